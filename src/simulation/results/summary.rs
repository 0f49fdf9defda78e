//! The summary of a run: its figures, and its last lines on the terminal.

use std::path::Path;

use super::report::{Report, turns_freely};
use super::{deposit, fragments, ground, intrusion, remnant, restitution, warnings};
use crate::domain::comm::Comm;
use crate::outcome::Outcome;
use crate::outcome::crater::Crater;
use crate::output::summary::{Figures, Remnants};
use crate::output::{Summary, state_hash};
use crate::process::resources;
use crate::scene::Scene;
use crate::simulation::scales::has_balance;
use crate::simulation::{late, rigid};
use crate::step::Stepper;
use crate::step::phases::{NAMES, Phase};
use crate::warning;

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
    let (balances, left) = (has_balance(report.scene), report.totals.kinetic_in_centre_of_mass());
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
        energy_drift: if balances { conservation.energy_drift() } else { f64::NAN },
        energy_drift_over_left: if balances { conservation.energy_drift_over_left(left) } else { f64::NAN },
        momentum_drift: conservation.momentum,
        angular_momentum_drift: match turns_freely(report.scene, stepper) {
            true => conservation.angular_momentum,
            false => f64::NAN,
        },
        density_drift: report.density.drift,
        phases: phase_shares(stepper, comm),
        effects: effect_shares(stepper, comm),
        ghost_fraction: ghosts / particles,
        exchanged_bytes_per_step: bytes / stepper.state.step.max(1) as f64,
        imbalance: stepper.imbalance(),
        refused_steps: stepper.counters.refused,
        small_steps: report.scene.two_rates.is_some().then_some(stepper.counters.small_steps),
        list_builds: stepper.counters.list_builds,
        rebisections: stepper.counters.rebisections,
        migrated_particles: spent.migrated,
        errors: report.errors.clone(),
        late_stage: state.late.as_ref().map(|start| late::figures(start, conservation.energy_scale)),
        outcome: state.has_outcome().then(|| outcome_figures(report)),
        remnants: state.outcome.as_ref().map_or(Remnants::default(), |outcome| remnants(outcome, report.scene)),
        intrusion: state.intrusion.as_ref().map(|fall| intrusion::figures(fall, report.scene)),
        restitution: state.bounce.as_ref().map(restitution::figures),
        fragments: report.answers.fragments.clone(),
        deposit: report.answers.deposit.clone(),
        rigid: rigid::figures(report.scene, &stepper.state.rigid),
        nbody: report.answers.nbody.clone(),
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
        figures.extend(remnant_figures(outcome));
        figures.extend(remnant::figures(outcome, report.state.target_turn, report.scene));
        figures.extend(momentum_enhancement(report.scene, outcome));
    }
    if let Some(crater) = &report.state.crater {
        figures.extend(ground::figures(crater));
    }
    let diagnostics = report.stepper.settings.effects.iter().flat_map(|effect| effect.diagnostics());
    for (diagnostic, total) in diagnostics.zip(&report.totals.effects) {
        match diagnostic.name.strip_suffix("_mass") {
            Some(what) => figures.push((format!("{what}_fraction"), total / report.totals.mass)),
            // A crater may have reported it.
            None if figures.iter().all(|(name, _)| name != diagnostic.name) => {
                figures.push((diagnostic.name.to_string(), *total))
            }
            None => {}
        }
    }
    Figures(figures)
}

/// beta of a whole body: the momentum that its largest remnant has got along the normal, over what the projectile brought along it
/// (Holsapple & Housen 2012, Icarus 221, 875); ejecta that leave it have taken the rest the other way.
fn momentum_enhancement(scene: &Scene, outcome: &Outcome) -> Option<(String, f64)> {
    let (inwards, brought) = scene.impulse_on_body()?;
    let gained: f64 = inwards.iter().zip(outcome.largest_remnant_momentum).map(|(n, p)| n * p).sum();
    Some(("momentum_enhancement".to_string(), gained / brought))
}

fn remnant_figures(outcome: &Outcome) -> Vec<(String, f64)> {
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
    if let Some(trend) = outcome.trend {
        figures.push(named("largest_remnant_fraction_later", outcome.later_fraction()));
        figures.push(named("largest_remnant_of_total_later", outcome.later_of_total()));
        figures.push(named("largest_remnant_of_total_uncertainty", trend.uncertainty));
    }
    figures
}

/// The end of a run on the terminal, rank 0; the first `printed` warnings were printed before.
pub fn print(summary: &Summary, crater: Option<&Crater>, printed: usize, directory: &Path, is_root: bool) {
    let phase = |phase: Phase| 100.0 * summary.phases.0[phase as usize].1;
    let turning = match summary.angular_momentum_drift {
        drift if drift.is_finite() => format!(", angular momentum {drift:.1e}"),
        _ => String::new(), // walls or periods do not conserve it
    };
    let energy = match summary.energy_drift {
        drift if drift.is_finite() => format!("energy {drift:.1e}, "),
        _ => String::new(), // cold matter does not account for it
    };
    let density = match summary.density_drift {
        drift if drift.is_finite() => format!("; density within {:.1} % of mass over volume", 100.0 * drift),
        _ => String::new(), // no particle is surrounded
    };
    tracing::info!(
        "{} steps to t = {:.4e} s; drift of {energy}momentum {:.1e}{turning}{density}",
        summary.steps,
        summary.time,
        summary.momentum_drift
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
    if let Some(figures) = &summary.intrusion {
        intrusion::print(figures);
    }
    if let Some(figures) = &summary.restitution {
        restitution::print(figures);
    }
    if let Some(found) = &summary.fragments {
        fragments::print(found);
    }
    if let Some(figures) = &summary.deposit {
        deposit::print(figures);
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
    warning::log(&summary.warnings[printed..], is_root);
    tracing::info!("written to {}{}", directory.display(), warning::in_short(&summary.warnings));
}
