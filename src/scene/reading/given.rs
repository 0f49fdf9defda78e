//! Particles in files: `from = { file = "runs/first/snapshot_0010.vtkhdf" }`. What a scene has to know of them is read with the scene, and
//! travels with its text to all ranks.

use std::collections::BTreeMap;
use std::sync::Arc;

use toml::Value;

use crate::error::Result;
use crate::scene::document::source::{Document, SourceText};
use crate::scene::given::gather;
use crate::scene::tables::body::from::{FromTable, wrong_file};

/// Reads the file of every body that names one. Paths start at the scene's folder; from here on they are whole, so that the scene as it
/// is understood can be read from anywhere.
pub fn read_into(source: &mut SourceText) -> Result<()> {
    let (mut given, mut overrides) = (BTreeMap::new(), Vec::new());
    {
        let document = Document::parse(source)?;
        let bodies = document.tree.get("body").and_then(Value::as_array);
        for (number, body) in bodies.into_iter().flatten().enumerate() {
            let path = format!("body.{number}.from");
            // What is wrong with the table is told when the whole scene is read.
            let Some(Ok(mut from)) = body.get("from").map(|table| table.clone().try_into::<FromTable>()) else {
                continue;
            };
            let wrong = |what: String| wrong_file(&document, &path, &from.file, &what);
            let whole = std::path::absolute(source.folder().join(&from.file)).map_err(|e| wrong(e.to_string()))?;
            from.file = whole.display().to_string();
            let file = from.particle_file(&document, &path)?;
            let found = gather(&file, &from.keep).map_err(|what| wrong_file(&document, &path, &from.file, &what))?;
            overrides.push(format!("{path}.file={}", Value::String(from.file.clone())));
            given.insert(from.key(), Arc::new(found));
        }
    }
    source.given = given;
    source.overrides.extend(overrides);
    Ok(())
}
