//! The shape of matter that comes as particles: the cells of a grid in which some of them are.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::lattice::Rotation;
use crate::scene::given::grid::Grid;

/// Cells in the frame of the particles, and how these stand in the body's.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Voxels {
    grid: Arc<Grid>,
    /// What is the body's centre, in the frame of the particles, m.
    origin: [f64; 3],
    /// From their axes to the body's.
    rotation: Rotation,
    /// Of the matter, m^3 (in 2D m^2).
    pub volume: f64,
    /// Least and largest coordinate along each axis of the body, m.
    pub bounds: [[f64; 2]; 3],
    /// Largest distance from the body's centre, m.
    pub outer_radius: f64,
}

impl Voxels {
    /// `origin` (m) becomes the centre, and the axes are turned. `volume`: of the matter, m^3 (m^2 in 2D).
    pub fn new(grid: Arc<Grid>, origin: [f64; 3], rotation: Rotation, volume: f64, dimension: usize) -> Self {
        let (mut bounds, mut outer) = ([[f64::INFINITY, f64::NEG_INFINITY]; 3], 0.0f64);
        for cell in &grid.cells {
            for corner in 0..1i64 << dimension {
                let place: [f64; 3] = std::array::from_fn(|k| {
                    let x = (cell[k] + (corner >> k & 1)) as f64 * grid.edge - origin[k];
                    if k < dimension { x } else { 0.0 }
                });
                let x: [f64; 3] = std::array::from_fn(|a| (0..3).map(|b| rotation[a][b] * place[b]).sum());
                outer = outer.max(x.iter().map(|x| x * x).sum::<f64>().sqrt());
                (0..3).for_each(|k| bounds[k] = [bounds[k][0].min(x[k]), bounds[k][1].max(x[k])]);
            }
        }
        Self { grid, origin, rotation, volume, bounds, outer_radius: outer }
    }

    /// The same extent, without a place in it.
    pub fn without_cells(&self) -> Self {
        Self { grid: Arc::new(Grid { edge: self.grid.edge, cells: Vec::new() }), ..self.clone() }
    }

    pub fn contains(&self, point: [f64; 3]) -> bool {
        let turned = |b: usize| (0..3).map(|a| self.rotation[a][b] * point[a]).sum::<f64>();
        self.grid.holds(&std::array::from_fn(|b| self.origin[b] + turned(b)))
    }
}

#[cfg(test)]
mod tests {
    use super::super::lattice::rotation_about;
    use super::*;

    #[test]
    fn shapes_turn_with_their_body() {
        let site = |n: usize| [n % 20, n / 20 % 20, n / 400].map(|k| 0.1 * k as f64 + 0.05);
        let grid = Arc::new(Grid::of(&(0..8000).map(site).collect::<Vec<_>>()));
        let quarter = rotation_about([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2);
        let turned = Voxels::new(grid, [0.0; 3], quarter, 8.0, 3);
        // x -> y, y -> -x.
        assert!(turned.contains([-1.5, 0.5, 1.0]) && !turned.contains([1.5, 0.5, 1.0]));
        assert!((turned.bounds[0][0] + 2.0).abs() < 0.2 && turned.bounds[0][1].abs() < 0.1);
        assert!((turned.outer_radius - 12f64.sqrt()).abs() < 0.3);
    }
}
