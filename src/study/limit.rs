//! Richardson extrapolation with a fitted order: a figure over spacings h goes like f = f_0 + C h^p, and f_0 is its value at
//! zero spacing. f_0, C and p by least squares: for each p a linear problem, and one minimum over p.
//!
//! Uncertainty of f_0: with four spacings and more by leaving out one after another and fitting the rest (the jackknife,
//! Efron and Stein 1981, Ann. Statist. 9, 586), which sees scatter and terms of higher order alike; with three, which any
//! order fits, 1.25 times the extrapolated difference (the grid convergence index, Roache 1994, J. Fluids Eng. 116, 405). Outside
//! the asymptotic range nothing is extrapolated: the finest run's figure is used, as uncertain as figures differ.

use serde::{Deserialize, Serialize};

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Limit {
    /// f_0
    pub value: f64,
    pub uncertainty: f64,
    /// p; none where nothing was extrapolated.
    pub order: Option<f64>,
    /// Why it is only a guess; empty where figures converge as they should.
    pub doubt: String,
}

/// Orders that a scheme may have; a fit at an end of the range has found none.
const ORDERS: [f64; 2] = [0.2, 6.0];
const SCANNED: usize = 120;
/// Leaving out the coarsest may change the order this much within the asymptotic range.
const TOLERANCE: f64 = 0.5;
const SAFETY: f64 = 1.25;

/// f_0 and p with the residual sum of squares.
#[derive(Debug, Clone, Copy)]
struct Fit {
    value: f64,
    order: f64,
    rest: f64,
}

/// The limit of (spacing, figure) from coarse to fine; `None` for fewer than three spacings.
pub fn limit(points: &[(f64, f64)]) -> Option<Limit> {
    let &[first, .., last] = points else { return None };
    if points.len() < 3 || points.windows(2).any(|pair| pair[1].0 >= pair[0].0) {
        return None;
    }
    let stays = |doubt: &str| {
        let (low, high) = points.iter().fold((first.1, first.1), |(a, b), p| (a.min(p.1), b.max(p.1)));
        Some(Limit { value: last.1, uncertainty: high - low, order: None, doubt: doubt.into() })
    };
    let rises = |pair: &[(f64, f64)]| pair[1].1 > pair[0].1;
    if points.windows(2).any(|pair| rises(pair) != rises(&points[..2])) {
        return stays("figures go up and down with spacing");
    }
    let Some(fit) = Fit::of(points) else { return stays("figures do not settle as spacing falls") };
    if points.len() == 3 {
        let uncertainty = SAFETY * (fit.value - last.1).abs();
        let doubt = "three spacings fit any order".into();
        return Some(Limit { value: fit.value, uncertainty, order: Some(fit.order), doubt });
    }
    let finer = Fit::of(&points[1..]);
    let doubt = match finer {
        Some(finer) if (finer.order - fit.order).abs() <= TOLERANCE => String::new(),
        Some(finer) => format!("without the coarsest spacing the order is {:.2}", finer.order),
        None => "without the coarsest spacing no order fits".into(),
    };
    Some(Limit { value: fit.value, uncertainty: fit.jackknife(points), order: Some(fit.order), doubt })
}

impl Fit {
    /// The best order inside the range; none where the best lies at an end of it.
    fn of(points: &[(f64, f64)]) -> Option<Self> {
        let at = |k: f64| ORDERS[0] * libm::pow(ORDERS[1] / ORDERS[0], k / SCANNED as f64);
        let fit = |k: f64| Self::with_order(points, at(k));
        let best = (0..=SCANNED).min_by(|&a, &b| fit(a as f64).rest.total_cmp(&fit(b as f64).rest))?;
        if best == 0 || best == SCANNED {
            return None;
        }
        // Golden section between the neighbours of the best.
        let golden = 0.5 * (5f64.sqrt() - 1.0);
        let (mut low, mut high) = (best as f64 - 1.0, best as f64 + 1.0);
        for _ in 0..60 {
            let (a, b) = (high - golden * (high - low), low + golden * (high - low));
            if fit(a).rest < fit(b).rest { high = b } else { low = a }
        }
        Some(fit(0.5 * (low + high)))
    }

    /// Least squares for f_0 and C. The power is of h over the coarsest one, so that numbers stay near one.
    fn with_order(points: &[(f64, f64)], order: f64) -> Self {
        let h_0 = points[0].0;
        let x = |h: f64| libm::pow(h / h_0, order);
        let sum = |get: &dyn Fn(f64, f64) -> f64| points.iter().map(|&(h, f)| get(x(h), f)).sum::<f64>();
        let n = points.len() as f64;
        let (x_mean, f_mean) = (sum(&|x, _| x) / n, sum(&|_, f| f) / n);
        let sxx = sum(&|x, _| (x - x_mean) * (x - x_mean));
        let coefficient = sum(&|x, f| (x - x_mean) * (f - f_mean)) / sxx;
        let value = f_mean - coefficient * x_mean;
        let rest = sum(&|x, f| {
            let r = f - value - coefficient * x;
            r * r
        });
        Self { value, order, rest }
    }

    /// Standard error of f_0. Where the rest has no order, f_0 may as well be the finest figure.
    fn jackknife(&self, points: &[(f64, f64)]) -> f64 {
        let finest = points[points.len() - 1].1;
        let without = |k: usize| {
            let rest: Vec<_> = points.iter().enumerate().filter(|(i, _)| *i != k).map(|(_, p)| *p).collect();
            Self::of(&rest).map_or(finest, |fit| fit.value) - self.value
        };
        let n = points.len() as f64;
        ((n - 1.0) / n * (0..points.len()).map(without).map(|shift| shift * shift).sum::<f64>()).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(spacings: &[f64], figure: impl Fn(f64) -> f64) -> Limit {
        limit(&spacings.iter().map(|&h| (h, figure(h))).collect::<Vec<_>>()).unwrap()
    }

    const SPACINGS: [f64; 5] = [0.08, 0.04, 0.02, 0.01, 0.005];

    #[test]
    fn finds_a_known_limit_and_order() {
        for (p, c) in [(1.0, 3.0), (2.0, -40.0), (0.7, 0.2)] {
            let found = of(&SPACINGS, |h| 5.0 + c * h.powf(p));
            assert!((found.value - 5.0).abs() < 1e-6 && (found.order.unwrap() - p).abs() < 1e-4, "{found:?}");
            assert!(found.uncertainty < 1e-5 && found.doubt.is_empty(), "{found:?}");
        }
    }

    /// A second term, and scatter: the truth lies within two uncertainties.
    #[test]
    fn the_uncertainty_holds_the_truth() {
        let second = of(&SPACINGS, |h| 1.0 + h + 4.0 * h * h);
        assert!((second.value - 1.0).abs() < 2.0 * second.uncertainty && second.uncertainty < 0.02, "{second:?}");
        // Most of the scattered cases, as to be expected of five points.
        let scattered = |k: i32| of(&SPACINGS, |h| 1.0 + h + 2e-4 * (1e4 * h + k as f64).sin());
        let held = (0..40).map(scattered).filter(|found| (found.value - 1.0).abs() < 2.0 * found.uncertainty).count();
        assert!((32..40).contains(&held), "{held} of 40");
        let three = of(&SPACINGS[..3], |h| 1.0 + h * h);
        assert!((three.value - 1.0).abs() < three.uncertainty && three.doubt.contains("three"), "{three:?}");
    }

    #[test]
    fn nothing_is_extrapolated_outside_the_asymptotic_range() {
        let wild = of(&SPACINGS, |h| (300.0 * h).sin());
        assert!(wild.order.is_none() && wild.value == (1.5f64).sin() && wild.uncertainty > 0.5, "{wild:?}");
        // It falls as fast as ever, like a logarithm: no limit is in sight.
        assert!(of(&SPACINGS, |h| h.ln()).order.is_none());
        assert!(limit(&[(0.1, 1.0), (0.05, 1.1)]).is_none());
    }
}
