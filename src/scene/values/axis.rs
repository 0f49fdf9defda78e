//! Coordinate axes and stretches of them.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::Result;
use crate::scene::document::source::Document;
use crate::units::Length;

/// A coordinate axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum CoordinateAxis {
    X,
    Y,
    Z,
}

impl CoordinateAxis {
    pub const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];

    /// 0 to 2; an error at the key `path` where the scene does not have the axis.
    pub fn number(self, document: &Document, path: &str, dimension: usize) -> Result<usize> {
        match self as usize {
            number if number < dimension => Ok(number),
            _ => Err(document.error(path, "there is no z axis in 2 dimensions").allowed("x, y")),
        }
    }
}

/// A stretch of an axis as it is written: lower and upper end.
pub type Interval = [Length; 2];

/// The ends of an interval, m.
pub fn interval(document: &Document, path: &str, [low, high]: Interval) -> Result<[f64; 2]> {
    if low.0 < high.0 {
        return Ok([low.0, high.0]);
    }
    Err(document.error(path, format!("{low} is not below {high}")).allowed("[lower end, upper end]"))
}
