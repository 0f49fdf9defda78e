//! The cost of a run, predicted before it starts: `--check`.

pub mod cost;
pub mod model;
pub mod pace;
