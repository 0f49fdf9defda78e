//! `[numerics]`: how the sums are made. Every key has a default; what costs something is off until asked for.

use std::borrow::Cow;
use std::f64::consts::PI;
use std::ops::RangeInclusive;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::integrator::{IntegratorRule, IntegratorTable};
use super::skin::{SkinRule, SkinValue};
use crate::error::Result;
use crate::kernel::{Kernel, SUPPORT};
use crate::scene::document::source::Document;
use crate::scene::values::checks::{Range, within};
use crate::scene::values::switch::Switch;
use crate::units::Number;

/// How the sums over particles are made, and how long a step is.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct NumericsTable {
    /// A word for kernel, eta, CFL number and treatment of viscosity together, by what they cost and how far they are off. What the scene
    /// says itself of any of these counts more.
    quality: Option<Quality>,
    /// Kernel; all end at 2h.
    kernel: Kernel,
    /// Courant number C. A step is short enough for sound, for approaching neighbours, and for matter that is not in touch yet: nothing
    /// comes by more than C h into the support of other matter before its forces are known. More than 1 with an integrator that controls
    /// its error only.
    #[schemars(range(min = CFL[0], max = LONG_CFL[1]))]
    cfl: Number,
    /// Margin of neighbour lists, in units of the support: a number from 0 to 1 for all particles, or "auto" for each particle's own, by how
    /// matter around it moves, which is chosen anew with each list for the least work.
    skin: SkinValue,
    /// Smoothing length h over (m / rho)^(1/d).
    #[schemars(range(min = ETA[0], max = ETA[1]))]
    #[schemars(extend("default" = DEFAULT_ETA))]
    eta: Option<Number>,
    /// Instead of `eta`: how many particles even matter has inside the support, V_d (2 eta)^d - 1. For an eta of 1.2 these are 57 in 3D,
    /// 17 in 2D.
    neighbours: Option<Number>,
    /// Whether artificial viscosity acts at all.
    pub viscosity: bool,
    /// Velocity gradients exact for linear fields: no strain in rigid rotation. Without it, on where any material has `strength`, or where
    /// `density_contrast` is on.
    corrected_gradient: Option<bool>,
    /// An antisymmetric stress beside the symmetric one, so that forces exert no torque and what turns freely keeps its spin, for a tenth
    /// of the time of an impact; needs the corrected gradient. Without it, on where any material has `strength`, unless there is artificial
    /// stress, beside which thin walls in tension lose particles.
    angular_momentum: Option<bool>,
    /// For iron into ice, air or vapour beside rock: of two particles the light one gives way and the heavy one stands, instead of both
    /// alike; needs the corrected gradient. Without it, on where a material has `strength` and the densities of two bodies differ more than
    /// twofold, and, with the corrected gradient, wherever they differ more than a hundredfold. A
    /// `rigid` body needs it.
    density_contrast: Option<bool>,
    /// Against single particles of a stiff body that oscillate across its surface until they shoot into soft matter (cannonballs): what is
    /// in touch with matter of a larger `alpha` of viscosity takes that alpha; a pair has the mean of both.
    contact_viscosity: bool,
    /// Viscosity that smooth flow does not feel: it acts on what is left of a pair's approach once both velocities are carried to the
    /// middle between them along their gradients; needs the corrected gradient.
    reconstruction: bool,
    /// Viscosity that falls where nothing is shocked: each particle has all of `alpha` where compression steepens, and afterwards less and
    /// less of it.
    viscosity_switch: Switch<ViscositySwitchTable>,
    /// Density that stays mass over volume: what continuity has let drift away from it returns, inside matter.
    density_relaxation: Switch<DensityRelaxationTable>,
    /// Against clumping in tension.
    artificial_stress: Switch<ArtificialStressTable>,
    /// Whether the smoothing length h stays as it is at the start.
    smoothing_length: SmoothingLengthValue,
    /// How steps are made: with one evaluation of all forces, which is right for everything, or with error control.
    integrator: IntegratorTable,
}

/// The keys that each stands for are in `quality.toml`.
#[derive(Debug, Clone, Copy, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Quality {
    Draft,
    Standard,
    Fine,
}

const CFL: Range = [1e-3, 1.0];
/// Of an integrator that refuses steps which are too long.
const LONG_CFL: Range = [1e-3, 2.0];
const FACTOR: Range = [0.0, 1.0];
const FLOOR: Range = [0.0, 1.0];
const BEYOND: Range = [0.0, 1.0];
const SMALLEST: Range = [0.01, 1.0];
const LARGEST: Range = [1.0, 100.0];

impl Default for NumericsTable {
    fn default() -> Self {
        Self {
            quality: None,
            kernel: Kernel::CubicSpline,
            cfl: Number::new(0.25),
            skin: SkinValue::Auto,
            eta: None,
            neighbours: None,
            viscosity: true,
            corrected_gradient: None,
            angular_momentum: None,
            density_contrast: None,
            contact_viscosity: false,
            reconstruction: false,
            viscosity_switch: Switch::off(),
            density_relaxation: Switch::off(),
            artificial_stress: Switch::off(),
            smoothing_length: SmoothingLengthValue::default(),
            integrator: IntegratorTable::default(),
        }
    }
}

/// h over (m / rho)^(1/d): default, least and largest.
const DEFAULT_ETA: f64 = 1.2;
/// Up to the 200 neighbours in 2D that Geretshauser et al. (2010, table 2) went to, whose h is the whole support: their h / l_c = 7 is
/// an eta of 3.76 on the hexagonal lattice.
const ETA: Range = [0.8, 4.0];

/// Bodies whose densities differ by more than this factor are told apart in their pairs, see `pair::contrast`.
const ALIKE: f64 = 2.0;
/// The factor from which on pairs are told apart where nothing has strength: below it both kinds of pairs keep energy, beyond it liquids in thin gas gain and lose as much as there is.
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

/// The numbers of neighbours that stand for an eta that is allowed.
fn number_of_neighbours(dimension: usize) -> RangeInclusive<f64> {
    let [low, high] = ETA;
    neighbours(low.next_up(), dimension).ceil()..=neighbours(high.next_down(), dimension).floor()
}

/// Viscosity that falls where nothing is shocked.
#[derive(Debug, Clone, Copy, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct ViscositySwitchTable {
    /// Least share of alpha.
    #[schemars(range(min = FLOOR[0], max = FLOOR[1]))]
    floor: Number,
}

impl Default for ViscositySwitchTable {
    fn default() -> Self {
        Self { floor: Number::new(0.1) }
    }
}

/// Density that returns to mass over volume.
#[derive(Debug, Clone, Copy, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct DensityRelaxationTable {
    /// By how much both may differ: sums over disordered particles are off by some per cent themselves, which a solid would feel as
    /// pressure.
    #[schemars(range(min = BEYOND[0], max = BEYOND[1]))]
    beyond: Number,
}

impl Default for DensityRelaxationTable {
    fn default() -> Self {
        Self { beyond: Number::new(0.05) }
    }
}

/// A repulsion against clumping in tension.
#[derive(Debug, Clone, Copy, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct ArtificialStressTable {
    /// Repulsion over the tension.
    #[schemars(range(min = FACTOR[0], max = FACTOR[1]))]
    factor: Number,
}

impl Default for ArtificialStressTable {
    fn default() -> Self {
        Self { factor: Number::new(0.2) }
    }
}

/// `"constant"`, or a table.
#[derive(Debug, Clone, Copy, Default)]
pub struct SmoothingLengthValue(Option<FollowingTable>);

/// A smoothing length that changes with the particle, within bounds in units of the first h.
#[derive(Debug, Clone, Copy, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct FollowingTable {
    /// What it follows.
    follows: Followed,
    /// Least h.
    #[serde(default = "half")]
    #[schemars(range(min = SMALLEST[0], max = SMALLEST[1]))]
    smallest: Number,
    /// Largest h.
    #[serde(default = "two")]
    #[schemars(range(min = LARGEST[0], max = LARGEST[1]))]
    largest: Number,
}

#[derive(Debug, Clone, Copy, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Followed {
    /// h = h_0 (rho_0 / rho)^(1/d).
    Density,
}

fn half() -> Number {
    Number::new(0.5)
}

fn two() -> Number {
    Number::new(2.0)
}

impl JsonSchema for SmoothingLengthValue {
    fn schema_name() -> Cow<'static, str> {
        "SmoothingLengthValue".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        json_schema!({ "anyOf": [{ "const": CONSTANT }, generator.subschema_for::<FollowingTable>()] })
    }
}

/// The word for a smoothing length that stays as it is.
const CONSTANT: &str = "constant";

impl Serialize for SmoothingLengthValue {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        match &self.0 {
            Some(follows) => follows.serialize(serializer),
            None => serializer.serialize_str(CONSTANT),
        }
    }
}

impl<'de> Deserialize<'de> for SmoothingLengthValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        struct ConstantOrTable;
        impl<'de> serde::de::Visitor<'de> for ConstantOrTable {
            type Value = SmoothingLengthValue;
            fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                f.write_str("\"constant\" or { follows = \"density\", smallest = 0.5, largest = 2.0 }")
            }
            fn visit_str<E: serde::de::Error>(self, word: &str) -> std::result::Result<Self::Value, E> {
                match word {
                    CONSTANT => Ok(SmoothingLengthValue(None)),
                    _ => Err(E::invalid_value(serde::de::Unexpected::Str(word), &self)),
                }
            }
            fn visit_map<A: serde::de::MapAccess<'de>>(self, map: A) -> std::result::Result<Self::Value, A::Error> {
                FollowingTable::deserialize(serde::de::value::MapAccessDeserializer::new(map))
                    .map(|f| SmoothingLengthValue(Some(f)))
            }
        }
        deserializer.deserialize_any(ConstantOrTable)
    }
}

/// How the sums are made.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct NumericsSettings {
    pub kernel: Kernel,
    /// Time step over h / signal speed.
    pub cfl: f64,
    /// Margin of neighbour lists over the support.
    pub skin: SkinRule,
    /// h over (m / rho)^(1/d).
    pub eta: f64,
    /// Whether artificial viscosity acts at all; its strength belongs to the material.
    pub viscosity: bool,
    pub corrected_gradient: bool,
    /// Whether forces between particles are to exert no torque.
    pub angular_momentum: bool,
    /// Whether the light one of a pair gives way, and the heavy one stands.
    pub density_contrast: bool,
    /// Whether what touches matter of a larger alpha has that alpha in all of its pairs.
    pub contact_viscosity: bool,
    /// Whether viscosity acts on reconstructed velocities.
    pub reconstruction: bool,
    /// Least share of alpha, where a switch decides it.
    pub viscosity_switch: Option<f64>,
    /// By how much density may differ from mass over volume, where it returns.
    pub density_relaxation: Option<f64>,
    pub artificial_stress: Option<ArtificialStress>,
    pub smoothing_length: SmoothingLengthRule,
    pub integrator: IntegratorRule,
}

/// Gray, Monaghan & Swift 2001, CMAME 190, 6641: repulsion by `factor` of the tension, times f^4.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ArtificialStress {
    pub factor: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum SmoothingLengthRule {
    Constant,
    /// h = h_0 (rho_0 / rho)^(1/d), within these bounds relative to h_0.
    FollowsDensity {
        smallest: f64,
        largest: f64,
    },
}

/// What of a scene's matter decides how its sums are made.
#[derive(Debug, Clone, Copy)]
pub struct Matter {
    /// Whether any has strength.
    pub solid: bool,
    /// Density of the densest body over that of the lightest.
    pub contrast: f64,
    /// Whether any body is rigid.
    pub rigid: bool,
}

impl NumericsTable {
    /// The table with eta for a number of neighbours, and what is right for the scene's matter.
    pub fn complete(&self, dimension: usize, Matter { solid, contrast, rigid }: Matter) -> Self {
        let mut complete = self.clone();
        complete.complete_eta(dimension);
        // In a scene that is not solid the contrast brings the corrected gradient with it.
        let unlike = rigid || contrast > if solid { ALIKE } else { APART };
        let wanted = unlike && self.density_contrast != Some(false);
        let corrected = *complete.corrected_gradient.get_or_insert(solid || wanted);
        // Beside artificial stress it costs rubber its rebound: thin walls in tension lose particles.
        complete.angular_momentum.get_or_insert(solid && corrected && self.artificial_stress.0.is_none());
        complete.density_contrast.get_or_insert(wanted && corrected);
        complete
    }

    /// A number of neighbours that is allowed becomes the eta that gives it.
    fn complete_eta(&mut self, dimension: usize) {
        match (self.eta, self.neighbours) {
            (None, None) => self.eta = Some(Number::new(DEFAULT_ETA)),
            (None, Some(number)) if number_of_neighbours(dimension).contains(&number.0) => {
                self.eta = Some(Number::new(eta_of(number.0, dimension)));
                self.neighbours = None;
            }
            _ => {}
        }
    }

    pub fn validate(&self, document: &Document, dimension: usize) -> Result<NumericsSettings> {
        let eta = self.valid_eta(document, dimension)?;
        let within =
            |key: &str, value: Number, range: Range| within(document, &format!("numerics.{key}"), value, range);
        let viscosity_switch = match self.viscosity_switch.0.filter(|_| self.viscosity) {
            None => None,
            Some(raw) => Some(within("viscosity_switch.floor", raw.floor, FLOOR)?),
        };
        let density_relaxation = match self.density_relaxation.0 {
            None => None,
            Some(raw) => Some(within("density_relaxation.beyond", raw.beyond, BEYOND)?),
        };
        let artificial_stress = match self.artificial_stress.0 {
            None => None,
            Some(raw) => Some(ArtificialStress { factor: within("artificial_stress.factor", raw.factor, FACTOR)? }),
        };
        let smoothing_length = match self.smoothing_length.0 {
            None => SmoothingLengthRule::Constant,
            Some(FollowingTable { follows: Followed::Density, smallest, largest }) => {
                SmoothingLengthRule::FollowsDensity {
                    smallest: within("smoothing_length.smallest", smallest, SMALLEST)?,
                    largest: within("smoothing_length.largest", largest, LARGEST)?,
                }
            }
        };
        let integrator = self.integrator.validate(document)?;
        let [corrected_gradient, angular_momentum, density_contrast] =
            [self.corrected_gradient, self.angular_momentum, self.density_contrast].map(|on| on == Some(true));
        if !corrected_gradient {
            for (key, on) in [
                ("angular_momentum", angular_momentum),
                ("density_contrast", density_contrast),
                ("reconstruction", self.reconstruction),
            ] {
                if on {
                    let what = "it needs what the corrected gradient knows of a neighbourhood";
                    let error = document.error(&format!("numerics.{key}"), what);
                    return Err(error.allowed("numerics.corrected_gradient = true"));
                }
            }
        }
        Ok(NumericsSettings {
            kernel: self.kernel,
            cfl: match integrator {
                IntegratorRule::PredictorCorrector => within("cfl", self.cfl, CFL)?,
                _ => within("cfl", self.cfl, LONG_CFL)?,
            },
            skin: self.skin.validate(document)?,
            eta,
            viscosity: self.viscosity,
            corrected_gradient,
            angular_momentum,
            density_contrast,
            contact_viscosity: self.contact_viscosity && self.viscosity,
            reconstruction: self.reconstruction && self.viscosity,
            viscosity_switch,
            density_relaxation,
            artificial_stress,
            smoothing_length,
            integrator,
        })
    }

    /// h over (m / rho)^(1/d).
    fn valid_eta(&self, document: &Document, dimension: usize) -> Result<f64> {
        let path = "numerics.neighbours";
        match (self.eta, self.neighbours) {
            (Some(_), Some(_)) => {
                Err(document.error(path, "both `eta` and `neighbours` are given").allowed("one of them"))
            }
            (eta, None) => within(document, "numerics.eta", eta.unwrap_or(Number::new(DEFAULT_ETA)), ETA),
            (None, Some(number)) => {
                let (fewest, most) = number_of_neighbours(dimension).into_inner();
                within(document, path, number, [fewest, most]).map(|number| eta_of(number, dimension))
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
        for key in ["density_contrast", "angular_momentum", "reconstruction"] {
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

    #[test]
    fn long_steps_need_error_control() {
        let cfl = |overrides: &[&str]| {
            let overrides: Vec<String> = overrides.iter().map(|text| text.to_string()).collect();
            Scene::parse("s.toml", TEXT, &overrides).map(|scene| scene.numerics.cfl)
        };
        let long = "numerics.cfl=1.5";
        assert_eq!(cfl(&[long, "numerics.integrator=cash_karp"]).unwrap(), 1.5);
        assert!(cfl(&[long]).err().unwrap().allowed.ends_with("to 1"));
        assert!(cfl(&["numerics.cfl=2.1", "numerics.integrator=cash_karp"]).is_err());
    }
}
