//! Damping of pairs that move apart, the mirror image of viscosity's beta: p_ij = -K rho mu^2 with mu = h v.x / (r^2 + 0.01 h^2)
//! and rho the mean density. A pressure of the pair is alike in force and heating, and this one only ever heats.

use sph_mpi::math::lanes::Lanes;
use sph_mpi::pair::Pair;

const K: f64 = 0.5;

/// p_ij, Pa; `density_sum` is rho_i + rho_j.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
pub unsafe fn pressure<L: Lanes, const D: usize>(pair: &Pair<L, D>, density_sum: L) -> L {
    // SAFETY: as promised by the caller.
    unsafe {
        let q = pair.r.mul(pair.h_inverse);
        let mu = pair.v_dot_x.max(L::splat(0.0)).mul(pair.h_inverse).div(q.fma(q, L::splat(0.01)));
        mu.mul(mu).mul(density_sum).mul(L::splat(-0.5 * K))
    }
}

mod tests {
    use super::*;
    use sph_mpi::math::lanes::Portable;

    /// p_ij of a pair at the distance x along x, with the relative velocity v.
    fn of_a_pair(x: f64, v: f64, h: f64) -> f64 {
        // SAFETY: portable lanes need no instruction set.
        unsafe {
            let all = |x: f64| Portable::splat(x);
            let zero = all(0.0);
            let pair = Pair::<Portable, 3> {
                x: [all(x), zero, zero],
                v: [all(v), zero, zero],
                r: all(x.abs()),
                h_inverse: all(1.0 / h),
                v_dot_x: all(v * x),
                gradient: [zero; 3],
                slope: zero,
            };
            let sum = pressure(&pair, all(2.0 * 2700.0));
            Portable::fold([sum; 8])[0] / 8.0
        }
    }

    #[test]
    fn pairs_that_move_apart_are_held_back_and_heat() {
        let (x, v, h) = (1.3, 20.0, 1.1);
        let mu = h * v * x / (x * x + 0.01 * h * h);
        let p = of_a_pair(x, v, h);
        assert!((p / (-K * 2700.0 * mu * mu) - 1.0).abs() < 1e-14, "{p}");
        // Nothing acts on those that approach; seen from the other particle it is the same.
        assert_eq!(of_a_pair(x, -v, h), 0.0);
        assert_eq!(of_a_pair(-x, -v, h), p);
        // The heating V_j p v.gW is positive: the gradient of the kernel points against x.
        assert!(p * v * -x > 0.0);
    }
}
