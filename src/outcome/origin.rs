//! The fate of each body: shares of its own matter, wherever it ended. A fragment or an aggregate belongs to a body by the share of
//! that body's matter that it holds; aggregates of several bodies are reported under each.

use super::evaluation::{Evaluation, Origin, Remnants, counted};
use super::particle::{LINK_DAMAGE, Particle};
use super::piece::{Piece, Question};
use super::tally::{Scale, all_values};
use super::{bound, fragments};
use crate::domain::comm::Comm;
use crate::math::ExactSum;

/// Bodies beside target and projectile that are reported; each costs a search.
const MOST_OTHERS: usize = 8;

/// The fates of target, projectile and the first others of the scene; `masses` of all its bodies, kg. Collective.
pub fn by_body(
    comm: &Comm,
    particles: &[Particle],
    evaluation: &Evaluation,
    question: &Question,
    masses: &[f64],
) -> Vec<Origin> {
    let others = (0..masses.len()).filter(|body| !question.bodies.contains(body)).take(MOST_OTHERS);
    let mut bodies: Vec<usize> = question.bodies.iter().copied().chain(others).collect();
    bodies.sort_unstable();
    let labels = fragments::labels(comm, particles, fragments::Link::Intact(LINK_DAMAGE));
    let scale = Scale::agree(comm, particles);
    let tell = |&body: &usize| {
        // Only this body is evaluated.
        let alone = Question { bodies: [body, usize::MAX], others: true, target_mass: masses[body], ..*question };
        let pieces = fragments::pieces(comm, &scale, particles, &labels, alone.bodies);
        shares(comm, pieces, evaluation, &alone)
    };
    bodies.iter().map(tell).collect()
}

/// `pieces`: those of the evaluation, in the same order, with the matter of one body summed apart.
fn shares(comm: &Comm, pieces: Vec<Piece>, evaluation: &Evaluation, alone: &Question) -> Origin {
    let held = |members: &[bool]| {
        let mut sum = [ExactSum::new()];
        pieces.iter().zip(members).filter(|(_, member)| **member).for_each(|(piece, _)| sum[0].add(piece.of[0]));
        all_values(comm, &mut sum)[0]
    };
    let fragments = (0..pieces.len()).filter(|&i| pieces[i].count > 1 && pieces[i].of[0] > 0.0);
    let fragment = bound::best(comm, &pieces, fragments.map(|i| (pieces[i].of[0], i)));
    let fragment = counted(comm, &pieces, fragment, alone);
    let (all, in_largest) = (held(&vec![true; pieces.len()]), held(&evaluation.in_largest));
    // What holds more than half of it holds most of it.
    let remnant = if in_largest > 0.5 * all { in_largest } else { Remnants::among(comm, pieces, alone).mass };
    let share = |mass: f64| mass / alone.target_mass;
    Origin {
        body: alone.bodies[0],
        in_largest_remnant: share(in_largest),
        remnant: share(remnant.max(in_largest)),
        fragment: share(fragment),
    }
}
