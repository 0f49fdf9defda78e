//! The program: arguments, one scene for all ranks, the run it asks for, and one place that prints errors.

use std::borrow::Cow;
use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Parser;

use crate::cli::{Args, Command};
use crate::domain::comm::{Comm, Network};
use crate::error::{Error, Result, plain};
use crate::forecast::cost;
use crate::math::lanes;
use crate::output::summary::Accuracy;
use crate::output::{agree, collective, on_root};
use crate::process::faults::Fault;
use crate::process::lock::{self, Lock, Work};
use crate::process::{directory, log, resources, signals};
use crate::report;
use crate::scene::source::SourceText;
use crate::scene::{self, Scene, input};
use crate::simulation::{self, Ended, Options};
use crate::step::workers;
use crate::study::{self, Part, Sources, Study, keys, points, stored};
use crate::threshold::search;

/// Exit codes beside 0.
const BAD_INPUT: i32 = 2;
/// A run that failed on its way.
const FAILED: i32 = 1;
/// Stopped by a signal, with a whole checkpoint: EX_TEMPFAIL of sysexits.h, run again with --resume.
const INTERRUPTED: i32 = 75;

/// Runs the program on this rank and returns its exit code.
pub fn main() -> i32 {
    // Arguments are the same on every rank, and so is what comes of them; rank 0 alone has to say it.
    let comm = Comm::start();
    let resident_at_start = resources::resident_bytes();
    let code = match Args::try_parse() {
        Ok(args) if args.keys.is_some() || args.schema.is_some() => explain_keys(&args, &comm),
        Ok(Args { command: Some(Command::Report { directory }), .. }) => write_report(&directory, &comm),
        Ok(args) => on_all_ranks(&args, resident_at_start, &comm),
        Err(error) => {
            if comm.is_root() {
                say(&error);
            }
            error.exit_code()
        }
    };
    if collective::is_stuck(&comm) {
        comm.abort(code);
    }
    comm.finish();
    code
}

/// What may be written in a scene or a study: rank 0 prints what all find.
fn explain_keys(args: &Args, comm: &Comm) -> i32 {
    let text = match (&args.keys, &args.schema) {
        (Some(table), _) => keys::text(table),
        (None, of) => keys::schema_text(of.as_deref().unwrap_or_default()),
    };
    let text = match text {
        Ok(text) => text,
        Err(error) => return complain(&error, BAD_INPUT, comm),
    };
    match on_root(comm, || print(&text)) {
        Ok(()) => 0,
        Err(error) => complain(&error, FAILED, comm),
    }
}

/// Writes the report of a run, by rank 0, and says where.
fn write_report(directory: &Path, comm: &Comm) -> i32 {
    log::start(comm.rank(), false);
    let write = || {
        let path = report::write(directory, lock::require_no_other(directory, |_| true).is_err())?;
        print(&format!("{}\n", path.display()))
    };
    match on_root(comm, write) {
        Ok(()) => 0,
        Err(error) => complain(&error, if error.bad_input { BAD_INPUT } else { FAILED }, comm),
    }
}

/// What the command line gets for an answer: in colours, unless it holds what no terminal should get.
fn say(error: &clap::Error) {
    let text = error.render().to_string();
    match plain(&text) {
        Cow::Borrowed(_) => drop(error.print()),
        Cow::Owned(text) => eprint!("{text}"),
    }
}

/// What the file asks for.
enum Task {
    /// With the study's choice, where an accuracy was asked for.
    Scene(Box<Scene>, Option<Accuracy>),
    Study(Box<Study>),
}

fn on_all_ranks(args: &Args, resident_at_start: f64, comm: &Comm) -> i32 {
    log::start(comm.rank(), args.quiet);
    resources::hold_memory();
    if let Err(error) = check_machine(args, comm) {
        return complain(&error, BAD_INPUT, comm);
    }
    let task = match read(args, comm) {
        Ok(task) => task,
        Err(error) => return complain(&error, BAD_INPUT, comm),
    };
    if args.check || args.points {
        return match describe(args, &task, comm) {
            Ok(text) => match on_root(comm, || print(&plain(&text))) {
                Ok(()) => 0,
                Err(error) => complain(&error, FAILED, comm),
            },
            Err(error) => complain(&error, BAD_INPUT, comm),
        };
    }
    let options = Options {
        directory: args.out.clone().unwrap_or_else(|| usual_directory(args, &task)),
        resume: args.resume,
        resident_at_start,
        trace: args.trace,
        accuracy: match &task {
            Task::Scene(_, choice) => choice.clone(),
            Task::Study(_) => None,
        },
    };
    // Held until the work is done.
    let _lock = match prepare(args, &task, &options, comm) {
        Ok(lock) => lock,
        Err(error) => return complain(&error, BAD_INPUT, comm),
    };
    let ended = match &task {
        Task::Scene(scene, _) if scene.threshold.is_some() => {
            search::run(scene, &options, comm).map(|found| found.map_or(Ended::Interrupted, |_| Ended::Finished))
        }
        Task::Scene(scene, _) => simulation::run(scene, &options, comm).map(|report| report.ended),
        Task::Study(study) => study::run(study, part(args), &options, comm),
    };
    match ended {
        Ok(Ended::Finished) => 0,
        Ok(Ended::Interrupted) => INTERRUPTED,
        Err(error) => complain(&error, if error.bad_input { BAD_INPUT } else { FAILED }, comm),
    }
}

/// Rank 0 reads; all ranks get the same or the same error. A study's scenes are then read on each from the same texts.
fn read(args: &Args, comm: &Comm) -> Result<Task> {
    type Texts = (Option<(Scene, Option<Accuracy>)>, Option<Sources>);
    let read = || -> Result<Texts> {
        let refused =
            |what: &str, allowed: &str| Err(Error::new(what).at(args.scene().display().to_string()).allowed(allowed));
        let source = SourceText::open(args.scene(), &args.overrides)?;
        if points::is_study(&source) {
            if args.accuracy.is_some() {
                return refused("--accuracy of a study", "the scene that was studied");
            }
            return Ok((None, Some(points::read(source)?)));
        }
        let scene = scene::of(source)?;
        if args.task.is_some() || args.collect || args.points {
            return refused("a single scene has no points", "a file with a [study] table");
        }
        let Some(accuracy) = args.accuracy else { return Ok((Some((scene, None)), None)) };
        let choice = stored::choose(&scene, accuracy)?;
        Ok((Some((stored::apply(&scene, &choice)?, Some(choice))), None))
    };
    let mut bytes = Vec::new();
    if comm.is_root() {
        let read = read();
        // The others wait for an answer, whatever it is.
        bytes = serde_json::to_vec(&read)
            .or_else(|e| serde_json::to_vec(&Err::<Texts, _>(Error::new(format!("the scene cannot be sent: {e}")))))
            .unwrap_or_default();
    }
    comm.broadcast(&mut bytes);
    let read: Result<Texts> = serde_json::from_slice(&bytes).map_err(|e| Error::new(e.to_string()))?;
    match read? {
        (Some((scene, choice)), _) => {
            simulation::require(&scene)?;
            Ok(Task::Scene(Box::new(scene), choice))
        }
        (None, Some(sources)) => Ok(Task::Study(Box::new(Study::new(&sources)?))),
        (None, None) => Err(Error::new("nothing was read")),
    }
}

/// What `--check` and `--points` say. Collective.
fn describe(args: &Args, task: &Task, comm: &Comm) -> Result<String> {
    let ranks = args.ranks.unwrap_or(comm.size() as u32) as usize;
    let given = args.latency.zip(args.bandwidth);
    let network = given.map(|(latency, bandwidth)| Network { latency, bandwidth });
    agree(comm, workers::start_threads(1))?;
    match task {
        Task::Study(study) if args.points => Ok(study::check::list(study)),
        Task::Study(study) => match args.task {
            Some(number) => cost::check(&study.point(number as usize)?.scene, ranks, network, comm),
            None => study::check::check(study, ranks, network, comm),
        },
        Task::Scene(scene, choice) => {
            let chosen = choice.as_ref().map_or(String::new(), |choice| format!("{choice}\n\n"));
            Ok(chosen + &cost::check(scene, ranks, network, comm)?)
        }
    }
}

fn part(args: &Args) -> Part {
    match args.task {
        Some(number) => Part::Task(number as usize),
        None if args.collect => Part::Collect,
        None => Part::All,
    }
}

/// A study often has the name of its scene: its folder must not be that of the scene's runs.
fn usual_directory(args: &Args, task: &Task) -> PathBuf {
    // What comes through a pipe has no name of its own.
    let name = if input::is_passed_on(args.scene()) { Path::new("stdin") } else { args.scene() };
    let directory = directory::default_directory(name);
    match task {
        Task::Scene(..) => directory,
        Task::Study(_) => {
            directory.with_file_name(format!("{}_study", directory.file_name().unwrap_or_default().to_string_lossy()))
        }
    }
}

/// Threads that nobody means to start, on any number of cores; and over how many to a core.
const MOST_THREADS: usize = 256;
const MOST_PER_CORE: usize = 4;

/// What the environment and the command line say of this machine. Ranks may stand on different ones. Collective.
fn check_machine(args: &Args, comm: &Comm) -> Result<()> {
    let cores = workers::usable_cores();
    let most = MOST_THREADS.max(MOST_PER_CORE * cores);
    let threads = match args.threads {
        Some(threads) if threads as usize > most => {
            let what = format!("{threads} threads on {cores} usable cores");
            Err(Error::new(what).at("--threads").allowed(format!("1 to {most}")))
        }
        _ => Ok(()),
    };
    agree(comm, threads.and(check_instruction_set()).and(Fault::check()))
}

/// An error where the environment requests an instruction set that nobody knows.
fn check_instruction_set() -> Result<()> {
    let Some(request) = lanes::unknown_request() else { return Ok(()) };
    Err(Error::new(format!("`{request}` is not an instruction set")).at(lanes::VARIABLE).allowed(lanes::SETS))
}

/// Directory, threads, signals; the lock of the directory, on rank 0.
fn prepare(args: &Args, task: &Task, options: &Options, comm: &Comm) -> Result<Option<Lock>> {
    let lock = take_directory(args, task, options, comm)?;
    let cores = workers::usable_cores();
    let threads = match args.threads {
        Some(threads) => threads as usize,
        None => (cores / ranks_on_these_cores(cores, comm)).max(1),
    };
    if threads > cores {
        tracing::warn!(
            "{threads} threads on {cores} usable cores: the launcher may have pinned this rank (--bind-to none)"
        );
    }
    agree(comm, workers::start_threads(threads))?;
    signals::listen();
    Ok(lock)
}

/// The directory, made, and its lock. Collective.
fn take_directory(args: &Args, task: &Task, options: &Options, comm: &Comm) -> Result<Option<Lock>> {
    let folder = &options.directory;
    // Tasks of a study work side by side, and begin whenever they are begun; each has the lock of its point.
    if args.task.is_some() {
        return directory::share(folder, comm).map(|()| None);
    }
    let (work, levels) = match task {
        Task::Study(_) if args.collect => return directory::prepare(folder, true, Work::Tables, comm),
        Task::Study(_) => (Work::Study, 2),
        Task::Scene(scene, _) if scene.threshold.is_some() => (Work::Search, 1),
        Task::Scene(..) => (Work::Run, 0),
    };
    if options.resume {
        directory::require_checkpoint(folder, levels, comm)?;
    }
    directory::prepare(folder, options.resume, work, comm)
}

/// Ranks of this host that share the cores this rank may use: all of them where nothing is pinned, one where the launcher
/// gave each rank cores of its own. Collective.
fn ranks_on_these_cores(cores: usize, comm: &Comm) -> usize {
    let mine = workers::affinity_key();
    let sharing = comm.all_gather(&[mine, cores as u64]).chunks_exact(2).filter(|other| other[0] == mine).count();
    sharing.max(1)
}

/// One line from rank 0, the same code on all ranks.
fn complain(error: &Error, code: i32, comm: &Comm) -> i32 {
    if comm.is_root() {
        log::error(error);
    }
    code
}

/// To the standard output, where somebody still reads it.
fn print(text: &str) -> Result<()> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Error::new(format!("cannot write: {e}")).at("standard output"))
        }
        _ => Ok(()),
    }
}
