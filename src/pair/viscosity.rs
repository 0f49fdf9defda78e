//! Monaghan viscosity (Monaghan 1992, ARA&A 30, 543): for approaching pairs Pi = (-alpha c mu + beta mu^2) / rho with
//! mu = h v.x / (r^2 + 0.01 h^2), h that of the pair, and means of alpha c, beta and rho. It enters as a
//! pressure p_ij = rho_i rho_j Pi_ij of the pair, alike in force and heating, so that it only ever heats.

use super::Pair;
use crate::math::lanes::Lanes;

/// Inputs of viscosity from the two particles.
#[derive(Clone, Copy)]
pub struct Inputs<L: Lanes> {
    /// rho_i, rho_j, kg/m^3.
    pub density: [L; 2],
    /// Sum of alpha c over the pair, m/s.
    pub alpha_c: L,
    /// Mean beta.
    pub beta: L,
    /// v.x of the approach that is resisted, m^2/s; not positive.
    pub jump: L,
}

/// 1/r and the two numbers of viscosity, from one division.
#[derive(Clone, Copy)]
pub struct Result<L: Lanes> {
    pub r_inverse: L,
    /// p_ij, Pa.
    pub pressure: L,
    /// |mu| of the whole approach, m/s.
    pub approach: L,
}

/// # Safety
/// As for [`Lanes`].
#[inline(always)]
pub unsafe fn viscous<L: Lanes, const D: usize>(pair: &Pair<L, D>, r2: L, inputs: &Inputs<L>) -> Result<L> {
    unsafe {
        let [rho_i, rho_j] = inputs.density;
        let g = pair.h_inverse;
        // mu = w / d with everything in units of h.
        let w = inputs.jump.mul(g);
        let closing = pair.v_dot_x.min(L::splat(0.0)).mul(g);
        let d = r2.mul(g).fma(g, L::splat(0.01));
        let rho_sum = rho_i.add(rho_j);
        let d2_rho = d.mul(d).mul(rho_sum);
        let t = L::splat(1.0).div(pair.r.mul(d2_rho));
        let r_t = pair.r.mul(t);
        // -alpha c mu + beta mu^2 = (w / d^2) (beta w - alpha c d), alpha c the mean; 1 / mean rho = 2 / rho_sum.
        let bracket = inputs.beta.mul(w).mul(L::splat(2.0));
        let bracket = inputs.alpha_c.fnma(d, bracket);
        let pressure = rho_i.mul(rho_j).mul(w.mul(bracket)).mul(r_t);
        let approach = L::splat(0.0).sub(closing).mul(d.mul(rho_sum)).mul(r_t);
        Result { r_inverse: t.mul(d2_rho), pressure, approach }
    }
}
