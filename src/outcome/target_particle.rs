//! Particles from which craters and ejecta are measured.

/// A particle of the ground, relative to the point of impact.
pub struct TargetParticle {
    /// Above the face, m.
    pub height: f64,
    /// Along the face from the point of impact, m.
    pub aside: [f64; 2],
    /// Upward, m/s.
    pub speed: f64,
    /// kg.
    pub mass: f64,
    /// Volume before the impact, m^3 (m^2 in 2D).
    pub volume: f64,
    /// Density over its initial value.
    pub relative_density: f64,
    /// Distention now and at the start, where its body has pores.
    pub distention: Option<[f64; 2]>,
}
