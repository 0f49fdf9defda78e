//! `[run]`: how long to run, and how often to save.

use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::error::Result;
use crate::scene::document::source::Document;
use crate::scene::values::checks::{POSITIVE, positive};
use crate::scene::values::word::{self, word_or, word_schema};
use crate::units::Time;

/// How long to run, and how often to save.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct RunTable {
    /// When the run ends: a time, or `"settled"`, for impacts, whose default it is; with `gravity.self` it goes on until the largest
    /// remnant stays as it is. Other scenes require a time.
    #[schemars(extend("x-default" = "\"settled\" for impacts"))]
    until: Option<UntilValue>,
    /// Largest number of steps, where that comes first; no limit without it.
    steps: Option<u64>,
    /// Wall time between checkpoints.
    #[schemars(extend("x-allowed" = POSITIVE))]
    checkpoint_every: Time,
    /// Simulated time at which a run ends even where it has not settled; no limit without it.
    #[schemars(extend("x-allowed" = POSITIVE))]
    max_time: Option<Time>,
}

impl Default for RunTable {
    fn default() -> Self {
        Self { until: None, steps: None, checkpoint_every: Time::new(600.0), max_time: None }
    }
}

/// A time, or `"settled"`.
#[derive(Debug, Clone, Copy)]
pub enum UntilValue {
    Settled,
    Time(Time),
}

impl UntilValue {
    const WORD: &str = "settled";

    /// The end that it stands for; an error at the key `path` where nothing can settle, as without an `impact`.
    pub fn validate(self, document: &Document, path: &str, impact: bool) -> Result<Until> {
        match self {
            UntilValue::Settled if !impact => {
                let what = "\"settled\" is defined for impacts only, and the scene has no [impact]";
                Err(document.error(path, what).allowed("a time, e.g. \"100 s\""))
            }
            UntilValue::Settled => Ok(Until::Settled),
            UntilValue::Time(time) => positive(document, path, time).map(Until::Time),
        }
    }
}

impl Serialize for UntilValue {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        let given = match self {
            UntilValue::Settled => None,
            UntilValue::Time(time) => Some(time),
        };
        word::serialize(given, Self::WORD, serializer)
    }
}

word_schema!(UntilValue, Time);

impl<'de> Deserialize<'de> for UntilValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        word_or(deserializer, Self::WORD).map(|time| time.map_or(UntilValue::Settled, UntilValue::Time))
    }
}

/// When a run ends, and how often it saves itself.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RunSettings {
    pub until: Until,
    /// Largest number of steps.
    pub steps: Option<u64>,
    /// Wall seconds between checkpoints.
    pub checkpoint_every: f64,
    /// Simulated time at which a run ends even if not settled, s.
    pub max_time: Option<f64>,
}

/// When something ends or begins.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Until {
    Settled,
    /// s
    Time(f64),
}

impl RunTable {
    /// The table with the end of an `impact`, which is known without being said.
    pub fn complete(&self, impact: bool) -> Self {
        Self { until: self.until.or(impact.then_some(UntilValue::Settled)), ..self.clone() }
    }

    /// `impact`: whether the scene has one.
    pub fn validate(&self, document: &Document, impact: bool) -> Result<RunSettings> {
        let Some(until) = self.until else {
            return Err(document
                .error("run", "the scene has no end: key `until` is missing")
                .allowed("run.until = \"100 s\""));
        };
        let until = until.validate(document, "run.until", impact)?;
        let max_time = self.max_time.map(|time| positive(document, "run.max_time", time)).transpose()?;
        let checkpoint_every = positive(document, "run.checkpoint_every", self.checkpoint_every)?;
        Ok(RunSettings { until, steps: self.steps, checkpoint_every, max_time })
    }
}
