//! Faults on demand, for tests: `SPH_MPI_FAULT=panic:RANK:STEP` panics on that rank at that step, `pool:RANK:STEP` does so on
//! the other threads of its pool, `kill:RANK:STEP` ends the process there without a word, `stop:RANK:STEP` behaves as if SIGTERM had come. Costs one comparison per step.

/// What is to happen on this rank, and when.
#[derive(Debug, Clone, Copy, Default)]
pub struct Fault {
    kind: Option<Kind>,
    step: u64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    Panic,
    Pool,
    Kill,
    Stop,
}

impl Fault {
    /// The fault that the environment asks of this rank.
    pub fn of_rank(rank: usize) -> Self {
        let text = std::env::var("SPH_MPI_FAULT").unwrap_or_default();
        let mut parts = text.split(':');
        let kind = match parts.next() {
            Some("panic") => Kind::Panic,
            Some("pool") => Kind::Pool,
            Some("kill") => Kind::Kill,
            Some("stop") => Kind::Stop,
            _ => return Self::default(),
        };
        let mut number = || parts.next().and_then(|n| n.parse::<u64>().ok());
        match (number(), number()) {
            (Some(r), Some(step)) if r == rank as u64 => Self { kind: Some(kind), step },
            _ => Self::default(),
        }
    }

    /// Strikes when its step has come; true where a stop is asked for.
    pub fn strike(&self, step: u64) -> bool {
        if self.kind.is_none() || step != self.step {
            return false;
        }
        match self.kind {
            Some(Kind::Panic) => panic!("a panic was asked for at step {step}"),
            Some(Kind::Pool) => {
                rayon::broadcast(|thread| assert_eq!(thread.index(), 0, "a panic was asked for at step {step}"));
                false
            }
            Some(Kind::Kill) => {
                // SAFETY: ends this process.
                unsafe { libc::raise(libc::SIGKILL) };
                false
            }
            _ => true,
        }
    }
}
