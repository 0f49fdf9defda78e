//! Pictures drawn by the program itself, with a font of its own: no Python, no fonts of the machine.

pub mod colours;
pub mod curves;
pub mod cut;
pub mod raster;
pub mod scale;
pub mod trade_off;

use std::path::Path;

use plotters::prelude::*;
use plotters::style::{FontStyle, register_font};

use crate::error::{Error, Result};

/// DejaVu Sans; its licence lies beside it.
static FONT: &[u8] = include_bytes!("../fonts/DejaVuSans.ttf");

/// Draws onto a white canvas of that size and writes it as PNG.
fn paint(
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
