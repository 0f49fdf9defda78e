//! What a run says about how far it can be trusted: in its log, in `warnings` of summary.json, in its last line; and which body an
//! outcome speaks of. Runs of a few steps.

use std::fs;
use std::path::Path;

use serde_json::Value;
use sph_mpi::math::Vec3;
use tempfile::TempDir;

use crate::common::{ByHand, IMPACT, Launch, SMALL_SEARCH, program, ranks, summary};

/// A moonlet is hit beside its larger primary.
const THREE: &str = r#"
[[body]]
name = "moonlet"
shape = { sphere = { radius = "80 m" } }
material = "basalt"
particles = 500

[[body]]
name = "dart"
shape = { sphere = { radius = "20 m" } }
material = "basalt"
particles = 30

[[body]]
name = "primary"
shape = { sphere = { radius = "200 m" } }
material = "basalt"
spacing = "50 m"
position = ["-800 m", "0 m", "0 m"]

[impact]
speed = "3 km/s"
target = "moonlet"
projectile = "dart"

[material.basalt.strength]
[material.basalt.fracture]

[numerics]
corrected_gradient = true

[run]
until = "60 ms"

[output]
picture = false
"#;

fn run(dir: &TempDir, scene: &str, more: &[&str]) -> (Value, String) {
    let output = Launch::in_directory(1, dir.path(), scene, more).run().expect_code(0);
    (summary(&dir.path().join("run")), output.stderr)
}

fn folder() -> TempDir {
    tempfile::tempdir().expect("a temporary directory")
}

fn kinds(summary: &Value) -> Vec<&str> {
    let warnings = summary["warnings"].as_array().expect("a list");
    warnings.iter().map(|warning| warning["kind"].as_str().expect("a word")).collect()
}

fn last_line(log: &str) -> &str {
    log.lines().last().expect("a last line")
}

/// The untouched primary, sixteen times the moonlet, is no remnant of it: all figures are those of the impact without it.
#[test]
fn a_bystander_is_no_remnant_of_the_target() {
    let (with, without) = (folder(), folder());
    let (three, _) = run(&with, THREE, &[]);
    let (begin, end) = (THREE.rfind("[[body]]").expect("bodies"), THREE.find("[impact]").expect("an impact"));
    let (two, _) = run(&without, &[&THREE[..begin], &THREE[end..]].concat(), &[]);
    let figure = |summary: &Value, name: &str| summary["outcome"][name].as_f64().unwrap_or_else(|| panic!("{name}"));
    let left = figure(&two, "largest_remnant_fraction");
    assert!(left > 0.0 && left < 1.1, "{left}");
    for name in [
        "largest_remnant_fraction",
        "largest_remnant_of_total",
        "largest_remnant_fraction_strict",
        "second_remnant_fraction",
        "largest_fragment_fraction",
        "unbound_mass",
        "total_mass",
    ] {
        let (a, b) = (figure(&three, name), figure(&two, name));
        assert!((a - b).abs() <= 1e-12 * b.abs(), "{name}: {a} {b}");
    }
    let share = |summary: &Value, body: &str, name: &str| summary["remnants"][body][name].as_f64().expect("a share");
    assert!((share(&three, "primary", "remnant_fraction") - 1.0).abs() < 1e-12);
    assert_eq!(share(&three, "primary", "in_largest_remnant_fraction"), 0.0);
    for summary in [&three, &two] {
        // Without the projectile's matter in it.
        assert!(share(summary, "moonlet", "remnant_fraction") <= left);
    }
    assert!(two["remnants"]["primary"].is_null());
}

/// 89 degrees: 13 km overlap by 2 m, at a spacing of 2.3 km.
#[test]
fn paths_that_hardly_overlap_are_warned_about() {
    let dir = folder();
    let grazing = IMPACT.replace("45 deg", "89 deg").replace("particles = 1400", "particles = 300");
    let (figures, log) = run(&dir, &grazing, &["--set", "run.steps=3"]);
    assert_eq!(kinds(&figures), ["overlap"]);
    assert!(
        log.matches("WARN overlap: the paths of `projectile` and `target` overlap by 0.213 m, 0.08 %").count() == 1,
        "{log}"
    );
    assert!(last_line(&log).ends_with("; 1 warning: overlap"), "{log}");
    let kept = fs::read_to_string(dir.path().join("run/log.txt")).expect("a log");
    assert!(kept.contains("WARN overlap:") && last_line(&kept).ends_with("; 1 warning: overlap"));
    let check = Launch::in_directory(2, dir.path(), &grazing, &["--check"]).run().expect_code(0).stdout;
    assert!(check.contains("\nwarnings\n  overlap: the paths"), "{check}");
    // What is well resolved says nothing.
    let dir = folder();
    let (figures, log) = run(&dir, IMPACT, &["--set", "run.steps=3"]);
    assert!(kinds(&figures).is_empty() && !log.contains("WARN") && last_line(&log).ends_with("run"), "{log}");
    let check = Launch::in_directory(1, dir.path(), IMPACT, &["--check"]).run().expect_code(0).stdout;
    assert!(!check.contains("\nwarnings\n"), "{check}");
}

/// A projectile smaller than a spacing of its target, in a study: each point says so, and so does the study.
#[test]
fn a_study_says_what_its_points_warn_of() {
    let dir = folder();
    fs::write(dir.path().join("scene.toml"), IMPACT).expect("a scene");
    let study = "[study]\nscene = \"scene.toml\"\nerror = \"outcome.largest_remnant_fraction\"\nvalue = 1\n[study.set]\nrun.steps = 2\nrun.until = \"settled\"\n\
                 [study.vary]\nprojectile.radius = [\"40 m\", \"400 m\", \"50 m\"]\n";
    fs::write(dir.path().join("study.toml"), study).expect("a study");
    let go = r#"cd "$HERE" && exec "$0" study.toml --out run "$@""#;
    let launch = |more: &[&str]| Launch::new(2, "sh", &[&["-c", go, program()], more].concat()).env("HERE", dir.path());
    let check = launch(&["--check"]).run().expect_code(0).stdout;
    let told = "projectile: 2 of 3 points, first point 1: `projectile` is 0.";
    assert!(check.contains(told), "{check}");
    let log = launch(&[]).run().expect_code(0).stderr;
    assert!(log.contains(&format!("WARN {told}")) && last_line(&log).contains(" warning"), "{log}");
    let page = fs::read_to_string(dir.path().join("run/study.md")).expect("a page");
    assert!(page.contains("Warning (projectile): 2 of 3 points"), "{page}");
    let table = fs::read_to_string(dir.path().join("run/study.csv")).expect("a table");
    assert_eq!(table.lines().filter(|line| line.ends_with("\"projectile\"")).count(), 2, "{table}");
}

/// Hot enough to be vapour from the start, a target is no intact fragment; just not hot enough, it is one.
#[test]
fn vapour_is_no_intact_fragment() {
    // E_iv of basalt is 4.72 MJ/kg, E_cv 18.2; heated, it expands.
    for (energy, fragments) in [("19 MJ/kg", 1.0), ("1 MJ/kg", 2.0)] {
        let dir = folder();
        let heat = format!("target.internal_energy={energy}");
        let (figures, _) = run(&dir, IMPACT, &["--set", "run.steps=1", "--set", &heat]);
        assert_eq!(figures["outcome"]["fragments"], fragments, "{energy}");
        let target = figures["remnants"]["target"]["fragment_fraction"].as_f64().expect("a share");
        assert!((target - (fragments - 1.0)).abs() < 1e-12, "{energy}: {target}");
    }
}

/// An impact of a search that warns of its energy widens the uncertainty, by the drift over the kinetic energy that is left.
#[test]
fn a_search_counts_the_drift_of_its_impacts() {
    let dir = folder();
    run(&dir, SMALL_SEARCH, &[]);
    // The same search, had its impacts drifted by nothing, and by a tenth of the energy that is left.
    let [good, drifting] = [0.0, 0.1].map(|drift: f64| {
        let path = dir.path().join("run/impacts.json");
        let mut impacts: Value = read(&path);
        for impact in impacts.as_array_mut().expect("impacts") {
            let warnings = [serde_json::json!({ "kind": "energy", "text": "it drifts" })];
            impact["price"]["energy_drift_over_left"] = drift.into();
            impact["warnings"] = Value::from(&warnings[..(drift > 0.0) as usize]);
        }
        fs::write(&path, impacts.to_string()).expect("impacts");
        fs::remove_file(dir.path().join("run/summary.json")).expect("it is made anew");
        run(&dir, SMALL_SEARCH, &["--resume"])
    });
    let threshold = |run: &(Value, String), name: &str| run.0["threshold"][name].as_f64().expect("a number");
    let part = |run: &(Value, String)| run.0["threshold"]["uncertainty_parts"]["drift"].as_f64().expect("a part");
    let q_star = threshold(&good, "q_star_d");
    assert_eq!(threshold(&drifting, "q_star_d"), q_star);
    assert_eq!(part(&good), 0.0);
    assert!((part(&drifting) / (0.1 * q_star) - 1.0).abs() < 1e-12);
    let expected = (threshold(&good, "uncertainty").powi(2) + (0.1 * q_star).powi(2)).sqrt();
    assert!((threshold(&drifting, "uncertainty") / expected - 1.0).abs() < 1e-12);
    assert!(kinds(&good.0).is_empty() && last_line(&good.1).ends_with("run"), "{}", good.1);
    assert_eq!(kinds(&drifting.0), ["energy"]);
    let log = &drifting.1;
    assert!(log.contains("J/kg for the drift of energy") && log.contains("WARN energy: "), "{log}");
    assert!(last_line(log).ends_with("; 1 warning: energy"), "{log}");
}

fn read(path: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(path).expect("a file")).expect("JSON")
}

/// A ball whose particles know their density, and one in which some think they are half or three times as dense.
#[test]
fn density_that_is_not_mass_over_volume_is_found() {
    let ball = "[[body]]\nname = \"ball\"\nshape = { sphere = { radius = \"1 m\" } }\nmaterial = \"basalt\"\nparticles = 1500\n\
                [run]\nuntil = \"1 s\"\n";
    ranks(1, "warnings::density_that_is_not_mass_over_volume_is_found", |comm| {
        let mut hand = ByHand::<3>::new(ball, comm, |_| {});
        hand.evaluate();
        let good = hand.stepper.check_density().bodies[0];
        assert!(good.inside > 500 && good.inside < 1300 && good.crowded + good.sparse == 0, "{good:?}");
        for (factor, crowds) in [(1.0 / 3.0, false), (3.0, true)] {
            // The density that all believe in, over the true one.
            let mut hand = ByHand::<3>::new(ball, comm, |_| {});
            for i in hand.particles() {
                let density: f64 = hand.get("density", i);
                hand.set("density", i, density / factor);
            }
            hand.evaluate();
            let found = hand.stepper.check_density().bodies[0];
            let (off, right) = if crowds { (found.crowded, found.sparse) } else { (found.sparse, found.crowded) };
            assert!(found.inside > 500 && off == found.inside && right == 0, "{factor}: {found:?}");
        }
        // Torn out of the ball, with three times its density.
        let outermost = |a: &usize, b: &usize| hand.position(*a).norm().total_cmp(&hand.position(*b).norm());
        let lone = hand.particles().max_by(outermost).expect("particles");
        hand.set("position", lone, Vec3::new(9.0, 0.0, 0.0));
        hand.set("density", lone, 8100.0);
        hand.evaluate();
        let found = hand.stepper.check_density().bodies[0];
        assert_eq!((found.alone, found.off()), (1, 1), "{found:?}");
        hand.stepper.release_buffers();
        assert_eq!(hand.stepper.check_density().bodies[0].judged(), 0);
        // What does not deform needs no density that is true.
        let block = "[[body]]\nname = \"block\"\nshape = { box = { size = [2, 2, 1] } }\nmaterial = \"basalt\"\n\
                     position = [0, 0, -1.6]\nspacing = 0.15\n";
        let rigid = ball.replace(
            "[run]",
            &format!("rigid = {{ sound_speed = 3000 }}\n{block}[numerics]\ncorrected_gradient = true\n[run]"),
        );
        let mut hand = ByHand::<3>::new(&rigid, comm, |_| {});
        for i in hand.particles().filter(|&i| hand.body(i) == 0).collect::<Vec<_>>() {
            let density: f64 = hand.get("density", i);
            hand.set("density", i, 3.0 * density);
        }
        hand.evaluate();
        let [ball, block] = hand.stepper.check_density().bodies[..] else { panic!("two bodies") };
        assert!(ball.judged() == 0 && block.inside > 100 && block.off() == 0, "{ball:?} {block:?}");
    });
}
