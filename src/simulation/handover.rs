//! Particles that come from files: every rank reads a share of the rows and keeps those that are asked for, with all columns of state that
//! file and scene both have.

use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::material::Core;
use crate::material::damage::DAMAGE;
use crate::material::eos::INTERNAL_ENERGY;
use crate::material::porosity::DISTENTION;
use crate::material::strength::DEVIATORIC_STRESS;
use crate::math::{Deviator, Mat3, Vec3};
use crate::output::agree;
use crate::particles::{Column, ColumnShape, Columns, Element, Life, ParticleId};
use crate::scene::given::Rows;
use crate::scene::given::file::{MASS, POSITION, VELOCITY};
use crate::scene::{Body, Handover, Scene};
use crate::step::settings::Preset;

const DENSITY: &str = "density";

/// Adds this rank's share of the particles that files bring; returns the columns that they bring, which effects do not initialise. `layer`:
/// the column that numbers layers, where there are any. Collective.
pub fn take(
    scene: &Scene,
    core: &Core,
    layer: Option<Column<f64>>,
    columns: &mut Columns,
    comm: &Comm,
) -> Result<Vec<Preset>> {
    let mut presets = Vec::new();
    for (number, body) in scene.bodies.iter().enumerate() {
        let Some(source) = body.given.as_ref().and_then(|given| given.source.as_ref()) else { continue };
        let taker = Taker { scene, number, source, core, layer };
        presets.extend(taker.take(columns, comm)?);
    }
    Ok(presets)
}

/// A body of the scene, and the file that its particles come from.
struct Taker<'a> {
    scene: &'a Scene,
    number: usize,
    source: &'a Handover,
    core: &'a Core,
    layer: Option<Column<f64>>,
}

/// Rows of the file that become particles, from `first` on.
struct Taken<'a> {
    rows: &'a Rows,
    first: usize,
    /// Row and number of the body of each.
    which: Vec<(usize, usize)>,
}

impl Taker<'_> {
    fn take(&self, columns: &mut Columns, comm: &Comm) -> Result<Vec<Preset>> {
        let state: Vec<String> = columns
            .registry
            .entries
            .iter()
            .filter(|entry| entry.info.life == Life::State)
            .map(|entry| entry.name.clone())
            .collect();
        let wanted = |name: &str| name == MASS || state.iter().any(|known| known == name);
        let range = comm.share(self.source.gathered.rows);
        let path = &self.source.file.path;
        let rows =
            agree(comm, self.source.file.read(range, &wanted).map_err(|what| Error::new(what).at(path).bad_input()))?;
        let parts = self.parts();
        let which = (0..rows.count).filter_map(|row| Some((row, parts[self.source.gathered.group_of(&rows, row)?])));
        let taken = Taken { which: which.collect(), rows: &rows, first: columns.len() };
        columns.resize(taken.first + taken.which.len());
        self.place(columns, &taken);
        self.matter(columns, &taken);
        let mut presets = Vec::new();
        let mut from_file = Vec::new();
        for index in 0..columns.registry.entries.len() {
            let name = columns.registry.entries[index].name.clone();
            if !state.contains(&name) || [POSITION, VELOCITY].contains(&name.as_str()) || rows.column(&name).is_none() {
                continue;
            }
            if self.copy(columns, &name, &taken) {
                let width = columns.width(index);
                let words = columns.words(index)[taken.first * width..].to_vec();
                presets.push(Preset { column: index, first: taken.first, words });
                from_file.push(name);
            }
        }
        let body = &self.scene.bodies[self.number];
        let names = if from_file.is_empty() { "nothing".into() } else { from_file.join(", ") };
        tracing::info!(
            "{}: {} particles of {path}, which has of their state, beside place and velocity: {names}",
            body.name,
            self.source.gathered.particles()
        );
        Ok(presets)
    }

    /// Number of the scene's body that each group of the file is.
    fn parts(&self) -> Vec<usize> {
        let is_part = |body: &Body, group: usize| {
            body.given.as_ref().is_some_and(|given| (given.body, given.group) == (self.number, group))
        };
        let groups = 0..self.source.gathered.groups.len();
        let part =
            |group| self.scene.bodies.iter().position(|body| is_part(body, group)).expect("a body for each group");
        groups.map(part).collect()
    }

    /// Numbers, places and velocities.
    fn place(&self, columns: &mut Columns, taken: &Taken) {
        let body = &self.scene.bodies[self.number];
        let (position, velocity) = (taken.rows.column(POSITION), taken.rows.column(VELOCITY));
        let (centre, spin) = (Vec3::from(body.centre), Vec3::from(body.spin));
        for (i, &(row, part)) in (taken.first..).zip(&taken.which) {
            let site = match taken.rows.ids.get(row) {
                Some(id) => ParticleId(*id).site(),
                None => taken.rows.first + row as u64,
            };
            let turned = |column: Option<&crate::scene::given::file::Column>, zero: [f64; 3]| {
                let own = column.map_or([0.0; 3], |column| column.vector(row));
                self.turn() * (Vec3::from(own) - Vec3::from(zero))
            };
            let away = turned(position, self.source.origin);
            let place = centre + away;
            let moving = turned(velocity, if velocity.is_some() { self.source.drift } else { [0.0; 3] });
            let moving = moving + Vec3::from(body.velocity) + spin.cross(&away);
            let held = self.scene.layers.iter().position(|layer| layer.holds(self.number, place.into()));
            let motion = held.map_or(body.motion, |layer| self.scene.layers[layer].motion);
            columns.set(self.core.id, i, ParticleId::new(part, site));
            columns.set(self.core.position, i, place);
            columns.set(self.core.velocity, i, Vec3::from(motion.start(moving.into())));
            if let Some(layer) = self.layer {
                columns.set(layer, i, held.map_or(0.0, |layer| (layer + 1) as f64));
            }
        }
    }

    /// What the scene says of the matter, where the file may not.
    fn matter(&self, columns: &mut Columns, taken: &Taken) {
        let energy = columns.registry.find::<f64>(INTERNAL_ENERGY);
        let damage = columns.registry.find::<f64>(DAMAGE);
        for (i, &(row, part)) in (taken.first..).zip(&taken.which) {
            let body = &self.scene.bodies[part];
            let density = if self.source.unload { self.unloaded(taken, row, part) } else { body.density };
            columns.set(self.core.density.value, i, density);
            if let Some(damage) = damage.filter(|_| self.scene.materials[body.material].has_fracture()) {
                columns.set(damage, i, body.damage);
            }
            if let Some(energy) = energy {
                columns.set(energy, i, body.internal_energy);
            }
        }
    }

    /// Copies a column of the file; returns whether it counts.
    fn copy(&self, columns: &mut Columns, name: &str, taken: &Taken) -> bool {
        let own = taken.rows.column(name).expect("a column of the file");
        let entry = columns.registry.entries.iter().find(|entry| entry.name == name).expect("a column of the scene");
        match entry.shape {
            ColumnShape::Scalar if own.width == 1 => {
                // Set without load before.
                if name == DENSITY && self.source.unload {
                    return false;
                }
                let column: Column<f64> = found(columns, name);
                for (i, &(row, _)) in (taken.first..).zip(&taken.which) {
                    columns.set(column, i, own.number(row));
                }
                true
            }
            ColumnShape::Deviator if own.width == 6 => {
                if name == DEVIATORIC_STRESS && self.source.unload {
                    return false;
                }
                let (column, turn): (Column<Deviator>, Mat3) = (found(columns, name), self.turn());
                for (i, &(row, _)) in (taken.first..).zip(&taken.which) {
                    let [xx, yy, zz, xy, yz, xz] = std::array::from_fn(|k| own.values[6 * row + k]);
                    let s = turn * Mat3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz) * turn.transpose();
                    columns.set(
                        column,
                        i,
                        Deviator { xx: s[(0, 0)], yy: s[(1, 1)], xy: s[(0, 1)], xz: s[(0, 2)], yz: s[(1, 2)] },
                    );
                }
                true
            }
            // The vectors of a scene beside places and velocities are of its own account.
            _ => false,
        }
    }

    /// Density without load, kg/m^3.
    fn unloaded(&self, taken: &Taken, row: usize, part: usize) -> f64 {
        let body = &self.scene.bodies[part];
        let distention = taken.rows.column(DISTENTION).map_or(body.distention, |column| column.number(row));
        let matrix = self.scene.materials[body.material].reference_density();
        matrix.map_or(body.density, |density| density / distention)
    }

    fn turn(&self) -> Mat3 {
        Mat3::from_fn(|a, b| self.source.rotation[a][b])
    }
}

fn found<T: Element>(columns: &Columns, name: &str) -> Column<T> {
    columns.registry.find(name).expect("a column of the scene")
}
