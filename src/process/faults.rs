//! Faults on demand, for tests: `SPH_MPI_FAULT=KIND:RANK:STEP` happens on that rank in that step. Costs one comparison per step.
//!
//! - `panic` panics there, `pool` on the other threads of the rank's pool, `kill` ends the process without a message;
//! - `stop` behaves as if SIGTERM had come;
//! - `nan` makes a rate of one particle NaN;
//! - `memory` requests more memory than there are addresses;
//! - `full` lets no file of the rank grow any more, `full_in_checkpoint` requests a checkpoint at that moment;
//! - `kill_in_write`, `term_in_write` request a checkpoint and raise SIGKILL or SIGTERM during the data of the next file, and
//!   `kill_before_rename` when that file is complete, but still has its temporary name.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::error::{Error, Result};
use crate::material::{Core, Local, MaterialEffect, Setup};
use crate::output::moment::{self, Moment};
use crate::particles::{Integrated, Registry};

/// Files cannot grow beyond this many bytes where a full disk is simulated: less than any checkpoint, more than a log.
const FULL: libc::rlim_t = 1 << 16;

/// The fault of this rank and its step.
#[derive(Debug, Clone, Default)]
pub struct Fault {
    kind: Option<Kind>,
    /// Whether the fault is this rank's.
    mine: bool,
    step: u64,
    /// Set when a rate is to become NaN.
    poisoned: Arc<AtomicBool>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    Panic,
    Pool,
    Kill,
    Stop,
    Nan,
    Memory,
    Full,
    FullInCheckpoint,
    KillInWrite,
    TermInWrite,
    KillBeforeRename,
}

/// What a fault requests of the run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Trigger {
    Nothing,
    Checkpoint,
    Stop,
}

const VARIABLE: &str = "SPH_MPI_FAULT";

fn requested() -> String {
    std::env::var_os(VARIABLE).unwrap_or_default().to_string_lossy().into_owned()
}

impl Fault {
    /// The fault that the environment requests, for this rank.
    pub fn of_rank(rank: usize) -> Self {
        Self::parse(&requested(), rank).unwrap_or_default()
    }

    /// An error where the environment requests an unknown fault.
    pub fn check() -> Result<()> {
        let text = requested();
        if text.is_empty() || Self::parse(&text, 0).is_some() {
            return Ok(());
        }
        let allowed = "KIND:RANK:STEP, with one of panic, pool, kill, stop, nan, full, full_in_checkpoint, kill_in_write, \
                       term_in_write, kill_before_rename";
        Err(Error::new(format!("`{text}` is not a fault")).at(VARIABLE).allowed(allowed))
    }

    fn parse(text: &str, rank: usize) -> Option<Self> {
        let mut parts = text.split(':');
        let kind = match parts.next()? {
            "panic" => Kind::Panic,
            "pool" => Kind::Pool,
            "kill" => Kind::Kill,
            "stop" => Kind::Stop,
            "nan" => Kind::Nan,
            "memory" => Kind::Memory,
            "full" => Kind::Full,
            "full_in_checkpoint" => Kind::FullInCheckpoint,
            "kill_in_write" => Kind::KillInWrite,
            "term_in_write" => Kind::TermInWrite,
            "kill_before_rename" => Kind::KillBeforeRename,
            _ => return None,
        };
        let (on, step) = (parts.next()?.parse::<usize>().ok()?, parts.next()?.parse().ok()?);
        if parts.next().is_some() {
            return None;
        }
        Some(Self { kind: Some(kind), mine: on == rank, step, ..Self::default() })
    }

    /// The effect by which a rate becomes NaN; `None` where no such fault is requested. The same on all ranks.
    pub fn effect(&self, core: &Core) -> Option<Box<dyn MaterialEffect>> {
        let poison = || Poison { density: core.density, poisoned: Arc::clone(&self.poisoned) };
        (self.kind == Some(Kind::Nan)).then(|| Box::new(poison()) as Box<dyn MaterialEffect>)
    }

    /// Triggers the fault, if it is due in this step; returns what it requests of the run.
    pub fn trigger(&self, step: u64) -> Trigger {
        let Some(kind) = self.kind.filter(|_| self.mine && step == self.step) else { return Trigger::Nothing };
        match kind {
            Kind::Panic => panic!("a panic was requested at step {step}"),
            Kind::Pool => {
                rayon::broadcast(|thread| assert_eq!(thread.index(), 0, "a panic was requested at step {step}"));
            }
            // SAFETY: ends this process.
            Kind::Kill => drop(unsafe { libc::raise(libc::SIGKILL) }),
            Kind::Stop => return Trigger::Stop,
            Kind::Nan => self.poisoned.store(true, Ordering::Relaxed),
            Kind::Memory => drop(std::hint::black_box(Vec::<u8>::with_capacity(isize::MAX as usize))),
            Kind::Full | Kind::FullInCheckpoint => {
                let limit = libc::rlimit { rlim_cur: FULL, rlim_max: libc::RLIM_INFINITY };
                // SAFETY: reads the structure that it is given.
                unsafe { libc::setrlimit(libc::RLIMIT_FSIZE, &limit) };
            }
            Kind::KillInWrite => moment::arm(Moment::Writing, libc::SIGKILL),
            Kind::TermInWrite => moment::arm(Moment::Writing, libc::SIGTERM),
            Kind::KillBeforeRename => moment::arm(Moment::Written, libc::SIGKILL),
        }
        let elsewhere = [Kind::Panic, Kind::Pool, Kind::Kill, Kind::Stop, Kind::Nan, Kind::Memory, Kind::Full];
        if elsewhere.contains(&kind) { Trigger::Nothing } else { Trigger::Checkpoint }
    }
}

/// Makes the rate of density of a rank's first particle NaN, once it is enabled.
struct Poison {
    density: Integrated<f64>,
    poisoned: Arc<AtomicBool>,
}

impl MaterialEffect for Poison {
    fn declare(_setup: &Setup, _registry: &mut Registry, _core: &Core) -> Result<Option<Self>> {
        Ok(None)
    }

    fn name(&self) -> &'static str {
        "fault"
    }

    fn rates(&self, local: &Local) {
        if local.chunk.range.start == 0 && self.poisoned.load(Ordering::Relaxed) {
            local.rate(self.density).set(0, f64::NAN);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fault_strikes_on_its_rank_in_its_step() {
        let fault = Fault::parse("stop:1:7", 1).unwrap();
        assert_eq!(
            (fault.trigger(6), fault.trigger(7), fault.trigger(8)),
            (Trigger::Nothing, Trigger::Stop, Trigger::Nothing)
        );
        assert_eq!(Fault::parse("stop:1:7", 0).unwrap().trigger(7), Trigger::Nothing);
        assert!(Fault::parse("nonsense:1:7", 0).is_none() && Fault::parse("stop:1", 0).is_none());
    }
}
