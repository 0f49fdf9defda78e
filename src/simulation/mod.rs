//! One run of a scene, from its particles to its outcome and its price.

mod collapse;
pub mod compare;
pub mod directory;
mod due;
pub mod faults;
mod files;
mod finish;
pub mod footprint;
mod ground;
pub mod late;
pub mod lock;
pub mod log;
pub mod memory;
pub mod modes;
mod nbody;
pub mod probes;
pub mod report;
mod require;
pub mod resources;
mod restart;
pub mod run;
pub mod setup;
pub mod signals;
pub mod state;
pub mod warnings;

pub use require::require;
pub use run::{Ended, Options, RunReport, run};
