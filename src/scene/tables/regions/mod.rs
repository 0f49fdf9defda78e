//! Parts of bodies, by where their particles start: layers with a motion of their own, probes.

pub mod layer;
pub mod probe;
pub mod region;
