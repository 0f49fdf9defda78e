//! The program: arguments, one scene for all ranks, the run it asks for, and one place that prints errors.

use clap::Parser;

use crate::campaigns::{cost, search};
use crate::cli::Args;
use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::output::{agree, collective};
use crate::scene::{self, Scene};
use crate::simulation::{self, Ended, Options, log, resources, run::default_directory, signals};
use crate::step::workers;

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
        Ok(args) => on_all_ranks(&args, resident_at_start, &comm),
        Err(error) => {
            if comm.is_root() {
                let _ = error.print();
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

fn on_all_ranks(args: &Args, resident_at_start: f64, comm: &Comm) -> i32 {
    log::start(comm.rank(), args.quiet);
    resources::hold_memory();
    let scene = match read_scene(args, comm) {
        Ok(scene) => scene,
        Err(error) => return complain(&error, BAD_INPUT, comm),
    };
    if args.check {
        let ranks = args.ranks.unwrap_or(comm.size() as u32) as usize;
        let network = args.latency.zip(args.bandwidth);
        let started = agree(comm, workers::start_threads(1));
        return match started.and_then(|()| cost::check(&scene, ranks, network, comm)) {
            Ok(text) => {
                if comm.is_root() {
                    print!("{text}");
                }
                0
            }
            Err(error) => complain(&error, BAD_INPUT, comm),
        };
    }
    let options = Options {
        directory: args.out.clone().unwrap_or_else(|| default_directory(&scene)),
        resume: args.resume,
        resident_at_start,
    };
    if let Err(error) = prepare(args, &options, comm) {
        return complain(&error, BAD_INPUT, comm);
    }
    let ended = match &scene.threshold {
        Some(_) => search::run(&scene, &options, comm),
        None => simulation::run(&scene, &options, comm).map(|report| report.ended),
    };
    match ended {
        Ok(Ended::Finished) => 0,
        Ok(Ended::Interrupted) => INTERRUPTED,
        Err(error) => complain(&error, if error.bad_input { BAD_INPUT } else { FAILED }, comm),
    }
}

/// Rank 0 reads; all ranks get the same scene or the same error.
fn read_scene(args: &Args, comm: &Comm) -> Result<Scene> {
    let mut bytes = Vec::new();
    if comm.is_root() {
        let read = scene::read(&args.scene, &args.overrides);
        bytes = serde_json::to_vec(&read).map_err(|e| Error::new(e.to_string()))?;
    }
    comm.broadcast(&mut bytes);
    let read: Result<Scene> = serde_json::from_slice(&bytes).map_err(|e| Error::new(e.to_string()))?;
    read
}

/// Directory, threads, signals.
fn prepare(args: &Args, options: &Options, comm: &Comm) -> Result<()> {
    if options.resume {
        simulation::directory::require_checkpoint(&options.directory, comm)?;
    }
    simulation::directory::prepare(&options.directory, options.resume, comm)?;
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
    Ok(())
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
        eprintln!("error: {error}");
    }
    code
}
