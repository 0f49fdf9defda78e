//! `[nbody]`: whether the run ends with bodies that an N-body program can go on with.

use serde::{Deserialize, Serialize};

use super::source::Document;
use crate::error::Result;

/// What becomes a body.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Nbody {
    /// Least number of particles.
    pub smallest: u64,
    /// Largest number of bodies.
    pub most: u64,
}

impl Default for Nbody {
    fn default() -> Self {
        Self { smallest: 1, most: 100_000 }
    }
}

impl Nbody {
    /// `remnants`: whether the scene is an impact that leaves any.
    pub(super) fn validate(self, document: &Document, dimension: usize, remnants: bool) -> Result<Self> {
        if dimension != 3 || !remnants {
            let what = "there are no remnants to be handed on";
            return Err(document.error("nbody", what).allowed("an impact in three dimensions, onto no ground"));
        }
        for (key, value) in [("smallest", self.smallest), ("most", self.most)] {
            if value == 0 {
                return Err(document.error(&format!("nbody.{key}"), "0 is too few").allowed("1 and more"));
            }
        }
        Ok(self)
    }
}
