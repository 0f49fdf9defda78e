//! What tables say together: whether names, places, periods and initial states fit.

use super::tables::SceneTables;
use crate::error::Result;
use crate::kernel::SUPPORT;
use crate::material::MaterialTable;
use crate::particles::Periods;
use crate::scene::document::keys::keys_of;
use crate::scene::document::source::Document;
use crate::scene::geometry::periods::{TOUCHING, fills};
use crate::scene::geometry::shape::BodyShape;
use crate::scene::tables::body::table::InitialState;
use crate::scene::tables::body::validated::Body;
use crate::scene::tables::gravity::GravitySettings;
use crate::scene::tables::impacts::impact::ImpactSettings;
use crate::scene::tables::numerics::{NumericsSettings, SmoothingLengthRule};
use crate::units::Length;

/// Bodies are numbered in 16 bits of a particle's id.
const MOST_BODIES: usize = 1 << 16;

/// Each body can be addressed by its name, which therefore must not be another table's.
pub fn check_names(document: &Document, tables: &SceneTables) -> Result<()> {
    if tables.body.is_empty() || tables.body.len() > MOST_BODIES {
        let what = format!("the scene has {} bodies", tables.body.len());
        return Err(document.error("body", what).allowed(format!("1 to {MOST_BODIES} tables [[body]]")));
    }
    let keys = keys_of::<SceneTables>();
    for (number, body) in tables.body.iter().enumerate() {
        let (path, name) = (format!("body.{number}.name"), body.name.as_str());
        if name.is_empty() || keys.contains(&name) || name.contains(['.', '=']) {
            let what = format!("\"{name}\" cannot name a body");
            let allowed =
                "any name without . and = that is no table or key of a scene: --set NAME.KEY=VALUE means the body";
            return Err(document.error(&path, what).allowed(allowed));
        }
        if tables.body[..number].iter().any(|other| other.name == name) {
            return Err(document.error(&path, format!("two bodies are named \"{name}\"")));
        }
    }
    Ok(())
}

/// There are numbers for the bodies and the parts of a refined target.
pub fn check_parts(document: &Document, bodies: usize, parts: usize) -> Result<()> {
    if bodies + parts > MOST_BODIES {
        let what = "no numbers are left for the parts of the target";
        return Err(document.error("impact.refine", what).allowed("fewer bodies"));
    }
    Ok(())
}

/// Bodies lie within the periods, and no particle meets two images of another.
pub fn check_periods(
    document: &Document,
    periods: &Periods,
    bodies: &[Body],
    numerics: &NumericsSettings,
) -> Result<()> {
    let reach = largest_reach(bodies, numerics);
    if periods.shortest() < 2.1 * reach {
        let what = format!("a period of {} is too short", Length::new(periods.shortest()));
        return Err(document
            .error("domain.periodic", what)
            .allowed(format!("{} or more, 2.1 times the radius of the neighbour lists", Length::new(2.1 * reach))));
    }
    for (number, body) in bodies.iter().enumerate() {
        let bounds = body.shape.bounds(body.dimension);
        for axis in (0..body.dimension).filter(|&axis| periods.closed(axis)) {
            let middle = body.centre[axis] + bounds.middle[axis] - periods.low[axis];
            let slack = TOUCHING * periods.length[axis];
            if middle - bounds.half[axis] < -slack || middle + bounds.half[axis] > periods.length[axis] + slack {
                let what = format!("body \"{}\" reaches beyond the period", body.name);
                return Err(document.error(&format!("body.{number}.position"), what).allowed("bodies within [domain]"));
            }
        }
    }
    Ok(())
}

/// The largest list radius that any particle may get, m.
fn largest_reach(bodies: &[Body], numerics: &NumericsSettings) -> f64 {
    let largest = bodies.iter().map(|body| body.expected_smoothing_length(numerics.eta)).fold(0.0, f64::max);
    let growth = match numerics.smoothing_length {
        SmoothingLengthRule::Constant => 1.0,
        SmoothingLengthRule::FollowsDensity { largest, .. } => largest,
    };
    SUPPORT * (1.0 + numerics.skin.widest(true)) * growth * largest
}

/// What a body that carries its own weight depends on.
#[derive(Clone, Copy)]
pub struct Space<'a> {
    pub materials: &'a [MaterialTable],
    pub gravity: &'a GravitySettings,
    pub periods: &'a Periods,
}

/// What starts under its own weight is a ball of something solid, in a scene where matter has a weight.
pub fn check_initial_states(document: &Document, bodies: &[Body], space: &Space) -> Result<()> {
    let Space { materials, gravity, periods } = *space;
    for (number, body) in bodies.iter().enumerate().filter(|(_, body)| body.start == InitialState::Hydrostatic) {
        let material = &materials[body.material];
        let refused = match () {
            () if material.reference_density().is_none() => Some(("a gas has no surface", "a solid")),
            () if body.rubble.is_some() => Some(("the voids of a pile carry nothing", "a body without `rubble`")),
            () if material.porosity.is_some() => Some(("pores would crush first", "a material without porosity")),
            () if is_ground(body, periods, gravity) => None,
            () if matches!(body.shape, BodyShape::Box { .. }) && gravity.own.is_none() => Some((
                "nothing holds the body's sides, or nothing pulls it down",
                "a box that fills its periods, gravity.uniform downwards",
            )),
            () if gravity.own.is_none() => Some(("no matter attracts any here", "a key `self` in [gravity]")),
            () if !matches!(body.shape, BodyShape::Sphere { .. }) => Some(("the body is no ball", "a sphere")),
            () => None,
        };
        if let Some((what, allowed)) = refused {
            return Err(document.error(&format!("body.{number}.start"), what).allowed(allowed));
        }
    }
    Ok(())
}

/// Whether a body is a box without sides that uniform gravity alone pulls down.
fn is_ground(body: &Body, periods: &Periods, gravity: &GravitySettings) -> bool {
    let (&BodyShape::Box { size }, Some(uniform), None) = (&body.shape, gravity.uniform, gravity.own) else {
        return false;
    };
    let up = body.dimension - 1;
    let filled = fills(periods, size);
    uniform[up] < 0.0 && !periods.closed(up) && (0..up).all(|axis| filled[axis])
}

/// No two bodies share volume.
pub fn check_overlaps(document: &Document, bodies: &[Body]) -> Result<()> {
    for (number, body) in bodies.iter().enumerate() {
        for other in &bodies[..number] {
            if other.shape.overlaps(other.centre, &body.shape, body.centre, body.dimension) {
                let what = format!("bodies \"{}\" and \"{}\" overlap", other.name, body.name);
                return Err(document
                    .error(&format!("body.{number}.position"), what)
                    .allowed("bodies that do not share volume"));
            }
        }
    }
    Ok(())
}

/// The keys that a threshold search may vary.
pub fn varied(document: &Document, impact: Option<&ImpactSettings>, bodies: &[Body]) -> Result<Vec<String>> {
    let Some(impact) = impact else {
        return Err(document.error("threshold", "a threshold search needs an [impact]"));
    };
    let projectile = &bodies[impact.projectile];
    if !matches!(projectile.shape, BodyShape::Sphere { .. }) {
        let what = format!("a search varies the radius of a sphere, and body \"{}\" is none", projectile.name);
        return Err(document.error("threshold", what).allowed("a projectile with shape sphere"));
    }
    Ok(vec![format!("{}.radius", projectile.name)])
}
