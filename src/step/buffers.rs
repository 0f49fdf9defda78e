//! What a rank holds for its pairs: records, and the chunks with and without ghosts in their rows. All of it follows from particles and
//! lists, and can be given back between two steps.

use std::ops::Range;

use crate::particles::chunk::chunk_range;

/// A line of 64 bytes.
#[repr(C, align(64))]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct Line(pub [f64; 8]);

/// Records, and which chunks read those of ghosts.
#[derive(Default)]
pub(super) struct Buffers {
    pub records: Vec<Line>,
    /// Chunks without ghosts in their rows.
    pub interior: Vec<u32>,
    /// Chunks with ghosts in their rows.
    pub boundary: Vec<u32>,
    pub all: Vec<u32>,
    /// Where a rank has fast particles: what the numbers above stand for instead of chunks, the stretches of slow particles.
    pub pieces: Option<Vec<Range<usize>>>,
    /// Whether lists and records were given back.
    pub released: bool,
}

impl Buffers {
    /// The particles that a number of `all` stands for, of `count`.
    #[inline]
    pub fn range(&self, number: usize, count: usize) -> Range<usize> {
        self.pieces.as_ref().map_or_else(|| chunk_range(number, count), |pieces| pieces[number].clone())
    }

    pub fn writer(&mut self) -> Writer {
        Writer(bytemuck::cast_slice_mut::<Line, f64>(&mut self.records).as_mut_ptr())
    }
}

/// Where threads write records, each those of its own particles.
#[derive(Clone, Copy)]
pub(super) struct Writer(*mut f64);

// SAFETY: who writes through it keeps to the slots of particles that are its own, see `Packer::pack`.
unsafe impl Sync for Writer {}

impl Writer {
    pub fn start(&self) -> *mut f64 {
        self.0
    }
}
