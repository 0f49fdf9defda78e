//! Wave speeds and engineering constants of an isotropic solid; Graff 1975, chapters 2, 5 and 8; Love 1944, chapter V.
//!
//! ```text
//! c_b^2 = K / rho    c_L^2 = (K + 4/3 mu) / rho    c_S^2 = mu / rho    c_bar^2 = E / rho
//! E = 9 K mu / (3 K + mu)    nu = (3 K - 2 mu) / (6 K + 2 mu)
//! plane strain, as a solid of two dimensions:   E' = E / (1 - nu^2)    nu' = nu / (1 - nu)    K' = K + mu / 3
//! ```
//! K bulk, mu shear, E Young's modulus, Pa; nu Poisson's number; rho density, kg/m^3. c_L and c_S are the same in 2D as in
//! 3D; a thin strip in plane strain carries waves with sqrt(E' / rho), as a thin plate does.

use super::all_positive;
use crate::error::Result;
use crate::material::MaterialTable;

/// An isotropic elastic solid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elastic {
    /// Pa.
    pub bulk_modulus: f64,
    /// Pa.
    pub shear_modulus: f64,
    /// kg/m^3.
    pub density: f64,
}

impl Elastic {
    /// Fails unless all three are positive.
    pub fn new(bulk_modulus: f64, shear_modulus: f64, density: f64) -> Result<Self> {
        all_positive(&[
            ("the bulk modulus", bulk_modulus),
            ("the shear modulus", shear_modulus),
            ("the density", density),
        ])?;
        Ok(Self { bulk_modulus, shear_modulus, density })
    }

    /// The material of a scene at its reference density; `None` without strength or for a gas.
    pub fn of(material: &MaterialTable) -> Option<Self> {
        Some(Self {
            bulk_modulus: material.eos.law().bulk_modulus()?,
            shear_modulus: material.strength.as_ref()?.shear_modulus.0,
            density: material.reference_density()?,
        })
    }

    fn speed(&self, modulus: f64) -> f64 {
        (modulus / self.density).sqrt()
    }

    /// Speed of sound in a fluid of the same bulk modulus, m/s.
    pub fn bulk_speed(&self) -> f64 {
        self.speed(self.bulk_modulus)
    }

    /// Speed of a longitudinal wave in matter without lateral strain, m/s.
    pub fn longitudinal_speed(&self) -> f64 {
        self.speed(self.bulk_modulus + 4.0 / 3.0 * self.shear_modulus)
    }

    /// Speed of a shear wave, m/s.
    pub fn shear_speed(&self) -> f64 {
        self.speed(self.shear_modulus)
    }

    /// Speed of a longitudinal wave in a thin bar of `dimension` 3, or in a thin strip in plane strain (2), m/s.
    pub fn bar_speed(&self, dimension: usize) -> f64 {
        self.speed(self.youngs_modulus(dimension))
    }

    /// Speed of a longitudinal wave along a thin plate, m/s.
    pub fn plate_speed(&self) -> f64 {
        self.bar_speed(2)
    }

    /// E, or E' in plane strain (`dimension` 2), Pa.
    pub fn youngs_modulus(&self, dimension: usize) -> f64 {
        let (k, mu) = (self.bulk_modulus, self.shear_modulus);
        match dimension {
            2 => 4.0 * mu * (3.0 * k + mu) / (3.0 * k + 4.0 * mu),
            _ => 9.0 * k * mu / (3.0 * k + mu),
        }
    }

    /// nu, or nu' in plane strain (`dimension` 2).
    pub fn poisson_number(&self, dimension: usize) -> f64 {
        let (k, mu) = (self.bulk_modulus, self.shear_modulus);
        match dimension {
            2 => (3.0 * k - 2.0 * mu) / (3.0 * k + 4.0 * mu),
            _ => (3.0 * k - 2.0 * mu) / (6.0 * k + 2.0 * mu),
        }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    pub fn basalt() -> Elastic {
        Elastic::new(26.7e9, 22.7e9, 2700.0).unwrap()
    }

    /// The solid of the colliding rings, in units of its own (Gray, Monaghan & Swift 2001).
    pub fn rubber() -> Elastic {
        Elastic::new(1.0, 0.22, 1.0).unwrap()
    }

    /// Evaluated by hand, to the digits given.
    #[test]
    fn tabulated_speeds() {
        let table = [
            (basalt(), [3144.7, 4593.3, 2899.6, 4433.1, 4497.7, 53.06e9, 0.1688]),
            (Elastic::new(9.47e9, 2.8e9, 917.0).unwrap(), [3213.6, 3794.5, 1747.4, 2887.6, 3102.2, 7.646e9, 0.3654]),
            (Elastic::new(75.2e9, 26.5e9, 2700.0).unwrap(), [5277.5, 6398.3, 3132.9, 5133.2, 5463.2, 71.14e9, 0.3423]),
            (rubber(), [1.0, 1.1372, 0.4690, 0.7842, 0.8546, 0.6149, 0.3975]),
        ];
        for (solid, expected) in table {
            let found = [
                solid.bulk_speed(),
                solid.longitudinal_speed(),
                solid.shear_speed(),
                solid.bar_speed(3),
                solid.plate_speed(),
                solid.youngs_modulus(3),
                solid.poisson_number(3),
            ];
            for (a, b) in found.iter().zip(expected) {
                // Four digits.
                assert!((a / b - 1.0).abs() < 2e-4, "{solid:?}: {a} {b}");
            }
        }
    }

    /// Hooke's law in two dimensions: a strip pulled along x, free along y, strained nowhere along z.
    #[test]
    fn plane_strain_is_a_solid_of_two_dimensions() {
        for solid in [basalt(), rubber(), Elastic::new(3.0, 7.0, 1.0).unwrap()] {
            let lambda = solid.bulk_modulus - 2.0 / 3.0 * solid.shear_modulus;
            let (e_x, e_y) = (1.0, -solid.poisson_number(2));
            let stress = |along: f64| lambda * (e_x + e_y) + 2.0 * solid.shear_modulus * along;
            let scale = solid.youngs_modulus(2);
            assert!(stress(e_y).abs() < 1e-14 * scale && (stress(e_x) / scale - 1.0).abs() < 1e-14);
            let (e, nu) = (solid.youngs_modulus(3), solid.poisson_number(3));
            assert!((e / (1.0 - nu * nu) / scale - 1.0).abs() < 1e-14);
        }
        assert!(Elastic::new(1.0, 0.0, 1.0).is_err());
    }
}
