//! What a scene says about records: `[record]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::super::MaterialTable;
use crate::error::{Error, Result};

/// The largest values that each particle has seen, as columns of snapshots.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Records {
    /// Largest pressure.
    pub peak_pressure: bool,
    /// Largest molten share; needs a material that can vaporise.
    pub melt_fraction: bool,
    /// Largest vaporised share; needs a material that can vaporise.
    pub vapour_fraction: bool,
}

impl Records {
    /// Melt and vapour are only known where some material has energies of vaporisation.
    pub fn validate(&self, materials: &[MaterialTable]) -> Result<()> {
        let known = materials.iter().any(|material| material.eos.law().vaporisation().is_some());
        match [("melt_fraction", self.melt_fraction), ("vapour_fraction", self.vapour_fraction)].iter().find(|r| r.1) {
            Some((key, _)) if !known => Err(Error::new(format!("{key} is requested, but no material can vaporise"))
                .at(format!("record.{key}"))
                .allowed("scenes with a Tillotson equation of state")),
            _ => Ok(()),
        }
    }
}
