//! Morton codes: the bits of D coordinates interleaved. Codes of one cell's contents are contiguous, and dropping D bits
//! gives the code of the cell twice as wide (Morton 1966).

/// Bits per coordinate: three coordinates fit into one word.
pub const BITS: u32 = 21;

/// The code of a point with coordinates below `2^BITS`; the first coordinate holds the highest bits.
#[inline]
pub fn encode<const D: usize>(coordinates: [u32; D]) -> u64 {
    coordinates.iter().fold(0, |code, &c| code << 1 | spread::<D>(c))
}

#[inline]
pub fn decode<const D: usize>(code: u64) -> [u32; D] {
    std::array::from_fn(|k| gather::<D>(code >> (D - 1 - k)))
}

/// The codes of the up to 3^D cells that touch a cell, itself included, in lexicographic order of their offsets.
pub struct Block {
    codes: [u64; 27],
    len: usize,
    /// Cells along each axis.
    counts: [u8; 3],
    /// Axes along which all cells of the lattice touch each other.
    short: [bool; 3],
}

impl Block {
    /// `side`: cells per edge of the lattice; there is nothing beyond its edges.
    pub fn around<const D: usize>(code: u64, side: u32) -> Self {
        Self::of(decode::<D>(code).map(|c| (c.saturating_sub(1), (c + 1).min(side - 1))), |_, c| c)
    }

    /// [`Block::around`] on a lattice that is periodic after `period` cells from its middle on; zero along open axes.
    pub fn around_periodic<const D: usize>(code: u64, side: u32, period: [u32; D]) -> Self {
        let ranges: [(u32, u32); D] = std::array::from_fn(|k| {
            let c = decode::<D>(code)[k];
            match period[k] {
                0 => (c.saturating_sub(1), (c + 1).min(side - 1)),
                // Three cells or fewer all touch.
                n if n <= 3 => (side / 2, side / 2 + n - 1),
                _ => (c - 1, c + 1),
            }
        });
        let short = std::array::from_fn(|k| k < D && (1..=3).contains(&period[k]));
        Self { short, ..Self::of(ranges, |k, c| if period[k] == 0 { c } else { wrapped(c, side / 2, period[k]) }) }
    }

    fn of<const D: usize>(ranges: [(u32, u32); D], place: impl Fn(usize, u32) -> u32) -> Self {
        let mut block = Self { codes: [0; 27], len: 1, counts: [1; 3], short: [false; 3] };
        for (k, (low, high)) in ranges.into_iter().enumerate() {
            let count = (high - low + 1) as usize;
            let mut bits = [0; 3];
            for (bits, c) in bits.iter_mut().zip(low..=high) {
                *bits = spread::<D>(place(k, c)) << (D - 1 - k);
            }
            // From the last on, so that each prefix is read before its place is written to.
            for number in (0..block.len).rev() {
                let prefix = block.codes[number];
                for c in (0..count).rev() {
                    block.codes[number * count + c] = prefix | bits[c];
                }
            }
            block.len *= count;
            block.counts[k] = count as u8;
        }
        block
    }

    pub fn codes(&self) -> &[u64] {
        &self.codes[..self.len]
    }

    /// In which layer of the block, 0 to 2 along each of D axes, its cell `number` lies: two bits per axis, or 3 along axes on
    /// which all cells touch each other, on both sides.
    pub fn layers<const D: usize>(&self, number: usize) -> u8 {
        let (mut layers, mut rest) = (0, number as u8);
        for k in (0..D).rev() {
            let layer = if self.short[k] { 3 } else { rest % self.counts[k] };
            rest /= self.counts[k];
            layers |= layer << (2 * k);
        }
        layers
    }
}

/// The coordinate within the `period` cells from `first` on, of one that lies at most a period beyond them.
pub fn wrapped(c: u32, first: u32, period: u32) -> u32 {
    first + (c + period - first) % period
}

/// Moves bit k to bit D k.
#[inline]
fn spread<const D: usize>(c: u32) -> u64 {
    let mut x = c as u64;
    if D == 2 {
        x = (x | x << 16) & 0x0000_ffff_0000_ffff;
        x = (x | x << 8) & 0x00ff_00ff_00ff_00ff;
        x = (x | x << 4) & 0x0f0f_0f0f_0f0f_0f0f;
        x = (x | x << 2) & 0x3333_3333_3333_3333;
        (x | x << 1) & 0x5555_5555_5555_5555
    } else {
        x = (x | x << 32) & 0x001f_0000_0000_ffff;
        x = (x | x << 16) & 0x001f_0000_ff00_00ff;
        x = (x | x << 8) & 0x100f_00f0_0f00_f00f;
        x = (x | x << 4) & 0x10c3_0c30_c30c_30c3;
        (x | x << 2) & 0x1249_2492_4924_9249
    }
}

/// Moves bit D k to bit k and drops the others.
#[inline]
fn gather<const D: usize>(code: u64) -> u32 {
    let mut x = code;
    if D == 2 {
        x &= 0x5555_5555_5555_5555;
        x = (x | x >> 1) & 0x3333_3333_3333_3333;
        x = (x | x >> 2) & 0x0f0f_0f0f_0f0f_0f0f;
        x = (x | x >> 4) & 0x00ff_00ff_00ff_00ff;
        x = (x | x >> 8) & 0x0000_ffff_0000_ffff;
        (x | x >> 16) as u32
    } else {
        x &= 0x1249_2492_4924_9249;
        x = (x | x >> 2) & 0x10c3_0c30_c30c_30c3;
        x = (x | x >> 4) & 0x100f_00f0_0f00_f00f;
        x = (x | x >> 8) & 0x001f_0000_ff00_00ff;
        x = (x | x >> 16) & 0x001f_0000_0000_ffff;
        (x | x >> 32) as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_interleave_bits_and_coarsen_by_shifting() {
        assert_eq!(encode([0b11, 0b00, 0b01]), 0b100_101);
        assert_eq!(encode([0b11, 0b01]), 0b10_11);
        let top = (1 << BITS) - 1;
        for c in [[0, 1, 2], [top, 0, top], [123_456, 2_000_000, 77]] {
            assert_eq!(decode::<3>(encode(c)), c);
            assert_eq!(decode::<3>(encode(c) >> 12), c.map(|c| c >> 4));
            assert_eq!(decode::<2>(encode([c[0], c[1]])), [c[0], c[1]]);
        }
    }

    #[test]
    fn blocks_stop_at_the_edge_of_the_lattice() {
        let inside: Vec<_> = Block::around::<2>(encode([1, 2]), 4).codes().iter().map(|&c| decode::<2>(c)).collect();
        assert_eq!(inside, [[0, 1], [0, 2], [0, 3], [1, 1], [1, 2], [1, 3], [2, 1], [2, 2], [2, 3]]);
        assert_eq!(Block::around::<3>(encode([5, 6, 7]), 1 << BITS).codes().len(), 27);
        assert_eq!(Block::around::<3>(encode([0, 0, 0]), 2).codes().len(), 8);
    }

    #[test]
    fn layers_of_a_block_ascend_along_each_axis() {
        let block = Block::around::<3>(encode([5, 0, 7]), 16);
        for (number, &code) in block.codes().iter().enumerate() {
            let c = decode::<3>(code);
            assert_eq!(block.layers::<3>(number) as u32, (c[0] - 4) | c[1] << 2 | (c[2] - 6) << 4);
        }
        // Through the end of the period, and where it has three cells only.
        let block = Block::around_periodic::<2>(encode([8, 10]), 16, [5, 3]);
        let layers: Vec<_> =
            (0..block.codes().len()).map(|n| (decode::<2>(block.codes()[n])[0], block.layers::<2>(n))).collect();
        assert_eq!(layers.iter().map(|l| l.0).collect::<Vec<_>>(), [12, 12, 12, 8, 8, 8, 9, 9, 9]);
        assert_eq!(layers.iter().map(|l| l.1).collect::<Vec<_>>(), [12, 12, 12, 13, 13, 13, 14, 14, 14]);
    }
}
