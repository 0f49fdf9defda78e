//! One run of a scene, from its particles to its outcome and its cost.

mod collapse;
mod due;
pub mod footprint;
mod handover;
mod late;
mod open;
mod require;
mod restart;
pub mod results;
mod rigid;
pub mod run;
pub mod scales;
pub mod setup;
pub mod state;
mod steps;

pub use require::require;
pub use run::{Ended, Options, RunReport};
pub use steps::run;
