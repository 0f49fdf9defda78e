//! A step that could not be made. Numbers that are none are looked for twice in a step: in what the material effects have made
//! of a particle, before any neighbour hears of it, and in its rates, before they act on it. All ranks then know the same
//! particle.

use std::cell::Cell;

use crate::domain::comm::Comm;
use crate::error::Error;
use crate::output::agree;
use crate::particles::ParticleId;

/// Why a step could not be made, on all ranks alike.
#[derive(Debug, Clone, PartialEq)]
pub struct Failure {
    /// The step that failed; 0 is the evaluation of new particles.
    pub step: u64,
    /// Where it began; none where no single particle is to blame.
    pub particle: Option<ParticleId>,
    pub what: String,
}

/// A particle with a number that is none, and which.
#[derive(Debug, Clone, PartialEq)]
pub struct Bad {
    pub id: ParticleId,
    pub what: String,
}

impl Failure {
    /// The failure of the particle with the smallest id that any rank has found. Collective; some rank must have found one.
    pub fn of_ranks(mine: Option<&Bad>, step: u64, comm: &Comm) -> Self {
        let first = comm.all_gather(&[mine.map_or(u64::MAX, |bad| bad.id.0)]).into_iter().fold(u64::MAX, u64::min);
        let told = mine.filter(|bad| bad.id.0 == first).map_or(Ok(()), |bad| Err(Error::new(&bad.what)));
        let what = agree(comm, told).map_or_else(|error| error.what, |()| "a number is none".to_string());
        Self { step, particle: Some(ParticleId(first)), what }
    }

    /// For the person at the terminal, with the names of the bodies.
    pub fn error<'a>(&self, name: impl Fn(usize) -> &'a str) -> Error {
        let step = format!("step {}", self.step);
        Error::new(&self.what).at(match self.particle {
            Some(id) => format!("{step}, particle {} of body {}", id.site(), name(id.body())),
            None => step,
        })
    }
}

impl Bad {
    /// The one with the smaller id.
    pub fn first(a: Option<Self>, b: Option<Self>) -> Option<Self> {
        match (a, b) {
            (Some(a), Some(b)) => Some(if a.id <= b.id { a } else { b }),
            (a, b) => a.or(b),
        }
    }
}

/// Bits of the exponent; all of them are set in infinities and in what is no number.
const EXPONENT: u64 = 0x7ff << 52;

/// Whether all words are finite numbers. One pass without a branch, over numbers that are in cache.
pub fn finite(words: &[Cell<u64>]) -> bool {
    let carried = words.iter().fold(0, |any, word| any | ((word.get() & EXPONENT) + (1 << 52)));
    carried >> 63 == 0
}

/// As [`finite`].
pub fn all_finite(numbers: &[f64]) -> bool {
    let carried = numbers.iter().fold(0, |any, x| any | ((x.to_bits() & EXPONENT) + (1 << 52)));
    carried >> 63 == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_told_from_what_is_none() {
        let whole = [0.0, -0.0, 5e-324, -1.5, f64::MAX, f64::MIN];
        assert!(all_finite(&whole));
        for bad in [f64::NAN, -f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::from_bits(0x7ff0_0000_0000_0001)] {
            for at in 0..whole.len() {
                let mut numbers = whole;
                numbers[at] = bad;
                assert!(!all_finite(&numbers) && !finite(&numbers.map(|x| Cell::new(x.to_bits()))), "{bad} at {at}");
            }
        }
    }

    #[test]
    fn a_failure_names_step_particle_and_body() {
        let failure = Failure { step: 7, particle: Some(ParticleId::new(1, 42)), what: "it is none".into() };
        let text = failure.error(|body| ["target", "projectile"][body]).to_string();
        assert_eq!(text, "step 7, particle 42 of body projectile: it is none");
        assert_eq!(Failure { particle: None, ..failure }.error(|_| "").to_string(), "step 7: it is none");
    }
}
