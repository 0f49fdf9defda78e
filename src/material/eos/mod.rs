//! Equation of state: pressure and bulk speed of sound from density and internal energy, and the energy itself:
//! du/dt = sigma : L / rho + viscous heating (Jutzi et al. 2008, eq. 29), summed by the pair loop as the counterpart of
//! the momentum sums.
//!
//! u specific internal energy, J/kg; P pressure, Pa; c speed of sound, m/s.
//! Columns: owns `internal_energy`; sets the core columns `pressure` and `sound_speed`, but for porous bodies, whose pressure
//! is that of their matrix (see `porosity`).
//! Time step: none of its own; the Courant condition uses its speed of sound.

pub mod ideal_gas;
pub mod murnaghan;
pub mod simplified_tillotson;
pub mod tillotson;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Core, Late, Local, MaterialEffect, MaterialTable, PerBody, Setup, Table};
use crate::error::Result;
use crate::particles::{Column, ColumnInfo, Integrated, Life, Registry};
use ideal_gas::{IdealGas, IdealGasTable};
use murnaghan::{Murnaghan, MurnaghanTable};
use simplified_tillotson::{SimplifiedTillotson, SimplifiedTillotsonTable};
use tillotson::{Tillotson, TillotsonTable};

/// Name of the column that this effect owns.
pub const INTERNAL_ENERGY: &str = "internal_energy";

/// Equation of state: a table with one key, the law.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum EosTable {
    /// Tillotson's equation of state.
    Tillotson(TillotsonTable),
    /// P = c rho E + A mu.
    SimplifiedTillotson(SimplifiedTillotsonTable),
    /// P = (gamma - 1) rho E.
    IdealGas(IdealGasTable),
    Murnaghan(MurnaghanTable),
}

impl EosTable {
    pub fn law(&self) -> Eos {
        match self {
            EosTable::Tillotson(table) => Eos::Tillotson(Tillotson::new(table)),
            EosTable::SimplifiedTillotson(table) => Eos::SimplifiedTillotson(SimplifiedTillotson::new(table)),
            EosTable::IdealGas(table) => Eos::IdealGas(IdealGas::new(table)),
            EosTable::Murnaghan(table) => Eos::Murnaghan(Murnaghan::new(table)),
        }
    }
}

impl Table for EosTable {
    fn validate(&self, place: &str, _material: &MaterialTable) -> Result<()> {
        match self {
            EosTable::Tillotson(table) => table.validate(&format!("{place}.tillotson")),
            EosTable::SimplifiedTillotson(table) => table.validate(&format!("{place}.simplified_tillotson")),
            EosTable::IdealGas(table) => table.validate(&format!("{place}.ideal_gas")),
            EosTable::Murnaghan(table) => table.validate(&format!("{place}.murnaghan")),
        }
    }
}

/// The closed family of equations of state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Eos {
    Tillotson(Tillotson),
    SimplifiedTillotson(SimplifiedTillotson),
    IdealGas(IdealGas),
    Murnaghan(Murnaghan),
}

impl Eos {
    /// Whether pressure follows from density alone, so that no internal energy is needed.
    pub fn is_cold(&self) -> bool {
        matches!(self, Eos::Murnaghan(_))
    }

    /// Pressure, Pa, and bulk speed of sound, m/s, at density `rho`, kg/m^3, and internal energy `u`, J/kg.
    #[inline]
    pub fn pressure(&self, rho: f64, u: f64) -> (f64, f64) {
        match self {
            Eos::Tillotson(law) => law.pressure(rho, u),
            Eos::SimplifiedTillotson(law) => law.pressure(rho, u),
            Eos::IdealGas(law) => law.pressure(rho, u),
            Eos::Murnaghan(law) => law.pressure(rho),
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
        }
    }

    /// Density without load and heat, kg/m^3; a gas has none.
    pub fn reference_density(&self) -> Option<f64> {
        match self {
            Eos::Tillotson(law) => Some(law.reference_density()),
            Eos::SimplifiedTillotson(law) => Some(law.reference_density()),
            Eos::Murnaghan(law) => Some(law.reference_density()),
            Eos::IdealGas(_) => None,
        }
    }

    /// Bulk modulus at the reference density, Pa; a gas has none.
    pub fn bulk_modulus(&self) -> Option<f64> {
        match self {
            Eos::Tillotson(law) => Some(law.bulk_modulus()),
            Eos::SimplifiedTillotson(law) => Some(law.bulk_modulus()),
            Eos::Murnaghan(law) => Some(law.bulk_modulus()),
            Eos::IdealGas(_) => None,
        }
    }

    /// Energies at which vaporisation begins and is complete, J/kg, for laws that know them.
    pub fn vaporisation(&self) -> Option<[f64; 2]> {
        match self {
            Eos::Tillotson(law) => Some(law.vaporisation()),
            Eos::SimplifiedTillotson(_) | Eos::IdealGas(_) | Eos::Murnaghan(_) => None,
        }
    }
}

/// Pressure and its partial derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slopes {
    /// Pa.
    pub p: f64,
    /// dP/drho at constant energy, m^2/s^2.
    pub by_rho: f64,
    /// dP/du at constant density, kg/m^3.
    pub by_u: f64,
}

impl Slopes {
    /// c^2 = dP/drho + P / rho^2 dP/du, m^2/s^2.
    #[inline]
    pub fn sound2(&self, rho: f64) -> f64 {
        self.by_rho + self.p * self.by_u / (rho * rho)
    }
}

/// The speed of sound of a solid, m/s, whose square is at least a quarter of that at rest, `rest2`.
#[inline]
pub fn bounded_sound(sound2: f64, rest2: f64) -> f64 {
    let lowest = 0.25 * rest2;
    if sound2 < lowest { lowest } else { sound2 }.sqrt()
}

/// Where tension begins to fade, and where it has gone, as rho / rho_0.
const TENSION_FADES: f64 = 0.95;
const TENSION_GONE: f64 = 0.85;

/// Tension of matter that has expanded too far to bear it: it fades linearly between eta = 0.95 and 0.85. The largest tension that
/// is left, 0.056 A at most, is a few times the spall strength of metals, and rock breaks at strains of 1e-3, so that solids
/// are limited by their own fracture and never by this.
#[inline]
fn fading(state: Slopes, eta: f64, inverse_rho_0: f64) -> Slopes {
    if !(state.p < 0.0 && eta < TENSION_FADES) {
        return state;
    }
    let slope = 1.0 / (TENSION_FADES - TENSION_GONE);
    if eta <= TENSION_GONE {
        return Slopes { p: 0.0, by_rho: 0.0, by_u: 0.0 };
    }
    let share = (eta - TENSION_GONE) * slope;
    Slopes {
        p: share * state.p,
        by_rho: share * state.by_rho + state.p * slope * inverse_rho_0,
        by_u: share * state.by_u,
    }
}

/// Pressure and speed of sound of the particles that are not porous, and the internal energy of all, unless every law of the scene
/// is cold; always present.
pub struct EquationOfState {
    /// `None` where all bodies are porous.
    laws: Option<PerBody<Eos>>,
    density: Column<f64>,
    energy: Option<Integrated<f64>>,
    pressure: Column<f64>,
    sound_speed: Column<f64>,
}

impl MaterialEffect for EquationOfState {
    fn declare(setup: &Setup, registry: &mut Registry, core: &Core) -> Result<Option<Self>> {
        let laws = PerBody::new(setup, |_, material| material.porosity.is_none().then(|| material.eos.law()));
        let cold = setup.body_material.iter().all(|&material| setup.materials[material].eos.law().is_cold());
        let energy = (!cold).then(|| {
            registry.owner("eos").integrated(ColumnInfo {
                name: INTERNAL_ENERGY,
                unit: "J/kg",
                about: "Specific internal energy.",
                life: Life::State,
                snapshot: true,
            })
        });
        let (density, pressure, sound_speed) = (core.density.value, core.pressure, core.sound_speed);
        Ok(Some(Self { laws, density, energy, pressure, sound_speed }))
    }

    fn name(&self) -> &'static str {
        "eos"
    }

    fn soften(&mut self, late: &Late) {
        let laws = self.laws.iter_mut().flat_map(PerBody::iter_mut);
        laws.for_each(|(body, law)| *law = late.0[body].law());
    }

    fn rates(&self, local: &Local) {
        let Some(rate) = self.energy.map(|energy| local.rate(energy)) else { return };
        for (i, flow) in local.flow.iter().enumerate() {
            rate.set(i, flow.heating);
        }
    }

    fn update(&self, local: &Local) {
        let (density, energy) = (local.view(self.density), local.optional(self.energy.map(|energy| energy.value)));
        let (pressure, sound_speed) = (local.view(self.pressure), local.view(self.sound_speed));
        let set = |i: usize, (p, c): (f64, f64)| {
            pressure.set(i, p);
            sound_speed.set(i, c);
        };
        let state = |i: usize| (density.get(i), energy.get(i));
        for (law, range) in self.laws.iter().flat_map(|laws| laws.runs(local)) {
            // The law is chosen outside the loop over particles.
            match law {
                Eos::Tillotson(law) => range.for_each(|i| set(i, law.pressure(state(i).0, state(i).1))),
                Eos::SimplifiedTillotson(law) => range.for_each(|i| set(i, law.pressure(state(i).0, state(i).1))),
                Eos::IdealGas(law) => range.for_each(|i| set(i, law.pressure(state(i).0, state(i).1))),
                Eos::Murnaghan(law) => range.for_each(|i| set(i, law.pressure(density.get(i)))),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::{Rig, basalt, gas};
    use super::*;
    use crate::math::Mat3;

    #[test]
    fn tables_are_strict() {
        let table = |text: &str| toml::from_str::<MaterialTable>(text);
        assert!(table("eos = { ideal_gas = { gamma = 1.4 } }").is_ok());
        assert!(table("eos = { ideal_gas = { gamma = 1.4, mass = 2 } }").is_err());
        assert!(table("eos = { van_der_waals = { gamma = 1.4 } }").is_err());
        let error = table("eos = { ideal_gas = { gamma = 1 } }").unwrap().validate("material.air").unwrap_err();
        assert_eq!(error.to_string(), "material.air.eos.ideal_gas.gamma: gamma is 1 (allowed: numbers above 1)");
    }

    /// Adiabatic compression of a gas from rest: P / rho^gamma stays, to second order in the step.
    #[test]
    fn adiabatic_compression_keeps_entropy() {
        let mut rig = Rig::new(gas());
        let energy = rig.column(INTERNAL_ENERGY);
        rig.set(energy, 2.5e5);
        rig.step(&Mat3::zeros(), 0.0);
        let entropy = |rig: &Rig| rig.get(rig.core.pressure) / libm::pow(rig.get(rig.core.density.value), 1.4);
        let before = entropy(&rig);
        for _ in 0..1000 {
            rig.step(&Mat3::from_diagonal_element(-0.1), 1e-3);
        }
        assert!((entropy(&rig) / before - 1.0).abs() < 1e-6, "{}", entropy(&rig) / before);
    }

    /// A scene of cold matter has no column of energy, and an effect that requires one is an error.
    #[test]
    fn cold_matter_has_no_energy() {
        let material = |more: &str| -> MaterialTable {
            toml::from_str(&format!("eos = {{ murnaghan = {{ rho_0 = 2540, K_0 = 5e9, n = 4 }} }}\n{more}")).unwrap()
        };
        let mut rig = Rig::new(material("strength = { shear_modulus = 3e9, yield_strength = 1e8 }"));
        assert!(rig.columns.registry.find::<f64>(INTERNAL_ENERGY).is_none());
        rig.step(&Mat3::from_diagonal_element(-0.1), 0.0);
        for _ in 0..10 {
            rig.step(&Mat3::from_diagonal_element(-0.1), 0.01);
        }
        // ln(rho / rho_0) is 0.03.
        let exact = 1.25e9 * (libm::exp(0.12) - 1.0);
        assert!((rig.get(rig.core.pressure) / exact - 1.0).abs() < 1e-3, "{}", rig.get(rig.core.pressure));
        let melting = "strength = { shear_modulus = 3e9, yield_strength = 1e8, melting = { energy = 1e6 } }";
        assert!(Rig::try_new(vec![material(melting)], Default::default(), 0.0).is_err());
        let records = super::super::Records { melt_fraction: true, ..Default::default() };
        assert!(Rig::try_new(vec![material("")], records, 0.0).is_err());
        assert!(Rig::try_new(vec![material(""), basalt()], records, 0.0).is_ok());
    }

    #[test]
    fn each_body_has_its_own_law() {
        let mut rig = Rig::with_materials(vec![gas(), basalt()]);
        rig.step(&Mat3::zeros(), 0.0);
        assert_eq!(rig.get_of(0, rig.core.sound_speed), 0.0);
        assert!(rig.get_of(1, rig.core.sound_speed) > 3000.0);
    }
}
