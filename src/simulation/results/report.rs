//! Reports of a run: rows of history.csv, distributions, the picture, and the summary with its cost.

use std::path::Path;

use crate::domain::comm::Comm;
use crate::error::Result;
use crate::material::MaterialEffect;
use crate::math::Vec3;
use crate::output::Cell;
use crate::output::figures::cut::{self, Picture};
use crate::output::figures::raster::Plane;
use crate::output::summary::{Accuracy, Figures, Fragments};
use crate::scene::Scene;
use crate::simulation::state::{RunState, Spent};
use crate::step::packing::DensityCheck;
use crate::step::time_step::NamedLimit;
use crate::step::{StepState, Stepper, Totals};

/// Names and units of history.csv.
pub fn history_columns(effects: &[Box<dyn MaterialEffect>], prescribed: bool, scene: &Scene) -> Vec<(String, String)> {
    let fixed = [
        ("step", ""),
        ("time", "s"),
        ("dt", "s"),
        ("limited_by", ""),
        ("limiting_body", ""),
        ("limiting_site", ""),
        ("kinetic_energy", "J"),
        ("internal_energy", "J"),
        ("total_energy", "J"),
        ("momentum_x", "kg m/s"),
        ("momentum_y", "kg m/s"),
        ("momentum_z", "kg m/s"),
        ("angular_momentum_x", "kg m^2/s"),
        ("angular_momentum_y", "kg m^2/s"),
        ("angular_momentum_z", "kg m^2/s"),
    ];
    let planar = scene.dimension == 2;
    let kept = fixed
        .iter()
        .filter(|(name, _)| !planar || !["momentum_z", "angular_momentum_x", "angular_momentum_y"].contains(name));
    let own = |(name, unit): &(&str, &str)| (name.to_string(), unit.to_string());
    let potential = scene.gravity.any().then_some(("potential_energy", "J"));
    let held = [
        ("boundary_work", "J"),
        ("boundary_impulse_x", "kg m/s"),
        ("boundary_impulse_y", "kg m/s"),
        ("boundary_impulse_z", "kg m/s"),
    ];
    let held = held.iter().filter(|(name, _)| prescribed && !(planar && *name == "boundary_impulse_z"));
    let diagnostics = effects.iter().flat_map(|effect| effect.diagnostics());
    kept.map(own)
        .chain(potential.iter().map(own))
        .chain(held.map(own))
        .chain(diagnostics.map(|d| (d.name.to_string(), d.unit.to_string())))
        .collect()
}

/// One row of history.csv.
pub fn history_row(
    state: &StepState,
    totals: &Totals,
    limited: &NamedLimit,
    prescribed: bool,
    planar: bool,
) -> Vec<Cell> {
    let NamedLimit { limit, reason } = limited;
    let mut cells = vec![
        Cell::Integer(state.step),
        Cell::Real(state.time),
        Cell::Real(state.next),
        Cell::Text(reason.to_string()),
        Cell::Integer(limit.id.body() as u64),
        Cell::Integer(limit.id.site()),
        Cell::Real(totals.kinetic),
        Cell::Real(totals.internal),
        Cell::Real(totals.energy()),
    ];
    let (p, l) = (totals.momentum, totals.angular_momentum);
    let vectors = if planar { vec![p.x, p.y, l.z] } else { vec![p.x, p.y, p.z, l.x, l.y, l.z] };
    let j = totals.impulse;
    let held = match (prescribed, planar) {
        (false, _) => vec![],
        (true, true) => vec![totals.work, j.x, j.y],
        (true, false) => vec![totals.work, j.x, j.y, j.z],
    };
    cells.extend(vectors.iter().chain(&totals.potential).chain(&held).chain(&totals.effects).map(|x| Cell::Real(*x)));
    cells
}

/// The input of a picture.
pub struct PictureSource<'a, 'c, const D: usize> {
    pub scene: &'a Scene,
    pub stepper: &'a Stepper<'c, D>,
    pub time: f64,
    /// The file.
    pub path: &'a Path,
}

/// A cut through the plane of an impact or a fall. Collective.
pub fn draw_cut<const D: usize>(source: &PictureSource<D>, comm: &Comm) -> Result<()> {
    let scene = source.scene;
    let target = scene.impact.as_ref().map_or(0, |impact| impact.target);
    let (face, origin) = (scene.face(), Vec3::from(scene.bodies[target].centre));
    // The projectile comes down in the plane of x and the face's normal; onto a sphere it moves in that of x and y.
    let up = face.map_or(1, |face| face.up);
    let of_impact = || Plane { origin, across: Vec3::x(), up: Vec3::ith(up, 1.0) };
    let plane = plane_of_fall(scene).or_else(|| upright_plane(scene)).unwrap_or_else(of_impact);
    let picture = Picture {
        title: format!("{} (t = {:.4} s)", scene.title, source.time),
        plane,
        ejected: scene.outcome.map(|outcome| (up, outcome.ejection_speed)),
        distention: scene.bodies.iter().fold(1.0, |most: f64, body| most.max(body.distention)),
    };
    let (columns, bodies) = (&source.stepper.columns, &source.stepper.settings.view.constants);
    cut::draw(source.path, &picture, columns, bodies, comm)
}

/// The plane in which a body falls into dust.
fn plane_of_fall(scene: &Scene) -> Option<Plane> {
    let fall = scene.intrusion?;
    let origin = Vec3::from(scene.bodies[fall.body].centre);
    let across = if fall.axis == 0 { Vec3::y() } else { Vec3::x() };
    Some(Plane { origin, across, up: Vec3::ith(fall.axis, 1.0) })
}

/// The plane of x and z where matter falls or flies along z, and no impact says otherwise.
fn upright_plane(scene: &Scene) -> Option<Plane> {
    if scene.impact.is_some() || scene.dimension == 2 {
        return None;
    }
    let moving = scene.bodies.iter().map(|body| body.velocity).find(|v| v.iter().any(|x| *x != 0.0));
    let along = scene.gravity.uniform.or(moving)?;
    let origin = Vec3::from(scene.bodies[0].centre);
    (Vec3::from(along).iamax() == 2).then_some(Plane { origin, across: Vec3::x(), up: Vec3::z() })
}

/// Whether angular momentum is conserved: not with walls, periodic axes or uniform gravity.
pub fn turns_freely<const D: usize>(scene: &Scene, stepper: &Stepper<D>) -> bool {
    !stepper.settings.prescribes_motion() && !scene.periods.any() && scene.gravity.uniform.is_none()
}

/// What a scene asks of the end of a run, each by a table of its own.
#[derive(Debug, Clone, Default)]
pub struct Answers {
    pub nbody: Option<Figures>,
    pub fragments: Option<Fragments>,
    pub deposit: Option<Figures>,
}

/// The input of a summary.
pub struct Report<'a, 'c, const D: usize> {
    pub scene: &'a Scene,
    pub stepper: &'a Stepper<'c, D>,
    pub state: &'a RunState,
    pub totals: &'a Totals,
    /// Density against mass over volume at the last check.
    pub density: &'a DensityCheck,
    pub spent: Spent,
    /// Errors against the exact solution that the scene names.
    pub errors: Figures,
    pub answers: Answers,
    pub resident_at_start: f64,
    pub accuracy: Option<&'a Accuracy>,
    pub comm: &'a Comm,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::particles::ParticleId;
    use crate::step::time_step::Limit;

    /// A row by the names of its columns.
    fn row(dimension: usize, prescribed: bool) -> Vec<(String, Cell)> {
        let text = format!(
            "dimension = {dimension}\n[[body]]\nname = \"b\"\nshape = {{ sphere = {{ radius = 1 }} }}\nmaterial = \"basalt\"\n\
             particles = 9\n[gravity]\nuniform = {:?}\n[run]\nuntil = 1\n",
            vec![1.0; dimension]
        );
        let scene = Scene::parse("s.toml", &text, &[]).unwrap();
        let state = StepState { step: 7, time: 1.5, next: 0.25, ..StepState::default() };
        let totals = Totals {
            kinetic: 11.0,
            internal: 12.0,
            potential: Some(-3.0),
            momentum: Vec3::new(21.0, 22.0, 23.0),
            angular_momentum: Vec3::new(31.0, 32.0, 33.0),
            work: 41.0,
            impulse: Vec3::new(51.0, 52.0, 53.0),
            ..Totals::default()
        };
        let limit = Limit { id: ParticleId::new(2, 99), ..Limit::NONE };
        let limited = NamedLimit { limit, reason: "sound" };
        let cells = history_row(&state, &totals, &limited, prescribed, dimension == 2);
        let names = history_columns(&[], prescribed, &scene);
        assert_eq!(names.len(), cells.len(), "{names:?}");
        names.into_iter().map(|(name, _)| name).zip(cells).collect()
    }

    #[test]
    fn every_column_of_the_history_has_its_number() {
        let expected = [
            ("step", Cell::Integer(7)),
            ("time", Cell::Real(1.5)),
            ("dt", Cell::Real(0.25)),
            ("limited_by", Cell::Text("sound".into())),
            ("limiting_body", Cell::Integer(2)),
            ("limiting_site", Cell::Integer(99)),
            ("kinetic_energy", Cell::Real(11.0)),
            ("internal_energy", Cell::Real(12.0)),
            ("total_energy", Cell::Real(20.0)),
            ("momentum_x", Cell::Real(21.0)),
            ("momentum_y", Cell::Real(22.0)),
            ("momentum_z", Cell::Real(23.0)),
            ("angular_momentum_x", Cell::Real(31.0)),
            ("angular_momentum_y", Cell::Real(32.0)),
            ("angular_momentum_z", Cell::Real(33.0)),
            ("potential_energy", Cell::Real(-3.0)),
            ("boundary_work", Cell::Real(41.0)),
            ("boundary_impulse_x", Cell::Real(51.0)),
            ("boundary_impulse_y", Cell::Real(52.0)),
            ("boundary_impulse_z", Cell::Real(53.0)),
        ];
        for (dimension, prescribed, columns) in [(3, true, 20), (3, false, 16), (2, true, 16), (2, false, 13)] {
            let row = row(dimension, prescribed);
            assert_eq!(row.len(), columns, "{row:?}");
            for (name, cell) in row {
                let known = expected.iter().find(|(known, _)| *known == name);
                assert_eq!(known.map(|(_, cell)| cell), Some(&cell), "{name} in {dimension}D");
            }
        }
    }
}
