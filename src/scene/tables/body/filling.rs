//! How a shape is filled with a lattice: by a spacing, or by the number of particles.

use crate::error::Result;
use crate::scene::geometry::lattice::{Faces, Lattice, LatticeKind, Rotation};
use crate::scene::geometry::rubble::Rubble;
use crate::scene::geometry::shape::BodyShape;

/// Bodies of up to this many lattice sites are counted when read; larger ones are close to their expected number.
pub const COUNTED: u64 = 400_000;

/// Whether there is matter at a place relative to the centre of a shape.
pub fn is_filled(local: [f64; 3], shape: &BodyShape, rubble: Option<&Rubble>, dimension: usize) -> bool {
    shape.contains(local, dimension) && rubble.is_none_or(|rubble| rubble.depth(local).is_some())
}

/// A shape to be filled with a lattice.
pub struct Filling<'a> {
    pub kind: LatticeKind,
    pub rotation: Rotation,
    pub shape: &'a BodyShape,
    pub rubble: Option<&'a Rubble>,
    pub dimension: usize,
    pub faces: Faces,
}

impl Filling<'_> {
    /// The lattice of this spacing, m.
    pub fn lattice(&self, spacing: f64) -> Result<Lattice> {
        Lattice::covering(self.kind, spacing, self.rotation, self.shape.bounds(self.dimension), self.faces)
    }

    fn spacing_of(&self, particles: f64) -> f64 {
        let volume = self.rubble.map_or_else(|| self.shape.volume(self.dimension), |rubble| rubble.volume);
        self.kind.spacing_of_cell(volume / particles, self.dimension)
    }

    fn count(&self, lattice: &Lattice) -> u64 {
        let holds = |site: &u64| is_filled(lattice.position(*site), self.shape, self.rubble, self.dimension);
        (0..lattice.sites()).filter(holds).count() as u64
    }

    /// The spacing follows from the volume; flat faces can hold a row more or less than that, so spacings near it are tried
    /// until the number is within one per cent. Where none is (rows come and go as a whole), the nearest is taken.
    pub fn with_particles(&self, particles: u64) -> Result<Lattice> {
        let expected = self.spacing_of(particles as f64);
        let mut best = self.lattice(expected)?;
        if best.sites() > COUNTED {
            return Ok(best);
        }
        let mut least = self.count(&best).abs_diff(particles);
        for trial in 2..=60 {
            if 100 * least <= particles {
                break;
            }
            let side = if trial % 2 == 0 { 1.0 } else { -1.0 };
            let lattice = self.lattice(expected * (1.0 + side * 0.002 * (trial / 2) as f64))?;
            let off = self.count(&lattice).abs_diff(particles);
            if off < least {
                (best, least) = (lattice, off);
            }
        }
        Ok(best)
    }

    /// The given spacing, or finer until there are `particles`.
    pub fn at_least(&self, particles: u64, spacing: f64) -> Result<Lattice> {
        let mut spacing = spacing.min(self.spacing_of(particles as f64));
        loop {
            let lattice = self.lattice(spacing)?;
            if lattice.sites() > COUNTED || self.count(&lattice) >= particles {
                return Ok(lattice);
            }
            spacing *= 0.99;
        }
    }
}
