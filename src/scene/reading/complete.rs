//! The defaults of a scene that follow from other keys. Nothing is refused here: what cannot be completed stays as it is, and
//! [`super::validate`] says why.

use super::bodies::BodyContext;
use super::tables::{DIMENSIONS, SceneTables};
use crate::material::MaterialTable;
use crate::scene::document::source::Document;
use crate::scene::tables::body::rigid::Speeds;
use crate::scene::tables::body::table::BodyTable;
use crate::scene::tables::impacts::refine::RefineTable;
use crate::scene::tables::numerics::Matter;
use crate::scene::values::switch::Switch;

/// The tables with every default filled in.
pub fn complete(document: &Document, tables: &SceneTables) -> SceneTables {
    let dimension = tables.dimension as usize;
    let names = tables.body_names();
    let impact = tables.impact.as_ref().map(|impact| impact.complete(&names));
    let projectile = impact.as_ref().and_then(|impact| impact.projectile(&names));
    let complete = |(number, body): (usize, &BodyTable)| {
        body.complete(dimension, projectile == Some(number), tables.material.get(&body.material))
    };
    let mut body: Vec<BodyTable> = tables.body.iter().enumerate().map(complete).collect();
    complete_rigid(document, tables, &mut body);
    let solid = tables.material.values().any(MaterialTable::has_strength);
    let numerics = tables.numerics.complete(
        dimension,
        Matter { solid, contrast: contrast(&body), rigid: body.iter().any(|body| body.rigid().is_some()) },
    );
    let run = tables.run.complete(impact.is_some());
    let mut complete = SceneTables { impact, body, numerics, run, ..tables.clone() };
    if let Some(refine) = refined(document, &complete)
        && let Some(impact) = &mut complete.impact
    {
        impact.refine = Some(Switch(Some(refine)));
    }
    complete
}

/// What the tables of rigid bodies say where they say nothing.
fn complete_rigid(document: &Document, tables: &SceneTables, bodies: &mut [BodyTable]) {
    if bodies.iter().all(|body| body.rigid().is_none()) {
        return;
    }
    let sound = bodies.iter().filter(|body| body.rigid().is_none()).filter_map(|body| {
        let (material, density) = (tables.material.get(&body.material)?, body.density?);
        let energy = body.internal_energy.unwrap_or_default();
        Some(material.sound_speed(density.0 * body.distention.map_or(1.0, |distention| distention.0), energy.0))
    });
    let sound = sound.fold(0.0, f64::max);
    let speeds = Speeds { sound, motion: fastest_motion(document, tables, bodies) };
    for body in bodies {
        if let Some(rigid) = body.rigid() {
            body.rigid = Some(Switch(Some(rigid.complete(speeds, body.motion.is_some()))));
        }
    }
}

/// A bound on how fast bodies move in a scene where none deforms, m/s: at the start, or after a fall through all of it.
fn fastest_motion(document: &Document, tables: &SceneTables, bodies: &[BodyTable]) -> f64 {
    let length = |numbers: &mut dyn Iterator<Item = f64>| numbers.map(|x| x * x).sum::<f64>().sqrt();
    let (mut fastest, mut farthest) = (tables.impact.as_ref().map_or(0.0, |impact| impact.speed.0), 0.0f64);
    for body in bodies {
        let shape = body.shape.as_ref().and_then(|shape| shape.validate(document, "", tables.dimension as usize).ok());
        let radius = shape.map_or(0.0, |shape| shape.outer_radius());
        let speed = body.velocity.iter().chain(body.prescribed_velocity()).flat_map(|v| &v.0).map(|v| v.0);
        let spin = body.spin.iter().flat_map(|w| &w.0).map(|w| w.0);
        fastest = fastest.max(length(&mut { speed }) + length(&mut { spin }) * radius);
        farthest = farthest.max(length(&mut body.position.iter().flat_map(|x| &x.0).map(|x| x.0)) + radius);
    }
    let gravity = tables.gravity.as_ref().map_or(0.0, |gravity| length(&mut gravity.uniform_components()));
    (fastest * fastest + 4.0 * gravity * farthest).sqrt()
}

/// Density of the densest body over that of the lightest.
fn contrast(bodies: &[BodyTable]) -> f64 {
    let densities = bodies.iter().filter_map(|body| Some(body.density?.0));
    densities.clone().fold(0.0, f64::max) / densities.fold(f64::INFINITY, f64::min)
}

/// `impact.refine`, where it has a default that follows from the projectile's lattice: which is why the bodies of an impact are read
/// here, too.
fn refined(document: &Document, tables: &SceneTables) -> Option<RefineTable> {
    let impact = tables.impact.as_ref()?;
    let refine = impact.refinement().filter(|refine| !refine.is_complete())?;
    if !DIMENSIONS.contains(&tables.dimension)
        || tables.material.values().any(|material| material.validate("").is_err())
    {
        return None;
    }
    let impact = impact.validate(document, &tables.body_names()).ok()?;
    let periods = tables.domain.validate(document, tables.dimension as usize).ok()?;
    let context = BodyContext { document, tables, periods: &periods, impact: Some(&impact) };
    let target = context.read(impact.target, None).ok()?;
    let spacing = context.spacing_at_impact(&target).ok()?;
    Some(refine.complete(&context.read(impact.projectile, Some(spacing)).ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::document::keys;
    use crate::scene::document::source::SourceText;
    use crate::scene::reading::library;

    /// What is complete stays as it is; what cannot be completed is left to be refused, and nothing panics on it.
    #[test]
    fn completing_ends() {
        let refined = "[[body]]\nname = \"target\"\nshape = { sphere = { radius = \"10 m\" } }\nmaterial = \"basalt\"\nspacing = \"2 m\"\n\
            [[body]]\nname = \"stone\"\nshape = { sphere = { radius = \"60 cm\" } }\nmaterial = \"basalt\"\n\
            [impact]\nspeed = \"5 km/s\"\nrefine = true\n[numerics]\nneighbours = 57\n";
        let print = |tables: &SceneTables| toml::to_string(tables).expect("tables");
        for (change, whole) in [
            ("title=x", true),
            ("dimension=7", false),
            ("stone.radius=-1 m", false),
            ("impact.target=nobody", false),
            ("numerics.neighbours=1", false),
            ("target.material=ideal_gas", false),
        ] {
            let source = SourceText::new("s.toml", refined, &[change.into()]);
            let mut document = Document::parse(&source).expect("a tree");
            library::complete(&mut document).expect("materials");
            let written: SceneTables = keys::deserialize(&document).expect("tables");
            let once = complete(&document, &written);
            assert_eq!(print(&complete(&document, &once)), print(&once), "{change}");
            let refine = once.impact.as_ref().and_then(|impact| impact.refinement()).expect("a table");
            assert!(refine.is_complete() || !whole, "{change}");
            assert_eq!(crate::scene::reading::validate::validate(&document, &once).is_ok(), whole, "{change}");
        }
    }
}
