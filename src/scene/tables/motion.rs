//! `motion` of a body or a layer: how it moves whatever the forces.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::Result;
use crate::motion::PrescribedMotion;
use crate::scene::document::source::Document;
use crate::scene::values::axis::CoordinateAxis;
use crate::scene::values::components::Components;
use crate::units::{Speed, Time};

/// How something moves: `"fixed"`, or a table with one key.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum MotionTable {
    /// At rest, whatever the forces.
    Fixed,
    /// With this velocity, whatever the forces.
    Velocity(Components<Speed>),
    /// Along these axes only, as the forces ask.
    Along(Vec<CoordinateAxis>),
    /// Slowed down towards the velocity at the start, within about this time: an absorbing layer. With a second time, `["1 us", "50 us"]`,
    /// until then only, to let a body settle.
    Damping(Components<Time>),
}

impl MotionTable {
    /// `towards`: the velocity that damping leads back to, m/s.
    pub fn validate(
        &self,
        document: &Document,
        path: &str,
        dimension: usize,
        towards: [f64; 3],
    ) -> Result<PrescribedMotion> {
        match self {
            MotionTable::Fixed => Ok(PrescribedMotion::Prescribed([0.0; 3])),
            MotionTable::Velocity(components) => {
                components.vector(document, path, dimension).map(PrescribedMotion::Prescribed)
            }
            MotionTable::Along(axes) => {
                let mut along = [false; 3];
                for axis in axes {
                    along[axis.number(document, path, dimension)?] = true;
                }
                Ok(PrescribedMotion::Along(along))
            }
            MotionTable::Damping(Components(times)) => {
                let (time, until) = match times[..] {
                    [time] => (time, None),
                    [time, until] => (time, Some(until)),
                    _ => {
                        let what = format!("{} times", times.len());
                        return Err(document.error(path, what).allowed("a time, or [time, until]"));
                    }
                };
                for (word, given) in [("within", Some(time)), ("until", until)] {
                    if let Some(given) = given.filter(|given| given.0 <= 0.0) {
                        let what = format!("damping {word} {given}");
                        return Err(document.error(path, what).allowed("a time above zero"));
                    }
                }
                Ok(PrescribedMotion::Damped { time: time.0, towards, until: until.map(|until| until.0) })
            }
        }
    }
}
