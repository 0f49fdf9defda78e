//! Reads bodies whose particles come from a file: what their table says beside `from`, and one body per group of particles.

use std::collections::BTreeMap;

use super::from::{Frame, FromTable};
use super::given::{Given, Handover};
use super::reader::BodyReader;
use super::table::{BodyTable, InitialState};
use super::validated::Body;
use crate::error::Result;
use crate::material::MaterialTable;
use crate::material::damage::DAMAGE;
use crate::scene::geometry::bounding_box::BoundingBox;
use crate::scene::geometry::lattice::{Faces, IDENTITY, Lattice, LatticeKind};
use crate::scene::geometry::shape::BodyShape;
use crate::scene::geometry::voxels::Voxels;
use crate::scene::given::Group;

/// Materials of a scene, in their order.
pub type Materials = BTreeMap<String, MaterialTable>;

impl BodyReader<'_> {
    /// The bodies of a table with `from`; `number`: of the first of them.
    pub fn read_given(&self, raw: &BodyTable, number: usize, materials: &Materials) -> Result<Vec<Body>> {
        let from = raw.from.as_ref().expect("a table with `from`");
        self.refuse_beside_file(raw)?;
        let source = self.handover(raw, from)?;
        let gathered = &source.gathered;
        let parts = gathered.groups.iter().map(|group| self.part(raw, from, group, materials));
        let mut bodies = parts.collect::<Result<Vec<Body>>>()?;
        let volumes = gathered
            .groups
            .iter()
            .zip(&bodies)
            .map(|(group, body)| group.count as f64 * group.particle_mass / body.density);
        let (whole_mass, whole_volume) = (gathered.mass, volumes.sum::<f64>());
        let whole = Voxels::new(gathered.grid.clone(), source.origin, source.rotation, whole_volume, self.dimension);
        for (group, body) in bodies.iter_mut().enumerate() {
            // The others have its size, without its cells.
            body.shape = BodyShape::Voxels(if group == 0 { whole.clone() } else { whole.without_cells() });
            let Group { count, particle_mass, .. } = gathered.groups[group];
            let source = (group == 0).then(|| source.clone());
            body.given =
                Some(Given { body: number, group, particles: count, particle_mass, whole_mass, whole_volume, source });
        }
        Ok(bodies)
    }

    fn refuse_beside_file(&self, raw: &BodyTable) -> Result<()> {
        let beside = [
            ("shape", raw.shape.is_some()),
            ("particles", raw.particles.is_some()),
            ("spacing", raw.spacing.is_some()),
            ("least_particles", raw.least_particles.is_some()),
            ("disorder", raw.disorder.is_some()),
            ("rigid", raw.rigid().is_some()),
            ("flow", raw.flow.is_some()),
            ("blast", raw.blast.is_some()),
            ("rubble", raw.rubble.is_some()),
            ("joints", raw.joints.is_some()),
            ("pressure", raw.pressure.is_some()),
            ("start", raw.start != InitialState::Unloaded),
        ];
        match beside.into_iter().find(|(_, is_there)| *is_there) {
            Some((key, _)) => {
                let what = format!("the body has `from`: its particles come from a file, and `{key}` is not theirs");
                Err(self.error(key, what).allowed("one of `from` and what makes particles anew"))
            }
            None => Ok(()),
        }
    }

    fn handover(&self, raw: &BodyTable, from: &FromTable) -> Result<Handover> {
        let path = format!("{}.from", self.path);
        let file = from.particle_file(self.document, &path)?;
        let Some(gathered) = self.document.given(&from.key()) else {
            return Err(self.error("from.file", format!("{} has not been read", from.file)));
        };
        if let Some(other) = gathered.dimension.filter(|dimension| *dimension != self.dimension) {
            let what = format!("{} has {other} dimensions, the scene {}", from.file, self.dimension);
            return Err(self.error("from.file", what).allowed("a file of the scene's dimension"));
        }
        if gathered.late && !from.unload {
            let what =
                "the matter in it is that of a late stage, softer than its material: as it stands it would spring";
            return Err(self.error("from.unload", what).allowed("unload = true"));
        }
        let (origin, drift) = match from.frame {
            Frame::CentreOfMass => (gathered.centre, gathered.velocity),
            Frame::File => ([0.0; 3], [0.0; 3]),
        };
        Ok(Handover { file, gathered, origin, drift, rotation: self.rotation(raw)?, unload: from.unload })
    }

    /// The part that a group of particles is; shape and particles follow.
    fn part(&self, raw: &BodyTable, from: &FromTable, group: &Group, materials: &Materials) -> Result<Body> {
        let name = self.material_of(raw, from, group)?;
        let Some((index, (_, material))) = materials.iter().enumerate().find(|(_, (known, _))| **known == name) else {
            let key =
                if name == raw.material { "material".to_string() } else { format!("from.materials.{}", group.origin) };
            let known: Vec<&str> = materials.keys().map(String::as_str).collect();
            return Err(self.error(&key, format!("{name} names no material")).allowed(known.join(", ")));
        };
        let distention = match (group.distention, raw.distention) {
            _ if material.porosity.is_none() => 1.0,
            (Some(alpha), _) => alpha,
            (None, Some(_)) => self.distention(raw, material)?,
            (None, None) => material.distention(),
        };
        let reference = material.reference_density().map(|density| density / distention);
        let given = raw.density.map(|density| density.0);
        let Some(density) =
            group.density.or(given).or(reference).filter(|density| *density > 0.0 && density.is_finite())
        else {
            return Err(self.error("density", "key `density` is missing: a gas has no density of its own"));
        };
        if from.unload && (material.is_dust() || reference.is_none()) {
            let what = format!("what density `{name}` has without load is not known");
            return Err(self.error("from.unload", what).allowed("a solid that is no dust"));
        }
        let has_damage = self.document.given(&from.key()).is_some_and(|gathered| gathered.has(DAMAGE));
        let volume = group.particle_mass / density;
        let spacing = LatticeKind::default().spacing_of_cell(volume, self.dimension);
        let mut half = [0.5 * spacing; 3];
        half[self.dimension..].fill(0.0);
        let bounds = BoundingBox { middle: [0.0; 3], half, dimension: self.dimension };
        let lattice = Lattice::covering(LatticeKind::default(), spacing, IDENTITY, bounds, Faces::default())?;
        let velocity = self.vector("velocity", &raw.velocity)?;
        Ok(Body {
            name: raw.name.clone(),
            shape: BodyShape::Sphere { radius: spacing },
            dimension: self.dimension,
            material: index,
            lattice,
            centre: self.vector("position", &raw.position)?,
            velocity,
            spin: self.spin(raw)?,
            damage: if has_damage { 0.0 } else { self.damage(raw, material)? },
            internal_energy: raw.internal_energy.map_or(0.0, |energy| energy.0),
            density,
            distention,
            motion: self.motion(raw, velocity)?,
            rigid: None,
            disorder: None,
            flow: None,
            blast: None,
            rubble: None,
            joints: None,
            start: InitialState::Unloaded,
            cut: None,
            given: None,
        })
    }

    /// The material of a group: what the table says of its origin, or the body's.
    fn material_of(&self, raw: &BodyTable, from: &FromTable, group: &Group) -> Result<String> {
        if let Some(name) = from.materials.get(&group.origin) {
            return Ok(name.clone());
        }
        let gathered = self.document.given(&from.key());
        let most = gathered.as_ref().and_then(|gathered| gathered.groups.first());
        if most.is_some_and(|most| most.material != group.material) {
            let what = format!(
                "nothing says what material here is that of `{}`, which {} calls `{}`, other than most of its matter",
                group.origin, from.file, group.material
            );
            let allowed = format!("materials = {{ {:?} = {:?} }}, or `keep` of one body", group.origin, raw.material);
            return Err(self.error("from.materials", what).allowed(allowed));
        }
        Ok(raw.material.clone())
    }
}
