//! The lattice of cells and the canonical order of particles. The lattice has a fixed origin and base side, so that a
//! particle's cell depends on its position alone. Cells come in levels, each twice as wide as the one below: a particle
//! lives in the first level whose cells are as wide as its list radius.

use super::curve;
use super::periods::Periods;

/// The widest level: two cells per dimension.
pub const MAX_LEVEL: u32 = curve::BITS - 1;

/// Cells are this much wider than the radii they hold, so that rounding in `x / side` cannot separate neighbours.
const MARGIN: f64 = 1.0 + 1.0 / (1 << 20) as f64;

/// Far below that margin, far above rounding.
const HAIR: f64 = 1.0 / (1u64 << 40) as f64;

/// A particle of the neighbour search: state at the last list build.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Site<const D: usize> {
    pub id: u64,
    /// m
    pub position: [f64; D],
    /// List radius: the kernel's support and the skin, m.
    pub radius: f64,
}

impl<const D: usize> Site<D> {
    /// The image at this shift.
    #[inline]
    pub fn shifted(&self, shift: &[f64; D]) -> Self {
        Self { position: std::array::from_fn(|k| self.position[k] + shift[k]), ..*self }
    }
}

/// The canonical order: level, cell along the curve, global id.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    pub level: u32,
    /// Morton code of the cell within its level.
    pub cell: u64,
    pub id: u64,
}

/// Cells of all levels: fixed for the run. Along a periodic axis a whole number of cells makes one period, at every level
/// that the scene's bodies need.
#[derive(Debug, Clone, Copy)]
pub struct Lattice {
    /// Sides of the cells of level 0, m.
    sides: [f64; 3],
    origin: [f64; 3],
    /// Cells of level 0 in a period; zero along open axes.
    period: [u32; 3],
}

impl Lattice {
    /// `radius`: the smallest list radius of the scene; smaller ones that come later live in level 0 all the same.
    pub fn new(radius: f64) -> Self {
        Self { sides: [radius * MARGIN; 3], origin: [0.0; 3], period: [0; 3] }
    }

    /// The lattice of a periodic domain; list radii up to `largest` get levels that fit into the periods, which must
    /// be twice as long.
    pub fn periodic(radius: f64, largest: f64, periods: &Periods) -> Self {
        let mut lattice = Self::new(radius);
        // Cells along periodic axes are a little wider than requested, so the level is found with the others.
        let level = lattice.level(largest);
        for axis in (0..3).filter(|&axis| periods.closed(axis)) {
            let widest = lattice.sides[axis] * (1u64 << level) as f64;
            let cells = ((periods.length[axis] / widest) as u32).max(1) << level;
            // So little too wide that rounding puts no position of the period into the cell beyond its end.
            lattice.sides[axis] = periods.length[axis] / cells as f64 * (1.0 + HAIR);
            lattice.origin[axis] = periods.low[axis];
            lattice.period[axis] = cells;
        }
        lattice
    }

    /// Smallest side of a level's cells, m.
    pub fn side(&self, level: u32) -> f64 {
        self.sides.iter().fold(f64::INFINITY, |a, &b| a.min(b)) * (1u64 << level) as f64
    }

    /// Cells per edge of the lattice.
    pub fn cells(level: u32) -> u32 {
        1 << (curve::BITS - level)
    }

    pub fn is_periodic(&self) -> bool {
        self.period != [0; 3]
    }

    /// Cells of a level in a period along each axis, zero along open ones; `None` where a level does not fit into them.
    pub fn period<const D: usize>(&self, level: u32) -> Option<[u32; D]> {
        let fits = self.period.iter().all(|cells| cells % (1 << level) == 0);
        fits.then(|| std::array::from_fn(|k| self.period[k] >> level))
    }

    /// The first level whose cells are as wide as `radius`. In the last level all cells touch, whatever the radius.
    pub fn level(&self, radius: f64) -> u32 {
        (0..MAX_LEVEL).find(|&level| radius * MARGIN <= self.side(level)).unwrap_or(MAX_LEVEL)
    }

    /// Coordinates of the cell of level 0. Positions outside the lattice belong to its outermost cells: clamping brings
    /// cells nearer to each other, never apart. Those of level l follow by dropping l bits.
    pub fn coordinates<const D: usize>(&self, position: &[f64; D]) -> [u32; D] {
        let half = Self::cells(1) as f64;
        std::array::from_fn(|k| {
            let cell = ((position[k] - self.origin[k]) / self.sides[k]).clamp(-half, half - 1.0);
            // The next lower integer; without SSE4 it would be a call.
            let towards_zero = cell as i32;
            (towards_zero - (cell < towards_zero as f64) as i32 + half as i32) as u32
        })
    }

    /// Whether a position lies in the upper half of its cell of some level, along each axis.
    pub fn upper_half<const D: usize>(&self, position: &[f64; D], level: u32) -> [bool; D] {
        if level > 0 {
            return self.coordinates(position).map(|c| c >> (level - 1) & 1 == 1);
        }
        let half = Self::cells(1) as f64;
        std::array::from_fn(|k| {
            let cell = ((position[k] - self.origin[k]) / self.sides[k]).clamp(-half, half - 0.5);
            cell - cell.floor() >= 0.5
        })
    }

    pub fn place<const D: usize>(&self, site: &Site<D>) -> Place {
        let level = self.level(site.radius);
        Place { level, cell: curve::encode(self.coordinates(&site.position)) >> (D as u32 * level), id: site.id }
    }
}

/// From the code of a cell to a range: open addressing, at most half full.
#[derive(Debug, Default)]
pub struct CellTable {
    entries: Vec<(u64, u32, u32)>,
    shift: u32,
}

impl CellTable {
    /// Empties the table and makes room for `cells` cells.
    pub fn reset(&mut self, cells: usize) {
        let size = (2 * cells).next_power_of_two().max(2);
        self.entries.clear();
        self.entries.resize(size, (0, 0, 0));
        self.shift = 64 - size.trailing_zeros();
    }

    /// Ranges are not empty; each code comes once.
    pub fn insert(&mut self, code: u64, start: u32, end: u32) {
        debug_assert!(start < end);
        let mut at = self.first(code);
        while self.entries[at].2 != 0 {
            at = (at + 1) & (self.entries.len() - 1);
        }
        self.entries[at] = (code, start, end);
    }

    #[inline]
    pub fn get(&self, code: u64) -> Option<(u32, u32)> {
        let mut at = self.first(code);
        loop {
            let (found, start, end) = self.entries[at];
            if end == 0 {
                return None;
            }
            if found == code {
                return Some((start, end));
            }
            at = (at + 1) & (self.entries.len() - 1);
        }
    }

    /// Multiplication by 2^64 / golden ratio, upper bits (Knuth, The Art of Computer Programming 3, section 6.4).
    #[inline]
    fn first(&self, code: u64) -> usize {
        (code.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> self.shift) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_hold_their_radii() {
        let lattice = Lattice::new(2.0);
        assert_eq!([0.5, 2.0, 2.1, 4.0, 4.1, 1e30].map(|r| lattice.level(r)), [0, 0, 1, 1, 2, MAX_LEVEL]);
    }

    #[test]
    fn a_period_is_a_whole_number_of_cells() {
        let periods = Periods { low: [0.0, -1.0, 0.0], length: [0.0, 10.0, 5.0] };
        let lattice = Lattice::periodic(0.6, 1.5, &periods);
        // Level 2 holds 1.5 in cells of 2.4: four of them in y, two in z.
        assert_eq!(lattice.level(1.5), 2);
        assert_eq!([0, 2].map(|level| lattice.period::<3>(level)), [Some([0, 16, 8]), Some([0, 4, 2])]);
        assert_eq!(lattice.period::<3>(4), None);
        let cell = |y: f64| lattice.coordinates(&[0.0, y, 0.0])[1];
        assert_eq!(cell(9.0f64.next_down()) - cell(-1.0), 15);
        assert!((0..1000).all(|k| lattice.level(0.6 + 0.001 * k as f64) >= Lattice::new(0.6).level(0.6)));
    }

    #[test]
    fn clamping_brings_cells_nearer_never_apart() {
        let lattice = Lattice::new(1.0);
        let edge = lattice.side((Lattice::cells(1)).trailing_zeros());
        for x in [edge - 3.0, edge - 0.5, edge, 5.0 * edge, -edge, -edge - 0.1, -7.0 * edge, 0.0, -1e-300] {
            for step in [0.0, 0.3, 0.999_999, 1.0] {
                let [a, b] = [x, x + step].map(|x| lattice.coordinates(&[x])[0]);
                assert!(b - a <= 1, "{x} and {}: cells {a} and {b}", x + step);
            }
        }
        assert_eq!(lattice.coordinates(&[f64::INFINITY, f64::NEG_INFINITY]), [Lattice::cells(0) - 1, 0]);
    }

    #[test]
    fn tables_find_what_was_put_in() {
        let mut table = CellTable::default();
        table.reset(1000);
        for k in 0..1000u64 {
            table.insert(k << 20, k as u32, k as u32 + 1);
        }
        for k in 0..1000u64 {
            assert_eq!(table.get(k << 20), Some((k as u32, k as u32 + 1)));
            assert_eq!(table.get(k << 20 | 1), None);
        }
        table.reset(0);
        assert_eq!(table.get(0), None);
    }
}
