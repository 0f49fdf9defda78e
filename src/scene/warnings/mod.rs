//! What is allowed in a scene and still unlikely to be meant.

mod equilibrium;
mod resolution;
mod units;
