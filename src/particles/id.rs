//! Global particle numbers: 64 bits, the body in the upper 16 and the lattice site within the body in the lower 48.
//! A particle so carries its body, and through it its mass and material, without a column for them.

#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ParticleId(pub u64);

impl ParticleId {
    pub const SITE_BITS: u32 = 48;

    #[inline]
    pub fn new(body: usize, site: u64) -> Self {
        debug_assert!(body < 1 << 16 && site < 1 << Self::SITE_BITS);
        Self((body as u64) << Self::SITE_BITS | site)
    }

    #[inline]
    pub fn body(self) -> usize {
        (self.0 >> Self::SITE_BITS) as usize
    }

    #[inline]
    pub fn site(self) -> u64 {
        self.0 & ((1 << Self::SITE_BITS) - 1)
    }
}
