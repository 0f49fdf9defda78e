//! The scheme of Cash & Karp (1990, ACM Trans. Math. Softw. 16, 201), of fifth order, six evaluations per step, with error control per
//! quantity:
//!
//! ```text
//! y_i = y_0 + dt sum_j a_ij k_j,   k_i = f(y_i)          stages at 0, 1/5, 3/10, 3/5, 1, 7/8 of the step
//! y'  = y_0 + dt sum_j b_j k_j,    e = dt |sum_j (b_j - b*_j) k_j|      b* of fourth order, embedded
//! ```
//! for positions, velocities and every integrated column. The error over the tolerated one is
//! E = max over quantities of e_q / (size_q tolerance_q). A step with E > 1 is refused; the next one is
//! dt clamp(0.8 E^(-1/5), 1/5, 5) long, and no longer than the limits of any step.
//!
//! | quantity | its size | what does not count |
//! |---|---|---|
//! | velocity | largest relative velocity of any two particles | errors below tolerance times 1e-6 c |
//! | position | smoothing length of the particle | |
//! | density | that of the particle | |
//! | any other column | largest \|q\| + dt \|q'\| of all particles | below tolerance times 1e-6 of rho c^2 (Pa), c^2 (J/kg) or 1 (numbers) |
//!
//! dt |q'| stands in the size as a standing wave has no stress at all twice in each period (Press et al. 1992, Numerical Recipes, 16.2). What
//! does not count is what velocities of 1e-6 c bring about: the stress rho c v, the energy c v. It keeps the rounding errors of matter at
//! rest from being controlled. Columns that only keep accounts (in no snapshot) are advanced without control.
//!
//! Stability: vibrations that nothing damps are amplified by 1.4e-4 (w dt)^6 per step (|R(iy)|^2 = 1 + y^6 / 3600 + ...), those that are
//! damped die away up to w dt = 3.7 on the real axis. Which Courant numbers that allows is measured in
//! tests/validation/integrators.md.
//!
//! Irreversible changes start at each stage from the last accepted state. Columns: k_0 to k_4 of velocities and of every integrated
//! column, and a copy of every state column.

use std::cell::Cell;

use super::copies::Copies;
use super::error::{QUANTITIES, share};
use super::tableau::{END, ERROR, KEPT, MOMENTS, PLACE_END, PLACE_ERROR, PLACE_STAGE, STAGE, STAGES, Weights};
use super::{Integrator, Moved, REST, StepError, Verdict, add, rigid_error};
use crate::material::ParticleView;
use crate::motion::rigid::{RigidBody, RigidRates};
use crate::particles::rates::words_of;
use crate::particles::{Chunk, Life, Rates, Registry};

/// Next step over the one that the error would just allow: where viscosity begins and ends to act the error varies by its tenfold from step
/// to step, and a step that is refused costs five evaluations.
const CAUTION: f64 = 0.8;
/// Bounds of the next step over this one.
const CHANGE: [f64; 2] = [0.2, 5.0];
/// Order of the error of a step.
const ORDER: f64 = 5.0;

/// The first two of the controlled quantities.
const VELOCITY: usize = 0;
const POSITION: usize = 1;

/// The columns of k_0 to k_4 of one column.
type Kept = [usize; KEPT];

/// What the error of a column is compared with.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Size {
    /// The particle's own value.
    Own,
    /// The largest in all particles; errors of `REST` times this do not count.
    Largest(Natural),
}

/// A size that a quantity has by nature, at the speed of sound c and density rho.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Natural {
    /// rho c^2.
    Modulus,
    /// c^2.
    Energy,
    /// 1.
    One,
    Unknown,
}

/// A quantity whose error is controlled.
#[derive(Debug, Clone, PartialEq)]
struct Quantity {
    name: String,
    tolerance: f64,
}

/// An integrated column.
#[derive(Debug)]
struct Advanced {
    value: usize,
    rates: Kept,
    /// Its number among the controlled quantities, and what its error is compared with; `None` for accounts.
    control: Option<(usize, Size)>,
}

pub struct CashKarp {
    moved: Moved,
    copies: Copies,
    velocity_copy: usize,
    accelerations: Kept,
    columns: Vec<Advanced>,
    quantities: Vec<Quantity>,
    view: ParticleView,
}

impl CashKarp {
    /// `tolerance`: what a scene tolerates of each quantity, by its name.
    pub fn declare(registry: &mut Registry, view: &ParticleView, tolerance: impl Fn(&str) -> f64) -> Self {
        let moved = Moved::new(registry, &view.core);
        let copies = Copies::declare(registry);
        let kept = |registry: &mut Registry, of: usize| -> Kept {
            std::array::from_fn(|stage| registry.like(of, &format!("_rate_{stage}"), Life::Scratch))
        };
        let accelerations = kept(registry, moved.velocity.index);
        let mut quantities = Vec::new();
        let mut control = |name: &str| {
            quantities.push(Quantity { name: name.to_string(), tolerance: tolerance(name) });
            quantities.len() - 1
        };
        assert_eq!(["velocity", "position"].map(&mut control), [VELOCITY, POSITION]);
        let mut columns = Vec::new();
        for &value in &moved.integrated {
            let rates = kept(registry, value);
            let entry = &registry.entries[value];
            let size = match entry.info.unit {
                _ if value == view.core.density.value.index => Size::Own,
                "Pa" => Size::Largest(Natural::Modulus),
                "J/kg" => Size::Largest(Natural::Energy),
                "" => Size::Largest(Natural::One),
                _ => Size::Largest(Natural::Unknown),
            };
            let control = entry.info.snapshot.then(|| (control(&entry.name), size));
            columns.push(Advanced { value, rates, control });
        }
        assert!(quantities.len() <= QUANTITIES, "room for the errors of {QUANTITIES} quantities");
        let velocity_copy = copies.of(moved.velocity.index);
        Self { moved, copies, velocity_copy, accelerations, columns, quantities, view: view.clone() }
    }

    /// Names of the quantities whose errors are controlled.
    pub fn controlled_names(&self) -> Vec<&str> {
        self.quantities.iter().map(|quantity| &quantity.name[..]).collect()
    }

    /// The state of a stage, from the rates of those before.
    fn move_to(&self, chunk: &Chunk, stage: usize, dt: f64) {
        self.copies.restore(chunk);
        let moved = |value: usize, rates: &Kept, weights: &Weights, by: f64| {
            let slopes = Slopes { kept: &rates.map(|column| chunk.words(column))[..stage], last: None };
            for (k, q) in chunk.words(value).iter().enumerate() {
                add(q, by * slopes.sum(weights, k));
            }
        };
        self.drift(chunk, MOMENTS[stage] * dt);
        moved(self.moved.position.index, &self.accelerations, &PLACE_STAGE[stage], dt * dt);
        moved(self.moved.velocity.index, &self.accelerations, &STAGE[stage], dt);
        self.columns.iter().for_each(|column| moved(column.value, &column.rates, &STAGE[stage], dt));
    }

    /// Moves positions by the velocity at the beginning of the step.
    fn drift(&self, chunk: &Chunk, time: f64) {
        let places = chunk.words(self.moved.position.index).iter();
        places.zip(chunk.words(self.velocity_copy)).for_each(|(x, v)| add(x, time * number(v)));
    }

    /// Keeps the rates of a stage.
    fn keep(&self, chunk: &Chunk, rates: &Rates, stage: usize) {
        let keep = |column: usize, new: &[Cell<u64>]| {
            chunk.words(column).iter().zip(new).for_each(|(kept, new)| kept.set(new.get()));
        };
        keep(self.accelerations[stage], words_of(&rates.acceleration));
        self.columns.iter().zip(rates.blocks()).for_each(|(column, new)| keep(column.rates[stage], new));
    }

    /// The end of the step, from the rates of all stages.
    fn finish(&self, chunk: &Chunk, rates: &Rates, dt: f64) -> StepError {
        self.copies.restore(chunk);
        let mut error = StepError::default();
        self.finish_motion(chunk, rates, dt, &mut error);
        for (column, last) in self.columns.iter().zip(rates.blocks()) {
            let kept = column.rates.map(|column| chunk.words(column));
            let slopes = Slopes { kept: &kept, last: Some(last) };
            self.finish_column(chunk, column, &slopes, dt, &mut error);
        }
        error
    }

    /// Positions, velocities, and their errors.
    fn finish_motion(&self, chunk: &Chunk, rates: &Rates, dt: f64, error: &mut StepError) {
        let kept = self.accelerations.map(|column| chunk.words(column));
        let slopes = Slopes { kept: &kept, last: Some(words_of(&rates.acceleration)) };
        let (position, velocity) = (chunk.words(self.moved.position.index), chunk.words(self.moved.velocity.index));
        let width = velocity.len() / chunk.len().max(1);
        let (ids, sound_speed) = (chunk.view(self.view.core.id), chunk.view(self.view.core.sound_speed));
        self.drift(chunk, dt);
        for k in 0..chunk.len() {
            let rest = REST * self.quantities[VELOCITY].tolerance * sound_speed.get(k);
            let h = self.view.smoothing_length(chunk, k, ids.get(k).body());
            for word in k * width..(k + 1) * width {
                add(&position[word], dt * dt * slopes.sum(&PLACE_END, word));
                add(&velocity[word], dt * slopes.sum(&END, word));
                error.note(POSITION, dt * dt * slopes.sum(&PLACE_ERROR, word).abs() / h);
                let off = dt * slopes.sum(&ERROR, word).abs();
                if off > rest {
                    error.note(VELOCITY, off);
                }
            }
        }
    }

    fn finish_column(&self, chunk: &Chunk, column: &Advanced, slopes: &Slopes, dt: f64, error: &mut StepError) {
        let words = chunk.words(column.value);
        let width = words.len() / chunk.len().max(1);
        for (k, values) in words.chunks(width.max(1)).enumerate() {
            let rest = self.rest(chunk, k, column);
            for (q, word) in values.iter().zip(k * width..) {
                let before = number(q);
                add(q, dt * slopes.sum(&END, word));
                let Some((quantity, size)) = column.control else { continue };
                let off = dt * slopes.sum(&ERROR, word).abs();
                match size {
                    Size::Own => error.note(quantity, off / number(q)),
                    Size::Largest(_) => {
                        let rate = number(&slopes.kept[0][word]);
                        error.note_size(quantity, before.abs().max(number(q).abs()) + dt * rate.abs());
                        error.note(quantity, if off > rest { off } else { 0.0 });
                    }
                }
            }
        }
    }

    /// The error of a column that does not count in particle `k`.
    fn rest(&self, chunk: &Chunk, k: usize, column: &Advanced) -> f64 {
        let Some((quantity, Size::Largest(natural))) = column.control else { return 0.0 };
        let c = chunk.view(self.view.core.sound_speed).get(k);
        let size = match natural {
            Natural::Modulus => chunk.view(self.view.core.density.value).get(k) * c * c,
            Natural::Energy => c * c,
            Natural::One => 1.0,
            Natural::Unknown => 0.0,
        };
        REST * self.quantities[quantity].tolerance * size
    }

    /// The error over the tolerated one; `speed` as in [`Integrator::judge`].
    fn worst(&self, error: &StepError, speed: f64) -> f64 {
        let own = |quantity: usize| {
            quantity == POSITION || self.columns.iter().any(|column| column.control == Some((quantity, Size::Own)))
        };
        let of = |(quantity, Quantity { tolerance, .. }): (usize, &Quantity)| {
            let size = match quantity {
                VELOCITY => speed,
                _ if own(quantity) => 1.0,
                _ => error.sizes[quantity],
            };
            share(error.errors[quantity], size, *tolerance)
        };
        self.quantities.iter().enumerate().map(of).fold(0.0, f64::max)
    }
}

/// Rates of all stages of one column in a chunk.
struct Slopes<'a> {
    kept: &'a [&'a [Cell<u64>]],
    /// Of the last stage.
    last: Option<&'a [Cell<u64>]>,
}

impl Slopes<'_> {
    /// The weighted sum of a word's rates.
    #[inline(always)]
    fn sum(&self, weights: &Weights, word: usize) -> f64 {
        let kept = self.kept.iter().zip(weights).fold(0.0, |sum, (rate, weight)| sum + weight * number(&rate[word]));
        self.last.map_or(kept, |last| kept + weights[KEPT] * number(&last[word]))
    }
}

#[inline(always)]
fn number(word: &Cell<u64>) -> f64 {
    f64::from_bits(word.get())
}

impl Integrator for CashKarp {
    fn stages(&self) -> &'static [f64] {
        &MOMENTS
    }

    fn may_refuse(&self) -> bool {
        true
    }

    fn advance(&self, chunk: &Chunk, stage: usize, dt: f64) {
        self.move_to(chunk, stage, dt);
    }

    fn take(&self, chunk: &Chunk, rates: &Rates, stage: usize, dt: f64) -> StepError {
        if stage + 1 == STAGES {
            return self.finish(chunk, rates, dt);
        }
        if stage == 0 {
            self.copies.make(chunk);
        }
        self.keep(chunk, rates, stage);
        StepError::default()
    }

    fn controlled(&self) -> usize {
        self.quantities.len()
    }

    fn set_back(&self, chunk: &Chunk) {
        self.copies.restore(chunk);
    }

    fn advance_rigid(&self, body: &mut RigidBody, stage: usize, dt: f64) {
        body.move_by(&STAGE[stage], dt);
    }

    fn take_rigid(&self, body: &mut RigidBody, rates: &RigidRates, stage: usize, dt: f64) -> StepError {
        body.keep(rates, stage);
        if stage + 1 < STAGES {
            return StepError::default();
        }
        let error = rigid_error(body, &ERROR, dt, VELOCITY);
        body.move_by(&END, dt);
        error
    }

    fn judge(&self, error: &StepError, speed: f64, dt: f64) -> Verdict {
        let worst = self.worst(error, speed);
        let change = match worst > 0.0 {
            true => (CAUTION * libm::pow(worst, -1.0 / ORDER)).clamp(CHANGE[0], CHANGE[1]),
            false => CHANGE[1],
        };
        match worst <= 1.0 {
            true => Verdict::Accept { most: change * dt },
            false => Verdict::Refuse { next: change * dt },
        }
    }
}
