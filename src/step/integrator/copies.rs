//! The state at the beginning of a step, kept by an integrator that may refuse it.

use crate::particles::{Chunk, Life, Registry};

/// What the names of the copies end with.
pub const AT_START: &str = "_at_start";

/// A copy of every state column.
#[derive(Debug)]
pub(super) struct Copies {
    /// (state column, its copy).
    pairs: Vec<(usize, usize)>,
}

impl Copies {
    pub fn declare(registry: &mut Registry) -> Self {
        let state = |index: &usize| registry.entries[*index].info.life == Life::State;
        let state: Vec<usize> = (0..registry.entries.len()).filter(state).collect();
        Self { pairs: state.iter().map(|&index| (index, registry.like(index, AT_START, Life::Scratch))).collect() }
    }

    /// The copy of a state column.
    pub fn of(&self, state: usize) -> usize {
        self.pairs.iter().find(|pair| pair.0 == state).expect("a state column").1
    }

    pub fn make(&self, chunk: &Chunk) {
        for &(state, copy) in &self.pairs {
            chunk.words(state).iter().zip(chunk.words(copy)).for_each(|(state, copy)| copy.set(state.get()));
        }
    }

    /// Sets the state back to its copy.
    pub fn restore(&self, chunk: &Chunk) {
        for &(state, copy) in &self.pairs {
            chunk.words(state).iter().zip(chunk.words(copy)).for_each(|(state, copy)| state.set(copy.get()));
        }
    }
}
