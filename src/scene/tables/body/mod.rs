//! `[[body]]`: a shape of one material on a lattice, with what its particles start with; or particles of a file.

pub mod blast;
pub mod blocks;
mod filling;
pub mod flow;
pub mod from;
pub mod given;
pub mod given_reader;
pub mod orientation;
pub mod reader;
pub mod rigid;
mod rigid_rules;
pub mod shape;
pub mod table;
pub mod validated;
