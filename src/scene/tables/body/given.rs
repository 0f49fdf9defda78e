//! Bodies whose particles come from a file: one body for each group of particles of one mass and one origin, of which the first has the
//! number of the scene's body, and the others follow the scene's bodies, as parts of it.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::scene::geometry::lattice::Rotation;
use crate::scene::given::{Gathered, ParticleFile};

/// The particles of a body that come from a file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Given {
    /// Number of the scene's body that it is or is a part of.
    pub body: usize,
    /// Number of its group in the file.
    pub group: usize,
    pub particles: u64,
    /// Of one particle, kg.
    pub particle_mass: f64,
    /// Mass, kg, and volume without load, m^3 (in 2D kg/m, m^2), of all parts.
    pub whole_mass: f64,
    pub whole_volume: f64,
    /// Where the particles are; the first part has it for all of them.
    pub source: Option<Handover>,
}

/// How the particles of a file become those of a body.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Handover {
    pub file: ParticleFile,
    pub gathered: Arc<Gathered>,
    /// What becomes the body's centre, m, and is at rest, m/s, in the frame of the file.
    pub origin: [f64; 3],
    pub drift: [f64; 3],
    /// From the axes of the file to those of the scene.
    pub rotation: Rotation,
    pub unload: bool,
}
