//! The log: every line goes to the terminal of rank 0 and to the `log.txt` of the run that is going on; `RUST_LOG` filters.
//! With a terminal attached, one progress bar stays below the lines; batch logs get plain lines from time to time instead.

use std::fs::File;
use std::io::{IsTerminal, Write};
use std::path::Path;
use std::sync::Mutex;
use std::time::{Duration, Instant};

use console::Term;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::error::{Result, plain};
use crate::output::publish::cannot;

static LOG_FILE: Mutex<Option<File>> = Mutex::new(None);
static BAR: Mutex<Option<ProgressBar>> = Mutex::new(None);

/// Writes a line to the terminal, above the bar, and to the log file.
struct Tee {
    rank: usize,
}

impl Write for Tee {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        // One line, whatever names it tells.
        let text = plain(String::from_utf8_lossy(bytes).trim_end()).replace('\n', "\\n") + "\n";
        let bar = BAR.lock().unwrap().clone();
        match bar {
            Some(bar) => bar.println(text.trim_end()),
            None => std::io::stderr().write_all(text.as_bytes())?,
        }
        if self.rank == 0
            && let Some(file) = LOG_FILE.lock().unwrap().as_mut()
        {
            // A full disk must not stop the log on the terminal; the run's own files report it.
            let _ = file.write_all(text.as_bytes());
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

/// Starts logging on this rank: rank 0 speaks, the others only warn; `quiet` leaves errors.
pub fn start(rank: usize, quiet: bool) {
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

/// From now on lines also go to `path`, on rank 0. A run that is resumed goes on without where that cannot be.
pub fn to_file(path: &Path, resumed: bool) -> Result<()> {
    match File::options().create(true).write(true).append(resumed).truncate(!resumed).open(path) {
        Ok(file) => *LOG_FILE.lock().unwrap() = Some(file),
        Err(error) if resumed => {
            *LOG_FILE.lock().unwrap() = None;
            tracing::warn!("{} cannot be gone on with: {error}", path.display());
        }
        Err(error) => return Err(cannot("write", path, error)),
    }
    Ok(())
}

/// The terminal that the user looks at: this rank's own, or that of its launcher, which hands output on through a pipe.
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
    speaks: bool,
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
        Self { bar, spoken: Instant::now(), speaks: root }
    }

    /// `done` in 0..1; the message is made only when it is shown.
    pub fn show(&mut self, done: f64, message: impl FnOnce() -> String) {
        if let Some(bar) = &self.bar {
            bar.set_position((1000.0 * done.clamp(0.0, 1.0)) as u64);
            bar.set_message(plain(&message()).into_owned());
        } else if self.speaks && self.spoken.elapsed() > Self::PAUSE {
            self.spoken = Instant::now();
            tracing::info!("{:.0} % {}", 100.0 * done.clamp(0.0, 1.0), message());
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
        *BAR.lock().unwrap() = None;
    }
}
