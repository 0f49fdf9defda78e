//! The exact solution that a scene names: made at the start from the scene's own numbers, compared at the end.

pub mod elastic;
pub mod growth;
pub mod modes;
pub mod pictures;
pub mod profile;
pub mod rest;
pub mod signal;
pub mod solution;

use std::path::Path;

use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::output::summary::Figures;
use crate::scene::Scene;
use crate::step::Stepper;
use pictures::Pictures;
use solution::Reference;

/// The exact solution that a run is compared with.
pub struct Comparison {
    reference: Reference,
    title: String,
}

/// What a run has noted for its comparison.
#[derive(Debug, Clone, Copy)]
pub struct Noted<'a> {
    /// s.
    pub time: f64,
    /// Drift of angular momentum, relative.
    pub angular_momentum: f64,
    /// What [`Comparison::sample`] gave.
    pub samples: &'a [[f64; 2]],
}

impl Comparison {
    /// `None` where the scene names no solution; an error where its bodies do not make the problem that it names.
    pub fn new(scene: &Scene) -> Result<Option<Self>> {
        let Some(compare) = &scene.compare else { return Ok(None) };
        let place = |e: Error| Error { allowed: e.allowed, ..scene.error("compare.with", e.what) };
        let reference = solution::of(scene, compare).map_err(place)?;
        Ok(Some(Self { reference, title: scene.title.clone() }))
    }

    /// Time, s, and the amplitude of a vibration or a growing wave, or the speed of matter that should be at rest; `None` for other solutions.
    /// Collective.
    pub fn sample<const D: usize>(&self, stepper: &Stepper<D>, time: f64, comm: &Comm) -> Option<[f64; 2]> {
        match &self.reference {
            Reference::Vibration(vibration) => Some([time, signal::amplitude(vibration, stepper, comm)]),
            Reference::Growth(growth) => Some([time, growth::amplitude(growth, stepper, comm)]),
            Reference::Rest(rest) => Some([time, rest::speed(rest, stepper, comm)]),
            Reference::Profile(_) | Reference::Rotation(_) => None,
        }
    }

    /// Errors by name, and figures into the directory if there is one. `angular`: drift of angular momentum; `samples`: what
    /// [`Comparison::sample`] gave. Collective.
    pub fn finish<const D: usize>(
        &self,
        stepper: &Stepper<D>,
        noted: &Noted,
        directory: Option<&Path>,
        comm: &Comm,
    ) -> Result<Figures> {
        let &Noted { time, angular_momentum, samples } = noted;
        let pictures = directory.map(|directory| Pictures { title: &self.title, directory });
        match &self.reference {
            Reference::Profile(profile) => profile::compare(profile, stepper, time, pictures, comm),
            Reference::Vibration(vibration) => signal::compare(vibration, samples, pictures, comm),
            Reference::Growth(growth) => growth::compare(growth, samples),
            Reference::Rest(rest) => rest::compare(rest, stepper, samples, pictures, comm),
            Reference::Rotation(rotation) => {
                let turns = rotation.spin * time / (2.0 * std::f64::consts::PI);
                let named = |name: &str, value| (name.to_string(), value);
                Ok(Figures(vec![
                    named("angular_momentum", angular_momentum),
                    named("angular_momentum_per_turn", angular_momentum / turns),
                ]))
            }
        }
    }
}
