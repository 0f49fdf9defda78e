//! All tables of a scene as they are written. Completed and printed as TOML they are the scene as understood.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::material::{MaterialTable, Records};
use crate::scene::tables::body::table::BodyTable;
use crate::scene::tables::compare::CompareTable;
use crate::scene::tables::domain::DomainTable;
use crate::scene::tables::gravity::GravityTable;
use crate::scene::tables::impacts::deposit::DepositTable;
use crate::scene::tables::impacts::fragments::FragmentsTable;
use crate::scene::tables::impacts::impact::ImpactTable;
use crate::scene::tables::impacts::intrusion::IntrusionTable;
use crate::scene::tables::impacts::late_stage::LateStageTable;
use crate::scene::tables::impacts::nbody::NbodySettings;
use crate::scene::tables::impacts::outcome::OutcomeTable;
use crate::scene::tables::impacts::restitution::RestitutionTable;
use crate::scene::tables::impacts::threshold::ThresholdTable;
use crate::scene::tables::numerics::NumericsTable;
use crate::scene::tables::output::OutputTable;
use crate::scene::tables::regions::layer::LayerTable;
use crate::scene::tables::regions::probe::ProbeTable;
use crate::scene::tables::run::RunTable;
use crate::scene::tables::two_rates::TwoRatesTable;

/// The dimensions that a scene may have.
pub const DIMENSIONS: [u8; 2] = [2, 3];

/// A scene.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SceneTables {
    /// What figures and files call the scene.
    #[serde(default)]
    pub title: String,
    /// 3, or 2: plane strain, masses per metre of depth, vectors of two components.
    #[serde(default = "three")]
    #[schemars(extend("enum" = DIMENSIONS))]
    #[schemars(range(min = 2, max = 3))]
    pub dimension: u8,
    /// One table per body.
    #[serde(default)]
    pub body: Vec<BodyTable>,
    /// One table per layer.
    #[serde(default)]
    pub layer: Vec<LayerTable>,
    pub impact: Option<ImpactTable>,
    pub intrusion: Option<IntrusionTable>,
    pub restitution: Option<RestitutionTable>,
    pub fragments: Option<FragmentsTable>,
    pub deposit: Option<DepositTable>,
    #[serde(default)]
    pub domain: DomainTable,
    pub gravity: Option<GravityTable>,
    /// One table per material that is not taken from the library as it stands there, by its name.
    #[serde(default)]
    pub material: BTreeMap<String, MaterialTable>,
    #[serde(default)]
    pub numerics: NumericsTable,
    #[serde(default)]
    pub run: RunTable,
    pub two_rates: Option<TwoRatesTable>,
    pub late_stage: Option<LateStageTable>,
    #[serde(default)]
    pub output: OutputTable,
    #[serde(default)]
    pub record: Records,
    pub threshold: Option<ThresholdTable>,
    pub compare: Option<CompareTable>,
    pub outcome: Option<OutcomeTable>,
    pub nbody: Option<NbodySettings>,
    /// One table per probe.
    #[serde(default)]
    pub probe: Vec<ProbeTable>,
}

fn three() -> u8 {
    3
}

impl SceneTables {
    /// Names of the bodies.
    pub fn body_names(&self) -> Vec<&str> {
        self.body.iter().map(|body| body.name.as_str()).collect()
    }
}
