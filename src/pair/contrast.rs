//! Pairs of very different density: air or vapour beside rock. The plain sums share the strain of a pair evenly, so that gas
//! moving against rock counts as compression of the rock, and the resulting pressure, with the bulk modulus of rock, expels the
//! gas. Here the light particle takes most of the strain, by the shares
//!
//! ```text
//! w_i = 2 rho_j / (rho_i + rho_j)        w_i + w_j = 2
//! a_i = (1/rho_i) sum_j V_j (w_i sigma_i + w_j sigma_j) . gW      L_i = sum_j w_i V_j (v_j - v_i) (x) gW      M_i likewise
//! ```
//! The pair's pressure (rho_j P_i + rho_i P_j) / (rho_i + rho_j), that of the light one, is what makes the acceleration of both sides of a
//! contact the same (Hu & Adams 2007, J. Comp. Phys. 227, 264); the shares of the strain are its counterpart in the energy, which
//! stays constant to rounding. Equal densities have w = 1, the plain sums. As neighbours do not count alike, only the corrected gradient
//! is exact for linear fields.
//!
//! A rigid body is the limit of infinite density. Its records hold [`RIGID`] times its density: of a pair with a deformable particle
//! that one takes all the strain (w = 2), and the stress of the pair is twice its own, as if the body were its mirror image. In
//! viscosity the density of the pair becomes 2 rho of the deformable particle; alpha c of the rigid one, which its record holds divided
//! by [`RIGID`], drops out, so that p = rho (alpha c |mu| + 2 beta mu^2) with the other's rho, alpha and c. Between two rigid bodies
//! the factors cancel in all but beta mu^2, which is left out there.
//!
//! A rigid body that does not adhere has [`LOOSE`] times its density: w = 0 on both sides, and only viscosity and a contact that is no
//! pair term (`step::contact`) act between them.

use super::Pair;
use crate::math::lanes::Lanes;

/// Density of a rigid body's records over its own: powers of two, so that nothing is rounded. One that adheres, and one that does not.
pub const RIGID: f64 = (1u128 << 60) as f64;
pub const LOOSE: f64 = (1u128 << 100) as f64;
/// No matter that deforms is as dense, kg/m^3, and no rigid body that adheres.
const DENSEST: f64 = 1e12;
const DENSEST_THAT_ADHERES: f64 = 1e25;

/// beta, but for pairs of rigid bodies, which have none.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
pub unsafe fn beta_of<L: Lanes>(beta: L, rho_i: L, rho_j: L) -> L {
    unsafe { beta.keep(rho_i.min(rho_j).less(L::splat(DENSEST))) }
}

/// Whether the record of a particle with this density is that of a rigid body that does not adhere.
#[inline]
pub fn is_loose(density: f64) -> bool {
    density > DENSEST_THAT_ADHERES
}

/// 1 where one of two particles deforms and the other belongs to a rigid body that does not adhere, 0 elsewhere.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
pub unsafe fn loose<L: Lanes>(rho_i: L, rho_j: L) -> (L, bool) {
    unsafe {
        let mask = L::splat(DENSEST_THAT_ADHERES).less(rho_i.max(rho_j));
        if L::count(mask) == 0 {
            return (L::splat(0.0), false);
        }
        let deforms = rho_i.min(rho_j).less(L::splat(DENSEST));
        (L::splat(1.0).keep(mask).keep(deforms), true)
    }
}

/// w_i and w_j from rho_i and rho_j.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
pub unsafe fn shares<L: Lanes>(rho_i: L, rho_j: L) -> [L; 2] {
    unsafe {
        let scale = L::splat(2.0).div(rho_i.add(rho_j));
        [rho_j.mul(scale), rho_i.mul(scale)]
    }
}

/// The words of a stress, symmetric or not, times its share.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
pub unsafe fn share_of<L: Lanes, const N: usize>(share: L, stress: [L; N]) -> [L; N] {
    unsafe {
        let mut s = stress;
        for word in &mut s {
            *word = word.mul(share);
        }
        s
    }
}

/// V_j gW as i strains by it.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
pub unsafe fn straining<L: Lanes, const D: usize>(share: L, pair: &Pair<L, D>) -> [L; D] {
    unsafe {
        let mut g = pair.gradient;
        for word in &mut g {
            *word = word.mul(share);
        }
        g
    }
}
