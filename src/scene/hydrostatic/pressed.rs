//! Where a body's particles start, and in what state, where it carries its own weight.

use super::ball::BallProfile;
use super::slab::Slab;
use crate::error::Result;
use crate::material::eos::Eos;
use crate::scene::geometry::shape::BodyShape;
use crate::scene::tables::body::validated::Body;

/// How a body is compressed.
#[derive(Debug, Clone, PartialEq)]
pub enum Pressed {
    /// By its own gravity; with its centre, m.
    Ball(BallProfile, [f64; 3]),
    /// By uniform gravity.
    Slab(Slab),
}

impl Pressed {
    /// `uniform`: acceleration of a box, m/s^2.
    pub fn new(body: &Body, law: &Eos, uniform: [f64; 3]) -> Result<Self> {
        match body.shape {
            BodyShape::Box { .. } => Slab::new(body, law, uniform).map(Self::Slab),
            _ => BallProfile::new(body, law).map(|profile| Self::Ball(profile, body.centre)),
        }
    }

    /// For what lies at `point` without load, m: the place that it gets, its density, kg/m^3, and its internal energy, J/kg.
    pub fn at(&self, point: [f64; 3]) -> ([f64; 3], f64, f64) {
        match self {
            Self::Slab(slab) => slab.at(point),
            Self::Ball(profile, centre) => {
                let away: [f64; 3] = std::array::from_fn(|k| point[k] - centre[k]);
                let (ratio, density, energy) = profile.at(away.iter().map(|x| x * x).sum::<f64>().sqrt());
                (std::array::from_fn(|k| centre[k] + away[k] * ratio), density, energy)
            }
        }
    }
}
