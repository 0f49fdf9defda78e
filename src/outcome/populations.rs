//! What has become of one body or of two that have collided, as four populations: the largest piece, the second largest, pieces whose
//! masses follow a power law, and the rest, which is too small to be resolved; and, of two bodies, one word.
//!
//! ```text
//! piece           particles that are linked, directly or through others, by less than a link length (the kernel's support, if the scene
//!                 gives none: they would act on each other)
//! kept            of each body, the largest share of its own matter that lies in one piece
//! fragmentation   a body has kept less than `intact`
//! sticking        else, both lie in the same piece
//! bouncing        else
//! ```
//! Link length as in Geretshauser et al. 2010 (A&A 513, A58, Sect. 5.3); populations after Geretshauser et al. 2011 (A&A 531, A166).

use std::fmt::{self, Write};

use super::bound;
use super::distributions::{MAX_LISTED, least_listed, rank_of};
use super::fragments::{self, LINK, Link};
use super::particle::Particle;
use super::piece::Piece;
use super::power_law;
pub use super::power_law::PowerLaw;
use super::tally::{Scale, all_values};
use crate::domain::comm::Comm;
use crate::math::ExactSum;

/// What is asked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Question {
    /// One body, or two that collide.
    pub bodies: [usize; 2],
    /// m.
    pub link: f64,
    /// Particles of a piece whose mass counts as resolved.
    pub least_particles: u64,
    /// Share of its matter that a body must keep together to count as whole.
    pub intact: f64,
}

/// One word for a collision.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Word {
    Sticking,
    Bouncing,
    Fragmentation,
}

impl fmt::Display for Word {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Word::Sticking => "sticking",
            Word::Bouncing => "bouncing",
            Word::Fragmentation => "fragmentation",
        })
    }
}

impl Word {
    /// `kept`: by each body, `together`: whether both in the same piece.
    fn of(kept: [f64; 2], together: bool, intact: f64) -> Self {
        match (kept.iter().all(|kept| *kept >= intact), together) {
            (false, _) => Word::Fragmentation,
            (true, true) => Word::Sticking,
            (true, false) => Word::Bouncing,
        }
    }
}

/// A piece of the list.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Listed {
    /// kg.
    pub mass: f64,
    pub particles: u64,
}

/// The same on all ranks.
#[derive(Debug, Clone, PartialEq)]
pub struct Populations {
    /// Of all pieces, kg.
    pub total: f64,
    /// The largest pieces, at most [`MAX_LISTED`], by falling mass.
    pub pieces: Vec<Listed>,
    /// Of the listed, how many are resolved.
    pub resolved: usize,
    pub law: Option<PowerLaw>,
    pub kept: [f64; 2],
    /// Of two bodies.
    pub word: Option<Word>,
}

/// `particles`: those of the bodies in question. Collective.
pub fn evaluate(comm: &Comm, particles: &[Particle], question: &Question) -> Populations {
    // Links have LINK times this length.
    let spacing = question.link / LINK;
    let linked: Vec<Particle> =
        particles.iter().map(|particle| Particle { spacing, damage: 0.0, ..*particle }).collect();
    let scale = Scale::agree(comm, &linked);
    let labels = fragments::labels(comm, &linked, Link::Intact(1.0));
    let pieces = fragments::pieces(comm, &scale, &linked, &labels, question.bodies);
    let mut sums = [const { ExactSum::new() }; 3];
    for piece in &pieces {
        let masses = [piece.mass, piece.of[0], piece.of[1]];
        sums.iter_mut().zip(masses).for_each(|(sum, mass)| sum.add(mass));
    }
    let [total, a, b] = all_values(comm, &mut sums);
    let of = [a, b];
    let mut kept = [0, 1].map(|k| pieces.iter().fold(0.0, |most: f64, piece| most.max(piece.of[k])));
    comm.all_max(&mut kept);
    let homes = [0, 1].map(|k| bound::best(comm, &pieces, (0..pieces.len()).map(|i| (pieces[i].of[k], i))));
    let kept = [0, 1].map(|k| kept[k] / of[k]);
    let two = question.bodies[0] != question.bodies[1];
    let word = two.then(|| Word::of(kept, homes[0] == homes[1], question.intact));
    let pieces = listed(comm, &pieces);
    let resolved = pieces.iter().position(|piece| piece.particles < question.least_particles).unwrap_or(pieces.len());
    let masses: Vec<f64> = pieces[..resolved].iter().map(|piece| piece.mass).collect();
    Populations { total, law: power_law::fit(&masses, total), pieces, resolved, kept, word }
}

/// The largest pieces of all ranks, on all ranks.
fn listed(comm: &Comm, pieces: &[Piece]) -> Vec<Listed> {
    let least = least_listed(comm, pieces.iter().map(rank_of).collect(), MAX_LISTED);
    let chosen = pieces.iter().filter(|piece| rank_of(piece) >= least);
    let words: Vec<u64> = chosen.flat_map(|piece| [piece.label, piece.mass.to_bits(), piece.count]).collect();
    let received = comm.sparse_exchange(if words.is_empty() { Vec::new() } else { vec![(0, words)] });
    let mut records: Vec<&[u64]> = received.iter().flat_map(|(_, words)| words.chunks_exact(3)).collect();
    records.sort_by_key(|record| (std::cmp::Reverse(record[1]), record[0]));
    let mut bytes: Vec<u8> = records.iter().flat_map(|record| bytemuck::cast_slice(&record[1..]).to_vec()).collect();
    comm.broadcast(&mut bytes);
    let words: Vec<u64> = bytemuck::pod_collect_to_vec(&bytes);
    words.chunks_exact(2).map(|word| Listed { mass: f64::from_bits(word[0]), particles: word[1] }).collect()
}

impl Populations {
    fn share(&self, pieces: &[Listed]) -> f64 {
        pieces.iter().fold(0.0, |sum, piece| sum + piece.mass) / self.total
    }

    /// Shares of the largest piece, the second, the power law's and the rest.
    pub fn shares(&self) -> [f64; 4] {
        let piece = |k: usize| self.pieces.get(k).map_or(0.0, |piece| piece.mass / self.total);
        let others = self.share(self.pieces.get(2..self.resolved).unwrap_or_default());
        let [largest, second] = [piece(0), piece(1)];
        [largest, second, others, (1.0 - largest - second - others).max(0.0)]
    }

    /// Masses over that of all, and the cumulative share at each.
    pub fn cumulative(&self) -> Vec<[f64; 2]> {
        let masses: Vec<f64> = self.pieces.iter().map(|piece| piece.mass).collect();
        power_law::cumulative(&masses, self.total)
    }

    /// `fragment_masses.csv`.
    pub fn table(&self) -> String {
        let mut text = String::from("mass_kg,particles,mass_over_all,cumulative_share,power_law\n");
        for (Listed { mass, particles }, [over_all, share]) in self.pieces.iter().zip(self.cumulative()) {
            let law = self.law.map_or(f64::NAN, |law| law.at(over_all));
            let _ = writeln!(text, "{mass:e},{particles},{over_all:e},{share:e},{law:e}");
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_word_for_each_collision() {
        assert_eq!(Word::of([0.95, 1.0], true, 0.9), Word::Sticking);
        assert_eq!(Word::of([0.95, 0.9], false, 0.9), Word::Bouncing);
        assert_eq!(Word::of([0.89, 1.0], true, 0.9), Word::Fragmentation);
    }

    #[test]
    fn populations_share_all_mass() {
        let listed = |mass, particles| Listed { mass, particles };
        let pieces = vec![listed(4.0, 40), listed(3.0, 30), listed(1.0, 10), listed(0.5, 5)];
        let of =
            |pieces, resolved| Populations { total: 10.0, pieces, resolved, law: None, kept: [0.0; 2], word: None };
        let found = of(pieces.clone(), 3).shares();
        assert!([0.4, 0.3, 0.1, 0.2].iter().zip(found).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?}");
        // Two bodies in one piece, and a body in dust.
        assert_eq!(of(vec![listed(10.0, 99)], 1).shares(), [1.0, 0.0, 0.0, 0.0]);
        assert_eq!(of(Vec::new(), 0).shares(), [0.0, 0.0, 0.0, 1.0]);
        let text = of(pieces, 3).table();
        assert!(text.contains("\n3e0,30,3e-1,6e-1,NaN\n") && text.lines().count() == 5, "{text}");
    }
}
