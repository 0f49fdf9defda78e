//! Gravitationally bound aggregates. Pieces - whole fragments and loose particles - are tested against an aggregate again
//! and again, joining and leaving it, until nothing changes. A piece of mass m belongs to an aggregate whose other
//! members have mass M, velocity V and potential phi(x) if their relative motion is bound (two-body energy over the
//! reduced mass):  |v - V|^2 / 2 + (1 + m / M) phi(x) < 0.
//!
//! The aggregate starts from the largest fragment; and, as rubble may have no large one, once more from all pieces that are bound,
//! in the potential of all, to the motion around its deepest place. Where almost none is, as matter at that place is ejected where
//! pores collapse, it starts from the pieces bound to the motion of one piece: the one of a sample to which most mass is. (This
//! alone would not suffice: to matter between two piles that separate both are bound, each by itself, and would count as one.) The
//! most massive result counts: by its whole mass, or by its matter of one body (`rank`).

use super::piece::Piece;
use super::tally::all_values;
use crate::domain::comm::Comm;
use crate::gravity::{Body, Opening, solve};
use crate::math::{ExactSum, Vec3};
use crate::random::uniform;

/// Passes in which pieces may join as well as leave; later they only leave, so that the search ends.
const FREE_PASSES: usize = 30;
/// Pieces count for the motion of the deepest place within so many sizes, cube roots of its volume, of the piece that lies there: with
/// particles these are the hundred nearest.
const AROUND: f64 = 3.0;
/// An aggregate grown from the deepest place counts as almost nothing below this share of all free mass.
const NEXT_TO_NOTHING: f64 = 0.1;
/// Pieces of the sample whose motions are tried: a remnant of a tenth of everything is missed once in a thousand times.
const SAMPLE: usize = 64;
/// Potentials are right to 1e-3, speeds of escape to half of that.
const OPENING: Opening = Opening { angle: 0.7, accuracy: f64::INFINITY, order: 4 };

/// A set of pieces of all ranks.
#[derive(Debug, Clone, PartialEq)]
pub struct Aggregate {
    /// Whether each of this rank's pieces belongs to it.
    pub members: Vec<bool>,
    /// Mass on all ranks, kg.
    pub mass: f64,
}

/// The mass by which pieces are compared, kg.
pub type Rank<'a> = &'a dyn Fn(&Piece) -> f64;

/// The largest aggregate by `rank` among the pieces that are `free`. Collective.
pub fn largest(comm: &Comm, pieces: &[Piece], free: &[bool], rank: Rank) -> Aggregate {
    let search = Search { comm, pieces, free, rank };
    let fragments = (0..pieces.len()).filter(|&i| free[i] && pieces[i].count > 1 && rank(&pieces[i]) > 0.0);
    let from_fragment = match best(comm, pieces, fragments.map(|i| (rank(&pieces[i]), i))) {
        Some(label) => search.grow(pieces.iter().map(|p| p.label == label).collect()),
        None => Aggregate { members: vec![false; pieces.len()], mass: 0.0 },
    };
    let [held, all] = [&from_fragment.members[..], free].map(|members| search.ranked(members));
    if held > 0.5 * all {
        return from_fragment;
    }
    let from_rubble = search.rubble();
    if search.ranked(&from_rubble.members) > held { from_rubble } else { from_fragment }
}

/// The label of the piece with the largest figure over all ranks, the smallest label among equals. Collective.
pub fn best(comm: &Comm, pieces: &[Piece], figures: impl Iterator<Item = (f64, usize)>) -> Option<u64> {
    let better = |a: (f64, u64), b: (f64, u64)| if b.0 > a.0 || (b.0 == a.0 && b.1 < a.1) { b } else { a };
    let nothing = (f64::NEG_INFINITY, u64::MAX);
    let mine = figures.map(|(figure, i)| (figure, pieces[i].label)).fold(nothing, better);
    let all = comm.all_gather(&[mine.0.to_bits(), mine.1]);
    let found = all.chunks_exact(2).map(|w| (f64::from_bits(w[0]), w[1])).fold(nothing, better);
    (found.0 > f64::NEG_INFINITY).then_some(found.1)
}

struct Search<'a> {
    comm: &'a Comm,
    pieces: &'a [Piece],
    free: &'a [bool],
    rank: Rank<'a>,
}

impl Search<'_> {
    /// Lets an aggregate gain and lose pieces until it stays as it is.
    fn grow(&self, seed: Vec<bool>) -> Aggregate {
        let mut members = vec![false; self.pieces.len()];
        let mut potential = vec![0.0; self.pieces.len()];
        let (mut next, mut mass) = (seed, 0.0);
        for pass in 0.. {
            if !self.update_potential(&mut potential, &members, &next) {
                break;
            }
            members = next;
            let momentum;
            (mass, momentum) = self.sum(&members);
            let anchor = best(self.comm, self.pieces, self.chosen(&members).map(|i| (self.pieces[i].mass, i)));
            let stays = |i: usize| {
                let piece = &self.pieces[i];
                let mine = if members[i] { piece.mass } else { 0.0 };
                let rest = mass - mine;
                let motion = piece.velocity - (momentum - piece.velocity * mine) / rest;
                let energy = 0.5 * motion.norm_squared() + potential[i] * (1.0 + piece.mass / rest);
                Some(piece.label) == anchor || energy < 0.0 && (members[i] || pass < FREE_PASSES)
            };
            next = (0..members.len()).map(|i| self.free[i] && stays(i)).collect();
        }
        Aggregate { members, mass }
    }

    /// The aggregate of rubble.
    fn rubble(&self) -> Aggregate {
        let mut potential = vec![0.0; self.pieces.len()];
        self.update_potential(&mut potential, &vec![false; self.pieces.len()], self.free);
        let from_the_deepest = self.grow(self.bound_to_the_deepest(&potential));
        if from_the_deepest.mass > NEXT_TO_NOTHING * self.sum(self.free).0 {
            return from_the_deepest;
        }
        let from_sample = self.grow(self.bound_to_most(&potential));
        if from_sample.mass > from_the_deepest.mass { from_sample } else { from_the_deepest }
    }

    fn is_bound(&self, i: usize, motion: &Vec3, potential: &[f64]) -> bool {
        self.free[i] && 0.5 * (self.pieces[i].velocity - motion).norm_squared() + potential[i] < 0.0
    }

    /// All that is bound to the pieces around the deepest place.
    fn bound_to_the_deepest(&self, potential: &[f64]) -> Vec<bool> {
        let deepest = best(self.comm, self.pieces, self.chosen(self.free).map(|i| (-potential[i], i)));
        let here = self.pieces.iter().find(|piece| Some(piece.label) == deepest);
        let mut place = here.map_or([f64::NEG_INFINITY; 4], |piece| {
            [piece.position.x, piece.position.y, piece.position.z, AROUND * libm::cbrt(piece.volume)]
        });
        self.comm.all_max(&mut place);
        let [x, y, z, reach] = place;
        let is_near = |i: usize| self.free[i] && (self.pieces[i].position - Vec3::new(x, y, z)).norm() <= reach;
        let (mass, momentum) = self.sum(&(0..self.pieces.len()).map(is_near).collect::<Vec<_>>());
        let motion = momentum / mass;
        let belongs = |i| self.is_bound(i, &motion, potential) || Some(self.pieces[i].label) == deepest;
        (0..self.pieces.len()).map(belongs).collect()
    }

    /// All that is bound to the motion of the piece of the sample to which most mass is bound.
    fn bound_to_most(&self, potential: &[f64]) -> Vec<bool> {
        let motions = self.sample();
        let mut bound = [const { ExactSum::new() }; SAMPLE];
        for (sum, motion) in bound.iter_mut().zip(&motions) {
            let members = (0..self.pieces.len()).filter(|&i| self.is_bound(i, motion, potential));
            members.for_each(|i| sum.add(self.pieces[i].mass));
        }
        let masses = all_values(self.comm, &mut bound);
        let best = (0..SAMPLE).fold(0, |best, k| if masses[k] > masses[best] { k } else { best });
        let belongs = |i| motions.get(best).is_some_and(|motion| self.is_bound(i, motion, potential));
        (0..self.pieces.len()).map(belongs).collect()
    }

    /// Velocities of a random sample of free pieces, the same on any number of ranks; of all, if there are fewer.
    fn sample(&self) -> Vec<Vec3> {
        let lot = |label: u64| uniform(0, label, 0).to_bits();
        let words = |i: usize| {
            let Piece { label, velocity, .. } = &self.pieces[i];
            [lot(*label), *label, velocity.x.to_bits(), velocity.y.to_bits(), velocity.z.to_bits()]
        };
        let first = |mut drawn: Vec<[u64; 5]>| {
            drawn.sort_unstable();
            drawn.truncate(SAMPLE);
            drawn
        };
        let mut mine = first(self.chosen(self.free).map(words).collect());
        mine.resize(SAMPLE, [u64::MAX; 5]);
        let drawn = first(self.comm.all_gather(&mine));
        let velocity = |w: &[u64; 5]| Vec3::new(f64::from_bits(w[2]), f64::from_bits(w[3]), f64::from_bits(w[4]));
        drawn.iter().filter(|w| w[0] != u64::MAX).map(velocity).collect()
    }

    fn chosen(&self, members: &[bool]) -> impl Iterator<Item = usize> {
        (0..self.pieces.len()).filter(move |&i| members[i])
    }

    /// Sum of the members' ranks on all ranks, kg.
    fn ranked(&self, members: &[bool]) -> f64 {
        let mut sum = [ExactSum::new()];
        self.chosen(members).for_each(|i| sum[0].add((self.rank)(&self.pieces[i])));
        all_values(self.comm, &mut sum)[0]
    }

    /// Mass and momentum of the members on all ranks.
    fn sum(&self, members: &[bool]) -> (f64, Vec3) {
        let mut sums = [const { ExactSum::new() }; 4];
        for i in self.chosen(members) {
            let piece = &self.pieces[i];
            let momentum = piece.velocity * piece.mass;
            let values = [piece.mass, momentum.x, momentum.y, momentum.z];
            sums.iter_mut().zip(values).for_each(|(sum, value)| sum.add(value));
        }
        let [mass, x, y, z] = all_values(self.comm, &mut sums);
        (mass, Vec3::new(x, y, z))
    }

    /// Updates the potential of the members at every free piece, itself left out (J/kg), to a new membership: it is
    /// linear in them, and after the first pass few change. Returns whether any did.
    fn update_potential(&self, potential: &mut [f64], before: &[bool], after: &[bool]) -> bool {
        let free: Vec<usize> = self.chosen(self.free).collect();
        let some = |from: &[bool], to: &[bool]| free.iter().any(|&i| to[i] && !from[i]) as u8 as f64;
        let mut changes = [some(before, after), some(after, before)];
        self.comm.all_max(&mut changes);
        for (from, to, sign, change) in [(before, after, 1.0, changes[0]), (after, before, -1.0, changes[1])] {
            if change == 0.0 {
                continue;
            }
            let body = |&i: &usize| {
                let piece = &self.pieces[i];
                let mass = if to[i] && !from[i] { piece.mass } else { 0.0 };
                let (position, softening) = (piece.position.into(), piece.softening());
                Body { id: piece.label, position, mass, softening, acceleration: 0.0 }
            };
            let bodies: Vec<Body> = free.iter().map(body).collect();
            for (&i, field) in free.iter().zip(solve(self.comm, &bodies, &OPENING)) {
                potential[i] += sign * field.potential;
            }
        }
        changes != [0.0; 2]
    }
}
