//! Checkpoints: every state column and the other state of the run, readable on any number of ranks. Two generations stay;
//! each column carries a checksum that neither the order of particles nor the number of ranks changes: the sum modulo 2^256,
//! over particles, of blake3(id, the column's words). The reader takes the newest whole one.

use std::path::{Path, PathBuf};

use super::collective::{CollectiveFile, Value};
use super::on_root;
use super::publish::{cannot, prepare, publish, sync_directory_of};
use super::state_hash::{HashSum, hash_columns, state_columns};
use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::particles::{Column, ColumnShape, Columns, ParticleId, Registry};

pub const NEWEST: &str = "checkpoint.h5";
pub const PREVIOUS: &str = "checkpoint_previous.h5";

/// The contents of a checkpoint beside the columns.
#[derive(Debug, Clone, PartialEq, Default, serde::Serialize, serde::Deserialize)]
pub struct CheckpointMeta {
    /// The scene as read, with defaults; a checkpoint of another scene is refused.
    pub scene: String,
    /// Numbers by name, bit for bit.
    pub reals: Vec<(String, Bits)>,
    pub integers: Vec<(String, u64)>,
    /// Other state of the caller, as JSON.
    pub json: String,
}

/// A number stored by its bits, so that no text form can change it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Bits(u64);

impl From<f64> for Bits {
    fn from(x: f64) -> Self {
        Self(x.to_bits())
    }
}

impl From<Bits> for f64 {
    fn from(bits: Bits) -> Self {
        f64::from_bits(bits.0)
    }
}

impl CheckpointMeta {
    pub fn real(&self, name: &str) -> Option<f64> {
        self.reals.iter().find(|(n, _)| n == name).map(|(_, bits)| (*bits).into())
    }

    pub fn integer(&self, name: &str) -> Option<u64> {
        self.integers.iter().find(|(n, _)| n == name).map(|(_, value)| *value)
    }
}

/// A checkpoint that was read.
#[derive(Debug)]
pub struct Checkpoint {
    /// An equal share of the particles on every rank, in no special order.
    pub columns: Columns,
    pub meta: CheckpointMeta,
    /// The file it came from.
    pub path: PathBuf,
    /// Why the newer file was not taken, where it was not.
    pub refused: Option<Error>,
}

/// The text part of the file.
#[derive(serde::Serialize, serde::Deserialize)]
struct Header {
    dimension: usize,
    particles: u64,
    meta: CheckpointMeta,
}

/// Writes `checkpoint.h5`; the existing one becomes `checkpoint_previous.h5`. Collective.
pub fn write(
    directory: &Path,
    columns: &Columns,
    id: Column<ParticleId>,
    meta: &CheckpointMeta,
    comm: &Comm,
) -> Result<()> {
    let path = directory.join(NEWEST);
    prepare(&path, comm, |file| fill(file, columns, id, meta, comm))?;
    on_root(comm, || keep_previous(directory))?;
    publish(&path, comm)
}

fn fill(
    file: &CollectiveFile,
    columns: &Columns,
    id: Column<ParticleId>,
    meta: &CheckpointMeta,
    comm: &Comm,
) -> Result<()> {
    let particles = file.places(columns.len()).total;
    let header = Header { dimension: columns.registry.dimension, particles: particles as u64, meta: meta.clone() };
    write_header(file, &header, comm)?;
    file.group("/columns")?;
    let which = state_columns(columns);
    for (&index, sum) in which.iter().zip(checksums(columns, id, &which, comm)) {
        let entry = &columns.registry.entries[index];
        let at = format!("/columns/{}", entry.name);
        match entry.shape {
            ColumnShape::Id => file.write(&at, columns.words(index), entry.width, None)?,
            _ => file.write(&at, columns.numbers(index), entry.width, None)?,
        }
        file.attribute(&at, "unit", Value::Text(entry.info.unit))?;
        file.attribute(&at, "checksum", Value::Text(&sum.to_string()))?;
    }
    Ok(())
}

/// Headers of ranks may differ, in wall times for example: rank 0's text counts.
fn write_header(file: &CollectiveFile, header: &Header, comm: &Comm) -> Result<()> {
    let mut text = serde_json::to_vec_pretty(header).map_err(|e| Error::new(e.to_string()))?;
    comm.broadcast(&mut text);
    file.write_on_root("/header", &text)?;
    file.attribute("/header", "checksum", Value::Text(&blake3::hash(&text).to_string()))
}

/// The new file is complete by now under its temporary name, so that at any moment there is a checkpoint.
fn keep_previous(directory: &Path) -> Result<()> {
    let newest = directory.join(NEWEST);
    if newest.exists() {
        std::fs::rename(&newest, directory.join(PREVIOUS)).map_err(|e| cannot("rename", &newest, e))?;
        sync_directory_of(&newest)?;
    }
    Ok(())
}

fn checksums(columns: &Columns, id: Column<ParticleId>, which: &[usize], comm: &Comm) -> Vec<HashSum> {
    let mine: Vec<HashSum> = which.iter().map(|&index| hash_columns(columns, id, &[index])).collect();
    HashSum::over_ranks(&mine, comm)
}

/// Why a file is not taken.
enum Refusal {
    /// Damaged or unreadable: an older one may be used.
    NotWhole(Error),
    /// Whole, but of another scene: the user must decide.
    OtherScene(Error),
}

/// Describes how the scene of a checkpoint differs from that of the run; `None` where both are the same.
pub type Differs<'a> = &'a dyn Fn(&str) -> Option<String>;

/// The newest whole checkpoint of a directory, or none where there is no checkpoint at all. Collective.
pub fn read_newest(directory: &Path, registry: &Registry, comm: &Comm, differs: Differs) -> Result<Option<Checkpoint>> {
    let mut refused: Option<Error> = None;
    for name in [NEWEST, PREVIOUS] {
        let path = directory.join(name);
        if !exists(&path, comm) {
            continue;
        }
        match read_one(&path, registry, comm, differs) {
            Ok((columns, meta)) => return Ok(Some(Checkpoint { columns, meta, path, refused })),
            Err(Refusal::OtherScene(error)) => {
                return Err(match refused {
                    None => error,
                    Some(newer) => {
                        let what = format!("{newer}; and the one before, {}: {}", path.display(), error.what);
                        Error { what, ..error }.at(directory.display().to_string())
                    }
                });
            }
            Err(Refusal::NotWhole(error)) => {
                refused = Some(match refused {
                    None => error,
                    Some(newer) => Error::new(format!("no whole checkpoint is left: {newer}; {error}")),
                });
            }
        }
    }
    refused.map_or(Ok(None), |error| Err(error.bad_input()))
}

/// As rank 0 sees it: on a network file system ranks may see different states for a while.
fn exists(path: &Path, comm: &Comm) -> bool {
    let mut found = [(comm.is_root() && path.exists()) as i64];
    comm.all_sum(&mut found);
    found[0] > 0
}

fn read_one(
    path: &Path,
    registry: &Registry,
    comm: &Comm,
    differs: Differs,
) -> std::result::Result<(Columns, CheckpointMeta), Refusal> {
    let place = path.display().to_string();
    let not_whole = |error: Error| Refusal::NotWhole(if error.place.is_empty() { error.at(&place) } else { error });
    let file = CollectiveFile::open(path, comm).map_err(not_whole)?;
    let header = read_header(&file).map_err(not_whole)?;
    if let Some(difference) = differs(&header.meta.scene) {
        let error = Error::new(format!("the checkpoint belongs to another scene: {difference}")).at(&place);
        let error = error.allowed(
            "the scene it was written for, in which the title, [output] and the end of [run] may change; or another \
             directory (--out)",
        );
        return Err(Refusal::OtherScene(error.bad_input()));
    }
    let columns = read_columns(&file, &header, registry, comm).map_err(not_whole)?;
    file.close().map_err(not_whole)?;
    Ok((columns, header.meta))
}

fn read_header(file: &CollectiveFile) -> Result<Header> {
    let rows = file.rows("/header")?;
    let text = file.read::<u8>("/header", 1, 0..rows)?;
    if file.read_text("/header", "checksum")? != blake3::hash(&text).to_string() {
        return Err(Error::new("the header does not match its checksum"));
    }
    serde_json::from_slice(&text).map_err(|e| Error::new(format!("the header cannot be understood: {e}")))
}

fn read_columns(file: &CollectiveFile, header: &Header, registry: &Registry, comm: &Comm) -> Result<Columns> {
    let mut columns = Columns::new(registry.clone());
    let which = state_columns(&columns);
    check_names(file, header, registry)?;
    let id = registry.find::<ParticleId>("id").ok_or_else(|| Error::new("a checkpoint needs the column id"))?;
    let rows = comm.share(header.particles);
    let rows = rows.start as usize..rows.end as usize;
    columns.resize(rows.len());
    for &index in &which {
        let entry = &registry.entries[index];
        let at = format!("/columns/{}", entry.name);
        if file.rows(&at)? as u64 != header.particles {
            return Err(Error::new(format!("the column {} has not one row per particle", entry.name)));
        }
        let words = match entry.shape {
            ColumnShape::Id => file.read::<u64>(&at, entry.width, rows.clone())?,
            _ => bytemuck::cast_vec(file.read::<f64>(&at, entry.width, rows.clone())?),
        };
        columns.words_mut(index).copy_from_slice(&words);
    }
    for (&index, sum) in which.iter().zip(checksums(&columns, id, &which, comm)) {
        let name = &registry.entries[index].name;
        if file.read_text(&format!("/columns/{name}"), "checksum")? != sum.to_string() {
            return Err(Error::new(format!("the column {name} does not match its checksum")));
        }
    }
    Ok(columns)
}

/// The file must hold exactly the state columns of this run.
fn check_names(file: &CollectiveFile, header: &Header, registry: &Registry) -> Result<()> {
    let state = registry.entries.iter().filter(|entry| entry.info.life.is_state());
    let mut expected: Vec<String> = state.map(|entry| entry.name.clone()).collect();
    let mut found = file.members("/columns")?;
    expected.sort();
    found.sort();
    if header.dimension != registry.dimension || found != expected {
        let error = Error::new(format!("it holds {} in {}D", found.join(", "), header.dimension));
        return Err(error.allowed(format!("{} in {}D", expected.join(", "), registry.dimension)));
    }
    Ok(())
}
