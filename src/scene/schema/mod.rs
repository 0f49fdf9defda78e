//! The keys of scenes, described from the types that parse them: as a JSON Schema for editors, and as pages for people. Other files of
//! the program (studies) use the same two for their own types.

pub mod json;
mod library;
pub mod page;

use serde_json::Value;

use super::reading::tables::SceneTables;

/// The schema of a scene.
pub fn of_scene() -> Value {
    let mut schema = json::of::<SceneTables>("A scene of sph-mpi");
    library::complete(&mut schema);
    schema
}
