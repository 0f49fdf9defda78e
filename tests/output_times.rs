//! Snapshots come at the times that were asked for, once each, and the list of them agrees with the files.

use std::fs;
use std::path::Path;

use crate::common::{GAS_BALLS, Launch, summary};

/// Exit code of a run that was stopped.
const STOPPED: i32 = 75;

/// Runs the balls into `dir/run` on `ranks` ranks; a fault, or none (""), may stop it.
#[track_caller]
fn run(dir: &Path, ranks: usize, settings: &[&str], fault: &str) {
    let mut args: Vec<&str> = settings.iter().flat_map(|setting| ["--set", setting]).collect();
    args.extend(dir.join("run").exists().then_some("--resume"));
    let code = if fault.is_empty() { 0 } else { STOPPED };
    Launch::in_directory(ranks, dir, GAS_BALLS, &args).env("SPH_MPI_FAULT", fault).limit(60).run().expect_code(code);
}

/// (time, file) of the list of snapshots, which must be the snapshots that lie there, each with the time of the list.
#[track_caller]
fn listed(dir: &Path) -> Vec<(f64, String)> {
    let run = dir.join("run");
    let text = fs::read_to_string(run.join("snapshots.vtkhdf.series")).expect("a list of snapshots");
    let series: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let entry = |f: &serde_json::Value| (f["time"].as_f64().unwrap(), f["name"].as_str().unwrap().to_string());
    let listed: Vec<(f64, String)> = series["files"].as_array().expect("files").iter().map(entry).collect();
    let names = fs::read_dir(&run).expect("a run").flatten().map(|e| e.file_name().into_string().unwrap());
    let mut files: Vec<String> = names.filter(|name| name.ends_with(".vtkhdf")).collect();
    files.sort();
    assert_eq!(listed.iter().map(|(_, name)| name.clone()).collect::<Vec<_>>(), files);
    for (time, name) in &listed {
        let file = hdf5::File::open(run.join(name)).expect("a snapshot");
        let inside: f64 = file.group("run").unwrap().attr("time").unwrap().read_scalar().unwrap();
        assert_eq!(inside, *time, "{name}");
    }
    listed
}

fn times(dir: &Path) -> Vec<f64> {
    listed(dir).into_iter().map(|(time, _)| time).collect()
}

/// The first steps of the balls at rest are three times as long as the time between snapshots, and later ones shorter. The same
/// on any ranks, and where the run is stopped on its way.
#[test]
fn snapshots_come_when_they_are_due() {
    let settings = ["output.every=10 ms", "run.until=0.2 s"];
    let [whole, ranks, stopped] = [(); 3].map(|()| tempfile::tempdir().expect("a temporary directory"));
    run(whole.path(), 1, &settings, "");
    run(ranks.path(), 2, &settings, "");
    for (ranks, stop) in [(1, "stop:0:3"), (2, "stop:0:6"), (1, "stop:0:17")] {
        run(stopped.path(), ranks, &settings, stop);
    }
    run(stopped.path(), 1, &settings, "");
    for dir in [&whole, &ranks, &stopped] {
        let expected: Vec<f64> = (0..=20).map(|k| k as f64 * 0.01).collect();
        assert_eq!(times(dir.path()), expected);
        assert_eq!(summary(&dir.path().join("run"))["state_hash"], summary(&whole.path().join("run"))["state_hash"]);
    }
}

/// An end that is no due time is shown too, and one that is shown once.
#[test]
fn the_end_is_shown_once() {
    let of = |settings: &[&str]| {
        let dir = tempfile::tempdir().expect("a temporary directory");
        run(dir.path(), 1, settings, "");
        (times(dir.path()), summary(&dir.path().join("run"))["state_hash"].to_string())
    };
    assert_eq!(of(&["output.every=0.15 s"]).0, [0.0, 0.15, 0.3, 3.0 * 0.15, 0.5]);
    assert_eq!(of(&["output.snapshots=6"]).0, [0.0, 0.1, 0.2, 3.0 * 0.1, 0.4, 0.5]);
    // Steps end where they like, but at the end.
    let (one, hash) = of(&["output.snapshots=1"]);
    assert_eq!(one, [0.5]);
    let dir = tempfile::tempdir().expect("a temporary directory");
    run(dir.path(), 1, &[], "");
    assert_eq!(
        summary(&dir.path().join("run"))["state_hash"].to_string(),
        hash,
        "snapshots that are not asked for cost"
    );
    let (two, _) = of(&["output.every=0.1 s", "run.steps=0"]);
    assert_eq!(two, [0.0], "the start is the end");
}
