//! A run that is resumed when its scene requests another end than before: it goes on, or reports that it has ended.

use super::run::{Ended, Run, RunReport};
use super::scales::{binding, crossing, first_contact, free_fall_time};
use crate::error::Result;
use crate::outcome::settled::Settled;
use crate::output::publish::cannot;
use crate::output::{Summary, on_root, snapshot};
use crate::scene::{Scene, Snapshots, Until};

/// The summary of a run up to an earlier end, which has been moved since.
const PREVIOUS_SUMMARY: &str = "summary_previous.json";

/// Detects when an impact has settled, where the scene requests it. `kinetic`: initial kinetic energy in the
/// centre-of-mass frame, J.
pub fn settling(scene: &Scene, kinetic: f64) -> Option<Settled> {
    let settles = scene.run.until == Until::Settled || scene.late_stage.is_some_and(|l| l.at == Until::Settled);
    scene.impact.as_ref().filter(|_| settles).map(|_| {
        let (contact, through) = (first_contact(scene), crossing(scene));
        let settled = Settled::new(contact, through, kinetic);
        if scene.gravity.own.is_some() { settled.bound_by(binding(scene), free_fall_time(scene)) } else { settled }
    })
}

impl<const D: usize> Run<'_, D> {
    /// Before the first step after a restart: the results of the run if it had ended, that is still its end and all of them are
    /// on disk. Otherwise `None`, and the run goes on. Collective.
    pub(super) fn take_up(&mut self) -> Result<Option<RunReport>> {
        if self.state.settled.is_none() {
            self.state.settled = settling(self.scene, self.state.conservation.energy_scale);
        }
        let Some(end) = self.state.end.clone() else {
            // The outcome of an impact that ends at a given time is that of its end.
            if matches!(self.scene.run.until, Until::Time(_)) {
                (self.state.outcome, self.state.crater) = (None, None);
            }
            return Ok(None);
        };
        // Found at an end that may have been moved.
        let is_of_end = end.has_outcome || matches!(self.scene.run.until, Until::Time(_));
        let found = (self.state.outcome.clone(), self.state.crater.clone());
        if is_of_end {
            (self.state.outcome, self.state.crater) = (None, None);
        }
        if !self.is_over() {
            return self.go_beyond().map(|()| None);
        }
        (self.state.outcome, self.state.crater) = found;
        let path = self.options.directory.join("summary.json");
        let steps = self.stepper.state.step;
        let matches = |summary: &Summary| (summary.steps, summary.time) == (steps, self.stepper.state.time);
        let summary = Summary::read(&path, self.comm).filter(matches);
        let Some(summary) = summary.filter(|_| self.has_its_files()) else { return Ok(None) };
        tracing::info!(
            "the run has ended before, at t = {:.4e} s, step {steps}: nothing is done; a later end (run.until, run.max_time, \
             run.steps) takes it further",
            self.stepper.state.time
        );
        Ok(Some(RunReport { ended: Ended::Finished, summary, outcome: self.state.outcome.clone() }))
    }

    /// Whether the files written after the last checkpoint exist: a disk may have been full. Collective.
    fn has_its_files(&self) -> bool {
        let scene = self.scene;
        // Written after the checkpoint, which does not count it.
        let last = snapshot::name(self.state.snapshots + 1);
        let files: [(&str, bool); 8] = [
            ("outcome.png", scene.output.picture),
            ("fragments.csv", scene.impact.is_some() && !scene.hits_ground()),
            ("nbody.csv", scene.nbody.is_some()),
            ("restitution.csv", scene.restitution.is_some()),
            ("fragment_masses.csv", scene.fragments.is_some()),
            ("deposit.csv", scene.deposit.is_some()),
            ("filling_profile.csv", scene.intrusion.is_some() && self.ends_deepest()),
            (
                &last,
                scene.output.snapshots != Snapshots::Never && self.state.snapshot_time != Some(self.stepper.state.time),
            ),
        ];
        let required: Vec<&str> = files.into_iter().filter(|(_, required)| *required).map(|(name, _)| name).collect();
        !self.lacks(&required)
    }

    /// Whether the directory lacks one of these files. Collective.
    pub(super) fn lacks(&self, names: &[&str]) -> bool {
        let lacks = |name: &&str| !self.options.directory.join(name).exists();
        let mut lacking = [(self.comm.is_root() && names.iter().any(lacks)) as i64];
        self.comm.all_sum(&mut lacking);
        lacking[0] > 0
    }

    /// Continues a run whose end has been moved to a later time. Collective.
    fn go_beyond(&mut self) -> Result<()> {
        let (from, to) = ("summary.json", PREVIOUS_SUMMARY);
        let path = self.options.directory.join(from);
        let keep = || match path.exists() {
            true => std::fs::rename(&path, path.with_file_name(to)).map_err(|e| cannot("rename", &path, e)),
            false => Ok(()),
        };
        on_root(self.comm, keep)?;
        self.state.end = None;
        tracing::info!(
            "the run had ended at t = {:.4e} s and goes on; what it found is now in {to}",
            self.stepper.state.time
        );
        Ok(())
    }
}
