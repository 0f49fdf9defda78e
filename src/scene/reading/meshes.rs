//! Shape models in files: `mesh = { file = "bennu.obj" }` is read with the scene, and travels with its text to all ranks.

use std::collections::BTreeMap;
use std::sync::Arc;

use toml::Value;

use crate::error::Result;
use crate::scene::document::source::{Document, SourceText};
use crate::scene::mesh::read::read;

/// Reads every shape model that a body names. Paths start at the scene's folder; from here on they are whole, so that the scene as it
/// is understood can be read from anywhere.
pub fn read_into(source: &mut SourceText) -> Result<()> {
    let (mut meshes, mut overrides) = (BTreeMap::new(), Vec::new());
    {
        let document = Document::parse(source)?;
        let mut files = Vec::new();
        if let Some(bodies) = document.tree.get("body") {
            find("body", bodies, &mut files);
        }
        for (path, file) in files {
            let wrong = |what: String| document.error(&path, what);
            let whole = std::path::absolute(source.folder().join(&file)).map_err(|e| wrong(e.to_string()))?;
            meshes.insert(whole.display().to_string(), Arc::new(read(&whole).map_err(wrong)?));
            overrides.push(format!("{path}={}", Value::String(whole.display().to_string())));
        }
    }
    source.meshes = meshes;
    source.overrides.extend(overrides);
    Ok(())
}

/// Key and name of the file of every `mesh` at or below a value.
fn find(path: &str, value: &Value, files: &mut Vec<(String, String)>) {
    match value {
        Value::Array(items) => items.iter().enumerate().for_each(|(n, item)| find(&format!("{path}.{n}"), item, files)),
        Value::Table(table) => {
            for (key, value) in table {
                let path = format!("{path}.{key}");
                match value.get("file").and_then(Value::as_str) {
                    Some(file) if key == "mesh" => files.push((format!("{path}.file"), file.into())),
                    _ => find(&path, value, files),
                }
            }
        }
        _ => {}
    }
}
