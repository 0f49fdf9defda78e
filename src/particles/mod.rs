//! The particles of one rank: columns, ids and order, cells, and local views of them.

pub mod cells;
pub mod chunk;
pub mod columns;
pub mod curve;
pub mod id;
pub mod large_pages;
pub mod local;
pub mod order;
pub mod periods;
pub mod rates;

pub use cells::{Lattice, Place, Site};
pub use chunk::{Chunk, View};
pub use columns::{Column, ColumnInfo, ColumnShape, Columns, Element, Integrated, Life, Registry, Values};
pub use id::ParticleId;
pub use local::Local;
pub use periods::Periods;
pub use rates::Rates;
