//! `[nbody]`: whether the run ends with bodies that an N-body program can go on with.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::Result;
use crate::scene::document::source::Document;

/// What an impact in 3D, onto no ground, has left at the end of the run, as bodies for an N-body program.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct NbodySettings {
    /// Least number of particles of a body.
    #[schemars(range(min = FROM_ONE))]
    pub smallest: u64,
    /// Largest number of bodies, the most massive ones.
    #[schemars(range(min = FROM_ONE))]
    pub most: u64,
}

const FROM_ONE: u64 = 1;

impl Default for NbodySettings {
    fn default() -> Self {
        Self { smallest: 1, most: 100_000 }
    }
}

impl NbodySettings {
    /// `remnants`: whether the scene is an impact that leaves any.
    pub fn validate(self, document: &Document, dimension: usize, remnants: bool) -> Result<Self> {
        if dimension != 3 || !remnants {
            let what = "there are no remnants to be handed on";
            return Err(document.error("nbody", what).allowed("an impact in three dimensions, onto no ground"));
        }
        for (key, value) in [("smallest", self.smallest), ("most", self.most)] {
            if value < FROM_ONE {
                return Err(document
                    .error(&format!("nbody.{key}"), "0 is too few")
                    .allowed(format!("{FROM_ONE} and more")));
            }
        }
        Ok(self)
    }
}
