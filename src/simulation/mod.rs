//! One run of a scene, from its particles to its outcome and its cost.

mod collapse;
mod due;
mod files;
mod finish;
pub mod footprint;
mod ground;
mod late;
mod nbody;
mod open;
pub mod probes;
mod report;
mod require;
mod restart;
pub mod run;
pub mod scales;
pub mod setup;
pub mod state;
mod steps;
mod summary;
pub mod warnings;

pub use require::require;
pub use run::{Ended, Options, RunReport};
pub use steps::run;
