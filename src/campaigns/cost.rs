//! What a scene is and what it will cost, before it runs: the text of `--check`.

use std::fmt::Write;

use toml::{Table, Value};

use super::pace::{self, Pace};
use crate::domain::comm::Comm;
use crate::error::Result;
use crate::outcome::settled::Settled;
use crate::particles::Life;
use crate::scene::{Scene, Until};
use crate::simulation::footprint::Footprint;
use crate::simulation::setup::{self, Plan};
use crate::simulation::{report, resources};
use crate::step::time_step;

/// Impacts that a threshold search usually takes.
const IMPACTS: f64 = 6.0;

/// Describes the scene and its cost on `ranks` ranks of one thread each. Collective.
pub fn check(scene: &Scene, ranks: usize, comm: &Comm) -> Result<String> {
    let plan = setup::plan(scene, setup::count_particles(scene, comm)?);
    let footprint = Footprint::new(scene, &plan, ranks);
    let pace = pace::measure(scene, &plan.constants, comm)?;
    let parts = [
        bodies(scene, &plan),
        effects(scene, &plan),
        columns(&plan),
        memory(&plan, &footprint, ranks),
        time(scene, &plan, &footprint, (pace, ranks)),
    ];
    Ok(parts.concat())
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
    format!("{}\n{} in {} dimensions\n\n{}", scene.title, scene.path(), scene.dimension, aligned(&rows))
}

/// Effects and pair terms, each with the tables that ask for it.
fn effects(scene: &Scene, plan: &Plan) -> String {
    let understood: Table = scene.to_toml().parse().unwrap_or_default();
    let mut rows = vec![words(["effect", "asked for by"])];
    let mut row = |name: &str| {
        let tables = tables(&understood, name);
        let why = if tables.is_empty() { "every scene".to_string() } else { tables.join(", ") };
        rows.push(vec![name.to_string(), why]);
    };
    plan.effects.iter().for_each(|effect| row(effect.name()));
    ["viscosity", "corrected_gradient", "artificial_stress"]
        .iter()
        .zip([scene.numerics.viscosity, plan.terms.correction, plan.terms.artificial_stress])
        .filter(|(_, on)| *on)
        .for_each(|(name, _)| row(name));
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
        let about = if entry.name == entry.info.name { entry.info.about } else { "Rate at the last evaluation." };
        let unit = if entry.name == entry.info.name { entry.info.unit.to_string() } else { rate_of(entry.info.unit) };
        let life = if entry.info.life == Life::State { "state" } else { "scratch" };
        let snapshots = if entry.info.snapshot { "yes" } else { "no" };
        let width = entry.width.to_string();
        rows.push(words([entry.name.as_str(), &unit, &width, entry.owner, life, snapshots, about]));
    }
    format!("\n{}", aligned(&rows))
}

fn rate_of(unit: &str) -> String {
    if unit.is_empty() { "1/s".into() } else { format!("{unit}/s") }
}

fn memory(plan: &Plan, footprint: &Footprint, ranks: usize) -> String {
    let mut text = String::new();
    let layout = &footprint.layout;
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
        line("warning", format!("{ranks} ranks on this machine would not fit into its memory"));
    }
    let sent = format!("{} per rank, {} in all", size(footprint.sent()), size(footprint.sent() * ranks as f64));
    line("sent in a step", sent);
    format!("\nmemory on {ranks} rank{}\n{text}", if ranks == 1 { "" } else { "s" })
}

fn time(scene: &Scene, plan: &Plan, footprint: &Footprint, (pace, ranks): (Pace, usize)) -> String {
    let (first, limiting) = step(scene, plan, 0.0);
    // Shocks of an impact close in with about its speed, in some particle or other until the end.
    let dt = scene.impact.as_ref().map_or(first, |impact| step(scene, plan, impact.speed).0);
    let (end, why) = end(scene);
    let steps = (end / dt).ceil().min(scene.run.steps.map_or(f64::INFINITY, |most| most as f64));
    let updates = steps * footprint.particles as f64;
    let core_seconds = updates / pace.updates_per_core_second;
    let mut text = String::new();
    let mut line = |what: &str, value: String| {
        let _ = writeln!(text, "  {what:<34}{value}");
    };
    line("first step", format!("{} s, by the CFL condition in body {limiting}", number(first)));
    line("end", format!("{} s, {why}", number(end)));
    let limit = if scene.impact.is_some() { "the CFL condition at the speed of impact" } else { "the first" };
    line("steps", format!("{steps:.0}, were all of {} s as {limit} allows", number(dt)));
    let Pace { particles, steps, list_builds, .. } = pace;
    let how = format!("measured here: {particles} particles, {steps} steps, {list_builds} list builds");
    line("updates per core-second", format!("{:.2e}, {how}", pace.updates_per_core_second));
    let cost = |runs: f64| {
        let core = runs * core_seconds;
        let apart = if ranks > 1 { format!(", {} on {ranks}", duration(core / ranks as f64)) } else { String::new() };
        format!("{} on one core{apart}", duration(core))
    };
    if scene.threshold.is_some() {
        line("one impact", cost(1.0));
        line(&format!("the search, of about {IMPACTS} impacts"), cost(IMPACTS));
    } else {
        line("the run", cost(1.0));
    }
    format!("\ntime, without waits of ranks for each other and without output\n{text}")
}

/// The step that the signal speed allows where particles approach with this speed, s, and the body that limits it.
fn step<'a>(scene: &'a Scene, plan: &Plan, approach: f64) -> (f64, &'a str) {
    let steps = plan.constants.iter().enumerate().map(|(number, constants)| {
        let body = &scene.bodies[number];
        let [alpha, beta] = scene.materials[body.material].viscosity_coefficients().unwrap_or_default();
        let sound = report::sound_speed(scene, number);
        let dt = time_step::cfl(scene.numerics.cfl, constants.smoothing_length, sound, (alpha, beta), approach);
        (dt, body.name.as_str())
    });
    steps.fold((f64::INFINITY, ""), |a, b| if b.0 < a.0 { b } else { a })
}

/// When the run will end, s, as far as it can be known, and what says so.
fn end(scene: &Scene) -> (f64, String) {
    let (end, why) = match scene.run.until {
        Until::Time(end) => (end, "run.until".to_string()),
        Until::Settled => {
            let settled = Settled::new(report::first_contact(scene), report::crossing(scene), 0.0).earliest();
            (
                2.0 * settled,
                format!(
                    "if it settles as early as it may, at {} s; then it goes on to twice that time",
                    number(settled)
                ),
            )
        }
    };
    match scene.run.max_time {
        Some(most) if most < end => (most, "run.max_time".to_string()),
        _ => (end, why),
    }
}

fn words<const N: usize>(cells: [&str; N]) -> Vec<String> {
    cells.map(str::to_string).to_vec()
}

/// Rows with their cells below each other.
fn aligned(rows: &[Vec<String>]) -> String {
    let columns = rows.first().map_or(0, Vec::len);
    let width = |k: usize| rows.iter().map(|row| row[k].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let mut text = String::new();
    for row in rows {
        let line: String = row.iter().zip(&widths).map(|(cell, width)| format!("  {cell:<width$}")).collect();
        let _ = writeln!(text, "{}", line.trim_end());
    }
    text
}

/// Four digits.
fn number(x: f64) -> String {
    if x == 0.0 || (1e-2..1e5).contains(&x.abs()) {
        let magnitude = if x == 0.0 { 0 } else { libm::floor(libm::log10(x.abs())) as i32 };
        format!("{x:.*}", (3 - magnitude).max(0) as usize)
    } else {
        format!("{x:.3e}")
    }
}

fn size(bytes: f64) -> String {
    scaled(bytes, &[(1e12, "TB"), (1e9, "GB"), (1e6, "MB"), (1e3, "kB"), (1.0, "bytes")])
}

fn duration(seconds: f64) -> String {
    scaled(seconds, &[(86400.0, "days"), (3600.0, "h"), (60.0, "min"), (1.0, "s")])
}

/// In the largest unit that leaves more than one and a half of it, or in the last.
fn scaled(x: f64, units: &[(f64, &str)]) -> String {
    let last = units.len() - 1;
    let (unit, name) = units[units.iter().position(|(unit, _)| x > 1.5 * unit).unwrap_or(last)];
    let digits = if x < 10.0 * unit { 1 } else { 0 };
    format!("{:.digits$} {name}", x / unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene(overrides: &[&str]) -> (Scene, Plan) {
        let overrides: Vec<String> = overrides.iter().map(|o| o.to_string()).collect();
        let scene = Scene::parse("qd.toml", include_str!("../../inputs/qd_star.toml"), &overrides).unwrap();
        let constants = scene.bodies.iter().map(|body| body.constants(1000, scene.numerics.eta)).collect();
        let plan = setup::plan(&scene, constants);
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
        // Contact comes within the gap of 2h at 5 km/s; then 2 crossings of 100 km, twice.
        let crossing = 1e5 / sound;
        let (end, _) = end(&scene);
        assert!(end > 4.0 * crossing && end < 4.0 * crossing + 2.0 * 4e4 / 5e3, "{end} {crossing}");
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!(
            [0.0, 0.0675, 2.5, 1236.0, 20012.0, 1.5e-3].map(number),
            ["0.000", "0.06750", "2.500", "1236", "20012", "1.500e-3"]
        );
        assert_eq!([900.0, 2500.0, 3.2e7, 5e13].map(size), ["900 bytes", "2.5 kB", "32 MB", "50 TB"]);
        assert_eq!([0.25, 80.0, 100.0, 7200.0, 1e6].map(duration), ["0.2 s", "80 s", "1.7 min", "2.0 h", "12 days"]);
    }
}
