//! The outcome of an impact: fragments, aggregates bound by gravity, and when the outcome may be evaluated.
//!
//! Everything here runs in parallel on the owned particles; sums are exact and ties go to the smallest label, so that the
//! outcome has the same bits on any number of ranks. Velocities are relative to the common centre of mass wherever they are
//! reported.
//!
//! Where a scene has just a target and a projectile, all matter counts, and the largest remnant is the most massive aggregate,
//! whichever body it comes from. Where there are further bodies, only the matter of these two counts; the largest remnant is the
//! aggregate that holds most of the target's, and pieces that are mostly of other bodies are excluded, as an untouched neighbour is
//! not a remnant of the target. For the fate of each body see `origin`.

pub mod bound;
pub mod crater;
pub mod distributions;
pub mod fragments;
pub mod nbody;
pub mod origin;
pub mod profiles;
pub mod reaccumulated;
pub mod rebound;
pub mod scaling;
pub mod settled;
pub mod tally;
pub mod target_particle;
pub mod vapour;

use serde::{Deserialize, Serialize};

use crate::domain::comm::Comm;
use crate::material::{BodyConstants, Core};
use crate::math::{ExactSum, Vec3};
use crate::particles::Columns;
use origin::Origin;
use tally::{Scale, Tally};

/// Particles damaged less than this are linked into fragments.
pub const LINK_DAMAGE: f64 = 0.9;
/// The stricter threshold whose outcome is reported beside it.
pub const STRICT_DAMAGE: f64 = 0.5;

/// A particle as the outcome uses it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Particle {
    pub id: u64,
    /// Number of the scene's body that it comes from.
    pub body: usize,
    /// m.
    pub position: Vec3,
    /// m/s.
    pub velocity: Vec3,
    /// kg.
    pub mass: f64,
    /// Volume at the initial density of its body, m^3 (m^2 in 2D).
    pub volume: f64,
    /// Edge of a cube of that volume (of a square in 2D), m.
    pub spacing: f64,
    /// Vapour, which has no cohesion, counts as broken.
    pub damage: f64,
}

/// The owned particles as the outcome uses them; `whole`: the scene's body that each body is or is a part of, `damage`: damage of
/// particle i of a body.
pub fn particles(
    columns: &Columns,
    core: &Core,
    constants: &[BodyConstants],
    whole: &[usize],
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
            body: whole[id.body()],
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
    /// Volume at the initial density of its bodies, m^3 (m^2 in 2D).
    pub volume: f64,
    /// Centre of mass, m.
    pub position: Vec3,
    /// Velocity of the centre of mass, m/s.
    pub velocity: Vec3,
    /// Matter of each of the two bodies in question, kg.
    pub of: [f64; 2],
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
            of: tally.masses(scale),
        }
    }

    /// Smoothing length that spreads its mass over a sphere of its volume, m.
    fn softening(&self) -> f64 {
        0.5 * libm::cbrt(self.volume * (0.75 / std::f64::consts::PI))
    }
}

/// Which bodies of an impact are evaluated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Question {
    pub dimension: usize,
    /// Mass of the target, kg.
    pub target_mass: f64,
    /// Numbers of target and projectile.
    pub bodies: [usize; 2],
    /// Whether the scene has further bodies.
    pub others: bool,
}

impl Question {
    /// The mass by which pieces are compared, kg.
    pub fn rank(&self, piece: &Piece) -> f64 {
        if self.others { piece.of[0] } else { piece.mass }
    }

    /// The mass of a piece that counts, kg.
    pub fn counted(&self, piece: &Piece) -> f64 {
        if self.others { piece.of[0] + piece.of[1] } else { piece.mass }
    }
}

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
}

/// The outcome with fragments of particles damaged less than [`STRICT_DAMAGE`].
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Strict {
    pub largest_remnant_fraction: f64,
    pub largest_fragment_fraction: f64,
    pub fragments: u64,
}

/// An outcome and the pieces from which it was evaluated.
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
    /// Of everything.
    pub centre: CentreOfMass,
    /// Mass of everything, kg.
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
    let others: Vec<bool> = usual.free.iter().zip(&usual.in_largest).map(|(free, member)| *free && !member).collect();
    let second = usual.largest_of(comm, &others, question, &|piece| question.counted(piece)).0;
    let outcome = Outcome {
        target_mass: question.target_mass,
        total_mass,
        largest_remnant_fraction: over_target(usual.mass),
        largest_remnant_particles: usual.particles(comm),
        largest_remnant_of_total: usual.mass / total_mass,
        second_remnant_fraction: over_target(second),
        largest_fragment_fraction: over_target(usual.largest_fragment),
        fragments: usual.fragments,
        unbound_mass: (total_mass - usual.mass).max(0.0),
        strict,
        bodies: Vec::new(),
    };
    let centre = CentreOfMass { position: total.position(&scale), velocity: total.velocity(&scale) };
    Evaluation { outcome, pieces: usual.pieces, in_largest: usual.in_largest, centre, mass }
}

/// Pieces at one threshold of damage, and the largest remnant among them.
struct Remnants {
    pieces: Vec<Piece>,
    /// Which of them may be part of a remnant.
    free: Vec<bool>,
    in_largest: Vec<bool>,
    mass: f64,
    largest_fragment: f64,
    fragments: u64,
}

impl Remnants {
    /// `labels`: label of the fragment that each particle belongs to, if any.
    fn find(comm: &Comm, particles: &[Particle], scale: &Scale, labels: &[Option<u64>], question: &Question) -> Self {
        let pieces = fragments::pieces(comm, scale, particles, labels, question.bodies);
        Self::among(comm, pieces, question)
    }

    fn among(comm: &Comm, pieces: Vec<Piece>, question: &Question) -> Self {
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
    fn largest_of(&self, comm: &Comm, free: &[bool], question: &Question, rank: bound::Rank) -> (f64, Vec<bool>) {
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

    /// Particles of the largest remnant. Collective.
    fn particles(&self, comm: &Comm) -> u64 {
        let members = self.pieces.iter().zip(&self.in_largest).filter(|(_, member)| **member);
        let mut count = [members.map(|(piece, _)| piece.count as i64).sum()];
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
fn counted(comm: &Comm, pieces: &[Piece], label: Option<u64>, question: &Question) -> f64 {
    let piece = pieces.iter().find(|piece| Some(piece.label) == label);
    let mut mass = [piece.map_or(0.0, |piece| question.counted(piece))];
    comm.all_max(&mut mass);
    mass[0]
}

/// The values of exact sums over all ranks. Collective.
fn all_values<const N: usize>(comm: &Comm, sums: &mut [ExactSum; N]) -> [f64; N] {
    let values = comm.sum_exactly(sums);
    std::array::from_fn(|k| values[k])
}
