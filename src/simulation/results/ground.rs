//! Output of an impact onto ground: evaluates the crater, makes its tables and figures.

use std::path::Path;

use crate::error::Result;
use crate::math::Vec3;
use crate::outcome::crater::{self, Crater, CraterEvaluation, Matter, Question};
use crate::outcome::profiles::PoresRow;
use crate::output::figures::curves::{Axis, Figure, Mark, Series};
use crate::particles::ParticleId;
use crate::scene::Scene;
use crate::simulation::run::Run;

impl<const D: usize> Run<'_, D> {
    /// The crater as it is now, where the scene hits a flat face. Collective.
    pub(in crate::simulation) fn crater(&self) -> Option<CraterEvaluation> {
        let question = question(self.scene)?;
        Some(self.with_matter(|matter| crater::evaluate(self.comm, matter, &question)))
    }

    /// The momentum enhancement as it is now, where the scene says how fast matter escapes. Collective.
    pub(in crate::simulation) fn momentum_row(&self) -> Option<f64> {
        self.scene.outcome?;
        let question = question(self.scene)?;
        self.with_matter(|matter| crater::momentum_enhancement(self.comm, matter, &question))
    }

    fn with_matter<T>(&self, act: impl FnOnce(Matter) -> T) -> T {
        let (columns, view) = (&self.stepper.columns, &self.stepper.settings.view);
        let start = |id: ParticleId| self.scene.bodies[id.body()].start_of(id.site());
        act(Matter { columns, core: &view.core, constants: &view.constants, start: &start })
    }

    /// ejecta.png, and distention.png of ground with pores; for one rank.
    pub(in crate::simulation) fn draw_crater(&self, evaluation: &CraterEvaluation) -> Result<()> {
        let drawer = Drawer { title: &self.scene.title, directory: &self.options.directory, dimension: D };
        drawer.draw_ejecta(evaluation).and(drawer.draw_pores(evaluation))
    }
}

/// Name and unit of a scene's column of history.csv, where it says how fast matter escapes.
pub const COLUMN: (&str, &str) = ("momentum_enhancement", "");

/// Names and contents of the tables.
pub fn tables(evaluation: &CraterEvaluation) -> Vec<(&'static str, Vec<u8>)> {
    let ejecta = evaluation.ejecta.table(evaluation.impulse);
    let mut tables = vec![("ejecta.csv", ejecta), ("crater.csv", evaluation.bowl.table())];
    tables.extend(evaluation.pores.as_ref().map(|pores| ("distention.csv", pores.table())));
    tables.into_iter().map(|(name, text)| (name, text.into_bytes())).collect()
}

fn question(scene: &Scene) -> Option<Question> {
    let (face, impact) = (scene.face()?, scene.impact.as_ref()?);
    let ground = scene.bodies.iter().enumerate().filter(|(body, _)| *body != impact.projectile);
    let extent = ground.fold(0.0, |most: f64, (_, body)| most.max(2.0 * body.shape.outer_radius()));
    Some(Question {
        face: Vec3::from(face.middle),
        up: face.up,
        target: scene.at_impact()?,
        projectile: impact.projectile,
        ejection_speed: scene.outcome.map(|outcome| outcome.ejection_speed),
        extent,
        impulse: scene.bodies[impact.projectile].whole_mass() * impact.speed * libm::cos(impact.angle),
    })
}

/// Figures of an outcome under the names of summary.json.
pub fn figures(crater: &Crater) -> Vec<(String, f64)> {
    let mut figures = Vec::new();
    let mut named = |name: &str, value: f64| figures.push((name.to_string(), value));
    if let Some(ejected) = crater.ejected {
        named("ejected_mass", ejected.mass);
        named("ejected_volume", ejected.volume);
        named("ejected_mass_above_face", ejected.mass_above_face);
        named("ejected_over_projectile", ejected.mass / crater.projectile_mass);
        named("momentum_enhancement", ejected.momentum_enhancement);
    }
    named("crater_depth", crater.depth);
    named("crater_radius", crater.radius);
    if let Some(compaction) = crater.compaction {
        named("minimum_distention", compaction.minimum_distention);
        named("compacted_volume", compaction.compacted_volume);
        named("crushed_volume", compaction.crushed_volume);
    }
    named("ground_mass", crater.ground_mass);
    named("projectile_mass", crater.projectile_mass);
    figures
}

fn axis(label: &str, logarithmic: bool) -> Axis {
    Axis { label: label.into(), logarithmic }
}

/// Where and under which title figures are drawn.
struct Drawer<'a> {
    title: &'a str,
    directory: &'a Path,
    dimension: usize,
}

impl Drawer<'_> {
    fn figure(&self, x: Axis, y: Axis, series: Vec<Series>) -> Figure {
        Figure { title: self.title.into(), x, y, series }
    }

    /// Draws volume where there is a compacted volume to compare it with, else mass.
    fn draw_ejecta(&self, evaluation: &CraterEvaluation) -> Result<()> {
        let rows = &evaluation.ejecta.rows;
        let compaction = evaluation.crater.compaction;
        let points = rows.iter().map(|row| (row.speed, if compaction.is_some() { row.volume } else { row.mass }));
        let line =
            |label: &str, points: Vec<(f64, f64)>, mark| Series { label: label.into(), points, errors: vec![], mark };
        let mut series = vec![line("faster upwards", points.collect(), Mark::Line)];
        if let (Some(compaction), Some(first), Some(last)) = (compaction, rows.first(), rows.last()) {
            let level = [first.speed, last.speed].map(|speed| (speed, compaction.compacted_volume));
            series.push(line("compacted", level.to_vec(), Mark::Dashed));
        }
        let cubic = if self.dimension == 3 { "m³" } else { "m²" };
        let what = match compaction {
            Some(_) => format!("Volume before the impact [{cubic}]"),
            None => "Mass [kg]".to_string(),
        };
        let figure = self.figure(axis("Upward speed [m/s]", true), axis(&what, true), series);
        figure.draw(&self.directory.join("ejecta.png"))
    }

    fn draw_pores(&self, evaluation: &CraterEvaluation) -> Result<()> {
        let Some(pores) = &evaluation.pores else { return Ok(()) };
        let line = |label: &str, value: fn(&PoresRow) -> f64, mark| Series {
            label: label.into(),
            points: pores.rows.iter().map(|row| (row.depth, value(row))).collect(),
            errors: vec![],
            mark,
        };
        let series = vec![
            line("mean", |row| row.mean, Mark::Line),
            line("least", |row| row.least, Mark::Dashed),
            line("largest", |row| row.largest, Mark::Dashed),
        ];
        let depth = axis("Depth below the point of impact [m]", false);
        let figure = self.figure(depth, axis("Distention", false), series);
        figure.draw(&self.directory.join("distention.png"))
    }
}

/// The crater on the terminal, rank 0.
pub fn print(crater: &Crater) {
    let mut text = format!("crater {:.3} m deep, {:.3} m in radius", crater.depth, crater.radius);
    if let Some(ejected) = crater.ejected {
        let ratio = ejected.mass / crater.projectile_mass;
        let beta = ejected.momentum_enhancement;
        text +=
            &format!("; ejected {:.4e} kg, {ratio:.3} of the projectile's mass; momentum x {beta:.3}", ejected.mass);
    }
    if let Some(compaction) = crater.compaction {
        let (volume, least) = (compaction.compacted_volume, compaction.minimum_distention);
        text += &format!("; compacted {volume:.4e} m^3, distention down to {least:.4}");
    }
    tracing::info!("{text}");
}
