//! Eight lanes of f64 on every processor: AVX-512, two halves with AVX2 and FMA, or plain arrays. The three give the same
//! bits: fused multiply-adds everywhere, IEEE division and square root, and one order in which lanes are folded.
//!
//! All methods inline into an entry function that carries the `#[target_feature]`; that function is chosen once per run.

use std::arch::x86_64::*;
use std::sync::OnceLock;

/// Lanes per vector on every instruction set.
pub const LANES: usize = 8;

/// Instruction set of the vector loops.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Width {
    Portable,
    Avx2,
    Avx512,
}

/// The widest set this processor has, or the one `SPH_MPI_SIMD` (portable, avx2, avx512) names if the processor has it.
pub fn width() -> Width {
    static WIDTH: OnceLock<Width> = OnceLock::new();
    *WIDTH.get_or_init(|| {
        let avx2 = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
        let avx512 = avx2 && is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512vl");
        let best = if avx512 {
            Width::Avx512
        } else if avx2 {
            Width::Avx2
        } else {
            Width::Portable
        };
        match requested(&std::env::var(VARIABLE).unwrap_or_default()) {
            Ok(Some(Width::Portable)) => Width::Portable,
            Ok(Some(Width::Avx2)) if avx2 => Width::Avx2,
            Ok(Some(Width::Avx512)) if avx512 => Width::Avx512,
            _ => best,
        }
    })
}

/// Environment variable that requests an instruction set.
pub const VARIABLE: &str = "SPH_MPI_SIMD";

/// What it may say.
pub const SETS: &str = "portable, avx2, avx512";

/// The request of the environment where nobody knows such an instruction set.
pub fn unknown_request() -> Option<String> {
    let request = std::env::var_os(VARIABLE).unwrap_or_default().to_string_lossy().into_owned();
    requested(&request).is_err().then_some(request)
}

/// The instruction set of a name; none for no name.
fn requested(name: &str) -> Result<Option<Width>, ()> {
    match name {
        "" => Ok(None),
        "portable" => Ok(Some(Width::Portable)),
        "avx2" => Ok(Some(Width::Avx2)),
        "avx512" => Ok(Some(Width::Avx512)),
        _ => Err(()),
    }
}

/// Eight lanes.
///
/// # Safety
/// Every method may only run on a processor with the instruction set of the implementing type; `read_quad` further reads
/// four numbers behind each of the eight offsets.
#[allow(clippy::missing_safety_doc)]
pub unsafe trait Lanes: Copy {
    type Mask: Copy;
    unsafe fn splat(x: f64) -> Self;
    unsafe fn add(self, o: Self) -> Self;
    unsafe fn sub(self, o: Self) -> Self;
    unsafe fn mul(self, o: Self) -> Self;
    unsafe fn div(self, o: Self) -> Self;
    unsafe fn sqrt(self) -> Self;
    /// 1 / sqrt(self) as single precision gives it, for numbers that it holds.
    unsafe fn inverse_root_estimate(self) -> Self;
    /// self * b + c with one rounding.
    unsafe fn fma(self, b: Self, c: Self) -> Self;
    /// c - self * b with one rounding.
    unsafe fn fnma(self, b: Self, c: Self) -> Self;
    /// The larger; `o` where either is NaN.
    unsafe fn max(self, o: Self) -> Self;
    unsafe fn min(self, o: Self) -> Self;
    unsafe fn less(self, o: Self) -> Self::Mask;
    unsafe fn count(mask: Self::Mask) -> u32;
    /// Zero where the mask is false.
    unsafe fn keep(self, mask: Self::Mask) -> Self;
    /// `self` where the mask is true, `o` elsewhere.
    unsafe fn or(self, mask: Self::Mask, o: Self) -> Self;
    /// Eight numbers from `at` on.
    unsafe fn read(at: *const f64) -> Self;
    /// Numbers 0..4 behind `base + offsets[lane]`, one vector per number.
    unsafe fn read_quad(base: *const f64, offsets: &[usize; LANES]) -> [Self; 4];
    /// The numbers whose first 32 bits are in the lower or in the upper half of each lane.
    unsafe fn half(self, upper: bool) -> Self;
    /// ((0+1)+(2+3)) + ((4+5)+(6+7)) of each of eight vectors.
    unsafe fn fold(v: [Self; 8]) -> [f64; 8];
    unsafe fn fold_max(self) -> f64;

    /// 1 / sqrt(self) to the last bit or two, for numbers that single precision holds: from an estimate with error e by a step
    /// that leaves e^3.
    #[inline(always)]
    unsafe fn inverse_root(self) -> Self {
        // SAFETY: the caller's.
        unsafe {
            let y = self.inverse_root_estimate();
            let e = self.mul(y).fnma(y, Self::splat(1.0));
            y.mul(e).fma(e.fma(Self::splat(0.375), Self::splat(0.5)), y)
        }
    }
}

/// Bits of the upper half of a lane.
const UPPER: u64 = !0 << 32;

/// Plain arrays.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub struct Portable([f64; LANES]);

macro_rules! each {
    ($i:ident => $e:expr) => {{
        let mut r = [0.0; LANES];
        for $i in 0..LANES {
            r[$i] = $e;
        }
        Portable(r)
    }};
}

// SAFETY: no instruction set is needed; `read_quad` reads what its contract allows.
unsafe impl Lanes for Portable {
    type Mask = [bool; LANES];
    #[inline(always)]
    unsafe fn splat(x: f64) -> Self {
        Portable([x; LANES])
    }
    #[inline(always)]
    unsafe fn add(self, o: Self) -> Self {
        each!(i => self.0[i] + o.0[i])
    }
    #[inline(always)]
    unsafe fn sub(self, o: Self) -> Self {
        each!(i => self.0[i] - o.0[i])
    }
    #[inline(always)]
    unsafe fn mul(self, o: Self) -> Self {
        each!(i => self.0[i] * o.0[i])
    }
    #[inline(always)]
    unsafe fn div(self, o: Self) -> Self {
        each!(i => self.0[i] / o.0[i])
    }
    #[inline(always)]
    unsafe fn sqrt(self) -> Self {
        each!(i => self.0[i].sqrt())
    }
    #[inline(always)]
    unsafe fn inverse_root_estimate(self) -> Self {
        each!(i => f64::from(1.0 / (self.0[i] as f32).sqrt()))
    }
    #[inline(always)]
    unsafe fn fma(self, b: Self, c: Self) -> Self {
        each!(i => self.0[i].mul_add(b.0[i], c.0[i]))
    }
    #[inline(always)]
    unsafe fn fnma(self, b: Self, c: Self) -> Self {
        each!(i => (-self.0[i]).mul_add(b.0[i], c.0[i]))
    }
    #[inline(always)]
    unsafe fn max(self, o: Self) -> Self {
        each!(i => if self.0[i] > o.0[i] { self.0[i] } else { o.0[i] })
    }
    #[inline(always)]
    unsafe fn min(self, o: Self) -> Self {
        each!(i => if self.0[i] < o.0[i] { self.0[i] } else { o.0[i] })
    }
    #[inline(always)]
    unsafe fn less(self, o: Self) -> Self::Mask {
        std::array::from_fn(|i| self.0[i] < o.0[i])
    }
    #[inline(always)]
    unsafe fn count(mask: Self::Mask) -> u32 {
        mask.iter().map(|&b| b as u32).sum()
    }
    #[inline(always)]
    unsafe fn keep(self, mask: Self::Mask) -> Self {
        each!(i => if mask[i] { self.0[i] } else { 0.0 })
    }
    #[inline(always)]
    unsafe fn or(self, mask: Self::Mask, o: Self) -> Self {
        each!(i => if mask[i] { self.0[i] } else { o.0[i] })
    }
    #[inline(always)]
    unsafe fn read(at: *const f64) -> Self {
        // SAFETY: the caller vouches for eight numbers.
        each!(i => unsafe { *at.add(i) })
    }
    #[inline(always)]
    unsafe fn read_quad(base: *const f64, offsets: &[usize; LANES]) -> [Self; 4] {
        // SAFETY: the caller vouches for four numbers behind each offset.
        std::array::from_fn(|k| each!(i => unsafe { *base.add(offsets[i] + k) }))
    }
    #[inline(always)]
    unsafe fn half(self, upper: bool) -> Self {
        each!(i => {
            let word = self.0[i].to_bits();
            f64::from_bits(if upper { word & UPPER } else { word << 32 })
        })
    }
    #[inline(always)]
    unsafe fn fold(v: [Self; 8]) -> [f64; 8] {
        v.map(|Portable(a)| ((a[0] + a[1]) + (a[2] + a[3])) + ((a[4] + a[5]) + (a[6] + a[7])))
    }
    #[inline(always)]
    unsafe fn fold_max(self) -> f64 {
        self.0.iter().copied().fold(f64::NEG_INFINITY, |a, b| if a > b { a } else { b })
    }
}

// Helpers of the wide types are functions, not closures: a closure around intrinsics is not inlined into the entry
// function, and the loop then runs several times slower.

/// Four numbers behind each of four offsets, one vector per number.
///
/// # Safety
/// Needs AVX2, and four numbers behind each offset.
#[inline(always)]
unsafe fn transpose4(base: *const f64, offsets: [usize; 4]) -> [__m256d; 4] {
    unsafe {
        let (r0, r1) = (_mm256_loadu_pd(base.add(offsets[0])), _mm256_loadu_pd(base.add(offsets[1])));
        let (r2, r3) = (_mm256_loadu_pd(base.add(offsets[2])), _mm256_loadu_pd(base.add(offsets[3])));
        let (a, b) = (_mm256_unpacklo_pd(r0, r1), _mm256_unpackhi_pd(r0, r1));
        let (c, d) = (_mm256_unpacklo_pd(r2, r3), _mm256_unpackhi_pd(r2, r3));
        [
            _mm256_permute2f128_pd::<0x20>(a, c),
            _mm256_permute2f128_pd::<0x20>(b, d),
            _mm256_permute2f128_pd::<0x31>(a, c),
            _mm256_permute2f128_pd::<0x31>(b, d),
        ]
    }
}

/// Sums of two vectors' lanes: hadd(a, b) = a0+a1, b0+b1, a2+a3, b2+b3; then halves are added, low with low first.
///
/// # Safety
/// Needs AVX2.
#[inline(always)]
unsafe fn fold_two(a: Avx2, b: Avx2) -> __m128d {
    unsafe {
        let (low, high) = (_mm256_hadd_pd(a.0, b.0), _mm256_hadd_pd(a.1, b.1));
        let low = _mm_add_pd(_mm256_castpd256_pd128(low), _mm256_extractf128_pd::<1>(low));
        let high = _mm_add_pd(_mm256_castpd256_pd128(high), _mm256_extractf128_pd::<1>(high));
        _mm_add_pd(low, high)
    }
}

/// The halves behind two offsets in one register.
///
/// # Safety
/// Needs AVX-512F, and four numbers behind each offset.
#[inline(always)]
unsafe fn join(base: *const f64, low: usize, high: usize) -> __m512d {
    unsafe {
        let low = _mm512_castpd256_pd512(_mm256_loadu_pd(base.add(low)));
        _mm512_insertf64x4::<1>(low, _mm256_loadu_pd(base.add(high)))
    }
}

/// Neighbouring lanes of two vectors added.
///
/// # Safety
/// Needs AVX-512F.
#[inline(always)]
unsafe fn add_neighbours(a: Avx512, b: Avx512) -> __m512d {
    unsafe { _mm512_add_pd(_mm512_unpacklo_pd(a.0, b.0), _mm512_unpackhi_pd(a.0, b.0)) }
}

/// Neighbouring blocks of 128 bits of two vectors added.
///
/// # Safety
/// Needs AVX-512F.
#[inline(always)]
unsafe fn add_blocks(a: __m512d, b: __m512d) -> __m512d {
    unsafe { _mm512_add_pd(_mm512_shuffle_f64x2::<0x88>(a, b), _mm512_shuffle_f64x2::<0xdd>(a, b)) }
}

/// Two halves of four lanes, AVX2 with FMA.
#[derive(Clone, Copy)]
pub struct Avx2(__m256d, __m256d);

// SAFETY: intrinsics of AVX2 and FMA, which the entry function enables.
unsafe impl Lanes for Avx2 {
    type Mask = (__m256d, __m256d);
    #[inline(always)]
    unsafe fn splat(x: f64) -> Self {
        unsafe { Avx2(_mm256_set1_pd(x), _mm256_set1_pd(x)) }
    }
    #[inline(always)]
    unsafe fn add(self, o: Self) -> Self {
        unsafe { Avx2(_mm256_add_pd(self.0, o.0), _mm256_add_pd(self.1, o.1)) }
    }
    #[inline(always)]
    unsafe fn sub(self, o: Self) -> Self {
        unsafe { Avx2(_mm256_sub_pd(self.0, o.0), _mm256_sub_pd(self.1, o.1)) }
    }
    #[inline(always)]
    unsafe fn mul(self, o: Self) -> Self {
        unsafe { Avx2(_mm256_mul_pd(self.0, o.0), _mm256_mul_pd(self.1, o.1)) }
    }
    #[inline(always)]
    unsafe fn div(self, o: Self) -> Self {
        unsafe { Avx2(_mm256_div_pd(self.0, o.0), _mm256_div_pd(self.1, o.1)) }
    }
    #[inline(always)]
    unsafe fn sqrt(self) -> Self {
        unsafe { Avx2(_mm256_sqrt_pd(self.0), _mm256_sqrt_pd(self.1)) }
    }
    #[inline(always)]
    unsafe fn inverse_root_estimate(self) -> Self {
        unsafe {
            let (low, high) = (_mm256_cvtpd_ps(self.0), _mm256_cvtpd_ps(self.1));
            let y = _mm256_div_ps(_mm256_set1_ps(1.0), _mm256_sqrt_ps(_mm256_set_m128(high, low)));
            Avx2(_mm256_cvtps_pd(_mm256_castps256_ps128(y)), _mm256_cvtps_pd(_mm256_extractf128_ps::<1>(y)))
        }
    }
    #[inline(always)]
    unsafe fn fma(self, b: Self, c: Self) -> Self {
        unsafe { Avx2(_mm256_fmadd_pd(self.0, b.0, c.0), _mm256_fmadd_pd(self.1, b.1, c.1)) }
    }
    #[inline(always)]
    unsafe fn fnma(self, b: Self, c: Self) -> Self {
        unsafe { Avx2(_mm256_fnmadd_pd(self.0, b.0, c.0), _mm256_fnmadd_pd(self.1, b.1, c.1)) }
    }
    #[inline(always)]
    unsafe fn max(self, o: Self) -> Self {
        unsafe { Avx2(_mm256_max_pd(self.0, o.0), _mm256_max_pd(self.1, o.1)) }
    }
    #[inline(always)]
    unsafe fn min(self, o: Self) -> Self {
        unsafe { Avx2(_mm256_min_pd(self.0, o.0), _mm256_min_pd(self.1, o.1)) }
    }
    #[inline(always)]
    unsafe fn less(self, o: Self) -> Self::Mask {
        unsafe { (_mm256_cmp_pd::<_CMP_LT_OQ>(self.0, o.0), _mm256_cmp_pd::<_CMP_LT_OQ>(self.1, o.1)) }
    }
    #[inline(always)]
    unsafe fn count(mask: Self::Mask) -> u32 {
        unsafe { (_mm256_movemask_pd(mask.0) as u32 | (_mm256_movemask_pd(mask.1) as u32) << 4).count_ones() }
    }
    #[inline(always)]
    unsafe fn keep(self, mask: Self::Mask) -> Self {
        unsafe { Avx2(_mm256_and_pd(self.0, mask.0), _mm256_and_pd(self.1, mask.1)) }
    }
    #[inline(always)]
    unsafe fn or(self, mask: Self::Mask, o: Self) -> Self {
        unsafe { Avx2(_mm256_blendv_pd(o.0, self.0, mask.0), _mm256_blendv_pd(o.1, self.1, mask.1)) }
    }
    #[inline(always)]
    unsafe fn read(at: *const f64) -> Self {
        unsafe { Avx2(_mm256_loadu_pd(at), _mm256_loadu_pd(at.add(4))) }
    }
    #[inline(always)]
    unsafe fn read_quad(base: *const f64, offsets: &[usize; LANES]) -> [Self; 4] {
        unsafe {
            let low = transpose4(base, [offsets[0], offsets[1], offsets[2], offsets[3]]);
            let high = transpose4(base, [offsets[4], offsets[5], offsets[6], offsets[7]]);
            [Avx2(low[0], high[0]), Avx2(low[1], high[1]), Avx2(low[2], high[2]), Avx2(low[3], high[3])]
        }
    }
    #[inline(always)]
    unsafe fn half(self, upper: bool) -> Self {
        unsafe {
            let half = |x: __m256d| {
                let word = _mm256_castpd_si256(x);
                _mm256_castsi256_pd(if upper {
                    _mm256_and_si256(word, _mm256_set1_epi64x(UPPER as i64))
                } else {
                    _mm256_slli_epi64::<32>(word)
                })
            };
            Avx2(half(self.0), half(self.1))
        }
    }
    #[inline(always)]
    unsafe fn fold(v: [Self; 8]) -> [f64; 8] {
        unsafe {
            let mut out = [0.0; 8];
            for k in 0..4 {
                _mm_storeu_pd(out.as_mut_ptr().add(2 * k), fold_two(v[2 * k], v[2 * k + 1]));
            }
            out
        }
    }
    #[inline(always)]
    unsafe fn fold_max(self) -> f64 {
        unsafe {
            let m = _mm256_max_pd(self.0, self.1);
            let m = _mm_max_pd(_mm256_castpd256_pd128(m), _mm256_extractf128_pd::<1>(m));
            _mm_cvtsd_f64(_mm_max_sd(m, _mm_unpackhi_pd(m, m)))
        }
    }
}

/// One register of eight lanes, AVX-512.
#[derive(Clone, Copy)]
pub struct Avx512(pub __m512d);

// SAFETY: intrinsics of AVX-512F, which the entry function enables.
unsafe impl Lanes for Avx512 {
    type Mask = __mmask8;
    #[inline(always)]
    unsafe fn splat(x: f64) -> Self {
        unsafe { Avx512(_mm512_set1_pd(x)) }
    }
    #[inline(always)]
    unsafe fn add(self, o: Self) -> Self {
        unsafe { Avx512(_mm512_add_pd(self.0, o.0)) }
    }
    #[inline(always)]
    unsafe fn sub(self, o: Self) -> Self {
        unsafe { Avx512(_mm512_sub_pd(self.0, o.0)) }
    }
    #[inline(always)]
    unsafe fn mul(self, o: Self) -> Self {
        unsafe { Avx512(_mm512_mul_pd(self.0, o.0)) }
    }
    #[inline(always)]
    unsafe fn div(self, o: Self) -> Self {
        unsafe { Avx512(_mm512_div_pd(self.0, o.0)) }
    }
    #[inline(always)]
    unsafe fn sqrt(self) -> Self {
        unsafe { Avx512(_mm512_sqrt_pd(self.0)) }
    }
    #[inline(always)]
    unsafe fn inverse_root_estimate(self) -> Self {
        unsafe {
            let root = _mm256_sqrt_ps(_mm512_cvtpd_ps(self.0));
            Avx512(_mm512_cvtps_pd(_mm256_div_ps(_mm256_set1_ps(1.0), root)))
        }
    }
    #[inline(always)]
    unsafe fn fma(self, b: Self, c: Self) -> Self {
        unsafe { Avx512(_mm512_fmadd_pd(self.0, b.0, c.0)) }
    }
    #[inline(always)]
    unsafe fn fnma(self, b: Self, c: Self) -> Self {
        unsafe { Avx512(_mm512_fnmadd_pd(self.0, b.0, c.0)) }
    }
    #[inline(always)]
    unsafe fn max(self, o: Self) -> Self {
        unsafe { Avx512(_mm512_max_pd(self.0, o.0)) }
    }
    #[inline(always)]
    unsafe fn min(self, o: Self) -> Self {
        unsafe { Avx512(_mm512_min_pd(self.0, o.0)) }
    }
    #[inline(always)]
    unsafe fn less(self, o: Self) -> Self::Mask {
        unsafe { _mm512_cmp_pd_mask::<_CMP_LT_OQ>(self.0, o.0) }
    }
    #[inline(always)]
    unsafe fn count(mask: Self::Mask) -> u32 {
        mask.count_ones()
    }
    #[inline(always)]
    unsafe fn keep(self, mask: Self::Mask) -> Self {
        unsafe { Avx512(_mm512_maskz_mov_pd(mask, self.0)) }
    }
    #[inline(always)]
    unsafe fn or(self, mask: Self::Mask, o: Self) -> Self {
        unsafe { Avx512(_mm512_mask_blend_pd(mask, o.0, self.0)) }
    }
    #[inline(always)]
    unsafe fn read(at: *const f64) -> Self {
        unsafe { Avx512(_mm512_loadu_pd(at)) }
    }
    #[inline(always)]
    unsafe fn read_quad(base: *const f64, offsets: &[usize; LANES]) -> [Self; 4] {
        unsafe {
            let (z0, z1) = (join(base, offsets[0], offsets[2]), join(base, offsets[1], offsets[3]));
            let (z2, z3) = (join(base, offsets[4], offsets[6]), join(base, offsets[5], offsets[7]));
            let (a, b) = (_mm512_unpacklo_pd(z0, z1), _mm512_unpackhi_pd(z0, z1));
            let (c, d) = (_mm512_unpacklo_pd(z2, z3), _mm512_unpackhi_pd(z2, z3));
            [
                Avx512(_mm512_shuffle_f64x2::<0x88>(a, c)),
                Avx512(_mm512_shuffle_f64x2::<0x88>(b, d)),
                Avx512(_mm512_shuffle_f64x2::<0xdd>(a, c)),
                Avx512(_mm512_shuffle_f64x2::<0xdd>(b, d)),
            ]
        }
    }
    #[inline(always)]
    unsafe fn half(self, upper: bool) -> Self {
        unsafe {
            let word = _mm512_castpd_si512(self.0);
            Avx512(_mm512_castsi512_pd(if upper {
                _mm512_and_si512(word, _mm512_set1_epi64(UPPER as i64))
            } else {
                _mm512_slli_epi64::<32>(word)
            }))
        }
    }
    #[inline(always)]
    unsafe fn fold(v: [Self; 8]) -> [f64; 8] {
        unsafe {
            let (a, b) = (add_neighbours(v[0], v[1]), add_neighbours(v[2], v[3]));
            let (c, d) = (add_neighbours(v[4], v[5]), add_neighbours(v[6], v[7]));
            let sums = add_blocks(add_blocks(a, b), add_blocks(c, d));
            let mut out = [0.0; 8];
            _mm512_storeu_pd(out.as_mut_ptr(), sums);
            out
        }
    }
    #[inline(always)]
    unsafe fn fold_max(self) -> f64 {
        unsafe { _mm512_reduce_max_pd(self.0) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A sample of all operations, as bits.
    ///
    /// # Safety
    /// As for [`Lanes`].
    #[inline(always)]
    unsafe fn sample<L: Lanes>(data: &[f64], offsets: &[usize; 8]) -> Vec<u64> {
        unsafe {
            let [a, b, c, d] = L::read_quad(data.as_ptr(), offsets);
            let mask = a.less(b);
            let v = [
                a.add(b),
                a.sub(c),
                a.mul(d).div(b),
                a.mul(a).sqrt(),
                a.fma(b, c),
                a.fnma(c, d),
                a.max(b).min(c).add(a.mul(a).inverse_root()),
                d.keep(mask).add(c.or(mask, L::read(data.as_ptr()))),
            ];
            let mut bits: Vec<u64> = L::fold(v).iter().map(|x| x.to_bits()).collect();
            bits.push(v[4].fold_max().to_bits());
            bits.push(L::count(mask) as u64);
            bits
        }
    }
    /// # Safety
    /// As for [`sample`].
    #[target_feature(enable = "avx2,fma")]
    unsafe fn sample_avx2(data: &[f64], offsets: &[usize; 8]) -> Vec<u64> {
        unsafe { sample::<Avx2>(data, offsets) }
    }
    /// # Safety
    /// As for [`sample`].
    #[target_feature(enable = "avx512f,avx512vl,avx2,fma")]
    unsafe fn sample_avx512(data: &[f64], offsets: &[usize; 8]) -> Vec<u64> {
        unsafe { sample::<Avx512>(data, offsets) }
    }

    #[test]
    fn all_widths_give_the_same_bits() {
        for round in 0..200 {
            let data: Vec<f64> =
                (0..64).map(|i| (crate::random::uniform(round, i, 0) - 0.5) * 10f64.powi((i % 7) as i32)).collect();
            let offsets = std::array::from_fn(|i| (crate::random::uniform(round, i as u64, 1) * 60.0) as usize);
            // SAFETY: 60 + 3 < 64; wider sets run only where the processor has them.
            unsafe {
                let expected = sample::<Portable>(&data, &offsets);
                if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
                    assert_eq!(sample_avx2(&data, &offsets), expected);
                } else {
                    println!("skipped: no AVX2 here");
                }
                if is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512vl") {
                    assert_eq!(sample_avx512(&data, &offsets), expected);
                } else {
                    println!("skipped: no AVX-512 here");
                }
            }
        }
    }

    #[test]
    fn a_request_is_understood_or_refused() {
        assert_eq!((requested(""), requested("avx2")), (Ok(None), Ok(Some(Width::Avx2))));
        assert!(requested("avx1024").is_err());
    }
}
