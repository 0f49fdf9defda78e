//! Reading a file of particles, whatever its format.

use std::ops::Range;

use super::file::{Format, Found, Head, ParticleFile, Rows};
use super::{hdf5_file, text};

impl ParticleFile {
    pub fn head(&self) -> Found<Head> {
        match self.format {
            Format::Text => text::head(self),
            Format::Snapshot => hdf5_file::head_of_snapshot(&self.path),
            Format::Hdf5 => hdf5_file::head(self),
        }
    }

    /// Rows of the file with the columns that are `wanted`.
    pub fn read(&self, rows: Range<u64>, wanted: &dyn Fn(&str) -> bool) -> Found<Rows> {
        let mut rows = match self.format {
            Format::Text => text::rows(self, rows, wanted)?,
            Format::Snapshot => hdf5_file::rows_of_snapshot(&self.path, rows, wanted)?,
            Format::Hdf5 => hdf5_file::rows(self, rows, wanted)?,
        };
        for column in &mut rows.columns {
            if let Some(size) = self.units.get(&column.name) {
                column.values.iter_mut().for_each(|x| *x *= size);
            }
            if let Some(bad) = column.values.iter().position(|x| !x.is_finite()) {
                let row = rows.first + (bad / column.width) as u64;
                return Err(format!("{} of particle {row} is {}", column.name, column.values[bad]));
            }
        }
        Ok(rows)
    }
}
