//! Scenes as nobody would write them: whatever is done to the scenes of `inputs/`, reading them ends in a scene or in an error
//! that says where it is, and never in a panic.

use std::path::Path;

use proptest::prelude::*;
use proptest::sample::Index;
use proptest::test_runner::{Config, RngSeed, TestRunner};
use sph_mpi::error::Error;
use sph_mpi::scene::{self, Scene};
use toml::{Table, Value};

/// What one thing is replaced by: numbers at the ends of their ranges, other units, other types.
const STRANGE: [&str; 40] = [
    "0",
    "-1",
    "1",
    "2",
    "65536",
    "1e9",
    "9223372036854775807",
    "-9223372036854775808",
    "1e308",
    "-1e308",
    "1e-320",
    "nan",
    "-inf",
    "inf",
    "true",
    "false",
    "[]",
    "[1]",
    "[1, 2, 3]",
    "[[1], [2]]",
    "{}",
    "{ seed = 1 }",
    "{ sphere = { radius = 1 } }",
    "{ a = { b = [1] } }",
    "\"\"",
    "\"target\"",
    "\"projectile\"",
    "\"basalt\"",
    "\"ideal_gas\"",
    "\"5 km\"",
    "\"-3 kg\"",
    "\"1e999 s\"",
    "\"1e-400 m\"",
    "\"7 km/s\"",
    "\"9e307 km\"",
    "\"4 deg\"",
    "\"2 m^127\"",
    "\"3 µm\"",
    "\"settled\"",
    "1979-05-27T07:32:00Z",
];

/// Something done to a scene's text or to its tree.
#[derive(Debug, Clone)]
enum Edit {
    DeleteLine(Index),
    RepeatLine(Index, Index),
    Truncate(Index),
    Insert(Index, String),
    Cut(Index, u8),
    /// A value somewhere in the tree is replaced.
    Replace(Index, Index),
    /// A key somewhere in the tree goes, or gets another name.
    Delete(Index),
    Rename(Index, String),
    /// A value goes to where another one stood.
    Copy(Index, Index),
}

fn edit() -> impl Strategy<Value = Edit> {
    let index = any::<Index>;
    prop_oneof![
        1 => index().prop_map(Edit::DeleteLine),
        1 => (index(), index()).prop_map(|(from, to)| Edit::RepeatLine(from, to)),
        1 => index().prop_map(Edit::Truncate),
        1 => (index(), ".{1,8}").prop_map(|(at, text)| Edit::Insert(at, text)),
        1 => (index(), any::<u8>()).prop_map(|(at, length)| Edit::Cut(at, length)),
        8 => (index(), index()).prop_map(|(at, by)| Edit::Replace(at, by)),
        2 => index().prop_map(Edit::Delete),
        1 => (index(), "[a-z_]{0,6}|.{1,4}").prop_map(|(at, name)| Edit::Rename(at, name)),
        2 => (index(), index()).prop_map(|(from, to)| Edit::Copy(from, to)),
    ]
}

impl Edit {
    fn apply(&self, text: &str) -> String {
        let lines: Vec<&str> = text.lines().collect();
        // The nearest place from there on at which a character begins.
        let place = |at: usize| (at..=text.len()).find(|&at| text.is_char_boundary(at)).unwrap_or(text.len());
        match self {
            _ if text.is_empty() => "x".into(),
            Edit::DeleteLine(at) => {
                let at = at.index(lines.len());
                [&lines[..at], &lines[at + 1..]].concat().join("\n")
            }
            Edit::RepeatLine(from, to) => {
                let mut lines = lines;
                let line = lines[from.index(lines.len())];
                lines.insert(to.index(lines.len()), line);
                lines.join("\n")
            }
            Edit::Truncate(at) => text[..place(at.index(text.len()))].into(),
            Edit::Insert(at, what) => {
                let at = place(at.index(text.len()));
                [&text[..at], what, &text[at..]].concat()
            }
            Edit::Cut(at, length) => {
                let at = place(at.index(text.len()));
                [&text[..at], &text[place((at + *length as usize).min(text.len()))..]].concat()
            }
            in_tree => match text.parse::<Table>() {
                Ok(mut tree) => {
                    in_tree.apply_to(&mut tree);
                    toml::to_string(&tree).unwrap_or_default()
                }
                Err(_) => text.into(),
            },
        }
    }

    fn apply_to(&self, tree: &mut Table) {
        let mut paths = Vec::new();
        paths_of(&Value::Table(tree.clone()), &mut Vec::new(), &mut paths);
        if paths.is_empty() {
            return;
        }
        let path = |index: &Index| paths[index.index(paths.len())].clone();
        match self {
            Edit::Replace(at, by) => {
                let text = STRANGE[by.index(STRANGE.len())];
                let value = format!("x = {text}").parse::<Table>().expect("a value")["x"].clone();
                put(tree, &path(at), Some(value));
            }
            Edit::Delete(at) => put(tree, &path(at), None),
            Edit::Rename(at, name) => {
                let mut path = path(at);
                let value = get(tree, &path);
                put(tree, &path, None);
                *path.last_mut().expect("a path has a key") = name.clone();
                put(tree, &path, value);
            }
            Edit::Copy(from, to) => {
                let value = get(tree, &path(from));
                put(tree, &path(to), value);
            }
            _ => {}
        }
    }
}

/// Paths of everything in a tree; items of lists by their number.
fn paths_of(value: &Value, here: &mut Vec<String>, found: &mut Vec<Vec<String>>) {
    let children: Vec<(String, &Value)> = match value {
        Value::Table(table) => table.iter().map(|(key, value)| (key.clone(), value)).collect(),
        Value::Array(items) => items.iter().enumerate().map(|(n, value)| (n.to_string(), value)).collect(),
        _ => Vec::new(),
    };
    for (key, child) in children {
        here.push(key);
        found.push(here.clone());
        paths_of(child, here, found);
        here.pop();
    }
}

fn get(tree: &Table, path: &[String]) -> Option<Value> {
    let mut here = Value::Table(tree.clone());
    for key in path {
        here = match here {
            Value::Table(mut table) => table.remove(key)?,
            Value::Array(items) => items.get(key.parse::<usize>().ok()?)?.clone(),
            _ => return None,
        };
    }
    Some(here)
}

/// Sets what stands at `path`, or removes it.
fn put(tree: &mut Table, path: &[String], value: Option<Value>) {
    fn within(here: &mut Value, path: &[String], value: Option<Value>) {
        let Some((key, rest)) = path.split_first() else { return };
        match here {
            Value::Table(table) if rest.is_empty() => {
                table.remove(key);
                table.extend(value.map(|value| (key.clone(), value)));
            }
            Value::Array(items) if rest.is_empty() => {
                let at = key.parse().unwrap_or(items.len()).min(items.len());
                if at < items.len() {
                    items.remove(at);
                }
                value.into_iter().for_each(|value| items.insert(at, value));
            }
            Value::Table(table) => table.get_mut(key).into_iter().for_each(|next| within(next, rest, value.clone())),
            Value::Array(items) => {
                let next = key.parse::<usize>().ok().and_then(|at| items.get_mut(at));
                next.into_iter().for_each(|next| within(next, rest, value.clone()));
            }
            _ => {}
        }
    }
    let mut root = Value::Table(std::mem::take(tree));
    within(&mut root, path, value);
    *tree = root.as_table().cloned().unwrap_or_default();
}

/// The scenes of `inputs/`, as they are written and as they are understood, with every key that there is for them.
fn inputs() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../inputs");
    let of = |folder: &Path| std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let files: Vec<_> = of(&folder).flat_map(|path| of(&path).chain([path]).collect::<Vec<_>>()).collect();
    let mut scenes: Vec<_> = files.into_iter().filter(|path| path.extension().is_some_and(|e| e == "toml")).collect();
    scenes.sort();
    assert!(scenes.iter().any(|path| path.ends_with("compaction_wave.toml")), "no scene with pores among {scenes:?}");
    let written = scenes.iter().map(|path| std::fs::read_to_string(path).expect("a readable scene"));
    let both = |text: String| {
        let understood = Scene::parse("scene.toml", &text, &[]).map(|scene| scene.to_toml());
        [Some(text), understood.ok()].into_iter().flatten()
    };
    written.flat_map(both).collect()
}

/// The same cases each time; nothing is written into the source tree.
fn check<S: Strategy>(cases: u32, strategy: S, test: impl Fn(S::Value) -> Result<(), TestCaseError>) {
    let config = Config { cases, failure_persistence: None, rng_seed: RngSeed::Fixed(7), ..Config::default() };
    TestRunner::new(config).run(&strategy, test).unwrap_or_else(|e| panic!("{e}"));
}

/// File and line, file and key, or the override.
fn names_a_place(error: &Error) -> bool {
    let after = error.place.strip_prefix("scene.toml:").map(str::trim_start);
    after.is_some_and(|rest| !rest.is_empty()) || error.place.starts_with("--set ")
}

fn assert_placed(read: Result<Scene, Error>) -> Result<(), TestCaseError> {
    match read {
        Ok(scene) => {
            // What is taken can be printed, and reads back to the same.
            let again = Scene::parse("scene.toml", &scene.to_toml(), &[]);
            prop_assert!(
                again.as_ref().is_ok_and(|s| s.to_toml() == scene.to_toml()),
                "{again:?}\n{}",
                scene.to_toml()
            );
        }
        Err(error) => prop_assert!(names_a_place(&error) && !error.what.is_empty(), "{error:?}"),
    }
    Ok(())
}

#[test]
fn edited_scenes_are_read_or_refused_with_a_place() {
    let inputs = inputs();
    let count = inputs.len();
    let edited = move |(which, edits): (usize, Vec<Edit>)| {
        edits.iter().fold(inputs[which].clone(), |text: String, edit| edit.apply(&text))
    };
    let texts = (0..count, proptest::collection::vec(edit(), 1..4)).prop_map(edited);
    check(3000, texts, |text| assert_placed(Scene::parse("scene.toml", &text, &[])));
}

#[test]
fn edited_settings_are_taken_or_refused_with_a_place() {
    let inputs = inputs();
    let key = "(target|projectile|body|run|numerics|material|output|impact|x)(\\.[a-z_0-9]{1,9}){0,3}|.{0,9}";
    let known = proptest::sample::select(vec![
        "target.particles",
        "target.radius",
        "target.shape",
        "run.until",
        "numerics",
        "material.basalt",
        "body",
        "body.0",
        "body.7.name",
        "target.material",
        "output.every",
        "impact.angle",
        "title",
        "dimension",
        "target",
    ]);
    let value = prop_oneof![proptest::sample::select(STRANGE.to_vec()).prop_map(String::from), ".{0,12}"];
    let strategy = (0..inputs.len(), prop_oneof![known.prop_map(String::from), key], value);
    check(1500, strategy, |(which, key, value)| {
        assert_placed(Scene::parse("scene.toml", &inputs[which], &[format!("{key}={value}")]))
    });
}

#[test]
fn bytes_that_are_no_text() {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let path = dir.path().join("scene.toml");
    check(300, proptest::collection::vec(any::<u8>(), 0..200), |bytes| {
        std::fs::write(&path, bytes).expect("a file");
        let error = scene::read(&path, &[]).expect_err("no scene");
        prop_assert!(error.place.contains("scene.toml"), "{error:?}");
        Ok(())
    });
}

/// A table of pores that makes no sense: the line it stands on, its key, and what is allowed instead.
#[test]
fn senseless_pores_are_refused_with_line_and_key() {
    // The fifth line is the wrong one.
    let scene = |wrong: &str, law: &str| {
        format!(
            "[[body]]\nname = \"rock\"\nshape = {{ sphere = {{ radius = 1 }} }}\nmaterial = \"basalt\"\n{wrong}\nparticles = 100\n\
             [run]\nuntil = 1\n{law}"
        )
    };
    let lines = |table: &str, wrong: &str, rest: &str| {
        let body =
            "[[body]]\nname = \"rock\"\nshape = { sphere = { radius = 1 } }\nmaterial = \"basalt\"\nparticles = 100\n";
        format!("{body}[run]\nuntil = 1\n[material.basalt.{table}]\n{wrong}\n{rest}")
    };
    let porosity = "[material.basalt.porosity]\np_alpha = { quadratic = true }\n";
    let place = "material.basalt.porosity";
    let pumice = "P_e = 1e6\nP_s = 2e8\nn_2 = 3\n";
    // Text, line, key, what the message says and what it allows.
    let cases: Vec<(String, usize, String, &str, &str)> = vec![
        (
            scene("distention = 0.9", porosity),
            5,
            "body rock, distention".into(),
            "distention is 0.9",
            "1 (no pores) and above",
        ),
        (scene("distention = nan", porosity), 5, "body rock, distention".into(), "NaN is not finite", ""),
        (scene("distention = 2", ""), 5, "body rock, distention".into(), "no porosity", "[material.basalt.porosity]"),
        (
            lines("porosity", "distention = 0.5", "p_alpha = { quadratic = true }"),
            9,
            format!("{place}.distention"),
            "distention is 0.5",
            "1 (no pores) and above",
        ),
        (lines("porosity", "", ""), 8, place.into(), "not one law of compaction", "p_alpha, rho_alpha, epsilon_alpha"),
        (
            lines("porosity", "p_alpha = { quadratic = true }", "rho_alpha = { quadratic = true }"),
            8,
            place.into(),
            "not one law",
            "p_alpha, rho_alpha, epsilon_alpha",
        ),
        (
            lines("porosity.p_alpha", "", ""),
            8,
            format!("{place}.p_alpha"),
            "not one crush curve",
            "quadratic, two_slope, measured",
        ),
        (
            lines("porosity.p_alpha.quadratic", "P_s = \"1 kPa\"", ""),
            9,
            format!("{place}.p_alpha.quadratic.P_s"),
            "not above P_e",
            "",
        ),
        (
            lines("porosity.p_alpha.quadratic", "P_e = \"-1 MPa\"", ""),
            9,
            format!("{place}.p_alpha.quadratic.P_e"),
            "P_e is -1e6",
            "above zero",
        ),
        (lines("porosity.p_alpha.quadratic", "P_e = \"1 km\"", ""), 9, "P_e".into(), "1 km", "Pa"),
        (lines("porosity.p_alpha.quadratic", "P_x = 3", ""), 9, "P_x".into(), "unknown", "P_e"),
        (
            lines("porosity.p_alpha.two_slope", "alpha_t = 7", &format!("{pumice}P_t = 7e7\nn_1 = 12\n")),
            9,
            format!("{place}.p_alpha.two_slope.alpha_t"),
            "alpha_t is 7",
            "1 to the distention, 3",
        ),
        (
            lines("porosity.p_alpha.two_slope", "n_1 = 1", &format!("{pumice}P_t = 7e7\nalpha_t = 1.9\n")),
            9,
            format!("{place}.p_alpha.two_slope.n_1"),
            "n_1 is 1",
            "above 1",
        ),
        (
            lines("porosity.p_alpha.two_slope", "P_t = 3e8", &format!("{pumice}n_1 = 12\nalpha_t = 1.9\n")),
            11,
            format!("{place}.p_alpha.two_slope.P_s"),
            "P_s is 2e8 Pa, not above P_t",
            "",
        ),
        (
            lines("porosity.p_alpha.measured", "pressure = [2e6, 1e6]", "distention = [3, 1]"),
            9,
            format!("{place}.p_alpha.measured.pressure"),
            "do not rise",
            "each above the one before",
        ),
        (
            lines("porosity.p_alpha.measured", "distention = [3, 1.1]", "pressure = [1e6, 2e6]"),
            9,
            format!("{place}.p_alpha.measured.distention"),
            "do not fall to 1",
            "the last one 1",
        ),
        (
            lines("porosity.p_alpha.measured", "distention = [3, 1]", "pressure = [1e6]"),
            8,
            format!("{place}.p_alpha.measured"),
            "1 pressures and 2 distentions",
            "as many",
        ),
        (
            lines("porosity.p_alpha", "elastic = { c_e = 4e3, c_0 = 3e3 }", "quadratic = true"),
            9,
            format!("{place}.p_alpha.elastic.c_e"),
            "c_e is 4e3",
            "0.05 and 1 times c_0",
        ),
        (
            lines("porosity.rho_alpha", "elastic = { c_e = 2e3, c_0 = 3e3 }", "quadratic = true"),
            9,
            format!("{place}.rho_alpha.elastic"),
            "follows pressure",
            "p_alpha",
        ),
        (
            lines("porosity.epsilon_alpha", "kappa = 1.5", "P_e = 1e6"),
            9,
            format!("{place}.epsilon_alpha.kappa"),
            "kappa is 1.5",
            "0 to 1",
        ),
        (
            lines("porosity.epsilon_alpha", "elastic_strain = 0.1", "P_e = 1e6"),
            8,
            format!("{place}.epsilon_alpha"),
            "where crushing begins",
            "P_e or elastic_strain",
        ),
        (
            lines("porosity.epsilon_alpha", "alpha_X = 3.5", ""),
            9,
            format!("{place}.epsilon_alpha.alpha_X"),
            "alpha_X is 3.5",
            "up to the distention, 3",
        ),
    ];
    let mut silent = Vec::new();
    for (text, line, key, says, allowed) in cases {
        let message = Scene::parse("scene.toml", &text, &[]).expect_err(&text).to_string();
        let parts = [&format!("scene.toml:{line}"), &key, says, allowed];
        let missing = parts.iter().filter(|part| !message.contains(**part));
        silent.extend(missing.map(|part| format!("`{message}` does not say `{part}`")));
    }
    assert!(silent.is_empty(), "{}", silent.join("\n"));
}
