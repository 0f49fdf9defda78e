//! How runs end when something is in the way: nobody who reads what they print, no room for what comes last, signals, no memory.

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use crate::common::{GAS_BALLS, IMPACT, Launch, Output, program, summary, write_scene};
use crate::hard_viscosity::COARSE;

/// Exit codes: failed on its way, stopped on request.
const FAILED: i32 = 1;
const STOPPED: i32 = 75;

fn text(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// The one line that says what went wrong; it stands in the log of the run, too.
#[track_caller]
fn assert_told(output: &Output, log: &Path, says: &[&str]) {
    let errors: Vec<&str> = output.stderr.lines().filter(|line| line.starts_with("error: ")).collect();
    assert_eq!(errors.len(), 1, "one line\n{}", output.stderr);
    says.iter().for_each(|part| assert!(errors[0].contains(part), "{:?} does not say {part:?}", errors[0]));
    assert!(text(log).contains(errors[0]), "{} does not say {:?}", log.display(), errors[0]);
}

/// Runs a line of the shell in which `$RUN` is the program with the balls on its way into the directory.
fn shell(line: &str, ranks: usize, log: &str) -> (tempfile::TempDir, Output) {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let scene = write_scene(dir.path(), GAS_BALLS);
    let mpirun = if ranks > 1 { format!("mpirun -n {ranks} --bind-to none ") } else { String::new() };
    let run = format!("{mpirun}{} {}", program(), scene.display());
    let line = format!("cd {}; run() {{ {run} \"$@\"; echo $? > code; }}; {line}", dir.path().display());
    let output = Launch::alone("sh", &["-c", &line]).env("RUST_LOG", log).limit(60).run();
    (dir, output)
}

/// Whoever reads along leaves, or the disk that the lines go to is full: the run goes on to its end.
#[test]
fn nobody_needs_to_read_what_a_run_prints() {
    for (line, ranks) in [
        ("run --out run 2>&1 | head -1", 1),
        // mpirun ends a job whose lines nobody takes from it; it must not get any.
        ("run --out run 2>&1 | true", 2),
        ("run --out run > /dev/full 2>&1", 1),
        ("run --out run > /dev/full 2>&1", 2),
        ("run --out run >&- 2>&-", 1),
    ] {
        let (dir, output) = shell(line, ranks, "debug");
        // An mpirun whose lines nobody takes may crash by itself, and its shell with it: what it was to say is not told then.
        let crashes = ranks > 1 && line.contains('|');
        assert!(crashes || text(&dir.path().join("code")).trim() == "0", "{line}\n{}", output.stderr);
        let log = text(&dir.path().join("run/log.txt"));
        assert!(log.contains("written to") && dir.path().join("run/summary.json").exists(), "{line}\n{log}");
    }
}

/// An answer that cannot be given is an error, of one line, but where nobody wants it any more.
#[test]
fn answers_that_cannot_be_printed() {
    for (line, code, says) in [
        ("run --check > /dev/full", "1", "error: standard output: cannot write"),
        ("run --check | head -1", "0", ""),
        ("run --check --set run.untl=1 2> /dev/full", "2", ""),
    ] {
        let (dir, output) = shell(line, 1, "info");
        assert_eq!(text(&dir.path().join("code")).trim(), code, "{line}\n{}", output.stderr);
        let errors: Vec<&str> = output.stderr.lines().collect();
        assert!(errors.len() <= 1 && output.stderr.contains(says), "{line}\n{}", output.stderr);
    }
}

/// What comes last cannot be written: the checkpoint and the summary are there. A picture is worth a warning, others an error.
#[test]
fn what_fails_at_the_end_fails_alone() {
    let cases = [
        ("outcome.png", 0, "a picture is missing: "),
        ("velocities.csv", FAILED, "velocities.csv.tmp: cannot rename"),
        ("snapshot_0001.vtkhdf", FAILED, "cannot rename"),
    ];
    for (name, code, says) in cases {
        let dir = tempfile::tempdir().expect("a temporary directory");
        let run = dir.path().join("run");
        let settings = ["run.steps=30", "output.picture=true", "output.snapshots=1", "run.until=2 s"];
        let mut args: Vec<&str> = settings.iter().flat_map(|setting| ["--set", setting]).collect();
        let launch = |args: &[&str], fault| {
            Launch::in_directory(2, dir.path(), IMPACT, args).env("SPH_MPI_FAULT", fault).limit(60).run()
        };
        launch(&args, "stop:0:20").expect_code(STOPPED);
        // A folder that is not empty cannot be replaced.
        fs::create_dir_all(run.join(name).join("in_the_way")).expect("a folder");
        args.push("--resume");
        let output = launch(&args, "").expect_code(code);
        assert!(output.stderr.contains(says) && text(&run.join("log.txt")).contains(says), "{name}\n{}", output.stderr);
        assert_eq!(summary(&run)["steps"], 30, "{name}");
        let written = |name: &str| fs::metadata(run.join(name)).and_then(|file| file.modified()).expect(name);
        let rest = ["outcome.png", "velocities.csv", "snapshot_0001.vtkhdf", "sizes.csv", "fragments.csv"];
        assert!(rest.iter().all(|other| run.join(other).exists()), "{name} keeps others from being written");
        for other in rest.into_iter().filter(|other| *other != name) {
            assert!(written("checkpoint.h5") <= written("summary.json") && written("summary.json") <= written(other));
        }
        if code == FAILED {
            assert_told(&output, &run.join("log.txt"), &[says, "checkpoint and summary.json are written"]);
        }
        let names = fs::read_dir(&run).expect("a run").flatten().map(|e| e.file_name().into_string().unwrap());
        assert!(names.into_iter().all(|name| !name.contains(".tmp")), "half a file is left");
    }
}

/// Where the history cannot grow the run ends, but with a checkpoint of the moment.
#[test]
fn a_history_that_cannot_grow_leaves_a_checkpoint() {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let run = dir.path().join("run");
    let args = ["--set", "run.until=50 s", "--set", "run.steps=320"];
    let launch = |out: &str, fault, more: &[&str]| {
        let args: Vec<&str> = args.iter().chain(&["--out", out]).chain(more).copied().collect();
        let scene = write_scene(dir.path(), GAS_BALLS);
        let args = [&[scene.to_str().expect("a plain path")], &args[..]].concat();
        Launch::scene(2, &args).env("SPH_MPI_FAULT", fault).limit(60).run()
    };
    let (out, whole) = (run.to_str().expect("a plain path").to_string(), dir.path().join("whole"));
    let output = launch(&out, "full:0:5", &[]).expect_code(FAILED);
    assert_told(&output, &run.join("log.txt"), &["history.csv", "cannot write"]);
    assert!(run.join("checkpoint.h5").exists() && !run.join("summary.json").exists());
    launch(&out, "", &["--resume"]).expect_code(0);
    launch(whole.to_str().expect("a plain path"), "", &[]).expect_code(0);
    assert_eq!(summary(&run)["state_hash"], summary(&whole)["state_hash"]);
    // Rows of the step that found no room and of the one in which all ranks heard of it are gone.
    let (found, expected) = (text(&run.join("history.csv")), text(&whole.join("history.csv")));
    let rows: Vec<&str> = found.lines().collect();
    let missing = expected.lines().filter(|row| !rows.contains(row)).count();
    assert!(missing <= 2 && rows.len() + missing == expected.lines().count(), "{missing} rows are missing");
}

/// One line, from the rank that wants it, and no stack.
#[test]
fn memory_that_is_not_to_be_had() {
    for rank in 0..2 {
        let dir = tempfile::tempdir().expect("a temporary directory");
        let launch = Launch::in_directory(2, dir.path(), IMPACT, &[]).env("SPH_MPI_FAULT", format!("memory:{rank}:5"));
        let output = launch.limit(60).run().expect_code(FAILED);
        let errors: Vec<&str> = output.stderr.lines().filter(|line| line.starts_with("error: ")).collect();
        assert!(errors.len() == 1 && errors[0].contains(&format!("rank {rank}: no memory for")), "{}", output.stderr);
        assert!(!output.stderr.contains("Signal") && !output.stderr.contains("backtrace"), "{}", output.stderr);
        assert!(rank > 0 || text(&dir.path().join("run/log.txt")).contains(errors[0]));
    }
}

/// Whichever rank it is.
#[test]
fn a_panic_stands_in_the_log() {
    let dir = tempfile::tempdir().expect("a temporary directory");
    Launch::in_directory(2, dir.path(), IMPACT, &[]).env("SPH_MPI_FAULT", "panic:1:5").limit(60).run();
    let log = text(&dir.path().join("run/log.txt"));
    assert!(log.contains("error: rank 1 panicked") && log.contains("requested at step 5"), "{log}");
}

/// mpirun ends at a second Ctrl-C without its ranks, which then end by themselves.
#[test]
fn no_rank_outlives_its_launcher() {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let args = ["--set", "target.particles=20000", "--set", "output.history_every=1"];
    let mut job = Launch::in_directory(2, dir.path(), IMPACT, &args).limit(60).start();
    let history = dir.path().join("run/history.csv");
    job.wait_until("step 1 is in its history", || {
        fs::read_to_string(&history).is_ok_and(|text| text.lines().count() > 2)
    });
    let ranks = job.processes();
    assert!(ranks.len() >= 2);
    job.signal(libc::SIGINT);
    std::thread::sleep(Duration::from_millis(200));
    job.signal(libc::SIGINT);
    job.wait();
    let ended = Instant::now();
    let lives = |pid: &u32| fs::read_to_string(format!("/proc/{pid}/stat")).is_ok_and(|stat| !stat.contains(") Z "));
    while ranks.iter().any(lives) {
        assert!(ended.elapsed() < Duration::from_millis(700), "ranks outlive mpirun");
        std::thread::sleep(Duration::from_millis(10));
    }
}

/// Steps that are too long: energy comes from nowhere, and steps become ever shorter. Such a run would never end.
#[test]
fn a_run_that_blows_up_ends() {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let more: Vec<&str> = COARSE.iter().chain(&["numerics.cfl=1"]).flat_map(|set| ["--set", *set]).collect();
    let output = Launch::in_directory(2, dir.path(), include_str!("../inputs/exact/sod.toml"), &more).run();
    let output = output.expect_code(FAILED);
    let says = ["the time step has collapsed", "energy drift", "blown up (change: a smaller numerics.cfl"];
    assert_told(&output, &dir.path().join("run/log.txt"), &says);
}
