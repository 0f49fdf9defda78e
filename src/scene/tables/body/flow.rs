//! `flow` of a body: a field of velocity at the start.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::Result;
use crate::scene::document::source::Document;
use crate::scene::values::axis::CoordinateAxis;
use crate::scene::values::checks::POSITIVE;
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
    Wave { along: usize, moves: usize, wavelength: f64, speed: f64 },
    /// A free vibration of the body, as it swings through its rest shape; the largest speed, m/s.
    Mode { shape: VibrationMode, speed: f64 },
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
            FlowTable::Mode(mode) => Ok(Flow::Mode { shape: mode.shape, speed: mode.speed.0 }),
        }
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
            Flow::Mode { .. } => None,
        }
    }
}
