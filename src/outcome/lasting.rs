//! Whether the largest remnant will last. When the shock has left (`settled`), what is broken goes on to come apart: without its own
//! gravity the slow matter leaves, too, as it gets ever farther away and nothing brakes it. Over the last third of the time tau since first
//! contact the remnant's mass M is fitted by
//!
//! ```text
//! M = A + B tau     which makes it B tau more at twice the time; uncertain by 5/4 |B| tau + 2 s, s what M is off the line (rms)
//! ```
//! A line in time errs on the side of change where it slows down; where it still speeds up, a quarter more is needed (basalt of 50 km hit at
//! 5 km/s: 2.4 per cent of all mass are lost until twice the time, the line says 2.0). The remnant lasts once the uncertainty is 4 per
//! cent of all mass or less. What has not come to that at eight times the time at which the shock had left is taken as it is then.

use std::collections::VecDeque;

use serde::{Deserialize, Serialize};

use crate::math::Line;

/// Share of all mass by which a remnant that lasts is uncertain at most.
const TOLERANCE: f64 = 0.04;
/// Uncertainty over the change by the line.
const MARGIN: f64 = 1.25;
/// tau over that at which the fit begins.
const WINDOW: f64 = 1.5;
/// Evaluations in a window.
const EVALUATIONS: f64 = 12.0;
/// tau over that of the first evaluation at which the outcome is taken in any case.
const LATEST: f64 = 8.0;

/// What becomes of the largest remnant, in shares of the mass of everything.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Trend {
    /// How much more it is at twice the time since first contact.
    pub change: f64,
    /// How far it may then be from what it is now.
    pub uncertainty: f64,
}

impl Trend {
    /// Whether it says what the remnant will be.
    pub fn lasts(&self) -> bool {
        self.uncertainty <= TOLERANCE
    }
}

/// Evaluations of the largest remnant from time to time; part of a checkpoint.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Lasting {
    /// s.
    first_contact: f64,
    /// tau of the first evaluation, s.
    begin: Option<f64>,
    /// (tau, s; M over the mass of everything), oldest first; the oldest at or before the begin of a window, once there is one.
    evaluations: VecDeque<(f64, f64)>,
}

impl Lasting {
    /// `first_contact`: its time, s.
    pub fn new(first_contact: f64) -> Self {
        Self { first_contact, begin: None, evaluations: VecDeque::with_capacity(EVALUATIONS as usize + 2) }
    }

    /// The earliest end of a run whose shock has left at `settled`, s.
    pub fn earliest(first_contact: f64, settled: f64) -> f64 {
        first_contact + WINDOW * (settled - first_contact)
    }

    /// Whether the next evaluation is due at `time`, s.
    pub fn is_due(&self, time: f64) -> bool {
        let tau = time - self.first_contact;
        self.evaluations.back().is_none_or(|(last, _)| tau >= last * libm::pow(WINDOW, 1.0 / EVALUATIONS))
    }

    /// Records an evaluation, M over the mass of everything; true where the outcome is to be taken.
    pub fn note(&mut self, time: f64, share: f64) -> bool {
        let tau = time - self.first_contact;
        let begin = *self.begin.get_or_insert(tau);
        self.evaluations.push_back((tau, share));
        while self.evaluations.len() > 1 && self.evaluations[1].0 <= tau / WINDOW {
            self.evaluations.pop_front();
        }
        let is_long_enough = self.evaluations[0].0 <= tau / WINDOW;
        let lasts = || self.trend().as_ref().is_some_and(Trend::lasts);
        tau >= LATEST * begin || (is_long_enough && lasts())
    }

    /// None of fewer than three evaluations.
    pub fn trend(&self) -> Option<Trend> {
        let points: Vec<(f64, f64)> = self.evaluations.iter().copied().collect();
        let line = Line::through(&points).filter(|_| points.len() > 2)?;
        let &(tau, now) = points.last()?;
        // Neither less than nothing nor more than everything.
        let change = (now + line.slope * tau).clamp(0.0, 1.0) - now;
        Some(Trend { change, uncertainty: MARGIN * change.abs() + 2.0 * line.scatter })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// When the outcome is taken in a run with step `dt`, and the trend then.
    fn taken(share: impl Fn(f64) -> f64, dt: f64) -> (f64, Trend) {
        let mut lasting = Lasting::new(50.0);
        let mut time = 150.0;
        while !(lasting.is_due(time) && lasting.note(time, share(time - 50.0))) {
            time += dt;
        }
        (time, lasting.trend().expect("evaluations"))
    }

    #[test]
    fn what_stays_ends_after_a_window() {
        let (time, trend) = taken(|_| 0.5, 1.0);
        // Evaluations come with every 3.4 per cent of tau, at whole seconds.
        assert!((200.0..206.0).contains(&time), "{time}");
        assert_eq!(trend, Trend { change: 0.0, uncertainty: 0.0 });
    }

    #[test]
    fn what_shrinks_is_waited_for_and_then_is_what_was_said() {
        let share = |tau: f64| 0.3 + 0.4 * 100.0 / tau;
        let (time, trend) = taken(share, 1.0);
        let tau = time - 50.0;
        // The line falls as M does over the window, from 40 / (tau / 1.5) to 40 / tau: by 60 / tau in a time tau.
        let exact = MARGIN * 60.0 / TOLERANCE;
        assert!((tau / 800.0 - 1.0).abs() < 0.04 && exact > 800.0, "{tau} {exact}");
        assert!((share(2.0 * tau) - share(tau)).abs() <= trend.uncertainty && trend.change < 0.0, "{trend:?}");
        let slow = |tau: f64| 0.3 + 0.05 * 100.0 / tau;
        let (time, trend) = taken(slow, 1.0);
        let (tau, exact) = (time - 50.0, MARGIN * 7.5 / TOLERANCE);
        assert!((tau / exact - 1.0).abs() < 0.08, "{tau} {exact}");
        assert!((slow(2.0 * tau) - slow(tau)).abs() <= trend.uncertainty && trend.uncertainty <= TOLERANCE);
    }

    #[test]
    fn what_vanishes_does_not_fall_below_nothing() {
        let share = |tau: f64| (0.5 - tau / 1e3).max(0.001);
        let (time, trend) = taken(share, 1.0);
        assert!(share(time - 50.0) + trend.change >= 0.0 && trend.uncertainty <= TOLERANCE, "{time} {trend:?}");
    }

    #[test]
    fn jumps_are_part_of_the_uncertainty() {
        // Ten per cent of all come and go: no line tells whether they are there at twice the time.
        let (time, trend) = taken(|tau| if (tau / 7.0).floor() % 2.0 == 0.0 { 0.5 } else { 0.4 }, 1.0);
        assert!(time >= 850.0 && trend.uncertainty > 0.09 && !trend.lasts(), "{time} {trend:?}");
    }
}
