//! Campaigns: studies whose points are searches of Q*_D. Small balls without strength; seconds in all.

use std::fs;
use std::path::Path;

use serde_json::Value;
use tempfile::TempDir;

use crate::common::{Launch, SMALL_SEARCH, assert_as_measured, assert_known_files, program};

const CAMPAIGN: &str = r#"
title = "A small campaign"

[study]
scene = "target.toml"

[study.together.target]
labels = ["rock", "ice"]
material.rock.base = ["basalt", "ice"]
impact.speed = ["5 km/s", "3 km/s"]

[study.vary]
target.radius = ["10 km"]
"#;

fn folder(campaign: &str) -> TempDir {
    let dir = tempfile::tempdir().expect("a temporary directory");
    fs::write(dir.path().join("target.toml"), SMALL_SEARCH).expect("a scene");
    fs::write(dir.path().join("campaign.toml"), campaign).expect("a campaign");
    dir
}

fn launch(ranks: usize, dir: &Path, args: &[&str]) -> Launch {
    let go = r#"cd "$HERE" && exec "$0" campaign.toml --out run "$@""#;
    Launch::new(ranks, "sh", &[&["-c", go, program()], args].concat()).env("HERE", dir)
}

/// Rows of the thresholds without their costs.
fn thresholds(dir: &Path) -> Vec<Value> {
    let text = fs::read_to_string(dir.join("run/study.json")).expect("study.json");
    let study: Value = serde_json::from_str(&text).expect("JSON");
    let mut rows = study["thresholds"].as_array().expect("thresholds").clone();
    rows.iter_mut().for_each(|row| {
        row.as_object_mut().expect("a row").remove("core_seconds");
    });
    rows
}

#[test]
fn every_point_is_a_search_and_the_table_grows() {
    let dir = folder(CAMPAIGN);
    // Stopped in its second search: what it has is on paper by then.
    let points = launch(1, dir.path(), &["--points"]).run().expect_code(0);
    let names: Vec<&str> = points.stdout.lines().filter_map(|line| line.splitn(3, ' ').nth(2)).collect();
    assert_eq!(names, ["radius 10 km, rock", "radius 10 km, ice"]);
    launch(1, dir.path(), &[]).env("SPH_MPI_FAULT", "stop:0:250").run().expect_code(75);
    launch(2, dir.path(), &["--resume"]).run().expect_code(0);
    let rows = thresholds(dir.path());
    let families: Vec<&Value> = rows.iter().map(|row| &row["family"]).collect();
    assert_eq!(families, ["rock", "ice"]);
    let q_star: Vec<f64> = rows.iter().map(|row| row["q_star_d"].as_f64().expect("Q*_D")).collect();
    // Ice is bound by a ninth of the energy.
    assert!(q_star[1] < 0.5 * q_star[0], "{q_star:?}");
    assert_as_measured("Q*_D of rock, J/kg", q_star[0], 1.0556e4);
    assert_as_measured("Q*_D of ice, J/kg", q_star[1], 4.791e3);
    let page = fs::read_to_string(dir.path().join("run/study.md")).expect("a page");
    assert!(page.contains("| 1 | rock | 10000 | 5000 |") && !page.contains("Pareto: "), "{page}");
    for part in ["run", "run/point_001", "run/point_001/impact_01"] {
        assert_known_files(&dir.path().join(part));
    }
    assert!(dir.path().join("run/q_star.png").exists() && !dir.path().join("run/error_pairs.png").exists());

    // In tasks, on other ranks: the same.
    let tasks = folder(CAMPAIGN);
    for task in ["2", "1"] {
        launch(1, tasks.path(), &["--task", task]).run().expect_code(0);
    }
    launch(1, tasks.path(), &["--collect"]).run().expect_code(0);
    assert_eq!(thresholds(tasks.path()), rows);
}

#[test]
fn a_search_without_a_bracket_has_a_reason_and_the_campaign_goes_on() {
    let dir = folder(&(CAMPAIGN.to_string() + "[study.set]\nthreshold.max = \"2 km\"\nthreshold.min = \"1.9 km\"\n"));
    launch(2, dir.path(), &[]).run().expect_code(0);
    let page = fs::read_to_string(dir.path().join("run/study.md")).expect("a page");
    assert_eq!(page.matches("no threshold was found").count(), 2, "{page}");
    assert!(!dir.path().join("run/q_star.png").exists());
}

#[test]
fn what_makes_no_campaign() {
    for (campaign, says) in [
        (CAMPAIGN.replace("\"ice\"]\nmat", "\"ice\", \"dust\"]\nmat"), "labels do not name the values"),
        (
            CAMPAIGN.to_string() + "[study.set]\nthreshold = false\nrun.until = \"1 s\"\n",
            "the error of a run is not defined",
        ),
        (CAMPAIGN.replace("[study.tog", "target = \"1 %\"\n[study.tog"), "nothing says what the error is"),
    ] {
        let dir = folder(&campaign);
        let refused = launch(2, dir.path(), &[]).run().expect_code(2);
        assert!(refused.stderr.contains(says), "{}", refused.stderr);
    }
}
