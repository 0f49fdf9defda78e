//! Particles as lines of text: a line of names, `x [km], y [km], z [km], vx [m/s], ...`, then one line per particle, numbers apart
//! by commas, semicolons, tabs or blanks. Lines that begin with # do not count.

use std::collections::BTreeSet;
use std::ops::Range;
use std::path::Path;

use super::file::{Column, Found, Head, MATERIAL, POSITION, ParticleFile, Rows, VELOCITY, size_of_unit};
use crate::scene::document::input;

/// Columns of several numbers, and the names of these.
const SEVERAL: [(&str, &[&str]); 3] = [
    (POSITION, &["x", "y", "z"]),
    (VELOCITY, &["vx", "vy", "vz"]),
    ("deviatoric_stress", &["s_xx", "s_yy", "s_zz", "s_xy", "s_yz", "s_xz"]),
];

/// A column of the file: which number of which column of particles, and the size of its unit.
struct Place {
    column: String,
    component: usize,
    size: f64,
}

struct Table {
    places: Vec<Place>,
    lines: Vec<(usize, Vec<String>)>,
}

fn cells(line: &str) -> Vec<String> {
    let apart = |c: char| [',', ';', '\t'].contains(&c);
    let trimmed = |cell: &str| cell.trim().trim_matches('"').to_string();
    if line.contains(apart) {
        line.split(apart).map(trimmed).collect()
    } else {
        line.split_whitespace().map(trimmed).collect()
    }
}

/// The names of the columns: where blanks separate them, a unit in brackets belongs to the name before it.
fn titles_of(line: &str) -> Vec<String> {
    let mut titles: Vec<String> = Vec::new();
    for cell in cells(line) {
        match titles.last_mut().filter(|_| cell.starts_with(['[', '('])) {
            Some(last) => *last += &cell,
            None => titles.push(cell),
        }
    }
    titles
}

/// `x [km]` or `x (km)` -> where it belongs.
fn place(title: &str) -> Found<Place> {
    let (name, unit) = match title.split_once(['[', '(']) {
        Some((name, rest)) => (name.trim(), Some(rest.trim_end_matches([']', ')']).trim())),
        None => (title.trim(), None),
    };
    let several = SEVERAL.iter().find_map(|(column, names)| Some((*column, names.iter().position(|n| *n == name)?)));
    let (column, component) = several.unwrap_or((name, 0));
    let size = match unit.filter(|unit| !unit.is_empty()) {
        Some(unit) => size_of_unit(column, unit).map_err(|what| format!("`{title}`: {what}"))?,
        None => 1.0,
    };
    Ok(Place { column: column.to_string(), component, size })
}

fn read(file: &ParticleFile) -> Found<Table> {
    let text = input::read_large(Path::new(&file.path))?;
    let counts = |line: &&str| !line.trim().is_empty() && !line.trim_start().starts_with('#');
    let mut lines = (1..).zip(text.lines()).filter(|(_, line)| counts(line));
    let (_, titles) = lines.next().ok_or("it is empty")?;
    let titles = titles_of(titles);
    if titles.iter().all(|title| title.parse::<f64>().is_ok()) {
        return Err("its first line has no names of columns (x, y, z, vx, vy, vz, mass, ...)".into());
    }
    let places = titles.iter().map(|title| place(title)).collect::<Found<Vec<_>>>()?;
    for (n, one) in places.iter().enumerate() {
        if places[..n].iter().any(|other| (&other.column, other.component) == (&one.column, one.component)) {
            return Err(format!("the column `{}` is there twice", titles[n]));
        }
    }
    let lines: Vec<(usize, Vec<String>)> = lines.map(|(number, line)| (number, cells(line))).collect();
    match lines.iter().find(|(_, cells)| cells.len() != places.len()) {
        Some((line, cells)) => Err(format!("line {line}: {} numbers under {} names", cells.len(), places.len())),
        None => Ok(Table { places, lines }),
    }
}

impl Table {
    fn columns(&self) -> Vec<String> {
        let mut names: Vec<String> = Vec::new();
        for place in &self.places {
            if place.column != MATERIAL && !names.contains(&place.column) {
                names.push(place.column.clone());
            }
        }
        names
    }
}

pub fn head(file: &ParticleFile) -> Found<Head> {
    let table = read(file)?;
    let depth = table.places.iter().any(|place| (place.column.as_str(), place.component) == (POSITION, 2));
    Ok(Head {
        rows: table.lines.len() as u64,
        dimension: Some(if depth { 3 } else { 2 }),
        columns: table.columns(),
        ..Head::default()
    })
}

pub fn rows(file: &ParticleFile, rows: Range<u64>, wanted: &dyn Fn(&str) -> bool) -> Found<Rows> {
    let table = read(file)?;
    let lines = &table.lines[rows.start as usize..rows.end as usize];
    let mut found = Rows { count: lines.len(), first: rows.start, ..Rows::default() };
    for name in table.columns().into_iter().filter(|name| wanted(name)) {
        let several = SEVERAL.iter().find(|(column, _)| *column == name);
        let width = several.map_or(1, |(_, names)| names.len());
        let mut values = vec![0.0; width * lines.len()];
        for (k, place) in table.places.iter().enumerate().filter(|(_, place)| place.column == name) {
            for (row, (line, cells)) in lines.iter().enumerate() {
                let number: f64 = cells[k].parse().map_err(|_| format!("line {line}: `{}` is no number", cells[k]))?;
                values[row * width + place.component] = number * place.size;
            }
        }
        found.columns.push(Column { name, width, values });
    }
    if let Some(k) = table.places.iter().position(|place| place.column == MATERIAL) {
        let words: BTreeSet<&String> = table.lines.iter().map(|(_, cells)| &cells[k]).collect();
        found.words = words.into_iter().cloned().collect();
        let number = |word: &String| found.words.binary_search(word).expect("a word of the column") as i64;
        found.kinds = lines.iter().map(|(_, cells)| number(&cells[k])).collect();
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::super::file::Format;
    use super::*;

    fn with(text: &str, act: impl FnOnce(&ParticleFile)) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("p.csv");
        std::fs::write(&path, text).unwrap();
        let path = path.display().to_string();
        act(&ParticleFile { path, format: Format::Text, datasets: BTreeMap::new(), units: BTreeMap::new() });
    }

    #[test]
    fn columns_have_names_and_units() {
        let text = "# of another code\nx [km],y [km],z [km],vy (cm/s),mass [g],material,damage\n\
            1,2,3,50,7,rock,0.5\n\n4,5,6,0,8,iron,0\n";
        with(text, |file| {
            let head = file.head().unwrap();
            assert_eq!((head.rows, head.dimension), (2, Some(3)));
            assert_eq!(head.columns, ["position", "velocity", "mass", "damage"]);
            let rows = file.read(1..2, &|_| true).unwrap();
            assert_eq!(rows.column(POSITION).unwrap().vector(0), [4e3, 5e3, 6e3]);
            assert_eq!((rows.kinds[0], &rows.words[..]), (0, &["iron".to_string(), "rock".to_string()][..]));
            let first = file.read(0..1, &|name| name != "damage").unwrap();
            assert_eq!(first.column(VELOCITY).unwrap().vector(0), [0.0, 0.5, 0.0]);
            assert!(first.column("damage").is_none() && first.column("mass").unwrap().number(0) == 0.007);
        });
    }

    #[test]
    fn what_is_wrong_is_named() {
        for (text, what) in [
            ("", "it is empty"),
            ("1 2 3\n", "no names of columns"),
            ("x y z mass\n1 2 3\n", "line 2: 3 numbers under 4 names"),
            ("x y z mass\n1 2 3 heavy\n", "line 2: `heavy` is no number"),
            ("x y x\n1 2 3\n", "the column `x` is there twice"),
            ("x [kg] y z\n1 2 3\n", "`x[kg]`"),
            ("x y z mass\n1 2 3 nan\n", "mass of particle 0 is NaN"),
        ] {
            with(text, |file| {
                let read = file.head().and_then(|head| file.read(0..head.rows, &|_| true));
                let message = read.unwrap_err();
                assert!(message.contains(what), "{text}: {message}");
            });
        }
    }
}
