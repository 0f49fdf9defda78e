//! Bodies for an N-body program: a sphere for each clump (see `fragments`) and each loose particle, in the frame
//! of the centre of mass, largest first. A sphere has the mass, centre and velocity of its clump and the volume of its matter before
//! the impact; its rotation is not carried over. Clumps below the requested size or beyond the requested number are left out and
//! added up.

use bytemuck::{Pod, Zeroable};

use super::distributions::{least_listed, rank_of};
use super::fragments::{self, Link};
use super::particle::{LINK_DAMAGE, Particle};
use super::tally::{self, NONE, Scale, all_values};
use crate::domain::comm::Comm;
use crate::math::ExactSum;

/// Which clumps become bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Choice {
    /// Least number of particles.
    pub smallest: u64,
    /// Largest number of bodies.
    pub most: u64,
}

/// A sphere.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Sphere {
    /// The smallest id in it.
    pub label: u64,
    pub particles: u64,
    /// kg.
    pub mass: f64,
    /// m.
    pub radius: f64,
    /// m and m/s, relative to the centre of mass of everything and its motion.
    pub position: [f64; 3],
    pub velocity: [f64; 3],
}

/// Pieces that became no body, added up.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LeftOut {
    pub pieces: f64,
    /// kg.
    pub mass: f64,
    /// Momentum in the frame of the centre of mass, kg m/s.
    pub momentum: [f64; 3],
}

/// The spheres, on rank 0 alone, and the sum of the pieces left out. Collective.
pub fn spheres(comm: &Comm, particles: &[Particle], choice: &Choice) -> (Vec<Sphere>, LeftOut) {
    let scale = Scale::agree(comm, particles);
    let total = tally::total(comm, &scale, particles, NONE);
    let (centre, motion) = (total.position(&scale), total.velocity(&scale));
    let labels = fragments::labels(comm, particles, Link::Slow(LINK_DAMAGE));
    let pieces = fragments::pieces(comm, &scale, particles, &labels, NONE);
    let large = pieces.iter().filter(|piece| piece.count >= choice.smallest);
    let least = least_listed(comm, large.map(rank_of).collect(), choice.most);
    let mut sums = [const { ExactSum::new() }; 5];
    let mut chosen: Vec<Sphere> = Vec::new();
    for piece in &pieces {
        let (position, velocity) = (piece.position - centre, piece.velocity - motion);
        if piece.count >= choice.smallest && rank_of(piece) >= least {
            chosen.push(Sphere {
                label: piece.label,
                particles: piece.count,
                mass: piece.mass,
                radius: libm::cbrt(piece.volume * (0.75 / std::f64::consts::PI)),
                position: position.into(),
                velocity: velocity.into(),
            });
            continue;
        }
        let p = velocity * piece.mass;
        sums.iter_mut().zip([1.0, piece.mass, p.x, p.y, p.z]).for_each(|(sum, value)| sum.add(value));
    }
    let [number, mass, x, y, z] = all_values(comm, &mut sums);
    let words: Vec<u64> = bytemuck::cast_slice(&chosen).to_vec();
    let received = comm.sparse_exchange(if words.is_empty() { Vec::new() } else { vec![(0, words)] });
    let mut all: Vec<Sphere> =
        received.iter().flat_map(|(_, words)| bytemuck::cast_slice::<u64, Sphere>(words).to_vec()).collect();
    all.sort_by(|a, b| b.mass.total_cmp(&a.mass).then(a.label.cmp(&b.label)));
    (all, LeftOut { pieces: number, mass, momentum: [x, y, z] })
}
