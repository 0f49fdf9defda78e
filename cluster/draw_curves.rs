//! Draws a figure of curves from a table: `draw_curves FIGURE.png TITLE X Y <curves.csv`, with X and Y the labels of the axes,
//! both logarithmic. A row holds the name of its series, how that is drawn (line, dashed or points), x and y.

use std::io::BufRead;
use std::path::Path;

use sph_mpi::error::{Error, Result};
use sph_mpi::output::figures::curves::{Axis, Figure, Mark, Series};

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let drawn = match &arguments[..] {
        [figure, title, x, y] => draw(Path::new(figure), title, [x, y]),
        _ => {
            Err(Error::new("four arguments are wanted").allowed("FIGURE.png TITLE X Y, and a table on standard input"))
        }
    };
    if let Err(error) = drawn {
        eprintln!("error: {error}");
        std::process::exit(2);
    }
}

fn draw(path: &Path, title: &str, labels: [&str; 2]) -> Result<()> {
    let mut series: Vec<Series> = Vec::new();
    for line in std::io::stdin().lock().lines() {
        let line = line?;
        let (label, mark, point) = row(&line)?;
        match series.iter_mut().find(|series| series.label == label) {
            Some(series) => series.points.push(point),
            None => series.push(Series { label, points: vec![point], errors: Vec::new(), mark }),
        }
    }
    let [x, y] = labels.map(|label| Axis { label: label.to_string(), logarithmic: true });
    Figure { title: title.to_string(), x, y, series }.draw(path)
}

fn row(line: &str) -> Result<(String, Mark, (f64, f64))> {
    let bad = || Error::new(format!("`{line}` is no row")).allowed("series,line|dashed|points,x,y");
    let mut cells = line.trim_end().rsplitn(4, ',');
    let mut next = || cells.next().ok_or_else(bad);
    let (y, x, mark, label) = (next()?, next()?, next()?, next()?);
    let mark = match mark {
        "line" => Mark::Line,
        "dashed" => Mark::Dashed,
        "points" => Mark::Points,
        _ => return Err(bad()),
    };
    let number = |text: &str| text.parse::<f64>().map_err(|_| bad());
    Ok((label.trim_matches('"').to_string(), mark, (number(x)?, number(y)?)))
}
