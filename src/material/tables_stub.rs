//! Stand-in for the tables of the material effects, with the shapes that the effects' own files define.

use serde::{Deserialize, Serialize};

use crate::error::{Error, Result};
use crate::units::{Number, NumberDensity, Pressure, SpecificEnergy};

pub mod eos {
    use crate::units::{Density, Number, Pressure, SpecificEnergy};
    use serde::{Deserialize, Serialize};

    #[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case", deny_unknown_fields)]
    pub enum EosTable {
        Tillotson(TillotsonTable),
        IdealGas(IdealGasTable),
    }

    #[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
    #[serde(deny_unknown_fields)]
    pub struct TillotsonTable {
        pub rho_0: Density,
        pub a: Number,
        pub b: Number,
        #[serde(rename = "A")]
        pub modulus_a: Pressure,
        #[serde(rename = "B")]
        pub modulus_b: Pressure,
        #[serde(rename = "E_0")]
        pub e_0: SpecificEnergy,
        #[serde(rename = "E_iv")]
        pub e_iv: SpecificEnergy,
        #[serde(rename = "E_cv")]
        pub e_cv: SpecificEnergy,
        pub alpha: Number,
        pub beta: Number,
    }

    #[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
    #[serde(deny_unknown_fields)]
    pub struct IdealGasTable {
        pub gamma: Number,
    }
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MaterialTable {
    pub eos: eos::EosTable,
    pub strength: Option<StrengthTable>,
    pub fracture: Option<FractureTable>,
    pub viscosity: Option<ViscosityTable>,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StrengthTable {
    #[serde(rename = "yield")]
    pub yield_law: YieldLaw,
    pub shear_modulus: Pressure,
    pub yield_strength: Pressure,
    pub melting: Option<MeltingTable>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum YieldLaw {
    VonMises,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MeltingTable {
    pub energy: SpecificEnergy,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FractureTable {
    pub model: FractureModel,
    pub seed: u64,
    pub weibull_k: NumberDensity,
    pub weibull_m: Number,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FractureModel {
    GradyKipp,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ViscosityTable {
    pub alpha: Number,
    pub beta: Number,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Records {
    pub peak_pressure: bool,
    pub melt_fraction: bool,
    pub vapour_fraction: bool,
}

impl Records {
    pub fn validate(&self, _materials: &[MaterialTable]) -> Result<()> {
        Ok(())
    }
}

impl MaterialTable {
    pub fn validate(&self, place: &str) -> Result<()> {
        match self.strength {
            Some(s) if s.shear_modulus.0 <= 0.0 => {
                let place = format!("{place}.strength.shear_modulus");
                Err(Error::new("shear_modulus is not positive").at(place).allowed("numbers above zero"))
            }
            _ => Ok(()),
        }
    }

    pub fn reference_density(&self) -> Option<f64> {
        match self.eos {
            eos::EosTable::Tillotson(t) => Some(t.rho_0.0),
            eos::EosTable::IdealGas(_) => None,
        }
    }

    pub fn has_fracture(&self) -> bool {
        self.fracture.is_some()
    }
}
