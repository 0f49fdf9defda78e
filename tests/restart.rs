//! One run, one directory; and what may change, and what may be lost, between a run and its restart.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

use crate::common::{IMPACT, Launch, Output, assert_known_files, program, summary, write_scene};

const BAD_INPUT: i32 = 2;

/// sph-mpi on one rank in the folder `here`, while another job may be at work: exit code and what it says.
fn meanwhile(here: &Path, args: &[&str]) -> (Option<i32>, String) {
    let mut command = Command::new(program());
    command.args(args).args(["--threads", "1"]).current_dir(here);
    command.env("OMPI_ALLOW_RUN_AS_ROOT", "1").env("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1");
    let output = command.output().expect("the program");
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

/// Fails unless it is refused in one line that says all of `says`.
#[track_caller]
fn assert_refused(here: &Path, args: &[&str], says: &[&str]) {
    let (code, stderr) = meanwhile(here, args);
    let errors: Vec<&str> = stderr.lines().filter(|line| line.starts_with("error: ")).collect();
    assert_eq!((code, errors.len()), (Some(BAD_INPUT), 1), "{args:?}\n{stderr}");
    for part in says {
        assert!(errors[0].contains(part), "{:?} does not say {part:?}", errors[0]);
    }
}

#[track_caller]
fn assert_ends(here: &Path, args: &[&str]) -> String {
    let (code, stderr) = meanwhile(here, args);
    assert_eq!(code, Some(0), "{args:?}\n{stderr}");
    stderr
}

/// Files of a folder, but for its log, and what they hold.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display())).flatten();
    let files = entries.filter(|entry| entry.path().is_file() && entry.file_name() != "log.txt");
    files.map(|entry| (entry.file_name().into_string().unwrap(), fs::read(entry.path()).unwrap())).collect()
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display())).flatten();
    let mut names: Vec<String> = entries.map(|entry| entry.file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// A run at work is neither renamed nor written into; where it was killed, the next one goes on.
#[test]
fn the_second_in_a_directory_is_told_who_is_at_work() {
    let dir = tempfile::tempdir().unwrap();
    let run = dir.path().join("run");
    let mut job = Launch::in_directory(2, dir.path(), IMPACT, &["--set", "run.until=1000 s"]).start();
    job.wait_until("its history grows", || {
        fs::read_to_string(run.join("history.csv")).is_ok_and(|t| t.lines().count() > 3)
    });
    let lock: Value = serde_json::from_slice(&fs::read(run.join("lock")).unwrap()).unwrap();
    let holder =
        format!("a run is at work here: process {} on {} since ", lock["process"], lock["host"].as_str().unwrap());
    // Too early for a checkpoint that could be resumed.
    fs::write(run.join("checkpoint_previous.h5"), "").unwrap();
    for more in [&[][..], &["--resume"], &["--set", "target.radius=900"]] {
        assert_refused(dir.path(), &[&["scene.toml", "--out", "run"], more].concat(), &["run: ", &holder, "--out"]);
    }
    assert_eq!(names(dir.path()), ["run", "scene.toml"]);
    fs::remove_file(run.join("checkpoint_previous.h5")).unwrap();
    job.signal_ranks(libc::SIGUSR1);
    job.wait().expect_code(75);
    assert!(!run.join("lock").exists());

    let mut job = Launch::in_directory(2, dir.path(), IMPACT, &["--resume", "--set", "run.until=1000 s"]).start();
    job.wait_until("it is at work again", || run.join("lock").exists());
    job.signal_ranks(libc::SIGKILL);
    job.wait();
    assert!(run.join("lock").exists(), "a killed run cannot take its lock away");
    let said = assert_ends(dir.path(), &["scene.toml", "--out", "run", "--resume", "--set", "run.steps=40"]);
    assert!(said.contains("lock: left behind by process "), "{said}");
    assert!(!run.join("lock").exists() && summary(&run)["steps"].as_u64() >= Some(1));
    // Of another host nothing is known here.
    let text = lock.to_string().replace("\"host\":\"", "\"host\":\"another_");
    fs::write(run.join("lock"), text).unwrap();
    assert_refused(dir.path(), &["scene.toml", "--out", "run"], &["another_", "run/lock removed"]);
}

const SEARCH: &str = r#"
[[body]]
name = "target"
shape = { sphere = { radius = "50 km" } }
material = "basalt"
particles = 300

[[body]]
name = "projectile"
shape = { sphere = { radius = "12 km" } }
material = "basalt"

[impact]
speed = "5 km/s"

[threshold]
vary = "projectile.radius"
tolerance = 0.5
repeats = 0

[output]
picture = false
"#;

/// Its impacts are as much its own as its directory.
#[test]
fn a_search_at_work_is_left_alone_and_goes_on_with_its_own_scene() {
    let dir = tempfile::tempdir().unwrap();
    let run = dir.path().join("run");
    let mut job = Launch::in_directory(1, dir.path(), SEARCH, &["--set", "run.until=100000 s"]).start();
    job.wait_until("its first impact is at work", || run.join("impact_01/history.csv").exists());
    let scene = ["scene.toml", "--set", "threshold=false", "--out"];
    for (args, says) in [
        (vec!["scene.toml", "--out", "run"], "run: a threshold search is at work here"),
        ([&scene[..], &["run/impact_01"]].concat(), "impact_01: a run is at work here"),
        ([&scene[..], &["run/impact_07"]].concat(), "run: a threshold search is at work here"),
    ] {
        assert_refused(dir.path(), &args, &[says]);
    }
    drop(job);
    let said = Launch::in_directory(1, dir.path(), SEARCH, &[]).run().expect_code(0).stderr;
    assert!(said.contains("lock: left behind by") && dir.path().join("run.1/impact_01").exists(), "{said}");

    let resume = ["scene.toml", "--out", "run", "--resume"];
    assert_refused(
        dir.path(),
        &[&resume[..], &["--set", "impact.speed=4 km/s"]].concat(),
        &["another scene: `impact.speed` was"],
    );
    // A record that is damaged is made anew from the impacts, none of which is run again.
    let found = summary_of(dir.path(), &resume);
    fs::write(run.join("impacts.json"), "[{").unwrap();
    let said = assert_ends(dir.path(), &resume);
    assert!(said.contains("impacts.json is damaged") && said.contains("has ended before"), "{said}");
    assert_eq!(summary(&run)["threshold"], found["threshold"]);
    assert_known_files(&run);
    assert_known_files(&run.join("impact_01"));
}

fn summary_of(here: &Path, args: &[&str]) -> Value {
    assert_ends(here, args);
    summary(&here.join("run"))
}

/// Two tasks are never at one point, and the whole study not at work beside a task.
#[test]
fn points_of_a_study_are_locked_one_by_one() {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("scene.toml"), IMPACT).unwrap();
    let study = "[study]\nscene = \"scene.toml\"\nerror = \"energy_drift\"\nagainst = \"finest\"\n[study.set]\n\
        run.until = \"1000 s\"\n[study.resolution]\ntarget.particles = [300, 1400]\n";
    fs::write(dir.path().join("study.toml"), study).unwrap();
    let start = r#"cd "$HERE" && exec "$0" study.toml --out run --task 2"#;
    let mut job = Launch::new(1, "sh", &["-c", start, program()]).env("HERE", dir.path()).start();
    job.wait_until("its point is at work", || dir.path().join("run/point_002/history.csv").exists());
    let args = |more: &[&'static str]| [&["study.toml", "--out", "run"], more].concat();
    assert_refused(dir.path(), &args(&["--task", "2"]), &["point_002: a run is at work here"]);
    assert_refused(dir.path(), &args(&[]), &["point_002: a run is at work here"]);
    assert_refused(dir.path(), &args(&["--collect"]), &["no point has a result here"]);
    assert_eq!(names(dir.path()), ["run", "scene.toml", "study.toml"]);
    let mut other = args(&["--task", "1"]);
    other.extend(["--set", "study.set.run.until=0.01 s"]);
    assert_ends(dir.path(), &other);
    assert!(dir.path().join("run/point_001/point.json").exists());
    drop(job);
}

/// A folder with the user's files is written into, or refused; never renamed.
#[test]
fn where_to_write() {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| dir.path().join(name);
    let short = ["--set", "run.steps=2"];
    let run = |here: &Path, args: &[&str]| assert_ends(here, &[args, &short].concat());
    let refused = |here: &Path, args: &[&str], says: &[&str]| assert_refused(here, &[args, &short].concat(), says);
    for folder in ["proj", "here", "scratch"] {
        fs::create_dir(at(folder)).unwrap();
    }
    for scene in ["proj/impact.toml", "here/impact.toml", "impact.toml"] {
        fs::write(at(scene), IMPACT).unwrap();
    }
    fs::write(at("proj/notes.txt"), "mine").unwrap();
    run(dir.path(), &["proj/impact.toml", "--out", "proj"]);
    assert_eq!(fs::read_to_string(at("proj/notes.txt")).unwrap(), "mine");
    let before = files(&at("proj"));
    refused(dir.path(), &["proj/impact.toml", "--out", "proj"], &["checkpoint.h5, ", "not renamed", "--resume"]);
    assert!(files(&at("proj")) == before && before.contains_key("summary.json"));

    run(&at("here"), &["impact.toml", "--out", "."]);
    assert!(at("here/summary.json").exists() && at("here/impact.toml").exists());
    // A scene of the name that a run gives to its own.
    fs::create_dir(at("mine")).unwrap();
    fs::write(at("mine/scene.toml"), IMPACT).unwrap();
    refused(&at("mine"), &["scene.toml", "--out", "."], &["scene.toml, which a run writes over"]);
    // An empty directory is sph-mpi's from then on, but one that somebody is in stays.
    fs::create_dir(at("empty")).unwrap();
    run(&at("empty"), &["../impact.toml", "--out", "."]);
    refused(&at("empty"), &["../impact.toml", "--out", "."], &["cannot be renamed"]);
    run(dir.path(), &["impact.toml", "--out", "empty"]);
    assert!(at("empty.1/summary.json").exists() && at("empty/summary.json").exists());

    std::os::unix::fs::symlink("scratch/run", at("link")).unwrap();
    for _ in 0..2 {
        run(dir.path(), &["impact.toml", "--out", "link"]);
    }
    assert!(
        at("link").is_symlink() && at("scratch/run.1/summary.json").exists() && at("scratch/run/summary.json").exists()
    );
    refused(dir.path(), &["impact.toml", "--out", "impact.toml"], &["a file of this name exists"]);
    assert_eq!(names(dir.path()), ["empty", "empty.1", "here", "impact.toml", "link", "mine", "proj", "scratch"]);
}

/// `more` arguments on the impact, which is resumed where it was begun.
fn leg(dir: &Path, ranks: usize, more: &[&str]) -> Output {
    let resume: &[&str] = if dir.join("run").exists() { &["--resume"] } else { &[] };
    Launch::in_directory(ranks, dir, IMPACT, &[resume, more].concat()).run()
}

/// End, output and title change at restarts; the bits are those of a run that asked for all of it from the start.
#[test]
fn a_run_goes_on_to_a_later_end() {
    let (dir, straight) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let run = dir.path().join("run");
    leg(straight.path(), 1, &["--set", "run.steps=60"]).expect_code(0);
    leg(dir.path(), 2, &["--set", "run.steps=20"]).expect_code(0);
    let first = summary(&run);
    let later =
        ["run.steps=60", "title=longer", "output.precision=f32", "output.history_every=5", "run.checkpoint_every=1 s"];
    let set: Vec<&str> = later.iter().flat_map(|key| ["--set", *key]).collect();
    let output = leg(dir.path(), 1, &set).expect_code(0);
    assert!(output.stderr.contains("goes on; what it found is now in summary_previous.json"), "{}", output.stderr);
    let (found, whole) = (summary(&run), summary(&straight.path().join("run")));
    for key in ["state_hash", "steps", "outcome"] {
        assert_eq!(found[key], whole[key], "{key}");
    }
    assert_eq!((found["title"].as_str(), found["outcome"]["time"].as_f64()), (Some("longer"), found["time"].as_f64()));
    let previous: Value = serde_json::from_slice(&fs::read(run.join("summary_previous.json")).unwrap()).unwrap();
    assert_eq!(previous, first);
    assert_known_files(&run);
    // By time, and until it is settled, too.
    let end = 1.5 * found["time"].as_f64().unwrap();
    leg(dir.path(), 1, &["--set", &format!("run.until={end} s")]).expect_code(0);
    let near = |value: &Value, time: f64| value.as_f64().is_some_and(|value| (value / time - 1.0).abs() < 1e-12);
    assert!(near(&summary(&run)["time"], end) && near(&summary(&run)["outcome"]["time"], end), "{}", summary(&run));
    let settled = ["--set", "run.until=settled", "--set", &format!("run.max_time={} s", 1.2 * end)];
    leg(dir.path(), 1, &settled).expect_code(0);
    assert!(near(&summary(&run)["time"], 1.2 * end), "{}", summary(&run));
    // What is another question is named.
    for (change, says) in [
        ("projectile.radius=300 m", "`projectile.radius` was "),
        ("impact.angle=30 deg", "`impact.angle` was "),
        ("numerics.eta=1.3", "`numerics.eta` was 1.2 and now is 1.3"),
    ] {
        assert_refused(
            dir.path(),
            &["scene.toml", "--out", "run", "--resume", "--set", change],
            &["another scene: ", says],
        );
    }
}

/// It says so; no snapshot, row or figure is added.
#[test]
fn a_finished_run_that_is_resumed_does_nothing() {
    for until in ["run.until=0.2 s", "run.steps=15"] {
        let dir = tempfile::tempdir().unwrap();
        let run = dir.path().join("run");
        let set = [
            "--set",
            until,
            "--set",
            "output.every=0.05 s",
            "--set",
            "output.picture=true",
            "--set",
            "nbody.smallest=1",
        ];
        leg(dir.path(), 1, &set).expect_code(0);
        let before = files(&run);
        let changed = files_changed_by(&run, || {
            let output = leg(dir.path(), 2, &set).expect_code(0);
            assert!(
                output.stderr.contains("has ended before") && output.stderr.contains("nothing is done"),
                "{}",
                output.stderr
            );
        });
        assert!(files(&run) == before && changed.is_empty(), "{changed:?}");
        assert_known_files(&run);
        // Lost after the last checkpoint, what it found is written again, and is the same.
        let found = summary(&run);
        for lost in ["outcome.png", "summary.json"] {
            fs::remove_file(run.join(lost)).unwrap();
            fs::remove_file(run.join("fragments.csv")).unwrap();
            leg(dir.path(), 1, &set).expect_code(0);
        }
        for key in ["state_hash", "steps", "outcome", "nbody", "energy_drift", "pair_interactions"] {
            assert_eq!(summary(&run)[key], found[key], "{key}");
        }
        assert!(found["outcome"].get("largest_remnant_fraction_later").is_none(), "{}", found["outcome"]);
        let now = files(&run);
        assert!(
            before
                .iter()
                .filter(|(name, _)| !["summary.json", "history.csv", "report.html"].contains(&name.as_str()))
                .all(|(name, text)| now[name] == *text)
        );
        assert_eq!(now["history.csv"], before["history.csv"]);
    }
}

/// Names of the files of a folder that `act` has written, with the same bytes or others.
fn files_changed_by(folder: &Path, act: impl FnOnce()) -> Vec<String> {
    let times = || -> BTreeMap<String, std::time::SystemTime> {
        let of = |name: &String| fs::metadata(folder.join(name)).unwrap().modified().unwrap();
        files(folder).into_keys().map(|name| (name.clone(), of(&name))).collect()
    };
    let before = times();
    act();
    let now = times();
    // The history is opened before it is known that nothing will be added.
    now.into_iter()
        .filter(|(name, time)| name != "history.csv" && before.get(name) != Some(time))
        .map(|(name, _)| name)
        .collect()
}

/// The checkpoint is what counts: nothing beside it can refuse it.
#[test]
fn damage_beside_a_whole_checkpoint_refuses_nothing() {
    type Damage = fn(&Path);
    let damages: [(&str, Damage); 5] = [
        ("history.csv", |path| fs::write(path, "").unwrap()),
        ("history.csv", |path| fs::write(path, b"tim\xff\xfe,3\n\0\0\0").unwrap()),
        ("log.txt", |path| fs::write(path, b"\0\xff\n").unwrap()),
        ("log.txt", |path| fs::remove_file(path).and_then(|()| fs::create_dir(path)).unwrap()),
        ("snapshots.vtkhdf.series", |path| fs::write(path, "{").unwrap()),
    ];
    let (dir, scene) = (tempfile::tempdir().unwrap(), |dir: &Path| write_scene(dir, IMPACT));
    scene(dir.path());
    let set = ["--set", "run.steps=30", "--set", "output.history_every=1", "--set", "output.every=0.05 s"];
    let mut hash = None;
    for (number, (name, damage)) in damages.into_iter().enumerate() {
        let out = format!("run_{number}");
        let args = [&["scene.toml", "--out", &out], &set[..]].concat();
        assert_ends(dir.path(), &[&args[..], &["--set", "run.steps=10"]].concat());
        damage(&dir.path().join(&out).join(name));
        let said = assert_ends(dir.path(), &[&args[..], &["--resume"]].concat());
        let found = summary(&dir.path().join(&out));
        assert_eq!(*hash.get_or_insert(found["state_hash"].clone()), found["state_hash"], "{name} {number}");
        if name == "history.csv" {
            assert!(said.contains("begins anew"), "{said}");
            let history = fs::read_to_string(dir.path().join(&out).join(name)).unwrap();
            assert_eq!(history.lines().count(), 21, "{history}");
        }
    }
}
