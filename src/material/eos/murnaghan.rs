//! Murnaghan's law, which is cold (Murnaghan 1944, PNAS 30, 244; Geretshauser et al. 2010, eq. 25, for glass):
//!
//! ```text
//! P = K_0 / n [ (rho / rho_0)^n - 1 ]        c^2 = dP/drho = K_0 / rho_0 (rho / rho_0)^(n-1)
//! ```
//! P pressure, K_0 bulk modulus, Pa; rho density, rho_0 reference density, kg/m^3; n rise of the bulk modulus with pressure. Tension
//! fades as for Tillotson's law, and c^2 >= K_0 / (4 rho_0). Pressure does not depend on heat, so that no internal energy is
//! needed.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::super::setup::all_positive;
use super::slopes::{Slopes, bounded_sound, fading};
use crate::error::Result;
use crate::units::{Density, Number, Pressure};

/// Murnaghan's law, which heat does not enter: P = K_0 / n [ (rho / rho_0)^n - 1 ].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MurnaghanTable {
    /// Density without load.
    pub rho_0: Density,
    /// Bulk modulus at that density.
    #[serde(rename = "K_0")]
    pub modulus: Pressure,
    /// Exponent: how fast the bulk modulus rises with pressure.
    pub n: Number,
}

impl MurnaghanTable {
    pub(super) fn validate(&self, place: &str) -> Result<()> {
        all_positive(place, &[("rho_0", self.rho_0.0), ("K_0", self.modulus.0), ("n", self.n.0)])
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Murnaghan {
    rho_0: f64,
    inverse_rho_0: f64,
    modulus: f64,
    n: f64,
}

impl Murnaghan {
    pub fn new(table: &MurnaghanTable) -> Self {
        let rho_0 = table.rho_0.0;
        Self { rho_0, inverse_rho_0: 1.0 / rho_0, modulus: table.modulus.0, n: table.n.0 }
    }

    pub fn reference_density(&self) -> f64 {
        self.rho_0
    }

    /// K = rho dP/drho at rho_0, Pa.
    pub fn bulk_modulus(&self) -> f64 {
        self.modulus
    }

    /// Pressure, Pa, and speed of sound, m/s.
    #[inline]
    pub fn pressure(&self, rho: f64) -> (f64, f64) {
        let state = self.slopes(rho);
        (state.p, bounded_sound(state.by_rho, self.modulus * self.inverse_rho_0))
    }

    /// Pressure and its derivatives.
    #[inline]
    pub fn slopes(&self, rho: f64) -> Slopes {
        let eta = rho * self.inverse_rho_0;
        let power = libm::pow(eta, self.n - 1.0);
        let state = Slopes {
            p: self.modulus / self.n * (eta * power - 1.0),
            by_rho: self.modulus * self.inverse_rho_0 * power,
            by_u: 0.0,
        };
        fading(state, eta, self.inverse_rho_0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pressure_and_its_slope_are_those_of_the_law() {
        let glass: MurnaghanTable = toml::from_str("rho_0 = 2540\nK_0 = \"5 GPa\"\nn = 4").unwrap();
        let law = Murnaghan::new(&glass);
        assert_eq!(law.pressure(2540.0), (0.0, (5e9f64 / 2540.0).sqrt()));
        // K_0 / 4 (1.1^4 - 1).
        assert!((law.pressure(1.1 * 2540.0).0 / (1.25e9 * 0.4641) - 1.0).abs() < 1e-13);
        for rho in [2450.0, 2540.0, 3000.0] {
            let slope = (law.pressure(rho + 0.01).0 - law.pressure(rho - 0.01).0) / 0.02;
            assert!((law.slopes(rho).by_rho / slope - 1.0).abs() < 1e-7, "{rho}");
        }
    }
}
