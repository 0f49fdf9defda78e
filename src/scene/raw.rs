//! The tables of a scene as they are written. Every key with a default gets it here or in `body.rs`, so that a filled-in
//! `RawScene` printed as TOML is the scene as understood.

use std::collections::BTreeMap;
use std::fmt;
use std::marker::PhantomData;

use serde::de::{IntoDeserializer, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::ask::{RawAsked, RawProbe};
use super::blocks::{RawJoints, RawRubble};
use super::boundaries::{RawDomain, RawLayer, RawMotion};
use super::compare::RawCompare;
use super::gravity::RawGravity;
use super::hydrostatic::Start;
use super::impact::AngleAt;
use super::late_stage::RawLateStage;
use super::lattice::LatticeKind;
use super::nbody::Nbody;
use super::numerics::{RawNumerics, Switch};
use super::refine::RawRefine;
use super::settings::{RawOutput, RawRun, RawThreshold};
use super::start::{RawBlast, RawFlow};
use crate::material::{MaterialTable, Records};
use crate::units::{Angle, Density, Frequency, Length, Number, Pressure, SpecificEnergy, Speed};

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawScene {
    #[serde(default)]
    pub title: String,
    #[serde(default = "three")]
    pub dimension: u8,
    #[serde(default)]
    pub body: Vec<RawBody>,
    #[serde(default)]
    pub layer: Vec<RawLayer>,
    pub impact: Option<RawImpact>,
    #[serde(default)]
    pub domain: RawDomain,
    pub gravity: Option<RawGravity>,
    #[serde(default)]
    pub material: BTreeMap<String, MaterialTable>,
    #[serde(default)]
    pub numerics: RawNumerics,
    #[serde(default)]
    pub run: RawRun,
    pub late_stage: Option<RawLateStage>,
    #[serde(default)]
    pub output: RawOutput,
    #[serde(default)]
    pub record: Records,
    pub threshold: Option<RawThreshold>,
    pub compare: Option<RawCompare>,
    pub outcome: Option<RawAsked>,
    pub nbody: Option<Nbody>,
    #[serde(default)]
    pub probe: Vec<RawProbe>,
}

fn three() -> u8 {
    3
}

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawBody {
    pub name: String,
    pub shape: RawShape,
    pub material: String,
    pub particles: Option<u64>,
    pub spacing: Option<Spacing>,
    pub least_particles: Option<u64>,
    #[serde(default)]
    pub lattice: LatticeKind,
    pub orientation: Option<RawOrientation>,
    pub position: Option<Components<Length>>,
    pub velocity: Option<Components<Speed>>,
    pub spin: Option<Components<Frequency>>,
    pub damage: Option<Number>,
    pub distention: Option<Number>,
    pub density: Option<Density>,
    pub internal_energy: Option<SpecificEnergy>,
    pub pressure: Option<Pressure>,
    pub motion: Option<RawMotion>,
    pub flow: Option<RawFlow>,
    pub blast: Option<RawBlast>,
    pub rubble: Option<RawRubble>,
    pub joints: Option<RawJoints>,
    #[serde(default)]
    pub start: Start,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum RawShape {
    #[serde(alias = "disc")]
    Sphere(RawBall),
    Box(RawBox),
    Cylinder(RawCylinder),
    Heap(RawHeap),
    #[serde(alias = "half_disc")]
    HalfSphere(RawHalfBall),
}

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawBall {
    pub radius: Length,
}

/// Hollow within `inner`.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawHalfBall {
    pub radius: Length,
    #[serde(default)]
    pub inner: Length,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawBox {
    pub size: Components<Length>,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawCylinder {
    pub radius: Length,
    pub height: Length,
}

/// Flat at the top where `top` is more than 0.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawHeap {
    pub radius: Length,
    #[serde(default)]
    pub top: Length,
    pub height: Length,
}

/// A random rotation of the lattice, or one about an axis.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawOrientation {
    pub seed: Option<u64>,
    pub axis: Option<Components<Number>>,
    pub angle: Option<Angle>,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawImpact {
    pub speed: Speed,
    #[serde(default)]
    pub angle: Angle,
    #[serde(default)]
    pub angle_at: AngleAt,
    pub target: Option<String>,
    pub projectile: Option<String>,
    pub refine: Option<Switch<RawRefine>>,
}

/// Distance of nearest particles: given, or the target's (finer where the projectile would be too coarse).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Spacing {
    OfTarget,
    Given(Length),
}

impl Serialize for Spacing {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Spacing::OfTarget => serializer.serialize_str("target"),
            Spacing::Given(length) => length.serialize(serializer),
        }
    }
}

impl<'de> Deserialize<'de> for Spacing {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        word_or(deserializer, "target").map(|given| given.map_or(Spacing::OfTarget, Spacing::Given))
    }
}

/// Reads `word` as none, anything else as a quantity.
pub(super) fn word_or<'de, D: Deserializer<'de>, Q: Deserialize<'de>>(
    deserializer: D,
    word: &'static str,
) -> Result<Option<Q>, D::Error> {
    struct WordOr<Q>(&'static str, PhantomData<Q>);
    impl<'de, Q: Deserialize<'de>> Visitor<'de> for WordOr<Q> {
        type Value = Option<Q>;
        fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
            write!(f, "\"{}\" or a quantity with its unit", self.0)
        }
        fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<Self::Value, E> {
            if text == self.0 {
                return Ok(None);
            }
            Q::deserialize(text.into_deserializer()).map(Some).map_err(|e: E| {
                let message = e.to_string().replacen("(allowed: ", &format!("(allowed: \"{}\", ", self.0), 1);
                E::custom(message)
            })
        }
        fn visit_f64<E: serde::de::Error>(self, value: f64) -> Result<Self::Value, E> {
            Q::deserialize(value.into_deserializer()).map(Some)
        }
        fn visit_i64<E: serde::de::Error>(self, value: i64) -> Result<Self::Value, E> {
            Q::deserialize(value.into_deserializer()).map(Some)
        }
    }
    deserializer.deserialize_any(WordOr(word, PhantomData))
}

/// A vector with one component per dimension; a single number stands for a vector of one (the spin in 2D).
#[derive(Debug, Clone, PartialEq)]
pub struct Components<Q>(pub Vec<Q>);

impl<Q: Serialize> Serialize for Components<Q> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match &self.0[..] {
            [single] => single.serialize(serializer),
            several => several.serialize(serializer),
        }
    }
}

impl<'de, Q: Deserialize<'de>> Deserialize<'de> for Components<Q> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct OneOrMany<Q>(PhantomData<Q>);
        impl<'de, Q: Deserialize<'de>> Visitor<'de> for OneOrMany<Q> {
            type Value = Components<Q>;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a list with one component per dimension")
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
                let mut components = Vec::new();
                while let Some(component) = list.next_element()? {
                    components.push(component);
                }
                Ok(Components(components))
            }
            fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<Self::Value, E> {
                Q::deserialize(text.into_deserializer()).map(|q| Components(vec![q]))
            }
            fn visit_f64<E: serde::de::Error>(self, value: f64) -> Result<Self::Value, E> {
                Q::deserialize(value.into_deserializer()).map(|q| Components(vec![q]))
            }
            fn visit_i64<E: serde::de::Error>(self, value: i64) -> Result<Self::Value, E> {
                Q::deserialize(value.into_deserializer()).map(|q| Components(vec![q]))
            }
        }
        deserializer.deserialize_any(OneOrMany(PhantomData))
    }
}
