//! When an outcome may be evaluated: from two sound crossings of the largest body after first contact on, as soon as the
//! internal energy has stayed within 1e-3 of the initial kinetic energy (centre-of-mass frame) over one crossing.
//! With own gravity, heating must also be so slow by then that a whole free-fall time t_ff would add less than half of
//! G M^2 / R of the target. Until then matter that will be bound or lost exchanges momentum (softened at the time that
//! the first rule gives, a broken ball of 10 km kept 6 to 10 % more of its mass). This only shows that the shock and its effects
//! are over; for reaccumulation by gravity see `reaccumulated`.

use std::collections::VecDeque;

use serde::{Deserialize, Serialize};

/// Crossings after first contact before which nothing counts as settled.
const LEAST_CROSSINGS: f64 = 2.0;
/// Share of the initial kinetic energy by which internal energy may vary.
const TOLERANCE: f64 = 1e-3;
/// Share of G M^2 / R by which it may grow in a free-fall time, at the rate of the last crossing.
const OF_BINDING: f64 = 0.5;
/// Samples kept per crossing.
const SAMPLES: usize = 64;

/// Watches the internal energy of a run, step by step; part of a checkpoint.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Settled {
    /// s.
    first_contact: f64,
    /// s.
    crossing: f64,
    /// J.
    allowed: f64,
    /// (time, internal energy), oldest first; the oldest lies at or before the start of the last crossing, once there is one.
    samples: VecDeque<(f64, f64)>,
    since: Option<f64>,
}

impl Settled {
    /// `first_contact`: time of first contact, s. `crossing`: time that sound takes through the largest body, s.
    /// `kinetic`: initial kinetic energy in the centre-of-mass frame, J.
    pub fn new(first_contact: f64, crossing: f64, kinetic: f64) -> Self {
        let samples = VecDeque::with_capacity(SAMPLES + 2);
        Self { first_contact, crossing, allowed: TOLERANCE * kinetic, samples, since: None }
    }

    /// Adds the rule for a target bound by gravity: `binding` is G M^2 / R, J; `fall` t_ff, s.
    pub fn bound_by(self, binding: f64, fall: f64) -> Self {
        Self { allowed: self.allowed.min(OF_BINDING * binding * self.crossing / fall), ..self }
    }

    /// Records the internal energy (J) at a time (s) later than the last; true from the moment of settling on.
    pub fn update(&mut self, time: f64, internal: f64) -> bool {
        if self.since.is_some() || time < self.first_contact {
            return self.since.is_some();
        }
        while self.samples.len() > 1 && self.samples[1].0 <= time - self.crossing {
            self.samples.pop_front();
        }
        let is_long_enough = self.samples.front().is_some_and(|(oldest, _)| *oldest <= time - self.crossing);
        let is_late_enough = time >= self.first_contact + LEAST_CROSSINGS * self.crossing;
        let ends = self.samples.iter().fold((internal, internal), |(low, high), (_, u)| (low.min(*u), high.max(*u)));
        if is_long_enough && is_late_enough && ends.1 - ends.0 < self.allowed {
            self.since = Some(time);
        }
        if self.samples.back().is_none_or(|(last, _)| time - last >= self.crossing / SAMPLES as f64) {
            self.samples.push_back((time, internal));
        }
        self.since.is_some()
    }

    /// The earliest time at which it can settle, s.
    pub fn earliest(&self) -> f64 {
        self.first_contact + LEAST_CROSSINGS * self.crossing
    }

    /// When it settled, s.
    pub fn since(&self) -> Option<f64> {
        self.since
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// First settled time of an internal energy, sampled with step `dt`.
    fn settles(internal: impl Fn(f64) -> f64, dt: f64) -> Option<f64> {
        let mut settled = Settled::new(1.0, 10.0, 1000.0);
        (0..10_000).map(|step| step as f64 * dt).find(|&t| settled.update(t, internal(t)))
    }

    #[test]
    fn a_constant_settles_after_two_crossings() {
        let t = settles(|_| 5.0, 0.1).unwrap();
        assert!((21.0..21.0 + 0.11).contains(&t), "{t}");
    }

    /// u = 500 (1 - exp(-t / tau)) changes by 1 J over one crossing from t = tau ln(500 (e^(10 / tau) - 1)) on; the window
    /// may be longer by one sample.
    #[test]
    fn a_relaxing_energy_settles_when_its_change_is_small_enough() {
        let tau = 8.0;
        let exact = tau * f64::ln(500.0 * (f64::exp(10.0 / tau) - 1.0));
        let t = settles(|t| 500.0 * (1.0 - f64::exp(-t / tau)), 0.01).unwrap();
        assert!(t >= exact - 0.01 && t < exact + 2.0 * 10.0 / SAMPLES as f64, "{t} {exact}");
    }

    /// Within 1 J of 1000 J; within 0.1 J where 2 J bind and falling takes ten crossings.
    #[test]
    fn what_binds_sets_a_tighter_bound() {
        let settles = |mut settled: Settled| {
            (0..10_000).map(|k| 0.01 * k as f64).find(|&t| settled.update(t, 500.0 * (1.0 - f64::exp(-t / 8.0))))
        };
        let (loose, tight) = (Settled::new(1.0, 10.0, 1000.0), Settled::new(1.0, 10.0, 1000.0).bound_by(2.0, 100.0));
        assert_eq!(settles(loose.clone()), settles(loose.clone().bound_by(1e9, 100.0)));
        let later = settles(tight).unwrap() - settles(loose).unwrap();
        assert!((later - 8.0 * f64::ln(10.0)).abs() < 2.0 * 10.0 / SAMPLES as f64, "{later}");
    }

    #[test]
    fn an_oscillation_that_returns_is_not_settled() {
        assert_eq!(settles(|t| 2.0 * f64::sin(t * std::f64::consts::TAU / 10.0), 0.05), None);
    }

    #[test]
    fn goes_on_from_a_copy_and_keeps_few_samples() {
        let energy = |t: f64| 500.0 * (1.0 - f64::exp(-t / 8.0));
        let mut first = Settled::new(1.0, 10.0, 1000.0);
        (0..3000).for_each(|k| {
            first.update(k as f64 * 0.01, energy(k as f64 * 0.01));
        });
        let text = toml::to_string(&first).unwrap();
        let mut second: Settled = toml::from_str(&text).unwrap();
        for k in 3000..9000 {
            let (t, u) = (k as f64 * 0.01, energy(k as f64 * 0.01));
            assert_eq!(first.update(t, u), second.update(t, u));
        }
        assert!(first.since().is_some() && first.samples.len() <= SAMPLES + 2);
    }
}
