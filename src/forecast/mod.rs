//! What a run will cost, before it starts: `--check`.

pub mod cost;
pub mod model;
pub mod pace;
