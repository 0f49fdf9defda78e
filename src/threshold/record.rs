//! The impacts of a threshold search so far, on disk, so that an interrupted search continues from there.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Deserializer, Serialize};

use super::bracket::Point;
use super::fit;
use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::outcome::Outcome;
use crate::output::publish::{cannot, replace_text};
use crate::output::summary::Figures;
use crate::output::{agree, on_root};
use crate::scene::Scene;
use crate::scene::answer::understood;
use crate::scene::identity::{Difference, differences};
use crate::warning::Warning;

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
    pub price: ImpactCost,
    pub state_hash: String,
    /// Warnings of its run.
    #[serde(default)]
    pub warnings: Vec<Warning>,
}

/// Cost and conservation errors of an impact.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
pub struct ImpactCost {
    pub particles: u64,
    pub steps: u64,
    pub wall_seconds: f64,
    pub core_seconds: f64,
    pub mpi_wait_seconds: f64,
    pub pair_interactions: u64,
    pub updates: f64,
    pub energy_drift: f64,
    #[serde(default = "not_known", deserialize_with = "number_or_null")]
    pub energy_drift_over_left: f64,
    pub momentum_drift: f64,
    #[serde(deserialize_with = "number_or_null")]
    pub angular_momentum_drift: f64,
}

fn not_known() -> f64 {
    f64::NAN
}

/// Numbers that are not finite are null in JSON.
fn number_or_null<'de, D: Deserializer<'de>>(deserializer: D) -> std::result::Result<f64, D::Error> {
    Option::<f64>::deserialize(deserializer).map(|number| number.unwrap_or(f64::NAN))
}

impl Impact {
    /// The impact as a point of the search for Q*_D.
    pub fn point(&self) -> Point {
        Point {
            q: self.q,
            remnant: self.outcome.largest_remnant_fraction,
            remnant_later: self.outcome.later_fraction(),
        }
    }

    /// The impact as a point of the search for Q*_RD.
    pub fn point_of_total(&self) -> Point {
        Point {
            q: self.q_r,
            remnant: self.outcome.largest_remnant_of_total,
            remnant_later: self.outcome.later_of_total(),
        }
    }

    /// Whether the threshold depends on it: it is fitted, or gives the scatter.
    pub fn decides(&self) -> bool {
        fit::is_fitted(self.outcome.largest_remnant_fraction)
    }

    /// Relative uncertainty of its energy: the drift over the remaining kinetic energy, which determines how much leaves the
    /// target; zero without a warning of it.
    pub fn drift(&self) -> f64 {
        let warned = self.warnings.iter().any(|warning| warning.kind == "energy");
        match (warned, self.price.energy_drift_over_left) {
            (false, _) => 0.0,
            (true, left) if left.is_nan() => self.price.energy_drift.min(1.0),
            (true, left) => left.min(1.0),
        }
    }

    /// Warnings that concern the threshold: the number of particles of a remnant matters where it is near one half.
    pub fn relevant_warnings(&self) -> Vec<Warning> {
        let matters = |warning: &&Warning| self.decides() || warning.kind != "few_particles";
        self.warnings.iter().filter(matters).cloned().collect()
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
            named("largest_remnant_fraction_later", self.outcome.later_fraction()),
            named("largest_remnant_fraction_strict", self.outcome.strict.largest_remnant_fraction),
            named("largest_fragment_fraction", self.outcome.largest_fragment_fraction),
            named("largest_remnant_of_total", self.outcome.largest_remnant_of_total),
            named("particles", self.price.particles as f64),
            named("steps", self.price.steps as f64),
            named("core_seconds", self.price.core_seconds),
            named("pair_interactions", self.price.pair_interactions as f64),
            named("energy_drift", self.price.energy_drift),
            named("momentum_drift", self.price.momentum_drift),
            named("energy_drift_over_left", self.price.energy_drift_over_left),
            named("warnings", self.warnings.len() as f64),
        ])
    }
}

/// The scene that is searched, as read, with defaults.
const SCENE: &str = "scene.toml";

fn file(directory: &Path) -> PathBuf {
    directory.join("impacts.json")
}

/// Writes the scene that is searched. Collective.
pub fn begin(directory: &Path, scene: &Scene, comm: &Comm) -> Result<()> {
    let write = || replace_text(&directory.join(SCENE), &scene.to_toml());
    on_root(comm, write)
}

/// The impacts on disk, on every rank; none where there is no record. Impacts of another scene are refused. Collective.
pub fn read(directory: &Path, scene: &Scene, comm: &Comm) -> Result<Vec<Impact>> {
    let mine = if comm.is_root() { read_alone(directory, scene) } else { Ok(Vec::new()) };
    let mut text = serde_json::to_vec(mine.as_deref().unwrap_or_default()).map_err(|e| Error::new(e.to_string()))?;
    agree(comm, mine)?;
    comm.broadcast(&mut text);
    serde_json::from_slice(&text).map_err(|e| Error::new(e.to_string()).at(file(directory).display().to_string()))
}

fn read_alone(directory: &Path, scene: &Scene) -> Result<Vec<Impact>> {
    let path = file(directory);
    let bytes = match std::fs::read(&path) {
        Ok(bytes) => bytes,
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => return Ok(Vec::new()),
        Err(e) => return Err(cannot("read", &path, e)),
    };
    let before = std::fs::read_to_string(directory.join(SCENE)).unwrap_or_default();
    if let Some(difference) = differs(&before, scene).filter(|_| !before.is_empty()) {
        let what = format!("the search belongs to another scene: {difference}");
        let allowed = "the scene of its impacts, in which the title, [output] and [threshold] may change; or another directory (--out)";
        return Err(Error::new(what).at(directory.display().to_string()).allowed(allowed).bad_input());
    }
    // Impacts that have ended are not run again: their folders have their results.
    Ok(serde_json::from_slice(&bytes).unwrap_or_else(|error| {
        tracing::warn!("{} is damaged and made anew: {error}", path.display());
        Vec::new()
    }))
}

/// The first key that changes the outcome of an impact.
fn differs(before: &str, scene: &Scene) -> Option<String> {
    let [before, now] = [before, &scene.to_toml()].map(|text| {
        let mut table = understood(text);
        table.remove("threshold");
        table
    });
    differences(&before, &now).first().map(Difference::to_string)
}

/// Collective.
pub fn write(directory: &Path, impacts: &[Impact], comm: &Comm) -> Result<()> {
    let write = || {
        let text = serde_json::to_string_pretty(impacts).map_err(|e| Error::new(e.to_string()))?;
        replace_text(&file(directory), &(text + "\n"))
    };
    on_root(comm, write)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drift_counts_where_it_is_warned_of() {
        let price = ImpactCost { energy_drift: 2e-3, energy_drift_over_left: 0.3, ..ImpactCost::default() };
        let text = serde_json::to_string(&price).expect("JSON");
        let of = |price: ImpactCost, warnings: Vec<Warning>| Impact {
            repeat: 0,
            length: 1.0,
            q: 1.0,
            q_r: 1.0,
            outcome: Outcome { largest_remnant_fraction: 0.05, ..Outcome::default() },
            price,
            state_hash: String::new(),
            warnings,
        };
        let energy = || vec![Warning::new("energy", "drifts".into()), Warning::new("few_particles", "few".into())];
        assert_eq!(of(price, Vec::new()).drift(), 0.0);
        assert_eq!(of(price, energy()).drift(), 0.3);
        let spent = ImpactCost { energy_drift_over_left: f64::NAN, ..price };
        assert_eq!(of(spent, energy()).drift(), 2e-3);
        let nothing_left = serde_json::to_string(&spent).expect("JSON");
        let read = |text: &str| serde_json::from_str::<ImpactCost>(text).expect("a price").energy_drift_over_left;
        assert!(read(&nothing_left).is_nan() && read(&text) == 0.3);
        assert!(read(&text.replace("\"energy_drift_over_left\":0.3,", "")).is_nan());
        // A remnant of a twentieth decides nothing, however few particles it has.
        assert_eq!(of(price, energy()).relevant_warnings(), energy()[..1]);
    }
}
