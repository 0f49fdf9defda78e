//! What may be written in scenes and studies, as the program tells it: pages and schemas follow from the types that parse the files,
//! those that are stored are as new as the code, and every file of `inputs/` names its schema.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;
use sph_mpi::scene::Scene;
use sph_mpi::study::keys;

use crate::common::{Launch, program};

/// Set, the stored files are written anew.
const WRITE: &str = "SPH_MPI_WRITE_KEYS";

fn inputs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../inputs")
}

/// Compares a stored file with what the code says, or writes it.
fn check(path: &Path, text: &str) {
    if std::env::var_os(WRITE).is_some() {
        fs::write(path, text).expect("a file that can be written");
    }
    let stored = fs::read_to_string(path).unwrap_or_default();
    let how = format!("{WRITE}=1 cargo test --release --locked keys");
    assert!(stored == text, "{} is older than the code, to write it anew: {how}", path.display());
}

#[test]
fn stored_schemas_are_as_new_as_the_code() {
    for of in ["scene", "study"] {
        check(&inputs().join(format!("{of}.schema.json")), &keys::schema_text(of).expect("a schema"));
    }
}

#[test]
fn the_page_of_keys_is_as_new_as_the_code() {
    let path = inputs().join("README.md");
    let page = fs::read_to_string(&path).expect("inputs/README.md");
    check(&path, &keys::with_tables(&page).expect("the two lines between which the keys stand"));
}

fn toml_files(dir: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(dir).expect("a readable folder").flatten() {
        match entry.path() {
            path if path.is_dir() => toml_files(&path, found),
            path if path.extension().is_some_and(|end| end == "toml") => found.push(path),
            _ => {}
        }
    }
}

/// Editors find the schema by the first line.
#[test]
fn every_input_names_its_schema() {
    let mut files = Vec::new();
    toml_files(&inputs(), &mut files);
    assert!(files.len() > 40);
    for path in files {
        let text = fs::read_to_string(&path).expect("a text");
        let of = if text.contains("\n[study") { "study" } else { "scene" };
        let depth = path.strip_prefix(inputs()).expect("below inputs").components().count() - 1;
        let up = if depth == 0 { "./".to_string() } else { "../".repeat(depth) };
        let expected = format!("#:schema {up}{of}.schema.json");
        assert_eq!(text.lines().next(), Some(&expected[..]), "{}", path.display());
    }
}

fn page(args: &[&str]) -> String {
    Launch::alone(program(), args).limit(60).run().expect_code(0).stdout
}

#[test]
fn pages_tell_type_unit_default_and_what_is_allowed() {
    let list = page(&["--keys"]);
    for table in ["[[body]]", "[numerics]", "[gravity.self]", "[material.NAME.porosity]", "[study]"] {
        assert!(list.contains(&format!("  {table} ")), "{table}\n{list}");
    }
    let run = page(&["--keys", "run"]);
    assert!(run.contains("checkpoint_every  time (s); more than 0; default: \"600 s\""), "{run}");
    let numerics = page(&["--keys", "numerics"]);
    assert!(numerics.contains("number; 0.001 to 2; default: 0.25"), "{numerics}");
    assert!(page(&["--keys", "material.basalt.porosity"]) == page(&["--keys", "material.porosity"]));
    for table in ["", "body", "body.shape", "impact.refine", "study", "material"] {
        let text = page(&["--keys", table]);
        let long = text.lines().find(|line| line.chars().count() > 100);
        assert!(long.is_none() && !text.is_empty(), "{table}: {long:?}");
    }
    let wrong = Launch::alone(program(), &["--keys", "bdy"]).limit(60).run().expect_code(2);
    assert!(wrong.stderr.contains("unknown table `bdy`, did you mean `body`?"), "{}", wrong.stderr);
}

/// The whole of every table, as the type has it: what is printed, and what a schema knows.
#[test]
fn the_schema_knows_every_key_of_a_printed_scene() {
    let schema = keys::schema("scene").expect("a schema");
    let keys =
        |value: &Value| value.as_object().map(|keys| keys.keys().cloned().collect::<Vec<_>>()).unwrap_or_default();
    let scene = Scene::parse("impact.toml", include_str!("../inputs/impact.toml"), &[]).expect("a scene").to_toml();
    let printed: toml::Table = scene.parse().expect("TOML");
    let known = keys(&schema["properties"]);
    assert!(printed.keys().all(|key| known.contains(key)), "{known:?}");
    let known = keys(&schema["properties"]["numerics"]["properties"]);
    let numerics = printed["numerics"].as_table().expect("a table");
    assert!(numerics.keys().all(|key| known.contains(key)), "{known:?}");
    // Nothing but what is known.
    for path in ["", "/properties/numerics", "/properties/body/items", "/properties/run"] {
        assert_eq!(schema.pointer(&format!("{path}/additionalProperties")), Some(&Value::Bool(false)), "{path}");
    }
    // Defaults are the code's.
    assert_eq!(schema.pointer("/properties/numerics/properties/cfl/default").and_then(Value::as_f64), Some(0.25));
    assert_eq!(numerics["cfl"].as_float(), Some(0.25));
}
