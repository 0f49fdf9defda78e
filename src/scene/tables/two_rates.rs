//! `[two_rates]`: bodies that take smaller steps than the rest.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::impacts::named;
use super::integrator::IntegratorRule;
use super::numerics::NumericsSettings;
use crate::error::Result;
use crate::scene::document::source::Document;
use crate::scene::tables::body::validated::Body;
use crate::scene::tables::gravity::GravitySettings;

/// For a stiff or fine body in soft or coarse matter: it takes several small steps in each step of the rest, with what is in touch with it. What
/// they give each other keeps momentum exactly, and energy to second order of the step.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TwoRatesTable {
    /// Names of the bodies that take small steps.
    fast: Vec<String>,
    /// How many parts of a target that `impact.refine` makes finer take them, too, the finest first.
    #[serde(default)]
    parts: u32,
    /// Small steps in each step of the rest; as many as the bodies' own limits ask for without it.
    #[schemars(range(min = STEPS[0], max = STEPS[1]))]
    steps: Option<u32>,
}

/// Least and most small steps that may be asked for.
const STEPS: [u32; 2] = [2, 1 << 14];

/// Which bodies take small steps.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TwoRates {
    /// Of each body, parts of a target among them, whether it does.
    pub fast: Vec<bool>,
    /// Small steps in each step of the rest, where the scene says it.
    pub steps: Option<u32>,
}

/// The rest of a scene that two rates depend on.
pub struct Matter<'a> {
    /// The bodies that the scene names.
    pub bodies: &'a [Body],
    /// Parts of a refined target.
    pub parts: usize,
    pub numerics: &'a NumericsSettings,
    pub gravity: &'a GravitySettings,
    /// Whether there is a late stage.
    pub late_stage: bool,
}

impl TwoRatesTable {
    pub fn validate(&self, document: &Document, matter: &Matter) -> Result<TwoRates> {
        let Matter { bodies, parts, .. } = *matter;
        let mut fast = vec![false; bodies.len() + parts];
        for (number, name) in self.fast.iter().enumerate() {
            fast[named::body(document, &format!("two_rates.fast.{number}"), name, bodies)?] = true;
        }
        if self.parts as usize > parts {
            let what = format!("{} parts of a target take small steps, but there are {parts}", self.parts);
            return Err(document.error("two_rates.parts", what).allowed(format!("0 to {parts}")));
        }
        fast[bodies.len()..][..self.parts as usize].fill(true);
        if fast.iter().all(|fast| *fast) || !fast.contains(&true) {
            let error = document.error("two_rates.fast", "all bodies take the same steps");
            return Err(error.allowed("some bodies of a scene, not all"));
        }
        if let Some(steps) = self.steps
            && !(STEPS[0]..=STEPS[1]).contains(&steps)
        {
            let [least, most] = STEPS;
            let error = document.error("two_rates.steps", format!("{steps} small steps"));
            return Err(error.allowed(format!("{least} to {most}")));
        }
        combines(document, matter)?;
        Ok(TwoRates { fast, steps: self.steps })
    }
}

/// Refuses what refers to a moment of all particles.
fn combines(document: &Document, matter: &Matter) -> Result<()> {
    let numerics = matter.numerics;
    let refused = [
        (numerics.integrator != IntegratorRule::PredictorCorrector, "an integrator that may refuse steps"),
        (matter.gravity.own.is_some(), "gravity of particles on each other"),
        (matter.bodies.iter().any(|body| body.rigid.is_some()), "a rigid body"),
        (matter.late_stage, "a late stage"),
    ];
    match refused.into_iter().find(|(found, _)| *found) {
        None => Ok(()),
        Some((_, what)) => {
            let error = document.error("two_rates", format!("{what} and two rates cannot be combined"));
            Err(error.allowed("one of them"))
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::Scene;

    const BALLS: &str = "[[body]]\nname = \"bead\"\nshape = { sphere = { radius = 1 } }\nmaterial = \"basalt\"\nspacing = 0.2\n\
        [[body]]\nname = \"bed\"\nshape = { box = { size = [9, 9, 4] } }\nposition = [0, 0, -3]\nmaterial = \"basalt\"\n\
        spacing = 0.4\n[run]\nuntil = 1\n[two_rates]\nfast = [\"bead\"]\n";

    fn parse(changes: &[&str]) -> crate::error::Result<Scene> {
        let changes: Vec<String> = changes.iter().map(|text| text.to_string()).collect();
        Scene::parse("s.toml", BALLS, &changes)
    }

    #[test]
    fn bodies_of_two_rates_are_named() {
        let rates = |changes: &[&str]| parse(changes).unwrap_or_else(|e| panic!("{e}")).two_rates;
        let found = rates(&[]).expect("two rates");
        assert_eq!((found.fast, found.steps), (vec![true, false], None));
        assert_eq!(rates(&["two_rates.steps=60"]).expect("two rates").steps, Some(60));
        assert_eq!(rates(&["two_rates=false"]), None);
        let again = Scene::parse("s.toml", &parse(&[]).expect("a scene").to_toml(), &[]).expect("as understood");
        assert_eq!(again.two_rates, rates(&[]));
    }

    #[test]
    fn what_two_rates_cannot_do_is_refused() {
        for (change, expected) in [
            ("two_rates.fast=[\"beat\"]", "unknown body `beat`"),
            ("two_rates.fast=[]", "all bodies take the same steps (allowed: some bodies"),
            ("two_rates.fast=[\"bead\", \"bed\"]", "all bodies take the same steps (allowed: some bodies"),
            ("two_rates.steps=1", "1 small steps (allowed: 2 to 16384)"),
            ("two_rates.parts=1", "1 parts of a target take small steps, but there are 0 (allowed: 0 to 0)"),
            ("numerics.integrator=runge_kutta", "an integrator that may refuse steps and two rates cannot be combined"),
            ("gravity.self=true", "gravity of particles on each other and two rates"),
            ("bed.rigid=true", "a rigid body and two rates cannot be combined (allowed: one of them)"),
        ] {
            let text = parse(&[change]).expect_err(change).to_string();
            assert!(text.contains(expected) && !text.contains('\n'), "{change}: {text}");
        }
    }
}
