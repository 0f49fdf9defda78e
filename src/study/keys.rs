//! Every key of scenes and studies, as `sph-mpi --keys` prints them, as documents have them, and as schemas for editors. All follow from
//! the types that parse the files.

use serde_json::Value;

use super::settings;
use crate::error::{Error, Result};
use crate::scene::keys::nearest;
use crate::scene::schema;
use crate::scene::schema::page::{Page, find, index, pages};

/// Between these lines a document has the tables of keys.
pub const BEGIN: &str = "<!-- keys: begin -->";
pub const END: &str = "<!-- keys: end -->";

/// The schema of scenes (`"scene"`) or of studies (`"study"`).
pub fn schema(of: &str) -> Result<Value> {
    match of {
        "scene" => Ok(schema::of_scene()),
        "study" => Ok(settings::schema()),
        _ => Err(Error::new(format!("no schema of `{of}`")).at("--schema").allowed("scene, study")),
    }
}

/// A schema as it is printed and stored.
pub fn schema_text(of: &str) -> Result<String> {
    Ok(format!("{:#}\n", schema(of)?))
}

/// The pages of all tables; the first is that of the keys of a scene outside of tables.
fn all() -> Vec<Page> {
    let study = pages(&settings::schema()).into_iter().filter(|page| !page.path.is_empty());
    pages(&schema::of_scene()).into_iter().chain(study).collect()
}

/// The keys of the table of this name, or the list of all tables where the name is empty.
pub fn text(table: &str) -> Result<String> {
    let pages = all();
    if table.is_empty() {
        return Ok(format!(
            "Tables; --keys TABLE prints the keys of one.\n\n{}",
            index(&pages.iter().collect::<Vec<_>>())
        ));
    }
    let Some(page) = find(&pages, table) else {
        let known: Vec<String> = pages.iter().map(|page| page.path.clone()).collect();
        let near = nearest(table, &known).map_or(String::new(), |near| format!(", did you mean `{near}`?"));
        return Err(Error::new(format!("unknown table `{table}`{near}"))
            .at("--keys")
            .allowed("what --keys alone lists"));
    };
    let within = format!("{}.", page.path);
    let inner: Vec<&Page> = pages.iter().filter(|other| other.path.starts_with(&within)).collect();
    let more = if inner.is_empty() { String::new() } else { format!("\nTables in it:\n\n{}", index(&inner)) };
    Ok(page.text() + &more)
}

/// The tables of keys as a document has them.
pub fn markdown() -> String {
    let pages = all();
    let sections: Vec<String> = pages
        .iter()
        .map(|page| match page.path.is_empty() {
            true => page.markdown().replacen("`[]`", "Outside of tables", 1),
            false => page.markdown(),
        })
        .collect();
    sections.join("\n")
}

/// A document with the tables of keys between the two lines that mark their place, or none where it has no such lines.
pub fn with_tables(document: &str) -> Option<String> {
    let (before, rest) = document.split_once(BEGIN)?;
    let (_, after) = rest.split_once(END)?;
    Some(format!("{before}{BEGIN}\n\n{}\n{END}{after}", markdown()))
}
