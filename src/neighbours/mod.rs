//! Lists of neighbours within the larger of two list radii. Knows positions and radii, no physics and no
//! ranks: its input is the local set.

mod cells;
mod filter;
pub mod list;
mod stream;

pub use list::NeighbourList;
