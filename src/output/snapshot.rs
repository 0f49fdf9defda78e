//! Snapshots: VTKHDF 2.0 files (PolyData, one vertex per particle) that ParaView, PyVista and h5py open directly, written
//! collectively. Particles are in no special order; `id` identifies them. Every field has the attributes `unit` and
//! `description`. Outside /VTKHDF, /run holds time, step, program, version and scene, /bodies what the
//! bodies are, and /conservation the balance sheet.
//! Format: VTK file formats, "VTKHDF", section PolyData.

use std::path::Path;

use serde_json::{Value as Json, json};

use super::agree;
use super::collective::{CollectiveFile, Value};
use super::publish::{prepare, publish, replace_text, temporary};
use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::material::ParticleView;
use crate::math::{Deviator, Vec3};
use crate::particles::columns::Entry;
use crate::particles::{Column, ColumnShape, Columns, ParticleId};

/// How numbers are stored; ids and body numbers are always exact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Storage {
    /// 32 instead of 64 bits per number.
    pub single_precision: bool,
    /// Level of compression, 1 to 9; smaller files, written several times slower.
    pub gzip: Option<u8>,
}

/// The contents of a snapshot besides the program's name and version.
pub struct Snapshot<'a> {
    pub columns: &'a Columns,
    /// One entry per body.
    pub view: &'a ParticleView,
    /// s.
    pub time: f64,
    pub step: u64,
    /// The scene as read, with defaults.
    pub scene: &'a str,
    /// Whether matter is that of a late stage.
    pub late_stage: bool,
    /// Each body's name and that of its material, in the order of their numbers.
    pub bodies: &'a [[&'a str; 2]],
    pub derived: &'a [Derived],
    /// Whether each particle belongs to the largest remnant, where that has been found.
    pub in_largest: Option<&'a [bool]>,
    /// Conservation figures by name.
    pub figures: &'a [(String, f64)],
    pub storage: Storage,
}

/// A field that follows from others, and is made for the file alone.
pub struct Derived {
    pub name: &'static str,
    pub unit: &'static str,
    pub about: &'static str,
    /// Of each particle.
    pub values: Vec<f64>,
}

/// A field: its name in the file, unit and one sentence.
struct Label<'a> {
    name: &'a str,
    unit: &'a str,
    about: &'a str,
}

impl Snapshot<'_> {
    /// Writes the file; it appears under its name when it is whole. Returns whether every write was collective, as HDF5
    /// reports it. Collective.
    pub fn write(&self, path: &Path, comm: &Comm) -> Result<bool> {
        let collective = prepare(path, comm, |file| {
            self.write_geometry(file)?;
            self.write_fields(file)?;
            self.write_run(file)?;
            self.write_bodies(file)?;
            Ok(file.was_collective())
        })?;
        publish(path, comm).inspect_err(|_| {
            if comm.is_root() {
                let _ = std::fs::remove_file(temporary(path));
            }
        })?;
        Ok(collective)
    }

    fn write_geometry(&self, file: &CollectiveFile) -> Result<()> {
        let columns = self.columns;
        let places = file.places(columns.len());
        let (start, total) = (places.before as i64, places.total as i64);
        file.group("/VTKHDF")?;
        file.attribute("/VTKHDF", "Version", Value::Integers(&[2, 0]))?;
        file.attribute("/VTKHDF", "Type", Value::Ascii8("PolyData"))?;
        file.write_on_root("/VTKHDF/NumberOfPoints", &[total])?;
        let position = find::<Vec3>(columns, "position")?;
        let entry = &columns.registry.entries[position.index];
        self.write_numbers(file, "/VTKHDF/Points", &label(entry), &self.vectors(position), 3)?;
        for (cells, count) in [("Vertices", total), ("Lines", 0), ("Polygons", 0), ("Strips", 0)] {
            let at = |name: &str| format!("/VTKHDF/{cells}/{name}");
            file.group(&format!("/VTKHDF/{cells}"))?;
            file.write_on_root(&at("NumberOfCells"), &[count])?;
            file.write_on_root(&at("NumberOfConnectivityIds"), &[count])?;
            let mine = if count > 0 { start..start + columns.len() as i64 } else { 0..0 };
            file.write(&at("Connectivity"), &mine.clone().collect::<Vec<i64>>(), 1, self.storage.gzip)?;
            // One offset more than cells: the first rank holds the leading zero.
            let lead = file.is_root().then_some(0);
            let offsets: Vec<i64> = lead.into_iter().chain(mine.map(|k| k + 1)).collect();
            file.write(&at("Offsets"), &offsets, 1, self.storage.gzip)?;
        }
        Ok(())
    }

    fn write_fields(&self, file: &CollectiveFile) -> Result<()> {
        let columns = self.columns;
        file.group("/VTKHDF/PointData")?;
        for entry in &columns.registry.entries {
            let given_elsewhere = ["position", "smoothing_length"].contains(&entry.name.as_str());
            if entry.info.snapshot && !given_elsewhere {
                self.write_column(file, entry)?;
            }
        }
        let id = find::<ParticleId>(columns, "id")?;
        let body = |i: usize| columns.get(id, i).body();
        let all = 0..columns.len();
        let about = "Number of the body to which the particle belongs.";
        let bodies: Vec<i32> = all.clone().map(|i| body(i) as i32).collect();
        self.write_exact(file, &Label { name: "body", unit: "", about }, &bodies)?;
        for &Derived { name, unit, about, ref values } in self.derived {
            self.write_field(file, &Label { name, unit, about }, values, 1)?;
        }
        if let Some(in_largest) = self.in_largest {
            let about = "1 where the particle belongs to the largest remnant, 0 elsewhere.";
            let members: Vec<i32> = in_largest.iter().map(|member| i32::from(*member)).collect();
            self.write_exact(file, &Label { name: "largest_remnant", unit: "", about }, &members)?;
        }
        let masses: Vec<f64> = all.clone().map(|i| self.view.constants[body(i)].particle_mass).collect();
        let unit = if columns.registry.dimension == 2 { "kg/m" } else { "kg" };
        self.write_field(file, &Label { name: "mass", unit, about: "Mass of the particle." }, &masses, 1)?;
        let h: Vec<f64> = all.map(|i| self.view.smoothing_length(columns, i, body(i))).collect();
        let about = "Smoothing length; the radius of the kernel's support is twice as large.";
        self.write_field(file, &Label { name: "smoothing_length", unit: "m", about }, &h, 1)
    }

    fn write_column(&self, file: &CollectiveFile, entry: &Entry) -> Result<()> {
        let (columns, label) = (self.columns, label(entry));
        match entry.shape {
            ColumnShape::Id => {
                let column = find::<ParticleId>(columns, &entry.name)?;
                self.write_exact(file, &label, columns.words(column.index))
            }
            ColumnShape::Scalar => {
                let column = find::<f64>(columns, &entry.name)?;
                self.write_field(file, &label, columns.numbers(column.index), 1)
            }
            ColumnShape::Vector => self.write_field(file, &label, &self.vectors(find(columns, &entry.name)?), 3),
            ColumnShape::Deviator => self.write_field(file, &label, &self.tensors(find(columns, &entry.name)?), 6),
        }
    }

    /// Three components, in 2D too: VTK knows no other vectors.
    fn vectors(&self, column: Column<Vec3>) -> Vec<f64> {
        (0..self.columns.len()).flat_map(|i| <[f64; 3]>::from(self.columns.get(column, i))).collect()
    }

    /// Symmetric tensors in VTK's order XX YY ZZ XY YZ XZ.
    fn tensors(&self, column: Column<Deviator>) -> Vec<f64> {
        let components = |s: Deviator| [s.xx, s.yy, s.zz(), s.xy, s.yz, s.xz];
        (0..self.columns.len()).flat_map(|i| components(self.columns.get(column, i))).collect()
    }

    fn write_exact<T: hdf5::H5Type>(&self, file: &CollectiveFile, label: &Label, values: &[T]) -> Result<()> {
        let path = format!("/VTKHDF/PointData/{}", label.name);
        file.write(&path, values, 1, self.storage.gzip)?;
        describe(file, &path, label)
    }

    fn write_field(&self, file: &CollectiveFile, label: &Label, values: &[f64], width: usize) -> Result<()> {
        self.write_numbers(file, &format!("/VTKHDF/PointData/{}", label.name), label, values, width)
    }

    fn write_numbers(
        &self,
        file: &CollectiveFile,
        path: &str,
        label: &Label,
        values: &[f64],
        width: usize,
    ) -> Result<()> {
        if self.storage.single_precision {
            let narrow: Vec<f32> = values.iter().map(|&x| x as f32).collect();
            file.write(path, &narrow, width, self.storage.gzip)?;
        } else {
            file.write(path, values, width, self.storage.gzip)?;
        }
        describe(file, path, label)
    }

    fn write_run(&self, file: &CollectiveFile) -> Result<()> {
        file.group("/run")?;
        file.attribute("/run", "time", Value::Real(self.time))?;
        file.attribute("/run", "time_unit", Value::Text("s"))?;
        file.attribute("/run", "step", Value::Integer(self.step as i64))?;
        file.attribute("/run", "dimension", Value::Integer(self.columns.registry.dimension as i64))?;
        file.attribute("/run", "late_stage", Value::Integer(i64::from(self.late_stage)))?;
        file.attribute("/run", "program", Value::Text(env!("CARGO_PKG_NAME")))?;
        file.attribute("/run", "version", Value::Text(env!("CARGO_PKG_VERSION")))?;
        file.attribute("/run", "scene", Value::Text(self.scene))?;
        file.group("/conservation")?;
        self.figures.iter().try_for_each(|(name, value)| file.attribute("/conservation", name, Value::Real(*value)))
    }
}

impl Snapshot<'_> {
    /// What the numbers in the field `body` stand for.
    fn write_bodies(&self, file: &CollectiveFile) -> Result<()> {
        file.group("/bodies")?;
        let constants = &self.view.constants;
        for (number, ([name, material], body)) in self.bodies.iter().zip(constants).enumerate() {
            let group = format!("/bodies/{number}");
            file.group(&group)?;
            file.attribute(&group, "name", Value::Text(name))?;
            file.attribute(&group, "material", Value::Text(material))?;
            file.attribute(&group, "particle_mass", Value::Real(body.particle_mass))?;
            file.attribute(&group, "smoothing_length", Value::Real(body.smoothing_length))?;
            file.attribute(&group, "density", Value::Real(body.density))?;
            file.attribute(&group, "distention", Value::Real(body.distention))?;
        }
        Ok(())
    }
}

fn label(entry: &Entry) -> Label<'_> {
    Label { name: &entry.name, unit: entry.info.unit, about: entry.info.about }
}

fn describe(file: &CollectiveFile, path: &str, label: &Label) -> Result<()> {
    file.attribute(path, "unit", Value::Text(label.unit))?;
    file.attribute(path, "description", Value::Text(label.about))
}

/// A column that every scene has.
fn find<T: crate::particles::Element>(columns: &Columns, name: &str) -> Result<Column<T>> {
    columns.registry.find(name).ok_or_else(|| Error::new(format!("a snapshot needs the column {name}")))
}

/// Enters a snapshot into the list that ParaView plays as an animation. Others from this time on, left by a run that was
/// resumed before them, are cut off, files and all. By rank 0; all ranks return the same.
pub fn extend_series(path: &Path, snapshot: &str, time: f64, comm: &Comm) -> Result<()> {
    let mine = if comm.is_root() { extend_series_alone(path, snapshot, time) } else { Ok(()) };
    agree(comm, mine)
}

fn extend_series_alone(path: &Path, snapshot: &str, time: f64) -> Result<()> {
    let old = std::fs::read_to_string(path).ok().and_then(|text| serde_json::from_str::<Json>(&text).ok());
    let files = old.and_then(|series| series["files"].as_array().cloned()).unwrap_or_default();
    let stays = |f: &Json| f["name"] != snapshot && f["time"].as_f64().is_some_and(|t| t < time);
    let (mut files, old): (Vec<Json>, Vec<Json>) = files.into_iter().partition(stays);
    files.push(json!({ "name": snapshot, "time": time }));
    let series = json!({ "file-series-version": "1.0", "files": files });
    replace_text(path, &format!("{series:#}\n"))?;
    for name in old.iter().filter_map(|f| f["name"].as_str()) {
        if name != snapshot && is_name(name) {
            // It may be gone already.
            let _ = std::fs::remove_file(path.with_file_name(name));
        }
    }
    Ok(())
}

/// The name of a run's n-th snapshot, from 1 on.
pub fn name(number: u32) -> String {
    format!("snapshot_{number:04}.vtkhdf")
}

fn is_name(text: &str) -> bool {
    let number = text.strip_prefix("snapshot_").and_then(|rest| rest.strip_suffix(".vtkhdf"));
    number.is_some_and(|number| !number.is_empty() && number.bytes().all(|digit| digit.is_ascii_digit()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_series_grows_and_forgets_what_a_resumed_run_writes_again() {
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path().join("snapshot.vtkhdf.series");
        for (name, time) in [("a", 0.0), ("b", 1.0), ("c", 2.0), ("b", 1.0)] {
            extend_series_alone(&path, name, time).unwrap();
        }
        let series: Json = serde_json::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
        let expected = json!([{ "name": "a", "time": 0.0 }, { "name": "b", "time": 1.0 }]);
        assert_eq!((&series["files"], &series["file-series-version"]), (&expected, &json!("1.0")));
    }

    /// When a run is resumed with snapshots farther apart, the list and the files agree.
    #[test]
    fn snapshots_beyond_the_newest_are_cut_off() {
        let directory = tempfile::tempdir().unwrap();
        let at = |name: &str| directory.path().join(name);
        std::fs::write(at("notes.txt"), "").unwrap();
        for (number, time) in [(1, 0.0), (2, 1.0), (3, 2.0), (4, 3.0), (2, 2.0)] {
            std::fs::write(at(&name(number)), "").unwrap();
            extend_series_alone(&at("snapshots.vtkhdf.series"), &name(number), time).unwrap();
        }
        let left = |number| at(&name(number)).exists();
        assert_eq!([1, 2, 3, 4].map(left), [true, true, false, false]);
        assert!(at("notes.txt").exists() && !is_name("../snapshot_1.vtkhdf") && !is_name("snapshot_a.vtkhdf"));
    }
}
