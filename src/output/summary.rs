//! summary.json: results and cost of a run, under keys that scripts may rely on.

use std::fmt;
use std::marker::PhantomData;
use std::path::Path;

use serde::de::{MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::{agree, publish};
use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::warning::Warning;

/// Names with values, in the order in which they were given.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Figures(pub Vec<(String, f64)>);

impl Serialize for Figures {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

/// Null is a number that is not finite.
impl<'de> Deserialize<'de> for Figures {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        let figures: Vec<(String, Option<f64>)> = pairs(deserializer)?;
        Ok(Self(figures.into_iter().map(|(name, value)| (name, value.unwrap_or(f64::NAN))).collect()))
    }
}

/// Names with values, in the order of the file.
fn pairs<'de, T: Deserialize<'de>, D: Deserializer<'de>>(
    deserializer: D,
) -> std::result::Result<Vec<(String, T)>, D::Error> {
    struct Pairs<T>(PhantomData<T>);
    impl<'de, T: Deserialize<'de>> Visitor<'de> for Pairs<T> {
        type Value = Vec<(String, T)>;

        fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
            f.write_str("names with values")
        }

        fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> std::result::Result<Self::Value, A::Error> {
            let mut pairs = Vec::new();
            while let Some(pair) = map.next_entry()? {
                pairs.push(pair);
            }
            Ok(pairs)
        }
    }
    deserializer.deserialize_map(Pairs(PhantomData))
}

fn number<'de, D: Deserializer<'de>>(deserializer: D) -> std::result::Result<f64, D::Error> {
    Option::deserialize(deserializer).map(|number| number.unwrap_or(f64::NAN))
}

/// Pieces of a body, or of two that have collided.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Fragments {
    /// `sticking`, `bouncing` or `fragmentation`, of two bodies.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outcome: Option<String>,
    #[serde(flatten)]
    pub figures: Figures,
}

/// Names of bodies with figures of each.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Remnants(pub Vec<(String, Figures)>);

impl Remnants {
    fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl Serialize for Remnants {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, figures)| (name, figures)))
    }
}

impl<'de> Deserialize<'de> for Remnants {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        pairs(deserializer).map(Self)
    }
}

/// A run in figures. Numbers that are not finite are written as null.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Summary {
    pub title: String,
    pub version: String,
    /// See [`state_hash`](mod@super::state_hash): the same for any ranks and threads.
    pub state_hash: String,
    /// State of the steps beside the particles: number and length of steps, time, state of integrators and gravity.
    pub step_state: serde_json::Value,
    /// Simulated time at the end, s.
    pub time: f64,
    pub steps: u64,
    pub particles: u64,
    pub ranks: usize,
    pub threads_per_rank: usize,
    pub wall_seconds: f64,
    /// Waits inside MPI, summed over ranks.
    pub mpi_wait_seconds: f64,
    /// User and system time of all threads of all ranks, less the time spent spinning in MPI waits.
    pub core_seconds: f64,
    /// Directed pairs inside the support.
    pub pair_interactions: u64,
    /// One update is one force evaluation of one owned particle.
    pub updates_per_core_second: f64,
    /// (Peak resident set - resident set after MPI_Init) / particles, over all ranks.
    pub bytes_per_particle: f64,
    pub list_bytes_per_particle: f64,
    /// Largest |E - E0| over the run, over the initial kinetic energy in the centre-of-mass frame.
    #[serde(deserialize_with = "number")]
    pub energy_drift: f64,
    /// Largest |E - E0| over the kinetic energy in that frame at the end; NaN where less than 1e-3 of the initial one is left.
    #[serde(deserialize_with = "number")]
    pub energy_drift_over_left: f64,
    /// Drift of momentum over sum m |v|.
    #[serde(deserialize_with = "number")]
    pub momentum_drift: f64,
    #[serde(deserialize_with = "number")]
    pub angular_momentum_drift: f64,
    /// By how much density is off mass over volume at the end: 99 of 100 particles inside matter by less.
    #[serde(deserialize_with = "number")]
    pub density_drift: f64,
    /// Name -> share of the time.
    pub phases: Figures,
    /// Name -> share of the time, of effects with an update of their own.
    pub effects: Figures,
    /// Ghosts over owned particles.
    pub ghost_fraction: f64,
    pub exchanged_bytes_per_step: f64,
    /// Largest load of a rank over the mean.
    pub imbalance: f64,
    /// Steps that were refused and tried again shorter.
    pub refused_steps: u64,
    /// Small steps, where some bodies take these.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub small_steps: Option<u64>,
    pub list_builds: u64,
    pub rebisections: u64,
    /// Moves of particles between ranks.
    pub migrated_particles: u64,
    /// Errors against the exact solution that the scene names.
    pub errors: Figures,
    /// How the late stage began, where it has.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub late_stage: Option<Figures>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outcome: Option<Figures>,
    /// Shares of the own matter of an impact's bodies.
    #[serde(skip_serializing_if = "Remnants::is_empty")]
    pub remnants: Remnants,
    /// A body that falls into dust.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub intrusion: Option<Figures>,
    /// A body that hits another.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub restitution: Option<Figures>,
    /// The pieces of a body, or of two that have collided.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fragments: Option<Fragments>,
    /// The heap that a body leaves on level ground.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deposit: Option<Figures>,
    /// Rigid bodies at the end, as in history.csv, and their masses.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rigid: Option<Figures>,
    /// The bodies written for an N-body program.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub nbody: Option<Figures>,
    /// Result of a search; not read back, as its impacts are.
    #[serde(skip_serializing_if = "Option::is_none", skip_deserializing)]
    pub threshold: Option<Threshold>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub accuracy: Option<Accuracy>,
    /// Limits of the validity of the results.
    pub warnings: Vec<Warning>,
}

/// A setting that a study of the scene chose for a requested accuracy.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Accuracy {
    /// Requested relative error.
    pub asked: f64,
    /// The error that the study found with this setting, and of which figure.
    pub expected: f64,
    pub figure: String,
    pub core_seconds: f64,
    pub pair_interactions: u64,
    pub setting: String,
    /// As after `--set`.
    pub overrides: Vec<String>,
    /// File of the study.
    pub study: String,
    /// Number of its point.
    pub point: usize,
}

/// Result of a threshold search; specific energies in J/kg.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Threshold {
    pub q_star_d: f64,
    pub q_star_rd: f64,
    /// Uncertainty of Q*_D: half the bracket, residual of the fit, shift to twice the time, scatter between
    /// realisations and drift of energy where an impact warns of it, combined.
    pub uncertainty: f64,
    pub uncertainty_of_q_star_rd: f64,
    /// Parts of the uncertainty of Q*_D: bracket, residual, shift, scatter, drift.
    pub uncertainty_parts: Figures,
    /// Slope s of M_lr / M_T = 1/2 - s (Q / Q*_D - 1).
    pub slope: f64,
    /// Angle of the impacts from the normal, degrees; published fits average over angles.
    pub angle: f64,
    /// The published value it is compared with, Benz & Asphaug 1999.
    pub reference: f64,
    pub ratio_to_reference: f64,
    /// How the search ended.
    pub end: String,
    pub impacts: Vec<Figures>,
}

impl fmt::Display for Accuracy {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [asked, expected] = [self.asked, self.expected].map(|x| 100.0 * x);
        write!(
            f,
            "for {asked:.3} % the study {} chooses {} ({}): point {}, whose {} was {expected:.3} % at {:.3e} core-seconds",
            self.study,
            self.setting,
            self.overrides.join(", "),
            self.point,
            self.figure,
            self.core_seconds
        )
    }
}

impl Summary {
    /// Writes the file, by rank 0; all ranks return the same.
    pub fn write(&self, path: &Path, comm: &Comm) -> Result<()> {
        let mine = if comm.is_root() { self.write_alone(path) } else { Ok(()) };
        agree(comm, mine)
    }

    /// The contents of the file, on all ranks; `None` where there is no file or it holds no summary. Collective.
    pub fn read(path: &Path, comm: &Comm) -> Option<Self> {
        let mut text = if comm.is_root() { std::fs::read(path).unwrap_or_default() } else { Vec::new() };
        comm.broadcast(&mut text);
        serde_json::from_slice(&text).ok()
    }

    fn write_alone(&self, path: &Path) -> Result<()> {
        let text =
            serde_json::to_string_pretty(self).map_err(|e| Error::new(e.to_string()).at(path.display().to_string()))?;
        publish::replace_text(path, &(text + "\n"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_keep_their_order_and_absent_parts_are_left_out() {
        let figures = Figures(vec![("pairs".into(), 0.7), ("exchange".into(), 0.1)]);
        let summary = Summary { steps: 7, phases: figures, energy_drift: f64::NAN, ..Default::default() };
        let text = serde_json::to_string(&summary).unwrap();
        let at = |key: &str| text.find(&format!("\"{key}\"")).unwrap_or_else(|| panic!("{key} in {text}"));
        let order = ["state_hash", "steps", "energy_drift", "phases", "pairs", "exchange", "errors"];
        assert!(order.windows(2).all(|w| at(w[0]) < at(w[1])));
        assert!(text.contains("\"energy_drift\":null") && !text.contains("threshold"));
        let back: Summary = serde_json::from_str(&text).unwrap();
        assert_eq!(serde_json::to_string(&back).unwrap(), text);
    }
}
