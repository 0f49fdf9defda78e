//! `[[body]]` validated: every key of one body, and what they say together.

use super::blast::Blast;
use super::filling::Filling;
use super::flow::Flow;
use super::rigid::Rigid;
use super::rigid_rules;
use super::table::{BodyTable, DAMAGE, SHIFT, Spacing};
use super::validated::{Body, Disorder};
use crate::error::{Error, Result};
use crate::material::MaterialTable;
use crate::material::eos::EosTable;
use crate::motion::PrescribedMotion;
use crate::particles::Periods;
use crate::scene::document::source::Document;
use crate::scene::geometry::joints::Joints;
use crate::scene::geometry::lattice::{Faces, IDENTITY, Lattice, Rotation};
use crate::scene::geometry::periods::fills;
use crate::scene::geometry::rubble::Rubble;
use crate::scene::geometry::shape::BodyShape;
use crate::scene::values::checks::{POSITIVE, within};
use crate::scene::values::components::Components;
use crate::units::{Length, Quantity};

/// Validates one body, whose key path is `path` (`body.0`).
pub struct BodyReader<'a> {
    pub document: &'a Document<'a>,
    pub path: String,
    pub dimension: usize,
    pub periods: &'a Periods,
    /// Spacing that "target" stands for, m.
    pub target_spacing: Option<f64>,
    /// Whether `[impact]` places and moves this body; then it cannot do so itself.
    pub placed: bool,
}

/// Distance from the origin in spacings at which a millionth of a spacing is lost.
const FARTHEST: f64 = 1e10;

impl BodyReader<'_> {
    pub fn read(&self, raw: &BodyTable, material: (usize, &MaterialTable)) -> Result<Body> {
        let Some(shape) = &raw.shape else {
            let what = "key `shape` is missing";
            return Err(self.error("shape", what).allowed("a shape, or `from` with the name of a file of particles"));
        };
        let shape = shape.validate(self.document, &self.path, self.dimension)?;
        let distention = self.distention(raw, material.1)?;
        let (density, internal_energy) = self.thermal_state(raw, material.1)?;
        let rotation = self.rotation(raw)?;
        let rubble = self.rubble(raw, &shape)?;
        let lattice = self.lattice(raw, &shape, rubble.as_ref(), rotation)?;
        let spin = self.spin(raw)?;
        let joints = self.joints(raw, &shape, material.1)?;
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
            motion: PrescribedMotion::Free,
            rigid: self.rigid(raw, material.1)?,
            disorder: self.disorder(raw)?,
            flow: self.flow(raw, material.1)?,
            blast: self.blast(raw)?,
            rubble,
            joints,
            start: raw.start,
            cut: None,
            given: None,
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

    pub(super) fn error(&self, key: &str, what: impl Into<String>) -> Error {
        self.document.error(&format!("{}.{key}", self.path), what)
    }

    fn positive<const L: i8, const M: i8, const T: i8>(&self, key: &str, value: Quantity<L, M, T>) -> Result<f64> {
        if value.0 > 0.0 {
            return Ok(value.0);
        }
        let name = key.rsplit('.').next().unwrap_or(key);
        Err(self.error(key, format!("{name} is {value}")).allowed(POSITIVE))
    }

    pub(super) fn spin(&self, raw: &BodyTable) -> Result<[f64; 3]> {
        match (self.dimension, raw.spin.as_ref().map(|spin| &spin.0[..])) {
            (_, None) => Ok([0.0; 3]),
            (2, Some([about_z])) => Ok([0.0, 0.0, about_z.0]),
            (3, Some([x, y, z])) => Ok([x.0, y.0, z.0]),
            (2, _) => Err(self.error("spin", "a spin in 2D is one number, about z")),
            _ => Err(self.error("spin", "a spin has three components")),
        }
    }

    pub(super) fn vector<const L: i8, const M: i8, const T: i8>(
        &self,
        key: &str,
        given: &Option<Components<Quantity<L, M, T>>>,
    ) -> Result<[f64; 3]> {
        match given {
            None => Ok([0.0; 3]),
            Some(_) if self.placed => Err(self.error(key, format!("the {key} of this body follows from [impact]"))),
            Some(components) => components.vector(self.document, &format!("{}.{key}", self.path), self.dimension),
        }
    }

    pub(super) fn motion(&self, raw: &BodyTable, velocity: [f64; 3]) -> Result<PrescribedMotion> {
        let path = format!("{}.motion", self.path);
        match &raw.motion {
            None => Ok(PrescribedMotion::Free),
            Some(motion) => motion.validate(self.document, &path, self.dimension, velocity),
        }
    }

    fn rigid(&self, raw: &BodyTable, material: &MaterialTable) -> Result<Option<Rigid>> {
        raw.rigid().map(|rigid| rigid_rules::validate(&rigid, self.document, &self.path, raw, material)).transpose()
    }

    fn flow(&self, raw: &BodyTable, material: &MaterialTable) -> Result<Option<Flow>> {
        let path = format!("{}.flow", self.path);
        let Some(flow) = &raw.flow else { return Ok(None) };
        let flow = flow.validate(self.document, &path, self.dimension)?;
        if matches!(flow, Flow::Vortex { .. }) && !matches!(material.eos, EosTable::IdealGas(_)) {
            let what = "the pressure of a vortex is that of an ideal gas";
            return Err(self.error("flow.vortex", what).allowed("a material with eos.ideal_gas"));
        }
        Ok(Some(flow))
    }

    fn disorder(&self, raw: &BodyTable) -> Result<Option<Disorder>> {
        let Some(table) = &raw.disorder else { return Ok(None) };
        let path = format!("{}.disorder.shift", self.path);
        Ok(Some(Disorder { shift: within(self.document, &path, table.shift, SHIFT)?, seed: table.seed }))
    }

    fn blast(&self, raw: &BodyTable) -> Result<Option<Blast>> {
        let path = format!("{}.blast", self.path);
        raw.blast.as_ref().map(|blast| blast.validate(self.document, &path)).transpose()
    }

    fn rubble(&self, raw: &BodyTable, shape: &BodyShape) -> Result<Option<Rubble>> {
        let path = format!("{}.rubble", self.path);
        raw.rubble.as_ref().map(|rubble| rubble.validate(self.document, &path, shape, self.dimension)).transpose()
    }

    fn joints(&self, raw: &BodyTable, shape: &BodyShape, material: &MaterialTable) -> Result<Option<Joints>> {
        let Some(joints) = &raw.joints else { return Ok(None) };
        if !material.has_fracture() {
            let what = format!("material `{}` has no fracture, so there are no joints", raw.material);
            let error = self.error("joints", what);
            return Err(error.allowed(format!("a table [material.{}.fracture]", raw.material)));
        }
        let path = format!("{}.joints", self.path);
        joints.validate(self.document, &path, shape, self.dimension).map(Some)
    }

    pub(super) fn damage(&self, raw: &BodyTable, material: &MaterialTable) -> Result<f64> {
        match raw.damage {
            None => Ok(0.0),
            Some(damage) if !(DAMAGE[0]..=DAMAGE[1]).contains(&damage.0) => {
                let [intact, broken] = DAMAGE;
                Err(self.error("damage", format!("damage is {damage}")).allowed(format!("{intact} to {broken}")))
            }
            Some(_) if material.eos.law().bulk_modulus().is_none() => {
                Err(self.error("damage", format!("material `{}` is a gas, which does not break", raw.material)))
            }
            Some(damage) => Ok(damage.0),
        }
    }

    pub(super) fn distention(&self, raw: &BodyTable, material: &MaterialTable) -> Result<f64> {
        match raw.distention {
            None => Ok(1.0),
            Some(_) if material.is_dust() => {
                let what = format!("`{}` is dust, whose pores are told by its filling factor", raw.material);
                Err(self.error("distention", what).allowed("filling_factor"))
            }
            Some(_) if material.porosity.is_none() => {
                let what = format!("material `{}` has no porosity, so there is no distention", raw.material);
                let error = self.error("distention", what);
                Err(error.allowed(format!("a table [material.{}.porosity]", raw.material)))
            }
            Some(distention) if distention.0 >= 1.0 && distention.0.is_finite() => Ok(distention.0),
            Some(distention) => {
                Err(self.error("distention", format!("distention is {distention}")).allowed("1 (no pores) and above"))
            }
        }
    }

    /// The filling factor of dust must be that of its density.
    fn check_filling_factor(&self, raw: &BodyTable, material: &MaterialTable) -> Result<()> {
        let Some(phi) = raw.filling_factor else { return Ok(()) };
        let Some(law) = material.dust() else {
            let error = self.error("filling_factor", format!("material `{}` is no dust", raw.material));
            return Err(error.allowed("a material with eos.sirono"));
        };
        if !(phi.0 > 0.0 && phi.0 <= 1.0) {
            // Either follows from the other: the one that the scene has is named.
            let is_given = self.document.says(&format!("{}.filling_factor", self.path));
            return Err(match raw.density.filter(|_| !is_given) {
                Some(density) => self
                    .error("density", format!("a density of {density} has a filling factor of {phi}"))
                    .allowed(format!("above 0, {} kg/m^3 at most", law.solid_density())),
                None => self.error("filling_factor", format!("filling_factor is {phi}")).allowed("above 0, 1 at most"),
            });
        }
        match raw.density {
            Some(density) if (density.0 / (phi.0 * law.solid_density()) - 1.0).abs() > 1e-9 => {
                let what =
                    format!("a density of {density} has a filling factor of {}", density.0 / law.solid_density());
                Err(self.error("filling_factor", what).allowed("one of density and filling_factor"))
            }
            _ => Ok(()),
        }
    }

    /// Density, kg/m^3, and specific internal energy, J/kg.
    fn thermal_state(&self, raw: &BodyTable, material: &MaterialTable) -> Result<(f64, f64)> {
        self.check_filling_factor(raw, material)?;
        let Some(density) = raw.density else {
            return Err(self.error("density", "key `density` is missing: a gas has no density of its own"));
        };
        let rho = self.positive("density", density)?;
        let energy = match (raw.pressure, raw.internal_energy, &material.eos) {
            (None, energy, _) => {
                let energy = energy.unwrap_or_default();
                if energy.0 < 0.0 {
                    let what = format!("internal_energy is {energy}");
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

    pub(super) fn rotation(&self, raw: &BodyTable) -> Result<Rotation> {
        let given = raw.orientation.as_ref();
        given.map_or(Ok(IDENTITY), |given| given.rotation(self.document, &self.path, self.dimension))
    }

    fn lattice(
        &self,
        raw: &BodyTable,
        shape: &BodyShape,
        rubble: Option<&Rubble>,
        rotation: Rotation,
    ) -> Result<Lattice> {
        if let Some(least) = raw.least_particles
            && (least == 0 || raw.spacing != Some(Spacing::OfTarget))
        {
            let what = format!("{least} cannot be the least number of particles");
            let allowed = "1 or more, of the projectile of an [impact] with spacing = \"target\"";
            return Err(self.error("least_particles", what).allowed(allowed));
        }
        let faces = match *shape {
            BodyShape::Box { size } => Faces { flat: true, periodic: fills(self.periods, size) },
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
                Some(spacing) => filling.at_least(raw.least_particles.unwrap_or(1), spacing),
                None => {
                    let what = "only the projectile of an [impact] follows the target's spacing";
                    return Err(self.error("spacing", what).allowed("a length"));
                }
            },
        };
        lattice.map_err(|e| e.at(self.document.place(&format!("{}.spacing", self.path))))
    }
}
