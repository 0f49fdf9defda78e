//! Counter-based random numbers: a draw is a pure function of (seed, global id, draw), so that a particle has the same
//! numbers whatever rank holds it and whenever they are drawn. Philox4x32-10, Salmon et al. 2011 (SC11), section 4.

/// Four 32-bit words for one counter and key.
#[inline]
fn philox(mut counter: [u32; 4], mut key: [u32; 2]) -> [u32; 4] {
    for _ in 0..10 {
        let a = counter[0] as u64 * 0xD251_1F53;
        let b = counter[2] as u64 * 0xCD9E_8D57;
        counter = [(b >> 32) as u32 ^ counter[1] ^ key[0], b as u32, (a >> 32) as u32 ^ counter[3] ^ key[1], a as u32];
        key = [key[0].wrapping_add(0x9E37_79B9), key[1].wrapping_add(0xBB67_AE85)];
    }
    counter
}

/// Uniform draws in the open interval (0, 1), two at a time: numbers `2 pair` and `2 pair + 1` of particle `id`.
#[inline]
pub fn uniform_pair(seed: u64, id: u64, pair: u64) -> [f64; 2] {
    let c =
        philox([pair as u32, (pair >> 32) as u32, id as u32, (id >> 32) as u32], [seed as u32, (seed >> 32) as u32]);
    let unit = |hi: u32, lo: u32| {
        let bits = ((hi as u64) << 32 | lo as u64) >> 12;
        (bits as f64 + 0.5) * (1.0 / (1u64 << 52) as f64)
    };
    [unit(c[0], c[1]), unit(c[2], c[3])]
}

/// Draw number `draw` of particle `id`.
#[inline]
pub fn uniform(seed: u64, id: u64, draw: u64) -> f64 {
    uniform_pair(seed, id, draw / 2)[(draw % 2) as usize]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Known answers of Random123 1.09 for Philox4x32-10.
    #[test]
    fn philox_known_answers() {
        assert_eq!(philox([0; 4], [0; 2]), [0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8]);
        assert_eq!(philox([u32::MAX; 4], [u32::MAX; 2]), [0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd]);
    }

    #[test]
    fn draws_are_uniform_and_open() {
        let n = 100_000;
        let (mut sum, mut square) = (0.0, 0.0);
        for id in 0..n {
            let u = uniform(7, id, 3);
            assert!(u > 0.0 && u < 1.0);
            sum += u;
            square += u * u;
        }
        let (mean, second) = (sum / n as f64, square / n as f64);
        // Four standard errors of the mean: 4 / sqrt(12 n) = 3.7e-3.
        assert!((mean - 0.5).abs() < 3.7e-3 && (second - 1.0 / 3.0).abs() < 4e-3);
    }
}
