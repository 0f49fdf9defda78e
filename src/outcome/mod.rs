//! The outcome of an impact: fragments, aggregates bound by gravity, and when the outcome may be evaluated.
//!
//! Everything here runs in parallel on the owned particles; sums are exact and ties go to the smallest label, so that the
//! outcome has the same bits on any number of ranks. Velocities are relative to the common centre of mass wherever they are
//! reported.
//!
//! Where a scene has just a target and a projectile, all matter counts, and the largest remnant is the most massive aggregate,
//! whichever body it comes from. Where there are further bodies, only the matter of these two counts; the largest remnant is the
//! aggregate that holds most of the target's, and pieces that are mostly of other bodies are excluded, as an untouched neighbour is
//! not a remnant of the target. For the fate of each body see `origin`.

pub mod bound;
pub mod crater;
pub mod deposit;
pub mod distributions;
pub mod evaluation;
pub mod filling;
pub mod form;
pub mod fragments;
pub mod intrusion;
pub mod lasting;
pub mod members;
pub mod nbody;
pub mod origin;
pub mod particle;
pub mod piece;
pub mod populations;
pub mod power_law;
pub mod profiles;
pub mod reaccumulated;
pub mod rebound;
pub mod restitution;
pub mod scaling;
pub mod settled;
pub mod tally;
pub mod target_particle;
pub mod vapour;

pub use evaluation::{CentreOfMass, Evaluation, Outcome, Strict, evaluate};
pub use particle::{LINK_DAMAGE, Particle, STRICT_DAMAGE, particles};
pub use piece::{Piece, Question};
