//! Who is near whom: lists of neighbours within the larger of two list radii. Knows positions and radii, no physics and no
//! ranks: what it is given is the local set.

mod cells;
mod filter;
pub mod list;
mod stream;

pub use list::NeighbourList;
