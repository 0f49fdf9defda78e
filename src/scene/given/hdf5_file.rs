//! Particles in HDF5: snapshots of this program, and files of others, whose datasets are named one by one.

use std::collections::BTreeMap;
use std::ops::Range;

use hdf5::types::VarLenUnicode;
use hdf5::{Dataset, File, Group, H5Type};

use super::file::{Column, Found, Head, Label, MATERIAL, Origin, POSITION, ParticleFile, Rows};

const POINTS: &str = "/VTKHDF/Points";
/// Fields that number particles.
const NUMBERS: [&str; 3] = ["id", "body", LARGEST];
/// Whether a particle belongs to the largest remnant.
const LARGEST: &str = "largest_remnant";

fn open(path: &str) -> Found<File> {
    // A folder, or what does not end, is no file to HDF5, which would say so in many lines.
    match std::fs::metadata(path) {
        Err(e) => return Err(e.to_string()),
        Ok(about) if !about.is_file() => return Err("it is no regular file".into()),
        Ok(_) => {}
    }
    File::open(path).map_err(|_| "it is no whole HDF5 file".to_string())
}

fn dataset(file: &File, name: &str) -> Found<Dataset> {
    file.dataset(name).map_err(|_| format!("it has no dataset {name}"))
}

/// Numbers per row, and the rows.
fn shape(set: &Dataset) -> Found<(u64, usize)> {
    match set.shape()[..] {
        [rows] => Ok((rows as u64, 1)),
        [rows, width] if width > 0 => Ok((rows as u64, width)),
        ref other => Err(format!("{} has the shape {other:?}, not one row per particle", set.name())),
    }
}

fn read<T: H5Type + Copy>(set: &Dataset, rows: &Range<u64>) -> Found<Vec<T>> {
    let range = rows.start as usize..rows.end as usize;
    let read = match set.ndim() {
        1 => set.read_slice_1d::<T, _>(range).map(|array| array.iter().copied().collect()),
        _ => set.read_slice_2d::<T, _>((range, ..)).map(|array| array.iter().copied().collect()),
    };
    read.map_err(|e| format!("{} cannot be read: {e}", set.name()))
}

fn column(set: &Dataset, name: &str, rows: &Range<u64>) -> Found<Column> {
    let (there, width) = shape(set)?;
    if there < rows.end {
        return Err(format!("{} has {there} rows, other columns have more", set.name()));
    }
    Ok(Column { name: name.to_string(), width, values: read(set, rows)? })
}

fn text(group: &Group, name: &str) -> Option<String> {
    Some(group.attr(name).ok()?.read_scalar::<VarLenUnicode>().ok()?.to_string())
}

fn number<T: H5Type>(group: &Group, name: &str) -> Option<T> {
    group.attr(name).ok()?.read_scalar().ok()
}

pub fn head_of_snapshot(path: &str) -> Found<Head> {
    let file = open(path)?;
    let (rows, _) = shape(&dataset(&file, POINTS)?)?;
    let run = file.group("/run").map_err(|_| "it is no snapshot of this program: it has no group /run".to_string())?;
    let fields = file.group(FIELDS).and_then(|group| group.member_names()).unwrap_or_default();
    let mut columns = vec![POSITION.to_string()];
    columns.extend(fields.into_iter().filter(|name| !NUMBERS.contains(&name.as_str())));
    let mut origins = BTreeMap::new();
    // Snapshots of earlier versions do not have them.
    let bodies = file.group("/bodies").and_then(|group| group.groups()).unwrap_or_default();
    for body in bodies {
        let path = body.name();
        let name = path.rsplit('/').next().unwrap_or_default();
        let origin = Origin {
            name: text(&body, "name").unwrap_or_default(),
            material: text(&body, "material").unwrap_or_default(),
            density: number(&body, "density").unwrap_or(f64::NAN),
            distention: number(&body, "distention").unwrap_or(1.0),
        };
        origins.insert(name.parse().map_err(|_| format!("{path} is no number of a body"))?, origin);
    }
    Ok(Head {
        rows,
        dimension: number::<i64>(&run, "dimension").map(|dimension| dimension as usize),
        late: number::<i64>(&run, "late_stage") == Some(1),
        time: number(&run, "time"),
        columns,
        bodies: origins,
    })
}

/// The datasets in a group of a file, but the numbers of particles.
pub fn labels(path: &str, group: &str) -> Found<Vec<Label>> {
    let file = open(path)?;
    let fields = file.group(group).map_err(|_| format!("it has no group {group}"))?;
    let text = |set: &Dataset, name: &str| {
        let text = set.attr(name).and_then(|attribute| attribute.read_scalar::<VarLenUnicode>());
        text.map(|text| text.to_string()).unwrap_or_default()
    };
    let label = |name: String| -> Found<Label> {
        let set = dataset(&file, &format!("{group}/{name}"))?;
        let (_, width) = shape(&set)?;
        Ok(Label { unit: text(&set, "unit"), about: text(&set, "description"), name, width })
    };
    let names = fields.member_names().map_err(|e| e.to_string())?;
    names.into_iter().filter(|name| name != "id").map(label).collect()
}

/// Where a snapshot has its fields.
pub const FIELDS: &str = "/VTKHDF/PointData";

pub fn rows_of_snapshot(path: &str, rows: Range<u64>, wanted: &dyn Fn(&str) -> bool) -> Found<Rows> {
    let file = open(path)?;
    let fields = file.group(FIELDS).map_err(|_| format!("it has no group {FIELDS}"))?;
    let field = |name: &str| dataset(&file, &format!("{FIELDS}/{name}"));
    let mut found = Rows { count: (rows.end - rows.start) as usize, first: rows.start, ..Rows::default() };
    found.ids = read(&field("id")?, &rows)?;
    found.kinds = read(&field("body")?, &rows)?;
    if let Ok(set) = field(LARGEST) {
        found.in_largest = read::<i64>(&set, &rows)?.into_iter().map(|word| word != 0).collect();
    }
    if wanted(POSITION) {
        found.columns.push(column(&dataset(&file, POINTS)?, POSITION, &rows)?);
    }
    for name in fields.member_names().map_err(|e| e.to_string())? {
        if !NUMBERS.contains(&name.as_str()) && wanted(&name) {
            found.columns.push(column(&field(&name)?, &name, &rows)?);
        }
    }
    Ok(found)
}

pub fn head(file: &ParticleFile) -> Found<Head> {
    let open = open(&file.path)?;
    let place = file.datasets.get(POSITION).ok_or("`columns` does not say where the positions are")?;
    let (rows, width) = shape(&dataset(&open, place)?)?;
    let columns = file.datasets.keys().filter(|name| *name != MATERIAL).cloned().collect();
    Ok(Head { rows, dimension: Some(width), columns, ..Head::default() })
}

pub fn rows(file: &ParticleFile, rows: Range<u64>, wanted: &dyn Fn(&str) -> bool) -> Found<Rows> {
    let open = open(&file.path)?;
    let mut found = Rows { count: (rows.end - rows.start) as usize, first: rows.start, ..Rows::default() };
    for (name, place) in &file.datasets {
        let set = dataset(&open, place)?;
        match name.as_str() {
            MATERIAL => found.kinds = read(&set, &rows)?,
            name if wanted(name) => found.columns.push(column(&set, name, &rows)?),
            _ => {}
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::super::file::{Format, MASS};
    use super::*;

    /// A file as another program writes it, with numbers of 32 bits.
    #[test]
    fn datasets_of_another_program_are_read() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("p.h5");
        let written = File::create(&path).unwrap();
        let group = written.create_group("PartType0").unwrap();
        let place: Vec<f32> = (0..12).map(|k| 0.5 * k as f32).collect();
        let set = group.new_dataset::<f32>().shape((4, 3)).create("Coordinates").unwrap();
        set.write_raw(&place).unwrap();
        group.new_dataset::<f64>().shape(4).create("Masses").unwrap().write_raw(&[1.0, 2.0, 3.0, 4.0]).unwrap();
        group.new_dataset::<i32>().shape(4).create("MaterialIDs").unwrap().write_raw(&[400, 400, 402, 402]).unwrap();
        drop((set, group, written));
        let named = [(POSITION, "Coordinates"), (MASS, "Masses"), (MATERIAL, "MaterialIDs")];
        let datasets = named.map(|(name, set)| (name.to_string(), format!("PartType0/{set}")));
        let mut file = ParticleFile {
            path: path.display().to_string(),
            format: Format::Hdf5,
            datasets: datasets.into(),
            units: [(POSITION.to_string(), 2.0)].into(),
        };
        let head = file.head().unwrap();
        assert_eq!((head.rows, head.dimension, head.columns.len()), (4, Some(3), 2));
        let rows = file.read(1..3, &|_| true).unwrap();
        assert_eq!(rows.column(POSITION).unwrap().vector(1), [6.0, 7.0, 8.0]);
        assert_eq!((rows.column(MASS).unwrap().number(0), rows.kind(0), rows.kind(1)), (2.0, 400, 402));
        file.datasets.insert(MASS.to_string(), "PartType0/Mass".into());
        assert_eq!(file.read(0..4, &|_| true).unwrap_err(), "it has no dataset PartType0/Mass");
        std::fs::write(&path, "text").unwrap();
        assert_eq!(file.head().unwrap_err(), "it is no whole HDF5 file");
        assert_eq!(head_of_snapshot("/dev/zero").unwrap_err(), "it is no regular file");
    }
}
