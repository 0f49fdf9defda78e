//! Which particles belong to the largest remnant.

use std::collections::BTreeSet;

use super::evaluation::Evaluation;
use super::fragments;
use super::particle::Particle;
use crate::domain::comm::Comm;

/// Which of this rank's particles belong to the largest remnant. Collective.
pub fn members(comm: &Comm, particles: &[Particle], evaluation: &Evaluation) -> Vec<bool> {
    let chosen: BTreeSet<u64> = evaluation
        .pieces
        .iter()
        .zip(&evaluation.in_largest)
        .filter(|(_, member)| **member)
        .map(|(piece, _)| piece.label)
        .collect();
    let own = evaluation.labels.iter().flatten().copied().collect();
    let fragments = fragments::chosen_of(comm, &chosen, &own);
    // Loose particles are pieces where they are.
    let belongs = |(particle, label): (&Particle, &Option<u64>)| match label {
        Some(label) => fragments.contains(label),
        None => chosen.contains(&particle.id),
    };
    particles.iter().zip(&evaluation.labels).map(belongs).collect()
}
