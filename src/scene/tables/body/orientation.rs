//! `orientation`: how a lattice or a part of a shape is turned.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::Result;
use crate::scene::document::source::Document;
use crate::scene::geometry::lattice::{Rotation, random_rotation, rotation_about};
use crate::scene::values::components::Components;
use crate::units::{Angle, Number};

/// How a lattice is turned: at random by a `seed`, or about an axis by an angle (in 2D an angle alone).
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OrientationTable {
    /// A random rotation; another seed gives another one.
    pub seed: Option<u64>,
    /// Axis of the rotation, of any length; in 3D only.
    pub axis: Option<Components<Number>>,
    /// Angle of the rotation.
    pub angle: Option<Angle>,
}

impl OrientationTable {
    /// `path`: of what is turned.
    pub fn rotation(&self, document: &Document, path: &str, dimension: usize) -> Result<Rotation> {
        let wrong = |key: &str, what: &str| document.error(&format!("{path}.{key}"), what);
        let about = |axis, angle: Angle| Ok(rotation_about(axis, angle.0));
        match (self.seed, &self.axis, self.angle, dimension) {
            (Some(seed), None, None, dimension) => Ok(random_rotation(seed, dimension)),
            (None, None, Some(angle), 2) => about([0.0, 0.0, 1.0], angle),
            (None, Some(axis), Some(angle), 3) => {
                let axis = axis.vector(document, &format!("{path}.orientation.axis"), dimension)?;
                if axis == [0.0; 3] {
                    return Err(wrong("orientation.axis", "the axis has no length"));
                }
                about(axis, angle)
            }
            (_, _, _, 2) => Err(wrong("orientation", "unclear").allowed("{ seed = 3 } or { angle = \"30 deg\" }")),
            _ => {
                let allowed = "{ seed = 3 } or { axis = [0, 0, 1], angle = \"30 deg\" }";
                Err(wrong("orientation", "unclear").allowed(allowed))
            }
        }
    }
}
