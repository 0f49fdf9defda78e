//! The Pareto front: points that no other beats in both cost and error. And the cost of an error: curves of one setting from
//! coarse to fine, interpolated by straight lines in logarithms.

use serde::{Deserialize, Serialize};

use crate::math::Line;

/// Points that no other beats, from cheap to expensive. `points` are (cost, error); one that is missing beats nothing.
pub fn front(points: &[Option<(f64, f64)>]) -> Vec<usize> {
    let mut order: Vec<(usize, f64, f64)> =
        points.iter().enumerate().filter_map(|(k, point)| point.map(|(cost, error)| (k, cost, error))).collect();
    order.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.2.total_cmp(&b.2)));
    let mut found: Vec<(usize, f64)> = Vec::new();
    for (k, _, error) in order {
        if found.last().is_none_or(|(_, best)| error < *best) {
            found.push((k, error));
        }
    }
    found.into_iter().map(|(k, _)| k).collect()
}

/// One run of a setting.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// m
    pub spacing: f64,
    pub error: f64,
    pub cost: f64,
}

/// How a cost is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Known {
    /// A run has this error or less, and none of the setting is coarser.
    Measured,
    /// Between two runs.
    Interpolated,
    /// Beyond the finest run, by the fitted order.
    Extrapolated,
}

/// The cost of an error with one setting.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ErrorCost {
    pub cost: f64,
    /// m
    pub spacing: f64,
    pub known: Known,
}

/// The step of `curve` (coarse to fine) from which on every error is within `target`. A step that is so by chance, with finer
/// ones above the target, does not count.
pub fn first_within(curve: &[Step], target: f64) -> Option<usize> {
    let beyond = curve.iter().rposition(|step| step.error > target).map_or(0, |k| k + 1);
    (beyond < curve.len()).then_some(beyond)
}

/// The least cost at which `curve` (coarse to fine) stays within `target`; none where its finest run does not.
pub fn price(curve: &[Step], target: f64) -> Option<ErrorCost> {
    let k = first_within(curve, target)?;
    let fine = curve[k];
    let Some(coarse) = k.checked_sub(1).map(|before| curve[before]).filter(|_| fine.error > 0.0) else {
        return Some(ErrorCost { cost: fine.cost, spacing: fine.spacing, known: Known::Measured });
    };
    let part = libm::log(coarse.error / target) / libm::log(coarse.error / fine.error);
    let between = |a: f64, b: f64| a * libm::pow(b / a, part);
    Some(ErrorCost {
        cost: between(coarse.cost, fine.cost),
        spacing: between(coarse.spacing, fine.spacing),
        known: Known::Interpolated,
    })
}

/// The cost by extrapolation beyond the finest run, by straight lines through all: error over spacing of this `order`, cost over
/// spacing.
pub fn beyond(curve: &[Step], target: f64, order: f64) -> Option<ErrorCost> {
    let finest = curve.last()?;
    let logs: Vec<(f64, f64)> = curve.iter().map(|s| (libm::log(s.spacing), libm::log(s.cost))).collect();
    let slope = Line::through(&logs)?.slope;
    if order <= 0.0 || finest.error <= target {
        return None;
    }
    let ratio = libm::pow(target / finest.error, 1.0 / order);
    let cost = finest.cost * libm::pow(ratio, slope);
    Some(ErrorCost { cost, spacing: finest.spacing * ratio, known: Known::Extrapolated })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_known_front() {
        let points = [(1.0, 0.9), (2.0, 0.5), (2.0, 0.6), (3.0, 0.5), (4.0, 0.1), (8.0, 0.2)].map(Some);
        assert_eq!(front(&points), [0, 1, 4]);
        assert_eq!(front(&[None, Some((1.0, 1.0)), None]), [1]);
        assert!(front(&[]).is_empty());
    }

    /// Error h, cost h^-3: one per cent costs 1e6.
    fn curve() -> Vec<Step> {
        [0.08, 0.04, 0.02, 0.007].map(|h: f64| Step { spacing: h, error: h, cost: h.powi(-3) }).to_vec()
    }

    #[test]
    fn prices_lie_on_the_power_law() {
        let found = price(&curve(), 0.01).unwrap();
        assert!((found.cost / 1e6 - 1.0).abs() < 1e-12 && (found.spacing - 0.01).abs() < 1e-12);
        assert_eq!(found.known, Known::Interpolated);
        let coarsest = price(&curve(), 0.5).unwrap();
        assert_eq!((coarsest.spacing, coarsest.known), (0.08, Known::Measured));
        assert_eq!(price(&curve(), 0.001), None);
        let guess = beyond(&curve(), 0.001, 1.0).unwrap();
        assert!((guess.cost / 1e9 - 1.0).abs() < 1e-9 && guess.known == Known::Extrapolated);
        assert!(beyond(&curve(), 0.001, -1.0).is_none() && beyond(&curve()[..1], 0.001, 1.0).is_none());
    }

    /// An error that happens to pass through zero does not count.
    #[test]
    fn luck_does_not_count() {
        let mut lucky = curve();
        lucky[1].error = 1e-6;
        assert_eq!(first_within(&lucky, 0.01), Some(3));
        assert!((price(&lucky, 0.01).unwrap().spacing - 0.01).abs() < 1e-12);
    }
}
