//! Numbers and tables for a terminal.

use std::fmt::Write;

use crate::error::plain;

/// Cells of a row.
pub fn words<const N: usize>(cells: [&str; N]) -> Vec<String> {
    cells.map(str::to_string).to_vec()
}

/// Rows with their cells below each other.
pub fn aligned(rows: &[Vec<String>]) -> String {
    let columns = rows.first().map_or(0, Vec::len);
    // Names may hold any characters.
    let cell = |cell: &String| plain(cell).replace('\n', "\\n");
    let rows: Vec<Vec<String>> = rows.iter().map(|row| row.iter().map(cell).collect()).collect();
    let width = |k: usize| rows.iter().map(|row| row[k].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let mut text = String::new();
    for row in &rows {
        let line: String = row.iter().zip(&widths).map(|(cell, width)| format!("  {cell:<width$}")).collect();
        let _ = writeln!(text, "{}", line.trim_end());
    }
    text
}

/// Four digits.
pub fn number(x: f64) -> String {
    if x == 0.0 || (1e-2..1e5).contains(&x.abs()) {
        let magnitude = if x == 0.0 { 0 } else { libm::floor(libm::log10(x.abs())) as i32 };
        format!("{x:.*}", (3 - magnitude).max(0) as usize)
    } else {
        format!("{x:.3e}")
    }
}

pub fn size(bytes: f64) -> String {
    scaled(bytes, &[(1e12, "TB"), (1e9, "GB"), (1e6, "MB"), (1e3, "kB"), (1.0, "bytes")])
}

pub fn duration(seconds: f64) -> String {
    scaled(seconds, &[(86400.0, "days"), (3600.0, "h"), (60.0, "min"), (1.0, "s")])
}

/// `x` in the largest unit of which it is more than one and a half, or in the last.
fn scaled(x: f64, units: &[(f64, &str)]) -> String {
    let last = units.len() - 1;
    let (unit, name) = units[units.iter().position(|(unit, _)| x > 1.5 * unit).unwrap_or(last)];
    let digits = if x < 10.0 * unit { 1 } else { 0 };
    format!("{:.digits$} {name}", x / unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!(
            [0.0, 0.0675, 2.5, 1236.0, 20012.0, 1.5e-3].map(number),
            ["0.000", "0.06750", "2.500", "1236", "20012", "1.500e-3"]
        );
        assert_eq!([900.0, 2500.0, 3.2e7, 5e13].map(size), ["900 bytes", "2.5 kB", "32 MB", "50 TB"]);
        assert_eq!([0.25, 80.0, 100.0, 7200.0, 1e6].map(duration), ["0.2 s", "80 s", "1.7 min", "2.0 h", "12 days"]);
    }
}
