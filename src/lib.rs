//! A hydrocode for impacts into strong, brittle, porous and dusty bodies: smoothed particle hydrodynamics, distributed with MPI.

pub mod error;
pub mod math;
pub mod units;
pub mod warning;

pub mod kernel;
pub mod particles;
pub mod random;

pub mod domain;
pub mod neighbours;

pub mod gravity;
pub mod material;
pub mod motion;
pub mod pair;

pub mod exact;
pub mod outcome;
pub mod output;
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
