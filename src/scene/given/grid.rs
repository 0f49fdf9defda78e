//! Cells of a grid that hold particles: where matter is, when it comes as particles.

use serde::{Deserialize, Serialize};

/// The cells, in the frame of the particles.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Grid {
    /// Edge of a cell, m.
    pub edge: f64,
    /// In ascending order.
    pub cells: Vec<[i64; 3]>,
}

/// Particles in a cell: so many that no cell within a lattice is empty, and so few that cells follow the surface.
const IN_A_CELL: [f64; 2] = [3.0, 6.0];
/// Edges that are tried.
const TRIALS: usize = 60;

impl Grid {
    /// Of these particles; in 2D their third coordinate is zero.
    pub fn of(positions: &[[f64; 3]]) -> Self {
        let extent = (0..3).map(|k| {
            let along = positions.iter().map(|x| x[k]);
            along.clone().fold(f64::NEG_INFINITY, f64::max) - along.fold(f64::INFINITY, f64::min)
        });
        let extent = extent.fold(0.0, f64::max);
        if extent <= 0.0 {
            return Self { edge: 1.0, cells: cells(positions, 1.0) };
        }
        let (mut edge, count) = (extent / (positions.len() as f64).sqrt(), positions.len() as f64);
        let mut found = cells(positions, edge);
        for _ in 0..TRIALS {
            let [least, most] = IN_A_CELL;
            let held = count / found.len() as f64;
            if (least..most).contains(&held) {
                break;
            }
            edge *= if held < least { 1.21 } else { 0.87 };
            if edge > 2.0 * extent {
                break;
            }
            found = cells(positions, edge);
        }
        Self { edge, cells: found }
    }

    /// Whether a point lies in one of them.
    pub fn holds(&self, point: &[f64; 3]) -> bool {
        self.cells.binary_search(&cell(point, self.edge)).is_ok()
    }
}

fn cells(positions: &[[f64; 3]], edge: f64) -> Vec<[i64; 3]> {
    let mut cells: Vec<[i64; 3]> = positions.iter().map(|x| cell(x, edge)).collect();
    cells.sort_unstable();
    cells.dedup();
    cells
}

fn cell(x: &[f64; 3], edge: f64) -> [i64; 3] {
    x.map(|x| (x / edge).floor() as i64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lattice_has_no_hole_and_ends_at_its_surface() {
        let site = |n: usize, shift: f64| [n % 20, n / 20 % 20, n / 400].map(|k| shift + 0.1 * k as f64 + 0.05);
        let points: Vec<_> = (0..8000).map(|n| site(n, 0.0)).chain((0..8000).map(|n| site(n, 7.0))).collect();
        let grid = Grid::of(&points);
        for n in 0..5000 {
            let inside = std::array::from_fn(|k| 1.0 + 1.9 * (crate::random::uniform(5, n, k as u64) - 0.5));
            assert!(grid.holds(&inside), "{inside:?}");
        }
        for outside in [[2.3, 1.0, 1.0], [1.0, -0.3, 1.0], [4.0, 4.0, 4.0], [6.7, 6.7, 6.7]] {
            assert!(!grid.holds(&outside), "{outside:?}");
        }
        assert!(grid.holds(&[8.0, 8.0, 8.0]));
    }

    #[test]
    fn few_particles_lie_somewhere_too() {
        for points in [&[[1.0, 2.0, 3.0]][..], &[[0.0; 3], [1.0, 0.0, 0.0]], &[[0.0; 3]; 4]] {
            let grid = Grid::of(points);
            assert!(points.iter().all(|x| grid.holds(x)), "{points:?}");
        }
    }
}
