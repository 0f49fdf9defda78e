//! A run: what it was asked for, what it holds while it goes on, and what it gives back.

use std::path::{Path, PathBuf};
use std::time::Instant;

use super::collapse::Collapse;
use super::state::RunState;
use crate::comparison::Comparison;
use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::outcome::Outcome;
use crate::outcome::crater::CraterEvaluation;
use crate::output::publish::replace;
use crate::output::summary::Accuracy;
use crate::output::{History, Summary};
use crate::process::faults::Fault;
use crate::scene::Scene;
use crate::step::packing::Packing;
use crate::step::time_step::NamedLimit;
use crate::step::{Stepper, Totals};

/// How a run is to be done; the scene says what.
#[derive(Debug, Clone)]
pub struct Options {
    pub directory: PathBuf,
    /// Go on from the newest whole checkpoint, where there is one.
    pub resume: bool,
    /// Resident bytes of the process before anything was made.
    pub resident_at_start: f64,
    /// The choice by which the scene got its settings, for the summary; and how the log says it.
    pub accuracy: Option<Accuracy>,
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
    /// Whether density is mass over volume, at the last look.
    pub(super) packing: Vec<Packing>,
    /// What failed on this rank alone.
    pub(super) failed: Option<Error>,
    /// What is to be written of an outcome.
    pub(super) products: Products,
    /// The step at which the run is to stop before its end.
    pub(super) last: Option<u64>,
    pub(super) collapse: Collapse,
    /// What limits the time step.
    pub(super) limit: NamedLimit,
}

/// What is still to be written of an outcome.
#[derive(Default)]
pub(super) struct Products {
    /// Names and contents of files; contents are rank 0's.
    pub tables: Vec<(&'static str, Vec<u8>)>,
    /// To be drawn.
    pub crater: Option<CraterEvaluation>,
    /// Whether the cut is to be drawn.
    pub cut: bool,
}

impl Products {
    /// All files that can be written; the first error. For one rank.
    pub fn write_tables(&self, directory: &Path) -> Result<()> {
        let write = |(name, bytes): &(&str, Vec<u8>)| replace(&directory.join(name), bytes);
        self.tables.iter().map(write).fold(Ok(()), Result::and)
    }
}
