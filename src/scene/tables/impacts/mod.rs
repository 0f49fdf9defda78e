//! What a scene says of an impact: who hits whom, where the target is finer, what is asked about it, what follows after the shock.

pub mod deposit;
pub mod fragments;
pub mod impact;
pub mod intrusion;
pub mod late_stage;
pub mod named;
pub mod nbody;
pub mod outcome;
pub mod refine;
pub mod restitution;
pub mod threshold;
