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
    /// When each phase began and how long it took, where somebody asks for it.
    pub trace: Option<Trace>,
}

/// What a rank has done and when.
#[derive(Debug, Clone)]
pub struct Trace {
    /// Where its clock begins.
    zero: Instant,
    pub spans: Vec<Span>,
}

/// A phase of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// Its number among [`NAMES`].
    pub phase: usize,
    /// s.
    pub begin: f64,
    pub length: f64,
}

impl Trace {
    /// Spans at most: of some ten thousand steps.
    const MOST: usize = 120_000;

    /// A trace whose clock begins now.
    pub fn begin() -> Self {
        Self { zero: Instant::now(), spans: Vec::new() }
    }

    /// Whether nothing more is noted.
    pub fn is_full(&self) -> bool {
        self.spans.len() >= Self::MOST
    }
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
        let length = since.elapsed().as_secs_f64();
        self.seconds[phase as usize] += length;
        if let Some(trace) = self.trace.as_mut().filter(|trace| !trace.is_full()) {
            let begin = since.saturating_duration_since(trace.zero).as_secs_f64();
            trace.spans.push(Span { phase: phase as usize, begin, length });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spans_are_noted_where_they_are_asked_for() {
        let mut phases = Phases::default();
        phases.time(Phase::Pairs, || std::thread::sleep(std::time::Duration::from_millis(2)));
        assert!(phases.trace.is_none() && phases.seconds[Phase::Pairs as usize] >= 2e-3);
        phases.trace = Some(Trace::begin());
        phases.time(Phase::Wait, || ());
        phases.time(Phase::Pairs, || ());
        let spans = phases.trace.expect("a trace").spans;
        assert_eq!(
            spans.iter().map(|span| span.phase).collect::<Vec<_>>(),
            [Phase::Wait as usize, Phase::Pairs as usize]
        );
        assert!(spans[0].begin >= 0.0 && spans[1].begin >= spans[0].begin + spans[0].length);
    }
}
