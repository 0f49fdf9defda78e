//! `[outcome]`: what is asked about an impact onto ground.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::impact::ImpactSettings;
use crate::error::Result;
use crate::scene::document::source::Document;
use crate::scene::tables::body::validated::Body;
use crate::scene::values::checks::{POSITIVE, positive};
use crate::units::Speed;

/// What is asked about an impact onto a flat face.
#[derive(Debug, Clone, Copy, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OutcomeTable {
    /// Upward speed from which on matter counts as ejected.
    #[schemars(extend("x-allowed" = POSITIVE))]
    ejection_speed: Speed,
}

/// What is asked about an impact onto ground.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct OutcomeSettings {
    /// Upward speed from which on matter counts as ejected, m/s.
    pub ejection_speed: f64,
}

impl OutcomeTable {
    pub fn validate(
        &self,
        document: &Document,
        impact: Option<&ImpactSettings>,
        bodies: &[Body],
    ) -> Result<OutcomeSettings> {
        if !impact.is_some_and(|impact| bodies[impact.target].shape.has_upper_face()) {
            let what = "ejecta rise from a flat face, and no [impact] of this scene meets one";
            return Err(document
                .error("outcome", what)
                .allowed("an impact onto a target with shape half_sphere, box or cylinder"));
        }
        Ok(OutcomeSettings { ejection_speed: positive(document, "outcome.ejection_speed", self.ejection_speed)? })
    }
}
