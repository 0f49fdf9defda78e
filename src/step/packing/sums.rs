//! Sums over a row of neighbours that tell how densely particles lie. Inside matter
//!
//! ```text
//! S_i = sum_j V_j W_ij     V = m / rho     is 1 where density is mass over volume,
//! ```
//! of whatever materials and spacings: 2 where particles are twice as dense as their densities. A particle is inside where it has
//! at least half of the surrounding matter that it has in its lattice, evenly distributed:
//!
//! ```text
//! C_i = sum_j v_j W_ij >= 1/2     |sum_j v_j (x_j - x_i) W_ij| <= h C_i / 10     v = (h / eta)^d
//! ```
//! Spray and surfaces, where S is meaningless, thus do not count. W is the cubic spline whatever the scene's kernel: any would do.
//! The sums run over the lists and records of an evaluation.

use crate::kernel::{CubicSpline, Shape};
use crate::math::lanes::{Avx2, Avx512, LANES, Lanes, Portable, Width, width};
use crate::pair::record::half;
use crate::pair::{Layout, Rows};

pub const LEAST_COVER: f64 = 0.5;
const MOST_SHIFT: f64 = 0.1;

/// Sums over a row of neighbours.
#[derive(Debug, Clone, Copy, Default)]
pub struct Sums {
    /// S.
    pub packing: f64,
    /// C.
    pub cover: f64,
    /// Modulus of the first moment of C, over h.
    pub shift: f64,
}

impl Sums {
    pub fn is_inside(&self) -> bool {
        self.cover >= LEAST_COVER && self.shift <= MOST_SHIFT * self.cover
    }

    /// ln S of a particle inside matter. Where S is too large particles are too close, whatever is around. Where it is too small that may
    /// be for want of neighbours: near a surface the sum misses matter, and its first moment tells how much at most.
    pub fn off(&self) -> f64 {
        let off = libm::log(self.packing);
        if off >= 0.0 { off } else { (off + libm::log1p(self.shift / self.cover)).min(0.0) }
    }
}

/// Lists and records of an evaluation.
pub struct Neighbours<'a, const D: usize> {
    rows: &'a Rows<'a>,
    layout: &'a Layout,
    eta: f64,
    width: Width,
}

impl<'a, const D: usize> Neighbours<'a, D> {
    pub fn new(rows: &'a Rows, layout: &'a Layout, eta: f64) -> Self {
        Self { rows, layout, eta, width: width() }
    }

    /// Sums of row `i`; zero where its record has not been made.
    pub fn sums(&self, i: usize) -> Sums {
        // SAFETY: the width is that of this processor; lists hold slots of the records that they were built for.
        unsafe {
            match self.width {
                Width::Portable => portable(self, i),
                Width::Avx2 => avx2(self, i),
                Width::Avx512 => avx512(self, i),
            }
        }
    }

    /// # Safety
    /// As for [`Lanes`].
    #[inline(always)]
    unsafe fn row<L: Lanes>(&self, i: usize) -> Sums {
        let (rows, layout, stride) = (self.rows, self.layout, self.layout.stride());
        let own = &rows.records[rows.slots[i] as usize * stride..][..layout.words()];
        let g_i = half(own, layout.h_inverse());
        if g_i == 0.0 {
            return Sums::default();
        }
        let base = rows.records.as_ptr();
        let (volume, inverse) = (layout.volume(), layout.h_inverse() / 2);
        // SAFETY: the caller's; four numbers lie behind a multiple of four within a record.
        let [packing, cover, shift @ ..] = unsafe {
            let mut all = [L::splat(0.0); 8];
            for eight in rows.entries[rows.offsets[i]..rows.offsets[i + 1]].chunks_exact(LANES) {
                let mut offsets = [0; LANES];
                for k in 0..LANES {
                    offsets[k] = eight[k] as usize * stride;
                }
                let place = L::read_quad(base, &offsets);
                let volumes = L::read_quad(base.add(volume / 4 * 4), &offsets)[volume % 4];
                let inverses = L::read_quad(base.add(inverse / 4 * 4), &offsets)[inverse % 4];
                let g_j = inverses.half(layout.h_inverse() % 2 == 1);
                let g = g_j.add(L::splat(g_i)).mul(L::splat(0.5));
                let mut x = [L::splat(0.0); D];
                let mut r2 = L::splat(0.0);
                for k in 0..D {
                    x[k] = place[k].sub(L::splat(own[k]));
                    r2 = x[k].fma(x[k], r2);
                }
                let (mut w, mut lattice) = (CubicSpline::value_lanes(r2.sqrt().mul(g)), L::splat(1.0));
                let packed = g_j.mul(L::splat(self.eta));
                for _ in 0..D {
                    w = w.mul(g);
                    lattice = lattice.mul(packed);
                }
                let v = w.div(lattice);
                all[0] = w.fma(volumes, all[0]);
                all[1] = all[1].add(v);
                for k in 0..D {
                    all[2 + k] = v.mul(g).fma(x[k], all[2 + k]);
                }
            }
            L::fold(all)
        };
        let norm = CubicSpline::normalisation::<D>();
        let w_0 = CubicSpline::value(0.0);
        let own_packing = w_0 * g_i.powi(D as i32) * own[volume];
        Sums {
            packing: norm * (packing + own_packing),
            cover: norm * (cover + w_0 * self.eta.powi(-(D as i32))),
            shift: norm * shift[..D].iter().map(|x| x * x).sum::<f64>().sqrt(),
        }
    }
}

unsafe fn portable<const D: usize>(neighbours: &Neighbours<D>, i: usize) -> Sums {
    // SAFETY: the portable lanes need no instruction set.
    unsafe { neighbours.row::<Portable>(i) }
}

#[target_feature(enable = "avx2,fma")]
unsafe fn avx2<const D: usize>(neighbours: &Neighbours<D>, i: usize) -> Sums {
    // SAFETY: the width was chosen for this processor.
    unsafe { neighbours.row::<Avx2>(i) }
}

#[target_feature(enable = "avx512f,avx512vl,avx2,fma,popcnt")]
unsafe fn avx512<const D: usize>(neighbours: &Neighbours<D>, i: usize) -> Sums {
    // SAFETY: the width was chosen for this processor.
    unsafe { neighbours.row::<Avx512>(i) }
}
