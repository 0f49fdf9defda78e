//! What craters and ejecta are measured from.

/// A particle of the ground, seen from where the projectile hits.
pub struct TargetParticle {
    /// m.
    pub height: f64,
    /// Along the face from the point of impact, m.
    pub aside: [f64; 2],
    /// Upward, m/s.
    pub speed: f64,
    /// kg.
    pub mass: f64,
    /// Before the impact, m^3 (m^2 in 2D).
    pub volume: f64,
    /// Of its first density.
    pub relative_density: f64,
    /// Now and at the start, where its body has pores.
    pub distention: Option<[f64; 2]>,
}
