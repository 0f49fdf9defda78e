//! Whether density is still mass over volume, and its return to it. Continuity integrates density without regard to the places of
//! particles; where they pass through each other, or are compressed by spurious forces, the two differ.

mod check;
mod relaxation;
mod sums;

pub use check::{DensityCheck, FACTOR, Packing};
pub use relaxation::{DensityRelaxation, is_due};
