//! Predictor-corrector with one evaluation per step, of second order:
//!
//!   predict   x += dt v + dt^2/2 a,   v += dt a,   q += dt q'          (a, q' of the last evaluation)
//!   correct   v += dt/2 (a_new - a),  q += dt/2 (q'_new - q')
//!
//! for every integrated column q. Positions are not corrected: this is the velocity form of Verlet's scheme, and what is a
//! neighbour then follows from the prediction alone. Irreversible state (damage) is no integrated column: it grows once per
//! step and is never taken back.

use std::cell::Cell;

use crate::material::Core;
use crate::particles::{Chunk, Registry};

#[inline]
fn advance(value: &Cell<u64>, by: f64) {
    value.set((f64::from_bits(value.get()) + by).to_bits());
}

/// Moves a chunk on by `dt`.
pub fn predict(chunk: &Chunk, registry: &Registry, core: &Core, dt: f64) {
    let (position, velocity) = (chunk.words(core.position.index), chunk.words(core.velocity.index));
    for ((x, v), a) in position.iter().zip(velocity).zip(chunk.words(core.acceleration.index)) {
        let a = f64::from_bits(a.get());
        advance(x, dt * f64::from_bits(v.get()) + 0.5 * dt * dt * a);
        advance(v, dt * a);
    }
    for &(value, rate) in &registry.integrated {
        for (q, rate) in chunk.words(value).iter().zip(chunk.words(rate)) {
            advance(q, dt * f64::from_bits(rate.get()));
        }
    }
}

/// Corrects what [`predict`] did, with the rates at its end; these become the rates of the next prediction.
pub fn correct(chunk: &Chunk, registry: &Registry, core: &Core, new: &NewRates, dt: f64) {
    let half = 0.5 * dt;
    let mend = |value: &Cell<u64>, rate: &Cell<u64>, new: f64| {
        advance(value, half * (new - f64::from_bits(rate.get())));
        rate.set(new.to_bits());
    };
    let (velocity, acceleration) = (chunk.words(core.velocity.index), chunk.words(core.acceleration.index));
    for ((v, a), new) in velocity.iter().zip(acceleration).zip(new.acceleration) {
        mend(v, a, *new);
    }
    for (&(value, rate), new) in registry.integrated.iter().zip(new.integrated) {
        for ((q, rate), new) in chunk.words(value).iter().zip(chunk.words(rate)).zip(new) {
            mend(q, rate, f64::from_bits(new.get()));
        }
    }
}

/// Rates that a chunk's evaluation found.
pub struct NewRates<'a> {
    /// D numbers per particle, m/s^2.
    pub acceleration: &'a [f64],
    /// One block per integrated column.
    pub integrated: &'a [Vec<Cell<u64>>],
}
