//! Fracture by the growth of flaws (Grady & Kipp 1980, as Benz & Asphaug 1995; Jutzi et al. 2008, eqs 34-39).
//!
//! ```text
//! eps = sigma_1 / ((1 - D) E_Y)                  local strain;  E_Y = 9 K mu / (3 K + mu)
//! d D^(1/3) / dt = n_act^(1/3) c_g / R_s         while eps > eps_1, up to D = n_act / n_tot
//! c_g = 0.4 c_L    c_L^2 = (K + 4/3 mu) / rho_0    R_s = 2h
//! ```
//! D damage, the share of a particle's volume that its cracks have relieved of stress; sigma_1 largest principal value
//! of the damaged stress, K, mu, E_Y bulk, shear and Young's modulus, Pa; eps_1 threshold of the particle's weakest
//! flaw, n_act and n_tot its active flaws and all its flaws; c_g speed of a crack, m/s; R_s radius of the particle's
//! kernel at the start, m.
//!
//! In porous bodies the strain is that of the matrix: of alpha sigma, as both moduli of the body are those of the matrix over
//! alpha. Compaction adds its own growth of D^(1/3) (Jutzi et al. 2008, eq. 59; see `porosity`), up to D = 1.
//!
//! For the number of a particle's flaws, and the strains at which they open, see `flaws`.
//!
//! Damage weakens the acting stress (see `damage`) and is never written back into it; it acts on shear of matter with friction
//! through the yield strength alone (see `strength`).
//! Columns: owns `damage` and `activation_threshold`. D grows in `commit` alone and never decreases.
//! Time step: none; at a Courant number of 0.25 and with 12 active flaws D^(1/3) grows by 0.11 per step.

pub mod flaws;
mod table;

use super::damage::damage_column;
use super::{Core, Diagnostic, Local, MaterialEffect, MaterialTable, PerBody, Setup, porosity, strength};
use crate::error::Result;
use crate::math::Deviator;
use crate::particles::{Column, ColumnInfo, Columns, Life, ParticleId, Registry};
use flaws::{FlawCount, Flaws};
pub use table::{FractureModel, FractureTable};

/// Crack speed over the longitudinal speed of sound.
const CRACK_SPEED: f64 = 0.4;

#[derive(Debug, Clone, Copy)]
struct Brittle {
    flaws: Flaws,
    /// E_Y, Pa.
    youngs_modulus: f64,
    /// c_g / R_s, 1/s.
    growth: f64,
    initial_damage: f64,
    porous: bool,
    friction: bool,
}

impl Brittle {
    fn new(setup: &Setup, body: usize, material: &MaterialTable) -> Option<Self> {
        let (fracture, strength) = (material.fracture.as_ref()?, material.strength.as_ref()?);
        let law = material.eos.law();
        let (bulk, density, shear) = (law.bulk_modulus()?, law.reference_density()?, strength.shear_modulus.0);
        let constants = &setup.constants[body];
        // In 2D a particle represents a cube: its flaws must not depend on the metre of depth that its mass refers to.
        let volume = libm::pow(constants.particle_mass / constants.density, 3.0 / setup.dimension as f64);
        let sound = ((bulk + 4.0 / 3.0 * shear) / density).sqrt();
        Some(Self {
            flaws: Flaws::new(fracture, volume, constants.particles),
            youngs_modulus: 9.0 * bulk * shear / (3.0 * bulk + shear),
            growth: CRACK_SPEED * sound / (2.0 * constants.smoothing_length),
            initial_damage: setup.initial_damage[body],
            porous: material.porosity.is_some(),
            friction: strength.has_friction(),
        })
    }

    /// Local strain of a particle with D < 1, or `None` where it cannot exceed `threshold`.
    #[inline]
    fn strain_above(&self, threshold: f64, stress: &Deviator, pressure: f64, intact: f64) -> Option<f64> {
        // sigma_1 / (1 - D): the view scales S always but P only in tension.
        let pressure = if pressure < 0.0 { pressure } else { pressure / intact };
        let bearable = threshold * self.youngs_modulus;
        // No principal value of S exceeds 2 sqrt(J2 / 3): most particles are done here.
        let reach = 2.0 * (stress.j2() / 3.0).sqrt();
        if reach - pressure <= bearable {
            return None;
        }
        let sigma = largest_principal(stress) - pressure;
        (sigma > bearable).then(|| sigma / self.youngs_modulus)
    }

    /// Damage after `dt` at a strain above the threshold.
    fn grown(&self, id: ParticleId, damage: f64, strain: f64, dt: f64) -> f64 {
        let FlawCount { active, all: total } = self.flaws.count(id, strain);
        let root = libm::cbrt(damage) + libm::cbrt(active as f64) * self.growth * dt;
        (root * root * root).min(active as f64 / total as f64).max(damage)
    }
}

/// Largest principal value of a traceless tensor: 2 sqrt(J2/3) cos(theta), cos(3 theta) = sqrt(27) J3 / (2 J2^(3/2)).
#[inline]
fn largest_principal(s: &Deviator) -> f64 {
    let zz = s.zz();
    let j3 = s.xx * (s.yy * zz - s.yz * s.yz) - s.xy * (s.xy * zz - s.yz * s.xz) + s.xz * (s.xy * s.yz - s.yy * s.xz);
    let radius = (s.j2() / 3.0).sqrt();
    let cube = radius * radius * radius;
    if cube == 0.0 {
        return 0.0;
    }
    let cosine = (0.5 * j3 / cube).clamp(-1.0, 1.0);
    2.0 * radius * libm::cos(libm::acos(cosine) / 3.0)
}

/// Damage of the bodies that can break.
pub struct Fracture {
    bodies: PerBody<Brittle>,
    id: Column<ParticleId>,
    damage: Column<f64>,
    threshold: Column<f64>,
    stress: Column<Deviator>,
    pressure: Column<f64>,
    /// Distention and growth of D^(1/3) by compaction, where a porous body can break.
    pores: Option<(Column<f64>, Column<f64>)>,
}

impl MaterialEffect for Fracture {
    fn declare(setup: &Setup, registry: &mut Registry, core: &Core) -> Result<Option<Self>> {
        let Some(bodies) = PerBody::new(setup, |body, material| Brittle::new(setup, body, material)) else {
            return Ok(None);
        };
        let stress = registry.need("fracture", strength::DEVIATORIC_STRESS)?;
        let pores = registry.find(porosity::DISTENTION).zip(registry.find(porosity::COMPACTION_DAMAGE));
        let damage = damage_column(registry);
        registry.owner("fracture");
        let threshold = registry.column(ColumnInfo {
            name: "activation_threshold",
            unit: "",
            about: "Strain at which the weakest flaw begins to grow.",
            life: Life::Kept,
            snapshot: false,
        });
        Ok(Some(Self { bodies, id: core.id, damage, threshold, stress, pressure: core.pressure, pores }))
    }

    fn name(&self) -> &'static str {
        "fracture"
    }

    fn initialise(&self, local: &Local) {
        let (id, damage, threshold) = (local.view(self.id), local.view(self.damage), local.view(self.threshold));
        for (brittle, range) in self.bodies.runs(local) {
            for i in range {
                // Joints have damage from the start.
                damage.set(i, damage.get(i).max(brittle.initial_damage));
                threshold.set(i, brittle.flaws.weakest(id.get(i)));
            }
        }
    }

    fn commit(&self, local: &Local) {
        let (id, damage, threshold) = (local.view(self.id), local.view(self.damage), local.view(self.threshold));
        let (stress, pressure) = (local.view(self.stress), local.view(self.pressure));
        for (brittle, range) in self.bodies.runs(local) {
            let pores = self.pores.filter(|_| brittle.porous);
            let pores = pores.map(|(distention, compaction)| (local.view(distention), local.view(compaction)));
            for i in range {
                let d = damage.get(i);
                let intact = 1.0 - d;
                if intact <= 0.0 {
                    continue;
                }
                let (mut s, mut p) = (stress.get(i), pressure.get(i));
                if let Some((distention, _)) = &pores {
                    let alpha = distention.get(i);
                    (s, p) = (s.scaled(alpha), alpha * p);
                }
                if brittle.friction {
                    s = s.scaled(1.0 / intact); // the yield strength accounts for damage
                }
                let strain = brittle.strain_above(threshold.get(i), &s, p, intact);
                if let Some(strain) = strain {
                    damage.set(i, brittle.grown(id.get(i), d, strain, local.dt));
                }
                let crushing = pores.as_ref().map_or(0.0, |(_, compaction)| compaction.get(i));
                if crushing > 0.0 {
                    let root = libm::cbrt(damage.get(i)) + crushing;
                    damage.set(i, (root * root * root).clamp(damage.get(i), 1.0));
                }
            }
        }
    }

    fn diagnostics(&self) -> Vec<Diagnostic> {
        vec![Diagnostic { name: "damaged_mass", unit: "kg" }]
    }

    fn diagnose(&self, columns: &Columns, i: usize, _body: usize, mass: f64, add: &mut dyn FnMut(usize, f64)) {
        add(0, mass * columns.get(self.damage, i));
    }
}

#[cfg(test)]
mod tests {
    use super::super::BodyConstants;
    use super::super::damage::{DAMAGE, damaged_stress};
    use super::super::testing::{Rig, basalt, gas, without_fracture};
    use super::*;
    use crate::math::Mat3;
    use crate::random::uniform_pair;

    /// The flaws of one of `particles` of 1 mm^3.
    fn flaws(particles: u64) -> Flaws {
        Flaws::new(&basalt().fracture.unwrap(), 1e-9, particles)
    }

    fn total(flaws: &Flaws, site: u64) -> u32 {
        flaws.count(ParticleId::new(0, site), 1.0).all
    }

    #[test]
    fn largest_principal_value_agrees_with_rotations() {
        for k in 0..200 {
            let at = |j: u64| uniform_pair(1, k, j)[0] - 0.5;
            let s = Deviator { xx: at(0), yy: at(1), xy: at(2), xz: at(3), yz: at(4) };
            let exact = s.with_mean(1.0, 0.0).largest_principal();
            // Where two values meet, acos loses half of the digits.
            assert!((largest_principal(&s) - exact).abs() < 1e-8, "{s:?}");
        }
        assert_eq!(largest_principal(&Deviator::default()), 0.0);
        assert_eq!(largest_principal(&Deviator { xx: 2.0, yy: -1.0, ..Default::default() }), 2.0);
    }

    fn brittle() -> Brittle {
        let flaws = flaws(1);
        Brittle { flaws, youngs_modulus: 5e10, growth: 2.0, initial_damage: 0.0, porous: false, friction: false }
    }

    /// One flaw: D = (c_g t / R_s)^3, up to 1 and no further.
    #[test]
    fn a_single_flaw_grows_at_the_speed_of_a_crack() {
        let brittle = brittle();
        let site = (0..).find(|&site| total(&brittle.flaws, site) == 1).unwrap();
        let id = ParticleId::new(0, site);
        let mut damage = 0.0;
        for step in 1..=60 {
            damage = brittle.grown(id, damage, 1.0, 0.01);
            let expected = (2.0 * 0.01 * f64::from(step)).min(1.0);
            assert!((libm::cbrt(damage) - expected).abs() < 1e-13, "{step} {damage}");
        }
        assert_eq!(damage, 1.0);
    }

    /// n flaws grow n^(1/3) times as fast, up to n_act / n_tot; damage above that stays.
    #[test]
    fn active_flaws_bound_damage() {
        let brittle = Brittle { flaws: flaws(10_000), ..brittle() };
        let id = ParticleId::new(0, 5);
        let strain = (1..)
            .map(|step| f64::from(step) * 1e-5)
            .find(|&strain| strain > brittle.flaws.weakest(id) && brittle.flaws.count(id, strain).active == 3)
            .unwrap();
        let bound = 3.0 / f64::from(brittle.flaws.count(id, strain).all);
        let first = brittle.grown(id, 0.0, strain, 1e-3);
        assert!((first / (3.0 * 2e-3f64.powi(3)) - 1.0).abs() < 1e-13);
        assert_eq!(brittle.grown(id, 0.0, strain, 1e3), bound);
        assert_eq!(brittle.grown(id, 0.99, strain, 1e3), 0.99);
    }

    /// The local strain is that of the damaged stress over 1 - D, whichever way it is computed.
    #[test]
    fn strain_is_that_of_the_undamaged_part() {
        let brittle = brittle();
        let s = Deviator { xx: 3e8, yy: -1e8, xy: 0.5e8, xz: 0.2e8, yz: -0.7e8 };
        for pressure in [-2e8, 1e8] {
            for damage in [0.0, 0.4, 0.5] {
                let sigma = damaged_stress(&s, pressure, damage, false).largest_principal();
                let strain = brittle.strain_above(0.0, &s, pressure, 1.0 - damage).unwrap();
                assert!((strain * (1.0 - damage) * brittle.youngs_modulus / sigma - 1.0).abs() < 1e-12);
                assert_eq!(brittle.strain_above(1.0001 * strain, &s, pressure, 1.0 - damage), None);
            }
        }
        assert_eq!(brittle.strain_above(0.0, &s, 1e9, 1.0), None);
    }

    /// Uniaxial stretching to 0.2 % and back, three times: damage only grows, and only while stretched.
    #[test]
    fn damage_never_decreases() {
        let mut rig = Rig::new(basalt());
        let damage = rig.column::<f64>(DAMAGE);
        let mut gradient = Mat3::zeros();
        let (mut last, mut rises) = (0.0, 0);
        for step in 0..600 {
            gradient[(0, 0)] = if step / 100 % 2 == 0 { 0.2 } else { -0.2 };
            rig.step(&gradient, 1e-4);
            let now = rig.get(damage);
            assert!((last..=1.0).contains(&now));
            rises += u32::from(now > last);
            last = now;
        }
        assert!(rises > 10 && last > 0.0, "{rises} {last}");
    }

    /// One spacing gives the same flaws in 2D, where the mass is that of a metre of depth, as in 3D.
    #[test]
    fn flaws_do_not_depend_on_the_metre_of_depth() {
        let spacing: f64 = 0.02;
        let weakest = |dimension: i32| {
            let particle_mass = 2700.0 * spacing.powi(dimension);
            let constants = BodyConstants {
                particle_mass,
                smoothing_length: 0.024,
                particles: 1000,
                density: 2700.0,
                distention: 1.0,
            };
            let setup = Setup {
                dimension: dimension as usize,
                materials: &[basalt()],
                body_material: &[0],
                constants: &[constants],
                initial_damage: &[0.0],
                records: Default::default(),
                smoothing_length: None,
            };
            Brittle::new(&setup, 0, &basalt()).unwrap().flaws.weakest(ParticleId::new(0, 1))
        };
        assert!((weakest(2) / weakest(3) - 1.0).abs() < 1e-13);
    }

    #[test]
    fn damage_starts_as_the_scene_says() {
        let rig = Rig::with_records(vec![basalt(), gas()], Default::default(), 0.25);
        assert_eq!(rig.get_of(0, rig.column::<f64>(DAMAGE)), 0.25);
        assert!(rig.get_of(0, rig.column::<f64>("activation_threshold")) > 0.0);
        assert_eq!(rig.get_of(1, rig.column::<f64>(DAMAGE)), 0.0, "a gas does not break");
    }

    #[test]
    fn fracture_needs_a_solid_with_strength() {
        assert!(basalt().validate("material.basalt").is_ok());
        let soft = MaterialTable { strength: None, ..basalt() };
        assert!(soft.validate("material.basalt").unwrap_err().what.contains("needs strength"));
        let thin = MaterialTable { eos: gas().eos, ..basalt() };
        assert!(thin.validate("material.basalt").unwrap_err().what.contains("gas"));
    }

    #[test]
    fn a_scene_without_fracture_has_no_column_of_it() {
        let rig = Rig::new(without_fracture(basalt()));
        assert!(rig.columns.registry.find::<f64>(DAMAGE).is_none());
        let gas = Rig::new(gas());
        assert_eq!(gas.columns.registry.integrated.len(), 2, "density and energy");
    }

    /// Whether damage of this value grows under a tensile stress that is `share` of the one at which the weakest flaw opens, by
    /// shear or by pressure, in matter with this distention.
    fn grows(material: &MaterialTable, damage: f64, distention: f64, share: f64, by_shear: bool) -> bool {
        let mut rig = Rig::new(material.clone());
        let (bulk, shear) = (26.7e9, 22.7e9);
        let youngs_modulus = 9.0 * bulk * shear / (3.0 * bulk + shear);
        let pull = share * youngs_modulus * rig.get(rig.column::<f64>("activation_threshold"));
        rig.set(rig.column(DAMAGE), damage);
        if let Some(column) = rig.columns.registry.find::<f64>(porosity::DISTENTION) {
            rig.set(column, distention);
        }
        // The largest principal value of diag(2, -1, -1).
        let s = Deviator { xx: pull, yy: -0.5 * pull, ..Default::default() };
        rig.set(rig.column(strength::DEVIATORIC_STRESS), if by_shear { s } else { Deviator::default() });
        rig.set(rig.core.pressure, if by_shear { 0.0 } else { -pull });
        rig.each(1e-6, &[], |effect, local| {
            if effect.name() == "fracture" {
                effect.commit(local);
            }
        });
        rig.get(rig.column::<f64>(DAMAGE)) > damage
    }

    /// Flaws lie in the matrix, whose stress is alpha times that of the body.
    #[test]
    fn flaws_of_porous_matter_feel_the_stress_of_the_matrix() {
        let pores = "distention = 2\np_alpha = { quadratic = { P_e = 1e6, P_s = 2e8 } }";
        let porous = MaterialTable { porosity: Some(toml::from_str(pores).unwrap()), ..basalt() };
        for by_shear in [true, false] {
            for (share, distention, expected) in
                [(0.55, 2.0, true), (0.45, 2.0, false), (0.7, 1.5, true), (0.6, 1.5, false)]
            {
                let found = grows(&porous, 0.0, distention, share, by_shear);
                assert_eq!(found, expected, "{share} at {distention}, shear: {by_shear}");
            }
            assert!(grows(&basalt(), 0.0, 1.0, 1.05, by_shear) && !grows(&basalt(), 0.0, 1.0, 0.95, by_shear));
        }
    }

    /// With friction the deviator is the damaged one; the intact part of the matter bears all of it: S / (1 - D).
    #[test]
    fn flaws_feel_the_stress_of_what_is_left_whatever_the_law_of_yield() {
        let mut rock = basalt();
        let law = "cohesion = 9e7\ninternal_friction = 2\nfriction = 0.8\ndamaged_cohesion = 0";
        rock.strength.as_mut().unwrap().collins = Some(toml::from_str(law).unwrap());
        for (share, expected) in [(0.75, true), (0.65, false)] {
            assert_eq!(grows(&rock, 0.3, 1.0, share, true), expected, "{share}");
        }
        // Without friction S is that of undamaged matter.
        assert!(grows(&basalt(), 0.3, 1.0, 1.05, true) && !grows(&basalt(), 0.3, 1.0, 0.95, true));
    }
}
