//! The tour of inputs/README.md, small: each of its scenes runs to its end and says what the tour promises. (The shape
//! model is in `shapes`, the two aggregates of dust in `dust_analysis`.)

use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::common::{Launch, summary};

/// Runs a scene of `inputs/` on two ranks with keys set, into `out`.
fn run(scene: &str, out: &Path, changes: &[&str]) -> Value {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../inputs").join(scene);
    let mut args: Vec<String> = [&path, Path::new("--out"), out].iter().map(|arg| arg.display().to_string()).collect();
    for change in changes {
        args.extend(["--set".to_string(), change.to_string()]);
    }
    Launch::scene(2, &args).run().expect_code(0);
    assert!(out.join("report.html").exists(), "{scene} has no report");
    summary(out)
}

fn number(summary: &Value, key: &str) -> f64 {
    summary["outcome"][key].as_f64().unwrap_or_else(|| panic!("no outcome.{key} in {summary}"))
}

/// The ground takes more than was brought, and less than anybody has measured.
#[test]
fn a_craft_pushes_the_ground() {
    let dir = tempfile::tempdir().expect("a directory");
    let coarse = ["impact.refine.spacing=80 cm", "ground.spacing=3.2 m", "run.until=10 ms", "output.snapshots=2"];
    let found = run("dart.toml", &dir.path().join("run"), &coarse);
    let beta = number(&found, "momentum_enhancement");
    println!("beta {beta:.3}");
    assert!((1.05..3.0).contains(&beta), "{beta}");
}

/// All that is left of the first target is the second one.
#[test]
fn what_an_impact_has_left_is_hit_again() {
    let dir = tempfile::tempdir().expect("a directory");
    let (first, second) = (dir.path().join("first"), dir.path().join("second"));
    let coarse = ["target.particles=1000", "run.until=10 s", "output.snapshots=2"];
    let before = run("impact.toml", &first, &coarse);
    let file = format!("target.from.file={}", first.join("snapshot_0002.vtkhdf").display());
    let after = run("tour/second_impact.toml", &second, &[&file, "run.until=2 s", "output.snapshots=1"]);
    let left = number(&before, "largest_remnant_fraction") * number(&before, "target_mass");
    assert!((number(&after, "target_mass") / left - 1.0).abs() < 1e-12, "{after}");
    assert!(number(&after, "largest_remnant_fraction") < 1.0);
}
