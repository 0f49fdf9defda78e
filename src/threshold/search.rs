//! The catastrophic disruption threshold: impact after impact at the scene's speed and angle, the projectile's size varied,
//! until the largest remnant is known to fall through one half. Q*_D and Q*_RD come from the same impacts. A few more, at the
//! threshold but with other flaws and another orientation of the lattice, show how reliable the outcome of one impact is:
//! their standard deviation, over the slope of the remnant law, is part of the uncertainty. So is the drift of energy, where a
//! fitted impact warns of it.

use std::path::Path;

use super::bracket::{Next, Point, Rules, next};
use super::fit::{Threshold, threshold};
use super::record::{self, Impact, ImpactCost};
use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::outcome::scaling::{self, ThresholdFit};
use crate::output::figures::curves::{Axis, Figure, Mark, Series};
use crate::output::figures::or_warn;
use crate::output::publish::replace_text;
use crate::output::summary::{self, Figures};
use crate::output::{Summary, on_root};
use crate::process::directory;
use crate::process::lock::Work;
use crate::scene::{Body, BodyShape, Scene, USUAL_RADII};
use crate::simulation::{self, Ended, Options};
use crate::warning::{self, Warning};

/// The data of the scene that the search uses.
struct Search<'a> {
    scene: &'a Scene,
    key: &'a str,
    target: &'a Body,
    projectile: &'a Body,
    speed: f64,
    reference: ThresholdFit,
    repeats: u32,
}

/// Searches, or continues a search; `None` where it was interrupted. Collective.
pub fn run(scene: &Scene, options: &Options, comm: &Comm) -> Result<Option<Summary>> {
    let search = Search::new(scene)?;
    let impacts = if options.resume { record::read(&options.directory, scene, comm)? } else { Vec::new() };
    record::begin(&options.directory, scene, comm)?;
    let mut progress = Progress { search: &search, options, comm, impacts };
    let rules = search.rules();
    let end = loop {
        match next(&progress.points(Impact::point), &rules) {
            Next::Impact(q) => {
                if !progress.run_impact(search.length(q), 0)? {
                    return Ok(None);
                }
            }
            Next::Done(end) => break end,
        }
    };
    // Q*_RD is lower, and may lie just outside the impacts that bracket Q*_D.
    while let Some(q) = progress.next_for_total(&rules) {
        if !progress.run_impact(search.length(q), 0)? {
            return Ok(None);
        }
    }
    if let Some(found) = threshold(&progress.points(Impact::point)) {
        let done = progress.impacts.iter().map(|impact| impact.repeat).max().unwrap_or(0);
        for repeat in done + 1..=search.repeats {
            if !progress.run_impact(search.length(found.q_star), repeat)? {
                return Ok(None);
            }
        }
    }
    let end = serde_json::to_string(&end).unwrap_or_default().trim_matches('"').to_string();
    Found::new(&progress, end).write(&options.directory, comm).map(Some)
}

/// The progress of a search.
struct Progress<'a> {
    search: &'a Search<'a>,
    options: &'a Options,
    comm: &'a Comm,
    impacts: Vec<Impact>,
}

impl Progress<'_> {
    /// The impacts of the search itself.
    fn points(&self, point: fn(&Impact) -> Point) -> Vec<Point> {
        self.impacts.iter().filter(|impact| impact.repeat == 0).map(point).collect()
    }

    /// Q of an impact that helps to bracket Q*_RD, where none does yet and another is allowed.
    fn next_for_total(&self, rules: &Rules) -> Option<f64> {
        let points = self.points(Impact::point_of_total);
        if threshold(&points).is_some() {
            return None;
        }
        match next(&points, rules) {
            Next::Impact(q_r) => self.search.q_of_q_r(q_r),
            Next::Done(_) => None,
        }
    }

    /// Runs one impact and records it; false where it was interrupted. Collective.
    fn run_impact(&mut self, length: f64, repeat: u32) -> Result<bool> {
        let number = self.impacts.len() + 1;
        let (search, comm) = (self.search, self.comm);
        tracing::info!("impact {number}: {} = {length:.5e} m, Q = {:.4e} J/kg", search.key, search.q(length));
        let Some(impact) = search.impact(length, repeat, number, self.options, comm)? else { return Ok(false) };
        tracing::info!(
            "impact {number}: M_lr / M_T = {:.3}, {:.3} at twice the time",
            impact.outcome.largest_remnant_fraction,
            impact.outcome.later_fraction()
        );
        self.impacts.push(impact);
        record::write(&self.options.directory, &self.impacts, comm)?;
        Ok(true)
    }
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
        if threshold.vary != key || !matches!(projectile.shape, BodyShape::Sphere { .. }) {
            let what = format!("`{}` cannot be varied", threshold.vary);
            return Err(Error::new(what).at("threshold.vary").allowed(key + " of a sphere"));
        }
        // Rock with pores is rock.
        let solid = scene.materials[target.material].reference_density().unwrap_or(target.density);
        let reference = scaling::nearest_fit(solid, impact.speed);
        let repeats = threshold.repeats;
        Ok(Self { scene, key: &threshold.vary, target, projectile, speed: impact.speed, reference, repeats })
    }

    fn rules(&self) -> Rules {
        let settings = self.scene.threshold.as_ref().expect("checked in `new`");
        // A projectile must be smaller than its target; one of a hundredth only makes a crater.
        let size = self.target.shape.outer_radius();
        let [least, most] = USUAL_RADII;
        let range =
            [settings.min.unwrap_or(least * size), settings.max.unwrap_or(most * size)].map(|length| self.q(length));
        Rules {
            start: self.reference.q_star(size),
            tolerance: settings.tolerance,
            max_impacts: settings.max_impacts as usize,
            range,
        }
    }

    fn projectile_mass(&self, length: f64) -> f64 {
        let ratio = length / self.projectile.shape.outer_radius();
        self.projectile.mass() * ratio * ratio * ratio
    }

    /// J/kg.
    fn q(&self, length: f64) -> f64 {
        scaling::q(self.target.whole_mass(), self.projectile_mass(length), self.speed)
    }

    /// Q of the impact whose Q_R is given, J/kg: Q_R = Q / (1 + x)^2 with the mass ratio x = Q / (v^2 / 2). No projectile
    /// smaller than the target reaches Q_R above v^2 / 8.
    fn q_of_q_r(&self, q_r: f64) -> Option<f64> {
        let half_square = 0.5 * self.speed * self.speed;
        let y = q_r / half_square;
        (y < 0.25).then(|| half_square * ((1.0 - 2.0 * y) - (1.0 - 4.0 * y).sqrt()) / (2.0 * y))
    }

    /// The radius that gives this Q, m.
    fn length(&self, q: f64) -> f64 {
        let mass = scaling::projectile_mass(self.target.whole_mass(), q, self.speed);
        self.projectile.shape.outer_radius() * libm::cbrt(mass / self.projectile.mass())
    }

    /// What distinguishes an impact from the scene; a repeat has flaws and an orientation of its own.
    fn overrides(&self, length: f64, repeat: u32) -> Vec<String> {
        let mut all = vec![format!("{}={length:?}", self.key)];
        if repeat > 0 {
            all.push(format!("{}.orientation={{ seed = {} }}", self.target.name, 1000 + repeat));
            if let Some(fracture) = &self.scene.materials[self.target.material].fracture {
                let material = &self.scene.material_names[self.target.material];
                all.push(format!("material.{material}.fracture.seed={}", fracture.seed + repeat as u64));
            }
        }
        all
    }

    /// Runs one impact, or resumes the one that was interrupted; `None` where it was interrupted again.
    fn impact(
        &self,
        length: f64,
        repeat: u32,
        number: usize,
        options: &Options,
        comm: &Comm,
    ) -> Result<Option<Impact>> {
        let scene = self.scene.reread(&self.overrides(length, repeat))?;
        let directory = options.directory.join(format!("impact_{number:02}"));
        let _lock = directory::prepare(&directory, options.resume, Work::Run, comm)?;
        let report = simulation::run(&scene, &Options { directory, ..options.clone() }, comm)?;
        let (Ended::Finished, Some(outcome)) = (report.ended, report.outcome) else { return Ok(None) };
        let (target, projectile) = (self.target.whole_mass(), self.projectile_mass(length));
        Ok(Some(Impact {
            repeat,
            length,
            q: scaling::q(target, projectile, self.speed),
            q_r: scaling::q_r(target, projectile, self.speed),
            outcome,
            price: price(&report.summary),
            state_hash: report.summary.state_hash,
            warnings: report.summary.warnings,
        }))
    }
}

fn price(summary: &Summary) -> ImpactCost {
    ImpactCost {
        particles: summary.particles,
        steps: summary.steps,
        wall_seconds: summary.wall_seconds,
        core_seconds: summary.core_seconds,
        mpi_wait_seconds: summary.mpi_wait_seconds,
        pair_interactions: summary.pair_interactions,
        updates: summary.updates_per_core_second * summary.core_seconds,
        energy_drift: summary.energy_drift,
        energy_drift_over_left: summary.energy_drift_over_left,
        momentum_drift: summary.momentum_drift,
        angular_momentum_drift: summary.angular_momentum_drift,
    }
}

/// The result of the search.
struct Found<'a> {
    search: &'a Search<'a>,
    impacts: &'a [Impact],
    d: Option<Threshold>,
    rd: Option<Threshold>,
    /// Standard deviation of the threshold between repeats, J/kg; none without repeats.
    scatter: Option<f64>,
    /// Largest relative drift of energy of an impact that the threshold depends on, where it is warned of; else zero.
    drift: f64,
    end: String,
}

impl<'a> Found<'a> {
    fn new(progress: &'a Progress<'a>, end: String) -> Self {
        let d = threshold(&progress.points(Impact::point));
        let repeated = progress.impacts.iter().filter(|impact| impact.repeat > 0);
        let shares: Vec<f64> = repeated.map(|impact| impact.outcome.largest_remnant_fraction).collect();
        let scatter = d.as_ref().filter(|_| shares.len() > 1).map(|t| deviation(&shares) * t.q_star / t.slope);
        let rd = threshold(&progress.points(Impact::point_of_total));
        // Where no impact is near one half, the bracket decides.
        let none_decides = !progress.impacts.iter().any(Impact::decides);
        let deciding = progress.impacts.iter().filter(|impact| none_decides || impact.decides());
        let drift = deciding.map(Impact::drift).fold(0.0, f64::max);
        Self { search: progress.search, impacts: &progress.impacts, d, rd, scatter, drift, end }
    }

    /// A threshold's own uncertainty, the scatter between realisations and the drift, which are alike in relative terms for both.
    fn uncertainty(&self, t: &Threshold) -> f64 {
        let relative = self.d.as_ref().zip(self.scatter).map_or(0.0, |(d, scatter)| scatter / d.q_star);
        let scatter = relative * t.q_star;
        let drift = self.drift * t.q_star;
        (t.uncertainty.combined * t.uncertainty.combined + scatter * scatter + drift * drift).sqrt()
    }

    /// summary.json, threshold.csv and two figures, on rank 0; and the result in words. Collective.
    fn write(&self, directory: &Path, comm: &Comm) -> Result<Summary> {
        let summary = self.summary(comm);
        summary.write(&directory.join("summary.json"), comm)?;
        on_root(comm, || self.write_alone(directory))?;
        self.print(&summary, directory, comm.is_root());
        Ok(summary)
    }

    fn write_alone(&self, directory: &Path) -> Result<()> {
        replace_text(&directory.join("threshold.csv"), &self.table())?;
        or_warn(self.remnant_figure().draw(&directory.join("threshold.png")));
        or_warn(self.radius_figure().draw(&directory.join("q_star.png")));
        if self.search.scene.output.picture {
            or_warn(crate::report::write(directory, false).map(|_| ()));
        }
        Ok(())
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
            let scatter = self.scatter.unwrap_or(f64::NAN);
            let drift = self.drift * t.q_star;
            let own = [("bracket", u.bracket), ("residual", u.residual), ("shift", u.shift)];
            own.into_iter().chain([("scatter", scatter), ("drift", drift)])
        });
        let uncertainty = |found: &Option<Threshold>| found.as_ref().map_or(f64::NAN, |t| self.uncertainty(t));
        summary::Threshold {
            q_star_d,
            q_star_rd: number(&self.rd, |t| t.q_star),
            uncertainty: uncertainty(&self.d),
            uncertainty_of_q_star_rd: uncertainty(&self.rd),
            uncertainty_parts: Figures(parts.map(|(name, value)| (name.to_string(), value)).collect()),
            slope: number(&self.d, |t| t.slope),
            angle: self.angle_in_degrees(),
            reference: self.reference(),
            ratio_to_reference: q_star_d / self.reference(),
            end: self.end.clone(),
            impacts: self.impacts.iter().map(Impact::figures).collect(),
        }
    }

    /// The cost of all impacts together; drifts are the largest of any.
    fn summary(&self, comm: &Comm) -> Summary {
        let sum = |get: fn(&ImpactCost) -> f64| self.impacts.iter().map(|impact| get(&impact.price)).sum::<f64>();
        let largest = |get: fn(&ImpactCost) -> f64| self.impacts.iter().map(|i| get(&i.price)).fold(0.0, f64::max);
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
            energy_drift_over_left: largest(|p| p.energy_drift_over_left),
            momentum_drift: largest(|p| p.momentum_drift),
            angular_momentum_drift: largest(|p| p.angular_momentum_drift),
            threshold: Some(self.threshold()),
            warnings: self.warnings(),
            ..Summary::default()
        }
    }

    /// Warnings of all impacts, each kind once.
    fn warnings(&self) -> Vec<Warning> {
        let relevant: Vec<Vec<Warning>> = self.impacts.iter().map(Impact::relevant_warnings).collect();
        warning::merged("impact", (1..).zip(relevant.iter().map(Vec::as_slice)))
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
        let of = |repeats: bool, get: fn(&Impact) -> (f64, f64)| -> Vec<(f64, f64)> {
            self.impacts.iter().filter(|impact| (impact.repeat > 0) == repeats).map(get).collect()
        };
        let mut series = vec![
            Series {
                label: "settled".into(),
                points: of(false, |i| (i.q, i.outcome.largest_remnant_fraction)),
                errors: Vec::new(),
                mark: Mark::Points,
            },
            Series {
                label: "at twice the time".into(),
                points: of(false, |i| (i.q, i.outcome.later_fraction())),
                errors: Vec::new(),
                mark: Mark::Points,
            },
        ];
        if self.scatter.is_some() {
            series.push(Series {
                label: "other flaws and orientations".into(),
                points: of(true, |i| (i.q, i.outcome.largest_remnant_fraction)),
                errors: Vec::new(),
                mark: Mark::Points,
            });
        }
        if let Some(t) = &self.d {
            let law = |x: f64| (x * t.q_star, 0.5 - t.slope * (x - 1.0));
            let line = (0..=40).map(|k| law(0.5 + k as f64 / 40.0)).filter(|(_, share)| (0.1..=0.9).contains(share));
            let label = format!("Q*_D = {:.3e} ± {:.1e} J/kg", t.q_star, self.uncertainty(t));
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
                errors: vec![self.uncertainty(t)],
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

    fn print(&self, summary: &Summary, directory: &Path, is_root: bool) {
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
        if self.drift > 0.0 {
            tracing::info!("the uncertainty contains {:.1e} J/kg for the drift of energy", self.drift * t.q_star_d);
        }
        warning::log(&summary.warnings, is_root);
        tracing::info!("written to {}{}", directory.display(), warning::in_short(&summary.warnings));
    }
}

/// Standard deviation of a sample.
fn deviation(values: &[f64]) -> f64 {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    (values.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / (values.len() - 1) as f64).sqrt()
}
