//! Buffers of a thread for a chunk, and its findings.

use std::cell::Cell;
use std::time::{Duration, Instant};

use super::contact::Touch;
use super::failure::{NonFinite, Watched};
use super::integrator::StepError;
use super::time_step::Limit;
use crate::material::{LocalFlow, MaterialEffect};
use crate::math::Mat3;
use crate::motion::rigid::LoadSums;
use crate::pair::RowSums;
use crate::particles::chunk::CHUNK;
use crate::particles::{Rates, Registry};

pub struct Workspace {
    pub sums: Vec<RowSums>,
    /// Flow around each particle, from the sums of its row.
    pub flow: Vec<LocalFlow>,
    pub bodies: Vec<u16>,
    pub rates: Rates,
    pub watched: Watched,
    /// Forces on each rigid body since they were taken last.
    pub loads: Vec<LoadSums>,
    /// What touches a particle, while it is at work.
    pub touches: Vec<Touch>,
    /// Findings since the last [`Workspace::take`].
    pub found: Findings,
    /// Time spent in each effect so far.
    effects: Vec<Cell<Duration>>,
}

/// Findings over the chunks of a pass.
#[derive(Debug, Clone, PartialEq)]
pub struct Findings {
    /// Tightest limit of the next step.
    pub limit: Limit,
    /// First particle with a non-finite number, by id.
    pub non_finite: Option<NonFinite>,
    /// Directed pairs inside the support.
    pub pairs: u64,
    pub velocities: VelocityRange,
    pub error: StepError,
}

impl Findings {
    pub fn nothing() -> Self {
        Self {
            limit: Limit::NONE,
            non_finite: None,
            pairs: 0,
            velocities: VelocityRange::NOTHING,
            error: StepError::default(),
        }
    }

    pub fn merge(&mut self, other: Self) {
        self.limit = self.limit.tighter(other.limit);
        self.non_finite = NonFinite::first(self.non_finite.take(), other.non_finite);
        self.pairs += other.pairs;
        self.velocities.merge(&other.velocities);
        self.error.merge(&other.error);
    }
}

impl Workspace {
    pub fn new(registry: &Registry, effects: usize, rigid: usize) -> Self {
        let flow = LocalFlow { velocity_gradient: Mat3::zeros(), heating: 0.0 };
        Self {
            sums: vec![RowSums::default(); CHUNK],
            flow: vec![flow; CHUNK],
            bodies: vec![0; CHUNK],
            rates: Rates::new(registry),
            watched: Watched::new(registry),
            loads: vec![LoadSums::default(); rigid],
            touches: Vec::with_capacity(rigid),
            found: Findings::nothing(),
            effects: vec![Cell::default(); effects],
        }
    }

    /// Findings since the last call.
    pub fn take(&mut self) -> Findings {
        std::mem::replace(&mut self.found, Findings::nothing())
    }

    /// Calls every effect in order and records its time.
    pub fn each_effect(&self, effects: &[Box<dyn MaterialEffect>], mut act: impl FnMut(&dyn MaterialEffect)) {
        let mut start = Instant::now();
        for (effect, time) in effects.iter().zip(&self.effects) {
            act(effect.as_ref());
            let end = Instant::now();
            time.set(time.get() + (end - start));
            start = end;
        }
    }

    /// Seconds that this thread has spent in each effect so far.
    pub fn effect_seconds(&self) -> impl Iterator<Item = f64> {
        self.effects.iter().map(|time| time.get().as_secs_f64())
    }
}

/// Extremes of the velocities of many particles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VelocityRange {
    /// m/s
    pub forward: [f64; 3],
    /// Largest components of the opposite velocities, m/s.
    pub backward: [f64; 3],
    /// Smallest smoothing length, m.
    pub smallest: f64,
}

impl VelocityRange {
    pub const NOTHING: Self =
        Self { forward: [f64::NEG_INFINITY; 3], backward: [f64::NEG_INFINITY; 3], smallest: f64::INFINITY };

    pub fn merge(&mut self, other: &Self) {
        for k in 0..3 {
            self.forward[k] = self.forward[k].max(other.forward[k]);
            self.backward[k] = self.backward[k].max(other.backward[k]);
        }
        self.smallest = self.smallest.min(other.smallest);
    }
}
