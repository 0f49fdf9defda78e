//! `[output]`: what a run writes.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::run::{RunSettings, Until};
use crate::error::Result;
use crate::scene::document::source::Document;
use crate::scene::values::checks::{POSITIVE, positive};
use crate::units::Time;

/// What a run writes.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct OutputTable {
    /// How many snapshots over the whole run: the first at the start, the last at the end, a single one at the end; this or `every`. None
    /// without either.
    snapshots: Option<u32>,
    /// Simulated time between snapshots; this or `snapshots`.
    #[schemars(extend("x-allowed" = POSITIVE))]
    every: Option<Time>,
    /// Width of the floating-point numbers in snapshots.
    precision: Precision,
    /// gzip level of snapshots, 0 for none.
    #[schemars(range(max = MOST_COMPRESSED))]
    compression: u8,
    /// Steps between rows of history.csv.
    #[schemars(range(min = FEWEST_STEPS))]
    history_every: u64,
    /// Whether to draw the outcome.
    picture: bool,
    /// What MPI is told when it opens a file, `{ striping_factor = 8, cb_nodes = 4 }`; may change at a restart. Counts (`cb_nodes`,
    /// `striping_factor`, ...) from 1 on.
    #[schemars(with = "BTreeMap<String, Hint>")]
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    mpi_io_hints: BTreeMap<String, toml::Value>,
}

/// A hint as the schema knows it.
#[derive(JsonSchema)]
#[serde(untagged)]
#[expect(dead_code, reason = "read as a value, to quote it in messages")]
enum Hint {
    Text(String),
    Count(i64),
    Switch(bool),
}

const MOST_COMPRESSED: u8 = 9;
const FEWEST_STEPS: u64 = 1;

impl Default for OutputTable {
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

/// Width of the floating-point numbers in snapshots.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Precision {
    /// Half the size.
    F32,
    /// All bits.
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
pub struct OutputSettings {
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

impl OutputTable {
    pub fn validate(&self, document: &Document, run: &RunSettings) -> Result<OutputSettings> {
        let snapshots = self.snapshots(document, run)?;
        if self.compression > MOST_COMPRESSED {
            let what = format!("{} is no compression level", self.compression);
            return Err(document.error("output.compression", what).allowed(format!("0 to {MOST_COMPRESSED}")));
        }
        if self.history_every < FEWEST_STEPS {
            return Err(document
                .error("output.history_every", "0 steps between lines")
                .allowed(format!("{FEWEST_STEPS} or more")));
        }
        let mpi_io_hints = self.hints(document)?;
        let Self { precision, compression, history_every, picture, .. } = *self;
        Ok(OutputSettings { snapshots, precision, compression, history_every, picture, mpi_io_hints })
    }

    /// The first of a number of snapshots shows the start, the last the end; a single one shows the end.
    fn snapshots(&self, document: &Document, run: &RunSettings) -> Result<Snapshots> {
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
            (None, Some(every)) => ("output.every", positive(document, "output.every", every)?),
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
