//! The motion of one rigid body: its state, the rates that forces give it, and the state after a combination of rates. Nothing here
//! knows an integrator or a particle.
//!
//! ```text
//! dX/dt = V,    dV/dt = F / m,    dL/dt = T,    w = R J^-1 R^T L,    R: rotation from the body's frame into space
//! ```
//! X centre of mass, m; V its velocity, m/s; F force, N; L angular momentum about the centre, kg m^2/s; T torque about it, N m; J
//! inertia in the body's frame, kg m^2; w angular velocity, 1/s. In 2D all turning is about z.
//!
//! A motion that a scene prescribes changes F and T; its work and impulse are integrated with the rest (see `motion`).

use serde::{Deserialize, Serialize};

use super::turning::{Orientation, turning};
use crate::math::{Mat3, Vec3};
use crate::motion::PrescribedMotion;

/// Largest angle of one substep of a turn, rad: the error of a turn is then some 1e-9 of it.
const TURN: f64 = 0.02;
/// Largest step over the time constant of damping.
const DAMPING_STEP: f64 = 0.25;

/// Vectors in files.
mod vector {
    use super::Vec3;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub fn serialize<S: Serializer>(vector: &Vec3, serializer: S) -> Result<S::Ok, S::Error> {
        <[f64; 3]>::from(*vector).serialize(serializer)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec3, D::Error> {
        <[f64; 3]>::deserialize(deserializer).map(Vec3::from)
    }
}

/// How a rigid body moves.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct RigidMotion {
    /// Centre of mass, m.
    #[serde(with = "vector")]
    pub centre: Vec3,
    /// m/s.
    #[serde(with = "vector")]
    pub velocity: Vec3,
    /// About the centre, kg m^2/s.
    #[serde(with = "vector")]
    pub angular_momentum: Vec3,
    pub orientation: Orientation,
    /// Work done by the prescribed motion, J.
    pub work: f64,
    /// Momentum added by the prescribed motion, kg m/s.
    #[serde(with = "vector")]
    pub impulse: Vec3,
}

/// How fast all that changes.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct RigidRates {
    /// m/s.
    #[serde(with = "vector")]
    pub velocity: Vec3,
    /// m/s^2.
    #[serde(with = "vector")]
    pub acceleration: Vec3,
    /// N m.
    #[serde(with = "vector")]
    pub torque: Vec3,
    /// Rate of the rotation vector since the step's beginning, 1/s.
    #[serde(with = "vector")]
    pub turning: Vec3,
    /// Power of the prescribed motion, W.
    pub power: f64,
    /// Force of the prescribed motion, N.
    #[serde(with = "vector")]
    pub push: Vec3,
}

/// What acts on a rigid body from outside.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Load {
    /// N.
    #[serde(with = "vector")]
    pub force: Vec3,
    /// About the centre of mass, N m.
    #[serde(with = "vector")]
    pub torque: Vec3,
}

/// What a scene says of how a rigid body moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Guidance {
    pub motion: PrescribedMotion,
    /// Whether it may turn.
    pub rotation: bool,
}

/// A rigid body: its matter, its motion, and what integrators keep of its rates. The same on every rank.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct RigidBody {
    /// Number of the scene's body.
    pub body: usize,
    /// kg (per metre of depth in 2D).
    pub mass: f64,
    /// J^-1, 1/(kg m^2); zero about axes about which it does not turn.
    pub mobility: [[f64; 3]; 3],
    /// Largest distance of a particle from the centre, m.
    pub reach: f64,
    pub motion: RigidMotion,
    /// At the last evaluation.
    pub load: Load,
    /// Of the last evaluation, where an integrator goes on from them.
    pub rates: RigidRates,
    /// Change of acceleration and torque over the last step, divided by its length, m/s^3 and N m/s.
    pub slope: [[f64; 3]; 2],
    /// The motion at the beginning of the step.
    #[serde(skip)]
    start: RigidMotion,
    /// Rotation vector since then, rad.
    #[serde(skip)]
    turned: Vec3,
    /// Rates of the stages of the step so far.
    #[serde(skip)]
    stages: Vec<RigidRates>,
}

impl RigidBody {
    /// A body without load. `mobility`: J^-1; for the others see the fields.
    pub fn new(body: usize, mass: f64, mobility: &Mat3, reach: f64, motion: RigidMotion) -> Self {
        let mobility = std::array::from_fn(|a| std::array::from_fn(|b| mobility[(a, b)]));
        Self { body, mass, mobility, reach, motion, ..Self::default() }
    }

    fn matrix(&self) -> Mat3 {
        Mat3::from_fn(|a, b| self.mobility[a][b])
    }

    /// Angular velocity with the angular momentum `l`, kg m^2/s, in an orientation, 1/s.
    fn spin_of(&self, orientation: &Orientation, l: &Vec3) -> Vec3 {
        let r = orientation.matrix();
        r * (self.matrix() * r.tr_mul(l))
    }

    /// Angular velocity, 1/s.
    pub fn spin(&self) -> Vec3 {
        self.spin_of(&self.motion.orientation, &self.motion.angular_momentum)
    }

    /// The rates by what acts on the body at the time `now`, s.
    pub fn rates_by(&self, load: &Load, guidance: &Guidance, now: f64) -> RigidRates {
        let Load { force, torque } = *load;
        let RigidMotion { velocity, angular_momentum, .. } = self.motion;
        let spin = self.spin();
        let (mut held, mut turning_by) = (force, torque);
        match guidance.motion {
            PrescribedMotion::Free => {}
            PrescribedMotion::Prescribed(_) => held = Vec3::zeros(),
            PrescribedMotion::Along(along) => held = Vec3::from_fn(|k, _| if along[k] { force[k] } else { 0.0 }),
            motion @ PrescribedMotion::Damped { time, towards, .. } => {
                if !motion.is_free(now) {
                    held -= (velocity - Vec3::from(towards)) * (self.mass / time);
                    turning_by -= angular_momentum / time;
                }
            }
        }
        let push = held - force;
        let power = push.dot(&velocity) + (turning_by - torque).dot(&spin);
        RigidRates {
            velocity,
            acceleration: held / self.mass,
            torque: if guidance.rotation { turning_by } else { Vec3::zeros() },
            turning: turning(&self.turned, &spin),
            power,
            push,
        }
    }

    /// A step of an integrator begins: what follows counts from here.
    pub fn begin(&mut self) {
        (self.start, self.turned) = (self.motion, Vec3::zeros());
        self.stages.clear();
    }

    /// Keeps the rates of a stage.
    pub fn keep(&mut self, rates: &RigidRates, stage: usize) {
        self.stages.truncate(stage);
        self.stages.push(*rates);
    }

    /// The motion at the step's beginning, advanced by `dt` seconds of the stages' rates with these weights.
    pub fn move_by(&mut self, weights: &[f64], dt: f64) {
        let (mut motion, mut turned) = (self.start, Vec3::zeros());
        for (rates, weight) in self.stages.iter().zip(weights) {
            let by = dt * weight;
            motion.centre += rates.velocity * by;
            motion.velocity += rates.acceleration * by;
            motion.angular_momentum += rates.torque * by;
            motion.work += rates.power * by;
            motion.impulse += rates.push * by;
            turned += rates.turning * by;
        }
        motion.orientation = self.start.orientation.turned(&turned);
        (self.motion, self.turned) = (motion, turned);
    }

    /// Sets the body back to the beginning of the step.
    pub fn set_back(&mut self) {
        (self.motion, self.turned) = (self.start, Vec3::zeros());
    }

    /// Largest velocity of a particle, m/s, by `dt` seconds of the stages' rates with these weights: the error of a step, where the
    /// weights are differences.
    pub fn velocity_by(&self, weights: &[f64], dt: f64) -> f64 {
        let (mut velocity, mut angular_momentum) = (Vec3::zeros(), Vec3::zeros());
        for (rates, weight) in self.stages.iter().zip(weights) {
            velocity += rates.acceleration * (dt * weight);
            angular_momentum += rates.torque * (dt * weight);
        }
        velocity.norm() + self.spin_of(&self.motion.orientation, &angular_momentum).norm() * self.reach
    }

    /// The orientation after `dt` seconds, with a torque that changes at a constant rate: the classical scheme of fourth order, in
    /// substeps so short that a free body keeps its energy for many turns, however long the step.
    pub fn turn(&mut self, dt: f64) {
        let l_0 = self.motion.angular_momentum;
        let (torque, slope) = (self.rates.torque, Vec3::from(self.slope[1]));
        let l = |t: f64| l_0 + torque * t + slope * (0.5 * t * t);
        let most =
            [0.0, dt].map(|t| self.spin_of(&self.motion.orientation, &l(t)).norm()).into_iter().fold(0.0, f64::max);
        if most == 0.0 {
            return;
        }
        let count = (most * dt / TURN).ceil().clamp(1.0, 1e6);
        let h = dt / count;
        let mut orientation = self.motion.orientation;
        for substep in 0..count as u32 {
            let start = f64::from(substep) * h;
            let rate =
                |turned: Vec3, t: f64| turning(&turned, &self.spin_of(&orientation.turned(&turned), &l(start + t)));
            let k_1 = rate(Vec3::zeros(), 0.0);
            let k_2 = rate(k_1 * (0.5 * h), 0.5 * h);
            let k_3 = rate(k_2 * (0.5 * h), 0.5 * h);
            let k_4 = rate(k_3 * h, h);
            orientation = orientation.turned(&((k_1 + (k_2 + k_3) * 2.0 + k_4) * (h / 6.0)));
        }
        self.motion.orientation = orientation;
    }

    /// Where a point of the body is that is `place` from its centre in its own frame, and its velocity.
    pub fn point(&self, r: &Mat3, spin: &Vec3, place: &Vec3) -> [Vec3; 2] {
        let arm = r * place;
        [self.motion.centre + arm, self.motion.velocity + spin.cross(&arm)]
    }

    /// Bound on the acceleration of its particles by the last load, m/s^2.
    pub fn fastest(&self, rates: &RigidRates) -> f64 {
        let spin = self.spin();
        let orientation = &self.motion.orientation;
        let change = self.spin_of(orientation, &(rates.torque - spin.cross(&self.motion.angular_momentum)));
        rates.acceleration.norm() + (change.norm() + spin.norm_squared()) * self.reach
    }
}

impl Guidance {
    /// Whether forces alone move the body.
    pub fn is_free(&self) -> bool {
        self.motion == PrescribedMotion::Free && self.rotation
    }

    /// The longest step that damping allows at the time `now`, s.
    pub fn longest_step(&self, now: f64) -> f64 {
        match self.motion {
            PrescribedMotion::Damped { time, .. } if !self.motion.is_free(now) => DAMPING_STEP * time,
            _ => f64::INFINITY,
        }
    }
}

/// J^-1 of an inertia, zero about axes about which there is none: a body of one particle, or of particles in a row.
pub fn mobility(inertia: &crate::math::Sym, dimension: usize) -> Mat3 {
    /// Share of the largest inertia below which there is none.
    const NONE: f64 = 1e-9;
    if dimension == 2 {
        let about_z = if inertia.zz > 0.0 { 1.0 / inertia.zz } else { 0.0 };
        return Mat3::from_diagonal(&Vec3::new(0.0, 0.0, about_z));
    }
    let (values, axes) = inertia.principal();
    let largest = values.iter().copied().fold(0.0, f64::max);
    let inverse = Vec3::from(values).map(|value| if value > NONE * largest { 1.0 / value } else { 0.0 });
    axes * Mat3::from_diagonal(&inverse) * axes.transpose()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Sym;

    /// A body that turns freely: angular momentum stays as it is, energy to the error of the turns.
    fn free(principal: [f64; 3]) -> RigidBody {
        let [xx, yy, zz] = principal;
        let mobility = mobility(&Sym { xx, yy, zz, ..Sym::ZERO }, 3);
        let motion = RigidMotion { angular_momentum: Vec3::new(0.5, 0.2, 3.0), ..RigidMotion::default() };
        RigidBody::new(0, 1.0, &mobility, 1.0, motion)
    }

    fn energy(body: &RigidBody) -> f64 {
        0.5 * body.motion.angular_momentum.dot(&body.spin())
    }

    /// Also about the axis of middle inertia, where it tumbles.
    #[test]
    fn a_free_body_keeps_its_energy() {
        let mut body = free([1.0, 3.0, 2.0]);
        let before = energy(&body);
        for _ in 0..4000 {
            body.turn(0.1);
        }
        let drift = energy(&body) / before - 1.0;
        assert!(drift.abs() < 1e-7, "{drift:e} after 400 s, {} turns", 400.0 * 1.5 / std::f64::consts::TAU);
        let norm: f64 = body.motion.orientation.0.iter().map(|q| q * q).sum();
        assert!((norm - 1.0).abs() < 1e-14);
    }

    /// The axis of a symmetric top goes round the angular momentum at |L| / J_1.
    #[test]
    fn a_symmetric_top_precesses() {
        let mut body = free([2.0, 2.0, 1.0]);
        let l = body.motion.angular_momentum;
        let period = std::f64::consts::TAU * 2.0 / l.norm();
        let axis = body.motion.orientation.matrix() * Vec3::z();
        for _ in 0..100 {
            (0..20).for_each(|_| body.turn(period / 20.0));
        }
        let off = (body.motion.orientation.matrix() * Vec3::z() - axis).norm();
        assert!(off < 1e-6, "{off:e} rad after 100 periods");
    }

    /// Heun's weights: two stages make a step of second order in the place and in the orientation.
    #[test]
    fn stages_are_combined_like_numbers() {
        let guidance = Guidance { motion: PrescribedMotion::Free, rotation: true };
        let load = |t: f64| Load { force: Vec3::new(1.0 + t, 0.0, 0.0), torque: Vec3::new(0.0, 1.0 - t, 0.5) };
        let after = |steps: u32| {
            let mut body = free([1.0, 3.0, 2.0]);
            let dt = 1.0 / f64::from(steps);
            for step in 0..steps {
                let t = f64::from(step) * dt;
                body.begin();
                body.keep(&body.rates_by(&load(t), &guidance, t), 0);
                body.move_by(&[1.0], dt);
                body.keep(&body.rates_by(&load(t + dt), &guidance, t), 1);
                body.move_by(&[0.5, 0.5], dt);
            }
            body
        };
        let exact = after(4000);
        let error = |steps: u32| {
            let body = after(steps);
            let turn = (body.motion.orientation.matrix() - exact.motion.orientation.matrix()).norm();
            turn + (body.motion.centre - exact.motion.centre).norm()
        };
        let ratio = error(20) / error(40);
        assert!((3.5..4.5).contains(&ratio), "{ratio}");
    }

    #[test]
    fn what_holds_a_body_does_the_rest_of_the_work() {
        let mut body = free([1.0, 1.0, 1.0]);
        body.motion.velocity = Vec3::new(2.0, 3.0, 0.0);
        let load = Load { force: Vec3::new(5.0, 7.0, 0.0), torque: Vec3::x() };
        let rates = |motion, rotation| body.rates_by(&load, &Guidance { motion, rotation }, 0.0);
        let along = rates(PrescribedMotion::Along([true, false, false]), false);
        assert_eq!((along.acceleration, along.push, along.power), (Vec3::x() * 5.0, Vec3::y() * -7.0, -21.0));
        assert_eq!(along.torque, Vec3::zeros());
        let held = rates(PrescribedMotion::Prescribed([2.0, 3.0, 0.0]), true);
        assert_eq!((held.acceleration, held.power, held.torque), (Vec3::zeros(), -31.0, Vec3::x()));
        let motion = PrescribedMotion::Damped { time: 0.5, towards: [0.0; 3], until: Some(1.0) };
        let damped = rates(motion, true);
        assert_eq!((damped.acceleration, damped.push), (Vec3::new(1.0, 1.0, 0.0), Vec3::new(-4.0, -6.0, 0.0)));
        assert!((damped.power + 26.0 + 2.0 * (0.25 + 0.04 + 9.0)).abs() < 1e-12, "{}", damped.power);
        assert_eq!(body.rates_by(&load, &Guidance { motion, rotation: true }, 2.0).power, 0.0);
    }

    #[test]
    fn a_row_of_particles_does_not_turn_about_itself() {
        let row = mobility(&Sym { xx: 0.0, yy: 2.0, zz: 2.0, ..Sym::ZERO }, 3);
        assert_eq!(row, Mat3::from_diagonal(&Vec3::new(0.0, 0.5, 0.5)));
        assert_eq!(mobility(&Sym::ZERO, 3), Mat3::zeros());
        assert_eq!(mobility(&Sym { zz: 4.0, ..Sym::ZERO }, 2)[(2, 2)], 0.25);
    }
}
