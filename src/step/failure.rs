//! A step that could not be made. Non-finite numbers are looked for twice in a stage: in a particle's columns after the material
//! effects, before they reach any neighbour, and in its rates, before they act on it. All ranks then know the same particle.

use super::settings::StepSettings;
use crate::domain::comm::Comm;
use crate::error::Error;
use crate::material::Local;
use crate::output::agree;
use crate::particles::columns::Entry;
use crate::particles::rates::{finite, words_of};
use crate::particles::{Chunk, ColumnShape, Life, ParticleId, Registry, View};

/// Why a step could not be made, on all ranks alike.
#[derive(Debug, Clone, PartialEq)]
pub struct Failure {
    /// The step that failed; 0 is the evaluation of new particles.
    pub step: u64,
    /// The particle where it began; `None` where there is no single one.
    pub particle: Option<ParticleId>,
    pub what: String,
}

/// A particle with a non-finite number, and which number.
#[derive(Debug, Clone, PartialEq)]
pub struct NonFinite {
    pub id: ParticleId,
    pub what: String,
}

impl Failure {
    /// The failure of the particle with the smallest id that any rank has found. Collective; some rank must have found one.
    pub fn of_ranks(mine: Option<&NonFinite>, step: u64, comm: &Comm) -> Self {
        let first = comm.all_gather(&[mine.map_or(u64::MAX, |found| found.id.0)]).into_iter().fold(u64::MAX, u64::min);
        let reported = mine.filter(|found| found.id.0 == first).map_or(Ok(()), |found| Err(Error::new(&found.what)));
        let what = agree(comm, reported).map_or_else(|error| error.what, |()| "a number is not finite".to_string());
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

impl NonFinite {
    /// The one with the smaller id.
    pub fn first(a: Option<Self>, b: Option<Self>) -> Option<Self> {
        match (a, b) {
            (Some(a), Some(b)) => Some(if a.id <= b.id { a } else { b }),
            (a, b) => a.or(b),
        }
    }
}

/// The columns that are checked after the effects have acted: those of snapshots and those that follow from the state. Others are
/// rates, which are checked when they are made, and values of earlier moments.
pub struct Watched(Vec<(usize, Entry)>);

impl Watched {
    pub fn new(registry: &Registry) -> Self {
        let is_watched = |entry: &Entry| {
            entry.shape != ColumnShape::Id
                && entry.owner != "integrator"
                && (entry.info.snapshot || entry.info.life == Life::Scratch)
        };
        let entries = registry.entries.iter().enumerate().filter(|(_, entry)| is_watched(entry));
        Self(entries.map(|(index, entry)| (index, entry.clone())).collect())
    }

    /// Notes the first particle of a chunk with a non-finite number in `found`, unless one of a smaller id is there.
    pub fn look(&self, chunk: &Chunk, ids: &View<ParticleId>, found: &mut Option<NonFinite>) {
        if self.0.iter().all(|(index, _)| finite(chunk.words(*index))) {
            return;
        }
        for (index, entry) in &self.0 {
            let words = chunk.words(*index);
            let bad = (0..chunk.len()).filter(|&k| !finite(&words[k * entry.width..(k + 1) * entry.width]));
            let what =
                || format!("its {} is not finite after the effects have acted (owner: {})", entry.name, entry.owner);
            let bad = bad.map(|k| ids.get(k)).min().map(|id| NonFinite { id, what: what() });
            *found = NonFinite::first(found.take(), bad);
        }
    }
}

/// The first particle with a rate that is not finite, and which of the causes in their order: the forces of its neighbours,
/// their motion, or the effect that makes its rates non-finite.
pub fn first_non_finite_rate(settings: &StepSettings, registry: &Registry, local: &Local) -> Option<NonFinite> {
    let (n, dimension, rates) = (local.len(), registry.dimension, local.rates);
    let mut found = None;
    let mut note = |k: usize, what: &dyn Fn() -> String| {
        let id = local.view(settings.view.core.id).get(k);
        if found.as_ref().is_none_or(|bad: &NonFinite| id < bad.id) {
            found = Some(NonFinite { id, what: what() });
        }
    };
    for k in 0..n {
        let flow = &local.flow[k];
        let gradient = flow.velocity_gradient.as_slice();
        if !finite(words_of(&rates.acceleration[k * dimension..(k + 1) * dimension])) {
            note(k, &|| "the forces of its neighbours add up to an acceleration that is not finite".into());
        } else if !(gradient.iter().all(|x| x.is_finite()) && flow.heating.is_finite()) {
            note(k, &|| "the motion of its neighbours gives a velocity gradient that is not finite".into());
        }
    }
    // Effects fill the rates once more, one after another.
    rates.clear();
    for effect in &settings.effects {
        effect.rates(local);
        for (slot, &value) in registry.integrated.iter().enumerate() {
            for k in (0..n).filter(|&k| !finite(rates.of_particle(slot, k))) {
                let name = &registry.entries[value].name;
                note(k, &|| format!("effect `{}` makes a rate of {name} that is not finite", effect.name()));
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failure_names_step_particle_and_body() {
        let failure = Failure { step: 7, particle: Some(ParticleId::new(1, 42)), what: "it is not finite".into() };
        let text = failure.error(|body| ["target", "projectile"][body]).to_string();
        assert_eq!(text, "step 7, particle 42 of body projectile: it is not finite");
        assert_eq!(Failure { particle: None, ..failure }.error(|_| "").to_string(), "step 7: it is not finite");
    }
}
