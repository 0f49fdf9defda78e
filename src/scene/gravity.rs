//! `[gravity]`: an acceleration that is the same everywhere, as in a laboratory or on the ground, and what particles do to each
//! other.

use serde::{Deserialize, Serialize};

use super::numerics::Switch;
use super::raw::Components;
use super::settings::within;
use super::source::Document;
use crate::error::Result;
use crate::particles::Periods;
use crate::units::{Acceleration, Number};

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawGravity {
    uniform: Option<Components<Acceleration>>,
    #[serde(rename = "self", default = "off")]
    own: Switch<RawOwnGravity>,
}

fn off() -> Switch<RawOwnGravity> {
    Switch(None)
}

#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
struct RawOwnGravity {
    accuracy: Number,
    interval: Number,
}

impl Default for RawOwnGravity {
    fn default() -> Self {
        Self { accuracy: Number::new(0.01), interval: Number::new(3e-3) }
    }
}

/// What attracts; SI.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Gravity {
    /// Acceleration of all that moves freely, m/s^2.
    pub uniform: Option<[f64; 3]>,
    pub own: Option<OwnGravity>,
}

/// The gravity of particles on each other.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct OwnGravity {
    /// Error of one cell's expansion that a particle may feel, over its acceleration.
    pub accuracy: f64,
    /// Time from one evaluation to the next, over the free-fall time of the densest body.
    pub interval: f64,
}

impl Gravity {
    pub fn any(&self) -> bool {
        self.uniform.is_some() || self.own.is_some()
    }
}

impl RawGravity {
    pub(super) fn validate(&self, document: &Document, dimension: usize, periods: &Periods) -> Result<Gravity> {
        if self.uniform.is_none() && self.own.0.is_none() {
            return Err(document.error("gravity", "nothing attracts").allowed("a key `uniform` or `self`"));
        }
        let uniform = self.uniform.as_ref().map(|given| uniform(document, given, dimension)).transpose()?;
        let own = self.own.0.map(|own| own.validate(document, dimension, periods)).transpose()?;
        Ok(Gravity { uniform, own })
    }
}

impl RawOwnGravity {
    fn validate(&self, document: &Document, dimension: usize, periods: &Periods) -> Result<OwnGravity> {
        let path = "gravity.self";
        if dimension == 2 {
            let what = "matter attracts itself in three dimensions: in the plane it would stand for rods without end";
            return Err(document.error(path, what).allowed("dimension = 3"));
        }
        if periods.any() {
            let what = "periodic space has no potential of its own matter";
            return Err(document.error(path, what).allowed("open space"));
        }
        Ok(OwnGravity {
            accuracy: within(document, "gravity.self.accuracy", self.accuracy, 1e-6, 0.1)?,
            interval: within(document, "gravity.self.interval", self.interval, 0.0, 0.1)?,
        })
    }
}

fn uniform(document: &Document, uniform: &Components<Acceleration>, dimension: usize) -> Result<[f64; 3]> {
    let error = |what: String| document.error("gravity.uniform", what);
    if uniform.0.len() != dimension {
        let what = format!("{} components in {dimension} dimensions", uniform.0.len());
        return Err(error(what).allowed(format!("{dimension} components")));
    }
    let mut acceleration = [0.0; 3];
    acceleration.iter_mut().zip(&uniform.0).for_each(|(a, given)| *a = given.0);
    Ok(acceleration)
}
