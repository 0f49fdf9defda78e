//! `start = "hydrostatic"`: bodies that are compressed by their own weight from the start.

mod ball;
mod isentrope;
pub mod pressed;
mod slab;
