//! The late stage of a run: once the shock has left, matter may be softer by far, so that steps grow with the time that sound
//! takes (after Raducan & Jutzi 2022, PSJ 3, 128: the simplest law of pressure, without heat, with both moduli lowered alike).
//!
//! ```text
//! P = A' (alpha rho / rho_0 - 1) / alpha        instead of the equation of state; heat adds no pressure
//! mu' = mu A' / A,   S' = S A' / A              at the same elastic strain, so that stress falls as pressure does
//! alpha                                         stays as it is, pores under load included
//! u' = u + e' - e,   e = [ w_P P_s^2 / (2 A) + w_S S_s:S_s / (4 mu) ] / rho_s
//! ```
//! P pressure, S deviatoric stress of the body, P_s = alpha P and S_s = alpha S those of its matrix, A bulk modulus of the matrix
//! at rest, mu shear modulus, Pa; rho density, rho_s = alpha rho, kg/m^3; alpha distention; u internal energy, e the part of it
//! that is stored elastically, J/kg, to second order in the strain, with A in place of rho_s c^2; a prime marks values after the
//! switch. w_P is 1 - D in tension, else 1; w_S 1 - D without friction, else 1; D damage.
//!
//! Limits that are stresses stay as they are: yield strength, cohesion, friction, and the stress at which a flaw opens (its strain
//! times Young's modulus of the stiff matter). Tension still fades below 0.95 rho_0, so that the tension of soft matter is 0.056 A'
//! at most. Vapour has no pressure left once its density is below rho_0; viscosity uses the new speed of sound.

use super::MaterialTable;
use super::eos::Eos;
use super::eos::simplified_tillotson::{SimplifiedTillotson, SimplifiedTillotsonTable};
use crate::math::Deviator;
use crate::units::{Density, Number, Pressure};

/// Elastic moduli of a matrix.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stiffness {
    /// A, Pa.
    pub bulk: f64,
    /// mu, Pa; zero without strength.
    pub shear: f64,
}

/// The stress in a particle and what it depends on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
    /// kg/m^3.
    pub density: f64,
    pub distention: f64,
    /// Pa.
    pub pressure: f64,
    /// Pa.
    pub stress: Deviator,
    pub damage: f64,
    /// Whether damage acts on shear through the yield strength alone.
    pub friction: bool,
}

impl Stiffness {
    /// e, J/kg.
    pub fn elastic_energy(&self, load: &Load) -> f64 {
        let intact = 1.0 - load.damage;
        let (w_p, w_s) = (if load.pressure < 0.0 { intact } else { 1.0 }, if load.friction { 1.0 } else { intact });
        let (p, s) = (load.distention * load.pressure, load.distention * load.distention * 2.0 * load.stress.j2());
        let shear = if self.shear > 0.0 { w_s * s / (4.0 * self.shear) } else { 0.0 };
        (w_p * p * p / (2.0 * self.bulk) + shear) / (load.distention * load.density)
    }
}

/// The matter of one body before and after the switch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Softening {
    /// Density of the matrix without load, kg/m^3.
    rho_0: f64,
    before: Stiffness,
    /// A' / A.
    ratio: f64,
}

impl Softening {
    /// The switch to the bulk modulus `to`, Pa; `None` for a gas, which has no modulus.
    pub fn new(material: &MaterialTable, to: f64) -> Option<Self> {
        let law = material.eos.law();
        let (rho_0, bulk) = (law.reference_density()?, law.bulk_modulus()?);
        let shear = material.strength.as_ref().map_or(0.0, |strength| strength.shear_modulus.0);
        Some(Self { rho_0, before: Stiffness { bulk, shear }, ratio: to / bulk })
    }

    /// A' / A.
    pub fn ratio(&self) -> f64 {
        self.ratio
    }

    pub fn before(&self) -> Stiffness {
        self.before
    }

    pub fn after(&self) -> Stiffness {
        Stiffness { bulk: self.ratio * self.before.bulk, shear: self.ratio * self.before.shear }
    }

    /// A' / rho_0, square of the bulk speed of sound, m^2/s^2.
    pub fn sound2(&self) -> f64 {
        self.after().bulk / self.rho_0
    }

    /// Longitudinal speed of sound, m/s.
    pub fn longitudinal_sound(&self) -> f64 {
        let after = self.after();
        ((after.bulk + 4.0 / 3.0 * after.shear) / self.rho_0).sqrt()
    }

    /// P = A' (rho / rho_0 - 1) of the matrix.
    pub fn law(&self) -> Eos {
        Eos::SimplifiedTillotson(SimplifiedTillotson::new(&SimplifiedTillotsonTable {
            rho_0: Density::new(self.rho_0),
            c: Number::new(0.0),
            modulus: Pressure::new(self.after().bulk),
        }))
    }
}

/// The late stage of every body, by its number.
#[derive(Debug, Clone, PartialEq)]
pub struct Late(pub Vec<Softening>);

#[cfg(test)]
mod tests {
    use super::super::testing::{Rig, basalt};
    use super::*;
    use crate::material::{eos, porosity, strength};
    use crate::math::Mat3;

    fn softened(to: f64) -> (Late, f64) {
        let softening = Softening::new(&basalt(), to).unwrap();
        (Late(vec![softening]), softening.ratio())
    }

    fn go_over(rig: &mut Rig, late: &Late) {
        rig.effects.iter_mut().for_each(|effect| effect.soften(late));
        rig.each(0.0, &[], |effect, local| effect.carry_over(local, late));
        rig.each(0.0, &[], |effect, local| effect.update(local));
    }

    /// Pressure falls to A' mu, heat or not; the deviator and the speed of sound fall in the same ratio.
    #[test]
    fn soft_matter_bears_the_same_strain() {
        let mut rig = Rig::new(basalt());
        let (late, ratio) = softened(1e7);
        let gradient = Mat3::new(-1.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
        rig.step(&gradient, 0.0);
        (0..10).for_each(|_| {
            rig.step(&gradient, 1e-4);
        });
        let energy = rig.column(eos::INTERNAL_ENERGY);
        rig.set(energy, 1e4);
        let stress = rig.column::<Deviator>(strength::DEVIATORIC_STRESS);
        let before = rig.get(stress);
        go_over(&mut rig, &late);
        let mu = rig.get(rig.core.density.value) / 2700.0 - 1.0;
        assert!((rig.get(rig.core.pressure) / (1e7 * mu) - 1.0).abs() < 1e-12);
        assert_eq!(rig.get(stress), before.scaled(ratio));
        let sound = ((1e7 + 4.0 / 3.0 * ratio * 22.7e9 / (1.0 + mu)) / 2700.0).sqrt();
        assert!((rig.get(rig.core.sound_speed) / sound - 1.0).abs() < 1e-12);
        // And from there stress grows with the soft moduli.
        let turn_free = Mat3::from_diagonal(&crate::math::Vec3::new(-1.0, 0.5, 0.5));
        rig.step(&turn_free, 0.0);
        let start = rig.get(stress);
        rig.step(&turn_free, 1e-4);
        let grown = rig.get(stress).xx - start.xx;
        assert!((grown / (-2e-4 * ratio * 22.7e9) - 1.0).abs() < 1e-9, "{grown}");
    }

    /// Pores stay: neither load nor its end changes distention, and P = A' (alpha rho / rho_0 - 1) / alpha.
    #[test]
    fn pores_stay_as_they_are() {
        let text =
            "distention = 1.5\np_alpha = { quadratic = { P_e = 1e6, P_s = 2e8 }, elastic = { c_e = 2e3, c_0 = 3e3 } }";
        let mut material = basalt();
        material.porosity = Some(toml::from_str(text).unwrap());
        let mut rig = Rig::new(material);
        let alpha = rig.column::<f64>(porosity::DISTENTION);
        let compression = Mat3::from_diagonal_element(-1.0);
        rig.step(&compression, 0.0);
        (0..20).for_each(|_| {
            rig.step(&compression, 1e-3);
        });
        let (late, _) = softened(1e7);
        let kept = rig.get(alpha);
        assert!(kept > 1.0 && kept < 1.5, "{kept}");
        go_over(&mut rig, &late);
        for sign in [1.0, -1.0, 1.0, 1.0] {
            (0..20).for_each(|_| {
                rig.step(&Mat3::from_diagonal_element(sign), 1e-3);
            });
            // The corrector has advanced density.
            rig.each(0.0, &[], |effect, local| effect.update(local));
            assert_eq!(rig.get(alpha), kept);
            let matrix = kept * rig.get(rig.core.density.value) / 2700.0;
            let p = rig.get(rig.core.pressure);
            assert!(matrix < 0.95 || (p / (1e7 * (matrix - 1.0) / kept) - 1.0).abs() < 1e-9, "{p} {matrix}");
        }
    }

    /// One half of stress times strain: hydrostatic, in shear, and what damage leaves of it.
    #[test]
    fn elastic_energy_by_hand() {
        let stiff = Stiffness { bulk: 2e10, shear: 1e10 };
        let shear = Deviator { xy: 2e6, ..Deviator::default() };
        let load = Load { density: 2000.0, distention: 1.0, pressure: 3e6, stress: shear, damage: 0.4, friction: true };
        let (pressed, sheared) = (9e12 / 4e10 / 2000.0, 2.0 * 4e12 / 4e10 / 2000.0);
        let near = |load: &Load, expected: f64| {
            let found = stiff.elastic_energy(load);
            assert!((found / expected - 1.0).abs() < 1e-14, "{found} {expected}");
        };
        near(&load, pressed + sheared);
        near(&Load { pressure: -3e6, ..load }, 0.6 * pressed + sheared);
        near(&Load { friction: false, ..load }, pressed + 0.6 * sheared);
        // A matrix of twice the density fills half of the body: twice the stress in half the volume.
        near(&Load { distention: 2.0, ..load }, 2.0 * (pressed + sheared));
    }
}
