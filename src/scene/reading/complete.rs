//! The defaults of a scene that follow from other keys. Nothing is refused here: what cannot be completed stays as it is, and
//! [`super::validate`] says why.

use super::bodies::BodyContext;
use super::tables::{DIMENSIONS, SceneTables};
use crate::material::MaterialTable;
use crate::scene::document::source::Document;
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
    let body: Vec<BodyTable> = tables.body.iter().enumerate().map(complete).collect();
    let solid = tables.material.values().any(MaterialTable::has_strength);
    let numerics = tables.numerics.complete(dimension, Matter { solid, contrast: contrast(&body) });
    let run = tables.run.complete(impact.is_some());
    let mut complete = SceneTables { impact, body, numerics, run, ..tables.clone() };
    if let Some(refine) = refined(document, &complete)
        && let Some(impact) = &mut complete.impact
    {
        impact.refine = Some(Switch(Some(refine)));
    }
    complete
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
