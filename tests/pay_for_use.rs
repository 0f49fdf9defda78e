//! Pay for use: what a scene does not ask for exists neither in memory, nor in messages, nor in the pair loop, nor in files.
//! Prints what each effect costs; times are for the reader and never decide.

use std::collections::BTreeSet;
use std::path::Path;

use sph_mpi::pair::record::{PressureGradient, StressTerm, TensorGradient, ViscousTerm};
use sph_mpi::pair::{Layout, Terms};
use sph_mpi::scene::Scene;
use sph_mpi::simulation::footprint::Footprint;
use sph_mpi::simulation::setup::{Plan, plan};

use crate::common::{IMPACT, Launch, ranks, summary, write_scene};

/// Two balls that fly towards each other; the same particles in every scene.
const BALLS: &str = r#"
title = "Two balls"

[[body]]
name = "left"
shape = { sphere = { radius = "1 km" } }
material = "MATERIAL"
density = "2700 kg/m^3"
particles = 3000

[[body]]
name = "right"
shape = { sphere = { radius = "1 km" } }
material = "MATERIAL"
density = "2700 kg/m^3"
particles = 3000
position = ["2.3 km", "0 m", "0 m"]
velocity = ["-1 km/s", "0 m/s", "0 m/s"]

[run]
until = "1000 s"
steps = 40

[output]
every = "1000 s"
picture = false
"#;

/// What every scene has, name and words per particle.
const CORE: [(&str, usize); 13] = [
    ("id", 1),
    ("position", 3),
    ("velocity", 3),
    ("acceleration", 3),
    ("jerk", 3),
    ("build_position", 3),
    ("skin", 1),
    ("density", 1),
    ("density_rate", 1),
    ("pressure", 1),
    ("sound_speed", 1),
    ("internal_energy", 1),
    ("internal_energy_rate", 1),
];
const STRENGTH: [(&str, usize); 2] = [("deviatoric_stress", 5), ("deviatoric_stress_rate", 5)];
const MOMENTS: [(&str, usize); 4] =
    [("moment_diagonal", 3), ("moment_off_diagonal", 3), ("moment_diagonal_rate", 3), ("moment_off_diagonal_rate", 3)];
const FRACTURE: [(&str, usize); 2] = [("damage", 1), ("activation_threshold", 1)];
/// Rigid pores of a material that can break, and what elastic ones need.
const PORES: [(&str, usize); 3] = [("distention", 1), ("stress_factor", 1), ("compaction_damage", 1)];
const ELASTIC_PORES: [(&str, usize); 1] = [("unloaded_distention", 1)];
const RECORDS: [(&str, usize); 3] = [("peak_pressure", 1), ("melt_fraction", 1), ("vapour_fraction", 1)];
const VARIABLE_H: [(&str, usize); 2] = [("smoothing_length", 1), ("build_smoothing_length", 1)];
/// In the record with them: beta, as materials may differ in it.
const SLOPES: [(&str, usize); 2] = [("slope_diagonal", 3), ("slope_off_diagonal", 3)];
const SWITCH: [(&str, usize); 2] = [("viscosity_switch", 1), ("divergence", 1)];
const RELAXATION: [(&str, usize); 2] = [("density_relaxation", 1), ("packing_at_start", 1)];
const TWO_RATES: [(&str, usize); 4] = [("fast", 1), ("near_fast", 1), ("fast_acceleration", 3), ("fast_heating", 1)];

/// A scene and what it may hold.
struct Case {
    name: &'static str,
    /// Added to the scene before.
    asks: &'static str,
    gas: bool,
    columns: Vec<(&'static str, usize)>,
    terms: Terms,
    /// Numbers of a ghost record: position and velocity, stress, V, density, 1/h, and what follows from the terms.
    ghost_words: usize,
}

/// Physics that grows from a gas to all that there is.
fn cases() -> Vec<Case> {
    let pressure = StressTerm::Pressure { gradient: PressureGradient::Plain };
    let gas = Terms { stress: pressure, viscosity: ViscousTerm::Off };
    let viscous = Terms { viscosity: ViscousTerm::SameBeta, ..gas };
    // Solids have what is right for them unless a scene says otherwise.
    let gradient = TensorGradient::Corrected { contrast: false, angular_momentum: true };
    let [solid, tensile] =
        [false, true].map(|artificial| Terms { stress: StressTerm::Tensor { artificial, gradient }, ..viscous });
    let reconstructed = Terms { viscosity: ViscousTerm::Reconstructed, ..tensile };
    let mut columns = CORE.to_vec();
    let mut with = |more: &[(&'static str, usize)]| {
        columns.extend(more);
        columns.clone()
    };
    let case = |name, asks, gas, columns, terms, ghost_words| Case { name, asks, gas, columns, terms, ghost_words };
    vec![
        case("gas without viscosity", "", true, with(&[]), gas, 6 + 1 + 1 + 1),
        case("gas", "", true, with(&[]), viscous, 6 + 1 + 1 + 2),
        case(
            "+ strength",
            "[material.basalt.strength]",
            false,
            with(&[&STRENGTH[..], &MOMENTS].concat()),
            solid,
            6 + 6 + 1 + 3,
        ),
        case("+ fracture", "[material.basalt.fracture]", false, with(&FRACTURE), solid, 6 + 6 + 1 + 3),
        // Friction reads pressure and damage that are there.
        case("+ friction", "[material.basalt.strength.collins]", false, with(&[]), solid, 6 + 6 + 1 + 3),
        // What pores change is in the pressure, the stress and the damage that a record holds anyway.
        case("+ porosity", "[material.basalt.porosity.p_alpha.quadratic]", false, with(&PORES), solid, 6 + 6 + 1 + 3),
        case(
            "+ elastic pores",
            "material.basalt.porosity.p_alpha.elastic = { c_e = \"2 km/s\", c_0 = \"3.145 km/s\" }",
            false,
            with(&ELASTIC_PORES),
            solid,
            6 + 6 + 1 + 3,
        ),
        case(
            "+ artificial stress",
            "numerics.artificial_stress = true\nnumerics.angular_momentum = true",
            false,
            with(&[]),
            tensile,
            6 + 6 + 1 + 6,
        ),
        case(
            "+ records",
            "record = { peak_pressure = true, melt_fraction = true, vapour_fraction = true }",
            false,
            with(&RECORDS),
            tensile,
            6 + 6 + 1 + 6,
        ),
        case(
            "+ variable h",
            "numerics.smoothing_length = { follows = \"density\" }",
            false,
            with(&VARIABLE_H),
            tensile,
            6 + 6 + 1 + 6,
        ),
        case("+ reconstruction", "numerics.reconstruction = true", false, with(&SLOPES), reconstructed, 6 + 6 + 1 + 10),
        case(
            "+ viscosity switch",
            "numerics.viscosity_switch = true",
            false,
            with(&SWITCH),
            reconstructed,
            6 + 6 + 1 + 10,
        ),
        case(
            "+ density relaxation",
            "numerics.density_relaxation = true",
            false,
            with(&RELAXATION),
            reconstructed,
            6 + 6 + 1 + 10,
        ),
        case("+ two rates", "two_rates.fast = [\"left\"]", false, with(&TWO_RATES), reconstructed, 6 + 6 + 1 + 10),
        // The divergence is there already.
        case(
            "+ viscosity by loading",
            "material.basalt.viscosity.speed = \"loading\"",
            false,
            with(&[("loading_speed", 1)]),
            reconstructed,
            6 + 6 + 1 + 10,
        ),
    ]
}

/// A solid without what it has by default holds and sends less.
#[test]
fn a_solid_may_do_without_its_defaults() {
    let text = format!("{BALLS}\n[material.basalt.strength]\n").replace("MATERIAL", "basalt");
    let plan = |change: &str| {
        let scene = Scene::parse("scene.toml", &text, &[change.to_string()]).expect("a scene");
        plan(&scene, scene.bodies.iter().map(|body| body.constants(10, scene.numerics.eta)).collect()).expect("a plan")
    };
    let [default, less, least] =
        ["numerics.cfl=0.25", "numerics.angular_momentum=false", "numerics.corrected_gradient=false"].map(plan);
    let moments = 8 * MOMENTS.iter().map(|(_, width)| width).sum::<usize>();
    let bytes = |plan: &Plan| plan.registry.bytes_per_particle();
    assert_eq!([bytes(&less), bytes(&least)], [bytes(&default) - moments; 2]);
    let keeps = [&default, &less].map(|plan| plan.terms.angular_momentum());
    assert_eq!((keeps, less.terms.corrects(), least.terms.corrects()), ([true, false], true, false));
    let words = |plan: &Plan| Layout { dimension: 3, terms: plan.terms }.words();
    assert_eq!([words(&default), words(&less), words(&least)], [16, 15, 15]);
}

impl Case {
    /// The scene: keys of its own and of the cases before it.
    fn scene(&self, asked: &[&str]) -> String {
        let material = if self.gas { "ideal_gas" } else { "basalt" };
        let heat = if self.gas { "internal_energy = \"1e6 J/kg\"\n" } else { "" };
        let off = if self.terms.viscosity == ViscousTerm::Off { "numerics.viscosity = false\n" } else { "" };
        let keys: Vec<&str> = asked.iter().copied().filter(|line| !line.starts_with('[')).collect();
        let tables: Vec<&str> = asked.iter().copied().filter(|line| line.starts_with('[')).collect();
        let mut balls = BALLS.replace("MATERIAL", material).replace("particles =", &format!("{heat}particles ="));
        if asked.iter().any(|line| line.contains("porosity")) {
            // Porous bodies are as heavy as their pores leave them.
            balls = balls.replace("density = \"2700 kg/m^3\"\n", "");
        }
        format!("{off}{}\n{balls}\n{}\n", keys.join("\n"), tables.join("\n"))
    }

    fn names(&self) -> BTreeSet<&str> {
        self.columns.iter().map(|(name, _)| *name).collect()
    }

    /// Memory and loop: columns, terms and ghost record of the plan that a run follows.
    fn check_plan(&self, plan: &Plan) {
        let entries = &plan.registry.entries;
        let found: BTreeSet<(&str, usize)> = entries.iter().map(|e| (e.name.as_str(), e.width)).collect();
        assert_eq!(found, self.columns.iter().copied().collect(), "columns of {}", self.name);
        assert_eq!(plan.terms, self.terms, "terms of the pair loop of {}", self.name);
        assert_eq!(Layout { dimension: 3, terms: plan.terms }.words(), self.ghost_words, "ghosts of {}", self.name);
    }

    /// Files: the snapshot holds columns and what follows from ids, the checkpoint the state.
    fn check_files(&self, run: &Path, plan: &Plan) {
        let members = |file: &str, group: &str| -> BTreeSet<String> {
            let path = run.join(file);
            let file = hdf5::File::open(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
            file.group(group).and_then(|group| group.member_names()).expect("a group").into_iter().collect()
        };
        let declared = |keep: &dyn Fn(&sph_mpi::particles::columns::Entry) -> bool| -> BTreeSet<String> {
            plan.registry.entries.iter().filter(|e| keep(e)).map(|e| e.name.clone()).collect()
        };
        let mut fields = declared(&|entry| entry.info.snapshot && entry.name != "position");
        fields.extend(["body", "mass", "smoothing_length"].map(String::from));
        assert_eq!(members("snapshot_0001.vtkhdf", "/VTKHDF/PointData"), fields, "snapshot of {}", self.name);
        let state = declared(&|entry| entry.info.life.is_state());
        assert_eq!(members("checkpoint.h5", "/columns"), state, "checkpoint of {}", self.name);
    }
}

fn parse(text: &str) -> (Scene, Plan) {
    let scene = Scene::parse("scene.toml", text, &[]).unwrap_or_else(|e| panic!("{e}\n{text}"));
    let constants = scene.bodies.iter().map(|body| {
        let particles = body.count(0..body.lattice_sites());
        body.constants(particles, scene.numerics.eta)
    });
    let plan = plan(&scene, constants.collect()).expect("a plan");
    (scene, plan)
}

fn run(scene: &str, ranks: usize, settings: &[&str]) -> (tempfile::TempDir, serde_json::Value) {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let settings: Vec<&str> = settings.iter().flat_map(|setting| ["--set", setting]).collect();
    Launch::in_directory(ranks, dir.path(), scene, &settings).run().expect_code(0);
    let found = summary(&dir.path().join("run"));
    (dir, found)
}

#[test]
fn a_scene_holds_what_it_asks_for_and_no_more() {
    let solids =
        ["deviatoric_stress", "damage", "activation_threshold", "distention", "peak_pressure", "smoothing_length"];
    println!(
        "{:<22} {:>7} {:>15} {:>12} {:>12} {:>16}",
        "scene", "columns", "bytes/particle", "pair record", "ghost sends", "us per particle"
    );
    let mut asked = Vec::new();
    for case in cases() {
        asked.extend((!case.asks.is_empty()).then_some(case.asks));
        let text = case.scene(&asked);
        let (_, plan) = parse(&text);
        case.check_plan(&plan);
        assert!(!case.gas || solids.iter().all(|name| !case.names().contains(name)), "a gas holds a solid's column");
        let (dir, summary) = run(&text, 1, &[]);
        case.check_files(&dir.path().join("run"), &plan);
        let phase = |name: &str| summary["phases"][name].as_f64().unwrap_or(0.0);
        let steps = 1.0 - phase("output") - phase("outcome") - phase("diagnostics");
        let updates = summary["particles"].as_f64().unwrap_or(0.0) * summary["steps"].as_f64().unwrap_or(0.0);
        let layout = Layout { dimension: 3, terms: plan.terms };
        println!(
            "{:<22} {:>7} {:>15} {:>12} {:>12} {:>16.2}",
            case.name,
            plan.registry.entries.len(),
            plan.registry.bytes_per_particle(),
            8 * layout.stride(),
            8 * layout.words(),
            1e6 * steps * summary["core_seconds"].as_f64().unwrap_or(0.0) / updates
        );
    }
}

/// What really goes over the wire: between two runs on two ranks that differ by four steps on the same lists, exactly the
/// words of each ghost's record and, from the watch over displacements, a part that does not depend on the physics.
#[test]
fn ghosts_send_the_words_of_their_record() {
    let all = cases();
    let sent = |case: &Case, asked: &[&str]| {
        let text = case.scene(asked);
        let total = |steps: &str| {
            // A wide skin and slow bodies keep the first lists.
            let calm = ["numerics.skin=1", "right.velocity=[0, 0, 0]", "left.velocity=[0, 0, 0]", steps];
            let (_dir, summary) = run(&text, 2, &calm);
            let number = |key: &str| summary[key].as_f64().expect("a number");
            assert_eq!(number("list_builds"), 1.0, "the run stays on its first lists");
            let ghosts = number("ghost_fraction") * number("particles");
            (number("exchanged_bytes_per_step") * number("steps"), ghosts)
        };
        let ((few, ghosts), (many, _)) = (total("run.steps=2"), total("run.steps=6"));
        assert!(ghosts > 100.0, "{ghosts} ghosts");
        ((many - few) / 4.0, ghosts)
    };
    let (gas, gas_ghosts) = sent(&all[1], &[]);
    let (solid, solid_ghosts) = sent(&all[3], &[all[2].asks, all[3].asks]);
    assert_eq!(gas_ghosts, solid_ghosts, "the same particles stand in both");
    let words = (all[3].ghost_words - all[1].ghost_words) as f64;
    println!("{gas_ghosts} ghosts: a gas sends {gas:.0} bytes in a step, a fractured solid {solid:.0}");
    assert!(
        (solid - gas - 8.0 * words * gas_ghosts).abs() < 1.0,
        "{solid} - {gas} is not {words} numbers for each ghost"
    );
    assert!(gas >= 8.0 * all[1].ghost_words as f64 * gas_ghosts, "a gas sends its records");
}

/// On every rank, before anything is allocated; the ranks of a machine share its memory.
#[test]
fn what_does_not_fit_into_memory_is_refused() {
    ranks(2, "pay_for_use::what_does_not_fit_into_memory_is_refused", |comm| {
        let (scene, plan) = parse(&cases()[1].scene(&[]));
        let mut footprint = Footprint::new(&scene, &plan, 2);
        assert!(footprint.require(comm).is_ok(), "a few thousand particles fit");
        // An exabyte on each.
        footprint.parts[0].1 = 1e18;
        let error = footprint.require(comm).expect_err("an exabyte is refused").to_string();
        assert!(error.contains("2000000.0 TB") && error.contains("2 ranks"), "{error}");
    });
}

/// `--check` names every effect and column of the impact with its bytes, from one rank, and runs nothing.
#[test]
fn check_says_what_a_scene_costs() {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let scene = write_scene(dir.path(), IMPACT);
    let out = dir.path().join("run");
    let check = |more: &[&str]| {
        let mut args = vec![scene.to_str().expect("a plain path"), "--check", "--out"];
        args.extend([out.to_str().expect("a plain path")].iter().chain(more));
        Launch::scene(2, &args).run().expect_code(0).stdout
    };
    // What effects and columns are listed: the first words of lines.
    let lists = |text: &str, word: &str| text.lines().any(|line| line.split_whitespace().next() == Some(word));
    let (text, without) = (check(&[]), check(&["--set", "material.basalt.fracture=false", "--ranks", "8"]));
    for word in ["strength", "deviatoric_stress", "smoothing_length", "fracture", "damage"] {
        assert!(lists(&text, word), "{word} is missing in\n{text}");
    }
    assert!(!lists(&without, "fracture") && !lists(&without, "damage"), "{without}");
    assert!(text.contains("bytes per particle"), "{text}");
    for (text, memory) in [(&text, "memory on 2 ranks"), (&without, "memory on 8 ranks")] {
        assert_eq!(text.matches(memory).count(), 1, "{memory}: one rank speaks\n{text}");
    }
    // Two ranks measure what lies between them; another network can be given, a slow one here.
    let slow = check(&["--ranks", "8", "--latency", "1e-3", "--bandwidth", "1e6"]);
    assert!(text.contains("one step on 2 ranks") && text.contains("measured between the first rank"), "{text}");
    assert!(slow.contains("one step on 8 ranks") && slow.contains("1.00e-3 s, 1.0e6 bytes/s, as given"), "{slow}");
    let efficiency = |text: &str| {
        let line = text.lines().find_map(|line| line.trim().strip_prefix("parallel efficiency"));
        line.and_then(|rest| rest.trim().parse::<f64>().ok()).unwrap_or_else(|| panic!("{text}"))
    };
    assert!(efficiency(&slow) < 0.1 && efficiency(&text) < 1.0 && efficiency(&text) > efficiency(&slow));
    assert!(!out.exists(), "a check leaves no run");
}

/// Matter whose pressure depends on density alone has no energy to carry, and no balance of it is claimed; heat that would be lost
/// on it is refused.
#[test]
fn cold_matter_carries_no_energy() {
    let text = |more: &str| {
        let glass = "eos = { murnaghan = { rho_0 = \"2540 kg/m^3\", K_0 = \"5 GPa\", n = 4 } }";
        let strength = "strength = { shear_modulus = \"3 GPa\", yield_strength = \"1 GPa\" }";
        let ball = |name: &str, radius: f64, particles: u32| {
            format!(
                "[[body]]\nname = \"{name}\"\nshape = {{ sphere = {{ radius = {radius} }} }}\nmaterial = \"bead\"\nparticles = {particles}\n"
            )
        };
        let (target, projectile) = (ball("target", 1.0, 300), ball("projectile", 0.5, 40));
        format!(
            "{target}{projectile}{more}\n[material.bead]\n{glass}\n{strength}\n[impact]\nspeed = \"50 m/s\"\n[run]\nuntil = \"2 ms\"\n\
             [output]\npicture = false\nsnapshots = 1\n"
        )
    };
    let (_, planned) = parse(&text(""));
    assert!(planned.registry.find::<f64>("internal_energy").is_none());
    let (_dir, summary) = run(&text(""), 1, &[]);
    assert!(summary["energy_drift"].is_null(), "{}", summary["energy_drift"]);
    assert!(summary["momentum_drift"].as_f64().is_some_and(|drift| drift < 1e-12), "{}", summary["momentum_drift"]);
    let scene = Scene::parse("scene.toml", &text("internal_energy = \"1 J/kg\""), &[]).expect("a scene");
    let constants = scene.bodies.iter().map(|body| body.constants(10, scene.numerics.eta)).collect();
    let refused = plan(&scene, constants).err().expect("heat has no place").to_string();
    assert!(refused.contains("starts with heat"), "{refused}");
}
