//! The particles of one rank: columns, who owns which, and local views of them.

pub mod chunk;
pub mod columns;
pub mod id;

pub use chunk::{Chunk, View};
pub use columns::{Column, ColumnInfo, Columns, Element, Integrated, Life, Registry, Shape};
pub use id::ParticleId;
