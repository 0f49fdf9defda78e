//! The pair loop: for each row (an owned particle and its neighbours) the sums of all terms, in one pass over the records.
//! Neighbour k of a row stands on lane k mod 8; lanes are folded in one fixed order. Rows are padded with a record that
//! adds exact zeros.

use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};

use super::Pair;
use super::artificial_stress;
use super::contrast;
use super::record::{Layout, Terms, Viscosity};
use super::stress::{PairStress, add_pressure_force};
use super::torque;
use super::viscosity::{Inputs, viscous};
use crate::kernel::Shape;
use crate::math::lanes::{LANES, Lanes};

/// Sums of one row. Not yet divided by the density of the row's particle.
#[derive(Debug, Clone, Copy, Default)]
pub struct RowSums {
    /// Sum of V_j (sigma_i + sigma_j - p_ij) . gW: D numbers, N/m^3.
    pub force: [f64; 3],
    /// L_i, row by row: D x D numbers, 1/s.
    pub gradient: [f64; 9],
    /// M_i: xx yy zz xy xz yz, or xx yy xy in 2D.
    pub moment: [f64; 6],
    /// Sum of V_j (p_ij v_ij . gW - f^4 v_ij . R_ij . gW), W/m^3.
    pub dissipation: f64,
    /// Largest |mu| of approach, m/s.
    pub approach: f64,
    /// Neighbours inside the larger support.
    pub neighbours: u32,
}

/// What the loop reads.
#[derive(Clone, Copy)]
pub struct Rows<'a> {
    /// Records in slot order, the padding record last; `Layout::stride` numbers each.
    pub records: &'a [f64],
    /// Entries of row i: `entries[offsets[i]..offsets[i + 1]]`, slots, a multiple of eight.
    pub offsets: &'a [usize],
    pub entries: &'a [u32],
    /// Slot of each owned particle.
    pub slots: &'a [u32],
}

/// Numbers that are the same for all pairs of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants {
    /// beta of viscosity, where all materials share it.
    pub beta: f64,
    /// 1 / W(spacing) of the artificial stress, see [`artificial_stress::reference`].
    pub artificial_reference: f64,
}

/// The shape of the loop as constants, so that an absent term leaves no instruction.
pub trait Form: Copy {
    const D: usize;
    const TERMS: Terms;
    type Kernel: Shape;
    const LAYOUT: Layout = Layout { dimension: Self::D, terms: Self::TERMS };
}

/// Sums in the order in which they are folded: force, gradient, moment, dissipation.
const MOST_SUMS: usize = 24;

/// Rows from the one at work to the one whose neighbours are fetched: two cells or so.
const AHEAD: usize = 32;

/// Rows that share the fetching.
const SHARES: usize = 8;

struct Sums<L: Lanes> {
    folded: [L; MOST_SUMS],
    approach: L,
    neighbours: u32,
}

/// One record on all lanes, or eight records.
struct Side<L: Lanes> {
    words: [L; 24],
}

impl<L: Lanes> Side<L> {
    #[inline(always)]
    fn at(&self, k: usize) -> L {
        self.words[k]
    }

    /// A number of 32 bits.
    ///
    /// # Safety
    /// As for [`Lanes`].
    #[inline(always)]
    unsafe fn half(&self, k: usize) -> L {
        unsafe { self.words[k / 2].half(k % 2 == 1) }
    }

    /// `N` of them, the first `count` from `from` on.
    ///
    /// # Safety
    /// As for [`Lanes`].
    #[inline(always)]
    unsafe fn halves<const N: usize>(&self, from: usize, count: usize) -> [L; N] {
        unsafe {
            let mut numbers = [L::splat(0.0); N];
            for k in 0..count {
                numbers[k] = self.half(from + k);
            }
            numbers
        }
    }

    #[inline(always)]
    fn stress<F: Form>(&self, from: usize) -> [L; 6] {
        let mut s = [self.words[from]; 6];
        let words = F::LAYOUT.tensor_words();
        s[..words].copy_from_slice(&self.words[from..from + words]);
        s
    }
}

/// Rows `range` of the loop; `out[k]` receives row `range.start + k`.
///
/// # Safety
/// As for [`Lanes`]; every entry must be a slot of `rows.records`.
#[inline(always)]
pub unsafe fn sum_rows<L: Lanes, F: Form, const D: usize>(
    rows: &Rows,
    constants: &Constants,
    range: std::ops::Range<usize>,
    out: &mut [RowSums],
) {
    unsafe {
        let stride = F::LAYOUT.stride();
        let base = rows.records.as_ptr();
        let norm = L::splat(0.5 * F::Kernel::normalisation::<D>());
        let fixed = [norm, L::splat(constants.artificial_reference), L::splat(constants.beta)];
        for (row, sums_out) in range.zip(out) {
            let mine = &rows.records[rows.slots[row] as usize * stride..][..stride];
            let mut i = Side { words: [L::splat(0.0); 24] };
            for k in 0..F::LAYOUT.words() {
                i.words[k] = L::splat(mine[k]);
            }
            let mut sums = Sums { folded: [L::splat(0.0); MOST_SUMS], approach: L::splat(0.0), neighbours: 0 };
            fetch_ahead(rows, row, stride);
            for eight in rows.entries[rows.offsets[row]..rows.offsets[row + 1]].chunks_exact(LANES) {
                let mut offsets = [0; LANES];
                for k in 0..LANES {
                    offsets[k] = eight[k] as usize * stride;
                }
                let mut j = Side { words: [L::splat(0.0); 24] };
                for quad in 0..F::LAYOUT.words().div_ceil(4) {
                    let four = L::read_quad(base.add(4 * quad), &offsets);
                    j.words[4 * quad..4 * quad + 4].copy_from_slice(&four);
                }
                interact::<L, F, D>(&i, &j, fixed, &mut sums);
            }
            *sums_out = fold::<L, F, D>(&sums);
        }
    }
}

/// Asks for records that rows to come will read: rows that follow each other have nearly the same neighbours, so that each asks
/// for its share of those of one row ahead.
#[inline(always)]
fn fetch_ahead(rows: &Rows, row: usize, stride: usize) {
    let Some(&[start, end]) = rows.offsets.get(row + AHEAD..).and_then(|ends| ends.first_chunk()) else { return };
    for &slot in rows.entries[start..end].iter().skip(row % SHARES).step_by(SHARES) {
        let record = rows.records.as_ptr().wrapping_add(slot as usize * stride);
        for line in 0..stride / 8 {
            // SAFETY: fetching reads nothing, wherever the address leads.
            unsafe { _mm_prefetch::<_MM_HINT_T0>(record.wrapping_add(8 * line).cast()) };
        }
    }
}

/// Every term of one set of eight pairs.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
unsafe fn interact<L: Lanes, F: Form, const D: usize>(i: &Side<L>, j: &Side<L>, fixed: [L; 3], sums: &mut Sums<L>) {
    unsafe {
        let [norm, reference, beta] = fixed;
        let layout = F::LAYOUT;
        let mut x = [L::splat(0.0); D];
        let mut v = [L::splat(0.0); D];
        for a in 0..D {
            x[a] = i.at(a).sub(j.at(a));
            v[a] = i.at(D + a).sub(j.at(D + a));
        }
        let (mut r2, mut v_dot_x) = (x[0].mul(x[0]), v[0].mul(x[0]));
        for a in 1..D {
            r2 = x[a].fma(x[a], r2);
            v_dot_x = v[a].fma(x[a], v_dot_x);
        }
        // Coincident particles: the slope's numerator is an exact zero at q = 0, and stays finite.
        r2 = r2.max(L::splat(1e-200));
        let r = r2.sqrt();
        // No kernel of a pair is narrower than two thirds of the other.
        let (g_i, g_j) = (i.half(layout.h_inverse()), j.half(layout.h_inverse()));
        let wide = g_i.min(g_j);
        let narrowest = wide.mul(L::splat(1.5));
        let (g_i, g_j) = (g_i.min(narrowest), g_j.min(narrowest));
        let h_inverse = g_i.add(g_j).mul(L::splat(0.5));
        let inside = r.mul(wide).less(L::splat(crate::kernel::SUPPORT));
        sums.neighbours += L::count(inside);

        let zero = L::splat(0.0);
        let mut pair = Pair { x, v, r, h_inverse, v_dot_x, gradient: x, slope: zero };
        let (r_inverse, mut pressure) = if let Viscosity::Off = F::TERMS.viscosity {
            (L::splat(1.0).div(r), zero)
        } else {
            let own = F::TERMS.viscosity == Viscosity::OwnBeta;
            let beta = if own { i.half(layout.beta()).add(j.half(layout.beta())).mul(L::splat(0.5)) } else { beta };
            let inputs = Inputs {
                density: [i.half(layout.density()), j.half(layout.density())],
                alpha_c: i.half(layout.alpha_c()).add(j.half(layout.alpha_c())),
                beta,
            };
            let out = viscous(&pair, r2, &inputs);
            sums.approach = sums.approach.max(out.approach.keep(inside));
            (out.r_inverse, out.pressure)
        };

        // Mean of both kernels' slopes, times V_j.
        let first = slope::<L, F, D>(r, g_i);
        let like = L::count(g_i.min(g_j).less(g_i.max(g_j))) == 0;
        let slopes = first.add(if like { first } else { slope::<L, F, D>(r, g_j) });
        pair.slope = slopes.mul(norm).mul(j.at(layout.volume())).mul(r_inverse);
        for a in 0..D {
            pair.gradient[a] = pair.slope.mul(x[a]);
        }
        let shares = if F::TERMS.contrast {
            contrast::shares(i.half(layout.density()), j.half(layout.density()))
        } else {
            [zero, zero]
        };
        let straining = if F::TERMS.contrast { contrast::straining(shares[0], &pair) } else { pair.gradient };
        let (force, rest) = sums.folded.split_at_mut(D);
        let force: &mut [L; D] = force.try_into().unwrap_unchecked();
        let mut taken = zero;
        let from = layout.stress();
        if F::TERMS.tensor {
            let (mut s_i, mut s_j) = (i.stress::<F>(from), j.stress::<F>(from));
            if F::TERMS.contrast {
                (s_i, s_j) = (contrast::share_of(shares[0], s_i), contrast::share_of(shares[1], s_j));
            }
            let mut stress = PairStress::<L, D>::sum(&s_i, &s_j);
            if F::TERMS.artificial_stress {
                let (from, words) = (layout.artificial(), layout.tensor_words());
                let r_ij = PairStress::<L, D>::sum(&i.halves(from, words), &j.halves(from, words));
                if F::TERMS.no_torque {
                    let at = (r_inverse, reference);
                    pressure = pressure.sub(artificial_stress::tension::<L, F::Kernel, D>(&pair, at, &r_ij));
                } else {
                    (stress, taken) = artificial_stress::apply::<L, F::Kernel, D>(&pair, reference, &r_ij, stress);
                }
            }
            stress.minus_pressure(pressure).add_force(&pair.gradient, force);
            if F::TERMS.no_torque {
                let (from, words) = (layout.axial(), layout.axial_words());
                let (mut w_i, mut w_j) = (i.halves::<3>(from, words), j.halves::<3>(from, words));
                if F::TERMS.contrast {
                    (w_i, w_j) = (contrast::share_of(shares[0], w_i), contrast::share_of(shares[1], w_j));
                }
                torque::add_force(&w_i, &w_j, &pair, force);
            }
        } else {
            let (mut s_i, mut s_j) = (i.at(from), j.at(from));
            if F::TERMS.contrast {
                (s_i, s_j) = (s_i.mul(shares[0]), s_j.mul(shares[1]));
            }
            add_pressure_force(s_i.add(s_j), pressure, &pair, force);
        }
        for a in 0..D {
            for b in 0..D {
                rest[D * a + b] = v[a].fnma(straining[b], rest[D * a + b]);
            }
        }
        let rest = &mut rest[D * D..];
        let viscous = F::TERMS.viscosity != Viscosity::Off || F::TERMS.artificial_stress;
        if viscous {
            rest[0] = pressure.mul(v_dot_x).sub(taken).fma(pair.slope, rest[0]);
        }
        if F::TERMS.correction {
            let m = &mut rest[1..];
            for a in 0..D {
                m[a] = x[a].fnma(straining[a], m[a]);
            }
            m[D] = x[0].fnma(straining[1], m[D]);
            if D == 3 {
                m[D + 1] = x[0].fnma(straining[2], m[D + 1]);
                m[D + 2] = x[1].fnma(straining[2], m[D + 2]);
            }
        }
    }
}

/// h^-(d+1) times the kernel's slope, from r and 1/h.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
unsafe fn slope<L: Lanes, F: Form, const D: usize>(r: L, g: L) -> L {
    unsafe {
        let g2 = g.mul(g);
        F::Kernel::slope_lanes(r.mul(g)).mul(if D == 2 { g2.mul(g) } else { g2.mul(g2) })
    }
}

/// Sums of one row, from eight lanes to one.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
unsafe fn fold<L: Lanes, F: Form, const D: usize>(sums: &Sums<L>) -> RowSums {
    unsafe {
        let count = D + D * D + 1 + if F::TERMS.correction { F::LAYOUT.tensor_words() } else { 0 };
        let mut flat = [0.0; MOST_SUMS];
        for group in 0..count.div_ceil(8) {
            let mut v = [sums.approach; 8];
            v.copy_from_slice(&sums.folded[8 * group..8 * group + 8]);
            flat[8 * group..8 * group + 8].copy_from_slice(&L::fold(v));
        }
        let mut out = RowSums { approach: sums.approach.fold_max(), neighbours: sums.neighbours, ..RowSums::default() };
        out.force[..D].copy_from_slice(&flat[..D]);
        out.gradient[..D * D].copy_from_slice(&flat[D..D + D * D]);
        out.dissipation = flat[D + D * D];
        out.moment.copy_from_slice(&flat[D + D * D + 1..D + D * D + 7]);
        out
    }
}
