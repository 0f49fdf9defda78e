//! history.csv: one row per recorded step, written by rank 0. A resumed run cuts the rows beyond the step it starts from, so
//! that the file is that of an uninterrupted run. A damaged file is set aside, as the checkpoint alone decides.

use std::fs::{File, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};

use super::agree;
use super::publish::{cannot, replace_text};
use crate::domain::comm::Comm;
use crate::error::{Error, Result};

/// The name that a history gets that a resumed run cannot continue.
pub const DAMAGED: &str = "history_damaged.csv";

/// One field of a row.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    Real(f64),
    Integer(u64),
    Text(String),
}

/// The open file; on ranks other than 0 it writes nothing.
pub struct History {
    path: PathBuf,
    file: Option<File>,
    /// Number of columns, and which of them counts steps.
    columns: usize,
    step: usize,
    /// Step of the last row.
    last: Option<u64>,
    line: String,
}

impl History {
    /// `columns` are (name, unit), and the one named `step` counts steps. A new run (`resumed` is `None`) starts the file
    /// afresh; a resumed one keeps its rows up to that step. Collective.
    pub fn open(path: &Path, columns: &[(&str, &str)], resumed: Option<u64>, comm: &Comm) -> Result<Self> {
        let open = || Self::open_alone(path, columns, resumed);
        let none = Self {
            path: path.to_path_buf(),
            file: None,
            columns: columns.len(),
            step: 0,
            last: None,
            line: String::new(),
        };
        agree(comm, if comm.is_root() { open() } else { Ok(none) })
    }

    fn open_alone(path: &Path, columns: &[(&str, &str)], resumed: Option<u64>) -> Result<Self> {
        let step = columns.iter().position(|(name, _)| *name == "step").unwrap_or(0);
        let mut text = header(columns) + "\n";
        let mut last = None;
        if let (Some(from), true) = (resumed, path.exists()) {
            match std::fs::read(path).map_err(|e| cannot("read", path, e)).and_then(|old| kept(&old, columns, from)) {
                Ok((rows, newest)) => (text, last) = (text + &rows, newest),
                Err(error) => set_aside(path, &error)?,
            }
        }
        replace_text(path, &text)?;
        let file = OpenOptions::new().append(true).open(path).map_err(|e| cannot("open", path, e))?;
        let (path, columns) = (path.to_path_buf(), columns.len());
        Ok(Self { path, file: Some(file), columns, step, last, line: String::new() })
    }

    /// Appends a row, unless the last one is of the same step. Not collective: an error of rank 0 is to be agreed on at the step's reduction.
    pub fn row(&mut self, cells: &[Cell]) -> Result<()> {
        debug_assert_eq!(cells.len(), self.columns);
        let Some(file) = &mut self.file else { return Ok(()) };
        let step = match cells.get(self.step) {
            Some(Cell::Integer(step)) => Some(*step),
            _ => None,
        };
        if step.is_some() && step == self.last {
            return Ok(());
        }
        self.last = step;
        self.line.clear();
        for (k, cell) in cells.iter().enumerate() {
            if k > 0 {
                self.line.push(',');
            }
            match cell {
                Cell::Real(x) => self.line.push_str(&format!("{x:e}")),
                Cell::Integer(n) => self.line.push_str(&n.to_string()),
                Cell::Text(text) => self.line.push_str(&quoted(text)),
            }
        }
        self.line.push('\n');
        // One write per row: a run that is killed leaves at most one broken row, which resuming cuts.
        file.write_all(self.line.as_bytes()).map_err(|e| cannot("write", &self.path, e))
    }
}

fn header(columns: &[(&str, &str)]) -> String {
    let name =
        |(name, unit): &(&str, &str)| if unit.is_empty() { quoted(name) } else { quoted(&format!("{name} [{unit}]")) };
    columns.iter().map(name).collect::<Vec<_>>().join(",")
}

fn quoted(text: &str) -> String {
    let text = text.replace(['\n', '\r'], " ");
    if text.contains([',', '"']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text }
}

/// Renames a history that cannot be continued; an empty one holds nothing to keep.
fn set_aside(path: &Path, why: &Error) -> Result<()> {
    let aside = path.with_file_name(DAMAGED);
    if std::fs::metadata(path).is_ok_and(|file| file.is_file() && file.len() == 0) {
        tracing::warn!("{} is empty and begins anew", path.display());
        return Ok(());
    }
    tracing::warn!("{} begins anew, the old file is now {DAMAGED}: {why}", path.display());
    std::fs::rename(path, aside).map_err(|e| cannot("rename", path, e))
}

/// The whole rows up to a step, and the step of the last of them.
fn kept(old: &[u8], columns: &[(&str, &str)], last: u64) -> Result<(String, Option<u64>)> {
    let old = String::from_utf8_lossy(old);
    let header = header(columns);
    if old.lines().next() != Some(header.as_str()) {
        return Err(Error::new("the history to be continued has other columns").allowed(header));
    }
    let step = columns.iter().position(|(name, _)| *name == "step").unwrap_or(0);
    let (mut text, mut newest) = (String::new(), None);
    for line in old.split_inclusive('\n').skip(1).filter(|line| line.ends_with('\n')) {
        let fields = fields(line.trim_end());
        let number = fields.get(step).and_then(|field| field.parse::<u64>().ok());
        // Remains of a failing disk between whole rows are dropped.
        if fields.len() == columns.len() && number.is_some_and(|n| n <= last && newest.is_none_or(|newest| n > newest))
        {
            text.push_str(line);
            newest = number;
        }
    }
    Ok((text, newest))
}

/// Fields of a row; commas inside quotes separate nothing.
fn fields(line: &str) -> Vec<&str> {
    let mut inside = false;
    line.split(|c| {
        inside ^= c == '"';
        c == ',' && !inside
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const COLUMNS: [(&str, &str); 4] = [("time", "s"), ("limit", ""), ("step", ""), ("energy", "J")];

    fn row(step: u64) -> [Cell; 4] {
        [Cell::Real(0.1 * step as f64), Cell::Text("CFL, particle 3".into()), Cell::Integer(step), Cell::Real(1e20)]
    }

    fn history(path: &Path, resumed: Option<u64>) -> History {
        History::open_alone(path, &COLUMNS, resumed).unwrap()
    }

    #[test]
    fn a_resumed_history_reads_as_if_nothing_had_happened() {
        let directory = tempfile::tempdir().unwrap();
        let (whole, broken) = (directory.path().join("whole.csv"), directory.path().join("broken.csv"));
        let mut straight = history(&whole, None);
        (1..=6).for_each(|step| straight.row(&row(step)).unwrap());
        let mut first = history(&broken, None);
        (1..=5).for_each(|step| first.row(&row(step)).unwrap());
        first.file.as_mut().unwrap().write_all(b"0.6,\"CFL, par").unwrap();
        let mut second = history(&broken, Some(3));
        (4..=6).for_each(|step| second.row(&row(step)).unwrap());
        let text = std::fs::read_to_string(&whole).unwrap();
        assert_eq!(std::fs::read_to_string(&broken).unwrap(), text);
        assert_eq!(text.lines().count(), 7);
        assert_eq!(text.lines().next(), Some("time [s],limit,step,energy [J]"));
    }

    /// Where the checkpoint is whole, a damaged history must not prevent resuming.
    #[test]
    fn a_damaged_history_begins_anew_and_is_kept() {
        let directory = tempfile::tempdir().unwrap();
        let (path, aside) = (directory.path().join("history.csv"), directory.path().join(DAMAGED));
        let read = || std::fs::read_to_string(&path).unwrap();
        for (damage, kept) in [(&b""[..], false), (b"time,step\n0,3\n", true), (b"\xff\0\0\n", true)] {
            std::fs::write(&path, damage).unwrap();
            history(&path, Some(3)).row(&row(4)).unwrap();
            assert_eq!(read().lines().count(), 2);
            assert!(read().starts_with("time [s],") && read().ends_with(",4,1e20\n"), "{}", read());
            assert_eq!(std::fs::read(&aside).ok().as_deref(), kept.then_some(damage));
        }
    }

    #[test]
    fn whole_rows_are_kept_and_none_is_written_twice() {
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path().join("history.csv");
        let mut first = history(&path, None);
        [1, 2, 2, 3, 4].into_iter().for_each(|step| first.row(&row(step)).unwrap());
        let text = std::fs::read_to_string(&path).unwrap();
        assert_eq!(text.lines().count(), 5);
        // Zeros, as after a failure of power, between the rows and at the end.
        std::fs::write(&path, text.replace('\n', "\n\0\0\n1,2\n\0,\0,\0,\0\n") + "\0\0").unwrap();
        let mut second = history(&path, Some(4));
        [4, 5].into_iter().for_each(|step| second.row(&row(step)).unwrap());
        let resumed = std::fs::read_to_string(&path).unwrap();
        let steps: Vec<&str> = resumed.lines().map(|line| fields(line)[2]).collect();
        assert_eq!(steps, ["step", "1", "2", "3", "4", "5"]);
    }

    #[test]
    fn numbers_come_back_bit_for_bit() {
        for x in [0.1, 1.0 / 3.0, 5e-324, f64::MAX] {
            assert_eq!(format!("{x:e}").parse::<f64>().unwrap().to_bits(), x.to_bits());
        }
    }
}
