//! `numerics.skin`: how much farther than the support neighbour lists reach.

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::error::Result;
use crate::scene::document::source::Document;
use crate::scene::values::checks::{Range, within};
use crate::scene::values::word::{self, word_or, word_schema};
use crate::units::Number;

/// A number, or `"auto"`.
#[derive(Debug, Clone, Copy, Default)]
pub enum SkinValue {
    #[default]
    Auto,
    Fixed(Number),
}

const FIXED: Range = [0.0, 1.0];

/// Margin of neighbour lists, in units of the support.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum SkinRule {
    /// The same for all particles at all times.
    Fixed(f64),
    /// Each particle's own, by how matter around it moves.
    Auto,
}

impl SkinValue {
    const WORD: &str = "auto";

    pub fn validate(self, document: &Document) -> Result<SkinRule> {
        match self {
            SkinValue::Auto => Ok(SkinRule::Auto),
            SkinValue::Fixed(number) => within(document, "numerics.skin", number, FIXED).map(SkinRule::Fixed),
        }
    }
}

impl SkinRule {
    /// Of the first lists.
    pub fn first(self) -> f64 {
        match self {
            SkinRule::Fixed(skin) => skin,
            SkinRule::Auto => 0.05,
        }
    }

    /// The widest of particles in the cells that are made for their smoothing length.
    pub fn of_cells(self) -> f64 {
        match self {
            SkinRule::Fixed(skin) => skin,
            SkinRule::Auto => 0.1,
        }
    }

    /// The widest of all: that of cells twice as wide, where no period bounds them.
    pub fn widest(self, periodic: bool) -> f64 {
        match self {
            SkinRule::Auto if !periodic => 2.0 * (1.0 + self.of_cells()) - 1.0,
            _ => self.of_cells(),
        }
    }
}

impl Serialize for SkinValue {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        let given = match self {
            SkinValue::Auto => None,
            SkinValue::Fixed(number) => Some(number),
        };
        word::serialize(given, Self::WORD, serializer)
    }
}

word_schema!(SkinValue, Number);

impl<'de> Deserialize<'de> for SkinValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        word_or(deserializer, Self::WORD).map(|number| number.map_or(SkinValue::Auto, SkinValue::Fixed))
    }
}
