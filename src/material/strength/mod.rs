//! Elastic shear up to a yield surface.
//!
//! ```text
//! dS/dt = 2 mu (e - tr(e)/3) + Omega S - S Omega     Jutzi et al. 2008, eqs 31-32 with the sign of the spin corrected
//! e = (L + L^T)/2    Omega = (L - L^T)/2
//! S -> S min(1, Y / sqrt(3 J2)) or S min(1, Y / sqrt(J2)), depending on the law of `yield_law`; J2 = S:S / 2
//! c_L^2 = c^2 + 4 mu / (3 rho)
//! ```
//! S deviatoric stress, mu shear modulus, Y yield strength, Pa; e strain rate, Omega spin, 1/s; c, c_L bulk and longitudinal
//! speed of sound, m/s. In 2D this is plane strain: S_zz = -(S_xx + S_yy) counts in J2.
//!
//! In porous bodies S is that of the body, S_s / alpha with S_s of the matrix (Jutzi et al. 2008, eqs 45-53, with f on Hooke's
//! term alone, as stress rotates with the body whatever its pores do, and S is that of the body throughout):
//!
//! ```text
//! dS/dt = f / alpha 2 mu (e - tr(e)/3) + Omega S - S Omega - S alpha' / alpha    c_L^2 = c^2 + 4 mu / (3 alpha rho)
//! ```
//! f of `porosity`, within 0 and 1; alpha' the rate of distention alpha. Y does not depend on alpha.
//!
//! Without friction S is the stress of the undamaged matter: damage weakens the acting stress (see `damage`) and is never written
//! back. With friction Y depends on damage, and S is the acting stress: damage affects shear in no other way, or broken rock
//! under pressure would bear none. Y then needs the pressure, so that S returns to its surface when that is known, at the state
//! of the pair loop; damage is that of the step before.
//! Dust shears by its own law (see `dust`). Columns: owns `deviatoric_stress`; stiffens the core column `sound_speed`.
//! Time step: none of its own; the Courant condition uses the longitudinal speed.

mod dust;
mod table;
mod yield_law;

use super::damage::damage_column;
use super::porosity::{PoreColumns, distention_rate};
use super::{Core, Late, Local, MaterialEffect, MaterialTable, PerBody, Setup, eos};
use crate::error::{Error, Result};
use crate::math::{Deviator, Sym};
use crate::particles::{Column, ColumnInfo, Integrated, Life, Registry};
use dust::DustShear;
pub use table::{CollinsTable, DruckerPragerTable, MeltingTable, StrengthTable};
use yield_law::{LARGEST_VOLUME, Yield, returned};

/// Name of the column that this effect owns.
pub const DEVIATORIC_STRESS: &str = "deviatoric_stress";

#[derive(Debug, Clone, Copy)]
struct Solid {
    shear_modulus: f64,
    yields: Yield,
    friction: bool,
    /// Constant damage of bodies without fracture.
    damage: f64,
    can_break: bool,
    /// Density of the matrix below which shear waves get no faster, kg/m^3.
    lowest_density: f64,
    porous: bool,
}

impl Solid {
    fn new(setup: &Setup, body: usize, material: &MaterialTable) -> Option<Self> {
        let table = material.strength.as_ref()?;
        let constants = &setup.constants[body];
        Some(Self {
            shear_modulus: table.shear_modulus.0,
            yields: Yield::new(table),
            friction: table.has_friction(),
            damage: setup.initial_damage[body],
            can_break: material.has_fracture(),
            lowest_density: constants.density * constants.distention / LARGEST_VOLUME,
            porous: material.porosity.is_some(),
        })
    }
}

/// Deviatoric stress of the bodies that have strength.
pub struct Strength {
    /// `None` where all bodies that bear shear are dust.
    solids: Option<PerBody<Solid>>,
    dust: Option<DustShear>,
    stress: Integrated<Deviator>,
    density: Column<f64>,
    /// Where an equation of state has one; without it heat does not weaken.
    energy: Option<Column<f64>>,
    pressure: Column<f64>,
    sound_speed: Column<f64>,
    /// Where any body is porous.
    pores: Option<PoreColumns>,
    /// Where a body with friction can break.
    damage: Option<Column<f64>>,
}

impl MaterialEffect for Strength {
    fn declare(setup: &Setup, registry: &mut Registry, core: &Core) -> Result<Option<Self>> {
        if !setup.body_material.iter().any(|&material| setup.materials[material].has_strength()) {
            return Ok(None);
        }
        let solids = PerBody::new(setup, |body, material| Solid::new(setup, body, material));
        let pores = PoreColumns::find(registry);
        let stress = registry.owner("strength").integrated(ColumnInfo {
            name: DEVIATORIC_STRESS,
            unit: "Pa",
            about: "Deviatoric stress before damage.",
            life: Life::State,
            snapshot: true,
        });
        let energy = registry.find(eos::INTERNAL_ENERGY);
        if energy.is_none() && setup.materials.iter().any(MaterialTable::melts) {
            return Err(Error::new("strength falls with heat, but no equation of state has an internal energy"));
        }
        let breaks = |body| {
            let solid = solids.as_ref().and_then(|solids| solids.of(body));
            solid.is_some_and(|solid: &Solid| solid.friction && solid.can_break)
        };
        let damage = (0..setup.constants.len()).any(breaks).then(|| damage_column(registry));
        let dust = DustShear::new(setup, registry, core, stress);
        let (density, pressure, sound_speed) = (core.density.value, core.pressure, core.sound_speed);
        Ok(Some(Self { solids, dust, stress, density, energy, pressure, sound_speed, pores, damage }))
    }

    fn name(&self) -> &'static str {
        "strength"
    }

    fn soften(&mut self, late: &Late) {
        let solids = self.solids.iter_mut().flat_map(PerBody::iter_mut);
        solids.for_each(|(body, solid)| solid.shear_modulus = late.0[body].after().shear);
    }

    fn carry_over(&self, local: &Local, late: &Late) {
        let stress = local.view(self.stress.value);
        for (body, range) in
            local.runs().filter(|(body, _)| self.solids.as_ref().is_some_and(|solids| solids.of(*body).is_some()))
        {
            range.for_each(|i| stress.set(i, stress.get(i).scaled(late.0[body].ratio())));
        }
    }

    fn rates(&self, local: &Local) {
        let (stress, rate) = (local.view(self.stress.value), local.rate(self.stress));
        if let Some(dust) = &self.dust {
            dust.rates(local);
        }
        for (solid, range) in self.runs(local) {
            if let Some(pores) = self.pores.filter(|_| solid.porous) {
                self.porous_rates(local, solid, range, &pores);
                continue;
            }
            for i in range {
                let gradient = &local.flow[i].velocity_gradient;
                let elastic = Deviator::of(&Sym::symmetric_part(gradient), 2.0 * solid.shear_modulus);
                rate.set(i, elastic.plus(&stress.get(i).turned_by(gradient)));
            }
        }
    }

    fn admit(&self, local: &Local) {
        let (stress, energy) = (local.view(self.stress.value), local.optional(self.energy));
        if let Some(dust) = &self.dust {
            dust.admit(local);
        }
        for (solid, range) in self.runs(local).filter(|(solid, _)| !solid.friction) {
            for i in range {
                if let Some(within) = returned(&stress.get(i), 3.0, solid.yields.strength(energy.get(i))) {
                    stress.set(i, within);
                }
            }
        }
    }

    fn update(&self, local: &Local) {
        let (density, sound_speed) = (local.view(self.density), local.view(self.sound_speed));
        if let Some(dust) = &self.dust {
            dust.update(local);
        }
        for (solid, range) in self.runs(local) {
            if solid.friction {
                self.return_to_yield(local, solid, range.clone());
            }
            let stiffness = 4.0 / 3.0 * solid.shear_modulus;
            if let Some(pores) = self.pores.filter(|_| solid.porous) {
                let (distention, factor) = (local.view(pores.distention), local.view(pores.stress_factor));
                let loading_speed = pores.loading_speed.map(|column| local.view(column));
                for i in range {
                    let matrix_density = distention.get(i) * density.get(i);
                    let shear = stiffness / matrix_density.max(solid.lowest_density);
                    let c = sound_speed.get(i);
                    sound_speed.set(i, (c * c + shear).sqrt());
                    if let Some(loading_speed) = &loading_speed {
                        let (c, share) = (loading_speed.get(i), factor.get(i).clamp(0.0, 1.0));
                        loading_speed.set(i, (c * c + shear * share).sqrt());
                    }
                }
                continue;
            }
            for i in range {
                let c = sound_speed.get(i);
                sound_speed.set(i, (c * c + stiffness / density.get(i).max(solid.lowest_density)).sqrt());
            }
        }
    }
}

impl Strength {
    /// The particles of solids, in stretches with the same parameters.
    fn runs<'a>(&'a self, local: &'a Local) -> impl Iterator<Item = (&'a Solid, std::ops::Range<usize>)> {
        self.solids.iter().flat_map(|solids| solids.runs(local))
    }

    /// Returns the stress to the yield surface at the present pressure.
    fn return_to_yield(&self, local: &Local, solid: &Solid, range: std::ops::Range<usize>) {
        let (stress, energy) = (local.view(self.stress.value), local.optional(self.energy));
        let pressure = local.view(self.pressure);
        let damage = self.damage.filter(|_| solid.can_break).map(|column| local.view(column));
        for i in range {
            let d = damage.as_ref().map_or(solid.damage, |damage| damage.get(i));
            let bearable = solid.yields.strength_under(pressure.get(i), d, energy.get(i));
            if let Some(within) = returned(&stress.get(i), 1.0, bearable) {
                stress.set(i, within);
            }
        }
    }

    /// Rates of porous matter.
    fn porous_rates(&self, local: &Local, solid: &Solid, range: std::ops::Range<usize>, pores: &PoreColumns) {
        let (stress, rate) = (local.view(self.stress.value), local.rate(self.stress));
        let (distention, stress_factor) = (local.view(pores.distention), local.view(pores.stress_factor));
        for i in range {
            let gradient = &local.flow[i].velocity_gradient;
            let (divergence, factor) = (gradient.trace(), stress_factor.get(i));
            // Collapsed pores do not reopen: in expansion the matrix takes all of the strain.
            let share = if divergence < 0.0 { factor.clamp(0.0, 1.0) } else { 1.0 };
            let modulus = 2.0 * solid.shear_modulus * share / distention.get(i);
            let s = stress.get(i);
            let elastic = Deviator::of(&Sym::symmetric_part(gradient), modulus);
            let concentrated = s.scaled(-distention_rate(factor, divergence));
            rate.set(i, elastic.plus(&s.turned_by(gradient)).plus(&concentrated));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::{Rig, basalt, without_fracture};
    use super::*;
    use crate::math::Mat3;
    use crate::units::Pressure;

    fn stress_column(rig: &Rig) -> Column<Deviator> {
        rig.column(DEVIATORIC_STRESS)
    }

    /// Uniaxial strain at a constant rate: S_xx = 4/3 mu e until 3/2 |S_xx| = Y, from there S_xx = -2/3 Y.
    #[test]
    fn uniaxial_strain_is_elastic_then_plastic() {
        let mut rig = Rig::new(without_fracture(basalt()));
        let gradient = Mat3::from_diagonal(&crate::math::Vec3::new(-1.0, 0.0, 0.0));
        // The rate of the first step is zero: the gradient is seen once before.
        rig.step(&gradient, 0.0);
        let (mu, bearable) = (22.7e9, 3.5e9);
        let dt = 1e-4;
        for step in 1..=2000 {
            rig.step(&gradient, dt);
            let s = rig.get(stress_column(&rig));
            // Heating by compression softens: Y = Y_0 (1 - u / u_melt).
            let u: f64 = rig.get(rig.column(eos::INTERNAL_ENERGY));
            let elastic = -4.0 / 3.0 * mu * dt * step as f64;
            let expected = elastic.max(-2.0 / 3.0 * bearable * (1.0 - u / 3.4e6));
            assert!(
                (s.xx / expected - 1.0).abs() < 1e-10 && (s.yy / s.xx + 0.5).abs() < 1e-12,
                "{step} {s:?} {expected}"
            );
        }
    }

    #[test]
    fn melt_bears_nothing() {
        let yields = Yield::new(&basalt().strength.unwrap());
        let stress = Deviator { xy: 1e6, ..Default::default() };
        assert_eq!(yields.strength(1.7e6), 1.75e9);
        assert_eq!(yields.strength(-1.0), 3.5e9);
        assert_eq!(returned(&stress, 3.0, yields.strength(5e6)), Some(Deviator::default()));
    }

    /// A rigid rotation by 45 degrees turns diag(1, -1, 0) into S_xy = 1 and keeps J2. The scheme rotates by z = 2 dtheta
    /// per step with a phase error of order z^3, so that the sum stays below z^2 times the angle of rotation in the stress's
    /// plane.
    #[test]
    fn rotation_turns_stress_and_keeps_j2() {
        let mut rig = Rig::new(without_fracture(basalt()));
        rig.set(stress_column(&rig), Deviator { xx: 1e6, yy: -1e6, ..Default::default() });
        let gradient = Mat3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0);
        let steps = 1000;
        let dt = std::f64::consts::FRAC_PI_4 / steps as f64;
        rig.step(&gradient, 0.0);
        for _ in 0..steps {
            rig.step(&gradient, dt);
        }
        let s = rig.get(stress_column(&rig));
        let bound = 1e6 * (2.0 * dt) * (2.0 * dt) * std::f64::consts::FRAC_PI_2;
        assert!((s.xy - 1e6).abs() < bound && s.xx.abs() < bound, "{s:?}");
        assert!((s.j2() / 1e12 - 1.0).abs() < 2e-6 * bound, "{}", s.j2());
        assert_eq!(rig.get(rig.core.density.value), 2700.0);
    }

    /// Basalt with the library's friction and constant damage.
    fn rock(melting: bool) -> MaterialTable {
        let mut rock = without_fracture(basalt());
        let strength = rock.strength.as_mut().unwrap();
        let number = crate::units::Number::new;
        strength.collins = Some(CollinsTable {
            cohesion: Pressure::new(90e6),
            internal_friction: number(2.0),
            friction: number(0.8),
            damaged_cohesion: Pressure::new(0.0),
        });
        strength.melting = strength.melting.filter(|_| melting);
        rock
    }

    /// One element, compressed to a pressure and then sheared far beyond yield: sqrt(J2) is Y(P, D), whatever the damage.
    #[test]
    fn sheared_rock_bears_what_pressure_and_damage_allow() {
        for damage in [0.0, 0.25, 0.7, 1.0] {
            for (strain, steps) in [(-1e-4, 10), (-1e-2, 10), (3e-3, 10)] {
                let mut rig = Rig::with_records(vec![rock(false)], Default::default(), damage);
                let compression = Mat3::from_diagonal_element(strain / 3.0 / steps as f64);
                let shear = Mat3::new(0.0, 1e-3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
                rig.step(&compression, 0.0);
                for _ in 0..steps {
                    rig.step(&compression, 1.0);
                }
                rig.step(&shear, 0.0);
                for _ in 0..60 {
                    rig.step(&shear, 1.0);
                }
                let p: f64 = rig.get(rig.core.pressure);
                assert_eq!(p > 0.0, strain < 0.0);
                let rise = 2.0 * p.max(0.0);
                let intact = 9e7 + rise / (1.0 + rise / 3.41e9);
                let broken = (0.8 * p).clamp(0.0, intact);
                let expected = (1.0 - damage) * intact + damage * broken;
                let found = rig.get(stress_column(&rig)).j2().sqrt();
                // The corrector rotates the returned stress by the spin of half a step.
                assert!((found - expected).abs() <= 1e-6 * expected, "D {damage}, P {p}: {found} {expected}");
            }
        }
    }

    /// Friction heats: the work of shear heats the matter, which melts in the end and bears nothing.
    #[test]
    fn rubbing_heats_and_melts() {
        let mut rig = Rig::with_records(vec![rock(true)], Default::default(), 1.0);
        let compression = Mat3::from_diagonal_element(-1e-3);
        let shear = Mat3::new(0.0, 1e-2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
        rig.step(&compression, 0.0);
        for _ in 0..10 {
            rig.step(&compression, 1.0);
        }
        rig.step(&shear, 0.0);
        for _ in 0..100 {
            rig.step(&shear, 0.1);
        }
        let u = |rig: &Rig| rig.get(rig.column::<f64>(eos::INTERNAL_ENERGY));
        let before = u(&rig);
        let stress = rig.get(stress_column(&rig));
        for _ in 0..10 {
            rig.step(&shear, 1e-2);
        }
        let power = stress.xy * 1e-2 / rig.get(rig.core.density.value);
        let gained = u(&rig) - before;
        assert!((gained / (0.1 * power) - 1.0).abs() < 0.01, "{gained} J/kg, power {power} W/kg");
        for _ in 0..100_000 {
            rig.step(&shear, 1.0);
        }
        assert!(u(&rig) < 3.6e6 && rig.get(stress_column(&rig)).j2().sqrt() < 1e6, "{}", u(&rig));
    }

    /// c_L = sqrt((K + 4/3 mu) / rho): 4593 m/s in basalt, so that cracks grow at c_g = 0.4 c_L = 1837 m/s (Benz & Asphaug 1995).
    #[test]
    fn sound_is_longitudinal() {
        let mut rig = Rig::new(without_fracture(basalt()));
        rig.step(&Mat3::zeros(), 0.0);
        assert!((0.4 * rig.get(rig.core.sound_speed) - 1837.0).abs() < 0.5);
    }
}
