//! `[intrusion]`: a body that falls into dust. It falls along one axis: that of uniform gravity, else that of its own velocity.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::named;
use crate::error::Result;
use crate::material::MaterialTable;
use crate::particles::Periods;
use crate::scene::document::source::Document;
use crate::scene::tables::body::validated::Body;
use crate::scene::tables::gravity::{GravitySettings, only_component};

/// A body that falls into dust, along the axis of uniform gravity or, without it, of the body's velocity: how deep, how long, and what it
/// leaves of the dust when it is deepest.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct IntrusionTable {
    /// Name of the body that falls.
    body: String,
    /// Name of the body of dust that it falls into.
    into: String,
    /// Whether the run ends when the body is deepest, before its given end.
    #[serde(default)]
    ends_run: bool,
}

/// A body that falls into dust. Coordinates along the fall are those of its axis, times `sign`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct IntrusionSettings {
    /// Numbers of the bodies.
    pub body: usize,
    pub into: usize,
    /// The axis of the fall, and whether it leads up it (1) or down (-1).
    pub axis: usize,
    pub sign: f64,
    /// The surface of the dust at the start, along the fall, m.
    pub surface: f64,
    /// The body's lowest point at the start, along the fall, m.
    pub lowest: f64,
    /// Acceleration along the fall, m/s^2; zero without uniform gravity.
    pub gravity: f64,
    pub ends_run: bool,
}

/// What else the scene says.
pub struct Around<'a> {
    pub bodies: &'a [Body],
    pub materials: &'a [MaterialTable],
    pub gravity: &'a GravitySettings,
    pub periods: &'a Periods,
}

impl IntrusionTable {
    pub fn validate(&self, document: &Document, around: &Around) -> Result<IntrusionSettings> {
        let bodies = around.bodies;
        let body = named::body(document, "intrusion.body", &self.body, bodies)?;
        let into = named::body(document, "intrusion.into", &self.into, bodies)?;
        if body == into {
            return Err(document.error("intrusion.into", "a body does not fall into itself").allowed("another body"));
        }
        if !around.materials[bodies[into].material].is_dust() {
            let what = format!("`{}` is no dust", self.into);
            return Err(document.error("intrusion.into", what).allowed("a body whose equation of state is sirono"));
        }
        if around.periods.any() {
            let what = "depth is measured in open space";
            return Err(document.error("intrusion", what).allowed("a scene without periodic axes"));
        }
        let (axis, along) = direction(&bodies[body], around.gravity).ok_or_else(|| {
            let what = format!("the fall of `{}` has no axis", self.body);
            let allowed = "uniform gravity along one axis; without it, a velocity of the body along one axis";
            document.error("intrusion.body", what).allowed(allowed)
        })?;
        let across = |body: &Body, k: usize| {
            let bounds = body.shape.bounds(body.dimension);
            [-1.0, 1.0].map(|side| body.centre[k] + bounds.middle[k] + side * bounds.half[k])
        };
        let misses = |k: usize| {
            let ([low, high], [from, to]) = (across(&bodies[body], k), across(&bodies[into], k));
            low >= to || high <= from
        };
        if (0..bodies[body].dimension).filter(|&k| k != axis).any(misses) {
            let what = format!("`{}` falls beside `{}`", self.body, self.into);
            return Err(document.error("intrusion.body", what).allowed("a body whose fall leads into the dust"));
        }
        let sign = 1f64.copysign(along);
        let end = |body: &Body, side: f64| {
            let bounds = body.shape.bounds(body.dimension);
            sign * (body.centre[axis] + bounds.middle[axis]) + side * bounds.half[axis]
        };
        let gravity = around.gravity.uniform.map_or(0.0, |g| sign * g[axis]);
        let (surface, lowest) = (end(&bodies[into], -1.0), end(&bodies[body], 1.0));
        Ok(IntrusionSettings { body, into, axis, sign, surface, lowest, gravity, ends_run: self.ends_run })
    }
}

/// The axis of a fall and its component; none where it is along none.
fn direction(body: &Body, gravity: &GravitySettings) -> Option<(usize, f64)> {
    let pull = gravity.uniform.filter(|g| *g != [0.0; 3]);
    only_component(&pull.unwrap_or(body.velocity))
}

#[cfg(test)]
mod tests {
    use crate::scene::Scene;

    const BEAD: &str = "[[body]]\nname = \"dust\"\nshape = { half_sphere = { radius = 3 } }\nmaterial = \"silica_dust\"\nspacing = 0.5\n\
        [[body]]\nname = \"bead\"\nshape = { sphere = { radius = 1 } }\nposition = [0, 0, 2.5]\nvelocity = [0, 0, -2]\n\
        material = \"glass\"\nspacing = 0.5\n[gravity]\nuniform = [0, 0, -9.81]\n[run]\nuntil = 1\n\
        [intrusion]\nbody = \"bead\"\ninto = \"dust\"\n";

    fn parse(changes: &[&str]) -> crate::error::Result<Scene> {
        let changes: Vec<String> = changes.iter().map(|text| text.to_string()).collect();
        Scene::parse("s.toml", BEAD, &changes)
    }

    #[test]
    fn a_body_falls_along_gravity_or_its_velocity() {
        let found = |changes: &[&str]| parse(changes).unwrap_or_else(|e| panic!("{e}")).intrusion.expect("a fall");
        let fall = found(&[]);
        assert_eq!((fall.axis, fall.sign, fall.gravity), (2, -1.0, 9.81));
        assert_eq!((fall.surface, fall.lowest), (0.0, -1.5));
        let fall = found(&["gravity=false", "bead.position=[-5, 0, 0]", "bead.velocity=[3, 0, 0]"]);
        assert_eq!((fall.axis, fall.sign, fall.gravity), (0, 1.0, 0.0));
        assert_eq!((fall.surface, fall.lowest), (-3.0, -4.0));
        assert!(parse(&["intrusion=false"]).unwrap().intrusion.is_none());
    }

    #[test]
    fn a_fall_that_cannot_be_measured_is_refused() {
        for (change, expected) in [
            ("intrusion.body=beat", "--set intrusion.body=beat: unknown body `beat`"),
            ("intrusion.into=bead", "a body does not fall into itself (allowed: another body)"),
            (
                "dust.material=basalt",
                "s.toml:19: intrusion.into: `dust` is no dust (allowed: a body whose equation of state",
            ),
            ("gravity.uniform=[0, -1, -9]", "the fall of `bead` has no axis (allowed: uniform gravity along one axis"),
            ("domain.periodic={ x = [-9, 9] }", "depth is measured in open space"),
            (
                "bead.position=[4.5, 0, 2.5]",
                "`bead` falls beside `dust` (allowed: a body whose fall leads into the dust)",
            ),
            ("intrusion.ends_rnu=true", "did you mean `ends_run`?"),
        ] {
            let text = parse(&[change]).expect_err(change).to_string();
            assert!(text.contains(expected) && !text.contains('\n'), "{change}: {text}");
        }
    }
}
