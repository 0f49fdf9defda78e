//! Figures of curves and points: M_lr against Q, thresholds against radius, energies against time, size distributions.

use std::path::Path;

use plotters::prelude::*;
use plotters::series::DashedLineSeries;

use super::colours::hue;
use super::paint;
use super::scale::Scale;
use crate::error::Result;

const SIZE: (u32, u32) = (1000, 700);

/// How a series is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    Line,
    Dashed,
    Points,
}

#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Its name in the legend; empty for none.
    pub label: String,
    pub points: Vec<(f64, f64)>,
    /// Half lengths of the points' error bars along y; empty for none.
    pub errors: Vec<f64>,
    pub mark: Mark,
}

#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Quantity with its unit.
    pub label: String,
    pub logarithmic: bool,
}

#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    pub title: String,
    pub x: Axis,
    pub y: Axis,
    pub series: Vec<Series>,
}

impl Figure {
    /// Writes the figure as PNG; for one rank. Points that are not finite, or not positive on a logarithmic axis, are left
    /// out.
    pub fn draw(&self, path: &Path) -> Result<()> {
        paint(path, SIZE, |root| self.draw_on(root).map_err(|e| e.to_string()))
    }

    fn draw_on<'a>(
        &self,
        root: &DrawingArea<BitMapBackend<'a>, plotters::coord::Shift>,
    ) -> std::result::Result<(), DrawingAreaErrorKind<<BitMapBackend<'a> as DrawingBackend>::ErrorType>> {
        let (x, y) = self.scales();
        let mut chart = ChartBuilder::on(root)
            .caption(&self.title, ("sans-serif", 24))
            .margin(16)
            .margin_right(34)
            .x_label_area_size(58)
            .y_label_area_size(96)
            .build_cartesian_2d(x, y)?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(RGBColor(222, 222, 222))
            .x_desc(&self.x.label)
            .y_desc(&self.y.label)
            .axis_desc_style(("sans-serif", 19))
            .label_style(("sans-serif", 16))
            .draw()?;
        for (k, series) in self.series.iter().enumerate() {
            let points = self.shown(series);
            let stroke = hue(k).stroke_width(2);
            let drawn = match series.mark {
                Mark::Line => chart.draw_series(LineSeries::new(points.iter().map(|p| p.0), stroke))?,
                Mark::Dashed => chart.draw_series(DashedLineSeries::new(points.iter().map(|p| p.0), 9, 6, stroke))?,
                Mark::Points => {
                    let bars = points.iter().filter(|p| p.1 > 0.0);
                    chart.draw_series(bars.map(|&((x, y), e)| {
                        let low = if self.y.logarithmic { (y - e).max(1e-3 * y) } else { y - e };
                        ErrorBar::new_vertical(x, low, y, y + e, hue(k).stroke_width(2), 10)
                    }))?;
                    chart.draw_series(points.iter().map(|p| Circle::new(p.0, 5, hue(k).filled())))?
                }
            };
            if !series.label.is_empty() {
                let (strokes, dot) = legend_mark(series.mark);
                // Every entry has the same shape; an unused dot is hidden inside the stroke.
                let (at_dot, radius) = dot.map_or(((9, 0), 0), |at| (at, 5));
                drawn.label(&series.label).legend(move |at| {
                    let stroke = |n: usize| strokes.get(n).map_or(vec![], |ends| ends.to_vec());
                    EmptyElement::at(at)
                        + PathElement::new(stroke(0), hue(k).stroke_width(2))
                        + PathElement::new(stroke(1), hue(k).stroke_width(2))
                        + Circle::new(at_dot, radius, hue(k).filled())
                });
            }
        }
        if self.series.iter().any(|series| !series.label.is_empty()) {
            chart
                .configure_series_labels()
                .position(self.emptiest_corner(&x, &y))
                .margin(14)
                .legend_area_size(44)
                .background_style(WHITE.mix(0.85))
                .border_style(RGBColor(160, 160, 160))
                .label_font(("sans-serif", 16))
                .draw()?;
        }
        Ok(())
    }

    /// Points with the lengths of their error bars, without those that the axes cannot show.
    fn shown(&self, series: &Series) -> Vec<((f64, f64), f64)> {
        let fits = |x: f64, axis: &Axis| x.is_finite() && (x > 0.0 || !axis.logarithmic);
        let points = series.points.iter().enumerate();
        let points = points.map(|(k, &point)| (point, series.errors.get(k).copied().unwrap_or(0.0)));
        points.filter(|((x, y), _)| fits(*x, &self.x) && fits(*y, &self.y)).collect()
    }

    fn scales(&self) -> (Scale, Scale) {
        let all: Vec<((f64, f64), f64)> = self.series.iter().flat_map(|series| self.shown(series)).collect();
        let x = Scale::around(all.iter().map(|((x, _), _)| *x), self.x.logarithmic);
        let ends = all.iter().flat_map(|((_, y), e)| if *e > 0.0 { vec![y - e, y + e] } else { vec![*y] });
        (x, Scale::around(ends, self.y.logarithmic))
    }

    /// The corner with the fewest points, for the legend.
    fn emptiest_corner(&self, x: &Scale, y: &Scale) -> SeriesLabelPosition {
        let corners = [
            (SeriesLabelPosition::UpperRight, [1.0, 1.0]),
            (SeriesLabelPosition::UpperLeft, [0.0, 1.0]),
            (SeriesLabelPosition::LowerLeft, [0.0, 0.0]),
            (SeriesLabelPosition::LowerRight, [1.0, 0.0]),
        ];
        let crowd = |corner: &[f64; 2]| {
            let near = |point: &((f64, f64), f64)| {
                let (at_x, at_y) = (x.fraction(point.0.0), y.fraction(point.0.1));
                (at_x - corner[0]).abs() < 0.45 && (at_y - corner[1]).abs() < 0.3
            };
            self.series.iter().map(|s| self.shown(s).iter().filter(|p| near(p)).count()).sum::<usize>()
        };
        let best = corners.into_iter().min_by_key(|(_, corner)| crowd(corner));
        best.map_or(SeriesLabelPosition::UpperRight, |(position, _)| position)
    }
}

/// Pixels right and down of a sample's left end in the legend.
type Offset = (i32, i32);

/// Strokes and dots of a mark in the legend.
fn legend_mark(mark: Mark) -> (Vec<[Offset; 2]>, Option<Offset>) {
    match mark {
        Mark::Line => (vec![[(4, 0), (34, 0)]], None),
        Mark::Dashed => (vec![[(4, 0), (15, 0)], [(23, 0), (34, 0)]], None),
        Mark::Points => (vec![], Some((19, 0))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn figure(points: Vec<(f64, f64)>) -> Figure {
        let axis = |label: &str, logarithmic| Axis { label: label.into(), logarithmic };
        let series = Series { label: "impacts".into(), errors: vec![0.05; points.len()], points, mark: Mark::Points };
        Figure { title: "t".into(), x: axis("Q [J/kg]", true), y: axis("M", false), series: vec![series] }
    }

    #[test]
    fn points_that_cannot_be_shown_are_left_out() {
        let figure = figure(vec![(0.0, 1.0), (10.0, 0.5), (f64::NAN, 0.1), (20.0, f64::INFINITY)]);
        assert_eq!(figure.shown(&figure.series[0]), [((10.0, 0.5), 0.05)]);
    }

    #[test]
    fn draws_a_png_even_of_nothing() {
        let directory = tempfile::tempdir().unwrap();
        for (name, points) in [("some.png", vec![(1e5, 0.9), (1e7, 0.1)]), ("none.png", vec![])] {
            let path = directory.path().join(name);
            figure(points).draw(&path).unwrap();
            assert_eq!(&std::fs::read(&path).unwrap()[..8], b"\x89PNG\r\n\x1a\n");
        }
    }

    #[test]
    fn an_unwritable_place_is_an_error() {
        let error = figure(vec![(1.0, 1.0)]).draw(Path::new("/nowhere/at/all.png")).unwrap_err();
        assert!(error.what.contains("cannot draw") && error.place == "/nowhere/at/all.png");
    }
}
