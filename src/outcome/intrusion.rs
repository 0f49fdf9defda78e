//! The fall of a body into dust, followed step by step (Geretshauser et al. 2010, A&A 513, A58, Sects. 3.2, 5.1.2): first contact, the
//! deepest point, and the curve between them. The body's lowest point moves as its centre of mass does.
//!
//! ```text
//! depth d(t)      of the lowest point below the undisturbed surface; contact: d(t_c) = 0
//! deepest point   first turn of the velocity after contact: stopping time T_s = t - t_c, intrusion D
//! cleared curve   d(t) - g (t - t_c)^2 / 2: what the fall would be without the speed that gravity has added since contact
//! normalised      h' = -d / D' over t' = (t - t_c) / T', D' and T' those of the cleared curve's own turn: from (0, 0) to (1, -1)
//! sine            h' = -sin(pi t' / 2)                                                                      (eq. 22)
//! deviation       root of the mean over t' from 0 to 1 of the square of the difference
//! ```
//! The paper says that its curves are cleared from gravity, not how; this is the plainest way in which both ends of a curve are those
//! of its normalisation. Moments between two steps are those of straight lines through the speeds (contact: through the depths).

use serde::{Deserialize, Serialize};
use std::f64::consts::FRAC_PI_2;
use std::fmt::Write;

use super::filling::{Marks, Profile, Volumes};

/// Samples of a curve that are kept: when there are twice as many, every other one is dropped.
const SAMPLES: usize = 500;

/// One moment of a fall.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Sample {
    /// s.
    pub time: f64,
    /// Of the body's lowest point below the surface, m.
    pub depth: f64,
    /// Of the body's centre of mass, m/s, positive downwards.
    pub speed: f64,
}

impl Sample {
    /// Without the part that gravity has had since first contact.
    fn cleared(self, contact: &Sample, gravity: f64) -> Self {
        let t = self.time - contact.time;
        Self { depth: self.depth - 0.5 * gravity * t * t, speed: self.speed - gravity * t, ..self }
    }

    /// Where the speed passes zero on its way to `next`.
    fn turn(&self, next: &Self) -> Self {
        let share =
            if self.speed > next.speed { (self.speed / (self.speed - next.speed)).clamp(0.0, 1.0) } else { 1.0 };
        let time = share * (next.time - self.time);
        Self { time: self.time + time, depth: self.depth + 0.5 * self.speed * time, speed: 0.0 }
    }
}

/// A fall so far; part of a checkpoint.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Fall {
    /// m/s^2, along the fall.
    gravity: f64,
    /// Depth less the coordinate of the centre of mass along the fall, m.
    offset: f64,
    pub last: Sample,
    pub contact: Option<Sample>,
    /// The turn of the cleared curve.
    pub cleared: Option<Sample>,
    pub deepest: Option<Sample>,
    curve: Vec<Sample>,
    /// Steps between the samples of the curve, and steps since contact.
    stride: u64,
    steps: u64,
}

impl Fall {
    /// `depth` of the lowest point at the start, m; `centre`, `speed` of the centre of mass along the fall, m and m/s.
    pub fn new(gravity: f64, depth: f64, centre: f64, speed: f64, time: f64) -> Self {
        let last = Sample { time, depth, speed };
        let contact = (depth >= 0.0).then_some(last);
        let (curve, offset) = (Vec::new(), depth - centre);
        Self { gravity, offset, last, contact, cleared: None, deepest: None, curve, stride: 1, steps: 0 }
    }

    /// Depth of the body's lowest point, m, where its centre of mass is at `centre` along the fall.
    pub fn depth(&self, centre: f64) -> f64 {
        centre + self.offset
    }

    /// Takes the next moment: where the centre of mass is along the fall, m, and how fast, m/s. True at the one at which the body has
    /// been deepest.
    pub fn update(&mut self, time: f64, centre: f64, speed: f64) -> bool {
        let now = Sample { time, depth: self.depth(centre), speed };
        let before = std::mem::replace(&mut self.last, now);
        if self.contact.is_none() && now.depth >= 0.0 {
            let share = now.depth / (now.depth - before.depth);
            let back = |now: f64, before: f64| now - share * (now - before);
            let (time, speed) = (back(now.time, before.time), back(now.speed, before.speed));
            self.contact = Some(Sample { time, depth: 0.0, speed });
        }
        let Some(contact) = self.contact.filter(|_| self.deepest.is_none()) else { return false };
        let before = if before.time < contact.time { contact } else { before };
        let cleared = |sample: Sample| sample.cleared(&contact, self.gravity);
        if self.cleared.is_none() && cleared(now).speed <= 0.0 {
            self.cleared = Some(cleared(before).turn(&cleared(now)));
        }
        if now.speed <= 0.0 {
            self.deepest = Some(before.turn(&now));
            return true;
        }
        self.keep(now);
        false
    }

    fn keep(&mut self, sample: Sample) {
        self.steps += 1;
        if self.steps.is_multiple_of(self.stride) {
            self.curve.push(sample);
        }
        if self.curve.len() == 2 * SAMPLES {
            self.stride *= 2;
            let mut kept = true;
            self.curve.retain(|_| {
                kept = !kept;
                kept
            });
        }
    }

    /// The curve from contact to the deepest point, once that is known.
    pub fn curve(&self) -> Option<Curve> {
        let (contact, cleared, deepest) = (self.contact?, self.cleared?, self.deepest?);
        let samples = [&[contact], &self.curve[..], &[deepest]].concat();
        let normal = |sample: &Sample| {
            let sample = sample.cleared(&contact, self.gravity);
            [(sample.time - contact.time) / (cleared.time - contact.time), -sample.depth / cleared.depth]
        };
        let normalised = samples.iter().map(normal).collect();
        Some(Curve { stopping_time: deepest.time - contact.time, samples, normalised })
    }
}

/// -sin(pi t / 2).
pub fn sine(t: f64) -> f64 {
    -libm::sin(FRAC_PI_2 * t)
}

/// An intrusion curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// From contact to the deepest point, s.
    pub stopping_time: f64,
    pub samples: Vec<Sample>,
    /// t' and h' of each sample.
    pub normalised: Vec<[f64; 2]>,
}

impl Curve {
    /// Root mean square of its difference from the sine.
    pub fn deviation(&self) -> f64 {
        let squares = |&[t, h]: &[f64; 2]| (h - sine(t)) * (h - sine(t));
        let mut sum = 0.0;
        for pair in self.normalised.windows(2) {
            // Both curves pass through (1, -1).
            let end = if pair[1][0] > 1.0 { [1.0, -1.0] } else { pair[1] };
            if pair[0][0] < 1.0 {
                sum += 0.5 * (end[0] - pair[0][0]) * (squares(&pair[0]) + squares(&end));
            }
        }
        sum.sqrt()
    }

    /// `intrusion.csv`.
    pub fn table(&self) -> String {
        let mut text = String::from("time_s,depth_m,speed_m_s,normalised_time,normalised_height,sine\n");
        for (Sample { time, depth, speed }, [t, h]) in self.samples.iter().zip(&self.normalised) {
            let _ = writeln!(text, "{time:e},{depth:e},{speed:e},{t:e},{h:e},{:e}", sine(*t));
        }
        text
    }
}

/// A fall and what it has left of the dust, for tables and pictures.
pub struct IntrusionEvaluation {
    pub curve: Option<Curve>,
    pub profile: Profile,
    pub volumes: Volumes,
    pub marks: Marks,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Falls freely by 1 mm, then d(t) = D sin(w (t - t_c)) + g (t - t_c)^2 / 2; `resumed`: at that step.
    fn fall(gravity: f64, dt: f64, resumed: u64) -> (Fall, u64) {
        let (depth, rate, speed) = (2e-3, 500.0, 1.0);
        let contact = 1e-3 / speed;
        let at = |t: f64| {
            let s = t - contact;
            if s < 0.0 {
                return (speed * s, speed);
            }
            let (sin, cos) = (libm::sin(rate * s), libm::cos(rate * s));
            (depth * sin + 0.5 * gravity * s * s, depth * rate * cos + gravity * s)
        };
        let mut fall = Fall::new(gravity, at(0.0).0, 7.0, at(0.0).1, 0.0);
        for step in 1.. {
            if step == resumed {
                fall = serde_json::from_str(&serde_json::to_string(&fall).unwrap()).unwrap();
            }
            let (depth, speed) = at(step as f64 * dt);
            if fall.update(step as f64 * dt, 7.0 + 1e-3 + depth, speed) {
                return (fall, step);
            }
        }
        unreachable!()
    }

    #[test]
    fn a_sine_is_found_as_a_sine() {
        let (fall, step) = fall(0.0, 1e-6, 0);
        let (contact, deepest) = (fall.contact.unwrap(), fall.deepest.unwrap());
        let curve = fall.curve().unwrap();
        assert!((contact.time - 1e-3).abs() < 1e-9 && contact.depth == 0.0 && (contact.speed - 1.0).abs() < 1e-6);
        assert!((curve.stopping_time - FRAC_PI_2 / 500.0).abs() < 1e-9, "{}", curve.stopping_time);
        assert!((step as f64 * 1e-6 - deepest.time) < 1e-6);
        assert!(
            (deepest.depth - 2e-3).abs() < 1e-5 && curve.deviation() < 2e-3,
            "{} {}",
            deepest.depth,
            curve.deviation()
        );
        assert!(curve.samples.len() >= SAMPLES && curve.samples.len() < 2 * SAMPLES + 2);
        assert_eq!(curve.normalised.last().map(|[t, h]| (*t, *h)), Some((1.0, -1.0)));
        assert_eq!(curve.table().lines().count(), curve.samples.len() + 1);
    }

    /// Gravity deepens the fall; less its part the curve is the sine again.
    #[test]
    fn gravity_is_cleared() {
        let (fall, _) = fall(20.0, 1e-6, 0);
        let (cleared, deepest) = (fall.cleared.unwrap(), fall.deepest.unwrap());
        assert!(cleared.time < deepest.time - 1e-5 && deepest.depth > 2.05e-3, "{cleared:?} {deepest:?}");
        let deviation = fall.curve().unwrap().deviation();
        assert!(deviation < 2e-3, "{deviation}");
        let not_cleared = Fall { gravity: 0.0, cleared: Some(deepest), ..fall }.curve().unwrap().deviation();
        assert!(not_cleared > 5.0 * deviation, "{not_cleared}");
    }

    /// A straight line deviates from the sine by sqrt(5/6 - 8/pi^2) in the mean square.
    #[test]
    fn the_deviation_of_a_straight_line() {
        let normalised: Vec<[f64; 2]> = (0..=1000).map(|k| [1e-3 * k as f64, -1e-3 * k as f64]).collect();
        let curve = Curve { stopping_time: 1.0, samples: Vec::new(), normalised };
        let expected = (5.0 / 6.0 - 2.0 / (FRAC_PI_2 * FRAC_PI_2)).sqrt();
        assert!((curve.deviation() - expected).abs() < 1e-6, "{} {expected}", curve.deviation());
    }

    #[test]
    fn goes_on_from_a_checkpoint() {
        assert_eq!(fall(20.0, 2.3e-6, 0), fall(20.0, 2.3e-6, 700));
    }

    /// What turns before it touches has no deepest point, and a fall may begin in touch.
    #[test]
    fn a_turn_counts_after_contact() {
        let mut above = Fall::new(0.0, -1.0, 0.0, 1.0, 0.0);
        assert!(!above.update(0.5, 0.4, 0.5) && !above.update(1.0, 0.4, -0.5) && above.contact.is_none());
        let mut touching = Fall::new(0.0, 0.0, 0.0, 1.0, 0.0);
        assert!(!touching.update(1.0, 0.75, 0.5) && touching.update(2.0, 0.75, -0.5));
        assert_eq!(touching.deepest, Some(Sample { time: 1.5, depth: 0.875, speed: 0.0 }));
    }
}
