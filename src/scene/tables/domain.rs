//! `[domain]`: where space closes on itself.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::{Error, Result};
use crate::particles::Periods;
use crate::scene::document::source::Document;
use crate::scene::values::axis::{CoordinateAxis, Interval, interval};

/// Where space closes on itself.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct DomainTable {
    /// Axes along which space closes on itself, each with its ends: `{ x = ["0 m", "1 km"] }`. Boxes that fill a period get whole rows
    /// of particles. Not with `[impact]`.
    periodic: BTreeMap<CoordinateAxis, Interval>,
}

const PERIODIC: &str = "domain.periodic";

impl DomainTable {
    pub fn validate(&self, document: &Document, dimension: usize) -> Result<Periods> {
        let mut periods = Periods::OPEN;
        for (axis, ends) in &self.periodic {
            let axis = axis.number(document, PERIODIC, dimension)?;
            let [low, high] = interval(document, PERIODIC, *ends)?;
            (periods.low[axis], periods.length[axis]) = (low, high - low);
        }
        Ok(periods)
    }
}

/// An error of a scene that has both an impact and periodic axes.
pub fn no_impact(document: &Document) -> Error {
    let what = "an impact is found in open space: fragments are not linked across periods";
    document.error(PERIODIC, what).allowed("a scene without [impact]")
}
