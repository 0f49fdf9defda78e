//! `flow` of a body: a field of velocity at the start.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::Result;
use crate::scene::document::source::Document;
use crate::scene::values::axis::CoordinateAxis;
use crate::scene::values::checks::{POSITIVE, positive};
use crate::scene::values::components::Components;
use crate::units::{Frequency, Length, Speed};

/// A field of velocity at the start, added to the body's own: a table with one key.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FlowTable {
    /// Away from the centre with this speed, towards it where it is negative.
    Radial(Speed),
    /// Along each axis in proportion to the distance from the centre.
    Stretch(Components<Frequency>),
    /// Half of a standing wave: a sine along one axis.
    Wave(WaveTable),
    /// A free vibration of the body, as it swings through its rest shape.
    Mode(ModeTable),
    /// A vortex about z that stands still: an ideal gas turns like a solid within a radius, and ever more slowly up to twice that. Its
    /// pressure balances it; that of the body is the one in the middle.
    Vortex(VortexTable),
    /// A stream along x between two others that flow back, with a small wave on both layers between them.
    Streams(StreamsTable),
}

#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StreamsTable {
    /// Speed of the stream, and of the others.
    speed: Speed,
    /// Distance of both layers, which lie alike above and below the body's centre.
    #[schemars(extend("x-allowed" = POSITIVE))]
    apart: Length,
    /// Thickness of a layer, across which the speed changes evenly.
    #[schemars(extend("x-allowed" = POSITIVE))]
    thickness: Length,
    /// Wavelength along x.
    #[schemars(extend("x-allowed" = POSITIVE))]
    wavelength: Length,
    /// Largest speed of the wave across.
    swing: Speed,
}

#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VortexTable {
    /// Largest speed.
    speed: Speed,
    /// Where it is reached.
    #[schemars(extend("x-allowed" = POSITIVE))]
    radius: Length,
}

#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WaveTable {
    /// Axis along which the velocity changes.
    along: CoordinateAxis,
    /// Axis along which matter moves.
    moves: CoordinateAxis,
    /// Wavelength.
    #[schemars(extend("x-allowed" = POSITIVE))]
    wavelength: Length,
    /// Largest speed.
    speed: Speed,
}

#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ModeTable {
    /// Shape of the vibration.
    shape: VibrationMode,
    /// Largest speed.
    speed: Speed,
}

/// Shapes of free vibration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum VibrationMode {
    /// A sphere or disc breathes.
    Radial,
    /// The halves of a sphere turn against each other; in 2D the inside of a disc against its rim.
    Torsional,
    /// A bar along x that is held at its lower end swings along y.
    Bending,
}

/// A validated field, relative to the body's centre.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Flow {
    /// Away from the centre with one speed, m/s.
    Radial(f64),
    /// Along each axis in proportion to the distance from the centre, 1/s.
    Stretch([f64; 3]),
    /// `speed * sin(2 pi x / wavelength)`: half of a standing wave.
    Wave {
        along: usize,
        moves: usize,
        wavelength: f64,
        speed: f64,
    },
    /// A free vibration of the body, as it swings through its rest shape; the largest speed, m/s.
    Mode {
        shape: VibrationMode,
        speed: f64,
    },
    /// A vortex about z: the largest speed, m/s, and where it is reached, m.
    Vortex {
        speed: f64,
        radius: f64,
    },
    Streams(Streams),
}

/// A stream along x between two others, with a wave on both layers.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Streams {
    /// m/s.
    pub speed: f64,
    /// Distance of the layers from the centre, m.
    pub height: f64,
    /// Half the thickness of a layer, m.
    pub half_width: f64,
    /// Of the wave, 1/m.
    pub wavenumber: f64,
    /// Largest speed of the wave across, m/s.
    pub swing: f64,
}

impl Streams {
    fn velocity(&self, r: [f64; 3]) -> [f64; 3] {
        let (sin, cos) = (libm::sin(self.wavenumber * r[0]), libm::cos(self.wavenumber * r[0]));
        let mut v = [self.speed * ((self.height - r[1].abs()) / self.half_width).clamp(-1.0, 1.0), 0.0, 0.0];
        // Without divergence, as the flow of a wave on either side of a layer is.
        for layer in [-self.height, self.height] {
            let swing = self.swing * self.reach(r[1] - layer);
            v[0] -= swing * cos * (r[1] - layer).signum();
            v[1] += swing * sin;
        }
        v
    }

    /// What is left of a wave at this distance from its layer.
    pub fn reach(&self, away: f64) -> f64 {
        libm::exp(-self.wavenumber * away.abs())
    }
}

impl FlowTable {
    pub fn validate(&self, document: &Document, path: &str, dimension: usize) -> Result<Flow> {
        match self {
            FlowTable::Radial(speed) => Ok(Flow::Radial(speed.0)),
            FlowTable::Stretch(rates) => rates.vector(document, path, dimension).map(Flow::Stretch),
            FlowTable::Wave(wave) if wave.wavelength.0 <= 0.0 => {
                let what = format!("a wavelength of {}", wave.wavelength);
                Err(document.error(&format!("{path}.wave.wavelength"), what).allowed("a length above zero"))
            }
            FlowTable::Wave(wave) => Ok(Flow::Wave {
                along: wave.along.number(document, path, dimension)?,
                moves: wave.moves.number(document, path, dimension)?,
                wavelength: wave.wavelength.0,
                speed: wave.speed.0,
            }),
            FlowTable::Streams(streams) => {
                let long = |key: &str, length: Length| positive(document, &format!("{path}.streams.{key}"), length);
                Ok(Flow::Streams(Streams {
                    speed: streams.speed.0,
                    height: 0.5 * long("apart", streams.apart)?,
                    half_width: 0.5 * long("thickness", streams.thickness)?,
                    wavenumber: 2.0 * std::f64::consts::PI / long("wavelength", streams.wavelength)?,
                    swing: streams.swing.0,
                }))
            }
            FlowTable::Vortex(vortex) => {
                let radius = positive(document, &format!("{path}.vortex.radius"), vortex.radius)?;
                Ok(Flow::Vortex { speed: vortex.speed.0, radius })
            }
            FlowTable::Mode(mode) => Ok(Flow::Mode { shape: mode.shape, speed: mode.speed.0 }),
        }
    }
}

/// Speed of a vortex over its largest, at a distance over its radius (Gresho & Chan 1990, Int. J. Num. Meth. Fluids 11, 621).
pub fn swirl(s: f64) -> f64 {
    if s < 1.0 { s } else { (2.0 - s).max(0.0) }
}

/// Pressure less that in the middle, over density and the square of the largest speed: the integral of swirl^2 / s.
pub fn swirl_pressure(s: f64) -> f64 {
    match s {
        s if s < 1.0 => 0.5 * s * s,
        s if s < 2.0 => 0.5 * s * s - 4.0 * s + 4.0 + 4.0 * libm::log(s),
        _ => 4.0 * std::f64::consts::LN_2 - 2.0,
    }
}

impl Flow {
    /// Velocity at `r` (m) from the centre, m/s; `None` for a mode, whose shape depends on the body's material.
    pub fn velocity(&self, r: [f64; 3]) -> Option<[f64; 3]> {
        match *self {
            Flow::Radial(speed) => {
                let length = (r[0] * r[0] + r[1] * r[1] + r[2] * r[2]).sqrt();
                Some(if length > 0.0 { r.map(|x| speed * x / length) } else { [0.0; 3] })
            }
            Flow::Stretch(rates) => Some(std::array::from_fn(|k| rates[k] * r[k])),
            Flow::Wave { along, moves, wavelength, speed } => {
                let mut velocity = [0.0; 3];
                velocity[moves] = speed * libm::sin(2.0 * std::f64::consts::PI * r[along] / wavelength);
                Some(velocity)
            }
            Flow::Vortex { speed, radius } => {
                let length = (r[0] * r[0] + r[1] * r[1]).sqrt();
                let turn = if length > 0.0 { speed * swirl(length / radius) / length } else { 0.0 };
                Some([-turn * r[1], turn * r[0], 0.0])
            }
            Flow::Streams(streams) => Some(streams.velocity(r)),
            Flow::Mode { .. } => None,
        }
    }

    /// What its pressure adds to that of the body at `r` (m) from the centre, over the density, m^2/s^2.
    pub fn pressure(&self, r: [f64; 3]) -> f64 {
        match *self {
            Flow::Vortex { speed, radius } => {
                speed * speed * swirl_pressure((r[0] * r[0] + r[1] * r[1]).sqrt() / radius)
            }
            _ => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pressure rises by the centripetal force of what turns.
    #[test]
    fn a_vortex_is_in_balance() {
        let vortex = Flow::Vortex { speed: 3.0, radius: 0.2 };
        for k in 1..60 {
            let (r, d) = (0.01 * k as f64 + 0.003, 1e-6);
            let slope = (vortex.pressure([r + d, 0.0, 0.0]) - vortex.pressure([r - d, 0.0, 0.0])) / (2.0 * d);
            let v = vortex.velocity([0.0, r, 5.0]).expect("a velocity");
            assert!((slope - v[0] * v[0] / r).abs() < 1e-6 && v[0] <= 0.0 && v[1] == 0.0, "{r} {slope} {v:?}");
        }
        assert_eq!(vortex.velocity([0.0; 3]), Some([0.0; 3]));
        assert_eq!(vortex.velocity([0.2, 0.0, 0.0]), Some([0.0, 3.0, 0.0]));
    }
}
