//! The lock of a folder: a file `lock` with host, process and the time at which that process started, made by rank 0 and
//! removed when the work is done. The lock of a killed run is distinguished from that of a working one if it was started on this
//! host.

use std::fs::{self, File};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use serde::{Deserialize, Serialize};

use crate::error::{Error, Result};
use crate::output::publish::cannot;

/// The file's name.
pub const LOCK: &str = "lock";

/// The kind of work in a folder.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Work {
    Run,
    /// Runs its impacts in folders of its own.
    Search,
    /// Runs its points in folders of its own.
    Study,
    /// Tables and figures of a study; points may run meanwhile.
    Tables,
}

/// The contents of the file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Holder {
    work: Work,
    /// The host's name; and the machine id, which distinguishes hosts of one name, where it is known.
    host: String,
    machine: String,
    process: u32,
    /// For the person who reads it.
    since: String,
    /// Clock ticks from the machine's start to that of the process: a later process of the same number has others.
    start: u64,
    /// This start of the machine.
    boot: String,
    /// Process numbers are valid within one of these only.
    namespace: String,
    /// Slurm's job, and how often it was requeued: when it runs again, the earlier run is over.
    job: String,
    restarts: u64,
}

/// Whether a holder is still there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Life {
    AtWork,
    Gone,
    /// On another host.
    Unknown,
}

/// A lock that this process holds; it is released when dropped.
#[derive(Debug)]
pub struct Lock {
    folder: PathBuf,
    text: String,
}

impl Lock {
    /// Takes the lock of a folder; an error names the holder. For one rank.
    pub fn take(folder: &Path, work: Work) -> Result<Self> {
        // Of two processes that find a lock left behind only one may replace it. Both are on this host, where this file lock
        // separates them; on a file system without such locks the rest still holds.
        let door = File::open(folder).map_err(|e| cannot("write here", folder, e))?;
        let _ = door.lock();
        let path = folder.join(LOCK);
        let me = Holder::me(work);
        let text = serde_json::to_string_pretty(&me).map_err(|e| Error::new(e.to_string()))? + "\n";
        loop {
            match File::create_new(&path) {
                Ok(mut file) => {
                    let lock = Self { folder: folder.to_path_buf(), text };
                    if let Err(error) = file.write_all(lock.text.as_bytes()).and_then(|()| file.sync_all()) {
                        // An incomplete lock must not remain.
                        let _ = fs::remove_file(&path);
                        return Err(cannot("write", &path, error));
                    }
                    return Ok(lock);
                }
                Err(error) if error.kind() != ErrorKind::AlreadyExists => {
                    return Err(Error::new(format!("cannot write here: {error}")).at(folder.display().to_string()));
                }
                Err(_) => {}
            }
            match Holder::of(&path)? {
                Some(holder) if holder.life(&me) == Life::Gone => {
                    tracing::info!("{}: left behind by {}, which has ended", path.display(), holder.process());
                    fs::remove_file(&path).map_err(|e| cannot("remove", &path, e))?;
                }
                Some(holder) => return Err(holder.refusal(&me, folder)),
                None => {}
            }
        }
    }

    /// To be called when the folder has been renamed.
    pub fn moved_to(&mut self, folder: &Path) {
        self.folder = folder.to_path_buf();
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        let path = self.folder.join(LOCK);
        // A user who removed it by hand may have begun another run here.
        if fs::read_to_string(&path).is_ok_and(|text| text == self.text) {
            let _ = fs::remove_file(&path);
        }
    }
}

/// Fails where another process is at work in a folder that `matters`, at most so many levels below.
pub fn require_none_below(folder: &Path, levels: usize, matters: &dyn Fn(&str) -> bool) -> Result<()> {
    let folders = fs::read_dir(folder).into_iter().flatten().flatten().filter(|entry| entry.path().is_dir());
    for entry in folders.filter(|entry| matters(&entry.file_name().to_string_lossy())) {
        require_no_other(&entry.path(), |_| true)?;
        if levels > 1 {
            require_none_below(&entry.path(), levels - 1, matters)?;
        }
    }
    Ok(())
}

/// Fails where another process holds the lock of the folder for work that `matters`.
pub fn require_no_other(folder: &Path, matters: fn(Work) -> bool) -> Result<()> {
    let me = Holder::me(Work::Run);
    match Holder::of(&folder.join(LOCK))? {
        Some(holder) if !matters(holder.work) || holder.life(&me) == Life::Gone || holder.is_same_process(&me) => {
            Ok(())
        }
        Some(holder) => Err(holder.refusal(&me, folder)),
        None => Ok(()),
    }
}

impl Holder {
    fn me(work: Work) -> Self {
        let read = |path: &str| fs::read_to_string(path).map_or(String::new(), |text| text.trim().to_string());
        let set = |name: &str| std::env::var(name).unwrap_or_default();
        let process = std::process::id();
        Self {
            work,
            host: read("/proc/sys/kernel/hostname"),
            machine: read("/etc/machine-id"),
            process,
            since: utc(SystemTime::now()),
            start: start_of(process).unwrap_or(0),
            boot: read("/proc/sys/kernel/random/boot_id"),
            namespace: fs::read_link("/proc/self/ns/pid").map_or(String::new(), |path| path.display().to_string()),
            job: set("SLURM_JOB_ID"),
            restarts: set("SLURM_RESTART_COUNT").parse().unwrap_or(0),
        }
    }

    /// The holder of a lock; `None` where there is no lock.
    fn of(path: &Path) -> Result<Option<Self>> {
        // One that is just being made, on another host, is empty for a moment.
        for _ in 0..20 {
            match fs::read(path) {
                Ok(text) => {
                    if let Ok(holder) = serde_json::from_slice(&text) {
                        return Ok(Some(holder));
                    }
                }
                Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
                Err(error) => return Err(cannot("read", path, error).bad_input()),
            }
            std::thread::sleep(Duration::from_millis(25));
        }
        let what = "there is a lock here that does not name its holder";
        let allowed = "another directory (--out); or, if no run is at work here, this file removed";
        Err(Error::new(what).at(path.display().to_string()).allowed(allowed).bad_input())
    }

    fn life(&self, me: &Self) -> Life {
        if !self.job.is_empty() && self.job == me.job && self.restarts < me.restarts {
            return Life::Gone;
        }
        if (&self.host, &self.machine) != (&me.host, &me.machine) {
            return Life::Unknown;
        }
        if self.boot != me.boot {
            return Life::Gone;
        }
        if self.namespace != me.namespace {
            return Life::Unknown;
        }
        match start_of(self.process) {
            Some(start) if start == self.start => Life::AtWork,
            Some(_) => Life::Gone,
            // Some systems hide the processes of others.
            None if exists(self.process) => Life::AtWork,
            None => Life::Gone,
        }
    }

    fn is_same_process(&self, me: &Self) -> bool {
        let key = |holder: &Self| (holder.host.clone(), holder.boot.clone(), holder.namespace.clone());
        (self.process, self.start) == (me.process, me.start) && key(self) == key(me)
    }

    fn process(&self) -> String {
        format!("process {} on {} since {}", self.process, self.host, self.since)
    }

    fn refusal(&self, me: &Self, folder: &Path) -> Error {
        let work = match self.work {
            Work::Run => "a run is",
            Work::Search => "a threshold search is",
            Work::Study => "a study is",
            Work::Tables => "a study's tables are",
        };
        let (path, other) = (folder.join(LOCK), "another directory (--out)");
        let (unsure, allowed) = match self.life(me) {
            Life::Unknown => (
                ", which cannot be checked from here",
                format!("{other}; or, if that process has ended, {} removed", path.display()),
            ),
            _ => ("", format!("{other}, or this one when that has ended")),
        };
        let what = format!("{work} at work here: {}{unsure}", self.process());
        Error::new(what).at(folder.display().to_string()).allowed(allowed).bad_input()
    }
}

/// Clock ticks from the start of the machine to that of a process, 0 for one that has ended and was not yet reaped by its
/// parent; `None` where there is none or it cannot be seen.
fn start_of(process: u32) -> Option<u64> {
    let stat = fs::read_to_string(format!("/proc/{process}/stat")).ok()?;
    // pid (name) state parent ... start: the name may hold anything, brackets too.
    let fields: Vec<&str> = stat.rsplit_once(')')?.1.split_whitespace().collect();
    if matches!(*fields.first()?, "Z" | "X") { Some(0) } else { fields.get(19)?.parse().ok() }
}

/// Whether a process exists whose details cannot be read.
fn exists(process: u32) -> bool {
    // SAFETY: signal 0 only tests whether the process exists.
    let there = unsafe { libc::kill(process as libc::pid_t, 0) } == 0;
    there || std::io::Error::last_os_error().raw_os_error() == Some(libc::EPERM)
}

/// `2026-03-01 12:00:00 UTC`.
fn utc(time: SystemTime) -> String {
    let seconds = time.duration_since(SystemTime::UNIX_EPOCH).map_or(0, |since| since.as_secs());
    let (hour, minute, second) = (seconds / 3600 % 24, seconds / 60 % 60, seconds % 60);
    let (mut days, mut year) = (seconds / 86400, 1970);
    let leap = |year: u64| year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    while days >= 365 + leap(year) as u64 {
        days -= 365 + leap(year) as u64;
        year += 1;
    }
    let lengths = [31, 28 + leap(year) as u64, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
    let mut month = 0;
    while days >= lengths[month] {
        days -= lengths[month];
        month += 1;
    }
    format!("{year}-{:02}-{:02} {hour:02}:{minute:02}:{second:02} UTC", month + 1, days + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Leaves a lock as another process would, which differs from this one by `change`.
    fn leave(folder: &Path, change: impl FnOnce(&mut Holder)) {
        let mut holder = Holder::me(Work::Run);
        change(&mut holder);
        fs::write(folder.join(LOCK), serde_json::to_string(&holder).unwrap()).unwrap();
    }

    /// A number that no process has: none is above the kernel's largest.
    const NOBODY: u32 = (1 << 22) + 1;

    #[test]
    fn the_second_is_told_who_holds_it_and_the_next_gets_it() {
        let folder = tempfile::tempdir().unwrap();
        let first = Lock::take(folder.path(), Work::Search).unwrap();
        let error = Lock::take(folder.path(), Work::Run).unwrap_err();
        let who = format!("a threshold search is at work here: process {} on ", std::process::id());
        assert!(error.what.starts_with(&who) && error.what.ends_with(" UTC") && error.bad_input, "{error}");
        assert!(error.allowed.contains("--out") && !error.allowed.contains("removed"), "{error}");
        drop(first);
        assert!(!folder.path().join(LOCK).exists());
        Lock::take(folder.path(), Work::Run).unwrap();
    }

    #[test]
    fn locks_left_behind_are_taken_over() {
        let folder = tempfile::tempdir().unwrap();
        let changes: [fn(&mut Holder); 3] = [
            |holder| holder.process = NOBODY,
            // The process number is that of another process by now.
            |holder| holder.start -= 1,
            |holder| holder.boot = "before the power failed".into(),
        ];
        for (number, change) in changes.into_iter().enumerate() {
            leave(folder.path(), change);
            drop(Lock::take(folder.path(), Work::Run).unwrap_or_else(|e| panic!("change {number}: {e}")));
        }
    }

    /// A requeued job of Slurm may run on another host.
    #[test]
    fn a_job_does_not_stand_in_its_own_way() {
        let of = |job: &str, host: &str, restarts: u64| Holder {
            job: job.into(),
            host: host.into(),
            restarts,
            process: NOBODY,
            ..Holder::me(Work::Run)
        };
        assert_eq!(of("7", "node1", 0).life(&of("7", "node2", 1)), Life::Gone);
        assert_eq!(of("7", "node1", 1).life(&of("7", "node2", 1)), Life::Unknown);
        assert_eq!(of("6", "node1", 0).life(&of("7", "node2", 1)), Life::Unknown);
        assert_eq!(of("", "node1", 0).life(&of("", "node2", 1)), Life::Unknown);
    }

    /// Whether they are at work cannot be known here: the error says what to do.
    #[test]
    fn locks_of_other_hosts_and_locks_that_say_nothing_are_left_to_the_user() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(LOCK);
        let changes: [fn(&mut Holder); 3] = [
            |holder| (holder.host, holder.process) = ("node17".into(), NOBODY),
            |holder| (holder.machine, holder.process) = ("another of this name".into(), NOBODY),
            |holder| (holder.namespace, holder.process) = ("of another container".into(), NOBODY),
        ];
        for change in changes {
            leave(folder.path(), change);
            let error = Lock::take(folder.path(), Work::Run).unwrap_err();
            let how = format!("{} removed", path.display());
            assert!(error.what.contains("cannot be checked from here") && error.allowed.contains(&how), "{error}");
        }
        for text in ["", "\0\0\0", "{}"] {
            fs::write(&path, text).unwrap();
            let error = Lock::take(folder.path(), Work::Run).unwrap_err();
            assert!(error.place.ends_with(LOCK) && error.allowed.contains("removed") && error.bad_input, "{error}");
        }
        fs::remove_file(&path).unwrap();
        Lock::take(folder.path(), Work::Run).unwrap();
    }

    /// Many processes at once, with a lock left behind or none: one gets it.
    #[test]
    fn of_many_at_once_one_gets_it() {
        for stale in [false, true] {
            let folder = tempfile::tempdir().unwrap();
            if stale {
                leave(folder.path(), |holder| holder.process = NOBODY);
            }
            let take = |_| Lock::take(folder.path(), Work::Run).ok();
            let got: Vec<Option<Lock>> = std::thread::scope(|scope| {
                let threads: Vec<_> = (0..8).map(|n| scope.spawn(move || take(n))).collect();
                threads.into_iter().map(|thread| thread.join().unwrap()).collect()
            });
            assert_eq!(got.iter().flatten().count(), 1, "stale: {stale}");
        }
    }

    #[test]
    fn a_lock_put_there_by_another_is_not_taken_away() {
        let folder = tempfile::tempdir().unwrap();
        let mine = Lock::take(folder.path(), Work::Run).unwrap();
        leave(folder.path(), |holder| holder.process = NOBODY);
        drop(mine);
        assert!(folder.path().join(LOCK).exists());
    }

    #[test]
    fn work_in_folders_below() {
        let folder = tempfile::tempdir().unwrap();
        let impact = folder.path().join("point_001/impact_02");
        fs::create_dir_all(&impact).unwrap();
        let all = |_: &str| true;
        // This process's own.
        let own = Lock::take(&impact, Work::Run).unwrap();
        require_none_below(folder.path(), 2, &all).unwrap();
        drop(own);
        leave(&impact, |holder| holder.host = "node17".into());
        require_none_below(folder.path(), 1, &all).unwrap();
        assert!(require_none_below(folder.path(), 2, &all).unwrap_err().place.ends_with("impact_02"));
        require_none_below(folder.path(), 2, &|name| name.starts_with("point")).unwrap();
    }

    #[test]
    fn dates() {
        let at = |seconds| utc(SystemTime::UNIX_EPOCH + Duration::from_secs(seconds));
        assert_eq!(at(0), "1970-01-01 00:00:00 UTC");
        assert_eq!(at(951_782_400), "2000-02-29 00:00:00 UTC");
        assert_eq!(at(1_767_225_599), "2025-12-31 23:59:59 UTC");
    }
}
