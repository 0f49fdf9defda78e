//! Exact sums per fragment: integers on a scale that all ranks agree on, so that the order of additions does not matter.
//! A value is rounded once, to 2^-70 of the largest of its kind; 2^56 particles may be added up. The matter of the two bodies in
//! question is summed apart.

use bytemuck::{Pod, Zeroable};

use super::particle::Particle;
use crate::domain::comm::Comm;
use crate::math::{ExactSum, Vec3};

/// No body is in question.
pub const NONE: [usize; 2] = [usize::MAX; 2];
/// Bits kept below the largest value.
const BITS: i32 = 70;

/// Exponents of the units in which mass, volume, mass times position and momentum are counted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale([i32; 4]);

impl Scale {
    /// Collective.
    pub fn agree(comm: &Comm, particles: &[Particle]) -> Self {
        let mut largest = particles.iter().fold([0.0f64; 4], |l, p| {
            let values = [p.mass, p.volume, p.mass * p.position.amax(), p.mass * p.velocity.amax()];
            std::array::from_fn(|k| l[k].max(values[k]))
        });
        comm.all_max(&mut largest);
        Self(largest.map(|x| libm::frexp(x).1 - BITS))
    }
}

/// Sums over particles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Pod, Zeroable)]
#[repr(C)]
pub struct Tally {
    pub count: u64,
    /// Mass, volume, mass times position, momentum, masses of the two bodies: 128-bit integers, low word first.
    sums: [[u64; 2]; 10],
}

impl Tally {
    pub const WORDS: usize = std::mem::size_of::<Self>() / 8;

    /// `bodies`: numbers of the two in question.
    pub fn add(&mut self, scale: &Scale, p: &Particle, bodies: [usize; 2]) {
        let (weighted, momentum) = (p.position * p.mass, p.velocity * p.mass);
        let [a, b] = bodies.map(|body| if p.body == body { p.mass } else { 0.0 });
        let values = [p.mass, p.volume, weighted.x, weighted.y, weighted.z, momentum.x, momentum.y, momentum.z, a, b];
        self.count += 1;
        for (k, value) in values.into_iter().enumerate() {
            let unit = scale.0[unit_of(k)];
            self.put(k, self.at(k) + libm::rint(libm::ldexp(value, -unit)) as i128);
        }
    }

    pub fn merge(&mut self, other: &Self) {
        self.count += other.count;
        for k in 0..self.sums.len() {
            self.put(k, self.at(k) + other.at(k));
        }
    }

    /// kg.
    pub fn mass(&self, scale: &Scale) -> f64 {
        self.value(scale, 0)
    }

    /// Mass of each of the two bodies in question, kg.
    pub fn masses(&self, scale: &Scale) -> [f64; 2] {
        [8, 9].map(|k| self.value(scale, k))
    }

    /// Volume at the initial density of the bodies, m^3 (m^2 in 2D).
    pub fn volume(&self, scale: &Scale) -> f64 {
        self.value(scale, 1)
    }

    /// Centre of mass, m.
    pub fn position(&self, scale: &Scale) -> Vec3 {
        Vec3::from_fn(|k, _| self.value(scale, 2 + k)) / self.mass(scale)
    }

    /// m/s.
    pub fn velocity(&self, scale: &Scale) -> Vec3 {
        Vec3::from_fn(|k, _| self.value(scale, 5 + k)) / self.mass(scale)
    }

    fn value(&self, scale: &Scale, k: usize) -> f64 {
        libm::ldexp(self.at(k) as f64, scale.0[unit_of(k)])
    }

    fn at(&self, k: usize) -> i128 {
        let [low, high] = self.sums[k];
        (low as u128 | (high as u128) << 64) as i128
    }

    fn put(&mut self, k: usize, sum: i128) {
        self.sums[k] = [sum as u64, (sum >> 64) as u64];
    }
}

/// The unit of sum `k`.
fn unit_of(k: usize) -> usize {
    [0, 1, 2, 2, 2, 3, 3, 3, 0, 0][k]
}

/// Sums over particles of all ranks, exactly. Collective.
pub fn total(comm: &Comm, scale: &Scale, particles: &[Particle], bodies: [usize; 2]) -> Tally {
    let mut mine = Tally::default();
    particles.iter().for_each(|p| mine.add(scale, p, bodies));
    let all = comm.all_gather(&[mine]);
    let mut sum = Tally::default();
    all.iter().for_each(|tally| sum.merge(tally));
    sum
}

/// The values of exact sums over all ranks. Collective.
pub(super) fn all_values<const N: usize>(comm: &Comm, sums: &mut [ExactSum; N]) -> [f64; N] {
    let values = comm.sum_exactly(sums);
    std::array::from_fn(|k| values[k])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn particle(id: u64, mass: f64, x: f64) -> Particle {
        let (position, velocity) = (Vec3::new(x, -2.0 * x, 1.0), Vec3::new(-x, 0.0, 3.0));
        Particle { id, body: 0, position, velocity, mass, volume: mass / 2.0, spacing: 1.0, damage: 0.0 }
    }

    #[test]
    fn any_order_and_grouping_gives_the_same_bits() {
        let particles: Vec<_> =
            (0..100).map(|i| particle(i, 1.0 / (i + 1) as f64, libm::sin(i as f64) * 1e5)).collect();
        let scale = Scale([1 - BITS, -BITS, 18 - BITS, 18 - BITS]);
        let sum = |order: &[Particle]| {
            let mut t = Tally::default();
            order.iter().for_each(|p| t.add(&scale, p, [0, 1]));
            t
        };
        let forward = sum(&particles);
        let mut halves = sum(&particles[60..]);
        halves.merge(&sum(&particles[..60]));
        assert_eq!(forward, halves);
        let mass: f64 = particles.iter().map(|p| p.mass).sum();
        assert!((forward.mass(&scale) / mass - 1.0).abs() < 1e-15);
        assert_eq!(forward.masses(&scale), [forward.mass(&scale), 0.0]);
        assert!((forward.velocity(&scale).z - 3.0).abs() < 1e-14);
        assert!((forward.position(&scale).x + forward.velocity(&scale).x).abs() < 1e-9);
    }
}
