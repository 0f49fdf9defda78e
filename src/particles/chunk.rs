//! Local updates run chunk by chunk: a few hundred particles, so that a chunk stays in cache while every effect passes over
//! it. Within a chunk all columns can be read and written through views of cells; chunks never overlap, so that threads
//! can work side by side.

use std::arch::x86_64::{_MM_HINT_T1, _mm_prefetch};
use std::cell::Cell;
use std::ops::Range;

use super::columns::{Column, Columns, Element, Values};

/// Particles per chunk.
pub const CHUNK: usize = 256;

/// Chunk number `chunk` of `count` particles.
pub fn chunk_range(chunk: usize, count: usize) -> Range<usize> {
    chunk * CHUNK..((chunk + 1) * CHUNK).min(count)
}

const WORDS_OF_LINE: usize = 8;

/// One column within a chunk; index 0 is the chunk's first particle.
#[derive(Clone, Copy)]
pub struct View<'a, T> {
    words: &'a [Cell<u64>],
    width: usize,
    element: std::marker::PhantomData<T>,
}

impl<'a, T: Element> View<'a, T> {
    pub fn new(words: &'a [Cell<u64>], width: usize) -> Self {
        Self { words, width, element: std::marker::PhantomData }
    }

    #[inline(always)]
    pub fn get(&self, i: usize) -> T {
        let words = &self.words[i * self.width..(i + 1) * self.width];
        T::load(|k| words[k].get(), self.width)
    }

    #[inline(always)]
    pub fn set(&self, i: usize, value: T) {
        let words = &self.words[i * self.width..(i + 1) * self.width];
        value.store(|k, w| words[k].set(w), self.width)
    }
}

/// A range of owned particles with exclusive access to all their columns.
pub struct Chunk<'a> {
    /// Owned particles of this chunk, as indices into the columns.
    pub range: Range<usize>,
    pointers: &'a [(*mut u64, usize)],
}

impl<'a> Chunk<'a> {
    pub fn len(&self) -> usize {
        self.range.len()
    }

    pub fn is_empty(&self) -> bool {
        self.range.is_empty()
    }

    /// Prefetches all columns of these particles of the chunk, which will be read soon.
    pub fn fetch(&self, particles: Range<usize>) {
        for &(start, width) in self.pointers {
            for line in (particles.start * width..particles.end * width).step_by(WORDS_OF_LINE) {
                let word = start.wrapping_add(self.range.start * width + line);
                // SAFETY: fetching reads nothing, wherever the address leads.
                unsafe { _mm_prefetch::<_MM_HINT_T1>(word.cast()) };
            }
        }
    }

    #[inline]
    pub fn view<T: Element>(&self, column: Column<T>) -> View<'_, T> {
        View::new(self.words(column.index), self.pointers[column.index].1)
    }

    /// The words of column `index` within this chunk.
    #[inline]
    pub fn words(&self, index: usize) -> &[Cell<u64>] {
        let (start, width) = self.pointers[index];
        // SAFETY: `Chunks::chunk` hands out ranges inside the column; its caller keeps them disjoint.
        unsafe { std::slice::from_raw_parts(start.add(self.range.start * width).cast(), self.range.len() * width) }
    }
}

impl Values for Chunk<'_> {
    #[inline]
    fn value<T: Element>(&self, column: Column<T>, i: usize) -> T {
        self.view(column).get(i)
    }
}

/// Hands out chunks of all columns; made once per pass.
pub struct Chunks<'a> {
    pointers: Vec<(*mut u64, usize)>,
    len: usize,
    columns: std::marker::PhantomData<&'a mut Columns>,
}

// SAFETY: the pointers lead into columns that are borrowed exclusively; disjoint chunks share no word.
unsafe impl Sync for Chunks<'_> {}
// SAFETY: as above.
unsafe impl Send for Chunks<'_> {}

impl<'a> Chunks<'a> {
    /// `pointers` is reused between passes so that a step allocates nothing.
    pub fn new(columns: &'a mut Columns, mut pointers: Vec<(*mut u64, usize)>) -> Self {
        pointers.clear();
        let len = columns.len();
        pointers.extend(columns.raw());
        Self { pointers, len, columns: std::marker::PhantomData }
    }

    /// # Safety
    /// No two chunks that live at the same time may overlap.
    pub unsafe fn chunk(&self, range: Range<usize>) -> Chunk<'_> {
        assert!(range.start <= range.end && range.end <= self.len);
        Chunk { range, pointers: &self.pointers }
    }

    pub fn into_pointers(self) -> Vec<(*mut u64, usize)> {
        self.pointers
    }
}
