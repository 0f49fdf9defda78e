//! Equation of state: pressure and bulk speed of sound from density and internal energy, and the energy itself:
//! du/dt = sigma : L / rho + viscous heating (Jutzi et al. 2008, eq. 29), summed by the pair loop as the counterpart of
//! the momentum sums.
//!
//! u specific internal energy, J/kg; P pressure, Pa; c speed of sound, m/s.
//! Columns: owns `internal_energy`; sets the core columns `pressure` and `sound_speed`, but for porous bodies, whose pressure
//! is that of their matrix (see `porosity`), and for dust, whose pressure depends on former loads (see `dust`).
//! Time step: none of its own; the Courant condition uses its speed of sound.

use super::super::{Core, Late, Local, MaterialEffect, PerBody, Setup};
use super::Eos;
use crate::error::Result;
use crate::particles::{Column, ColumnInfo, Integrated, Life, Registry};

/// Name of the column that this effect owns.
pub const INTERNAL_ENERGY: &str = "internal_energy";

/// Pressure and speed of sound of the particles that are not porous, and the internal energy of all, unless every law of the scene
/// is cold; always present.
pub struct EquationOfState {
    /// `None` where all bodies are porous or dust.
    laws: Option<PerBody<Eos>>,
    density: Column<f64>,
    energy: Option<Integrated<f64>>,
    pressure: Column<f64>,
    sound_speed: Column<f64>,
}

impl MaterialEffect for EquationOfState {
    fn declare(setup: &Setup, registry: &mut Registry, core: &Core) -> Result<Option<Self>> {
        let laws = PerBody::new(setup, |_, material| {
            (material.porosity.is_none() && !material.is_dust()).then(|| material.eos.law())
        });
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
                Eos::Tabulated(law) => range.for_each(|i| set(i, law.pressure(state(i).0, state(i).1))),
                Eos::Murnaghan(law) => range.for_each(|i| set(i, law.pressure(density.get(i)))),
                Eos::Sirono(_) => {}
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::MaterialTable;
    use super::super::super::testing::{Rig, basalt, gas};
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
        let records = super::super::super::Records { melt_fraction: true, ..Default::default() };
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
