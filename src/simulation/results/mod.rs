//! What a run gives: rows of its history, snapshots and checkpoints on its way; outcome, tables, pictures, warnings and the summary at
//! its end.

mod centres;
pub(in crate::simulation) mod deposit;
mod files;
pub(in crate::simulation) mod finish;
pub(in crate::simulation) mod fragments;
pub(in crate::simulation) mod ground;
pub(in crate::simulation) mod intrusion;
pub(in crate::simulation) mod nbody;
pub mod probes;
pub(in crate::simulation) mod remnant;
pub(in crate::simulation) mod report;
pub(in crate::simulation) mod restitution;
pub(in crate::simulation) mod summary;
mod temperature;
pub(in crate::simulation) mod trace;
pub mod warnings;
