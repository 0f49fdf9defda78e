//! `[late_stage]`: once the shock has left, matter becomes softer, so that steps grow (see `material::late`).

use std::f64::consts::PI;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::Result;
use crate::gravity::G;
use crate::material::MaterialTable;
use crate::scene::document::source::Document;
use crate::scene::tables::body::validated::Body;
use crate::scene::tables::gravity::GravitySettings;
use crate::scene::tables::run::{RunSettings, Until, UntilValue};
use crate::scene::values::checks::{POSITIVE, positive};
use crate::units::{Pressure, Speed};

/// Largest share of its volume by which a body's own weight may press soft matter together.
const MOST_SQUEEZED: f64 = 0.1;

/// Softer matter once the shock has left, so that steps grow.
#[derive(Debug, Clone, Copy, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LateStageTable {
    /// When matter becomes softer: a time, or `"settled"`, for impacts, when the shock has left.
    at: UntilValue,
    /// Bulk speed of sound of the matrix of every material from then on; this or `bulk_modulus`.
    #[schemars(extend("x-allowed" = POSITIVE))]
    sound_speed: Option<Speed>,
    /// Bulk modulus of the matrix of every material from then on; this or `sound_speed`.
    #[schemars(extend("x-allowed" = POSITIVE))]
    bulk_modulus: Option<Pressure>,
}

/// When matter becomes softer, and how soft.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct LateStageSettings {
    pub at: Until,
    pub softness: Softness,
}

/// Softness of the matrix of every material.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Softness {
    /// Bulk speed of sound, m/s.
    SoundSpeed(f64),
    /// Pa.
    BulkModulus(f64),
}

impl LateStageSettings {
    /// Bulk modulus of a material in the late stage, Pa; none for a gas.
    pub fn modulus(&self, material: &MaterialTable) -> Option<f64> {
        match self.softness {
            Softness::SoundSpeed(c) => Some(material.reference_density()? * c * c),
            Softness::BulkModulus(modulus) => Some(modulus),
        }
    }
}

/// What the end of a run and the matter in it allow.
pub struct Surroundings<'a> {
    pub run: &'a RunSettings,
    pub impact: bool,
    pub gravity: &'a GravitySettings,
    pub bodies: &'a [Body],
    pub materials: &'a [MaterialTable],
    pub names: &'a [String],
}

impl LateStageTable {
    pub fn validate(&self, document: &Document, around: &Surroundings) -> Result<LateStageSettings> {
        let softness = match (self.sound_speed, self.bulk_modulus) {
            (Some(c), None) => Softness::SoundSpeed(positive(document, "late_stage.sound_speed", c)?),
            (None, Some(a)) => Softness::BulkModulus(positive(document, "late_stage.bulk_modulus", a)?),
            (None, None) => {
                let error = document.error("late_stage", "it does not say how soft matter becomes");
                return Err(error.allowed("sound_speed = \"100 m/s\", or a bulk_modulus"));
            }
            (Some(_), Some(_)) => {
                let error = document.error("late_stage.bulk_modulus", "there is a sound_speed, too");
                return Err(error.allowed("one of them"));
            }
        };
        let stage = LateStageSettings { at: self.beginning(document, around)?, softness };
        stage.check_matter(document, around)?;
        Ok(stage)
    }

    fn beginning(&self, document: &Document, around: &Surroundings) -> Result<Until> {
        let path = "late_stage.at";
        let at = self.at.validate(document, path, around.impact)?;
        match (at, around.run.until) {
            (Until::Time(at), Until::Time(end)) if at >= end => {
                let what = format!("the run ends at {end} s, before the late stage begins");
                Err(document.error(path, what).allowed("a time before run.until"))
            }
            (_, Until::Settled) if around.gravity.own.is_none() => {
                let what = "without gravity of the particles nothing shows when the late stage is over";
                Err(document.error("run.until", what).allowed("a time, or [gravity] self = true"))
            }
            _ => Ok(at),
        }
    }
}

impl LateStageSettings {
    /// Matter must become softer, and bear its own weight still.
    fn check_matter(&self, document: &Document, around: &Surroundings) -> Result<()> {
        let path = match self.softness {
            Softness::SoundSpeed(_) => "late_stage.sound_speed",
            Softness::BulkModulus(_) => "late_stage.bulk_modulus",
        };
        for body in around.bodies {
            let (material, name) = (&around.materials[body.material], &around.names[body.material]);
            if material.is_dust() {
                let what = format!("{name} is dust, whose modulus follows from its density");
                return Err(document.error("late_stage", what).allowed("no dust"));
            }
            let stiff = material.eos.law().bulk_modulus().zip(self.modulus(material));
            let Some((before, after)) = stiff else {
                let what = format!("{name} is a gas, which has no bulk modulus to be lowered");
                return Err(document.error("late_stage", what).allowed("solids"));
            };
            if after >= before {
                let what = format!("{name} would not become softer: {after:.3e} Pa instead of {before:.3e} Pa");
                return Err(document.error(path, what).allowed("a smaller value"));
            }
            if around.gravity.own.is_none() {
                continue;
            }
            // 2/3 pi G rho^2 R^2, of which the matrix bears alpha times as much.
            let radius = body.shape.outer_radius();
            let middle = 2.0 / 3.0 * PI * G * (body.density * radius).powi(2) * body.distention;
            let least = middle / MOST_SQUEEZED;
            if after < least {
                let sound = (least / (body.density * body.distention)).sqrt();
                let what = format!(
                    "the weight of body \"{}\" would press soft matter together by {:.0} % in its middle",
                    body.name,
                    100.0 * middle / after
                );
                let allowed = format!("{least:.3e} Pa and above, a speed of sound of {sound:.1} m/s");
                return Err(document.error(path, what).allowed(allowed));
            }
        }
        Ok(())
    }
}
