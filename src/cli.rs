//! The command line.

use std::path::PathBuf;

use clap::Parser;

const EXAMPLES: &str = "\
Examples:
  mpirun -n 2 sph-mpi inputs/qd_star.toml
      run a scene, here the search for a disruption threshold, on two ranks
  sph-mpi inputs/qd_star.toml --check --ranks 8
      validate the scene and say what it will cost on eight ranks; nothing runs
  sph-mpi inputs/impact.toml --set target.particles=200000 --set 'projectile.radius=2 km' --out runs/hires
      the same scene with other values, into another directory
  sph-mpi inputs/impact.toml --set material.basalt.fracture=false
      without one of its effects
  mpirun -n 4 sph-mpi inputs/impact.toml --resume
      go on from the newest whole checkpoint, on any number of ranks

In --set, a body is addressed by its name and its shape's keys follow directly (projectile.radius).
SIGTERM and SIGUSR1 end a run with a checkpoint. RUST_LOG sets what is logged (error, warn, info, debug).";

/// A hydrocode for impacts into strong, brittle, porous and dusty bodies, distributed with MPI.
#[derive(Debug, Clone, PartialEq, Parser)]
#[command(name = "sph-mpi", version, about, after_help = EXAMPLES)]
pub struct Args {
    /// Scene file (TOML).
    pub scene: PathBuf,

    /// Validate the scene and say what it will cost: effects, columns, bytes per particle, ghosts, time.
    #[arg(long)]
    pub check: bool,

    /// Replace a value of the scene, or remove a table with KEY=false; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub overrides: Vec<String>,

    /// Directory for the run's files [default: runs/<scene>]. A finished run that stands there is renamed, never overwritten.
    #[arg(long, value_name = "DIRECTORY")]
    pub out: Option<PathBuf>,

    /// Go on from the newest whole checkpoint in the run's directory.
    #[arg(long, conflicts_with = "check")]
    pub resume: bool,

    /// Threads per rank [default: the cores that the rank may use].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub threads: Option<u16>,

    /// Ranks that --check estimates for [default: the ranks it runs on].
    #[arg(long, value_name = "N", requires = "check", value_parser = clap::value_parser!(u32).range(1..))]
    pub ranks: Option<u32>,

    /// Print nothing but errors.
    #[arg(long, short)]
    pub quiet: bool,
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
        for bad in
            ["sph-mpi", "sph-mpi a --threads 0", "sph-mpi a --ranks 2", "sph-mpi a --check --resume", "sph-mpi a b"]
        {
            assert!(parse(bad).is_err(), "{bad}");
        }
    }
}
