//! `[threshold]`: the search for the projectile that disperses half of the target.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::Result;
use crate::scene::document::source::Document;
use crate::scene::values::checks::{POSITIVE, Range, positive, within};
use crate::units::{Length, Number};

/// A search for the projectile that disperses half of the target, instead of a single run.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ThresholdTable {
    /// What is varied: the radius of the projectile, `"projectile.radius"`.
    vary: String,
    /// Relative width of the final bracket in Q.
    #[serde(default = "five_per_cent")]
    #[schemars(range(min = TOLERANCE[0], max = TOLERANCE[1]))]
    tolerance: Number,
    /// Least radius.
    #[schemars(extend("x-allowed" = POSITIVE))]
    #[schemars(extend("x-default" = format!("{} radii of the target", USUAL_RADII[0])))]
    min: Option<Length>,
    /// Largest radius.
    #[schemars(extend("x-allowed" = POSITIVE))]
    #[schemars(extend("x-default" = format!("{} radius of the target", USUAL_RADII[1])))]
    max: Option<Length>,
    /// Largest number of impacts that look for the bracket.
    #[serde(default = "sixteen")]
    #[schemars(range(min = FEWEST_IMPACTS))]
    max_impacts: u32,
    /// Impacts at the threshold with other flaws and another orientation of the target's lattice, for the scatter; 0 for none.
    #[serde(default = "three")]
    #[schemars(extend("x-allowed" = REPEATS))]
    repeats: u32,
}

/// Bounds of the varied length where the scene has none, over the target's.
pub const USUAL_RADII: Range = [0.01, 1.0];
const TOLERANCE: Range = [1e-4, 1.0];
const FEWEST_IMPACTS: u32 = 2;
const REPEATS: &str = "0, or 2 and more";

fn five_per_cent() -> Number {
    Number::new(0.05)
}

fn sixteen() -> u32 {
    16
}

fn three() -> u32 {
    3
}

/// A search for the projectile that disperses half of the target.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ThresholdSettings {
    /// The length that is varied, as `--set` names it: `projectile.radius`.
    pub vary: String,
    /// Relative width of the final bracket in Q.
    pub tolerance: f64,
    /// Bounds of the varied length, m.
    pub min: Option<f64>,
    pub max: Option<f64>,
    pub max_impacts: u32,
    /// Impacts at the threshold with other flaws and another orientation of the target's lattice: their scatter is part of
    /// the uncertainty. None, or two and more.
    pub repeats: u32,
}

impl ThresholdTable {
    /// `varied` are the keys that may be varied.
    pub fn validate(&self, document: &Document, varied: &[String]) -> Result<ThresholdSettings> {
        if !varied.contains(&self.vary) {
            let what = format!("`{}` cannot be varied", self.vary);
            return Err(document.error("threshold.vary", what).allowed(varied.join(", ")));
        }
        let min = self.min.map(|x| positive(document, "threshold.min", x)).transpose()?;
        let max = self.max.map(|x| positive(document, "threshold.max", x)).transpose()?;
        if let (Some(low), Some(high)) = (min, max)
            && low >= high
        {
            return Err(document.error("threshold.min", format!("{} is not below max", Length::new(low))));
        }
        if self.max_impacts < FEWEST_IMPACTS {
            return Err(document
                .error("threshold.max_impacts", "a bracket needs two impacts")
                .allowed(format!("{FEWEST_IMPACTS} or more")));
        }
        if self.repeats == 1 {
            return Err(document.error("threshold.repeats", "one impact shows no scatter").allowed(REPEATS));
        }
        let tolerance = within(document, "threshold.tolerance", self.tolerance, TOLERANCE)?;
        let Self { max_impacts, repeats, .. } = *self;
        Ok(ThresholdSettings { vary: self.vary.clone(), tolerance, min, max, max_impacts, repeats })
    }
}
