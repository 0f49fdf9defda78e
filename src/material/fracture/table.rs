//! What a scene says about fracture: `[material.X.fracture]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::super::MaterialTable;
use super::super::setup::{Table, all_positive};
use crate::error::{Error, Result};
use crate::units::{Number, NumberDensity};

/// Damage by the growth of flaws; needs strength.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FractureTable {
    /// The model.
    pub model: FractureModel,
    /// Another seed gives other flaws.
    #[serde(default = "first_seed")]
    pub seed: u64,
    /// k of Weibull's law n = k eps^m, the number density of flaws that are active at a strain eps.
    pub weibull_k: NumberDensity,
    /// m of Weibull's law.
    pub weibull_m: Number,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FractureModel {
    /// Flaws grow at a share of the speed of sound once they are active.
    GradyKipp,
}

fn first_seed() -> u64 {
    1
}

impl Table for FractureTable {
    fn validate(&self, place: &str, material: &MaterialTable) -> Result<()> {
        let FractureModel::GradyKipp = self.model;
        all_positive(place, &[("weibull_k", self.weibull_k.0), ("weibull_m", self.weibull_m.0)])?;
        if material.strength.is_none() {
            return Err(Error::new("fracture needs strength, as flaws open under stress")
                .at(place)
                .allowed("a strength table beside it"));
        }
        if material.eos.law().bulk_modulus().is_none() {
            return Err(Error::new("fracture needs a solid, and the equation of state is that of a gas").at(place));
        }
        Ok(())
    }
}
