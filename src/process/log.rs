//! The log: every line goes to the terminal of rank 0 and to the `log.txt` of the current run; `RUST_LOG` filters.
//! With a terminal attached, one progress bar stays below the lines; batch logs get plain lines from time to time instead. A
//! terminal or a pipe that takes no more lines does not end a run, whose own files are complete.

use std::fs::File;
use std::io::{IsTerminal, Write};
use std::os::fd::AsRawFd;
use std::os::unix::fs::OpenOptionsExt;
use std::os::unix::process::parent_id;
use std::path::{Path, PathBuf};
use std::sync::{LazyLock, Mutex, PoisonError};
use std::time::{Duration, Instant};

use console::Term;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::{memory, signals};
use crate::error::{Error, Result, plain};
use crate::output::publish::cannot;

/// Share of a run that has to be done before the rest is estimated.
const LEAST_SHARE: f64 = 0.01;

static LOG_FILE: Mutex<Option<File>> = Mutex::new(None);
/// The path of the log file, on every rank.
static LOG_PATH: Mutex<Option<PathBuf>> = Mutex::new(None);
static BAR: Mutex<Option<ProgressBar>> = Mutex::new(None);

/// Writes a line to the terminal, above the bar, and to the log file.
struct Tee {
    rank: usize,
}

impl Write for Tee {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        // One line, whatever names it contains.
        let text = plain(String::from_utf8_lossy(bytes).trim_end()).replace('\n', "\\n") + "\n";
        let bar = BAR.lock().unwrap().clone();
        match bar {
            Some(bar) => bar.println(text.trim_end()),
            None => to_terminal(text.as_bytes()),
        }
        if self.rank == 0 {
            to_open_file(text.as_bytes());
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

/// The launcher that forwards this process's lines; it ends all ranks where its own output is no longer read.
static LAUNCHER: LazyLock<Option<u32>> = LazyLock::new(|| signals::launcher(parent_id()));

/// Whether the standard error of the launcher, if that is a pipe, still has a reader.
fn is_read() -> bool {
    let Some(launcher) = *LAUNCHER else { return true };
    let path = PathBuf::from(format!("/proc/{launcher}/fd/2"));
    if !std::fs::read_link(&path).is_ok_and(|to| to.to_string_lossy().starts_with("pipe:")) {
        return true;
    }
    // A pipe without a reader cannot be opened for writing, unless one waits for a reader.
    let open = File::options().write(true).custom_flags(libc::O_NONBLOCK).open(path);
    !open.is_err_and(|e| e.raw_os_error() == Some(libc::ENXIO))
}

fn to_terminal(bytes: &[u8]) {
    if is_read() {
        let _ = std::io::stderr().write_all(bytes);
    }
}

/// A full disk must not stop the log on the terminal; the run's own files report it.
fn to_open_file(bytes: &[u8]) {
    if let Some(file) = LOG_FILE.lock().unwrap_or_else(PoisonError::into_inner).as_mut() {
        let _ = file.write_all(bytes);
    }
}

/// An error: one line on the terminal, and in the log of the current run. For the rank that logs.
pub fn error(error: &Error) {
    let line = format!("error: {}\n", plain(&error.to_string()));
    to_terminal(line.as_bytes());
    to_open_file(line.as_bytes());
}

/// Writes every panic to the log of the run, whatever the rank.
fn note_panics(rank: usize) {
    let next = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |info| {
        // A thread that panics may hold the lock.
        if let Ok(path) = LOG_PATH.try_lock()
            && let Some(mut file) = path.as_ref().and_then(|path| File::options().append(true).open(path).ok())
        {
            let _ = writeln!(file, "error: rank {rank} {}", info.to_string().replace('\n', " "));
        }
        next(info);
    }));
}

/// Starts logging on this rank: rank 0 logs everything, the others only warnings; with `quiet` only errors are logged.
pub fn start(rank: usize, quiet: bool) {
    memory::name_rank(rank);
    note_panics(rank);
    let default = match (rank, quiet) {
        (_, true) => "error",
        (0, false) => "info",
        _ => "warn",
    };
    let filter = tracing_subscriber::EnvFilter::try_from_default_env()
        .unwrap_or_else(|_| tracing_subscriber::EnvFilter::new(default));
    tracing_subscriber::fmt()
        .with_env_filter(filter)
        .with_target(false)
        .with_ansi(false)
        .with_timer(tracing_subscriber::fmt::time::uptime())
        .with_writer(move || Tee { rank })
        .init();
}

/// From now on lines also go to `path`, on the rank that `logs`; the others know where it is. A resumed run continues without
/// a file that cannot be opened.
pub fn to_file(path: &Path, resumed: bool, logs: bool) -> Result<()> {
    *LOG_PATH.lock().unwrap_or_else(PoisonError::into_inner) = Some(path.to_path_buf());
    if !logs {
        return Ok(());
    }
    // Lines of other ranks are between those of this one.
    let opened = File::options().create(true).append(true).open(path);
    let emptied = opened.and_then(|file| if resumed { Ok(file) } else { file.set_len(0).map(|()| file) });
    let mut open = LOG_FILE.lock().unwrap_or_else(PoisonError::into_inner);
    memory::report_to(emptied.as_ref().map_or(-1, AsRawFd::as_raw_fd));
    match emptied {
        Ok(file) => *open = Some(file),
        Err(error) if resumed => {
            *open = None;
            drop(open);
            tracing::warn!("{} cannot be continued: {error}", path.display());
        }
        Err(error) => return Err(cannot("write", path, error)),
    }
    Ok(())
}

/// The terminal that the user looks at: this rank's own, or that of its launcher, which forwards output through a pipe.
fn terminal() -> Option<ProgressDrawTarget> {
    if std::io::stderr().is_terminal() {
        return Some(ProgressDrawTarget::stderr());
    }
    let launcher = std::fs::read_link(format!("/proc/{}/fd/2", std::os::unix::process::parent_id())).ok()?;
    let is_terminal = launcher.starts_with("/dev/pts") || launcher.starts_with("/dev/tty");
    let open = || File::options().read(true).write(true).open(&launcher).ok();
    let (reader, writer) = is_terminal.then(|| open().zip(open())).flatten()?;
    Some(ProgressDrawTarget::term(Term::read_write_pair(reader, writer), 10))
}

/// Progress of one run, on rank 0.
pub struct Progress {
    bar: Option<ProgressBar>,
    spoken: Instant,
    logs: bool,
    /// When it was looked at first, and how much was done then.
    first: Option<(Instant, f64)>,
}

impl Progress {
    /// Lines of a batch log are this far apart.
    const PAUSE: Duration = Duration::from_secs(20);

    pub fn new(title: &str, root: bool) -> Self {
        let bar = terminal().filter(|_| root).map(|target| {
            let bar = ProgressBar::with_draw_target(Some(1000), target);
            let style = ProgressStyle::with_template("{prefix} {bar:24} {percent:>3}% {elapsed} {wide_msg}");
            bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
            bar.set_prefix(plain(title).into_owned());
            bar
        });
        *BAR.lock().unwrap() = bar.clone();
        Self { bar, spoken: Instant::now(), logs: root, first: None }
    }

    /// `done` in 0..1; the message is made only when it is shown.
    pub fn show(&mut self, done: f64, message: impl FnOnce() -> String) {
        let done = done.clamp(0.0, 1.0);
        let (since, before) = *self.first.get_or_insert((Instant::now(), done));
        let left = left(since.elapsed(), before, done);
        if let Some(bar) = &self.bar {
            bar.set_position((1000.0 * done) as u64);
            bar.set_message(format!("{left}{}", plain(&message())));
        } else if self.logs && self.spoken.elapsed() > Self::PAUSE {
            self.spoken = Instant::now();
            tracing::info!("{:.0} % {left}{}", 100.0 * done, message());
        }
    }
}

/// `12 min left, `: as long as it has taken so far for each share of the run; nothing where too little is done to tell.
fn left(elapsed: Duration, before: f64, done: f64) -> String {
    let share = done - before;
    if share < LEAST_SHARE || done >= 1.0 {
        return String::new();
    }
    let seconds = elapsed.as_secs_f64() * (1.0 - done) / share;
    let words = match seconds {
        s if s < 90.0 => format!("{s:.0} s"),
        s if s < 5400.0 => format!("{:.0} min", s / 60.0),
        s if s < 172_800.0 => format!("{:.1} h", s / 3600.0),
        s => format!("{:.1} days", s / 86_400.0),
    };
    format!("{words} left, ")
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
        *BAR.lock().unwrap() = None;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rest_takes_as_long_as_what_is_done() {
        let left = |minutes: u64, before, done| left(Duration::from_secs(60 * minutes), before, done);
        assert_eq!(left(10, 0.0, 0.25), "30 min left, ");
        // A run that was resumed at a half.
        assert_eq!(left(10, 0.5, 0.75), "10 min left, ");
        assert_eq!(left(60, 0.0, 0.25) + &left(1, 0.0, 0.5), "3.0 h left, 60 s left, ");
        assert_eq!(left(10, 0.5, 0.505) + &left(10, 0.0, 1.0), "");
    }
}
