//! Highly porous dust (see `eos::sirono`): pressure and bulk speed of sound from density and reference density, and the reference
//! density itself, which moves where pressure exceeds a strength. Shear is in `strength`.
//!
//! Plasticity at once (variant 1 of Geretshauser et al. 2010, Sect. 2.3): the reference density follows in every step. After unloading
//! (variant 2): pressure follows the strength, and the reference density moves when density turns back; until then the modulus is that of
//! before. A particle then keeps the density at which it yielded last, negative in tension, zero while it is elastic.
//!
//! Columns: owns `reference_density`, `filling_factor`, and `yield_density` where a material of the scene yields after unloading. Sets
//! the core columns `pressure` and `sound_speed` of dust.
//! Diagnostic: the volume that dust has lost for good, sum m max(0, 1/rho_0 - 1/rho'); what was torn apart counts nothing.
//! Time step: none of its own; the Courant condition uses its speed of sound.

use super::eos::EosTable;
use super::eos::sirono::{Loaded, Plasticity, Sirono};
use super::{Core, Diagnostic, Local, MaterialEffect, MaterialTable, PerBody, Setup};
use crate::error::Result;
use crate::particles::{Column, ColumnInfo, Columns, Life, Registry};

/// Names of columns that other effects and outcomes read.
pub const REFERENCE_DENSITY: &str = "reference_density";
pub const FILLING_FACTOR: &str = "filling_factor";
/// Name of the diagnostic.
pub const COMPACTED_VOLUME: &str = "dust_compacted_volume";

/// Pressure and reference density of bodies of dust.
pub struct Dust {
    bodies: PerBody<Sirono>,
    /// Volume of a particle of each body at the start over its mass, m^3/kg.
    specific_volumes: Vec<f64>,
    density: Column<f64>,
    reference: Column<f64>,
    filling_factor: Column<f64>,
    /// Where a material yields after unloading.
    yielded: Option<Column<f64>>,
    pressure: Column<f64>,
    sound_speed: Column<f64>,
}

impl MaterialTable {
    /// The law of dust, if this is dust.
    pub fn dust(&self) -> Option<Sirono> {
        match &self.eos {
            EosTable::Sirono(table) => Some(Sirono::new(table)),
            _ => None,
        }
    }
}

impl MaterialEffect for Dust {
    fn declare(setup: &Setup, registry: &mut Registry, core: &Core) -> Result<Option<Self>> {
        let Some(bodies) = PerBody::new(setup, |_, material| material.dust()) else { return Ok(None) };
        let late = |body: usize| bodies.of(body).is_some_and(|law| law.plasticity == Plasticity::AfterUnloading);
        let late = (0..setup.constants.len()).any(late);
        let info = |name, unit, about, life, snapshot| ColumnInfo { name, unit, about, life, snapshot };
        registry.owner("dust");
        let about = "Density at which dust would be without load.";
        let reference = registry.column(info(REFERENCE_DENSITY, "kg/m^3", about, Life::State, true));
        let about = "Share of the volume that monomers of dust fill; 1 in other matter.";
        let filling_factor = registry.column(info(FILLING_FACTOR, "", about, Life::Scratch, true));
        let about = "Density at which dust yielded last, negative in tension; zero while it is elastic.";
        let yielded = late.then(|| registry.column(info("yield_density", "kg/m^3", about, Life::State, false)));
        let (density, pressure, sound_speed) = (core.density.value, core.pressure, core.sound_speed);
        let specific_volumes = setup.constants.iter().map(|constants| 1.0 / constants.density).collect();
        Ok(Some(Self { bodies, specific_volumes, density, reference, filling_factor, yielded, pressure, sound_speed }))
    }

    fn name(&self) -> &'static str {
        "dust"
    }

    fn initialise(&self, local: &Local) {
        let (density, reference, filling_factor) =
            (local.view(self.density), local.view(self.reference), local.view(self.filling_factor));
        (0..local.len()).for_each(|i| filling_factor.set(i, 1.0));
        for (_, range) in self.bodies.runs(local) {
            range.for_each(|i| reference.set(i, density.get(i)));
        }
    }

    fn update(&self, local: &Local) {
        let (density, reference) = (local.view(self.density), local.view(self.reference));
        let (pressure, sound_speed) = (local.view(self.pressure), local.view(self.sound_speed));
        let filling_factor = local.view(self.filling_factor);
        for (law, range) in self.bodies.runs(local) {
            let yielded = self.yielded.filter(|_| law.plasticity == Plasticity::AfterUnloading);
            let yielded = yielded.map(|column| local.view(column));
            for i in range {
                let rho = density.get(i);
                let loaded = match &yielded {
                    None => law.load(rho, reference.get(i)),
                    Some(yielded) => {
                        let later = Later { reference: reference.get(i), yielded: yielded.get(i) };
                        let (pressure, later) = later.load(law, rho);
                        yielded.set(i, later.yielded);
                        Loaded { pressure, reference: later.reference }
                    }
                };
                reference.set(i, loaded.reference);
                pressure.set(i, loaded.pressure);
                sound_speed.set(i, (law.bulk_modulus(loaded.reference) / loaded.reference).sqrt());
                filling_factor.set(i, law.filling_factor(rho));
            }
        }
    }

    fn diagnostics(&self) -> Vec<Diagnostic> {
        vec![Diagnostic { name: COMPACTED_VOLUME, unit: "m^3" }]
    }

    fn diagnose(&self, columns: &Columns, i: usize, body: usize, mass: f64, add: &mut dyn FnMut(usize, f64)) {
        if self.bodies.of(body).is_some() {
            add(0, mass * (self.specific_volumes[body] - 1.0 / columns.get(self.reference, i)).max(0.0));
        }
    }
}

/// The state of dust that deforms for good after unloading, kg/m^3.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Later {
    reference: f64,
    yielded: f64,
}

impl Later {
    /// Pressure at a density, Pa, and the state that it leaves.
    fn load(self, law: &Sirono, rho: f64) -> (f64, Self) {
        let at = self.yielded.abs();
        let yields_on = if self.yielded > 0.0 { rho >= at } else { self.yielded < 0.0 && rho <= at };
        if yields_on {
            let strength = law.limited(f64::INFINITY.copysign(self.yielded), rho);
            if law.reference_of(rho, strength).is_some() {
                return (strength, Self { yielded: rho.copysign(self.yielded), ..self });
            }
        }
        let mut reference = self.reference;
        if self.yielded != 0.0 {
            let strength = law.limited(f64::INFINITY.copysign(self.yielded), at);
            reference = law.reference_of(at, strength).unwrap_or(reference);
        }
        let elastic = law.elastic_pressure(rho, reference);
        let bearable = law.limited(elastic, rho);
        match bearable != elastic && law.reference_of(rho, bearable).is_some() {
            true => (bearable, Self { reference, yielded: rho.copysign(elastic) }),
            false => (elastic, Self { reference, yielded: 0.0 }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::{Rig, silica};
    use super::*;
    use crate::math::Mat3;

    /// Both variants give one pressure along a path of loads that turns often, up to the stiffness within a step.
    #[test]
    fn both_variants_give_the_same_pressure() {
        let law = silica("").dust().unwrap();
        let (mut reference, mut later) = (300.0, Later { reference: 300.0, yielded: 0.0 });
        let mut yields = 0;
        for step in 0..4000 {
            let turn = 2e-3 * step as f64;
            let phi = 0.15 + 0.03 * turn * (1.0 + 0.4 * libm::sin(7.0 * turn)) - 0.01 * libm::sin(31.0 * turn);
            let rho = 2000.0 * phi.max(0.125);
            let loaded = law.load(rho, reference);
            reference = loaded.reference;
            let (pressure, next) = later.load(&law, rho);
            later = next;
            yields += (next.yielded != 0.0) as usize;
            let scale = loaded.pressure.abs().max(1.0);
            assert!((pressure - loaded.pressure).abs() < 1e-9 * scale, "{step} {phi}: {pressure} {loaded:?}");
        }
        assert!(yields > 500 && yields < 3500, "{yields}");
    }

    /// Elastic matter keeps its reference density, and the column of variant 2 is there only where it is asked for.
    #[test]
    fn columns_follow_from_the_variant() {
        let mut rig = Rig::new(silica(""));
        assert!(rig.columns.registry.find::<f64>("yield_density").is_none());
        assert!(rig.columns.registry.find::<f64>(super::super::eos::INTERNAL_ENERGY).is_none());
        rig.step(&Mat3::zeros(), 0.0);
        let (reference, filling_factor) = (rig.column::<f64>(REFERENCE_DENSITY), rig.column::<f64>(FILLING_FACTOR));
        assert_eq!((rig.get(reference), rig.get(filling_factor)), (300.0, 0.15));
        assert_eq!(rig.get(rig.core.pressure), 0.0);
        rig.step(&Mat3::from_diagonal_element(1e-3), 0.0);
        for _ in 0..10 {
            rig.step(&Mat3::from_diagonal_element(1e-3), 1.0);
        }
        // Tension below the strength of 1 kPa.
        let p = rig.get(rig.core.pressure);
        assert!(rig.get(reference) == 300.0 && (-200.0..0.0).contains(&p), "{p}");
        let later = Rig::new(silica("plasticity = \"after_unloading\""));
        assert!(later.columns.registry.find::<f64>("yield_density").is_some());
    }
}
