//! `[numerics] integrator`: how steps are made.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize};

use crate::error::Result;
use crate::scene::document::source::Document;
use crate::scene::values::checks::{Range, within};
use crate::units::Number;

const TOLERANCE: Range = [1e-12, 1.0];
/// Of a quantity: where it is large, nothing is refused for its sake.
const SINGLE_TOLERANCE: Range = [1e-12, 1e12];

/// `"predictor_corrector"`, or a table.
#[derive(Debug, Clone, PartialEq, Default, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum IntegratorTable {
    /// Second order, one evaluation per step.
    #[default]
    PredictorCorrector,
    /// Second order, two evaluations per step; a step whose error is too large is made again, shorter.
    RungeKutta(RungeKuttaTable),
    /// Fifth order, six evaluations per step; a step in which the error of any quantity is too large is made again, shorter. Give it
    /// `cfl = 1`: vibrations and flows without yielding then cost a third to two thirds more than by the predictor-corrector with 0.25,
    /// and are an eighteenth as far off or less. Where matter yields it costs more and is no better, as stress returns to the yield
    /// surface step by step, in first order whatever the integrator.
    CashKarp(CashKarpTable),
}

impl<'de> Deserialize<'de> for IntegratorTable {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        /// The table with one of its keys.
        #[derive(Default, Deserialize)]
        #[serde(deny_unknown_fields, default)]
        struct OneKey {
            runge_kutta: Option<RungeKuttaTable>,
            cash_karp: Option<CashKarpTable>,
        }
        struct WordOrTable;
        impl<'de> serde::de::Visitor<'de> for WordOrTable {
            type Value = IntegratorTable;
            fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                f.write_str("\"predictor_corrector\", { runge_kutta = { tolerance = 1e-4 } } or { cash_karp = { tolerance = 1e-4 } }")
            }
            fn visit_str<E: serde::de::Error>(self, word: &str) -> std::result::Result<Self::Value, E> {
                match word {
                    "predictor_corrector" => Ok(IntegratorTable::PredictorCorrector),
                    "runge_kutta" => Ok(IntegratorTable::RungeKutta(RungeKuttaTable::default())),
                    "cash_karp" => Ok(IntegratorTable::CashKarp(CashKarpTable::default())),
                    _ => Err(E::invalid_value(serde::de::Unexpected::Str(word), &self)),
                }
            }
            fn visit_map<A: serde::de::MapAccess<'de>>(self, map: A) -> std::result::Result<Self::Value, A::Error> {
                let table = OneKey::deserialize(serde::de::value::MapAccessDeserializer::new(map))?;
                match (table.runge_kutta, table.cash_karp) {
                    (Some(table), None) => Ok(IntegratorTable::RungeKutta(table)),
                    (None, Some(table)) => Ok(IntegratorTable::CashKarp(table)),
                    _ => Err(serde::de::Error::invalid_value(serde::de::Unexpected::Map, &self)),
                }
            }
        }
        deserializer.deserialize_any(WordOrTable)
    }
}

/// What the error control of `runge_kutta` tolerates.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct RungeKuttaTable {
    /// Error of a step: of velocities over the largest relative velocity, of densities over themselves.
    tolerance: Number,
}

impl Default for RungeKuttaTable {
    fn default() -> Self {
        Self { tolerance: Number::new(1e-4) }
    }
}

/// What the error control of `cash_karp` tolerates.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct CashKarpTable {
    /// Error of a step, in each quantity: of velocities over the largest relative velocity, of positions over h, of densities over
    /// themselves, of other columns over their largest value anywhere.
    #[schemars(range(min = TOLERANCE[0], max = TOLERANCE[1]))]
    tolerance: Number,
    /// The same for single quantities, by name: `{ density = 1e-6, deviatoric_stress = 1e-3 }`; `velocity`, `position`, and what steps
    /// advance of a scene's columns (`density`, `internal_energy`, `deviatoric_stress`). From 1e-12 on; a large one leaves a quantity out.
    #[schemars(with = "BTreeMap<String, f64>")]
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    tolerances: BTreeMap<String, Number>,
}

impl Default for CashKarpTable {
    fn default() -> Self {
        Self { tolerance: Number::new(1e-4), tolerances: BTreeMap::new() }
    }
}

/// How steps are made.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum IntegratorRule {
    PredictorCorrector,
    /// With the error of a step that is tolerated.
    RungeKutta {
        tolerance: f64,
    },
    /// The same, and what is tolerated of single quantities instead.
    CashKarp {
        tolerance: f64,
        tolerances: BTreeMap<String, f64>,
    },
}

impl IntegratorTable {
    pub fn validate(&self, document: &Document) -> Result<IntegratorRule> {
        let within = |key: &str, value: Number, range: Range| {
            within(document, &format!("numerics.integrator.{key}"), value, range)
        };
        Ok(match self {
            Self::PredictorCorrector => IntegratorRule::PredictorCorrector,
            Self::RungeKutta(table) => {
                IntegratorRule::RungeKutta { tolerance: within("runge_kutta.tolerance", table.tolerance, TOLERANCE)? }
            }
            Self::CashKarp(CashKarpTable { tolerance, tolerances }) => {
                let of = |(name, value): (&String, &Number)| {
                    let key = format!("cash_karp.tolerances.{name}");
                    Ok((name.clone(), within(&key, *value, SINGLE_TOLERANCE)?))
                };
                IntegratorRule::CashKarp {
                    tolerance: within("cash_karp.tolerance", *tolerance, TOLERANCE)?,
                    tolerances: tolerances.iter().map(of).collect::<Result<_>>()?,
                }
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    const TEXT: &str = "[[body]]\nname = \"ball\"\nshape = { sphere = { radius = 1 } }\nmaterial = \"basalt\"\n\
        particles = 1000\n[run]\nuntil = 1\n";

    #[test]
    fn an_integrator_is_a_word_or_a_table() {
        let rule = |value: &str| {
            let change = format!("numerics.integrator={value}");
            Scene::parse("s.toml", TEXT, &[change]).map(|scene| scene.numerics.integrator)
        };
        assert_eq!(rule("\"predictor_corrector\"").unwrap(), IntegratorRule::PredictorCorrector);
        for value in ["\"runge_kutta\"", "{ runge_kutta = {} }"] {
            assert_eq!(rule(value).unwrap(), IntegratorRule::RungeKutta { tolerance: 1e-4 });
        }
        for value in ["\"cash_karp\"", "{ cash_karp = {} }"] {
            assert_eq!(rule(value).unwrap(), IntegratorRule::CashKarp { tolerance: 1e-4, tolerances: BTreeMap::new() });
        }
        let single =
            rule("{ cash_karp = { tolerance = 1e-5, tolerances = { density = 1e-3, velocity = 1e9 } } }").unwrap();
        let tolerances = BTreeMap::from([("density".to_string(), 1e-3), ("velocity".to_string(), 1e9)]);
        assert_eq!(single, IntegratorRule::CashKarp { tolerance: 1e-5, tolerances });
        for wrong in [
            "\"runge\"",
            "3",
            "true",
            "{}",
            "{ runge_kutta = { tolerance = 0 } }",
            "{ cash_karp = { tolerance = 2 } }",
            "{ cash_karp = { tolerances = { density = 0 } } }",
            "{ cash_karp = {}, runge_kutta = {} }",
        ] {
            let error = rule(wrong).err().unwrap().to_string();
            assert!(error.contains("integrator") && !error.contains("variant"), "{wrong}: {error}");
        }
    }
}
