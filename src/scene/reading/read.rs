//! Reading a scene from a file or a text. Reading is pure and needs one process; a scene can be sent as bytes (serde) with every
//! number's bits.

use std::path::Path;

use toml::{Table, Value};

use super::complete::complete;
use super::tables::SceneTables;
use super::validate::validate;
use super::{curves, eos_tables, given, library, meshes, quality};
use crate::error::{Error, Result};
use crate::scene::document::keys;
use crate::scene::document::source::{Document, SourceText};
use crate::scene::validated::Scene;

/// Reads a scene from a file. `overrides` are `key=value`, as after `--set`.
pub fn read(path: &Path, overrides: &[String]) -> Result<Scene> {
    of(SourceText::open(path, overrides)?)
}

/// The scene of a text, and of the files that it names.
pub fn of(source: SourceText) -> Result<Scene> {
    from_source(with_files(source)?)
}

/// A text with what is in the files that it names.
pub fn with_files(mut source: SourceText) -> Result<SourceText> {
    curves::read_into(&mut source)?;
    meshes::read_into(&mut source)?;
    eos_tables::read_into(&mut source)?;
    given::read_into(&mut source)?;
    Ok(source)
}

/// The scene of a text whose files have been read, with further overrides.
pub fn with(source: &SourceText, overrides: &[String]) -> Result<Scene> {
    let mut source = source.clone();
    source.overrides.extend_from_slice(overrides);
    from_source(source)
}

impl Scene {
    /// Reads a scene from its text; `path` names it in messages.
    pub fn parse(path: &str, text: &str, overrides: &[String]) -> Result<Self> {
        from_source(SourceText::new(path, text, overrides))
    }

    /// The scene that its source gives with further overrides, e.g. another size of the projectile.
    pub fn reread(&self, overrides: &[String]) -> Result<Self> {
        with(&self.source, overrides)
    }
}

fn from_source(source: SourceText) -> Result<Scene> {
    let mut document = Document::parse(&source)?;
    library::complete(&mut document)?;
    quality::complete(&mut document)?;
    let mut written: SceneTables = keys::deserialize(&document)?;
    eos_tables::give(&mut written, &source);
    let tables = complete(&document, &written);
    let scene = validate(&document, &tables)?;
    check_numbers(&document, &scene)?;
    let understood =
        print(&tables).map_err(|e| Error::new(format!("the scene cannot be printed: {e}")).at(&source.path))?;
    Ok(Scene { understood, source: source.clone(), ..scene })
}

/// The scene as understood. What is off is not printed, except viscosity, which is on unless a material says otherwise; nor is what is in
/// files.
fn print(tables: &SceneTables) -> std::result::Result<String, toml::ser::Error> {
    let mut tables = tables.clone();
    eos_tables::give(&mut tables, &SourceText::new("", "", &[]));
    let mut tree = Table::try_from(&tables)?;
    let materials = tree.get_mut("material").and_then(Value::as_table_mut).into_iter().flatten();
    for material in materials.filter(|_| tables.numerics.viscosity).filter_map(|(_, material)| material.as_table_mut())
    {
        material.entry("viscosity").or_insert(Value::Boolean(false));
    }
    toml::to_string(&tree)
}

/// Finite numbers may have consequences that are not. Ranks get a scene as JSON, which has no such numbers: one without a check of
/// its own is found where it does not come back.
pub(in crate::scene) fn check_numbers(document: &Document, scene: &Scene) -> Result<()> {
    let text =
        serde_json::to_string(scene).map_err(|e| document.error("", format!("the scene cannot be sent: {e}")))?;
    let path = match serde_path_to_error::deserialize::<_, Scene>(&mut serde_json::Deserializer::from_str(&text)) {
        Ok(same) if same == *scene => return Ok(()),
        Ok(_) => String::new(),
        Err(e) => {
            let path = e.path().to_string().replace('[', ".").replace(']', "");
            // From fields of a scene to keys of its file.
            let tables = [("bodies", "body"), ("layers", "layer"), ("probes", "probe")];
            let table = tables.iter().find_map(|(field, key)| Some(format!("{key}{}", path.strip_prefix(field)?)));
            if path.starts_with("periods") { "domain.periodic".into() } else { table.unwrap_or(path) }
        }
    };
    Err(document.error(&path, "a number comes to nothing finite").allowed("sizes within reach of numbers"))
}
