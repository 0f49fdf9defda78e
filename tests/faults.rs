//! What a run survives: a full disk, damaged checkpoints, ranks that are killed, a non-finite number. Each time there is one
//! message and one exit code, and the run that goes on ends with the bits of one that nothing happened to.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use tempfile::TempDir;

use crate::common::{IMPACT, Launch, Output, program, summary, write_scene};

/// Exit codes: failed on its way, bad input, stopped on request.
const FAILED: i32 = 1;
const BAD_INPUT: i32 = 2;
const STOPPED: i32 = 75;

/// Long enough for bodies to meet and particles to change ranks.
const LENGTH: &str = "run.steps=100";

/// Runs that go on from each other in one directory.
struct Legs {
    dir: TempDir,
    /// After `--set`.
    settings: Vec<&'static str>,
}

impl Legs {
    fn new() -> Self {
        Self { dir: tempfile::tempdir().expect("a temporary directory"), settings: vec![LENGTH] }
    }

    fn run(&self) -> PathBuf {
        self.dir.path().join("run")
    }

    fn file(&self, name: &str) -> PathBuf {
        self.run().join(name)
    }

    /// One leg on `ranks` ranks with a fault, or none ("").
    #[track_caller]
    fn leg(&self, ranks: usize, fault: &str, code: i32) -> Output {
        let mut args: Vec<&str> = self.settings.iter().flat_map(|setting| ["--set", setting]).collect();
        let resumes = self.run().exists();
        args.extend(resumes.then_some("--resume"));
        self.launch(ranks, &args, fault).expect_code(code)
    }

    fn launch(&self, ranks: usize, args: &[&str], fault: &str) -> Output {
        Launch::in_directory(ranks, self.dir.path(), IMPACT, args).env("SPH_MPI_FAULT", fault).limit(60).run()
    }

    /// Goes on to the end, which must be that of an undisturbed run.
    #[track_caller]
    fn finish(&self) {
        self.finish_as(undisturbed());
    }

    #[track_caller]
    fn finish_as(&self, hash: &serde_json::Value) {
        self.leg(2, "", 0);
        assert_eq!(summary(&self.run())["state_hash"], *hash);
        assert!(self.temporary_files().is_empty(), "{:?}", self.temporary_files());
    }

    fn temporary_files(&self) -> Vec<String> {
        files(&self.run()).into_keys().filter(|name| name.ends_with(".tmp")).collect()
    }
}

/// Files of a folder and what they hold.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder).expect("the run's directory").flatten();
    let read = |path: PathBuf| fs::read(path).expect("a readable file");
    entries.map(|entry| (entry.file_name().to_string_lossy().into_owned(), read(entry.path()))).collect()
}

/// All files but the log.
fn results(legs: &Legs) -> BTreeMap<String, Vec<u8>> {
    files(&legs.run()).into_iter().filter(|(name, _)| name != "log.txt").collect()
}

/// The state hash at the end of a run that nothing happens to.
fn undisturbed() -> &'static serde_json::Value {
    static HASH: OnceLock<serde_json::Value> = OnceLock::new();
    HASH.get_or_init(|| {
        let legs = Legs::new();
        legs.leg(1, "", 0);
        summary(&legs.run())["state_hash"].clone()
    })
}

/// The one line in which the program says what went wrong, with all of `says` in it.
#[track_caller]
fn assert_one_error(output: &Output, says: &[&str]) {
    let errors: Vec<&str> = output.stderr.lines().filter(|line| line.starts_with("error: ")).collect();
    assert_eq!(errors.len(), 1, "one line, from one rank\n{}", output.stderr);
    for part in says {
        assert!(errors[0].contains(part), "{:?} does not say {part:?}", errors[0]);
    }
    assert!(!output.stderr.contains("panicked"), "{}", output.stderr);
}

/// Where the disk is full for one rank only, all of them end; the checkpoint that stood there stands, and goes on.
#[test]
fn full_disk_during_a_checkpoint() {
    for rank in 0..2 {
        let legs = Legs::new();
        legs.leg(2, "stop:0:20", STOPPED);
        let before = fs::read(legs.file("checkpoint.h5")).expect("a checkpoint");
        let output = legs.leg(2, &format!("full_in_checkpoint:{rank}:40"), FAILED);
        assert_one_error(&output, &["checkpoint.h5.tmp", "cannot write", "allowed: room on the disk"]);
        assert_eq!(legs.temporary_files(), [""; 0], "the room is given back");
        assert!(fs::read(legs.file("checkpoint.h5")).is_ok_and(|now| now == before), "the checkpoint was touched");
        legs.finish();
    }
}

/// The same for a snapshot on the way.
#[test]
fn full_disk_during_a_snapshot() {
    // Steps end where snapshots are due.
    let with_snapshots = || {
        let mut legs = Legs::new();
        legs.settings.push("output.every=0.03 s");
        legs
    };
    let whole = with_snapshots();
    whole.leg(1, "", 0);
    for rank in 0..2 {
        let legs = with_snapshots();
        legs.leg(2, "stop:0:20", STOPPED);
        let output = legs.leg(2, &format!("full:{rank}:22"), FAILED);
        assert_one_error(&output, &["/snapshot_00", ".vtkhdf.tmp: cannot ", "allowed: room on the disk"]);
        let snapshots = || {
            let names = files(&legs.run()).into_keys().filter(|name| name.ends_with(".vtkhdf"));
            names.collect::<Vec<_>>()
        };
        let (before, next) = (snapshots(), format!("snapshot_{:04}.vtkhdf", snapshots().len() + 1));
        assert!(output.stderr.contains(&next) && before.len() >= 2, "{before:?}\n{}", output.stderr);
        assert_eq!(legs.temporary_files(), [""; 0], "the room is given back");
        let series = fs::read_to_string(legs.file("snapshots.vtkhdf.series")).expect("a list of snapshots");
        assert!(before.iter().all(|name| series.contains(name.as_str())) && !series.contains(&next), "{series}");
        legs.finish_as(&summary(&whole.run())["state_hash"]);
        assert!(snapshots().contains(&next));
    }
}

/// A directory with two generations, of steps 20 and 40, and what `damage` makes of them.
fn damaged(damage: impl FnOnce(&Path, &Path)) -> Legs {
    let legs = Legs::new();
    legs.leg(2, "stop:0:20", STOPPED);
    legs.leg(2, "stop:0:40", STOPPED);
    damage(&legs.file("checkpoint.h5"), &legs.file("checkpoint_previous.h5"));
    legs
}

fn truncate(path: &Path) {
    let bytes = fs::read(path).expect("a checkpoint");
    fs::write(path, &bytes[..bytes.len() * 2 / 3]).expect("a writable checkpoint");
}

/// Amid the numbers of a column.
fn flip_a_bit(path: &Path) {
    let mut bytes = fs::read(path).expect("a checkpoint");
    let middle = bytes.len() / 2;
    bytes[middle] ^= 4;
    fs::write(path, bytes).expect("a writable checkpoint");
}

#[test]
fn damaged_newest_checkpoint_gives_way_to_the_previous_one() {
    let remove = |path: &Path| fs::remove_file(path).expect("a checkpoint");
    let says = ["the newest checkpoint was not taken", "does not match its checksum", ""];
    for (says, damage) in says.into_iter().zip([truncate, flip_a_bit, remove]) {
        let legs = damaged(|newest, _| damage(newest));
        legs.finish();
        let log = fs::read_to_string(legs.file("log.txt")).expect("a log");
        let last = log.lines().rfind(|line| line.contains("resuming from"));
        assert!(last.is_some_and(|line| line.ends_with("checkpoint_previous.h5")) && log.contains(says), "{log}");
    }
}

#[test]
fn damaged_checkpoints_without_a_whole_one() {
    let legs = damaged(|newest, previous| {
        flip_a_bit(newest);
        truncate(previous);
    });
    let before = results(&legs);
    let output = legs.leg(2, "", BAD_INPUT);
    assert_one_error(&output, &["no whole checkpoint is left", "checkpoint.h5", "checkpoint_previous.h5"]);
    assert!(results(&legs) == before, "nothing is written but the error");
    let log = fs::read_to_string(legs.file("log.txt")).expect("a log");
    assert!(log.contains("error: ") && log.contains("no whole checkpoint is left"), "{log}");
}

#[test]
fn checkpoint_of_another_scene() {
    let mut legs = damaged(|_, _| {});
    let before = results(&legs);
    legs.settings.push("impact.speed=4 km/s");
    let output = legs.leg(2, "", BAD_INPUT);
    assert_one_error(&output, &["checkpoint.h5", "belongs to another scene", "--out"]);
    assert!(results(&legs) == before, "nothing is written but the error");
    legs.settings.pop();
    legs.finish();
}

/// In a step, amid the data of a checkpoint, and when it is whole but has not got its name yet: the job ends at once.
#[test]
fn killed_ranks_leave_a_whole_checkpoint() {
    for fault in ["kill", "kill_in_write", "kill_before_rename"] {
        for rank in 0..2 {
            let legs = Legs::new();
            legs.leg(2, "stop:0:20", STOPPED);
            let output = legs.leg(2, &format!("{fault}:{rank}:40"), 128 + libc::SIGKILL);
            assert!(!legs.file("summary.json").exists(), "{fault} did not strike\n{}", output.stderr);
            legs.finish();
        }
    }
}

/// The write ends whole, and the step after it is the last.
#[test]
fn term_amid_a_write_stops_with_a_checkpoint() {
    for rank in 0..2 {
        let legs = Legs::new();
        legs.leg(2, &format!("term_in_write:{rank}:40"), STOPPED);
        let log = fs::read_to_string(legs.file("log.txt")).expect("a log");
        assert!(log.contains("stopped at step 41"), "{log}");
        assert!(legs.file("checkpoint_previous.h5").exists(), "the checkpoint in which the signal came");
        assert!(legs.temporary_files().is_empty());
        legs.finish();
    }
}

/// Checksums of a checkpoint's columns, which neither order nor ranks change.
fn checksums(path: &Path) -> BTreeMap<String, String> {
    let file = hdf5::File::open(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let columns = file.group("/columns").expect("columns");
    let sum = |name: &String| {
        let sum = columns.dataset(name).and_then(|column| column.attr("checksum")?.read_scalar());
        sum.map(|sum: hdf5::types::VarLenUnicode| sum.to_string()).expect("a checksum")
    };
    columns.member_names().expect("names").iter().map(|name| (name.clone(), sum(name))).collect()
}

/// A non-finite number is reported with step, particle, body, effect and quantity. The state from which the step started is
/// saved, to the bit, on any number of ranks, with a checkpoint to start from and without one.
#[test]
fn a_number_that_is_none_is_named_and_the_state_before_it_saved() {
    let expected = {
        let legs = Legs::new();
        legs.leg(1, "stop:0:59", STOPPED);
        checksums(&legs.file("checkpoint.h5"))
    };
    for (ranks, fault, saved_before) in [(2, "nan:0:60", true), (2, "nan:1:60", false), (1, "nan:0:60", false)] {
        let legs = Legs::new();
        if saved_before {
            legs.leg(2, "stop:0:20", STOPPED);
        }
        let says = ["step 60, particle ", "of body target", "effect `fault` makes a rate of density", "after step 59"];
        assert_one_error(&legs.leg(ranks, fault, FAILED), &says);
        assert_eq!(checksums(&legs.file("checkpoint.h5")), expected, "{ranks} ranks, {fault}");
        assert_eq!(legs.file("checkpoint_previous.h5").exists(), saved_before, "the one before stays");
        // The same failure at once: the state before it is saved already, and no older generation is lost.
        let generations = |legs: &Legs| files(&legs.run()).into_iter().filter(|(name, _)| name.ends_with(".h5"));
        let before: Vec<_> = generations(&legs).collect();
        assert_one_error(&legs.leg(ranks, fault, FAILED), &says);
        assert!(generations(&legs).eq(before), "a repeated failure leaves the checkpoints alone");
        legs.finish();
    }
}

/// Known before anything is made.
#[test]
fn too_little_memory() {
    let dir = tempfile::tempdir().expect("a temporary directory");
    // No particle takes less than 300 bytes.
    let particles = sph_mpi::process::resources::available_bytes() / 300.0;
    let setting = format!("target.particles={particles:.0}");
    let output = Launch::in_directory(2, dir.path(), IMPACT, &["--set", &setting]).limit(60).run();
    assert_one_error(&output.expect_code(BAD_INPUT), &["scene.toml", "GB of memory available", "fewer particles"]);
    assert!(!dir.path().join("run/summary.json").exists());
}

/// The others hear of it and do not wait for it.
#[test]
fn threads_that_one_rank_cannot_start() {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let scene = write_scene(dir.path(), IMPACT);
    let out = dir.path().join("run");
    // More stack for a thread than there are addresses.
    let no_stack = r#"[ "$OMPI_COMM_WORLD_RANK" = 1 ] && export RUST_MIN_STACK=140737488355328; exec "$0" "$@""#;
    let [scene, out] = [&scene, &out].map(|path| path.to_str().expect("a plain path"));
    let args = ["-c", no_stack, program(), scene, "--out", out, "--threads", "2"];
    let output = Launch::new(2, "sh", &args).limit(30).run().expect_code(BAD_INPUT);
    assert_one_error(&output, &["cannot start 2 threads"]);
}
