//! The keys of tables: reading them, and messages about unknown, missing and wrong ones for the person who wrote the scene, with
//! file, line and what is allowed.

use serde::de::{DeserializeOwned, Deserializer, Visitor, value};
use serde::forward_to_deserialize_any;

use super::source::Document;
use crate::error::{Error, Result};

/// Reads the tables of a tree: a completed scene's, or those of another file.
pub fn deserialize<T: DeserializeOwned>(document: &Document) -> Result<T> {
    let tree = toml::Value::Table(document.tree.clone());
    serde_path_to_error::deserialize(tree).map_err(|e| {
        let path = e.path().to_string().replace('[', ".").replace(']', "");
        explain(document, if path == "." { "" } else { &path }, e.inner().message())
    })
}

/// The keys that the table `T` has, in their order.
pub fn keys_of<T: DeserializeOwned>() -> &'static [&'static str] {
    /// Takes the keys that a derived `Deserialize` names, and gives nothing back.
    struct Names<'a>(&'a mut &'static [&'static str]);
    impl<'de> Deserializer<'de> for Names<'_> {
        type Error = value::Error;
        fn deserialize_struct<V: Visitor<'de>>(
            self,
            _name: &'static str,
            keys: &'static [&'static str],
            _visitor: V,
        ) -> std::result::Result<V::Value, value::Error> {
            *self.0 = keys;
            Err(serde::de::Error::custom("only the names"))
        }
        fn deserialize_any<V: Visitor<'de>>(self, _visitor: V) -> std::result::Result<V::Value, value::Error> {
            Err(serde::de::Error::custom("no table"))
        }
        forward_to_deserialize_any! {
            bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit unit_struct
            newtype_struct seq tuple tuple_struct map enum identifier ignored_any
        }
    }
    let mut keys: &'static [&'static str] = &[];
    drop(T::deserialize(Names(&mut keys)));
    keys
}

fn explain(document: &Document, path: &str, message: &str) -> Error {
    let message = message.trim_end().replace('\n', ", ");
    if let Some(rest) = message.strip_prefix("unknown field ") {
        let (found, known) = names(rest);
        // The path of an unknown key ends in the key or in its table.
        let path = if path.rsplit('.').next() == Some(&found) { path.to_string() } else { join(path, &found) };
        let others = if path.contains('.') { document.shape_keys(&path) } else { document.body_names() };
        let others = others.iter().map(|name| name.to_string()).collect();
        return unknown(document, &path, "key", &found, &[others, known].concat());
    }
    if let Some(rest) = message.strip_prefix("unknown variant ") {
        let (found, known) = names(rest);
        return unknown(document, path, "choice", &found, &known);
    }
    if let Some(rest) = message.strip_prefix("missing field ") {
        let (key, _) = names(rest);
        let mut what = format!("key `{key}` is missing");
        if path.starts_with("material.") {
            what += ", and the library has none for this material";
        }
        return document.error(path, what);
    }
    if message.starts_with("invalid type: unit variant") {
        return document.error(path, "wanted one of its words or tables").allowed(listed(path));
    }
    if message.starts_with("wanted exactly 1 element, ") {
        return document.error(path, "wanted one of several").allowed("one key in this table");
    }
    // The names of types say nothing to who writes a scene.
    let message = match message.split_once(", expected struct ") {
        Some((what, _)) => format!("{what}, expected a table"),
        None => message,
    };
    match message.split_once(" (allowed: ") {
        Some((what, allowed)) => document.error(path, what).allowed(allowed.strip_suffix(')').unwrap_or(allowed)),
        None => document.error(path, message.as_str()),
    }
}

/// Where all that a key may be is told.
fn listed(path: &str) -> String {
    let steps = path.split('.').filter(|step| step.parse::<usize>().is_err());
    let steps: Vec<&str> = steps.collect();
    let table = &steps[..steps.len().saturating_sub(1)];
    format!("those that `sph-mpi --keys {}` lists", table.join("."))
}

/// An error that names the nearest of the known words, and all of them.
pub fn unknown(document: &Document, path: &str, kind: &str, found: &str, known: &[String]) -> Error {
    let mut what = format!("unknown {kind} `{found}`");
    if let Some(near) = nearest(found, known) {
        what += &format!(", did you mean `{near}`?");
    }
    document.error(path, what).allowed(known.join(", "))
}

/// The known word that `found` is most likely a misspelling of.
pub fn nearest<'a>(found: &str, known: &'a [String]) -> Option<&'a str> {
    let distance = |word: &str| strsim::damerau_levenshtein(&found.to_lowercase(), &word.to_lowercase());
    let best = known.iter().min_by_key(|word| distance(word))?;
    (distance(best) <= (found.chars().count() / 3).max(2)).then_some(best)
}

/// The words between backticks: the first, and the others.
fn names(text: &str) -> (String, Vec<String>) {
    let mut quoted = text.split('`').skip(1).step_by(2).map(str::to_string);
    (quoted.next().unwrap_or_default(), quoted.collect())
}

fn join(path: &str, key: &str) -> String {
    if path.is_empty() { key.to_string() } else { format!("{path}.{key}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_word_is_named_only_if_near() {
        let known = ["radius".to_string(), "height".to_string()];
        assert_eq!(nearest("raduis", &known), Some("radius"));
        assert_eq!(nearest("temperature", &known), None);
        assert_eq!(nearest("x", &[]), None);
    }
}
