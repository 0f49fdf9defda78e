//! The loop over steps: when to write, signals, and whether the outcome has settled.

use std::time::Instant;

use super::collapse;
use super::due::{self, NextStep};
use super::run::{Ended, Options, Run, RunReport};
use super::scales::{first_contact, free_fall_time, has_balance};
use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::material::dust::FILLING_FACTOR;
use crate::outcome::lasting::Lasting;
use crate::outcome::restitution::Bounce;
use crate::output::publish::replace_text;
use crate::output::{agree, on_root};
use crate::process::faults::Trigger;
use crate::process::log::Progress;
use crate::process::{resources, signals};
use crate::scene::{Scene, Until};
use crate::step::Failure;
use crate::step::phases::Phase;
use crate::step::time_step::NamedLimit;

/// What ranks may request after a step; the largest request counts.
const CHECKPOINT: u32 = 1;
const STOP: u32 = 2;
/// An operation failed on one rank alone; all ranks end together.
const FAILED: u32 = 3;

/// Runs a scene. Collective.
pub fn run(scene: &Scene, options: &Options, comm: &Comm) -> Result<RunReport> {
    comm.set_file_hints(scene.output.mpi_io_hints.iter().map(|(key, value)| (key.as_str(), value.as_str())));
    match scene.dimension {
        2 => Run::<2>::open(scene, options, comm)?.run_to_end(),
        _ => Run::<3>::open(scene, options, comm)?.run_to_end(),
    }
}

impl<'a, const D: usize> Run<'a, D> {
    fn run_to_end(mut self) -> Result<RunReport> {
        if let Some(found) = self.take_up()? {
            return Ok(found);
        }
        let write = || replace_text(&self.options.directory.join("scene.toml"), &self.scene.to_toml());
        on_root(self.comm, write)?;
        let mut progress = Progress::new(&self.options.directory.display().to_string(), self.comm.is_root());
        if self.stepper.state.step == 0 {
            self.sample_vibration();
            self.write_history();
        }
        self.write_snapshot_if_due()?;
        while !self.is_over() {
            let NextStep { dt, end } = self.next_step();
            let stepped = match self.stepper.step(dt, end, self.request()) {
                Ok(stepped) => stepped,
                Err(failure) => return Err(self.go_back(&failure)),
            };
            let steps = self.stepper.state.step;
            self.watch_collapse()?;
            self.follow_fall()?;
            if steps % self.scene.output.history_every == 0 {
                self.note_totals()?;
                progress.show(self.done(), || self.describe());
            }
            if self.is_late_now()
                && let Err(failure) = self.go_soft()
            {
                return Err(self.go_back(&failure));
            }
            self.write_snapshot_if_due()?;
            if stepped.signal >= CHECKPOINT {
                let saved = self.write_checkpoint();
                // The first error says more than its consequences.
                agree(self.comm, self.failed.take().map_or(Ok(()), Err)).and(saved)?;
                let start = Instant::now();
                self.report_to(stepped.signal < STOP);
                self.stepper.phases.add(Phase::Output, start);
            }
            if stepped.signal >= STOP {
                self.write_products()?;
                self.write_trace()?;
                if self.comm.is_root() {
                    tracing::warn!("stopped at step {steps}, t = {:e} s; --resume continues", self.stepper.state.time);
                }
                return Ok(self.report(Ended::Interrupted));
            }
        }
        drop(progress);
        self.finish()
    }

    /// The last step ends on the dot, and so does one before a snapshot.
    fn next_step(&self) -> NextStep {
        let (most, time) = (self.stepper.state.next, self.stepper.state.time);
        let stop = self.late_time().into_iter().chain(self.end_time()).fold(f64::INFINITY, f64::min);
        let Some(due) = self.due() else {
            let is_last = stop - time <= most;
            return if is_last {
                NextStep { dt: stop - time, end: stop }
            } else {
                NextStep { dt: most, end: time + most }
            };
        };
        let next = due.next(self.state.snapshot_time, time);
        due::lead(most, time, if next < stop && !due.same(next, stop) { next } else { stop })
    }

    /// When the run is known to end, s.
    fn end_time(&self) -> Option<f64> {
        let limit = self.scene.run.max_time.unwrap_or(f64::INFINITY);
        let end = match self.scene.run.until {
            Until::Time(end) => end.min(limit),
            Until::Settled if self.state.has_outcome() => self.state.outcome_time.min(limit),
            Until::Settled => limit,
        };
        end.is_finite().then_some(end)
    }

    pub(super) fn is_over(&self) -> bool {
        let steps = self.scene.run.steps.is_some_and(|most| self.stepper.state.step >= most);
        let deepest = self.scene.intrusion.is_some_and(|intrusion| intrusion.ends_run) && self.is_deepest();
        let parted = self.scene.restitution.is_some_and(|restitution| restitution.ends_run)
            && self.state.bounce.as_ref().is_some_and(Bounce::is_over);
        steps || deepest || parted || self.end_time().is_some_and(|end| self.stepper.state.time >= end)
    }

    /// What this rank requests after the coming step; rank 0 keeps the clock of checkpoints.
    fn request(&self) -> u32 {
        if self.failed.is_some() {
            return FAILED;
        }
        let coming = self.stepper.state.step + 1;
        let trigger = self.fault.trigger(coming);
        if trigger == Trigger::Stop || signals::received() != 0 || self.last == Some(coming) {
            return STOP;
        }
        let due = self.comm.is_root() && self.saved.elapsed().as_secs_f64() > self.scene.run.checkpoint_every;
        if due || trigger == Trigger::Checkpoint { CHECKPOINT } else { 0 }
    }

    /// Saves the state before a step that failed. A step overwrites that state, and a copy of it would cost every step memory;
    /// but steps are reproducible, so the run goes back to the newest checkpoint (or to its start), repeats the steps up to
    /// the one that failed, with all that they write, and stops there with a checkpoint. Returns the error to be reported.
    /// Collective.
    fn go_back(self, failure: &Failure) -> Error {
        let (scene, comm) = (self.scene, self.comm);
        let options = Options { resume: true, ..self.options.clone() };
        let error = failure.error(|body| &scene.bodies[body].name);
        let before = failure.step - 1;
        if comm.is_root() {
            tracing::warn!("{error}; going back, to save the state after step {before}");
        }
        drop(self);
        let stop = || -> Result<u64> {
            let mut run = Run::<D>::open(scene, &options, comm)?;
            let found = run.stepper.state.step;
            run.last = Some(before);
            Ok(if found < before { run.run_to_end()?.summary.steps } else { found })
        };
        let continuation = match stop() {
            Ok(steps) => format!("; --resume continues from the checkpoint after step {steps}"),
            Err(second) => format!("; the state before that step could not be saved: {second}"),
        };
        Error { what: error.what + &continuation, ..error }
    }

    /// Names the particle that makes the time step collapse, and ends a run that has blown up.
    fn watch_collapse(&mut self) -> Result<()> {
        let Some(ratio) = self.collapse.note(self.stepper.state.next) else { return Ok(()) };
        self.limit = self.stepper.tightest_limit();
        let drift = if has_balance(self.scene) { self.state.conservation.energy_drift() } else { 0.0 };
        let what = format!("the time step has collapsed to {ratio:.1e} of the largest: {}", self.describe());
        if collapse::is_hopeless(ratio, drift) {
            let remedy = "the motion has blown up (change: a smaller numerics.cfl, more viscosity)";
            return Err(Error::new(format!("{what}; {remedy}")).at(format!("step {}", self.stepper.state.step)));
        }
        if self.comm.is_root() {
            tracing::warn!("{what}");
        }
        Ok(())
    }

    pub(super) fn note_totals(&mut self) -> Result<()> {
        self.totals = self.stepper.totals();
        self.state.conservation.note(&self.totals, self.stepper.state.time);
        self.sample_vibration();
        self.note_filling();
        self.follow_bounce();
        self.write_history();
        let time = self.stepper.state.time;
        let Some(settled) = self.state.settled.as_mut() else { return Ok(()) };
        let before = settled.since().is_some();
        if !settled.update(time, self.totals.internal) {
            return Ok(());
        }
        if !before {
            tracing::info!("settled at t = {time:.4e} s, step {}", self.stepper.state.step);
        }
        if self.scene.reaccumulates() {
            return self.watch_reaccumulation();
        }
        match self.scene.run.until == Until::Settled && !self.state.has_outcome() {
            true if self.scene.hits_ground() => self.take_outcome(),
            true => self.watch_remnant(),
            false => Ok(()),
        }
    }

    /// The largest filling factor of dust, where there is any. Collective.
    fn note_filling(&mut self) {
        let columns = &self.stepper.columns;
        let Some(filling) = columns.registry.find::<f64>(FILLING_FACTOR) else { return };
        // Of what is no dust it is 1.
        let id = self.stepper.settings.view.core.id;
        let is_dust = |i: usize| self.scene.materials[self.scene.bodies[columns.get(id, i).body()].material].is_dust();
        let dust = (0..columns.len()).filter(|&i| is_dust(i)).map(|i| columns.get(filling, i));
        let mut most = [dust.fold(self.state.most_filling, f64::max)];
        self.comm.all_max(&mut most);
        self.state.most_filling = most[0];
    }

    fn sample_vibration(&mut self) {
        let Some(comparison) = &self.comparison else { return };
        self.state.vibration.extend(comparison.sample(&self.stepper, self.stepper.state.time, self.comm));
    }

    /// Share of the run that is done, for the bar.
    fn done(&self) -> f64 {
        let end = match (&self.state.settled, self.end_time()) {
            (_, Some(end)) => end,
            (Some(settled), None) if self.scene.reaccumulates() => settled.earliest() + free_fall_time(self.scene),
            (Some(settled), None) => Lasting::earliest(first_contact(self.scene), settled.earliest()),
            (None, None) => f64::INFINITY,
        };
        self.stepper.state.time / end
    }

    pub(super) fn describe(&self) -> String {
        let (state, steps) = (&self.state, &self.stepper.state);
        let NamedLimit { limit, reason } = &self.limit;
        let [x, y, z] = limit.position;
        let particle = match self.scene.bodies.get(limit.id.body()) {
            Some(body) if limit.is_of_particle() => {
                format!(" of {} {} at ({x:.3e}, {y:.3e}, {z:.3e}) m", body.name, limit.id.site())
            }
            _ => String::new(),
        };
        let energy = match has_balance(self.scene) {
            true => format!("energy drift {:.1e}, ", state.conservation.energy_drift()),
            false => String::new(), // cold matter does not account for it
        };
        let memory = resources::resident_bytes() / f64::from(1 << 30);
        format!(
            "t {:.3e} s, step {}, {energy}dt {:.2e} s by {reason}{particle}, {memory:.2} GiB",
            steps.time, steps.step, steps.next
        )
    }
}
