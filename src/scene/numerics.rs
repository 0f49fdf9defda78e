//! `[numerics]`: how the sums are made. Every key has a default; what costs something is off until asked for.

use std::f64::consts::PI;

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::settings::within;
use super::source::Document;
use crate::error::Result;
use crate::kernel::{Kernel, SUPPORT};
use crate::units::Number;

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct RawNumerics {
    kernel: Kernel,
    cfl: Number,
    skin: Number,
    eta: Option<Number>,
    neighbours: Option<Number>,
    pub(super) viscosity: bool,
    corrected_gradient: Option<bool>,
    angular_momentum: Option<bool>,
    density_contrast: Option<bool>,
    artificial_stress: Switch<RawArtificialStress>,
    smoothing_length: RawSmoothingLength,
}

impl Default for RawNumerics {
    fn default() -> Self {
        Self {
            kernel: Kernel::CubicSpline,
            cfl: Number::new(0.25),
            skin: Number::new(0.1),
            eta: None,
            neighbours: None,
            viscosity: true,
            corrected_gradient: None,
            angular_momentum: None,
            density_contrast: None,
            artificial_stress: Switch(None),
            smoothing_length: RawSmoothingLength::default(),
        }
    }
}

/// h over (m / rho)^(1/d): default, least and largest.
const DEFAULT_ETA: f64 = 1.2;
const ETA: [f64; 2] = [0.8, 3.0];

/// Bodies whose densities differ by more than this factor are told apart in their pairs, see `pair::contrast`.
const ALIKE: f64 = 2.0;
/// The same where nothing has strength: below it both keep energy, beyond it liquids in thin gas gain and lose as much as there is.
const APART: f64 = 100.0;

/// Volume of the ball (or area of the disc) of radius 1.
fn unit_ball(dimension: usize) -> f64 {
    if dimension == 2 { PI } else { 4.0 / 3.0 * PI }
}

/// Neighbours inside the support of a particle that matter surrounds evenly, itself not counted: V_d (2 eta)^d - 1.
pub fn neighbours(eta: f64, dimension: usize) -> f64 {
    unit_ball(dimension) * libm::pow(SUPPORT * eta, dimension as f64) - 1.0
}

fn eta_of(neighbours: f64, dimension: usize) -> f64 {
    libm::pow((neighbours + 1.0) / unit_ball(dimension), 1.0 / dimension as f64) / SUPPORT
}

/// A table that may also be `true` (all its defaults) or `false` (off).
#[derive(Debug, Clone, Copy)]
pub struct Switch<T>(pub Option<T>);

impl<T: Serialize> Serialize for Switch<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        match &self.0 {
            Some(table) => table.serialize(serializer),
            None => serializer.serialize_bool(false),
        }
    }
}

impl<'de, T: Deserialize<'de> + Default> Deserialize<'de> for Switch<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        struct BoolOrTable<T>(std::marker::PhantomData<T>);
        impl<'de, T: Deserialize<'de> + Default> serde::de::Visitor<'de> for BoolOrTable<T> {
            type Value = Switch<T>;
            fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                f.write_str("true, false or a table")
            }
            fn visit_bool<E>(self, on: bool) -> std::result::Result<Self::Value, E> {
                Ok(Switch(on.then(T::default)))
            }
            fn visit_map<A: serde::de::MapAccess<'de>>(self, map: A) -> std::result::Result<Self::Value, A::Error> {
                T::deserialize(serde::de::value::MapAccessDeserializer::new(map)).map(|table| Switch(Some(table)))
            }
        }
        deserializer.deserialize_any(BoolOrTable(std::marker::PhantomData))
    }
}

#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct RawArtificialStress {
    factor: Number,
}

impl Default for RawArtificialStress {
    fn default() -> Self {
        Self { factor: Number::new(0.2) }
    }
}

#[derive(Debug, Clone, Copy, Default)]
pub struct RawSmoothingLength(Option<RawFollows>);

#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct RawFollows {
    follows: Followed,
    #[serde(default = "half")]
    smallest: Number,
    #[serde(default = "two")]
    largest: Number,
}

#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Followed {
    Density,
}

fn half() -> Number {
    Number::new(0.5)
}

fn two() -> Number {
    Number::new(2.0)
}

impl Serialize for RawSmoothingLength {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        match &self.0 {
            Some(follows) => follows.serialize(serializer),
            None => serializer.serialize_str("constant"),
        }
    }
}

impl<'de> Deserialize<'de> for RawSmoothingLength {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        struct ConstantOrTable;
        impl<'de> serde::de::Visitor<'de> for ConstantOrTable {
            type Value = RawSmoothingLength;
            fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                f.write_str("\"constant\" or { follows = \"density\", smallest = 0.5, largest = 2.0 }")
            }
            fn visit_str<E: serde::de::Error>(self, word: &str) -> std::result::Result<Self::Value, E> {
                match word {
                    "constant" => Ok(RawSmoothingLength(None)),
                    _ => Err(E::invalid_value(serde::de::Unexpected::Str(word), &self)),
                }
            }
            fn visit_map<A: serde::de::MapAccess<'de>>(self, map: A) -> std::result::Result<Self::Value, A::Error> {
                RawFollows::deserialize(serde::de::value::MapAccessDeserializer::new(map))
                    .map(|f| RawSmoothingLength(Some(f)))
            }
        }
        deserializer.deserialize_any(ConstantOrTable)
    }
}

/// How the sums are made.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Numerics {
    pub kernel: Kernel,
    /// Time step over h / signal speed.
    pub cfl: f64,
    /// Margin of neighbour lists over the support.
    pub skin: f64,
    /// h over (m / rho)^(1/d).
    pub eta: f64,
    /// Whether artificial viscosity acts at all; its strength belongs to the material.
    pub viscosity: bool,
    pub corrected_gradient: bool,
    /// Whether forces between particles are to exert no torque.
    pub angular_momentum: bool,
    /// Whether the light one of a pair gives way, and the heavy one stands.
    pub density_contrast: bool,
    pub artificial_stress: Option<ArtificialStress>,
    pub smoothing_length: SmoothingLength,
}

/// Gray, Monaghan & Swift 2001, CMAME 190, 6641: repulsion by `factor` of the tension, times f^4.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ArtificialStress {
    pub factor: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum SmoothingLength {
    Constant,
    /// h = h_0 (rho_0 / rho)^(1/d), within these bounds relative to h_0.
    FollowsDensity {
        smallest: f64,
        largest: f64,
    },
}

impl RawNumerics {
    /// Fills in eta, and what is right for a `solid`: a scene with strength.
    pub(super) fn validate(&mut self, document: &Document, dimension: usize, solid: bool) -> Result<Numerics> {
        let eta = self.eta(document, dimension)?;
        self.eta = Some(Number::new(eta));
        self.neighbours = None;
        let within = |key: &str, value: Number, low: f64, high: f64| {
            within(document, &format!("numerics.{key}"), value, low, high)
        };
        let artificial_stress = match self.artificial_stress.0 {
            None => None,
            Some(raw) => Some(ArtificialStress { factor: within("artificial_stress.factor", raw.factor, 0.0, 1.0)? }),
        };
        let smoothing_length = match self.smoothing_length.0 {
            None => SmoothingLength::Constant,
            Some(RawFollows { follows: Followed::Density, smallest, largest }) => SmoothingLength::FollowsDensity {
                smallest: within("smoothing_length.smallest", smallest, 0.01, 1.0)?,
                largest: within("smoothing_length.largest", largest, 1.0, 100.0)?,
            },
        };
        let corrected_gradient = self.corrected_gradient.unwrap_or(solid);
        // Beside artificial stress it costs rubber its rebound: thin walls in tension lose particles.
        let torque_free = solid && corrected_gradient && artificial_stress.is_none();
        let angular_momentum = *self.angular_momentum.get_or_insert(torque_free);
        if !corrected_gradient {
            for (key, asked) in
                [("angular_momentum", self.angular_momentum), ("density_contrast", self.density_contrast)]
            {
                if asked == Some(true) {
                    let what = "it needs what the corrected gradient knows of a neighbourhood";
                    let error = document.error(&format!("numerics.{key}"), what);
                    return Err(error.allowed("numerics.corrected_gradient = true"));
                }
            }
        }
        Ok(Numerics {
            kernel: self.kernel,
            cfl: within("cfl", self.cfl, 1e-3, 1.0)?,
            skin: within("skin", self.skin, 0.0, 1.0)?,
            eta,
            viscosity: self.viscosity,
            corrected_gradient,
            angular_momentum,
            density_contrast: false,
            artificial_stress,
            smoothing_length,
        })
    }

    /// Whether pairs of very different density get a term of their own: as asked for, or where bodies have such densities, kg/m^3. In a scene that
    /// is not `solid` it brings the corrected gradient with it.
    pub(super) fn contrast(
        &mut self,
        numerics: &mut Numerics,
        solid: bool,
        densities: impl Iterator<Item = f64> + Clone,
    ) {
        let [least, most] = [f64::INFINITY, 0.0];
        let ratio = densities.clone().fold(most, f64::max) / densities.fold(least, f64::min);
        let differ = ratio > if solid { ALIKE } else { APART };
        let wanted = differ && self.density_contrast != Some(false);
        numerics.corrected_gradient = *self.corrected_gradient.get_or_insert(solid || wanted);
        numerics.density_contrast = *self.density_contrast.get_or_insert(wanted && numerics.corrected_gradient);
    }

    /// h over (m / rho)^(1/d), as given or by the number of neighbours.
    fn eta(&self, document: &Document, dimension: usize) -> Result<f64> {
        let [low, high] = ETA;
        match (self.eta, self.neighbours) {
            (Some(_), Some(_)) => Err(document
                .error("numerics.neighbours", "both `eta` and `neighbours` are given")
                .allowed("one of them")),
            (eta, None) => within(document, "numerics.eta", eta.unwrap_or(Number::new(DEFAULT_ETA)), low, high),
            (None, Some(number)) => {
                let [fewest, most] = [low.next_up(), high.next_down()].map(|eta| neighbours(eta, dimension));
                let number = within(document, "numerics.neighbours", number, fewest.ceil(), most.floor())?;
                Ok(eta_of(number, dimension))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    const TEXT: &str = "[[body]]\nname = \"ball\"\nshape = { sphere = { radius = 1 } }\nmaterial = \"basalt\"\n\
        particles = 1000\n[run]\nuntil = 1\n";

    fn eta(overrides: &[&str]) -> Result<f64> {
        let overrides: Vec<String> = overrides.iter().map(|text| text.to_string()).collect();
        Scene::parse("s.toml", TEXT, &overrides).map(|scene| scene.numerics.eta)
    }

    /// 57 neighbours in 3D, 17 in the plane, are what eta = 1.2 gives.
    #[test]
    fn neighbours_stand_for_eta() {
        assert!((neighbours(1.2, 3) - 57.0).abs() < 0.1 && (neighbours(1.2, 2) - 17.1).abs() < 0.1);
        assert!([2, 3].iter().all(|&d| (eta_of(neighbours(1.37, d), d) - 1.37).abs() < 1e-14));
        assert_eq!(eta(&[]).unwrap(), 1.2);
        assert!((eta(&["numerics.neighbours=57"]).unwrap() - 1.2).abs() < 1e-3);
        // The later word counts.
        assert_eq!(eta(&["numerics.neighbours=57", "numerics.eta=1.5"]).unwrap(), 1.5);
    }

    #[test]
    fn what_needs_the_corrected_gradient_says_so() {
        for key in ["density_contrast", "angular_momentum"] {
            let on = format!("numerics.{key}=true");
            assert!(eta(&[&on, "numerics.corrected_gradient=true", "numerics.artificial_stress=true"]).is_ok());
            for wrong in [&[&on[..]][..], &[&on, "material.basalt.strength=true", "numerics.corrected_gradient=false"]]
            {
                let error = eta(wrong).err().unwrap();
                assert!(error.what.contains("corrected gradient") && error.place.contains(key), "{error}");
            }
        }
    }

    /// Solids get what is right for them, other matter does without it, and a scene's own word counts.
    #[test]
    fn defaults_follow_from_the_matter() {
        let choices = |overrides: &[&str]| {
            let overrides: Vec<String> = overrides.iter().map(|text| text.to_string()).collect();
            let two = "[[body]]\nname = \"other\"\nshape = { sphere = { radius = 1 } }\nmaterial = \"basalt\"\n\
                particles = 1000\nposition = [3, 0, 0]\n";
            let n = Scene::parse("s.toml", &format!("{two}{TEXT}"), &overrides).unwrap().numerics;
            [n.corrected_gradient, n.angular_momentum, n.density_contrast]
        };
        let (strong, light) = ("material.basalt.strength=true", "other.density=1300");
        assert_eq!(choices(&[]), [false; 3]);
        assert_eq!(choices(&[light]), [false; 3]);
        let thin = "other.density=20";
        assert_eq!(choices(&[thin]), [true, false, true]);
        assert_eq!(choices(&[thin, "numerics.density_contrast=false"]), [false; 3]);
        assert_eq!(choices(&[thin, "numerics.corrected_gradient=false"]), [false; 3]);
        assert_eq!(choices(&[strong]), [true, true, false]);
        assert_eq!(choices(&[strong, light]), [true; 3]);
        assert_eq!(choices(&[strong, "other.density=1400"]), [true, true, false]);
        assert_eq!(choices(&[strong, light, "numerics.corrected_gradient=false"]), [false; 3]);
        assert_eq!(choices(&[strong, light, "numerics.angular_momentum=false"]), [true, false, true]);
        assert_eq!(choices(&[strong, light, "numerics.artificial_stress=true"]), [true, false, true]);
        assert_eq!(choices(&[strong, light, "numerics.density_contrast=false"]), [true, true, false]);
    }

    #[test]
    fn one_of_eta_and_neighbours() {
        let both = Scene::parse("s.toml", &format!("{TEXT}[numerics]\neta = 1.2\nneighbours = 57\n"), &[]);
        let error = both.err().unwrap();
        assert!(error.what.contains("both") && error.place.starts_with("s.toml:10"), "{error}");
        assert!(eta(&["numerics.neighbours=3"]).err().unwrap().allowed.starts_with("17 to"));
    }
}
