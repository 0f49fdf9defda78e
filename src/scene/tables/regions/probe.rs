//! `[[probe]]`: a part of bodies whose means are columns of history.csv.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::region::{Region, RegionKeys, region};
use crate::error::Result;
use crate::scene::document::source::Document;
use crate::scene::tables::body::validated::Body;
use crate::scene::values::axis::Interval;

/// A part of bodies, by where its particles start, whose means are columns of history.csv: pressure, density, distention and its scatter.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ProbeTable {
    /// Begins the names of the columns, `NAME_pressure` and others: letters, digits and _, a name for each probe.
    name: String,
    /// Name of a body; all bodies without it.
    body: Option<String>,
    /// Lower and upper end along x; everywhere without it.
    x: Option<Interval>,
    /// Lower and upper end along y; everywhere without it.
    y: Option<Interval>,
    /// Lower and upper end along z; everywhere without it.
    z: Option<Interval>,
}

/// A validated probe.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Probe {
    pub name: String,
    pub region: Region,
}

impl ProbeTable {
    /// `number`: of the probe.
    pub fn validate(&self, document: &Document, number: usize, bodies: &[Body]) -> Result<Probe> {
        let path = format!("probe.{number}");
        let is_plain = |c: char| c.is_ascii_alphanumeric() || c == '_';
        if self.name.is_empty() || !self.name.chars().all(is_plain) {
            let what = format!("\"{}\" cannot name columns of history.csv", self.name);
            return Err(document.error(&format!("{path}.name"), what).allowed("letters, digits and _"));
        }
        let keys = RegionKeys { body: self.body.as_ref(), ends: [self.x, self.y, self.z] };
        Ok(Probe { name: self.name.clone(), region: region(document, &path, keys, bodies)? })
    }
}

/// Each probe has columns of its own in history.csv.
pub fn check_names(document: &Document, probes: &[Probe]) -> Result<()> {
    for (number, probe) in probes.iter().enumerate() {
        if probes[..number].iter().any(|other| other.name == probe.name) {
            let what = format!("two probes are named \"{}\"", probe.name);
            return Err(document
                .error(&format!("probe.{number}.name"), what)
                .allowed("a name for each: it names columns"));
        }
    }
    Ok(())
}
