//! Conserved quantities and diagnostics of effects, summed over all particles of all ranks exactly: no order of particles or
//! ranks can change a bit.

use rayon::prelude::*;

use super::settings::StepSettings;
use crate::domain::comm::Comm;
use crate::material::eos::INTERNAL_ENERGY;
use crate::math::{ExactSum, Vec3};
use crate::particles::Columns;

/// Sums over all particles.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Totals {
    /// kg
    pub mass: f64,
    /// J
    pub kinetic: f64,
    /// J; zero where the equations of state are cold.
    pub internal: f64,
    /// Energy in the field of gravity, J; `None` where the scene has no gravity.
    pub potential: Option<f64>,
    /// Force of uniform gravity on all matter, N.
    pub weight: Vec3,
    /// kg m/s
    pub momentum: Vec3,
    /// Angular momentum about the origin, kg m^2/s; in 2D only z.
    pub angular_momentum: Vec3,
    /// Work of prescribed motion on particles, J.
    pub work: f64,
    /// Momentum added by prescribed motion, kg m/s.
    pub impulse: Vec3,
    /// Sum of m |v|, the scale of momentum errors, kg m/s.
    pub momentum_scale: f64,
    /// Sum of m |x| |v|, the scale of errors of angular momentum, kg m^2/s.
    pub angular_scale: f64,
    /// One number per diagnostic of the material effects, in their order.
    pub effects: Vec<f64>,
}

impl Totals {
    pub fn energy(&self) -> f64 {
        self.kinetic + self.internal + self.potential.unwrap_or(0.0)
    }

    /// The conserved energy: energy less the work of prescribed motion, J.
    pub fn balance(&self) -> f64 {
        self.energy() - self.work
    }

    /// The conserved momentum, kg m/s: momentum less the impulse of walls, and of uniform gravity since the start, `time` s ago.
    pub fn momentum_balance(&self, time: f64) -> Vec3 {
        self.momentum - self.impulse - self.weight * time
    }

    /// Kinetic energy in the centre-of-mass frame, J.
    pub fn kinetic_in_centre_of_mass(&self) -> f64 {
        (self.kinetic - 0.5 * self.momentum.norm_squared() / self.mass).max(0.0)
    }
}

/// Particles that a thread sums up by itself, at least.
const SHARE: usize = 1 << 13;
/// Sums that every scene has, before those of effects.
const FIXED: usize = 15;

/// Sums over all particles; `gravity_age`: seconds since the particles' own gravity was evaluated. Collective.
pub fn totals(columns: &Columns, settings: &StepSettings, gravity_age: f64, comm: &Comm) -> Totals {
    let StepSettings { view, effects, motions, gravity, .. } = settings;
    let internal_energy = columns.registry.find::<f64>(INTERNAL_ENERGY);
    let counts: Vec<usize> = effects.iter().map(|effect| effect.diagnostics().len()).collect();
    let potential = FIXED + counts.iter().sum::<usize>();
    let nothing = || vec![ExactSum::new(); potential + gravity.is_some() as usize];
    let add = |mut sums: Vec<ExactSum>, i: usize| {
        let body = columns.get(view.core.id, i).body();
        let m = view.constants[body].particle_mass;
        let (x, v) = (columns.get(view.core.position, i), columns.get(view.core.velocity, i));
        let (p, l) = (m * v, x.cross(&(m * v)));
        let u = internal_energy.map_or(0.0, |u| columns.get(u, i));
        let v2 = v.norm_squared();
        let speed = v2.sqrt();
        let (work, j) = motions.as_ref().map_or((0.0, Vec3::zeros()), |motions| {
            (columns.get(motions.work.value, i), columns.get(motions.impulse.value, i))
        });
        let fixed = [
            m,
            0.5 * m * v2,
            m * u,
            p.x,
            p.y,
            p.z,
            l.x,
            l.y,
            l.z,
            m * speed,
            m * speed * x.norm_squared().sqrt(),
            work,
            j.x,
            j.y,
            j.z,
        ];
        fixed.iter().zip(&mut sums).for_each(|(term, sum)| sum.add(*term));
        if let Some(gravity) = gravity {
            sums[potential].add(m * gravity.energy(columns, gravity_age, i, &x));
        }
        let mut first = FIXED;
        for (effect, count) in effects.iter().zip(&counts) {
            if *count > 0 {
                effect.diagnose(columns, i, body, m, &mut |number, share| sums[first + number].add(share));
            }
            first += count;
        }
        sums
    };
    let merge = |mut sums: Vec<ExactSum>, others: Vec<ExactSum>| {
        sums.iter_mut().zip(&others).for_each(|(sum, other)| sum.merge(other));
        sums
    };
    let mut sums = match rayon::current_num_threads() {
        1 => (0..columns.len()).fold(nothing(), add),
        _ => (0..columns.len()).into_par_iter().with_min_len(SHARE).fold(nothing, add).reduce(nothing, merge),
    };
    let values = comm.sum_exactly(&mut sums);
    Totals {
        mass: values[0],
        kinetic: values[1],
        internal: values[2],
        momentum: Vec3::new(values[3], values[4], values[5]),
        angular_momentum: Vec3::new(values[6], values[7], values[8]),
        momentum_scale: values[9],
        angular_scale: values[10],
        work: values[11],
        impulse: Vec3::new(values[12], values[13], values[14]),
        potential: values.get(potential).copied(),
        weight: gravity.map_or(Vec3::zeros(), |gravity| gravity.uniform * values[0]),
        effects: values[FIXED..potential].to_vec(),
    }
}
