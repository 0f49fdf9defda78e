//! Artificial stress against the tensile instability (Gray, Monaghan & Swift 2001, CMAME 190, 6641, eqs 29-32): on each
//! principal axis in tension, R = -epsilon sigma; between two particles it acts with f^4, f = W(r) / W(spacing).
//!
//! Its force is not central. Where angular momentum is conserved, only the part along the line between both counts: a [`tension`]
//! of the pair, as large along the principal axes, that exerts no torque.

use super::Pair;
use super::stress::PairStress;
use crate::kernel::{CubicSpline, Kernel, Shape, WendlandC2};
use crate::math::Sym;
use crate::math::lanes::Lanes;

/// R of one particle from its damaged stress.
#[inline]
pub fn artificial_stress(stress: &Sym, epsilon: f64) -> Sym {
    // A sum of moduli bounds every principal value: nothing to do where none can be in tension.
    let shear = stress.xy.abs() + stress.xz.abs() + stress.yz.abs();
    if stress.xx.max(stress.yy).max(stress.zz) + shear <= 0.0 {
        return Sym::ZERO;
    }
    let (values, axes) = stress.principal();
    let mut r = Sym::ZERO;
    for (k, &sigma) in values.iter().enumerate() {
        if sigma > 0.0 {
            let (n, s) = (axes.column(k), -epsilon * sigma);
            r.xx += s * n[0] * n[0];
            r.yy += s * n[1] * n[1];
            r.zz += s * n[2] * n[2];
            r.xy += s * n[0] * n[1];
            r.xz += s * n[0] * n[2];
            r.yz += s * n[1] * n[2];
        }
    }
    r
}

/// 1 / W(spacing), in the units of [`Shape::value`]; `h` is given in spacings. The spacing is the distance of nearest
/// neighbours, at which f = 1: in a close packing it is 8 (in 2D) or 12 % more than the edge of the cube that a particle
/// fills, and f^4 would be 0.54 or 0.35 there if f were 1 at that edge.
pub fn reference(kernel: Kernel, h: f64) -> f64 {
    match kernel {
        Kernel::CubicSpline => 1.0 / CubicSpline::value(1.0 / h),
        Kernel::WendlandC2 => 1.0 / WendlandC2::value(1.0 / h),
    }
}

/// f^4 (R_i + R_j) added to the pair's stress; returns f^4 v_ij . (R_i + R_j) . x_ij, by which it lowers the energy.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
pub unsafe fn apply<L: Lanes, K: Shape, const D: usize>(
    pair: &Pair<L, D>,
    reference: L,
    r: &PairStress<L, D>,
    stress: PairStress<L, D>,
) -> (PairStress<L, D>, L) {
    unsafe {
        let f = K::value_lanes(pair.r.mul(pair.h_inverse)).mul(reference);
        let f2 = f.mul(f);
        let f4 = f2.mul(f2);
        let mut along = [L::splat(0.0); D];
        r.add_force(&pair.x, &mut along);
        let mut power = pair.v[0].mul(along[0]);
        for a in 1..D {
            power = pair.v[a].fma(along[a], power);
        }
        (stress.plus(f4, r), f4.mul(power))
    }
}

/// f^4 x . (R_i + R_j) x / x^2, an opposite of a pressure; `r_inverse`: the inverse of the distance.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
pub unsafe fn tension<L: Lanes, K: Shape, const D: usize>(
    pair: &Pair<L, D>,
    r_inverse: L,
    reference: L,
    r: &PairStress<L, D>,
) -> L {
    unsafe {
        let f = K::value_lanes(pair.r.mul(pair.h_inverse)).mul(reference);
        let f2 = f.mul(f);
        let mut along = [L::splat(0.0); D];
        r.add_force(&pair.x, &mut along);
        let mut both = pair.x[0].mul(along[0]);
        for a in 1..D {
            both = pair.x[a].fma(along[a], both);
        }
        f2.mul(f2).mul(both).mul(r_inverse.mul(r_inverse))
    }
}
