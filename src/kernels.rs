//! What loops over pairs of particles are made of: a library of its own, so that these can be compiled once, apart from the program.

pub mod kernel;
pub mod math;
pub mod pair;
pub mod random;
