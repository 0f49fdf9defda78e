//! Order of convergence: errors that fall like a power of the spacing, error = C spacing^p, by least squares in logarithms.
//! A straight line through few points always fits; whether errors have begun to fall like that, the asymptotic range, is
//! seen from the last step: it must have about the order of the whole.

use serde::{Deserialize, Serialize};

use crate::math::Line;

/// The order of the finest step may differ this much from that of all, in orders, within the asymptotic range.
const TOLERANCE: f64 = 0.25;

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Order {
    /// p
    pub order: f64,
    /// Standard error of p; `None` for two spacings, which any line fits.
    pub standard_error: Option<f64>,
    /// ln C, spacings in m.
    pub ln_coefficient: f64,
    pub spacings: usize,
    /// Why it is not the order of an asymptotic range; empty where it seems to be.
    pub doubt: String,
}

/// The order of (spacing, error) from coarse to fine; `None` for fewer than two spacings. Errors of zero give no order.
pub fn order(points: &[(f64, f64)]) -> Option<Order> {
    let logs: Vec<(f64, f64)> =
        points.iter().filter(|p| p.0 > 0.0 && p.1 > 0.0).map(|p| (libm::log(p.0), libm::log(p.1))).collect();
    let Line { slope: order, standard_error, intercept: ln_coefficient, .. } = Line::through(&logs)?;
    Some(Order { order, standard_error, ln_coefficient, spacings: logs.len(), doubt: doubt(&logs, order) })
}

fn doubt(logs: &[(f64, f64)], order: f64) -> String {
    let [.., before, last] = logs else { return String::new() };
    if logs.len() < 3 {
        return "two spacings fit any order".into();
    }
    if logs.windows(2).any(|pair| pair[1].1 >= pair[0].1) {
        return "errors do not fall with every spacing".into();
    }
    let last = (before.1 - last.1) / (before.0 - last.0);
    if (last - order).abs() > TOLERANCE {
        return format!("the finest step has order {last:.2}");
    }
    String::new()
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPACINGS: [f64; 5] = [0.08, 0.04, 0.02, 0.01, 0.005];

    fn of(error: impl Fn(f64) -> f64) -> Order {
        order(&SPACINGS.map(|h| (h, error(h)))).unwrap()
    }

    #[test]
    fn finds_a_known_order() {
        let found = of(|h| 3.0 * h.powf(1.7));
        assert!((found.order - 1.7).abs() < 1e-12 && (found.ln_coefficient - 3f64.ln()).abs() < 1e-12);
        assert!(found.standard_error.unwrap() < 1e-12 && found.doubt.is_empty());
    }

    /// Alternating scatter of +-10 %: the true order is within the standard error.
    #[test]
    fn scatter_widens_the_standard_error() {
        let found = of(|h| h * (1.0 + 0.1 * (h.log2() * std::f64::consts::PI).cos()));
        let error = found.standard_error.unwrap();
        assert!(error > 0.01 && (found.order - 1.0).abs() < 3.0 * error, "{found:?}");
    }

    #[test]
    fn floors_and_rises_are_doubtful() {
        assert!(of(|h| h * h + 1e-3).doubt.contains("finest step"));
        assert!(of(|h| 1.0 + h.log2().sin()).doubt.contains("do not fall"));
        assert!(order(&[(0.1, 0.2), (0.05, 0.1)]).unwrap().doubt.contains("two spacings"));
        assert!(order(&[(0.1, 0.2)]).is_none() && order(&[(0.1, 0.2), (0.1, 0.1)]).is_none());
    }
}
