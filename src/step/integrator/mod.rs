//! How steps are made of evaluations. An evaluation turns a state into rates and changes nothing (`derivatives`); an integrator
//! owns the columns that it needs beside the state (rates of before, copies), says at which moments of a step it needs rates,
//! moves a chunk there, and takes the rates:
//!
//! ```text
//! for each stage                      predictor-corrector       Runge-Kutta, for one that may refuse
//!     move to the moment of it        x + dt v ...              stage 0: stays; later ones: x + dt (k_0 ...)
//!     admit, update (, commit)        with commit               without
//!     rates of that state
//!     take them                       correct                   stage 0: keep k_0, copy; ...; the last: finish, error
//!     one reduction over ranks
//! accept: update, commit              has committed             refuse: set back, try less
//! ```
//! An integrator that never refuses commits irreversible changes before its evaluation, so that they act on neighbours at once; one
//! that may refuse commits when a step is accepted. Everything is local to a particle; global values go through the
//! reduction of the stage.
//!
//! Adding one: a file here, its key in the scene's `[numerics]`, and the line that selects it where a run is set up.

pub mod cash_karp;
mod copies;
pub mod error;
pub mod predictor_corrector;
pub mod runge_kutta;
mod tableau;

use crate::material::Core;
use crate::math::Vec3;
use crate::motion::rigid::{RigidBody, RigidRates};
use crate::particles::{Chunk, Column, Rates, Registry};
pub use cash_karp::CashKarp;
pub use copies::AT_START;
pub use error::{QUANTITIES, StepError};
pub use predictor_corrector::PredictorCorrector;
pub use runge_kutta::RungeKutta;

/// Velocities of this share of the speed of sound are rest: smaller errors than those tolerated of them are those of rounding, which no
/// step makes smaller.
const REST: f64 = 1e-6;

/// A rigid body whose error moves it by less than this share of its size in a step is as exact as its place can be.
const ROUNDING: f64 = 1e-14;

/// The error of a rigid body's velocity by these differences of weights, m/s, as that of the quantity with this number.
fn rigid_error(body: &RigidBody, weights: &[f64], dt: f64, quantity: usize) -> StepError {
    let (mut error, off) = (StepError::default(), body.velocity_by(weights, dt));
    if off * dt > ROUNDING * body.reach {
        error.note(quantity, off);
    }
    error
}

/// Advances the particles of a run through its steps.
pub trait Integrator: Send + Sync {
    /// The moment of each evaluation as a share of the step: 0 its beginning, 1 its end; a stage at 0 comes first, if at all.
    fn stages(&self) -> &'static [f64];

    /// Whether a step may be refused; irreversible state is then committed once it is accepted.
    fn may_refuse(&self) -> bool;

    /// Moves a chunk to the moment of a stage that is not at the step's beginning.
    fn advance(&self, chunk: &Chunk, stage: usize, dt: f64);

    /// Takes the rates of a stage; after the last one it brings the chunk to the end of the step, and returns the error.
    fn take(&self, chunk: &Chunk, rates: &Rates, stage: usize, dt: f64) -> StepError;

    /// How many quantities of [`StepError`] are in use.
    fn controlled(&self) -> usize {
        0
    }

    /// Sets a chunk back to the beginning of the step.
    fn set_back(&self, _chunk: &Chunk) {}

    /// Moves a rigid body to the moment of a stage that is not at the step's beginning, as [`Integrator::advance`] moves particles.
    fn advance_rigid(&self, body: &mut RigidBody, stage: usize, dt: f64);

    /// Takes the rates of a rigid body at a stage, as [`Integrator::take`] does those of particles. Setting back is the body's own.
    fn take_rigid(&self, body: &mut RigidBody, rates: &RigidRates, stage: usize, dt: f64) -> StepError;

    /// Accepts or refuses a step of `dt` seconds with this error; `speed`: the largest relative velocity of any two particles, m/s.
    fn judge(&self, _error: &StepError, _speed: f64, _dt: f64) -> Verdict {
        Verdict::Accept { most: f64::INFINITY }
    }
}

/// Whether a step is accepted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Verdict {
    /// It counts; by its error the next one may be `most` seconds long.
    Accept { most: f64 },
    /// It is set back; one of `next` seconds is tried instead.
    Refuse { next: f64 },
}

/// The columns that every integrator advances.
#[derive(Debug, Clone)]
struct Moved {
    position: Column<Vec3>,
    velocity: Column<Vec3>,
    /// Index of every integrated column.
    integrated: Vec<usize>,
}

impl Moved {
    fn new(registry: &Registry, core: &Core) -> Self {
        Self { position: core.position, velocity: core.velocity, integrated: registry.integrated.clone() }
    }
}

/// Adds to a number that is stored as a 64-bit word.
#[inline]
fn add(value: &std::cell::Cell<u64>, by: f64) {
    value.set((f64::from_bits(value.get()) + by).to_bits());
}
