//! Limited reconstruction of the approach that viscosity acts on (after Frontiere, Raskin & Owen 2017, J. Comp. Phys. 332, 160; Rosswog
//! 2020, MNRAS 498, 4230): velocities of both particles are carried to the middle between them along their gradients G, so that what
//! flows smoothly is not damped. Along the pair
//!
//! ```text
//! a = x . G_i x     b = x . G_j x     H = 2 a b / (a + b) where both approach (a, b < 0), else 0     jump = min(min(v.x, 0) - H, 0)
//! ```
//! with x and v of the pair. A linear flow has a = b = v.x, and no jump. H is van Leer's mean, nearer to the smaller of both, so that a
//! front between two slopes keeps its jump. Viscosity takes the jump where it took v.x: its force is alike for both particles, and its
//! heating, by the real v.x, never negative. G is the symmetric part of the corrected gradient at the last evaluation, times
//!
//! ```text
//! s = 1 - Z n / (n + X c)     n = max(-div v, 0) h     Z = 0.7     X = 0.02
//! ```
//! for a shock is smooth, too, once it is resolved: matter that is compressed within h by more than the part X of the speed c of its waves
//! keeps its viscosity, a strong shock Z of it. Shear and weak waves have s = 1.

use super::Pair;
use crate::math::lanes::Lanes;
use crate::math::{Mat3, Sym};

/// v.x of approach that is left between values carried to the middle of the pair; not positive.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
pub unsafe fn jump<L: Lanes, const D: usize>(pair: &Pair<L, D>, slopes: [&[L; 6]; 2]) -> L {
    unsafe {
        let zero = L::splat(0.0);
        let (a, b) = (along(slopes[0], &pair.x).min(zero), along(slopes[1], &pair.x).min(zero));
        // Not zero where both are.
        let sum = a.add(b).min(L::splat(-1e-300));
        let smooth = a.mul(b).mul(L::splat(2.0)).div(sum);
        pair.v_dot_x.min(zero).sub(smooth).min(zero)
    }
}

/// x . G x.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
unsafe fn along<L: Lanes, const D: usize>(g: &[L; 6], x: &[L; D]) -> L {
    unsafe {
        let mut sum = g[0].mul(x[0]).mul(x[0]);
        for k in 1..D {
            sum = g[k].mul(x[k]).fma(x[k], sum);
        }
        let mut across = g[D].mul(x[0]).mul(x[1]);
        if D == 3 {
            across = g[D + 1].mul(x[0]).fma(x[2], across);
            across = g[D + 2].mul(x[1]).fma(x[2], across);
        }
        across.fma(L::splat(2.0), sum)
    }
}

/// Compression within h over the speed of waves from which on matter keeps its viscosity: X.
const STEEP: f64 = 0.02;
/// The part that it keeps in a strong shock: Z. With all of it Noh's implosion, which plain viscosity heats too much, gains nothing; with
/// half of it gas behind Sod's and Sedov's shocks rings.
const KEPT: f64 = 0.7;

/// The gradient that carries values, s times the symmetric part of `gradient`, 1/s, in matter with waves of speed `c`, m/s, and
/// smoothing length `h`, m.
#[inline]
pub fn slope(gradient: &Mat3, h: f64, c: f64) -> Sym {
    let inward = (-gradient.trace() * h).max(0.0);
    let smooth = if inward > 0.0 { 1.0 - KEPT * inward / (inward + STEEP * c) } else { 1.0 };
    Sym::symmetric_part(&(gradient * smooth))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shear_is_carried_and_a_shock_hardly() {
        let shear = Mat3::new(0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
        assert_eq!(slope(&shear, 1.0, 1.0), Sym { xy: 1.0, ..Sym::ZERO });
        let along = |rate: f64, c: f64| slope(&Mat3::from_diagonal(&[rate, 0.0, 0.0].into()), 1.0, c).xx / rate;
        assert_eq!(along(5.0, 1.0), 1.0);
        assert!(along(-1e-4, 1.0) > 0.99 && (along(-STEEP, 1.0) - (1.0 - 0.5 * KEPT)).abs() < 1e-12);
        assert!((along(-1.0, 0.0) - (1.0 - KEPT)).abs() < 1e-12 && along(-1.0, 1.0) < 0.32);
        assert_eq!(slope(&Mat3::zeros(), 1.0, 0.0), Sym::ZERO);
    }
}
