//! Runs that answer one question together.

pub mod bracket;
pub mod fit;
