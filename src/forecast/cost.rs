//! Description and predicted cost of a scene, before it runs: the text of `--check`.

use std::fmt::Write;

use toml::{Table, Value};

use super::model::{self, Load, Step};
use super::pace::{self, Pace};
use crate::domain::comm::{Comm, Network};
use crate::error::Result;
use crate::kernel::SUPPORT;
use crate::material::BodyConstants;
use crate::outcome::lasting::Lasting;
use crate::outcome::settled::Settled;
use crate::output::text::{aligned, duration, number, size, words};
use crate::pair::record::ViscousTerm;
use crate::particles::Life;
use crate::particles::columns::Entry;
use crate::process::resources;
use crate::scene::{Body, Precision, Scene, SkinRule, Snapshots, Until};
use crate::simulation::footprint::Footprint;
use crate::simulation::scales::free_fall_time;
use crate::simulation::setup::{self, Plan};
use crate::simulation::{results::warnings, scales};
use crate::step::time_step;
use crate::warning::Warning;

/// Impacts that a threshold search usually takes.
const IMPACTS: f64 = 6.0;

/// Describes the scene and its cost on `ranks` ranks of one thread each, over this network where one is given. Collective.
pub fn check(scene: &Scene, ranks: usize, network: Option<Network>, comm: &Comm) -> Result<String> {
    let plan = setup::plan(scene, particles(scene, comm)?)?;
    let footprint = Footprint::new(scene, &plan, ranks);
    let pace = pace::measure(scene, &plan.constants, footprint.owned, network, comm)?;
    let life = list_life(scene, &plan).unwrap_or(pace.life);
    let cost = |footprint: &Footprint| Step::new(&pace.machine, &load(scene, &plan, footprint, life));
    let (alone, shared) = (cost(&Footprint::new(scene, &plan, 1)), cost(&footprint));
    let parts = [
        bodies(scene, &plan),
        effects(scene, &plan),
        columns(&plan),
        memory(&plan, &footprint),
        one_step(&alone, &shared, &pace, life, ranks),
        time(scene, &plan, &footprint, &pace, &shared),
        warned(&warnings::of_scene(scene)),
    ];
    Ok(parts.concat())
}

/// Particles are not listed where there are many of them. Collective.
fn particles(scene: &Scene, comm: &Comm) -> Result<Vec<BodyConstants>> {
    setup::expected_particles(scene).map_or_else(|| setup::count_particles(scene, comm), Ok)
}

/// A paragraph of warnings; empty without any.
pub fn warned(warnings: &[Warning]) -> String {
    let lines: String = warnings.iter().map(|w| format!("  {}: {}\n", w.kind, w.text)).collect();
    if lines.is_empty() { lines } else { format!("\nwarnings\n{lines}") }
}

fn bodies(scene: &Scene, plan: &Plan) -> String {
    let mut rows =
        vec![words(["body", "material", "particles", "spacing (m)", "h (m)", "mass (kg)", "density (kg/m^3)"])];
    for (body, constants) in scene.bodies.iter().zip(&plan.constants) {
        rows.push(vec![
            body.name.clone(),
            scene.material_names[body.material].clone(),
            constants.particles.to_string(),
            number(body.lattice.spacing),
            number(constants.smoothing_length),
            number(body.mass()),
            number(body.density),
        ]);
    }
    let title = scene.title.replace('\n', " ");
    let mut text = format!("{title}\n{} in {} dimensions\n\n{}", scene.path(), scene.dimension, aligned(&rows));
    if setup::expected_particles(scene).is_some() {
        text += "  numbers of particles are those that volumes give\n";
    }
    text
}

/// Effects and pair terms, each with the tables that request it.
fn effects(scene: &Scene, plan: &Plan) -> String {
    let understood: Table = scene.to_toml().parse().unwrap_or_default();
    let mut rows = vec![words(["effect", "requested by"])];
    let mut row = |name: &str| {
        let tables = tables(&understood, name);
        let why = if tables.is_empty() { "every scene".to_string() } else { tables.join(", ") };
        rows.push(vec![name.to_string(), why]);
    };
    plan.effects.iter().for_each(|effect| row(effect.name()));
    let t = &plan.terms;
    let terms = [
        ("viscosity", t.viscosity != ViscousTerm::Off),
        ("reconstruction", t.reconstructs()),
        ("viscosity_switch", plan.switch.is_some()),
        ("density_relaxation", plan.relaxation.is_some()),
        ("contact_viscosity", plan.view.contact_alpha().is_some()),
        ("corrected_gradient", t.corrects()),
        ("artificial_stress", t.artificial_stress()),
        ("angular_momentum", t.angular_momentum()),
        ("density_contrast", t.contrast()),
        ("two_rates", plan.two_rates.is_some()),
    ];
    terms.iter().filter(|(_, on)| *on).for_each(|(name, _)| row(name));
    format!("\n{}", aligned(&rows))
}

/// The tables and keys called `name` that are switched on: of materials, of `[numerics]`, of the scene.
fn tables(scene: &Table, name: &str) -> Vec<String> {
    let on = |table: Option<&Value>| table.is_some_and(|value| !matches!(value, Value::Boolean(false)));
    let inner = |table: &str| scene.get(table).and_then(Value::as_table);
    let materials = inner("material").into_iter().flatten().filter(|(_, material)| on(material.get(name)));
    let mut found: Vec<String> = materials.map(|(material, _)| format!("[material.{material}.{name}]")).collect();
    if found.is_empty() && inner("numerics").is_some_and(|numerics| on(numerics.get(name))) {
        found.push(format!("[numerics] {name}"));
    }
    if let Some(table) = inner(name) {
        let keys = table.iter().filter(|(_, value)| on(Some(value))).map(|(key, _)| key.as_str());
        found.push(format!("[{name}] {}", keys.collect::<Vec<_>>().join(", ")));
    }
    found
}

fn columns(plan: &Plan) -> String {
    let mut rows = vec![words(["column", "unit", "words", "effect", "life", "snapshots", "about"])];
    for entry in &plan.registry.entries {
        let (about, unit) = match entry.name.strip_prefix(entry.info.name) {
            Some("") => (entry.info.about, entry.info.unit.to_string()),
            Some("_rate") => ("Rate at the last evaluation.", rate_of(entry.info.unit)),
            _ => ("Copy at the beginning of the step.", entry.info.unit.to_string()),
        };
        let life = match entry.info.life {
            Life::State => "state",
            Life::Kept => "kept",
            Life::Scratch => "scratch",
        };
        let snapshots = if entry.info.snapshot { "yes" } else { "no" };
        let width = entry.width.to_string();
        rows.push(words([entry.name.as_str(), &unit, &width, entry.owner, life, snapshots, about]));
    }
    format!("\n{}", aligned(&rows))
}

fn rate_of(unit: &str) -> String {
    if unit.is_empty() { "1/s".into() } else { format!("{unit}/s") }
}

fn memory(plan: &Plan, footprint: &Footprint) -> String {
    let mut text = String::new();
    let (layout, ranks) = (&footprint.layout, footprint.ranks);
    let mut line = |what: &str, value: String| {
        let _ = writeln!(text, "  {what:<34}{value}");
    };
    line("columns", format!("{} bytes per particle", plan.registry.bytes_per_particle()));
    line("pair record", format!("{} bytes, {} sent per ghost", 8 * layout.stride(), 8 * layout.words()));
    line("neighbours within the list radius", format!("{:.0}", footprint.neighbours));
    line("particles per rank", format!("{:.0}, and {:.0} ghosts", footprint.owned, footprint.ghosts));
    for (what, bytes) in footprint.parts {
        line(what, format!("{:>10} per rank, {:.0} bytes per particle", size(bytes), bytes / footprint.owned));
    }
    let (rank, all) = (footprint.per_rank(), footprint.per_rank() * ranks as f64);
    line("memory", format!("{:>10} per rank, {:.0} bytes per particle", size(rank), rank / footprint.owned));
    let available = resources::available_bytes();
    line("on all ranks", format!("{:>10} of {} available on this machine", size(all), size(available)));
    if available > 0.0 && all > available {
        let (needs, has) = (size(all), size(available));
        line("warning", format!("it does not fit into this machine: needs {needs}, and there are {has}"));
    }
    let sent = format!("{} per rank, {} in all", size(footprint.sent()), size(footprint.sent() * ranks as f64));
    line("sent in a step", sent);
    format!("\nmemory on {ranks} rank{}\n{text}", if ranks == 1 { "" } else { "s" })
}

/// The load of each of `ranks` ranks, with neighbour lists that are used for `life` steps.
fn load(scene: &Scene, plan: &Plan, footprint: &Footprint, life: f64) -> Load {
    let d = scene.dimension as f64;
    // Displacements of cells are sent two cells deep; a site is a particle's id, position and radius.
    let watch = 2.0 * footprint.ghosts / footprint.ghosts_per_cell * 8.0 * (2.0 * d + 2.0);
    let site = 8.0 * (d + 2.0);
    // Particles move by about the skin between two lists: of a layer as deep as a list radius, that share may change ranks.
    let skin = scene.numerics.skin.first();
    let skin = skin / (1.0 + skin);
    Load {
        ranks: footprint.ranks,
        owned: footprint.owned,
        ghosts: footprint.ghosts,
        peers: footprint.peers,
        entries: footprint.row,
        life,
        ghost_bytes: footprint.sent(),
        watch_bytes: watch,
        build_bytes: footprint.ghosts * (site + skin * plan.registry.bytes_per_particle() as f64),
        history_every: scene.output.history_every as f64,
        gravity: StepForecast::new(scene, plan).evaluations_per_step(),
    }
}

/// Share of the particles that an impact moves fast, near the projectile, while lists live shortest.
const HIT: f64 = 0.1;

/// Steps until bodies of an impact have come nearer by the skin, and lists must be built: the shortest life there is, as all
/// ranks build together.
fn list_life(scene: &Scene, plan: &Plan) -> Option<f64> {
    let speed = scene.impact.as_ref()?.speed;
    let h = plan.constants.iter().map(|body| body.smoothing_length).fold(f64::INFINITY, f64::min);
    let delta = speed * step(scene, plan, speed).0 / (SUPPORT * h);
    Some(match scene.numerics.skin {
        SkinRule::Fixed(skin) => (skin / delta).max(1.0),
        SkinRule::Auto => setup::skin_limits(scene).expected_life(HIT, delta),
    })
}

fn one_step(alone: &Step, shared: &Step, pace: &Pace, life: f64, ranks: usize) -> String {
    let mut text = String::new();
    let mut line = |what: &str, value: String| {
        let _ = writeln!(text, "  {what:<34}{value}");
    };
    for (what, seconds) in shared.parts() {
        line(what, format!("{seconds:.2e} s  {:>5.1} %", 100.0 * seconds / shared.wall()));
    }
    line("a step", format!("{:.2e} s", shared.wall()));
    line("parallel efficiency", format!("{:.3}", model::efficiency(alone, shared, ranks)));
    let machine = &pace.machine;
    let nano = |seconds: f64| format!("{:.3}", 1e9 * seconds);
    line("ns per pair, per entry of a list", format!("{}, {}", nano(machine.pair), nano(machine.list)));
    line("ns per update, per new order", format!("{}, {}", nano(machine.update), nano(machine.ordering)));
    line("measured", format!("in {} steps of {} particles here", pace.steps, pace.particles));
    line("life of a list", format!("{life:.1} steps"));
    let network = format!("{:.2e} s, {:.1e} bytes/s", machine.latency, machine.bandwidth);
    line("latency and bandwidth", format!("{network}, {}", pace.network_by));
    let s = if ranks == 1 { "" } else { "s" };
    format!("\none step on {ranks} rank{s} of one thread, none of them sharing a core\n{text}")
}

/// The predicted cost of one run of a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PredictedCost {
    pub particles: u64,
    pub steps: f64,
    pub wall_seconds: f64,
    pub core_seconds: f64,
    /// Directed, inside the support.
    pub pair_interactions: f64,
}

/// Predicts a run on `ranks` ranks of one thread each, by a pace that was measured with the same effects. Collective.
pub fn predict(scene: &Scene, ranks: usize, pace: &Pace, comm: &Comm) -> Result<PredictedCost> {
    let plan = setup::plan(scene, particles(scene, comm)?)?;
    let footprint = Footprint::new(scene, &plan, ranks);
    let life = list_life(scene, &plan).unwrap_or(pace.life);
    let cost = Step::new(&pace.machine, &load(scene, &plan, &footprint, life));
    Ok(RunForecast::new(scene, &plan, &footprint, pace, &cost).price)
}

/// The pace of a scene. Collective.
pub fn pace(scene: &Scene, ranks: usize, network: Option<Network>, comm: &Comm) -> Result<Pace> {
    let plan = setup::plan(scene, particles(scene, comm)?)?;
    pace::measure(scene, &plan.constants, Footprint::new(scene, &plan, ranks).owned, network, comm)
}

/// The predicted course of a run, its output and its cost.
struct RunForecast<'a> {
    first: f64,
    limiting: &'a str,
    dt: f64,
    end: f64,
    why: String,
    files: String,
    bytes: f64,
    writing: f64,
    price: PredictedCost,
}

impl<'a> RunForecast<'a> {
    fn new(scene: &'a Scene, plan: &Plan, footprint: &Footprint, pace: &Pace, cost: &Step) -> Self {
        let StepForecast { first, limiting, dt, end, why, steps, .. } = StepForecast::new(scene, plan);
        let work = steps * work_of_step(scene, plan, dt);
        let (files, bytes) = output(scene, plan, footprint.particles, end, work * cost.wall());
        let writing = bytes / pace.machine.files;
        let inside = libm::pow(1.0 + scene.numerics.skin.first(), -(scene.dimension as f64));
        let price = PredictedCost {
            particles: footprint.particles,
            steps,
            wall_seconds: work * cost.wall() + writing,
            core_seconds: work * footprint.ranks as f64 * cost.work(),
            pair_interactions: work * footprint.particles as f64 * footprint.neighbours * inside,
        };
        Self { first, limiting, dt, end, why, files, bytes, writing, price }
    }
}

/// The steps of a run, as far as they can be known.
struct StepForecast<'a> {
    first: f64,
    limiting: &'a str,
    dt: f64,
    /// End of the run in simulated time, s.
    end: f64,
    why: String,
    steps: f64,
    /// Evaluations of the particles' own gravity.
    evaluations: f64,
}

impl<'a> StepForecast<'a> {
    fn new(scene: &'a Scene, plan: &Plan) -> Self {
        let (first, limiting) = match step(scene, plan, 0.0) {
            (dt, limiting) if dt.is_finite() => (dt, limiting),
            _ => step(scene, plan, fastest(scene)),
        };
        // Shocks of an impact close in with about its speed, in some particle or other until the end.
        let dt = scene.impact.as_ref().map_or(first, |impact| step(scene, plan, impact.speed).0);
        let (end, why) = end(scene);
        let switch = late_time(scene).map_or(end, |at| at.min(end));
        let soft = soft_step(scene, plan).unwrap_or(dt);
        // A step ends where a snapshot is due.
        let apart = if let Snapshots::Every(interval) = scene.output.snapshots { interval } else { f64::INFINITY };
        let (dt, soft) = (dt.min(apart), soft.min(apart));
        let interval = plan.gravity.and_then(|gravity| gravity.own).map_or(f64::INFINITY, |own| own.interval);
        let parts = [(switch, dt), (end - switch, soft)];
        let evaluations = parts.map(|(time, dt)| time / interval.max(dt)).iter().sum::<f64>();
        let steps = (switch / dt + (end - switch) / soft).ceil();
        let most = scene.run.steps.map_or(f64::INFINITY, |most| most as f64);
        if steps <= most {
            return Self { first, limiting, dt, end, why, steps, evaluations };
        }
        let (end, evaluations) = (end.min(most * dt), evaluations * most / steps);
        Self { first, limiting, dt, end, why, steps: most, evaluations }
    }

    fn evaluations_per_step(&self) -> f64 {
        self.evaluations / self.steps
    }
}

/// The largest speed of a body's side, m/s: it limits the step of cold gas.
fn fastest(scene: &Scene) -> f64 {
    let at_side = |body: &Body| {
        let mut side = body.centre;
        side[0] += body.shape.outer_radius();
        body.velocity_at(side).iter().map(|v| v * v).sum::<f64>().sqrt()
    };
    scene.bodies.iter().map(at_side).fold(0.0, f64::max)
}

/// When the late stage begins, s, if there is one: at the earliest, where that is to be seen.
fn late_time(scene: &Scene) -> Option<f64> {
    match scene.late_stage?.at {
        Until::Time(at) => Some(at),
        Until::Settled => Some(earliest_settled(scene)),
    }
}

fn earliest_settled(scene: &Scene) -> f64 {
    Settled::new(scales::first_contact(scene), scales::crossing(scene), 0.0).earliest()
}

/// The step of soft matter at rest, s.
fn soft_step(scene: &Scene, plan: &Plan) -> Option<f64> {
    let late = scene.late()?;
    let steps = plan.constants.iter().zip(&late.0).enumerate().map(|(number, (constants, softening))| {
        let (viscosity, sound) = (plan.view.material_viscosity(number), softening.longitudinal_sound());
        time_step::cfl(scene.numerics.cfl, constants.smoothing_length, sound, viscosity, 0.0)
    });
    Some(steps.fold(f64::INFINITY, f64::min))
}

fn time(scene: &Scene, plan: &Plan, footprint: &Footprint, pace: &Pace, cost: &Step) -> String {
    let (run, ranks) = (RunForecast::new(scene, plan, footprint, pace, cost), footprint.ranks);
    let mut text = String::new();
    let mut line = |what: &str, value: String| {
        let _ = writeln!(text, "  {what:<34}{value}");
    };
    line("first step", format!("{} s, by the CFL condition in body {}", number(run.first), run.limiting));
    line("end", format!("{} s, {}", number(run.end), run.why));
    let limit = if scene.impact.is_some() { "the CFL condition at the speed of impact" } else { "the first" };
    let soft = late_time(scene).zip(soft_step(scene, plan));
    let soft = soft.map(|(at, dt)| format!(", from {} s on of {} s", number(at), number(dt))).unwrap_or_default();
    line("steps", format!("{:.0}, were all of {} s as {limit} allows{soft}", run.price.steps, number(run.dt)));
    line("updates per core-second", format!("{:.2e}", footprint.owned / cost.work()));
    let rate = format!("{} per second, {}", size(pace.machine.files), pace.files_by);
    line("output", format!("{}: {}, {} at {rate}", run.files, size(run.bytes), duration(run.writing)));
    let price = |runs: f64| {
        let (wall, core) = (runs * run.price.wall_seconds, runs * run.price.core_seconds);
        format!("{} on {ranks} rank{}, {core:.3e} core-seconds", duration(wall), if ranks == 1 { "" } else { "s" })
    };
    if scene.threshold.is_some() {
        line("one impact", price(1.0));
        line(&format!("the search, of about {IMPACTS} impacts"), price(IMPACTS));
    } else {
        line("the run", price(1.0));
    }
    format!("\ntime; core-seconds are without waits of ranks for each other and without output\n{text}")
}

/// The output of a run, in words and in bytes. `until`: its end in simulated time, s, and in wall time, s.
fn output(scene: &Scene, plan: &Plan, particles: u64, end: f64, wall: f64) -> (String, f64) {
    let entries = &plan.registry.entries;
    let words = |wanted: &dyn Fn(&Entry) -> bool| entries.iter().filter(|e| wanted(e)).map(|e| e.width).sum::<usize>();
    let real = if scene.output.precision == Precision::F32 { 4.0 } else { 8.0 };
    let snapshots = match scene.output.snapshots {
        Snapshots::Never => 0.0,
        Snapshots::AtEnd => 1.0,
        Snapshots::Every(interval) => (end / interval - 1e-9).ceil() + 1.0,
    };
    let checkpoints = 1.0 + (wall / scene.run.checkpoint_every).floor();
    let of_snapshots = snapshots * real * words(&|entry| entry.info.snapshot) as f64;
    let of_checkpoints = checkpoints * 8.0 * words(&|entry| entry.info.life.is_state()) as f64;
    let s = if checkpoints == 1.0 { "" } else { "s" };
    let bytes = particles as f64 * (of_snapshots + of_checkpoints);
    (format!("{snapshots} snapshots, {checkpoints} checkpoint{s}"), bytes)
}

/// The step that the signal speed allows where particles approach with this speed, s, and the body that limits it: of those that do
/// not take small steps.
fn step<'a>(scene: &'a Scene, plan: &Plan, approach: f64) -> (f64, &'a str) {
    step_of(false, scene, plan, approach)
}

/// Evaluations of all particles that a step of `dt` seconds is worth: more than one, where some bodies take small steps. What touches
/// them is left out.
fn work_of_step(scene: &Scene, plan: &Plan, dt: f64) -> f64 {
    let Some(rates) = &plan.two_rates else { return 1.0 };
    let speed = scene.impact.as_ref().map_or(0.0, |impact| impact.speed);
    let (small, _) = step_of(true, scene, plan, speed);
    let asked = (dt / small).ceil().max(1.0);
    let small_steps = rates.steps.map_or(asked, f64::from);
    let all: u64 = plan.constants.iter().map(|body| body.particles).sum();
    let fast = plan.constants.iter().zip(&rates.bodies).filter(|(_, fast)| **fast);
    let share = fast.map(|(body, _)| body.particles).sum::<u64>() as f64 / all as f64;
    1.0 + share * (small_steps - 1.0)
}

/// The step of those bodies that take small ones, or of the others.
fn step_of<'a>(fast: bool, scene: &'a Scene, plan: &Plan, approach: f64) -> (f64, &'a str) {
    let is_fast = |number: usize| plan.two_rates.as_ref().is_some_and(|rates| rates.bodies[number]);
    let bodies = plan.constants.iter().enumerate().filter(|(number, _)| is_fast(*number) == fast);
    let steps = bodies.map(|(number, constants)| {
        let body = &scene.bodies[number];
        let (viscosity, sound) = (plan.view.material_viscosity(number), scales::sound_speed(scene, number));
        let dt = time_step::cfl(scene.numerics.cfl, constants.smoothing_length, sound, viscosity, approach);
        (dt, body.name.as_str())
    });
    steps.fold((f64::INFINITY, ""), |a, b| if b.0 < a.0 { b } else { a })
}

/// When the run will end, s, as far as it can be known, and by which condition.
fn end(scene: &Scene) -> (f64, String) {
    let (end, why) = match scene.run.until {
        Until::Time(end) => (end, "run.until".to_string()),
        Until::Settled if scene.reaccumulates() => {
            let fall = free_fall_time(scene);
            let why = "if gravity has done its work as early as it may, a free-fall time after the shock";
            (earliest_settled(scene) + fall, why.to_string())
        }
        Until::Settled if scene.hits_ground() => {
            (earliest_settled(scene), "if it settles as early as it may".to_string())
        }
        Until::Settled => {
            let settled = earliest_settled(scene);
            let why = format!(
                "if it settles as early as it may, at {} s, and the largest remnant lasts from then on",
                number(settled)
            );
            (Lasting::earliest(scales::first_contact(scene), settled), why)
        }
    };
    match scene.run.max_time {
        Some(most) if most < end => (most, "run.max_time".to_string()),
        _ => (end, why),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene(overrides: &[&str]) -> (Scene, Plan) {
        let overrides: Vec<String> = overrides.iter().map(|o| o.to_string()).collect();
        let scene = Scene::parse("qd.toml", include_str!("../../inputs/qd_star.toml"), &overrides).unwrap();
        let constants = scene.bodies.iter().map(|body| body.constants(1000, scene.numerics.eta)).collect();
        let plan = setup::plan(&scene, constants).expect("a plan");
        (scene, plan)
    }

    #[test]
    fn every_effect_names_its_tables() {
        let (all, plan) =
            scene(&["numerics.artificial_stress=true", "numerics.smoothing_length={follows=\"density\"}"]);
        let text = effects(&all, &plan);
        for (effect, table) in [
            ("density", "every scene"),
            ("eos", "[material.basalt.eos]"),
            ("strength", "[material.basalt.strength]"),
            ("fracture", "[material.basalt.fracture]"),
            ("record", "[record] peak_pressure"),
            ("smoothing_length", "[numerics] smoothing_length"),
            ("viscosity", "[material.basalt.viscosity]"),
            ("corrected_gradient", "[numerics] corrected_gradient"),
            ("artificial_stress", "[numerics] artificial_stress"),
        ] {
            let line = text.lines().find(|line| line.trim_start().starts_with(effect)).unwrap_or_default();
            assert!(line.ends_with(table), "{effect}: {line:?}");
        }
        let (bare, plan) = scene(&["material.basalt.fracture=false", "record=false", "numerics.viscosity=false"]);
        let text = effects(&bare, &plan);
        assert!(
            ["fracture", "record", "viscosity", "smoothing_length"].iter().all(|name| !text.contains(name)),
            "{text}"
        );
    }

    /// Both have a thousand particles, so that those of the projectile are closer.
    #[test]
    fn small_steps_of_some_bodies_are_counted() {
        let (plain, plan) = scene(&[]);
        let (dt, body) = step(&plain, &plan, 5e3);
        assert_eq!((body, work_of_step(&plain, &plan, dt)), ("projectile", 1.0));
        let (two, plan) = scene(&["two_rates.fast=[\"projectile\"]"]);
        let (large, body) = step(&two, &plan, 5e3);
        let (small, _) = step_of(true, &two, &plan, 5e3);
        assert!(body == "target" && small == dt && large > dt, "{body} {small} {large} {dt}");
        let steps = (large / small).ceil();
        assert_eq!(work_of_step(&two, &plan, large), 1.0 + 0.5 * (steps - 1.0));
        let (given, plan) = scene(&["two_rates={ fast = [\"projectile\"], steps = 64 }"]);
        assert_eq!(work_of_step(&given, &plan, large), 32.5);
    }

    #[test]
    fn every_column_is_listed() {
        let (_, plan) = scene(&[]);
        let text = columns(&plan);
        assert_eq!(text.lines().count(), 2 + plan.registry.entries.len());
        assert!(text.lines().any(|line| line.split_whitespace().take(3).eq(["deviatoric_stress_rate", "Pa/s", "5"])));
    }

    /// c_L of basalt: K = A = 26.7 GPa, mu = 22.7 GPa at 2700 kg/m^3.
    #[test]
    fn the_first_step_is_that_of_sound() {
        let (scene, plan) = scene(&["numerics.viscosity=false"]);
        let sound = ((26.7e9 + 4.0 / 3.0 * 22.7e9) / 2700.0f64).sqrt();
        let h = plan.constants[1].smoothing_length;
        assert!(plan.constants[0].smoothing_length > h);
        let (dt, body) = step(&scene, &plan, 0.0);
        assert!((dt / (0.25 * h / sound) - 1.0).abs() < 1e-6, "{dt}");
        assert_eq!(body, "projectile");
        // Contact comes within the gap of 2h at 5 km/s; then 2 crossings of 100 km and half of that again.
        let crossing = 1e5 / sound;
        let (end, _) = end(&scene);
        assert!(end > 3.0 * crossing && end < 3.0 * crossing + 4e4 / 5e3, "{end} {crossing}");
    }
    /// A gas without pressure, but for the heat in its middle, where W = 1 / (pi h^3).
    #[test]
    fn a_blast_limits_the_first_step() {
        let text = include_str!("../../inputs/exact/sedov.toml");
        let scene = Scene::parse("sedov.toml", text, &[]).expect("a scene");
        let constants = scene.bodies.iter().map(|body| body.constants(1000, scene.numerics.eta)).collect();
        let plan = setup::plan(&scene, constants).expect("a plan");
        let forecast = StepForecast::new(&scene, &plan);
        let (gamma, h_of_blast) = (5.0 / 3.0, 0.1f64);
        let heat = 1.0 / (std::f64::consts::PI * h_of_blast.powi(3));
        let sound = (gamma * (gamma - 1.0) * heat).sqrt();
        let exact = 0.15 * plan.constants[0].smoothing_length / (sound * (1.0 + 0.6 * 2.0));
        assert!(
            (forecast.first / exact - 1.0).abs() < 1e-12 && forecast.steps == (0.3 / exact).ceil(),
            "{}",
            forecast.first
        );
    }
}
