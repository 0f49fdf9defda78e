//! Simplified form of Tillotson's law (Jutzi et al. 2008, eqs 17 and 64): P = c rho u + A mu, mu = rho / rho_0 - 1, for u far
//! below E_0 and small mu.
//!
//! P pressure, A bulk modulus, Pa; rho density, rho_0 reference density, kg/m^3; u specific internal energy, J/kg; c = a + b of
//! the full law. Tension fades as there, and c^2 >= A / (4 rho_0).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::super::setup::all_positive;
use super::slopes::{Slopes, bounded_sound, fading};
use crate::error::Result;
use crate::units::{Density, Number, Pressure};

/// P = c rho E + A mu, mu = rho / rho_0 - 1.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SimplifiedTillotsonTable {
    /// Density without load.
    pub rho_0: Density,
    /// Pressure by heat over energy density.
    pub c: Number,
    /// Bulk modulus.
    #[serde(rename = "A")]
    pub modulus: Pressure,
}

impl SimplifiedTillotsonTable {
    pub(super) fn validate(&self, place: &str) -> Result<()> {
        all_positive(place, &[("rho_0", self.rho_0.0), ("c", self.c.0), ("A", self.modulus.0)])
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SimplifiedTillotson {
    rho_0: f64,
    inverse_rho_0: f64,
    c: f64,
    modulus: f64,
}

impl SimplifiedTillotson {
    pub fn new(table: &SimplifiedTillotsonTable) -> Self {
        let rho_0 = table.rho_0.0;
        Self { rho_0, inverse_rho_0: 1.0 / rho_0, c: table.c.0, modulus: table.modulus.0 }
    }

    pub fn reference_density(&self) -> f64 {
        self.rho_0
    }

    /// K = rho dP/drho at rho_0 and u = 0, Pa.
    pub fn bulk_modulus(&self) -> f64 {
        self.modulus
    }

    /// Pressure, Pa, and speed of sound, m/s. An energy below zero counts as zero.
    #[inline]
    pub fn pressure(&self, rho: f64, u: f64) -> (f64, f64) {
        let state = self.slopes(rho, u);
        (state.p, bounded_sound(state.sound2(rho), self.modulus * self.inverse_rho_0))
    }

    /// Pressure and its derivatives.
    #[inline]
    pub fn slopes(&self, rho: f64, u: f64) -> Slopes {
        let u = if u < 0.0 { 0.0 } else { u };
        let eta = rho * self.inverse_rho_0;
        let state = Slopes {
            p: self.c * rho * u + self.modulus * (eta - 1.0),
            by_rho: self.c * u + self.modulus * self.inverse_rho_0,
            by_u: self.c * rho,
        };
        fading(state, eta, self.inverse_rho_0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Quantity;

    fn law() -> SimplifiedTillotson {
        SimplifiedTillotson::new(&SimplifiedTillotsonTable {
            rho_0: Quantity(2700.0),
            c: Quantity(2.0),
            modulus: Quantity(7.5e10),
        })
    }

    #[test]
    fn pressure_is_linear_in_energy_and_density() {
        let (p, sound) = law().pressure(2727.0, 1e5);
        assert!((p - (2.0 * 2727.0 * 1e5 + 7.5e8)).abs() < 1e-4);
        // c^2 = c u + A / rho_0 + c P / rho
        let expected = 2e5 + 7.5e10 / 2700.0 + 2.0 * p / 2727.0;
        assert!((sound * sound / expected - 1.0).abs() < 1e-14);
    }

    #[test]
    fn far_expanded_matter_does_not_pull() {
        assert_eq!(law().pressure(0.8 * 2700.0, 0.0).0, 0.0);
        assert!(law().pressure(0.99 * 2700.0, 0.0).0 < -7e8);
    }
}
