//! Stored studies, and the setting that one of them chooses for an accuracy. Kept studies lie in
//! `inputs/studies/NAME.study.json`, copies of the study.json of a run; those in `runs/` come after them, newest first.

use std::path::{Path, PathBuf};
use std::time::SystemTime;

use toml::Table;

use super::analysis::{Analysis, Cost};
use crate::error::{Error, Result};
use crate::output::summary::Accuracy;
use crate::scene::Scene;
use crate::scene::answer::{identity, understood};
use crate::scene::identity::differences;

const KEPT: &str = "inputs/studies";
const RUNS: &str = "runs";

/// The settings of the cheapest run that had this relative error or less, for `scene` as the command line has it. For one
/// rank.
pub fn choose(scene: &Scene, accuracy: f64) -> Result<Accuracy> {
    let mut changed = Vec::new();
    let mut unable = Vec::new();
    for path in files() {
        // A file that cannot be read is not a study of this program.
        let text = std::fs::read_to_string(&path).unwrap_or_default();
        let Ok(study) = serde_json::from_str::<Analysis>(&text) else { continue };
        match same_scene(scene, &study) {
            Ok(true) => {}
            Ok(false) => continue,
            Err(difference) => {
                changed.push(format!("{}, {difference}", path.display()));
                continue;
            }
        }
        match chosen(&study, &path, accuracy) {
            Some(choice) => return Ok(choice),
            None => unable.push((path, study)),
        }
    }
    Err(refusal(scene, accuracy, &changed, &unable).bad_input())
}

/// The scene with the settings that were chosen.
pub fn apply(scene: &Scene, choice: &Accuracy) -> Result<Scene> {
    scene.reread(&choice.overrides)
}

fn chosen(study: &Analysis, path: &Path, accuracy: f64) -> Option<Accuracy> {
    if accuracy < study.measure.floor() {
        return None;
    }
    let point = study.cheapest_point(accuracy, Cost::CoreSeconds)?;
    Some(Accuracy {
        asked: accuracy,
        expected: point.error?,
        figure: study.measure.figure.clone(),
        core_seconds: point.core_seconds?,
        pair_interactions: point.pair_interactions? as u64,
        setting: study.settings[point.setting].name.clone(),
        overrides: point.overrides.clone(),
        study: path.display().to_string(),
        point: point.number,
    })
}

/// Whether the study is of this scene: with the overrides of the study's first point, both must be the same, `[study.set]`
/// included. An error that names the first difference, where the study is of a scene of that name.
fn same_scene(scene: &Scene, study: &Analysis) -> std::result::Result<bool, String> {
    let Some(first) = study.points.first() else { return Ok(false) };
    let choice = |overrides: &[String]| scene.reread(overrides);
    let same_name = Path::new(scene.path()).file_name() == Path::new(&study.scene.path).file_name();
    // Keys that scenes have had only since then have their defaults.
    let before = || -> Table {
        let now = Scene::parse(&study.scene.path, &study.scene.understood, &[]);
        now.map_or_else(|_| study.scene.understood.parse().unwrap_or_default(), |scene| understood(&scene.to_toml()))
    };
    match choice(&first.overrides) {
        Ok(there) if identity(&there) == study.scene.identity => Ok(true),
        Ok(there) if same_name => match difference(&before(), &understood(&there.to_toml())) {
            Some(difference) => Err(difference),
            None => Ok(true),
        },
        Err(error) if same_name => Err(format!("whose settings the scene no longer takes: {error}")),
        _ => Ok(false),
    }
}

/// The first key that differs, with both values.
fn difference(before: &Table, now: &Table) -> Option<String> {
    differences(before, now).first().map(|first| format!("where {first}"))
}

fn refusal(scene: &Scene, accuracy: f64, changed: &[String], unable: &[(PathBuf, Analysis)]) -> Error {
    let percent = |x: f64| format!("{:.4} %", 100.0 * x);
    let smallest = |(path, study): &(PathBuf, Analysis)| {
        let (error, point) = study
            .points
            .iter()
            .filter_map(|point| Some((stays_within(study, point.number)?, point)))
            .min_by(|a, b| a.0.total_cmp(&b.0))?;
        Some((
            error,
            format!("{} and more, by {} ({})", percent(error), study.settings[point.setting].name, path.display()),
        ))
    };
    let error = if let Some((_, best)) = unable.iter().filter_map(smallest).min_by(|a, b| a.0.total_cmp(&b.0)) {
        Error::new(format!("no setting of a study of this scene reaches {}", percent(accuracy))).allowed(best)
    } else if let Some(first) = changed.first() {
        Error::new(format!("the scene has changed since it was studied: {first}"))
            .allowed("the scene as it was, or a new study of it")
    } else {
        let what = "no study of this scene is stored, from which --accuracy could choose the setting";
        Error::new(what).allowed(format!("{KEPT}/NAME.study.json, or {RUNS}/NAME/study.json as a study writes it"))
    };
    error.at(scene.path())
}

/// The largest error of a point and of those finer than it, no less than the uncertainty of the study.
fn stays_within(study: &Analysis, number: usize) -> Option<f64> {
    let point = &study.points[number - 1];
    let finer = study.of_setting(point.setting).filter(|other| other.spacing <= point.spacing);
    point.error.map(|error| finer.filter_map(|other| other.error).fold(error.max(study.measure.floor()), f64::max))
}

/// Every file that may hold a study, in the order in which they are tried.
fn files() -> Vec<PathBuf> {
    let entries = |folder: &str| std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let mut kept: Vec<PathBuf> = entries(KEPT).filter(|path| path.to_string_lossy().ends_with(".study.json")).collect();
    kept.sort();
    let mut runs: Vec<(SystemTime, PathBuf)> = entries(RUNS)
        .map(|folder| folder.join("study.json"))
        .filter_map(|path| Some((std::fs::metadata(&path).ok()?.modified().ok()?, path)))
        .collect();
    runs.sort_by(|a, b| b.cmp(a));
    kept.into_iter().chain(runs.into_iter().map(|(_, path)| path)).collect()
}
