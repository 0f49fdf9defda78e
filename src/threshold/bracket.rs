//! The search for a threshold: chooses the next impact. Impacts are points (Q, M_lr / M); the threshold is where the
//! remnant's share falls through one half. Works in log Q, tolerates scatter, and assumes only that harder impacts
//! leave less.

use serde::{Deserialize, Serialize};

/// The share that defines the threshold.
pub const HALF: f64 = 0.5;

/// One impact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// Specific energy, J/kg: Q with the target's mass, or Q_R with both masses.
    pub q: f64,
    /// The largest remnant's share of that mass when the impact had settled: this one counts.
    pub remnant: f64,
    /// The largest remnant's share at twice that time, by its trend.
    pub remnant_later: f64,
}

/// Limits of the search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rules {
    /// Q of the first impact, J/kg.
    pub start: f64,
    /// Width of the final bracket over its middle.
    pub tolerance: f64,
    pub max_impacts: usize,
    /// Least and largest Q that the scene can reach, J/kg.
    pub range: [f64; 2],
}

/// The next action after the impacts so far.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Next {
    /// Run an impact at this Q, J/kg.
    Impact(f64),
    Done(End),
}

/// Why a search ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum End {
    /// The bracket is as narrow as requested.
    Converged,
    /// As many impacts as allowed, with a bracket that is still wider.
    OutOfImpacts,
    /// No impact within range or number left less than half.
    NeverDisrupted,
    /// No impact within range or number left more than half.
    AlwaysDisrupted,
}

/// Neighbouring impacts between which the share falls through one half.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Bracket {
    /// J/kg.
    pub low: f64,
    /// J/kg.
    pub high: f64,
    /// Where a straight line in log Q through the shares at both ends is one half, J/kg.
    pub crossing: f64,
}

impl Bracket {
    /// The bracket that (Q, share) pairs give. Where they scatter, so that more energy seems to leave more, the shares are
    /// first replaced by the nearest ones (least squares) that never rise.
    pub fn of(shares: &[(f64, f64)]) -> Option<Self> {
        let mut sorted = shares.to_vec();
        sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
        let smooth = never_rising(&sorted);
        let first_below = smooth.iter().position(|share| *share < HALF)?;
        let last_above = first_below.checked_sub(1)?;
        let (low, high) = (sorted[last_above].0, sorted[first_below].0);
        let part = (smooth[last_above] - HALF) / (smooth[last_above] - smooth[first_below]);
        Some(Self { low, high, crossing: low * libm::pow(high / low, part) })
    }

    /// Width over the middle.
    pub fn relative_width(&self) -> f64 {
        (self.high - self.low) / (0.5 * (self.high + self.low))
    }
}

/// The never rising sequence nearest to the shares (pool adjacent violators, Ayer et al. 1955). Impacts at one Q count as
/// one, with their mean.
fn never_rising(sorted: &[(f64, f64)]) -> Vec<f64> {
    let mut pools: Vec<(f64, usize)> = Vec::new();
    for group in sorted.chunk_by(|a, b| a.0 == b.0) {
        pools.push((group.iter().map(|(_, share)| share).sum(), group.len()));
        while let [.., (a, na), (b, nb)] = pools[..] {
            if a / na as f64 >= b / nb as f64 {
                break;
            }
            pools.truncate(pools.len() - 2);
            pools.push((a + b, na + nb));
        }
    }
    pools.iter().flat_map(|&(sum, n)| std::iter::repeat_n(sum / n as f64, n)).collect()
}

/// Decides after the impacts so far, in the order in which they were run.
pub fn next(points: &[Point], rules: &Rules) -> Next {
    let Some(bracket) = bracket_of(points) else { return reach_out(points, rules) };
    if bracket.relative_width() <= rules.tolerance {
        return Next::Done(End::Converged);
    }
    if points.len() >= rules.max_impacts {
        return Next::Done(End::OutOfImpacts);
    }
    Next::Impact(inside(points, &bracket, rules.tolerance))
}

fn bracket_of(points: &[Point]) -> Option<Bracket> {
    Bracket::of(&points.iter().map(|p| (p.q, p.remnant)).collect::<Vec<_>>())
}

/// Without a bracket: a step beyond the impact nearest to the threshold, as far as the remnant law M = 1 - Q / (2 Q*)
/// (Stewart and Leinhardt 2009) suggests, and somewhat farther so that the step crosses.
fn reach_out(points: &[Point], rules: &Rules) -> Next {
    let [least, most] = rules.range;
    let Some(last) = points.last() else { return Next::Impact(rules.start.clamp(least, most)) };
    let is_above = last.remnant >= HALF;
    let by_q = |a: &&Point, b: &&Point| a.q.total_cmp(&b.q);
    let nearest = if is_above { points.iter().max_by(by_q) } else { points.iter().min_by(by_q) }.unwrap_or(last);
    let (end, limit) = if is_above { (End::NeverDisrupted, most) } else { (End::AlwaysDisrupted, least) };
    // Q is converted to the projectile's radius and back, with rounding.
    if points.len() >= rules.max_impacts || (nearest.q / limit - 1.0).abs() < 1e-9 {
        return Next::Done(end);
    }
    let law = HALF / (1.0 - nearest.remnant).max(1e-3);
    // A remnant of a few per cent no longer shows how far beyond the threshold the impact was.
    let factor = match nearest.remnant {
        share if share >= HALF => (1.15 * law).clamp(1.25, 4.0),
        share if share > 0.1 => (law / 1.15).clamp(0.25, 0.8),
        _ => 0.3,
    };
    Next::Impact((nearest.q * factor).clamp(least, most))
}

/// Within a bracket: just beyond where the threshold is expected, seen from the nearer end, so that the farther end moves
/// close; but the middle (of log Q) where the last two impacts together have not halved the bracket.
fn inside(points: &[Point], bracket: &Bracket, tolerance: f64) -> f64 {
    let width = |b: &Bracket| libm::log(b.high / b.low);
    let before = points.len().checked_sub(2).and_then(|n| bracket_of(&points[..n]));
    if before.is_some_and(|before| width(bracket) > 0.5 * width(&before)) {
        return (bracket.low * bracket.high).sqrt();
    }
    let step = 1.0 + 0.4 * tolerance;
    let nearer_to_low = bracket.crossing * bracket.crossing < bracket.low * bracket.high;
    let beyond = if nearer_to_low { bracket.crossing * step } else { bracket.crossing / step };
    // Never so close to an end that the impact would add no information.
    let margin = libm::pow(bracket.high / bracket.low, 0.1);
    beyond.clamp(bracket.low * margin, bracket.high / margin)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::uniform;

    fn rules(start: f64) -> Rules {
        Rules { start, tolerance: 0.05, max_impacts: 8, range: [1.0, 1e9] }
    }

    fn run(start: f64, share: impl Fn(f64) -> f64) -> (Vec<Point>, End) {
        let mut points = Vec::new();
        loop {
            match next(&points, &rules(start)) {
                Next::Done(end) => return (points, end),
                Next::Impact(q) => points.push(Point { q, remnant: share(q), remnant_later: share(q) }),
            }
        }
    }

    /// Remnant laws of different steepness: linear to a tail (Leinhardt and Stewart 2012), steep, shallow.
    fn laws() -> [fn(f64) -> f64; 3] {
        let tail = |x: f64| if x < 1.8 { 1.0 - 0.5 * x } else { 0.1 * libm::pow(x / 1.8, -1.5) };
        [tail, |x| 1.0 / (1.0 + libm::pow(x, 6.0)), |x| 1.0 / (1.0 + libm::pow(x, 1.2))]
    }

    #[test]
    fn converges_within_eight_impacts_from_a_factor_of_three() {
        for law in laws() {
            for off in [0.33, 0.5, 0.73, 0.9, 1.0, 1.2, 2.0, 3.0] {
                let (points, end) = run(1e5 * off, |q| law(q / 1e5));
                assert_eq!(end, End::Converged, "start {off}: {points:?}");
                let bracket = bracket_of(&points).unwrap();
                assert!(bracket.relative_width() <= 0.05 && bracket.low <= 1e5 && 1e5 < bracket.high, "{bracket:?}");
            }
        }
    }

    #[test]
    fn scatter_does_not_mislead_it_beyond_its_size() {
        for seed in 0..50 {
            // Half a width of 0.03 in share is 0.06 in Q on this law.
            let noisy = |q: f64| laws()[0](q / 1e5) + 0.06 * (uniform(seed, q.to_bits(), 0) - 0.5);
            let (points, end) = run(0.7e5, noisy);
            assert!(end == End::Converged || end == End::OutOfImpacts);
            let bracket = bracket_of(&points).unwrap();
            assert!(bracket.low < 1.07e5 && bracket.high > 0.93e5, "{bracket:?}");
        }
    }

    #[test]
    fn says_when_there_is_no_threshold() {
        assert_eq!(run(1e5, |_| 0.99).1, End::NeverDisrupted);
        let (points, end) = run(1e5, |_| 0.0);
        assert_eq!(end, End::AlwaysDisrupted);
        assert_eq!(points.len(), 8);
        let near = Rules { range: [1e5, 2e5], ..rules(1e5) };
        let point = |q| Point { q, remnant: 0.9, remnant_later: 0.9 };
        assert_eq!(next(&[point(1e5)], &near), Next::Impact(2e5));
        assert_eq!(next(&[point(1e5), point(2e5)], &near), Next::Done(End::NeverDisrupted));
    }

    #[test]
    fn pools_what_rises() {
        let smooth = never_rising(&[(1.0, 0.9), (2.0, 0.4), (3.0, 0.6), (4.0, 0.55), (5.0, 0.1)]);
        let pooled = (0.4 + 0.6 + 0.55) / 3.0;
        assert_eq!(smooth, [0.9, pooled, pooled, pooled, 0.1]);
        assert_eq!(never_rising(&[(1.0, 0.4), (1.0, 0.6), (2.0, 0.3)]), [0.5, 0.5, 0.3]);
    }
}
