//! Rigid bodies of a scene: what their particles are made of, how they start, and what history.csv says of them.

use crate::material::MaterialTable;
use crate::math::Vec3;
use crate::motion::rigid::{RigidBody, RigidStart};
use crate::output::summary::Figures;
use crate::pair::contrast;
use crate::scene::{Body, Scene};

/// The matter of every body as effects see it.
pub struct Matter {
    pub materials: Vec<MaterialTable>,
    /// Number of each body's material.
    pub of_body: Vec<usize>,
    /// Damage of each body at the start.
    pub damage: Vec<f64>,
    /// Whether each body is rigid; empty where none is.
    pub rigid: Vec<bool>,
    /// Factor of the density of each body's records; empty where none is rigid.
    pub standing: Vec<f64>,
}

/// The materials of a scene; each rigid body has one of its own instead, of its contact with other rigid bodies alone, which as
/// broken matter does not pull.
pub fn matter(scene: &Scene) -> Matter {
    let mut matter = Matter {
        materials: scene.materials.clone(),
        of_body: scene.bodies.iter().map(|body| body.material).collect(),
        damage: scene.bodies.iter().map(|body| body.damage).collect(),
        rigid: Vec::new(),
        standing: Vec::new(),
    };
    for (number, body) in scene.bodies.iter().enumerate() {
        let Some(rigid) = body.rigid else { continue };
        matter.rigid.resize(scene.bodies.len(), false);
        matter.rigid[number] = true;
        matter.standing.resize(scene.bodies.len(), 1.0);
        matter.standing[number] = if rigid.adhesion { contrast::RIGID } else { contrast::LOOSE };
        matter.of_body[number] = matter.materials.len();
        matter.damage[number] = 1.0;
        matter.materials.push(scene.materials[body.material].of_contact(body.density, rigid.sound_speed));
    }
    matter
}

/// The rigid bodies at the start.
pub fn starts(scene: &Scene) -> Vec<RigidStart> {
    let start = |(number, body): (usize, &Body)| {
        let rigid = body.rigid?;
        Some(RigidStart {
            body: number,
            guidance: rigid.guidance(body.motion),
            velocity: body.motion.start(body.velocity).into(),
            spin: body.spin.into(),
            about: body.centre.into(),
            sound_speed: rigid.sound_speed,
        })
    };
    scene.bodies.iter().enumerate().filter_map(start).collect()
}

/// What history.csv says of a rigid body, and in which unit: vectors by the ends of their names.
const COLUMNS: [(&str, &str); 5] =
    [("position", "m"), ("velocity", "m/s"), ("angular_velocity", "1/s"), ("orientation", ""), ("force", "N")];
const AXES: [&str; 4] = ["w", "x", "y", "z"];

/// The axes of one of them: in 2D bodies turn about z, and their orientation is an angle.
fn axes(name: &str, dimension: usize) -> &'static [&'static str] {
    match (name, dimension) {
        ("orientation", 3) => &AXES,
        (_, 3) => &AXES[1..],
        ("angular_velocity", _) => &AXES[3..],
        _ => &AXES[1..3],
    }
}

/// Names and units of the columns of history.csv.
pub fn columns(scene: &Scene) -> Vec<(String, String)> {
    let of = |body: &Body| {
        let columns = COLUMNS.iter().flat_map(|&(name, unit)| match (name, scene.dimension) {
            ("orientation", 2) => vec![(format!("{}_angle", body.name), "rad".to_string())],
            (_, dimension) => {
                let column = |axis: &&str| (format!("{}_{name}_{axis}", body.name), unit.to_string());
                axes(name, dimension).iter().map(column).collect()
            }
        });
        columns.collect::<Vec<_>>()
    };
    scene.bodies.iter().filter(|body| body.rigid.is_some()).flat_map(of).collect()
}

/// The numbers below them.
pub fn row(bodies: &[RigidBody], dimension: usize) -> Vec<f64> {
    let of = |body: &RigidBody| {
        let (motion, spin) = (&body.motion, body.spin());
        let vector = |v: &Vec3| v.iter().take(dimension).copied().collect::<Vec<_>>();
        let [spin, orientation] = match dimension {
            2 => [vec![spin.z], vec![motion.orientation.angle_about_z()]],
            _ => [vector(&spin), motion.orientation.0.to_vec()],
        };
        [vector(&motion.centre), vector(&motion.velocity), spin, orientation, vector(&body.load.force)].concat()
    };
    bodies.iter().flat_map(of).collect()
}

/// What summary.json says of them.
pub fn figures(scene: &Scene, bodies: &[RigidBody]) -> Option<Figures> {
    let masses = bodies.iter().map(|body| (format!("{}_mass", scene.bodies[body.body].name), body.mass));
    let names = columns(scene).into_iter().map(|(name, _)| name);
    let figures = masses.chain(names.zip(row(bodies, scene.dimension)));
    (!bodies.is_empty()).then(|| Figures(figures.collect()))
}
