//! `[compare]`: the exact solution that a scene is compared with. Its parameters are those of the scene.

use serde::{Deserialize, Serialize};

use super::boundaries::RawInterval;
use super::source::Document;
use crate::error::Result;
use crate::units::{Length, Time};

#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawCompare {
    with: Solution,
    within: Option<RawInterval>,
    core: Option<Length>,
    after: Option<Time>,
}

/// The solutions there are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
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
    /// The same, when the shock has left through the target's free surface.
    Release,
    /// A body with `flow.wave`.
    StandingWave,
    /// A body with `flow.mode`.
    Vibration,
    /// A body with a `spin`.
    Rotation,
    /// Matter under gravity that has nothing to do but to rest.
    Rest,
}

/// A validated comparison.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Compare {
    pub with: Solution,
    /// Stretch of the solution's coordinate (x of the scene, or the distance from the centre) that counts, m.
    pub within: [f64; 2],
    /// Largest distance from the coordinate's axis that counts, m.
    pub core: Option<f64>,
    /// Time from which on counts whether matter rests, s.
    pub after: f64,
}

impl RawCompare {
    pub(super) fn validate(&self, document: &Document) -> Result<Compare> {
        let within = match self.within {
            None => [f64::MIN, f64::MAX],
            Some(ends) => super::boundaries::interval(document, "compare.within", ends)?,
        };
        let core = match self.core {
            Some(core) if core.0 <= 0.0 => {
                return Err(document.error("compare.core", format!("core is {core}")).allowed("more than 0"));
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
        Ok(Compare { with: self.with, within, core, after })
    }
}
