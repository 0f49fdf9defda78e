//! The particles of rigid bodies. Mass and inertia are those of the particles, so that sums over particles are those of the bodies;
//! the particles are placed from the body's motion, so that no rotation pulls them apart:
//!
//! ```text
//! x_i = X + R r_i,    v_i = V + w x (R r_i),    F = sum m_i a_i,    T = sum R r_i x m_i a_i
//! ```
//! r_i: place in the body's frame, which stays; a_i: the acceleration by all forces, as if the particle were free. The sums are
//! exact: no order of particles, threads or ranks changes a bit of them.
//!
//! Column, where a scene has rigid bodies: `rigid_place`, r_i.

use super::body::{Guidance, Load, RigidBody, RigidMotion, mobility};
use crate::domain::comm::Comm;
use crate::math::{ExactSum, Sym, Vec3};
use crate::motion::PrescribedMotion;
use crate::particles::{Chunk, Column, ColumnInfo, Columns, Life, ParticleId, Periods, Rates, Registry};

/// Force and torque of a body, being summed.
pub type LoadSums = [ExactSum; 6];

/// Columns of what is moved.
#[derive(Debug, Clone, Copy)]
pub struct MovedColumns {
    pub id: Column<ParticleId>,
    pub position: Column<Vec3>,
    pub velocity: Column<Vec3>,
}

/// A rigid body as a scene has it at the start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidStart {
    /// Number of the scene's body.
    pub body: usize,
    pub guidance: Guidance,
    /// Velocity at `about`, m/s, and angular velocity, 1/s.
    pub velocity: Vec3,
    pub spin: Vec3,
    /// m.
    pub about: Vec3,
    /// Speed of sound of its contact with other rigid bodies, m/s.
    pub sound_speed: f64,
}

/// The rigid bodies of a scene and their particles.
#[derive(Debug, Clone)]
pub struct RigidMatter {
    pub bodies: Vec<RigidStart>,
    /// Number among the rigid bodies, for each of the scene's.
    number: Vec<Option<usize>>,
    /// Mass of a particle of each of the scene's bodies, kg.
    masses: Vec<f64>,
    place: Column<Vec3>,
    moved: MovedColumns,
    periods: Periods,
}

/// The place in the body's frame.
const PLACE: ColumnInfo = ColumnInfo {
    name: "rigid_place",
    unit: "m",
    about: "Place of a rigid body's particle from the centre, in the frame that moves with the body.",
    life: Life::Kept,
    snapshot: false,
};

impl RigidMatter {
    /// Declares the column, or `None` where no body is rigid. `masses`: of a particle of each of the scene's bodies, kg.
    pub fn declare(
        bodies: Vec<RigidStart>,
        masses: Vec<f64>,
        periods: Periods,
        registry: &mut Registry,
        moved: MovedColumns,
    ) -> Option<Self> {
        if bodies.is_empty() {
            return None;
        }
        let number = (0..masses.len()).map(|of| bodies.iter().position(|start| start.body == of)).collect();
        let place = registry.owner("rigid").column(PLACE);
        Some(Self { bodies, number, masses, place, moved, periods })
    }

    /// The bodies of new particles, whose places in them are set. Collective.
    pub fn weigh(&self, columns: &mut Columns, comm: &Comm) -> Vec<RigidBody> {
        let numbers: Vec<Option<usize>> =
            (0..columns.len()).map(|i| self.number[columns.get(self.moved.id, i).body()]).collect();
        let mut sums = vec![ExactSum::new(); 4 * self.bodies.len()];
        for (i, number) in numbers.iter().enumerate() {
            let Some(number) = number else { continue };
            let m = self.masses[self.bodies[*number].body];
            let x = columns.get(self.moved.position, i);
            sums[4 * number..].iter_mut().zip([m, m * x.x, m * x.y, m * x.z]).for_each(|(sum, share)| sum.add(share));
        }
        let sums = comm.sum_exactly(&mut sums);
        let centres: Vec<Vec3> = sums.as_chunks::<4>().0.iter().map(|s| Vec3::new(s[1], s[2], s[3]) / s[0]).collect();
        let mut inertia = vec![ExactSum::new(); 6 * self.bodies.len()];
        let mut reach = vec![0.0; self.bodies.len()];
        for (i, number) in numbers.iter().enumerate() {
            let Some(number) = *number else { continue };
            let m = self.masses[self.bodies[number].body];
            let r = columns.get(self.moved.position, i) - centres[number];
            columns.set(self.place, i, r);
            let [xx, yy, zz] = [r.x * r.x, r.y * r.y, r.z * r.z];
            let shares = [yy + zz, xx + zz, xx + yy, -r.x * r.y, -r.x * r.z, -r.y * r.z];
            inertia[6 * number..].iter_mut().zip(shares).for_each(|(sum, share)| sum.add(m * share));
            reach[number] = r.norm().max(reach[number]);
        }
        let inertia = comm.sum_exactly(&mut inertia);
        comm.all_max(&mut reach);
        let of = |(number, start): (usize, &RigidStart)| {
            let [xx, yy, zz, xy, xz, yz] = inertia.as_chunks().0[number];
            let inertia = Sym { xx, yy, zz, xy, xz, yz };
            start.body(sums[4 * number], &inertia, centres[number], reach[number], columns.registry.dimension)
        };
        self.bodies.iter().enumerate().map(of).collect()
    }

    /// Sets positions and velocities of a chunk's particles to those of their bodies. `owners`: the scene's body of each particle.
    pub fn place(&self, chunk: &Chunk, owners: &[u16], bodies: &[RigidBody]) {
        let (position, velocity, place) =
            (chunk.view(self.moved.position), chunk.view(self.moved.velocity), chunk.view(self.place));
        self.each_stretch(owners, |number, particles| {
            let body = &bodies[number];
            let (r, spin) = (body.motion.orientation.matrix(), body.spin());
            for k in particles {
                let [x, v] = body.point(&r, &spin, &place.get(k));
                position.set(k, self.image(x, position.get(k)));
                velocity.set(k, v);
            }
        });
    }

    /// The image of a place nearest to another place.
    fn image(&self, x: Vec3, near: Vec3) -> Vec3 {
        if !self.periods.any() {
            return x;
        }
        let shift = |axis: usize| match self.periods.length[axis] {
            length if length > 0.0 => length * ((near[axis] - x[axis]) / length).round(),
            _ => 0.0,
        };
        x + Vec3::new(shift(0), shift(1), shift(2))
    }

    /// Adds the forces on a chunk's particles to those of their bodies; by itself no such particle is accelerated.
    pub fn take_forces<const D: usize>(
        &self,
        chunk: &Chunk,
        owners: &[u16],
        bodies: &[RigidBody],
        rates: &Rates,
        loads: &mut [LoadSums],
    ) {
        let place = chunk.view(self.place);
        let accelerations = rates.acceleration.as_chunks::<D>().0;
        self.each_stretch(owners, |number, particles| {
            let r = bodies[number].motion.orientation.matrix();
            let m = self.masses[bodies[number].body];
            for k in particles {
                let a = Vec3::from_fn(|axis, _| if axis < D { accelerations[k][axis].get() } else { 0.0 });
                // What is not finite stays, to be found with all other rates.
                if a == Vec3::zeros() || !a.iter().sum::<f64>().is_finite() {
                    continue;
                }
                accelerations[k].iter().for_each(|a| a.set(0.0));
                let force = m * a;
                let torque = (r * place.get(k)).cross(&force);
                let shares = force.iter().chain(torque.iter());
                loads[number].iter_mut().zip(shares).for_each(|(sum, share)| sum.add(*share));
            }
        });
    }

    /// Adds a force, N, that acts on one of the scene's bodies at a place, m.
    pub fn push(&self, body: usize, bodies: &[RigidBody], place: Vec3, force: Vec3, loads: &mut [LoadSums]) {
        let Some(number) = self.number[body] else { return };
        let centre = self.image(bodies[number].motion.centre, place);
        let torque = (place - centre).cross(&force);
        let shares = force.iter().chain(torque.iter());
        loads[number].iter_mut().zip(shares).for_each(|(sum, share)| sum.add(*share));
    }

    /// Force and torque of each body, of all ranks. Collective.
    pub fn loads(&self, sums: &mut [LoadSums], comm: &Comm) -> Vec<Load> {
        let values = comm.sum_exactly(sums.as_flattened_mut());
        let load = |v: &[f64; 6]| Load { force: Vec3::new(v[0], v[1], v[2]), torque: Vec3::new(v[3], v[4], v[5]) };
        values.as_chunks::<6>().0.iter().map(load).collect()
    }

    /// Stretches of particles of one rigid body, with the body's number.
    fn each_stretch(&self, owners: &[u16], mut act: impl FnMut(usize, std::ops::Range<usize>)) {
        let mut start = 0;
        for stretch in owners.chunk_by(|a, b| a == b) {
            let end = start + stretch.len();
            if let Some(number) = self.number[stretch[0] as usize] {
                act(number, start..end);
            }
            start = end;
        }
    }

    /// Whether a body is rigid, and its velocity is prescribed.
    pub fn holds(&self, body: usize) -> bool {
        let held = |number: usize| matches!(self.bodies[number].guidance.motion, PrescribedMotion::Prescribed(_));
        self.number[body].is_some_and(held)
    }

    /// Speed of sound of a body's contact with other rigid bodies, m/s; none where it is not rigid.
    pub fn sound_speed(&self, body: usize) -> f64 {
        self.number[body].map_or(0.0, |number| self.bodies[number].sound_speed)
    }

    /// Whether a scene prescribes how some of them move.
    pub fn are_guided(&self) -> bool {
        self.bodies.iter().any(|start| !start.guidance.is_free())
    }
}

impl RigidStart {
    fn body(&self, mass: f64, inertia: &Sym, centre: Vec3, reach: f64, dimension: usize) -> RigidBody {
        let spin = if self.guidance.rotation { self.spin } else { Vec3::zeros() };
        let mut inverse = mobility(inertia, dimension);
        if !self.guidance.rotation {
            inverse *= 0.0;
        }
        let motion = RigidMotion {
            centre,
            velocity: self.velocity + spin.cross(&(centre - self.about)),
            angular_momentum: inertia.to_matrix() * spin,
            ..RigidMotion::default()
        };
        RigidBody::new(self.body, mass, &inverse, reach, motion)
    }
}
