//! `[[body]]` as it is written, and the defaults that follow from other keys.

use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::blast::BlastTable;
use super::blocks::{JointsTable, RubbleTable};
use super::flow::FlowTable;
use super::from::FromTable;
use super::orientation::OrientationTable;
use super::rigid::RigidTable;
use super::shape::ShapeTable;
use crate::material::MaterialTable;
use crate::scene::geometry::lattice::LatticeKind;
use crate::scene::tables::motion::MotionTable;
use crate::scene::values::checks::{POSITIVE, Range};
use crate::scene::values::components::Components;
use crate::scene::values::switch::Switch;
use crate::scene::values::word::{self, word_or, word_schema};
use crate::units::{Angle, Density, Frequency, Length, Number, Pressure, SpecificEnergy, Speed};

/// Damage of intact and of broken matter.
pub const DAMAGE: Range = [0.0, 1.0];

/// A body: a shape of one material, filled with particles on a lattice.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BodyTable {
    /// Any name but a table's, without `.` and `=`; `--set NAME.KEY=VALUE` means the body.
    pub name: String,
    /// Shape around the body's centre; this or `from`.
    pub shape: Option<ShapeTable>,
    /// Particles of a file instead of a shape that is filled.
    pub from: Option<FromTable>,
    /// A material of the library, or of a table `[material.NAME]` with an `eos` or a `base`.
    pub material: String,
    /// Number of particles; this or `spacing`. The mass is that of the exact shape in any case.
    #[schemars(range(min = 1))]
    pub particles: Option<u64>,
    /// Distance of nearest particles. The projectile of an impact may have `"target"`, its default without `particles`: the target's
    /// spacing, or a finer one until the projectile has `least_particles`.
    #[schemars(extend("x-allowed" = POSITIVE))]
    pub spacing: Option<Spacing>,
    /// Least number of particles of a projectile with `spacing = "target"`.
    #[schemars(range(min = 1))]
    #[schemars(extend("default" = COARSEST_PROJECTILE))]
    pub least_particles: Option<u64>,
    /// Arrangement of the particles.
    #[serde(default)]
    pub lattice: LatticeKind,
    /// Random shifts of particles from the sites of the lattice; none without it.
    pub disorder: Option<DisorderTable>,
    /// How the lattice is turned; upright without it.
    pub orientation: Option<OrientationTable>,
    /// Where the centre is, one component per dimension; the origin without it. `[impact]` places the projectile.
    pub position: Option<Components<Length>>,
    /// Velocity of the centre; at rest without it. `[impact]` gives the projectile's, and the target of an impact rests.
    pub velocity: Option<Components<Speed>>,
    /// Angular velocity about the centre, one number in 2D; none without it.
    pub spin: Option<Components<Frequency>>,
    /// Damage at the start. It grows with fracture and stays without it. Broken matter does not pull: a liquid or
    /// strengthless ground should have 1, as otherwise it bears as much tension as the crystal would.
    #[schemars(range(min = DAMAGE[0], max = DAMAGE[1]))]
    #[schemars(extend("default" = DAMAGE[0]))]
    pub damage: Option<Number>,
    /// Distention at the start: density of the matrix over that of the body. Only with porosity; the crush curve of the material
    /// is scaled to it.
    #[schemars(range(min = 1))]
    #[schemars(extend("x-default" = "that of the porosity"))]
    pub distention: Option<Number>,
    /// Filling factor of dust at the start, the share of its volume that monomers fill, above 0; this or `density`.
    #[schemars(range(max = 1))]
    #[schemars(extend("x-default" = "the density over that of the monomers"))]
    pub filling_factor: Option<Number>,
    /// Density at the start. A gas requires it.
    #[schemars(extend("x-allowed" = POSITIVE))]
    #[schemars(extend("x-default" = "the material's over the distention"))]
    pub density: Option<Density>,
    /// Specific internal energy at the start.
    #[schemars(extend("default" = SpecificEnergy::default()))]
    pub internal_energy: Option<SpecificEnergy>,
    /// Pressure at the start, of an ideal gas, instead of `internal_energy`.
    #[schemars(extend("x-allowed" = POSITIVE))]
    pub pressure: Option<Pressure>,
    /// How the whole body moves whatever the forces; freely without it.
    pub motion: Option<MotionTable>,
    /// The body does not deform: all of it moves as one, and it stands for whatever hits it. `true`, or a table.
    pub rigid: Option<Switch<RigidTable>>,
    /// A field of velocity at the start, around the body's centre and added to `velocity`.
    pub flow: Option<FlowTable>,
    /// Heat in the middle at the start.
    pub blast: Option<BlastTable>,
    /// The body is a pile of blocks; solid without it.
    pub rubble: Option<RubbleTable>,
    /// The body is parted into blocks by fracture before the start. Needs a material with fracture.
    pub joints: Option<JointsTable>,
    /// Whether the body carries its own weight from the start.
    #[serde(default)]
    pub start: InitialState,
}

/// How a body's particles start.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum InitialState {
    /// On the lattice, at the density of the body.
    #[default]
    Unloaded,
    /// Compressed by its weight: the shape is that without load, and the mass stays. A solid without pores: a ball in a scene with
    /// `gravity.self`, or a box that fills its periods under `gravity.uniform`, whose lower face stays where it is.
    Hydrostatic,
}

/// Random shifts of particles from the sites of their lattice.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DisorderTable {
    /// Largest shift along each axis, in spacings.
    #[schemars(range(min = SHIFT[0], max = SHIFT[1]))]
    pub shift: Number,
    /// Another seed gives other shifts.
    #[serde(default)]
    pub seed: u64,
}

/// In spacings.
pub const SHIFT: Range = [0.0, 0.5];

/// Distance of nearest particles: given, or the target's (finer where the projectile would be too coarse).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Spacing {
    OfTarget,
    Given(Length),
}

impl Spacing {
    const WORD: &str = "target";
}

impl Serialize for Spacing {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let given = match self {
            Spacing::OfTarget => None,
            Spacing::Given(length) => Some(length),
        };
        word::serialize(given, Self::WORD, serializer)
    }
}

word_schema!(Spacing, Length);

impl<'de> Deserialize<'de> for Spacing {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        word_or(deserializer, Self::WORD).map(|given| given.map_or(Spacing::OfTarget, Spacing::Given))
    }
}

/// The least number of particles of a projectile whose spacing follows the target's, unless the scene names another.
const COARSEST_PROJECTILE: u64 = 100;

impl BodyTable {
    /// The table with every default filled in, as far as it can be: what is missing then is an error to who reads it. `material`: the
    /// body's, where it is known.
    pub fn complete(&self, dimension: usize, is_projectile: bool, material: Option<&MaterialTable>) -> Self {
        let mut complete = self.clone();
        if is_projectile && self.particles.is_none() && self.from.is_none() {
            let spacing = *complete.spacing.get_or_insert(Spacing::OfTarget);
            if spacing == Spacing::OfTarget {
                complete.least_particles.get_or_insert(COARSEST_PROJECTILE);
            }
        }
        if !is_projectile {
            complete.position.get_or_insert_with(|| Components::zero(dimension));
            complete.velocity.get_or_insert_with(|| Components::zero(dimension));
        }
        complete.spin.get_or_insert_with(|| Components::zero(if dimension == 2 { 1 } else { 3 }));
        let upright = || Components([0.0, 0.0, 1.0].map(Number::new).to_vec());
        complete.orientation.get_or_insert_with(|| OrientationTable {
            seed: None,
            axis: (dimension == 3).then(upright),
            angle: Some(Angle(0.0)),
        });
        if let Some(material) = material {
            complete.complete_state(material);
        }
        complete
    }

    /// The velocity that its motion prescribes.
    pub fn prescribed_velocity(&self) -> Option<&Components<Speed>> {
        match &self.motion {
            Some(MotionTable::Velocity(velocity)) => Some(velocity),
            _ => None,
        }
    }

    /// The table of a rigid body.
    pub fn rigid(&self) -> Option<RigidTable> {
        self.rigid.and_then(|rigid| rigid.0)
    }

    /// What the material says of damage, pores, density and energy.
    fn complete_state(&mut self, material: &MaterialTable) {
        if material.has_fracture() {
            self.damage.get_or_insert(Number::new(0.0));
        }
        let mut distention = 1.0;
        if let Some(porosity) = &material.porosity {
            distention = self.distention.get_or_insert(porosity.distention).0;
        }
        if let Some(law) = material.dust() {
            let solid = law.solid_density();
            let given = self.filling_factor.map(|phi| Density::new(phi.0 * solid));
            let density = self.density.get_or_insert(given.unwrap_or(Density::new(law.reference_density()))).0;
            self.filling_factor.get_or_insert(Number::new(density / solid));
        }
        if self.from.is_some() {
            return;
        }
        // A porous body is as heavy as its matrix.
        self.density = self.density.or(material.reference_density().map(|density| Density::new(density / distention)));
        if self.pressure.is_none() {
            self.internal_energy.get_or_insert_default();
        }
    }
}
