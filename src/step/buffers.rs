//! What a rank holds for its pairs: records, and the chunks with and without ghosts in their rows. All of it follows from particles and
//! lists, and can be given back between two steps.

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
    /// Whether lists and records were given back.
    pub released: bool,
}
