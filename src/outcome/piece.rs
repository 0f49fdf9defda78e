//! What an impact leaves, piece by piece, and which of it counts.

use super::tally::{Scale, Tally};
use crate::math::Vec3;

/// An intact fragment of several particles, or one loose particle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// The smallest id in it.
    pub label: u64,
    /// Particles.
    pub count: u64,
    /// kg.
    pub mass: f64,
    /// Volume at the initial density of its bodies, m^3 (m^2 in 2D).
    pub volume: f64,
    /// Centre of mass, m.
    pub position: Vec3,
    /// Velocity of the centre of mass, m/s.
    pub velocity: Vec3,
    /// Matter of each of the two bodies in question, kg.
    pub of: [f64; 2],
}

impl Piece {
    pub(super) fn new(label: u64, tally: &Tally, scale: &Scale) -> Self {
        Self {
            label,
            count: tally.count,
            mass: tally.mass(scale),
            volume: tally.volume(scale),
            position: tally.position(scale),
            velocity: tally.velocity(scale),
            of: tally.masses(scale),
        }
    }

    /// Smoothing length that spreads its mass over a sphere of its volume, m.
    pub(super) fn softening(&self) -> f64 {
        0.5 * libm::cbrt(self.volume * (0.75 / std::f64::consts::PI))
    }
}

/// Which bodies of an impact are evaluated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Question {
    pub dimension: usize,
    /// Mass of the target, kg.
    pub target_mass: f64,
    /// Numbers of target and projectile.
    pub bodies: [usize; 2],
    /// Whether the scene has further bodies.
    pub others: bool,
}

impl Question {
    /// The mass by which pieces are compared, kg.
    pub fn rank(&self, piece: &Piece) -> f64 {
        if self.others { piece.of[0] } else { piece.mass }
    }

    /// The mass of a piece that counts, kg.
    pub fn counted(&self, piece: &Piece) -> f64 {
        if self.others { piece.of[0] + piece.of[1] } else { piece.mass }
    }
}
