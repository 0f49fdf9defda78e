//! The time step: the smallest that any effect allows anywhere, and what limits it.
//!
//!   CFL            dt <= C h / (c + 0.6 (alpha c + beta |mu|))      Monaghan 1989 (J. Comp. Phys. 82, 1), eq. 4.9 with
//!                                                                   the largest |mu| over approaching neighbours
//!   acceleration   dt <= C sqrt(h / |a|)
//!   closing        approaching matter that is not in contact yet, see [`closing`](crate::domain::closing)
//!
//! and the limits of the material effects. Minima do not depend on order, so neither does the step.

use crate::material::Viscosity;
use crate::particles::ParticleId;

/// What limits the step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit {
    pub dt: f64,
    /// One of those below, or a material effect's, in their order.
    pub reason: usize,
    pub id: ParticleId,
    pub position: [f64; 3],
}

impl Limit {
    pub const CFL: usize = 0;
    pub const ACCELERATION: usize = 1;
    pub const MOTION: usize = 2;
    pub const CLOSING: usize = 3;
    /// The error of a step that an integrator tolerates; of no particle.
    pub const ERROR: usize = 4;
    /// First number of a material effect.
    pub const EFFECTS: usize = 5;

    pub const NONE: Self = Self { dt: f64::INFINITY, reason: 0, id: ParticleId(u64::MAX), position: [0.0; 3] };

    /// Whether it is that of the particle `id`.
    pub fn is_of_particle(&self) -> bool {
        self.reason != Self::ERROR
    }

    /// The tighter of two; equal ones are ordered by reason and particle, so that the log is the same for any ranks.
    pub fn tighter(self, other: Self) -> Self {
        let key = |l: &Self| (l.dt, l.reason, l.id);
        if key(&other) < key(&self) { other } else { self }
    }
}

/// A limit, and what sets it in a word.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NamedLimit {
    pub limit: Limit,
    /// See [`Stepper::reason_name`](super::Stepper::reason_name).
    pub reason: &'static str,
}

/// Signal-speed limit of one particle, s.
#[inline]
pub fn cfl(factor: f64, h: f64, sound_speed: f64, viscosity: Viscosity, approach: f64) -> f64 {
    let Viscosity { alpha, beta } = viscosity;
    factor * h / (sound_speed + 0.6 * (alpha * sound_speed + beta * approach))
}

/// Acceleration limit of one particle, s; infinite at rest.
#[inline]
pub fn acceleration(factor: f64, h: f64, a2: f64) -> f64 {
    factor * (h / a2.sqrt()).sqrt()
}
