//! `[compare]`: the exact solution that a scene is compared with. Its parameters are those of the scene.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::Result;
use crate::scene::document::source::Document;
use crate::scene::values::axis::{Interval, interval};
use crate::scene::values::checks::POSITIVE;
use crate::units::{Length, Time};

/// The exact solution that the scene is compared with at its end; its parameters are those of the scene.
#[derive(Debug, Clone, Copy, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompareTable {
    /// The solution.
    with: Solution,
    /// Stretch of the solution's coordinate (x, or the distance from the centre) that counts; everything without it.
    within: Option<Interval>,
    /// Only what is this near to the coordinate's axis counts, for `"piston"`; everything without it.
    #[schemars(extend("x-allowed" = POSITIVE))]
    core: Option<Length>,
    /// When speeds begin to count, for `"rest"`; from the start without it.
    after: Option<Time>,
}

/// The solutions there are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Solution {
    /// Two bodies of the same ideal gas that touch in a plane across x.
    Riemann,
    /// A body of ideal gas with a `blast`.
    Blast,
    /// A body of cold ideal gas that flows towards its centre (`flow.radial`).
    Implosion,
    /// A body, or a layer of one, with a prescribed velocity along one axis drives a solid.
    Piston,
    /// Two bodies meet in a plane across x.
    Impact,
    /// Two bodies have met in a plane across x, and the shock has left through the target's free surface.
    Release,
    /// A body with `flow.wave`; in a fluid that moves across, what is left of it.
    StandingWave,
    /// A body with `flow.vortex`.
    Vortex,
    /// A body with `flow.streams`: growth of the wave on their layer, as of an incompressible fluid.
    ShearLayer,
    /// A body with `flow.mode`.
    Vibration,
    /// A body with a `spin`.
    Rotation,
    /// Matter at rest under gravity.
    Rest,
}

/// A validated comparison.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ComparisonSettings {
    pub with: Solution,
    /// Stretch of the solution's coordinate (x of the scene, or the distance from the centre) that counts, m.
    pub within: [f64; 2],
    /// Largest distance from the coordinate's axis that counts, m.
    pub core: Option<f64>,
    /// Time from which on counts whether matter rests, s.
    pub after: f64,
}

impl CompareTable {
    pub fn validate(&self, document: &Document) -> Result<ComparisonSettings> {
        let within = match self.within {
            None => [f64::MIN, f64::MAX],
            Some(ends) => interval(document, "compare.within", ends)?,
        };
        let core = match self.core {
            Some(core) if core.0 <= 0.0 => {
                return Err(document.error("compare.core", format!("core is {core}")).allowed(POSITIVE));
            }
            core => core.map(|core| core.0),
        };
        let after = match self.after {
            Some(after) if after.0 < 0.0 || self.with != Solution::Rest => {
                let what = format!("after {after} with {:?}", self.with).to_lowercase();
                return Err(document.error("compare.after", what).allowed("0 or more, with \"rest\""));
            }
            after => after.map_or(0.0, |after| after.0),
        };
        Ok(ComparisonSettings { with: self.with, within, core, after })
    }
}
