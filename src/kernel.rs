//! Smoothing kernels. One convention everywhere: the support is 2h and q = r / h.
//!
//! cubic spline  W = s / h^d [ (2-q)^3 / 4 - (1-q)^3 ]  (each bracket only while positive), s = 10/(7 pi), 1/pi
//! Wendland C2   W = s / h^d (1 - q/2)^4 (2q + 1),                                      s = 7/(4 pi), 21/(16 pi)
//!
//! for d = 2, 3 (Monaghan & Lattanzio 1985, A&A 149, 135; Wendland 1995, Adv. Comp. Math. 4, 389).

use std::f64::consts::PI;

use crate::math::lanes::Lanes;

/// Support radius over smoothing length.
pub const SUPPORT: f64 = 2.0;

/// Kernel of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Kernel {
    #[default]
    CubicSpline,
    #[serde(rename = "wendland_c2")]
    WendlandC2,
}

impl Kernel {
    /// W at a distance `r`, m, of two (1/m^2) or three (1/m^3) dimensions.
    #[inline]
    pub fn value(self, r: f64, h: f64, dimension: usize) -> f64 {
        let q = r / h;
        let shape = match self {
            Self::CubicSpline => CubicSpline::value(q),
            Self::WendlandC2 => WendlandC2::value(q),
        };
        self.normalisation(dimension) * shape / volume(h, dimension)
    }

    /// dW/dr, 1/m^3 or 1/m^4.
    #[inline]
    pub fn slope(self, r: f64, h: f64, dimension: usize) -> f64 {
        let q = r / h;
        let shape = match self {
            Self::CubicSpline => CubicSpline::slope(q),
            Self::WendlandC2 => WendlandC2::slope(q),
        };
        self.normalisation(dimension) * shape / (volume(h, dimension) * h)
    }

    #[inline]
    fn normalisation(self, dimension: usize) -> f64 {
        match (self, dimension) {
            (Self::CubicSpline, 2) => CubicSpline::normalisation::<2>(),
            (Self::CubicSpline, _) => CubicSpline::normalisation::<3>(),
            (Self::WendlandC2, 2) => WendlandC2::normalisation::<2>(),
            (Self::WendlandC2, _) => WendlandC2::normalisation::<3>(),
        }
    }
}

/// h^d.
#[inline]
fn volume(h: f64, dimension: usize) -> f64 {
    if dimension == 2 { h * h } else { h * h * h }
}

/// A kernel as the pair loop needs it, without its factor s / h^d.
pub trait Shape: Copy {
    /// s for dimension D.
    fn normalisation<const D: usize>() -> f64;
    /// h^d W / s.
    fn value(q: f64) -> f64;
    /// h^(d+1) dW/dr / s.
    fn slope(q: f64) -> f64;
    /// h^d W / s for eight values of q.
    ///
    /// # Safety
    /// As for [`Lanes`].
    unsafe fn value_lanes<L: Lanes>(q: L) -> L;
    /// h^(d+1) dW/dr / s for eight values of q; exactly zero at q = 0 and beyond the support.
    ///
    /// # Safety
    /// As for [`Lanes`].
    unsafe fn slope_lanes<L: Lanes>(q: L) -> L;
}

#[derive(Clone, Copy)]
pub struct CubicSpline;

// SAFETY: the callers of its methods answer for the instruction set.
impl Shape for CubicSpline {
    fn normalisation<const D: usize>() -> f64 {
        if D == 2 { 10.0 / (7.0 * PI) } else { 1.0 / PI }
    }
    fn value(q: f64) -> f64 {
        let (a, b) = ((2.0 - q).max(0.0), (1.0 - q).max(0.0));
        0.25 * a * a * a - b * b * b
    }
    fn slope(q: f64) -> f64 {
        let (a, b) = ((2.0 - q).max(0.0), (1.0 - q).max(0.0));
        3.0 * b * b - 0.75 * a * a
    }
    #[inline(always)]
    unsafe fn value_lanes<L: Lanes>(q: L) -> L {
        unsafe {
            let a = L::splat(2.0).sub(q).max(L::splat(0.0));
            let b = L::splat(1.0).sub(q).max(L::splat(0.0));
            b.mul(b).fnma(b, a.mul(a).mul(a).mul(L::splat(0.25)))
        }
    }
    #[inline(always)]
    unsafe fn slope_lanes<L: Lanes>(q: L) -> L {
        unsafe {
            let a = L::splat(2.0).sub(q).max(L::splat(0.0));
            let b = L::splat(1.0).sub(q).max(L::splat(0.0));
            b.mul(b).fma(L::splat(3.0), a.mul(a).mul(L::splat(-0.75)))
        }
    }
}

#[derive(Clone, Copy)]
pub struct WendlandC2;

// SAFETY: the callers of its methods answer for the instruction set.
impl Shape for WendlandC2 {
    fn normalisation<const D: usize>() -> f64 {
        if D == 2 { 7.0 / (4.0 * PI) } else { 21.0 / (16.0 * PI) }
    }
    fn value(q: f64) -> f64 {
        let a = (1.0 - 0.5 * q).max(0.0);
        a * a * a * a * (2.0 * q + 1.0)
    }
    fn slope(q: f64) -> f64 {
        let a = (1.0 - 0.5 * q).max(0.0);
        -5.0 * q * a * a * a
    }
    #[inline(always)]
    unsafe fn value_lanes<L: Lanes>(q: L) -> L {
        unsafe {
            let a = q.fnma(L::splat(0.5), L::splat(1.0)).max(L::splat(0.0));
            let a2 = a.mul(a);
            a2.mul(a2).mul(q.fma(L::splat(2.0), L::splat(1.0)))
        }
    }
    #[inline(always)]
    unsafe fn slope_lanes<L: Lanes>(q: L) -> L {
        unsafe {
            let a = q.fnma(L::splat(0.5), L::splat(1.0)).max(L::splat(0.0));
            a.mul(a).mul(a).mul(q.mul(L::splat(-5.0)))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::lanes::Portable;

    fn slope<K: Shape>(q: f64) -> f64 {
        // SAFETY: the portable lanes need no instruction set.
        unsafe { K::slope_lanes(Portable::splat(q)).fold_max() }
    }

    fn integral<K: Shape, const D: usize>() -> f64 {
        let n = 200_000;
        let dq = SUPPORT / n as f64;
        let surface = |q: f64| if D == 2 { 2.0 * PI * q } else { 4.0 * PI * q * q };
        (0..n).map(|i| (i as f64 + 0.5) * dq).map(|q| K::normalisation::<D>() * K::value(q) * surface(q) * dq).sum()
    }

    #[test]
    fn kernels_integrate_to_one() {
        // Midpoint rule, error of order dq^2 = 1e-10.
        for sum in [
            integral::<CubicSpline, 2>(),
            integral::<CubicSpline, 3>(),
            integral::<WendlandC2, 2>(),
            integral::<WendlandC2, 3>(),
        ] {
            assert!((sum - 1.0).abs() < 1e-9, "{sum}");
        }
    }

    #[test]
    fn slopes_are_the_derivatives() {
        let d = 1e-6;
        for i in 1..40 {
            let q = i as f64 * 0.05 - 0.013;
            for (value, slope) in [
                (CubicSpline::value as fn(f64) -> f64, slope::<CubicSpline>(q)),
                (WendlandC2::value as fn(f64) -> f64, slope::<WendlandC2>(q)),
            ] {
                let difference = (value(q + d) - value(q - d)) / (2.0 * d);
                // Central difference: d^2 times the third derivative, and rounding 1e-16 / d.
                assert!((difference - slope).abs() < 1e-9, "q = {q}");
            }
        }
    }

    #[test]
    fn no_slope_at_the_centre_or_beyond_the_support() {
        for q in [0.0, 2.0, 2.1, 1e30] {
            assert_eq!(slope::<CubicSpline>(q), 0.0);
            assert_eq!(slope::<WendlandC2>(q), 0.0);
        }
    }
}
