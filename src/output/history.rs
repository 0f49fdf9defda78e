//! history.csv: one row per recorded step, written by rank 0. A resumed run cuts the rows beyond the step it starts from, so
//! that the file reads as if nothing had happened.

use std::fs::{File, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};

use super::agree;
use super::publish::{cannot, replace_text};
use crate::domain::comm::Comm;
use crate::error::{Error, Result};

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
    columns: usize,
    line: String,
}

impl History {
    /// `columns` are (name, unit), and the one named `step` counts steps. A new run (`resumed` is none) starts the file
    /// afresh; a resumed one keeps its rows up to that step. Collective.
    pub fn open(path: &Path, columns: &[(&str, &str)], resumed: Option<u64>, comm: &Comm) -> Result<Self> {
        let mine = if comm.is_root() { prepare(path, columns, resumed).map(Some) } else { Ok(None) };
        let file = agree(comm, mine)?;
        Ok(Self { path: path.to_path_buf(), file, columns: columns.len(), line: String::new() })
    }

    /// Appends a row. Not collective: an error of rank 0 is to be agreed on at the step's reduction.
    pub fn row(&mut self, cells: &[Cell]) -> Result<()> {
        debug_assert_eq!(cells.len(), self.columns);
        let Some(file) = &mut self.file else { return Ok(()) };
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

fn prepare(path: &Path, columns: &[(&str, &str)], resumed: Option<u64>) -> Result<File> {
    let mut text = header(columns) + "\n";
    if let (Some(step), true) = (resumed, path.exists()) {
        let old = std::fs::read_to_string(path).map_err(|e| cannot("read", path, e))?;
        text = kept(&old, columns, step).map_err(|e| e.at(path.display().to_string()))?;
    }
    replace_text(path, &text)?;
    OpenOptions::new().append(true).open(path).map_err(|e| cannot("open", path, e))
}

/// The header and the whole rows up to a step.
fn kept(old: &str, columns: &[(&str, &str)], last: u64) -> Result<String> {
    let header = header(columns);
    if old.lines().next() != Some(header.as_str()) {
        return Err(Error::new("the history to go on with has other columns").allowed(header));
    }
    let step = columns.iter().position(|(name, _)| *name == "step").unwrap_or(0);
    let mut text = header + "\n";
    for line in old.split_inclusive('\n').skip(1) {
        let number = fields(line.trim_end()).get(step).and_then(|field| field.parse::<u64>().ok());
        if line.ends_with('\n') && number.is_some_and(|n| n <= last) {
            text.push_str(line);
        }
    }
    Ok(text)
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
        let file = Some(prepare(path, &COLUMNS, resumed).unwrap());
        History { path: path.to_path_buf(), file, columns: COLUMNS.len(), line: String::new() }
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

    #[test]
    fn other_columns_are_refused() {
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path().join("history.csv");
        history(&path, None);
        let error = prepare(&path, &COLUMNS[..3], Some(3)).unwrap_err();
        assert!(error.what.contains("other columns") && error.place.ends_with("history.csv"));
    }

    #[test]
    fn numbers_come_back_bit_for_bit() {
        for x in [0.1, 1.0 / 3.0, 5e-324, f64::MAX] {
            assert_eq!(format!("{x:e}").parse::<f64>().unwrap().to_bits(), x.to_bits());
        }
    }
}
