//! The folder of a run: one run, one folder, held by a lock while the run works. A folder that sph-mpi made for a run is renamed
//! when the next one begins, never overwritten. A folder that holds other files keeps its name: a run is written beside
//! them, or refused where it would write over one.

use std::path::{Path, PathBuf};

use super::lock::{self, LOCK, Lock, Work};
use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::output::checkpoint::{NEWEST, PREVIOUS};
use crate::output::publish::cannot;
use crate::output::{agree, on_root};

/// Marks a folder that sph-mpi made, or found empty, to distinguish it from one of the user's.
const MARK: &str = ".sph-mpi";
const MARK_SAYS: &str = "sph-mpi made this folder for a run, and renames it when the next run is written here.\n";

/// Searches and studies have folders within folders.
const LEVELS: usize = 2;

/// `runs/<name of the scene file>`.
pub fn default_directory(scene: &Path) -> PathBuf {
    Path::new("runs").join(scene.file_stem().unwrap_or_default())
}

/// Makes the directory and takes its lock, which the caller holds while it works (rank 0 has it); a run that is there is
/// renamed to `.1`, `.2`, ... unless it is resumed. Collective.
pub fn prepare(path: &Path, resume: bool, work: Work, comm: &Comm) -> Result<Option<Lock>> {
    agree(comm, if comm.is_root() { prepare_alone(path, resume, work).map(Some) } else { Ok(None) })
}

/// Makes the directory in which tasks work side by side, each in a folder of its own. Collective.
pub fn share(path: &Path, comm: &Comm) -> Result<()> {
    let make = || {
        let folder = make(path)?;
        if entries(&folder).is_empty() { mark(&folder) } else { Ok(()) }
    };
    on_root(comm, make)
}

/// Fails where there is no checkpoint, here or up to so many levels below: a search has one in a folder for
/// each impact, and a campaign in one of those of each search. Collective.
pub fn require_checkpoint(path: &Path, levels: usize, comm: &Comm) -> Result<()> {
    let look = || {
        if holds_checkpoint(path, levels) {
            return Ok(());
        }
        Err(Error::new("there is no checkpoint to resume from").at(path.display().to_string()))
    };
    on_root(comm, look)
}

/// Whether a checkpoint lies in the folder, or in one of those so many levels below.
fn holds_checkpoint(folder: &Path, levels: usize) -> bool {
    let entries = || std::fs::read_dir(folder).into_iter().flatten().flatten();
    [NEWEST, PREVIOUS].iter().any(|name| folder.join(name).exists())
        || levels > 0 && entries().any(|entry| entry.path().is_dir() && holds_checkpoint(&entry.path(), levels - 1))
}

fn prepare_alone(path: &Path, resume: bool, work: Work) -> Result<Lock> {
    let folder = make(path)?;
    let lock = Lock::take(&folder, work)?;
    require_no_work_around(&folder, work)?;
    let found = entries(&folder);
    if resume {
        return Ok(lock);
    }
    if found.is_empty() {
        mark(&folder)?;
    } else if folder.join(MARK).exists() && found.iter().any(|name| is_of_a_run(name)) {
        return make_room(&folder, lock, work);
    } else {
        refuse_to_overwrite(path, &found)?;
        tracing::info!("{}: other files are here, and the run is written beside them", path.display());
    }
    Ok(lock)
}

/// The folder to which a path leads, symbolic links followed, made where it is not there.
fn make(path: &Path) -> Result<PathBuf> {
    // Without a slash at the end, through which no link can be read.
    let mut real: PathBuf = path.components().collect();
    // As many as Linux follows.
    for _ in 0..40 {
        let Ok(leads_to) = std::fs::read_link(&real) else { break };
        real = real.parent().unwrap_or(Path::new("")).join(leads_to);
    }
    let make = std::fs::create_dir_all(&real).and_then(|()| real.canonicalize());
    make.map_err(|e| {
        let what = if real.is_file() { "a file of this name exists".into() } else { format!("cannot write here: {e}") };
        Error::new(what).at(path.display().to_string()).allowed("a directory").bad_input()
    })
}

/// Names of the entries of a folder, but for those that [`prepare`] makes.
fn entries(folder: &Path) -> Vec<String> {
    let names = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.file_name());
    let mut names: Vec<String> = names.map(|name| name.to_string_lossy().into_owned()).collect();
    names.retain(|name| name != LOCK && name != MARK);
    names.sort();
    names
}

/// Tasks may do so at the same time: only the existence of the mark counts.
fn mark(folder: &Path) -> Result<()> {
    let path = folder.join(MARK);
    std::fs::write(&path, MARK_SAYS).map_err(|e| cannot("write", &path, e))
}

/// No other process may be at work in a folder of a search or study, nor the search or study whose folder this is. Points of a
/// study run while its tables are made.
fn require_no_work_around(folder: &Path, work: Work) -> Result<()> {
    if work == Work::Tables {
        return Ok(());
    }
    lock::require_none_below(folder, LEVELS, &is_part)?;
    let mut here = folder;
    for _ in 0..LEVELS {
        let name = here.file_name().unwrap_or_default().to_string_lossy();
        let Some(above) = here.parent().filter(|_| is_part(&name)) else { break };
        lock::require_no_other(above, |work| matches!(work, Work::Search | Work::Study))?;
        here = above;
    }
    Ok(())
}

/// Renames a folder of sph-mpi's and makes a new one, whose lock is returned.
fn make_room(folder: &Path, mut lock: Lock, work: Work) -> Result<Lock> {
    let refused = |what: &str| {
        let allowed = "--resume, or another directory (--out)";
        Err(Error::new(what).at(folder.display().to_string()).allowed(allowed).bad_input())
    };
    if std::env::current_dir().and_then(|here| here.canonicalize()).is_ok_and(|here| here.starts_with(folder)) {
        return refused("a run is here, and the current directory cannot be renamed");
    }
    lock::require_none_below(folder, LEVELS, &|_| true)?;
    let name = folder.file_name().unwrap_or_default().to_string_lossy();
    let free =
        (1..).map(|n| folder.with_file_name(format!("{name}.{n}"))).find(|path| path.symlink_metadata().is_err());
    let free = free.unwrap_or_default();
    std::fs::rename(folder, &free).map_err(|e| cannot("rename the run that is here", folder, e))?;
    lock.moved_to(&free);
    std::fs::create_dir_all(folder).map_err(|e| cannot("write here", folder, e))?;
    let lock = Lock::take(folder, work)?;
    mark(folder)?;
    Ok(lock)
}

/// Beside files of the user's none may have the name of one that a run writes.
fn refuse_to_overwrite(path: &Path, found: &[String]) -> Result<()> {
    let names: Vec<&str> = found.iter().map(String::as_str).filter(|name| is_of_a_run(name)).collect();
    let named = match names[..] {
        [] => return Ok(()),
        [name] => format!("{name}, which a run writes over, is"),
        [first, second] => format!("{first} and {second}, which a run writes over, are"),
        [first, second, ..] => format!("{first}, {second} and more, which a run writes over, are"),
    };
    let what = format!("{named} in a folder that was not made for a run, and is not renamed");
    let allowed = "another directory (--out), these files elsewhere, or --resume for a run that is here";
    Err(Error::new(what).at(path.display().to_string()).allowed(allowed).bad_input())
}

/// Whether a run, a search or a study writes a file of this name.
pub fn is_of_a_run(name: &str) -> bool {
    const FILES: [&str; 46] = [
        "checkpoint.h5",
        "checkpoint_previous.h5",
        "crater.csv",
        "deepest.png",
        "deposit.csv",
        "deposit.png",
        "distention.csv",
        "distention.png",
        "ejecta.csv",
        "ejecta.png",
        "error_core_seconds.png",
        "error_pairs.png",
        "filling_profile.csv",
        "filling_profile.png",
        "filling_volumes.csv",
        "filling_volumes.png",
        "fragment_masses.csv",
        "fragment_masses.png",
        "fragments.csv",
        "history.csv",
        "history_damaged.csv",
        "impacts.json",
        "intrusion.csv",
        "intrusion.png",
        "log.txt",
        "nbody.bin",
        "nbody.csv",
        "outcome.png",
        "point.json",
        "q_star.png",
        "report.html",
        "map.png",
        "restitution.csv",
        "restitution.png",
        "scene.toml",
        "sizes.csv",
        "snapshots.vtkhdf.series",
        "study.csv",
        "study.json",
        "study.md",
        "summary.json",
        "summary_previous.json",
        "threshold.csv",
        "threshold.png",
        "trace.json",
        "velocities.csv",
    ];
    let name = name.strip_suffix(".tmp").unwrap_or(name);
    let numbered = |kind: (&str, &str)| name.starts_with(kind.0) && name.ends_with(kind.1);
    FILES.contains(&name) || [("snapshot_", ".vtkhdf"), ("compare_", ".png")].into_iter().any(numbered) || is_part(name)
}

/// Names of the folders of an impact of a search and of a point of a study.
fn is_part(name: &str) -> bool {
    let number = name.strip_prefix("impact_").or(name.strip_prefix("point_"));
    number.is_some_and(|number| !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    fn read(path: &Path) -> String {
        fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
    }

    /// A run that writes a summary and ends.
    fn run(path: &Path, says: &str) -> Result<()> {
        let _lock = prepare_alone(path, false, Work::Run)?;
        fs::write(path.join("summary.json"), says).unwrap();
        Ok(())
    }

    #[test]
    fn runs_are_renamed_and_never_overwritten() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("impact");
        for round in 0..3 {
            run(&path, &round.to_string()).unwrap();
            // Files that the user puts beside it are renamed with it.
            fs::write(path.join("notes.txt"), round.to_string()).unwrap();
        }
        for (name, round) in [("impact.1", "0"), ("impact.2", "1"), ("impact", "2")] {
            let there = folder.path().join(name);
            assert_eq!(
                (read(&there.join("summary.json")), read(&there.join("notes.txt"))),
                (round.into(), round.into())
            );
            assert!(!there.join(LOCK).exists(), "{name} is left locked");
        }
        prepare_alone(&path, true, Work::Run).unwrap();
        assert_eq!(read(&path.join("summary.json")), "2");
    }

    #[test]
    fn a_run_at_work_is_neither_renamed_nor_resumed() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("impact");
        let at_work = prepare_alone(&path, false, Work::Run).unwrap();
        fs::write(path.join("summary.json"), "at work").unwrap();
        for resume in [false, true] {
            let error = prepare_alone(&path, resume, Work::Run).unwrap_err();
            assert!(error.what.starts_with("a run is at work here: process "), "{error}");
        }
        assert_eq!(
            (read(&path.join("summary.json")), folder.path().join("impact.1").exists()),
            ("at work".into(), false)
        );
        drop(at_work);
        run(&path, "next").unwrap();
    }

    #[test]
    fn a_folder_of_the_users_stays_where_it_is() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("project");
        fs::create_dir(&path).unwrap();
        fs::write(path.join("notes.txt"), "mine").unwrap();
        run(&path, "first").unwrap();
        assert_eq!((read(&path.join("notes.txt")), read(&path.join("summary.json"))), ("mine".into(), "first".into()));
        let error = run(&path, "second").unwrap_err();
        assert!(error.what.starts_with("summary.json, which a run writes over") && error.bad_input, "{error}");
        prepare_alone(&path, true, Work::Run).unwrap();
        // A scene, named as the one that a run writes.
        fs::remove_file(path.join("summary.json")).unwrap();
        fs::write(path.join("scene.toml"), "mine").unwrap();
        assert!(run(&path, "third").unwrap_err().what.starts_with("scene.toml, "));
        assert_eq!((read(&path.join("scene.toml")), entries(folder.path())), ("mine".into(), vec!["project".into()]));
    }

    /// Emptied and filled with other things, a folder that sph-mpi once made is the user's.
    #[test]
    fn a_folder_without_a_run_is_not_renamed() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("project");
        run(&path, "gone").unwrap();
        fs::remove_file(path.join("summary.json")).unwrap();
        fs::write(path.join("notes.txt"), "mine").unwrap();
        run(&path, "here").unwrap();
        assert_eq!((read(&path.join("notes.txt")), read(&path.join("summary.json"))), ("mine".into(), "here".into()));
        assert_eq!(entries(folder.path()), ["project"]);
    }

    #[test]
    fn symbolic_links_are_followed() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir(at("scratch")).unwrap();
        std::os::unix::fs::symlink("scratch/run", at("hop")).unwrap();
        std::os::unix::fs::symlink("hop", at("link")).unwrap();
        for (round, name) in ["link", "link/", "hop"].iter().enumerate() {
            run(&at(name), &round.to_string()).unwrap();
        }
        for (name, round) in [("run.1", "0"), ("run.2", "1"), ("run", "2")] {
            assert_eq!(read(&at("scratch").join(name).join("summary.json")), round);
        }
        assert!(at("link").is_symlink() && at("hop").is_symlink());
        assert_eq!(entries(folder.path()), ["hop", "link", "scratch"]);
        fs::write(at("file"), "").unwrap();
        assert!(run(&at("file"), "").unwrap_err().what.starts_with("a file of this name exists"));
    }

    /// Impacts and points have locks of their own, and no other process may work in or around them.
    #[test]
    fn searches_and_studies_hold_their_folders() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("study");
        let study = prepare_alone(&path, false, Work::Study).unwrap();
        let point = prepare_alone(&path.join("point_001"), false, Work::Search).unwrap();
        let impact = prepare_alone(&path.join("point_001/impact_02"), false, Work::Run).unwrap();
        // As another process would see it.
        let leave = |folder: &Path| {
            let text = read(&folder.join(LOCK)).replace("\"host\": \"", "\"host\": \"another_");
            fs::write(folder.join(LOCK), text).unwrap();
        };
        leave(&path.join("point_001/impact_02"));
        for (taken, work) in [(&path.join("point_001"), Work::Search), (&path, Work::Study)] {
            let lock = if work == Work::Study { &study } else { &point };
            assert!(require_no_work_around(taken, work).unwrap_err().place.ends_with("impact_02"), "{lock:?}");
        }
        require_no_work_around(&path, Work::Tables).unwrap();
        drop(impact);
        fs::remove_file(path.join("point_001/impact_02").join(LOCK)).unwrap();
        leave(&path);
        for below in ["point_002", "point_001/impact_03"] {
            let error = prepare_alone(&path.join(below), false, Work::Run).unwrap_err();
            assert!(error.what.starts_with("a study is at work here"), "{error}");
        }
        // Any other folder there is no part of it.
        prepare_alone(&path.join("elsewhere"), false, Work::Run).unwrap();
    }

    #[test]
    fn checkpoints_so_many_levels_below() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("study");
        fs::create_dir_all(path.join("point_001")).unwrap();
        fs::write(path.join("point_001").join(PREVIOUS), "").unwrap();
        assert!(holds_checkpoint(&path, 1) && !holds_checkpoint(&path, 0));
    }
}
