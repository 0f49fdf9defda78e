//! `numerics.quality`: a word for several keys of `[numerics]`. What a scene says itself takes the place of what the word says.

use toml::{Table, Value};

use crate::error::Result;
use crate::scene::document::keys::unknown;
use crate::scene::document::source::{Document, rivals};

const QUALITIES: &str = include_str!("../tables/quality.toml");

/// Fills up the tree's `[numerics]` with the keys that its quality stands for.
pub fn complete(document: &mut Document) -> Result<()> {
    let Some(Value::Table(numerics)) = document.tree.get("numerics") else { return Ok(()) };
    // What is no text is refused when the table is read.
    let Some(name) = numerics.get("quality").and_then(Value::as_str) else { return Ok(()) };
    let qualities = qualities();
    let Some(Value::Table(chosen)) = qualities.get(name) else {
        let known: Vec<String> = qualities.keys().cloned().collect();
        return Err(unknown(document, "numerics.quality", "quality", name, &known));
    };
    let corrected = numerics.get("corrected_gradient") != Some(&Value::Boolean(false));
    let is_free = |key: &str| !numerics.contains_key(key) && rivals(key).all(|rival| !numerics.contains_key(rival));
    let added: Vec<(String, Value)> = chosen
        .iter()
        .filter(|(key, _)| is_free(key) && (corrected || !NEEDS_CORRECTION.contains(&key.as_str())))
        .map(|(key, value)| (key.clone(), value.clone()))
        .collect();
    if let Some(numerics) = document.tree.get_mut("numerics").and_then(Value::as_table_mut) {
        numerics.extend(added);
    }
    Ok(())
}

/// Keys that mean nothing without the corrected gradient.
const NEEDS_CORRECTION: [&str; 1] = ["reconstruction"];

/// The keys of each quality.
pub fn qualities() -> Table {
    QUALITIES.parse().expect("the table of qualities is valid TOML: a test reads it")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;
    use crate::scene::document::source::SourceText;

    const BODY: &str = "[[body]]\nname = \"ball\"\nshape = { sphere = { radius = 1 } }\nmaterial = \"basalt\"\nparticles = 1000\n[run]\nuntil = 1\n";

    fn scene(numerics: &str) -> Result<Scene> {
        Scene::parse("s.toml", &format!("{BODY}[numerics]\n{numerics}"), &[])
    }

    #[test]
    fn every_quality_is_a_table_of_numerics() {
        for name in qualities().keys() {
            let read = scene(&format!("quality = \"{name}\"")).expect("a scene");
            // Read again from what it was understood as, it is the same.
            let again = Scene::parse("s.toml", &read.to_toml(), &[]).expect("a scene");
            assert_eq!(read.numerics, again.numerics);
        }
    }

    /// The word for what a scene has if it says nothing.
    #[test]
    fn standard_is_the_default() {
        assert_eq!(scene("quality = \"standard\"").expect("a scene").numerics, scene("").expect("a scene").numerics);
    }

    #[test]
    fn the_scenes_own_keys_count_more() {
        let fine = scene("quality = \"fine\"").expect("a scene").numerics;
        let own = scene("quality = \"fine\"\nneighbours = 57\ncfl = 0.1\nviscosity_switch = false")
            .expect("a scene")
            .numerics;
        assert!((own.eta - 1.2).abs() < 1e-3 && own.cfl == 0.1 && own.viscosity_switch.is_none());
        assert_eq!((own.kernel, own.reconstruction), (fine.kernel, fine.reconstruction));
        assert!(!scene("quality = \"fine\"\ncorrected_gradient = false").expect("a scene").numerics.reconstruction);
    }

    #[test]
    fn an_unknown_quality_is_named() {
        let text = scene("quality = \"finer\"").unwrap_err().to_string();
        assert!(text.contains("unknown quality `finer`, did you mean `fine`?"), "{text}");
        assert!(scene("quality = 3").is_err());
        let source = SourceText::new("s.toml", "numerics = 3", &[]);
        complete(&mut Document::parse(&source).expect("TOML")).expect("refused when the table is read");
    }
}
