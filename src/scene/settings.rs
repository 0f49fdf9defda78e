//! The tables that say how long to run, what to write, and what to search: `[run]`, `[output]`, `[threshold]`, each raw
//! and validated.

use std::collections::BTreeMap;

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::raw::word_or;
use super::source::Document;
use crate::error::Result;
use crate::units::{Length, Number, Time};

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct RawRun {
    pub(super) until: Option<RawUntil>,
    steps: Option<u64>,
    checkpoint_every: Time,
    max_time: Option<Time>,
}

impl Default for RawRun {
    fn default() -> Self {
        Self { until: None, steps: None, checkpoint_every: Time::new(600.0), max_time: None }
    }
}

#[derive(Debug, Clone, Copy)]
pub(super) enum RawUntil {
    Settled,
    Time(Time),
}

impl Serialize for RawUntil {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        match self {
            RawUntil::Settled => serializer.serialize_str("settled"),
            RawUntil::Time(time) => time.serialize(serializer),
        }
    }
}

impl<'de> Deserialize<'de> for RawUntil {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        word_or(deserializer, "settled").map(|time| time.map_or(RawUntil::Settled, RawUntil::Time))
    }
}

/// When a run ends, and how often it saves itself.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Run {
    pub until: Until,
    /// Largest number of steps.
    pub steps: Option<u64>,
    /// Wall seconds between checkpoints.
    pub checkpoint_every: f64,
    /// Simulated time at which a run ends even if not settled, s.
    pub max_time: Option<f64>,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Until {
    Settled,
    /// s
    Time(f64),
}

impl RawRun {
    /// Fills in the end of an impact.
    pub(super) fn validate(&mut self, document: &Document, impact: bool) -> Result<Run> {
        if self.until.is_none() && impact {
            self.until = Some(RawUntil::Settled);
        }
        let until = match self.until {
            None => {
                return Err(document
                    .error("run", "the scene has no end: key `until` is missing")
                    .allowed("run.until = \"100 s\""));
            }
            Some(RawUntil::Settled) if !impact => {
                let what = "\"settled\" is defined for impacts only, and the scene has no [impact]";
                return Err(document.error("run.until", what).allowed("a time, e.g. \"100 s\""));
            }
            Some(RawUntil::Settled) => Until::Settled,
            Some(RawUntil::Time(time)) => Until::Time(positive(document, "run.until", time.0, time)?),
        };
        let max_time = self.max_time.map(|time| positive(document, "run.max_time", time.0, time)).transpose()?;
        let checkpoint_every =
            positive(document, "run.checkpoint_every", self.checkpoint_every.0, self.checkpoint_every)?;
        Ok(Run { until, steps: self.steps, checkpoint_every, max_time })
    }
}

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct RawOutput {
    snapshots: Option<u32>,
    every: Option<Time>,
    precision: Precision,
    compression: u8,
    history_every: u64,
    picture: bool,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    mpi_io_hints: BTreeMap<String, toml::Value>,
}

impl Default for RawOutput {
    fn default() -> Self {
        Self {
            snapshots: None,
            every: None,
            precision: Precision::F64,
            compression: 0,
            history_every: 10,
            picture: true,
            mpi_io_hints: BTreeMap::new(),
        }
    }
}

/// Floating-point numbers in snapshots.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Precision {
    F32,
    #[default]
    F64,
}

/// When snapshots are written. Where there are any, the last one shows the end.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Snapshots {
    Never,
    AtEnd,
    /// From the start on, with this simulated time between them, s.
    Every(f64),
}

/// What a run writes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Output {
    pub snapshots: Snapshots,
    pub precision: Precision,
    /// gzip level of snapshots, 0 (none) to 9.
    pub compression: u8,
    /// Steps between lines of history.csv.
    pub history_every: u64,
    /// Whether to draw the outcome.
    pub picture: bool,
    /// What MPI is told when it opens a file. They may change between restarts: nothing else depends on them.
    pub mpi_io_hints: BTreeMap<String, String>,
}

impl RawOutput {
    pub(super) fn validate(&self, document: &Document, run: &Run) -> Result<Output> {
        let snapshots = self.snapshots(document, run)?;
        if self.compression > 9 {
            let what = format!("{} is no compression level", self.compression);
            return Err(document.error("output.compression", what).allowed("0 to 9"));
        }
        if self.history_every == 0 {
            return Err(document.error("output.history_every", "0 steps between lines").allowed("1 or more"));
        }
        let mpi_io_hints = self.hints(document)?;
        let Self { precision, compression, history_every, picture, .. } = *self;
        Ok(Output { snapshots, precision, compression, history_every, picture, mpi_io_hints })
    }

    /// The first of a number of snapshots shows the start, the last the end; a single one shows the end.
    fn snapshots(&self, document: &Document, run: &Run) -> Result<Snapshots> {
        let end = match run.until {
            Until::Time(end) => Some(end.min(run.max_time.unwrap_or(end))),
            Until::Settled => run.max_time,
        };
        let (key, interval) = match (self.snapshots, self.every) {
            (Some(_), Some(_)) => {
                return Err(document
                    .error("output.snapshots", "both `snapshots` and `every` are given")
                    .allowed("one of them"));
            }
            (Some(0), None) | (None, None) => return Ok(Snapshots::Never),
            (Some(1), None) => return Ok(Snapshots::AtEnd),
            (Some(_), None) if run.until == Until::Settled => {
                let what = "a number of snapshots needs a run of known length, and this one ends when it is settled";
                return Err(document
                    .error("output.snapshots", what)
                    .allowed("1, at the end; every = \"1 s\"; or run.until = \"100 s\""));
            }
            (Some(count), None) => ("output.snapshots", end.unwrap_or(f64::INFINITY) / (count - 1) as f64),
            (None, Some(every)) => ("output.every", positive(document, "output.every", every.0, every)?),
        };
        if end.is_some_and(|end| end / interval > MOST_SNAPSHOTS) {
            let what = format!("{:e} snapshots", end.unwrap_or_default() / interval);
            return Err(document.error(key, what).allowed(format!("{MOST_SNAPSHOTS:e} and less, and a step for each")));
        }
        Ok(Snapshots::Every(interval))
    }

    /// Hints as MPI takes them: short texts. Which of them it knows is up to the MPI and the file system.
    fn hints(&self, document: &Document) -> Result<BTreeMap<String, String>> {
        let hint = |(key, value): (&String, &toml::Value)| {
            let text = match value {
                toml::Value::String(text) => text.clone(),
                toml::Value::Integer(_) | toml::Value::Boolean(_) => value.to_string(),
                _ => String::new(),
            };
            let fits = |text: &str, most| (1..=most).contains(&text.len()) && !text.contains('\0');
            let counts = |text: &str| text.parse().is_ok_and(|count: u32| (1..=MOST_COUNTED).contains(&count));
            let (what, allowed) = match fits(key, LONGEST_HINT_KEY) && fits(&text, LONGEST_HINT) {
                true if COUNTS.contains(&key.as_str()) && !counts(&text) => {
                    (format!("{value} is no number of anything"), format!("1 to {MOST_COUNTED}"))
                }
                true => return Ok((key.clone(), text)),
                false => {
                    let allowed =
                        format!("a text of 1 to {LONGEST_HINT} characters, under a key of 1 to {LONGEST_HINT_KEY}");
                    (format!("{value} is no hint for MPI"), allowed)
                }
            };
            Err(document.error(&format!("output.mpi_io_hints.{key}"), what).allowed(allowed))
        };
        self.mpi_io_hints.iter().map(hint).collect()
    }
}

/// Each costs a step of its own, and a file.
const MOST_SNAPSHOTS: f64 = 1e6;

/// Hints that count ranks, servers or bytes. An MPI believes what it is told, and asks for the memory.
const COUNTS: [&str; 9] = [
    "cb_nodes",
    "cb_buffer_size",
    "cb_block_size",
    "striping_factor",
    "striping_unit",
    "num_io_nodes",
    "nb_proc",
    "ind_rd_buffer_size",
    "ind_wr_buffer_size",
];
const MOST_COUNTED: u32 = i32::MAX as u32;

/// What OpenMPI takes, which takes the least.
const LONGEST_HINT_KEY: usize = 35;
const LONGEST_HINT: usize = 255;

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawThreshold {
    vary: String,
    #[serde(default = "five_per_cent")]
    tolerance: Number,
    min: Option<Length>,
    max: Option<Length>,
    #[serde(default = "sixteen")]
    max_impacts: u32,
    #[serde(default = "three")]
    repeats: u32,
}

fn five_per_cent() -> Number {
    Number::new(0.05)
}

fn sixteen() -> u32 {
    16
}

fn three() -> u32 {
    3
}

/// A search for the projectile that disperses half of the target.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Threshold {
    /// The length that is varied, as `--set` names it: `projectile.radius`.
    pub vary: String,
    /// Relative width of the final bracket in Q.
    pub tolerance: f64,
    /// Bounds of the varied length, m.
    pub min: Option<f64>,
    pub max: Option<f64>,
    pub max_impacts: u32,
    /// Impacts at the threshold with other flaws and another orientation of the target's lattice: their scatter is part of
    /// the uncertainty. None, or two and more.
    pub repeats: u32,
}

impl RawThreshold {
    /// `varied` are the keys that may be varied.
    pub(super) fn validate(&self, document: &Document, varied: &[String]) -> Result<Threshold> {
        if !varied.contains(&self.vary) {
            let what = format!("`{}` cannot be varied", self.vary);
            return Err(document.error("threshold.vary", what).allowed(varied.join(", ")));
        }
        let min = self.min.map(|x| positive(document, "threshold.min", x.0, x)).transpose()?;
        let max = self.max.map(|x| positive(document, "threshold.max", x.0, x)).transpose()?;
        if let (Some(low), Some(high)) = (min, max)
            && low >= high
        {
            return Err(document.error("threshold.min", format!("{} is not below max", Length::new(low))));
        }
        if self.max_impacts < 2 {
            return Err(document.error("threshold.max_impacts", "a bracket needs two impacts").allowed("2 or more"));
        }
        if self.repeats == 1 {
            return Err(document.error("threshold.repeats", "one impact shows no scatter").allowed("0, or 2 and more"));
        }
        let tolerance = within(document, "threshold.tolerance", self.tolerance, 1e-4, 1.0)?;
        let Self { max_impacts, repeats, .. } = *self;
        Ok(Threshold { vary: self.vary.clone(), tolerance, min, max, max_impacts, repeats })
    }
}

pub(super) fn within(document: &Document, path: &str, value: Number, low: f64, high: f64) -> Result<f64> {
    if (low..=high).contains(&value.0) {
        return Ok(value.0);
    }
    Err(document.error(path, format!("{value} is out of range")).allowed(format!("{low} to {high}")))
}

pub(super) fn positive(document: &Document, path: &str, value: f64, printed: impl std::fmt::Display) -> Result<f64> {
    if value > 0.0 {
        return Ok(value);
    }
    Err(document.error(path, format!("{printed} is not positive")).allowed("more than 0"))
}
