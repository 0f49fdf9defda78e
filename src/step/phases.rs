//! Wall time of each phase of a rank, for the summary.

use std::time::Instant;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    Predict,
    Watch,
    Lists,
    Migration,
    Pack,
    Gravity,
    Pairs,
    Wait,
    Reduce,
    Diagnostics,
    Outcome,
    Output,
}

/// Names in the order of the enum.
pub const NAMES: [&str; 12] = [
    "predict_and_material",
    "displacement_watch",
    "lists",
    "migration_and_ghosts",
    "pack",
    "gravity",
    "pairs_rates_and_correct",
    "exposed_wait",
    "reduce",
    "diagnostics",
    "outcome",
    "output",
];

/// Seconds per phase.
#[derive(Debug, Clone, Default)]
pub struct Phases {
    pub seconds: [f64; NAMES.len()],
}

impl Phases {
    pub fn time<T>(&mut self, phase: Phase, work: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let out = work();
        self.add(phase, start);
        out
    }

    pub fn total(&self) -> f64 {
        self.seconds.iter().sum()
    }

    pub fn add(&mut self, phase: Phase, since: Instant) {
        self.seconds[phase as usize] += since.elapsed().as_secs_f64();
    }
}
