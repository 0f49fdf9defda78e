//! report.html: there after a run, made again of what is there, whole, small, and right in a browser.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::common::{Launch, assert_known_files, summary};

const SCENE: &str = r#"
title = "A small impact, <to> be & looked at"

[[body]]
name = "target"
shape = { sphere = { radius = "1 km" } }
material = "basalt"
particles = 1200

[[body]]
name = "projectile"
shape = { sphere = { radius = "400 m" } }
material = "basalt"

[impact]
speed = "3 km/s"
angle = "30 deg"

[material.basalt.strength]
[material.basalt.fracture]

[run]
until = "0.8 s"

[output]
snapshots = 3
"#;

/// What a browser says of the report, where there is one.
fn look(report: &Path) {
    let browser = Path::new("/usr/bin/chromium").exists() && Path::new("/usr/bin/chromedriver").exists();
    let Some(python) = std::env::var_os("SPH_MPI_PYTHON").filter(|_| browser) else {
        println!("the report is not opened: there is no Chromium, or SPH_MPI_PYTHON names no Python with selenium");
        return;
    };
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("report.py");
    let picture = report.with_extension("png");
    let output = Command::new(python).arg(script).arg(report).arg(&picture).output().expect("Python starts");
    let (said, error) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{error}");
    println!("{}", said.trim());
    fs::remove_file(picture).expect("a picture");
}

#[test]
fn a_run_is_looked_at_in_a_browser() {
    let dir = tempfile::tempdir().expect("a directory");
    Launch::in_directory(2, dir.path(), SCENE, &[]).run().expect_code(0);
    let run = dir.path().join("run");
    assert_known_files(&run);
    let path = run.join("report.html");
    let report = fs::read_to_string(&path).expect("a report");
    assert!(report.len() < 2_000_000, "{} bytes", report.len());
    assert!(report.contains("<h1>A small impact, &lt;to&gt; be &amp; looked at</h1>"));
    for from_elsewhere in ["src=\"http", "href=\"http", "@import", "fetch(\"http"] {
        assert!(!report.contains(from_elsewhere), "{from_elsewhere}");
    }
    look(&path);

    // Of the same files the same report, by whomever it is made.
    fs::remove_file(&path).expect("a report");
    let made = Launch::alone(crate::common::program(), &["report", run.to_str().unwrap()]).run().expect_code(0);
    assert!(made.stdout.trim().ends_with("report.html"), "{}", made.stdout);
    assert!(fs::read_to_string(&path).expect("a report") == report);
    // Of a run that has not come to its end.
    fs::remove_file(run.join("summary.json")).expect("a summary");
    Launch::alone(crate::common::program(), &["report", run.to_str().unwrap()]).run().expect_code(0);
    assert!(fs::read_to_string(&path).expect("a report").contains("It has not come to its end."));
}

#[test]
fn where_no_run_is_there_is_no_report() {
    let dir = tempfile::tempdir().expect("a directory");
    let output = Launch::scene(2, &["report", dir.path().to_str().unwrap()]).run().expect_code(2);
    assert_eq!(output.stderr.matches("there is no run").count(), 1, "{}", output.stderr);
    assert!(!dir.path().join("report.html").exists());
    // Pictures that nobody asks for cost nothing, and so does the report.
    Launch::in_directory(1, dir.path(), SCENE, &["--set", "output.picture=false", "--set", "run.steps=2"]).run();
    assert!(!dir.path().join("run/report.html").exists());
}

/// What three ranks do when: spans of each, one after the other, that add up to about the time of the run.
#[test]
fn a_trace_has_the_phases_of_all_ranks() {
    let dir = tempfile::tempdir().expect("a directory");
    let more = ["--trace", "--set", "output.picture=false", "--set", "output.snapshots=0"];
    Launch::in_directory(3, dir.path(), SCENE, &more).run().expect_code(0);
    let run = dir.path().join("run");
    assert_known_files(&run);
    let text = fs::read_to_string(run.join("trace.json")).expect("a trace");
    let trace: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let wall = summary(&run)["wall_seconds"].as_f64().expect("a time");
    for rank in 0..3 {
        let of_rank = trace["traceEvents"].as_array().expect("events").iter().filter(|event| event["tid"] == rank);
        let spans: Vec<[f64; 2]> = of_rank
            .filter(|event| event["ph"] == "X")
            .map(|event| ["ts", "dur"].map(|key| event[key].as_f64().expect("a time")))
            .collect();
        let sum = 1e-6 * spans.iter().map(|[_, length]| length).sum::<f64>();
        assert!(spans.len() > 1000 && (0.5..=1.05).contains(&(sum / wall)), "{}: {sum} of {wall} s", spans.len());
    }
}
