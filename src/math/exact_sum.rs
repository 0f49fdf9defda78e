//! Sums that do not depend on the order of their terms. Every finite f64 is a whole multiple of 2^-1074, so a sum of them is an
//! integer; it is kept in wide fixed point, 32 bits to a limb, each limb in an i64 whose upper half collects carries. Limbs of
//! different ranks may be added as plain integers. The value is rounded once, at the end.

/// Bits of payload per limb.
const LIMB_BITS: usize = 32;
const LIMB_MASK: i64 = (1 << LIMB_BITS) - 1;
/// 2099 bits reach from 2^-1074 to the largest f64; the rest of 70 limbs holds the growth of any sum.
const LIMBS: usize = 70;
/// Weight of the lowest bit is 2^LOWEST.
const LOWEST: i32 = -1074;
/// Additions after which carries are propagated: each adds less than 2^32 to a limb, and 2^31 of them would fill an i64.
const MAX_PENDING: u64 = 1 << 30;
/// Ranks whose normalised limbs may be added up before they are normalised again.
pub const MAX_RANKS: u64 = 1 << 20;

/// Exact sum of f64s, independent of their order. Infinities and NaN make the value NaN.
#[derive(Debug, Clone, PartialEq)]
pub struct ExactSum {
    /// Fixed-point limbs, lowest first; the last entry counts addends that were not finite.
    limbs: [i64; LIMBS + 1],
    /// Bound on the magnitude of every limb, in units of 2^32.
    pending: u64,
}

impl Default for ExactSum {
    fn default() -> Self {
        Self::new()
    }
}

impl ExactSum {
    /// Words of [`ExactSum::limbs`].
    pub const WORDS: usize = LIMBS + 1;

    pub const fn new() -> Self {
        Self { limbs: [0; LIMBS + 1], pending: 1 }
    }

    /// Adds a number.
    #[inline]
    pub fn add(&mut self, x: f64) {
        let bits = x.to_bits();
        let exponent = (bits >> 52) as usize & 0x7ff;
        if exponent == 0x7ff {
            self.limbs[LIMBS] += 1;
            return;
        }
        // Subnormals share the lowest exponent and lack the hidden bit.
        let hidden = if exponent == 0 { 0 } else { 1u64 << 52 };
        let position = exponent.max(1) - 1;
        let wide = ((bits & ((1 << 52) - 1) | hidden) as u128) << (position % LIMB_BITS);
        let sign = 1 - 2 * (bits >> 63) as i64;
        let limbs = &mut self.limbs[position / LIMB_BITS..][..3];
        limbs[0] += sign * (wide as i64 & LIMB_MASK);
        limbs[1] += sign * ((wide >> 32) as i64 & LIMB_MASK);
        limbs[2] += sign * ((wide >> 64) as i64);
        self.pending += 1;
        if self.pending >= MAX_PENDING {
            self.normalise();
        }
    }

    /// Adds another sum.
    #[inline]
    pub fn merge(&mut self, other: &Self) {
        for (mine, theirs) in self.limbs.iter_mut().zip(&other.limbs) {
            *mine += theirs;
        }
        self.pending += other.pending;
        if self.pending >= MAX_PENDING {
            self.normalise();
        }
    }

    /// Propagates carries: all limbs but the highest then lie in [0, 2^32), and equal sums have equal limbs.
    pub fn normalise(&mut self) {
        let mut carry = 0;
        for limb in &mut self.limbs[..LIMBS - 1] {
            let total = *limb + carry;
            *limb = total & LIMB_MASK;
            carry = total >> LIMB_BITS;
        }
        self.limbs[LIMBS - 1] += carry;
        self.pending = 1;
    }

    /// The limbs as they are; normalise first where they go into a message.
    #[inline]
    pub fn limbs(&self) -> &[i64] {
        &self.limbs
    }

    /// Normalised limbs, to be added up over at most [`MAX_RANKS`] ranks in place.
    pub fn limbs_mut(&mut self) -> &mut [i64] {
        self.normalise();
        self.pending = MAX_RANKS;
        &mut self.limbs
    }

    /// The sum with these limbs: normalised ones of one rank, or those of up to [`MAX_RANKS`] ranks added up.
    pub fn from_limbs(limbs: &[i64]) -> Self {
        let mut sum = Self { pending: MAX_RANKS, ..Self::new() };
        sum.limbs.copy_from_slice(limbs);
        sum
    }

    /// The sum, rounded once to the nearest f64 (ties to even); infinite where it exceeds the range of f64.
    pub fn value(&self) -> f64 {
        let mut magnitude = self.clone();
        magnitude.normalise();
        if magnitude.limbs[LIMBS] != 0 {
            return f64::NAN;
        }
        let negative = magnitude.limbs[LIMBS - 1] < 0;
        if negative {
            magnitude.limbs[..LIMBS].iter_mut().for_each(|limb| *limb = -*limb);
            magnitude.normalise();
        }
        let rounded = round(&magnitude.limbs[..LIMBS]);
        if negative { -rounded } else { rounded }
    }
}

/// The nearest f64 to a non-negative normalised number.
fn round(limbs: &[i64]) -> f64 {
    let Some(top) = limbs.iter().rposition(|&limb| limb != 0) else { return 0.0 };
    let length = top * LIMB_BITS + (64 - limbs[top].leading_zeros() as usize);
    if length > 2099 {
        return f64::INFINITY;
    }
    // The 53 bits below `length`, then whether half a unit and anything below it follow.
    let low = length.saturating_sub(53);
    let bit = |p: usize| (limbs[p / LIMB_BITS] >> (p % LIMB_BITS)) & 1;
    let limb = |k: usize| limbs.get(k).copied().unwrap_or(0) as u128;
    let k = low / LIMB_BITS;
    let window = (limb(k) | limb(k + 1) << 32 | limb(k + 2) << 64) >> (low % LIMB_BITS);
    let mut mantissa = window as u64 & ((1 << 53) - 1);
    if low > 0 && bit(low - 1) == 1 {
        let half = low - 1;
        let below = limbs[half / LIMB_BITS] & ((1 << (half % LIMB_BITS)) - 1) != 0
            || limbs[..half / LIMB_BITS].iter().any(|&limb| limb != 0);
        mantissa += u64::from(below || mantissa & 1 == 1);
    }
    // Both factors are exact, and so is their product: the mantissa has the precision of the result already.
    let exponent = low as i32 + LOWEST;
    let half = exponent / 2;
    mantissa as f64 * power_of_two(half) * power_of_two(exponent - half)
}

/// 2^n for n in the normal range.
fn power_of_two(n: i32) -> f64 {
    f64::from_bits(((n + 1023) as u64) << 52)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::uniform;

    fn sum(values: impl IntoIterator<Item = f64>) -> f64 {
        let mut s = ExactSum::new();
        values.into_iter().for_each(|x| s.add(x));
        s.value()
    }

    /// Numbers over the whole range of f64, subnormals included, of both signs.
    fn wild(n: u64, seed: u64) -> Vec<f64> {
        let number = |i| {
            let mantissa = 1.0 + uniform(seed, i, 0);
            let exponent = (uniform(seed, i, 1) * 2070.0) as i32 - 1070;
            let sign = if uniform(seed, i, 2) < 0.5 { -1.0 } else { 1.0 };
            sign * libm::ldexp(mantissa, exponent)
        };
        (0..n).map(number).collect()
    }

    #[test]
    fn one_number_comes_back_bit_for_bit() {
        let odd =
            [0.0, f64::MIN_POSITIVE, 5e-324, -5e-324, f64::MAX, f64::MIN, 1.0, -1.0 / 3.0, 2.225_073_858_507_201e-308];
        for x in wild(2000, 1).into_iter().chain(odd) {
            assert_eq!(sum([x]).to_bits(), x.to_bits(), "{x:e}");
        }
    }

    #[test]
    fn order_and_grouping_do_not_matter() {
        let mut values = wild(3000, 2);
        let forward = sum(values.iter().copied());
        values.reverse();
        let (mut a, mut b) = (ExactSum::new(), ExactSum::new());
        for (i, &x) in values.iter().enumerate() {
            if i % 3 == 0 { a.add(x) } else { b.add(x) }
        }
        b.merge(&a);
        assert_eq!(forward.to_bits(), b.value().to_bits());
    }

    #[test]
    fn cancellation_leaves_the_smallest() {
        let values = wild(1000, 3);
        let cancelled = values.iter().copied().chain([5e-324]).chain(values.iter().map(|x| -x));
        assert_eq!(sum(cancelled), 5e-324);
        assert_eq!(sum([1e300, 1.0, -1e300, -3.0]), -2.0);
        assert_eq!(sum([f64::MAX, f64::MAX, -f64::MAX]), f64::MAX);
    }

    /// Rounding to nearest, ties to even, with the deciding bit far below.
    #[test]
    fn ties_are_decided_by_the_last_bit() {
        let half = f64::EPSILON / 2.0;
        assert_eq!(sum([1.0, half]), 1.0);
        assert_eq!(sum([1.0, half, 5e-324]), 1.0 + f64::EPSILON);
        assert_eq!(sum([1.0 + f64::EPSILON, half]), 1.0 + 2.0 * f64::EPSILON);
        assert_eq!(sum([-1.0, -half, -5e-324]), -1.0 - f64::EPSILON);
        assert_eq!(sum([1.0, half, -5e-324]), 1.0);
        assert_eq!(sum([f64::MAX, f64::MAX]), f64::INFINITY);
        assert!(sum([1.0, f64::INFINITY]).is_nan());
    }

    /// Against 128-bit integers: multiples of 2^-20 below 2^60, whose sum i128 holds exactly.
    #[test]
    fn agrees_with_integer_arithmetic() {
        let unit = 1.0 / (1 << 20) as f64;
        let (mut s, mut integer) = (ExactSum::new(), 0i128);
        for i in 0..20_000 {
            let wide = (uniform(4, i, 0) - 0.5) * libm::exp2(80.0 * uniform(4, i, 1));
            let x = (wide / unit).trunc();
            s.add(x * unit);
            integer += x as i128;
            // `as f64` rounds to nearest even, and the unit is a power of two.
            assert_eq!(s.value(), integer as f64 * unit);
        }
    }

    #[test]
    fn limbs_of_ranks_add_as_integers() {
        let values = wild(4096, 5);
        let mut total = vec![0i64; ExactSum::WORDS];
        for rank in values.chunks(7) {
            let mut s = ExactSum::new();
            rank.iter().for_each(|&x| s.add(x));
            total.iter_mut().zip(s.limbs_mut().iter()).for_each(|(t, l)| *t += l);
        }
        assert_eq!(ExactSum::from_limbs(&total).value(), sum(values));
    }

    #[test]
    fn equal_sums_have_equal_limbs_once_normalised() {
        let (mut a, mut b) = (ExactSum::new(), ExactSum::new());
        [1.5, -7e30, 3.0].into_iter().for_each(|x| a.add(x));
        [-7e30, 4.5].into_iter().for_each(|x| b.add(x));
        a.normalise();
        b.normalise();
        assert_eq!(a.limbs(), b.limbs());
    }
}
