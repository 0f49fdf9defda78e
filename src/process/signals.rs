//! SIGTERM, SIGINT (Ctrl-C), SIGHUP and SIGUSR1, on any rank, request a checkpoint at the end of the step and a clean exit; a
//! second Ctrl-C ends the process at once. Where the launcher of the ranks ends before them, they end at once, too, as their output
//! is lost. A file that grows beyond the limit of the shell is an error like a full disk, not the end of the process.

use std::fs;
use std::os::unix::process::parent_id;
use std::sync::atomic::{AtomicI64, AtomicU32, Ordering};

static ASKED: AtomicU32 = AtomicU32::new(0);
/// When the first signal came, ms; zero before.
static FIRST: AtomicI64 = AtomicI64::new(0);

/// One Ctrl-C may arrive twice, by two ways; one after this time is a second one, ms.
const DELIBERATE: i64 = 500;
/// Programs that start ranks, by the beginnings of their names.
const LAUNCHERS: [&str; 7] = ["mpirun", "mpiexec", "orterun", "orted", "prterun", "prted", "hydra"];

fn milliseconds() -> i64 {
    let mut now = libc::timespec { tv_sec: 0, tv_nsec: 0 };
    // SAFETY: fills the structure that it is given, and may be called in a handler.
    unsafe { libc::clock_gettime(libc::CLOCK_MONOTONIC, &mut now) };
    1 + 1000 * now.tv_sec + now.tv_nsec / 1_000_000
}

extern "C" fn request(signal: libc::c_int) {
    let now = milliseconds();
    let first = FIRST.compare_exchange(0, now, Ordering::Relaxed, Ordering::Relaxed);
    if signal == libc::SIGINT && first.is_err_and(|first| now - first > DELIBERATE) {
        // SAFETY: ends the process, and may be called in a handler.
        unsafe { libc::_exit(128 + signal) };
    }
    ASKED.store(signal as u32, Ordering::Relaxed);
}

/// Installs the handlers. Signals that the user has chosen to ignore, as by nohup, stay ignored.
pub fn listen() {
    for signal in [libc::SIGTERM, libc::SIGUSR1, libc::SIGINT, libc::SIGHUP] {
        // SAFETY: the handler only touches atomics, reads the time and ends the process.
        unsafe {
            if libc::signal(signal, request as *const () as libc::sighandler_t) == libc::SIG_IGN {
                libc::signal(signal, libc::SIG_IGN);
            }
        }
    }
    // SAFETY: an ignored signal runs nothing.
    unsafe { libc::signal(libc::SIGXFSZ, libc::SIG_IGN) };
    if let Some(launcher) = launcher(parent_id()) {
        end_with(launcher);
    }
}

/// The signal that was received, or zero.
pub fn received() -> u32 {
    ASKED.load(Ordering::Relaxed)
}

/// The launcher among a process and its ancestors; none where ranks were started without one.
pub fn launcher(mut pid: u32) -> Option<u32> {
    while pid > 1 {
        let name = fs::read_to_string(format!("/proc/{pid}/comm")).ok()?;
        if LAUNCHERS.iter().any(|launcher| name.starts_with(launcher)) {
            return Some(pid);
        }
        // pid (name) state parent ...; the name may hold anything.
        let stat = fs::read_to_string(format!("/proc/{pid}/stat")).ok()?;
        pid = stat.rsplit_once(')')?.1.split_whitespace().nth(1)?.parse().ok()?;
    }
    None
}

/// Ends this process as soon as another one ends. A thread sleeps until then; where the system cannot watch processes, this has no
/// effect.
fn end_with(launcher: u32) {
    // SAFETY: opens a descriptor of another process, which is not touched.
    let process = unsafe { libc::syscall(libc::SYS_pidfd_open, launcher as libc::pid_t, 0) } as libc::c_int;
    if process < 0 {
        return;
    }
    let wait = move || {
        let mut until = libc::pollfd { fd: process, events: libc::POLLIN, revents: 0 };
        // SAFETY: waits for the one descriptor; then ends the process.
        unsafe {
            while libc::poll(&mut until, 1, -1) != 1 {}
            libc::_exit(128 + libc::SIGKILL);
        }
    };
    // Without the thread ranks end too, a second later, when MPI notices.
    let _ = std::thread::Builder::new().name("launcher".into()).stack_size(1 << 16).spawn(wait);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_launcher_is_found_among_ancestors() {
        // This process has one only where the tests run under one; the first process has none.
        assert_eq!(launcher(1), None);
        let mine = fs::read_to_string("/proc/self/comm").unwrap();
        assert!(LAUNCHERS.iter().all(|name| !mine.starts_with(name)));
    }
}
