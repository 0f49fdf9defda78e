//! Crush curves: the distention that a pressure leaves when it is reached for the first time (Jutzi et al. 2008, eqs 8 and 21).
//!
//! ```text
//! quadratic    alpha = 1 + (alpha_e - 1) s^2                                   s = (P_s - P) / (P_s - P_e)
//! two slopes   alpha = 1 + (alpha_t - 1) s^n_2 + (alpha_e - alpha_t) t^n_1     t = (P_t - P) / (P_t - P_e), 0 for P > P_t
//! measured     between points (P, alpha), monotone cubics in ln P (Fritsch & Carlson 1980, SIAM J. Numer. Anal. 17, 238)
//! ```
//! P pressure, P_e at which pores begin to crush, P_s at which none is left, P_t the end of the first slope, Pa; alpha_e
//! distention at P_e, alpha_t the distention of the second slope alone at P_e.
//!
//! A body with another distention than its material's takes the curve scaled: alpha - 1 by (alpha_0 - 1) over that of the
//! material.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::{Error, Result};
use crate::material::setup::all_positive;
use crate::units::{Number, Pressure};

/// A quadratic crush curve from P_e to P_s.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct QuadraticTable {
    /// Pressure at which pores begin to crush.
    #[serde(rename = "P_e")]
    pub p_e: Pressure,
    /// Pressure from which on no pores are left.
    #[serde(rename = "P_s")]
    pub p_s: Pressure,
}

/// A crush curve of two slopes, each a power.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TwoSlopeTable {
    /// Pressure at which pores begin to crush.
    #[serde(rename = "P_e")]
    pub p_e: Pressure,
    /// Pressure at which the first slope ends.
    #[serde(rename = "P_t")]
    pub p_t: Pressure,
    /// Pressure from which on no pores are left.
    #[serde(rename = "P_s")]
    pub p_s: Pressure,
    /// Distention that the second slope alone would have where pores begin to crush.
    pub alpha_t: Number,
    /// Power of the first slope.
    pub n_1: Number,
    /// Power of the second slope.
    pub n_2: Number,
}

/// A measured crush curve, `{ pressure = ["1 MPa", ...], distention = [4.64, ..., 1] }`, or `{ file = "curve.csv" }` with these two
/// columns (in Pa), which is read into the scene.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeasuredTable {
    /// Pressures, from the lowest on.
    pub pressure: Vec<Pressure>,
    /// Distention at each pressure, down to 1.
    pub distention: Vec<Number>,
}

/// A crush curve as a scene writes it: one of these.
#[derive(Debug, Clone, PartialEq)]
pub enum CurveTable<'a> {
    Quadratic(&'a QuadraticTable),
    TwoSlope(&'a TwoSlopeTable),
    Measured(&'a MeasuredTable),
}

impl CurveTable<'_> {
    /// P_e, Pa.
    pub fn elastic_limit(&self) -> f64 {
        match self {
            CurveTable::Quadratic(table) => table.p_e.0,
            CurveTable::TwoSlope(table) => table.p_e.0,
            CurveTable::Measured(table) => table.pressure.first().map_or(f64::NAN, |p| p.0),
        }
    }

    /// Checks the curve of a material with this distention.
    pub fn validate(&self, place: &str, distention: f64) -> Result<()> {
        let ordered = |place: &str, low: (&str, f64), high: (&str, f64)| {
            if low.1 < high.1 {
                return Ok(());
            }
            let what = format!("{} is {:e} Pa, not above {} = {:e} Pa", high.0, high.1, low.0, low.1);
            Err(Error::new(what).at(format!("{place}.{}", high.0)))
        };
        match self {
            CurveTable::Quadratic(table) => {
                let place = format!("{place}.quadratic");
                all_positive(&place, &[("P_e", table.p_e.0), ("P_s", table.p_s.0)])?;
                ordered(&place, ("P_e", table.p_e.0), ("P_s", table.p_s.0))
            }
            CurveTable::TwoSlope(table) => {
                let place = format!("{place}.two_slope");
                let (e, t, s) = (("P_e", table.p_e.0), ("P_t", table.p_t.0), ("P_s", table.p_s.0));
                all_positive(&place, &[e, t, s])?;
                ordered(&place, e, t)?;
                ordered(&place, t, s)?;
                for (key, power) in [("n_1", table.n_1.0), ("n_2", table.n_2.0)] {
                    if !(power > 1.0 && power.is_finite()) {
                        let error = Error::new(format!("{key} is {power}")).at(format!("{place}.{key}"));
                        return Err(error.allowed("numbers above 1, so that the curve has no kink"));
                    }
                }
                if (1.0..=distention.max(1.0)).contains(&table.alpha_t.0) {
                    return Ok(());
                }
                Err(Error::new(format!("alpha_t is {}", table.alpha_t.0))
                    .at(format!("{place}.alpha_t"))
                    .allowed(format!("1 to the distention, {distention}")))
            }
            CurveTable::Measured(table) => table.validate(&format!("{place}.measured")),
        }
    }
}

impl MeasuredTable {
    fn validate(&self, place: &str) -> Result<()> {
        let (p, alpha) = (&self.pressure, &self.distention);
        if p.len() != alpha.len() || p.len() < 2 {
            let what = format!("{} pressures and {} distentions", p.len(), alpha.len());
            return Err(Error::new(what).at(place).allowed("as many of one as of the other, two and more"));
        }
        let rising = p[0].0 > 0.0 && p.windows(2).all(|pair| pair[0].0 < pair[1].0) && p[p.len() - 1].0.is_finite();
        if !rising {
            return Err(Error::new("the pressures do not rise from point to point")
                .at(format!("{place}.pressure"))
                .allowed("finite pressures above 0, each above the one before"));
        }
        if alpha.windows(2).all(|pair| pair[0].0 > pair[1].0)
            && alpha[alpha.len() - 1].0 == 1.0
            && alpha[0].0.is_finite()
        {
            return Ok(());
        }
        Err(Error::new("the distentions do not fall to 1")
            .at(format!("{place}.distention"))
            .allowed("each below the one before, the last one 1"))
    }
}

/// alpha(P) on first loading.
#[derive(Debug, Clone, PartialEq)]
pub struct CrushCurve {
    /// Pa.
    p_e: f64,
    p_s: f64,
    /// As given: evaluated at P_e the form may be off in the last digits, and no pore may collapse without load.
    alpha_e: f64,
    form: Form,
}

#[derive(Debug, Clone, PartialEq)]
enum Form {
    Square {
        /// alpha_e - 1.
        height: f64,
    },
    Powers {
        p_t: f64,
        /// alpha_t - 1 and alpha_e - alpha_t.
        heights: [f64; 2],
        powers: [f64; 2],
    },
    Measured {
        /// alpha_e - 1 over that of the first point.
        scale: f64,
        points: Vec<Point>,
    },
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Point {
    ln_p: f64,
    /// alpha - 1 and its slope over ln P.
    height: f64,
    slope: f64,
}

impl CrushCurve {
    /// The curve of a body; `scale`: its alpha_0 - 1 over that of its material; `alpha_e`: where its crushing begins.
    pub fn new(table: &CurveTable, scale: f64, alpha_e: f64) -> Self {
        let height = alpha_e - 1.0;
        let (p_e, p_s, form) = match table {
            CurveTable::Quadratic(table) => (table.p_e.0, table.p_s.0, Form::Square { height }),
            CurveTable::TwoSlope(table) => {
                let second = (table.alpha_t.0 - 1.0) * scale;
                let (heights, powers) = ([second, height - second], [table.n_1.0, table.n_2.0]);
                (table.p_e.0, table.p_s.0, Form::Powers { p_t: table.p_t.0, heights, powers })
            }
            CurveTable::Measured(table) => {
                let scale = height / (table.distention[0].0 - 1.0);
                let p_s = table.pressure[table.pressure.len() - 1].0;
                (table.pressure[0].0, p_s, Form::Measured { scale, points: monotone(table) })
            }
        };
        Self { p_e, p_s, alpha_e, form }
    }

    /// P_e, Pa.
    pub fn elastic_limit(&self) -> f64 {
        self.p_e
    }

    /// P_s, Pa.
    pub fn solid_pressure(&self) -> f64 {
        self.p_s
    }

    /// alpha and d alpha / dP, 1/Pa; constant up to P_e and from P_s on.
    pub fn at(&self, p: f64) -> (f64, f64) {
        if p >= self.p_s {
            return (1.0, 0.0);
        }
        if p <= self.p_e {
            return (self.alpha_e, 0.0);
        }
        let (height, slope) = self.above_one(p);
        (1.0 + height, slope)
    }

    /// alpha - 1 and its slope between P_e and P_s.
    fn above_one(&self, p: f64) -> (f64, f64) {
        let by_p = 1.0 / (self.p_s - self.p_e);
        let s = (self.p_s - p) * by_p;
        match &self.form {
            Form::Square { height } => (height * s * s, -2.0 * height * s * by_p),
            Form::Powers { p_t, heights: [second, first], powers: [n_1, n_2] } => {
                let term = |height: f64, n: f64, x: f64, by_p: f64| {
                    let lower = libm::pow(x, n - 1.0);
                    (height * lower * x, -n * height * lower * by_p)
                };
                let (value, slope) = term(*second, *n_2, s, by_p);
                if p >= *p_t {
                    return (value, slope);
                }
                let by_p = 1.0 / (p_t - self.p_e);
                let (more, steeper) = term(*first, *n_1, (p_t - p) * by_p, by_p);
                (value + more, slope + steeper)
            }
            Form::Measured { scale, points } => {
                let x = libm::log(p);
                let k = points.partition_point(|point| point.ln_p <= x).clamp(1, points.len() - 1);
                let (value, slope) = hermite(&points[k - 1], &points[k], x);
                (scale * value, scale * slope / p)
            }
        }
    }
}

/// Points with slopes that keep the cubics between them monotone.
fn monotone(table: &MeasuredTable) -> Vec<Point> {
    let x: Vec<f64> = table.pressure.iter().map(|p| libm::log(p.0)).collect();
    let y: Vec<f64> = table.distention.iter().map(|alpha| alpha.0 - 1.0).collect();
    let secant: Vec<f64> = (1..x.len()).map(|k| (y[k] - y[k - 1]) / (x[k] - x[k - 1])).collect();
    let slope = |k: usize| {
        if k == 0 || k == x.len() - 1 {
            return secant[k.min(secant.len() - 1)];
        }
        // The weighted harmonic mean lies within the region where the cubics are monotone.
        let (before, after) = (x[k] - x[k - 1], x[k + 1] - x[k]);
        let (w, v) = (2.0 * after + before, after + 2.0 * before);
        (w + v) / (w / secant[k - 1] + v / secant[k])
    };
    (0..x.len()).map(|k| Point { ln_p: x[k], height: y[k], slope: slope(k) }).collect()
}

/// The cubic between two points, and its slope.
fn hermite(a: &Point, b: &Point, x: f64) -> (f64, f64) {
    let width = b.ln_p - a.ln_p;
    let t = (x - a.ln_p) / width;
    let rise = b.height - a.height;
    // a + t (c_1 + t (c_2 + t c_3))
    let c_1 = a.slope * width;
    let c_2 = 3.0 * rise - 2.0 * c_1 - b.slope * width;
    let c_3 = rise - c_1 - c_2;
    (a.height + t * (c_1 + t * (c_2 + t * c_3)), (c_1 + t * (2.0 * c_2 + t * 3.0 * c_3)) / width)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Quantity;

    pub fn pumice() -> TwoSlopeTable {
        TwoSlopeTable {
            p_e: Quantity(1.0e6),
            p_t: Quantity(6.8e7),
            p_s: Quantity(2.13e8),
            alpha_t: Quantity(1.9),
            n_1: Quantity(12.0),
            n_2: Quantity(3.0),
        }
    }

    /// Pumice (Jutzi et al. 2008, table 2), digits from an independent evaluation.
    #[test]
    fn two_slopes_of_pumice() {
        let curve = CrushCurve::new(&CurveTable::TwoSlope(&pumice()), 1.0, 4.64);
        let points =
            [(1e6, 4.64), (3e6, 3.779), (1e7, 2.275), (3e7, 1.582), (6.8e7, 1.288), (1e8, 1.136), (1.5e8, 1.0236)];
        for (p, alpha) in points {
            assert!((curve.at(p).0 - alpha).abs() < 6e-4, "{p:e} {}", curve.at(p).0);
        }
        assert_eq!(curve.at(2.13e8), (1.0, 0.0));
        assert_eq!(curve.at(0.0).1, 0.0);
        assert!((curve.at(1.495e7).0 - 1.9).abs() < 1e-3);
    }

    /// A curve that is sampled and interpolated agrees with the original, to the fourth order of the spacing of its points; it
    /// never overshoots.
    #[test]
    fn measured_curves_are_followed_monotonically() {
        let exact = CrushCurve::new(&CurveTable::TwoSlope(&pumice()), 1.0, 4.64);
        let p: Vec<f64> = (0..=60).map(|k| 1e6 * libm::pow(213.0, f64::from(k) / 60.0)).collect();
        let sampled = |p: &f64| if *p >= 2.1299e8 { 1.0 } else { exact.at(*p).0 };
        let table = MeasuredTable {
            pressure: p.iter().map(|p| Quantity(*p)).collect(),
            distention: p.iter().map(|p| Quantity(sampled(p))).collect(),
        };
        table.validate("x").unwrap();
        let curve = CrushCurve::new(&CurveTable::Measured(&table), 1.0, 4.64);
        let mut last = f64::INFINITY;
        for k in 0..4000 {
            let p = 1e6 * libm::pow(212.9, f64::from(k) / 4000.0);
            let (alpha, slope) = curve.at(p);
            assert!((alpha - exact.at(p).0).abs() < 3e-3 && alpha <= last && slope <= 0.0, "{p:e} {alpha} {slope}");
            last = alpha;
        }
    }

    /// Slopes against central differences, which have an error of 1e-10 relative to the curvature.
    #[test]
    fn slopes_agree_with_differences() {
        let quadratic = QuadraticTable { p_e: Quantity(8e7), p_s: Quantity(7e8) };
        let measured = MeasuredTable {
            pressure: [1e6, 5e6, 4e7, 2e8].map(Quantity).to_vec(),
            distention: [3.0, 2.2, 1.4, 1.0].map(Quantity).to_vec(),
        };
        let tables =
            [CurveTable::Quadratic(&quadratic), CurveTable::TwoSlope(&pumice()), CurveTable::Measured(&measured)];
        for table in &tables {
            for scale in [1.0, 0.3] {
                let curve = CrushCurve::new(table, scale, 1.0 + 2.0 * scale);
                for share in [0.02, 0.1, 0.35, 0.7, 0.95] {
                    let p = curve.p_e + share * (curve.p_s - curve.p_e);
                    let d = 1e-5 * p;
                    let slope = (curve.at(p + d).0 - curve.at(p - d).0) / (2.0 * d);
                    assert!((curve.at(p).1 / slope - 1.0).abs() < 1e-5, "{table:?} {p:e}");
                }
                assert!((curve.at(curve.p_e).0 - 1.0 - 2.0 * scale).abs() < 1e-14);
            }
        }
    }

    /// Up to P_e a curve is alpha_e to the last bit: that of pumice, made of its two slopes, would be 4.4e-15 below.
    #[test]
    fn curves_begin_at_alpha_e_exactly() {
        let measured = MeasuredTable {
            pressure: [1e6, 5e6, 2e8].map(Quantity).to_vec(),
            distention: [4.64, 2.2, 1.0].map(Quantity).to_vec(),
        };
        let quadratic = QuadraticTable { p_e: Quantity(3.9e7), p_s: Quantity(8.8e7) };
        let tables =
            [CurveTable::Quadratic(&quadratic), CurveTable::TwoSlope(&pumice()), CurveTable::Measured(&measured)];
        for table in &tables {
            for alpha_e in [1.05, 1.275, 3.0, 4.64] {
                let curve = CrushCurve::new(table, (alpha_e - 1.0) / 3.64, alpha_e);
                assert_eq!([-1e9, 0.0, curve.p_e].map(|p| curve.at(p)), [(alpha_e, 0.0); 3], "{table:?}");
            }
        }
    }

    #[test]
    fn senseless_curves_are_refused() {
        let quadratic = QuadraticTable { p_e: Quantity(8e7), p_s: Quantity(7e7) };
        let message = CurveTable::Quadratic(&quadratic).validate("p", 3.0).unwrap_err().to_string();
        assert_eq!(message, "p.quadratic.P_s: P_s is 7e7 Pa, not above P_e = 8e7 Pa");
        for alpha_t in [0.9, 5.0] {
            let table = TwoSlopeTable { alpha_t: Quantity(alpha_t), ..pumice() };
            assert!(CurveTable::TwoSlope(&table).validate("p", 4.64).is_err());
        }
        let kinked = TwoSlopeTable { n_1: Quantity(1.0), ..pumice() };
        assert!(CurveTable::TwoSlope(&kinked).validate("p", 4.64).is_err());
        for (p, alpha) in [(vec![1e6, 1e5], vec![2.0, 1.0]), (vec![1e6, 2e6], vec![2.0, 1.1]), (vec![1e6], vec![1.0])] {
            let (pressure, distention) =
                (p.into_iter().map(Quantity).collect(), alpha.into_iter().map(Quantity).collect());
            assert!(MeasuredTable { pressure, distention }.validate("m").is_err());
        }
    }
}
