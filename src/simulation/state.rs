//! What a run knows beside its particles; all of it goes into checkpoints.

use serde::{Deserialize, Serialize};

use crate::math::Vec3;
use crate::outcome::Outcome;
use crate::outcome::crater::Crater;
use crate::outcome::reaccumulated::Reaccumulated;
use crate::outcome::settled::Settled;
use crate::step::late::Switch;
use crate::step::{Counters, Totals};

/// Largest deviations of conserved quantities so far. What walls, pistons and uniform gravity do is counted: energy stands for
/// energy less their work, momentum for momentum less theirs.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Conservation {
    /// J.
    pub initial_energy: f64,
    /// Initial kinetic energy in the centre-of-mass frame, J; where that is zero, `largest_energy` stands for it.
    pub energy_scale: f64,
    /// Largest sum of kinetic and internal energy and the size of that in the particles' own field, J.
    #[serde(default)]
    pub largest_energy: f64,
    pub initial_momentum: [f64; 3],
    pub initial_angular_momentum: [f64; 3],
    /// Largest |E - E0|, J.
    pub energy: f64,
    /// Largest |p - p0| over sum m |v|.
    pub momentum: f64,
    /// Largest |L - L0| over sum m |x| |v|; says something in open space without prescribed motion only.
    pub angular_momentum: f64,
}

impl Conservation {
    pub fn new(first: &Totals) -> Self {
        Self {
            initial_energy: first.balance(),
            energy_scale: first.kinetic_in_centre_of_mass(),
            initial_momentum: first.momentum_balance(0.0).into(),
            initial_angular_momentum: first.angular_momentum.into(),
            ..Self::default()
        }
    }

    /// Takes a change of energy out of the account, J.
    pub fn shift_energy(&mut self, jump: f64) {
        self.initial_energy += jump;
    }

    /// `time`: since the start, s.
    pub fn note(&mut self, now: &Totals, time: f64) {
        let off = |a: [f64; 3], b: &[f64; 3]| a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt();
        let share = |off: f64, scale: f64| if scale > 0.0 { off / scale } else { off };
        self.energy = self.energy.max((now.balance() - self.initial_energy).abs());
        let momentum = share(off(now.momentum_balance(time).into(), &self.initial_momentum), now.momentum_scale);
        self.momentum = self.momentum.max(momentum);
        let angular = share(off(now.angular_momentum.into(), &self.initial_angular_momentum), now.angular_scale);
        self.angular_momentum = self.angular_momentum.max(angular);
        // In a uniform field the zero of energy is arbitrary.
        let own = if now.weight == Vec3::zeros() { now.potential.unwrap_or(0.0).abs() } else { 0.0 };
        self.largest_energy = self.largest_energy.max(now.kinetic + now.internal + own);
    }

    pub fn energy_drift(&self) -> f64 {
        let scale = if self.energy_scale > 0.0 { self.energy_scale } else { self.largest_energy };
        if scale > 0.0 { self.energy / scale } else { self.energy }
    }
}

/// Time and everything that must survive a restart.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct RunState {
    /// s.
    pub time: f64,
    /// The next step, s.
    pub dt: f64,
    pub counters: Counters,
    pub conservation: Conservation,
    /// Snapshots written.
    pub snapshots: u32,
    /// The time of the last one, s.
    #[serde(default)]
    pub snapshot_time: Option<f64>,
    pub settled: Option<Settled>,
    /// The largest remnant, once the shock has left, where gravity decides about the end.
    #[serde(default)]
    pub reaccumulated: Option<Reaccumulated>,
    /// Since the late stage has begun.
    #[serde(default)]
    pub late: Option<LateStart>,
    /// (time, s; amplitude, m/s) of a vibration that is compared with its exact period; of matter at rest its speed over that of
    /// free fall.
    #[serde(default)]
    pub vibration: Vec<[f64; 2]>,
    /// Outcome where the run settled, or at its end: this one counts. None of ground.
    pub outcome: Option<Outcome>,
    /// What is left of a flat face, at the same time.
    #[serde(default)]
    pub crater: Option<Crater>,
    /// When that was, s.
    pub outcome_time: f64,
    /// Wall time, processor time and MPI waits of all ranks before the last restart, s.
    pub spent: Spent,
}

/// How the late stage began.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct LateStart {
    /// s.
    pub time: f64,
    pub step: u64,
    pub switch: Switch,
    /// Steps that are allowed before and after, s.
    pub dt: [f64; 2],
}

impl RunState {
    pub fn has_outcome(&self) -> bool {
        self.outcome.is_some() || self.crater.is_some()
    }
}

/// What a run has cost, over all ranks but for wall time.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
pub struct Spent {
    /// s.
    pub wall: f64,
    /// User and system time of all threads, that of MPI waits left out, s.
    pub cpu: f64,
    /// MPI waits, wall time, s.
    pub wait: f64,
    pub pairs: u64,
    pub updates: u64,
    pub migrated: u64,
}
