//! Cells of the global lattice: octants of octants of one root cube, named by Morton keys.

use crate::domain::comm::Comm;
use crate::math::Vec3;

/// Halvings of the root cube; a key has three bits for each.
pub const DEEPEST: u32 = 21;

/// The cube that holds all bodies: its side is a power of two and its place the least corner of them all, so that it
/// depends on nothing but them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Root {
    corner: Vec3,
    /// Length of the edges, m.
    side: f64,
}

impl Root {
    /// Collective.
    pub async fn around<'a>(comm: &Comm, positions: impl Iterator<Item = &'a [f64; 3]>) -> Self {
        let mut ends = vec![f64::INFINITY; 6];
        for p in positions {
            for k in 0..3 {
                ends[k] = ends[k].min(p[k]);
                ends[3 + k] = ends[3 + k].min(-p[k]);
            }
        }
        let ends = comm.all_min_later(ends).await;
        let extent = (0..3).map(|k| -ends[3 + k] - ends[k]).fold(0.0, f64::max);
        // extent = f 2^e with f in [1/2, 1): the cube is larger than their box, and no more than twice.
        let side = libm::ldexp(1.0, libm::frexp(extent).1);
        Self { corner: Vec3::new(ends[0], ends[1], ends[2]), side }
    }

    /// Morton key of the deepest cell around a place.
    pub fn key(&self, position: &[f64; 3]) -> u64 {
        key_within(&self.within(position))
    }

    /// Length of the edges, m.
    pub fn side(&self) -> f64 {
        self.side
    }

    /// A place in sides of the cube from its corner.
    pub fn within(&self, position: &[f64; 3]) -> [f64; 3] {
        std::array::from_fn(|k| (position[k] - self.corner[k]) / self.side)
    }
}

/// Morton key of the deepest cell around a place given in sides of the root cube from its corner.
pub fn key_within(place: &[f64; 3]) -> u64 {
    let cells = (1u64 << DEEPEST) as f64;
    let axis = |k: usize| ((place[k] * cells) as u64).min((1 << DEEPEST) - 1);
    spread(axis(0)) << 2 | spread(axis(1)) << 1 | spread(axis(2))
}

/// A cell: `level` halvings below the root, `path` the octants on the way, three bits each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cell {
    pub level: u32,
    pub path: u64,
}

impl Cell {
    pub const ROOT: Self = Self { level: 0, path: 0 };

    pub fn child(self, octant: u64) -> Self {
        Self { level: self.level + 1, path: self.path << 3 | octant }
    }

    /// Geometric centre, in sides of the root cube from its corner.
    pub fn middle(self) -> [f64; 3] {
        let width = 1.0 / (1u64 << self.level) as f64;
        let axis = |shift: u32| (gather(self.first_key() >> shift) >> (DEEPEST - self.level)) as f64 + 0.5;
        [axis(2) * width, axis(1) * width, axis(0) * width]
    }

    /// The least key in the cell.
    pub fn first_key(self) -> u64 {
        self.path << (3 * (DEEPEST - self.level))
    }

    /// The least key after the cell.
    pub fn end_key(self) -> u64 {
        (self.path + 1) << (3 * (DEEPEST - self.level))
    }
}

/// Every bit of a 21-bit number moved to three times its place.
fn spread(x: u64) -> u64 {
    let x = (x | x << 32) & 0x001f_0000_0000_ffff;
    let x = (x | x << 16) & 0x001f_0000_ff00_00ff;
    let x = (x | x << 8) & 0x100f_00f0_0f00_f00f;
    let x = (x | x << 4) & 0x10c3_0c30_c30c_30c3;
    (x | x << 2) & 0x1249_2492_4924_9249
}

/// The inverse of [`spread`], other bits ignored.
fn gather(x: u64) -> u64 {
    let x = x & 0x1249_2492_4924_9249;
    let x = (x | x >> 2) & 0x10c3_0c30_c30c_30c3;
    let x = (x | x >> 4) & 0x100f_00f0_0f00_f00f;
    let x = (x | x >> 8) & 0x001f_0000_ff00_00ff;
    let x = (x | x >> 16) & 0x001f_0000_0000_ffff;
    (x | x >> 32) & 0x1f_ffff
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_lies_in_every_cell_that_its_key_names() {
        let root = Root { corner: Vec3::new(-3.0, 1.0, 5.0), side: 8.0 };
        let place = [1.7, 8.99, 5.01];
        let key = root.key(&place);
        for level in 0..=DEEPEST {
            let cell = Cell { level, path: key >> (3 * (DEEPEST - level)) };
            assert!((cell.first_key()..cell.end_key()).contains(&key));
            let off = (Vec3::from(root.within(&place)) - Vec3::from(cell.middle())).amax();
            assert!(off <= 0.5 / (1u64 << level) as f64, "level {level}: {off}");
        }
    }

    #[test]
    fn gather_undoes_spread() {
        for x in [0, 1, 0x155555, 0x1fffff, 0x0a_bcde] {
            assert_eq!(gather(spread(x)), x);
        }
        assert_eq!(spread(0b101), 0b001_000_001);
    }
}
