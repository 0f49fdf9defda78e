//! What a scene's gravity does to its particles:
//!
//! ```text
//! uniform    a = g, the same for all             potential energy  -m g.(x + n L)
//! own        a = -grad phi of all particles      potential energy  m phi / 2
//! ```
//!
//! Along a periodic axis of length L a particle that falls comes back from above: its n counts how often it has gone round, so that
//! what gravity has done stays known. It acts on accelerations before prescribed motion does, so that what holds a particle also
//! bears its weight. Over time uniform gravity gives all matter the momentum M g t; particles among each other give none.
//!
//! Columns, of own gravity only: `gravity`, `gravitational_potential`, kept between evaluations, which may be rarer than steps;
//! where uniform gravity acts along a period: `rounds`, n.
//! Time step: that of all accelerations.

use super::{Body, Field, Opening, solve_later};
use crate::domain::comm::{Comm, Overlapped};
use crate::math::Vec3;
use crate::particles::{Chunk, Column, ColumnInfo, Columns, Life, ParticleId, Registry};

/// Cells farther than their size over this see each other as expansions; nearer to 1 these converge too slowly.
const ANGLE: f64 = 0.9;
/// The same while accelerations, by which errors are measured, are not known yet.
const FIRST_ANGLE: f64 = 0.7;

/// The gravity of a scene.
#[derive(Debug, Clone, Copy)]
pub struct Attraction {
    /// m/s^2.
    pub uniform: Vec3,
    /// How often particles went round the periods, whose lengths are in m; where uniform gravity acts along one.
    pub rounds: Option<(Column<Vec3>, Vec3)>,
    pub own: Option<OwnGravity>,
}

/// The gravity of particles on each other.
#[derive(Debug, Clone, Copy)]
pub struct OwnGravity {
    /// m/s^2, as last evaluated.
    pub acceleration: Column<Vec3>,
    /// J/kg, at the same time.
    pub potential: Column<f64>,
    /// Error of one cell's expansion that a particle may feel, over its acceleration.
    pub accuracy: f64,
    /// Seconds from one evaluation to the next; zero for every step.
    pub interval: f64,
}

/// Fields at particles, on their way.
pub type Evaluation<'a> = Overlapped<'a, Vec<Field>>;

/// Particles as gravity sees them.
pub struct Matter<'a> {
    pub id: Column<ParticleId>,
    pub position: Column<Vec3>,
    /// Mass of particle `i` of a body, kg, and its smoothing length, m.
    pub mass_and_softening: &'a dyn Fn(&Columns, usize) -> (f64, f64),
}

impl Attraction {
    /// Adds to the accelerations of a chunk, `dimension` numbers for each particle, m/s^2.
    pub fn add(&self, chunk: &Chunk, dimension: usize, acceleration: &mut [f64]) {
        for (i, a) in acceleration.chunks_exact_mut(dimension).take(chunk.len()).enumerate() {
            let own = self.own.map_or(Vec3::zeros(), |own| chunk.view(own.acceleration).get(i));
            (0..dimension).for_each(|k| a[k] += self.uniform[k] + own[k]);
        }
    }

    /// Potential energy of particle `i` over its mass, J/kg, so that the sum over all is that of all.
    pub fn energy(&self, columns: &Columns, i: usize, x: &Vec3) -> f64 {
        let gone = self.rounds.map_or(*x, |(rounds, length)| x + columns.get(rounds, i).component_mul(&length));
        self.own.map_or(0.0, |own| 0.5 * columns.get(own.potential, i)) - self.uniform.dot(&gone)
    }
}

/// Name of the column that counts rounds.
pub const ROUNDS: &str = "rounds";

/// Declares the count of rounds.
pub fn declare_rounds(registry: &mut Registry) -> Column<Vec3> {
    let about = "How often the particle went round each period, forwards less backwards.";
    let info = ColumnInfo { name: ROUNDS, unit: "", about, life: Life::State, snapshot: false };
    registry.owner("gravity").column(info)
}

impl OwnGravity {
    pub fn declare(registry: &mut Registry, accuracy: f64, interval: f64) -> Self {
        let state = |name, unit, about, snapshot| ColumnInfo { name, unit, about, life: Life::State, snapshot };
        registry.owner("gravity");
        let about = "Acceleration by the gravity of all particles, as last evaluated.";
        let acceleration = registry.column(state("gravity", "m/s^2", about, false));
        let about = "Gravitational potential of all other particles, as last evaluated.";
        let potential = registry.column(state("gravitational_potential", "J/kg", about, true));
        Self { acceleration, potential, accuracy, interval }
    }

    /// Whether a step of `dt` seconds must evaluate it anew, `since` seconds after the last time.
    pub fn is_due(&self, since: Option<f64>, dt: f64) -> bool {
        since.is_none_or(|since| since + 0.5 * dt >= self.interval)
    }

    /// Its evaluation at all particles as they are, with other work meanwhile; [`OwnGravity::keep`] takes what it finds. `first`:
    /// it never was before. Collective.
    pub fn evaluation<'a>(&self, columns: &Columns, matter: &Matter, first: bool, comm: &'a Comm) -> Evaluation<'a> {
        let order = order(self.accuracy);
        let opening = Opening { angle: ANGLE, accuracy: self.accuracy, order };
        let mut bodies = self.bodies(columns, matter);
        Overlapped::new(comm, async move {
            if first {
                let opening = Opening { angle: FIRST_ANGLE, accuracy: f64::INFINITY, order };
                let fields = solve_later(comm, &bodies, &opening).await;
                for (body, field) in bodies.iter_mut().zip(fields) {
                    body.acceleration = Vec3::from(field.acceleration).norm_squared().sqrt();
                }
            }
            solve_later(comm, &bodies, &opening).await
        })
    }

    /// Takes over what an evaluation has found, in the order of the particles that it was begun with.
    pub fn keep(&self, columns: &mut Columns, fields: &[Field]) {
        for (i, Field { acceleration, potential }) in fields.iter().enumerate() {
            columns.set(self.acceleration, i, Vec3::from(*acceleration));
            columns.set(self.potential, i, *potential);
        }
    }

    fn bodies(&self, columns: &Columns, matter: &Matter) -> Vec<Body> {
        let body = |i: usize| {
            let (mass, softening) = (matter.mass_and_softening)(columns, i);
            Body {
                id: columns.get(matter.id, i).0,
                position: columns.get(matter.position, i).into(),
                mass,
                softening,
                acceleration: columns.get(self.acceleration, i).norm_squared().sqrt(),
            }
        };
        (0..columns.len()).map(body).collect()
    }
}

/// The order of expansions that is cheapest for an accuracy, as measured.
fn order(accuracy: f64) -> usize {
    match accuracy {
        a if a > 0.015 => 3,
        a if a > 1e-3 => 4,
        _ => 5,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The evaluation nearest to its time: half a step before or after it.
    #[test]
    fn gravity_is_due_at_the_step_nearest_to_its_time() {
        let own = OwnGravity::declare(&mut Registry::new(3), 0.01, 10.0);
        assert!(own.is_due(None, 1.0), "it never was before");
        for (since, dt, due) in [
            (0.0, 1.0, false),
            (9.4, 1.0, false),
            (9.5, 1.0, true),
            (9.6, 1.0, true),
            (7.9, 4.0, false),
            (8.0, 4.0, true),
        ] {
            assert_eq!(own.is_due(Some(since), dt), due, "{since} {dt}");
        }
        let always = OwnGravity { interval: 0.0, ..own };
        assert!(always.is_due(Some(0.0), 1e-9));
    }
}
