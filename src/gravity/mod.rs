//! Newtonian gravity: its action on particles ([`attraction`]), and the field of bodies on each other ([`multipole`]), which also
//! serves to find what is bound ([`crate::outcome::bound`]).

pub mod attraction;
pub mod multipole;

pub use attraction::{Attraction, Matter, OwnGravity, ROUNDS, Timing, declare_rounds};
pub use multipole::{Body, Field, Opening, solve, solve_later};

/// Newton's constant, m^3 / (kg s^2) (CODATA 2018).
pub const G: f64 = 6.67430e-11;
