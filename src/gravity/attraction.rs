//! Gravity acting on the particles:
//!
//! ```text
//! uniform    a = g, the same for all             potential energy  -m g.(x + n L)
//! own        a = -grad phi of all particles      potential energy  m phi / 2
//! ```
//!
//! Along a periodic axis of length L a particle that falls re-enters from above: its n counts how often it has crossed the period,
//! so that the work of gravity stays known. Gravity is added to accelerations before motion is prescribed, so that a held
//! particle's support also bears its weight. Over time uniform gravity gives all matter the momentum M g t; particles' own gravity
//! gives none.
//!
//! Evaluations of own gravity may be rarer than steps. A particle that kept the acceleration of the last one would be pulled to
//! where the centre was: a body that rotates by an angle of theta in one interval would gain angular momentum at first order in
//! theta. Between evaluations n and n + 1 the field is therefore extrapolated, `s` seconds after t_n:
//!
//! ```text
//! a = a_n + s u,    phi = phi_n + s (phi_n - phi_(n-1)) / T_n,    T_n = t_n - t_(n-1)
//! u = d_n + 0.8 T_n / (T_n + T_(n-1)) (d_n - d_(n-1)),            d_n = (a_n - a_(n-1)) / T_n
//! ```
//!
//! u is the rate at t_n - T_n / 10 of the parabola through the last three evaluations. For a rotating body or pair, the torque
//! of the change alone (u = d_n) is on average a theta^3 / 3, that with the rate at t_n a theta^3 / 12 the other way; here
//! theta^3 cancels. At the start the first interval is one step, and each next one at most twice as long as the one before.
//!
//! Columns, with own gravity only: `gravity`, `gravitational_potential`, as last evaluated; where evaluations are rarer than steps
//! `gravity_rate`, `gravity_slope`, `gravitational_potential_rate`: u, d_n and the rate of phi; where uniform gravity acts along a
//! period: `rounds`, n.
//! Time step: that of all accelerations.

use serde::{Deserialize, Serialize};

use super::{Body, Field, Opening, solve_later};
use crate::domain::comm::{Comm, Overlapped};
use crate::math::Vec3;
use crate::particles::{Chunk, Column, ColumnInfo, Columns, Life, ParticleId, Rates, Registry};

/// Cells farther than their size over this see each other as expansions; nearer to 1 these converge too slowly.
const ANGLE: f64 = 0.9;
/// [`ANGLE`] while accelerations, by which errors are measured, are not known yet.
const FIRST_ANGLE: f64 = 0.7;
/// From the middle of the last interval to where the rate is taken, over the interval: there the torque on a rotating body cancels.
const FORWARD: f64 = 0.4;

/// The gravity of a scene.
#[derive(Debug, Clone, Copy)]
pub struct Attraction {
    /// m/s^2.
    pub uniform: Vec3,
    /// How often particles crossed the periods, and the lengths of these, m; where uniform gravity acts along one.
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
    /// Rates of change until the next evaluation, where that is not the next step.
    pub rates: Option<FieldRates>,
    /// Error of one cell's expansion that a particle may feel, over its acceleration.
    pub accuracy: f64,
    /// Seconds from one evaluation to the next; zero for every step.
    pub interval: f64,
}

/// Columns of how a kept field changes.
#[derive(Debug, Clone, Copy)]
pub struct FieldRates {
    /// Rate u at which the acceleration is extrapolated, m/s^3.
    acceleration: Column<Vec3>,
    /// Mean rate d_n of the acceleration over the last interval, m/s^3.
    slope: Column<Vec3>,
    /// Rate of the potential, J/(kg s).
    potential: Column<f64>,
}

/// When own gravity was evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Timing {
    /// Seconds since the last evaluation, if there was one.
    pub age: Option<f64>,
    /// Seconds between the last two, and between the two before the last; 0 where there were none.
    pub spans: [f64; 2],
}

impl Timing {
    /// An evaluation takes place.
    fn restart(&mut self) {
        self.spans = [self.age.unwrap_or(0.0), self.spans[0]];
        self.age = Some(0.0);
    }
}

/// Fields at particles, being evaluated.
pub type Evaluation<'a> = Overlapped<'a, Vec<Field>>;

/// Particles as gravity sees them.
pub struct Matter<'a> {
    pub id: Column<ParticleId>,
    pub position: Column<Vec3>,
    /// Mass of particle `i` of a body, kg, and its smoothing length, m.
    pub mass_and_softening: &'a dyn Fn(&Columns, usize) -> (f64, f64),
}

impl Attraction {
    /// Adds to the accelerations of a chunk, m/s^2; `age` seconds after own gravity was evaluated.
    pub fn add(&self, chunk: &Chunk, age: f64, dimension: usize, rates: &Rates) {
        for (i, a) in rates.acceleration.chunks_exact(dimension).take(chunk.len()).enumerate() {
            let own = self.own.map_or(Vec3::zeros(), |own| {
                let rate = own.rates.map_or(Vec3::zeros(), |rates| chunk.view(rates.acceleration).get(i));
                chunk.view(own.acceleration).get(i) + rate * age
            });
            (0..dimension).for_each(|k| a[k].set(a[k].get() + (self.uniform[k] + own[k])));
        }
    }

    /// Potential energy of particle `i` over its mass, J/kg, so that the sum over all is that of all; `age` seconds after own gravity
    /// was evaluated.
    pub fn energy(&self, columns: &Columns, age: f64, i: usize, x: &Vec3) -> f64 {
        let gone = self.rounds.map_or(*x, |(rounds, length)| x + columns.get(rounds, i).component_mul(&length));
        let own = self.own.map_or(0.0, |own| {
            let rate = own.rates.map_or(0.0, |rates| columns.get(rates.potential, i));
            0.5 * (columns.get(own.potential, i) + rate * age)
        });
        own - self.uniform.dot(&gone)
    }
}

/// Name of the column that counts crossings of the periods.
pub const ROUNDS: &str = "rounds";

/// Declares the count of crossings of the periods.
pub fn declare_rounds(registry: &mut Registry) -> Column<Vec3> {
    let about = "Crossings of each period by the particle, forwards less backwards.";
    let info = ColumnInfo { name: ROUNDS, unit: "", about, life: Life::State, snapshot: false };
    registry.owner("gravity").column(info)
}

impl OwnGravity {
    /// `interval`: seconds from one evaluation to the next.
    pub fn declare(registry: &mut Registry, accuracy: f64, interval: f64) -> Self {
        let kept = |name, unit, about, snapshot| ColumnInfo { name, unit, about, life: Life::Kept, snapshot };
        registry.owner("gravity");
        let about = "Acceleration by the gravity of all particles, as last evaluated.";
        let acceleration = registry.column(kept("gravity", "m/s^2", about, false));
        let about = "Gravitational potential of all other particles, as last evaluated.";
        let potential = registry.column(kept("gravitational_potential", "J/kg", about, true));
        let rates = (interval > 0.0).then(|| {
            let about = "Rate at which the acceleration of gravity is extrapolated until it is evaluated again.";
            let acceleration = registry.column(kept("gravity_rate", "m/s^3", about, false));
            let about = "Mean rate of change of the acceleration of gravity between its last two evaluations.";
            let slope = registry.column(kept("gravity_slope", "m/s^3", about, false));
            let about = "Mean rate of change of the gravitational potential between its last two evaluations.";
            let potential = registry.column(kept("gravitational_potential_rate", "J/(kg s)", about, false));
            FieldRates { acceleration, slope, potential }
        });
        Self { acceleration, potential, rates, accuracy, interval }
    }

    /// Seconds for which the last evaluation is used: a change over a short time says little about a long one.
    pub fn lasts(&self, timing: &Timing) -> f64 {
        timing.age.map_or(0.0, |_| self.interval.min(2.0 * timing.spans[0]))
    }

    /// Whether a step of `dt` seconds must evaluate it anew, at its end.
    pub fn is_due(&self, timing: &Timing, dt: f64) -> bool {
        timing.age.is_none_or(|age| age + 0.5 * dt >= self.lasts(timing))
    }

    /// Starts an evaluation at all particles as they are, with other work meanwhile; [`OwnGravity::keep`] takes its result.
    /// `first`: there was none before. Collective.
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

    /// Takes over the result of an evaluation, in the order of the particles that it was begun with, `timing.age` seconds after the
    /// one before.
    pub fn keep(&self, columns: &mut Columns, fields: &[Field], timing: &mut Timing) {
        timing.restart();
        for (i, Field { acceleration, potential }) in fields.iter().enumerate() {
            let acceleration = Vec3::from(*acceleration);
            if let Some(rates) = self.rates {
                let [before, last] = [columns.get(self.acceleration, i), columns.get(rates.slope, i)];
                let [rate, slope] = rates_after(before, acceleration, last, &timing.spans);
                columns.set(rates.acceleration, i, rate);
                columns.set(rates.slope, i, slope);
                let change = potential - columns.get(self.potential, i);
                columns.set(rates.potential, i, over(change, timing.spans[0]));
            }
            columns.set(self.acceleration, i, acceleration);
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

/// The rate at which an acceleration is extrapolated, and its slope: from the last two values, the slope before and the spans, as
/// in [`Timing`].
fn rates_after(before: Vec3, now: Vec3, slope_before: Vec3, spans: &[f64; 2]) -> [Vec3; 2] {
    let [span, span_before] = *spans;
    if span == 0.0 {
        return [Vec3::zeros(); 2];
    }
    let slope = (now - before) / span;
    let bend = if span_before == 0.0 { 0.0 } else { 2.0 * FORWARD * span / (span + span_before) };
    [slope + (slope - slope_before) * bend, slope]
}

fn over(change: f64, span: f64) -> f64 {
    if span == 0.0 { 0.0 } else { change / span }
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
        let timing = |age: Option<f64>| Timing { age, spans: [10.0; 2] };
        assert!(own.is_due(&timing(None), 1.0), "there was none before");
        for (since, dt, due) in [
            (0.0, 1.0, false),
            (9.4, 1.0, false),
            (9.5, 1.0, true),
            (9.6, 1.0, true),
            (7.9, 4.0, false),
            (8.0, 4.0, true),
        ] {
            assert_eq!(own.is_due(&timing(Some(since)), dt), due, "{since} {dt}");
        }
        let always = OwnGravity { interval: 0.0, ..own };
        assert!(always.is_due(&timing(Some(0.0)), 1e-9));
    }

    /// The mean torque of an extrapolated field on a body that rotates by `turn` in an interval, over its acceleration.
    fn torque(turn: f64, spans: [f64; 2]) -> f64 {
        let pull = |angle: f64| Vec3::new(-angle.cos(), -angle.sin(), 0.0);
        let at = |time: f64| pull(turn * time);
        let [last, before] = [-spans[0], -spans[0] - spans[1]];
        let [_, slope] = rates_after(at(before), at(last), Vec3::zeros(), &[spans[1], 0.0]);
        let [rate, _] = rates_after(at(last), at(0.0), slope, &spans);
        let parts = 1000;
        let one = |part: usize| {
            let age = (part as f64 + 0.5) / parts as f64;
            (-at(age)).cross(&(at(0.0) + rate * age)).z
        };
        (0..parts).map(one).sum::<f64>() / parts as f64
    }

    #[test]
    fn what_turns_is_pulled_to_its_centre() {
        for turn in [0.003, 0.03] {
            // Without rates turn / 2, with the slope alone turn^3 / 3.
            let off = torque(turn, [1.0, 1.0]);
            assert!(off.abs() < 0.02 * turn.powi(3), "{turn}: {off:e}");
            // With uneven intervals a smaller part of the third power stays.
            let off = torque(turn, [1.0, 0.8]);
            assert!(off.abs() < 0.1 * turn.powi(3), "{turn}: {off:e}");
        }
    }

    #[test]
    fn what_changes_evenly_goes_on_evenly() {
        let accelerations = [1.0, 2.0, 4.0].map(|x| Vec3::new(x, 0.0, 0.0));
        let mut timing = Timing::default();
        timing.restart();
        assert_eq!((timing.age, timing.spans), (Some(0.0), [0.0; 2]));
        assert_eq!(rates_after(Vec3::zeros(), accelerations[0], Vec3::zeros(), &timing.spans), [Vec3::zeros(); 2]);
        timing.age = Some(0.5);
        timing.restart();
        assert_eq!(timing.spans, [0.5, 0.0]);
        let [rate, slope] = rates_after(accelerations[0], accelerations[1], Vec3::zeros(), &timing.spans);
        assert_eq!((rate.x, slope.x), (2.0, 2.0));
        timing.age = Some(1.0);
        timing.restart();
        let [rate, next] = rates_after(accelerations[1], accelerations[2], slope, &timing.spans);
        assert_eq!((rate, next), (slope, slope));
    }
}
