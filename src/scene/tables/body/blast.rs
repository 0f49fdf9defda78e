//! `blast` of a body: heat in its middle at the start.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::Result;
use crate::kernel::{Kernel, SUPPORT};
use crate::scene::document::source::Document;
use crate::scene::values::checks::{POSITIVE, positive};
use crate::units::{Energy, Length};

/// Heat in the middle at the start, spread like the cubic spline; the sum is exact.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BlastTable {
    /// Internal energy in all (in 2D per metre of depth).
    #[schemars(extend("x-allowed" = POSITIVE))]
    energy: Energy,
    /// Distance from the centre at which nothing of it is left.
    #[schemars(extend("x-allowed" = POSITIVE))]
    radius: Length,
}

/// Energy put into the middle of a body at the start: spread like the cubic spline of this radius, the sum exact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Blast {
    /// J (per metre of depth in 2D).
    pub energy: f64,
    /// Where nothing of it is left, m.
    pub radius: f64,
}

impl Blast {
    /// Smoothing length of the cubic spline that spreads it, m.
    pub fn smoothing_length(&self) -> f64 {
        self.radius / SUPPORT
    }

    /// Energy per volume in the middle, J/m^3.
    pub fn peak(&self, dimension: usize) -> f64 {
        self.energy * Kernel::CubicSpline.value(0.0, self.smoothing_length(), dimension)
    }
}

impl BlastTable {
    pub fn validate(&self, document: &Document, path: &str) -> Result<Blast> {
        Ok(Blast {
            energy: positive(document, &format!("{path}.energy"), self.energy)?,
            radius: positive(document, &format!("{path}.radius"), self.radius)?,
        })
    }
}
