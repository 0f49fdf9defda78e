//! Shapes made up of several: their union, less those that are taken away, one after the other. Each may be turned and lies anywhere
//! around the body's centre.

use serde::{Deserialize, Serialize};

use super::bounding_box::BoundingBox;
use super::lattice::Rotation;

/// What shapes must tell of themselves; see [`BodyShape`](super::shape::BodyShape).
pub trait Solid {
    fn volume(&self, dimension: usize) -> f64;
    fn contains(&self, point: [f64; 3], dimension: usize) -> bool;
    fn bounds(&self, dimension: usize) -> BoundingBox;
    fn outer_radius(&self) -> f64;
    /// None where it is not known.
    fn depth(&self, point: [f64; 3], dimension: usize) -> Option<f64>;
}

/// One of them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Part<S> {
    pub shape: S,
    /// Its centre from the body's, m.
    pub position: [f64; 3],
    /// From its own axes to the body's.
    pub rotation: Rotation,
    /// Whether it is taken away from those before it.
    pub minus: bool,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Compound<S> {
    parts: Vec<Part<S>>,
    /// m^3 (m^2 in 2D).
    pub volume: f64,
}

impl<S: Solid> Part<S> {
    /// A point as seen from the part.
    fn local(&self, point: [f64; 3]) -> [f64; 3] {
        let from: [f64; 3] = std::array::from_fn(|k| point[k] - self.position[k]);
        std::array::from_fn(|k| (0..3).map(|a| self.rotation[a][k] * from[a]).sum())
    }

    fn contains(&self, point: [f64; 3], dimension: usize) -> bool {
        self.shape.contains(self.local(point), dimension)
    }

    /// A box around it, as the body's axes are.
    fn bounds(&self, dimension: usize) -> BoundingBox {
        let own = self.shape.bounds(dimension);
        let turned = |x: [f64; 3], weigh: fn(f64) -> f64| -> [f64; 3] {
            std::array::from_fn(|a| (0..3).map(|k| weigh(self.rotation[a][k]) * x[k]).sum())
        };
        let middle = turned(own.middle, |x| x);
        BoundingBox {
            middle: std::array::from_fn(|k| self.position[k] + middle[k]),
            half: turned(own.half, f64::abs),
            dimension,
        }
    }
}

impl<S: Solid> Compound<S> {
    /// `parts`: one or more, the first not taken away.
    pub fn new(parts: Vec<Part<S>>, dimension: usize) -> Self {
        let mut compound = Self { parts, volume: 0.0 };
        compound.volume = if compound.parts_are_apart(dimension) {
            compound.parts.iter().map(|part| part.shape.volume(dimension)).sum()
        } else {
            compound.measured(dimension)
        };
        compound
    }

    pub fn contains(&self, point: [f64; 3], dimension: usize) -> bool {
        let last = self.parts.iter().rfind(|part| part.contains(point, dimension));
        last.is_some_and(|part| !part.minus)
    }

    pub fn bounds(&self, dimension: usize) -> BoundingBox {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for part in self.parts.iter().filter(|part| !part.minus) {
            let BoundingBox { middle, half, .. } = part.bounds(dimension);
            for k in 0..3 {
                low[k] = low[k].min(middle[k] - half[k]);
                high[k] = high[k].max(middle[k] + half[k]);
            }
        }
        let [middle, half] = [1.0, -1.0].map(|sign| std::array::from_fn(|k| 0.5 * (high[k] + sign * low[k])));
        BoundingBox { middle, half, dimension }
    }

    /// No point of it is farther from the body's centre, m.
    pub fn outer_radius(&self) -> f64 {
        let farthest =
            |part: &Part<S>| part.position.iter().map(|x| x * x).sum::<f64>().sqrt() + part.shape.outer_radius();
        self.parts.iter().filter(|part| !part.minus).map(farthest).fold(0.0, f64::max)
    }

    /// A point inside is at least so far from the surface, m: as deep as it is in the part that holds it deepest. None where something
    /// is taken away.
    pub fn depth(&self, point: [f64; 3], dimension: usize) -> Option<f64> {
        if self.parts.iter().any(|part| part.minus) {
            return None;
        }
        let holding = self.parts.iter().filter(|part| part.contains(point, dimension));
        holding
            .map(|part| part.shape.depth(part.local(point), dimension))
            .try_fold(0.0, |most: f64, depth| Some(most.max(depth?)))
    }

    /// Whether no two parts share a point and none is taken away: then volumes add up.
    fn parts_are_apart(&self, dimension: usize) -> bool {
        let apart = |(n, part): (usize, &Part<S>)| {
            self.parts[..n].iter().all(|other| {
                let mut shared = part.bounds(dimension).common(&other.bounds(dimension)).into_iter();
                !shared.any(|both| both.grid().any(|x| part.contains(x, dimension) && other.contains(x, dimension)))
            })
        };
        self.parts.iter().all(|part| !part.minus) && self.parts.iter().enumerate().all(apart)
    }

    /// Volume by the length inside of lines along the last axis, evenly spread (Roberts' R2 sequence) over the box around: an end of a
    /// line is found to rounding, and volumes of round shapes are right to some 1e-5.
    fn measured(&self, dimension: usize) -> f64 {
        let BoundingBox { middle, half, .. } = self.bounds(dimension);
        let last = dimension - 1;
        let at = |n: usize, height: f64| {
            let mut x = [0.0; 3];
            for k in 0..last {
                let spread = if dimension == 3 { n as f64 * SPREAD[k] } else { n as f64 / LINES as f64 };
                x[k] = middle[k] + half[k] * (2.0 * (0.5 + spread).fract() - 1.0);
            }
            x[last] = height;
            x
        };
        let length = |n: usize| {
            let inside = |height: f64| self.contains(at(n, height), dimension);
            let place = |k: usize| middle[last] + half[last] * (2.0 * k as f64 / STEPS as f64 - 1.0);
            let mut length = 0.0;
            let mut before = (place(0), inside(place(0)));
            for k in 1..=STEPS {
                let next = (place(k), inside(place(k)));
                let whole = next.0 - before.0;
                length += match (before.1, next.1) {
                    (false, false) => 0.0,
                    (true, true) => whole,
                    (first, _) => {
                        let edge = edge(inside, before.0, next.0, first);
                        if first { edge - before.0 } else { next.0 - edge }
                    }
                };
                before = next;
            }
            length
        };
        let face: f64 = half[..last].iter().map(|half| 2.0 * half).product();
        face * (0..LINES).map(length).sum::<f64>() / LINES as f64
    }
}

/// Lines, and points on each of them between which an end is looked for.
const LINES: usize = 1 << 16;
const STEPS: usize = 256;
/// 1/g and 1/g^2 with g^3 = g + 1.
const SPREAD: [f64; 2] = [0.754_877_666_246_692_8, 0.569_840_290_998_053_3];

/// Where a line leaves or enters between two points, to rounding.
fn edge(inside: impl Fn(f64) -> bool, mut low: f64, mut high: f64, first: bool) -> f64 {
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        *(if inside(middle) == first { &mut low } else { &mut high }) = middle;
    }
    0.5 * (low + high)
}
