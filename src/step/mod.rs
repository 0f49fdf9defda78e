//! One step after another. A step is made of the stages of an integrator ([`integrator`]); for each stage particles are moved to
//! its moment and their material is updated ([`passes`]), lists are built anew where they do not hold
//! ([`neighbourhood`]), records are packed ([`pack`]) and exchanged, rates are evaluated ([`derivatives`]) and taken by the
//! integrator, and ranks reduce what is global ([`reduction`]).

mod buffers;
pub mod contact;
pub mod derivatives;
pub mod diagnostics;
pub mod failure;
pub mod integrator;
pub mod late;
mod lists;
pub mod neighbourhood;
mod own_gravity;
pub mod pack;
pub mod packing;
pub mod passes;
pub mod phases;
pub mod rates;
pub mod reduction;
mod rigid;
pub mod settings;
pub mod skin;
pub mod slopes;
pub mod stepper;
pub mod switch;
pub mod time_step;
mod touching;
pub mod workers;
pub mod workspace;

pub use diagnostics::Totals;
pub use failure::Failure;
pub use settings::{Counters, StepSettings, StepState};
pub use stepper::{Stepped, Stepper};
