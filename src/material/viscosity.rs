//! Coefficients of the artificial viscosity, per material. The pair loop holds the formula: for approaching pairs Pi =
//! (-alpha c mu + beta mu^2) / rho, mu = h v.x / (r^2 + 0.01 h^2) (Monaghan & Gingold 1983), with alpha and beta as
//! means over the pair.

use serde::{Deserialize, Serialize};

use super::MaterialTable;
use super::setup::{Table, none_negative};
use crate::error::Result;
use crate::units::{Number, Quantity};

/// `[material.X.viscosity]`
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ViscosityTable {
    /// Linear in the speed of approach, spreads shocks and damps the noise behind them.
    pub alpha: Number,
    /// Quadratic, keeps particles from passing through each other in strong shocks.
    pub beta: Number,
}

impl Default for ViscosityTable {
    fn default() -> Self {
        Self { alpha: Quantity(1.5), beta: Quantity(3.0) }
    }
}

impl Table for ViscosityTable {
    fn validate(&self, place: &str, _material: &MaterialTable) -> Result<()> {
        none_negative(place, &[("alpha", self.alpha.0), ("beta", self.beta.0)])
    }
}

impl MaterialTable {
    /// alpha and beta; `None` where the scene goes without viscosity.
    pub fn viscosity_coefficients(&self) -> Option<[f64; 2]> {
        self.viscosity.map(|table| [table.alpha.0, table.beta.0])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn defaults_fill_what_a_scene_leaves_out() {
        let coefficients = |text: &str| toml::from_str::<MaterialTable>(text).unwrap().viscosity_coefficients();
        let gas = "eos = { ideal_gas = { gamma = 1.4 } }\n";
        assert_eq!(coefficients(&format!("{gas}viscosity = {{ beta = 2 }}")), Some([1.5, 2.0]));
        assert_eq!(coefficients(gas), None);
        assert!(toml::from_str::<ViscosityTable>("gamma = 2").is_err());
    }
}
