//! `[[layer]]`: a part of bodies with a motion of its own.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::region::{Region, RegionKeys, region};
use crate::error::Result;
use crate::motion::PrescribedMotion;
use crate::particles::Periods;
use crate::scene::document::source::Document;
use crate::scene::geometry::periods::fills;
use crate::scene::geometry::shape::BodyShape;
use crate::scene::tables::body::validated::Body;
use crate::scene::tables::motion::MotionTable;
use crate::scene::values::axis::Interval;
use crate::units::Length;

/// A part of bodies, by where its particles start, with a motion of its own. Layers go before bodies; the first that holds a particle
/// counts.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LayerTable {
    /// Name of a body; all bodies without it.
    pub body: Option<String>,
    /// Lower and upper end along x; everywhere without it.
    x: Option<Interval>,
    /// Lower and upper end along y; everywhere without it.
    y: Option<Interval>,
    /// Lower and upper end along z; everywhere without it.
    z: Option<Interval>,
    /// Thickness below the outer faces of its `body`: all of a sphere's, all but the upper one of a half_sphere, box or cylinder (the curved
    /// shell; bottom and sides, none where a box fills a period). Held `"fixed"` it reflects waves, with `{ damping }` it absorbs them.
    /// All depths without it.
    outer: Option<Length>,
    /// How it moves.
    motion: MotionTable,
}

/// A validated layer.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Layer {
    pub region: Region,
    pub outer: Option<Outer>,
    pub motion: PrescribedMotion,
}

/// What lies near a body's outer faces: see [`BodyShape::outer_distance`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Outer {
    /// m.
    pub thickness: f64,
    shape: BodyShape,
    centre: [f64; 3],
    /// Axes across which a box has faces.
    across: [bool; 3],
    dimension: usize,
}

impl Outer {
    /// Whether a point of the body belongs to it.
    pub fn holds(&self, point: [f64; 3]) -> bool {
        let inside = std::array::from_fn(|k| point[k] - self.centre[k]);
        self.shape.outer_distance(inside, self.across, self.dimension) <= self.thickness
    }
}

impl Layer {
    /// Whether a particle that starts at `point` belongs to it.
    pub fn holds(&self, body: usize, point: [f64; 3]) -> bool {
        self.region.holds(body, point) && self.outer.as_ref().is_none_or(|outer| outer.holds(point))
    }
}

impl LayerTable {
    /// `number`: of the layer.
    pub fn validate(&self, document: &Document, number: usize, bodies: &[Body], periods: &Periods) -> Result<Layer> {
        let path = format!("layer.{number}");
        let keys = RegionKeys { body: self.body.as_ref(), ends: [self.x, self.y, self.z] };
        let region = region(document, &path, keys, bodies)?;
        let body = region.body.map(|body| &bodies[body]);
        let outer = self.outer.map(|thickness| outer(document, &path, thickness, body, periods)).transpose()?;
        let towards = body.map_or([0.0; 3], |body| body.velocity);
        let dimension = bodies[0].dimension;
        let motion = self.motion.validate(document, &format!("{path}.motion"), dimension, towards)?;
        Ok(Layer { region, outer, motion })
    }
}

/// What lies within `thickness` of the outer faces of `body`.
fn outer(document: &Document, path: &str, thickness: Length, body: Option<&Body>, periods: &Periods) -> Result<Outer> {
    let error = |what: String| document.error(&format!("{path}.outer"), what);
    let Some(body) = body else {
        return Err(error("outer faces are those of one body".into()).allowed("a layer with a key `body`"));
    };
    let closed = match body.shape {
        BodyShape::Box { size } => fills(periods, size),
        _ => [false; 3],
    };
    if !body.shape.has_depth(body.dimension) {
        let what = format!("how far matter of body \"{}\" is from its faces is not known", body.name);
        return Err(error(what).allowed("shapes from which nothing is taken away"));
    }
    let across = closed.map(|closed| !closed);
    let most = body.shape.largest_outer_distance(across, body.dimension);
    if most == f64::INFINITY {
        return Err(error(format!("body \"{}\" has no outer faces: it fills its periods", body.name)));
    }
    if !(thickness.0 > 0.0 && thickness.0 < most) {
        let what = format!("an outer layer of {thickness} in body \"{}\"", body.name);
        return Err(error(what).allowed(format!("more than 0 and less than {}, which is all of it", Length::new(most))));
    }
    let Body { ref shape, centre, dimension, .. } = *body;
    Ok(Outer { thickness: thickness.0, shape: shape.clone(), centre, across, dimension })
}
