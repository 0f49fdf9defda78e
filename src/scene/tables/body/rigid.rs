//! `rigid` of a body: it does not deform, and moves as a whole.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::motion::PrescribedMotion;
use crate::motion::rigid::Guidance;
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
    /// Whether matter that deforms sticks to it: then tension acts across the contact as inside that matter; without, the body pushes
    /// and does not pull.
    #[serde(default)]
    pub adhesion: bool,
}

/// A validated rigid body; SI.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Rigid {
    /// m/s.
    pub sound_speed: f64,
    pub rotation: bool,
    pub adhesion: bool,
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
            adhesion: self.adhesion,
        }
    }
}

impl Rigid {
    /// How a body with this prescribed motion moves.
    pub fn guidance(&self, motion: PrescribedMotion) -> Guidance {
        Guidance { motion, rotation: self.rotation }
    }
}
