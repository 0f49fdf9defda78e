//! HDF5 files that all ranks write and read together. The safe HDF5 interface has no transfer properties, so the transfers
//! themselves go through the C interface; after each one it is checked that HDF5 made it collectively.
//!
//! Every method is collective and returns the same success or error on all ranks. In-memory and stored number types are
//! always the same: a conversion inside HDF5 would silently break collective transfers.

use std::cell::Cell;
use std::ops::Range;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use hdf5::types::{FixedAscii, VarLenUnicode};
use hdf5::{Dataset, Datatype, H5Type, Location};
use hdf5_sys::h5::{herr_t, hsize_t};
use hdf5_sys::h5d::{H5Dread, H5Dwrite};
use hdf5_sys::h5f::H5Fget_vfd_handle;
use hdf5_sys::h5i::hid_t;
use hdf5_sys::h5p::{H5FD_mpio_xfer_t, H5P_CLS_DATASET_XFER, H5Pclose, H5Pcreate, H5Pset_dxpl_mpio};
use hdf5_sys::h5s::{H5S_seloper_t, H5Sclose, H5Screate_simple, H5Sselect_hyperslab, H5Sselect_none};

use super::agree;
use super::moment::{self, Moment};
use crate::domain::comm::Comm;
use crate::error::{Error, Result};

/// Bytes a rank moves in one transfer at most: MPI counts are 32-bit.
const PIECE: usize = 1 << 30;
/// Whether HDF5 could not close a file that it failed to write.
static STUCK: AtomicBool = AtomicBool::new(false);

/// Whether some rank holds a file that HDF5 cannot close. HDF5 would try once more while MPI ends, and crash: such a job ends
/// by [`Comm::abort`]. Collective.
pub fn is_stuck(comm: &Comm) -> bool {
    let mut stuck = [STUCK.load(Ordering::Relaxed) as i64];
    comm.all_sum(&mut stuck);
    stuck[0] > 0
}

/// Rows per chunk of a compressed dataset.
const CHUNK_ROWS: usize = 1 << 14;

unsafe extern "C" {
    fn H5Pget_mpio_actual_io_mode(transfer: hid_t, mode: *mut i32) -> herr_t;
    fn H5Pget_mpio_no_collective_cause(transfer: hid_t, local: *mut u32, global: *mut u32) -> herr_t;
}

/// An attribute's value.
#[derive(Debug, Clone, PartialEq)]
pub enum Value<'a> {
    Real(f64),
    Integer(i64),
    Reals(&'a [f64]),
    Integers(&'a [i64]),
    Text(&'a str),
    /// Eight ASCII characters of fixed length, as VTK requires.
    Ascii8(&'a str),
}

/// Rows of a dataset that all ranks have parts of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RowPlaces {
    /// On the ranks before this one.
    pub before: usize,
    /// On all ranks.
    pub total: usize,
}

/// An open file. Close it with [`CollectiveFile::close`], before MPI ends.
pub struct CollectiveFile<'a> {
    file: hdf5::File,
    comm: &'a Comm,
    place: String,
    collective: Cell<bool>,
}

impl<'a> CollectiveFile<'a> {
    /// A new file; an old one of that name is emptied.
    pub fn create(path: &Path, comm: &'a Comm) -> Result<Self> {
        Self::with(path, comm, "create", |builder| builder.create(path))
    }

    /// An existing file, for reading.
    pub fn open(path: &Path, comm: &'a Comm) -> Result<Self> {
        Self::with(path, comm, "open", |builder| builder.open(path))
    }

    fn with(
        path: &Path,
        comm: &'a Comm,
        verb: &str,
        act: impl FnOnce(&hdf5::FileBuilder) -> hdf5::Result<hdf5::File>,
    ) -> Result<Self> {
        let mut builder = hdf5::File::with_options();
        // From version 1.8 on HDF5 guards its own structures by checksums, so that damage shows as an error.
        builder.with_fapl(|access| access.mpio(comm.raw(), comm.raw_file_hints()).libver_v18());
        let place = path.display().to_string();
        let file = agree(comm, act(&builder).map_err(|e| failure(verb, &place, e)))?;
        let opened = Self { file, comm, place, collective: Cell::new(true) };
        if comm.raw_file_hints().is_some() {
            // On all ranks, even where one alone logs.
            let hints = opened.hints()?;
            tracing::debug!("{} is open with the hints {hints:?}", opened.place);
        }
        Ok(opened)
    }

    /// Whether every transfer so far was collective on every rank, as HDF5 reports it.
    pub fn was_collective(&self) -> bool {
        self.collective.get()
    }

    /// The hints with which MPI has opened the file, as (key, value).
    pub fn hints(&self) -> Result<Vec<(String, String)>> {
        let mut handle = std::ptr::null_mut();
        // H5P_DEFAULT is 0.
        let found = hdf5::h5call!(H5Fget_vfd_handle(self.file.id(), 0, &mut handle));
        self.agree("read the hints of", "/", found)?;
        // SAFETY: the file was opened by the driver for MPI, whose handle is a pointer to its `MPI_File`.
        Ok(unsafe { self.comm.hints_of_file(handle) })
    }

    /// Creates a group and those above it.
    pub fn group(&self, path: &str) -> Result<()> {
        self.agree("create the group", path, self.file.create_group(path).map(|_| ()))
    }

    /// Attaches a value to a group or dataset.
    pub fn attribute(&self, object: &str, name: &str, value: Value) -> Result<()> {
        let written = self.within(object, |at| write_attribute(at, name, value));
        self.agree("write the attribute", &format!("{object}@{name}"), written)
    }

    /// Acts on a group or dataset.
    fn within<T>(&self, object: &str, act: impl FnOnce(&Location) -> hdf5::Result<T>) -> hdf5::Result<T> {
        match self.file.group(object) {
            Ok(group) => act(&group),
            Err(_) => act(&*self.file.dataset(object)?),
        }
    }

    /// Reads a text attribute.
    pub fn read_text(&self, object: &str, name: &str) -> Result<String> {
        let text = self.within(object, |at| at.attr(name)?.read_scalar::<VarLenUnicode>());
        Ok(self.agree("read the attribute", &format!("{object}@{name}"), text)?.to_string())
    }

    /// Names of the members of a group.
    pub fn members(&self, group: &str) -> Result<Vec<String>> {
        self.agree("list", group, self.file.group(group).and_then(|g| g.member_names()))
    }

    /// Writes a dataset of rows of `width` numbers, each rank's rows after those of the ranks before it; a rank may have
    /// none. `gzip` is the level of compression, from 1 to 9.
    pub fn write<T: H5Type>(&self, path: &str, values: &[T], width: usize, gzip: Option<u8>) -> Result<()> {
        let RowPlaces { before: start, total } = self.places(values.len() / width);
        let dataset = self.agree("create the dataset", path, self.create_dataset::<T>(path, total, width, gzip))?;
        let rows = start..start + values.len() / width;
        moment::reach(Moment::Writing);
        self.transfer("write", &dataset, width, rows, |piece, spaces, transfer| {
            let at = values[piece.start * width..].as_ptr();
            // SAFETY: the memory space describes the piece's numbers, which lie in `values` from its start on.
            unsafe { H5Dwrite(dataset.id(), spaces.kind, spaces.memory, spaces.file, transfer, at.cast()) }
        })
    }

    fn create_dataset<T: H5Type>(
        &self,
        path: &str,
        rows: usize,
        width: usize,
        gzip: Option<u8>,
    ) -> hdf5::Result<Dataset> {
        let mut builder = self.file.new_dataset::<T>().fill_time(hdf5::plist::dataset_create::FillTime::Never);
        let chunk = CHUNK_ROWS.min(rows);
        match gzip {
            Some(level) if rows > 0 && width == 1 => builder = builder.chunk(chunk).shuffle().deflate(level),
            Some(level) if rows > 0 => builder = builder.chunk((chunk, width)).shuffle().deflate(level),
            _ => {}
        }
        if width == 1 { builder.shape(rows).create(path) } else { builder.shape((rows, width)).create(path) }
    }

    /// Writes a dataset that rank 0 holds alone.
    pub fn write_on_root<T: H5Type>(&self, path: &str, values: &[T]) -> Result<()> {
        self.write(path, if self.is_root() { values } else { &[] }, 1, None)
    }

    pub fn is_root(&self) -> bool {
        self.comm.is_root()
    }

    /// Where the rows of a dataset stand of which this rank has so many. Collective.
    pub fn places(&self, mine: usize) -> RowPlaces {
        let counts = self.comm.all_gather(&[mine as u64]);
        let before = counts[..self.comm.rank()].iter().sum::<u64>();
        RowPlaces { before: before as usize, total: counts.iter().sum::<u64>() as usize }
    }

    /// Rows of a dataset.
    pub fn rows(&self, path: &str) -> Result<usize> {
        let dataset = self.agree("open the dataset", path, self.file.dataset(path))?;
        Ok(dataset.shape().first().copied().unwrap_or(0))
    }

    /// Reads rows of a dataset, on each rank its own; a rank may read none. The stored numbers must be of type `T`.
    pub fn read<T: H5Type + Clone + Default>(&self, path: &str, width: usize, rows: Range<usize>) -> Result<Vec<T>> {
        let dataset = self.agree("open the dataset", path, self.open_dataset::<T>(path, width, &rows))?;
        let mut values = vec![T::default(); rows.len() * width];
        self.transfer("read", &dataset, width, rows, |piece, spaces, transfer| {
            let at = values[piece.start * width..].as_mut_ptr();
            // SAFETY: the memory space describes the piece's numbers, which lie in `values` from its start on.
            unsafe { H5Dread(dataset.id(), spaces.kind, spaces.memory, spaces.file, transfer, at.cast()) }
        })?;
        Ok(values)
    }

    fn open_dataset<T: H5Type>(&self, path: &str, width: usize, rows: &Range<usize>) -> hdf5::Result<Dataset> {
        let dataset = self.file.dataset(path)?;
        let shape = dataset.shape();
        let columns = if shape.len() == 2 { shape[1] } else { 1 };
        if shape.is_empty() || shape.len() > 2 || columns != width || shape[0] < rows.end {
            return Err(format!("it has the shape {shape:?}, not {} rows of {width}", rows.end).into());
        }
        if !dataset.dtype()?.is::<T>() {
            return Err("it holds numbers of another type".into());
        }
        Ok(dataset)
    }

    /// Moves this rank's rows in pieces, with as many collective calls on every rank as the one with the most rows needs.
    fn transfer(
        &self,
        verb: &str,
        dataset: &Dataset,
        width: usize,
        rows: Range<usize>,
        mut act: impl FnMut(Range<usize>, &Spaces, hid_t) -> herr_t,
    ) -> Result<()> {
        let shape = dataset.shape();
        if shape.iter().product::<usize>() == 0 {
            return Ok(());
        }
        let setup = dataset.dtype().and_then(|kind| Ok((Transfer::collective()?, kind)));
        let (transfer, kind) = self.agree(verb, &dataset.name(), setup)?;
        let per_piece = (PIECE / (width * kind.size())).max(1);
        let mut pieces = [rows.len().div_ceil(per_piece).max(1) as f64];
        self.comm.all_max(&mut pieces);
        for number in 0..pieces[0] as usize {
            let piece = (number * per_piece).min(rows.len())..((number + 1) * per_piece).min(rows.len());
            let spaces = Spaces::of(&shape, rows.start + piece.start, piece.len(), &kind);
            let spaces = self.agree(verb, &dataset.name(), spaces)?;
            let done = hdf5::h5call!(act(piece, &spaces, transfer.0)).and_then(|_| transfer.was_collective());
            let collective = self.agree(verb, &dataset.name(), done)?;
            self.note(collective);
        }
        Ok(())
    }

    /// Remembers a transfer that was not collective on some rank.
    fn note(&self, collective: bool) {
        let mut broken = [!collective as i64];
        self.comm.all_sum(&mut broken);
        self.collective.set(self.collective.get() && broken[0] == 0);
    }

    /// Brings everything to the file system and closes the file.
    pub fn close(self) -> Result<()> {
        let flushed = self.agree("flush", "/", self.file.flush());
        let (comm, place) = (self.comm, self.place);
        let closed = self.file.close().map_err(|e| failure("close", &place, e));
        STUCK.fetch_or(closed.is_err(), Ordering::Relaxed);
        flushed.and(agree(comm, closed))
    }

    fn agree<T>(&self, verb: &str, object: &str, result: hdf5::Result<T>) -> Result<T> {
        agree(self.comm, result.map_err(|e| failure(&format!("{verb} {object}"), &self.place, e)))
    }
}

fn write_attribute(at: &Location, name: &str, value: Value) -> hdf5::Result<()> {
    match value {
        Value::Real(x) => at.new_attr::<f64>().create(name)?.write_scalar(&x),
        Value::Integer(n) => at.new_attr::<i64>().create(name)?.write_scalar(&n),
        Value::Reals(x) => at.new_attr::<f64>().shape(x.len()).create(name)?.write_raw(x),
        Value::Integers(n) => at.new_attr::<i64>().shape(n.len()).create(name)?.write_raw(n),
        Value::Text(text) => {
            let text: VarLenUnicode = text.replace('\0', " ").parse().map_err(|e| format!("{e}"))?;
            at.new_attr::<VarLenUnicode>().create(name)?.write_scalar(&text)
        }
        Value::Ascii8(text) => {
            let text = FixedAscii::<8>::from_ascii(text.as_bytes()).map_err(|e| format!("{e}"))?;
            at.new_attr::<FixedAscii<8>>().create(name)?.write_scalar(&text)
        }
    }
}

/// The messages of HDF5, innermost last.
fn failure(verb: &str, place: &str, error: hdf5::Error) -> Error {
    Error::new(format!("cannot {verb}: {error}")).at(place)
}

/// A list of transfer properties for collective transfers.
struct Transfer(hid_t);

impl Transfer {
    fn collective() -> hdf5::Result<Self> {
        let list = Self(hdf5::h5call!(H5Pcreate(*H5P_CLS_DATASET_XFER))?);
        hdf5::h5call!(H5Pset_dxpl_mpio(list.0, H5FD_mpio_xfer_t::H5FD_MPIO_COLLECTIVE))?;
        Ok(list)
    }

    /// Whether HDF5 reports the last transfer made with this list on this rank as collective.
    fn was_collective(&self) -> hdf5::Result<bool> {
        let (mut mode, mut local, mut global) = (0, 0, 0);
        hdf5::h5call!(H5Pget_mpio_actual_io_mode(self.0, &mut mode))?;
        hdf5::h5call!(H5Pget_mpio_no_collective_cause(self.0, &mut local, &mut global))?;
        // H5D_MPIO_CHUNK_COLLECTIVE = 2, H5D_MPIO_CONTIGUOUS_COLLECTIVE = 4; no cause is 0.
        Ok((mode == 2 || mode == 4) && local == 0 && global == 0)
    }
}

impl Drop for Transfer {
    fn drop(&mut self) {
        hdf5::h5lock!(H5Pclose(self.0));
    }
}

/// Where a piece lies in memory and in the file, and the type of its numbers.
struct Spaces {
    memory: hid_t,
    file: hid_t,
    kind: hid_t,
}

impl Spaces {
    /// `count` rows from `start` on, of a dataset of that shape; none is an empty selection.
    fn of(shape: &[usize], start: usize, count: usize, kind: &Datatype) -> hdf5::Result<Self> {
        let extent: Vec<hsize_t> = shape.iter().map(|&n| n as hsize_t).collect();
        let rank = extent.len() as i32;
        let mut block = extent.clone();
        block[0] = count.max(1) as hsize_t;
        let mut from = vec![0; extent.len()];
        from[0] = start as hsize_t;
        let none = std::ptr::null();
        let memory = hdf5::h5call!(H5Screate_simple(rank, block.as_ptr(), none))?;
        let file = match hdf5::h5call!(H5Screate_simple(rank, extent.as_ptr(), none)) {
            Ok(file) => file,
            Err(error) => {
                hdf5::h5lock!(H5Sclose(memory));
                return Err(error);
            }
        };
        let spaces = Self { memory, file, kind: kind.id() };
        if count == 0 {
            hdf5::h5call!(H5Sselect_none(memory))?;
            hdf5::h5call!(H5Sselect_none(file))?;
        } else {
            let set = H5S_seloper_t::H5S_SELECT_SET;
            hdf5::h5call!(H5Sselect_hyperslab(file, set, from.as_ptr(), none, block.as_ptr(), none))?;
        }
        Ok(spaces)
    }
}

impl Drop for Spaces {
    fn drop(&mut self) {
        hdf5::h5lock!(H5Sclose(self.memory));
        hdf5::h5lock!(H5Sclose(self.file));
    }
}
