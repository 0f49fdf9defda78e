//! The distance filter: which of a cell's candidates lie within the larger list radius of one particle. Three widths, one
//! answer: the squared distance is made of plain products and sums in the order of the dimensions, never fused.
//!
//! The widest one compares in single precision first, relative to a point nearby: only where rounding could change the answer,
//! about once in a thousand rows, it does the same as the others.

use std::arch::x86_64::*;
use std::ops::Range;

use crate::math::lanes::Width;
use crate::particles::Local;

/// Candidates come in whole groups of this many.
const GROUP: usize = 16;

/// The particles against which those of one cell must be tested, gathered from the local set.
#[derive(Debug)]
pub struct Candidates<const D: usize> {
    position: [Vec<f64>; D],
    radius_squared: Vec<f64>,
    slots: Vec<u32>,
    /// Positions relative to `origin`.
    rough_position: [Vec<f32>; D],
    rough_radius_squared: Vec<f32>,
    origin: [f64; D],
    /// Rough squared distances and radii squared are together wrong by less than this.
    doubt: f32,
    /// Any of them is a ghost.
    pub ghosts: bool,
}

impl<const D: usize> Default for Candidates<D> {
    fn default() -> Self {
        Self {
            position: std::array::from_fn(|_| Vec::new()),
            radius_squared: Vec::new(),
            slots: Vec::new(),
            rough_position: std::array::from_fn(|_| Vec::new()),
            rough_radius_squared: Vec::new(),
            origin: [0.0; D],
            doubt: 0.0,
            ghosts: false,
        }
    }
}

/// The particle whose neighbours are sought.
#[derive(Debug, Clone, Copy)]
pub struct Centre<const D: usize> {
    pub slot: u32,
    pub position: [f64; D],
    pub radius_squared: f64,
}

impl<const D: usize> Candidates<D> {
    pub fn clear(&mut self) {
        self.position.iter_mut().for_each(Vec::clear);
        self.radius_squared.clear();
        self.slots.clear();
        self.ghosts = false;
    }

    pub fn push(&mut self, local: &Local<D>, slots: Range<usize>) {
        for (mine, all) in self.position.iter_mut().zip(&local.position) {
            mine.extend_from_slice(&all[slots.clone()]);
        }
        self.radius_squared.extend_from_slice(&local.radius_squared[slots.clone()]);
        self.ghosts |= local.is_ghost[slots.clone()].contains(&true);
        self.slots.extend(slots.start as u32..slots.end as u32);
    }

    /// Fills the last group with candidates that are near nothing. `origin`: a point near the particles whose neighbours are
    /// sought.
    pub fn close(&mut self, width: Width, origin: [f64; D]) {
        let count = self.slots.len();
        let len = count.next_multiple_of(GROUP);
        self.position.iter_mut().for_each(|x| x.resize(len, f64::NAN));
        self.radius_squared.resize(len, 0.0);
        self.slots.resize(len, u32::MAX);
        if width == Width::Avx512 {
            // SAFETY: this width is chosen only where the processor has it.
            unsafe { self.make_rough(origin) };
            self.rough_position.iter_mut().for_each(|x| x[count..].fill(f32::INFINITY));
        }
    }

    /// Single precision for all candidates. With coordinates up to M from the origin, each rounded once, and radii up to L, a
    /// difference of coordinates is wrong by less than (2 M + L) u, u = 2^-24, and the square of a distance near L by less
    /// than D^1/2 2 L (2 M + L) u and some L^2 u.
    ///
    /// # Safety
    /// The processor has AVX-512F.
    #[target_feature(enable = "avx512f")]
    unsafe fn make_rough(&mut self, origin: [f64; D]) {
        self.origin = origin;
        let mut farthest = 0.0;
        for k in 0..D {
            farthest = larger(farthest, round(&self.position[k], origin[k], &mut self.rough_position[k]));
        }
        let largest = round(&self.radius_squared, 0.0, &mut self.rough_radius_squared);
        self.doubt = (8.0 * f32::EPSILON as f64 * (largest.sqrt() * farthest + largest)) as f32;
    }

    /// Appends to `out` the slots of all candidates but the centre nearer than the larger list radius, in their order.
    pub fn filter(&self, width: Width, centre: &Centre<D>, out: &mut Vec<u32>) {
        let len = self.slots.len();
        debug_assert_eq!(len % GROUP, 0);
        out.reserve(len + GROUP);
        let start = out.len();
        // SAFETY: there is room for all candidates and one group more behind `start`; the widths wider than `Portable` are
        // chosen only where the processor has them; every element up to the count returned has been written.
        unsafe {
            let to = out.as_mut_ptr().add(start);
            let found = match width {
                Width::Portable => self.filter_portable(centre, to),
                Width::Avx2 => self.filter_avx2(centre, to),
                Width::Avx512 => self.filter_avx512(centre, to),
            };
            out.set_len(start + found);
        }
    }

    /// # Safety
    /// `to` has room for as many slots as there are candidates.
    unsafe fn filter_portable(&self, centre: &Centre<D>, to: *mut u32) -> usize {
        let mut found = 0;
        for (k, &slot) in self.slots.iter().enumerate() {
            let mut r_squared = 0.0;
            for d in 0..D {
                let x = centre.position[d] - self.position[d][k];
                r_squared += x * x;
            }
            // SAFETY: `found <= k`.
            unsafe { *to.add(found) = slot };
            let near = r_squared < centre.radius_squared.max(self.radius_squared[k]);
            found += (near & (slot != centre.slot)) as usize;
        }
        found
    }

    /// # Safety
    /// `to` has room for as many slots as there are candidates and a group more; the processor has AVX2.
    #[target_feature(enable = "avx2")]
    unsafe fn filter_avx2(&self, centre: &Centre<D>, to: *mut u32) -> usize {
        let radius_squared = _mm256_set1_pd(centre.radius_squared);
        let me = _mm_set1_epi32(centre.slot as i32);
        let mut found = 0;
        for k in (0..self.slots.len()).step_by(4) {
            // SAFETY: all arrays hold whole groups; four slots are written at `found <= k`.
            unsafe {
                let mut r_squared = _mm256_setzero_pd();
                for d in 0..D {
                    let x = _mm256_sub_pd(
                        _mm256_set1_pd(centre.position[d]),
                        _mm256_loadu_pd(self.position[d].as_ptr().add(k)),
                    );
                    r_squared = _mm256_add_pd(r_squared, _mm256_mul_pd(x, x));
                }
                let limit = _mm256_max_pd(radius_squared, _mm256_loadu_pd(self.radius_squared.as_ptr().add(k)));
                let near = _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LT_OQ>(r_squared, limit));
                let slots = _mm_loadu_si128(self.slots.as_ptr().add(k).cast());
                let myself = _mm_movemask_ps(_mm_castsi128_ps(_mm_cmpeq_epi32(slots, me)));
                let keep = near & !myself;
                let order = _mm_loadu_si128(COMPRESS[keep as usize].as_ptr().cast());
                _mm_storeu_si128(to.add(found).cast(), _mm_shuffle_epi8(slots, order));
                found += keep.count_ones() as usize;
            }
        }
        found
    }

    /// # Safety
    /// `to` has room for as many slots as there are candidates and a group more; the processor has AVX-512F.
    #[target_feature(enable = "avx512f")]
    unsafe fn filter_avx512(&self, centre: &Centre<D>, to: *mut u32) -> usize {
        let rough: [__m512; D] = std::array::from_fn(|d| _mm512_set1_ps((centre.position[d] - self.origin[d]) as f32));
        let rough_radius_squared = _mm512_set1_ps(centre.radius_squared as f32);
        let (above, below) = (_mm512_set1_ps(self.doubt), _mm512_set1_ps(-self.doubt));
        let me = _mm512_set1_epi32(centre.slot as i32);
        let mut found = 0;
        for k in (0..self.slots.len()).step_by(GROUP) {
            // SAFETY: all arrays hold whole groups; sixteen slots are written at `found <= k`.
            unsafe {
                let mut r_squared = _mm512_setzero_ps();
                for d in 0..D {
                    let x = _mm512_sub_ps(rough[d], _mm512_loadu_ps(self.rough_position[d].as_ptr().add(k)));
                    r_squared = _mm512_fmadd_ps(x, x, r_squared);
                }
                let theirs = _mm512_loadu_ps(self.rough_radius_squared.as_ptr().add(k));
                let beyond = _mm512_sub_ps(r_squared, _mm512_max_ps(rough_radius_squared, theirs));
                let mut near = _mm512_cmp_ps_mask::<_CMP_LT_OQ>(beyond, below);
                // Values that are not finite are doubtful, too.
                if near != _mm512_cmp_ps_mask::<_CMP_NGE_UQ>(beyond, above) {
                    near = self.near_avx512(centre, k);
                }
                let slots = _mm512_loadu_si512(self.slots.as_ptr().add(k).cast());
                let keep = _mm512_mask_cmpneq_epi32_mask(near, slots, me);
                // Compressed in the register: compressing stores are slow on some processors.
                _mm512_storeu_si512(to.add(found).cast(), _mm512_maskz_compress_epi32(keep, slots));
                found += keep.count_ones() as usize;
            }
        }
        found
    }

    /// Which of the group from candidate `k` on are near, in full precision.
    ///
    /// # Safety
    /// A whole group follows `k`; the processor has AVX-512F.
    #[cold]
    #[target_feature(enable = "avx512f")]
    unsafe fn near_avx512(&self, centre: &Centre<D>, k: usize) -> u16 {
        let radius_squared = _mm512_set1_pd(centre.radius_squared);
        let mut near = 0;
        for half in 0..2 {
            let at = k + 8 * half;
            // SAFETY: all arrays hold whole groups.
            unsafe {
                let mut r_squared = _mm512_setzero_pd();
                for d in 0..D {
                    let x = _mm512_sub_pd(
                        _mm512_set1_pd(centre.position[d]),
                        _mm512_loadu_pd(self.position[d].as_ptr().add(at)),
                    );
                    r_squared = _mm512_add_pd(r_squared, _mm512_mul_pd(x, x));
                }
                let limit = _mm512_max_pd(radius_squared, _mm512_loadu_pd(self.radius_squared.as_ptr().add(at)));
                near |= (_mm512_cmp_pd_mask::<_CMP_LT_OQ>(r_squared, limit) as u16) << (8 * half);
            }
        }
        near
    }
}

/// Whole groups of numbers less the origin, in single precision; returns the largest modulus, NaN excluded.
#[inline(always)]
fn round(numbers: &[f64], origin: f64, rounded: &mut Vec<f32>) -> f64 {
    rounded.resize(numbers.len(), 0.0);
    let mut largest = [0.0; 8];
    for (eight, to) in numbers.as_chunks::<8>().0.iter().zip(rounded.as_chunks_mut::<8>().0) {
        for lane in 0..8 {
            let x = eight[lane] - origin;
            largest[lane] = larger(largest[lane], x.abs());
            to[lane] = x as f32;
        }
    }
    largest.into_iter().fold(0.0, larger)
}

/// The maximum as one instruction; `b` may be NaN.
#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// Byte shuffles that bring the 32-bit lanes of a mask to the front.
static COMPRESS: [[u8; 16]; 16] = {
    let mut table = [[0x80; 16]; 16];
    let mut mask = 0;
    while mask < 16 {
        let (mut lane, mut to) = (0, 0);
        while lane < 4 {
            if mask >> lane & 1 == 1 {
                let mut byte = 0;
                while byte < 4 {
                    table[mask][4 * to + byte] = (4 * lane + byte) as u8;
                    byte += 1;
                }
                to += 1;
            }
            lane += 1;
        }
        mask += 1;
    }
    table
};
