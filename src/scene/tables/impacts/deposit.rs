//! `[deposit]`: the heap that a body of grains leaves on level ground.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::named;
use crate::error::Result;
use crate::particles::Periods;
use crate::scene::document::source::Document;
use crate::scene::tables::body::validated::Body;
use crate::scene::tables::gravity::GravitySettings;

/// The heap that a body leaves on level ground at the end of the run, with uniform gravity along one axis: how far it has run out, how high it
/// is, how steep.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DepositTable {
    /// Name of the body, which stands on the ground at the start.
    body: String,
}

/// The heap that a body leaves.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct DepositSettings {
    /// Its number.
    pub body: usize,
    /// The point of the ground below the body's middle at the start, m.
    pub origin: [f64; 3],
    /// The axis of gravity, and whether up is along it (1) or against it (-1).
    pub axis: usize,
    pub sign: f64,
    /// Axes along which matter runs out.
    pub out: [Option<usize>; 2],
    /// Half of the body's width along the first of these at the start, m.
    pub half_width: f64,
    /// The body's height at the start, m.
    pub height: f64,
    /// m/s^2
    pub gravity: f64,
}

impl DepositTable {
    pub fn validate(
        &self,
        document: &Document,
        bodies: &[Body],
        gravity: &GravitySettings,
        periods: &Periods,
    ) -> Result<DepositSettings> {
        let number = named::body(document, "deposit.body", &self.body, bodies)?;
        let body = &bodies[number];
        let (axis, along) = gravity.axis().ok_or_else(|| {
            let what = "a heap lies on ground that is level";
            document.error("deposit", what).allowed("a scene with gravity.uniform along one axis")
        })?;
        let mut flat = (0..body.dimension).filter(|&k| k != axis && periods.length[k] == 0.0);
        let out = [flat.next(), flat.next()];
        let Some(first) = out[0] else {
            let what = "there is no axis along which matter could run out: all are periodic";
            return Err(document.error("deposit", what).allowed("a horizontal axis that is not periodic"));
        };
        if periods.length[axis] != 0.0 {
            let what = "matter that falls out of a period has no ground";
            return Err(document.error("deposit", what).allowed("a period along no axis or a horizontal one"));
        }
        let bounds = body.shape.bounds(body.dimension);
        let sign = -along.signum();
        let mut origin = body.centre;
        origin.iter_mut().zip(bounds.middle).for_each(|(x, middle)| *x += middle);
        origin[axis] -= sign * bounds.half[axis];
        Ok(DepositSettings {
            body: number,
            origin,
            axis,
            sign,
            out,
            half_width: bounds.half[first],
            height: 2.0 * bounds.half[axis],
            gravity: along.abs(),
        })
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::Scene;

    const COLUMN: &str = "[[body]]\nname = \"sand\"\nshape = { box = { size = [2, 4, 3] } }\nposition = [1, 0, 1.5]\nmaterial = \"basalt\"\n\
        spacing = 0.1\nlattice = \"cubic\"\n[gravity]\nuniform = [0, 0, -9.81]\n[run]\nuntil = 1\n[deposit]\nbody = \"sand\"\n";

    fn parse(changes: &[&str]) -> crate::error::Result<Scene> {
        let changes: Vec<String> = changes.iter().map(|change| change.to_string()).collect();
        Scene::parse("s.toml", COLUMN, &changes)
    }

    #[test]
    fn a_column_runs_out_along_what_is_level_and_open() {
        let found = parse(&[]).unwrap().deposit.unwrap();
        assert_eq!((found.origin, found.axis, found.sign), ([1.0, 0.0, 0.0], 2, 1.0));
        assert_eq!((found.out, found.half_width, found.height), ([Some(0), Some(1)], 1.0, 3.0));
        let channel = parse(&["domain.periodic.y=[-2, 2]", "gravity.uniform=[0, 0, 2]"]).unwrap().deposit.unwrap();
        assert_eq!((channel.out, channel.origin[2], channel.sign), ([Some(0), None], 3.0, -1.0));
    }

    #[test]
    fn needs_level_ground() {
        for (changes, message) in [
            (&["deposit.body=\"stone\""][..], "stone"),
            (&["gravity.uniform=[1, 0, -9.81]"], "a heap lies on ground that is level"),
            (&["domain.periodic={ x = [0, 2], y = [-2, 2] }"], "no axis along which matter could run out"),
        ] {
            let error = parse(changes).unwrap_err().to_string();
            assert!(error.contains(message), "{error}");
        }
    }
}
