//! A study before it runs: every setting at every resolution, each with its scene, all of them read and found valid.

use std::path::{Component, Path, PathBuf};

use serde::{Deserialize, Serialize};
use toml::Table;

use super::combine::combined;
use super::measure::Against;
use super::settings::{Change, Settings};
use crate::error::{Error, Result};
use crate::scene::answer::identity;
use crate::scene::source::{Document, SourceText};
use crate::scene::{self, Scene};
use crate::simulation::require;

/// Texts of a study and of its scene. Read by one rank; the result is the same on all.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Sources {
    pub study: SourceText,
    pub scene: SourceText,
}

/// Pictures of each run would cost as much as small runs themselves.
const NO_PICTURES: &str = "output.picture=false";
/// Largest number of runs; more are a mistake.
const MOST_POINTS: usize = 10_000;

/// A study, ready to run.
#[derive(Debug, Clone)]
pub struct Study {
    pub settings: Settings,
    /// Path of the study's file.
    pub path: String,
    /// Path of the scene's file.
    pub scene_path: String,
    /// Names of the settings, in the order of their numbers.
    pub names: Vec<String>,
    /// The body whose spacing is the resolution; `None` where no spacing is varied.
    pub spacing_of: Option<String>,
    /// Setting after setting, each from coarse to fine.
    pub points: Vec<Point>,
}

/// One run.
#[derive(Debug, Clone)]
pub struct Point {
    /// From 1.
    pub number: usize,
    pub setting: usize,
    /// The setting's name without the radii of bodies: the name of a curve over the radius.
    pub family: String,
    /// What is varied, as after `--set`; `[study.set]` comes before it.
    pub overrides: Vec<String>,
    /// m
    pub spacing: f64,
    pub identity: String,
    pub scene: Scene,
}

impl Point {
    /// Its folder in that of the study.
    pub fn folder(&self) -> String {
        format!("point_{:03}", self.number)
    }
}

/// Whether a text is that of a study rather than of a scene.
pub fn is_study(source: &SourceText) -> bool {
    source.text.parse::<Table>().is_ok_and(|table| table.contains_key("study"))
}

/// Reads the file of the study's scene, too.
pub fn read(study: SourceText) -> Result<Sources> {
    let document = Document::parse(&study)?;
    let settings = Settings::read(&document)?;
    require_few(&document, &settings)?;
    let scene = without_detours(&study.folder().join(&settings.scene));
    let scene = SourceText::open(&scene, &[]).map_err(|e| {
        let what = format!("{}: {}", e.place, e.what);
        document.error("study.scene", what).allowed("the path of a scene, from the folder of the study's file")
    })?;
    drop(document);
    Ok(Sources { study, scene: scene::with_files(scene)? })
}

/// `a/b/../c` is `a/c`.
fn without_detours(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match (part, plain.components().next_back()) {
            (Component::ParentDir, Some(Component::Normal(_))) => {
                plain.pop();
            }
            _ => plain.push(part),
        }
    }
    plain
}

/// Refuses too many runs, before any of them is read.
fn require_few(document: &Document, settings: &Settings) -> Result<()> {
    let runs = settings.runs();
    if runs <= MOST_POINTS as f64 {
        return Ok(());
    }
    let shown = if runs < 1e15 { format!("{runs}") } else { format!("{runs:.1e}") };
    Err(document.error("study", format!("{shown} runs")).allowed(format!("{MOST_POINTS} and fewer")))
}

impl Study {
    /// Reads every point's scene.
    pub fn new(sources: &Sources) -> Result<Self> {
        let document = Document::parse(&sources.study)?;
        let settings = Settings::read(&document)?;
        require_few(&document, &settings)?;
        let reader = Reader { document: &document, sources, settings: &settings };
        reader.check(&reader.scene(&settings.set.iter().collect::<Vec<_>>())?)?;
        let mut study = Self {
            path: sources.study.path.clone(),
            scene_path: sources.scene.path.clone(),
            names: Vec::new(),
            spacing_of: None,
            points: Vec::new(),
            settings: settings.clone(),
        };
        for setting in combined(&settings) {
            let mut points = Vec::new();
            for level in &settings.resolution.values {
                let changes: Vec<&Change> = settings.set.iter().chain(&setting.changes).chain(level).collect();
                let varied = setting.changes.iter().chain(level).map(Change::text).collect::<Vec<_>>();
                points.push((reader.scene(&changes)?, varied));
            }
            study.add(setting.name, setting.family, points);
        }
        study.find_spacing(&document)?;
        Ok(study)
    }

    /// The point of this number.
    pub fn point(&self, number: usize) -> Result<&Point> {
        number.checked_sub(1).and_then(|k| self.points.get(k)).ok_or_else(|| {
            let what = format!("the study has no point {number}");
            Error::new(what).at("--task").allowed(format!("1 to {}", self.points.len())).bad_input()
        })
    }

    /// Adds a setting, unless it is an earlier one by another name: a value may be that of the scene.
    fn add(&mut self, name: String, family: String, points: Vec<(Scene, Vec<String>)>) {
        let identities: Vec<String> = points.iter().map(|(scene, _)| identity(scene)).collect();
        let same = |number: usize| {
            let earlier = self.points.iter().filter(|point| point.setting == number);
            earlier.map(|point| &point.identity).eq(&identities)
        };
        if (0..self.names.len()).any(same) {
            return;
        }
        for ((scene, overrides), identity) in points.into_iter().zip(identities) {
            let (number, setting) = (self.points.len() + 1, self.names.len());
            let family = family.clone();
            self.points.push(Point { number, setting, family, overrides, spacing: 0.0, identity, scene });
        }
        self.names.push(name);
    }

    /// Spacings are those of the first body that is finer at one resolution than at another.
    fn find_spacing(&mut self, document: &Document) -> Result<()> {
        let levels = self.settings.resolution.values.len();
        let first = &self.points[..levels];
        let bodies = first.iter().map(|point| point.scene.bodies.len()).min().unwrap_or(0);
        let spacing = |point: &Point, body: usize| point.scene.bodies[body].lattice.spacing;
        let varies = |body: &usize| first.iter().any(|point| spacing(point, *body) != spacing(&first[0], *body));
        let body = (0..bodies).find(varies);
        if levels > 1 && body.is_none() {
            return Err(document
                .error("study.resolution", "no body gets another spacing")
                .allowed("BODY.spacing or BODY.particles; what is no resolution goes into [study.vary]"));
        }
        self.spacing_of = body.map(|body| first[0].scene.bodies[body].name.clone());
        for point in &mut self.points {
            let body = body.unwrap_or(0).min(point.scene.bodies.len() - 1);
            point.spacing = point.scene.bodies[body].lattice.spacing;
        }
        // Points of a setting go from coarse to fine, however its list does.
        self.points.sort_by(|a, b| a.setting.cmp(&b.setting).then(b.spacing.total_cmp(&a.spacing)));
        self.points.iter_mut().enumerate().for_each(|(k, point)| point.number = k + 1);
        Ok(())
    }
}

/// Reads scenes, and places their errors in the study's file.
struct Reader<'a> {
    document: &'a Document<'a>,
    sources: &'a Sources,
    settings: &'a Settings,
}

impl Reader<'_> {
    fn scene(&self, changes: &[&Change]) -> Result<Scene> {
        let texts = changes.iter().map(|change| change.text());
        let pictures = (!self.settings.set.iter().any(|set| set.key == "output.picture")).then(|| NO_PICTURES.into());
        let overrides: Vec<String> = pictures.into_iter().chain(texts).collect();
        let scene = scene::with(&self.sources.scene, &overrides);
        scene.and_then(|scene| require(&scene).map(|()| scene)).map_err(|e| self.placed(e, changes))
    }

    /// An error that names an override is placed at the key it came from; any other is reported with its point.
    fn placed(&self, error: Error, changes: &[&Change]) -> Error {
        let set = error.place.strip_prefix("--set ");
        if let Some(change) = changes.iter().find(|change| set == Some(&change.text())) {
            let place = self.document.place(&change.path);
            let what = if error.what.contains(&change.key) || error.what.starts_with("unknown") {
                error.what.clone()
            } else {
                format!("{} = {}: {}", change.key, change.value, error.what)
            };
            return Error { what, ..error.at(place) };
        }
        if changes.is_empty() {
            return error;
        }
        let texts: Vec<String> = changes.iter().map(|change| change.text()).collect();
        Error { what: format!("{} (with {})", error.what, texts.join(", ")), ..error }
    }

    fn check(&self, base: &Scene) -> Result<()> {
        if self.settings.measure.figure.starts_with("threshold.") && base.threshold.is_none() {
            return Err(self
                .document
                .error("study", "the error of a run is not defined")
                .allowed("error = ..., or a [threshold] in the scene: then each point is a search"));
        }
        if self.settings.measure.against == Against::Exact && base.compare.is_none() {
            return Err(self
                .document
                .error("study.error", "the scene names no exact solution")
                .allowed("[compare] in the scene, or value = ..., or against = \"finest\""));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCENE: &str = "[[body]]\nname = \"ball\"\nshape = { disc = { radius = 1 } }\nmaterial = \"basalt\"\n\
        particles = 100\n[material.basalt.strength]\n[numerics]\neta = 1.4\n[run]\nuntil = 1\n";
    const HEAD: &str = "[study]\nscene = \"a.toml\"\nerror = \"energy_drift\"\nagainst = \"finest\"\n";

    fn study(text: &str) -> Result<Study> {
        let source = |path: &str, text: &str| SourceText::new(path, text, &[]);
        let scene = format!("dimension = 2\n{SCENE}");
        Study::new(&Sources { study: source("s.toml", &format!("{HEAD}{text}")), scene: source("a.toml", &scene) })
    }

    #[test]
    fn a_grid_has_every_setting_at_every_resolution() {
        let study = study(
            "[study.resolution]\nball.particles = [400, 100]\n[study.vary]\n\
             numerics.kernel = [\"cubic_spline\", \"wendland_c2\"]\nmaterial.basalt.strength = [true, false]\n",
        )
        .unwrap();
        assert_eq!(
            study.names,
            [
                "cubic_spline, strength",
                "cubic_spline, no strength",
                "wendland_c2, strength",
                "wendland_c2, no strength"
            ]
        );
        assert_eq!((study.points.len(), study.spacing_of.as_deref()), (8, Some("ball")));
        // From coarse to fine, whatever the list does.
        assert!(study.points[0].spacing > 1.9 * study.points[1].spacing);
        assert_eq!(
            study.points[3].overrides,
            ["numerics.kernel=\"cubic_spline\"", "material.basalt.strength=false", "ball.particles=400"]
        );
        assert!(
            !study.points[3].scene.materials[0].has_strength() && study.points[0].scene.materials[0].has_strength()
        );
        assert_eq!(study.points[7].number, 8);
    }

    /// Runs are counted, not listed: 28^3, and more than any memory holds.
    #[test]
    fn too_many_runs_are_refused_at_once() {
        let list = |n: usize| format!("{:?}", (0..n).map(|k| 1.0 + 1e-3 * k as f64).collect::<Vec<_>>());
        let keys = |axes: usize, n: usize| {
            (0..axes).map(|k| format!("material.basalt.m{k} = {}\n", list(n))).collect::<String>()
        };
        let started = std::time::Instant::now();
        for (axes, n, says) in [(3, 28, "21952 runs"), (10, 10, "10000000000 runs"), (20, 100, "1.0e40 runs")] {
            let error = study(&format!("[study.vary]\n{}", keys(axes, n))).err().unwrap();
            assert_eq!((error.what.as_str(), error.allowed.as_str()), (says, "10000 and fewer"));
            assert!(error.place.starts_with("s.toml:1: study"), "{error}");
        }
        assert!(started.elapsed().as_secs() < 5);
        let apart = study(&format!("combine = \"one_at_a_time\"\n[study.vary]\n{}", keys(10, 10))).err().unwrap();
        assert!(apart.what.contains("unknown"), "101 runs are few: {apart}");
    }

    #[test]
    fn a_point_that_a_run_would_refuse_is_refused() {
        let error = study(
            "[study.vary]\nball.flow.mode.shape = [\"radial\"]\nball.flow.mode.speed = [1]\n\
                           [study.set]\nmaterial.basalt.strength = false\n",
        );
        let error = error.err().unwrap().to_string();
        assert!(error.contains("flow.mode") && error.contains("strength"), "{error}");
    }

    #[test]
    fn one_at_a_time_goes_out_from_the_scene() {
        let study = study(
            "combine = \"one_at_a_time\"\n[study.vary]\nnumerics.eta = [1.2, 1.4]\nnumerics.artificial_stress = [true]\n",
        )
        .unwrap();
        // eta 1.4 is that of the scene.
        assert_eq!(study.names, ["as the scene", "eta 1.2", "artificial_stress"]);
        assert_eq!(study.points[0].scene.numerics.eta, 1.4);
    }

    #[test]
    fn what_is_wrong_with_a_point_is_placed_in_the_study() {
        for (text, place, says) in [
            ("[study.vary]\nnumerics.etaa = [1.2]\n", "s.toml:6: study.vary.numerics.etaa", "did you mean `eta`?"),
            ("[study.vary]\nnumerics.eta = [1.2, 9]\n", "s.toml:6: study.vary.numerics.eta", "9 is out of range"),
            ("[study.vary]\nball.radiuss = [1]\n", "s.toml:6: study.vary.ball.radiuss", "did you mean `radius`?"),
            ("[study.set]\nrunn.until = 3\n", "s.toml:1: study", "nothing is varied"),
            (
                "[study.set]\nrunn.until = 3\n[study.vary]\nnumerics.eta = [1]\n",
                "s.toml:6: study.set.runn",
                "did you mean `run`?",
            ),
            ("[study.resolution]\nnumerics.eta = [1, 2]\n", "s.toml:5: study.resolution", "no body gets"),
        ] {
            let error = study(text).err().unwrap_or_else(|| panic!("{text}"));
            assert!(error.place.starts_with(place) && error.what.contains(says), "{error}\n{text}");
        }
    }
}
