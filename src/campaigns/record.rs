//! The impacts of a threshold search so far, on disk, so that a search that was interrupted goes on where it was.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::bracket::Point;
use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::outcome::Outcome;
use crate::output::agree;
use crate::output::publish::replace_text;
use crate::output::summary::Figures;

/// One finished impact.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Impact {
    /// 0 for the impacts of the search; repeats at the threshold are numbered from 1.
    pub repeat: u32,
    /// The varied length, m.
    pub length: f64,
    /// J/kg.
    pub q: f64,
    pub q_r: f64,
    pub outcome: Outcome,
    pub later: Outcome,
    pub price: Price,
    pub state_hash: String,
}

/// What an impact has cost and how well it conserved.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
pub struct Price {
    pub particles: u64,
    pub steps: u64,
    pub wall_seconds: f64,
    pub core_seconds: f64,
    pub mpi_wait_seconds: f64,
    pub pair_interactions: u64,
    pub updates: f64,
    pub energy_drift: f64,
    pub momentum_drift: f64,
    pub angular_momentum_drift: f64,
}

impl Impact {
    /// For Q*_D.
    pub fn point(&self) -> Point {
        Point {
            q: self.q,
            remnant: self.outcome.largest_remnant_fraction,
            remnant_later: self.later.largest_remnant_fraction,
        }
    }

    /// For Q*_RD.
    pub fn point_of_total(&self) -> Point {
        Point {
            q: self.q_r,
            remnant: self.outcome.largest_remnant_of_total,
            remnant_later: self.later.largest_remnant_of_total,
        }
    }

    /// A row of the table.
    pub fn figures(&self) -> Figures {
        let named = |name: &str, value: f64| (name.to_string(), value);
        Figures(vec![
            named("repeat", self.repeat as f64),
            named("length", self.length),
            named("q", self.q),
            named("q_r", self.q_r),
            named("largest_remnant_fraction", self.outcome.largest_remnant_fraction),
            named("largest_remnant_fraction_later", self.later.largest_remnant_fraction),
            named("largest_remnant_fraction_strict", self.outcome.strict.largest_remnant_fraction),
            named("largest_fragment_fraction", self.outcome.largest_fragment_fraction),
            named("largest_remnant_of_total", self.outcome.largest_remnant_of_total),
            named("particles", self.price.particles as f64),
            named("steps", self.price.steps as f64),
            named("core_seconds", self.price.core_seconds),
            named("pair_interactions", self.price.pair_interactions as f64),
            named("energy_drift", self.price.energy_drift),
            named("momentum_drift", self.price.momentum_drift),
        ])
    }
}

fn file(directory: &Path) -> PathBuf {
    directory.join("impacts.json")
}

/// The impacts on disk, on every rank; none where there is no record. Collective.
pub fn read(directory: &Path, comm: &Comm) -> Result<Vec<Impact>> {
    let mut text = Vec::new();
    let mut mine = Ok(());
    if comm.is_root() {
        match std::fs::read(file(directory)) {
            Ok(bytes) => text = bytes,
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => text = b"[]".to_vec(),
            Err(e) => mine = Err(Error::from(e).at(file(directory).display().to_string())),
        }
    }
    agree(comm, mine)?;
    comm.broadcast(&mut text);
    serde_json::from_slice(&text).map_err(|e| Error::new(e.to_string()).at(file(directory).display().to_string()))
}

/// Collective.
pub fn write(directory: &Path, impacts: &[Impact], comm: &Comm) -> Result<()> {
    let write = || {
        let text = serde_json::to_string_pretty(impacts).map_err(|e| Error::new(e.to_string()))?;
        replace_text(&file(directory), &(text + "\n"))
    };
    agree(comm, if comm.is_root() { write() } else { Ok(()) })
}
