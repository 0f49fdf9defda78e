//! The beginning of a run: particles are made, or read from the newest whole checkpoint.

use std::time::Instant;

use super::collapse::Collapse;
use super::footprint::Footprint;
use super::restart;
use super::results::{ground, intrusion, probes, report, restitution, warnings};
use super::rigid;
use super::run::{Options, Products, Run};
use super::setup::{self, Plan};
use super::state::{Conservation, Restored, RunState, Spent};
use crate::comparison::Comparison;
use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::material::porosity::DISTENTION;
use crate::output::{Checkpoint, History, agree, checkpoint};
use crate::particles::ParticleId;
use crate::process::faults::Fault;
use crate::process::{log, resources};
use crate::scene::Scene;
use crate::step::packing::DensityCheck;
use crate::step::phases::Trace;
use crate::step::time_step::{Limit, NamedLimit};
use crate::step::{Counters, Stepper};
use crate::warning;

impl<'a, const D: usize> Run<'a, D> {
    /// Makes the particles or reads them from the newest whole checkpoint.
    pub(super) fn open(scene: &'a Scene, options: &'a Options, comm: &'a Comm) -> Result<Self> {
        let started = Instant::now();
        let (cpu_at_start, wait_at_start) = (resources::cpu_seconds(), comm.wait_seconds());
        let wait_cpu_at_start = comm.wait_cpu_seconds();
        agree(comm, log::to_file(&options.directory.join("log.txt"), options.resume, comm.is_root()))?;
        if let Some(choice) = &options.accuracy {
            tracing::info!("{choice}");
        }
        warning::log(&warnings::of_scene(scene), comm.is_root());
        let comparison = Comparison::new(scene)?;
        let plan = plan_that_fits(scene, comm)?;
        let fault = Fault::of_rank(comm.rank());
        let saved = if options.resume {
            checkpoint::read_newest(&options.directory, &plan.registry, comm, &|before| scene.differs_from(before))?
        } else {
            None
        };
        let fresh = saved.is_none();
        let (mut stepper, state) = match saved {
            Some(saved) => Self::restore(scene, plan, saved, &fault, comm)?,
            None => Self::start(scene, plan, &fault, comm)?,
        };
        let totals = stepper.totals();
        let history = history(scene, options, &stepper, comm)?;
        if options.trace {
            // All clocks begin together.
            comm.barrier();
            stepper.phases.trace = Some(Trace::begin());
        }
        let mut run = Self {
            scene,
            options,
            comm,
            stepper,
            state,
            history,
            totals,
            started,
            cpu_at_start,
            wait_at_start,
            wait_cpu_at_start,
            saved: Instant::now(),
            fault,
            comparison,
            density: DensityCheck::unknown(),
            failed: None,
            members: None,
            products: Products::default(),
            last: None,
            collapse: Collapse::default(),
            limit: NamedLimit { limit: Limit { id: ParticleId(0), ..Limit::NONE }, reason: "" },
        };
        if fresh {
            run.state.target_turn = run.turn_of_target();
        }
        Ok(run)
    }

    /// Particles and state of a checkpoint.
    fn restore(
        scene: &Scene,
        plan: Plan,
        saved: Checkpoint,
        fault: &Fault,
        comm: &'a Comm,
    ) -> Result<(Stepper<'a, D>, RunState)> {
        if let Some(refused) = saved.refused.as_ref().filter(|_| comm.is_root()) {
            tracing::warn!("the newest checkpoint was not taken: {refused}");
        }
        tracing::info!("resuming from {}", saved.path.display());
        let mut settings = plan.settings(scene);
        settings.effects.extend(fault.effect(&settings.view.core));
        let restored: Restored =
            serde_json::from_str(&saved.meta.json).map_err(|e| Error::new(format!("its state cannot be read: {e}")))?;
        if let Some(late) = scene.late().filter(|_| restored.run.late.is_some()) {
            settings.effects.iter_mut().for_each(|effect| effect.soften(&late));
        }
        let mut stepper = Stepper::new(comm, saved.columns, settings);
        stepper.resume(restored.step);
        stepper.counters = Counters { pairs: 0, updates: 0, migrated: 0, ..restored.counters };
        Ok((stepper, restored.run))
    }

    /// New particles, evaluated once.
    fn start(scene: &Scene, plan: Plan, fault: &Fault, comm: &'a Comm) -> Result<(Stepper<'a, D>, RunState)> {
        let (columns, mut settings) = plan.populate(scene, comm)?;
        settings.effects.extend(fault.effect(&settings.view.core));
        let mut stepper = Stepper::new(comm, columns, settings);
        let state = Self::first_state(scene, &mut stepper)?;
        Ok((stepper, state))
    }

    fn first_state(scene: &Scene, stepper: &mut Stepper<'a, D>) -> Result<RunState> {
        stepper.start().map_err(|failure| failure.error(|body| &scene.bodies[body].name))?;
        let first = stepper.totals();
        Ok(RunState {
            conservation: Conservation::new(&first),
            intrusion: intrusion::begin(scene, stepper),
            bounce: restitution::begin(scene, stepper),
            snapshots: 0,
            settled: restart::settling(scene, first.kinetic_in_centre_of_mass()),
            snapshot_time: None,
            lasting: None,
            reaccumulated: None,
            late: None,
            vibration: Vec::new(),
            most_filling: 0.0,
            target_turn: None,
            outcome: None,
            crater: None,
            outcome_time: 0.0,
            end: None,
            spent: Spent::default(),
        })
    }
}

/// Columns and effects of a scene whose particles fit into memory. Collective.
fn plan_that_fits(scene: &Scene, comm: &Comm) -> Result<Plan> {
    let fit = |plan: &Plan| Footprint::new(scene, plan, comm.size()).require(comm).map_err(|e| e.at(scene.path()));
    // Where a run cannot fit by far, its particles need not be counted.
    if let Some(expected) = setup::expected_particles(scene) {
        fit(&setup::plan(scene, expected)?)?;
    }
    let plan = setup::plan(scene, setup::count_particles(scene, comm)?)?;
    fit(&plan)?;
    Ok(plan)
}

/// history.csv with the columns of the scene; one that is there goes on. Collective.
fn history<const D: usize>(scene: &Scene, options: &Options, stepper: &Stepper<D>, comm: &Comm) -> Result<History> {
    let settings = &stepper.settings;
    let mut columns = report::history_columns(&settings.effects, settings.prescribes_motion(), scene);
    columns.extend(probes::columns(scene, stepper.columns.registry.find::<f64>(DISTENTION).is_some()));
    let fall = intrusion::COLUMNS.iter().filter(|_| scene.intrusion.is_some());
    columns.extend(fall.map(|(name, unit)| (name.to_string(), unit.to_string())));
    let momentum = scene.outcome.map(|_| ground::COLUMN);
    let speed = scene.restitution.map(|_| restitution::COLUMN);
    columns.extend(momentum.into_iter().chain(speed).map(|(name, unit)| (name.to_string(), unit.to_string())));
    columns.extend(rigid::columns(scene));
    let labels: Vec<(&str, &str)> = columns.iter().map(|(name, unit)| (name.as_str(), unit.as_str())).collect();
    let resumed = Some(stepper.state.step).filter(|&step| step > 0);
    History::open(&options.directory.join("history.csv"), &labels, resumed, comm)
}
