//! `[impact]`: which body hits which, how fast and at what angle; where the projectile starts. The target rests where the scene puts
//! it; the projectile starts with one kernel support between the surfaces.
//!
//! On a sphere the projectile flies along -x, displaced along +y by sin(angle) (R_t + R_p): at contact its velocity makes
//! `angle` with the line of centres. Where the angle is that of its centre's path with the surface that this path meets, it is
//! displaced by sin(angle) R_t: a large projectile then passes nearer, and less of it beside the target. On a flat target (box,
//! cylinder, half sphere) it comes down on the middle of the upper face (+z, in 2D +y) and flies towards -x, `angle` from the normal.

use std::f64::consts::PI;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::refine::RefineTable;
use crate::error::{Error, Result};
use crate::scene::document::keys::unknown;
use crate::scene::document::source::Document;
use crate::scene::geometry::bounding_box::BoundingBox;
use crate::scene::geometry::shape::BodyShape;
use crate::scene::tables::body::validated::Body;
use crate::scene::values::checks::POSITIVE;
use crate::scene::values::switch::Switch;
use crate::units::{Angle, Speed};

/// An impact of one body onto another. Onto a sphere only a sphere can fall, along -x; a flat target is hit in the middle of its upper
/// face.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ImpactTable {
    /// Speed at contact; bodies start one kernel support apart.
    #[schemars(extend("x-allowed" = POSITIVE))]
    pub speed: Speed,
    /// Angle from the normal; 0 is head-on.
    #[serde(default)]
    #[schemars(extend("x-allowed" = ANGLES))]
    angle: Angle,
    /// Where the angle is measured.
    #[serde(default)]
    angle_at: AngleAt,
    /// Name of the body that is hit.
    #[schemars(extend("x-default" = "the first body"))]
    pub target: Option<String>,
    /// Name of the body that hits it.
    #[schemars(extend("x-default" = "the second body"))]
    projectile: Option<String>,
    /// Makes the target finer where it is hit.
    pub refine: Option<Switch<RefineTable>>,
}

/// Where the angle of an impact onto a sphere is measured.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum AngleAt {
    /// Where the surfaces touch.
    #[default]
    Contact,
    /// Where the path of the projectile's centre meets the target's surface: nearer to the middle, for a large projectile.
    Centre,
}

/// A validated impact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ImpactSettings {
    /// Indices of the bodies.
    pub target: usize,
    pub projectile: usize,
    /// Speed at contact, m/s.
    pub speed: f64,
    /// From the normal, rad.
    pub angle: f64,
    pub angle_at: AngleAt,
}

/// Numbers of the target and the projectile, unless the scene names them.
const USUAL: [usize; 2] = [0, 1];
const ANGLES: &str = "from 0 (head-on) to below 90 deg";

impl ImpactTable {
    /// The table with the names of both bodies, which default to the first and the second of `names`.
    pub fn complete(&self, names: &[&str]) -> Self {
        let mut complete = self.clone();
        let [first, second] = USUAL;
        if names.len() < 2 {
            return complete;
        }
        let target = complete.target.get_or_insert_with(|| names[first].into());
        let other = if names.iter().position(|name| *name == target.as_str()) == Some(second) { first } else { second };
        complete.projectile.get_or_insert_with(|| names[other].into());
        complete
    }

    /// Number of the body that the completed table names as the projectile.
    pub fn projectile(&self, names: &[&str]) -> Option<usize> {
        names.iter().position(|name| self.projectile.as_deref() == Some(*name))
    }

    /// The completed table's impact between bodies of these names.
    pub fn validate(&self, document: &Document, names: &[&str]) -> Result<ImpactSettings> {
        if names.len() < 2 {
            return Err(document.error("impact", "an impact needs two bodies, a target and a projectile"));
        }
        let find = |key: &str, name: &Option<String>| {
            let name = name.as_deref().unwrap_or_default();
            names.iter().position(|other| *other == name).ok_or_else(|| {
                let known: Vec<String> = names.iter().map(|name| name.to_string()).collect();
                unknown(document, &format!("impact.{key}"), "body", name, &known)
            })
        };
        let target = find("target", &self.target)?;
        let projectile = find("projectile", &self.projectile)?;
        if target == projectile {
            return Err(document.error("impact.projectile", "target and projectile are the same body"));
        }
        if self.speed.0 <= 0.0 {
            return Err(document.error("impact.speed", format!("speed is {}", self.speed)).allowed(POSITIVE));
        }
        if !(0.0..0.5 * PI).contains(&self.angle.0) {
            return Err(document.error("impact.angle", format!("angle is {}", self.angle)).allowed(ANGLES));
        }
        Ok(ImpactSettings { target, projectile, speed: self.speed.0, angle: self.angle.0, angle_at: self.angle_at })
    }

    /// What `refine` says, where it is on.
    pub fn refinement(&self) -> Option<&RefineTable> {
        self.refine.as_ref()?.0.as_ref()
    }
}

impl ImpactSettings {
    /// How far the path of a sphere passes beside the centre of another, m.
    fn aside(&self, r_t: f64, r_p: f64) -> f64 {
        let s = libm::sin(self.angle);
        match self.angle_at {
            AngleAt::Contact => s * (r_t + r_p),
            AngleAt::Centre => s * r_t,
        }
    }

    /// Where the surfaces touch first, from the target's centre, m: on a sphere, in the middle of the upper face, or where the axis along x
    /// leaves a shape without one.
    pub fn point(&self, target: &Body, projectile: &Body) -> [f64; 3] {
        if let BodyShape::Sphere { radius } = target.shape {
            let r_p = projectile.shape.outer_radius();
            let sine = self.aside(radius, r_p) / (radius + r_p);
            return [radius * (1.0 - sine * sine).sqrt(), radius * sine, 0.0];
        }
        if target.shape.is_round() {
            return [target.shape.end_along_x(target.dimension).unwrap_or_default(), 0.0, 0.0];
        }
        let (bounds, up) = (target.shape.bounds(target.dimension), target.dimension - 1);
        std::array::from_fn(|k| if k == up { bounds.middle[k] + bounds.half[k] } else { 0.0 })
    }

    /// The direction out of a target without an upper face from which the angle is measured: on a sphere the normal where the surfaces
    /// touch first, on other shapes the axis along x.
    pub fn outwards(&self, target: &Body, projectile: &Body) -> [f64; 3] {
        match &target.shape {
            BodyShape::Sphere { radius } => self.point(target, projectile).map(|x| x / radius),
            _ => [1.0, 0.0, 0.0],
        }
    }

    /// Centre and velocity of the projectile, `gap` (m) between the surfaces.
    pub fn place(&self, target: &Body, projectile: &Body, gap: f64) -> Result<([f64; 3], [f64; 3])> {
        let (s, c) = (libm::sin(self.angle), libm::cos(self.angle));
        match (&target.shape, &projectile.shape) {
            (&BodyShape::Sphere { radius: r_t }, &BodyShape::Sphere { radius: r_p }) => {
                let contact = r_t + r_p;
                let y = self.aside(r_t, r_p);
                let x = ((contact + gap) * (contact + gap) - y * y).sqrt();
                let [tx, ty, tz] = target.centre;
                Ok(([tx + x, ty + y, tz], [-self.speed, 0.0, 0.0]))
            }
            (BodyShape::Sphere { .. }, _) => {
                Err(Error::new("onto a sphere only a sphere can fall").allowed("a projectile with shape sphere"))
            }
            (shape, other) if shape.is_round() => {
                let Some(end) = shape.end_along_x(target.dimension) else {
                    let what = "the axis along x from the centre of the target does not meet it";
                    return Err(Error::new(what).allowed("a target with matter there"));
                };
                // From where a ball around the projectile would touch that point, back along the path until nothing overlaps.
                let path = [c, s, 0.0];
                let mut away = other.outer_radius() + gap;
                let around = BodyShape::Sphere { radius: away };
                loop {
                    let centre: [f64; 3] = std::array::from_fn(|k| path[k] * away + if k == 0 { end } else { 0.0 });
                    if !shape.overlaps([0.0; 3], &around, centre, target.dimension) {
                        let centre = std::array::from_fn(|k| target.centre[k] + centre[k]);
                        return Ok((centre, path.map(|x| -self.speed * x)));
                    }
                    away += 0.25 * gap;
                }
            }
            _ => {
                let up = target.dimension - 1;
                let top = |b: BoundingBox| b.middle[up] + b.half[up];
                let bottom = |b: BoundingBox| b.middle[up] - b.half[up];
                let height =
                    top(target.shape.bounds(target.dimension)) - bottom(projectile.shape.bounds(target.dimension));
                let (mut centre, mut velocity) = (target.centre, [0.0; 3]);
                centre[0] += gap * s / c;
                centre[up] += height + gap;
                velocity[0] = -self.speed * s;
                velocity[up] = -self.speed * c;
                Ok((centre, velocity))
            }
        }
    }
}
