//! The state of a run beside its particles; all of it is in checkpoints.

use serde::{Deserialize, Serialize};

use crate::math::Vec3;
use crate::outcome::Outcome;
use crate::outcome::crater::Crater;
use crate::outcome::filling::Marks;
use crate::outcome::intrusion::Fall;
use crate::outcome::lasting::Lasting;
use crate::outcome::reaccumulated::Reaccumulated;
use crate::outcome::restitution::Bounce;
use crate::outcome::settled::Settled;
use crate::step::late::Switch;
use crate::step::{Counters, StepState, Totals};

/// Kinetic energy below this share of the scale of energy counts as zero.
const SPENT: f64 = 1e-3;

/// Largest deviations of conserved quantities so far. Walls, pistons and uniform gravity are accounted for: energy is
/// energy less their work, momentum is momentum less theirs.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Conservation {
    /// J.
    pub initial_energy: f64,
    /// Initial kinetic energy in the centre-of-mass frame, J; where that is zero, `largest_energy` is used instead.
    pub energy_scale: f64,
    /// Largest sum of kinetic and internal energy and the size of that in the particles' own field, J.
    #[serde(default)]
    pub largest_energy: f64,
    pub initial_momentum: [f64; 3],
    pub initial_angular_momentum: [f64; 3],
    /// Largest |E - E0|, J.
    pub energy: f64,
    /// Largest E - E0, J.
    #[serde(default)]
    pub gain: f64,
    /// Largest |p - p0| over sum m |v|.
    pub momentum: f64,
    /// Largest |L - L0| over sum m |x| |v|; meaningful in open space without prescribed motion only.
    pub angular_momentum: f64,
    /// Largest |L - L0|, kg m^2/s.
    #[serde(default)]
    pub turn: f64,
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

    /// Excludes a change of energy from the drift, J.
    pub fn shift_energy(&mut self, jump: f64) {
        self.initial_energy += jump;
    }

    /// `time`: since the start, s.
    pub fn note(&mut self, now: &Totals, time: f64) {
        let off = |a: [f64; 3], b: &[f64; 3]| a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt();
        let share = |off: f64, scale: f64| if scale > 0.0 { off / scale } else { off };
        self.energy = self.energy.max((now.balance() - self.initial_energy).abs());
        self.gain = self.gain.max(now.balance() - self.initial_energy);
        let momentum = share(off(now.momentum_balance(time).into(), &self.initial_momentum), now.momentum_scale);
        self.momentum = self.momentum.max(momentum);
        let turn = off(now.angular_momentum.into(), &self.initial_angular_momentum);
        self.turn = self.turn.max(turn);
        self.angular_momentum = self.angular_momentum.max(share(turn, now.angular_scale));
        // In a uniform field the zero of energy is arbitrary.
        let own = if now.weight == Vec3::zeros() { now.potential.unwrap_or(0.0).abs() } else { 0.0 };
        self.largest_energy = self.largest_energy.max(now.kinetic + now.internal + own);
    }

    /// The scale of drifts of energy, J.
    pub fn energy_scale(&self) -> f64 {
        if self.energy_scale > 0.0 { self.energy_scale } else { self.largest_energy }
    }

    pub fn energy_drift(&self) -> f64 {
        let scale = self.energy_scale();
        if scale > 0.0 { self.energy / scale } else { self.energy }
    }

    /// Largest change of energy over the remaining kinetic energy in the centre-of-mass frame, `left`, J; NaN where that is almost
    /// zero, as in matter that has come to rest.
    pub fn energy_drift_over_left(&self, left: f64) -> f64 {
        if left > SPENT * self.energy_scale() { self.energy / left } else { f64::NAN }
    }
}

/// Results of a run so far, which a checkpoint holds beside the state of its steps.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct RunState {
    pub conservation: Conservation,
    /// Snapshots written.
    pub snapshots: u32,
    /// The time of the last one, s.
    #[serde(default)]
    pub snapshot_time: Option<f64>,
    pub settled: Option<Settled>,
    /// The largest remnant, once the shock has left, where the run ends when it lasts.
    #[serde(default)]
    pub lasting: Option<Lasting>,
    /// The same where the run ends with reaccumulation.
    #[serde(default)]
    pub reaccumulated: Option<Reaccumulated>,
    /// The switch to the late stage, once it has begun.
    #[serde(default)]
    pub late: Option<LateStart>,
    /// (time, s; amplitude, m/s) of a vibration that is compared with its exact period; for matter at rest its speed over that of
    /// free fall.
    #[serde(default)]
    pub vibration: Vec<[f64; 2]>,
    /// Largest filling factor of dust at any line of the history; zero without dust.
    #[serde(default)]
    pub most_filling: f64,
    /// A body that falls into dust, where the scene asks for it.
    #[serde(default)]
    pub intrusion: Option<Intrusion>,
    /// A body that hits another, where the scene asks for it.
    #[serde(default)]
    pub bounce: Option<Bounce>,
    /// Angular momentum of an impact's target about its centre of mass at the start, kg m^2/s.
    #[serde(default)]
    pub target_turn: Option<[f64; 3]>,
    /// Outcome where the run settled, or at its end: this one counts. `None` for ground.
    pub outcome: Option<Outcome>,
    /// The crater in a flat face, at the same time.
    #[serde(default)]
    pub crater: Option<Crater>,
    /// Time of the outcome, s.
    pub outcome_time: f64,
    /// Where the run has ended; with a later end it is continued from there.
    #[serde(default)]
    pub end: Option<End>,
    /// Wall time, processor time and MPI waits of all ranks before the last restart, s.
    pub spent: Spent,
}

/// The contents of a checkpoint beside the columns, for writing.
#[derive(Serialize)]
pub struct Saved<'a> {
    pub step: &'a StepState,
    pub counters: &'a Counters,
    pub run: &'a RunState,
}

/// The contents of a checkpoint beside the columns, for reading.
#[derive(Deserialize)]
pub struct Restored {
    pub step: StepState,
    pub counters: Counters,
    pub run: RunState,
}

/// The end of a run.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct End {
    /// Whether the outcome is that of the end, not that of the time at which the impact had settled.
    pub has_outcome: bool,
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

/// A body that falls into dust.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Intrusion {
    pub fall: Fall,
    /// What it had left of the dust when that was looked at last.
    pub left: Option<Left>,
}

/// What a fall has left of the dust.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Left {
    /// When, s.
    pub time: f64,
    pub marks: Marks,
    /// m^3 (m^2 in 2D).
    pub compacted_volume: f64,
    /// The filling factor that a volume as large as the body's exceeds.
    pub of_one_body: Option<f64>,
}

impl RunState {
    pub fn has_outcome(&self) -> bool {
        self.outcome.is_some() || self.crater.is_some()
    }
}

/// The cost of a run, over all ranks but for wall time.
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

#[cfg(test)]
mod tests {
    use super::*;

    fn start() -> Totals {
        Totals {
            mass: 2.0,
            kinetic: 10.0,
            internal: 3.0,
            momentum: Vec3::new(4.0, 0.0, 0.0),
            angular_momentum: Vec3::new(0.0, 0.0, 5.0),
            momentum_scale: 8.0,
            angular_scale: 20.0,
            ..Totals::default()
        }
    }

    /// The largest deviations count, also after a return to an earlier state.
    #[test]
    fn drifts_are_the_largest_deviations() {
        let mut kept = Conservation::new(&start());
        kept.note(&start(), 1.0);
        assert_eq!((kept.energy_drift(), kept.momentum, kept.angular_momentum), (0.0, 0.0, 0.0));
        let off = Totals {
            internal: 3.3,
            momentum: Vec3::new(4.0, 0.4, -0.3),
            angular_momentum: Vec3::new(0.0, 2.0, 5.0),
            ..start()
        };
        kept.note(&off, 2.0);
        kept.note(&Totals { internal: 2.9, ..start() }, 3.0);
        // 10 J less those of the centre of mass, 4^2 / (2 x 2).
        assert!((kept.energy_drift() - 0.3 / 6.0).abs() < 1e-12, "{}", kept.energy_drift());
        assert!((kept.momentum - 0.5 / 8.0).abs() < 1e-15 && (kept.angular_momentum - 2.0 / 20.0).abs() < 1e-15);
        // Lost energy counts like gained energy.
        kept.note(&Totals { kinetic: 9.0, ..start() }, 4.0);
        assert!((kept.energy_drift() - 1.0 / 6.0).abs() < 1e-12);
    }

    #[test]
    fn what_walls_and_gravity_do_is_no_drift() {
        let mut kept = Conservation::new(&start());
        let pushed = Totals {
            kinetic: 17.0,
            work: 7.0,
            momentum: Vec3::new(4.0, 1.0, -6.0),
            impulse: Vec3::new(0.0, 1.0, 0.0),
            weight: Vec3::new(0.0, 0.0, -2.0),
            ..start()
        };
        kept.note(&pushed, 3.0);
        assert_eq!((kept.energy_drift(), kept.momentum), (0.0, 0.0));
    }

    /// Where matter starts at rest the scale is the largest energy.
    #[test]
    fn matter_at_rest_has_a_scale_too() {
        let rest = Totals { kinetic: 0.0, momentum: Vec3::zeros(), internal: 0.0, ..start() };
        let mut kept = Conservation::new(&rest);
        kept.note(&Totals { kinetic: 4.0, internal: -3.0, ..rest.clone() }, 1.0);
        kept.note(&Totals { kinetic: 1.0, internal: 1.0, potential: Some(-2.0), ..rest }, 2.0);
        assert_eq!((kept.energy, kept.energy_drift()), (1.0, 0.25));
    }
}
