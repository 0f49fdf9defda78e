//! What a scene asks about itself beyond what follows from its kind: `[outcome]` of impacts onto ground, `[[probe]]`.

use serde::{Deserialize, Serialize};

use super::Scene;
use super::body::Body;
use super::boundaries::{Part, RawInterval, part};
use super::impact::Impact;
use super::settings::positive;
use super::shape::Shape;
use super::source::Document;
use crate::error::Result;
use crate::units::Speed;

/// `[outcome]`
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawAsked {
    ejection_speed: Speed,
}

/// What is asked about an impact onto ground.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Asked {
    /// Upward speed from which on matter counts as ejected, m/s.
    pub ejection_speed: f64,
}

impl RawAsked {
    pub(super) fn validate(&self, document: &Document, impact: Option<&Impact>, bodies: &[Body]) -> Result<Asked> {
        if !impact.is_some_and(|impact| bodies[impact.target].shape.has_upper_face()) {
            let what = "ejecta rise from a flat face, and no [impact] of this scene meets one";
            return Err(document
                .error("outcome", what)
                .allowed("an impact onto a target with shape half_sphere, box or cylinder"));
        }
        let ejection_speed =
            positive(document, "outcome.ejection_speed", self.ejection_speed.0, Speed::new(self.ejection_speed.0))?;
        Ok(Asked { ejection_speed })
    }
}

/// `[[probe]]`: a part of bodies, by where particles start, whose means go into history.csv.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawProbe {
    name: String,
    /// All without it.
    body: Option<String>,
    x: Option<RawInterval>,
    y: Option<RawInterval>,
    z: Option<RawInterval>,
}

/// A validated probe.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Probe {
    pub name: String,
    pub part: Part,
}

impl RawProbe {
    pub(super) fn validate(&self, document: &Document, number: usize, bodies: &[Body]) -> Result<Probe> {
        let path = format!("probe.{number}");
        let is_plain = |c: char| c.is_ascii_alphanumeric() || c == '_';
        if self.name.is_empty() || !self.name.chars().all(is_plain) {
            let what = format!("\"{}\" cannot name columns of history.csv", self.name);
            return Err(document.error(&format!("{path}.name"), what).allowed("letters, digits and _"));
        }
        let part = part(document, &path, (self.body.as_ref(), [self.x, self.y, self.z]), bodies)?;
        Ok(Probe { name: self.name.clone(), part })
    }
}

/// Each probe has columns of its own in history.csv.
pub(super) fn check_names(document: &Document, probes: &[Probe]) -> Result<()> {
    for (number, probe) in probes.iter().enumerate() {
        if probes[..number].iter().any(|other| other.name == probe.name) {
            let what = format!("two probes are named \"{}\"", probe.name);
            return Err(document
                .error(&format!("probe.{number}.name"), what)
                .allowed("a name for each: it names columns"));
        }
    }
    Ok(())
}

/// The upper face of a target that an impact comes down on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Face {
    /// Where the projectile hits, in the middle, m.
    pub middle: [f64; 3],
    /// The axis that points out of it: z, in 2D y.
    pub up: usize,
}

impl Scene {
    /// The face that the impact comes down on; none where it meets a sphere, or there is no impact.
    pub fn face(&self) -> Option<Face> {
        let target = &self.bodies[self.impact.as_ref()?.target];
        if !target.shape.has_upper_face() {
            return None;
        }
        let bounds = target.shape.bounds(target.dimension);
        let (mut middle, up) = (target.centre, target.dimension - 1);
        middle[up] += bounds.middle[up] + bounds.half[up];
        Some(Face { middle, up })
    }

    /// The body at the point of impact: the target, or the finest of its parts.
    pub fn at_impact(&self) -> Option<usize> {
        let target = self.impact.as_ref()?.target;
        let finer = |body: &usize| self.bodies[*body].whole(*body) == target;
        (target + 1..self.bodies.len()).find(finer).or(Some(target))
    }

    /// Whether the target stands for ground that goes on beyond its ends: a half sphere, or what has a layer at its outer
    /// faces. Then it has no remnants.
    pub fn hits_ground(&self) -> bool {
        let Some(impact) = self.impact.as_ref() else { return false };
        let cut_off = |layer: &super::Layer| layer.outer.is_some() && layer.part.body == Some(impact.target);
        let shape = &self.bodies[impact.target].shape;
        matches!(shape, Shape::HalfSphere { .. }) || shape.has_upper_face() && self.layers.iter().any(cut_off)
    }
}
