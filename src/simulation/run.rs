//! The loop over steps: history, snapshots, checkpoints, signals, and the question whether the outcome has settled.

use std::path::{Path, PathBuf};
use std::time::Instant;

use super::faults::Fault;
use super::footprint::Footprint;
use super::log::Progress;
use super::report::{self, Report};
use super::setup;
use super::signals;
use super::state::{Conservation, RunState, Spent};
use super::{directory, resources};
use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::outcome::settled::Settled;
use crate::outcome::{self, Evaluation, Outcome, Question};
use crate::output::publish::replace_text;
use crate::output::{CheckpointMeta, History, Snapshot, Storage, Summary, agree, checkpoint, snapshot};
use crate::particles::ParticleId;
use crate::scene::{Precision, Scene, Until};
use crate::step::phases::Phase;
use crate::step::time_step::Limit;
use crate::step::{Stepper, Totals};

/// How a run is to be done; the scene says what.
#[derive(Debug, Clone)]
pub struct Options {
    pub directory: PathBuf,
    /// Go on from the newest whole checkpoint, where there is one.
    pub resume: bool,
    /// Resident bytes of the process before anything was made.
    pub resident_at_start: f64,
}

/// Why a run came back.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Ended {
    Finished,
    /// A signal asked for it; the checkpoint is whole.
    Interrupted,
}

/// What a run found.
#[derive(Debug, Clone)]
pub struct RunReport {
    pub ended: Ended,
    pub summary: Summary,
    /// Where the run settled, or at its end.
    pub outcome: Option<Outcome>,
    /// At twice the time, where it settled.
    pub later: Option<Outcome>,
}

/// What ranks may ask for after a step; the largest wish counts.
const WANTS_CHECKPOINT: u32 = 1;
const WANTS_STOP: u32 = 2;
/// Something failed on one rank alone; all leave together.
const FAILED: u32 = 3;

/// Runs a scene. Collective.
pub fn run(scene: &Scene, options: &Options, comm: &Comm) -> Result<RunReport> {
    comm.set_file_hints(scene.output.mpi_io_hints.iter().map(|(key, value)| (key.as_str(), value.as_str())));
    match scene.dimension {
        2 => Run::<2>::open(scene, options, comm)?.run_to_end(),
        _ => Run::<3>::open(scene, options, comm)?.run_to_end(),
    }
}

struct Run<'a, const D: usize> {
    scene: &'a Scene,
    options: &'a Options,
    comm: &'a Comm,
    stepper: Stepper<'a, D>,
    state: RunState,
    history: History,
    totals: Totals,
    started: Instant,
    cpu_at_start: f64,
    wait_at_start: f64,
    wait_cpu_at_start: f64,
    saved: Instant,
    fault: Fault,
    evaluation: Option<Evaluation>,
    later: Option<Outcome>,
    /// What failed on this rank alone.
    failed: Option<Error>,
    /// What limits the time step.
    limit: (Limit, &'static str),
}

impl<'a, const D: usize> Run<'a, D> {
    /// Makes the particles or reads them from the newest whole checkpoint.
    fn open(scene: &'a Scene, options: &'a Options, comm: &'a Comm) -> Result<Self> {
        let started = Instant::now();
        let (cpu_at_start, wait_at_start) = (resources::cpu_seconds(), comm.wait_seconds());
        let wait_cpu_at_start = comm.wait_cpu_seconds();
        let log = || super::log::to_file(&options.directory.join("log.txt"), options.resume);
        agree(comm, if comm.is_root() { log() } else { Ok(()) })?;
        let plan = setup::plan(scene, setup::count_particles(scene, comm)?);
        Footprint::new(scene, &plan, comm.size()).require(comm).map_err(|e| e.at(scene.path()))?;
        let hash = scene_hash(scene);
        let saved = if options.resume {
            checkpoint::read_newest(&options.directory, &plan.registry, comm, &hash)?
        } else {
            None
        };
        let (mut stepper, state) = match saved {
            Some(saved) => {
                if let Some(refused) = &saved.refused {
                    tracing::warn!("the newest checkpoint was not taken: {refused}");
                }
                tracing::info!("going on from {}", saved.path.display());
                let mut stepper = Stepper::new(comm, saved.columns, plan.settings(scene));
                stepper.resume();
                let mut state: RunState = serde_json::from_str(&saved.meta.json)
                    .map_err(|e| Error::new(format!("its state cannot be read: {e}")))?;
                (state.counters.pairs, state.counters.updates, state.counters.migrated) = (0, 0, 0);
                (stepper, Some(state))
            }
            None => {
                let (columns, settings) = plan.populate(scene, comm);
                (Stepper::new(comm, columns, settings), None)
            }
        };
        let state = match state {
            Some(state) => state,
            None => Self::first_state(scene, &mut stepper)?,
        };
        stepper.counters = state.counters;
        let totals = stepper.totals();
        let columns = report::history_columns(&stepper.settings.effects, scene);
        let labels: Vec<(&str, &str)> = columns.iter().map(|(name, unit)| (name.as_str(), unit.as_str())).collect();
        let resumed = (state.counters.steps > 0).then_some(state.counters.steps);
        let history = History::open(&options.directory.join("history.csv"), &labels, resumed, comm)?;
        let text = scene.to_toml();
        let write = || replace_text(&options.directory.join("scene.toml"), &text);
        agree(comm, if comm.is_root() { write() } else { Ok(()) })?;
        let fault = Fault::of_rank(comm.rank());
        let saved = Instant::now();
        Ok(Self {
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
            saved,
            fault,
            evaluation: None,
            later: None,
            failed: None,
            limit: (Limit { id: ParticleId(0), ..Limit::NONE }, ""),
        })
    }

    fn first_state(scene: &Scene, stepper: &mut Stepper<'a, D>) -> Result<RunState> {
        let first = stepper.totals();
        let agreed = stepper.start()?;
        let settled = scene.impact.as_ref().filter(|_| scene.run.until == Until::Settled).map(|_| {
            Settled::new(report::first_contact(scene), report::crossing(scene), first.kinetic_in_centre_of_mass())
        });
        Ok(RunState {
            time: 0.0,
            dt: agreed.dt,
            counters: stepper.counters,
            conservation: Conservation::new(&first),
            snapshots: 0,
            settled,
            outcome: None,
            outcome_time: 0.0,
            spent: Spent::default(),
        })
    }

    fn run_to_end(mut self) -> Result<RunReport> {
        let mut progress = Progress::new(&self.options.directory.display().to_string(), self.comm.is_root());
        if self.state.counters.steps == 0 {
            self.write_history();
            self.write_snapshot_if_due()?;
        }
        while !self.is_over() {
            let dt = self.next_step();
            let agreed = self.stepper.step(dt, self.wish())?;
            self.state.time += dt;
            self.state.dt = agreed.dt;
            self.state.counters = self.stepper.counters;
            let steps = self.state.counters.steps;
            if steps % self.scene.output.history_every == 0 {
                self.note_totals()?;
                progress.show(self.done(), || self.describe());
            }
            self.write_snapshot_if_due()?;
            if agreed.signal == FAILED {
                agree(self.comm, self.failed.take().map_or(Ok(()), Err))?;
            }
            if agreed.signal >= WANTS_CHECKPOINT {
                self.write_checkpoint()?;
            }
            if agreed.signal >= WANTS_STOP {
                tracing::warn!("stopped by a signal at step {steps}, t = {:e} s; --resume goes on", self.state.time);
                return self.report(Ended::Interrupted);
            }
        }
        drop(progress);
        agree(self.comm, self.failed.take().map_or(Ok(()), Err))?;
        self.finish()
    }

    /// Seconds of the next step; the last one ends on the dot.
    fn next_step(&self) -> f64 {
        match self.end_time() {
            Some(end) => self.state.dt.min(end - self.state.time),
            None => self.state.dt,
        }
    }

    /// When the run is known to end, s.
    fn end_time(&self) -> Option<f64> {
        let limit = self.scene.run.max_time.unwrap_or(f64::INFINITY);
        let end = match self.scene.run.until {
            Until::Time(end) => end.min(limit),
            // Settled: the outcome is evaluated once more at twice that time.
            Until::Settled if self.state.outcome.is_some() => (2.0 * self.state.outcome_time).min(limit),
            Until::Settled => limit,
        };
        end.is_finite().then_some(end)
    }

    fn is_over(&self) -> bool {
        let steps = self.scene.run.steps.is_some_and(|most| self.state.counters.steps >= most);
        steps || self.end_time().is_some_and(|end| self.state.time >= end)
    }

    /// This rank's wish after the coming step; rank 0 keeps the clock.
    fn wish(&self) -> u32 {
        if self.failed.is_some() {
            return FAILED;
        }
        if self.fault.strike(self.state.counters.steps + 1) || signals::asked() != 0 {
            return WANTS_STOP;
        }
        let due = self.comm.is_root() && self.saved.elapsed().as_secs_f64() > self.scene.run.checkpoint_every;
        if due { WANTS_CHECKPOINT } else { 0 }
    }

    fn note_totals(&mut self) -> Result<()> {
        self.totals = self.stepper.totals();
        self.state.conservation.note(&self.totals);
        self.write_history();
        let time = self.state.time;
        let settled = self.state.settled.as_mut().is_some_and(|settled| settled.update(time, self.totals.internal));
        if settled && self.state.outcome.is_none() {
            tracing::info!("settled at t = {time:.4e} s, step {}", self.state.counters.steps);
            let evaluation = self.evaluate_outcome();
            self.state.outcome = Some(evaluation.outcome.clone());
            self.state.outcome_time = time;
            self.evaluation = Some(evaluation);
            self.write_outcome()?;
        }
        Ok(())
    }

    fn write_history(&mut self) {
        let (limit, reason) = self.stepper.tightest_limit();
        let cells = report::history_row(&self.state, &self.totals, (&limit, reason), D == 2);
        self.limit = (limit, reason);
        tracing::debug!("{}", self.describe());
        // Rank 0 writes; where it fails, all ranks hear of it with the next step.
        if let Err(error) = self.history.row(&cells) {
            self.failed.get_or_insert(error);
        }
    }

    fn evaluate_outcome(&mut self) -> Evaluation {
        let start = Instant::now();
        let core = self.stepper.settings.core;
        let particles = outcome::particles(&self.stepper.columns, &core, &self.stepper.settings.constants);
        let target = self.scene.impact.as_ref().map_or(0, |impact| impact.target);
        let question = Question { dimension: D, target_mass: self.scene.bodies[target].mass() };
        let evaluation = outcome::evaluate(self.comm, &particles, &question);
        self.stepper.phases.add(Phase::Outcome, start);
        evaluation
    }

    /// Distributions of fragments, where the outcome counts.
    fn write_outcome(&mut self) -> Result<()> {
        let Some(evaluation) = &self.evaluation else { return Ok(()) };
        report::write_distributions(evaluation, D, &self.options.directory, self.comm)?;
        if self.scene.output.picture {
            let source = report::PictureSource {
                scene: self.scene,
                stepper: &self.stepper,
                time: self.state.time,
                directory: &self.options.directory,
            };
            report::draw_cut(&source, self.comm)?;
        }
        Ok(())
    }

    fn write_snapshot_if_due(&mut self) -> Result<()> {
        let Some(interval) = self.scene.output.snapshot_interval else { return Ok(()) };
        if self.state.time + 1e-9 * interval < self.state.snapshots as f64 * interval {
            return Ok(());
        }
        self.write_snapshot()
    }

    fn write_snapshot(&mut self) -> Result<()> {
        let start = Instant::now();
        self.state.snapshots += 1;
        let name = format!("snapshot_{:04}.vtkhdf", self.state.snapshots);
        let figures = [
            ("energy_drift".to_string(), self.state.conservation.energy_drift()),
            ("momentum_drift".to_string(), self.state.conservation.momentum),
            ("angular_momentum_drift".to_string(), self.state.conservation.angular_momentum),
        ];
        let output = &self.scene.output;
        let written = Snapshot {
            columns: &self.stepper.columns,
            bodies: &self.stepper.settings.constants,
            time: self.state.time,
            step: self.state.counters.steps,
            scene: &self.scene.to_toml(),
            figures: &figures,
            storage: Storage {
                single_precision: output.precision == Precision::F32,
                gzip: (output.compression > 0).then_some(output.compression),
            },
        };
        let collective = written.write(&self.options.directory.join(&name), self.comm)?;
        if !collective {
            tracing::warn!("{name} was not written collectively");
        }
        let series = self.options.directory.join("snapshots.vtkhdf.series");
        snapshot::extend_series(&series, &name, self.state.time, self.comm)?;
        self.stepper.phases.add(Phase::Output, start);
        Ok(())
    }

    fn write_checkpoint(&mut self) -> Result<()> {
        let start = Instant::now();
        let mut state = self.state.clone();
        state.spent = self.spent();
        let meta = CheckpointMeta {
            scene_hash: scene_hash(self.scene),
            json: serde_json::to_string(&state).map_err(|e| Error::new(e.to_string()))?,
            ..CheckpointMeta::default()
        };
        let id = self.stepper.settings.core.id;
        checkpoint::write(&self.options.directory, &self.stepper.columns, id, &meta, self.comm)?;
        self.saved = Instant::now();
        self.stepper.phases.add(Phase::Output, start);
        Ok(())
    }

    /// What the run has cost so far, over all ranks. Collective.
    fn spent(&self) -> Spent {
        let before = &self.state.spent;
        let counters = &self.stepper.counters;
        let micro = |seconds: f64| (1e6 * seconds) as i64;
        let mut sums = [
            micro(resources::cpu_seconds() - self.cpu_at_start)
                - micro(self.comm.wait_cpu_seconds() - self.wait_cpu_at_start),
            micro(self.comm.wait_seconds() - self.wait_at_start),
            counters.pairs as i64,
            counters.updates as i64,
            counters.migrated as i64,
        ];
        self.comm.all_sum(&mut sums);
        Spent {
            wall: before.wall + self.started.elapsed().as_secs_f64(),
            cpu: before.cpu + 1e-6 * sums[0] as f64,
            wait: before.wait + 1e-6 * sums[1] as f64,
            pairs: before.pairs + sums[2] as u64,
            updates: before.updates + sums[3] as u64,
            migrated: before.migrated + sums[4] as u64,
        }
    }

    /// Share of the run that is done, for the bar.
    fn done(&self) -> f64 {
        let end = match (&self.state.settled, self.end_time()) {
            (_, Some(end)) => end,
            (Some(settled), None) => 2.0 * settled.earliest(),
            (None, None) => f64::INFINITY,
        };
        self.state.time / end
    }

    fn describe(&self) -> String {
        let state = &self.state;
        let (limit, reason) = &self.limit;
        let [x, y, z] = limit.position;
        format!(
            "t {:.3e} s, step {}, energy drift {:.1e}, dt {:.2e} s by {reason} of {} {} at ({x:.3e}, {y:.3e}, {z:.3e}) m",
            state.time,
            state.counters.steps,
            state.conservation.energy_drift(),
            state.dt,
            self.scene.bodies.get(limit.id.body()).map_or("", |body| &body.name),
            limit.id.site(),
        )
    }

    fn finish(mut self) -> Result<RunReport> {
        if self.state.counters.steps % self.scene.output.history_every != 0 {
            self.note_totals()?;
        }
        let later = self.scene.impact.is_some().then(|| self.evaluate_outcome());
        match (later, self.state.outcome.is_some()) {
            (Some(later), true) => self.later = Some(later.outcome),
            (Some(only), false) => {
                self.state.outcome = Some(only.outcome.clone());
                self.state.outcome_time = self.state.time;
                self.evaluation = Some(only);
                self.write_outcome()?;
            }
            (None, _) if self.scene.output.picture => {
                let source = report::PictureSource {
                    scene: self.scene,
                    stepper: &self.stepper,
                    time: self.state.time,
                    directory: &self.options.directory,
                };
                report::draw_cut(&source, self.comm)?;
            }
            _ => {}
        }
        if self.scene.output.snapshot_interval.is_some() {
            self.write_snapshot()?;
        }
        self.write_checkpoint()?;
        self.report(Ended::Finished)
    }

    fn report(self, ended: Ended) -> Result<RunReport> {
        let spent = self.spent();
        let summary = report::summarise(&Report {
            scene: self.scene,
            stepper: &self.stepper,
            state: &self.state,
            totals: &self.totals,
            later: self.later.as_ref(),
            spent,
            resident_at_start: self.options.resident_at_start,
            comm: self.comm,
        });
        if ended == Ended::Finished {
            summary.write(&self.options.directory.join("summary.json"), self.comm)?;
            report::print(&summary, &self.options.directory);
        }
        Ok(RunReport { ended, summary, outcome: self.state.outcome, later: self.later })
    }
}

/// Identifies what was asked for: the scene as understood, without what may change between restarts.
fn scene_hash(scene: &Scene) -> String {
    blake3::hash(scene.identity().as_bytes()).to_hex().to_string()
}

/// Where a scene's file lies decides the default directory.
pub fn default_directory(scene: &Scene) -> PathBuf {
    directory::default_directory(Path::new(scene.path()))
}
