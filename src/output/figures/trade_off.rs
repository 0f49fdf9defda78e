//! Error against cost: one curve for each setting, the Pareto front marked, the legend beside the axes, where it hides no
//! point for any number of settings.

use std::path::Path;

use plotters::prelude::*;
use plotters::series::DashedLineSeries;

use super::colours::{HUES, hue};
use super::paint;
use super::scale::Scale;
use crate::error::Result;

/// One setting, from coarse to fine.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    pub label: String,
    /// Cost and error.
    pub points: Vec<(f64, f64)>,
}

#[derive(Debug, Clone, PartialEq)]
pub struct TradeOff {
    pub title: String,
    /// Label of the axis of cost.
    pub cost: String,
    pub error: String,
    pub curves: Vec<Curve>,
    /// From cheap to expensive.
    pub front: Vec<(f64, f64)>,
    /// Requested errors, with their names.
    pub targets: Vec<(String, f64)>,
}

const CHART: (u32, u32) = (900, 700);
const ROW: i32 = 27;
/// Mean width of a letter of the legend, and the width beside its texts.
const LETTER: f64 = 8.2;
const SAMPLE: i32 = 52;
const GREY: RGBColor = RGBColor(150, 150, 150);
const FRONT: RGBColor = RGBColor(30, 30, 30);

type Area<'a> = DrawingArea<BitMapBackend<'a>, plotters::coord::Shift>;
type Drawn<'a> = std::result::Result<(), DrawingAreaErrorKind<<BitMapBackend<'a> as DrawingBackend>::ErrorType>>;

impl TradeOff {
    /// Writes the figure as PNG; for one rank. Points without a positive cost and error are left out.
    pub fn draw(&self, path: &Path) -> Result<()> {
        let longest = self.curves.iter().map(|curve| curve.label.chars().count()).max().unwrap_or(0).max(12);
        let width = CHART.0 + SAMPLE as u32 + (LETTER * longest as f64) as u32 + 16;
        let height = CHART.1.max((self.curves.len() as i32 * ROW + 140) as u32);
        paint(path, (width, height), |root| {
            let (chart, legend) = root.split_horizontally(CHART.0);
            self.draw_chart(&chart).and_then(|()| self.draw_legend(&legend)).map_err(|e| e.to_string())
        })
    }

    fn draw_chart<'a>(&self, root: &Area<'a>) -> Drawn<'a> {
        let (x, y) = self.scales();
        let mut chart = ChartBuilder::on(root)
            .caption(&self.title, ("sans-serif", 24))
            .margin(16)
            .x_label_area_size(58)
            .y_label_area_size(96)
            .build_cartesian_2d(x, y)?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(RGBColor(222, 222, 222))
            .x_desc(&self.cost)
            .y_desc(&self.error)
            .axis_desc_style(("sans-serif", 19))
            .label_style(("sans-serif", 16))
            .draw()?;
        for (name, error) in self.targets.iter().filter(|target| (0.0..1.0).contains(&y.fraction(target.1))) {
            let line = [(x.low, *error), (x.high, *error)];
            chart.draw_series(DashedLineSeries::new(line, 3, 5, GREY.stroke_width(1)))?;
            let above = (x.low, *error);
            chart.draw_series([EmptyElement::at(above) + Text::new(name.clone(), (6, -18), ("sans-serif", 15))])?;
        }
        chart.draw_series(LineSeries::new(self.front.iter().copied(), FRONT.mix(0.25).stroke_width(9)))?;
        for (k, curve) in self.curves.iter().enumerate() {
            let points = shown(&curve.points);
            if is_dashed(k) {
                chart.draw_series(DashedLineSeries::new(points.iter().copied(), 7, 5, hue(k).stroke_width(2)))?;
            } else {
                chart.draw_series(LineSeries::new(points.iter().copied(), hue(k).stroke_width(2)))?;
            }
            chart.draw_series(points.iter().map(|at| Circle::new(*at, 5, dot(k))))?;
        }
        chart.draw_series(self.front.iter().map(|at| Circle::new(*at, 9, FRONT.stroke_width(2))))?;
        Ok(())
    }

    fn draw_legend<'a>(&self, area: &Area<'a>) -> Drawn<'a> {
        let font = ("sans-serif", 16);
        let text = |label: &str, y: i32| Text::new(label.to_string(), (SAMPLE, y - 8), font);
        for (k, curve) in self.curves.iter().enumerate() {
            let y = 70 + k as i32 * ROW;
            let strokes: &[[i32; 2]] = if is_dashed(k) { &[[6, 16], [32, 42]] } else { &[[6, 42]] };
            for [from, to] in strokes {
                area.draw(&PathElement::new(vec![(*from, y), (*to, y)], hue(k).stroke_width(2)))?;
            }
            area.draw(&Circle::new((24, y), 5, dot(k)))?;
            area.draw(&text(&curve.label, y))?;
        }
        let y = 70 + self.curves.len() as i32 * ROW + 8;
        area.draw(&PathElement::new(vec![(6, y), (42, y)], FRONT.mix(0.25).stroke_width(9)))?;
        area.draw(&Circle::new((24, y), 9, FRONT.stroke_width(2)))?;
        area.draw(&text("Pareto front", y))
    }

    /// Every point, and the targets that are not far from them.
    fn scales(&self) -> (Scale, Scale) {
        let all: Vec<(f64, f64)> = self.curves.iter().flat_map(|curve| shown(&curve.points)).collect();
        let x = Scale::around(all.iter().map(|p| p.0), true);
        let points = Scale::around(all.iter().map(|p| p.1), true);
        let near = self.targets.iter().map(|t| t.1).filter(|t| *t > 0.2 * points.low && *t < 5.0 * points.high);
        (x, Scale::around(all.iter().map(|p| p.1).chain(near), true))
    }
}

/// When all colours are used they repeat, with other lines and dots.
fn is_dashed(k: usize) -> bool {
    k / HUES.len() % 2 == 1
}

fn dot(k: usize) -> ShapeStyle {
    if is_dashed(k) { hue(k).stroke_width(2) } else { hue(k).filled() }
}

fn shown(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let fits = |x: f64| x.is_finite() && x > 0.0;
    points.iter().copied().filter(|(x, y)| fits(*x) && fits(*y)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn draws_many_settings_and_none() {
        let directory = tempfile::tempdir().unwrap();
        for settings in [0, 1, 40] {
            let curve = |k: usize| Curve {
                label: format!("setting {k}"),
                points: (1..5)
                    .map(|n| (10f64.powi(n), (1.0 + 0.1 * k as f64) / n as f64))
                    .chain([(0.0, 1.0)])
                    .collect(),
            };
            let figure = TradeOff {
                title: "t".into(),
                cost: "core-seconds".into(),
                error: "error".into(),
                curves: (0..settings).map(curve).collect(),
                front: vec![(10.0, 1.0), (1e4, 0.25)],
                targets: vec![("50 %".into(), 0.5), ("far away".into(), 1e-9)],
            };
            let path = directory.path().join(format!("{settings}.png"));
            figure.draw(&path).unwrap();
            assert_eq!(&std::fs::read(&path).unwrap()[..8], b"\x89PNG\r\n\x1a\n");
            assert!(figure.scales().1.low > 0.05);
        }
    }
}
