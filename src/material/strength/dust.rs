//! Shear of highly porous dust (Geretshauser et al. 2010, eqs. 9, 10 and 18, corrected):
//!
//! ```text
//! dS/dt = K(rho') (e - tr(e)/3) + Omega S - S Omega      as 2 mu = K
//! S -> S min(1, Y(phi) / sqrt(3 J2))                     J2 = S:S / 2
//! as printed: tr(e)/d in d dimensions, and S -> S min(1, Y^2 / (3 S:S)): Y / sqrt(2) in the place of Y, and cut back too far
//! ```
//! S deviatoric stress, K bulk modulus, mu shear modulus, Y shear strength, Pa; rho' reference density, kg/m^3; phi filling factor.

use super::super::dust::REFERENCE_DENSITY;
use super::super::eos::sirono::Sirono;
use super::super::{Core, Local, PerBody, Setup};
use super::yield_law::{LARGEST_VOLUME, returned};
use crate::math::{Deviator, Sym};
use crate::particles::{Column, Integrated, Registry};

/// Shear of the bodies of dust.
pub struct DustShear {
    bodies: PerBody<Body>,
    reference: Column<f64>,
    density: Column<f64>,
    sound_speed: Column<f64>,
    stress: Integrated<Deviator>,
    /// Dimension of the scene.
    dimension: usize,
}

struct Body {
    law: Sirono,
    /// Density below which shear waves get no faster, kg/m^3.
    lowest_density: f64,
}

impl DustShear {
    pub fn new(setup: &Setup, registry: &Registry, core: &Core, stress: Integrated<Deviator>) -> Option<Self> {
        let bodies = PerBody::new(setup, |body, material| {
            Some(Body { law: material.dust()?, lowest_density: setup.constants[body].density / LARGEST_VOLUME })
        })?;
        let (density, sound_speed) = (core.density.value, core.sound_speed);
        let reference = registry.find(REFERENCE_DENSITY)?;
        Some(Self { bodies, reference, density, sound_speed, stress, dimension: setup.dimension })
    }

    pub fn rates(&self, local: &Local) {
        let (stress, rate) = (local.view(self.stress.value), local.rate(self.stress));
        let reference = local.view(self.reference);
        for (Body { law, .. }, range) in self.bodies.runs(local) {
            for i in range {
                let gradient = &local.flow[i].velocity_gradient;
                let strain = Sym::symmetric_part(gradient);
                let modulus = law.bulk_modulus(reference.get(i));
                let elastic = match (law.shear_as_printed, self.dimension) {
                    (true, 2) => in_plane(&strain, modulus),
                    _ => Deviator::of(&strain, modulus),
                };
                rate.set(i, elastic.plus(&stress.get(i).turned_by(gradient)));
            }
        }
    }

    pub fn admit(&self, local: &Local) {
        let (stress, density) = (local.view(self.stress.value), local.view(self.density));
        for (Body { law, .. }, range) in self.bodies.runs(local) {
            for i in range {
                let bearable = law.shear_strength(law.filling_factor(density.get(i)));
                let s = stress.get(i);
                let within =
                    if law.shear_as_printed { returned_as_printed(&s, bearable) } else { returned(&s, 3.0, bearable) };
                if let Some(within) = within {
                    stress.set(i, within);
                }
            }
        }
    }

    pub fn update(&self, local: &Local) {
        let (reference, density) = (local.view(self.reference), local.view(self.density));
        let sound_speed = local.view(self.sound_speed);
        for (Body { law, lowest_density }, range) in self.bodies.runs(local) {
            for i in range {
                let (c, modulus) = (sound_speed.get(i), 0.5 * law.bulk_modulus(reference.get(i)));
                let shear = 4.0 / 3.0 * modulus / density.get(i).max(*lowest_density);
                sound_speed.set(i, (c * c + shear).sqrt());
            }
        }
    }
}

/// The deviator with half of the trace, which has no part along z.
fn in_plane(strain: &Sym, modulus: f64) -> Deviator {
    let half = 0.5 * modulus * (strain.xx - strain.yy);
    Deviator { xx: half, yy: -half, xy: modulus * strain.xy, ..Deviator::default() }
}

/// The printed return, S min(1, Y^2 / (3 S:S)).
fn returned_as_printed(stress: &Deviator, bearable: f64) -> Option<Deviator> {
    let square = 6.0 * stress.j2();
    (square > bearable * bearable).then(|| stress.scaled(bearable * bearable / square))
}

#[cfg(test)]
mod tests {
    use super::super::super::dust;
    use super::super::super::testing::{Rig, silica};
    use super::super::DEVIATORIC_STRESS;
    use super::*;
    use crate::math::Mat3;

    /// Simple shear: S_xy = mu times the shear until sqrt(3) S_xy = Y, 88.4 Pa at a filling factor of 0.15; as printed until
    /// sqrt(6) S_xy = Y, and an overshoot is cut back by as much below that.
    #[test]
    fn dust_shears_up_to_its_strength() {
        for printed in [false, true] {
            let mut rig = Rig::new(silica(if printed { "shear_as_printed = true" } else { "" }));
            let shear = Mat3::new(0.0, 1e-3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
            let stress = rig.column::<Deviator>(DEVIATORIC_STRESS);
            rig.step(&shear, 0.0);
            let (mut largest, mut least_after) = (0.0f64, f64::INFINITY);
            for step in 1..=100 {
                rig.step(&shear, 1.0);
                let s = rig.get(stress).xy;
                if step <= 10 {
                    assert!((s / (2250.0 * 1e-3 * step as f64) - 1.0).abs() < 1e-3, "{step} {s}");
                }
                largest = largest.max(s);
                least_after = if step > 40 { least_after.min(s) } else { least_after };
            }
            let bearable = 88.386;
            if printed {
                let limit = bearable / 6f64.sqrt();
                assert!(largest <= limit && largest > 0.95 * limit, "{largest} {limit}");
                assert!((0.9..0.97).contains(&(least_after / limit)), "{least_after} {limit}");
            } else {
                let limit = bearable / 3f64.sqrt();
                assert!((largest / limit - 1.0).abs() < 1e-3 && (least_after / limit - 1.0).abs() < 1e-3, "{largest}");
            }
        }
    }

    /// c_L^2 = (K + 4/3 mu) / rho = 5/3 K / rho without load.
    #[test]
    fn sound_is_longitudinal() {
        let mut rig = Rig::new(silica(""));
        rig.step(&Mat3::zeros(), 0.0);
        assert!((rig.get(rig.core.sound_speed) / 25f64.sqrt() - 1.0).abs() < 1e-12);
        assert_eq!(rig.get(rig.column::<f64>(dust::REFERENCE_DENSITY)), 300.0);
    }

    /// Plane strain of the corrected law carries an out-of-plane stress, the printed one does not.
    #[test]
    fn printed_shear_has_no_part_out_of_the_plane() {
        let strain = Sym { xx: -2e-3, yy: 1e-3, xy: 5e-4, ..Sym::ZERO };
        let printed = in_plane(&strain, 4500.0);
        assert_eq!(printed.zz(), 0.0);
        assert!((printed.xx + 6.75).abs() < 1e-12 && (printed.xy - 2.25).abs() < 1e-12);
        assert!((Deviator::of(&strain, 4500.0).zz() - 1.5).abs() < 1e-12);
    }
}
