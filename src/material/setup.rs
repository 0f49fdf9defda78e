//! The input of effects: the scene's materials and bodies, and code shared by the tables that describe them.

use std::ops::Range;

use super::{BodyConstants, Local, MaterialTable, Records};
use crate::error::{Error, Result};

/// The part of a scene that material effects depend on. All slices but `materials` have one entry per body.
#[derive(Debug, Clone, Copy)]
pub struct Setup<'a> {
    /// 2 or 3.
    pub dimension: usize,
    pub materials: &'a [MaterialTable],
    /// Index of each body's material.
    pub body_material: &'a [usize],
    pub constants: &'a [BodyConstants],
    /// Damage that each body starts with, 0 to 1.
    pub initial_damage: &'a [f64],
    pub records: Records,
    /// Bounds of a smoothing length that follows density; constant without.
    pub smoothing_length: Option<Bounds>,
}

/// Bounds of a smoothing length that follows density, in units of the smoothing length at the start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    pub smallest: f64,
    pub largest: f64,
}

impl Setup<'_> {
    pub fn material(&self, body: usize) -> &MaterialTable {
        &self.materials[self.body_material[body]]
    }
}

/// Parameters of an effect, one set per body whose material requests it.
#[derive(Debug, Clone)]
pub struct PerBody<P>(Vec<Option<P>>);

impl<P> PerBody<P> {
    /// Calls `parameters` for each body; `None` when no body has any.
    pub fn new(setup: &Setup, parameters: impl Fn(usize, &MaterialTable) -> Option<P>) -> Option<Self> {
        let all: Vec<_> = (0..setup.constants.len()).map(|body| parameters(body, setup.material(body))).collect();
        all.iter().any(Option::is_some).then_some(Self(all))
    }

    /// Parameters of a body.
    pub fn of(&self, body: usize) -> Option<&P> {
        self.0[body].as_ref()
    }

    /// Parameters of every body that has the effect, with its number.
    pub fn iter_mut(&mut self) -> impl Iterator<Item = (usize, &mut P)> {
        self.0.iter_mut().enumerate().filter_map(|(body, parameters)| Some((body, parameters.as_mut()?)))
    }

    /// The particles of a chunk that have the effect, in stretches with the same parameters.
    pub fn runs<'a>(&'a self, local: &'a Local) -> impl Iterator<Item = (&'a P, Range<usize>)> {
        local.runs().filter_map(|(body, range)| Some((self.0[body].as_ref()?, range)))
    }
}

/// A table of a material.
pub trait Table {
    /// Checks the values against each other and against the material's other tables; `place` names the table in
    /// messages, `material.basalt.strength`.
    fn validate(&self, place: &str, material: &MaterialTable) -> Result<()>;
}

impl<T: Table> Table for Option<T> {
    fn validate(&self, place: &str, material: &MaterialTable) -> Result<()> {
        self.as_ref().map_or(Ok(()), |table| table.validate(place, material))
    }
}

/// Finds the first of the (key, value) pairs that is not a finite number above zero.
pub(super) fn all_positive(place: &str, values: &[(&str, f64)]) -> Result<()> {
    match values.iter().find(|(_, value)| !(*value > 0.0 && value.is_finite())) {
        Some((key, value)) => {
            Err(Error::new(format!("{key} is {value:e}")).at(format!("{place}.{key}")).allowed("numbers above zero"))
        }
        None => Ok(()),
    }
}

/// Finds the first of the (key, value) pairs that is not a finite number of zero or above.
pub(super) fn none_negative(place: &str, values: &[(&str, f64)]) -> Result<()> {
    match values.iter().find(|(_, value)| !(*value >= 0.0 && value.is_finite())) {
        Some((key, value)) => {
            Err(Error::new(format!("{key} is {value:e}")).at(format!("{place}.{key}")).allowed("zero and above"))
        }
        None => Ok(()),
    }
}
