//! Scenes: a TOML file is read into raw tables, completed from the material library and the defaults, and validated into a
//! [`Scene`]. Reading is pure and needs one process; a scene can be sent as bytes (serde) with every number's bits.

pub mod answer;
pub mod ask;
pub mod blocks;
pub mod body;
pub mod boundaries;
pub mod compare;
mod curves;
pub mod cut;
pub mod gravity;
pub mod hydrostatic;
pub mod identity;
pub mod impact;
pub mod input;
pub mod isentrope;
pub mod keys;
pub mod late_stage;
pub mod lattice;
mod materials;
pub mod nbody;
pub mod numerics;
mod raw;
mod refine;
mod resolution;
pub mod settings;
pub mod shape;
mod slab;
pub mod source;
pub mod start;
#[cfg(test)]
mod tests;
mod unlikely;

use std::path::Path;

use serde::{Deserialize, Serialize};
use toml::{Table, Value};

use crate::error::{Error, Result};
use crate::material::{MaterialTable, Records};
use crate::particles::Periods;
pub use ask::{Asked, Face, Probe};
pub use body::Body;
pub use boundaries::Layer;
pub use compare::Compare;
pub use gravity::Gravity;
pub use hydrostatic::Start;
pub use impact::Impact;
pub use late_stage::LateStage;
use late_stage::Surroundings;
pub use nbody::Nbody;
pub use numerics::{ArtificialStress, Numerics, SmoothingLength};
use raw::RawScene;
pub use settings::{Output, Precision, Run, Snapshots, Threshold, Until};
pub use shape::Shape;
use source::{Document, Source};
pub use start::{Blast, Flow, Mode};

/// A validated scene; all numbers in SI.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Scene {
    pub title: String,
    /// 2 or 3.
    pub dimension: usize,
    pub bodies: Vec<Body>,
    pub layers: Vec<Layer>,
    pub periods: Periods,
    pub gravity: Gravity,
    pub materials: Vec<MaterialTable>,
    pub material_names: Vec<String>,
    pub impact: Option<Impact>,
    pub numerics: Numerics,
    pub run: Run,
    pub late_stage: Option<LateStage>,
    pub output: Output,
    pub record: Records,
    pub threshold: Option<Threshold>,
    pub compare: Option<Compare>,
    pub outcome: Option<Asked>,
    pub probes: Vec<Probe>,
    pub nbody: Option<Nbody>,
    understood: String,
    source: Source,
}

/// Reads a scene from a file. `overrides` are `key=value`, as after `--set`.
pub fn read(path: &Path, overrides: &[String]) -> Result<Scene> {
    of(Source::open(path, overrides)?)
}

/// The scene of a text, and of the files that it names.
pub fn of(mut source: Source) -> Result<Scene> {
    curves::read_into(&mut source)?;
    Scene::from_source(source)
}

impl Scene {
    /// Reads a scene from its text; `path` names it in messages.
    pub fn parse(path: &str, text: &str, overrides: &[String]) -> Result<Self> {
        Self::from_source(Source { path: path.into(), text: text.into(), overrides: overrides.to_vec() })
    }

    /// The scene that its source gives with further overrides, e.g. another size of the projectile.
    pub fn reread(&self, overrides: &[String]) -> Result<Self> {
        let mut source = self.source.clone();
        source.overrides.extend_from_slice(overrides);
        Self::from_source(source)
    }

    /// The scene as understood: every default spelt out, library values included. Reads back to the same scene.
    pub fn to_toml(&self) -> String {
        self.understood.clone()
    }

    /// The file the scene was read from.
    pub fn path(&self) -> &str {
        &self.source.path
    }

    /// An error at a key: `body.0.flow.mode`.
    pub fn error(&self, path: &str, what: impl Into<String>) -> Error {
        let place = Document::parse(&self.source).map_or(self.path().to_string(), |document| document.place(path));
        Error::new(what).at(place).bad_input()
    }

    fn from_source(source: Source) -> Result<Self> {
        let mut document = Document::parse(&source)?;
        materials::complete(&mut document)?;
        let mut raw: RawScene = keys::deserialize(&document)?;
        let mut scene = validate(&document, &mut raw)?;
        check_numbers(&document, &scene)?;
        scene.understood =
            print(&raw).map_err(|e| Error::new(format!("the scene cannot be printed: {e}")).at(&source.path))?;
        scene.source = source.clone();
        Ok(scene)
    }
}

/// The scene as understood. What is off is not printed, except viscosity, which is on unless a material says otherwise.
fn print(raw: &RawScene) -> std::result::Result<String, toml::ser::Error> {
    let mut tree = Table::try_from(raw)?;
    let materials = tree.get_mut("material").and_then(Value::as_table_mut).into_iter().flatten();
    for material in materials.filter(|_| raw.numerics.viscosity).filter_map(|(_, material)| material.as_table_mut()) {
        material.entry("viscosity").or_insert(Value::Boolean(false));
    }
    toml::to_string(&tree)
}

/// Numbers that follow from others may be beyond the reach of numbers, each of which is within. Ranks get a scene as JSON, which
/// has no such numbers: one without a check of its own is found where it does not come back.
fn check_numbers(document: &Document, scene: &Scene) -> Result<()> {
    let text =
        serde_json::to_string(scene).map_err(|e| document.error("", format!("the scene cannot be sent: {e}")))?;
    let path = match serde_path_to_error::deserialize::<_, Scene>(&mut serde_json::Deserializer::from_str(&text)) {
        Ok(same) if same == *scene => return Ok(()),
        Ok(_) => String::new(),
        Err(e) => {
            let path = e.path().to_string().replace('[', ".").replace(']', "");
            // From fields of a scene to keys of its file.
            let tables = [("bodies", "body"), ("layers", "layer"), ("probes", "probe")];
            let table = tables.iter().find_map(|(field, key)| Some(format!("{key}{}", path.strip_prefix(field)?)));
            if path.starts_with("periods") { "domain.periodic".into() } else { table.unwrap_or(path) }
        }
    };
    Err(document.error(&path, "a number comes to nothing finite").allowed("sizes within reach of numbers"))
}

/// Support of the kernels over the smoothing length.
const SUPPORT: f64 = 2.0;
/// Bodies are numbered in 16 bits of a particle's id.
const MOST_BODIES: usize = 1 << 16;

/// Checks everything that a single key cannot show, and fills in the defaults that depend on other keys.
fn validate(document: &Document, raw: &mut RawScene) -> Result<Scene> {
    let dimension = raw.dimension as usize;
    if dimension != 2 && dimension != 3 {
        return Err(document.error("dimension", format!("{dimension} dimensions")).allowed("2 or 3"));
    }
    check_names(document, raw)?;
    let (material_names, materials): (Vec<_>, Vec<_>) = raw.material.clone().into_iter().unzip();
    for (name, material) in raw.material.iter() {
        // The checks of a table name keys by their path, which becomes a place in the file.
        material.validate(&format!("material.{name}")).map_err(|e| relocated(document, e))?;
    }
    raw.record.validate(&materials).map_err(|e| relocated(document, e))?;
    let solid = materials.iter().any(MaterialTable::has_strength);
    let mut numerics = raw.numerics.validate(document, dimension, solid)?;
    let impact = raw.impact.as_mut().map(|i| Impact::read(document, i, &raw.body)).transpose()?;
    let periods = raw.domain.validate(document, dimension)?;
    if impact.is_some() && periods.any() {
        return Err(boundaries::no_impact(document));
    }
    let gravity = raw.gravity.as_ref().map(|gravity| gravity.validate(document, dimension, &periods));
    let gravity = gravity.transpose()?.unwrap_or_default();
    let (mut bodies, parts) =
        bodies(document, raw, (&materials, &material_names), &periods, impact.as_ref(), numerics.eta)?;
    raw.numerics.contrast(&mut numerics, solid, bodies.iter().map(|body| body.density));
    check_starts(document, &bodies, (&materials, &gravity, &periods))?;
    check_overlaps(document, &bodies)?;
    boundaries::check_periods(document, &periods, &bodies, largest_reach(&bodies, &numerics))?;
    let layers =
        raw.layer.iter().enumerate().map(|(number, layer)| layer.validate(document, number, (&bodies, &periods)));
    let layers = layers.collect::<Result<Vec<_>>>()?;
    let run = raw.run.validate(document, impact.is_some())?;
    let output = raw.output.validate(document, &run)?;
    let late_stage = raw.late_stage.as_ref().map(|stage| {
        let (impact, names) = (impact.is_some(), &material_names[..]);
        let around =
            Surroundings { run: &run, impact, gravity: &gravity, bodies: &bodies, materials: &materials, names };
        stage.validate(document, &around)
    });
    let late_stage = late_stage.transpose()?;
    let outcome = raw.outcome.map(|asked| asked.validate(document, impact.as_ref(), &bodies)).transpose()?;
    let probes = raw.probe.iter().enumerate().map(|(number, probe)| probe.validate(document, number, &bodies));
    let probes = probes.collect::<Result<Vec<_>>>()?;
    ask::check_names(document, &probes)?;
    let threshold = match &raw.threshold {
        None => None,
        Some(threshold) => Some(threshold.validate(document, &varied(document, impact.as_ref(), &bodies)?)?),
    };
    if bodies.len() + parts.len() > MOST_BODIES {
        return Err(document
            .error("impact.refine", "no numbers are left for the parts of the target")
            .allowed("fewer bodies"));
    }
    bodies.extend(parts);
    let mut scene = Scene {
        title: raw.title.clone(),
        dimension,
        bodies,
        layers,
        periods,
        gravity,
        materials,
        material_names,
        impact,
        numerics,
        run,
        late_stage,
        output,
        record: raw.record,
        threshold,
        compare: raw.compare.as_ref().map(|compare| compare.validate(document)).transpose()?,
        outcome,
        probes,
        nbody: None,
        understood: String::new(),
        source: Source { path: String::new(), text: String::new(), overrides: Vec::new() },
    };
    if scene.threshold.is_some() && scene.hits_ground() {
        let what = "ground has no remnant that could keep half of it";
        return Err(document
            .error("threshold", what)
            .allowed("a target that is a whole body: no half_sphere, no layer with `outer`"));
    }
    let remnants = scene.impact.is_some() && !scene.hits_ground();
    scene.nbody = raw.nbody.map(|nbody| nbody.validate(document, dimension, remnants)).transpose()?;
    Ok(scene)
}

fn relocated(document: &Document, error: Error) -> Error {
    let place = document.place(&error.place);
    error.at(place)
}

fn check_names(document: &Document, raw: &RawScene) -> Result<()> {
    if raw.body.is_empty() || raw.body.len() > MOST_BODIES {
        let what = format!("the scene has {} bodies", raw.body.len());
        return Err(document.error("body", what).allowed(format!("1 to {MOST_BODIES} tables [[body]]")));
    }
    // A body is addressed by its name, which therefore must not be another table's.
    const TABLES: [&str; 19] = [
        "compare",
        "outcome",
        "probe",
        "layer",
        "domain",
        "gravity",
        "title",
        "dimension",
        "body",
        "impact",
        "late_stage",
        "material",
        "nbody",
        "numerics",
        "run",
        "output",
        "record",
        "threshold",
        "",
    ];
    for (number, body) in raw.body.iter().enumerate() {
        let path = format!("body.{number}.name");
        if TABLES.contains(&body.name.as_str()) || body.name.contains(['.', '=']) {
            let what = format!("\"{}\" cannot name a body", body.name);
            let allowed =
                "any name without . and = that is no table or key of a scene: --set NAME.KEY=VALUE means the body";
            return Err(document.error(&path, what).allowed(allowed));
        }
        if raw.body[..number].iter().any(|other| other.name == body.name) {
            return Err(document.error(&path, format!("two bodies are named \"{}\"", body.name)));
        }
    }
    Ok(())
}

/// Reads the target first, as the projectile's spacing may follow it, and places the projectile last. With the parts that a
/// refined target has beside itself.
fn bodies(
    document: &Document,
    raw: &mut RawScene,
    (materials, names): (&[MaterialTable], &[String]),
    periods: &Periods,
    impact: Option<&Impact>,
    eta: f64,
) -> Result<(Vec<Body>, Vec<Body>)> {
    let dimension = raw.dimension as usize;
    let read = |number: usize, body: &mut raw::RawBody, target_spacing: Option<f64>| {
        let placed = impact.is_some_and(|i| i.projectile == number);
        let path = format!("body.{number}");
        // A date is text to one reader of TOML and not to the other.
        let material = names.iter().position(|n| *n == body.material);
        let what = || document.error(&format!("{path}.material"), format!("{} names no material", body.material));
        let material = material.ok_or_else(what)?;
        body::Reader { document, path, dimension, periods, target_spacing, placed }
            .read(body, (material, &materials[material]))
    };
    let refine = raw.impact.as_mut().and_then(|impact| impact.refine.as_mut()?.0.as_mut());
    let target_spacing = match impact {
        None => None,
        Some(i) => {
            let target = read(i.target, &mut raw.body[i.target], None)?;
            if target.velocity != [0.0; 3] {
                let place = format!("body.{}.velocity", i.target);
                return Err(document
                    .error(&place, "the target of an impact rests at the start")
                    .allowed("no velocity"));
            }
            let given = refine.as_ref().map(|refine| refine.spacing(document, &target)).transpose()?.flatten();
            Some(given.unwrap_or(target.lattice.spacing))
        }
    };
    let mut bodies = Vec::with_capacity(raw.body.len());
    for (number, body) in raw.body.iter_mut().enumerate() {
        let follows = target_spacing.filter(|_| impact.is_some_and(|i| i.projectile == number));
        bodies.push(read(number, body, follows)?);
    }
    let parts = match (refine, impact) {
        (Some(refine), Some(i)) => refine.parts(document, &mut bodies, i)?,
        _ => Vec::new(),
    };
    if let Some(i) = impact {
        let (target, projectile) = (&bodies[i.target], &bodies[i.projectile]);
        let near = parts.first().unwrap_or(target);
        let h = near.expected_smoothing_length(eta).max(projectile.expected_smoothing_length(eta));
        let placed = i.place(target, projectile, SUPPORT * h);
        let (centre, velocity) = placed.map_err(|e| e.at(document.place(&format!("body.{}.shape", i.projectile))))?;
        (bodies[i.projectile].centre, bodies[i.projectile].velocity) = (centre, velocity);
    }
    Ok((bodies, parts))
}

/// The largest list radius that any particle may get, m.
fn largest_reach(bodies: &[Body], numerics: &Numerics) -> f64 {
    let largest = bodies.iter().map(|body| body.expected_smoothing_length(numerics.eta)).fold(0.0, f64::max);
    let growth = match numerics.smoothing_length {
        SmoothingLength::Constant => 1.0,
        SmoothingLength::FollowsDensity { largest, .. } => largest,
    };
    SUPPORT * (1.0 + numerics.skin) * growth * largest
}

/// What starts under its own weight is a ball of something solid, in a scene where matter has a weight.
fn check_starts(
    document: &Document,
    bodies: &[Body],
    (materials, gravity, periods): (&[MaterialTable], &Gravity, &Periods),
) -> Result<()> {
    for (number, body) in bodies.iter().enumerate().filter(|(_, body)| body.start == Start::Hydrostatic) {
        let material = &materials[body.material];
        let refused = match () {
            () if material.reference_density().is_none() => Some(("a gas has no surface", "a solid")),
            () if body.rubble.is_some() => Some(("the voids of a pile carry nothing", "a body without `rubble`")),
            () if material.porosity.is_some() => Some(("pores would crush first", "a material without porosity")),
            () if is_ground(body, periods, gravity) => None,
            () if matches!(body.shape, Shape::Box { .. }) && gravity.own.is_none() => Some((
                "nothing holds the body's sides, or nothing pulls it down",
                "a box that fills its periods, gravity.uniform downwards",
            )),
            () if gravity.own.is_none() => Some(("no matter attracts any here", "a key `self` in [gravity]")),
            () if !matches!(body.shape, Shape::Sphere { .. }) => Some(("the body is no ball", "a sphere")),
            () => None,
        };
        if let Some((what, allowed)) = refused {
            return Err(document.error(&format!("body.{number}.start"), what).allowed(allowed));
        }
    }
    Ok(())
}

/// Whether a body is a box without sides that uniform gravity alone pulls down.
fn is_ground(body: &Body, periods: &Periods, gravity: &Gravity) -> bool {
    let (Shape::Box { size }, Some(uniform), None) = (body.shape, gravity.uniform, gravity.own) else { return false };
    let up = body.dimension - 1;
    let filled = boundaries::fills(periods, size);
    uniform[up] < 0.0 && !periods.closed(up) && (0..up).all(|axis| filled[axis])
}

fn check_overlaps(document: &Document, bodies: &[Body]) -> Result<()> {
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
fn varied(document: &Document, impact: Option<&Impact>, bodies: &[Body]) -> Result<Vec<String>> {
    let Some(impact) = impact else {
        return Err(document.error("threshold", "a threshold search needs an [impact]"));
    };
    let projectile = &bodies[impact.projectile];
    if !matches!(projectile.shape, Shape::Sphere { .. }) {
        let what = format!("a search varies the radius of a sphere, and body \"{}\" is none", projectile.name);
        return Err(document.error("threshold", what).allowed("a projectile with shape sphere"));
    }
    Ok(vec![format!("{}.radius", projectile.name)])
}
