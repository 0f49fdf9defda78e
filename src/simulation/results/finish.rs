//! The end of a run. The most important files are written first: the checkpoint, then summary.json. The last snapshot, tables and
//! pictures follow, even where one of them fails; a picture that fails is a warning, a table an error.

use std::path::Path;

use super::report::{self, Answers, Report};
use super::summary;
use super::warnings;
use super::{deposit, fragments, ground};
use crate::comparison::Noted;
use crate::error::{Error, Result};
use crate::outcome::distributions::distributions;
use crate::outcome::lasting::Lasting;
use crate::outcome::origin;
use crate::output::figures::or_warn;
use crate::output::summary::{Figures, Fragments};
use crate::output::{Summary, agree, snapshot};
use crate::scene::Snapshots;
use crate::simulation::run::{Ended, Run, RunReport};
use crate::simulation::state::End;

impl<const D: usize> Run<'_, D> {
    /// Evaluates the outcome that counts, and writes its files, unless they must wait as the run is over. Collective.
    pub(in crate::simulation) fn take_outcome(&mut self) -> Result<()> {
        self.state.outcome_time = self.stepper.state.time;
        if !self.scene.hits_ground() {
            let mut evaluation = self.evaluate_outcome();
            let whole = self.scene.bodies.iter().enumerate().filter(|(n, body)| body.whole(*n) == *n);
            let masses: Vec<f64> = whole.map(|(_, body)| body.whole_mass()).collect();
            evaluation.outcome.bodies =
                origin::by_body(self.comm, &self.particles(), &evaluation, &self.question(), &masses);
            evaluation.outcome.trend = self.state.lasting.as_ref().and_then(Lasting::trend);
            self.find_remnant(&mut evaluation);
            let tables = distributions(self.comm, &evaluation, D);
            let named = [
                ("fragments.csv", tables.fragments),
                ("sizes.csv", tables.sizes),
                ("velocities.csv", tables.velocities),
            ];
            self.products.tables.extend(named.map(|(name, text)| (name, text.into_bytes())));
            self.state.outcome = Some(evaluation.outcome);
        }
        if let Some(evaluation) = self.crater() {
            self.products.tables.extend(ground::tables(&evaluation));
            self.state.crater = Some(evaluation.crater.clone());
            self.products.crater = Some(evaluation);
        }
        self.products.cut = true;
        if self.is_over() { Ok(()) } else { self.write_products() }
    }

    /// Writes the tables and draws the pictures that wait. Collective.
    pub(in crate::simulation) fn write_products(&mut self) -> Result<()> {
        let (products, directory) = (std::mem::take(&mut self.products), &self.options.directory);
        let root = self.comm.is_root();
        let written = agree(self.comm, if root { products.write_tables(directory) } else { Ok(()) });
        if self.scene.output.picture {
            if let Some(evaluation) = products.crater.filter(|_| root) {
                or_warn(self.draw_crater(&evaluation));
            }
            if root && products.bounce {
                or_warn(self.draw_bounce());
            }
            if let Some(populations) = products.populations.filter(|_| root) {
                or_warn(self.draw_populations(&populations));
            }
            if let Some(deposit) = products.deposit.filter(|_| root) {
                or_warn(self.draw_deposit(&deposit));
            }
            if let Some(evaluation) = products.intrusion {
                let drawn = self.draw_deepest();
                if root {
                    or_warn(drawn.and(self.draw_intrusion(&evaluation)));
                }
            }
            let drawn = if products.cut { self.draw_cut() } else { Ok(()) };
            if root {
                or_warn(drawn);
            }
        }
        written
    }

    /// outcome.png. Collective.
    fn draw_cut(&self) -> Result<()> {
        let source = report::PictureSource {
            scene: self.scene,
            stepper: &self.stepper,
            time: self.stepper.state.time,
            path: &self.options.directory.join("outcome.png"),
        };
        report::draw_cut(&source, self.comm)
    }

    /// Errors against the solution that the scene names; their figures go into the directory that is given. Collective.
    fn errors(&self, directory: Option<&Path>) -> Result<Figures> {
        let Some(comparison) = &self.comparison else { return Ok(Figures::default()) };
        let noted = Noted {
            time: self.stepper.state.time,
            angular_momentum: self.state.conservation.angular_momentum,
            samples: &self.state.vibration,
        };
        comparison.finish(&self.stepper, &noted, directory, self.comm)
    }

    /// Evaluates and writes all results. Where a run is resumed at its very end, the same files are written again.
    /// Collective.
    pub(in crate::simulation) fn finish(mut self) -> Result<RunReport> {
        // A run may be resumed from its last checkpoint for files that could not be written.
        let again = self.state.end.clone();
        if again.is_none() && self.stepper.state.step % self.scene.output.history_every != 0 {
            self.note_totals()?;
        }
        self.check_density();
        let settled_now = self.state.outcome_time == self.stepper.state.time;
        let at_end = again.as_ref().map_or(!self.state.has_outcome(), |end| end.has_outcome);
        match self.scene.impact.is_some() {
            true if at_end || (settled_now && self.products.tables.is_empty()) => self.take_outcome()?,
            true => {}
            false => self.products.cut = true,
        }
        if self.scene.intrusion.is_some() && (!self.is_deepest() || (again.is_some() && self.ends_deepest())) {
            self.take_intrusion();
        }
        let (fragments, deposit) = (self.take_fragments(), self.take_deposit());
        let (errors, nbody) = (self.errors(None), self.nbody());
        let again = again.is_some();
        let saved = if again {
            Ok(())
        } else {
            self.state.end = Some(End { has_outcome: at_end });
            self.write_checkpoint()
        };
        let snapshot = self.scene.output.snapshots != Snapshots::Never
            && self.state.snapshot_time != Some(self.stepper.state.time);
        // After a failed checkpoint there is no room for a snapshot, nor can HDF5 be relied on.
        let there = again && !self.lacks(&[&snapshot::name(self.state.snapshots + 1)]);
        let snapshot = snapshot && saved.is_ok() && !there;
        let summary = self.summary(errors.clone().unwrap_or_default(), Answers { nbody, fragments, deposit });
        let path = self.options.directory.join("summary.json");
        let reported = saved.and(errors.and_then(|_| summary.write(&path, self.comm)));
        let failed = agree(self.comm, self.failed.take().map_or(Ok(()), Err));
        let safe = reported.is_ok();
        let shown = if snapshot { self.write_snapshot() } else { Ok(()) };
        let written = self.write_products().and(self.write_trace());
        if self.scene.output.picture && self.comparison.is_some() {
            let drawn = self.errors(Some(&self.options.directory)).map(|_| ());
            if self.comm.is_root() {
                or_warn(drawn);
            }
        }
        self.report_to(false);
        let printed = warnings::of_scene(self.scene).len();
        let crater = self.state.crater.as_ref();
        summary::print(&summary, crater, printed, &self.options.directory, self.comm.is_root());
        reported.and(failed).and(shown).and(written).map_err(|error| match safe {
            true => Error { what: error.what + "; the last checkpoint and summary.json are written", ..error },
            false => error,
        })?;
        Ok(self.report_of(Ended::Finished, summary))
    }

    /// Tables of what is asked about bounces and pieces, and figures of the latter. Collective.
    fn take_fragments(&mut self) -> Option<Fragments> {
        let table = self.state.bounce.as_ref().map(|bounce| ("restitution.csv", bounce.table().into_bytes()));
        self.products.bounce = table.is_some();
        self.products.tables.extend(table);
        let populations = self.populations()?;
        self.products.tables.push(("fragment_masses.csv", populations.table().into_bytes()));
        let figures = fragments::figures(&populations, self.scene);
        self.products.populations = Some(populations);
        Some(figures)
    }

    /// Table and figures of the heap that is asked about. Collective.
    fn take_deposit(&mut self) -> Option<Figures> {
        let (deposit, settings) = (self.deposit()?, self.scene.deposit?);
        self.products.tables.push(("deposit.csv", deposit.table().into_bytes()));
        let figures = deposit::figures(&deposit, &settings);
        self.products.deposit = Some(deposit);
        Some(figures)
    }

    /// report.html, where pictures are asked for; `goes_on`: whether the run is not over. For rank 0, while the others go on.
    pub(in crate::simulation) fn report_to(&self, goes_on: bool) {
        if self.scene.output.picture && self.comm.is_root() {
            or_warn(crate::report::write(&self.options.directory, goes_on).map(|_| ()));
        }
    }

    /// The results of a run that ends here. Collective.
    pub(in crate::simulation) fn report(self, ended: Ended) -> RunReport {
        let summary = self.summary(Figures::default(), Answers::default());
        self.report_of(ended, summary)
    }

    fn report_of(self, ended: Ended, summary: Summary) -> RunReport {
        RunReport { ended, summary, outcome: self.state.outcome }
    }

    fn summary(&self, errors: Figures, answers: Answers) -> Summary {
        summary::summarise(&Report {
            scene: self.scene,
            stepper: &self.stepper,
            state: &self.state,
            totals: &self.totals,
            density: &self.density,
            spent: self.spent(),
            errors,
            answers,
            resident_at_start: self.options.resident_at_start,
            accuracy: self.options.accuracy.as_ref(),
            comm: self.comm,
        })
    }
}
