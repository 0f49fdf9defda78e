//! Bodies: a shape of one material on a lattice, with what its particles start with.

use std::ops::Range;

use serde::{Deserialize, Serialize};

use super::blocks::{Joints, Rubble};
use super::boundaries::fills;
use super::cut::Cut;
use super::hydrostatic::Start;
use super::lattice::{Faces, IDENTITY, Lattice, LatticeKind, Rotation, random_rotation, rotation_about};
use super::raw::{Components, RawBody, RawOrientation, RawShape, Spacing};
use super::shape::Shape;
use super::source::Document;
use super::start::{Blast, Flow};
use crate::error::{Error, Result};
use crate::material::eos::EosTable;
use crate::material::{BodyConstants, MaterialTable};
use crate::motion::Motion;
use crate::particles::Periods;
use crate::units::{Angle, Density, Frequency, Length, Number, Quantity, SpecificEnergy, Speed};

/// A validated body, SI units.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Body {
    pub name: String,
    pub shape: Shape,
    pub dimension: usize,
    /// Index into the scene's materials.
    pub material: usize,
    pub lattice: Lattice,
    /// Where the shape's centre is, m.
    pub centre: [f64; 3],
    /// Velocity of the centre, m/s.
    pub velocity: [f64; 3],
    /// Angular velocity about the centre, rad/s; along z in 2D.
    pub spin: [f64; 3],
    /// Damage at the start, 0 to 1.
    pub damage: f64,
    /// Specific internal energy at the start, J/kg.
    pub internal_energy: f64,
    /// Density at the start, kg/m^3.
    pub density: f64,
    /// Distention at the start, 1 without pores.
    pub distention: f64,
    pub motion: Motion,
    pub flow: Option<Flow>,
    pub blast: Option<Blast>,
    pub rubble: Option<Rubble>,
    pub joints: Option<Joints>,
    pub start: Start,
    /// What of the shape it is, where an impact refines its target.
    pub cut: Option<Cut>,
}

impl Body {
    /// Exact volume of its matter, m^3 (in 2D m^2, per metre of depth).
    pub fn volume(&self) -> f64 {
        self.cut.map_or_else(|| self.whole_volume(), |cut| cut.volume)
    }

    /// The same of all parts together.
    fn whole_volume(&self) -> f64 {
        self.rubble.as_ref().map_or_else(|| self.shape.volume(self.dimension), |rubble| rubble.volume)
    }

    /// Exact mass of its matter, kg (per metre of depth in 2D).
    pub fn mass(&self) -> f64 {
        self.density * self.volume()
    }

    /// Exact mass of the body that it is or is a part of, kg (per metre of depth in 2D).
    pub fn whole_mass(&self) -> f64 {
        self.density * self.whole_volume()
    }

    /// Number of the scene's body that this one, with this number, is or is a part of.
    pub fn whole(&self, number: usize) -> usize {
        self.cut.map_or(number, |cut| cut.body)
    }

    pub fn contains(&self, point: [f64; 3]) -> bool {
        self.holds(std::array::from_fn(|k| point[k] - self.centre[k]))
    }

    /// Velocity at the start of a particle at `point`, m/s, but for a mode of vibration.
    pub fn velocity_at(&self, point: [f64; 3]) -> [f64; 3] {
        let r: [f64; 3] = std::array::from_fn(|k| point[k] - self.centre[k]);
        let [wx, wy, wz] = self.spin;
        let turning = [wy * r[2] - wz * r[1], wz * r[0] - wx * r[2], wx * r[1] - wy * r[0]];
        let flow = self.flow.and_then(|flow| flow.velocity(r)).unwrap_or_default();
        std::array::from_fn(|k| self.velocity[k] + turning[k] + flow[k])
    }

    /// Damage at the start of a particle at `point`: whole where a joint or the surface of a block is less than a spacing away.
    pub fn damage_at(&self, point: [f64; 3]) -> f64 {
        let local = std::array::from_fn(|k| point[k] - self.centre[k]);
        let joint = self.joints.as_ref().map_or(f64::INFINITY, |joints| joints.depth(local));
        let surface = self.rubble.as_ref().and_then(|rubble| rubble.depth(local)).unwrap_or(f64::INFINITY);
        if joint.min(surface) < self.lattice.spacing { 1.0 } else { self.damage }
    }

    fn holds(&self, local: [f64; 3]) -> bool {
        is_filled(local, &self.shape, self.rubble.as_ref(), self.dimension)
            && self.cut.is_none_or(|cut| cut.holds(local))
    }

    /// Lattice sites are numbered below this; those inside the shape are its particles.
    pub fn lattice_sites(&self) -> u64 {
        self.lattice.sites()
    }

    /// The sites of `range` that lie inside, with their positions: the same bits whoever asks.
    pub fn sites(&self, range: Range<u64>) -> impl Iterator<Item = (u64, [f64; 3])> + '_ {
        range.filter_map(|site| {
            let local = self.lattice.position(site);
            self.holds(local).then(|| (site, std::array::from_fn(|k| self.centre[k] + local[k])))
        })
    }

    /// Particles among the sites of `range`.
    pub fn count(&self, range: Range<u64>) -> u64 {
        range.filter(|site| self.holds(self.lattice.position(*site))).count() as u64
    }

    /// Whether it has no particles at all; those of many sites are not counted.
    pub(super) fn has_no_site(&self) -> bool {
        let sites = self.lattice_sites();
        sites <= COUNTED && self.count(0..sites) == 0
    }

    /// Particles as expected from the volume; the true number differs at the surface.
    pub fn expected_particles(&self) -> f64 {
        self.volume() / self.lattice.cell_volume()
    }

    /// What all particles share, once their number is known; `eta` is h over (m / rho)^(1/d).
    pub fn constants(&self, particles: u64, eta: f64) -> BodyConstants {
        let particle_mass = self.mass() / particles as f64;
        let smoothing_length = eta * root(particle_mass / self.density, self.dimension);
        BodyConstants { particle_mass, smoothing_length, particles, density: self.density, distention: self.distention }
    }

    /// Smoothing length as expected from the lattice, before particles are counted, m.
    pub fn expected_smoothing_length(&self, eta: f64) -> f64 {
        eta * root(self.lattice.cell_volume(), self.dimension)
    }
}

/// Whether there is matter at a place relative to the centre of a shape.
fn is_filled(local: [f64; 3], shape: &Shape, rubble: Option<&Rubble>, dimension: usize) -> bool {
    shape.contains(local, dimension) && rubble.is_none_or(|rubble| rubble.depth(local).is_some())
}

/// The d-th root.
fn root(volume: f64, dimension: usize) -> f64 {
    if dimension == 2 { volume.sqrt() } else { libm::cbrt(volume) }
}

/// Validates one body and fills in its defaults. Its key path is `path` (`body.0`).
pub struct Reader<'a> {
    pub document: &'a Document<'a>,
    pub path: String,
    pub dimension: usize,
    pub periods: &'a Periods,
    /// Spacing that "target" stands for, m.
    pub target_spacing: Option<f64>,
    /// Whether [impact] places and moves this body; then it cannot do so itself.
    pub placed: bool,
}

/// Bodies of up to this many lattice sites are counted when read; larger ones are close to their expected number.
const COUNTED: u64 = 400_000;
/// Distance from the origin in spacings at which a millionth of a spacing is lost.
const FARTHEST: f64 = 1e10;
/// The least number of particles of a projectile whose spacing follows the target's, unless the scene names another.
const COARSEST_PROJECTILE: u64 = 100;

impl Reader<'_> {
    pub fn read(&self, raw: &mut RawBody, material: (usize, &MaterialTable)) -> Result<Body> {
        let shape = self.shape(&raw.shape)?;
        let distention = self.distention(raw, material.1)?;
        let (density, internal_energy) = self.thermal_state(raw, material.1, distention)?;
        let rotation = self.rotation(raw)?;
        let rubble = self.rubble(raw, &shape)?;
        let lattice = self.lattice(raw, (&shape, rubble.as_ref()), rotation)?;
        let zero = |n: usize| vec![0.0; n];
        if !self.placed {
            raw.position.get_or_insert_with(|| Components(zero(self.dimension).into_iter().map(Length::new).collect()));
            raw.velocity.get_or_insert_with(|| Components(zero(self.dimension).into_iter().map(Speed::new).collect()));
        }
        let turns = if self.dimension == 2 { 1 } else { 3 };
        let spin = raw.spin.get_or_insert_with(|| Components(zero(turns).into_iter().map(Frequency::new).collect()));
        let spin = match (self.dimension, &spin.0[..]) {
            (2, [about_z]) => [0.0, 0.0, about_z.0],
            (3, [x, y, z]) => [x.0, y.0, z.0],
            (2, _) => return Err(self.error("spin", "a spin in 2D is one number, about z")),
            _ => return Err(self.error("spin", "a spin has three components")),
        };
        let body = Body {
            name: raw.name.clone(),
            shape,
            dimension: self.dimension,
            material: material.0,
            lattice,
            centre: self.vector("position", &raw.position)?,
            velocity: self.vector("velocity", &raw.velocity)?,
            spin,
            damage: self.damage(raw, material.1)?,
            internal_energy,
            density,
            distention,
            motion: Motion::Free,
            flow: self.flow(raw)?,
            blast: self.blast(raw)?,
            rubble,
            joints: self.joints(raw, &shape, material.1)?,
            start: raw.start,
            cut: None,
        };
        let body = Body { motion: self.motion(raw, body.velocity)?, ..body };
        let mass = body.mass();
        if !(mass > 0.0 && mass.is_finite()) {
            let what = format!("the mass of the body comes to {mass} kg");
            return Err(self.error("shape", what).allowed("sizes within reach of numbers"));
        }
        if let Some(far) = body.centre.iter().find(|x| x.abs() > FARTHEST * body.lattice.spacing) {
            let what = format!("at {} numbers do not tell its particles apart", Length::new(*far));
            return Err(self.error("position", what).allowed("places nearer to the origin, or larger particles"));
        }
        if body.has_no_site() {
            let what = format!("no particle fits into the body at a spacing of {}", Length::new(body.lattice.spacing));
            return Err(self.error("spacing", what).allowed("a smaller spacing, or a number of particles"));
        }
        Ok(body)
    }

    fn error(&self, key: &str, what: impl Into<String>) -> Error {
        self.document.error(&format!("{}.{key}", self.path), what)
    }

    fn positive<const L: i8, const M: i8, const T: i8>(&self, key: &str, value: Quantity<L, M, T>) -> Result<f64> {
        if value.0 > 0.0 {
            return Ok(value.0);
        }
        let name = key.rsplit('.').next().unwrap_or(key);
        Err(self.error(key, format!("{name} is {value}")).allowed("more than 0"))
    }

    fn shape(&self, raw: &RawShape) -> Result<Shape> {
        match raw {
            RawShape::Sphere(ball) => Ok(Shape::Sphere { radius: self.positive("shape.sphere.radius", ball.radius)? }),
            RawShape::HalfSphere(ball) => {
                let radius = self.positive("shape.half_sphere.radius", ball.radius)?;
                if !(0.0..radius).contains(&ball.inner.0) {
                    let what = format!("inner is {} in a half sphere of {}", ball.inner, ball.radius);
                    return Err(self.error("shape.half_sphere.inner", what).allowed("0 to below the radius"));
                }
                Ok(Shape::HalfSphere { radius, inner: ball.inner.0 })
            }
            RawShape::Cylinder(_) if self.dimension == 2 => Err(self
                .error("shape.cylinder", "a cylinder needs three dimensions")
                .allowed("sphere, box, half_sphere")),
            RawShape::Cylinder(cylinder) => Ok(Shape::Cylinder {
                radius: self.positive("shape.cylinder.radius", cylinder.radius)?,
                height: self.positive("shape.cylinder.height", cylinder.height)?,
            }),
            RawShape::Heap(heap) => {
                let radius = self.positive("shape.heap.radius", heap.radius)?;
                if !(0.0..=radius).contains(&heap.top.0) {
                    let what = format!("top is {} above a foot of {}", heap.top, heap.radius);
                    return Err(self.error("shape.heap.top", what).allowed("0 to the radius"));
                }
                let height = self.positive("shape.heap.height", heap.height)?;
                Ok(Shape::Heap { radius, top: heap.top.0, height })
            }
            RawShape::Box(edges) => {
                let size = self.components("shape.box.size", &edges.size)?;
                for edge in &edges.size.0 {
                    self.positive("shape.box.size", *edge)?;
                }
                Ok(Shape::Box { size })
            }
        }
    }

    fn vector<const L: i8, const M: i8, const T: i8>(
        &self,
        key: &str,
        given: &Option<Components<Quantity<L, M, T>>>,
    ) -> Result<[f64; 3]> {
        match given {
            None => Ok([0.0; 3]),
            Some(_) if self.placed => Err(self.error(key, format!("the {key} of this body follows from [impact]"))),
            Some(components) => self.components(key, components),
        }
    }

    fn components<const L: i8, const M: i8, const T: i8>(
        &self,
        key: &str,
        components: &Components<Quantity<L, M, T>>,
    ) -> Result<[f64; 3]> {
        let given = components.0.len();
        if given != self.dimension {
            let what =
                format!("{given} component{} in {} dimensions", if given == 1 { "" } else { "s" }, self.dimension);
            return Err(self.error(key, what).allowed(format!("{} components", self.dimension)));
        }
        let mut vector = [0.0; 3];
        vector.iter_mut().zip(&components.0).for_each(|(v, c)| *v = c.0);
        Ok(vector)
    }

    fn motion(&self, raw: &RawBody, velocity: [f64; 3]) -> Result<Motion> {
        let path = format!("{}.motion", self.path);
        match &raw.motion {
            None => Ok(Motion::Free),
            Some(motion) => motion.validate(self.document, &path, (self.dimension, velocity)),
        }
    }

    fn flow(&self, raw: &RawBody) -> Result<Option<Flow>> {
        let path = format!("{}.flow", self.path);
        raw.flow.as_ref().map(|flow| flow.validate(self.document, &path, self.dimension)).transpose()
    }

    fn blast(&self, raw: &RawBody) -> Result<Option<Blast>> {
        let path = format!("{}.blast", self.path);
        raw.blast.as_ref().map(|blast| blast.validate(self.document, &path)).transpose()
    }

    fn rubble(&self, raw: &RawBody, shape: &Shape) -> Result<Option<Rubble>> {
        let path = format!("{}.rubble", self.path);
        raw.rubble.as_ref().map(|rubble| rubble.pile(self.document, &path, shape, self.dimension)).transpose()
    }

    fn joints(&self, raw: &RawBody, shape: &Shape, material: &MaterialTable) -> Result<Option<Joints>> {
        let Some(joints) = &raw.joints else { return Ok(None) };
        if !material.has_fracture() {
            let what = format!("material `{}` has no fracture, so there are no joints", raw.material);
            let error = self.error("joints", what);
            return Err(error.allowed(format!("a table [material.{}.fracture]", raw.material)));
        }
        let path = format!("{}.joints", self.path);
        joints.network(self.document, &path, shape, self.dimension).map(Some)
    }

    fn damage(&self, raw: &mut RawBody, material: &MaterialTable) -> Result<f64> {
        match raw.damage {
            None if material.has_fracture() => raw.damage = Some(Number::new(0.0)),
            None => {}
            Some(damage) if !(0.0..=1.0).contains(&damage.0) => {
                return Err(self.error("damage", format!("damage is {damage}")).allowed("0 to 1"));
            }
            Some(_) if material.eos.law().bulk_modulus().is_none() => {
                return Err(self.error("damage", format!("material `{}` is a gas, which does not break", raw.material)));
            }
            Some(_) => {}
        }
        Ok(raw.damage.map_or(0.0, |damage| damage.0))
    }

    fn distention(&self, raw: &mut RawBody, material: &MaterialTable) -> Result<f64> {
        let Some(table) = &material.porosity else {
            return match raw.distention {
                None => Ok(1.0),
                Some(_) => {
                    let what = format!("material `{}` has no porosity, so there is no distention", raw.material);
                    let error = self.error("distention", what);
                    Err(error.allowed(format!("a table [material.{}.porosity]", raw.material)))
                }
            };
        };
        let distention = *raw.distention.get_or_insert(table.distention);
        if distention.0 >= 1.0 && distention.0.is_finite() {
            return Ok(distention.0);
        }
        Err(self.error("distention", format!("distention is {distention}")).allowed("1 (no pores) and above"))
    }

    /// Density and specific internal energy; a porous body is as heavy as its matrix.
    fn thermal_state(&self, raw: &mut RawBody, material: &MaterialTable, distention: f64) -> Result<(f64, f64)> {
        let reference = material.reference_density().map(|density| Density::new(density / distention));
        let Some(density) = raw.density.or(reference) else {
            return Err(self.error("density", "key `density` is missing: a gas has no density of its own"));
        };
        let rho = self.positive("density", density)?;
        raw.density = Some(density);
        let energy = match (raw.pressure, raw.internal_energy, &material.eos) {
            (None, energy, _) => {
                let energy = *raw.internal_energy.insert(energy.unwrap_or_default());
                if energy.0 < 0.0 {
                    let what = format!("internal_energy is {}", SpecificEnergy::new(energy.0));
                    return Err(self.error("internal_energy", what).allowed("0 or more"));
                }
                energy.0
            }
            (Some(_), Some(_), _) => {
                return Err(self
                    .error("pressure", "both pressure and internal_energy are given")
                    .allowed("one of them"));
            }
            (Some(pressure), None, EosTable::IdealGas(gas)) => {
                self.positive("pressure", pressure)?;
                let gamma = gas.gamma.0;
                let energy = pressure.0 / ((gamma - 1.0) * rho);
                if !energy.is_finite() {
                    let what = format!("a pressure of {pressure} at {density} takes more energy than numbers reach");
                    return Err(self.error("pressure", what).allowed("sizes within reach of numbers"));
                }
                energy
            }
            (Some(_), None, _) => {
                let what = "only an ideal gas starts from a pressure";
                return Err(self.error("pressure", what).allowed("density and internal_energy"));
            }
        };
        Ok((rho, energy))
    }

    fn rotation(&self, raw: &mut RawBody) -> Result<Rotation> {
        let upright = || Components([0.0, 0.0, 1.0].map(Number::new).to_vec());
        let given = raw.orientation.get_or_insert_with(|| RawOrientation {
            seed: None,
            axis: (self.dimension == 3).then(upright),
            angle: Some(Angle(0.0)),
        });
        let about = |axis, angle: Angle| Ok(rotation_about(axis, angle.0));
        match (given.seed, &given.axis, given.angle, self.dimension) {
            (Some(seed), None, None, dimension) => Ok(random_rotation(seed, dimension)),
            (None, None, Some(angle), 2) => about([0.0, 0.0, 1.0], angle),
            (None, Some(axis), Some(angle), 3) => {
                let axis = self.components("orientation.axis", axis)?;
                if axis == [0.0; 3] {
                    return Err(self.error("orientation.axis", "the axis has no length"));
                }
                about(axis, angle)
            }
            (_, _, _, 2) => Err(self.error("orientation", "unclear").allowed("{ seed = 3 } or { angle = \"30 deg\" }")),
            _ => {
                let allowed = "{ seed = 3 } or { axis = [0, 0, 1], angle = \"30 deg\" }";
                Err(self.error("orientation", "unclear").allowed(allowed))
            }
        }
    }

    fn lattice(
        &self,
        raw: &mut RawBody,
        (shape, rubble): (&Shape, Option<&Rubble>),
        rotation: Rotation,
    ) -> Result<Lattice> {
        if raw.particles.is_none() && raw.spacing.is_none() && self.target_spacing.is_some() {
            raw.spacing = Some(Spacing::OfTarget);
        }
        if let Some(least) = raw.least_particles
            && (least == 0 || raw.spacing != Some(Spacing::OfTarget))
        {
            let what = format!("{least} cannot be the least number of particles");
            let allowed = "1 or more, of the projectile of an [impact] with spacing = \"target\"";
            return Err(self.error("least_particles", what).allowed(allowed));
        }
        let faces = match *shape {
            Shape::Box { size } => Faces { flat: true, periodic: fills(self.periods, size) },
            _ => Faces::default(),
        };
        if faces.periodic != [false; 3] && rotation != IDENTITY {
            let what = "a turned lattice does not go on beyond a period";
            return Err(self.error("orientation", what).allowed("no orientation"));
        }
        let filling = Filling { kind: raw.lattice, rotation, shape, rubble, dimension: self.dimension, faces };
        let lattice = match (raw.particles, raw.spacing) {
            (Some(_), Some(_)) => {
                return Err(self.error("particles", "both particles and spacing are given").allowed("one of them"));
            }
            (None, None) => {
                return Err(self
                    .error("particles", "the body has no particles")
                    .allowed("particles = 20000 or spacing = \"2 km\""));
            }
            (Some(0), None) => return Err(self.error("particles", "particles is 0").allowed("1 or more")),
            (Some(particles), None) => filling.with_particles(particles),
            (None, Some(Spacing::Given(spacing))) => filling.lattice(self.positive("spacing", spacing)?),
            (None, Some(Spacing::OfTarget)) => match self.target_spacing {
                Some(spacing) => filling.at_least(*raw.least_particles.get_or_insert(COARSEST_PROJECTILE), spacing),
                None => {
                    let what = "only the projectile of an [impact] follows the target's spacing";
                    return Err(self.error("spacing", what).allowed("a length"));
                }
            },
        };
        lattice.map_err(|e| e.at(self.document.place(&format!("{}.spacing", self.path))))
    }
}

/// A shape to be filled with a lattice.
struct Filling<'a> {
    kind: LatticeKind,
    rotation: Rotation,
    shape: &'a Shape,
    rubble: Option<&'a Rubble>,
    dimension: usize,
    faces: Faces,
}

impl Filling<'_> {
    fn lattice(&self, spacing: f64) -> Result<Lattice> {
        Lattice::covering(self.kind, spacing, self.rotation, self.shape.bounds(self.dimension), self.faces)
    }

    fn spacing_of(&self, particles: f64) -> f64 {
        let volume = self.rubble.map_or_else(|| self.shape.volume(self.dimension), |rubble| rubble.volume);
        self.kind.spacing_of_cell(volume / particles, self.dimension)
    }

    fn count(&self, lattice: &Lattice) -> u64 {
        let holds = |site: &u64| is_filled(lattice.position(*site), self.shape, self.rubble, self.dimension);
        (0..lattice.sites()).filter(holds).count() as u64
    }

    /// The spacing follows from the volume; flat faces can hold a row more or less than that, so spacings near it are tried
    /// until the number is within one per cent. Where none is (rows come and go as a whole), the nearest is taken.
    fn with_particles(&self, particles: u64) -> Result<Lattice> {
        let expected = self.spacing_of(particles as f64);
        let mut best = self.lattice(expected)?;
        if best.sites() > COUNTED {
            return Ok(best);
        }
        let mut least = self.count(&best).abs_diff(particles);
        for trial in 2..=60 {
            if 100 * least <= particles {
                break;
            }
            let side = if trial % 2 == 0 { 1.0 } else { -1.0 };
            let lattice = self.lattice(expected * (1.0 + side * 0.002 * (trial / 2) as f64))?;
            let off = self.count(&lattice).abs_diff(particles);
            if off < least {
                (best, least) = (lattice, off);
            }
        }
        Ok(best)
    }

    /// The given spacing, or finer until there are `particles`.
    fn at_least(&self, particles: u64, spacing: f64) -> Result<Lattice> {
        let mut spacing = spacing.min(self.spacing_of(particles as f64));
        loop {
            let lattice = self.lattice(spacing)?;
            if lattice.sites() > COUNTED || self.count(&lattice) >= particles {
                return Ok(lattice);
            }
            spacing *= 0.99;
        }
    }
}
