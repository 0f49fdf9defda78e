//! What a run says about itself: rows of history.csv, distributions, the picture, and the summary with its price.

use std::path::Path;

use super::state::{RunState, Spent};
use super::{ground, late, resources, warnings};
use crate::domain::comm::Comm;
use crate::error::Result;
use crate::material::MaterialEffect;
use crate::math::Vec3;
use crate::outcome::Outcome;
use crate::outcome::crater::Crater;
use crate::output::figures::cut::{self, Picture};
use crate::output::figures::raster::Plane;
use crate::output::summary::{Accuracy, Figures, Remnants};
use crate::output::{Cell, Summary, state_hash};
use crate::scene::Scene;
use crate::step::packing::Packing;
use crate::step::phases::{NAMES, Phase};
use crate::step::time_step::Limit;
use crate::step::{StepState, Stepper, Totals};
use crate::warning;

/// Names and units of history.csv.
pub fn history_columns(effects: &[Box<dyn MaterialEffect>], prescribed: bool, scene: &Scene) -> Vec<(String, String)> {
    let fixed = [
        ("step", ""),
        ("time", "s"),
        ("dt", "s"),
        ("limited_by", ""),
        ("limiting_body", ""),
        ("limiting_site", ""),
        ("kinetic_energy", "J"),
        ("internal_energy", "J"),
        ("total_energy", "J"),
        ("momentum_x", "kg m/s"),
        ("momentum_y", "kg m/s"),
        ("momentum_z", "kg m/s"),
        ("angular_momentum_x", "kg m^2/s"),
        ("angular_momentum_y", "kg m^2/s"),
        ("angular_momentum_z", "kg m^2/s"),
    ];
    let planar = scene.dimension == 2;
    let kept = fixed
        .iter()
        .filter(|(name, _)| !planar || !["momentum_z", "angular_momentum_x", "angular_momentum_y"].contains(name));
    let own = |(name, unit): &(&str, &str)| (name.to_string(), unit.to_string());
    let potential = scene.gravity.any().then_some(("potential_energy", "J"));
    let held = [
        ("boundary_work", "J"),
        ("boundary_impulse_x", "kg m/s"),
        ("boundary_impulse_y", "kg m/s"),
        ("boundary_impulse_z", "kg m/s"),
    ];
    let held = held.iter().filter(|(name, _)| prescribed && !(planar && *name == "boundary_impulse_z"));
    let diagnostics = effects.iter().flat_map(|effect| effect.diagnostics());
    kept.map(own)
        .chain(potential.iter().map(own))
        .chain(held.map(own))
        .chain(diagnostics.map(|d| (d.name.to_string(), d.unit.to_string())))
        .collect()
}

/// One row of history.csv.
pub fn history_row(
    state: &StepState,
    totals: &Totals,
    (limit, reason): (&Limit, &str),
    (prescribed, planar): (bool, bool),
) -> Vec<Cell> {
    let mut cells = vec![
        Cell::Integer(state.step),
        Cell::Real(state.time),
        Cell::Real(state.next),
        Cell::Text(reason.to_string()),
        Cell::Integer(limit.id.body() as u64),
        Cell::Integer(limit.id.site()),
        Cell::Real(totals.kinetic),
        Cell::Real(totals.internal),
        Cell::Real(totals.energy()),
    ];
    let (p, l) = (totals.momentum, totals.angular_momentum);
    let vectors = if planar { vec![p.x, p.y, l.z] } else { vec![p.x, p.y, p.z, l.x, l.y, l.z] };
    let j = totals.impulse;
    let held = match (prescribed, planar) {
        (false, _) => vec![],
        (true, true) => vec![totals.work, j.x, j.y],
        (true, false) => vec![totals.work, j.x, j.y, j.z],
    };
    cells.extend(vectors.iter().chain(&totals.potential).chain(&held).chain(&totals.effects).map(|x| Cell::Real(*x)));
    cells
}

/// What a picture is made from.
pub struct PictureSource<'a, 'c, const D: usize> {
    pub scene: &'a Scene,
    pub stepper: &'a Stepper<'c, D>,
    pub time: f64,
    pub directory: &'a Path,
}

/// outcome.png: a cut through the plane of impact. Collective.
pub fn draw_cut<const D: usize>(source: &PictureSource<D>, comm: &Comm) -> Result<()> {
    let scene = source.scene;
    let target = scene.impact.as_ref().map_or(0, |impact| impact.target);
    let (face, origin) = (scene.face(), Vec3::from(scene.bodies[target].centre));
    // The projectile comes down in the plane of x and the face's normal; onto a sphere it flies in that of x and y.
    let up = face.map_or(1, |face| face.up);
    let plane = Plane { origin, across: Vec3::x(), up: Vec3::ith(up, 1.0) };
    let picture = Picture {
        title: format!("{} (t = {:.4} s)", scene.title, source.time),
        plane,
        ejected: scene.outcome.map(|asked| (up, asked.ejection_speed)),
        distention: scene.bodies.iter().fold(1.0, |most: f64, body| most.max(body.distention)),
    };
    let particles = (&source.stepper.columns, &source.stepper.settings.view.constants[..]);
    cut::draw(&source.directory.join("outcome.png"), &picture, particles, comm)
}

/// Whether angular momentum is conserved: not where walls hold something, space closes on itself or has a below.
fn turns_freely<const D: usize>(scene: &Scene, stepper: &Stepper<D>) -> bool {
    stepper.settings.motions.is_none() && !scene.periods.any() && scene.gravity.uniform.is_none()
}

/// What a summary is made from.
pub struct Report<'a, 'c, const D: usize> {
    pub scene: &'a Scene,
    pub stepper: &'a Stepper<'c, D>,
    pub state: &'a RunState,
    pub totals: &'a Totals,
    pub later: Option<&'a Outcome>,
    /// Of each body, when it was last looked at.
    pub packing: &'a [Packing],
    pub spent: Spent,
    /// Against the exact solution that the scene names.
    pub errors: Figures,
    pub nbody: Option<Figures>,
    pub resident_at_start: f64,
    pub accuracy: Option<&'a Accuracy>,
    pub comm: &'a Comm,
}

/// The figures of a run. Collective.
pub fn summarise<const D: usize>(report: &Report<D>) -> Summary {
    let (stepper, state, comm) = (report.stepper, report.state, report.comm);
    let owned = stepper.columns.len();
    let memory = (resources::peak_resident_bytes() - report.resident_at_start).max(0.0);
    let list = stepper.neighbourhood.list_bytes();
    let mut sums = [
        owned as i64,
        stepper.neighbourhood.ghosts() as i64,
        memory as i64,
        list as i64,
        comm.bytes_sent() as i64,
        stepper.workers.threads() as i64,
    ];
    comm.all_sum(&mut sums);
    let [particles, ghosts, memory, list, bytes, threads] = sums.map(|x| x as f64);
    let spent = &report.spent;
    let core_seconds = spent.cpu.max(1e-9);
    let conservation = &state.conservation;
    let beside = serde_json::to_string(&stepper.state).unwrap_or_default();
    let mut summary = Summary {
        title: report.scene.title.clone(),
        version: env!("CARGO_PKG_VERSION").to_string(),
        state_hash: state_hash(&stepper.columns, stepper.settings.view.core.id, beside.as_bytes(), comm),
        step_state: serde_json::to_value(&stepper.state).unwrap_or_default(),
        time: stepper.state.time,
        steps: stepper.state.step,
        particles: particles as u64,
        ranks: comm.size(),
        threads_per_rank: threads as usize / comm.size(),
        wall_seconds: spent.wall,
        mpi_wait_seconds: spent.wait,
        core_seconds,
        pair_interactions: spent.pairs,
        updates_per_core_second: spent.updates as f64 / core_seconds,
        bytes_per_particle: memory / particles,
        list_bytes_per_particle: list / particles,
        energy_drift: conservation.energy_drift(),
        energy_drift_over_left: conservation.energy_drift_over_left(report.totals.kinetic_in_centre_of_mass()),
        momentum_drift: conservation.momentum,
        angular_momentum_drift: match turns_freely(report.scene, stepper) {
            true => conservation.angular_momentum,
            false => f64::NAN,
        },
        phases: phase_shares(stepper, comm),
        effects: effect_shares(stepper, comm),
        ghost_fraction: ghosts / particles,
        exchanged_bytes_per_step: bytes / stepper.state.step.max(1) as f64,
        imbalance: stepper.imbalance(),
        list_builds: stepper.counters.list_builds,
        rebisections: stepper.counters.rebisections,
        migrated_particles: spent.migrated,
        errors: report.errors.clone(),
        late_stage: state.late.as_ref().map(|start| late::figures(start, conservation.energy_scale)),
        outcome: state.has_outcome().then(|| outcome_figures(report)),
        remnants: state.outcome.as_ref().map_or(Remnants::default(), |outcome| remnants(outcome, report.scene)),
        nbody: report.nbody.clone(),
        threshold: None,
        accuracy: report.accuracy.cloned(),
        warnings: warnings::of_scene(report.scene),
    };
    let found = warnings::of_run(report, &summary);
    summary.warnings.extend(found);
    summary
}

/// What became of each body.
fn remnants(outcome: &Outcome, scene: &Scene) -> Remnants {
    let named = |name: &str, value: f64| (name.to_string(), value);
    let bodies = outcome.bodies.iter().map(|origin| {
        let body = &scene.bodies[origin.body];
        let figures = Figures(vec![
            named("mass", body.mass()),
            named("remnant_fraction", origin.remnant),
            named("fragment_fraction", origin.fragment),
            named("in_largest_remnant_fraction", origin.in_largest_remnant),
        ]);
        (body.name.clone(), figures)
    });
    Remnants(bodies.collect())
}

/// Share of each phase in the time of all ranks. Collective.
fn phase_shares<const D: usize>(stepper: &Stepper<D>, comm: &Comm) -> Figures {
    shares(NAMES, &stepper.phases.seconds, stepper.phases.total(), comm)
}

/// Share of each effect in the same time: its part of the phases `predict_and_material` and `pairs_rates_and_correct`, where
/// the threads of a rank work side by side. Collective.
fn effect_shares<const D: usize>(stepper: &Stepper<D>, comm: &Comm) -> Figures {
    let effects = &stepper.settings.effects;
    let mut seconds = vec![0.0; effects.len()];
    stepper.workers.collect(|workspace| {
        seconds.iter_mut().zip(workspace.effect_seconds()).for_each(|(sum, mine)| *sum += mine);
    });
    seconds.iter_mut().for_each(|s| *s /= stepper.workers.threads() as f64);
    shares(effects.iter().map(|effect| effect.name()), &seconds, stepper.phases.total(), comm)
}

/// `seconds` of all ranks over the `total` of all ranks. Collective.
fn shares(names: impl IntoIterator<Item = &'static str>, seconds: &[f64], total: f64, comm: &Comm) -> Figures {
    let mut micro: Vec<i64> = seconds.iter().chain([&total]).map(|s| (1e6 * s) as i64).collect();
    comm.all_sum(&mut micro);
    let total = micro[seconds.len()].max(1) as f64;
    Figures(names.into_iter().zip(&micro).map(|(name, t)| (name.to_string(), *t as f64 / total)).collect())
}

fn outcome_figures<const D: usize>(report: &Report<D>) -> Figures {
    let mut figures = vec![("time".to_string(), report.state.outcome_time)];
    if let Some(outcome) = &report.state.outcome {
        figures.extend(remnant_figures(outcome, report.later));
    }
    if let Some(crater) = &report.state.crater {
        figures.extend(ground::figures(crater));
    }
    let diagnostics = report.stepper.settings.effects.iter().flat_map(|effect| effect.diagnostics());
    for (diagnostic, total) in diagnostics.zip(&report.totals.effects) {
        match diagnostic.name.strip_suffix("_mass") {
            Some(what) => figures.push((format!("{what}_fraction"), total / report.totals.mass)),
            // A crater may have told it.
            None if figures.iter().all(|(name, _)| name != diagnostic.name) => {
                figures.push((diagnostic.name.to_string(), *total))
            }
            None => {}
        }
    }
    Figures(figures)
}

fn remnant_figures(outcome: &Outcome, later: Option<&Outcome>) -> Vec<(String, f64)> {
    let named = |name: &str, value: f64| (name.to_string(), value);
    let mut figures = vec![
        named("largest_remnant_fraction", outcome.largest_remnant_fraction),
        named("largest_remnant_of_total", outcome.largest_remnant_of_total),
        named("largest_remnant_particles", outcome.largest_remnant_particles as f64),
        named("largest_remnant_fraction_strict", outcome.strict.largest_remnant_fraction),
        named("largest_fragment_fraction", outcome.largest_fragment_fraction),
        named("largest_fragment_fraction_strict", outcome.strict.largest_fragment_fraction),
        named("second_remnant_fraction", outcome.second_remnant_fraction),
        named("fragments", outcome.fragments as f64),
        named("unbound_mass", outcome.unbound_mass),
        named("target_mass", outcome.target_mass),
        named("total_mass", outcome.total_mass),
    ];
    if let Some(later) = later {
        figures.push(named("largest_remnant_fraction_later", later.largest_remnant_fraction));
        figures.push(named("largest_remnant_of_total_later", later.largest_remnant_of_total));
    }
    figures
}

/// When the bodies of an impact would touch if they flew on as they start, s; zero where they touch already.
pub fn first_contact(scene: &Scene) -> f64 {
    let Some(impact) = &scene.impact else { return 0.0 };
    let (target, projectile) = (&scene.bodies[impact.target], &scene.bodies[impact.projectile]);
    let x = Vec3::from(projectile.centre) - Vec3::from(target.centre);
    let v = Vec3::from(projectile.velocity) - Vec3::from(target.velocity);
    if let Some(face) = scene.face() {
        let reach = projectile.shape.bounds(projectile.dimension);
        let height = projectile.centre[face.up] + reach.middle[face.up] - reach.half[face.up] - face.middle[face.up];
        return (height / -v[face.up]).max(0.0);
    }
    let reach = target.shape.outer_radius() + projectile.shape.outer_radius();
    // |x + v t| = reach, the earlier root.
    let (a, b, c) = (v.norm_squared(), x.dot(&v), x.norm_squared() - reach * reach);
    let discriminant = b * b - a * c;
    if a > 0.0 && discriminant >= 0.0 { ((-b - discriminant.sqrt()) / a).max(0.0) } else { 0.0 }
}

/// Time that sound takes through the largest body, in the target's material, s.
pub fn crossing(scene: &Scene) -> f64 {
    let largest = scene.bodies.iter().map(|b| b.shape.outer_radius()).fold(0.0, f64::max);
    2.0 * largest / sound_speed(scene, scene.impact.as_ref().map_or(0, |impact| impact.target))
}

/// Longitudinal speed of sound of a body at the start, m/s; rigid pores do not change that of the matrix.
pub fn sound_speed(scene: &Scene, body: usize) -> f64 {
    let body = &scene.bodies[body];
    let (material, density) = (&scene.materials[body.material], body.density * body.distention);
    let (_, bulk) = material.eos.law().pressure(density, body.internal_energy);
    let shear = material.strength.as_ref().map_or(0.0, |strength| strength.shear_modulus.0);
    (bulk * bulk + 4.0 / 3.0 * shear / density).sqrt()
}

/// The end of a run on the terminal, rank 0; the first `said` warnings were said before.
pub fn print(summary: &Summary, (crater, said): (Option<&Crater>, usize), directory: &Path, is_root: bool) {
    let phase = |phase: Phase| 100.0 * summary.phases.0[phase as usize].1;
    let turning = match summary.angular_momentum_drift {
        drift if drift.is_finite() => format!(", angular momentum {drift:.1e}"),
        _ => String::new(), // walls or periods do not conserve it
    };
    tracing::info!(
        "{} steps to t = {:.4e} s; drift of energy {:.1e}, momentum {:.1e}{}",
        summary.steps,
        summary.time,
        summary.energy_drift,
        summary.momentum_drift,
        turning
    );
    tracing::info!(
        "{:.1} s wall, {:.1} core-seconds ({:.1} s of MPI waits apart), {:.2e} updates per core-second, {:.0} bytes per particle",
        summary.wall_seconds,
        summary.core_seconds,
        summary.mpi_wait_seconds,
        summary.updates_per_core_second,
        summary.bytes_per_particle
    );
    let gravity = match phase(Phase::Gravity) {
        share if share > 0.0 => format!(" gravity {share:.0} %,"),
        _ => String::new(),
    };
    tracing::info!(
        "pairs {:.0} %,{} material {:.0} %, lists {:.0} %, migration {:.0} %, pack {:.0} %, exposed wait {:.0} %, output {:.0} %",
        phase(Phase::Pairs),
        gravity,
        phase(Phase::Predict),
        phase(Phase::Lists),
        phase(Phase::Migration),
        phase(Phase::Pack),
        phase(Phase::Wait) + phase(Phase::Reduce),
        phase(Phase::Output)
    );
    if let Some(crater) = crater {
        ground::print(crater);
    }
    if let Some(outcome) = summary.outcome.as_ref().filter(|outcome| outcome.0.iter().any(|(n, _)| n == "fragments")) {
        let of = |name: &str| outcome.0.iter().find(|(n, _)| n == name).map_or(f64::NAN, |(_, v)| *v);
        tracing::info!(
            "largest remnant {:.3} of the target (intact fragment {:.3}), {} fragments",
            of("largest_remnant_fraction"),
            of("largest_fragment_fraction"),
            of("fragments")
        );
    }
    warning::say(&summary.warnings[said..], is_root);
    tracing::info!("written to {}{}", directory.display(), warning::in_short(&summary.warnings));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::particles::ParticleId;

    /// A row by the names of its columns.
    fn row(dimension: usize, prescribed: bool) -> Vec<(String, Cell)> {
        let text = format!(
            "dimension = {dimension}\n[[body]]\nname = \"b\"\nshape = {{ sphere = {{ radius = 1 }} }}\nmaterial = \"basalt\"\n\
             particles = 9\n[gravity]\nuniform = {:?}\n[run]\nuntil = 1\n",
            vec![1.0; dimension]
        );
        let scene = Scene::parse("s.toml", &text, &[]).unwrap();
        let state = StepState { step: 7, time: 1.5, next: 0.25, ..StepState::default() };
        let totals = Totals {
            kinetic: 11.0,
            internal: 12.0,
            potential: Some(-3.0),
            momentum: Vec3::new(21.0, 22.0, 23.0),
            angular_momentum: Vec3::new(31.0, 32.0, 33.0),
            work: 41.0,
            impulse: Vec3::new(51.0, 52.0, 53.0),
            ..Totals::default()
        };
        let limit = Limit { id: ParticleId::new(2, 99), ..Limit::NONE };
        let cells = history_row(&state, &totals, (&limit, "sound"), (prescribed, dimension == 2));
        let names = history_columns(&[], prescribed, &scene);
        assert_eq!(names.len(), cells.len(), "{names:?}");
        names.into_iter().map(|(name, _)| name).zip(cells).collect()
    }

    #[test]
    fn every_column_of_the_history_has_its_number() {
        let expected = [
            ("step", Cell::Integer(7)),
            ("time", Cell::Real(1.5)),
            ("dt", Cell::Real(0.25)),
            ("limited_by", Cell::Text("sound".into())),
            ("limiting_body", Cell::Integer(2)),
            ("limiting_site", Cell::Integer(99)),
            ("kinetic_energy", Cell::Real(11.0)),
            ("internal_energy", Cell::Real(12.0)),
            ("total_energy", Cell::Real(20.0)),
            ("momentum_x", Cell::Real(21.0)),
            ("momentum_y", Cell::Real(22.0)),
            ("momentum_z", Cell::Real(23.0)),
            ("angular_momentum_x", Cell::Real(31.0)),
            ("angular_momentum_y", Cell::Real(32.0)),
            ("angular_momentum_z", Cell::Real(33.0)),
            ("potential_energy", Cell::Real(-3.0)),
            ("boundary_work", Cell::Real(41.0)),
            ("boundary_impulse_x", Cell::Real(51.0)),
            ("boundary_impulse_y", Cell::Real(52.0)),
            ("boundary_impulse_z", Cell::Real(53.0)),
        ];
        for (dimension, prescribed, columns) in [(3, true, 20), (3, false, 16), (2, true, 16), (2, false, 13)] {
            let row = row(dimension, prescribed);
            assert_eq!(row.len(), columns, "{row:?}");
            for (name, cell) in row {
                let known = expected.iter().find(|(known, _)| *known == name);
                assert_eq!(known.map(|(_, cell)| cell), Some(&cell), "{name} in {dimension}D");
            }
        }
    }
}
