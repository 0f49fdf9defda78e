//! What holds together by gravity. Pieces - whole fragments and loose particles - are tested against an aggregate again
//! and again, joining and leaving it, until nothing changes. A piece of mass m belongs to an aggregate whose other
//! members have mass M, velocity V and potential phi(x) if their relative motion is bound (two-body energy over the
//! reduced mass):  |v - V|^2 / 2 + (1 + m / M) phi(x) < 0.
//!
//! The aggregate starts from the largest fragment; and, as rubble may have none worth the name, once more from all that is
//! bound in the potential of everything to the deepest place in it. The more massive result counts.

use super::Piece;
use crate::domain::comm::Comm;
use crate::gravity::{Opening, Potential, Source, Target, Tree};
use crate::math::{ExactSum, Vec3};

/// Passes in which pieces may join as well as leave; later they only leave, so that the search ends.
const FREE_PASSES: usize = 30;

/// A set of pieces of all ranks.
#[derive(Debug, Clone, PartialEq)]
pub struct Aggregate {
    /// Which of this rank's pieces belong to it.
    pub members: Vec<bool>,
    /// On all ranks, kg.
    pub mass: f64,
}

/// The most massive aggregate among the pieces that are `free`. Collective.
pub fn largest(comm: &Comm, pieces: &[Piece], free: &[bool], opening: Opening) -> Aggregate {
    let search = Search { comm, pieces, free, opening };
    let by_mass = |fragment: bool| {
        let candidates = (0..pieces.len()).filter(move |&i| free[i] && (!fragment || pieces[i].count > 1));
        best(comm, pieces, candidates.map(|i| (pieces[i].mass, i)))
    };
    let from_rubble = search.grow(search.bound_to_the_deepest());
    match by_mass(true) {
        None => from_rubble,
        Some(label) => {
            let from_fragment = search.grow(pieces.iter().map(|p| p.label == label).collect());
            if from_rubble.mass > from_fragment.mass { from_rubble } else { from_fragment }
        }
    }
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
    opening: Opening,
}

impl Search<'_> {
    /// Lets an aggregate gain and lose pieces until it stays as it is.
    fn grow(&self, seed: Vec<bool>) -> Aggregate {
        let mut members = seed;
        for pass in 0.. {
            let (mass, momentum) = self.sum(&members);
            let anchor = best(self.comm, self.pieces, self.chosen(&members).map(|i| (self.pieces[i].mass, i)));
            let potential = self.potential(&members);
            let stays = |i: usize| {
                let piece = &self.pieces[i];
                let mine = if members[i] { piece.mass } else { 0.0 };
                let rest = mass - mine;
                let motion = piece.velocity - (momentum - piece.velocity * mine) / rest;
                let energy = 0.5 * motion.norm_squared() + potential[i] * (1.0 + piece.mass / rest);
                Some(piece.label) == anchor || energy < 0.0 && (members[i] || pass < FREE_PASSES)
            };
            let next: Vec<bool> = (0..members.len()).map(|i| self.free[i] && stays(i)).collect();
            let mut changed = [if next == members { 0.0 } else { 1.0 }];
            self.comm.all_max(&mut changed);
            if changed[0] == 0.0 {
                return Aggregate { members, mass };
            }
            members = next;
        }
        unreachable!("members only leave after {FREE_PASSES} passes")
    }

    /// All that is bound, in the potential of all free pieces, to the piece that lies deepest in it.
    fn bound_to_the_deepest(&self) -> Vec<bool> {
        let potential = self.potential(self.free);
        let deepest = best(self.comm, self.pieces, self.chosen(self.free).map(|i| (-potential[i], i)));
        let here = self.pieces.iter().find(|p| Some(p.label) == deepest);
        let mut frame = here.map_or([f64::NEG_INFINITY; 3], |p| p.velocity.into());
        self.comm.all_max(&mut frame);
        let frame = Vec3::from(frame);
        let bound = |i: usize| {
            let piece = &self.pieces[i];
            let energy = 0.5 * (piece.velocity - frame).norm_squared() + potential[i];
            self.free[i] && (Some(piece.label) == deepest || energy < 0.0)
        };
        (0..self.pieces.len()).map(bound).collect()
    }

    fn chosen(&self, members: &[bool]) -> impl Iterator<Item = usize> {
        (0..self.pieces.len()).filter(move |&i| members[i])
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
        let [mass, x, y, z] = super::all_values(self.comm, &mut sums);
        (mass, Vec3::new(x, y, z))
    }

    /// The potential of the members at every piece, itself left out, J/kg.
    fn potential(&self, members: &[bool]) -> Vec<f64> {
        let source =
            |p: &Piece| Source { id: p.label, position: p.position.into(), mass: p.mass, softening: p.softening() };
        let sources: Vec<Source> = self.chosen(members).map(|i| source(&self.pieces[i])).collect();
        let targets: Vec<Target> = self.pieces.iter().map(|p| Target::from(&source(p))).collect();
        let tree = Tree::build(self.comm, &sources, &targets, self.opening);
        tree.fields::<Potential>(&targets).into_iter().map(|potential| potential.0).collect()
    }
}
