//! Ideal gas: P = (gamma - 1) rho u, c^2 = gamma (gamma - 1) u.
//!
//! rho density, kg/m^3; u specific internal energy, J/kg; gamma ratio of heats.
//! An energy below zero, which only rounding can cause, gives P = 0 and c = 0.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::slopes::Slopes;
use crate::error::{Error, Result};
use crate::units::Number;

/// Ideal gas, P = (gamma - 1) rho E.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct IdealGasTable {
    /// Ratio of the specific heats, above 1.
    pub gamma: Number,
}

impl IdealGasTable {
    pub(super) fn validate(&self, place: &str) -> Result<()> {
        if self.gamma.0 > 1.0 && self.gamma.0.is_finite() {
            return Ok(());
        }
        Err(Error::new(format!("gamma is {}", self.gamma.0)).at(format!("{place}.gamma")).allowed("numbers above 1"))
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IdealGas {
    gamma: f64,
}

impl IdealGas {
    pub fn new(table: &IdealGasTable) -> Self {
        Self { gamma: table.gamma.0 }
    }

    /// Pressure, Pa, and speed of sound, m/s.
    #[inline]
    pub fn pressure(&self, rho: f64, u: f64) -> (f64, f64) {
        let heat = (self.gamma - 1.0) * if u < 0.0 { 0.0 } else { u };
        (heat * rho, (self.gamma * heat).sqrt())
    }

    /// Pressure and its derivatives.
    #[inline]
    pub fn slopes(&self, rho: f64, u: f64) -> Slopes {
        let by_u = (self.gamma - 1.0) * rho;
        let heat = (self.gamma - 1.0) * if u < 0.0 { 0.0 } else { u };
        Slopes { p: heat * rho, by_rho: heat, by_u }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Left state of Sod's tube (Sod 1978, J. Comp. Phys. 27, 1): rho = 1, P = 1, gamma = 1.4, c = sqrt(1.4).
    #[test]
    fn pressure_and_sound_speed_of_sods_left_state() {
        let gas = IdealGas { gamma: 1.4 };
        let (p, c) = gas.pressure(1.0, 2.5);
        assert!((p - 1.0).abs() < 1e-15 && (c - 1.4f64.sqrt()).abs() < 1e-15);
        assert_eq!(gas.pressure(1.0, -1e-3), (0.0, 0.0));
    }
}
