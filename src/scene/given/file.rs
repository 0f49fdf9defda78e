//! Files of particles: what they say of themselves, and the rows that are read of them.

use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::units::Quantity;

/// What is wrong, for a message.
pub type Found<T> = Result<T, String>;

pub const POSITION: &str = "position";
pub const VELOCITY: &str = "velocity";
pub const MASS: &str = "mass";
/// Names what matter is where a file does not say it by bodies.
pub const MATERIAL: &str = "material";

/// A file of particles, and how it is read.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ParticleFile {
    pub path: String,
    pub format: Format,
    /// Dataset of each column in an HDF5 file of another program.
    pub datasets: BTreeMap<String, String>,
    /// Size in SI units of the unit in which a column is written; 1 without.
    pub units: BTreeMap<String, f64>,
}

/// How particles are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Format {
    /// A snapshot of this program.
    Snapshot,
    /// HDF5 of another program.
    Hdf5,
    /// Lines of text.
    Text,
}

impl Format {
    /// By the ending of the name.
    pub fn of(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "vtkhdf" => Some(Format::Snapshot),
            "h5" | "hdf5" | "hdf" => Some(Format::Hdf5),
            "csv" | "txt" | "dat" => Some(Format::Text),
            _ => None,
        }
    }

    /// For messages.
    pub const ENDINGS: &str =
        ".vtkhdf (a snapshot of this program), .h5 or .hdf5 (of another program), .csv or .txt (lines of text)";
}

/// What a file says of itself.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Head {
    pub rows: u64,
    /// 2 or 3, where it is known.
    pub dimension: Option<usize>,
    /// Whether the matter is that of a late stage, which is softer than its material.
    pub late: bool,
    /// When it was written, s, where it says so.
    pub time: Option<f64>,
    /// Names of the columns.
    pub columns: Vec<String>,
    /// The bodies of a snapshot.
    pub bodies: BTreeMap<i64, Origin>,
}

/// A body that particles of a snapshot come from.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Origin {
    pub name: String,
    pub material: String,
    /// Bulk density and distention at its start, kg/m^3 and 1.
    pub density: f64,
    pub distention: f64,
}

/// One quantity of some particles.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    pub name: String,
    /// Numbers per particle.
    pub width: usize,
    pub values: Vec<f64>,
}

/// What a snapshot says of one of its fields.
#[derive(Debug, Clone, PartialEq)]
pub struct Label {
    pub name: String,
    pub unit: String,
    pub about: String,
    /// Numbers per particle.
    pub width: usize,
}

/// Some particles of a file, in SI units.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Rows {
    pub count: usize,
    /// Of the whole file: where these begin.
    pub first: u64,
    /// Number of the body, or what stands for the material of each; all of one kind where it is empty.
    pub kinds: Vec<i64>,
    /// Words that `kinds` are numbers of; empty where they are the numbers themselves.
    pub words: Vec<String>,
    /// Numbers of particles in a snapshot.
    pub ids: Vec<u64>,
    /// Whether each belongs to the largest remnant; empty where the file does not say it.
    pub in_largest: Vec<bool>,
    pub columns: Vec<Column>,
}

impl Rows {
    pub fn column(&self, name: &str) -> Option<&Column> {
        self.columns.iter().find(|column| column.name == name)
    }

    pub fn kind(&self, row: usize) -> i64 {
        self.kinds.get(row).copied().unwrap_or(0)
    }
}

impl Column {
    /// A vector; zero beyond its width.
    pub fn vector(&self, row: usize) -> [f64; 3] {
        let own = &self.values[row * self.width..(row + 1) * self.width];
        std::array::from_fn(|k| own.get(k).copied().unwrap_or(0.0))
    }

    pub fn number(&self, row: usize) -> f64 {
        self.values[row * self.width]
    }
}

/// Size of a unit in SI units: `km`, or `6371 km`, of a column's dimension.
pub fn size_of_unit(column: &str, unit: &str) -> Found<f64> {
    let text = if unit.starts_with(|c: char| c.is_ascii_digit()) { unit.to_string() } else { format!("1 {unit}") };
    fn of<const L: i8, const M: i8, const T: i8>(text: &str) -> Found<f64> {
        let size = text.parse::<Quantity<L, M, T>>().map_err(|e| e.to_string())?.0;
        if size > 0.0 && size.is_finite() { Ok(size) } else { Err(format!("a unit of size {size}")) }
    }
    match column {
        POSITION => of::<1, 0, 0>(&text),
        VELOCITY => of::<1, 0, -1>(&text),
        MASS => of::<0, 1, 0>(&text),
        "density" => of::<-3, 1, 0>(&text),
        "internal_energy" => of::<2, 0, -2>(&text),
        "pressure" | "deviatoric_stress" => of::<-1, 1, -2>(&text),
        _ => Err(format!("{column} is taken as it stands, in SI units")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_have_the_dimension_of_their_column() {
        assert_eq!(size_of_unit(POSITION, "km"), Ok(1e3));
        assert_eq!(size_of_unit(POSITION, "6371 km"), Ok(6.371e6));
        assert_eq!(size_of_unit("internal_energy", "erg/g"), Ok(1e-4));
        for (column, unit) in [(POSITION, "kg"), ("damage", "m"), (MASS, "0 kg")] {
            assert!(size_of_unit(column, unit).is_err(), "{column} {unit}");
        }
    }

    #[test]
    fn formats_follow_from_endings() {
        let of = |name: &str| Format::of(Path::new(name));
        assert_eq!(of("a/snapshot_0001.vtkhdf"), Some(Format::Snapshot));
        assert_eq!((of("x.H5"), of("x.csv"), of("x")), (Some(Format::Hdf5), Some(Format::Text), None));
    }
}
