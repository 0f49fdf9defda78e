//! Pictures drawn by the program itself, with a built-in font: no Python, no fonts of the machine.

pub mod colours;
pub mod curves;
pub mod cut;
pub mod map;
pub mod raster;
pub mod scale;
pub mod trade_off;

use std::fs::{self, File};
use std::io::{Read, Seek, SeekFrom};
use std::path::Path;

use plotters::prelude::*;
use plotters::style::{FontStyle, register_font};

use super::publish::{cannot, sync_directory_of};
use crate::error::{Error, Result};

/// DejaVu Sans; its licence lies beside it.
static FONT: &[u8] = include_bytes!("../fonts/DejaVuSans.ttf");

/// The last chunk of every PNG.
const LAST_CHUNK: [u8; 12] = *b"\0\0\0\0IEND\xae\x42\x60\x82";

/// A picture that could not be drawn gives only a warning: its data are in tables and figures too. For the rank that
/// logs.
pub fn or_warn(drawn: Result<()>) {
    if let Err(error) = drawn {
        tracing::warn!("a picture is missing: {error}");
    }
}

/// Draws onto a white canvas of that size and writes it as PNG, which appears whole or not at all.
fn paint(
    path: &Path,
    size: (u32, u32),
    draw: impl FnOnce(&DrawingArea<BitMapBackend, plotters::coord::Shift>) -> std::result::Result<(), String>,
) -> Result<()> {
    // The encoder takes the format from the name.
    let temporary = path.with_extension("tmp.png");
    let painted = paint_at(&temporary, size, draw).and_then(|()| {
        require_whole(&temporary).map_err(|e| cannot("write", path, e))?;
        fs::rename(&temporary, path).map_err(|e| cannot("rename", &temporary, e))
    });
    if painted.is_err() {
        // The first error is the one to be reported.
        let _ = fs::remove_file(&temporary);
    }
    painted.and_then(|()| sync_directory_of(path)).map_err(|e| e.at(path.display().to_string()))
}

/// The encoder does not report a disk that was full for the last of its bytes.
fn require_whole(path: &Path) -> std::io::Result<()> {
    let mut file = File::open(path)?;
    file.sync_all()?;
    let mut last = [0; LAST_CHUNK.len()];
    file.seek(SeekFrom::End(-(last.len() as i64)))?;
    file.read_exact(&mut last)?;
    if last == LAST_CHUNK { Ok(()) } else { Err(std::io::ErrorKind::UnexpectedEof.into()) }
}

fn paint_at(
    path: &Path,
    size: (u32, u32),
    draw: impl FnOnce(&DrawingArea<BitMapBackend, plotters::coord::Shift>) -> std::result::Result<(), String>,
) -> Result<()> {
    let failed = |what: String| Error::new(format!("cannot draw: {what}")).at(path.display().to_string());
    register_font("sans-serif", FontStyle::Normal, FONT).map_err(|_| failed("the font is unreadable".into()))?;
    let root = BitMapBackend::new(path, size).into_drawing_area();
    root.fill(&WHITE).map_err(|e| failed(e.to_string()))?;
    draw(&root).map_err(failed)?;
    root.present().map_err(|e| failed(e.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_appears_whole_or_not_at_all() {
        let folder = tempfile::tempdir().unwrap();
        let (path, temporary) = (folder.path().join("a.png"), folder.path().join("a.tmp.png"));
        paint(&path, (40, 30), |_| Ok(())).unwrap();
        let whole = fs::read(&path).unwrap();
        assert!(whole.ends_with(&LAST_CHUNK) && !temporary.exists());
        // A picture that cannot be drawn leaves the existing one.
        assert!(paint(&path, (40, 30), |_| Err("no".into())).is_err());
        assert!(fs::read(&path).unwrap() == whole && !temporary.exists());
        // The place is taken.
        fs::create_dir_all(folder.path().join("b.png/c")).unwrap();
        let error = paint(&folder.path().join("b.png"), (40, 30), |_| Ok(())).unwrap_err();
        assert!(error.what.starts_with("cannot rename") && !folder.path().join("b.tmp.png").exists(), "{error}");
        fs::write(&path, &whole[..whole.len() - 1]).unwrap();
        assert!(require_whole(&path).is_err(), "a picture that lacks its end");
    }
}
