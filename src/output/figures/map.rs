//! A map of words over two things that were varied: a cell for each pair of values, coloured by its word.

use std::path::Path;

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::colours::HUES;
use super::paint;
use crate::error::Result;

/// What is varied along one side.
#[derive(Debug, Clone, PartialEq)]
pub struct Side {
    pub label: String,
    pub values: Vec<String>,
}

#[derive(Debug, Clone, PartialEq)]
pub struct WordMap {
    pub title: String,
    /// From left to right.
    pub x: Side,
    /// From the bottom up.
    pub y: Side,
    /// The words, row by row of y; `None` where there is none.
    pub cells: Vec<Vec<Option<String>>>,
}

const CELL: (i32, i32) = (120, 70);
const MARGIN: (i32, i32) = (150, 60);
const BELOW: i32 = 90;
const EMPTY: RGBColor = RGBColor(225, 225, 225);

type Area<'a> = DrawingArea<BitMapBackend<'a>, plotters::coord::Shift>;
type Drawn<'a> = std::result::Result<(), DrawingAreaErrorKind<<BitMapBackend<'a> as DrawingBackend>::ErrorType>>;

impl WordMap {
    /// Writes the figure as PNG; for one rank.
    pub fn draw(&self, path: &Path) -> Result<()> {
        let (columns, rows) = (self.x.values.len() as i32, self.y.values.len() as i32);
        let width = MARGIN.0 + CELL.0 * columns.max(3) + 30;
        let height = MARGIN.1 + CELL.1 * rows + BELOW;
        paint(path, (width as u32, height as u32), |root| self.draw_on(root).map_err(|e| e.to_string()))
    }

    fn draw_on<'a>(&self, root: &Area<'a>) -> Drawn<'a> {
        let words = self.words();
        let centred = Pos::new(HPos::Center, VPos::Center);
        let style = |size: i32, ink: RGBColor| ("sans-serif", size).with_color(ink).into_text_style(root).pos(centred);
        let (columns, rows) = (self.x.values.len() as i32, self.y.values.len() as i32);
        let bottom = MARGIN.1 + CELL.1 * rows;
        let middle = MARGIN.0 + CELL.0 * columns / 2;
        root.draw(&Text::new(self.title.clone(), (middle, MARGIN.1 / 2), style(22, BLACK)))?;
        for (row, cells) in self.cells.iter().enumerate() {
            let low = bottom - CELL.1 * row as i32;
            for (column, cell) in cells.iter().enumerate() {
                let left = MARGIN.0 + CELL.0 * column as i32;
                let known = cell.as_ref().and_then(|word| words.iter().position(|other| *other == word));
                let (fill, ink) = known.map_or((EMPTY, BLACK), |k| (HUES[k % HUES.len()], WHITE));
                let corners = [(left + 1, low - CELL.1 + 1), (left + CELL.0 - 1, low - 1)];
                root.draw(&Rectangle::new(corners, fill.filled()))?;
                let text = cell.clone().unwrap_or_else(|| "–".into());
                root.draw(&Text::new(text, (left + CELL.0 / 2, low - CELL.1 / 2), style(17, ink)))?;
            }
        }
        for (k, value) in self.x.values.iter().enumerate() {
            let at = (MARGIN.0 + CELL.0 * k as i32 + CELL.0 / 2, bottom + 18);
            root.draw(&Text::new(value.clone(), at, style(16, BLACK)))?;
        }
        for (k, value) in self.y.values.iter().enumerate() {
            let at = (MARGIN.0 - 40, bottom - CELL.1 * k as i32 - CELL.1 / 2);
            root.draw(&Text::new(value.clone(), at, style(16, BLACK)))?;
        }
        root.draw(&Text::new(self.x.label.clone(), (middle, bottom + 55), style(19, BLACK)))?;
        let turned = TextStyle::from(("sans-serif", 19).into_font().transform(FontTransform::Rotate270)).pos(centred);
        root.draw(&Text::new(self.y.label.clone(), (30, MARGIN.1 + CELL.1 * rows / 2), turned))
    }

    /// All words, in alphabetical order, so that maps of the same words have the same colours.
    fn words(&self) -> Vec<&String> {
        let mut words: Vec<&String> = self.cells.iter().flatten().flatten().collect();
        words.sort();
        words.dedup();
        words
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_map_is_drawn_with_empty_cells_too() {
        let side =
            |label: &str, values: [&str; 2]| Side { label: label.into(), values: values.map(String::from).to_vec() };
        let map = WordMap {
            title: "Outcomes".into(),
            x: side("speed", ["1 m/s", "2 m/s"]),
            y: side("filling factor", ["0.1", "0.3"]),
            cells: vec![vec![Some("sticking".into()), None], vec![Some("bouncing".into()), Some("sticking".into())]],
        };
        assert_eq!(map.words(), ["bouncing", "sticking"]);
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("map.png");
        map.draw(&path).unwrap();
        assert!(std::fs::metadata(path).unwrap().len() > 1000);
    }
}
