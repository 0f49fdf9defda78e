//! Particles from which craters and ejecta are measured.

/// A particle, relative to the point of impact.
pub struct TargetParticle {
    /// Whether it is the projectile's, and not the ground's.
    pub of_projectile: bool,
    /// Above the face, m.
    pub height: f64,
    /// Along the face from the point of impact, m.
    pub aside: [f64; 2],
    /// Upward, m/s.
    pub speed: f64,
    /// Kinetic energy, J.
    pub energy: f64,
    /// Below the face and along it from the point of impact at the start, m.
    pub start: [f64; 2],
    /// kg.
    pub mass: f64,
    /// Volume before the impact, m^3 (m^2 in 2D).
    pub volume: f64,
    /// Density over its initial value.
    pub relative_density: f64,
    /// Distention now and at the start, where its body has pores.
    pub distention: Option<[f64; 2]>,
}

/// Distention from which on no pores are left.
const CRUSHED: f64 = 1.0 + 1e-9;

impl TargetParticle {
    /// Whether its body had pores and none of them are left.
    pub fn is_crushed(&self) -> bool {
        self.distention.is_some_and(|[now, _]| now <= CRUSHED)
    }
}
