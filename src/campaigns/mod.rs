//! Runs that answer one question together, and what they will cost.

pub mod bracket;
pub mod cost;
pub mod fit;
pub mod keys;
pub mod model;
pub mod pace;
pub mod record;
pub mod search;
pub mod study;
mod text;
