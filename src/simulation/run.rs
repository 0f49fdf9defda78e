//! A run: its options, its state while it goes on, and its results.

use std::path::{Path, PathBuf};
use std::time::Instant;

use super::collapse::Collapse;
use super::state::RunState;
use crate::comparison::Comparison;
use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::outcome::Outcome;
use crate::outcome::crater::CraterEvaluation;
use crate::outcome::deposit::Deposit;
use crate::outcome::intrusion::IntrusionEvaluation;
use crate::outcome::populations::Populations;
use crate::output::publish::replace;
use crate::output::summary::Accuracy;
use crate::output::{History, Summary};
use crate::process::faults::Fault;
use crate::scene::Scene;
use crate::step::packing::DensityCheck;
use crate::step::time_step::NamedLimit;
use crate::step::{Stepper, Totals};

/// Options of a run beside its scene.
#[derive(Debug, Clone)]
pub struct Options {
    pub directory: PathBuf,
    /// Resume from the newest whole checkpoint, where there is one.
    pub resume: bool,
    /// Resident bytes of the process before anything was made.
    pub resident_at_start: f64,
    /// The choice by which the scene got its settings, for the summary; and its description in the log.
    pub accuracy: Option<Accuracy>,
    /// Whether to note what each rank does when.
    pub trace: bool,
}

/// How a run ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Ended {
    Finished,
    /// By a signal; the checkpoint is whole.
    Interrupted,
}

/// The results of a run.
#[derive(Debug, Clone)]
pub struct RunReport {
    pub ended: Ended,
    pub summary: Summary,
    /// Where the run settled, or at its end.
    pub outcome: Option<Outcome>,
}

pub(super) struct Run<'a, const D: usize> {
    pub(super) scene: &'a Scene,
    pub(super) options: &'a Options,
    pub(super) comm: &'a Comm,
    pub(super) stepper: Stepper<'a, D>,
    pub(super) state: RunState,
    pub(super) history: History,
    pub(super) totals: Totals,
    pub(super) started: Instant,
    pub(super) cpu_at_start: f64,
    pub(super) wait_at_start: f64,
    pub(super) wait_cpu_at_start: f64,
    pub(super) saved: Instant,
    pub(super) fault: Fault,
    pub(super) comparison: Option<Comparison>,
    /// Whether density is mass over volume, at the last check.
    pub(super) density: DensityCheck,
    /// An error of this rank alone.
    pub(super) failed: Option<Error>,
    /// The largest remnant, once it has been found.
    pub(super) members: Option<Members>,
    /// Files of an outcome to be written.
    pub(super) products: Products,
    /// The step at which the run is to stop before its end.
    pub(super) last: Option<u64>,
    pub(super) collapse: Collapse,
    /// The tightest limit of the time step, and its name.
    pub(super) limit: NamedLimit,
}

/// Which of this rank's particles belonged to the largest remnant after a step.
pub(super) struct Members {
    pub step: u64,
    pub in_largest: Vec<bool>,
}

/// Files of an outcome that are still to be written.
#[derive(Default)]
pub(super) struct Products {
    /// Names and contents of files; contents are rank 0's.
    pub tables: Vec<(&'static str, Vec<u8>)>,
    /// Crater to be drawn.
    pub crater: Option<CraterEvaluation>,
    /// Fall into dust to be drawn.
    pub intrusion: Option<IntrusionEvaluation>,
    /// Pieces to be drawn.
    pub populations: Option<Populations>,
    /// Heap to be drawn.
    pub deposit: Option<Deposit>,
    /// Whether the bounce is to be drawn.
    pub bounce: bool,
    /// Whether the cut is to be drawn.
    pub cut: bool,
}

impl Products {
    /// Writes all tables that can be written; returns the first error. For one rank.
    pub fn write_tables(&self, directory: &Path) -> Result<()> {
        let write = |(name, bytes): &(&str, Vec<u8>)| replace(&directory.join(name), bytes);
        self.tables.iter().map(write).fold(Ok(()), Result::and)
    }
}
