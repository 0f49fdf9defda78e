//! `[gravity]`: an acceleration that is the same everywhere, as in a laboratory or on the ground, and what particles do to each
//! other.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::Result;
use crate::particles::Periods;
use crate::scene::document::source::Document;
use crate::scene::values::checks::{Range, within};
use crate::scene::values::components::Components;
use crate::scene::values::switch::Switch;
use crate::units::{Acceleration, Number};

/// What attracts: `uniform`, `self`, or both.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GravityTable {
    /// The same acceleration for all, `["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]`; along a periodic axis, too, where matter that falls comes
    /// round again. None without it.
    uniform: Option<Components<Acceleration>>,
    /// Gravity of the particles on each other, in three dimensions and open space.
    #[serde(rename = "self", default = "Switch::<SelfGravityTable>::off")]
    own: Switch<SelfGravityTable>,
}

/// Gravity of the particles on each other.
#[derive(Debug, Clone, Copy, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
struct SelfGravityTable {
    /// Error that the expansion of one cell may add to an acceleration, as a share of it.
    #[schemars(range(min = ACCURACY[0], max = ACCURACY[1]))]
    accuracy: Number,
    /// Time from one evaluation to the next, in free-fall times of the densest body; 0 for every step.
    #[schemars(range(min = INTERVAL[0], max = INTERVAL[1]))]
    interval: Number,
}

const ACCURACY: Range = [1e-6, 0.1];
const INTERVAL: Range = [0.0, 0.1];

impl Default for SelfGravityTable {
    fn default() -> Self {
        Self { accuracy: Number::new(0.01), interval: Number::new(3e-3) }
    }
}

/// What attracts; SI.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct GravitySettings {
    /// Acceleration of all that moves freely, m/s^2.
    pub uniform: Option<[f64; 3]>,
    pub own: Option<SelfGravity>,
}

/// The gravity of particles on each other.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SelfGravity {
    /// Error of one cell's expansion that a particle may feel, over its acceleration.
    pub accuracy: f64,
    /// Time from one evaluation to the next, over the free-fall time of the densest body.
    pub interval: f64,
}

impl GravitySettings {
    pub fn any(&self) -> bool {
        self.uniform.is_some() || self.own.is_some()
    }

    /// The axis of uniform gravity and its component along it, m/s^2; none where there is none, or it is along no axis.
    pub fn axis(&self) -> Option<(usize, f64)> {
        only_component(&self.uniform?)
    }
}

/// The only component of a vector that is not zero: its axis and value.
pub fn only_component(v: &[f64; 3]) -> Option<(usize, f64)> {
    let mut components = (0..3).filter(|&k| v[k] != 0.0);
    let axis = components.next().filter(|_| components.next().is_none())?;
    Some((axis, v[axis]))
}

impl GravityTable {
    /// Components of uniform gravity, m/s^2.
    pub fn uniform_components(&self) -> impl Iterator<Item = f64> + '_ {
        self.uniform.iter().flat_map(|uniform| &uniform.0).map(|g| g.0)
    }

    pub fn validate(&self, document: &Document, dimension: usize, periods: &Periods) -> Result<GravitySettings> {
        if self.uniform.is_none() && self.own.0.is_none() {
            return Err(document.error("gravity", "nothing attracts").allowed("a key `uniform` or `self`"));
        }
        let uniform =
            self.uniform.as_ref().map(|given| given.vector(document, "gravity.uniform", dimension)).transpose()?;
        let own = self.own.0.map(|own| own.validate(document, dimension, periods)).transpose()?;
        Ok(GravitySettings { uniform, own })
    }
}

impl SelfGravityTable {
    fn validate(&self, document: &Document, dimension: usize, periods: &Periods) -> Result<SelfGravity> {
        let path = "gravity.self";
        if dimension == 2 {
            let what = "matter attracts itself in three dimensions: in the plane it would stand for rods without end";
            return Err(document.error(path, what).allowed("dimension = 3"));
        }
        if periods.any() {
            let what = "periodic space has no potential of its own matter";
            return Err(document.error(path, what).allowed("open space"));
        }
        Ok(SelfGravity {
            accuracy: within(document, "gravity.self.accuracy", self.accuracy, ACCURACY)?,
            interval: within(document, "gravity.self.interval", self.interval, INTERVAL)?,
        })
    }
}
