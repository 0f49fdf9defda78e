//! Particles as outcomes use them.

use rayon::prelude::*;

use crate::material::{BodyConstants, Core};
use crate::math::Vec3;
use crate::particles::Columns;

/// Particles damaged less than this are linked into fragments.
pub const LINK_DAMAGE: f64 = 0.9;
/// The stricter threshold whose outcome is reported beside it.
pub const STRICT_DAMAGE: f64 = 0.5;

/// Particles that a thread makes by itself, at least.
const SHARE: usize = 1 << 12;

/// A particle as the outcome uses it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Particle {
    pub id: u64,
    /// Number of the scene's body that it comes from.
    pub body: usize,
    /// m.
    pub position: Vec3,
    /// m/s.
    pub velocity: Vec3,
    /// kg.
    pub mass: f64,
    /// Volume at the initial density of its body, m^3 (m^2 in 2D).
    pub volume: f64,
    /// Edge of a cube of that volume (of a square in 2D), m.
    pub spacing: f64,
    /// Vapour, which has no cohesion, counts as broken.
    pub damage: f64,
}

/// The owned particles as the outcome uses them; `whole`: the scene's body that each body is or is a part of, `damage`: damage of
/// particle i of a body.
pub fn particles(
    columns: &Columns,
    core: &Core,
    constants: &[BodyConstants],
    whole: &[usize],
    damage: impl Fn(usize, usize) -> f64 + Sync,
) -> Vec<Particle> {
    let sizes: Vec<(f64, f64)> = constants
        .iter()
        .map(|body| {
            let volume = body.particle_mass / body.density;
            (volume, if columns.registry.dimension == 3 { libm::cbrt(volume) } else { volume.sqrt() })
        })
        .collect();
    let particle = |i: usize| {
        let id = columns.get(core.id, i);
        let (volume, spacing) = sizes[id.body()];
        Particle {
            id: id.0,
            body: whole[id.body()],
            position: columns.get(core.position, i),
            velocity: columns.get(core.velocity, i),
            mass: constants[id.body()].particle_mass,
            volume,
            spacing,
            damage: damage(i, id.body()),
        }
    };
    (0..columns.len()).into_par_iter().with_min_len(SHARE).map(particle).collect()
}
