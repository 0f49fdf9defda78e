//! The state of a run as one number that does not depend on order or decomposition: the sum modulo 2^256, over all particles,
//! of blake3 of the particle's global id and its state columns, and of blake3 of the other state that later steps depend on. Two
//! runs agree in it exactly when they agree bit for bit.

use std::fmt;

use rayon::prelude::*;

use crate::domain::comm::Comm;
use crate::particles::{Column, Columns, ParticleId};

/// 32-bit limbs of a sum: with 64-bit integers, 2^31 ranks can be added before one overflows.
const LIMBS: usize = 8;

/// A sum of 256-bit hashes modulo 2^256.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct HashSum {
    /// Least significant first.
    words: [u64; 4],
}

impl HashSum {
    pub fn add(&mut self, hash: &blake3::Hash) {
        let bytes = hash.as_bytes();
        let words = std::array::from_fn(|k| u64::from_le_bytes(std::array::from_fn(|b| bytes[8 * k + b])));
        self.merge(&Self { words });
    }

    pub fn merge(&mut self, other: &Self) {
        let mut carry = false;
        for (a, b) in self.words.iter_mut().zip(other.words) {
            let (sum, over) = a.overflowing_add(b);
            let (sum, again) = sum.overflowing_add(carry as u64);
            (*a, carry) = (sum, over || again);
        }
    }

    /// Each sum added over all ranks, exactly.
    pub fn over_ranks(sums: &[Self], comm: &Comm) -> Vec<Self> {
        let mut limbs: Vec<i64> = sums.iter().flat_map(|s| s.limbs()).collect();
        comm.all_sum(&mut limbs);
        limbs.chunks_exact(LIMBS).map(Self::of_limbs).collect()
    }

    fn limbs(&self) -> [i64; LIMBS] {
        std::array::from_fn(|k| (self.words[k / 2] >> (32 * (k % 2)) & 0xffff_ffff) as i64)
    }

    fn of_limbs(limbs: &[i64]) -> Self {
        let (mut words, mut carry) = ([0; 4], 0u64);
        for (k, &limb) in limbs.iter().enumerate() {
            let sum = limb as u64 + carry;
            words[k / 2] |= (sum & 0xffff_ffff) << (32 * (k % 2));
            carry = sum >> 32;
        }
        Self { words }
    }
}

/// 64 hexadecimal digits, most significant first.
impl fmt::Display for HashSum {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.words.iter().rev().try_for_each(|word| write!(f, "{word:016x}"))
    }
}

/// Indices of the state columns, in registry order.
pub fn state_columns(columns: &Columns) -> Vec<usize> {
    let entries = columns.registry.entries.iter().enumerate();
    entries.filter(|(_, entry)| entry.info.life.is_state()).map(|(index, _)| index).collect()
}

/// This rank's share of the sum over particles of blake3(id, words of the columns `which`), little-endian. The id, which
/// comes first, is left out where it is one of the columns.
pub fn hash_columns(columns: &Columns, id: Column<ParticleId>, which: &[usize]) -> HashSum {
    let which: Vec<usize> = which.iter().copied().filter(|&index| index != id.index).collect();
    let add_particle = |(mut sum, mut bytes): (HashSum, Vec<u8>), i: usize| {
        bytes.clear();
        bytes.extend_from_slice(&columns.get(id, i).0.to_le_bytes());
        for &index in &which {
            let width = columns.width(index);
            let words = &columns.words(index)[i * width..(i + 1) * width];
            words.iter().for_each(|word| bytes.extend_from_slice(&word.to_le_bytes()));
        }
        sum.add(&blake3::hash(&bytes));
        (sum, bytes)
    };
    let merge = |mut a: HashSum, b: HashSum| {
        a.merge(&b);
        a
    };
    let parts = (0..columns.len()).into_par_iter().fold(|| (HashSum::default(), Vec::new()), add_particle);
    parts.map(|(sum, _)| sum).reduce(HashSum::default, merge)
}

/// The hash of the whole state, the same for any ranks and threads: that of the columns, and of the state `beside` them that all
/// ranks know. Collective.
pub fn state_hash(columns: &Columns, id: Column<ParticleId>, beside: &[u8], comm: &Comm) -> String {
    let mine = hash_columns(columns, id, &state_columns(columns));
    let mut sum = HashSum::over_ranks(&[mine], comm)[0];
    sum.add(&blake3::hash(beside));
    sum.to_string()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::{Core, declare_core};
    use crate::particles::Registry;

    fn particles(order: &[u64]) -> (Columns, Core) {
        let mut registry = Registry::new(3);
        let core = declare_core(&mut registry);
        let mut columns = Columns::new(registry);
        columns.resize(order.len());
        for (i, &site) in order.iter().enumerate() {
            columns.set(core.id, i, ParticleId::new(1, site));
            columns.set(core.density.value, i, 2700.0 + site as f64);
        }
        (columns, core)
    }

    fn hash(columns: &Columns, core: &Core) -> HashSum {
        hash_columns(columns, core.id, &state_columns(columns))
    }

    #[test]
    fn order_and_scratch_do_not_count_but_every_bit_of_the_state_does() {
        let (mut a, core) = particles(&[1, 2, 3]);
        let (b, _) = particles(&[3, 1, 2]);
        assert_eq!(hash(&a, &core), hash(&b, &core));
        a.set(core.pressure, 0, 1e9);
        assert_eq!(hash(&a, &core), hash(&b, &core));
        a.words_mut(core.density.value.index)[2] ^= 1;
        assert_ne!(hash(&a, &core), hash(&b, &core));
    }

    #[test]
    fn parts_add_up_to_the_whole() {
        let (whole, core) = particles(&[1, 2, 3, 4]);
        let (first, second) = (particles(&[4, 2]).0, particles(&[1, 3]).0);
        let (mut limbs, others) = (hash(&first, &core).limbs(), hash(&second, &core).limbs());
        limbs.iter_mut().zip(others).for_each(|(a, b)| *a += b);
        assert_eq!(HashSum::of_limbs(&limbs), hash(&whole, &core));
    }

    #[test]
    fn the_sum_is_modulo_two_to_the_256() {
        let mut sum = HashSum { words: [u64::MAX; 4] };
        sum.merge(&HashSum { words: [1, 0, 0, 0] });
        assert_eq!(sum, HashSum::default());
        assert_eq!(HashSum { words: [10, 0, 0, 1 << 60] }.to_string(), format!("1{:063x}", 10));
    }
}
