//! A scene's text, what the command line sets over it, and where in both a key stands, so that an error can say it.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use serde::{Deserialize, Serialize};
use toml::de::{DeTable, DeValue};
use toml::{Table, Value};

use super::input;
use crate::error::{Error, Result};
use crate::material::eos::tabulated::grid::Grid;
use crate::scene::given::Gathered;
use crate::scene::mesh;

/// Text and overrides a scene was read from.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct SourceText {
    /// Path of the file, for messages.
    pub path: String,
    pub text: String,
    /// `key=value`, in the order in which they apply.
    pub overrides: Vec<String>,
    /// Shape models by the names that the scene gives their files.
    pub meshes: BTreeMap<String, mesh::Shared>,
    /// Tables of equations of state by the names of their files.
    pub tables: BTreeMap<String, Arc<Grid>>,
    /// What is known of particles in files, by `FromTable::key`.
    pub given: BTreeMap<String, Arc<Gathered>>,
}

impl SourceText {
    /// A text that names no files.
    pub fn new(path: impl Into<String>, text: impl Into<String>, overrides: &[String]) -> Self {
        Self { path: path.into(), text: text.into(), overrides: overrides.to_vec(), ..Self::default() }
    }

    /// Reads the file; `overrides` are `key=value`, as after `--set`.
    pub fn open(path: &Path, overrides: &[String]) -> Result<Self> {
        let place = path.display().to_string();
        let text = input::read(path).map_err(|what| Error::new(format!("cannot read the scene: {what}")).at(&place))?;
        Ok(Self::new(place, text, overrides))
    }

    /// Where paths that it names start: its own folder; of what comes through a pipe, the one the program was started in.
    pub fn folder(&self) -> &Path {
        let path = Path::new(&self.path);
        let own = !input::is_passed_on(path);
        path.parent().filter(|_| own).unwrap_or(Path::new(""))
    }
}

/// The TOML tree of a source with its overrides applied. Keys are named by dotted paths; bodies by their number
/// (`body.0.shape.sphere.radius`), which messages replace by their name.
pub struct Document<'a> {
    source: &'a SourceText,
    pub tree: Table,
    /// Dotted path and text of each override.
    set: Vec<(String, &'a str)>,
}

/// Keys of one table that say the same thing in another way: where one is set over a scene, or named by a scene over the
/// library, the later word counts.
const RIVALS: [&[&str]; 18] = [
    &["particles", "spacing"],
    &["shape", "from"],
    &["eta", "neighbours"],
    &["snapshots", "every"],
    &["seed", "axis"],
    &["seed", "angle"],
    &["pressure", "internal_energy"],
    &["sound_speed", "bulk_modulus"],
    &["tillotson", "simplified_tillotson", "ideal_gas"],
    &["p_alpha", "rho_alpha", "epsilon_alpha"],
    &["quadratic", "two_slope", "measured"],
    &["P_e", "elastic_strain"],
    &["collins", "drucker_prager"],
    &["sphere", "disc", "box", "cylinder", "heap", "half_sphere", "half_disc", "ellipsoid", "mesh", "all"],
    &["scale", "size", "volume"],
    &["radial", "stretch", "wave", "mode"],
    &["velocity", "along", "damping"],
    &["value", "against"],
];

/// The keys that `key` excludes beside it.
pub fn rivals(key: &str) -> impl Iterator<Item = &'static str> {
    RIVALS
        .iter()
        .filter(move |group| group.contains(&key))
        .flat_map(|group| *group)
        .copied()
        .filter(move |other| *other != key)
}

impl<'a> Document<'a> {
    pub fn parse(source: &'a SourceText) -> Result<Self> {
        let tree = source.text.parse::<Table>().map_err(|e| {
            let line = e.span().map_or(String::new(), |span| format!(":{}", line_at(&source.text, span.start)));
            Error::new(e.message().replace('\n', ", ")).at(format!("{}{line}", source.path))
        })?;
        let mut document = Self { source, tree, set: Vec::new() };
        for text in &source.overrides {
            let path = document.set(text)?;
            document.set.push((path, text));
        }
        Ok(document)
    }

    /// An error at a key.
    pub fn error(&self, path: &str, what: impl Into<String>) -> Error {
        Error::new(what).at(self.place(path))
    }

    /// The shape model in a file, where that has been read.
    pub fn mesh(&self, file: &str) -> Option<&mesh::Mesh> {
        self.source.meshes.get(file).map(|mesh| &**mesh)
    }

    /// What is known of the particles of a file, where that has been read.
    pub fn given(&self, key: &str) -> Option<Arc<Gathered>> {
        self.source.given.get(key).cloned()
    }

    /// Whether the scene has a key, before anything is filled up.
    pub fn says(&self, path: &str) -> bool {
        let mut steps = path.split('.');
        let first = steps.next().and_then(|key| self.tree.get(key));
        steps
            .try_fold(first, |value, key| {
                let value = value?;
                Some(key.parse::<usize>().map_or_else(|_| value.get(key), |number| value.get(number)))
            })
            .flatten()
            .is_some()
    }

    /// Names of the scene's bodies.
    pub fn body_names(&self) -> Vec<&str> {
        let bodies = self.tree.get("body").and_then(Value::as_array);
        bodies.into_iter().flatten().filter_map(|b| b.get("name")?.as_str()).collect()
    }

    /// Keys of the shape of the body that an override addresses, which stand directly under its name there.
    pub fn shape_keys(&self, path: &str) -> Vec<&str> {
        // A key of one of the body's tables is not beside them.
        let key =
            path.strip_prefix("body.").and_then(|rest| rest.split_once('.')).filter(|(_, key)| !key.contains('.'));
        let number = key.and_then(|(number, _)| number.parse::<usize>().ok());
        let Some(number) = number.filter(|_| self.set.iter().any(|(set, _)| set == path)) else { return Vec::new() };
        let shape = self.tree["body"].get(number).and_then(|body| body.get("shape")?.as_table()?.iter().next());
        shape.and_then(|(_, keys)| keys.as_table()).map_or(Vec::new(), |keys| keys.keys().map(String::as_str).collect())
    }

    /// File, line and key, or the override that gave the key its value.
    pub fn place(&self, path: &str) -> String {
        let within = |outer: &str, inner: &str| inner == outer || inner.starts_with(&format!("{outer}."));
        if let Some((_, text)) = self.set.iter().rev().find(|(set, _)| within(set, path) || within(path, set)) {
            return format!("--set {text}");
        }
        let file = match self.line(path) {
            Some(line) => format!("{}:{line}", self.source.path),
            None => self.source.path.clone(),
        };
        if path.is_empty() { file } else { format!("{file}: {}", self.readable(path)) }
    }

    /// The path with a body's name in place of its number.
    fn readable(&self, path: &str) -> String {
        let named = path.strip_prefix("body.").and_then(|rest| {
            let (number, rest) = rest.split_once('.').unwrap_or((rest, ""));
            let name = self.tree.get("body")?.get(number.parse::<usize>().ok()?)?.get("name")?.as_str()?;
            Some(if rest.is_empty() { format!("body {name}") } else { format!("body {name}, {rest}") })
        });
        named.unwrap_or_else(|| path.to_string())
    }

    /// The line of a key, or of the innermost table around it that the file has.
    fn line(&self, path: &str) -> Option<usize> {
        let document = DeTable::parse(&self.source.text).ok()?;
        let mut offset = None;
        let mut here: Option<&DeValue> = None;
        for key in path.split('.') {
            let next = match here {
                None => find(document.get_ref(), key),
                Some(DeValue::Table(table)) => find(table, key),
                Some(DeValue::Array(array)) => {
                    key.parse().ok().and_then(|n: usize| array.get(n)).map(|v| (v.span().start, v.get_ref()))
                }
                Some(_) => None,
            };
            let Some((start, value)) = next else { break };
            offset = Some(start);
            here = Some(value);
        }
        offset.map(|start| line_at(&self.source.text, start))
    }

    /// Applies `key=value` and returns the key's path in the tree. `false` removes a table.
    fn set(&mut self, text: &str) -> Result<String> {
        let (key, value) = text.split_once('=').ok_or_else(|| {
            Error::new("no `=` in an override")
                .at(format!("--set {text}"))
                .allowed("key=value, e.g. target.particles=200000")
        })?;
        let (key, value) = (key.trim(), value.trim());
        if key.is_empty() || key.split('.').any(str::is_empty) {
            return Err(Error::new(format!("`{key}` is not a key"))
                .at(format!("--set {text}"))
                .allowed("keys joined by dots"));
        }
        let value = format!("x = {value}")
            .parse::<Table>()
            .ok()
            .filter(|t| t.len() == 1)
            .and_then(|mut t| t.remove("x"))
            .unwrap_or_else(|| Value::String(value.to_string()));
        let path = self.resolve(key);
        let steps: Vec<&str> = path.split('.').collect();
        let (last, parents) = steps.split_last().expect("split yields one part or more");
        let off = value.as_bool() == Some(false);
        for (depth, key) in steps.iter().enumerate().filter(|_| !off) {
            if rivals(key).next().is_none() {
                continue;
            }
            if let Some(table) = descend(&mut self.tree, &steps[..depth]) {
                rivals(key).for_each(|rival| drop(table.remove(rival)));
            }
        }
        let table = descend(&mut self.tree, parents).ok_or_else(|| {
            Error::new(format!("`{key}` leads through a key that is not a table")).at(format!("--set {text}"))
        })?;
        let removes = off && table.get(*last).is_some_and(|old| old.is_table() || old.is_array());
        if removes {
            table.remove(*last)
        } else {
            table.insert(last.to_string(), value)
        };
        Ok(path)
    }

    /// A key as the command line names it -> its path in the tree: a body by its name, its shape's keys directly.
    fn resolve(&self, key: &str) -> String {
        let (first, rest) = key.split_once('.').unwrap_or((key, ""));
        let bodies = self.tree.get("body").and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
        let Some(number) = bodies.iter().position(|b| b.get("name").and_then(Value::as_str) == Some(first)) else {
            return key.to_string();
        };
        let shape = bodies[number].get("shape").and_then(Value::as_table).and_then(|s| s.iter().next());
        match shape {
            Some((kind, keys)) if keys.get(rest).is_some() => format!("body.{number}.shape.{kind}.{rest}"),
            _ if rest.is_empty() => format!("body.{number}"),
            _ => format!("body.{number}.{rest}"),
        }
    }
}

fn find<'t, 'i>(table: &'t DeTable<'i>, key: &str) -> Option<(usize, &'t DeValue<'i>)> {
    table.iter().find(|(k, _)| k.get_ref() == key).map(|(k, v)| (k.span().start, v.get_ref()))
}

/// The table at the end of `path`, made where it is missing or was only switched on.
fn descend<'t>(table: &'t mut Table, path: &[&str]) -> Option<&'t mut Table> {
    let Some((key, rest)) = path.split_first() else { return Some(table) };
    let value = table.entry(key.to_string()).or_insert_with(|| Value::Table(Table::new()));
    if value.is_bool() {
        *value = Value::Table(Table::new());
    }
    match value {
        Value::Table(inner) => descend(inner, rest),
        Value::Array(items) => {
            let (number, rest) = rest.split_first()?;
            descend(items.get_mut(number.parse::<usize>().ok()?)?.as_table_mut()?, rest)
        }
        _ => None,
    }
}

fn line_at(text: &str, offset: usize) -> usize {
    1 + text.as_bytes()[..offset.min(text.len())].iter().filter(|b| **b == b'\n').count()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "title = \"t\"\n\n[[body]]\nname = \"target\"\nshape = { sphere = { radius = 1 } }\nspacing = 2\n\
        [material.basalt.fracture]\nseed = 1\n[numerics]\nartificial_stress = true\n";

    fn source(overrides: &[&str]) -> SourceText {
        let overrides: Vec<String> = overrides.iter().map(|s| s.to_string()).collect();
        SourceText::new("s.toml", TEXT, &overrides)
    }

    #[test]
    fn overrides_reach_bodies_shapes_and_tables() {
        let source = source(&[
            "target.radius=12 km",
            "target.particles=500",
            "material.basalt.fracture=false",
            "numerics.artificial_stress.factor=0.3",
            "run.until=5",
        ]);
        let tree = Document::parse(&source).unwrap().tree;
        let body = &tree["body"][0];
        assert_eq!(body["shape"]["sphere"]["radius"].as_str(), Some("12 km"));
        assert_eq!(body["particles"].as_integer(), Some(500));
        assert!(body.get("spacing").is_none());
        // A choice over another one: the later word counts.
        let other = SourceText { overrides: vec!["target.shape.box.size=[1, 1, 1]".into()], ..source.clone() };
        assert!(Document::parse(&other).unwrap().tree["body"][0]["shape"].get("sphere").is_none());
        assert!(tree["material"]["basalt"].get("fracture").is_none());
        assert_eq!(tree["numerics"]["artificial_stress"]["factor"].as_float(), Some(0.3));
        assert_eq!(tree["run"]["until"].as_integer(), Some(5));
    }

    #[test]
    fn places_name_file_line_and_key_or_the_override() {
        let source = source(&["run.until=5"]);
        let document = Document::parse(&source).unwrap();
        assert_eq!(document.place("body.0.shape.sphere.radius"), "s.toml:5: body target, shape.sphere.radius");
        assert_eq!(document.place("body.0.velocity"), "s.toml:3: body target, velocity");
        assert_eq!(document.place("material.basalt.fracture.seed"), "s.toml:8: material.basalt.fracture.seed");
        assert_eq!(document.place("run.until"), "--set run.until=5");
    }

    #[test]
    fn broken_text_and_overrides() {
        let broken = SourceText { text: "title = \"x\"\nbody = [".into(), ..source(&[]) };
        assert!(Document::parse(&broken).err().unwrap().place.starts_with("s.toml:2"));
        for bad in ["target.particles", "=5", "a..b=5", "title.x=5", "body.7.name=5"] {
            assert!(Document::parse(&source(&[bad])).is_err(), "{bad}");
        }
    }
}
