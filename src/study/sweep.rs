//! The runs of a study, one after another in one job, or one of them in a task of a job array.

use super::analysis::Analysis;
use super::points::{Point, Study};
use super::record::{self, Record};
use super::report;
use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::output::{Summary, agree, on_root};
use crate::process::lock::Work;
use crate::process::{directory, log};
use crate::scene::{Until, keys};
use crate::simulation::{self, Ended, Options};
use crate::threshold::search;

/// Which part of a study to run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// Every point that has no result yet, then tables and figures.
    All,
    /// One point, numbered from 1; nothing more.
    Task(usize),
    /// Tables and figures from the existing results.
    Collect,
}

/// Runs a part of the study, or continues it. Collective.
pub fn run(study: &Study, part: Part, options: &Options, comm: &Comm) -> Result<Ended> {
    let mut sweep = Sweep { study, options, comm, records: record::read(study, &options.directory, comm)? };
    match part {
        Part::Task(number) => {
            return sweep.run(study.point(number)?);
        }
        Part::All => {
            for point in &study.points {
                if sweep.run(point)? == Ended::Interrupted {
                    return Ok(Ended::Interrupted);
                }
                sweep.check_figure()?;
                // Searches take long: their table grows.
                if point.scene.threshold.is_some() {
                    sweep.report()?;
                }
            }
        }
        Part::Collect if sweep.records.iter().all(Option::is_none) => {
            let what = "no point has a result here";
            let allowed = "the folder of a study some of whose points were run (--out)";
            return Err(Error::new(what).at(options.directory.display().to_string()).allowed(allowed).bad_input());
        }
        Part::Collect => sweep.check_figure()?,
    }
    sweep.log_here()?;
    let analysis = sweep.report()?;
    report::print(&analysis, &options.directory, comm.is_root());
    // A search that finds no bracket has told something.
    let runs = study.points.iter().all(|point| point.scene.threshold.is_none());
    match runs && analysis.points.iter().all(|point| !point.failed.is_empty()) {
        true => Err(Error::new("no point of the study has a result; study.md says why each failed")
            .at(options.directory.display().to_string())),
        false => Ok(Ended::Finished),
    }
}

/// Makes the run of a point, or its search; `None` where it was interrupted. Collective.
fn make(point: &Point, options: &Options, comm: &Comm) -> Result<Option<Summary>> {
    if point.scene.threshold.is_some() {
        return match search::run(&point.scene, options, comm)? {
            Some(found) => with_threshold(found).map(Some),
            None => Ok(None),
        };
    }
    let report = simulation::run(&point.scene, options, comm)?;
    Ok((report.ended != Ended::Interrupted).then_some(report.summary))
}

/// A search may end without a bracket.
fn with_threshold(summary: Summary) -> Result<Summary> {
    match &summary.threshold {
        Some(found) if found.q_star_d.is_nan() => Err(Error::new(format!("no threshold was found: {}", found.end))),
        _ => Ok(summary),
    }
}

/// A run that `run.steps` or `run.max_time` ends has no valid result. They limit the cost of a setting whose time steps
/// are tiny.
fn to_its_end(point: &Point, summary: Summary) -> Result<Summary> {
    match point.scene.run.until {
        Until::Time(end) if summary.time < (1.0 - 1e-9) * end => {
            let what = format!("the run ended at {:.4e} s of {end:.4e} s, after {} steps", summary.time, summary.steps);
            Err(Error::new(what))
        }
        _ => Ok(summary),
    }
}

struct Sweep<'a> {
    study: &'a Study,
    options: &'a Options,
    comm: &'a Comm,
    records: Vec<Option<Record>>,
}

impl Sweep<'_> {
    /// Runs a point and records its result, unless that is known. Collective.
    fn run(&mut self, point: &Point) -> Result<Ended> {
        let (study, comm, number) = (self.study, self.comm, point.number);
        let what = format!("point {number} of {}: {}", study.points.len(), study.names[point.setting]);
        self.log_here()?;
        if self.records[number - 1].is_some() {
            tracing::info!("{what}: done before");
            return Ok(Ended::Finished);
        }
        tracing::info!("{what}, spacing {:.4e} m", point.spacing);
        let directory = self.options.directory.join(point.folder());
        let work = if point.scene.threshold.is_some() { Work::Search } else { Work::Run };
        let _lock = directory::prepare(&directory, self.options.resume, work, comm)?;
        let run = match make(point, &Options { directory, ..self.options.clone() }, comm) {
            Ok(None) => return Ok(Ended::Interrupted),
            Ok(Some(summary)) => to_its_end(point, summary),
            Err(error) => Err(error),
        };
        let record = Record::of(point, run.as_ref());
        record::write(&self.options.directory, point, &record, comm)?;
        self.log_here()?;
        match (record.figure(&study.settings.measure.figure), record.failed.as_str()) {
            (Some(figure), _) => tracing::info!("point {number}: {} = {figure:.4e}", study.settings.measure.figure),
            (None, "") => {}
            (None, failed) if comm.is_root() => tracing::warn!("point {number} failed, the study goes on: {failed}"),
            (None, _) => {}
        }
        self.records[number - 1] = Some(record);
        Ok(Ended::Finished)
    }

    /// Writes tables and figures from the existing results. Collective.
    fn report(&self) -> Result<Analysis> {
        let analysis = Analysis::new(self.study, &self.records);
        let write = || report::write(&analysis, &self.options.directory);
        on_root(self.comm, write)?;
        Ok(analysis)
    }

    /// Refuses a figure that the first finished run does not have.
    fn check_figure(&self) -> Result<()> {
        let name = &self.study.settings.measure.figure;
        let mut done = self.records.iter().flatten().filter(|record| record.failed.is_empty());
        let is_there = |record: &Record, name: &str| record.figure(name).is_some() || record.word(name).is_some();
        let missing = |record: &&Record| !is_there(record, name);
        let Some(record) = done.next().filter(missing) else { return Ok(()) };
        let table = name.split('.').next().unwrap_or_default();
        let known = record.figures.iter().map(|(key, _)| key).filter(|key| key.starts_with(table));
        let known: Vec<String> = known.map(|key| key.trim_start_matches("errors.").to_string()).collect();
        let found = name.trim_start_matches("errors.");
        let near = keys::nearest(found, &known).map_or(String::new(), |near| format!(", did you mean `{near}`?"));
        let error = Error::new(format!("runs have no figure `{found}`{near}")).allowed(known.join(", "));
        Err(error.at(format!("{}: study.error", self.study.path)).bad_input())
    }

    /// Directs messages of the study itself to its own log.
    fn log_here(&self) -> Result<()> {
        agree(self.comm, log::to_file(&self.options.directory.join("log.txt"), true, self.comm.is_root()))
    }
}
