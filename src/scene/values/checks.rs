//! Checks that several tables share, each with the one wording of its message.

use crate::error::Result;
use crate::scene::document::source::Document;
use crate::units::{Number, Quantity};

/// What is allowed of a quantity that must be positive.
pub const POSITIVE: &str = "more than 0";

/// The least and the largest number that a key may have.
pub type Range = [f64; 2];

/// A number within a range, both ends included.
pub fn within(document: &Document, path: &str, value: Number, [low, high]: Range) -> Result<f64> {
    if (low..=high).contains(&value.0) {
        return Ok(value.0);
    }
    Err(document.error(path, format!("{value} is out of range")).allowed(format!("{low} to {high}")))
}

/// The SI number of a quantity that must be positive.
pub fn positive<const L: i8, const M: i8, const T: i8>(
    document: &Document,
    path: &str,
    value: Quantity<L, M, T>,
) -> Result<f64> {
    if value.0 > 0.0 {
        return Ok(value.0);
    }
    Err(document.error(path, format!("{value} is not positive")).allowed(POSITIVE))
}
