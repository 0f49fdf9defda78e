//! Shapes of free vibration of the bodies of a scene, as velocities in space.

use super::elastic::elastic;
use crate::error::{Error, Result};
use crate::exact::vibration::{self, Mode as Exact};
use crate::motion::PrescribedMotion;
use crate::scene::{Body, BodyShape, Scene, VibrationMode};

/// A mode of one body.
#[derive(Debug, Clone, Copy)]
pub struct ModeShape {
    kind: VibrationMode,
    mode: Exact,
    dimension: usize,
    /// Where a bar is held, relative to the centre, m.
    clamp: f64,
    /// Largest velocity of the unscaled mode: divided by it, amplitudes are largest speeds.
    scale: f64,
    /// Angular frequency, rad/s.
    pub frequency: f64,
}

impl ModeShape {
    /// The lowest mode of this kind. A bar is held where its layer without motion ends.
    pub fn new(scene: &Scene, body: &Body, kind: VibrationMode) -> Result<Self> {
        let solid = elastic(scene, body)?;
        let mut clamp = 0.0;
        let mode = match (kind, &body.shape, scene.dimension) {
            (VibrationMode::Radial, &BodyShape::Sphere { radius }, 3) => vibration::sphere_radial(&solid, radius, 1)?,
            (VibrationMode::Radial, &BodyShape::Sphere { radius }, _) => vibration::disc_radial(&solid, radius, 1)?,
            (VibrationMode::Torsional, &BodyShape::Sphere { radius }, 3) => {
                vibration::sphere_torsional(&solid, radius, 1)?
            }
            (VibrationMode::Torsional, &BodyShape::Sphere { radius }, _) => {
                vibration::disc_torsional(&solid, radius, 1)?
            }
            (VibrationMode::Bending, &BodyShape::Box { size }, 2) => {
                let fixed = scene
                    .layers
                    .iter()
                    .filter(|layer| layer.motion == PrescribedMotion::Prescribed([0.0; 3]) && layer.outer.is_none());
                let held = fixed.map(|layer| layer.region.high[0] - body.centre[0]);
                clamp = held.fold(-0.5 * size[0], f64::max);
                vibration::clamped_plate(&solid, 0.5 * size[0] - clamp, size[1], 1)?
            }
            _ => {
                return Err(Error::new(format!("body `{}` has no such mode of vibration", body.name))
                    .allowed("radial or torsional for a sphere, bending for a box in 2 dimensions"));
            }
        };
        let largest = match body.shape {
            BodyShape::Sphere { radius } => {
                (0..=1000).map(|k| mode.at(1e-3 * k as f64 * radius).abs()).fold(0.0, f64::max)
            }
            _ => 1.0,
        };
        let scale = 1.0 / largest;
        Ok(Self { kind, mode, dimension: scene.dimension, clamp, scale, frequency: mode.angular_frequency })
    }

    /// Velocity at `r`, m, from the body's centre, for an amplitude of 1.
    pub fn velocity(&self, r: [f64; 3]) -> [f64; 3] {
        let length = (r[0] * r[0] + r[1] * r[1] + r[2] * r[2]).sqrt();
        if length == 0.0 {
            return [0.0; 3];
        }
        let at = self.scale * self.mode.at(length) / length;
        match (self.kind, self.dimension) {
            (VibrationMode::Radial, _) => r.map(|x| at * x),
            (VibrationMode::Torsional, 2) => [-at * r[1], at * r[0], 0.0],
            // Degree 2: about z, proportional to sin(2 theta), which is 1 at 45 degrees.
            (VibrationMode::Torsional, _) => {
                let turn = 2.0 * at * r[2] / length;
                [-turn * r[1], turn * r[0], 0.0]
            }
            (VibrationMode::Bending, _) => {
                let s = r[0] - self.clamp;
                [0.0, if s > 0.0 { self.scale * self.mode.at(s) } else { 0.0 }, 0.0]
            }
        }
    }
}
