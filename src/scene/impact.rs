//! Impact geometry. The target rests where the scene puts it; the projectile starts with one kernel support between the
//! surfaces.
//!
//! On a sphere the projectile flies along -x, displaced along +y by sin(angle) (R_t + R_p): at contact its velocity makes
//! `angle` with the line of centres. Where the angle is that of its centre's path with the surface that this path meets, it is
//! displaced by sin(angle) R_t: a large projectile then passes nearer, and less of it beside the target. On a flat target (box, cylinder, half sphere) it comes down on the middle of the
//! upper face (+z, in 2D +y) and flies towards -x, `angle` from the normal.

use serde::{Deserialize, Serialize};

use super::body::Body;
use super::lattice::Bounds;
use super::raw::{RawBody, RawImpact};
use super::shape::Shape;
use super::source::Document;
use crate::error::{Error, Result};
use crate::units::{Angle, Speed};

/// Where the angle of an impact onto a sphere is measured.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum AngleAt {
    /// Where the surfaces touch.
    #[default]
    Contact,
    /// Where the path of the projectile's centre meets the target's surface.
    Centre,
}

/// A validated impact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Impact {
    /// Indices of the bodies.
    pub target: usize,
    pub projectile: usize,
    /// Speed at contact, m/s.
    pub speed: f64,
    /// From the normal, rad.
    pub angle: f64,
    pub angle_at: AngleAt,
}

impl Impact {
    /// Finds the bodies, which default to the first and the second, and writes their names into `raw`.
    pub fn read(document: &Document, raw: &mut RawImpact, bodies: &[RawBody]) -> Result<Self> {
        if bodies.len() < 2 {
            return Err(document.error("impact", "an impact needs two bodies, a target and a projectile"));
        }
        let find = |key: &str, name: &mut Option<String>, default: usize| {
            let name = name.get_or_insert_with(|| bodies[default].name.clone());
            bodies.iter().position(|b| b.name == *name).ok_or_else(|| {
                let known: Vec<String> = bodies.iter().map(|b| b.name.clone()).collect();
                super::keys::unknown(document, &format!("impact.{key}"), "body", name, &known)
            })
        };
        let target = find("target", &mut raw.target, 0)?;
        let projectile = find("projectile", &mut raw.projectile, if target == 1 { 0 } else { 1 })?;
        if target == projectile {
            return Err(document.error("impact.projectile", "target and projectile are the same body"));
        }
        if raw.speed.0 <= 0.0 {
            let what = format!("speed is {}", Speed::new(raw.speed.0));
            return Err(document.error("impact.speed", what).allowed("more than 0"));
        }
        if !(0.0..0.5 * std::f64::consts::PI).contains(&raw.angle.0) {
            let what = format!("angle is {}", Angle(raw.angle.0));
            return Err(document.error("impact.angle", what).allowed("from 0 (head-on) to below 90 deg"));
        }
        Ok(Self { target, projectile, speed: raw.speed.0, angle: raw.angle.0, angle_at: raw.angle_at })
    }

    /// How far the path of a sphere passes beside the centre of another, m.
    fn aside(&self, r_t: f64, r_p: f64) -> f64 {
        let s = libm::sin(self.angle);
        match self.angle_at {
            AngleAt::Contact => s * (r_t + r_p),
            AngleAt::Centre => s * r_t,
        }
    }

    /// Where the surfaces touch first, from the target's centre, m: on a sphere, or in the middle of the upper face.
    pub fn point(&self, target: &Body, projectile: &Body) -> [f64; 3] {
        if let Shape::Sphere { radius } = target.shape {
            let r_p = projectile.shape.outer_radius();
            let sine = self.aside(radius, r_p) / (radius + r_p);
            return [radius * (1.0 - sine * sine).sqrt(), radius * sine, 0.0];
        }
        let (bounds, up) = (target.shape.bounds(target.dimension), target.dimension - 1);
        std::array::from_fn(|k| if k == up { bounds.middle[k] + bounds.half[k] } else { 0.0 })
    }

    /// Centre and velocity of the projectile, `gap` (m) between the surfaces.
    pub fn place(&self, target: &Body, projectile: &Body, gap: f64) -> Result<([f64; 3], [f64; 3])> {
        let (s, c) = (libm::sin(self.angle), libm::cos(self.angle));
        match (target.shape, projectile.shape) {
            (Shape::Sphere { radius: r_t }, Shape::Sphere { radius: r_p }) => {
                let contact = r_t + r_p;
                let y = self.aside(r_t, r_p);
                let x = ((contact + gap) * (contact + gap) - y * y).sqrt();
                let [tx, ty, tz] = target.centre;
                Ok(([tx + x, ty + y, tz], [-self.speed, 0.0, 0.0]))
            }
            (Shape::Sphere { .. }, _) => {
                Err(Error::new("onto a sphere only a sphere can fall").allowed("a projectile with shape sphere"))
            }
            _ => {
                let up = target.dimension - 1;
                let top = |b: Bounds| b.middle[up] + b.half[up];
                let bottom = |b: Bounds| b.middle[up] - b.half[up];
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
