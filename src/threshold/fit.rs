//! The threshold and its uncertainty from impacts. Near the threshold the largest remnant follows
//! M_lr / M = 1/2 - s (Q / Q* - 1) (Benz and Asphaug 1999), a straight line in Q; it is put through all impacts that
//! left between 0.1 and 0.9 by least squares. Shares far from one half bend away from the line: impacts count the less
//! the farther they are, with the tricube weights of local regression (Cleveland 1979), zero at 0.1 and 0.9.
//!
//! The uncertainty is the root of the sum of squares of
//! - half the width of the bracket,
//! - the standard error of the line's crossing, from its residuals (zero for fewer than three impacts),
//! - the shift of the crossing to twice the time, as the trends of remnants have it.

use serde::{Deserialize, Serialize};

use super::bracket::{Bracket, HALF, Point};

/// The remnant law is fitted to shares within this distance of one half.
const FITTED: f64 = 0.4;

/// A threshold found.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Threshold {
    /// J/kg.
    pub q_star: f64,
    /// s of the remnant law.
    pub slope: f64,
    pub bracket: Bracket,
    /// Impacts that the law was fitted to.
    pub impacts_fitted: usize,
    pub uncertainty: Uncertainty,
}

/// Parts of the uncertainty of a threshold, J/kg.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Uncertainty {
    /// Half the bracket's width.
    pub bracket: f64,
    /// Standard error of the fitted crossing.
    pub residual: f64,
    /// Shift of the crossing to twice the time.
    pub shift: f64,
    /// Root of the sum of squares.
    pub combined: f64,
}

/// The threshold by these impacts; `None` while they do not bracket it.
pub fn threshold(points: &[Point]) -> Option<Threshold> {
    let now: Vec<(f64, f64)> = points.iter().map(|p| (p.q, p.remnant)).collect();
    let later: Vec<(f64, f64)> = points.iter().map(|p| (p.q, p.remnant_later)).collect();
    let bracket = Bracket::of(&now)?;
    let crossing = Crossing::of(&now, &bracket);
    // At the later time the bracket may have moved off the impacts; the law still gives the crossing.
    let later_bracket = Bracket::of(&later).unwrap_or(bracket);
    let shift = (Crossing::of(&later, &later_bracket).q - crossing.q).abs();
    let half_width = 0.5 * (bracket.high - bracket.low);
    let residual = crossing.error;
    let combined = (half_width * half_width + residual * residual + shift * shift).sqrt();
    Some(Threshold {
        q_star: crossing.q,
        slope: crossing.slope,
        bracket,
        impacts_fitted: crossing.fitted,
        uncertainty: Uncertainty { bracket: half_width, residual, shift, combined },
    })
}

/// Where the law crosses one half.
struct Crossing {
    q: f64,
    slope: f64,
    error: f64,
    fitted: usize,
}

impl Crossing {
    /// The fitted crossing, held within the bracket widened by its own error, as the line is only an interpolation between
    /// impacts. The bracket's crossing where no falling line can be fitted.
    fn of(shares: &[(f64, f64)], bracket: &Bracket) -> Self {
        let near: Vec<(f64, f64)> = shares.iter().copied().filter(|(_, share)| is_fitted(*share)).collect();
        match Line::through(&near) {
            Some(line) => {
                let (q, error) = line.crossing();
                let q = q.clamp(bracket.low - error, bracket.high + error);
                Self { q, slope: line.fall * q, error, fitted: near.len() }
            }
            None => {
                let slope = slope_between(shares, bracket);
                Self { q: bracket.crossing, slope, error: 0.0, fitted: 0 }
            }
        }
    }
}

/// s of the law between the ends of the bracket.
fn slope_between(shares: &[(f64, f64)], bracket: &Bracket) -> f64 {
    let share_at = |q: f64| shares.iter().find(|(x, _)| *x == q).map_or(HALF, |(_, share)| *share);
    (share_at(bracket.low) - share_at(bracket.high)) / (bracket.high - bracket.low) * bracket.crossing
}

/// Whether the law is fitted to an impact that left this share.
pub fn is_fitted(share: f64) -> bool {
    weight(share) > 0.0
}

/// Tricube: one at one half, falling smoothly to zero.
fn weight(share: f64) -> f64 {
    let x = ((share - HALF) / FITTED).abs().min(1.0);
    let rest = 1.0 - x * x * x;
    rest * rest * rest
}

/// share = mean - fall (Q - middle), by weighted least squares.
struct Line {
    middle: f64,
    mean: f64,
    fall: f64,
    /// Sum of the weights.
    total: f64,
    /// Weighted sum of (Q - middle)^2.
    spread: f64,
    /// Standard deviation of a residual of weight one.
    scatter: f64,
}

impl Line {
    /// `None` unless shares fall significantly.
    fn through(points: &[(f64, f64)]) -> Option<Self> {
        let sum =
            |f: &dyn Fn(f64, f64) -> f64| points.iter().map(|&(q, share)| weight(share) * f(q, share)).sum::<f64>();
        let total = sum(&|_, _| 1.0);
        let middle = sum(&|q, _| q) / total;
        let mean = sum(&|_, share| share) / total;
        let spread = sum(&|q, _| (q - middle) * (q - middle));
        let fall = -sum(&|q, share| (q - middle) * (share - mean)) / spread;
        if points.len() < 2 || !(spread > 0.0 && fall > 0.0) {
            return None;
        }
        let residual = |q: f64, share: f64| share - mean + fall * (q - middle);
        let squares = sum(&|q, share| residual(q, share) * residual(q, share));
        let scatter = if points.len() > 2 { (squares / (points.len() - 2) as f64).sqrt() } else { 0.0 };
        Some(Self { middle, mean, fall, total, spread, scatter })
    }

    /// Q where the line is one half, and its standard error.
    fn crossing(&self) -> (f64, f64) {
        let offset = (self.mean - HALF) / self.fall;
        let error = self.scatter / self.fall * (1.0 / self.total + offset * offset / self.spread).sqrt();
        (self.middle + offset, error)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::uniform;

    fn points(qs: &[f64], now: impl Fn(f64) -> f64, later: impl Fn(f64) -> f64) -> Vec<Point> {
        qs.iter().map(|&q| Point { q, remnant: now(q), remnant_later: later(q) }).collect()
    }

    #[test]
    fn the_law_itself_is_recovered_exactly() {
        let law = |q_star: f64| move |q: f64| 0.5 - 0.35 * (q / q_star - 1.0);
        let found = threshold(&points(&[70.0, 90.0, 105.0, 140.0], law(100.0), law(98.0))).unwrap();
        assert!((found.q_star - 100.0).abs() < 1e-10 && (found.slope - 0.35).abs() < 1e-12, "{found:?}");
        assert_eq!((found.bracket.low, found.bracket.high, found.impacts_fitted), (90.0, 105.0, 4));
        let u = found.uncertainty;
        assert!(u.residual < 1e-10 && (u.shift - 2.0).abs() < 1e-10 && u.bracket == 7.5);
        assert!((u.combined - (7.5f64 * 7.5 + 4.0).sqrt()).abs() < 1e-9);
    }

    /// The stated standard error is that of many noisy searches, to 20 %.
    #[test]
    fn the_residual_error_is_the_spread_of_repeated_searches() {
        let qs = [80.0, 90.0, 97.0, 103.0, 110.0, 125.0];
        let (mut sum, mut square, mut stated) = (0.0, 0.0, 0.0);
        let n = 2000;
        for seed in 0..n {
            let noise = |q: f64| 0.03 * 12f64.sqrt() * (uniform(seed, q.to_bits(), 0) - 0.5);
            let shares: Vec<_> = qs.iter().map(|&q| (q, 0.5 - 0.5 * (q / 100.0 - 1.0) + noise(q))).collect();
            let (q, error) = Line::through(&shares).unwrap().crossing();
            sum += q;
            square += q * q;
            stated += error * error;
        }
        let mean = sum / n as f64;
        let spread = (square / n as f64 - mean * mean).sqrt();
        let stated = (stated / n as f64).sqrt();
        assert!((mean - 100.0).abs() < 4.0 * spread / (n as f64).sqrt() + 0.2, "{mean}");
        assert!((stated / spread - 1.0).abs() < 0.2, "{stated} {spread}");
    }

    #[test]
    fn a_jump_falls_back_to_the_bracket() {
        let step = |q: f64| if q < 100.0 { 0.95 } else { 0.05 };
        let found = threshold(&points(&[96.0, 100.0], step, step)).unwrap();
        assert!(found.q_star > 96.0 && found.q_star < 100.0);
        assert_eq!(found.impacts_fitted, 0);
        assert!((found.slope - 0.9 / 4.0 * found.q_star).abs() < 1e-12);
    }

    #[test]
    fn a_bent_curve_stays_within_its_bracket() {
        let bent = |q: f64| 1.0 / (1.0 + libm::pow(q / 100.0, 6.0));
        let found = threshold(&points(&[75.0, 98.0, 102.0, 140.0], bent, bent)).unwrap();
        let error = found.uncertainty.residual;
        assert!(found.q_star >= 98.0 - error && found.q_star <= 102.0 + error);
        assert!((found.q_star - 100.0).abs() < found.uncertainty.combined);
    }

    #[test]
    fn nothing_without_a_bracket() {
        assert_eq!(threshold(&points(&[1.0, 2.0], |_| 0.9, |_| 0.9)), None);
        assert_eq!(threshold(&points(&[1.0, 2.0], |_| 0.1, |_| 0.1)), None);
        assert_eq!(threshold(&[]), None);
    }

    /// By hand: the mean's error, sqrt(1 / 4), and the slope's, 10 sqrt(1 / 50), at the crossing 10 beyond the middle.
    #[test]
    fn the_error_of_a_crossing_grows_with_its_distance() {
        let line = Line { middle: 100.0, mean: 0.6, fall: 0.01, total: 4.0, spread: 50.0, scatter: 0.02 };
        let (q, error) = line.crossing();
        assert!((q - 110.0).abs() < 1e-12 && (error - 2.0 * 2.25f64.sqrt()).abs() < 1e-12, "{q} {error}");
        let (q, error) = Line { mean: 0.5, ..line }.crossing();
        assert!((q - 100.0).abs() < 1e-12 && (error - 1.0).abs() < 1e-12, "{q} {error}");
    }
}
