//! The outcome of an impact, evaluated from the particles of all ranks.

use serde::{Deserialize, Serialize};

use super::form::Form;
use super::lasting::Trend;
use super::particle::{LINK_DAMAGE, Particle, STRICT_DAMAGE};
use super::piece::{Piece, Question};
use super::tally::{self, Scale, all_values};
use super::{bound, fragments};
use crate::domain::comm::Comm;
use crate::math::{ExactSum, Vec3};

/// The outcome of an impact; fractions are of the target's mass unless stated otherwise.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Outcome {
    /// kg.
    pub target_mass: f64,
    /// Mass of both bodies, kg.
    pub total_mass: f64,
    /// The largest bound aggregate; in 2D, where there is no gravity, the largest fragment.
    pub largest_remnant_fraction: f64,
    /// Particles in it.
    #[serde(default)]
    pub largest_remnant_particles: u64,
    /// Mass of the largest remnant over the mass of both bodies.
    pub largest_remnant_of_total: f64,
    /// kg m/s.
    #[serde(default)]
    pub largest_remnant_momentum: [f64; 3],
    /// The largest aggregate of the remaining pieces.
    pub second_remnant_fraction: f64,
    /// The largest intact fragment.
    pub largest_fragment_fraction: f64,
    /// Intact fragments of two particles and more.
    pub fragments: u64,
    /// Mass outside the largest remnant, kg.
    pub unbound_mass: f64,
    /// The outcome with fragments of less damaged material.
    pub strict: Strict,
    /// The fate of each body, where requested.
    #[serde(default)]
    pub bodies: Vec<Origin>,
    /// The largest remnant as a body, in 3D.
    #[serde(default)]
    pub form: Option<Form>,
    /// What becomes of the largest remnant, where it was watched.
    #[serde(default)]
    pub trend: Option<Trend>,
}

impl Outcome {
    /// How much more mass the largest remnant has at twice the time, kg.
    fn change(&self) -> f64 {
        self.trend.map_or(0.0, |trend| trend.change * self.total_mass)
    }

    /// The largest remnant at twice the time, over the target.
    pub fn later_fraction(&self) -> f64 {
        self.largest_remnant_fraction + self.change() / self.target_mass
    }

    /// The largest remnant at twice the time, over both bodies.
    pub fn later_of_total(&self) -> f64 {
        self.largest_remnant_of_total + self.change() / self.total_mass
    }
}

/// The outcome with fragments of particles damaged less than [`STRICT_DAMAGE`].
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Strict {
    pub largest_remnant_fraction: f64,
    pub largest_fragment_fraction: f64,
    pub fragments: u64,
}

/// The common centre of mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CentreOfMass {
    /// m.
    pub position: Vec3,
    /// m/s.
    pub velocity: Vec3,
}

/// An outcome and the pieces it was read from.
pub struct Evaluation {
    pub outcome: Outcome,
    /// This rank's pieces.
    pub pieces: Vec<Piece>,
    /// Which of them belong to the largest remnant.
    pub in_largest: Vec<bool>,
    /// Label of the fragment that each of this rank's particles belongs to, none of a loose one.
    pub labels: Vec<Option<u64>>,
    /// Centre of mass of all matter.
    pub centre: CentreOfMass,
    /// Mass of all matter, kg.
    pub mass: f64,
}

/// Evaluates the state of all ranks. Collective.
pub fn evaluate(comm: &Comm, particles: &[Particle], question: &Question) -> Evaluation {
    let scale = Scale::agree(comm, particles);
    let total = tally::total(comm, &scale, particles, question.bodies);
    let mass = total.mass(&scale);
    let total_mass = if question.others { total.masses(&scale).iter().sum() } else { mass };
    let over_target = |mass: f64| mass / question.target_mass;
    let [usual, strict] =
        [LINK_DAMAGE, STRICT_DAMAGE].map(|damage| fragments::labels(comm, particles, fragments::Link::Intact(damage)));
    let mut differ = [(usual != strict) as u8 as f64];
    comm.all_max(&mut differ);
    let labels = usual;
    let usual = Remnants::find(comm, particles, &scale, &labels, question);
    let with_strict_links = |found: &Remnants| Strict {
        largest_remnant_fraction: over_target(found.mass),
        largest_fragment_fraction: over_target(found.largest_fragment),
        fragments: found.fragments,
    };
    let strict = match differ {
        [0.0] => with_strict_links(&usual),
        _ => with_strict_links(&Remnants::find(comm, particles, &scale, &strict, question)),
    };
    let others: Vec<bool> = usual.free.iter().zip(&usual.in_largest).map(|(free, member)| *free && !member).collect();
    let second = usual.largest_of(comm, &others, question, &|piece| question.counted(piece)).0;
    let outcome = Outcome {
        target_mass: question.target_mass,
        total_mass,
        largest_remnant_fraction: over_target(usual.mass),
        largest_remnant_particles: usual.particles(comm),
        largest_remnant_of_total: usual.mass / total_mass,
        largest_remnant_momentum: usual.momentum(comm),
        second_remnant_fraction: over_target(second),
        largest_fragment_fraction: over_target(usual.largest_fragment),
        fragments: usual.fragments,
        unbound_mass: (total_mass - usual.mass).max(0.0),
        strict,
        bodies: Vec::new(),
        form: None,
        trend: None,
    };
    let centre = CentreOfMass { position: total.position(&scale), velocity: total.velocity(&scale) };
    Evaluation { outcome, pieces: usual.pieces, in_largest: usual.in_largest, labels, centre, mass }
}

/// Pieces at one threshold of damage, and the largest remnant among them.
pub(super) struct Remnants {
    pub pieces: Vec<Piece>,
    /// Which of them may be part of a remnant.
    pub free: Vec<bool>,
    pub in_largest: Vec<bool>,
    pub mass: f64,
    pub largest_fragment: f64,
    pub fragments: u64,
}

impl Remnants {
    /// `labels`: label of the fragment that each particle belongs to, if any.
    pub fn find(
        comm: &Comm,
        particles: &[Particle],
        scale: &Scale,
        labels: &[Option<u64>],
        question: &Question,
    ) -> Self {
        let pieces = fragments::pieces(comm, scale, particles, labels, question.bodies);
        Self::among(comm, pieces, question)
    }

    pub fn among(comm: &Comm, pieces: Vec<Piece>, question: &Question) -> Self {
        let is_fragment = |i: &usize| pieces[*i].count > 1 && question.counted(&pieces[*i]) > 0.0;
        let fragments = || (0..pieces.len()).filter(is_fragment);
        let mut count = [fragments().count() as i64];
        comm.all_sum(&mut count);
        let largest = bound::best(comm, &pieces, fragments().map(|i| (question.rank(&pieces[i]), i)));
        let largest_fragment = counted(comm, &pieces, largest, question);
        let free = free(comm, &pieces, question);
        let fragments = count[0] as u64;
        let mut found = Self { pieces, free, in_largest: Vec::new(), mass: 0.0, largest_fragment, fragments };
        (found.mass, found.in_largest) = found.largest_of(comm, &found.free, question, &|piece| question.rank(piece));
        found
    }

    /// Counted mass and members of the largest remnant by `rank` among free pieces.
    pub fn largest_of(&self, comm: &Comm, free: &[bool], question: &Question, rank: bound::Rank) -> (f64, Vec<bool>) {
        if question.dimension == 3 {
            let members = bound::largest(comm, &self.pieces, free, rank).members;
            let mut sum = [ExactSum::new()];
            let mine = self.pieces.iter().zip(&members).filter(|(_, member)| **member);
            mine.for_each(|(piece, _)| sum[0].add(question.counted(piece)));
            return (all_values(comm, &mut sum)[0], members);
        }
        let figures = (0..free.len()).filter(|&i| free[i]).map(|i| (rank(&self.pieces[i]), i));
        let label = bound::best(comm, &self.pieces, figures);
        let members: Vec<bool> = self.pieces.iter().map(|piece| Some(piece.label) == label).collect();
        (counted(comm, &self.pieces, label, question), members)
    }

    /// This rank's pieces of the largest remnant.
    fn members(&self) -> impl Iterator<Item = &Piece> {
        self.pieces.iter().zip(&self.in_largest).filter(|(_, member)| **member).map(|(piece, _)| piece)
    }

    /// Momentum of the largest remnant, kg m/s. Collective.
    fn momentum(&self, comm: &Comm) -> [f64; 3] {
        let mut sums = [const { ExactSum::new() }; 3];
        for piece in self.members() {
            (0..3).for_each(|k| sums[k].add(piece.mass * piece.velocity[k]));
        }
        let momentum = all_values(comm, &mut sums);
        std::array::from_fn(|k| momentum[k])
    }

    /// Particles of the largest remnant. Collective.
    pub fn particles(&self, comm: &Comm) -> u64 {
        let mut count = [self.members().map(|piece| piece.count as i64).sum()];
        comm.all_sum(&mut count);
        count[0] as u64
    }
}

/// Which pieces may be part of a remnant: where there are other bodies, those of which at least half counts, and the one
/// that holds most of the target's matter.
fn free(comm: &Comm, pieces: &[Piece], question: &Question) -> Vec<bool> {
    if !question.others {
        return vec![true; pieces.len()];
    }
    let main = bound::best(comm, pieces, (0..pieces.len()).map(|i| (question.rank(&pieces[i]), i)));
    pieces.iter().map(|piece| 2.0 * question.counted(piece) >= piece.mass || Some(piece.label) == main).collect()
}

/// The counted mass of the piece of that label, kg; zero where there is none. Collective.
pub(super) fn counted(comm: &Comm, pieces: &[Piece], label: Option<u64>, question: &Question) -> f64 {
    let piece = pieces.iter().find(|piece| Some(piece.label) == label);
    let mut mass = [piece.map_or(0.0, |piece| question.counted(piece))];
    comm.all_max(&mut mass);
    mass[0]
}

/// Shares of a body's own matter.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Origin {
    /// Its number.
    pub body: usize,
    /// Share in the largest remnant of the impact.
    pub in_largest_remnant: f64,
    /// Share in the aggregate that holds most of it; in 2D in the piece.
    pub remnant: f64,
    /// Share in the intact fragment that holds most of it.
    pub fragment: f64,
}
