//! The particles of a checkpoint, which every run leaves at its end.

use std::collections::BTreeMap;
use std::path::Path;

use crate::scene::given::file::{MATERIAL, POSITION};
use crate::scene::given::{Format, Label, ParticleFile, labels};

const NAME: &str = "checkpoint.h5";
const COLUMNS: &str = "/columns";
/// What steps keep for themselves says nothing to look at.
const OWN: [&str; 4] = ["position", "build_position", "skin", "jerk"];
const OWN_ENDS: [&str; 3] = ["_rate", "_slope", "_at_build"];

/// A checkpoint to be looked at.
pub struct Found {
    pub file: ParticleFile,
    pub labels: Vec<Label>,
}

/// That of a run's directory; none where there is none that can be read.
pub fn open(directory: &Path) -> Option<Found> {
    let path = directory.join(NAME);
    let path = path.is_file().then(|| path.display().to_string())?;
    let own = |name: &str| {
        OWN.contains(&name) || name.starts_with("moment_") || OWN_ENDS.iter().any(|end| name.ends_with(end))
    };
    let labels: Vec<Label> = labels(&path, COLUMNS).ok()?.into_iter().filter(|label| !own(&label.name)).collect();
    let place = |name: &str| format!("{COLUMNS}/{name}");
    let mut datasets: BTreeMap<String, String> =
        labels.iter().map(|label| (label.name.clone(), place(&label.name))).collect();
    // The number of a particle has that of its body.
    datasets.extend([(POSITION.to_string(), place(POSITION)), (MATERIAL.to_string(), place("id"))]);
    let file = ParticleFile { path, format: Format::Hdf5, datasets, units: BTreeMap::new() };
    let body = Label { name: "body".into(), unit: String::new(), about: "Number of the body.".into(), width: 1 };
    Some(Found { file, labels: labels.into_iter().chain([body]).collect() })
}
