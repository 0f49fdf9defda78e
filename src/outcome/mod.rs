//! What an impact left behind: fragments, what gravity holds together, and when it is time to look.
//!
//! Everything here runs in parallel on the owned particles; sums are exact and ties go to the smallest label, so that the
//! outcome has the same bits on any number of ranks. Material of all bodies counts; velocities are relative to the common
//! centre of mass wherever they are reported.

pub mod bound;
pub mod crater;
pub mod distributions;
pub mod fragments;
pub mod nbody;
pub mod profiles;
pub mod reaccumulated;
pub mod rebound;
pub mod scaling;
pub mod settled;
pub mod tally;

use serde::{Deserialize, Serialize};

use crate::domain::comm::Comm;
use crate::material::{BodyConstants, Core};
use crate::math::{ExactSum, Vec3};
use crate::particles::Columns;
use tally::{Scale, Tally};

/// Particles damaged less than this are linked into fragments.
pub const LINK_DAMAGE: f64 = 0.9;
/// The stricter threshold whose outcome is reported beside it.
pub const STRICT_DAMAGE: f64 = 0.5;

/// A particle as the outcome sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Particle {
    pub id: u64,
    /// m.
    pub position: Vec3,
    /// m/s.
    pub velocity: Vec3,
    /// kg.
    pub mass: f64,
    /// At the density its body started with, m^3 (m^2 in 2D).
    pub volume: f64,
    /// Edge of a cube of that volume (of a square in 2D), m.
    pub spacing: f64,
    pub damage: f64,
}

/// The owned particles as the outcome sees them; `damage` of particle i of a body.
pub fn particles(
    columns: &Columns,
    core: &Core,
    constants: &[BodyConstants],
    damage: impl Fn(usize, usize) -> f64,
) -> Vec<Particle> {
    let sizes: Vec<(f64, f64)> = constants
        .iter()
        .map(|body| {
            let volume = body.particle_mass / body.density;
            (volume, if columns.registry.dimension == 3 { libm::cbrt(volume) } else { volume.sqrt() })
        })
        .collect();
    let particle = |i: usize| {
        let id = columns.get(core.id, i);
        let (volume, spacing) = sizes[id.body()];
        Particle {
            id: id.0,
            position: columns.get(core.position, i),
            velocity: columns.get(core.velocity, i),
            mass: constants[id.body()].particle_mass,
            volume,
            spacing,
            damage: damage(i, id.body()),
        }
    };
    (0..columns.len()).map(particle).collect()
}

/// An intact fragment of several particles, or one loose particle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// The smallest id in it.
    pub label: u64,
    /// Particles.
    pub count: u64,
    /// kg.
    pub mass: f64,
    /// At the density its bodies started with, m^3 (m^2 in 2D).
    pub volume: f64,
    /// Centre of mass, m.
    pub position: Vec3,
    /// Of the centre of mass, m/s.
    pub velocity: Vec3,
}

impl Piece {
    fn new(label: u64, tally: &Tally, scale: &Scale) -> Self {
        Self {
            label,
            count: tally.count,
            mass: tally.mass(scale),
            volume: tally.volume(scale),
            position: tally.position(scale),
            velocity: tally.velocity(scale),
        }
    }

    /// Smoothing length that spreads its mass over a sphere of its volume, m.
    fn softening(&self) -> f64 {
        0.5 * libm::cbrt(self.volume * (0.75 / std::f64::consts::PI))
    }
}

/// What is asked about an impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Question {
    pub dimension: usize,
    /// Mass of the target, kg.
    pub target_mass: f64,
}

/// The outcome of an impact; fractions are of the target's mass where nothing else is said.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Outcome {
    /// kg.
    pub target_mass: f64,
    /// Of both bodies, kg.
    pub total_mass: f64,
    /// The largest bound aggregate; in 2D, where there is no gravity, the largest fragment.
    pub largest_remnant_fraction: f64,
    /// The same over the mass of both bodies.
    pub largest_remnant_of_total: f64,
    /// The largest aggregate of what is left.
    pub second_remnant_fraction: f64,
    /// The largest intact fragment.
    pub largest_fragment_fraction: f64,
    /// Intact fragments of two particles and more.
    pub fragments: u64,
    /// Mass outside the largest remnant, kg.
    pub unbound_mass: f64,
    /// The same with fragments of less damaged material.
    pub strict: Strict,
}

/// The outcome with fragments of particles damaged less than [`STRICT_DAMAGE`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Strict {
    pub largest_remnant_fraction: f64,
    pub largest_fragment_fraction: f64,
    pub fragments: u64,
}

/// An outcome and the pieces it was read from.
pub struct Evaluation {
    pub outcome: Outcome,
    /// This rank's pieces.
    pub pieces: Vec<Piece>,
    /// Which of them belong to the largest remnant.
    pub in_largest: Vec<bool>,
    /// Centre of mass and its velocity.
    pub frame: (Vec3, Vec3),
}

/// Evaluates the state of all ranks. Collective.
pub fn evaluate(comm: &Comm, particles: &[Particle], question: &Question) -> Evaluation {
    let scale = Scale::agree(comm, particles);
    let total = tally::total(comm, &scale, particles.iter().copied());
    let total_mass = total.mass(&scale);
    let over_target = |mass: f64| mass / question.target_mass;
    let [usual, strict] =
        [LINK_DAMAGE, STRICT_DAMAGE].map(|damage| fragments::labels(comm, particles, fragments::Link::Intact(damage)));
    let mut differ = [(usual != strict) as u8 as f64];
    comm.all_max(&mut differ);
    let usual = Remnants::find(comm, particles, &scale, &usual, question);
    let with_strict_links = |found: &Remnants| Strict {
        largest_remnant_fraction: over_target(found.mass),
        largest_fragment_fraction: over_target(found.largest_fragment),
        fragments: found.fragments,
    };
    let strict = match differ {
        [0.0] => with_strict_links(&usual),
        _ => with_strict_links(&Remnants::find(comm, particles, &scale, &strict, question)),
    };
    let others: Vec<bool> = usual.in_largest.iter().map(|member| !member).collect();
    let second = usual.largest_of(comm, &others, question).0;
    let outcome = Outcome {
        target_mass: question.target_mass,
        total_mass,
        largest_remnant_fraction: over_target(usual.mass),
        largest_remnant_of_total: usual.mass / total_mass,
        second_remnant_fraction: over_target(second),
        largest_fragment_fraction: over_target(usual.largest_fragment),
        fragments: usual.fragments,
        unbound_mass: (total_mass - usual.mass).max(0.0),
        strict,
    };
    let frame = (total.position(&scale), total.velocity(&scale));
    Evaluation { outcome, pieces: usual.pieces, in_largest: usual.in_largest, frame }
}

/// Pieces at one threshold of damage, and the largest remnant among them.
struct Remnants {
    pieces: Vec<Piece>,
    in_largest: Vec<bool>,
    mass: f64,
    largest_fragment: f64,
    fragments: u64,
}

impl Remnants {
    /// `labels`: of the fragment that each particle belongs to, if any.
    fn find(comm: &Comm, particles: &[Particle], scale: &Scale, labels: &[Option<u64>], question: &Question) -> Self {
        let pieces = fragments::pieces(comm, scale, particles, labels);
        let is_fragment = |piece: &&Piece| piece.count > 1;
        let mut count = [pieces.iter().filter(is_fragment).count() as i64];
        comm.all_sum(&mut count);
        let mut largest = [pieces.iter().filter(is_fragment).fold(0.0, |m: f64, piece| m.max(piece.mass))];
        comm.all_max(&mut largest);
        let nothing = Vec::new();
        let mut found =
            Self { pieces, in_largest: nothing, mass: 0.0, largest_fragment: largest[0], fragments: count[0] as u64 };
        let all = vec![true; found.pieces.len()];
        (found.mass, found.in_largest) = found.largest_of(comm, &all, question);
        found
    }

    /// Mass and members of the largest remnant among free pieces.
    fn largest_of(&self, comm: &Comm, free: &[bool], question: &Question) -> (f64, Vec<bool>) {
        if question.dimension == 3 {
            let aggregate = bound::largest(comm, &self.pieces, free);
            return (aggregate.mass, aggregate.members);
        }
        let figures = (0..free.len()).filter(|&i| free[i]).map(|i| (self.pieces[i].mass, i));
        let label = bound::best(comm, &self.pieces, figures);
        let members: Vec<bool> = self.pieces.iter().map(|piece| Some(piece.label) == label).collect();
        let mut mass = [self.pieces.iter().filter(|p| Some(p.label) == label).fold(0.0, |_, piece| piece.mass)];
        comm.all_max(&mut mass);
        (mass[0], members)
    }
}

/// The values of exact sums over all ranks. Collective.
fn all_values<const N: usize>(comm: &Comm, sums: &mut [ExactSum; N]) -> [f64; N] {
    let mut limbs: Vec<i64> = sums.iter_mut().flat_map(|sum| sum.limbs_mut().to_vec()).collect();
    comm.all_sum(&mut limbs);
    std::array::from_fn(|k| ExactSum::from_limbs(&limbs[k * ExactSum::WORDS..(k + 1) * ExactSum::WORDS]).value())
}
