//! `from` of a body: particles of a file instead of a shape that a lattice fills.

use std::collections::BTreeMap;
use std::path::Path;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::{Error, Result};
use crate::scene::document::source::Document;
use crate::scene::given::file::{MASS, POSITION, size_of_unit};
use crate::scene::given::{Format, Keep, ParticleFile};

/// Particles of a file: of a snapshot, so that a run begins with what another one has left, or of another program. They bring all columns
/// that the file and the scene both have (position, velocity, mass, density, energy, damage, stress, distention ...). What the file
/// does not have starts as the body's keys say.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FromTable {
    /// The file, by its ending: `.vtkhdf` is a snapshot, `.csv` or `.txt` a table of particles, `.h5` or `.hdf5` of another
    /// program. A path starts at the scene's folder.
    pub file: String,
    /// Which of its particles.
    #[serde(default)]
    pub keep: Keep,
    /// What `position` and `velocity` of the body mean.
    #[serde(default)]
    pub frame: Frame,
    /// Whether the matter starts without load: at the density that it has without pressure, and without shear stress. What comes out of a late
    /// stage, or from another equation of state, must.
    #[serde(default)]
    pub unload: bool,
    /// Material of what was another body than most of the matter, by the name of that body, or by the word or number in the column
    /// `material` of another program's file. All other matter is of the body's `material`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub materials: BTreeMap<String, String>,
    /// In which dataset an HDF5 file of another program has each column: `{ position = "PartType0/Coordinates", ... }`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub columns: BTreeMap<String, String>,
    /// The unit in which such a file has a column, where it is not SI: `{ position = "6371 km", mass = "g" }`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub units: BTreeMap<String, String>,
}

/// The frame in which a file's particles are taken.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Frame {
    /// Their centre of mass comes to the body's `position`, and moves with its `velocity`.
    #[default]
    CentreOfMass,
    /// They stay where they are and as fast as they are, `position` and `velocity` added.
    File,
}

impl FromTable {
    /// How its file is read. `path`: of this table.
    pub fn particle_file(&self, document: &Document, path: &str) -> Result<ParticleFile> {
        let error = |key: &str, what: String| document.error(&format!("{path}.{key}"), what);
        let Some(format) = Format::of(Path::new(&self.file)) else {
            let what = format!("the ending of {} does not say what kind of file it is", self.file);
            return Err(error("file", what).allowed(Format::ENDINGS));
        };
        let foreign = format == Format::Hdf5;
        for (key, given) in [("columns", &self.columns), ("units", &self.units)] {
            if !foreign && !given.is_empty() {
                let what = format!("{key} are those of an HDF5 file of another program, and {} is none", self.file);
                return Err(error(key, what).allowed("no such table: names and units stand in the file"));
            }
        }
        if let Some(missing) = [POSITION, MASS].iter().find(|name| foreign && !self.columns.contains_key(**name)) {
            let what = format!("nothing says which dataset of {} has the {missing}", self.file);
            let allowed = "columns = { position = \"PartType0/Coordinates\", velocity = \"PartType0/Velocities\", \
                mass = \"PartType0/Masses\", ... }";
            return Err(error("columns", what).allowed(allowed));
        }
        let sizes = self.units.iter().map(|(column, unit)| {
            let size = size_of_unit(column, unit).map_err(|what| error(&format!("units.{column}"), what))?;
            Ok((column.clone(), size))
        });
        let units = sizes.collect::<Result<BTreeMap<String, f64>>>()?;
        Ok(ParticleFile { path: self.file.clone(), format, datasets: self.columns.clone(), units })
    }

    /// What identifies what has been read of it.
    pub fn key(&self) -> String {
        let Self { file, keep, columns, units, .. } = self;
        format!("{file} {keep:?} {columns:?} {units:?}")
    }
}

/// What is wrong with the file of a table at `path`.
pub fn wrong_file(document: &Document, path: &str, file: &str, what: &str) -> Error {
    document.error(&format!("{path}.file"), format!("{file}: {what}"))
}
