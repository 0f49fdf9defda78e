//! `rigid` of a body: it does not deform, and moves as a whole.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::table::{BodyTable, InitialState};
use crate::error::Result;
use crate::material::MaterialTable;
use crate::motion::PrescribedMotion;
use crate::motion::rigid::Guidance;
use crate::scene::document::source::Document;
use crate::scene::values::checks::POSITIVE;
use crate::units::Speed;

/// A body that does not deform.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RigidTable {
    /// Speed of sound of its contact with other rigid bodies: the faster, the less they overlap, and the shorter the steps while
    /// they touch. It does not enter what it does to matter that deforms.
    #[schemars(extend("x-allowed" = POSITIVE))]
    #[schemars(extend("x-default" = "the fastest sound in matter that deforms; without any, 20 times the fastest motion at the start"))]
    pub sound_speed: Option<Speed>,
    /// Whether it turns.
    #[schemars(extend("x-default" = "true, but with a `motion` false"))]
    pub rotation: Option<bool>,
}

/// A validated rigid body; SI.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Rigid {
    /// m/s.
    pub sound_speed: f64,
    pub rotation: bool,
}

/// Speed of sound of the contact over the fastest motion, where no matter deforms.
const FASTER_THAN_MOTION: f64 = 20.0;

/// What the speed of a contact follows from, where a scene does not give it, m/s.
#[derive(Debug, Clone, Copy, Default)]
pub struct Speeds {
    /// Fastest sound in matter that deforms.
    pub sound: f64,
    /// Fastest motion.
    pub motion: f64,
}

impl RigidTable {
    /// The table with what follows from the scene, as far as it does. `held`: the body has a motion of its own.
    pub fn complete(&self, speeds: Speeds, held: bool) -> Self {
        let found = if speeds.sound > 0.0 { speeds.sound } else { FASTER_THAN_MOTION * speeds.motion };
        let usable = found > 0.0 && found.is_finite();
        Self {
            sound_speed: self.sound_speed.or(usable.then(|| Speed::new(found))),
            rotation: self.rotation.or(Some(!held)),
        }
    }

    /// The rigid body of the completed table `body`, whose key path is `path`.
    pub fn validate(
        &self,
        document: &Document,
        path: &str,
        body: &BodyTable,
        material: &MaterialTable,
    ) -> Result<Rigid> {
        let refused = [
            ("material", material.reference_density().is_none(), "a gas is no rigid body", "a solid"),
            ("flow", body.flow.is_some(), "a rigid body does not deform", "velocity and spin"),
            ("blast", body.blast.is_some(), "a rigid body is not driven apart by heat", "no blast"),
            ("joints", body.joints.is_some(), "a rigid body does not break", "no joints"),
            ("damage", body.damage.is_some_and(|d| d.0 != 0.0), "a rigid body does not break", "no damage"),
            (
                "start",
                body.start != InitialState::Unloaded,
                "a rigid body does not yield to its weight",
                "\"unloaded\"",
            ),
        ];
        if let Some((key, _, what, allowed)) = refused.into_iter().find(|(_, refused, ..)| *refused) {
            return Err(document.error(&format!("{path}.{key}"), what).allowed(allowed));
        }
        let key = format!("{path}.rigid.sound_speed");
        let Some(sound_speed) = self.sound_speed else {
            let what = "key `sound_speed` is missing: nothing moves or deforms that it could follow from";
            return Err(document.error(&key, what).allowed("a speed well above that of the bodies"));
        };
        if !(sound_speed.0 > 0.0 && sound_speed.0.is_finite()) {
            return Err(document.error(&key, format!("sound_speed is {sound_speed}")).allowed(POSITIVE));
        }
        let rotation = self.rotation.unwrap_or(body.motion.is_none());
        if !rotation && body.spin.as_ref().is_some_and(|spin| spin.0.iter().any(|w| w.0 != 0.0)) {
            let what = "the body has a spin, but does not turn";
            return Err(document
                .error(&format!("{path}.spin"), what)
                .allowed("rigid = { rotation = true }, or no spin"));
        }
        Ok(Rigid { sound_speed: sound_speed.0, rotation })
    }
}

impl Rigid {
    /// How a body with this prescribed motion moves.
    pub fn guidance(&self, motion: PrescribedMotion) -> Guidance {
        Guidance { motion, rotation: self.rotation }
    }
}
