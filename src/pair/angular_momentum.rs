//! Conservation of angular momentum. The force V_i V_j (sigma_i + sigma_j) gW of stress tensors is not central: with
//! M_i = -sum V_j x_ij gW, all forces together exert the torque
//!
//! ```text
//! sum V_i a(sigma_i M_i)           a(A): the axial vector of A - A^T, (A_zy - A_yz, A_xz - A_zx, A_yx - A_xy)
//! ```
//! which vanishes inside uniform matter, where M is 1, but not along surfaces: a pile of blocks at rest begins to rotate. An
//! antisymmetric stress W_i = (w_i x) beside sigma_i cancels it, where (sigma + W) M is symmetric:
//!
//! ```text
//! W M + M W = M sigma - sigma M        (tr(M) - M) w = a(M sigma)
//! ```
//! Its force is w x gW. Work against it is counted as heat, which is zero in rigid rotation. M is
//! extrapolated from the last two evaluations, so that angular momentum is conserved to the second order of the step, and exactly
//! by matter at rest.
//!
//! Along the axes of M, with eigenvalues a, b, c >= 0, w_x = (c - b) sigma_yz / (b + c): |w| is at most the shear in sigma,
//! |w|^2 <= s : s / 2 with its deviator s. What is extrapolated may have an eigenvalue below zero, in spray whose few neighbours come and
//! go, and b + c then be next to nothing. So the bound is kept: without it particles of dust at 3 m/s left a neighbour at 600 to 1800.

use super::Pair;
use crate::math::lanes::{LANES, Lanes, Width, width};
use crate::math::{Sym, Vec3};

/// xx yy zz xy xz yz of eight particles.
pub type Syms = [[f64; LANES]; 6];

/// w, Pa, of eight particles with these stresses and M; in 2D along z. Zero where M is degenerate.
pub fn axials<const D: usize>(s: &Syms, m: &Syms) -> [Vec3; LANES] {
    // SAFETY: `width` names only what the processor has.
    unsafe {
        match width() {
            Width::Portable => each::<D>(s, m),
            Width::Avx2 => each_avx2::<D>(s, m),
            Width::Avx512 => each_avx512::<D>(s, m),
        }
    }
}

#[target_feature(enable = "avx2")]
unsafe fn each_avx2<const D: usize>(s: &Syms, m: &Syms) -> [Vec3; LANES] {
    each::<D>(s, m)
}

#[target_feature(enable = "avx512f,avx512vl,avx2")]
unsafe fn each_avx512<const D: usize>(s: &Syms, m: &Syms) -> [Vec3; LANES] {
    each::<D>(s, m)
}

/// A loop that the compiler vectorises, with the same bits.
#[inline(always)]
fn each<const D: usize>(s: &Syms, m: &Syms) -> [Vec3; LANES] {
    let at = |t: &Syms, k: usize| Sym { xx: t[0][k], yy: t[1][k], zz: t[2][k], xy: t[3][k], xz: t[4][k], yz: t[5][k] };
    let mut w = [[0.0; LANES]; 3];
    for k in 0..LANES {
        let one = axial::<D>(&at(s, k), &at(m, k));
        (w[0][k], w[1][k], w[2][k]) = (one.x, one.y, one.z);
    }
    std::array::from_fn(|k| Vec3::new(w[0][k], w[1][k], w[2][k]))
}

/// w, Pa, of a particle with this stress and M. In 2D along z, and only xx, yy, xy count. Zero where M is degenerate.
#[inline(always)]
fn axial<const D: usize>(s: &Sym, m: &Sym) -> Vec3 {
    if D == 2 {
        let trace = m.xx + m.yy;
        let product = |a: &Sym, b: &Sym| (a.xy * b.xx + a.yy * b.xy) - (a.xx * b.xy + a.xy * b.yy);
        let w = Vec3::new(0.0, 0.0, if trace > 0.0 { product(m, s) / trace } else { 0.0 });
        return bounded(w, 0.25 * (s.xx - s.yy) * (s.xx - s.yy) + s.xy * s.xy);
    }
    // a(M sigma), of which only the part that is not symmetric counts.
    let a = Vec3::new(
        (m.xz * s.xy + m.yz * s.yy + m.zz * s.yz) - (m.xy * s.xz + m.yy * s.yz + m.yz * s.zz),
        (m.xx * s.xz + m.xy * s.yz + m.xz * s.zz) - (m.xz * s.xx + m.yz * s.xy + m.zz * s.xz),
        (m.xy * s.xx + m.yy * s.xy + m.yz * s.xz) - (m.xx * s.xy + m.xy * s.yy + m.xz * s.yz),
    );
    let n = Sym { xx: m.yy + m.zz, yy: m.xx + m.zz, zz: m.xx + m.yy, xy: -m.xy, xz: -m.xz, yz: -m.yz };
    let normal = (s.xx - s.yy) * (s.xx - s.yy) + (s.yy - s.zz) * (s.yy - s.zz) + (s.zz - s.xx) * (s.zz - s.xx);
    bounded(solved(&n, &a), normal / 6.0 + (s.xy * s.xy + s.xz * s.xz + s.yz * s.yz))
}

/// w, no longer than the root of `most`.
#[inline(always)]
fn bounded(w: Vec3, most: f64) -> Vec3 {
    let square = w.x * w.x + w.y * w.y + w.z * w.z;
    w * if square > most { (most / square).sqrt() } else { 1.0 }
}

/// x of n x = a by Cramer's rule; zero where n is singular.
#[inline(always)]
fn solved(n: &Sym, a: &Vec3) -> Vec3 {
    let c = n.cofactors();
    let det = n.determinant(&c);
    // Neighbours on one line leave an eigenvalue of n without meaning.
    let trace = n.trace();
    let f = if det < LEAST * (trace * trace * trace) || det <= 0.0 { 0.0 } else { 1.0 / det };
    Vec3::new(
        c.xx * a.x + c.xy * a.y + c.xz * a.z,
        c.xy * a.x + c.yy * a.y + c.yz * a.z,
        c.xz * a.x + c.yz * a.y + c.zz * a.z,
    ) * f
}

/// Least determinant over the cube of the trace; 1/27 in uniform matter.
const LEAST: f64 = 1e-4;

/// W : L, W/m^3, for the uncorrected gradient L, row by row.
pub fn heating<const D: usize>(w: &[f64], l: &[f64]) -> f64 {
    if D == 2 {
        return w[0] * (l[2] - l[1]);
    }
    w[0] * (l[7] - l[5]) + w[1] * (l[2] - l[6]) + w[2] * (l[3] - l[1])
}

/// Adds (w_i + w_j) x g to `force`; `i` and `j` hold w: z alone in 2D.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
pub unsafe fn add_force<L: Lanes, const D: usize>(i: &[L], j: &[L], pair: &Pair<L, D>, force: &mut [L; D]) {
    unsafe {
        let g = &pair.gradient;
        if D == 2 {
            let w = i[0].add(j[0]);
            force[0] = w.fnma(g[1], force[0]);
            force[1] = w.fma(g[0], force[1]);
        } else {
            let (x, y, z) = (i[0].add(j[0]), i[1].add(j[1]), i[2].add(j[2]));
            force[0] = z.fnma(g[1], y.fma(g[2], force[0]));
            force[1] = x.fnma(g[2], z.fma(g[0], force[1]));
            force[2] = y.fnma(g[0], x.fma(g[1], force[2]));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Mat3;
    use crate::random::uniform;

    /// Vectors give what single particles give.
    #[test]
    fn eight_at_once() {
        let columns = |seed: u64, low: f64| -> Syms {
            let each: [Sym; LANES] = std::array::from_fn(|k| any(seed + k as u64, low));
            [
                each.map(|t| t.xx),
                each.map(|t| t.yy),
                each.map(|t| t.zz),
                each.map(|t| t.xy),
                each.map(|t| t.xz),
                each.map(|t| t.yz),
            ]
        };
        let (s, m) = (columns(3, -0.5), columns(50, 0.0));
        let (space, plane) = (axials::<3>(&s, &m), axials::<2>(&s, &m));
        for k in 0..LANES as u64 {
            let (s, m) = (any(3 + k, -0.5), any(50 + k, 0.0));
            assert_eq!(space[k as usize], axial::<3>(&s, &m));
            assert_eq!(plane[k as usize], axial::<2>(&s, &m));
        }
    }

    /// Where M cannot be one of neighbours, as two evaluations extrapolated may give it, w is no larger than the shear; where it can,
    /// the bound is never met, and (sigma + W) M is symmetric.
    #[test]
    fn no_moment_makes_more_than_the_shear() {
        let mut met = 0;
        for k in 0..20_000 {
            let (s, mut m) = (any(3 * k, -0.5), any(3 * k + 1, -0.5));
            let mean = s.trace() / 3.0;
            let shear = s.xx * s.xx + s.yy * s.yy + s.zz * s.zz - 3.0 * mean * mean;
            let shear = (0.5 * shear + s.xy * s.xy + s.xz * s.xz + s.yz * s.yz).sqrt();
            let w = axial::<3>(&s, &m);
            assert!(w.norm() <= shear * (1.0 + 1e-12), "{s:?} {m:?}: {w:?}");
            met += usize::from(w.norm() > shear * (1.0 - 1e-12));
            let plane = axial::<2>(&s, &m).norm();
            assert!(plane <= (0.25 * (s.xx - s.yy).powi(2) + s.xy * s.xy).sqrt() * (1.0 + 1e-12), "{s:?} {m:?}");
            // The square of any matrix is the moment of some neighbours.
            let root = m.to_matrix();
            m = Sym::symmetric_part(&(root * root));
            let w = axial::<3>(&s, &m);
            let product = (s.to_matrix() + cross(&w)) * m.to_matrix();
            if w != Vec3::zeros() {
                assert!((product - product.transpose()).norm() < 1e-9 * shear * m.to_matrix().norm(), "{w:?}");
            }
        }
        assert!(met > 200, "{met}");
    }

    fn any(seed: u64, low: f64) -> Sym {
        let d = |k: u64| uniform(seed, k, 0);
        Sym { xx: low + d(0), yy: low + d(1), zz: low + d(2), xy: d(3) - 0.5, xz: d(4) - 0.5, yz: d(5) - 0.5 }
    }

    fn cross(w: &Vec3) -> Mat3 {
        Mat3::new(0.0, -w.z, w.y, w.z, 0.0, -w.x, -w.y, w.x, 0.0)
    }

    /// (sigma + W) M is symmetric, rigid rotation does no work, and uniform neighbourhoods need no W.
    #[test]
    fn no_torque_is_left() {
        for seed in 0..50 {
            let (s, m) = (any(seed, -0.5), any(seed + 1000, 1.5));
            let w = axial::<3>(&s, &m);
            let t = s.to_matrix() + cross(&w);
            let left = t * m.to_matrix();
            assert!((left - left.transpose()).norm() < 1e-14, "{left}");
            let l = cross(&Vec3::new(0.3, -0.2, 0.7)) * m.to_matrix();
            let rows: Vec<f64> = (0..9).map(|k| l[(k / 3, k % 3)]).collect();
            let work = s.to_matrix().component_mul(&l).sum() + heating::<3>(w.as_slice(), &rows);
            assert!(work.abs() < 1e-14, "{work}");
            let plane = |t: &Sym| Sym { zz: 0.0, xz: 0.0, yz: 0.0, ..*t };
            let (s, m) = (plane(&s), plane(&m));
            let w = axial::<2>(&s, &m);
            let left = (s.to_matrix() + cross(&w)) * m.to_matrix();
            assert!((left - left.transpose()).norm() < 1e-14, "{left}");
            let l = cross(&Vec3::z()) * m.to_matrix();
            let rows = [l[(0, 0)], l[(0, 1)], l[(1, 0)], l[(1, 1)]];
            let work = s.to_matrix().component_mul(&l).sum() + heating::<2>(&[w.z], &rows);
            assert!(work.abs() < 1e-14, "{work}");
        }
        let even = Sym { xx: 0.9, yy: 0.9, zz: 0.9, ..Sym::ZERO };
        assert_eq!(axial::<3>(&any(1, 0.0), &even), Vec3::zeros());
        for few in [Sym::ZERO, Sym { xx: 1.0, ..Sym::ZERO }] {
            assert!(axial::<3>(&any(1, 0.0), &few).norm() <= 2.0 * any(1, 0.0).to_matrix().norm());
        }
    }
}
