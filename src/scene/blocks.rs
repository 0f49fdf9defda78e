//! Bodies of blocks: rubble piles of spheres with voids between them, and rock that joints part into blocks. Both follow from a seed
//! alone, so that every rank has the same.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::shape::Shape;
use super::source::Document;
use crate::error::Result;
use crate::random::{uniform, uniform_pair};
use crate::units::{Length, Number};

/// Places tried for a block before a pile is taken to be full.
const TRIES: u64 = 400_000;
/// A seed of its own for each use of random numbers.
const PILE: u64 = 0x7275_6262_6c65;
const JOINTS: u64 = 0x6a6f_696e_7473;
const MOST_BLOCKS: u64 = 100_000;

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawRubble {
    /// Smallest and largest radius of a block.
    radius: [Length; 2],
    /// Share of the body's volume between blocks.
    voids: Number,
    #[serde(default = "first_seed")]
    seed: u64,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawJoints {
    blocks: u64,
    #[serde(default = "first_seed")]
    seed: u64,
}

fn first_seed() -> u64 {
    1
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
struct Sphere {
    /// From the body's centre, m.
    centre: [f64; 3],
    radius: f64,
}

/// Spheres (in 2D discs) that do not overlap, each as large as the room at its place and the largest radius allow: most touch others.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(from = "Packed", into = "Packed")]
pub struct Rubble {
    spheres: Vec<Sphere>,
    /// Spheres by the cell that their centre lies in; cells are as wide as the largest sphere.
    cells: BTreeMap<[i32; 3], Vec<u32>>,
    width: f64,
    /// Of all spheres, m^3 (m^2 in 2D).
    pub volume: f64,
}

/// A pile as it is sent.
#[derive(Serialize, Deserialize)]
struct Packed {
    spheres: Vec<Sphere>,
    width: f64,
    volume: f64,
}

impl From<Rubble> for Packed {
    fn from(Rubble { spheres, width, volume, .. }: Rubble) -> Self {
        Self { spheres, width, volume }
    }
}

impl From<Packed> for Rubble {
    fn from(Packed { spheres, width, volume }: Packed) -> Self {
        let mut pile = Self { spheres: Vec::new(), cells: BTreeMap::new(), width, volume };
        spheres.into_iter().for_each(|sphere| pile.put(sphere));
        pile
    }
}

impl RawRubble {
    pub(super) fn pile(&self, document: &Document, path: &str, shape: &Shape, dimension: usize) -> Result<Rubble> {
        let [smallest, largest] = self.radius.map(|radius| radius.0);
        if !(0.0 < smallest && smallest <= largest) {
            let what = format!("radii of blocks from {} to {}", self.radius[0], self.radius[1]);
            return Err(document
                .error(&format!("{path}.radius"), what)
                .allowed("two lengths above zero, the smaller first"));
        }
        if !(0.0..1.0).contains(&self.voids.0) {
            let what = format!("voids are {}", self.voids);
            return Err(document.error(&format!("{path}.voids"), what).allowed("a share from 0 to below 1"));
        }
        let whole = shape.volume(dimension);
        let mut pile = Rubble { spheres: Vec::new(), cells: BTreeMap::new(), width: 2.0 * largest, volume: 0.0 };
        for attempt in 0..TRIES {
            if pile.volume >= (1.0 - self.voids.0) * whole {
                return Ok(pile);
            }
            let centre = place(shape, dimension, self.seed ^ PILE, attempt);
            let Some(centre) = centre else { continue };
            let radius = pile.room(centre, shape.depth(centre, dimension).min(largest), smallest);
            if radius >= smallest {
                pile.add(Sphere { centre, radius }, dimension);
            }
        }
        let left = 1.0 - pile.volume / whole;
        let what =
            format!("voids of {} are not reached: {left:.3} are left beside {} blocks", self.voids, pile.spheres.len());
        Err(document
            .error(&format!("{path}.voids"), what)
            .allowed(format!("{:.2} or more, or smaller blocks", left + 0.005)))
    }
}

/// A random place in a shape; `None` where the draw misses it.
fn place(shape: &Shape, dimension: usize, seed: u64, draw: u64) -> Option<[f64; 3]> {
    let bounds = shape.bounds(dimension);
    let ([a, b], c) = (uniform_pair(seed, draw, 0), uniform(seed, draw, 2));
    let point: [f64; 3] = std::array::from_fn(|k| bounds.middle[k] + (2.0 * [a, b, c][k] - 1.0) * bounds.half[k]);
    shape.contains(point, dimension).then_some(point)
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| (a[k] - b[k]) * (a[k] - b[k])).sum::<f64>().sqrt()
}

impl Rubble {
    fn cell(&self, point: [f64; 3]) -> [i32; 3] {
        point.map(|x| (x / self.width).floor() as i32)
    }

    /// Spheres that a point could lie in or near.
    fn near(&self, point: [f64; 3]) -> impl Iterator<Item = &Sphere> {
        let [x, y, z] = self.cell(point);
        let offsets = (0..27).map(move |n| [x + n % 3 - 1, y + n / 3 % 3 - 1, z + n / 9 - 1]);
        offsets.filter_map(|cell| self.cells.get(&cell)).flatten().map(|&i| &self.spheres[i as usize])
    }

    /// The largest radius, up to `most`, of a sphere here that overlaps no other; anything below `least` where there is less room.
    fn room(&self, centre: [f64; 3], most: f64, least: f64) -> f64 {
        let mut room = most;
        for sphere in self.near(centre) {
            room = room.min(distance(centre, sphere.centre) - sphere.radius);
            if room < least {
                break;
            }
        }
        room
    }

    fn add(&mut self, sphere: Sphere, dimension: usize) {
        self.volume += Shape::Sphere { radius: sphere.radius }.volume(dimension);
        self.put(sphere);
    }

    fn put(&mut self, sphere: Sphere) {
        let cell = self.cell(sphere.centre);
        self.cells.entry(cell).or_default().push(self.spheres.len() as u32);
        self.spheres.push(sphere);
    }

    /// How deep a point lies in its block, m; `None` between blocks.
    pub fn depth(&self, point: [f64; 3]) -> Option<f64> {
        self.near(point).map(|sphere| sphere.radius - distance(point, sphere.centre)).find(|depth| *depth >= 0.0)
    }

    pub fn blocks(&self) -> usize {
        self.spheres.len()
    }
}

/// Faces of the cells of Voronoi around random places.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Joints {
    seeds: Vec<[f64; 3]>,
}

impl RawJoints {
    pub(super) fn network(&self, document: &Document, path: &str, shape: &Shape, dimension: usize) -> Result<Joints> {
        if !(2..=MOST_BLOCKS).contains(&self.blocks) {
            let what = format!("{} blocks", self.blocks);
            return Err(document.error(&format!("{path}.blocks"), what).allowed(format!("2 to {MOST_BLOCKS}")));
        }
        let places = (0..).filter_map(|draw| place(shape, dimension, self.seed ^ JOINTS, draw));
        Ok(Joints { seeds: places.take(self.blocks as usize).collect() })
    }
}

impl Joints {
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
    use super::super::source::Source;
    use super::*;

    fn with_document<T>(act: impl FnOnce(&Document) -> T) -> T {
        let source = Source { path: "s.toml".into(), text: String::new(), overrides: Vec::new() };
        act(&Document::parse(&source).expect("an empty scene"))
    }

    fn pile(shape: Shape, dimension: usize, radius: [f64; 2], voids: f64, seed: u64) -> Result<Rubble> {
        let raw = RawRubble { radius: radius.map(Length::new), voids: Number::new(voids), seed };
        with_document(|document| raw.pile(document, "body.0.rubble", &shape, dimension))
    }

    /// Blocks lie within the shape, overlap nowhere, fill what they should, and most touch another.
    #[test]
    fn piles_are_packed() {
        let shapes = [
            (Shape::Sphere { radius: 1.0 }, 3, 0.55),
            (Shape::Sphere { radius: 1.0 }, 2, 0.3),
            (Shape::Box { size: [1.0, 2.0, 1.5] }, 3, 0.55),
            (Shape::Cylinder { radius: 1.0, height: 1.0 }, 3, 0.55),
            (Shape::HalfSphere { radius: 1.0, inner: 0.0 }, 3, 0.55),
        ];
        for (shape, dimension, voids) in shapes {
            let pile = pile(shape, dimension, [0.06, 0.25], voids, 1).unwrap();
            let mut touching = 0;
            for (i, a) in pile.spheres.iter().enumerate() {
                assert!((0.06..=0.25).contains(&a.radius));
                assert!(shape.depth(a.centre, dimension) >= a.radius);
                let gaps = pile.spheres.iter().enumerate().filter(|(j, _)| *j != i);
                let gap = gaps.map(|(_, b)| distance(a.centre, b.centre) - a.radius - b.radius).fold(9.0, f64::min);
                assert!(gap > -1e-12, "{shape:?}: blocks overlap by {gap}");
                touching += usize::from(gap < 1e-12);
                assert!((pile.depth(a.centre).unwrap() - a.radius).abs() < 1e-15);
            }
            assert!(touching * 10 > 6 * pile.blocks(), "{shape:?}: {touching} of {} touch", pile.blocks());
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
        let ball = |seed| pile(Shape::Sphere { radius: 1.0 }, 3, [0.1, 0.3], 0.6, seed).unwrap();
        assert_eq!(ball(1), ball(1));
        let sent = serde_json::to_string(&ball(1)).expect("numbers");
        assert_eq!(serde_json::from_str::<Rubble>(&sent).expect("what was written"), ball(1));
        assert_ne!(ball(1), ball(2));
    }

    #[test]
    fn what_cannot_be_piled_is_refused() {
        let said = |radius, voids| pile(Shape::Sphere { radius: 1.0 }, 3, radius, voids, 1).unwrap_err().to_string();
        assert!(said([0.2, 0.1], 0.5).contains("body.0.rubble.radius"));
        assert!(said([0.1, 0.2], 1.5).contains("voids are 1.5"));
        let full = said([0.2, 0.3], 0.1);
        assert!(full.contains("voids of 0.1 are not reached") && full.contains("or more, or smaller blocks"), "{full}");
    }

    /// The face between two seeds is the plane half-way; of many, the next face is never farther than half the way to any.
    #[test]
    fn joints_lie_between_blocks() {
        let two = Joints { seeds: vec![[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]] };
        assert_eq!(two.depth([0.25, 3.0, 4.0]), 0.25);
        assert_eq!(two.depth([-0.5, 0.0, 0.0]), 0.5);
        let raw = RawJoints { blocks: 40, seed: 3 };
        let shape = Shape::Sphere { radius: 1.0 };
        let many = with_document(|document| raw.network(document, "body.0.joints", &shape, 3)).unwrap();
        assert_eq!(many.seeds.len(), 40);
        for seed in &many.seeds {
            let others = many.seeds.iter().filter(|other| *other != seed);
            let nearest = others.map(|other| distance(*seed, *other)).fold(9.0, f64::min);
            assert!((many.depth(*seed) - 0.5 * nearest).abs() < 1e-12);
        }
    }
}
