//! Parts of bodies, named by where their particles start.

use serde::{Deserialize, Serialize};

use crate::error::Result;
use crate::scene::document::keys::unknown;
use crate::scene::document::source::Document;
use crate::scene::tables::body::validated::Body;
use crate::scene::values::axis::{CoordinateAxis, Interval, interval};

/// A block of space, within one body or any.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Region {
    /// The body it is a part of; any without.
    pub body: Option<usize>,
    /// m.
    pub low: [f64; 3],
    pub high: [f64; 3],
}

impl Region {
    /// Whether a particle that starts at `point` belongs to it.
    pub fn holds(&self, body: usize, point: [f64; 3]) -> bool {
        self.body.is_none_or(|own| own == body) && (0..3).all(|k| (self.low[k]..=self.high[k]).contains(&point[k]))
    }
}

/// The keys by which a table names a region.
#[derive(Debug, Clone, Copy)]
pub struct RegionKeys<'a> {
    /// The body's name; all bodies without it.
    pub body: Option<&'a String>,
    /// Along x, y and z; everywhere without them.
    pub ends: [Option<Interval>; 3],
}

/// The region that a table at `path` names.
pub fn region(document: &Document, path: &str, keys: RegionKeys, bodies: &[Body]) -> Result<Region> {
    let body = match keys.body {
        None => None,
        Some(name) => Some(bodies.iter().position(|body| body.name == *name).ok_or_else(|| {
            let known: Vec<String> = bodies.iter().map(|body| body.name.clone()).collect();
            unknown(document, &format!("{path}.body"), "body", name, &known)
        })?),
    };
    // Finite, as a scene travels as JSON.
    let (mut low, mut high) = ([f64::MIN; 3], [f64::MAX; 3]);
    for (axis, ends) in CoordinateAxis::ALL.into_iter().zip(keys.ends) {
        let Some(ends) = ends else { continue };
        let key = format!("{path}.{}", ["x", "y", "z"][axis as usize]);
        let axis = axis.number(document, &key, bodies[0].dimension)?;
        [low[axis], high[axis]] = interval(document, &key, ends)?;
    }
    Ok(Region { body, low, high })
}
