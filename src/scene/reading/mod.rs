//! From a text to a scene: the tables are read, completed from the material library and the defaults, and validated.

mod bodies;
mod checks;
mod complete;
mod curves;
mod eos_tables;
mod given;
mod library;
mod meshes;
mod quality;
pub mod read;
mod rigid;
pub mod tables;
mod validate;
