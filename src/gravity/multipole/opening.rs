//! When two cells act on each other through expansions alone. With R the distance of their centres of mass, s the
//! sum of their radii and P the order, they do where
//!
//! ```text
//! s < theta R                                       expansions converge
//! s + 2 max(h) < R                                  no pair is softened
//! G M_B / R^2 (s / R)^P <= eps a_A, and A for B     the error of either's acceleration is a small share of it
//! ```
//!
//! with a_A the least acceleration in A when gravity was last evaluated; the estimate is that of Dehnen (2014, Comp. Astrophys.
//! Cosmol. 1, 1), the measure that of Springel (2005, MNRAS 364, 1105). The test does not change when A and B are swapped, so
//! that cells are far from each other in both directions. It holds the better the larger R and a, and the smaller s, h and M are:
//! what is true of bounds is true of all that they bound.

use bytemuck::{Pod, Zeroable};

use super::cells::{Cell, DEEPEST};
use super::octree::{Node, Octree, Side};

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Opening {
    /// theta, below 1.
    pub angle: f64,
    /// eps; infinite where accelerations are not known yet.
    pub accuracy: f64,
    /// P.
    pub order: usize,
}

impl Opening {
    /// Whether two cells, at the squared distance `r2`, are far enough from each other.
    #[inline]
    pub fn is_far(&self, r2: f64, a: &Side, b: &Side) -> bool {
        let size = a.radius + b.radius;
        let reach = size + 2.0 * a.softening.max(b.softening);
        if reach * reach >= r2 || size * size >= self.angle * self.angle * r2 {
            return false;
        }
        if self.accuracy == f64::INFINITY {
            return true;
        }
        // The third condition, squared and times R^(2 P + 4).
        let (mut sizes, mut distances) = (1.0, self.accuracy * self.accuracy * r2 * r2);
        for _ in 0..self.order {
            sizes *= size * size;
            distances *= r2;
        }
        let off = |by: &Side, of: &Side| by.mass * by.mass * sizes <= distances * (of.acceleration * of.acceleration);
        off(b, a) && off(a, b)
    }
}

#[inline]
pub fn distance2(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    let x = [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    (x[0] * x[0] + x[1] * x[1]) + x[2] * x[2]
}

/// Levels of a tree.
const LEVELS: usize = DEEPEST as usize + 1;

/// Bounds on those cells of a branch that might open a source: cells are opened by cells of their own level or deeper ones, and
/// by leaves of any level.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Openers {
    /// Largest mass and radius of the cells that may open one of this level.
    mass: [f64; LEVELS],
    radius: [f64; LEVELS],
    softening: f64,
    acceleration: f64,
}

/// Bounds are rounded, so they are taken a little wider.
const MARGIN: f64 = 1e-9;

impl Openers {
    pub const WORDS: usize = std::mem::size_of::<Self>() / 8;

    pub fn of(branch: &Octree) -> Self {
        let mut openers = Self::zeroed();
        let Side { softening, acceleration, .. } = branch.nodes[0].side;
        (openers.softening, openers.acceleration) = (softening, acceleration);
        for node in &branch.nodes {
            let deepest = if node.is_leaf() { LEVELS } else { node.level as usize + 1 };
            for level in 0..deepest {
                openers.mass[level] = openers.mass[level].max(node.side.mass);
                openers.radius[level] = openers.radius[level].max(node.side.radius);
            }
        }
        openers
    }

    /// Whether no cell in the branch at `cell` opens `node`.
    pub fn see_as_one(&self, cell: Cell, node: &Node, opening: &Opening) -> bool {
        let level = node.level as usize;
        let (half, middle) = (0.5 / (1u64 << cell.level) as f64, cell.middle());
        // Centres of mass lie in their cells.
        let gap = |k: usize| ((node.centre[k] - middle[k]).abs() - half - MARGIN * half).max(0.0);
        let r2 = (gap(0) * gap(0) + gap(1) * gap(1)) + gap(2) * gap(2);
        let side = Side {
            mass: self.mass[level] * (1.0 + MARGIN),
            radius: self.radius[level] * (1.0 + MARGIN),
            softening: self.softening,
            acceleration: self.acceleration * (1.0 - MARGIN),
        };
        r2 > 0.0 && opening.is_far(r2 * (1.0 - MARGIN), &side, &node.side)
    }
}
