//! The particles of a run's snapshots, or of its checkpoint where there are none, as the page takes them: the same share of them in every snapshot, places in 16 bits per
//! coordinate, columns in 8 bits per number, so that a report stays below 20 MB.

use std::collections::BTreeMap;
use std::path::Path;

use serde_json::{Value as Json, json};

use super::checkpoint;
use crate::output::figures::colours::colour;
use crate::particles::ParticleId;
use crate::random::uniform;
use crate::scene::given::file::{Column, POSITION};
use crate::scene::given::{FIELDS, Format, Label, ParticleFile, labels};

/// Bytes of all snapshots at most, before they are written as text of 4/3 the length.
const BUDGET: f64 = 11e6;
/// Snapshots at most; of more, some evenly through the run.
const SNAPSHOTS: usize = 40;
/// Rows that are read at a time.
const ROWS: u64 = 1 << 20;
/// Particles farther from the middle than so many sizes of the first snapshot are left out.
const FAR: f64 = 20.0;
/// Seed of the choice of particles.
const SEED: u64 = 20;
/// Parts of the values that lie beyond either end of the scale.
const BEYOND: f64 = 0.002;
/// Ranges of values beyond which a scale is logarithmic.
const DECADES: f64 = 1e3;
/// Where half of the values are so many times smaller than the highest, a scale is logarithmic, too, over [`DECADES`] below it.
const MOSTLY_SMALL: f64 = 1e2;
/// Colours of the map.
const COLOURS: usize = 256;
/// Columns that say little in colours, and are shown last.
const FIRST_SHOWN: [&str; 6] = ["damage", "pressure", "filling_factor", "density", "speed", "body"];

/// Particles for a page.
pub struct Cloud {
    /// What the script has to know.
    pub about: Json,
    /// Of each snapshot: places (x, y, z of each particle), then each column.
    pub snapshots: Vec<Vec<u8>>,
}

/// A snapshot as it is read: values of the chosen particles.
struct Read {
    time: f64,
    position: Vec<[f64; 3]>,
    columns: BTreeMap<String, Vec<f64>>,
}

/// The particles in `directory`; none where there are none.
pub fn read(directory: &Path) -> Result<Option<Cloud>, String> {
    let open = |name: &String| ParticleFile {
        path: directory.join(name).display().to_string(),
        format: Format::Snapshot,
        datasets: BTreeMap::new(),
        units: BTreeMap::new(),
    };
    let mut files: Vec<ParticleFile> = series(directory).iter().map(open).collect();
    let mut fields = files.last().map(|last| labels(&last.path, FIELDS)).transpose()?.unwrap_or_default();
    if files.is_empty() {
        let Some(found) = checkpoint::open(directory) else { return Ok(None) };
        fields = found.labels;
        files.push(found.file);
    }
    let last = files.last().expect("one or more");
    let labels: Vec<Label> = fields.into_iter().filter_map(shown).collect();
    let total = last.head()?.rows;
    let share = BUDGET / files.len() as f64 / (6 + labels.len()) as f64 / total.max(1) as f64;
    let mut snapshots = files.iter().map(|file| snapshot(file, share)).collect::<Result<Vec<Read>, String>>()?;
    let (middle, size) = extent(&snapshots[0].position);
    snapshots.iter_mut().for_each(|read| read.leave_out(&middle, FAR * size));
    let scales: Vec<(Label, Scale)> =
        labels.into_iter().filter_map(|label| Some((label.clone(), Scale::of(&snapshots, &label.name)?))).collect();
    let usual = FIRST_SHOWN.iter().find_map(|name| scales.iter().position(|(label, _)| label.name == *name));
    let boxes: Vec<[[f64; 3]; 2]> = snapshots.iter().map(|read| corners(&read.position)).collect();
    let about = json!({
        "total": total,
        "usual": usual.unwrap_or(0),
        "size": spacing(&snapshots[0]),
        "colours": (0..COLOURS).map(|k| {
            let found = colour(k as f64 / (COLOURS - 1) as f64);
            [found.0, found.1, found.2]
        }).collect::<Vec<_>>(),
        "columns": scales.iter().map(|(label, scale)| json!({
            "name": label.name, "unit": label.unit, "about": label.about,
            "low": scale.low, "high": scale.high, "logarithmic": scale.logarithmic,
        })).collect::<Vec<_>>(),
        "snapshots": snapshots.iter().zip(&boxes).map(|(read, [low, high])| json!({
            "time": read.time, "count": read.position.len(), "low": low, "high": high,
        })).collect::<Vec<_>>(),
    });
    let bytes = snapshots.iter().zip(&boxes).map(|(read, corners)| bytes(read, corners, &scales)).collect();
    Ok(Some(Cloud { about, snapshots: bytes }))
}

/// Names of the snapshots that are shown, in order of time.
fn series(directory: &Path) -> Vec<String> {
    let text = std::fs::read_to_string(directory.join("snapshots.vtkhdf.series")).unwrap_or_default();
    let series: Json = serde_json::from_str(&text).unwrap_or_default();
    let files = series["files"].as_array().cloned().unwrap_or_default();
    let names: Vec<String> = files.iter().filter_map(|file| Some(file["name"].as_str()?.to_string())).collect();
    let is_there = |name: &String| directory.join(name).is_file();
    let names: Vec<String> = names.into_iter().filter(is_there).collect();
    if names.len() <= SNAPSHOTS {
        return names;
    }
    (0..SNAPSHOTS).map(|k| names[k * (names.len() - 1) / (SNAPSHOTS - 1)].clone()).collect()
}

/// A field of a file as it is shown: numbers as they are, of vectors and tensors their size.
fn shown(label: Label) -> Option<Label> {
    match (label.name.as_str(), label.width) {
        (POSITION, _) => None,
        ("velocity", _) => Some(Label { name: "speed".into(), about: "Size of the velocity.".into(), ..label }),
        (_, 1) => Some(label),
        (_, 6) => Some(Label { about: format!("{} Square root of its second invariant.", label.about), ..label }),
        _ => Some(Label { about: format!("{} Its size.", label.about), ..label }),
    }
}

fn value(column: &Column, row: usize) -> f64 {
    let own = &column.values[row * column.width..(row + 1) * column.width];
    match own {
        [number] => *number,
        // s : s / 2, off-diagonal components twice.
        [xx, yy, zz, xy, yz, xz] => size([*xx, *yy, *zz], [*xy, *yz, *xz]),
        // Traceless, as checkpoints have it: without zz, and in 2D without xz and yz.
        [xx, yy, xy, xz, yz] => size([*xx, *yy, -(xx + yy)], [*xy, *yz, *xz]),
        vector => vector.iter().map(|x| x * x).sum::<f64>().sqrt(),
    }
}

/// Square root of the second invariant of a tensor.
fn size(diagonal: [f64; 3], off: [f64; 3]) -> f64 {
    let squares = |x: [f64; 3]| x.iter().map(|x| x * x).sum::<f64>();
    (0.5 * squares(diagonal) + squares(off)).sqrt()
}

/// Reads the chosen `share` of the particles of a file.
fn snapshot(file: &ParticleFile, share: f64) -> Result<Read, String> {
    let head = file.head()?;
    let mut found = Read { time: head.time.unwrap_or(f64::NAN), position: Vec::new(), columns: BTreeMap::new() };
    let mut first = 0;
    while first < head.rows {
        let end = (first + ROWS).min(head.rows);
        let rows = file.read(first..end, &|_| true)?;
        // Rows of a checkpoint have no numbers here, and are of one moment.
        let number = |row: usize| rows.ids.get(row).copied().unwrap_or(first + row as u64);
        let chosen: Vec<usize> = (0..rows.count).filter(|row| uniform(SEED, number(*row), 0) < share).collect();
        for column in &rows.columns {
            if column.name == POSITION {
                found.position.extend(chosen.iter().map(|row| column.vector(*row)));
                continue;
            }
            let name = if column.name == "velocity" { "speed".to_string() } else { column.name.clone() };
            found.columns.entry(name).or_default().extend(chosen.iter().map(|row| value(column, *row)));
        }
        let mut add = |name: &str, value: &dyn Fn(usize) -> f64| {
            found.columns.entry(name.to_string()).or_default().extend(chosen.iter().map(|row| value(*row)));
        };
        let body = |kind: i64| if rows.ids.is_empty() { ParticleId(kind as u64).body() as i64 } else { kind };
        add("body", &|row| body(rows.kind(row)) as f64);
        if !rows.in_largest.is_empty() {
            add("largest_remnant", &|row| f64::from(u8::from(rows.in_largest[row])));
        }
        first = end;
    }
    Ok(found)
}

impl Read {
    fn leave_out(&mut self, middle: &[f64; 3], far: f64) {
        let near: Vec<bool> = self.position.iter().map(|x| (0..3).all(|k| (x[k] - middle[k]).abs() <= far)).collect();
        let keep = |n: usize| near[n];
        let mut n = 0..;
        self.position.retain(|_| n.next().is_some_and(keep));
        for column in self.columns.values_mut() {
            let mut n = 0..;
            column.retain(|_| n.next().is_some_and(keep));
        }
    }
}

/// Least and largest corner.
fn corners(positions: &[[f64; 3]]) -> [[f64; 3]; 2] {
    if positions.is_empty() {
        return [[0.0; 3]; 2];
    }
    positions.iter().fold([[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]], |[low, high], x| {
        [std::array::from_fn(|k| low[k].min(x[k])), std::array::from_fn(|k| high[k].max(x[k]))]
    })
}

/// Middle and largest side of the box around.
fn extent(positions: &[[f64; 3]]) -> ([f64; 3], f64) {
    let [low, high] = corners(positions);
    let side = (0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max);
    (std::array::from_fn(|k| 0.5 * (low[k] + high[k])), if side > 0.0 { side } else { 1.0 })
}

/// The distance of neighbours, about, m.
fn spacing(read: &Read) -> f64 {
    let h = read.columns.get("smoothing_length").map(|h| sorted(h.clone())).unwrap_or_default();
    // A checkpoint does not have it: half of the box is taken to be full.
    let crowd = || {
        let [low, high] = corners(&read.position);
        let sides: Vec<f64> = (0..3).map(|k| high[k] - low[k]).filter(|side| *side > 0.0).collect();
        let volume = sides.iter().product::<f64>() * 0.5 / read.position.len().max(1) as f64;
        if sides.is_empty() { 1.0 } else { volume.powf(1.0 / sides.len() as f64) }
    };
    h.get(h.len() / 2).map_or_else(crowd, |h| 0.8 * h)
}

fn sorted(mut values: Vec<f64>) -> Vec<f64> {
    values.sort_by(f64::total_cmp);
    values
}

/// From values to parts of a scale.
struct Scale {
    low: f64,
    high: f64,
    logarithmic: bool,
}

impl Scale {
    /// For a column of all snapshots; none where it is not in all of them.
    fn of(snapshots: &[Read], name: &str) -> Option<Self> {
        let columns = snapshots.iter().map(|read| read.columns.get(name)).collect::<Option<Vec<_>>>();
        // What only the last snapshot has is shown, too, as zero elsewhere.
        let columns = columns.or_else(|| Some(snapshots.iter().filter_map(|read| read.columns.get(name)).collect()))?;
        let all = sorted(columns.into_iter().flatten().copied().collect());
        if all.is_empty() {
            return None;
        }
        let at = |share: f64| all.get(((all.len() - 1) as f64 * share).round() as usize).copied();
        let (low, high) = (at(BEYOND)?, at(1.0 - BEYOND)?);
        // Whole numbers and parts of one have their own ends.
        let (low, high) = if all[0] >= 0.0 && all[all.len() - 1] <= 1.0 { (0.0, 1.0) } else { (low, high) };
        let whole = all.iter().all(|x| x.fract() == 0.0);
        let mostly_small = all[0] >= 0.0 && high > 1.0 && !whole && at(0.5)? < high / MOSTLY_SMALL;
        let low = if mostly_small { low.max(high / DECADES) } else { low };
        let logarithmic = mostly_small || low > 0.0 && high / low > DECADES;
        Some(Self { low, high: if high > low { high } else { low + 1.0 }, logarithmic })
    }

    fn part(&self, x: f64) -> f64 {
        let part = match self.logarithmic {
            true => (x.max(f64::MIN_POSITIVE) / self.low).ln() / (self.high / self.low).ln(),
            false => (x - self.low) / (self.high - self.low),
        };
        part.clamp(0.0, 1.0)
    }
}

fn bytes(read: &Read, [low, high]: &[[f64; 3]; 2], scales: &[(Label, Scale)]) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(read.position.len() * (6 + scales.len()));
    for x in &read.position {
        for k in 0..3 {
            let side = high[k] - low[k];
            let part = if side > 0.0 { (x[k] - low[k]) / side } else { 0.0 };
            bytes.extend_from_slice(&((65535.0 * part).round() as u16).to_le_bytes());
        }
    }
    for (label, scale) in scales {
        match read.columns.get(&label.name) {
            Some(column) => bytes.extend(column.iter().map(|x| (255.0 * scale.part(*x)).round() as u8)),
            None => bytes.extend(std::iter::repeat_n(0, read.position.len())),
        }
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(values: &[f64]) -> Read {
        let position = (0..values.len()).map(|k| [k as f64, 0.0, -1.0]).collect();
        Read { time: 0.0, position, columns: [("x".to_string(), values.to_vec())].into() }
    }

    #[test]
    fn values_and_places_become_parts() {
        let snapshots = [read(&[-2.0, 0.0, 2.0])];
        let scale = Scale::of(&snapshots, "x").unwrap();
        assert_eq!((scale.low, scale.high, scale.logarithmic), (-2.0, 2.0, false));
        let label = Label { name: "x".into(), unit: String::new(), about: String::new(), width: 1 };
        let packed = bytes(&snapshots[0], &corners(&snapshots[0].position), &[(label, scale)]);
        assert_eq!(packed[..6], [0; 6]);
        assert_eq!(packed[6..8], 32768u16.to_le_bytes());
        assert_eq!(packed[12..14], [255, 255]);
        assert_eq!(packed[18..], [0, 128, 255]);
    }

    #[test]
    fn scales_follow_from_the_values() {
        let wide = Scale::of(&[read(&[1.0, 1e3, 1e6])], "x").unwrap();
        assert!(wide.logarithmic && (wide.part(1e3) - 0.5).abs() < 1e-12 && wide.part(0.0) == 0.0);
        let speeds = Scale::of(&[read(&[0.0, 0.5, 1.0, 2.0, 3.0, 4e3])], "x").unwrap();
        assert!(speeds.logarithmic && (speeds.low, speeds.high) == (4.0, 4e3) && speeds.part(0.0) == 0.0);
        let bodies = Scale::of(&[read(&[0.0, 0.0, 0.0, 200.0])], "x").unwrap();
        assert!(!bodies.logarithmic && bodies.low == 0.0);
        let damage = Scale::of(&[read(&[0.2, 0.4])], "x").unwrap();
        assert_eq!((damage.low, damage.high), (0.0, 1.0));
        assert!(Scale::of(&[read(&[])], "x").is_none() && Scale::of(&[read(&[7.0])], "x").is_some());
    }

    #[test]
    fn what_has_flown_away_is_left_out() {
        let mut far = read(&[1.0, 2.0, 3.0]);
        far.leave_out(&[0.0, 0.0, -1.0], 1.5);
        assert_eq!((far.position.len(), &far.columns["x"][..]), (2, &[1.0, 2.0][..]));
    }
}
