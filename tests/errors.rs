//! What the person at the terminal gets: one clear line and one exit code for bad input, an end within seconds when a rank
//! fails, and a whole checkpoint when the run is asked to stop.

use std::fs;
use std::path::Path;

use crate::common::{IMPACT, Launch, program, summary, write_scene};

/// Exit code for bad input.
const BAD_INPUT: i32 = 2;
/// Exit code of a run that stopped on request and can go on (EX_TEMPFAIL of sysexits.h).
const STOPPED: i32 = 75;

/// Runs the scene with `args` on two ranks and checks that both end with the code for bad input and that there is one
/// error, with all of `says` in it.
#[track_caller]
pub fn assert_refused(scene: &Path, args: &[&str], says: &[&str]) {
    let dir = tempfile::tempdir().expect("a temporary directory");
    // Each rank leaves its own exit code: of a job, mpirun only reports the first.
    let keep_code = r#""$0" "$@"; echo $? > "$CODES/$OMPI_COMM_WORLD_RANK""#;
    let out = dir.path().join("out");
    let mut command = vec!["-c", keep_code, program(), scene.to_str().expect("a plain path")];
    if !args.contains(&"--out") {
        command.extend(["--out", out.to_str().expect("a plain path")]);
    }
    command.extend(args);
    let output = Launch::new(2, "sh", &command).env("CODES", dir.path()).limit(30).run().expect_code(0);
    for rank in 0..2 {
        let code = fs::read_to_string(dir.path().join(rank.to_string())).unwrap_or_default();
        assert_eq!(code.trim(), BAD_INPUT.to_string(), "exit code of rank {rank}\n{}", output.stderr);
    }
    let errors: Vec<&str> = output.stderr.lines().filter(|line| line.contains("error")).collect();
    assert_eq!(errors.len(), 1, "one line, from one rank\n{}", output.stderr);
    assert!(errors[0].starts_with("error: "), "{}", errors[0]);
    for part in says {
        assert!(errors[0].contains(part), "{:?} does not say {part:?}", errors[0]);
    }
    assert!(!output.stderr.contains("panicked") && !output.stdout.contains("panicked"), "{}", output.stderr);
    assert!(!out.join("summary.json").exists(), "refused input leaves no run");
}

/// The impact with `old` replaced by `new` is refused.
#[track_caller]
fn assert_edit_refused(old: &str, new: &str, says: &[&str]) {
    assert!(IMPACT.contains(old), "{old:?} is in the scene");
    assert_scene_refused(&IMPACT.replacen(old, new, 1), says);
}

#[track_caller]
pub fn assert_scene_refused(scene: &str, says: &[&str]) {
    let dir = tempfile::tempdir().expect("a temporary directory");
    assert_refused(&write_scene(dir.path(), scene), &[], says);
}

#[test]
fn unknown_key() {
    assert_edit_refused("particles = 1400", "partcles = 1400", &["scene.toml", "partcles", "particles"]);
}

#[test]
fn unknown_table_of_a_material() {
    assert_edit_refused("[material.basalt.fracture]", "[material.basalt.fractur]", &["fractur", "fracture"]);
}

#[test]
fn unknown_material() {
    assert_edit_refused("material = \"basalt\"", "material = \"basallt\"", &["basallt", "basalt"]);
}

#[test]
fn wrong_unit() {
    assert_edit_refused("radius = \"1 km\"", "radius = \"1 kg\"", &["radius", "1 kg", "allowed", "km"]);
}

#[test]
fn number_that_is_none() {
    assert_edit_refused("speed = \"5 km/s\"", "speed = \"fast\"", &["speed", "fast", "allowed"]);
}

#[test]
fn pores_that_make_no_sense() {
    let old = "[material.basalt.fracture]";
    let table =
        |distention: &str| format!("[material.basalt.porosity]\np_alpha = {{ quadratic = true }}\n{distention}\n{old}");
    let line = 2 + IMPACT.lines().position(|line| line == old).expect("fracture") + 1;
    let place = format!("scene.toml:{line}: material.basalt.porosity.distention");
    assert_edit_refused(
        old,
        &table("distention = 0.5"),
        &[&place, "distention is 0.5", "allowed: 1 (no pores) and above"],
    );
    assert_edit_refused(old, &table("distension = 2"), &["distension", "distention"]);
}

#[test]
fn broken_toml() {
    assert_scene_refused("title = \"ends in the middle\n", &["scene.toml", "1"]);
}

#[test]
fn negative_radius() {
    assert_edit_refused("radius = \"400 m\"", "radius = \"-400 m\"", &["radius", "-400 m"]);
}

#[test]
fn negative_mass() {
    assert_edit_refused("particles = 1400", "particles = 1400\ndensity = \"-2700 kg/m^3\"", &["density", "-2700"]);
}

#[test]
fn overlapping_bodies() {
    let ball = |name: &str, x: &str| {
        format!(
            "[[body]]\nname = \"{name}\"\nshape = {{ sphere = {{ radius = \"1 km\" }} }}\nmaterial = \"basalt\"\n\
             spacing = \"200 m\"\nposition = [\"{x}\", \"0 m\", \"0 m\"]\n"
        )
    };
    let scene = format!("{}{}[run]\nuntil = \"1 s\"\n", ball("first", "0 m"), ball("second", "1.5 km"));
    assert_scene_refused(&scene, &["first", "second", "overlap"]);
}

#[test]
fn scene_without_particles() {
    assert_scene_refused("title = \"nothing\"\n[run]\nuntil = \"1 s\"\n", &["body"]);
    assert_edit_refused("particles = 1400", "particles = 0", &["particles", "0"]);
}

#[test]
fn missing_file() {
    assert_refused(Path::new("no/such/scene.toml"), &[], &["no/such/scene.toml"]);
}

#[test]
fn unwritable_output() {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let scene = write_scene(dir.path(), IMPACT);
    // Below a file no directory can be made, not even by root.
    let out = scene.join("run");
    assert_refused(&scene, &["--out", out.to_str().expect("a plain path")], &["scene.toml/run"]);
}

#[test]
fn bad_setting() {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let scene = write_scene(dir.path(), IMPACT);
    assert_refused(&scene, &["--set", "projectile.radios=500 m"], &["radios", "radius"]);
}

#[test]
fn checkpoint_of_nothing() {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let scene = write_scene(dir.path(), IMPACT);
    assert_refused(&scene, &["--resume"], &["checkpoint"]);
}

/// A fault on one rank, without which the run would go on for minutes, ends the job within seconds.
#[track_caller]
fn assert_fault_ends_the_job(fault: &str, start: impl FnOnce(&[&str]) -> Launch) -> String {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let scene = write_scene(dir.path(), IMPACT);
    let out = dir.path().join("run");
    let [scene, out] = [&scene, &out].map(|path| path.to_str().expect("a plain path"));
    let args = [scene, "--out", out, "--set", "run.until=1000 s", "--threads", "2"];
    let output = start(&args).env("SPH_MPI_FAULT", fault).limit(20).run();
    assert!(output.code.is_some_and(|code| code != 0), "exit code {:?}\n{}", output.code, output.stderr);
    output.stderr
}

#[test]
fn panic_on_one_rank_ends_the_job() {
    for fault in ["panic:0:5", "panic:1:5", "pool:0:5", "pool:1:5"] {
        let stderr = assert_fault_ends_the_job(fault, |args| Launch::scene(2, args));
        assert!(stderr.contains("a panic was requested"), "{stderr}");
    }
}

#[test]
fn panic_without_mpirun_ends_the_program() {
    for fault in ["panic:0:5", "pool:0:5"] {
        let stderr = assert_fault_ends_the_job(fault, |args| Launch::alone(program(), args));
        assert!(stderr.contains("a panic was requested"), "{stderr}");
    }
}

#[test]
fn death_of_one_rank_ends_the_job() {
    assert_fault_ends_the_job("kill:1:5", |args| Launch::scene(2, args));
}

/// Stops the impact by `stop` once it is under way, checks the end, resumes it and compares it with a run left alone.
#[track_caller]
fn assert_stop_and_resume(stop: impl FnOnce(&crate::common::Job)) {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let scene = write_scene(dir.path(), IMPACT);
    let [whole, stopped] = ["whole", "stopped"].map(|name| dir.path().join(name));
    let start = |out: &Path, more: &[&str]| {
        let mut args = vec![scene.to_str().expect("a plain path"), "--out", out.to_str().expect("a plain path")];
        args.extend(["--set", "output.history_every=1"].iter().chain(more));
        Launch::scene(2, &args).start()
    };
    start(&whole, &[]).wait().expect_code(0);

    let mut job = start(&stopped, &[]);
    let history = stopped.join("history.csv");
    job.wait_until("step 5 is in its history", || {
        fs::read_to_string(&history).is_ok_and(|text| text.lines().count() > 6)
    });
    stop(&job);
    let output = job.wait().expect_code(STOPPED);
    assert!(!stopped.join("summary.json").exists(), "the run went to its end before it was stopped\n{}", output.stderr);
    assert!(stopped.join("checkpoint.h5").exists(), "{}", output.stderr);
    let left: Vec<_> = fs::read_dir(&stopped).expect("the run's directory").flatten().map(|e| e.file_name()).collect();
    assert!(!left.iter().any(|name| name.to_string_lossy().ends_with(".tmp")), "half a file is left: {left:?}");

    start(&stopped, &["--resume"]).wait().expect_code(0);
    assert_eq!(summary(&stopped)["state_hash"], summary(&whole)["state_hash"]);
    assert_eq!(summary(&stopped)["steps"], summary(&whole)["steps"]);
}

/// mpirun passes SIGUSR1 on to its ranks.
#[test]
fn usr1_to_mpirun_stops_with_a_checkpoint() {
    assert_stop_and_resume(|job| job.signal(libc::SIGUSR1));
}

/// As srun does, which starts the ranks itself.
#[test]
fn term_to_the_ranks_stops_with_a_checkpoint() {
    assert_stop_and_resume(|job| job.signal_ranks(libc::SIGTERM));
}

/// Ctrl-C of a terminal, and a terminal that is closed, as far as they reach a rank.
#[test]
fn interrupt_and_hangup_of_one_rank_stop_all_with_a_checkpoint() {
    assert_stop_and_resume(|job| job.signal_one(false, libc::SIGINT));
    assert_stop_and_resume(|job| job.signal_one(true, libc::SIGHUP));
}
