//! Completed tables -> scene: every table by itself, then what they say together.

use super::bodies::BodyContext;
use super::checks::{self, Space};
use super::rigid;
use super::tables::{DIMENSIONS, SceneTables};
use crate::error::{Error, Result};
use crate::material::MaterialTable;
use crate::scene::document::source::{Document, SourceText};
use crate::scene::tables::impacts::intrusion::Around;
use crate::scene::tables::impacts::late_stage::Surroundings;
use crate::scene::tables::regions::probe;
use crate::scene::tables::{domain, two_rates};
use crate::scene::validated::Scene;

/// Checks everything that a single key cannot show.
pub fn validate(document: &Document, tables: &SceneTables) -> Result<Scene> {
    let dimension = tables.dimension as usize;
    if !DIMENSIONS.contains(&tables.dimension) {
        return Err(document.error("dimension", format!("{dimension} dimensions")).allowed("2 or 3"));
    }
    checks::check_names(document, tables)?;
    let materials = materials(document, tables)?;
    let material_names: Vec<String> = tables.material.keys().cloned().collect();
    let numerics = tables.numerics.validate(document, dimension)?;
    let names = tables.body_names();
    let impact = tables.impact.as_ref().map(|impact| impact.validate(document, &names)).transpose()?;
    let periods = tables.domain.validate(document, dimension)?;
    if impact.is_some() && periods.any() {
        return Err(domain::no_impact(document));
    }
    let gravity = tables.gravity.as_ref().map(|gravity| gravity.validate(document, dimension, &periods));
    let gravity = gravity.transpose()?.unwrap_or_default();
    let context = BodyContext { document, tables, periods: &periods, impact: impact.as_ref() };
    let bodies = context.read_all(numerics.eta)?;
    let (mut bodies, parts) = (bodies.named, bodies.parts);
    let space = Space { materials: &materials, gravity: &gravity, periods: &periods };
    checks::check_initial_states(document, &bodies, &space)?;
    checks::check_overlaps(document, &bodies)?;
    rigid::check(document, tables, &bodies, &periods, &numerics)?;
    checks::check_periods(document, &periods, &bodies, &numerics)?;
    let layers = (0..).zip(&tables.layer).map(|(number, layer)| layer.validate(document, number, &bodies, &periods));
    let layers = layers.collect::<Result<Vec<_>>>()?;
    let run = tables.run.validate(document, impact.is_some())?;
    let output = tables.output.validate(document, &run)?;
    let surroundings = Surroundings {
        run: &run,
        impact: impact.is_some(),
        gravity: &gravity,
        bodies: &bodies,
        materials: &materials,
        names: &material_names,
    };
    let late_stage = tables.late_stage.map(|stage| stage.validate(document, &surroundings)).transpose()?;
    let outcome = tables.outcome.map(|outcome| outcome.validate(document, impact.as_ref(), &bodies)).transpose()?;
    let probes = (0..).zip(&tables.probe).map(|(number, probe)| probe.validate(document, number, &bodies));
    let probes = probes.collect::<Result<Vec<_>>>()?;
    probe::check_names(document, &probes)?;
    let around = Around { bodies: &bodies, materials: &materials, gravity: &gravity, periods: &periods };
    let intrusion = tables.intrusion.as_ref().map(|table| table.validate(document, &around)).transpose()?;
    let restitution =
        tables.restitution.as_ref().map(|table| table.validate(document, &bodies, &gravity)).transpose()?;
    let fragments = tables.fragments.as_ref().map(|table| table.validate(document, &bodies)).transpose()?;
    let deposit =
        tables.deposit.as_ref().map(|table| table.validate(document, &bodies, &gravity, &periods)).transpose()?;
    let threshold = match &tables.threshold {
        None => None,
        Some(threshold) => Some(threshold.validate(document, &checks::varied(document, impact.as_ref(), &bodies)?)?),
    };
    let matter = two_rates::Matter {
        bodies: &bodies,
        parts: parts.len(),
        numerics: &numerics,
        gravity: &gravity,
        late_stage: late_stage.is_some(),
    };
    let two_rates = tables.two_rates.as_ref().map(|rates| rates.validate(document, &matter)).transpose()?;
    checks::check_parts(document, bodies.len(), parts.len())?;
    bodies.extend(parts);
    let scene = Scene {
        title: tables.title.clone(),
        dimension,
        bodies,
        layers,
        periods,
        gravity,
        materials,
        material_names,
        impact,
        intrusion,
        restitution,
        fragments,
        deposit,
        numerics,
        run,
        two_rates,
        late_stage,
        output,
        record: tables.record,
        threshold,
        compare: tables.compare.map(|compare| compare.validate(document)).transpose()?,
        outcome,
        probes,
        nbody: None,
        understood: String::new(),
        source: SourceText::new("", "", &[]),
    };
    with_remnants(document, tables, scene)
}

/// The materials, each checked, in the order of their names.
fn materials(document: &Document, tables: &SceneTables) -> Result<Vec<MaterialTable>> {
    // The checks of a table name keys by their path, which becomes a place in the file.
    let relocated = |error: Error| {
        let place = document.place(&error.place);
        error.at(place)
    };
    for (name, material) in &tables.material {
        material.validate(&format!("material.{name}")).map_err(relocated)?;
    }
    let materials: Vec<MaterialTable> = tables.material.values().cloned().collect();
    tables.record.validate(&materials).map_err(relocated)?;
    Ok(materials)
}

/// The scene with what is asked about remnants, which an impact onto ground does not have.
fn with_remnants(document: &Document, tables: &SceneTables, scene: Scene) -> Result<Scene> {
    if scene.threshold.is_some() && scene.hits_ground() {
        let what = "ground has no remnant that could keep half of it";
        return Err(document
            .error("threshold", what)
            .allowed("a target that is a whole body: no half_sphere, no layer with `outer`"));
    }
    let remnants = scene.impact.is_some() && !scene.hits_ground();
    let nbody = tables.nbody.map(|nbody| nbody.validate(document, scene.dimension, remnants)).transpose()?;
    Ok(Scene { nbody, ..scene })
}
