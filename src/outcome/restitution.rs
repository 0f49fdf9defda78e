//! The coefficient of restitution of a body that hits another (Geretshauser et al. 2010, A&A 513, A58, Sect. 5.2): how fast their centres
//! of mass part, over how fast they approached.
//!
//! ```text
//! u(t)    velocity of one centre of mass relative to the other's, along that at the start: positive while they approach
//! eps     -u(end) / u(start); negative where they still approach
//! loss    1 - eps^2, the share of the kinetic energy of this motion that is gone
//! contact from the moment at which u has left its first value by 1e-3 of it until it has come as near to its last one
//! ```
//! Without gravity, u changes in contact only.

use serde::{Deserialize, Serialize};
use std::fmt::Write;

/// Samples that are kept: when there are twice as many, every other one is dropped.
const SAMPLES: usize = 500;
/// Change of u over its first value that counts as contact.
const TOUCHED: f64 = 1e-3;
/// Last part of the run in which u of bodies that have parted changes no more than by [`STILL`] of its first value.
const LAST: f64 = 0.1;
const STILL: f64 = 0.01;

/// A bounce so far; part of a checkpoint.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Bounce {
    /// Direction of approach.
    pub direction: [f64; 3],
    /// u at the start, m/s.
    before: f64,
    /// The last (time, s; u, m/s).
    last: [f64; 2],
    samples: Vec<[f64; 2]>,
    /// Rows between samples, and rows since the start.
    stride: u64,
    rows: u64,
}

impl Bounce {
    /// `velocity`: of one centre relative to the other's, m/s, at `time`, s.
    pub fn new(velocity: [f64; 3], time: f64) -> Self {
        let before = velocity.iter().map(|v| v * v).sum::<f64>().sqrt();
        let last = [time, before];
        Self { direction: velocity.map(|v| v / before), before, last, samples: vec![last], stride: 1, rows: 0 }
    }

    /// The component along the approach, m/s.
    pub fn approach(&self, velocity: [f64; 3]) -> f64 {
        velocity.iter().zip(self.direction).map(|(v, n)| v * n).sum()
    }

    pub fn update(&mut self, velocity: [f64; 3], time: f64) {
        if time <= self.last[0] {
            return;
        }
        self.last = [time, self.approach(velocity)];
        self.rows += 1;
        if self.rows.is_multiple_of(self.stride) {
            self.samples.push(self.last);
        }
        if self.samples.len() > 2 * SAMPLES {
            self.stride *= 2;
            let mut kept = false;
            self.samples.retain(|_| {
                kept = !kept;
                kept
            });
        }
    }

    /// All samples with the last one.
    fn all(&self) -> Vec<[f64; 2]> {
        let mut all = self.samples.clone();
        if all.last() != Some(&self.last) {
            all.push(self.last);
        }
        all
    }

    pub fn before(&self) -> f64 {
        self.before
    }

    /// u at the end, negative where the bodies part, m/s.
    pub fn after(&self) -> f64 {
        self.last[1]
    }

    pub fn coefficient(&self) -> f64 {
        -self.after() / self.before
    }

    /// Share of the energy of the approach that is gone.
    pub fn loss(&self) -> f64 {
        1.0 - self.coefficient() * self.coefficient()
    }

    /// First and last moment of contact, s; none where nothing has happened.
    pub fn contact(&self) -> Option<[f64; 2]> {
        let all = self.all();
        let off = |sample: &[f64; 2], u: f64| (sample[1] - u).abs() > TOUCHED * self.before;
        let begin = all.iter().find(|sample| off(sample, self.before))?;
        let end = all.iter().rev().find(|sample| off(sample, self.after()))?;
        Some([begin[0], end[0].max(begin[0])])
    }

    /// Whether the bodies still push or pull each other.
    pub fn is_going_on(&self) -> bool {
        let all = self.all();
        let from = self.last[0] - LAST * (self.last[0] - all[0][0]);
        all.iter().any(|[time, u]| *time >= from && (u - self.after()).abs() > STILL * self.before)
    }

    /// Whether the bodies part, and have not touched for half as long as they did.
    pub fn is_over(&self) -> bool {
        let apart = |[begin, end]: [f64; 2]| self.last[0] - end > 0.5 * (end - begin);
        self.after() < 0.0 && self.contact().is_some_and(apart)
    }

    /// (time, s; u, m/s).
    pub fn points(&self) -> Vec<(f64, f64)> {
        self.all().into_iter().map(|[time, u]| (time, u)).collect()
    }

    /// `restitution.csv`.
    pub fn table(&self) -> String {
        let mut text = String::from("time_s,approach_speed_m_s\n");
        for [time, u] in self.all() {
            let _ = writeln!(text, "{time:e},{u:e}");
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Approaches at 0.5 m/s along (3, 4) / 5, is in contact from 1 s to 2 s, and parts at `after` m/s.
    fn bounce(after: f64, until: f64, rows: usize, resumed: usize) -> Bounce {
        let along = |u: f64| [0.6 * u, 0.8 * u, 0.0];
        let mut bounce = Bounce::new(along(0.5), 0.0);
        for k in 1..=rows {
            if k == resumed {
                bounce = serde_json::from_str(&serde_json::to_string(&bounce).unwrap()).unwrap();
            }
            let time = until * k as f64 / rows as f64;
            bounce.update(along(0.5 + (time - 1.0).clamp(0.0, 1.0) * (-after - 0.5)), time);
        }
        bounce
    }

    #[test]
    fn speeds_before_and_after() {
        let found = bounce(0.1, 4.0, 4000, 0);
        assert!((found.coefficient() - 0.2).abs() < 1e-12 && (found.loss() - 0.96).abs() < 1e-12, "{found:?}");
        let [begin, end] = found.contact().unwrap();
        assert!((begin - 1.0).abs() < 0.02 && (end - 2.0).abs() < 0.02 && !found.is_going_on(), "{begin} {end}");
        assert!(found.all().len() <= 2 * SAMPLES + 2 && found.table().lines().count() == found.all().len() + 1);
        // What moves aside does not count.
        assert!((found.approach([-0.8, 0.6, 3.0])).abs() < 1e-15);
        assert_eq!(found, bounce(0.1, 4.0, 4000, 1777));
    }

    #[test]
    fn an_end_in_contact_is_noticed() {
        let found = bounce(0.1, 1.5, 300, 0);
        assert!(found.is_going_on() && found.coefficient() < 0.0, "{found:?}");
        let untouched = bounce(0.1, 0.9, 30, 0);
        // In contact for a second; who sticks never ends it.
        let over = |after: f64, until: f64| bounce(after, until, 300, 0).is_over();
        assert!(!untouched.is_over() && !over(0.1, 1.5) && !over(0.1, 2.4) && over(0.1, 2.6) && !over(0.0, 4.0));
        assert!(
            untouched.contact().is_none() && (untouched.coefficient() + 1.0).abs() < 1e-12 && !untouched.is_going_on()
        );
        assert_eq!(bounce(0.0, 3.0, 30, 0).coefficient(), -0.0);
    }
}
