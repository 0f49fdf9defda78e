//! Stress divergence in the (sigma_i + sigma_j) form, with velocity gradient as its energy counterpart.
//! The viscous pressure p_ij of the pair is subtracted on the diagonal.

use super::Pair;
use crate::math::lanes::Lanes;

/// The sum of two stresses on eight lanes: xx yy zz xy xz yz, or xx yy xy in 2D. `diagonal` counts the leading diagonal
/// numbers.
#[derive(Clone, Copy)]
pub struct PairStress<L: Lanes, const D: usize>(pub [L; 6]);

impl<L: Lanes, const D: usize> PairStress<L, D> {
    /// # Safety
    /// As for [`Lanes`].
    #[inline(always)]
    pub unsafe fn sum(a: &[L; 6], b: &[L; 6]) -> Self {
        unsafe {
            let mut s = *a;
            for k in 0..D * (D + 1) / 2 {
                s[k] = a[k].add(b[k]);
            }
            Self(s)
        }
    }

    /// # Safety
    /// As for [`Lanes`].
    #[inline(always)]
    pub unsafe fn minus_pressure(mut self, p: L) -> Self {
        unsafe {
            for k in 0..D {
                self.0[k] = self.0[k].sub(p);
            }
            self
        }
    }

    /// self + factor * other.
    ///
    /// # Safety
    /// As for [`Lanes`].
    #[inline(always)]
    pub unsafe fn plus(mut self, factor: L, other: &Self) -> Self {
        unsafe {
            for k in 0..D * (D + 1) / 2 {
                self.0[k] = factor.fma(other.0[k], self.0[k]);
            }
            self
        }
    }

    /// Adds sigma . g to `force`.
    ///
    /// # Safety
    /// As for [`Lanes`].
    #[inline(always)]
    pub unsafe fn add_force(&self, g: &[L; D], force: &mut [L; D]) {
        unsafe {
            let s = &self.0;
            if D == 2 {
                force[0] = s[2].fma(g[1], s[0].fma(g[0], force[0]));
                force[1] = s[1].fma(g[1], s[2].fma(g[0], force[1]));
            } else {
                force[0] = s[4].fma(g[2], s[3].fma(g[1], s[0].fma(g[0], force[0])));
                force[1] = s[5].fma(g[2], s[1].fma(g[1], s[3].fma(g[0], force[1])));
                force[2] = s[2].fma(g[2], s[5].fma(g[1], s[4].fma(g[0], force[2])));
            }
        }
    }
}

/// Without strength the stress is -P: adds (s - p) g, with `s` the sum of -P over the pair.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
pub unsafe fn add_pressure_force<L: Lanes, const D: usize>(s: L, p: L, pair: &Pair<L, D>, force: &mut [L; D]) {
    unsafe {
        let total = s.sub(p);
        for a in 0..D {
            force[a] = total.fma(pair.gradient[a], force[a]);
        }
    }
}
