//! Where space ends or closes on itself, and what is held: `[domain]`, `motion` of a body, `[[layer]]`. Parts of bodies to be
//! held or watched are named by where their particles start.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::body::Body;
use super::raw::Components;
use super::shape::Shape;
use super::source::Document;
use crate::error::{Error, Result};
use crate::motion::Motion;
use crate::particles::Periods;
use crate::units::{Length, Speed, Time};

/// A coordinate axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Axis {
    X,
    Y,
    Z,
}

impl Axis {
    /// Its number; an error where the scene does not have it.
    pub(super) fn number(self, document: &Document, path: &str, dimension: usize) -> Result<usize> {
        match self as usize {
            number if number < dimension => Ok(number),
            _ => Err(document.error(path, "there is no z axis in 2 dimensions").allowed("x, y")),
        }
    }
}

/// A stretch of an axis.
pub type RawInterval = [Length; 2];

pub(super) fn interval(document: &Document, path: &str, [low, high]: RawInterval) -> Result<[f64; 2]> {
    if low.0 < high.0 {
        return Ok([low.0, high.0]);
    }
    Err(document.error(path, format!("{low} is not below {high}")).allowed("[lower end, upper end]"))
}

#[derive(Debug, Clone, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct RawDomain {
    periodic: BTreeMap<Axis, RawInterval>,
}

impl RawDomain {
    pub(super) fn validate(&self, document: &Document, dimension: usize) -> Result<Periods> {
        let mut periods = Periods::OPEN;
        for (axis, ends) in &self.periodic {
            let path = "domain.periodic";
            let axis = axis.number(document, path, dimension)?;
            let [low, high] = interval(document, path, *ends)?;
            (periods.low[axis], periods.length[axis]) = (low, high - low);
        }
        Ok(periods)
    }
}

/// Share of a period by which a body may seem to miss its ends.
const TOUCHING: f64 = 1e-9;

/// Along which axes a body of this size fills the period.
pub(super) fn fills(periods: &Periods, size: [f64; 3]) -> [bool; 3] {
    std::array::from_fn(|k| periods.closed(k) && (size[k] - periods.length[k]).abs() <= TOUCHING * periods.length[k])
}

/// Bodies lie within the periods, and no particle meets two images of another. `reach`: the largest list radius there may be, m.
pub(super) fn check_periods(document: &Document, periods: &Periods, bodies: &[Body], reach: f64) -> Result<()> {
    if periods.shortest() < 2.1 * reach {
        let what = format!("a period of {} is too short", Length::new(periods.shortest()));
        return Err(document
            .error("domain.periodic", what)
            .allowed(format!("{} or more, 2.1 times the radius of the neighbour lists", Length::new(2.1 * reach))));
    }
    for (number, body) in bodies.iter().enumerate() {
        let bounds = body.shape.bounds(body.dimension);
        for axis in (0..body.dimension).filter(|&axis| periods.closed(axis)) {
            let middle = body.centre[axis] + bounds.middle[axis] - periods.low[axis];
            let slack = TOUCHING * periods.length[axis];
            if middle - bounds.half[axis] < -slack || middle + bounds.half[axis] > periods.length[axis] + slack {
                let what = format!("body \"{}\" reaches beyond the period", body.name);
                return Err(document.error(&format!("body.{number}.position"), what).allowed("bodies within [domain]"));
            }
        }
    }
    Ok(())
}

/// How something moves: `"fixed"`, or a table with one key.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum RawMotion {
    Fixed,
    Velocity(Components<Speed>),
    Along(Vec<Axis>),
    /// Within about this time; for ever, or until a second one.
    Damping(Components<Time>),
}

impl RawMotion {
    /// `towards`: the velocity that damping leads back to, m/s.
    pub(super) fn validate(
        &self,
        document: &Document,
        path: &str,
        (dimension, towards): (usize, [f64; 3]),
    ) -> Result<Motion> {
        match self {
            RawMotion::Fixed => Ok(Motion::Prescribed([0.0; 3])),
            RawMotion::Velocity(components) if components.0.len() != dimension => {
                let what = format!("{} components in {dimension} dimensions", components.0.len());
                Err(document.error(path, what).allowed(format!("{dimension} components")))
            }
            RawMotion::Velocity(components) => {
                let mut velocity = [0.0; 3];
                velocity.iter_mut().zip(&components.0).for_each(|(v, c)| *v = c.0);
                Ok(Motion::Prescribed(velocity))
            }
            RawMotion::Along(axes) => {
                let mut along = [false; 3];
                for axis in axes {
                    along[axis.number(document, path, dimension)?] = true;
                }
                Ok(Motion::Along(along))
            }
            RawMotion::Damping(Components(times)) => {
                let (time, until) = match times[..] {
                    [time] => (time, None),
                    [time, until] => (time, Some(until)),
                    _ => {
                        let what = format!("{} times", times.len());
                        return Err(document.error(path, what).allowed("a time, or [time, until]"));
                    }
                };
                for (word, given) in [("within", Some(time)), ("until", until)] {
                    if let Some(given) = given.filter(|given| given.0 <= 0.0) {
                        let what = format!("damping {word} {given}");
                        return Err(document.error(path, what).allowed("a time above zero"));
                    }
                }
                Ok(Motion::Damped { time: time.0, towards, until: until.map(|until| until.0) })
            }
        }
    }
}

/// A part of bodies, by where particles start, with a motion of its own.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawLayer {
    /// All without it.
    body: Option<String>,
    x: Option<RawInterval>,
    y: Option<RawInterval>,
    z: Option<RawInterval>,
    /// Thickness below the body's outer faces.
    outer: Option<Length>,
    motion: RawMotion,
}

/// A validated layer.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Layer {
    pub part: Part,
    pub outer: Option<Outer>,
    pub motion: Motion,
}

/// A block of space, within one body or any.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Part {
    /// The body it is a part of; any without.
    pub body: Option<usize>,
    /// m.
    pub low: [f64; 3],
    pub high: [f64; 3],
}

/// What lies near a body's outer faces: see [`Shape::outer_distance`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Outer {
    /// m.
    pub thickness: f64,
    shape: Shape,
    centre: [f64; 3],
    /// Axes across which a box has faces.
    across: [bool; 3],
    dimension: usize,
}

impl Outer {
    /// Whether a point of the body belongs to it.
    pub fn holds(&self, point: [f64; 3]) -> bool {
        let inside = std::array::from_fn(|k| point[k] - self.centre[k]);
        self.shape.outer_distance(inside, self.across, self.dimension) <= self.thickness
    }
}

impl Part {
    /// Whether a particle that starts at `point` belongs to it.
    pub fn holds(&self, body: usize, point: [f64; 3]) -> bool {
        self.body.is_none_or(|own| own == body) && (0..3).all(|k| (self.low[k]..=self.high[k]).contains(&point[k]))
    }
}

impl Layer {
    /// Whether a particle that starts at `point` belongs to it.
    pub fn holds(&self, body: usize, point: [f64; 3]) -> bool {
        self.part.holds(body, point) && self.outer.as_ref().is_none_or(|outer| outer.holds(point))
    }
}

/// The part of `body` (all without) between these ends along x, y and z.
pub(super) fn part(
    document: &Document,
    path: &str,
    (body, ends): (Option<&String>, [Option<RawInterval>; 3]),
    bodies: &[Body],
) -> Result<Part> {
    let body = match body {
        None => None,
        Some(name) => Some(bodies.iter().position(|body| body.name == *name).ok_or_else(|| {
            let known: Vec<String> = bodies.iter().map(|body| body.name.clone()).collect();
            super::keys::unknown(document, &format!("{path}.body"), "body", name, &known)
        })?),
    };
    // Finite, as a scene travels as JSON.
    let (mut low, mut high) = ([f64::MIN; 3], [f64::MAX; 3]);
    for (axis, ends) in [Axis::X, Axis::Y, Axis::Z].into_iter().zip(ends) {
        let Some(ends) = ends else { continue };
        let key = format!("{path}.{}", ["x", "y", "z"][axis as usize]);
        let axis = axis.number(document, &key, bodies[0].dimension)?;
        [low[axis], high[axis]] = interval(document, &key, ends)?;
    }
    Ok(Part { body, low, high })
}

impl RawLayer {
    pub(super) fn validate(
        &self,
        document: &Document,
        number: usize,
        (bodies, periods): (&[Body], &Periods),
    ) -> Result<Layer> {
        let path = format!("layer.{number}");
        let part = part(document, &path, (self.body.as_ref(), [self.x, self.y, self.z]), bodies)?;
        let body = part.body.map(|body| &bodies[body]);
        let outer = self.outer.map(|thickness| outer(document, &path, (thickness, body), periods)).transpose()?;
        let towards = body.map_or([0.0; 3], |body| body.velocity);
        let dimension = bodies[0].dimension;
        let motion = self.motion.validate(document, &format!("{path}.motion"), (dimension, towards))?;
        Ok(Layer { part, outer, motion })
    }
}

/// What lies within `thickness` of the outer faces of `body`.
fn outer(
    document: &Document,
    path: &str,
    (thickness, body): (Length, Option<&Body>),
    periods: &Periods,
) -> Result<Outer> {
    let error = |what: String| document.error(&format!("{path}.outer"), what);
    let Some(body) = body else {
        return Err(error("outer faces are those of one body".into()).allowed("a layer with a key `body`"));
    };
    let closed = match body.shape {
        Shape::Box { size } => fills(periods, size),
        _ => [false; 3],
    };
    let across = closed.map(|closed| !closed);
    let most = body.shape.largest_outer_distance(across, body.dimension);
    if most == f64::INFINITY {
        return Err(error(format!("body \"{}\" has no outer faces: it fills its periods", body.name)));
    }
    if !(thickness.0 > 0.0 && thickness.0 < most) {
        let what = format!("an outer layer of {thickness} in body \"{}\"", body.name);
        return Err(error(what).allowed(format!("more than 0 and less than {}, which is all of it", Length::new(most))));
    }
    let Body { shape, centre, dimension, .. } = *body;
    Ok(Outer { thickness: thickness.0, shape, centre, across, dimension })
}

/// An error of a scene that has both an impact and periodic axes.
pub(super) fn no_impact(document: &Document) -> Error {
    let what = "an impact is found in open space: fragments are not linked across periods";
    document.error("domain.periodic", what).allowed("a scene without [impact]")
}
