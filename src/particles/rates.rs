//! Rates of a chunk's particles as an evaluation finds them. They are apart from the columns: the state has not changed
//! when they are known, and an integrator decides how to use them.

use std::cell::Cell;

use super::chunk::{CHUNK, View};
use super::columns::{Element, Integrated, Registry};

/// Bits of the exponent; all of them are set in infinities and NaN.
const EXPONENT: u64 = 0x7ff << 52;

/// Room for the rates of one chunk.
pub struct Rates {
    /// D numbers per particle, m/s^2.
    pub acceleration: Vec<Cell<f64>>,
    /// One block per integrated column, in the order of [`Registry::integrated`].
    blocks: Vec<Block>,
}

struct Block {
    words: Vec<Cell<u64>>,
    /// 64-bit words per particle.
    width: usize,
}

impl Rates {
    pub fn new(registry: &Registry) -> Self {
        let block = |&index: &usize| {
            let width = registry.entries[index].width;
            Block { words: vec![Cell::new(0); CHUNK * width], width }
        };
        Self {
            acceleration: vec![Cell::new(0.0); CHUNK * registry.dimension],
            blocks: registry.integrated.iter().map(block).collect(),
        }
    }

    /// Sets the rates of all integrated columns to zero; accelerations are written anew anyway.
    pub fn clear(&self) {
        self.blocks.iter().flat_map(|block| &block.words).for_each(|word| word.set(0));
    }

    #[inline]
    pub fn view<T: Element>(&self, column: Integrated<T>) -> View<'_, T> {
        let block = &self.blocks[column.slot];
        View::new(&block.words, block.width)
    }

    /// The words of each integrated column's rate, in the order of [`Registry::integrated`].
    pub fn blocks(&self) -> impl Iterator<Item = &[Cell<u64>]> {
        self.blocks.iter().map(|block| &block.words[..])
    }

    /// The words of particle `k` in the block of an integrated column.
    pub fn of_particle(&self, slot: usize, k: usize) -> &[Cell<u64>] {
        let Block { words, width } = &self.blocks[slot];
        &words[k * width..(k + 1) * width]
    }

    /// Whether the rates of the first `count` particles are finite.
    pub fn are_finite(&self, count: usize, dimension: usize) -> bool {
        finite(words_of(&self.acceleration[..count * dimension]))
            && self.blocks.iter().all(|block| finite(&block.words[..count * block.width]))
    }
}

/// Numbers as their words.
pub fn words_of(numbers: &[Cell<f64>]) -> &[Cell<u64>] {
    // SAFETY: f64 and u64 have the same size and alignment, and any word is a value of both.
    unsafe { std::slice::from_raw_parts(numbers.as_ptr().cast(), numbers.len()) }
}

/// Whether all words are finite numbers. One pass without a branch, over numbers that are in cache.
pub fn finite(words: &[Cell<u64>]) -> bool {
    let carried = words.iter().fold(0, |any, word| any | ((word.get() & EXPONENT) + (1 << 52)));
    carried >> 63 == 0
}

/// Whether all numbers are finite.
pub fn all_finite(numbers: &[f64]) -> bool {
    let carried = numbers.iter().fold(0, |any, x| any | ((x.to_bits() & EXPONENT) + (1 << 52)));
    carried >> 63 == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finite_numbers_are_told_from_others() {
        let whole = [0.0, -0.0, 5e-324, -1.5, f64::MAX, f64::MIN];
        assert!(all_finite(&whole));
        for bad in [f64::NAN, -f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::from_bits(0x7ff0_0000_0000_0001)] {
            for at in 0..whole.len() {
                let mut numbers = whole;
                numbers[at] = bad;
                assert!(!all_finite(&numbers) && !finite(&numbers.map(|x| Cell::new(x.to_bits()))), "{bad} at {at}");
            }
        }
    }
}
