//! One substep after another: predict, material, lists if they must be rebuilt, pack, exchange, pair loop, rates, correct.

pub mod diagnostics;
pub mod evaluate;
pub mod failure;
pub mod integrator;
pub mod late;
pub mod neighbourhood;
pub mod pack;
pub mod packing;
pub mod phases;
pub mod stepper;
pub mod time_step;
pub mod workers;

pub use diagnostics::Totals;
pub use failure::Failure;
pub use stepper::{Counters, Stepper};
