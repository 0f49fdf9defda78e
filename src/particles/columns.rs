//! Columns: one quantity of all particles of a rank. Effects declare the columns they own in the registry when a scene is set
//! up and keep typed handles; allocation, migration, checkpoint, snapshot and the manual's table follow from the registry
//! alone. Every column is an array of 64-bit words, so that all of these move words and know no physics.

use std::marker::PhantomData;
use std::sync::Arc;

use rayon::prelude::*;

use super::id::ParticleId;
use super::large_pages::prefer_large_pages;
use super::order::Reordering;
use crate::error::{Error, Result};
use crate::math::{Deviator, Vec3};

/// The values of a column per particle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ColumnShape {
    Scalar,
    /// One number per dimension.
    Vector,
    /// Traceless symmetric tensor: xx, yy, xy in 2D (plane strain), xx, yy, xy, xz, yz in 3D.
    Deviator,
    Id,
}

impl ColumnShape {
    /// Words of 64 bits per particle.
    pub fn words(self, dimension: usize) -> usize {
        match self {
            ColumnShape::Scalar | ColumnShape::Id => 1,
            ColumnShape::Vector => dimension,
            ColumnShape::Deviator => 2 * dimension - 1,
        }
    }
}

/// How long a column's content matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Life {
    /// Part of the state that a step changes: kept in checkpoints, counted in the state hash, and set back where a step is refused.
    State,
    /// Part of the state that a step does not change: constants, and results of evaluations and list builds for later ones.
    Kept,
    /// Follows from the state; moves with the particle, is not kept.
    Scratch,
}

impl Life {
    /// Whether it is kept in checkpoints and counted in the state hash.
    pub fn is_state(self) -> bool {
        self != Life::Scratch
    }
}

/// A column as its owner declares it.
#[derive(Debug, Clone, Copy)]
pub struct ColumnInfo {
    pub name: &'static str,
    /// SI unit, "" for pure numbers.
    pub unit: &'static str,
    /// One sentence for files and manual.
    pub about: &'static str,
    pub life: Life,
    /// Written to snapshots.
    pub snapshot: bool,
}

/// Typed handle of a column.
#[derive(Debug)]
pub struct Column<T> {
    pub index: usize,
    element: PhantomData<fn() -> T>,
}

impl<T> Clone for Column<T> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<T> Copy for Column<T> {}

/// A state column that the integrator advances by its rate.
#[derive(Debug)]
pub struct Integrated<T> {
    pub value: Column<T>,
    /// Number among the integrated columns; the place of its rate in [`Rates`](super::Rates).
    pub slot: usize,
}

impl<T> Clone for Integrated<T> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<T> Copy for Integrated<T> {}

/// A type of value that a column can hold.
pub trait Element: Copy {
    const SHAPE: ColumnShape;
    /// Reads from `words` (as many as the shape has).
    fn load(words: impl Fn(usize) -> u64, width: usize) -> Self;
    fn store(self, words: impl Fn(usize, u64), width: usize);
}

impl Element for f64 {
    const SHAPE: ColumnShape = ColumnShape::Scalar;
    #[inline(always)]
    fn load(words: impl Fn(usize) -> u64, _: usize) -> Self {
        f64::from_bits(words(0))
    }
    #[inline(always)]
    fn store(self, words: impl Fn(usize, u64), _: usize) {
        words(0, self.to_bits())
    }
}

impl Element for ParticleId {
    const SHAPE: ColumnShape = ColumnShape::Id;
    #[inline(always)]
    fn load(words: impl Fn(usize) -> u64, _: usize) -> Self {
        ParticleId(words(0))
    }
    #[inline(always)]
    fn store(self, words: impl Fn(usize, u64), _: usize) {
        words(0, self.0)
    }
}

/// In 2D the third component reads as zero and is not stored.
impl Element for Vec3 {
    const SHAPE: ColumnShape = ColumnShape::Vector;
    #[inline(always)]
    fn load(words: impl Fn(usize) -> u64, width: usize) -> Self {
        let z = if width == 3 { f64::from_bits(words(2)) } else { 0.0 };
        Vec3::new(f64::from_bits(words(0)), f64::from_bits(words(1)), z)
    }
    #[inline(always)]
    fn store(self, words: impl Fn(usize, u64), width: usize) {
        words(0, self.x.to_bits());
        words(1, self.y.to_bits());
        if width == 3 {
            words(2, self.z.to_bits());
        }
    }
}

impl Element for Deviator {
    const SHAPE: ColumnShape = ColumnShape::Deviator;
    #[inline(always)]
    fn load(words: impl Fn(usize) -> u64, width: usize) -> Self {
        let at = |k| f64::from_bits(words(k));
        let (xz, yz) = if width == 5 { (at(3), at(4)) } else { (0.0, 0.0) };
        Self { xx: at(0), yy: at(1), xy: at(2), xz, yz }
    }
    #[inline(always)]
    fn store(self, words: impl Fn(usize, u64), width: usize) {
        words(0, self.xx.to_bits());
        words(1, self.yy.to_bits());
        words(2, self.xy.to_bits());
        if width == 5 {
            words(3, self.xz.to_bits());
            words(4, self.yz.to_bits());
        }
    }
}

/// Columns that can be read particle by particle: all of a rank, or a chunk's.
pub trait Values {
    fn value<T: Element>(&self, column: Column<T>, i: usize) -> T;
}

impl Values for Columns {
    #[inline]
    fn value<T: Element>(&self, column: Column<T>, i: usize) -> T {
        self.get(column, i)
    }
}

/// A column in the registry.
#[derive(Debug, Clone)]
pub struct Entry {
    pub info: ColumnInfo,
    /// Name in files: the declared one, with the suffix of an integrator's own columns.
    pub name: String,
    pub shape: ColumnShape,
    /// 64-bit words per particle.
    pub width: usize,
    /// The effect that declared it.
    pub owner: &'static str,
}

/// All columns of a run, in the order in which they were declared.
#[derive(Debug, Clone)]
pub struct Registry {
    pub dimension: usize,
    pub entries: Vec<Entry>,
    /// Index of every integrated column.
    pub integrated: Vec<usize>,
    owner: &'static str,
}

impl Registry {
    pub fn new(dimension: usize) -> Self {
        Self { dimension, entries: Vec::new(), integrated: Vec::new(), owner: "" }
    }

    /// Sets the effect that declares the following columns.
    pub fn owner(&mut self, owner: &'static str) -> &mut Self {
        self.owner = owner;
        self
    }

    pub fn column<T: Element>(&mut self, info: ColumnInfo) -> Column<T> {
        self.push::<T>(info, info.name.to_string())
    }

    /// Declares a state column that the integrator advances by its rate.
    pub fn integrated<T: Element>(&mut self, info: ColumnInfo) -> Integrated<T> {
        let value = self.push::<T>(info, info.name.to_string());
        self.integrated.push(value.index);
        Integrated { value, slot: self.integrated.len() - 1 }
    }

    /// A column of the shape of column `index`, whose name it takes with `suffix`; never in snapshots. Returns its index.
    pub fn like(&mut self, index: usize, suffix: &str, life: Life) -> usize {
        let Entry { info, ref name, shape, width, .. } = self.entries[index];
        let (name, info) = (format!("{name}{suffix}"), ColumnInfo { life, snapshot: false, ..info });
        self.add(Entry { info, name, shape, width, owner: self.owner })
    }

    /// The column another effect declared, if this scene has it.
    pub fn find<T: Element>(&self, name: &str) -> Option<Column<T>> {
        let index = self.entries.iter().position(|e| e.name == name)?;
        assert!(self.entries[index].shape == T::SHAPE, "column {name} requested with another shape");
        Some(Column { index, element: PhantomData })
    }

    /// The column another effect declared, which `who` needs.
    pub fn need<T: Element>(&self, who: &str, name: &str) -> Result<Column<T>> {
        let missed = || Error::new(format!("{who} needs the column {name}, which nothing in this scene has"));
        self.find(name).ok_or_else(missed)
    }

    /// Bytes of columns per particle.
    pub fn bytes_per_particle(&self) -> usize {
        self.entries.iter().map(|e| 8 * e.width).sum()
    }

    fn push<T: Element>(&mut self, info: ColumnInfo, name: String) -> Column<T> {
        let width = T::SHAPE.words(self.dimension);
        let index = self.add(Entry { info, name, shape: T::SHAPE, width, owner: self.owner });
        Column { index, element: PhantomData }
    }

    fn add(&mut self, entry: Entry) -> usize {
        assert!(self.entries.iter().all(|e| e.name != entry.name), "column {} declared twice", entry.name);
        self.entries.push(entry);
        self.entries.len() - 1
    }
}

/// The columns themselves: owned particles only, `len` of them, each column `len * width` words.
#[derive(Debug)]
pub struct Columns {
    pub registry: Arc<Registry>,
    words: Vec<Vec<u64>>,
    len: usize,
}

impl Columns {
    pub fn new(registry: Registry) -> Self {
        let words = registry.entries.iter().map(|_| Vec::new()).collect();
        Self { registry: Arc::new(registry), words, len: 0 }
    }

    /// The same columns, without a particle.
    pub fn without_particles(&self) -> Self {
        let words = self.words.iter().map(|_| Vec::new()).collect();
        Self { registry: Arc::clone(&self.registry), words, len: 0 }
    }

    /// Becomes a copy of these particles of `from`, in this order.
    pub fn copy_of(&mut self, from: &Self, which: &[u32]) {
        for ((column, from), entry) in self.words.iter_mut().zip(&from.words).zip(&self.registry.entries) {
            let width = entry.width;
            column.clear();
            column.reserve(which.len() * width);
            for &i in which {
                column.extend_from_slice(&from[i as usize * width..(i as usize + 1) * width]);
            }
        }
        self.len = which.len();
    }

    /// Becomes a copy of `from`.
    pub fn copy_all(&mut self, from: &Self) {
        for (column, from) in self.words.iter_mut().zip(&from.words) {
            column.clear();
            column.extend_from_slice(from);
        }
        self.len = from.len;
    }

    /// Writes its particles over these particles of `to`.
    pub fn write_back(&self, to: &mut Self, which: &[u32]) {
        for ((column, to), entry) in self.words.iter().zip(&mut to.words).zip(&self.registry.entries) {
            let width = entry.width;
            for (k, &i) in which.iter().enumerate() {
                to[i as usize * width..(i as usize + 1) * width].copy_from_slice(&column[k * width..(k + 1) * width]);
            }
        }
    }

    pub fn len(&self) -> usize {
        self.len
    }

    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// New particles are zero in every column.
    pub fn resize(&mut self, len: usize) {
        for (column, entry) in self.words.iter_mut().zip(&self.registry.entries) {
            column.reserve_exact((len * entry.width).saturating_sub(column.len()));
            prefer_large_pages(column);
            column.resize(len * entry.width, 0);
        }
        self.len = len;
    }

    /// All words of column `index` (length `len * width`).
    pub fn words(&self, index: usize) -> &[u64] {
        &self.words[index]
    }

    pub fn words_mut(&mut self, index: usize) -> &mut [u64] {
        &mut self.words[index]
    }

    /// Column `to` becomes equal to column `from`, of the same width.
    pub fn copy(&mut self, from: usize, to: usize) {
        let [from, to] = self.words.get_disjoint_mut([from, to]).expect("two different columns");
        to.copy_from_slice(from);
    }

    /// The column's words read as numbers; meaningless for ids.
    pub fn numbers(&self, index: usize) -> &[f64] {
        bytemuck::cast_slice(&self.words[index])
    }

    pub fn numbers_mut(&mut self, index: usize) -> &mut [f64] {
        bytemuck::cast_slice_mut(&mut self.words[index])
    }

    pub fn width(&self, index: usize) -> usize {
        self.registry.entries[index].width
    }

    #[inline]
    pub fn get<T: Element>(&self, column: Column<T>, i: usize) -> T {
        let width = self.registry.entries[column.index].width;
        let words = &self.words[column.index];
        T::load(|k| words[i * width + k], width)
    }

    #[inline]
    pub fn set<T: Element>(&mut self, column: Column<T>, i: usize, value: T) {
        let width = self.registry.entries[column.index].width;
        let words =
            std::cell::Cell::from_mut(&mut self.words[column.index][i * width..(i + 1) * width]).as_slice_of_cells();
        value.store(|k, w| words[k].set(w), width);
    }

    /// Reorders the particles, `order[new] = old`; `scratch` is reused between calls.
    pub fn reorder(&mut self, order: &[u32], scratch: &mut Vec<u64>) {
        for (column, entry) in self.words.iter_mut().zip(&self.registry.entries) {
            let width = entry.width;
            scratch.clear();
            for &old in order {
                scratch.extend_from_slice(&column[old as usize * width..(old as usize + 1) * width]);
            }
            // Back into its own buffer: those of wide columns would otherwise end up holding narrow ones.
            column.clear();
            column.extend_from_slice(scratch);
        }
        self.len = order.len();
    }

    /// Reorders the particles.
    pub fn rearrange(&mut self, reordering: &Reordering) {
        let columns = self.words.par_iter_mut().zip(&self.registry.entries);
        columns.for_each(|(column, entry)| reordering.apply(column, entry.width));
    }

    /// Words of one whole particle, all columns.
    pub fn particle_words(&self) -> usize {
        self.registry.entries.iter().map(|e| e.width).sum()
    }

    /// Appends particle `i`, all columns in registry order, to a message.
    pub fn write_particle(&self, i: usize, message: &mut Vec<u64>) {
        for (column, entry) in self.words.iter().zip(&self.registry.entries) {
            message.extend_from_slice(&column[i * entry.width..(i + 1) * entry.width]);
        }
    }

    /// Appends the particles of a message written by [`Columns::write_particle`].
    pub fn append(&mut self, message: &[u64]) {
        let per = self.particle_words();
        debug_assert_eq!(message.len() % per, 0);
        for particle in message.chunks_exact(per) {
            let mut at = 0;
            for (column, entry) in self.words.iter_mut().zip(&self.registry.entries) {
                column.extend_from_slice(&particle[at..at + entry.width]);
                at += entry.width;
            }
        }
        self.len += message.len() / per;
    }

    /// Bytes held, spare capacity included.
    pub fn bytes(&self) -> usize {
        self.words.iter().map(|c| 8 * c.capacity()).sum()
    }

    pub(super) fn raw(&mut self) -> impl Iterator<Item = (*mut u64, usize)> + '_ {
        self.words.iter_mut().zip(&self.registry.entries).map(|(c, e)| (c.as_mut_ptr(), e.width))
    }
}
