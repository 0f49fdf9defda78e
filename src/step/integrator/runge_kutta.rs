//! Heun's scheme with error control, of second order, two evaluations per step (Hairer, Norsett & Wanner 1993, Solving Ordinary
//! Differential Equations I, II.1 and II.4):
//!
//! ```text
//! k_0 = f(y),    k_1 = f(y + dt k_0),    y' = y + dt/2 (k_0 + k_1)
//! e = dt/2 |k_1 - k_0|      the difference to Euler's step, which is embedded
//! ```
//! for positions, velocities and every integrated column. The error over the tolerated one is
//! E = max(e_v / w, e_rho / rho) / tolerance, w the largest relative velocity of any two particles. A step with E > 1 is refused;
//! the next one is dt clamp(0.9 / sqrt(E), 1/5, 2) long, and no longer than the limits of any step.
//!
//! Errors of a velocity below tolerance times 1e-6 of the speed of sound do not count, or matter at rest would have its rounding errors
//! controlled.
//!
//! Irreversible changes start at each stage from the last accepted state. Columns: k_0 of velocities and of every integrated
//! column, and a copy of every state column.

use std::cell::Cell;

use super::copies::Copies;
use super::error::share;
use super::{Integrator, Moved, REST, StepError, Verdict, add, rigid_error};
use crate::material::Core;
use crate::motion::rigid::{RigidBody, RigidRates};
use crate::particles::{Chunk, Column, Life, Rates, Registry};

/// Next step over the one that the error would just allow.
const CAUTION: f64 = 0.9;
/// Bounds of the next step over this one.
const CHANGE: [f64; 2] = [0.2, 2.0];

/// Quantities whose errors are controlled.
const VELOCITY: usize = 0;
const DENSITY: usize = 1;

pub struct RungeKutta {
    moved: Moved,
    /// Number of the density among the integrated columns.
    density: usize,
    /// Columns of k_0: of velocities, and of each integrated column.
    acceleration: usize,
    rates: Vec<usize>,
    copies: Copies,
    velocity_copy: usize,
    sound_speed: Column<f64>,
    tolerance: f64,
}

impl RungeKutta {
    pub fn declare(registry: &mut Registry, core: &Core, tolerance: f64) -> Self {
        let moved = Moved::new(registry, core);
        let copies = Copies::declare(registry);
        Self {
            density: core.density.slot,
            acceleration: registry.like(moved.velocity.index, "_rate", Life::Scratch),
            rates: moved.integrated.iter().map(|&index| registry.like(index, "_rate", Life::Scratch)).collect(),
            velocity_copy: copies.of(moved.velocity.index),
            copies,
            moved,
            sound_speed: core.sound_speed,
            tolerance,
        }
    }

    /// Sets the state back to y and advances it by the velocity and the rates of stage 0.
    fn euler(&self, chunk: &Chunk, dt: f64) {
        self.set_back(chunk);
        let by = |value: usize, rate: usize| {
            for (q, rate) in chunk.words(value).iter().zip(chunk.words(rate)) {
                add(q, dt * f64::from_bits(rate.get()));
            }
        };
        by(self.moved.position.index, self.velocity_copy);
        by(self.moved.velocity.index, self.acceleration);
        self.moved.integrated.iter().zip(&self.rates).for_each(|(&value, &rate)| by(value, rate));
    }

    /// Keeps stage 0: the rates, and a copy of the state.
    fn keep(&self, chunk: &Chunk, rates: &Rates) {
        for (kept, a) in chunk.words(self.acceleration).iter().zip(&rates.acceleration) {
            kept.set(a.get().to_bits());
        }
        for (&kept, new) in self.rates.iter().zip(rates.blocks()) {
            chunk.words(kept).iter().zip(new).for_each(|(kept, new)| kept.set(new.get()));
        }
        self.copies.make(chunk);
    }

    /// From the rates at y + dt k_0 to the end of the step.
    fn finish(&self, chunk: &Chunk, rates: &Rates, dt: f64) -> StepError {
        self.euler(chunk, dt);
        let half = 0.5 * dt;
        let mean = |q: &Cell<u64>, first: f64, second: f64| {
            add(q, half * (second - first));
            half * (second - first).abs()
        };
        let first_of = |word: &Cell<u64>| f64::from_bits(word.get());
        let (position, velocity) = (chunk.words(self.moved.position.index), chunk.words(self.moved.velocity.index));
        // Here the velocity is still that of stage 1.
        for ((x, first), second) in position.iter().zip(chunk.words(self.velocity_copy)).zip(velocity) {
            mean(x, first_of(first), first_of(second));
        }
        let mut error = StepError::default();
        let (sound_speed, width) = (chunk.view(self.sound_speed), velocity.len() / chunk.len().max(1));
        let velocities = velocity.iter().zip(chunk.words(self.acceleration)).zip(&rates.acceleration);
        for (k, ((v, first), second)) in velocities.enumerate() {
            let off = mean(v, first_of(first), second.get());
            if off > REST * self.tolerance * sound_speed.get(k / width) {
                error.note(VELOCITY, off);
            }
        }
        for (slot, (&value, &rate)) in self.moved.integrated.iter().zip(&self.rates).enumerate() {
            let second = rates.blocks().nth(slot).expect("a block for each integrated column");
            for ((q, first), second) in chunk.words(value).iter().zip(chunk.words(rate)).zip(second) {
                let off = mean(q, first_of(first), f64::from_bits(second.get()));
                if slot == self.density {
                    error.note(DENSITY, off / f64::from_bits(q.get()));
                }
            }
        }
        error
    }
}

impl Integrator for RungeKutta {
    fn stages(&self) -> &'static [f64] {
        &[0.0, 1.0]
    }

    fn may_refuse(&self) -> bool {
        true
    }

    fn advance(&self, chunk: &Chunk, _stage: usize, dt: f64) {
        self.euler(chunk, dt);
    }

    fn take(&self, chunk: &Chunk, rates: &Rates, stage: usize, dt: f64) -> StepError {
        if stage == 0 {
            self.keep(chunk, rates);
            return StepError::default();
        }
        self.finish(chunk, rates, dt)
    }

    fn controlled(&self) -> usize {
        2
    }

    fn set_back(&self, chunk: &Chunk) {
        self.copies.restore(chunk);
    }

    fn advance_rigid(&self, body: &mut RigidBody, _stage: usize, dt: f64) {
        body.move_by(&[1.0], dt);
    }

    fn take_rigid(&self, body: &mut RigidBody, rates: &RigidRates, stage: usize, dt: f64) -> StepError {
        body.keep(rates, stage);
        if stage == 0 {
            return StepError::default();
        }
        let error = rigid_error(body, &[-0.5, 0.5], dt, VELOCITY);
        body.move_by(&[0.5, 0.5], dt);
        error
    }

    fn judge(&self, error: &StepError, speed: f64, dt: f64) -> Verdict {
        let share = |quantity: usize, size: f64| share(error.errors[quantity], size, self.tolerance);
        let error = share(VELOCITY, speed).max(share(DENSITY, 1.0));
        let change = if error > 0.0 { (CAUTION / error.sqrt()).clamp(CHANGE[0], CHANGE[1]) } else { CHANGE[1] };
        match error <= 1.0 {
            true => Verdict::Accept { most: change * dt },
            false => Verdict::Refuse { next: change * dt },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::declare_core;

    #[test]
    fn steps_are_refused_by_their_error_and_grow_back() {
        let mut registry = Registry::new(3);
        let core = declare_core(&mut registry);
        let scheme = RungeKutta::declare(&mut registry, &core, 1e-3);
        let off = |quantity: usize, off: f64| {
            let mut error = StepError::default();
            error.note(quantity, off);
            error
        };
        let judge = |velocity: f64| scheme.judge(&off(VELOCITY, velocity), 10.0, 1.0);
        assert_eq!(judge(0.0), Verdict::Accept { most: 2.0 });
        assert_eq!(judge(0.01), Verdict::Accept { most: 0.9 });
        assert_eq!(judge(0.04), Verdict::Refuse { next: 0.45 });
        assert_eq!(judge(1e9), Verdict::Refuse { next: 0.2 });
        let dense = scheme.judge(&off(DENSITY, 4e-3), 0.0, 1.0);
        assert_eq!(dense, Verdict::Refuse { next: 0.45 });
    }
}
