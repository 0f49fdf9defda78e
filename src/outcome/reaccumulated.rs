//! When gravitational reaccumulation is over: the largest remnant (see `bound`) has kept its mass and its inner motion over
//! a free-fall time t_ff = sqrt(3 pi / (32 G rho)) of the target,
//!
//! ```text
//! max M - min M <= max(0.01 M, 0.001 M_all)        max K - min K <= 0.01 G M^2 / R        over the last t_ff
//! K = sum m |v - V|^2 / 2 over its pieces          R = (3 V / (4 pi))^(1/3), V its volume before the impact
//! ```
//! M, V mass (kg) and velocity of the remnant, m and v of a piece of it. The rotation of a fragment is not in K; a steady rotation
//! of the whole is, and does not change. Matter that falls back in a wide orbit later than t_ff is part of M already, as it is
//! bound.

use std::collections::VecDeque;

use serde::{Deserialize, Serialize};

use super::evaluation::Evaluation;
use super::tally::all_values;
use crate::domain::comm::Comm;
use crate::gravity::G;
use crate::math::{ExactSum, Vec3};

/// Shares of M, of the mass of everything, and of G M^2 / R, within which a remnant stays the same.
const OF_REMNANT: f64 = 0.01;
const OF_ALL: f64 = 1e-3;
const OF_BINDING: f64 = 0.01;
/// Evaluations per free-fall time.
const EVALUATIONS: usize = 16;

/// The largest remnant at a moment.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Remnant {
    /// kg.
    pub mass: f64,
    /// K, J.
    pub kinetic: f64,
    /// G M^2 / R, J.
    pub binding: f64,
}

impl Remnant {
    /// Collective.
    pub fn of(evaluation: &Evaluation, comm: &Comm) -> Self {
        let mut sums = [const { ExactSum::new() }; 6];
        for piece in evaluation.pieces.iter().zip(&evaluation.in_largest).filter(|(_, member)| **member).map(|(p, _)| p)
        {
            // Near the centre of mass of everything little precision is lost when the remnant's own motion is subtracted.
            let v = piece.velocity - evaluation.centre.velocity;
            let p = piece.mass * v;
            let values = [piece.mass, 0.5 * piece.mass * v.norm_squared(), p.x, p.y, p.z, piece.volume];
            sums.iter_mut().zip(values).for_each(|(sum, value)| sum.add(value));
        }
        let [mass, kinetic, x, y, z, volume] = all_values(comm, &mut sums);
        if mass <= 0.0 {
            return Self { mass: 0.0, kinetic: 0.0, binding: 0.0 };
        }
        let own = 0.5 * Vec3::new(x, y, z).norm_squared() / mass;
        let radius = libm::cbrt(volume * (0.75 / std::f64::consts::PI));
        Self { mass, kinetic: (kinetic - own).max(0.0), binding: G * mass * mass / radius }
    }
}

/// Evaluations of the largest remnant from time to time; part of a checkpoint.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Reaccumulated {
    /// t_ff, s.
    window: f64,
    /// Mass of everything, kg.
    total: f64,
    /// (time, s; remnant), oldest first; the oldest at or before the start of the last window, once there is one.
    #[serde(alias = "looks")]
    evaluations: VecDeque<(f64, Remnant)>,
}

impl Reaccumulated {
    pub fn new(window: f64, total: f64) -> Self {
        Self { window, total, evaluations: VecDeque::with_capacity(EVALUATIONS + 2) }
    }

    /// Whether the next evaluation is due at `time`, s.
    pub fn is_due(&self, time: f64) -> bool {
        self.evaluations.back().is_none_or(|(last, _)| time - last >= self.window / EVALUATIONS as f64)
    }

    /// Records an evaluation; true where the remnant has stayed the same for a whole window.
    pub fn note(&mut self, time: f64, now: Remnant) -> bool {
        self.evaluations.push_back((time, now));
        while self.evaluations.len() > 1 && self.evaluations[1].0 <= time - self.window {
            self.evaluations.pop_front();
        }
        let spread = |of: fn(&Remnant) -> f64| {
            let ends = self.evaluations.iter().map(|(_, remnant)| of(remnant));
            let (low, high) = ends.fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), x| (low.min(x), high.max(x)));
            high - low
        };
        self.evaluations[0].0 <= time - self.window
            && spread(|remnant| remnant.mass) <= (OF_REMNANT * now.mass).max(OF_ALL * self.total)
            && spread(|remnant| remnant.kinetic) <= OF_BINDING * now.binding
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// First time at which a remnant counts as reaccumulated, in a run with step `dt`.
    fn ends(remnant: impl Fn(f64) -> (f64, f64), dt: f64) -> Option<f64> {
        let mut evaluations = Reaccumulated::new(100.0, 1000.0);
        (0..4000).map(|step| 50.0 + step as f64 * dt).find(|&t| {
            let (mass, kinetic) = remnant(t);
            evaluations.is_due(t) && evaluations.note(t, Remnant { mass, kinetic, binding: 10.0 })
        })
    }

    #[test]
    fn what_stays_ends_after_a_window() {
        assert_eq!(ends(|_| (500.0, 3.0), 1.0), Some(150.0 + 5.0)); // evaluations come every 7 s: 50, 57 ... 155
    }

    #[test]
    fn what_grows_or_settles_is_waited_for() {
        // Grows by 1 % of itself, 5 kg, per window from t = 500 on: 20 (t - 450) before.
        let t = ends(|t| (500.0 - 5.0 * f64::exp((500.0 - t) / 100.0), 0.0), 1.0).unwrap();
        // exp(-(t - 600) / 100) - exp(-(t - 500) / 100) <= 1: t >= 500 + 100 ln(e - 1)
        let exact = 500.0 + 100.0 * f64::ln(f64::exp(1.0) - 1.0);
        assert!((t - exact).abs() < 2.0 * 7.0 + 1.0, "{t} {exact}");
        let t = ends(|t| (500.0, 2.0 * f64::exp(-t / 200.0)), 1.0).unwrap();
        // 2 e^(-t / 200) (e^(1/2) - 1) <= 0.1
        let exact = 200.0 * f64::ln(20.0 * (f64::exp(0.5) - 1.0));
        assert!((t - exact).abs() < 2.0 * 7.0 + 1.0, "{t} {exact}");
    }

    #[test]
    fn a_swing_is_no_end_and_dust_is() {
        assert_eq!(ends(|t| (500.0, 1.0 + 0.2 * f64::sin(t / 20.0)), 1.0), None);
        assert!(ends(|t| (0.5 + 0.2 * f64::sin(t), 0.0), 1.0).is_some());
    }
}
