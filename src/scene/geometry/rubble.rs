//! Rubble piles: blocks with voids between them. A pile follows from its seed alone, so that every rank has the same.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::shape::BodyShape;
use crate::random::{uniform, uniform_pair};

/// Places tried for a block before a pile is taken to be full.
const TRIES: u64 = 400_000;
/// Piles draw other numbers from a seed than what else uses it.
const PILE: u64 = 0x7275_6262_6c65;

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
struct Block {
    /// From the body's centre, m.
    centre: [f64; 3],
    radius: f64,
}

/// Spherical blocks (in 2D discs) that do not overlap, each as large as the room at its place and the largest radius allow: most touch others.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(from = "SentPile", into = "SentPile")]
pub struct Rubble {
    blocks: Vec<Block>,
    /// Blocks by the cell that their centre lies in; cells are as wide as the largest block.
    cells: BTreeMap<[i32; 3], Vec<u32>>,
    width: f64,
    /// Volume of all blocks, m^3 (m^2 in 2D).
    pub volume: f64,
}

/// A pile as it is sent.
#[derive(Serialize, Deserialize)]
struct SentPile {
    blocks: Vec<Block>,
    width: f64,
    volume: f64,
}

impl From<Rubble> for SentPile {
    fn from(Rubble { blocks, width, volume, .. }: Rubble) -> Self {
        Self { blocks, width, volume }
    }
}

impl From<SentPile> for Rubble {
    fn from(SentPile { blocks, width, volume }: SentPile) -> Self {
        let mut pile = Self { blocks: Vec::new(), cells: BTreeMap::new(), width, volume };
        blocks.into_iter().for_each(|block| pile.put(block));
        pile
    }
}

/// How a pile is packed; lengths in m.
#[derive(Debug, Clone, Copy)]
pub struct Packing {
    /// Radius of a block.
    pub smallest: f64,
    pub largest: f64,
    /// Largest share of the shape's volume between blocks.
    pub voids: f64,
    pub seed: u64,
}

impl Rubble {
    /// Packs a shape, block after block at random places; the pile as full as it gets is the error where more voids are left.
    pub fn pack(shape: &BodyShape, dimension: usize, packing: Packing) -> Result<Self, Self> {
        let Packing { smallest, largest, voids, seed } = packing;
        let whole = shape.volume(dimension);
        let mut pile = Self { blocks: Vec::new(), cells: BTreeMap::new(), width: 2.0 * largest, volume: 0.0 };
        for attempt in 0..TRIES {
            if pile.volume >= (1.0 - voids) * whole {
                return Ok(pile);
            }
            let Some(centre) = place(shape, dimension, seed ^ PILE, attempt) else { continue };
            let radius = pile.room(centre, shape.depth(centre, dimension).min(largest), smallest);
            if radius >= smallest {
                pile.add(Block { centre, radius }, dimension);
            }
        }
        Err(pile)
    }

    fn cell(&self, point: [f64; 3]) -> [i32; 3] {
        point.map(|x| (x / self.width).floor() as i32)
    }

    /// Blocks that a point could lie in or near.
    fn near(&self, point: [f64; 3]) -> impl Iterator<Item = &Block> {
        let [x, y, z] = self.cell(point);
        let offsets = (0..27).map(move |n| [x + n % 3 - 1, y + n / 3 % 3 - 1, z + n / 9 - 1]);
        offsets.filter_map(|cell| self.cells.get(&cell)).flatten().map(|&i| &self.blocks[i as usize])
    }

    /// The largest radius, up to `most`, of a sphere here that overlaps no other; anything below `least` where there is less room.
    fn room(&self, centre: [f64; 3], most: f64, least: f64) -> f64 {
        let mut room = most;
        for block in self.near(centre) {
            room = room.min(distance(centre, block.centre) - block.radius);
            if room < least {
                break;
            }
        }
        room
    }

    fn add(&mut self, block: Block, dimension: usize) {
        self.volume += BodyShape::Sphere { radius: block.radius }.volume(dimension);
        self.put(block);
    }

    fn put(&mut self, block: Block) {
        let cell = self.cell(block.centre);
        self.cells.entry(cell).or_default().push(self.blocks.len() as u32);
        self.blocks.push(block);
    }

    /// How deep a point lies in its block, m; `None` between blocks.
    pub fn depth(&self, point: [f64; 3]) -> Option<f64> {
        self.near(point).map(|block| block.radius - distance(point, block.centre)).find(|depth| *depth >= 0.0)
    }

    /// Number of blocks.
    pub fn count(&self) -> usize {
        self.blocks.len()
    }
}

/// A random place in a shape; `None` where the draw misses it.
pub(super) fn place(shape: &BodyShape, dimension: usize, seed: u64, draw: u64) -> Option<[f64; 3]> {
    let bounds = shape.bounds(dimension);
    let ([a, b], c) = (uniform_pair(seed, draw, 0), uniform(seed, draw, 2));
    let point: [f64; 3] = std::array::from_fn(|k| bounds.middle[k] + (2.0 * [a, b, c][k] - 1.0) * bounds.half[k]);
    shape.contains(point, dimension).then_some(point)
}

/// Distance of two points.
pub(super) fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| (a[k] - b[k]) * (a[k] - b[k])).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pile(shape: BodyShape, dimension: usize, radius: [f64; 2], voids: f64, seed: u64) -> Result<Rubble, Rubble> {
        Rubble::pack(&shape, dimension, Packing { smallest: radius[0], largest: radius[1], voids, seed })
    }

    /// Blocks lie within the shape, overlap nowhere, fill what they should, and most touch another.
    #[test]
    fn piles_are_packed() {
        let shapes = [
            (BodyShape::Sphere { radius: 1.0 }, 3, 0.55),
            (BodyShape::Sphere { radius: 1.0 }, 2, 0.3),
            (BodyShape::Box { size: [1.0, 2.0, 1.5] }, 3, 0.55),
            (BodyShape::Cylinder { radius: 1.0, height: 1.0 }, 3, 0.55),
            (BodyShape::HalfSphere { radius: 1.0, inner: 0.0 }, 3, 0.55),
        ];
        for (shape, dimension, voids) in shapes {
            let pile = pile(shape.clone(), dimension, [0.06, 0.25], voids, 1).unwrap();
            let mut touching = 0;
            for (i, a) in pile.blocks.iter().enumerate() {
                assert!((0.06..=0.25).contains(&a.radius));
                assert!(shape.depth(a.centre, dimension) >= a.radius);
                let gaps = pile.blocks.iter().enumerate().filter(|(j, _)| *j != i);
                let gap = gaps.map(|(_, b)| distance(a.centre, b.centre) - a.radius - b.radius).fold(9.0, f64::min);
                assert!(gap > -1e-12, "{shape:?}: blocks overlap by {gap}");
                touching += usize::from(gap < 1e-12);
                assert!((pile.depth(a.centre).unwrap() - a.radius).abs() < 1e-15);
            }
            assert!(touching * 10 > 6 * pile.count(), "{shape:?}: {touching} of {} touch", pile.count());
            // Points say the same as the sum of volumes.
            let draws = (0..200_000).filter_map(|draw| place(&shape, dimension, 7, draw));
            let (inside, all) =
                draws.fold((0, 0), |(inside, all), p| (inside + usize::from(pile.depth(p).is_some()), all + 1));
            let (found, expected) = (inside as f64 / all as f64, pile.volume / shape.volume(dimension));
            assert!((found - expected).abs() < 5e-3 && expected >= 1.0 - voids, "{shape:?}: {found} {expected}");
        }
    }

    #[test]
    fn piles_follow_from_their_seed() {
        let ball = |seed| pile(BodyShape::Sphere { radius: 1.0 }, 3, [0.1, 0.3], 0.6, seed).unwrap();
        assert_eq!(ball(1), ball(1));
        let sent = serde_json::to_string(&ball(1)).expect("numbers");
        assert_eq!(serde_json::from_str::<Rubble>(&sent).expect("what was written"), ball(1));
        assert_ne!(ball(1), ball(2));
    }

    #[test]
    fn a_full_pile_is_given_up() {
        let full = pile(BodyShape::Sphere { radius: 1.0 }, 3, [0.2, 0.3], 0.1, 1).unwrap_err();
        assert!(full.count() > 0 && full.volume < 0.9 * BodyShape::Sphere { radius: 1.0 }.volume(3));
    }
}
