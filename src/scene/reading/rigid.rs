//! Rigid bodies and the rest of the scene: what they need of it, and what makes no sense beside them.

use super::tables::SceneTables;
use crate::error::Result;
use crate::particles::Periods;
use crate::scene::document::source::Document;
use crate::scene::geometry::periods::fills;
use crate::scene::geometry::shape::BodyShape;
use crate::scene::tables::body::validated::Body;
use crate::scene::tables::numerics::NumericsSettings;

/// Refuses what a rigid body cannot be combined with. `bodies`: those that the scene names.
pub fn check(
    document: &Document,
    tables: &SceneTables,
    bodies: &[Body],
    periods: &Periods,
    numerics: &NumericsSettings,
) -> Result<()> {
    let mut rigid = bodies.iter().enumerate().filter(|(_, body)| body.rigid.is_some());
    let Some((_, first)) = rigid.clone().next() else { return Ok(()) };
    let name = &first.name;
    if !numerics.density_contrast {
        // Which of both the scene says, of which either takes it away.
        let key = if document.says("numerics.density_contrast") { "density_contrast" } else { "corrected_gradient" };
        let what = format!("rigid body \"{name}\" stands for what hits it by the density contrast of pairs");
        return Err(document.error(&format!("numerics.{key}"), what).allowed("true, or no such key"));
    }
    if tables.late_stage.is_some() {
        let what = format!("rigid body \"{name}\" cannot be softened");
        return Err(document.error("late_stage", what).allowed("no late stage, or no rigid body"));
    }
    let layer = tables
        .layer
        .iter()
        .position(|layer| bodies.iter().any(|body| body.rigid.is_some() && layer.body.as_ref() == Some(&body.name)));
    if let Some(number) = layer {
        let what = "a part of a rigid body has no motion of its own";
        return Err(document.error(&format!("layer.{number}.body"), what).allowed("`motion` of the body itself"));
    }
    let target = tables.impact.as_ref().and_then(|impact| impact.target.as_ref());
    if target.is_some_and(|target| bodies.iter().any(|body| body.rigid.is_some() && body.name == *target)) {
        if tables.threshold.is_some() {
            let error = document.error("threshold", "a rigid target is never dispersed");
            return Err(error.allowed("a target that is not rigid"));
        }
        if tables.impact.as_ref().is_some_and(|impact| impact.refinement().is_some()) {
            let error = document.error("impact.refine", "a rigid target is one body and is not refined");
            return Err(error.allowed("no `refine`, or a target that is not rigid"));
        }
    }
    let turns = |body: &Body| body.rigid.is_some_and(|rigid| rigid.rotation);
    let spans = |body: &Body| matches!(body.shape, BodyShape::Box { size } if fills(periods, size) != [false; 3]);
    if let Some((number, body)) = rigid.find(|(_, body)| turns(body) && spans(body)) {
        let what = format!("rigid body \"{}\" fills a period, in which it cannot turn", body.name);
        return Err(document.error(&format!("body.{number}.rigid"), what).allowed("{ rotation = false }"));
    }
    Ok(())
}
