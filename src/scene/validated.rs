//! A scene as the rest of the program knows it, and what follows from it for an impact.

use serde::{Deserialize, Serialize};

use super::document::source::{Document, SourceText};
use super::geometry::shape::BodyShape;
use super::tables::body::validated::Body;
use super::tables::compare::ComparisonSettings;
use super::tables::gravity::GravitySettings;
use super::tables::impacts::deposit::DepositSettings;
use super::tables::impacts::fragments::FragmentsSettings;
use super::tables::impacts::impact::ImpactSettings;
use super::tables::impacts::intrusion::IntrusionSettings;
use super::tables::impacts::late_stage::LateStageSettings;
use super::tables::impacts::nbody::NbodySettings;
use super::tables::impacts::outcome::OutcomeSettings;
use super::tables::impacts::restitution::RestitutionSettings;
use super::tables::impacts::threshold::ThresholdSettings;
use super::tables::numerics::NumericsSettings;
use super::tables::output::OutputSettings;
use super::tables::regions::layer::Layer;
use super::tables::regions::probe::Probe;
use super::tables::run::{RunSettings, Until};
use super::tables::two_rates::TwoRates;
use crate::error::Error;
use crate::material::late::Softening;
use crate::material::{Late, MaterialTable, Records};
use crate::particles::Periods;

/// A validated scene; all numbers in SI.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Scene {
    pub title: String,
    /// 2 or 3.
    pub dimension: usize,
    pub bodies: Vec<Body>,
    pub layers: Vec<Layer>,
    pub periods: Periods,
    pub gravity: GravitySettings,
    pub materials: Vec<MaterialTable>,
    pub material_names: Vec<String>,
    pub impact: Option<ImpactSettings>,
    pub intrusion: Option<IntrusionSettings>,
    pub restitution: Option<RestitutionSettings>,
    pub fragments: Option<FragmentsSettings>,
    pub deposit: Option<DepositSettings>,
    pub numerics: NumericsSettings,
    pub run: RunSettings,
    pub two_rates: Option<TwoRates>,
    pub late_stage: Option<LateStageSettings>,
    pub output: OutputSettings,
    pub record: Records,
    pub threshold: Option<ThresholdSettings>,
    pub compare: Option<ComparisonSettings>,
    pub outcome: Option<OutcomeSettings>,
    pub probes: Vec<Probe>,
    pub nbody: Option<NbodySettings>,
    /// The completed tables, printed.
    pub(super) understood: String,
    pub(super) source: SourceText,
}

/// The upper face of a target that an impact comes down on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TargetFace {
    /// Where the projectile hits, in the middle, m.
    pub middle: [f64; 3],
    /// The axis that points out of it: z, in 2D y.
    pub up: usize,
}

impl Scene {
    /// The scene as understood: every default spelt out, library values included. Reads back to the same scene.
    pub fn to_toml(&self) -> String {
        self.understood.clone()
    }

    /// The file the scene was read from.
    pub fn path(&self) -> &str {
        &self.source.path
    }

    /// An error at a key: `body.0.flow.mode`.
    pub fn error(&self, path: &str, what: impl Into<String>) -> Error {
        let place = Document::parse(&self.source).map_or(self.path().to_string(), |document| document.place(path));
        Error::new(what).at(place).bad_input()
    }

    /// The matter of each body in the late stage; none without one.
    pub fn late(&self) -> Option<Late> {
        let stage = self.late_stage.as_ref()?;
        let softening = |body: &Body| {
            let material = &self.materials[body.material];
            Softening::new(material, stage.modulus(material)?)
        };
        self.bodies.iter().map(softening).collect::<Option<Vec<_>>>().map(Late)
    }

    /// Whether the run goes on until gravity has brought together what it will: its end, where that is not a time.
    pub fn reaccumulates(&self) -> bool {
        self.run.until == Until::Settled && self.gravity.own.is_some() && !self.hits_ground()
    }

    /// The face that the impact comes down on; none where it meets a sphere, or there is no impact.
    pub fn face(&self) -> Option<TargetFace> {
        let target = &self.bodies[self.impact.as_ref()?.target];
        if !target.shape.has_upper_face() {
            return None;
        }
        let bounds = target.shape.bounds(target.dimension);
        let (mut middle, up) = (target.centre, target.dimension - 1);
        middle[up] += bounds.middle[up] + bounds.half[up];
        Some(TargetFace { middle, up })
    }

    /// The body at the point of impact: the target, or the finest of its parts.
    pub fn at_impact(&self) -> Option<usize> {
        let target = self.impact.as_ref()?.target;
        let finer = |body: &usize| self.bodies[*body].cut.is_some_and(|cut| cut.body == target);
        (target + 1..self.bodies.len()).find(finer).or(Some(target))
    }

    /// The direction into the target where it is hit, along the normal, and the momentum that the projectile brings along it, kg m/s; none
    /// where there is no impact, or onto a flat face (see `outcome::crater`).
    pub fn impulse_on_body(&self) -> Option<([f64; 3], f64)> {
        let impact = self.impact.as_ref().filter(|_| self.face().is_none())?;
        let (target, projectile) = (&self.bodies[impact.target], &self.bodies[impact.projectile]);
        let inwards = impact.outwards(target, projectile).map(|n| -n);
        let speed: f64 = inwards.iter().zip(projectile.velocity).map(|(n, v)| n * v).sum();
        Some((inwards, projectile.whole_mass() * speed))
    }

    /// Whether the target stands for ground that goes on beyond its ends: a half sphere, or what has a layer at its outer
    /// faces. Then it has no remnants.
    pub fn hits_ground(&self) -> bool {
        let Some(impact) = self.impact.as_ref() else { return false };
        let cut_off = |layer: &Layer| layer.outer.is_some() && layer.region.body == Some(impact.target);
        let shape = &self.bodies[impact.target].shape;
        matches!(shape, BodyShape::HalfSphere { .. }) || shape.has_upper_face() && self.layers.iter().any(cut_off)
    }
}
