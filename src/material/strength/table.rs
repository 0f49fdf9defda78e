//! What a scene says about strength: `[material.X.strength]`. The laws of yield check their own keys.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::super::MaterialTable;
use super::super::setup::{Table, all_positive};
use crate::error::Result;
use crate::units::{Number, Pressure, SpecificEnergy};

/// Resistance to shear: von Mises' law, sqrt(3 J2) up to the yield strength at any pressure, unless a table of friction is there.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StrengthTable {
    /// Shear modulus.
    pub shear_modulus: Pressure,
    /// Largest strength of cold matter at any pressure: of sqrt(3 J2) in von Mises' law, of sqrt(J2) with friction.
    pub yield_strength: Pressure,
    /// Heat weakens.
    pub melting: Option<MeltingTable>,
    /// Friction of rock, intact to broken; this or `drucker_prager`.
    pub collins: Option<CollinsTable>,
    /// Friction of granular matter; this or `collins`.
    pub drucker_prager: Option<DruckerPragerTable>,
}

/// Heat weakens.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeltingTable {
    /// Specific internal energy at which no strength is left.
    pub energy: SpecificEnergy,
}

impl Table for StrengthTable {
    fn validate(&self, place: &str, _material: &MaterialTable) -> Result<()> {
        all_positive(place, &[("shear_modulus", self.shear_modulus.0), ("yield_strength", self.yield_strength.0)])?;
        self.validate_law(place)?;
        match self.melting {
            Some(melting) => all_positive(&format!("{place}.melting"), &[("energy", melting.energy.0)]),
            None => Ok(()),
        }
    }
}

/// Rock with friction, sqrt(J2) up to Y(P, D); damage acts on shear through Y alone.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CollinsTable {
    /// Y_0: sqrt(J2) that intact cold matter bears without pressure.
    pub cohesion: Pressure,
    /// mu_i: coefficient of friction of intact rock.
    pub internal_friction: Number,
    /// mu_d: coefficient of friction of broken rock.
    pub friction: Number,
    /// Y_c: cohesion of broken rock.
    pub damaged_cohesion: Pressure,
}

/// Granular matter, sqrt(J2) up to cohesion + friction P, at most the yield strength.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DruckerPragerTable {
    /// Strength without pressure.
    pub cohesion: Pressure,
    /// Coefficient of friction.
    pub friction: Number,
}
