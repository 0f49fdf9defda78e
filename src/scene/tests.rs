//! Scenes as a whole: the scenes of `inputs/`, what is read out of them, and the text of messages.

use std::path::Path;

use super::document::keys::keys_of;
use super::document::source::{Document, SourceText};
use super::reading::read::check_numbers;
use super::reading::tables::SceneTables;
use super::tables::numerics::ArtificialStress;
use super::*;
use crate::error::Result;
use crate::material::eos::EosTable;

const IMPACT: &str = include_str!("../../inputs/impact.toml");
const BALL: &str = "[[body]]\nname = \"ball\"\nshape = { sphere = { radius = \"1 m\" } }\nmaterial = \"basalt\"\nspacing = 0.2\n\
    [run]\nuntil = \"1 s\"\n";

fn parse(text: &str, overrides: &[&str]) -> Result<Scene> {
    Scene::parse("s.toml", text, &overrides.iter().map(|o| o.to_string()).collect::<Vec<_>>())
}

/// The message for the ball's scene with one replacement.
fn complaint(from: &str, to: &str) -> String {
    assert!(BALL.contains(from));
    parse(&BALL.replace(from, to), &[]).expect_err(to).to_string()
}

fn particles(body: &Body) -> u64 {
    body.count(0..body.lattice_sites())
}

fn inputs() -> Vec<Scene> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("inputs");
    let mut scenes = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|e| e == "toml") {
            scenes.push(read(&path, &[]).unwrap_or_else(|e| panic!("{e}")));
        }
    }
    scenes
}

#[test]
fn every_input_reads_back_from_its_own_print() {
    let scenes = inputs();
    assert!(scenes.len() >= 4);
    for scene in scenes {
        let printed = SourceText::new(scene.path(), scene.to_toml(), &[]);
        let again = of(printed).unwrap_or_else(|e| panic!("{e}\n{}", scene.to_toml()));
        let source = scene.source.clone();
        assert_eq!(Scene { source, ..again }, scene, "{}", scene.to_toml());
    }
}

#[test]
fn a_printed_scene_can_be_changed() {
    let scene = parse(IMPACT, &[]).unwrap();
    let printed = scene.to_toml();
    let changes = ["target.orientation.seed=2", "target.spacing=1 km", "output.every=1 s", "projectile.radius=2 km"];
    assert_eq!(parse(&printed, &changes).unwrap().bodies, parse(IMPACT, &changes).unwrap().bodies);
}

#[test]
fn scenes_travel_as_bytes() {
    for scene in inputs() {
        let bytes = serde_json::to_vec(&scene).unwrap();
        assert_eq!(serde_json::from_slice::<Scene>(&bytes).unwrap(), scene);
    }
}

#[test]
fn the_main_scene_is_what_it_says() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("inputs/qd_star.toml");
    let scene = read(&path, &[]).unwrap();
    let [target, projectile] = &scene.bodies[..] else { panic!("two bodies") };
    assert_eq!(target.shape, BodyShape::Sphere { radius: 50e3 });
    assert!(particles(target).abs_diff(20_000) <= 200, "{}", particles(target));
    assert_eq!(projectile.lattice.spacing, target.lattice.spacing);
    assert!(particles(projectile) >= 100);
    assert_eq!(scene.materials.len(), 1);
    assert!(scene.materials[0].has_fracture() && scene.materials[0].strength.unwrap().melting.is_some());
    assert!(scene.numerics.corrected_gradient && scene.numerics.viscosity && scene.record.peak_pressure);
    assert_eq!((scene.run.until, scene.run.checkpoint_every), (Until::Settled, 600.0));
    assert_eq!(scene.threshold.as_ref().unwrap().vary, "projectile.radius");
    // Mass is exact: particles times their mass is that of the sphere.
    let constants = target.constants(particles(target), scene.numerics.eta);
    let exact = 2700.0 * 4.0 / 3.0 * std::f64::consts::PI * 50e3f64.powi(3);
    assert!((constants.particle_mass * constants.particles as f64 / exact - 1.0).abs() < 1e-14);
    let h = 1.2 * (exact / 2700.0 / constants.particles as f64).cbrt();
    assert!((constants.smoothing_length / h - 1.0).abs() < 1e-14);
}

#[test]
fn the_projectile_meets_the_target_at_the_angle_asked_for() {
    for degrees in [0.0f64, 30.0, 75.0] {
        let scene =
            parse(IMPACT, &[&format!("impact.angle={degrees} deg"), "target.position=[\"1 km\", 0, \"-3 km\"]"])
                .unwrap();
        let [target, projectile] = &scene.bodies[..] else { panic!("two bodies") };
        assert_eq!(projectile.velocity, [-5000.0, 0.0, 0.0]);
        let r: [f64; 3] = std::array::from_fn(|k| projectile.centre[k] - target.centre[k]);
        let gap = (r[0] * r[0] + r[1] * r[1] + r[2] * r[2]).sqrt() - 11e3;
        let h = target.expected_smoothing_length(1.2);
        assert!((gap - 2.0 * h).abs() < 1e-9 * h, "{gap}");
        // Flown on to contact, the line of centres makes the angle with the velocity.
        assert!((r[1] / 11e3 - degrees.to_radians().sin()).abs() < 1e-12 && r[2] == 0.0 && r[0] > 0.0);
        // Or its centre's path meets the surface at that angle.
        let scene = scene.reread(&["impact.angle_at=centre".into()]).unwrap();
        let y = scene.bodies[1].centre[1] - scene.bodies[0].centre[1];
        assert!((y / 10e3 - degrees.to_radians().sin()).abs() < 1e-12, "{y}");
    }
}

#[test]
fn a_flat_target_is_hit_from_above() {
    let overrides = ["target.shape={ half_sphere = { radius = \"10 km\" } }", "impact.angle=30 deg"];
    let scene = parse(IMPACT, &overrides).unwrap();
    let [target, projectile] = &scene.bodies[..] else { panic!("two bodies") };
    let gap = projectile.centre[2] - 1000.0;
    assert!((gap - 2.0 * target.expected_smoothing_length(1.2)).abs() < 1e-9 * gap);
    let v = projectile.velocity;
    assert!((v[0] / v[2] - 30f64.to_radians().tan()).abs() < 1e-14);
    // It flies on to the middle of the face.
    assert!((projectile.centre[0] - gap * v[0] / v[2]).abs() < 1e-9 * gap);
}

#[test]
fn a_small_projectile_gets_a_hundred_particles() {
    let scene = parse(IMPACT, &["projectile.radius=100 m"]).unwrap();
    let n = particles(&scene.bodies[1]);
    assert!((100..=120).contains(&n), "{n}");
    let larger = scene.reread(&["projectile.radius=3 km".into()]).unwrap();
    assert_eq!(larger.bodies[1].shape, BodyShape::Sphere { radius: 3e3 });
    assert_eq!(larger.bodies[1].lattice.spacing, larger.bodies[0].lattice.spacing);
    let coarser = parse(IMPACT, &["projectile.radius=100 m", "projectile.least_particles=30"]).unwrap();
    let n = particles(&coarser.bodies[1]);
    assert!((30..=40).contains(&n), "{n}");
    for wrong in ["projectile.least_particles=0", "target.least_particles=10"] {
        let text = parse(IMPACT, &[wrong]).unwrap_err().to_string();
        assert!(text.contains("cannot be the least number of particles"), "{text}");
    }
}

/// Within one per cent, and where faces are flat, within half a layer along each axis: rows come and go as a whole.
#[test]
fn numbers_of_particles_are_met() {
    let check = |change: &str, n: u64, overrides: &[&str]| {
        let scene = parse(BALL, &[overrides, &[change, &format!("ball.particles={n}")]].concat()).unwrap();
        let body = &scene.bodies[0];
        let edges = body.shape.bounds(body.dimension).half.map(|half| 2.0 * half);
        let half_layers: f64 = edges[..body.dimension].iter().map(|edge| 0.5 * body.lattice.spacing / edge).sum();
        let allowed = 0.01 + if change.contains(" sphere") { 0.0 } else { half_layers };
        let off = particles(body).abs_diff(n) as f64 / n as f64;
        assert!(off <= allowed, "{change}: {} of {n}", particles(body));
    };
    for n in [1000, 3000, 10_000] {
        check("ball.shape={ sphere = { radius = 1 } }", n, &[]);
        check("ball.shape={ sphere = { radius = 1 } }", n, &["dimension=2", "ball.orientation.seed=4"]);
        check("ball.shape={ half_sphere = { radius = 1 } }", n, &[]);
        check("ball.shape={ cylinder = { radius = 1, height = 3 } }", n, &[]);
        check("ball.shape={ box = { size = [1, 2, 3] } }", n, &["ball.lattice=cubic"]);
    }
}

#[test]
fn sites_are_the_same_in_parts_as_in_whole() {
    let scene = parse(BALL, &["ball.position=[1, 2, 3]", "ball.orientation.seed=7"]).unwrap();
    let body = &scene.bodies[0];
    let end = body.lattice_sites();
    let whole: Vec<_> = body.sites(0..end).collect();
    let parts: Vec<_> = [0..end / 3, end / 3..end / 2, end / 2..end].into_iter().flat_map(|r| body.sites(r)).collect();
    assert_eq!(whole, parts);
    assert_eq!(whole.len() as u64, body.count(0..end));
    assert!(whole.iter().all(|(_, p)| body.contains(*p)));
}

#[test]
fn bodies_turn_about_their_centre() {
    let scene =
        parse(BALL, &["ball.spin=[0, 0, \"2 rad/s\"]", "ball.position=[5, 0, 0]", "ball.velocity=[0, 0, \"3 m/s\"]"])
            .unwrap();
    assert_eq!(scene.bodies[0].velocity_at([6.0, 0.0, 0.0]), [0.0, 2.0, 3.0]);
    let flat = parse(BALL, &["dimension=2", "ball.spin=2 rad/s"]).unwrap();
    assert_eq!(flat.bodies[0].velocity_at([0.0, 1.0, 0.0]), [-2.0, 0.0, 0.0]);
}

#[test]
fn a_gas_starts_from_its_pressure() {
    let scene =
        parse(include_str!("../../inputs/blast_gas.toml"), &["material.ideal_gas.eos.ideal_gas.gamma=1.4"]).unwrap();
    assert!(matches!(scene.materials[0].eos, EosTable::IdealGas(gas) if gas.gamma.0 == 1.4));
    assert!((scene.bodies[0].internal_energy / 2.5e5 - 1.0).abs() < 1e-15);
}

/// N snapshots are N files: the first of them at the start, the last at the end, and a single one at the end.
#[test]
fn snapshots_are_as_many_as_were_asked_for() {
    let snapshots = |overrides: &[&str]| parse(BALL, overrides).map(|scene| scene.output.snapshots);
    assert_eq!(snapshots(&["output.snapshots=0"]).unwrap(), Snapshots::Never);
    assert_eq!(snapshots(&["output.snapshots=1"]).unwrap(), Snapshots::AtEnd);
    assert_eq!(snapshots(&["output.snapshots=5", "run.until=8 s"]).unwrap(), Snapshots::Every(2.0));
    assert_eq!(snapshots(&["output.snapshots=5", "run.until=8 s", "run.max_time=4 s"]).unwrap(), Snapshots::Every(1.0));
    assert_eq!(snapshots(&["output.every=3 s", "run.until=8 s"]).unwrap(), Snapshots::Every(3.0));
    for too_many in ["output.every=1e-9 s", "output.snapshots=4000000000"] {
        let text = snapshots(&[too_many, "run.until=8 s"]).unwrap_err().to_string();
        assert!(text.contains("snapshots") && text.contains("1e6 and less"), "{text}");
    }
}

#[test]
fn a_gas_does_not_break() {
    let text = parse(include_str!("../../inputs/blast_gas.toml"), &["ball.damage=1"]).unwrap_err().to_string();
    assert!(text.contains("is a gas, which does not break"), "{text}");
}

#[test]
fn unknown_keys_name_the_nearest_known_one() {
    let text = complaint("spacing = 0.2", "spacng = 0.2");
    assert!(text.starts_with("s.toml:5: body ball, spacng: unknown key `spacng`, did you mean `spacing`?"), "{text}");
    assert!(text.contains("(allowed: name, shape, from, material, particles, spacing,"), "{text}");
    let text = complaint("radius", "raduis");
    assert!(text.starts_with("s.toml:3: ") && text.contains("did you mean `radius`?"), "{text}");
    let text = complaint("sphere", "shpere");
    assert!(
        text.starts_with("s.toml:3: ") && text.contains("unknown choice `shpere`, did you mean `sphere`?"),
        "{text}"
    );
    let text = complaint("[run]", "[ran]");
    assert!(text.starts_with("s.toml:6: ran: unknown key `ran`, did you mean `run`?"), "{text}");
    let text = parse(BALL, &["bal.spacing=1"]).unwrap_err().to_string();
    assert!(text.starts_with("--set bal.spacing=1: unknown key `bal`, did you mean `ball`?"), "{text}");
    let text = parse(&format!("{BALL}[material.basalt.fracture]\nweibul_m = 9\n"), &[]).unwrap_err().to_string();
    assert!(text.starts_with("s.toml:9: ") && text.contains("did you mean `weibull_m`?"), "{text}");
    let text = parse(&format!("{BALL}[numerics.artificial_stress]\nfaktor = 1\n"), &[]).unwrap_err().to_string();
    assert!(text.starts_with("s.toml:9: ") && text.contains("did you mean `factor`?"), "{text}");
}

#[test]
fn wrong_values_are_refused_in_one_clear_line() {
    let cases = [
        ("\"1 m\"", "\"1 kg\"", "s.toml:3: body ball, shape.sphere.radius: \"1 kg\" is a mass; a length is wanted"),
        ("\"1 m\"", "\"-1 m\"", "s.toml:3: body ball, shape.sphere.radius: radius is -1 m (allowed: more than 0)"),
        ("spacing = 0.2", "spacing = 0", "s.toml:5: body ball, spacing: spacing is 0 m (allowed: more than 0)"),
        ("spacing = 0.2", "particles = 0", "s.toml:5: body ball, particles: particles is 0"),
        ("spacing = 0.2", "", "the body has no particles"),
        ("spacing = 0.2", "spacing = 0.2\nparticles = 5", "both particles and spacing are given"),
        ("spacing = 0.2", "spacing = \"target\"", "only the projectile of an [impact] follows"),
        ("spacing = 0.2", "spacing = 1e-6", "lattice sites (allowed: at most 2^48 sites per body)"),
        ("spacing = 0.2", "spacing = 0.2\ndensity = -2700", "s.toml:6: body ball, density: density is -2700 kg/m^3"),
        ("spacing = 0.2", "spacing = 0.2\nposition = [0, 0]", "2 components in 3 dimensions (allowed: 3 components)"),
        ("spacing = 0.2", "spacing = 0.2\nspin = 3", "a spin has three components"),
        ("spacing = 0.2", "spacing = 0.2\ndamage = 1.5", "damage is 1.5 (allowed: 0 to 1)"),
        ("spacing = 0.2", "spacing = 0.2\norientation = {}", "{ seed = 3 } or { axis"),
        ("spacing = 0.2", "spacing = 0.2\npressure = 5", "only an ideal gas starts from a pressure"),
        ("spacing = 0.2", "spacing = 0.2\nlattice = \"hpc\"", "did you mean `hcp`?"),
        ("\"ball\"", "\"run\"", "\"run\" cannot name a body"),
        ("name = \"ball\"", "", "key `name` is missing"),
        ("\"basalt\"", "\"ideal_gas\"", "key `density` is missing: a gas has no density of its own"),
        ("until = \"1 s\"", "", "the scene has no end"),
        ("\"1 s\"", "\"1 m\"", "\"1 m\" is a length; a time is wanted (allowed: \"settled\", \"100 s\""),
        ("\"1 s\"", "\"settled\"", "\"settled\" is defined for impacts only"),
        ("\"1 s\"", "\"1 s\"\n[output]\ncompression = 10", "10 is no compression level (allowed: 0 to 9)"),
        ("\"1 s\"", "\"1 s\"\n[numerics]\ncfl = 7", "s.toml:9: numerics.cfl: 7 is out of range (allowed: 0.001 to 1)"),
        ("\"1 s\"", "\"1 s\"\n[numerics]\nkernel = \"wendland\"", "unknown choice `wendland`"),
        ("\"1 s\"", "\"1 s\"\n[numerics]\nsmoothing_length = \"free\"", "\"constant\" or { follows = \"density\""),
        ("\"1 s\"", "\"1 s\"\n[threshold]\nvary = \"ball.radius\"", "a threshold search needs an [impact]"),
        ("\"1 s\"", "\"1 s\"\n[impact]\nspeed = 5", "an impact needs two bodies"),
        ("\"1 s\"", "\"1 s", "s.toml:7"),
        ("[[body]]", "dimension = 4\n[[body]]", "s.toml:1: dimension: 4 dimensions (allowed: 2 or 3)"),
    ];
    for (from, to, expected) in cases {
        let text = complaint(from, to);
        assert!(text.contains(expected) && !text.contains('\n'), "{to}: {text}");
    }
    let cases = [
        ("impact.speed=-5 km/s", "--set impact.speed=-5 km/s: speed is -5000 m/s"),
        ("impact.angle=90 deg", "below 90 deg"),
        ("impact.target=targt", "unknown body `targt`, did you mean `target`?"),
        ("target.velocity=[1, 0, 0]", "rests at the start"),
        ("projectile.velocity=[1, 0, 0]", "follows from [impact]"),
        ("projectile.shape={ box = { size = [1, 1, 1] } }", "onto a sphere only a sphere can fall"),
        ("threshold.vary=target.radius", "`target.radius` cannot be varied (allowed: projectile.radius)"),
        ("run.until=settled", "needs a run of known length"),
        ("numerics=3", "invalid type: integer `3`, expected a table"),
        ("material.basalt.strength.shear_modulus=-1", "--set material.basalt.strength.shear_modulus=-1"),
        ("material.basalt.strength.shear_modulus=3 GPb", "unknown unit `GPb`"),
    ];
    for (change, expected) in cases {
        let text = parse(IMPACT, &[change]).expect_err(change).to_string();
        assert!(text.contains(expected) && !text.contains('\n'), "{change}: {text}");
    }
    let text = read(Path::new("nowhere.toml"), &[]).unwrap_err().to_string();
    assert!(text.starts_with("nowhere.toml: cannot read the scene"), "{text}");
    assert!(parse("", &[]).unwrap_err().to_string().contains("the scene has 0 bodies"));
}

#[test]
fn overlapping_bodies_are_refused() {
    let second = BALL.replace("\"ball\"", "\"other\"").replace("[run]\nuntil = \"1 s\"\n", "position = [1.9, 0, 0]\n");
    let text = parse(&format!("{second}{BALL}"), &[]).unwrap_err().to_string();
    assert!(text.contains("bodies \"other\" and \"ball\" overlap"), "{text}");
    assert!(parse(&format!("{second}{BALL}"), &["other.position=[2, 0, 0]"]).is_ok());
}

#[test]
fn overrides_switch_effects() {
    let scene = parse(
        IMPACT,
        &["material.basalt.fracture=false", "numerics.viscosity=false", "numerics.artificial_stress=true"],
    )
    .unwrap();
    assert!(!scene.materials[0].has_fracture() && scene.materials[0].viscosity.is_none() && !scene.numerics.viscosity);
    assert_eq!(scene.numerics.artificial_stress, Some(ArtificialStress { factor: 0.2 }));
}

#[test]
fn two_dimensional_scenes_have_mass_per_depth() {
    let scene = parse(include_str!("../../inputs/rotating_rod_2d.toml"), &[]).unwrap();
    let rod = &scene.bodies[0];
    assert_eq!(particles(rod), 50 * 10);
    assert!((rod.mass() - 2700.0 * 0.2).abs() < 1e-10);
    assert!(rod.sites(0..rod.lattice_sites()).all(|(_, p)| p[2] == 0.0));
    let text =
        parse(BALL, &["dimension=2", "ball.shape={ cylinder = { radius = 1, height = 1 } }"]).unwrap_err().to_string();
    assert!(text.contains("a cylinder needs three dimensions"), "{text}");
}

/// Whatever a character of a scene is changed into, reading ends with a scene or an error, never with a panic.
#[test]
fn damaged_text_never_panics() {
    let marks = ['"', '[', ']', '=', '-', '9', '.', 'e', ' ', '\n', 'µ'];
    for (number, (at, old)) in BALL.char_indices().enumerate() {
        for mark in [marks[number % marks.len()], marks[(7 * number + 3) % marks.len()]] {
            let mut text = BALL.to_string();
            text.replace_range(at..at + old.len_utf8(), &mark.to_string());
            // A spacing made tiny would only cost time.
            if !text.contains("spacing = 0.") || text.contains("e0") {
                continue;
            }
            let _ = parse(&text, &[]);
        }
    }
}

/// Hints are texts for MPI; a scene with others is the same scene to a restart.
#[test]
fn hints_are_texts_and_no_part_of_the_question() {
    let plain = parse(BALL, &[]).unwrap();
    let hinted = parse(BALL, &["output.mpi_io_hints={ cb_nodes = 4, romio_cb_write = \"enable\" }"]).unwrap();
    let hints: Vec<_> = hinted.output.mpi_io_hints.iter().map(|(key, value)| (key.as_str(), value.as_str())).collect();
    assert_eq!(hints, [("cb_nodes", "4"), ("romio_cb_write", "enable")]);
    assert!(hinted.to_toml().contains("romio_cb_write") && hinted.to_toml() != plain.to_toml());
    assert_eq!(hinted.differs_from(&plain.to_toml()), None);
    for bad in ["cb_nodes=-99999", "cb_nodes=0", "striping_factor=many", "cb_buffer_size=1e9"] {
        let error = parse(BALL, &[&format!("output.mpi_io_hints.{bad}")]).unwrap_err().to_string();
        assert!(error.contains("mpi_io_hints") && error.contains("is no"), "{error}");
    }
    for bad in ["cb_nodes=\"\"", "cb_nodes=0.5", "a_key_longer_than_openmpi_takes_it_at_all=1"] {
        let error = parse(BALL, &[&format!("output.mpi_io_hints.{bad}")]).unwrap_err().to_string();
        assert!(error.contains("is no hint for MPI") && error.contains("1 to 35"), "{error}");
    }
}

/// Each number is one, and what follows from it is none; or nothing can be told apart where it puts a body.
#[test]
fn numbers_beyond_reach_are_refused_at_their_key() {
    let gas = "spacing = 0.2\ndensity = 1e-300\npressure = 1e99";
    let thin = "[material.basalt]\neos = { ideal_gas = { gamma = 1.00000000000001 } }\n[run]\nuntil = 1\n";
    for (from, to, expected) in [
        (
            "spacing = 0.2",
            "spacing = 0.2\nvelocity = [1e200, 0, 0]",
            "s.toml:6: body ball, velocity.0: 1e200 is too large",
        ),
        ("spacing = 0.2", "spacing = 0.2\npressure = 1e308", "s.toml:6: body ball, pressure: 1e308 is too large"),
        (
            "spacing = 0.2",
            "spacing = 0.2\norientation = { axis = [1e200, 0, 0], angle = 1 }",
            "s.toml:6: body ball, orientation.axis",
        ),
        (
            "spacing = 0.2",
            "spacing = 0.2\nposition = [0, 1e12, 0]",
            "s.toml:6: body ball, position: at 1e12 m numbers do not tell",
        ),
        ("spacing = 0.2", "spacing = 0.2\nspin = [nan, 0, 0]", "s.toml:6: body ball, spin"),
    ] {
        let text = complaint(from, to);
        assert!(text.starts_with(expected) && !text.contains('\n'), "{to}: {text}");
    }
    let text = BALL.replace("spacing = 0.2", gas).replace("[run]\nuntil = \"1 s\"\n", thin);
    let text = parse(&text, &[]).unwrap_err().to_string();
    assert!(
        text.starts_with("s.toml:7: body ball, pressure: a pressure of 1e99 Pa at 1e-300 kg/m^3 takes more"),
        "{text}"
    );
    // What no check of its own finds.
    let source = SourceText::new("s.toml", BALL, &[]);
    let document = Document::parse(&source).unwrap();
    let good = parse(BALL, &[]).unwrap();
    assert!(check_numbers(&document, &good).is_ok());
    let mut bad = good.clone();
    bad.bodies[0].internal_energy = f64::INFINITY;
    let text = check_numbers(&document, &bad).unwrap_err().to_string();
    assert!(text.starts_with("s.toml:1: body ball, internal_energy: a number comes to nothing finite"), "{text}");
    let mut bad = good.clone();
    bad.periods.length[0] = f64::INFINITY;
    assert!(check_numbers(&document, &bad).unwrap_err().to_string().contains("domain.periodic"));
    let mut bad = good;
    bad.run.max_time = Some(f64::NAN);
    assert!(check_numbers(&document, &bad).is_err(), "null is no number left out");
}

#[test]
fn probes_have_names_of_their_own() {
    let probes = |second: &str| format!("{BALL}[[probe]]\nname = \"x\"\n[[probe]]\nname = \"{second}\"\n");
    assert!(parse(&probes("y"), &[]).is_ok());
    let text = parse(&probes("x"), &[]).unwrap_err().to_string();
    assert!(text.starts_with("s.toml:11: probe.1.name: two probes are named \"x\""), "{text}");
    let text = complaint("\"ball\"", "\"probe\"");
    assert!(
        text.contains("\"probe\" cannot name a body (allowed: any name without . and = that is no table"),
        "{text}"
    );
}

/// A body is addressed by its name, which therefore must not be a key of a scene, whatever keys there are.
#[test]
fn no_body_is_named_like_a_key_of_a_scene() {
    let keys = keys_of::<SceneTables>();
    assert!(keys.len() >= 18 && keys.contains(&"late_stage"), "{keys:?}");
    for key in keys.iter().chain(&[""]) {
        let text = complaint("\"ball\"", &format!("\"{key}\""));
        assert!(text.contains(&format!("\"{key}\" cannot name a body")), "{text}");
    }
}

/// A search changes the radius of a sphere; any other projectile would be refused by the search itself.
#[test]
fn only_spheres_are_searched() {
    let ground = "target.shape={ box = { size = [\"10 km\", \"10 km\", \"10 km\"] } }";
    let rod = "projectile.shape={ cylinder = { radius = \"1 km\", height = \"1 km\" } }";
    let text = parse(IMPACT, &[ground, rod, "threshold.vary=projectile.radius"]).unwrap_err().to_string();
    assert!(text.contains("varies the radius of a sphere, and body \"projectile\" is none"), "{text}");
}
