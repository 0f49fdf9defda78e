//! Picture of the outcome: a cut through the bodies. On the left damage, else distention (grey: initial black, fully compacted
//! white), else the filling factor of dust (other matter counts as full), else density; on the right ejecta (dark), where the scene gives an ejection speed, else peak
//! pressure, else speed.

use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::colours::{Shades, shade};
use super::paint;
use super::raster::{Dot, Plane, Raster, rasterise, window};
use super::scale::{Scale, number};
use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::material::BodyConstants;
use crate::material::dust::FILLING_FACTOR;
use crate::material::porosity::DISTENTION;
use crate::material::record::PEAK_PRESSURE;
use crate::math::Vec3;
use crate::output::agree;
use crate::particles::{Column, Columns, ParticleId};

/// Pixels of a panel's side.
const SIDE: usize = 640;
const LEFT: i32 = 92;
const TOP: i32 = 92;
const PANEL_WIDTH: i32 = 890;
const SIZE: (u32, u32) = (2 * PANEL_WIDTH as u32, 820);
/// Largest over smallest value beyond which a quantity that spans orders of magnitude gets a logarithmic colour bar.
const SPAN: f64 = 100.0;
/// Background without matter, behind greys.
const SKY: RGBColor = RGBColor(222, 232, 242);

/// The plane and the quantities to be drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    pub title: String,
    pub plane: Plane,
    /// Axis and speed (m/s) along it from which on matter counts as ejected.
    pub ejected: Option<(usize, f64)>,
    /// The largest distention that a body starts with.
    pub distention: f64,
}

/// The quantity of a panel.
struct Quantity {
    title: String,
    unit: &'static str,
    /// Known limits of the values, where there are some.
    limits: Option<(f64, f64)>,
    /// May span orders of magnitude.
    wide: bool,
    /// Values from here on do not widen the range of the colours.
    below: f64,
    shades: Shades,
    value: Source,
}

impl Quantity {
    fn new(title: &str, unit: &'static str, value: Source) -> Self {
        Self {
            title: title.into(),
            unit,
            limits: None,
            wide: false,
            below: f64::INFINITY,
            shades: Shades::Colours,
            value,
        }
    }
}

enum Source {
    Column(Column<f64>),
    Speed(Column<Vec3>),
    /// One where the velocity along an axis is above a speed, else zero.
    Faster(Column<Vec3>, usize, f64),
}

impl Source {
    fn of(&self, columns: &Columns, i: usize) -> f64 {
        match self {
            Source::Column(column) => columns.get(*column, i),
            Source::Speed(velocity) => columns.get(*velocity, i).norm(),
            Source::Faster(velocity, axis, speed) => f64::from(columns.get(*velocity, i)[*axis] > *speed),
        }
    }
}

/// Draws a cut to a PNG file. Collective; the picture is the same for any number of ranks.
pub fn draw(path: &Path, picture: &Picture, columns: &Columns, bodies: &[BodyConstants], comm: &Comm) -> Result<()> {
    let quantities = [left(picture, columns)?, right(picture, columns)?];
    let dots = dots(columns, bodies, &quantities)?;
    let plane = &picture.plane;
    let raster = rasterise(plane, window(plane, &dots, SIDE, comm), &dots, comm);
    let mine = if comm.is_root() { paint_panels(path, picture, &raster, &quantities) } else { Ok(()) };
    agree(comm, mine)
}

fn needed<T: crate::particles::Element>(columns: &Columns, name: &str) -> Result<Column<T>> {
    columns.registry.find(name).ok_or_else(|| Error::new(format!("the picture of a cut needs the column {name}")))
}

fn left(picture: &Picture, columns: &Columns) -> Result<Quantity> {
    let scalar = |name| columns.registry.find::<f64>(name).map(Source::Column);
    if let Some(value) = scalar("damage") {
        return Ok(Quantity { limits: Some((0.0, 1.0)), ..Quantity::new("Damage", "", value) });
    }
    if let Some(value) = scalar(DISTENTION) {
        let limits = Some((1.0, picture.distention));
        return Ok(Quantity { limits, shades: Shades::Greys, ..Quantity::new("Distention", "", value) });
    }
    if let Some(value) = scalar(FILLING_FACTOR) {
        // Of dust: other matter is full.
        return Ok(Quantity { wide: true, below: 1.0, ..Quantity::new("Filling factor", "", value) });
    }
    Ok(Quantity::new("Density", "kg/m³", Source::Column(needed(columns, "density")?)))
}

fn right(picture: &Picture, columns: &Columns) -> Result<Quantity> {
    if let Some((axis, speed)) = picture.ejected {
        let title = format!("Dark: faster than {} m/s upwards", number(speed));
        let value = Source::Faster(needed(columns, "velocity")?, axis, speed);
        return Ok(Quantity {
            limits: Some((0.0, 1.0)),
            shades: Shades::LightAndDark,
            ..Quantity::new(&title, "", value)
        });
    }
    if let Some(peak) = columns.registry.find::<f64>(PEAK_PRESSURE) {
        return Ok(Quantity { wide: true, ..Quantity::new("Peak pressure", "Pa", Source::Column(peak)) });
    }
    let value = Source::Speed(needed(columns, "velocity")?);
    Ok(Quantity { wide: true, ..Quantity::new("Speed", "m/s", value) })
}

fn dots(columns: &Columns, bodies: &[BodyConstants], quantities: &[Quantity; 2]) -> Result<Vec<Dot>> {
    let (id, position) = (needed::<ParticleId>(columns, "id")?, needed::<Vec3>(columns, "position")?);
    let dot = |i: usize| {
        let id = columns.get(id, i);
        // Three quarters of the spacing h / 1.2: beyond the farthest hole of a lattice, so that whole rock has no gaps.
        let reach = 0.75 * bodies[id.body()].smoothing_length / 1.2;
        let values = [0, 1].map(|panel| quantities[panel].value.of(columns, i));
        Dot { id: id.0, position: columns.get(position, i), reach, values }
    };
    Ok((0..columns.len()).map(dot).collect())
}

fn paint_panels(path: &Path, picture: &Picture, raster: &Raster, quantities: &[Quantity; 2]) -> Result<()> {
    paint(path, SIZE, |root| {
        let text = ("sans-serif", 26).into_font().color(&BLACK).pos(Pos::new(HPos::Center, VPos::Top));
        root.draw(&Text::new(picture.title.clone(), (SIZE.0 as i32 / 2, 14), text)).map_err(|e| e.to_string())?;
        let panels = root.split_evenly((1, 2));
        for ((panel, quantity), values) in panels.iter().zip(quantities).zip(&raster.panels) {
            draw_panel(panel, quantity, values, &picture.plane, raster).map_err(|e| e.to_string())?;
        }
        Ok(())
    })
}

type Area<'a> = DrawingArea<BitMapBackend<'a>, Shift>;
type Drawn<'a> = std::result::Result<(), DrawingAreaErrorKind<<BitMapBackend<'a> as DrawingBackend>::ErrorType>>;

fn draw_panel<'a>(area: &Area<'a>, quantity: &Quantity, values: &[f64], plane: &Plane, raster: &Raster) -> Drawn<'a> {
    let scale = colour_scale(quantity, values);
    let side = SIDE as i32;
    if quantity.shades == Shades::Greys {
        // White is a value there.
        area.draw(&Rectangle::new([(LEFT, TOP), (LEFT + side - 1, TOP + side - 1)], SKY.filled()))?;
    }
    for (pixel, value) in values.iter().enumerate().filter(|(_, value)| !value.is_nan()) {
        let (row, column) = ((pixel / SIDE) as i32, (pixel % SIDE) as i32);
        area.draw_pixel((LEFT + column, TOP + side - 1 - row), &shade(quantity.shades, scale.fraction(*value)))?;
    }
    let heading = style(22).pos(Pos::new(HPos::Center, VPos::Bottom));
    area.draw(&Text::new(quantity.title.as_str(), (LEFT + side / 2, TOP - 10), heading))?;
    draw_axes(area, plane, raster)?;
    if quantity.shades == Shades::LightAndDark { Ok(()) } else { draw_bar(area, quantity, &scale) }
}

fn style(size: i32) -> TextStyle<'static> {
    ("sans-serif", size).into_font().color(&BLACK)
}

/// The colours' range: known limits, or the values in the picture without the outermost half per cent.
fn colour_scale(quantity: &Quantity, values: &[f64]) -> Scale {
    let mut sorted: Vec<f64> = values.iter().copied().filter(|v| v.is_finite() && *v < quantity.below).collect();
    sorted.sort_by(f64::total_cmp);
    let at = |share: f64| sorted.get((share * (sorted.len().max(1) - 1) as f64) as usize).copied().unwrap_or(0.0);
    let (low, high) = quantity.limits.unwrap_or((at(0.005), at(0.995)));
    if quantity.wide && high > 0.0 && high > SPAN * low.max(0.0) {
        let positive = sorted.iter().position(|v| *v > 0.0).unwrap_or(0);
        let low = sorted[positive + (sorted.len() - positive) / 50];
        // At most four decades: lower values are noise.
        return Scale { low: low.clamp(1e-4 * high, 0.5 * high), high, logarithmic: true };
    }
    let room = if high > low { 0.0 } else { (1e-3 * high.abs()).max(1e-3) };
    Scale { low: low - room, high: high + room, logarithmic: false }
}

/// A unit of length in which the window is a handy number.
fn length_unit(half: f64) -> (f64, &'static str) {
    let units = [(1e3, "km"), (1.0, "m"), (1e-2, "cm"), (1e-3, "mm")];
    units.into_iter().find(|(size, _)| half >= 2.0 * size).unwrap_or((1e-6, "µm"))
}

/// The coordinate that a direction is, or `otherwise`.
fn axis_name(direction: &Vec3, otherwise: &'static str) -> &'static str {
    let axes = [(Vec3::x(), "x"), (Vec3::y(), "y"), (Vec3::z(), "z")];
    axes.into_iter().find(|(axis, _)| axis == direction).map_or(otherwise, |(_, name)| name)
}

fn draw_axes<'a>(area: &Area<'a>, plane: &Plane, raster: &Raster) -> Drawn<'a> {
    let (window, side) = (&raster.window, SIDE as i32);
    let (unit, unit_name) = length_unit(window.half);
    area.draw(&Rectangle::new([(LEFT - 1, TOP - 1), (LEFT + side, TOP + side)], BLACK))?;
    let below = style(16).pos(Pos::new(HPos::Center, VPos::Top));
    let beside = style(16).pos(Pos::new(HPos::Right, VPos::Center));
    let scale = |axis: usize| {
        let [low, high] = [-1.0, 1.0].map(|end| (window.centre[axis] + end * window.half) / unit);
        Scale { low, high, logarithmic: false }
    };
    let pixel = |fraction: f64| (fraction * side as f64).round() as i32;
    for tick in scale(0).ticks(7) {
        let x = LEFT + pixel(scale(0).fraction(tick));
        area.draw(&PathElement::new([(x, TOP + side), (x, TOP + side + 6)], BLACK))?;
        area.draw(&Text::new(number(tick), (x, TOP + side + 11), below.clone()))?;
    }
    for tick in scale(1).ticks(7) {
        let y = TOP + side - pixel(scale(1).fraction(tick));
        area.draw(&PathElement::new([(LEFT - 6, y), (LEFT - 1, y)], BLACK))?;
        area.draw(&Text::new(number(tick), (LEFT - 11, y), beside.clone()))?;
    }
    let middle = (LEFT + side / 2, TOP + side + 40);
    area.draw(&Text::new(
        format!("{} [{unit_name}]", axis_name(&plane.across, "along the cut")),
        middle,
        style(18).pos(Pos::new(HPos::Center, VPos::Top)),
    ))?;
    let turned = ("sans-serif", 18).into_font().transform(FontTransform::Rotate270).color(&BLACK);
    let left = (16, TOP + side / 2);
    area.draw(&Text::new(
        format!("{} [{unit_name}]", axis_name(&plane.up, "up the cut")),
        left,
        turned.pos(Pos::new(HPos::Center, VPos::Top)),
    ))
}

fn draw_bar<'a>(area: &Area<'a>, quantity: &Quantity, scale: &Scale) -> Drawn<'a> {
    let (left, right, side) = (LEFT + SIDE as i32 + 24, LEFT + SIDE as i32 + 48, SIDE as i32);
    for y in 0..side {
        let shade = shade(quantity.shades, (side - 1 - y) as f64 / (side - 1) as f64);
        area.draw(&PathElement::new([(left, TOP + y), (right, TOP + y)], shade))?;
    }
    area.draw(&Rectangle::new([(left - 1, TOP - 1), (right + 1, TOP + side)], BLACK))?;
    let beside = style(16).pos(Pos::new(HPos::Left, VPos::Center));
    for tick in scale.ticks(7) {
        let y = TOP + side - 1 - (scale.fraction(tick) * (side - 1) as f64).round() as i32;
        area.draw(&PathElement::new([(right + 1, y), (right + 6, y)], BLACK))?;
        area.draw(&Text::new(number(tick), (right + 10, y), beside.clone()))?;
    }
    let above = style(16).pos(Pos::new(HPos::Left, VPos::Bottom));
    area.draw(&Text::new(quantity.unit, (left, TOP - 10), above))
}
