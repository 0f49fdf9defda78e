//! How a body moves and what heats it at the start, beyond one velocity and one energy: `flow` and `blast`.

use serde::{Deserialize, Serialize};

use super::boundaries::Axis;
use super::raw::Components;
use super::source::Document;
use crate::error::Result;
use crate::units::{Energy, Frequency, Length, Speed};

/// A field of velocity at the start, added to the body's own.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum RawFlow {
    Radial(Speed),
    Stretch(Components<Frequency>),
    Wave(RawWave),
    Mode(RawMode),
}

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawWave {
    along: Axis,
    moves: Axis,
    wavelength: Length,
    speed: Speed,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawMode {
    shape: Mode,
    speed: Speed,
}

/// Shapes of free vibration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Mode {
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
    Mode { shape: Mode, speed: f64 },
}

impl RawFlow {
    pub(super) fn validate(&self, document: &Document, path: &str, dimension: usize) -> Result<Flow> {
        match self {
            RawFlow::Radial(speed) => Ok(Flow::Radial(speed.0)),
            RawFlow::Stretch(rates) if rates.0.len() != dimension => {
                let what = format!("{} components in {dimension} dimensions", rates.0.len());
                Err(document.error(path, what).allowed(format!("{dimension} components")))
            }
            RawFlow::Stretch(rates) => {
                let mut stretch = [0.0; 3];
                stretch.iter_mut().zip(&rates.0).for_each(|(s, r)| *s = r.0);
                Ok(Flow::Stretch(stretch))
            }
            RawFlow::Wave(wave) if wave.wavelength.0 <= 0.0 => {
                let what = format!("a wavelength of {}", wave.wavelength);
                Err(document.error(&format!("{path}.wave.wavelength"), what).allowed("a length above zero"))
            }
            RawFlow::Wave(wave) => Ok(Flow::Wave {
                along: wave.along.number(document, path, dimension)?,
                moves: wave.moves.number(document, path, dimension)?,
                wavelength: wave.wavelength.0,
                speed: wave.speed.0,
            }),
            RawFlow::Mode(mode) => Ok(Flow::Mode { shape: mode.shape, speed: mode.speed.0 }),
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

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawBlast {
    energy: Energy,
    radius: Length,
}

/// Energy put into the middle of a body at the start: spread like the cubic spline of this radius, the sum exact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Blast {
    /// J (per metre of depth in 2D).
    pub energy: f64,
    /// Where nothing of it is left, m.
    pub radius: f64,
}

impl RawBlast {
    pub(super) fn validate(&self, document: &Document, path: &str) -> Result<Blast> {
        for (key, value, printed) in
            [("energy", self.energy.0, self.energy.to_string()), ("radius", self.radius.0, self.radius.to_string())]
        {
            super::settings::positive(document, &format!("{path}.{key}"), value, printed)?;
        }
        Ok(Blast { energy: self.energy.0, radius: self.radius.0 })
    }
}
