//! epsilon-alpha: distention by volumetric strain alone (Wünnemann et al. 2006, Icarus 180, 514; Jutzi et al. 2008, eqs 9-14).
//!
//! ```text
//! eps = ln(rho_0 / rho)                                                  negative in compression
//! eps > eps_e             alpha = alpha_0
//! eps_X < eps < eps_e     alpha = alpha_0 exp(kappa (eps - eps_e))
//! eps_c < eps < eps_X     alpha = 1 + (alpha_X - 1) ((eps_c - eps) / (eps_c - eps_X))^2
//! eps < eps_c             alpha = 1                                      eps_c = eps_X + 2 (1 - alpha_X) / (kappa alpha_X)
//! ```
//! rho density, rho_0 that at the start, kg/m^3; eps_e strain at which pores begin to crush, kappa at most 1: for kappa = 1 the
//! matrix keeps its density. alpha_X begins the power law, which joins without a kink; without it the exponential continues
//! to 1.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::{Error, Result};
use crate::material::setup::{all_positive, none_negative};
use crate::units::{Number, Pressure};

/// Distention falls exponentially with strain, then by a power law.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StrainTable {
    /// Rate of the exponential, more than 0 and at most 1.
    pub kappa: Number,
    /// Pressure of the cold body where it begins; this or `elastic_strain`.
    #[serde(rename = "P_e")]
    pub p_e: Option<Pressure>,
    /// Compressive volumetric strain where it begins; this or `P_e`.
    pub elastic_strain: Option<Number>,
    /// Distention where the power law takes over.
    #[serde(rename = "alpha_X")]
    pub alpha_x: Option<Number>,
}

impl StrainTable {
    pub fn validate(&self, place: &str, distention: f64) -> Result<()> {
        all_positive(place, &[("kappa", self.kappa.0)])?;
        if self.kappa.0 > 1.0 {
            return Err(Error::new(format!("kappa is {}", self.kappa.0))
                .at(format!("{place}.kappa"))
                .allowed("0 to 1"));
        }
        match (self.p_e, self.elastic_strain) {
            (Some(p_e), None) => all_positive(place, &[("P_e", p_e.0)])?,
            (None, Some(strain)) => none_negative(place, &[("elastic_strain", strain.0)])?,
            _ => {
                return Err(Error::new("where crushing begins is not clear")
                    .at(place)
                    .allowed("P_e or elastic_strain"));
            }
        }
        match self.alpha_x {
            Some(alpha_x) if !(alpha_x.0 > 1.0 && alpha_x.0 <= distention) => {
                let error = Error::new(format!("alpha_X is {}", alpha_x.0)).at(format!("{place}.alpha_X"));
                Err(error.allowed(format!("above 1, up to the distention, {distention}")))
            }
            _ => Ok(()),
        }
    }
}

/// alpha(eps) of a body on first loading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StrainLaw {
    alpha_0: f64,
    kappa: f64,
    /// rho_0, kg/m^3.
    density: f64,
    /// -eps_e
    elastic: f64,
    power: Option<Power>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Power {
    alpha_x: f64,
    /// -eps_X and -eps_c.
    begins: f64,
    ends: f64,
}

impl StrainLaw {
    /// `density` of the body at the start; `elastic`: -eps_e.
    pub fn new(table: &StrainTable, alpha_0: f64, density: f64, elastic: f64) -> Self {
        let kappa = table.kappa.0;
        let power = table.alpha_x.filter(|alpha_x| alpha_x.0 < alpha_0).map(|alpha_x| {
            let alpha_x = alpha_x.0;
            let begins = elastic + libm::log(alpha_0 / alpha_x) / kappa;
            Power { alpha_x, begins, ends: begins + 2.0 * (alpha_x - 1.0) / (kappa * alpha_x) }
        });
        Self { alpha_0, kappa, density, elastic, power }
    }

    /// alpha and d alpha / d eps at a density, kg/m^3.
    pub fn at(&self, rho: f64) -> (f64, f64) {
        // -eps, positive in compression.
        let strain = libm::log(rho / self.density);
        if strain <= self.elastic {
            return (self.alpha_0, 0.0);
        }
        if let Some(power) = self.power.filter(|power| strain > power.begins) {
            let left = (power.ends - strain) / (power.ends - power.begins);
            if left <= 0.0 {
                return (1.0, 0.0);
            }
            let height = (power.alpha_x - 1.0) * left;
            return (1.0 + height * left, 2.0 * height / (power.ends - power.begins));
        }
        let alpha = self.alpha_0 * libm::exp(self.kappa * (self.elastic - strain));
        if alpha > 1.0 { (alpha, self.kappa * alpha) } else { (1.0, 0.0) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Quantity;

    fn table(alpha_x: Option<f64>) -> StrainTable {
        StrainTable {
            kappa: Quantity(0.98),
            p_e: None,
            elastic_strain: Some(Quantity(0.01)),
            alpha_x: alpha_x.map(Quantity),
        }
    }

    /// Value and slope are continuous across branches; slopes agree with differences.
    #[test]
    fn branches_meet_without_a_kink() {
        let law = StrainLaw::new(&table(Some(1.3)), 3.0, 900.0, 0.01);
        let power = law.power.unwrap();
        let at = |strain: f64| law.at(900.0 * libm::exp(strain));
        for joint in [power.begins, power.ends] {
            let (below, above) = (at(joint - 1e-9), at(joint + 1e-9));
            assert!((below.0 - above.0).abs() < 1e-8 && (below.1 - above.1).abs() < 1e-7, "{below:?} {above:?}");
        }
        for strain in [0.02, 0.4, power.begins + 0.1, power.ends - 0.05] {
            let slope = -(at(strain + 1e-6).0 - at(strain - 1e-6).0) / 2e-6;
            assert!((at(strain).1 / slope - 1.0).abs() < 1e-6, "{strain}");
        }
        assert_eq!(at(0.005), (3.0, 0.0));
        assert_eq!(at(power.ends + 0.01), (1.0, 0.0));
    }

    /// kappa = 1: alpha = alpha_0 rho_e / rho, the matrix keeps its density.
    #[test]
    fn the_matrix_keeps_its_density_at_kappa_one() {
        let law = StrainLaw::new(&StrainTable { kappa: Quantity(1.0), ..table(None) }, 3.0, 900.0, 0.01);
        let rho_e = 900.0 * libm::exp(0.01);
        for rho in [950.0, 1500.0, 2400.0] {
            assert!((law.at(rho).0 * rho / (3.0 * rho_e) - 1.0).abs() < 1e-14);
        }
        assert_eq!(law.at(2800.0), (1.0, 0.0));
    }

    #[test]
    fn senseless_tables_are_refused() {
        assert!(table(Some(1.3)).validate("e", 3.0).is_ok());
        assert!(table(Some(3.3)).validate("e", 3.0).is_err());
        assert!(StrainTable { kappa: Quantity(1.1), ..table(None) }.validate("e", 3.0).is_err());
        assert!(StrainTable { p_e: Some(Quantity(1e6)), ..table(None) }.validate("e", 3.0).is_err());
        assert!(StrainTable { elastic_strain: None, ..table(None) }.validate("e", 3.0).is_err());
    }
}
