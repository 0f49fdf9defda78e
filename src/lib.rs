//! A hydrocode for impacts into strong, brittle, porous and dusty bodies: smoothed particle hydrodynamics, distributed with MPI.

pub use sph_mpi_kernels::{kernel, math, random};
/// Interactions of pairs of particles: their terms, and the loops over them.
pub mod pair {
    pub use sph_mpi_kernels::pair::*;
    pub use sph_mpi_loops::PairLoop;
}

pub mod error;
pub mod units;
pub mod warning;

pub mod particles;

pub mod domain;
pub mod neighbours;

pub mod gravity;
pub mod material;
pub mod motion;

pub mod exact;
pub mod outcome;
pub mod output;
pub mod report;
pub mod scene;

pub mod process;
pub mod step;

pub mod comparison;
pub mod simulation;

pub mod forecast;
pub mod threshold;

pub mod study;

pub mod cli;
pub mod program;
