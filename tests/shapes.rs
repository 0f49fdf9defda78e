//! Bodies of any shape: runs of scenes with shape models and with shapes made up of several.

use std::path::{Path, PathBuf};

use crate::common::{Launch, summary};

fn lump() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../inputs/shapes/lump.obj")
}

/// A spinning lump beside two balls stuck together, a piece cut out of one of them, that drift into it.
fn scene() -> String {
    format!(
        r#"
[[body]]
name = "lump"
shape = {{ mesh = {{ file = "{}", size = "200 m" }} }}
material = "basalt"
spacing = "14 m"
spin = [0, 0, "2 1/s"]

[[body]]
name = "pair"
shape.all = [
    {{ shape = {{ sphere = {{ radius = "60 m" }} }}, position = ["-50 m", 0, 0] }},
    {{ shape = {{ ellipsoid = {{ semi_axes = ["60 m", "40 m", "50 m"] }} }}, position = ["50 m", 0, 0], orientation = {{ axis = [0, 0, 1], angle = "40 deg" }} }},
    {{ shape = {{ box = {{ size = ["40 m", "40 m", "40 m"] }} }}, position = ["-90 m", 0, 0], minus = true }},
]
material = "basalt"
spacing = "12 m"
position = ["215 m", "20 m", 0]
velocity = ["-900 m/s", 0, 0]

[material.basalt.strength]
[material.basalt.fracture]

[run]
until = "0.3 s"
"#,
        lump().display()
    )
}

#[test]
fn bodies_of_any_shape_are_the_same_on_any_ranks() {
    let (_, summary) = crate::sameness::compare_scene("shapes", scene().leak());
    // Mass, momentum and angular momentum are counted as for other bodies.
    let drift = |name: &str| summary[name].as_f64().unwrap_or_else(|| panic!("no {name}"));
    assert!(drift("momentum_drift") < 1e-12 && drift("energy_drift").abs() < 0.02, "{summary}");
}

/// Where a shape model is missing, or open, a run ends before it begins, on every rank alike.
#[test]
fn a_missing_shape_model_is_one_clear_error() {
    let dir = tempfile::tempdir().expect("a directory");
    let scene = scene().replace("lump.obj", "none.obj");
    let output = Launch::in_directory(2, dir.path(), &scene, &[]).run().expect_code(2);
    assert!(output.stderr.contains("body lump, shape.mesh.file: cannot read"), "{}", output.stderr);
    assert_eq!(output.stderr.matches("cannot read").count(), 1, "{}", output.stderr);
}

/// The small version of `inputs/shape_model.toml`: it is hit, and what it was made of is still there.
#[test]
fn the_shape_model_of_the_inputs_is_hit() {
    let dir = tempfile::tempdir().expect("a directory");
    let scene = include_str!("../inputs/shape_model.toml").replace("shapes/lump.obj", &lump().display().to_string());
    let changes = ["--set", "target.particles=2000", "--set", "run.until=0.02 s", "--set", "output=false"];
    Launch::in_directory(1, dir.path(), &scene, &changes).run().expect_code(0);
    let summary = summary(&dir.path().join("run"));
    assert!(summary["outcome"]["damaged_fraction"].as_f64().is_some_and(|damaged| damaged > 0.05), "{summary}");
}
