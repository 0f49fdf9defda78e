//! The command line.

use std::path::{Path, PathBuf};

use clap::{Parser, Subcommand};

use crate::study::settings;

const EXAMPLES: &str = "\
Examples:
  mpirun -n 2 sph-mpi inputs/qd_star.toml
      run a scene, here the search for a disruption threshold, on two ranks
  sph-mpi inputs/qd_star.toml --check --ranks 8
      validate the scene and say what it will cost on eight ranks; nothing runs
  sph-mpi inputs/impact.toml --check --ranks 1024 --latency 1.5e-6 --bandwidth 3e9
      the same for a network that is not this machine's
  sph-mpi inputs/impact.toml --set target.particles=200000 --set 'projectile.radius=2 km' --out runs/hires
      the same scene with other values, into another directory
  sph-mpi inputs/impact.toml --set material.basalt.fracture=false
      without one of its effects
  mpirun -n 2 sph-mpi inputs/studies/sod.toml
      a study: error against cost over settings and resolutions of another scene
  sph-mpi inputs/exact/sod.toml --accuracy 2%
      the scene with the cheapest setting that a stored study of it knows for that error
  mpirun -n 4 sph-mpi inputs/impact.toml --resume
      go on from the newest whole checkpoint, on any number of ranks
  sph-mpi inputs/impact.toml --resume --set 'run.until=40 s'
      take a run that has ended further

  sph-mpi report runs/impact
      look at a run in a browser: writes runs/impact/report.html, also while it runs
  sph-mpi --keys body
      every key of a table, with unit, default and what is allowed; --keys alone lists the tables

In --set, a body is addressed by its name and its shape's keys follow directly (projectile.radius).
Ctrl-C, SIGTERM, SIGHUP and SIGUSR1 end a run with a checkpoint. RUST_LOG sets what is logged (error, warn, info, debug).";

/// A hydrocode for impacts into strong, brittle, porous and dusty bodies, distributed with MPI.
#[derive(Debug, Clone, PartialEq, Parser)]
#[command(name = "sph-mpi", version, about, after_help = EXAMPLES)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub struct Args {
    #[command(subcommand)]
    pub command: Option<Command>,

    /// Scene file (TOML).
    #[arg(required_unless_present_any = ["keys", "schema"])]
    pub scene: Option<PathBuf>,

    /// Print the keys of a table of scenes or studies, e.g. body or material.porosity [default: list the tables].
    #[arg(long, value_name = "TABLE", num_args = 0..=1, default_missing_value = "", exclusive = true)]
    pub keys: Option<String>,

    /// Print the JSON Schema of scenes, or that of studies.
    #[arg(long, value_name = "scene|study", num_args = 0..=1, default_missing_value = "scene", exclusive = true)]
    pub schema: Option<String>,

    /// Validate the scene and say what it will cost: effects, columns, bytes per particle, ghosts, time.
    #[arg(long)]
    pub check: bool,

    /// Replace a value of the scene, or remove a table with KEY=false; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub overrides: Vec<String>,

    /// Directory for the run's files [default: `runs/SCENE`]. A run that stands there is renamed, other files are left alone.
    #[arg(long, value_name = "DIRECTORY")]
    pub out: Option<PathBuf>,

    /// Go on from the newest whole checkpoint in the run's directory; end, output and title may be others than before.
    #[arg(long, conflicts_with = "check")]
    pub resume: bool,

    /// Threads per rank [default: the cores that the rank may use].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub threads: Option<u16>,

    /// Choose the setting that a study of the scene found to be the cheapest with this error, e.g. 1%.
    #[arg(long, value_name = "ERROR", value_parser = accuracy)]
    pub accuracy: Option<f64>,

    /// Run one point of a study alone, as a task of a job array.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub task: Option<u32>,

    /// Write tables and figures of a study from the points that are there, and run none.
    #[arg(long, conflicts_with_all = ["task", "check", "resume"])]
    pub collect: bool,

    /// List the points of a study, one a line, and end.
    #[arg(long, conflicts_with_all = ["task", "check", "resume", "collect"])]
    pub points: bool,

    /// Ranks that --check estimates for [default: the ranks it runs on].
    #[arg(long, value_name = "N", requires = "check", value_parser = clap::value_parser!(u32).range(1..))]
    pub ranks: Option<u32>,

    /// Seconds for a short message between ranks, for --check of another network [default: measured on two ranks and more].
    #[arg(long, value_name = "SECONDS", requires = "check", requires = "bandwidth", value_parser = positive)]
    pub latency: Option<f64>,

    /// Bytes per second that a rank can send, all ranks of a machine at once; with --latency.
    #[arg(long, value_name = "BYTES", requires = "check", requires = "latency", value_parser = positive)]
    pub bandwidth: Option<f64>,

    /// Write trace.json of each run: what each rank does when, for chrome://tracing or ui.perfetto.dev.
    #[arg(long, conflicts_with_all = ["check", "collect", "points"])]
    pub trace: bool,

    /// Print nothing but errors.
    #[arg(long, short)]
    pub quiet: bool,
}

/// What the program does beside running scenes.
#[derive(Debug, Clone, PartialEq, Subcommand)]
pub enum Command {
    /// Write report.html into the directory of a run, search or study: it opens in a browser, and needs nothing else.
    Report {
        /// The directory of the run, which may go on meanwhile.
        directory: PathBuf,
    },
}

impl Args {
    /// The scene file; empty where none is needed.
    pub fn scene(&self) -> &Path {
        self.scene.as_deref().unwrap_or(Path::new(""))
    }
}

fn positive(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| "not a number".to_string())?;
    if value > 0.0 && value.is_finite() { Ok(value) } else { Err("more than 0 is allowed".into()) }
}

fn accuracy(text: &str) -> Result<f64, String> {
    settings::accuracy(text).map_err(|what| format!("{what}; allowed: {}", settings::ACCURACIES))
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    fn parse(line: &str) -> Result<Args, clap::Error> {
        Args::try_parse_from(line.split_whitespace())
    }

    #[test]
    fn definitions_are_consistent() {
        Args::command().debug_assert();
    }

    #[test]
    fn arguments() {
        let args = parse("sph-mpi a.toml --set x=1 --set y.z=2 --out d --threads 2 --resume").unwrap();
        assert_eq!(args.overrides, ["x=1", "y.z=2"]);
        assert_eq!((args.threads, args.resume, args.check), (Some(2), true, false));
        assert_eq!(parse("sph-mpi a.toml --check --ranks 8").unwrap().ranks, Some(8));
        let network = parse("sph-mpi a.toml --check --latency 2e-6 --bandwidth 1e10").unwrap();
        assert_eq!((network.latency, network.bandwidth), (Some(2e-6), Some(1e10)));
        assert_eq!(parse("sph-mpi a.toml --accuracy 1%").unwrap().accuracy, Some(0.01));
        assert_eq!(parse("sph-mpi --keys").unwrap().keys.as_deref(), Some(""));
        assert_eq!(parse("sph-mpi --keys body.shape").unwrap().keys.as_deref(), Some("body.shape"));
        assert_eq!(parse("sph-mpi --schema").unwrap().schema.as_deref(), Some("scene"));
        let report = parse("sph-mpi report runs/impact").unwrap();
        assert_eq!(report.command, Some(Command::Report { directory: "runs/impact".into() }));
        for bad in [
            "sph-mpi",
            "sph-mpi report",
            "sph-mpi a report b",
            "sph-mpi --quiet report b",
            "sph-mpi a --threads 0",
            "sph-mpi a --ranks 2",
            "sph-mpi a --check --resume",
            "sph-mpi a --latency 1e-6",
            "sph-mpi a --check --latency 1e-6",
            "sph-mpi a --check --latency 1e-6 --bandwidth 0",
            "sph-mpi a b",
            "sph-mpi a --keys",
            "sph-mpi --keys body --check",
            "sph-mpi a --accuracy good",
            "sph-mpi a --accuracy 0%",
            "sph-mpi a --task 0",
            "sph-mpi a --task 1 --collect",
        ] {
            assert!(parse(bad).is_err(), "{bad}");
        }
    }
}
