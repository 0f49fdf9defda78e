//! Joints that part rock into blocks. They follow from their seed alone, so that every rank has the same.

use serde::{Deserialize, Serialize};

use super::rubble::{distance, place};
use super::shape::BodyShape;

/// Joints draw other numbers from a seed than what else uses it.
const JOINTS: u64 = 0x6a6f_696e_7473;

/// Faces of the Voronoi cells around random places, the seeds of the blocks.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Joints {
    seeds: Vec<[f64; 3]>,
}

impl Joints {
    /// Joints between `blocks` (two or more) blocks of a shape.
    pub fn new(shape: &BodyShape, dimension: usize, blocks: usize, seed: u64) -> Self {
        let places = (0..).filter_map(|draw| place(shape, dimension, seed ^ JOINTS, draw));
        Self { seeds: places.take(blocks).collect() }
    }

    /// Distance of a point from the nearest face between two blocks, m.
    pub fn depth(&self, point: [f64; 3]) -> f64 {
        let squares = |seed: &[f64; 3]| (0..3).map(|k| (point[k] - seed[k]) * (point[k] - seed[k])).sum::<f64>();
        let own = self.seeds.iter().min_by(|a, b| squares(a).total_cmp(&squares(b))).expect("two seeds or more");
        let to_face = |other: &[f64; 3]| (squares(other) - squares(own)) / (2.0 * distance(*own, *other));
        self.seeds.iter().filter(|seed| *seed != own).map(to_face).fold(f64::INFINITY, f64::min)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The face between two seeds is the plane half-way; of many, the next face is never farther than half the way to any.
    #[test]
    fn joints_lie_between_blocks() {
        let two = Joints { seeds: vec![[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]] };
        assert_eq!(two.depth([0.25, 3.0, 4.0]), 0.25);
        assert_eq!(two.depth([-0.5, 0.0, 0.0]), 0.5);
        let many = Joints::new(&BodyShape::Sphere { radius: 1.0 }, 3, 40, 3);
        assert_eq!(many.seeds.len(), 40);
        for seed in &many.seeds {
            let others = many.seeds.iter().filter(|other| *other != seed);
            let nearest = others.map(|other| distance(*seed, *other)).fold(9.0, f64::min);
            assert!((many.depth(*seed) - 0.5 * nearest).abs() < 1e-12);
        }
    }
}
