//! The pair loop: for each row (an owned particle and its neighbours) the sums of all terms, in one pass over the records.
//! Neighbour k of a row is on lane k mod 8; lanes are folded in one fixed order. Rows are padded with a record that
//! adds exact zeros.

use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};

use super::interact::{Fixed, Form, Side, Sums, interact};
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
    /// Sum of V_j W over particles of rigid bodies that do not adhere.
    pub fill: f64,
    /// Its rate, the sum of V_j v_ij . gW over these, 1/s.
    pub filling: f64,
    /// Largest |mu| of approach, m/s.
    pub approach: f64,
    /// Neighbours inside the larger support.
    pub neighbours: u32,
}

/// The input of the loop.
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
    /// 1 / W(spacing) of the artificial stress, see [`reference`](super::artificial_stress::reference).
    pub artificial_reference: f64,
}

/// Sums of a row at most: force, gradient, dissipation, moment and contact, in groups of eight.
const MOST_SUMS: usize = 24;

/// Rows from the one at work to the one whose neighbours are fetched: two cells or so.
const AHEAD: usize = 32;

/// Rows that share the fetching.
const SHARES: usize = 8;

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
        let fixed = Fixed {
            norm: L::splat(0.5 * F::Kernel::normalisation::<D>()),
            reference: L::splat(constants.artificial_reference),
            beta: L::splat(constants.beta),
        };
        for (row, sums_out) in range.zip(out) {
            let mine = &rows.records[rows.slots[row] as usize * stride..][..stride];
            let mut i = Side { words: [L::splat(0.0); 24] };
            for k in 0..F::LAYOUT.words() {
                i.words[k] = L::splat(mine[k]);
            }
            let mut sums = Sums::<L, D>::zero();
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
                interact::<L, F, D>(&i, &j, &fixed, &mut sums);
            }
            *sums_out = fold::<L, F, D>(&sums);
        }
    }
}

/// Prefetches records that later rows will read: consecutive rows have nearly the same neighbours, so that each fetches
/// its share of those of one row ahead.
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

/// Sums of one row, from eight lanes to one.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
unsafe fn fold<L: Lanes, F: Form, const D: usize>(sums: &Sums<L, D>) -> RowSums {
    unsafe {
        let mut lanes = [sums.dissipation; MOST_SUMS];
        lanes[..D].copy_from_slice(&sums.force);
        lanes[D..D + D * D].copy_from_slice(sums.gradient.as_flattened());
        lanes[D + D * D + 1..D + D * D + 7].copy_from_slice(&sums.moment);
        let contact = D + D * D + 7;
        lanes[contact..contact + 2].copy_from_slice(&[sums.fill, sums.filling]);
        let count = match (F::TERMS.contrast(), F::TERMS.corrects()) {
            (true, _) => contact + 2,
            (false, true) => D + D * D + 1 + F::LAYOUT.tensor_words(),
            (false, false) => D + D * D + 1,
        };
        let mut flat = [0.0; MOST_SUMS];
        for group in 0..count.div_ceil(8) {
            let mut v = [sums.dissipation; 8];
            v.copy_from_slice(&lanes[8 * group..8 * group + 8]);
            flat[8 * group..8 * group + 8].copy_from_slice(&L::fold(v));
        }
        let mut out = RowSums { approach: sums.approach.fold_max(), neighbours: sums.neighbours, ..RowSums::default() };
        out.force[..D].copy_from_slice(&flat[..D]);
        out.gradient[..D * D].copy_from_slice(&flat[D..D + D * D]);
        out.dissipation = flat[D + D * D];
        out.moment.copy_from_slice(&flat[D + D * D + 1..contact]);
        [out.fill, out.filling] = [flat[contact], flat[contact + 1]];
        out
    }
}
