//! A point's result on disk, in its own folder: tasks of a job array write side by side, and an interrupted study
//! continues from there.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::points::{Point, Study};
use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::output::publish::replace_text;
use crate::output::{Summary, agree, on_root};
use crate::warning::Warning;

/// The result of a point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Identity of the scene that was run.
    pub identity: String,
    /// Why it failed; empty where it did not.
    pub failed: String,
    pub state_hash: String,
    /// Every number of its summary, by dotted keys.
    pub figures: Vec<(String, f64)>,
    /// Every text of it.
    #[serde(default)]
    pub words: Vec<(String, String)>,
    #[serde(default)]
    pub warnings: Vec<Warning>,
}

impl Record {
    pub fn of(point: &Point, run: std::result::Result<&Summary, &Error>) -> Self {
        let identity = point.identity.clone();
        let nothing = Self {
            identity,
            failed: String::new(),
            state_hash: String::new(),
            figures: Vec::new(),
            words: Vec::new(),
            warnings: Vec::new(),
        };
        match run {
            Ok(summary) => {
                let leaves = leaves(summary);
                Self {
                    state_hash: summary.state_hash.clone(),
                    figures: leaves.iter().filter_map(|(key, leaf)| Some((key.clone(), leaf.as_f64()?))).collect(),
                    words: leaves.iter().filter_map(|(key, leaf)| Some((key.clone(), leaf.as_str()?.into()))).collect(),
                    warnings: summary.warnings.clone(),
                    ..nothing
                }
            }
            Err(error) => Self { failed: error.to_string(), ..nothing },
        }
    }

    pub fn figure(&self, name: &str) -> Option<f64> {
        self.figures.iter().find(|(key, _)| key == name).map(|(_, value)| *value)
    }

    pub fn word(&self, name: &str) -> Option<&str> {
        self.words.iter().find(|(key, _)| key == name).map(|(_, word)| word.as_str())
    }
}

/// What stands in a summary, by dotted keys.
fn leaves(summary: &Summary) -> Vec<(String, Value)> {
    fn collect(prefix: &str, value: &Value, found: &mut Vec<(String, Value)>) {
        match value {
            Value::Object(inner) => inner.iter().for_each(|(key, value)| {
                let key = if prefix.is_empty() { key.clone() } else { format!("{prefix}.{key}") };
                collect(&key, value, found);
            }),
            other => found.push((prefix.to_string(), other.clone())),
        }
    }
    let mut found = Vec::new();
    collect("", &serde_json::to_value(summary).unwrap_or_default(), &mut found);
    found
}

fn file(directory: &Path, point: &Point) -> PathBuf {
    directory.join(point.folder()).join("point.json")
}

/// The results of all points so far, on every rank. Collective.
pub fn read(study: &Study, directory: &Path, comm: &Comm) -> Result<Vec<Option<Record>>> {
    let read = || study.points.iter().map(|point| read_one(directory, point)).collect::<Result<Vec<_>>>();
    let mine = if comm.is_root() { read() } else { Ok(Vec::new()) };
    let mut bytes = serde_json::to_vec(mine.as_deref().unwrap_or_default()).map_err(|e| Error::new(e.to_string()))?;
    agree(comm, mine)?;
    comm.broadcast(&mut bytes);
    serde_json::from_slice(&bytes).map_err(|e| Error::new(e.to_string()))
}

fn read_one(directory: &Path, point: &Point) -> Result<Option<Record>> {
    let path = file(directory, point);
    let place = |e: String| Error::new(e).at(path.display().to_string());
    let text = match std::fs::read(&path) {
        Ok(text) => String::from_utf8_lossy(&text).into_owned(),
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => return Ok(None),
        Err(e) => return Err(place(e.to_string())),
    };
    // A run that has ended is not run again: its folder has its results.
    let Ok(record) = serde_json::from_str::<Record>(&text) else {
        tracing::warn!("{} is damaged: the point counts as not run", path.display());
        return Ok(None);
    };
    if record.identity != point.identity {
        let what = "this run belongs to another study, or to this one before it was changed";
        return Err(place(what.into()).allowed("the same study, or another folder (--out)").bad_input());
    }
    Ok(Some(record))
}

/// Collective.
pub fn write(directory: &Path, point: &Point, record: &Record, comm: &Comm) -> Result<()> {
    let write = || {
        let text = serde_json::to_string_pretty(record).map_err(|e| Error::new(e.to_string()))?;
        replace_text(&file(directory, point), &(text + "\n"))
    };
    on_root(comm, write)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::summary::Figures;

    #[test]
    fn figures_have_dotted_keys() {
        let errors = Figures(vec![("density_l1".into(), 0.02), ("nothing".into(), f64::NAN)]);
        let found = leaves(&Summary { steps: 7, errors, ..Default::default() });
        let of = |name: &str| found.iter().find(|(key, _)| key == name).and_then(|(_, value)| value.as_f64());
        assert_eq!((of("steps"), of("errors.density_l1"), of("errors.nothing")), (Some(7.0), Some(0.02), None));
    }
}
