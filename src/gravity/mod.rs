//! Newtonian gravity: what it does to particles ([`attraction`]), their field on each other by multipoles of cells on cells
//! ([`multipole`]), and here, for bound mass, the potential of some bodies at other places, by a distributed octree with quadrupoles
//! (Barnes and Hut 1986; Salmon and Warren 1994).
//!
//! Everything that decides about the result - root cube, cells, leaves, expansions, opening tests, the order of sums -
//! follows from the set of sources alone, so that potentials have the same bits on any number of ranks:
//! - a cell of the global lattice is split where it holds more than `LEAF` sources, counted over all ranks;
//! - cells down to a size that suits the number of ranks form the *top*, which every rank knows; below each of its ends, a
//!   *branch*, all sources go to one rank, which builds the branch with its sources in canonical order;
//! - a rank receives of a remote branch the part that its targets can open, no more.
//!
//! Pair potential: a point mass spread over the cubic spline kernel, `h_ij = max(h_i, h_j)`, exactly Newtonian from
//! r = 2 h_ij on (Price and Monaghan 2007, MNRAS 374, appendix A). Cells are expanded only where no pair is softened.

pub mod attraction;
pub mod cells;
pub mod moments;
pub mod multipole;
pub mod top;
pub mod tree;
pub mod walk;

pub use attraction::{Attraction, Matter, OwnGravity, ROUNDS, declare_rounds};
pub use moments::{Acceleration, Field, Potential};
pub use tree::Tree;

use bytemuck::{Pod, Zeroable};

use crate::math::Vec3;

/// Newton's constant, m^3 / (kg s^2) (CODATA 2018).
pub const G: f64 = 6.67430e-11;

/// A body that attracts. Positive mass, positive softening.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Source {
    /// Different for every source of the job: fixes the order of sums, and keeps a body from attracting itself.
    pub id: u64,
    /// m.
    pub position: [f64; 3],
    /// kg.
    pub mass: f64,
    /// Smoothing length h, m; softening ends at 2h.
    pub softening: f64,
}

/// A place at which gravity is wanted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Target {
    /// The source that is not felt here; [`Target::NOBODY`] for all to be felt.
    pub id: u64,
    pub position: Vec3,
    pub softening: f64,
}

impl Target {
    pub const NOBODY: u64 = u64::MAX;
}

impl From<&Source> for Target {
    fn from(source: &Source) -> Self {
        Self { id: source.id, position: Vec3::from(source.position), softening: source.softening }
    }
}

/// Opening angle: a cell of side s is expanded from a distance of s / angle on. In (0, 1].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Opening(f64);

impl Opening {
    /// Larger angles than 1 are taken as 1: beyond 1.15 a body could lie in a cell that is expanded at its place.
    pub fn new(angle: f64) -> Self {
        Self(angle.clamp(1e-3, 1.0))
    }

    pub fn angle(self) -> f64 {
        self.0
    }
}

impl Default for Opening {
    fn default() -> Self {
        Self(0.5)
    }
}
