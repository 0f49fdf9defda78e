//! Compressive strength of dust: the pressure at which a filling factor gives way.
//!
//! ```text
//! powder      Sigma = p_m [(phi_2 - phi_1) / (phi_2 - phi) - 1]^(Delta ln 10)    Geretshauser et al. 2010, eq. 21
//! fluffy      Sigma = (E_roll / r_0^3) phi^3                                    Kataoka et al. 2013, A&A 554, A4
//! measured    straight lines between points (phi, Sigma)
//! ```
//! phi filling factor, p_m mean pressure, Pa; phi_1, phi_2 filling factors of loose matter, which bears nothing, and of the densest
//! packing, which does not give way; Delta width of the curve in decades of pressure; E_roll energy to roll a monomer by a quarter of
//! its circumference, J; r_0 radius of the monomers, m. Beyond both ends of a curve matter bears nothing, or is not compacted further.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::super::super::setup::all_positive;
use crate::error::{Error, Result};
use crate::units::{Energy, Length, Number, Pressure};

/// Compressive strength over the filling factor.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum CompressionTable {
    /// Strength of packed powder, as measured (Guettler et al. 2009).
    Powder(PowderTable),
    /// Strength of fluffy aggregates, by the cube of the filling factor.
    Fluffy(FluffyTable),
    /// Strength by a list of points.
    Measured(MeasuredTable),
}

/// Strength of packed powder, as measured (Guettler et al. 2009).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PowderTable {
    /// Pressure in the middle of the curve.
    pub p_m: Pressure,
    /// Filling factor up to which matter bears nothing.
    #[schemars(range(min = 0, max = 1))]
    pub phi_1: Number,
    /// Filling factor of the densest packing.
    #[schemars(range(min = 0, max = 1))]
    pub phi_2: Number,
    /// Width of the curve, in decades of pressure.
    #[serde(rename = "Delta")]
    pub width: Number,
}

/// Strength of fluffy aggregates, by the cube of the filling factor.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FluffyTable {
    /// Energy that rolls a monomer over another by a quarter of its circumference.
    pub rolling_energy: Energy,
    /// Radius of the monomers.
    pub monomer_radius: Length,
}

/// Strength by a list of points.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeasuredTable {
    /// Filling factors, from the smallest on.
    pub filling_factor: Vec<Number>,
    /// Compressive strength at each.
    pub pressure: Vec<Pressure>,
}

impl CompressionTable {
    pub(super) fn validate(&self, place: &str) -> Result<()> {
        match self {
            CompressionTable::Powder(table) => {
                let place = format!("{place}.powder");
                let PowderTable { p_m, phi_1, phi_2, width } = table;
                all_positive(&place, &[("p_m", p_m.0), ("phi_2", phi_2.0), ("Delta", width.0)])?;
                let error = |key: &str, what: String| Error::new(what).at(format!("{place}.{key}"));
                if !(0.0..1.0).contains(&phi_1.0) {
                    return Err(error("phi_1", format!("phi_1 is {phi_1}")).allowed("0 and more, below phi_2"));
                }
                if !(phi_1.0 < phi_2.0 && phi_2.0 <= 1.0) {
                    return Err(error("phi_2", format!("phi_2 is {phi_2}")).allowed("more than phi_1, 1 at most"));
                }
                Ok(())
            }
            CompressionTable::Fluffy(table) => {
                let values = [("rolling_energy", table.rolling_energy.0), ("monomer_radius", table.monomer_radius.0)];
                all_positive(&format!("{place}.fluffy"), &values)
            }
            CompressionTable::Measured(table) => table.validate(&format!("{place}.measured")),
        }
    }
}

impl MeasuredTable {
    fn validate(&self, place: &str) -> Result<()> {
        let (phi, pressure) = (&self.filling_factor, &self.pressure);
        if phi.len() != pressure.len() || phi.len() < 2 {
            let what = format!("{} filling factors and {} pressures", phi.len(), pressure.len());
            return Err(Error::new(what).at(place).allowed("as many of one as of the other, two and more"));
        }
        let (factors, pressures) = (format!("{place}.filling_factor"), format!("{place}.pressure"));
        if let Some(phi) = phi.iter().find(|phi| !(0.0..=1.0).contains(&phi.0)) {
            return Err(Error::new(format!("a filling factor of {phi}")).at(factors).allowed("0 to 1"));
        }
        if let Some(pair) = phi.windows(2).find(|pair| pair[0].0 >= pair[1].0) {
            let error = Error::new(format!("{} follows {}", pair[1], pair[0])).at(factors);
            return Err(error.allowed("filling factors that rise from point to point"));
        }
        if let Some(pressure) = pressure.iter().find(|p| !(p.0 >= 0.0 && p.0.is_finite())) {
            return Err(Error::new(format!("a pressure of {pressure}")).at(pressures).allowed("finite, 0 and above"));
        }
        if let Some(pair) = pressure.windows(2).find(|pair| pair[0].0 > pair[1].0) {
            let error = Error::new(format!("{} follows {}", pair[1], pair[0])).at(pressures);
            return Err(error.allowed("pressures that do not fall from point to point"));
        }
        Ok(())
    }
}

/// A law of compressive strength.
#[derive(Debug, Clone, PartialEq)]
pub enum Compression {
    Powder { p_m: f64, phi_1: f64, phi_2: f64, exponent: f64 },
    Fluffy { scale: f64 },
    Measured { phi: Vec<f64>, pressure: Vec<f64> },
}

impl Compression {
    pub fn new(table: &CompressionTable) -> Self {
        match table {
            CompressionTable::Powder(table) => Compression::Powder {
                p_m: table.p_m.0,
                phi_1: table.phi_1.0,
                phi_2: table.phi_2.0,
                exponent: table.width.0 * std::f64::consts::LN_10,
            },
            CompressionTable::Fluffy(table) => {
                let r = table.monomer_radius.0;
                Compression::Fluffy { scale: table.rolling_energy.0 / (r * r * r) }
            }
            CompressionTable::Measured(table) => Compression::Measured {
                phi: table.filling_factor.iter().map(|phi| phi.0).collect(),
                pressure: table.pressure.iter().map(|p| p.0).collect(),
            },
        }
    }

    /// Sigma, Pa, at a filling factor; infinite where matter is not compacted further.
    #[inline]
    pub fn strength(&self, phi: f64) -> f64 {
        match self {
            Compression::Powder { p_m, phi_1, phi_2, exponent } => {
                if phi <= *phi_1 {
                    0.0
                } else if phi >= *phi_2 {
                    f64::INFINITY
                } else {
                    p_m * libm::pow((phi_2 - phi_1) / (phi_2 - phi) - 1.0, *exponent)
                }
            }
            Compression::Fluffy { scale } if phi < 1.0 => scale * phi * phi * phi,
            Compression::Fluffy { .. } => f64::INFINITY,
            Compression::Measured { phi: points, pressure } => {
                let above = points.partition_point(|&point| point <= phi);
                if above == 0 {
                    return 0.0;
                }
                let Some(&next) = points.get(above) else { return f64::INFINITY };
                let share = (phi - points[above - 1]) / (next - points[above - 1]);
                pressure[above - 1] + share * (pressure[above] - pressure[above - 1])
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law(text: &str) -> Compression {
        let table: CompressionTable = toml::from_str::<toml::Table>(text).unwrap()["c"].clone().try_into().unwrap();
        table.validate("c").unwrap();
        Compression::new(&table)
    }

    #[test]
    fn powder_is_limited_at_both_ends() {
        let powder = law("c.powder = { p_m = 260, phi_1 = 0.12, phi_2 = 0.58, Delta = 0.58 }");
        assert_eq!(powder.strength(0.1), 0.0);
        assert_eq!(powder.strength(0.58), f64::INFINITY);
        // Half way the base is one.
        assert!((powder.strength(0.35) / 260.0 - 1.0).abs() < 1e-14);
        assert!((powder.strength(0.15) / 7.42459 - 1.0).abs() < 1e-6, "{}", powder.strength(0.15));
    }

    /// The ice of Kataoka et al. 2013: monomers of 0.1 um, 4.74e-9 erg to roll.
    #[test]
    fn fluffy_matter_follows_the_cube() {
        let fluffy = law("c.fluffy = { rolling_energy = 4.74e-16, monomer_radius = \"0.1 um\" }");
        assert!((fluffy.strength(1e-3) / 4.74e-4 - 1.0).abs() < 1e-12, "{}", fluffy.strength(1e-3));
        assert!((fluffy.strength(2e-3) / fluffy.strength(1e-3) - 8.0).abs() < 1e-12);
        assert_eq!(fluffy.strength(1.0), f64::INFINITY);
    }

    #[test]
    fn points_are_joined() {
        let measured = law("c.measured = { filling_factor = [0.1, 0.2, 0.4], pressure = [0, 100, \"1 kPa\"] }");
        assert_eq!([0.05, 0.1, 0.2, 0.4].map(|phi| measured.strength(phi)), [0.0, 0.0, 100.0, f64::INFINITY]);
        assert!((measured.strength(0.3) - 550.0).abs() < 1e-9 && (measured.strength(0.15) - 50.0).abs() < 1e-9);
    }

    #[test]
    fn bad_curves_are_named() {
        let wrong = |text: &str| {
            let table: CompressionTable = toml::from_str::<toml::Table>(text).unwrap()["c"].clone().try_into().unwrap();
            table.validate("c").unwrap_err().to_string()
        };
        let powder = |phi_1: f64, phi_2: f64| {
            wrong(&format!("c.powder = {{ p_m = 260, phi_1 = {phi_1}, phi_2 = {phi_2}, Delta = 0.58 }}"))
        };
        assert_eq!(powder(-0.1, 0.5), "c.powder.phi_1: phi_1 is -0.1 (allowed: 0 and more, below phi_2)");
        assert_eq!(powder(0.3, 0.2), "c.powder.phi_2: phi_2 is 0.2 (allowed: more than phi_1, 1 at most)");
        let measured =
            |phi: &str, p: &str| wrong(&format!("c.measured = {{ filling_factor = {phi}, pressure = {p} }}"));
        assert!(measured("[0.1, 0.2]", "[1]").contains("2 filling factors and 1 pressures"));
        assert!(measured("[0.2, 0.1]", "[1, 2]").starts_with("c.measured.filling_factor"));
        assert!(measured("[0.1, 0.2]", "[2, 1]").starts_with("c.measured.pressure"));
    }
}
