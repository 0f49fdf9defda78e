//! Values as the tables of a scene write them, beyond numbers with units: vectors, switches, words in a quantity's place, axes and
//! intervals; and the checks that several tables share.

pub mod axis;
pub mod checks;
pub mod components;
pub mod switch;
pub mod word;
