//! A rig for tests: one particle per body, driven by a given velocity gradient with the predictor-corrector of the step
//! loop.

use super::damage::{DAMAGE, damaged_stress};
use super::strength;
use super::{BodyConstants, Core, Local, LocalFlow, MaterialEffect, MaterialTable, Records, Setup, StepLimit, effects};
use crate::error::Result;
use crate::math::{Deviator, Mat3};
use crate::particles::chunk::Chunks;
use crate::particles::{Column, Columns, Element, Life, ParticleId, Rates, Registry};

/// Benz & Asphaug 1999, Icarus 142, 5.
pub fn basalt() -> MaterialTable {
    toml::from_str(
        r#"
        eos = { tillotson = { rho_0 = 2700, a = 0.5, b = 1.5, A = "26.7 GPa", B = "26.7 GPa", E_0 = 487e6, E_iv = 4.72e6,
            E_cv = 18.2e6, alpha = 5, beta = 5 } }
        [strength]
        shear_modulus = "22.7 GPa"
        yield_strength = "3.5 GPa"
        melting = { energy = 3.4e6 }
        [fracture]
        model = "grady_kipp"
        weibull_k = "4.0e35 m^-3"
        weibull_m = 9
        "#,
    )
    .unwrap()
}

/// A material whose B is more than twice its A.
pub fn nylon() -> MaterialTable {
    toml::from_str(
        r#"eos = { tillotson = { rho_0 = 1185, a = 0.6, b = 2, A = "10.1 GPa", B = "33.8 GPa", E_0 = 7e6, E_iv = 2e6,
            E_cv = 2.4e6, alpha = 10, beta = 5 } }"#,
    )
    .unwrap()
}

pub fn gas() -> MaterialTable {
    toml::from_str("eos = { ideal_gas = { gamma = 1.4 } }").unwrap()
}

/// Dust as calibrated by Geretshauser et al. 2010, with more keys of its law.
pub fn silica(more: &str) -> MaterialTable {
    toml::from_str(&format!(
        "[eos.sirono]\nrho_s = 2000\nrho_i = 300\nK_0 = \"4.5 kPa\"\ngamma = 4\n{more}\n\
         tension = {{ T_0 = 630.9573444801932, slope = 1.48 }}\n\
         compression.powder = {{ p_m = 260, phi_1 = 0.12, phi_2 = 0.58, Delta = 0.58 }}\n"
    ))
    .expect("a material")
}

pub fn without_fracture(material: MaterialTable) -> MaterialTable {
    MaterialTable { fracture: None, ..material }
}

pub struct Rig {
    pub core: Core,
    pub columns: Columns,
    pub effects: Vec<Box<dyn MaterialEffect>>,
    /// Columns of the last rates, one per integrated column.
    rates: Vec<usize>,
    constants: Vec<BodyConstants>,
    bodies: Vec<u16>,
    friction: Vec<bool>,
}

impl Rig {
    /// One body, one particle of 1 m^3 with h = 1.2 m.
    pub fn new(material: MaterialTable) -> Self {
        Self::with_materials(vec![material])
    }

    /// One body of each material.
    pub fn with_materials(materials: Vec<MaterialTable>) -> Self {
        Self::with_records(materials, Records::default(), 0.0)
    }

    pub fn with_records(materials: Vec<MaterialTable>, records: Records, initial_damage: f64) -> Self {
        Self::try_new(materials, records, initial_damage).expect("effects that have what they need")
    }

    pub fn try_new(materials: Vec<MaterialTable>, records: Records, initial_damage: f64) -> Result<Self> {
        let count = materials.len();
        let constants: Vec<_> = materials
            .iter()
            .map(|material| {
                let distention = material.distention();
                let density = material.reference_density().unwrap_or(1.0) / distention;
                BodyConstants { particle_mass: density, smoothing_length: 1.2, particles: 1, density, distention }
            })
            .collect();
        let body_material: Vec<_> = (0..count).collect();
        let initial_damage = vec![initial_damage; count];
        let setup = Setup {
            dimension: 3,
            materials: &materials,
            body_material: &body_material,
            constants: &constants,
            initial_damage: &initial_damage,
            records,
            smoothing_length: None,
        };
        let mut registry = Registry::new(3);
        let (core, effects) = effects(&setup, &mut registry)?;
        let rates = registry.integrated.clone();
        let rates = rates.iter().map(|&index| registry.like(index, "_rate", Life::Kept)).collect();
        let mut columns = Columns::new(registry);
        columns.resize(count);
        for body in 0..count {
            columns.set(core.id, body, ParticleId::new(body, 0));
        }
        let bodies = (0..count as u16).collect();
        let friction = materials.iter().map(MaterialTable::has_friction).collect();
        let mut rig = Self { core, columns, effects, rates, constants, bodies, friction };
        rig.each(0.0, &[], |effect, local| effect.initialise(local));
        Ok(rig)
    }

    pub fn column<T: Element>(&self, name: &str) -> Column<T> {
        self.columns.registry.find(name).unwrap()
    }

    pub fn get<T: Element>(&self, column: Column<T>) -> T {
        self.columns.get(column, 0)
    }

    pub fn get_of<T: Element>(&self, body: usize, column: Column<T>) -> T {
        self.columns.get(column, body)
    }

    pub fn set<T: Element>(&mut self, column: Column<T>, value: T) {
        self.columns.set(column, 0, value);
    }

    /// Calls `act` for every effect in order; `update` and `initialise` need no flow.
    pub fn each(&mut self, dt: f64, flow: &[LocalFlow], mut act: impl FnMut(&dyn MaterialEffect, &Local)) {
        let new_rates = Rates::new(&self.columns.registry);
        let integrated = self.columns.registry.integrated.clone();
        let len = self.columns.len();
        let chunks = Chunks::new(&mut self.columns, Vec::new());
        // SAFETY: the only chunk.
        let chunk = unsafe { chunks.chunk(0..len) };
        let (bodies, constants) = (&self.bodies, &self.constants);
        let local = Local { chunk: &chunk, bodies, constants, flow, rates: &new_rates, dt };
        for effect in &self.effects {
            act(effect.as_ref(), &local);
        }
        if flow.is_empty() {
            return;
        }
        // The corrector: the mean of the old and the new rate replaces the old one.
        for ((&value, &rate), new) in integrated.iter().zip(&self.rates).zip(new_rates.blocks()) {
            for ((value, rate), new) in chunk.words(value).iter().zip(chunk.words(rate)).zip(new) {
                let change = f64::from_bits(new.get()) - f64::from_bits(rate.get());
                value.set((f64::from_bits(value.get()) + 0.5 * dt * change).to_bits());
                rate.set(new.get());
            }
        }
    }

    /// One step of `dt` in which every particle moves with `gradient`; the smallest step limit.
    pub fn step(&mut self, gradient: &Mat3, dt: f64) -> Option<StepLimit> {
        for (value, &rate) in self.columns.registry.integrated.clone().into_iter().zip(&self.rates) {
            let rates = self.columns.numbers(rate).to_vec();
            for (word, rate) in self.columns.words_mut(value).iter_mut().zip(rates) {
                *word = (f64::from_bits(*word) + rate * dt).to_bits();
            }
        }
        self.each(dt, &[], |effect, local| effect.admit(local));
        self.each(dt, &[], |effect, local| effect.update(local));
        self.each(dt, &[], |effect, local| effect.commit(local));
        let flow: Vec<_> = (0..self.columns.len())
            .map(|i| LocalFlow { velocity_gradient: *gradient, heating: self.heating(i, gradient) })
            .collect();
        let mut limits = Vec::new();
        self.each(dt, &flow, |effect, local| {
            effect.rates(local);
            limits.extend(effect.step_limit(local));
        });
        self.each(dt, &[], |effect, local| effect.admit(local));
        limits.into_iter().min_by(|a, b| a.dt.total_cmp(&b.dt))
    }

    /// sigma : L / rho.
    fn heating(&self, i: usize, gradient: &Mat3) -> f64 {
        let registry = &self.columns.registry;
        let at = |name| registry.find(name).map_or(0.0, |column| self.columns.get(column, i));
        let stress = registry.find(strength::DEVIATORIC_STRESS).map_or(Deviator::default(), |s| self.columns.get(s, i));
        let sigma = damaged_stress(&stress, self.columns.get(self.core.pressure, i), at(DAMAGE), self.friction[i]);
        sigma.to_matrix().dot(gradient) / self.columns.get(self.core.density.value, i)
    }
}
