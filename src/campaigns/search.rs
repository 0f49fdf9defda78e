//! The catastrophic disruption threshold: impact after impact at the scene's speed and angle, the projectile's size varied,
//! until the largest remnant is known to fall through one half. Q*_D and Q*_RD come from the same impacts.

use std::path::Path;

use super::bracket::{Next, Rules, next};
use super::fit::{Threshold, threshold};
use super::record::{self, Impact, Price};
use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::outcome::scaling::{self, ThresholdFit};
use crate::output::figures::curves::{Axis, Figure, Mark, Series};
use crate::output::publish::replace_text;
use crate::output::summary::{self, Figures};
use crate::output::{Summary, agree};
use crate::scene::{Body, Scene, Shape};
use crate::simulation::{self, Ended, Options};

/// What the search knows of its scene.
struct Search<'a> {
    scene: &'a Scene,
    key: &'a str,
    target: &'a Body,
    projectile: &'a Body,
    speed: f64,
    reference: ThresholdFit,
}

/// Searches, or goes on searching. Collective.
pub fn run(scene: &Scene, options: &Options, comm: &Comm) -> Result<Ended> {
    let search = Search::new(scene)?;
    let rules = search.rules();
    let mut impacts = if options.resume { record::read(&options.directory, comm)? } else { Vec::new() };
    let end = loop {
        let points: Vec<_> = impacts.iter().map(Impact::point).collect();
        let q = match next(&points, &rules) {
            Next::Impact(q) => q,
            Next::Done(end) => break end,
        };
        let length = search.length(q);
        tracing::info!("impact {}: {} = {length:.5e} m, Q = {q:.4e} J/kg", impacts.len() + 1, search.key);
        let Some(impact) = search.impact(length, impacts.len() + 1, options, comm)? else {
            return Ok(Ended::Interrupted);
        };
        tracing::info!(
            "impact {}: M_lr / M_T = {:.3}, {:.3} at twice the time",
            impacts.len() + 1,
            impact.outcome.largest_remnant_fraction,
            impact.later.largest_remnant_fraction
        );
        impacts.push(impact);
        record::write(&options.directory, &impacts, comm)?;
    };
    let points: Vec<_> = impacts.iter().map(Impact::point).collect();
    let of_total: Vec<_> = impacts.iter().map(Impact::point_of_total).collect();
    let end = serde_json::to_string(&end).unwrap_or_default().trim_matches('"').to_string();
    let found = Found { search: &search, impacts: &impacts, d: threshold(&points), rd: threshold(&of_total), end };
    found.write(&options.directory, comm)?;
    Ok(Ended::Finished)
}

impl<'a> Search<'a> {
    fn new(scene: &'a Scene) -> Result<Self> {
        let (Some(threshold), Some(impact)) = (&scene.threshold, &scene.impact) else {
            return Err(Error::new("a threshold is searched with impacts")
                .at(scene.path())
                .allowed("an [impact] table"));
        };
        let (target, projectile) = (&scene.bodies[impact.target], &scene.bodies[impact.projectile]);
        let key = format!("{}.radius", projectile.name);
        if threshold.vary != key || !matches!(projectile.shape, Shape::Sphere { .. }) {
            let what = format!("`{}` cannot be varied", threshold.vary);
            return Err(Error::new(what).at("threshold.vary").allowed(key + " of a sphere"));
        }
        let reference = scaling::nearest_fit(target.density, impact.speed);
        Ok(Self { scene, key: &threshold.vary, target, projectile, speed: impact.speed, reference })
    }

    fn rules(&self) -> Rules {
        let asked = self.scene.threshold.as_ref().expect("checked in `new`");
        // A projectile as large as its target is no projectile; one of a hundredth leaves a crater.
        let size = self.target.shape.outer_radius();
        let range = [asked.min.unwrap_or(0.01 * size), asked.max.unwrap_or(size)].map(|length| self.q(length));
        Rules {
            start: self.reference.q_star(size),
            tolerance: asked.tolerance,
            max_impacts: asked.max_impacts as usize,
            range,
        }
    }

    fn projectile_mass(&self, length: f64) -> f64 {
        let ratio = length / self.projectile.shape.outer_radius();
        self.projectile.mass() * ratio * ratio * ratio
    }

    /// J/kg.
    fn q(&self, length: f64) -> f64 {
        scaling::q(self.target.mass(), self.projectile_mass(length), self.speed)
    }

    /// The radius that gives this Q, m.
    fn length(&self, q: f64) -> f64 {
        let mass = scaling::projectile_mass(self.target.mass(), q, self.speed);
        self.projectile.shape.outer_radius() * libm::cbrt(mass / self.projectile.mass())
    }

    /// Runs one impact, or goes on with the one that was interrupted; none where it was interrupted again.
    fn impact(&self, length: f64, number: usize, options: &Options, comm: &Comm) -> Result<Option<Impact>> {
        let scene = self.scene.reread(&[format!("{}={length:?}", self.key)])?;
        let directory = options.directory.join(format!("impact_{number:02}"));
        simulation::directory::prepare(&directory, options.resume, comm)?;
        let report = simulation::run(&scene, &Options { directory, ..options.clone() }, comm)?;
        let (Ended::Finished, Some(outcome)) = (report.ended, report.outcome) else { return Ok(None) };
        let later = report.later.unwrap_or_else(|| outcome.clone());
        let (target, projectile) = (self.target.mass(), self.projectile_mass(length));
        Ok(Some(Impact {
            length,
            q: scaling::q(target, projectile, self.speed),
            q_r: scaling::q_r(target, projectile, self.speed),
            outcome,
            later,
            price: price(&report.summary),
            state_hash: report.summary.state_hash,
        }))
    }
}

fn price(summary: &Summary) -> Price {
    Price {
        particles: summary.particles,
        steps: summary.steps,
        wall_seconds: summary.wall_seconds,
        core_seconds: summary.core_seconds,
        mpi_wait_seconds: summary.mpi_wait_seconds,
        pair_interactions: summary.pair_interactions,
        updates: summary.updates_per_core_second * summary.core_seconds,
        energy_drift: summary.energy_drift,
        momentum_drift: summary.momentum_drift,
        angular_momentum_drift: summary.angular_momentum_drift,
    }
}

/// What the search found.
struct Found<'a> {
    search: &'a Search<'a>,
    impacts: &'a [Impact],
    d: Option<Threshold>,
    rd: Option<Threshold>,
    end: String,
}

impl Found<'_> {
    /// summary.json, threshold.csv and two figures, on rank 0; and the result in words. Collective.
    fn write(&self, directory: &Path, comm: &Comm) -> Result<()> {
        self.summary(comm).write(&directory.join("summary.json"), comm)?;
        agree(comm, if comm.is_root() { self.write_alone(directory) } else { Ok(()) })?;
        self.print(directory);
        Ok(())
    }

    fn write_alone(&self, directory: &Path) -> Result<()> {
        replace_text(&directory.join("scene.toml"), &self.search.scene.to_toml())?;
        replace_text(&directory.join("threshold.csv"), &self.table())?;
        self.remnant_figure().draw(&directory.join("threshold.png"))?;
        self.radius_figure().draw(&directory.join("q_star.png"))
    }

    fn reference(&self) -> f64 {
        self.search.reference.q_star(self.search.target.shape.outer_radius())
    }

    fn angle_in_degrees(&self) -> f64 {
        self.search.scene.impact.as_ref().map_or(0.0, |impact| impact.angle).to_degrees()
    }

    fn threshold(&self) -> summary::Threshold {
        let number = |found: &Option<Threshold>, get: fn(&Threshold) -> f64| found.as_ref().map_or(f64::NAN, get);
        let q_star_d = number(&self.d, |t| t.q_star);
        let parts = self.d.iter().flat_map(|t| {
            let u = &t.uncertainty;
            [("bracket", u.bracket), ("residual", u.residual), ("shift", u.shift)]
        });
        summary::Threshold {
            q_star_d,
            q_star_rd: number(&self.rd, |t| t.q_star),
            uncertainty: number(&self.d, |t| t.uncertainty.combined),
            uncertainty_of_q_star_rd: number(&self.rd, |t| t.uncertainty.combined),
            uncertainty_parts: Figures(parts.map(|(name, value)| (name.to_string(), value)).collect()),
            slope: number(&self.d, |t| t.slope),
            angle: self.angle_in_degrees(),
            reference: self.reference(),
            ratio_to_reference: q_star_d / self.reference(),
            end: self.end.clone(),
            impacts: self.impacts.iter().map(Impact::figures).collect(),
        }
    }

    /// The price of all impacts together; drifts are the largest of any.
    fn summary(&self, comm: &Comm) -> Summary {
        let sum = |get: fn(&Price) -> f64| self.impacts.iter().map(|impact| get(&impact.price)).sum::<f64>();
        let largest = |get: fn(&Price) -> f64| self.impacts.iter().map(|i| get(&i.price)).fold(0.0, f64::max);
        let hashes: String = self.impacts.iter().map(|impact| impact.state_hash.as_str()).collect();
        let core_seconds = sum(|p| p.core_seconds);
        Summary {
            title: self.search.scene.title.clone(),
            version: env!("CARGO_PKG_VERSION").to_string(),
            state_hash: blake3::hash(hashes.as_bytes()).to_hex().to_string(),
            steps: sum(|p| p.steps as f64) as u64,
            particles: self.impacts.last().map_or(0, |impact| impact.price.particles),
            ranks: comm.size(),
            threads_per_rank: rayon::current_num_threads(),
            wall_seconds: sum(|p| p.wall_seconds),
            mpi_wait_seconds: sum(|p| p.mpi_wait_seconds),
            core_seconds,
            pair_interactions: sum(|p| p.pair_interactions as f64) as u64,
            updates_per_core_second: sum(|p| p.updates) / core_seconds.max(1e-9),
            energy_drift: largest(|p| p.energy_drift),
            momentum_drift: largest(|p| p.momentum_drift),
            angular_momentum_drift: largest(|p| p.angular_momentum_drift),
            threshold: Some(self.threshold()),
            ..Summary::default()
        }
    }

    fn table(&self) -> String {
        let rows: Vec<Figures> = self.impacts.iter().map(Impact::figures).collect();
        let Some(first) = rows.first() else { return String::new() };
        let names: Vec<&str> = first.0.iter().map(|(name, _)| name.as_str()).collect();
        let line = |row: &Figures| row.0.iter().map(|(_, value)| format!("{value:e}")).collect::<Vec<_>>().join(",");
        let lines: Vec<String> = std::iter::once(names.join(",")).chain(rows.iter().map(line)).collect();
        lines.join("\n") + "\n"
    }

    /// M_lr against Q with the fitted law.
    fn remnant_figure(&self) -> Figure {
        let points = |get: fn(&Impact) -> (f64, f64)| self.impacts.iter().map(get).collect::<Vec<_>>();
        let mut series = vec![
            Series {
                label: "settled".into(),
                points: points(|i| (i.q, i.outcome.largest_remnant_fraction)),
                errors: Vec::new(),
                mark: Mark::Points,
            },
            Series {
                label: "at twice the time".into(),
                points: points(|i| (i.q, i.later.largest_remnant_fraction)),
                errors: Vec::new(),
                mark: Mark::Points,
            },
        ];
        if let Some(t) = &self.d {
            let law = |x: f64| (x * t.q_star, 0.5 - t.slope * (x - 1.0));
            let line = (0..=40).map(|k| law(0.5 + k as f64 / 40.0)).filter(|(_, share)| (0.1..=0.9).contains(share));
            let label = format!("Q*_D = {:.3e} ± {:.1e} J/kg", t.q_star, t.uncertainty.combined);
            series.push(Series { label, points: line.collect(), errors: Vec::new(), mark: Mark::Line });
        }
        Figure {
            title: format!("{} ({:.0}° from the normal)", self.search.scene.title, self.angle_in_degrees()),
            x: Axis { label: "Q (J/kg)".into(), logarithmic: false },
            y: Axis { label: "largest remnant / target".into(), logarithmic: false },
            series,
        }
    }

    /// Q*_D beside Benz & Asphaug 1999.
    fn radius_figure(&self) -> Figure {
        let fit = &self.search.reference;
        let radius = self.search.target.shape.outer_radius();
        let radii = (0..=120).map(|k| libm::pow(10.0, -1.0 + 7.0 * k as f64 / 120.0));
        let mut series = vec![Series {
            label: format!("Benz & Asphaug 1999, {:.1} km/s, mean over angles", 1e-3 * fit.speed),
            points: radii.map(|r| (r, fit.q_star(r))).collect(),
            errors: Vec::new(),
            mark: Mark::Line,
        }];
        if let Some(t) = &self.d {
            series.push(Series {
                label: format!("this scene, {:.0}°", self.angle_in_degrees()),
                points: vec![(radius, t.q_star)],
                errors: vec![t.uncertainty.combined],
                mark: Mark::Points,
            });
        }
        Figure {
            title: "Catastrophic disruption threshold".into(),
            x: Axis { label: "target radius (m)".into(), logarithmic: true },
            y: Axis { label: "Q*_D (J/kg)".into(), logarithmic: true },
            series,
        }
    }

    fn print(&self, directory: &Path) {
        let t = self.threshold();
        tracing::info!(
            "Q*_D = {:.4e} +- {:.1e} J/kg at {:.0} degrees from the normal, {:.2} of Benz & Asphaug 1999 ({:.3e}, their fit averages over angles)",
            t.q_star_d,
            t.uncertainty,
            t.angle,
            t.ratio_to_reference,
            t.reference
        );
        tracing::info!(
            "Q*_RD = {:.4e} +- {:.1e} J/kg; {} impacts, {}",
            t.q_star_rd,
            t.uncertainty_of_q_star_rd,
            self.impacts.len(),
            self.end
        );
        tracing::info!("written to {}", directory.display());
    }
}
