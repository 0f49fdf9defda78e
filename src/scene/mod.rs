//! Scenes: a TOML file is read into raw tables, completed from the material library and the defaults, and validated into a
//! [`Scene`]. From the top: `schema` (the keys described), `reading` (text -> tables -> completed tables -> scene), `warnings` and `identity` (what a scene may be
//! asked), `validated` (the scene), `hydrostatic` (bodies under their own weight), `tables` (one file per table), `geometry`, `values`
//! (what all tables use), `document` (the text), `mesh` (shape models), `given` (particles from files). Files import from those below only.

pub mod answer;
mod document;
mod geometry;
pub mod given;
mod hydrostatic;
pub mod identity;
mod mesh;
mod reading;
pub mod schema;
mod tables;
#[cfg(test)]
mod tests;
mod validated;
mod values;
mod warnings;

pub use document::{input, keys, source};
pub use geometry::shape::BodyShape;
pub use hydrostatic::pressed::Pressed;
pub use reading::read::{of, read, with, with_files};
pub use tables::body::blast::Blast;
pub use tables::body::flow::{Flow, Streams, VibrationMode};
pub use tables::body::given::{Given, Handover};
pub use tables::body::table::InitialState;
pub use tables::body::validated::Body;
pub use tables::compare::{ComparisonSettings, Solution};
pub use tables::impacts::deposit::DepositSettings;
pub use tables::impacts::intrusion::IntrusionSettings;
pub use tables::impacts::restitution::RestitutionSettings;
pub use tables::impacts::threshold::USUAL_RADII;
pub use tables::integrator::IntegratorRule;
pub use tables::numerics::SmoothingLengthRule;
pub use tables::output::{Precision, Snapshots};
pub use tables::regions::layer::Layer;
pub use tables::run::Until;
pub use tables::skin::SkinRule;
pub use validated::Scene;
