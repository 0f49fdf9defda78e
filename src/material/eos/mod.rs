//! Equations of state: a closed family of laws, one file each. The effect that applies them is in `effect`.

mod effect;
pub mod ideal_gas;
pub mod murnaghan;
pub mod simplified_tillotson;
pub mod sirono;
pub mod slopes;
pub mod tabulated;
pub mod tillotson;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{MaterialTable, Table};
use crate::error::{Error, Result};
pub use effect::{EquationOfState, INTERNAL_ENERGY};
use ideal_gas::{IdealGas, IdealGasTable};
use murnaghan::{Murnaghan, MurnaghanTable};
use simplified_tillotson::{SimplifiedTillotson, SimplifiedTillotsonTable};
use sirono::{Sirono, SironoTable};
use slopes::Slopes;
use tabulated::{Tabulated, TabulatedTable};
use tillotson::{Tillotson, TillotsonTable};

/// Equation of state: a table with one key, the law.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum EosTable {
    /// Tillotson's equation of state.
    Tillotson(TillotsonTable),
    /// P = c rho E + A mu.
    SimplifiedTillotson(SimplifiedTillotsonTable),
    /// P = (gamma - 1) rho E.
    IdealGas(IdealGasTable),
    Murnaghan(MurnaghanTable),
    Sirono(SironoTable),
    #[serde(rename = "table")]
    Tabulated(TabulatedTable),
}

impl EosTable {
    pub fn law(&self) -> Eos {
        match self {
            EosTable::Tillotson(table) => Eos::Tillotson(Tillotson::new(table)),
            EosTable::SimplifiedTillotson(table) => Eos::SimplifiedTillotson(SimplifiedTillotson::new(table)),
            EosTable::IdealGas(table) => Eos::IdealGas(IdealGas::new(table)),
            EosTable::Murnaghan(table) => Eos::Murnaghan(Murnaghan::new(table)),
            EosTable::Sirono(table) => Eos::Sirono(Sirono::new(table)),
            EosTable::Tabulated(table) => Eos::Tabulated(Tabulated::new(table)),
        }
    }
}

impl Table for EosTable {
    fn validate(&self, place: &str, material: &MaterialTable) -> Result<()> {
        match self {
            EosTable::Tillotson(table) => table.validate(&format!("{place}.tillotson")),
            EosTable::SimplifiedTillotson(table) => table.validate(&format!("{place}.simplified_tillotson")),
            EosTable::IdealGas(table) => table.validate(&format!("{place}.ideal_gas")),
            EosTable::Murnaghan(table) => table.validate(&format!("{place}.murnaghan")),
            EosTable::Sirono(table) => {
                alone(place.trim_end_matches(".eos"), material)?;
                table.validate(&format!("{place}.sirono"))
            }
            EosTable::Tabulated(table) => table.validate(&format!("{place}.table")),
        }
    }
}

/// Refuses what the law of dust has of its own.
fn alone(material_place: &str, material: &MaterialTable) -> Result<()> {
    let others = [
        ("porosity", material.porosity.is_some()),
        ("strength", material.strength.is_some()),
        ("fracture", material.fracture.is_some()),
    ];
    match others.iter().find(|(_, there)| *there) {
        Some((table, _)) => Err(Error::new(format!("the law of dust, eos.sirono, has a {table} of its own"))
            .at(format!("{material_place}.{table}"))
            .allowed("no such table")),
        None => Ok(()),
    }
}

/// The closed family of equations of state.
#[derive(Debug, Clone, PartialEq)]
pub enum Eos {
    Tillotson(Tillotson),
    SimplifiedTillotson(SimplifiedTillotson),
    IdealGas(IdealGas),
    Murnaghan(Murnaghan),
    /// Without load; `dust` holds what load leaves behind.
    Sirono(Sirono),
    Tabulated(Tabulated),
}

impl Eos {
    /// Whether pressure follows from density alone, so that no internal energy is needed.
    pub fn is_cold(&self) -> bool {
        matches!(self, Eos::Murnaghan(_) | Eos::Sirono(_))
    }

    /// Pressure, Pa, and bulk speed of sound, m/s, at density `rho`, kg/m^3, and internal energy `u`, J/kg.
    #[inline]
    pub fn pressure(&self, rho: f64, u: f64) -> (f64, f64) {
        match self {
            Eos::Tillotson(law) => law.pressure(rho, u),
            Eos::SimplifiedTillotson(law) => law.pressure(rho, u),
            Eos::IdealGas(law) => law.pressure(rho, u),
            Eos::Murnaghan(law) => law.pressure(rho),
            Eos::Sirono(law) => law.unloaded(rho),
            Eos::Tabulated(law) => law.pressure(rho, u),
        }
    }

    /// Pressure and its derivatives.
    #[inline]
    pub fn slopes(&self, rho: f64, u: f64) -> Slopes {
        match self {
            Eos::Tillotson(law) => law.slopes(rho, u),
            Eos::SimplifiedTillotson(law) => law.slopes(rho, u),
            Eos::IdealGas(law) => law.slopes(rho, u),
            Eos::Murnaghan(law) => law.slopes(rho),
            Eos::Sirono(law) => law.slopes(rho),
            Eos::Tabulated(law) => law.slopes(rho, u),
        }
    }

    /// Density without load and heat, kg/m^3; a gas has none.
    pub fn reference_density(&self) -> Option<f64> {
        match self {
            Eos::Tillotson(law) => Some(law.reference_density()),
            Eos::SimplifiedTillotson(law) => Some(law.reference_density()),
            Eos::Murnaghan(law) => Some(law.reference_density()),
            Eos::Sirono(law) => Some(law.reference_density()),
            Eos::Tabulated(law) => Some(law.reference_density()),
            Eos::IdealGas(_) => None,
        }
    }

    /// Bulk modulus at the reference density, Pa; a gas has none.
    pub fn bulk_modulus(&self) -> Option<f64> {
        match self {
            Eos::Tillotson(law) => Some(law.bulk_modulus()),
            Eos::SimplifiedTillotson(law) => Some(law.bulk_modulus()),
            Eos::Murnaghan(law) => Some(law.bulk_modulus()),
            Eos::Sirono(law) => Some(law.bulk_modulus(law.reference_density())),
            Eos::Tabulated(law) => Some(law.bulk_modulus()),
            Eos::IdealGas(_) => None,
        }
    }

    /// Energies at which vaporisation begins and is complete, J/kg, for laws that know them.
    pub fn vaporisation(&self) -> Option<[f64; 2]> {
        match self {
            Eos::Tillotson(law) => Some(law.vaporisation()),
            Eos::Tabulated(law) => law.vaporisation(),
            Eos::SimplifiedTillotson(_) | Eos::IdealGas(_) | Eos::Murnaghan(_) | Eos::Sirono(_) => None,
        }
    }
}
