//! Elastic pores (Jutzi et al. 2008, eqs 6-7; Herrmann 1969): below the crush curve distention follows pressure reversibly.
//!
//! ```text
//! d alpha / dP = alpha^2 / K_0 (1 - 1 / h^2)    h = 1 + (alpha - 1) (c_e - c_0) / (c_0 (alpha_e - 1))    K_0 = c_0^2 rho_s0
//! ```
//! alpha distention, alpha_e that at P_e; K_0 bulk modulus of the matrix, Pa; rho_s0 its density without load, kg/m^3; c_0, c_e
//! speeds of sound of the matrix and of the porous body at alpha_e, m/s: 1/c^2 = 1/c_0^2 - rho_s / alpha^2 d alpha / dP, so that
//! sound runs with h c_0.
//!
//! With x = alpha - 1, h = 1 + s x, the equation is solved in closed form. P = F(x) - F(x_r) is the line of states of a body
//! that has x_r without load:
//!
//! ```text
//! F = K_0 / s [ ln(x) / 2 - e ln(2 + s x) + (e - 1/2) ln(1 + x) - C / (1 + x) ]    e = s^2 / (2 (s - 2)^2)    C = (1 - s)^2 / (s - 2)
//! ```
//! Under tension pores keep the distention they have without load.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::{Error, Result};
use crate::material::setup::all_positive;
use crate::units::Speed;

/// Pores give way and come back below P_e.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ElasticTable {
    /// Speed of sound of the porous body where pores begin to crush.
    pub c_e: Speed,
    /// Speed of sound of the matrix.
    pub c_0: Speed,
}

impl ElasticTable {
    pub fn validate(&self, place: &str) -> Result<()> {
        all_positive(place, &[("c_e", self.c_e.0), ("c_0", self.c_0.0)])?;
        // Slower than this, h has no sign at the start.
        if self.c_e.0 < self.c_0.0 && self.c_e.0 > 0.05 * self.c_0.0 {
            return Ok(());
        }
        Err(Error::new(format!("c_e is {:e} m/s and c_0 is {:e} m/s", self.c_e.0, self.c_0.0))
            .at(format!("{place}.c_e"))
            .allowed("c_e between 0.05 and 1 times c_0; without the table pores are rigid"))
    }
}

/// The branch of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elastic {
    /// K_0, Pa.
    modulus: f64,
    /// s
    steepness: f64,
}

impl Elastic {
    /// The branch of a body with the distention `alpha_0` without load, and alpha_e, which it has at `p_e`, Pa; `None` for a body
    /// without pores.
    pub fn new(table: &ElasticTable, alpha_0: f64, p_e: f64, matrix_density: f64) -> Option<(Self, f64)> {
        let c_0 = table.c_0.0;
        let with = |alpha_e: f64| Self {
            modulus: c_0 * c_0 * matrix_density,
            steepness: (table.c_e.0 - c_0) / (c_0 * (alpha_e - 1.0)),
        };
        if alpha_0 <= 1.0 {
            return None;
        }
        // h depends on alpha_e: bisection, once for a body.
        let (mut low, mut high) = (1.0 + 0.5 * (alpha_0 - 1.0), alpha_0);
        loop {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                return Some((with(middle), middle));
            }
            if with(middle).pressure(middle, alpha_0) > p_e { low = middle } else { high = middle }
        }
    }

    /// Pressure at a distention on the line of a body that has `unloaded` without load, Pa.
    pub fn pressure(&self, alpha: f64, unloaded: f64) -> f64 {
        self.level(alpha) - self.level(unloaded)
    }

    /// F at a distention, Pa.
    pub fn level(&self, alpha: f64) -> f64 {
        let (x, s) = (alpha - 1.0, self.steepness);
        let e = 0.5 * s * s / ((s - 2.0) * (s - 2.0));
        let c = (1.0 - s) * (1.0 - s) / (s - 2.0);
        let sum = 0.5 * libm::log(x) - e * libm::log(2.0 + s * x) + (e - 0.5) * libm::log(alpha) - c / alpha;
        self.modulus / s * sum
    }

    /// d alpha / dP, 1/Pa.
    pub fn slope(&self, alpha: f64) -> f64 {
        let h = 1.0 + self.steepness * (alpha - 1.0);
        alpha * alpha / self.modulus * (1.0 - 1.0 / (h * h))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Quantity;

    /// Porous aluminium (Jutzi et al. 2008, table 1).
    fn aluminium(alpha_0: f64) -> (Elastic, f64) {
        let table = ElasticTable { c_e: Quantity(4110.0), c_0: Quantity(5350.0) };
        Elastic::new(&table, alpha_0, 8e7, 2700.0).unwrap()
    }

    /// alpha_e = 1.2738287912637167 at alpha_0 = 1.275, from a numerical integration of eq. 6.
    #[test]
    fn distention_at_the_elastic_limit() {
        let (elastic, alpha_e) = aluminium(1.275);
        assert!((alpha_e - 1.2738287912637167).abs() < 1e-11, "{alpha_e}");
        assert!((elastic.pressure(alpha_e, 1.275) - 8e7).abs() < 1.0);
        assert_eq!(elastic.pressure(1.2, 1.2), 0.0);
    }

    /// The closed form against the equation, in differences.
    #[test]
    fn the_line_obeys_its_equation() {
        for alpha_0 in [1.1, 1.275, 3.0] {
            let (elastic, alpha_e) = aluminium(alpha_0);
            for share in [0.05, 0.3, 0.8, 0.999] {
                let alpha = 1.0 + share * (alpha_e - 1.0);
                let d = 1e-5 * (alpha - 1.0);
                let by_p = 2.0 * d / (elastic.pressure(alpha + d, alpha_0) - elastic.pressure(alpha - d, alpha_0));
                assert!((elastic.slope(alpha) / by_p - 1.0).abs() < 1e-6, "{alpha_0} {alpha}");
            }
            // Sound at alpha_e: 1/c^2 = 1/c_0^2 - rho_s / alpha^2 d alpha / dP.
            let sound2 = 1.0 / (1.0 / (5350.0 * 5350.0) - 2700.0 / (alpha_e * alpha_e) * elastic.slope(alpha_e));
            assert!((sound2.sqrt() - 4110.0).abs() < 1e-6, "{}", sound2.sqrt());
        }
    }

    #[test]
    fn senseless_speeds_are_refused() {
        let table = |c_e: f64| ElasticTable { c_e: Quantity(c_e), c_0: Quantity(5350.0) };
        assert!(table(4110.0).validate("e").is_ok());
        assert!(table(5350.0).validate("e").is_err() && table(100.0).validate("e").is_err());
        assert!(Elastic::new(&table(4110.0), 1.0, 8e7, 2700.0).is_none());
    }
}
