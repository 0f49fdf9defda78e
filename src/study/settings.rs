//! `[study]`: which scene, what is varied, and what counts as its error; read and validated. The file has a `title` beside it.
//!
//! Lists of one key in `[study.vary]` are axes of their own. Lists of one table, `[study.resolution]` or
//! `[study.together.NAME]`, change together: their first values belong to each other, then their second ones, and so on.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use toml::{Table, Value};

use super::measure::{Against, Measure};
use crate::error::{Error, Result};
use crate::scene::source::Document;
use crate::scene::{keys, schema as schemas};
use crate::units;

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct StudyFile {
    /// What figures and files call the study.
    #[serde(default)]
    title: String,
    study: StudyTable,
}

/// A study of another file's scene: error against cost over settings and resolutions.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct StudyTable {
    /// Path of the scene, from the folder of the study's file.
    scene: String,
    /// What is compared: a key of `errors` in summary.json, or any figure of it (`outcome.unbound_mass`) with `value` or `against`. Not
    /// needed where the scene has a `[threshold]`.
    error: Option<String>,
    /// A word of summary.json that is told of each point (`fragments.outcome`); where the values of two things are combined, a map of it
    /// is drawn. No `error` is needed beside it.
    word: Option<String>,
    /// What the figure should be, SI or with a unit.
    #[schemars(with = "Option<NumberOrText>")]
    value: Option<Value>,
    /// How well `value` is known, SI or with a unit.
    #[schemars(with = "Option<NumberOrText>")]
    uncertainty: Option<Value>,
    /// What the figure is compared with instead of a `value`; the exact solution without it.
    against: Option<AgainstWord>,
    /// Errors for which the cheapest setting is named: `"1 %"`, or a list.
    #[schemars(with = "Option<NumbersOrTexts>")]
    target: Option<Value>,
    /// How values combine into settings.
    #[serde(default)]
    combine: Combine,
    /// Dotted keys of the scene, as after --set, and their values in every run.
    #[serde(default)]
    #[schemars(with = "Values")]
    set: Table,
    /// Dotted keys with lists of one length, which change together; the spacing of a body must be among them. One resolution without it.
    #[serde(default)]
    #[schemars(with = "Values")]
    resolution: Table,
    /// Dotted keys with lists of values, each on its own; 10 000 runs in all at most.
    #[serde(default)]
    #[schemars(with = "Values")]
    vary: Table,
    /// A table for each thing to vary, by its name: dotted keys with lists of one length; `labels = [...]` names its values.
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, Values>")]
    together: Table,
}

/// Keys of another file's scene, which that file's schema knows.
type Values = BTreeMap<String, serde_json::Value>;

/// A number as a study writes it.
#[derive(JsonSchema)]
#[serde(untagged)]
#[expect(dead_code, reason = "only described: values are read with their place")]
enum NumberOrText {
    Number(f64),
    Text(String),
}

/// One or several of them.
#[derive(JsonSchema)]
#[serde(untagged)]
#[expect(dead_code, reason = "only described: values are read with their place")]
enum NumbersOrTexts {
    Number(f64),
    Text(String),
    List(Vec<NumberOrText>),
}

/// The schema of a study's file.
pub fn schema() -> serde_json::Value {
    schemas::json::of::<StudyFile>("A study of sph-mpi")
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum AgainstWord {
    /// The run of the smallest spacing.
    Finest,
}

/// How axes combine into settings; each setting is run at every resolution.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Combine {
    /// Each value of an axis with each of the others.
    #[default]
    Grid,
    /// The scene as it is, and each value of each axis alone over it.
    OneAtATime,
}

/// One value of a dotted key.
#[derive(Debug, Clone, PartialEq)]
pub struct Change {
    /// As in `--set`.
    pub key: String,
    pub value: Value,
    /// Where the study's file has it: `study.vary.numerics.eta`.
    pub path: String,
}

impl Change {
    /// As after `--set`.
    pub fn text(&self) -> String {
        format!("{}={}", self.key, self.value)
    }
}

/// What takes several values, each of them one change or several that belong together.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Axis {
    /// Of a table in `[study.together]`; empty for a single key.
    pub name: String,
    /// What its values are called; empty where the table does not say.
    pub labels: Vec<String>,
    pub values: Vec<Vec<Change>>,
}

/// The table, validated as far as it goes without the scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Settings {
    pub title: String,
    /// Relative to the study's file.
    pub scene: String,
    pub measure: Measure,
    /// Dotted key of summary.json.
    pub word: Option<String>,
    /// Errors for which the cheapest setting is named, largest first.
    pub targets: Vec<f64>,
    pub combine: Combine,
    /// Over the scene, in every run.
    pub set: Vec<Change>,
    /// One value where nothing is said of resolution.
    pub resolution: Axis,
    pub axes: Vec<Axis>,
}

impl Settings {
    pub fn read(document: &Document) -> Result<Self> {
        let raw: StudyFile = keys::deserialize(document)?;
        let study = raw.study;
        let mut resolution = together(document, "study.resolution", &study.resolution)?;
        if resolution.values.is_empty() {
            resolution.values.push(Vec::new());
        }
        let mut axes = Vec::new();
        for change in changes("study.vary", &study.vary) {
            let values = list(document, &change)?;
            let single = values.into_iter().map(|value| vec![Change { value, ..change.clone() }]);
            axes.push(Axis { values: single.collect(), ..Axis::default() });
        }
        for (name, table) in &study.together {
            let path = format!("study.together.{name}");
            let Value::Table(table) = table else {
                return Err(document.error(&path, "not a table").allowed(format!("[{path}] with lists of one length")));
            };
            axes.push(named(document, name, &path, table)?);
        }
        if axes.is_empty() && resolution.values.len() < 2 {
            return Err(document
                .error("study", "nothing is varied")
                .allowed("lists of values in [study.resolution] or [study.vary]"));
        }
        Ok(Self {
            measure: measure(document, &study)?,
            targets: targets(document, study.target.as_ref())?,
            word: study.word,
            title: raw.title,
            scene: study.scene,
            combine: study.combine,
            set: changes("study.set", &study.set),
            resolution,
            axes,
        })
    }

    /// How many runs the study asks for: settings that come out alike are counted apart.
    pub fn runs(&self) -> f64 {
        let lengths = self.axes.iter().map(|axis| axis.values.len() as f64);
        let settings: f64 = match self.combine {
            Combine::Grid => lengths.product(),
            Combine::OneAtATime => 1.0 + lengths.sum::<f64>(),
        };
        settings * self.resolution.values.len() as f64
    }
}

/// The leaves of a table of dotted keys.
fn changes(path: &str, table: &Table) -> Vec<Change> {
    fn collect(path: &str, key: &str, table: &Table, found: &mut Vec<Change>) {
        for (name, value) in table {
            let key = if key.is_empty() { name.clone() } else { format!("{key}.{name}") };
            match value {
                Value::Table(inner) if !inner.is_empty() => collect(path, &key, inner, found),
                _ => found.push(Change { path: format!("{path}.{key}"), key, value: value.clone() }),
            }
        }
    }
    let mut found = Vec::new();
    collect(path, "", table, &mut found);
    found
}

fn list(document: &Document, change: &Change) -> Result<Vec<Value>> {
    match &change.value {
        Value::Array(values) if !values.is_empty() => Ok(values.clone()),
        other => Err(document
            .error(&change.path, format!("{other} is no list of values"))
            .allowed(format!("{} = [first, second, ...]", change.key))),
    }
}

/// A table of `[study.together]`: `labels` of it are no key, they name its values.
fn named(document: &Document, name: &str, path: &str, table: &Table) -> Result<Axis> {
    let mut table = table.clone();
    let labels = table.remove("labels");
    let axis = together(document, path, &table)?;
    let text = |value: &Value| value.as_str().filter(|text| !text.is_empty()).map(str::to_string);
    let labels: Option<Vec<String>> = match &labels {
        None => Some(Vec::new()),
        Some(Value::Array(given)) => given.iter().map(text).collect(),
        Some(_) => None,
    };
    match labels {
        Some(labels) if labels.is_empty() || labels.len() == axis.values.len() => {
            Ok(Axis { name: name.into(), labels, ..axis })
        }
        _ => {
            let what = "labels do not name the values";
            Err(document
                .error(&format!("{path}.labels"), what)
                .allowed(format!("a list of {} texts", axis.values.len())))
        }
    }
}

/// Keys whose lists have one length and change together.
fn together(document: &Document, path: &str, table: &Table) -> Result<Axis> {
    let keys = changes(path, table);
    let mut values: Vec<Vec<Change>> = Vec::new();
    for change in &keys {
        let list = list(document, change)?;
        if values.is_empty() {
            values.resize(list.len(), Vec::new());
        }
        if values.len() != list.len() {
            let what = format!("{} values, and `{}` has {}", list.len(), keys[0].key, values.len());
            return Err(document.error(&change.path, what).allowed("lists of one length: they change together"));
        }
        for (group, value) in values.iter_mut().zip(list) {
            group.push(Change { value, ..change.clone() });
        }
    }
    Ok(Axis { values, ..Axis::default() })
}

/// What a search finds, which no error is needed for.
const THRESHOLD: &str = "threshold.q_star_d";

fn measure(document: &Document, study: &StudyTable) -> Result<Measure> {
    let figure = match study.error.as_deref() {
        None => study.word.clone().unwrap_or_else(|| THRESHOLD.to_string()),
        Some(error) if error.contains('.') => error.to_string(),
        Some(error) => format!("errors.{error}"),
    };
    let number = |key: &str, value: &Option<Value>| {
        value
            .as_ref()
            .map(|value| number(value).map_err(|e| document.error(&format!("study.{key}"), e.what)))
            .transpose()
    };
    let (value, uncertainty) = (number("value", &study.value)?, number("uncertainty", &study.uncertainty)?);
    let against = match (value, &study.against) {
        (Some(_), Some(_)) => {
            return Err(document.error("study.against", "both `value` and `against` are given").allowed("one of them"));
        }
        (Some(0.0), None) => {
            return Err(document.error("study.value", "errors are relative, and none is to zero").allowed("not 0"));
        }
        (Some(value), None) => Against::Value { value, uncertainty: uncertainty.unwrap_or(0.0).abs() },
        (None, Some(AgainstWord::Finest)) => Against::Finest,
        (None, None) if figure.starts_with("errors.") => Against::Exact,
        (None, None) if figure.starts_with("threshold.") || study.error.is_none() => Against::Nothing,
        (None, None) => {
            return Err(document
                .error("study.error", format!("`{figure}` has nothing to be compared with"))
                .allowed("value = ..., or against = \"finest\", or a key of `errors` in summary.json"));
        }
    };
    if against == Against::Nothing && study.target.is_some() {
        return Err(document
            .error("study.target", "nothing says what the error is")
            .allowed("beside `value` or `against`"));
    }
    if uncertainty.is_some() && value.is_none() {
        return Err(document.error("study.uncertainty", "the uncertainty of no value").allowed("beside value = ..."));
    }
    Ok(Measure { figure, against })
}

/// A bare number, which is SI, or a text with a unit.
fn number(value: &Value) -> Result<f64> {
    match value {
        Value::Integer(n) => Ok(*n as f64),
        Value::Float(x) if x.is_finite() => Ok(*x),
        Value::String(text) => units::si(text),
        other => Err(Error::new(format!("{other} is not a number"))),
    }
}

fn targets(document: &Document, given: Option<&Value>) -> Result<Vec<f64>> {
    let one = |value: &Value| match value {
        Value::String(text) => accuracy(text),
        other => accuracy(&other.to_string()),
    };
    let read = |value: &Value| one(value).map_err(|what| document.error("study.target", what).allowed(ACCURACIES));
    let mut targets = match given {
        None => Vec::new(),
        Some(Value::Array(list)) => list.iter().map(read).collect::<Result<Vec<_>>>()?,
        Some(value) => vec![read(value)?],
    };
    targets.sort_by(|a, b| b.total_cmp(a));
    targets.dedup();
    Ok(targets)
}

pub const ACCURACIES: &str = "\"1 %\" or 0.01, more than 0";

/// A relative error: `1 %`, `1%` or `0.01`.
pub fn accuracy(text: &str) -> std::result::Result<f64, String> {
    let (number, scale) = match text.trim().strip_suffix('%') {
        Some(number) => (number, 0.01),
        None => (text, 1.0),
    };
    let value = number.trim().parse::<f64>().ok().map(|x| scale * x);
    value.filter(|x| *x > 0.0 && x.is_finite()).ok_or_else(|| format!("`{text}` is no relative error"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::source::SourceText;

    fn read(text: &str) -> Result<Settings> {
        let source = SourceText::new("s.toml", text, &[]);
        Settings::read(&Document::parse(&source)?)
    }

    const HEAD: &str = "[study]\nscene = \"a.toml\"\nerror = \"density_l1\"\n";

    #[test]
    fn lists_of_a_group_change_together() {
        let settings = read(&format!(
            "{HEAD}target = [\"1 %\", 0.05]\n[study.resolution]\nrock.spacing = [\"2 m\", 1]\nrock.size = [[1, 2], [1, 3]]\n\
             [study.vary]\nnumerics.eta = [1.2, 1.4, 1.6]\n[study.together.viscosity]\nmaterial.gas.viscosity.alpha = [1, 2]\n\
             material.gas.viscosity.beta = [2, 4]\n"
        ))
        .unwrap();
        let texts = |axis: &Axis, k: usize| axis.values[k].iter().map(Change::text).collect::<Vec<_>>();
        assert_eq!(texts(&settings.resolution, 0), ["rock.spacing=\"2 m\"", "rock.size=[1, 2]"]);
        assert_eq!(texts(&settings.resolution, 1), ["rock.spacing=1", "rock.size=[1, 3]"]);
        assert_eq!(settings.axes.len(), 2);
        assert_eq!(texts(&settings.axes[0], 2), ["numerics.eta=1.6"]);
        assert_eq!(settings.axes[1].name, "viscosity");
        assert_eq!(texts(&settings.axes[1], 1), ["material.gas.viscosity.alpha=2", "material.gas.viscosity.beta=4"]);
        assert_eq!((settings.targets, settings.combine), (vec![0.05, 0.01], Combine::Grid));
        assert_eq!(settings.measure, Measure { figure: "errors.density_l1".into(), against: Against::Exact });
    }

    #[test]
    fn accuracies() {
        assert_eq!(["1%", "0.5 %", "0.02"].map(|text| accuracy(text).unwrap()), [0.01, 0.005, 0.02]);
        assert!(["", "%", "-1 %", "0", "much", "nan"].iter().all(|text| accuracy(text).is_err()));
    }

    #[test]
    fn what_makes_no_study() {
        let vary = "[study.vary]\nnumerics.eta = [1.2]\n";
        for (text, place, says) in [
            (format!("{HEAD}combin = 1\n{vary}"), "s.toml:4: study.combin", "did you mean `combine`?"),
            (HEAD.to_string(), "s.toml:1: study", "nothing is varied"),
            (format!("{HEAD}[study.vary]\nnumerics.eta = 1.2\n"), "s.toml:5", "no list"),
            (format!("{HEAD}[study.resolution]\na.spacing = [1, 2]\nb.spacing = [1]\n"), "s.toml:6", "has 2"),
            (format!("{HEAD}value = 0\n{vary}"), "s.toml:4", "relative"),
            (format!("{HEAD}value = 1\nagainst = \"finest\"\n{vary}"), "s.toml:5", "both"),
            (format!("{HEAD}uncertainty = 1\n{vary}"), "s.toml:4", "no value"),
            (format!("{HEAD}target = \"good\"\n{vary}"), "s.toml:4", "no relative error"),
            (HEAD.replace("density_l1", "outcome.time") + vary, "s.toml:3", "nothing to be compared with"),
        ] {
            let error = read(&text).err().unwrap_or_else(|| panic!("{text}"));
            assert!(error.place.starts_with(place) && error.what.contains(says), "{error}\n{text}");
        }
    }
}
