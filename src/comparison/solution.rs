//! From a scene to the solution it names.

use super::elastic::elastic;
use super::modes::ModeShape;
use super::rest::Rest;
use crate::error::{Error, Result};
use crate::exact::compaction::PorousMedium;
use crate::exact::piston::{Piston, Solid};
use crate::exact::riemann::{Gas, Riemann};
use crate::exact::shear_layer::growth;
use crate::exact::shock::{Impact, Medium};
use crate::exact::{State, noh::Noh, sedov::Sedov};
use crate::material::MaterialTable;
use crate::material::eos::EosTable;
use crate::motion::PrescribedMotion;
use crate::scene::{Body, BodyShape, ComparisonSettings, Flow, Layer, Scene, Solution, Streams};

/// A solution ready to be compared with.
pub enum Reference {
    Profile(Profile),
    Vibration(Vibration),
    Growth(Growth),
    Rotation(Rotation),
    Rest(Rest),
}

/// A solution along a coordinate; fields that are not finite do not count.
pub struct Profile {
    pub place: Place,
    /// Coordinates that count, m, as the scene counts them.
    pub within: [f64; 2],
    /// Only particles within this distance from the coordinate's axis count, m; `None` counts all.
    pub core: Option<f64>,
    /// State at a coordinate (m) and a time (s).
    pub at: Box<dyn Fn(f64, f64) -> State + Sync>,
    /// Where waves start at t = 0, m: front speeds are measured from here.
    pub origin: f64,
}

/// The meaning of a coordinate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// Along this axis; the velocity that counts is that along `moves`.
    Axis { along: usize, moves: usize },
    /// Distance from this point, m.
    Radius([f64; 3]),
    /// Distance from an axis along z through this point, m; the velocity that counts is that around it.
    Around([f64; 3]),
}

/// A vibration of one body.
pub struct Vibration {
    pub body: usize,
    /// Velocity at a place, m, of a vibration of amplitude 1.
    pub shape: Box<dyn Fn([f64; 3]) -> [f64; 3] + Sync>,
    /// rad/s; zero where nothing pulls back, in a fluid that moves across.
    pub frequency: f64,
    /// Decay, 1/s, by a viscosity of c h.
    pub decay: f64,
    /// Amplitude at the start, m/s.
    pub speed: f64,
}

/// A wave on a layer between two streams.
pub struct Growth {
    pub body: usize,
    /// Of the body, m.
    pub centre: [f64; 3],
    pub streams: Streams,
    /// 1/s.
    pub rate: f64,
}

/// A rotating body.
pub struct Rotation {
    /// rad/s.
    pub spin: f64,
}

fn needs(what: &str) -> Error {
    Error::new(format!("the scene does not make this problem: it needs {what}"))
}

/// The solution that `compare` names, with the scene's parameters.
pub fn of(scene: &Scene, compare: &ComparisonSettings) -> Result<Reference> {
    let within = compare.within;
    if compare.core.is_some() && compare.with != Solution::Piston {
        return Err(needs("a piston, whose core alone can be compared"));
    }
    match compare.with {
        Solution::Riemann => riemann(scene, within).map(Reference::Profile),
        Solution::Blast => blast(scene, within).map(Reference::Profile),
        Solution::Implosion => implosion(scene, within).map(Reference::Profile),
        Solution::Piston => {
            let profile = piston(scene, within)?;
            Ok(Reference::Profile(Profile { core: compare.core, ..profile }))
        }
        Solution::Impact => impact(scene, within, false).map(Reference::Profile),
        Solution::Release => impact(scene, within, true).map(Reference::Profile),
        Solution::Vortex => vortex(scene, within).map(Reference::Profile),
        Solution::ShearLayer => shear_layer(scene).map(Reference::Growth),
        Solution::StandingWave => standing_wave(scene).map(Reference::Vibration),
        Solution::Vibration => vibration(scene).map(Reference::Vibration),
        Solution::Rest => Rest::new(scene, compare.after).map(Reference::Rest).ok_or_else(|| needs("gravity")),
        Solution::Rotation => {
            let spin = |body: &Body| body.spin.iter().map(|w| w * w).sum::<f64>().sqrt();
            let spin = scene.bodies.iter().map(spin).fold(0.0, f64::max);
            if spin > 0.0 { Ok(Reference::Rotation(Rotation { spin })) } else { Err(needs("a body with a spin")) }
        }
    }
}

fn material<'a>(scene: &'a Scene, body: &Body) -> &'a MaterialTable {
    &scene.materials[body.material]
}

fn gas(scene: &Scene, body: &Body) -> Result<(Gas, f64)> {
    let EosTable::IdealGas(table) = &material(scene, body).eos else { return Err(needs("bodies of an ideal gas")) };
    let gamma = table.gamma.0;
    let pressure = (gamma - 1.0) * body.density * body.internal_energy;
    Ok((Gas { density: body.density, velocity: body.velocity[0], pressure }, gamma))
}

/// Lower and upper end of a box along x, m.
fn ends(body: &Body) -> Result<[f64; 2]> {
    ends_along(body, 0)
}

/// Lower and upper end of a body with flat ends along an axis, m.
fn ends_along(body: &Body, axis: usize) -> Result<[f64; 2]> {
    let length = match body.shape {
        BodyShape::Box { size } => size[axis],
        BodyShape::Cylinder { height, .. } if axis == 2 => height,
        _ => return Err(needs("bodies with flat ends: shape box, or a cylinder along z")),
    };
    Ok([body.centre[axis] - 0.5 * length, body.centre[axis] + 0.5 * length])
}

/// Two boxes that share a face across x, the lower one first, and the coordinate of the face.
fn touching(scene: &Scene) -> Result<(usize, usize, f64)> {
    let [first, second] = &scene.bodies[..] else { return Err(needs("two bodies")) };
    let (a, b) = (ends(first)?, ends(second)?);
    let near = |x: f64, y: f64| (x - y).abs() <= 1e-9 * (a[1] - a[0]);
    match (near(a[1], b[0]), near(b[1], a[0])) {
        (true, _) => Ok((0, 1, a[1])),
        (_, true) => Ok((1, 0, b[1])),
        _ => Err(needs("two bodies that touch across x")),
    }
}

const ALONG_X: Place = Place::Axis { along: 0, moves: 0 };

fn riemann(scene: &Scene, within: [f64; 2]) -> Result<Profile> {
    let (left, right, face) = touching(scene)?;
    let ((left, gamma), (right, other)) = (gas(scene, &scene.bodies[left])?, gas(scene, &scene.bodies[right])?);
    if gamma != other {
        return Err(needs("one ratio of heats"));
    }
    let solution = Riemann::new(left, right, gamma)?;
    Ok(Profile { place: ALONG_X, within, core: None, at: Box::new(move |x, t| solution.at(x - face, t)), origin: face })
}

fn blast(scene: &Scene, within: [f64; 2]) -> Result<Profile> {
    let body = scene.bodies.iter().find(|body| body.blast.is_some()).ok_or_else(|| needs("a body with a blast"))?;
    let (_, gamma) = gas(scene, body)?;
    let solution = Sedov::new(scene.dimension, gamma, body.blast.map_or(0.0, |blast| blast.energy), body.density)?;
    let at = Box::new(move |r: f64, t: f64| solution.at(r, t));
    Ok(Profile { place: Place::Radius(body.centre), within, core: None, at, origin: 0.0 })
}

fn implosion(scene: &Scene, within: [f64; 2]) -> Result<Profile> {
    let inward = |body: &&Body| matches!(body.flow, Some(Flow::Radial(speed)) if speed < 0.0);
    let body = scene.bodies.iter().find(inward).ok_or_else(|| needs("a body with flow = { radial = \"-1 m/s\" }"))?;
    let Some(Flow::Radial(speed)) = body.flow else { return Err(needs("a radial flow")) };
    let (_, gamma) = gas(scene, body)?;
    let solution = Noh::new(scene.dimension, gamma, body.density, -speed)?;
    let at = Box::new(move |r: f64, t: f64| solution.at(r, t));
    Ok(Profile { place: Place::Radius(body.centre), within, core: None, at, origin: 0.0 })
}

fn shear_layer(scene: &Scene) -> Result<Growth> {
    let streams = |body: &Body| match body.flow {
        Some(Flow::Streams(streams)) => Some(streams),
        _ => None,
    };
    let found = scene.bodies.iter().enumerate().find_map(|(number, body)| streams(body).map(|flow| (number, flow)));
    let (body, streams) = found.ok_or_else(|| needs("a body with flow.streams"))?;
    let rate = growth(streams.speed.abs(), streams.half_width, streams.wavenumber)?;
    Ok(Growth { body, centre: scene.bodies[body].centre, streams, rate })
}

fn vortex(scene: &Scene, within: [f64; 2]) -> Result<Profile> {
    let body = scene.bodies.iter().find(|body| matches!(body.flow, Some(Flow::Vortex { .. })));
    let body = body.ok_or_else(|| needs("a body with flow.vortex"))?;
    let (Gas { density, pressure, .. }, gamma) = gas(scene, body)?;
    let Some(flow) = body.flow else { return Err(needs("a vortex")) };
    let at = Box::new(move |r: f64, _: f64| {
        let place = [r, 0.0, 0.0];
        let stress = pressure + density * flow.pressure(place);
        let velocity = flow.velocity(place).map_or(0.0, |v| v[1]);
        State { density, velocity, stress, internal_energy: stress / ((gamma - 1.0) * density), ..State::default() }
    });
    Ok(Profile { place: Place::Around(body.centre), within, core: None, at, origin: 0.0 })
}

/// The face of the piston is where its layer ends; the solid lies beyond, in the direction of its motion.
fn piston(scene: &Scene, within: [f64; 2]) -> Result<Profile> {
    // Axis and speed along it.
    let moving = |motion: &PrescribedMotion| {
        let PrescribedMotion::Prescribed(v) = motion else { return None };
        let mut given = (0..3).filter(|&axis| v[axis] != 0.0);
        let axis = given.next().filter(|_| given.next().is_none())?;
        Some((axis, v[axis]))
    };
    let of_layer = |layer: &Layer| {
        moving(&layer.motion).map(|(axis, v)| (axis, v, [layer.region.low[axis], layer.region.high[axis]]))
    };
    let of_body =
        |body: &Body| moving(&body.motion).map(|(axis, v)| ends_along(body, axis).map(|ends| (axis, v, ends)));
    let layer = scene.layers.iter().find_map(of_layer);
    let (along, speed, faces) = match (layer, scene.bodies.iter().find_map(of_body)) {
        (Some(layer), _) => layer,
        (None, Some(body)) => body?,
        _ => return Err(needs("a layer or a body with a prescribed velocity along one axis")),
    };
    let driven = scene.bodies.iter().find(|body| moving(&body.motion).is_none());
    let driven = driven.ok_or_else(|| needs("a body that is driven"))?;
    let driven_material = material(scene, driven);
    let face = if speed > 0.0 { faces[1] } else { faces[0] };
    let solution = match PorousMedium::of(driven_material, driven.distention) {
        Some(_) if driven_material.has_strength() => return Err(needs("a porous solid without strength")),
        Some(medium) => medium.piston(speed.abs())?,
        None => Piston::new(&Solid::of(driven_material).ok_or_else(|| needs("a solid"))?, speed.abs())?,
    };
    if driven_material.has_friction() {
        return Err(needs("a solid whose strength does not depend on pressure"));
    }
    let side = speed.signum();
    let at = Box::new(move |x: f64, t: f64| {
        let x = side * (x - face);
        let state = solution.at(x, t);
        // The piston is behind the face.
        if x < speed.abs() * t { NOTHING } else { State { velocity: side * state.velocity, ..state } }
    });
    Ok(Profile { place: Place::Axis { along, moves: along }, within, core: None, at, origin: face })
}

const NOTHING: State =
    State { density: f64::NAN, velocity: f64::NAN, stress: f64::NAN, internal_energy: f64::NAN, distention: f64::NAN };

/// The lower body is the projectile. Strength is no part of the solution: the scene must do without.
fn impact(scene: &Scene, within: [f64; 2], released: bool) -> Result<Profile> {
    let (lower, upper, face) = touching(scene)?;
    let (projectile, target) = (&scene.bodies[lower], &scene.bodies[upper]);
    if scene.materials.iter().any(|material| material.has_strength()) {
        return Err(needs("materials without strength"));
    }
    let medium = |body: &Body| Medium {
        law: material(scene, body).eos.law(),
        density: body.density,
        internal_energy: body.internal_energy,
    };
    let rest = target.velocity[0];
    let speed = projectile.velocity[0] - rest;
    if speed <= 0.0 {
        return Err(needs("the lower body to run into the upper one"));
    }
    let solution = Impact::new(&medium(projectile), &medium(target), speed)?;
    let at: Box<dyn Fn(f64, f64) -> State + Sync> = if released {
        let shocked = solution.target_shock;
        let release = medium(target).release(&shocked.behind)?;
        let size = ends(target)?;
        let thickness = size[1] - size[0];
        let arrival = thickness / shocked.speed;
        let sound = medium(target).law.pressure(release.density, release.internal_energy).1;
        Box::new(move |x, t| {
            // The rarefaction's tail runs back through released matter with its speed of sound.
            let after = t - arrival;
            let x = x - face - rest * t;
            let tail = thickness + (release.velocity - sound) * after;
            if after <= 0.0 || x < tail {
                return NOTHING;
            }
            let (density, velocity) = (release.density, release.velocity + rest);
            State { density, velocity, internal_energy: release.internal_energy, ..State::default() }
        })
    } else {
        Box::new(move |x, t| {
            let state = solution.at(x - face - rest * t, t);
            State { velocity: state.velocity + rest, ..state }
        })
    };
    Ok(Profile { place: ALONG_X, within, core: None, at, origin: face })
}

fn standing_wave(scene: &Scene) -> Result<Vibration> {
    let found = scene.bodies.iter().position(|body| matches!(body.flow, Some(Flow::Wave { .. })));
    let number = found.ok_or_else(|| needs("a body with flow.wave"))?;
    let body = &scene.bodies[number];
    let Some(Flow::Wave { along, moves, wavelength, speed }) = body.flow else { return Err(needs("a wave")) };
    let [bulk, shear] = material(scene, body).moduli(body.density).ok_or_else(|| needs("a solid or a liquid"))?;
    // A liquid bears no shear.
    let [along_it, across] = match shear > 0.0 {
        true => elastic(scene, body).map(|solid| [solid.longitudinal_speed(), solid.shear_speed()])?,
        false => [(bulk / body.density).sqrt(), 0.0],
    };
    let sound = if along == moves { along_it } else { across };
    let centre = body.centre;
    let flow = Flow::Wave { along, moves, wavelength, speed: 1.0 };
    let shape =
        Box::new(move |x: [f64; 3]| flow.velocity(std::array::from_fn(|k| x[k] - centre[k])).unwrap_or_default());
    let k = 2.0 * std::f64::consts::PI / wavelength;
    let decay = k * k * along_it * body.expected_smoothing_length(scene.numerics.eta);
    Ok(Vibration { body: number, shape, frequency: k * sound, decay, speed })
}

fn vibration(scene: &Scene) -> Result<Vibration> {
    let found = scene.bodies.iter().position(|body| matches!(body.flow, Some(Flow::Mode { .. })));
    let number = found.ok_or_else(|| needs("a body with flow.mode"))?;
    let body = &scene.bodies[number];
    let Some(Flow::Mode { shape, speed }) = body.flow else { return Err(needs("a mode")) };
    let mode = ModeShape::new(scene, body, shape)?;
    let (centre, frequency) = (body.centre, mode.frequency);
    let shape = Box::new(move |x: [f64; 3]| mode.velocity(std::array::from_fn(|k| x[k] - centre[k])));
    Ok(Vibration { body: number, shape, frequency, decay: f64::NAN, speed })
}
