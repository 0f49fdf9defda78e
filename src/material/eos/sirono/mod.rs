//! Highly porous dust: the model of Sirono (2004, Icarus 167, 431) as modified by Geretshauser et al. (2010, A&A 513, A58).
//!
//! ```text
//! p = K(rho') (rho / rho' - 1)          eq. 8     within T(phi) <= p <= Sigma(phi)       eq. 19
//! K(rho) = 2 mu(rho) = K_0 (rho / rho_i)^gamma                                           eq. 9
//! c^2 = K(rho') / rho'                                                                   eq. 16
//! T = -T_0 10^(t phi)    Y = sqrt(Sigma |T|)                                             eq. 20, Sect. 2.3
//! ```
//! rho density, rho' reference density, at which matter is without load, rho_s density of the monomers, kg/m^3; phi = rho / rho_s
//! filling factor; p pressure, K bulk modulus, mu shear modulus, Sigma compressive, T tensile, Y shear strength, Pa (Sigma: see
//! `compression`). Pressure beyond a strength deforms for good: rho' becomes the one that has the strength for its pressure at the
//! present density.
//!
//! With x = rho' / rho the pressure is K(rho) (x^(gamma - 1) - x^gamma). It is largest, K(rho) (gamma - 1)^(gamma - 1) / gamma^gamma, at
//! x = (gamma - 1) / gamma: no rho' can give more, and matter that could bear more stays elastic (for the powder of the library above
//! phi = 0.5748). The exponent gamma is not printed in the paper; 4 is that of Sirono (2004).

pub mod compression;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::super::setup::{all_positive, none_negative};
use super::slopes::Slopes;
use crate::error::{Error, Result};
use crate::units::{Density, Number, Pressure};
use compression::{Compression, CompressionTable};

/// Highly porous dust, which yields to pressure, tension and shear as its filling factor says.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SironoTable {
    /// Density of the monomers.
    pub rho_s: Density,
    /// Density of dust that has the bulk modulus `K_0` without load.
    pub rho_i: Density,
    /// Bulk modulus at that density.
    #[serde(rename = "K_0")]
    pub modulus: Pressure,
    /// Power of the density by which the bulk modulus grows, above 1.
    pub gamma: Number,
    /// Compressive strength.
    pub compression: CompressionTable,
    /// Tensile strength; without it dust bears neither tension nor shear.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tension: Option<TensionTable>,
    /// When deformation becomes permanent.
    #[serde(default)]
    pub plasticity: Plasticity,
    /// Shear as the paper prints it, for comparison: a third of the volume strain becomes one over the dimension, and the yield
    /// criterion has Y / sqrt(2) in the place of Y and cuts back too far what exceeds it (eqs. 10 and 18).
    #[serde(default)]
    pub shear_as_printed: bool,
}

/// Beyond it the modulus changes by more than a factor of ten over a change of density by a tenth.
const MOST_GAMMA: f64 = 24.0;

/// Tensile strength, 10^(slope phi) T_0.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TensionTable {
    /// Strength of the thinnest matter.
    #[serde(rename = "T_0")]
    pub scale: Pressure,
    /// Decades per unit of the filling factor.
    pub slope: Number,
}

/// When deformation becomes permanent.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Plasticity {
    /// As soon as pressure reaches a strength.
    #[default]
    AtOnce,
    /// When the load falls again; until then modulus and speed of sound stay those of before.
    AfterUnloading,
}

impl SironoTable {
    pub(super) fn validate(&self, place: &str) -> Result<()> {
        all_positive(place, &[("rho_s", self.rho_s.0), ("rho_i", self.rho_i.0), ("K_0", self.modulus.0)])?;
        if self.rho_i.0 > self.rho_s.0 {
            let what = format!("rho_i is {}, and the monomers have {}", self.rho_i, self.rho_s);
            return Err(Error::new(what).at(format!("{place}.rho_i")).allowed("rho_s at most"));
        }
        if !(self.gamma.0 > 1.0 && self.gamma.0 <= MOST_GAMMA) {
            let error = Error::new(format!("gamma is {}", self.gamma)).at(format!("{place}.gamma"));
            return Err(error.allowed(format!("above 1, {MOST_GAMMA} at most")));
        }
        if let Some(TensionTable { scale, slope }) = &self.tension {
            none_negative(&format!("{place}.tension"), &[("T_0", scale.0), ("slope", slope.0)])?;
        }
        self.compression.validate(&format!("{place}.compression"))
    }
}

/// The law of one kind of dust.
#[derive(Debug, Clone, PartialEq)]
pub struct Sirono {
    rho_s: f64,
    rho_i: f64,
    modulus: f64,
    gamma: f64,
    compression: Compression,
    tension: f64,
    tension_slope: f64,
    pub plasticity: Plasticity,
    pub shear_as_printed: bool,
    /// Largest p / K(rho) of any reference density, and where it is, as rho' / rho.
    most: f64,
    at_most: f64,
}

/// Pressure of dust, and what it leaves behind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Loaded {
    /// Pa.
    pub pressure: f64,
    /// kg/m^3; as before where the load is elastic.
    pub reference: f64,
}

impl Sirono {
    pub fn new(table: &SironoTable) -> Self {
        let gamma = table.gamma.0;
        let at_most = (gamma - 1.0) / gamma;
        Self {
            rho_s: table.rho_s.0,
            rho_i: table.rho_i.0,
            modulus: table.modulus.0,
            gamma,
            compression: Compression::new(&table.compression),
            tension: table.tension.map_or(0.0, |tension| tension.scale.0),
            tension_slope: table.tension.map_or(0.0, |tension| tension.slope.0 * std::f64::consts::LN_10),
            plasticity: table.plasticity,
            shear_as_printed: table.shear_as_printed,
            most: libm::pow(at_most, gamma - 1.0) / gamma,
            at_most,
        }
    }

    /// Density of the monomers, kg/m^3.
    pub fn solid_density(&self) -> f64 {
        self.rho_s
    }

    /// rho_i, kg/m^3.
    pub fn reference_density(&self) -> f64 {
        self.rho_i
    }

    /// K of matter without load at a density, Pa.
    #[inline]
    pub fn bulk_modulus(&self, rho: f64) -> f64 {
        let eta = rho / self.rho_i;
        // The usual power needs no library.
        let power = if self.gamma == 4.0 { (eta * eta) * (eta * eta) } else { libm::pow(eta, self.gamma) };
        self.modulus * power
    }

    /// Pressure, Pa, zero, and speed of sound, m/s, of matter without load.
    pub fn unloaded(&self, rho: f64) -> (f64, f64) {
        (0.0, (self.bulk_modulus(rho) / rho).sqrt())
    }

    /// Pressure of matter without load, and its derivatives.
    pub fn slopes(&self, rho: f64) -> Slopes {
        Slopes { p: 0.0, by_rho: self.bulk_modulus(rho) / rho, by_u: 0.0 }
    }

    #[inline]
    pub fn filling_factor(&self, rho: f64) -> f64 {
        rho / self.rho_s
    }

    /// Sigma, Pa; infinite where matter is not compacted further.
    #[inline]
    pub fn compressive_strength(&self, phi: f64) -> f64 {
        self.compression.strength(phi)
    }

    /// T, Pa; negative.
    #[inline]
    pub fn tensile_strength(&self, phi: f64) -> f64 {
        -self.tension * libm::exp(self.tension_slope * phi)
    }

    /// Y, Pa.
    #[inline]
    pub fn shear_strength(&self, phi: f64) -> f64 {
        (self.compressive_strength(phi) * -self.tensile_strength(phi)).sqrt()
    }

    /// Pressure of elastic matter, Pa.
    #[inline]
    pub fn elastic_pressure(&self, rho: f64, reference: f64) -> f64 {
        self.bulk_modulus(reference) * (rho / reference - 1.0)
    }

    /// Pressure at a density of matter with a reference density, kg/m^3, which deforms for good where a strength is exceeded.
    #[inline]
    pub fn load(&self, rho: f64, reference: f64) -> Loaded {
        let elastic = self.elastic_pressure(rho, reference);
        let bearable = self.limited(elastic, rho);
        if bearable == elastic {
            return Loaded { pressure: elastic, reference };
        }
        match self.reference_of(rho, bearable) {
            Some(reference) => Loaded { pressure: bearable, reference },
            None => Loaded { pressure: elastic, reference },
        }
    }

    /// A pressure, Pa, brought within both strengths.
    #[inline]
    pub fn limited(&self, pressure: f64, rho: f64) -> f64 {
        let phi = self.filling_factor(rho);
        if pressure > 0.0 {
            pressure.min(self.compressive_strength(phi))
        } else {
            pressure.max(self.tensile_strength(phi))
        }
    }

    /// The reference density, kg/m^3, of matter that has a pressure, Pa, at a density: the one nearest to it. `None` where no
    /// reference density gives as much.
    pub fn reference_of(&self, rho: f64, pressure: f64) -> Option<f64> {
        let share = pressure / self.bulk_modulus(rho);
        if share.is_nan() || share > self.most {
            return None;
        }
        // Newton's method on x^(gamma-1) - x^gamma = share from x = 1: concave and falling, so that it approaches from above.
        let (mut x, gamma) = (1.0f64, self.gamma);
        for _ in 0..60 {
            // The usual power needs no library.
            let power = if gamma == 4.0 { x * x } else { libm::pow(x, gamma - 2.0) };
            let slope = power * ((gamma - 1.0) - gamma * x);
            let next = (x - (power * x * (1.0 - x) - share) / slope).max(self.at_most);
            if (next - x).abs() <= 1e-15 * x {
                x = next;
                break;
            }
            x = next;
        }
        Some(x * rho)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(more: &str) -> SironoTable {
        toml::from_str(&format!(
            "rho_s = 2000\nrho_i = 300\nK_0 = \"4.5 kPa\"\n{more}\ntension = {{ T_0 = 630.9573444801932, slope = 1.48 }}\n\
             compression.powder = {{ p_m = 260, phi_1 = 0.12, phi_2 = 0.58, Delta = 0.58 }}\n"
        ))
        .unwrap()
    }

    fn dust() -> Sirono {
        Sirono::new(&table("gamma = 4"))
    }

    /// The reference density has the pressure that it was asked for, on both sides, for any power.
    #[test]
    fn the_reference_density_solves_the_law() {
        for gamma in ["gamma = 2", "gamma = 2.7", "gamma = 4", "gamma = 6"] {
            let law = Sirono::new(&table(gamma));
            for rho in [150.0, 300.0, 700.0, 1100.0] {
                let most = law.most * law.bulk_modulus(rho);
                for share in [-30.0, -1.0, -1e-3, -1e-9, 1e-9, 1e-3, 0.5, 0.999] {
                    let reference = law.reference_of(rho, share * most).unwrap();
                    let off = law.elastic_pressure(rho, reference) / (share * most) - 1.0;
                    assert!(off.abs() < 1e-13 / share.abs().min(1.0) + 1e-12, "{gamma} {rho} {share}: {off:e}");
                    assert_eq!(share > 0.0, reference < rho);
                }
                assert_eq!(law.reference_of(rho, 1.001 * most), None);
            }
        }
    }

    /// Beyond the densest packing and below the loosest all numbers are finite.
    #[test]
    fn no_density_breaks_the_law() {
        let law = dust();
        let mut reference = 300.0;
        for rho in [300.0, 1000.0, 1145.0, 1149.0, 1155.0, 1160.0, 1200.0, 1999.0, 900.0, 240.0, 30.0, 1e-3, 500.0] {
            let loaded = law.load(rho, reference);
            reference = loaded.reference;
            assert!(loaded.pressure.is_finite() && reference.is_finite() && reference > 0.0, "{rho}: {loaded:?}");
            assert!(loaded.pressure <= 0.0 || reference >= 0.75 * rho * (1.0 - 1e-12) || rho > 1149.0);
        }
        // Nothing bears pressure below phi_1.
        assert_eq!(law.load(200.0, 150.0), Loaded { pressure: 0.0, reference: 200.0 });
        // Above phi = 0.5748 no reference density gives the strength.
        assert_eq!(law.reference_of(1150.0, law.compressive_strength(0.575)), None);
        assert!(law.reference_of(1149.0, law.compressive_strength(0.5745)).is_some());
    }

    #[test]
    fn bad_tables_are_named() {
        let wrong = |more: &str| table(more).validate("material.dust.eos.sirono").unwrap_err().to_string();
        assert_eq!(wrong("gamma = 1"), "material.dust.eos.sirono.gamma: gamma is 1 (allowed: above 1, 24 at most)");
        assert!(toml::from_str::<SironoTable>("gamma = 4").is_err());
    }
}
