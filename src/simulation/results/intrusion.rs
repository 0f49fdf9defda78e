//! A body that falls into dust: follows it step by step, looks at the dust when the body is deepest (at the end of the run, where it
//! has not come to rest before), makes tables, figures and pictures of both.

use std::path::Path;

use super::centres;
use super::report;
use crate::error::Result;
use crate::material::dust::COMPACTED_VOLUME;
use crate::math::Vec3;
use crate::outcome::CentreOfMass;
use crate::outcome::filling::{Filled, Line, Marks, Of, Profile, Volumes};
use crate::outcome::intrusion::{Curve, Fall, IntrusionEvaluation, sine};
use crate::output::figures::curves::{Axis, Figure, Mark, Series};
use crate::output::summary::Figures;
use crate::scene::{IntrusionSettings, Scene};
use crate::simulation::run::Run;
use crate::simulation::state::{Intrusion, Left};
use crate::step::Stepper;
use crate::warning::Warning;

/// Names and units of the columns of history.csv.
pub const COLUMNS: [(&str, &str); 2] = [("intrusion_depth", "m"), ("intrusion_speed", "m/s")];

/// The start of a fall, where the scene asks for one. Collective.
pub fn begin<const D: usize>(scene: &Scene, stepper: &Stepper<D>) -> Option<Intrusion> {
    let settings = scene.intrusion?;
    let [centre] = centres::of([settings.body], scene, stepper, stepper.comm);
    let (x, v) = along(&settings, &centre);
    let fall = Fall::new(settings.gravity, settings.lowest - settings.surface, x, v, stepper.state.time);
    Some(Intrusion { fall, left: None })
}

/// Where a centre is along the fall, m, and how fast, m/s.
fn along(settings: &IntrusionSettings, centre: &CentreOfMass) -> (f64, f64) {
    (settings.sign * centre.position[settings.axis], settings.sign * centre.velocity[settings.axis])
}

impl<const D: usize> Run<'_, D> {
    /// Follows the fall by one step, until the body is deepest. Collective.
    pub(in crate::simulation) fn follow_fall(&mut self) -> Result<()> {
        let Some(settings) = self.scene.intrusion.filter(|_| !self.is_deepest()) else { return Ok(()) };
        let [centre] = centres::of([settings.body], self.scene, &self.stepper, self.comm);
        let (x, v) = along(&settings, &centre);
        let time = self.stepper.state.time;
        if !self.state.intrusion.as_mut().is_some_and(|intrusion| intrusion.fall.update(time, x, v)) {
            return Ok(());
        }
        tracing::info!("`{}` is deepest at t = {time:.4e} s", self.scene.bodies[settings.body].name);
        self.take_intrusion();
        if self.is_over() { Ok(()) } else { self.write_products() }
    }

    /// Whether the body has come to rest.
    pub(in crate::simulation) fn is_deepest(&self) -> bool {
        self.state.intrusion.as_ref().is_some_and(|intrusion| intrusion.fall.deepest.is_some())
    }

    /// Whether the run has ended where the body was deepest, or before: what its end shows is what was asked for.
    pub(in crate::simulation) fn ends_deepest(&self) -> bool {
        self.scene.intrusion.is_some_and(|intrusion| intrusion.ends_run || !self.is_deepest())
    }

    /// The cells of history.csv. Collective where the scene asks for an intrusion.
    pub(in crate::simulation) fn fall_row(&self) -> Vec<f64> {
        let (Some(settings), Some(intrusion)) = (self.scene.intrusion, &self.state.intrusion) else {
            return Vec::new();
        };
        let [centre] = centres::of([settings.body], self.scene, &self.stepper, self.comm);
        let (x, v) = along(&settings, &centre);
        vec![intrusion.fall.depth(x), v]
    }

    /// Looks at the dust as it is now. Collective.
    pub(in crate::simulation) fn take_intrusion(&mut self) {
        let (Some(settings), Some(intrusion)) = (self.scene.intrusion, self.state.intrusion.take()) else { return };
        let (scene, comm) = (self.scene, self.comm);
        let body = &scene.bodies[settings.body];
        let [centre] = centres::of([settings.body], scene, &self.stepper, comm);
        let line = line(scene, &settings, centre.position);
        let profile = Profile::measure(comm, self.filled(&settings), &line);
        let volumes = Volumes::measure(comm, self.filled(&settings), body.whole_mass() / body.density);
        let marks = Marks::of(&profile, line.depth(&centre.position));
        let totals = self.stepper.totals();
        let diagnostics = self.stepper.settings.effects.iter().flat_map(|effect| effect.diagnostics());
        let compacted = diagnostics.zip(&totals.effects).find(|(diagnostic, _)| diagnostic.name == COMPACTED_VOLUME);
        let left = Left {
            time: self.stepper.state.time,
            marks,
            compacted_volume: compacted.map_or(0.0, |(_, volume)| *volume),
            of_one_body: volumes.of_one_body(),
        };
        let curve = intrusion.fall.curve();
        self.state.intrusion = Some(Intrusion { left: Some(left), ..intrusion });
        let tables = [
            ("intrusion.csv", curve.as_ref().map(Curve::table)),
            ("filling_profile.csv", Some(profile.table())),
            ("filling_volumes.csv", Some(volumes.table())),
        ];
        let tables = tables.into_iter().filter_map(|(name, text)| Some((name, text?.into_bytes())));
        self.products.tables.extend(tables);
        self.products.intrusion = Some(IntrusionEvaluation { curve, profile, volumes, marks });
    }

    /// This rank's particles, as profiles see them.
    fn filled(&self, settings: &IntrusionSettings) -> impl Iterator<Item = Filled> {
        let (scene, columns, view) = (self.scene, &self.stepper.columns, &self.stepper.settings.view);
        let laws: Vec<_> = scene.bodies.iter().map(|body| scene.materials[body.material].dust()).collect();
        let settings = *settings;
        (0..columns.len()).map(move |i| {
            let part = columns.get(view.core.id, i).body();
            let density = columns.get(view.core.density.value, i);
            Filled {
                position: columns.get(view.core.position, i),
                volume: view.constants[part].particle_mass / density,
                filling_factor: laws[part].as_ref().map_or(1.0, |law| law.filling_factor(density)),
                smoothing_length: view.smoothing_length(columns, i, part),
                of: match scene.bodies[part].whole(part) {
                    body if body == settings.body => Of::Body,
                    body if body == settings.into => Of::Dust,
                    _ => Of::Other,
                },
            }
        })
    }

    /// Pictures of the curve, the profile and the volumes; for one rank.
    pub(in crate::simulation) fn draw_intrusion(&self, evaluation: &IntrusionEvaluation) -> Result<()> {
        let drawer = Drawer { title: &self.scene.title, directory: &self.options.directory };
        drawer.draw_curve(evaluation).and(drawer.draw_profile(evaluation)).and(drawer.draw_volumes(evaluation))
    }

    /// deepest.png: the plane of the fall at this moment. Collective.
    pub(in crate::simulation) fn draw_deepest(&self) -> Result<()> {
        let source = report::PictureSource {
            scene: self.scene,
            stepper: &self.stepper,
            time: self.stepper.state.time,
            path: &self.options.directory.join("deepest.png"),
        };
        report::draw_cut(&source, self.comm)
    }
}

/// The line of the fall through the body's centre: from above the body to the far end of the dust.
fn line(scene: &Scene, settings: &IntrusionSettings, through: Vec3) -> Line {
    let height = |body: usize| {
        let body = &scene.bodies[body];
        2.0 * body.shape.bounds(body.dimension).half[settings.axis]
    };
    Line {
        through,
        axis: settings.axis,
        sign: settings.sign,
        surface: settings.surface,
        ends: [-2.0 * height(settings.body), height(settings.into)],
        spacing: scene.bodies[settings.into].lattice.spacing,
        kernel: scene.numerics.kernel,
        dimension: scene.dimension,
    }
}

/// `intrusion` of summary.json.
pub fn figures(intrusion: &Intrusion, scene: &Scene) -> Figures {
    let (fall, left) = (&intrusion.fall, intrusion.left.unwrap_or_default());
    let volume = scene.intrusion.map_or(f64::NAN, |settings| {
        let body = &scene.bodies[settings.body];
        body.whole_mass() / body.density
    });
    let known = |value: Option<f64>| value.unwrap_or(f64::NAN);
    let curve = fall.curve();
    let figures = [
        ("time", left.time),
        ("contact_time", known(fall.contact.map(|at| at.time))),
        ("contact_speed", known(fall.contact.map(|at| at.speed))),
        ("stopping_time", known(curve.as_ref().map(|curve| curve.stopping_time))),
        ("depth", fall.deepest.unwrap_or(fall.last).depth),
        ("peak_depth", known(left.marks.peak_depth)),
        ("peak_filling_factor", known(left.marks.peak)),
        ("gap_depth", known(left.marks.gap_depth)),
        ("gap_filling_factor", known(left.marks.gap)),
        ("sine_deviation", known(curve.as_ref().map(Curve::deviation))),
        ("compacted_volume", left.compacted_volume),
        ("compacted_over_body", left.compacted_volume / volume),
        ("filling_factor_of_body_volume", known(left.of_one_body)),
    ];
    Figures(figures.map(|(name, value)| (name.to_string(), value)).to_vec())
}

/// A body that has not come to rest.
pub fn warning(intrusion: &Intrusion, scene: &Scene) -> Option<Warning> {
    let (settings, fall) = (scene.intrusion?, &intrusion.fall);
    let [body, into] = [settings.body, settings.into].map(|body| &scene.bodies[body].name);
    let what = match (fall.contact, fall.deepest) {
        (_, Some(_)) => return None,
        (None, None) => format!("`{body}` has not touched `{into}`"),
        (Some(_), None) => format!("`{body}` has not come to rest in `{into}`: depths are those of the end"),
    };
    Some(Warning::new("intrusion", format!("{what} (change: a later run.until)")))
}

/// The fall on the terminal, rank 0.
pub fn print(intrusion: &Figures) {
    let of = |name: &str| intrusion.0.iter().find(|(n, _)| n == name).map_or(f64::NAN, |(_, value)| *value);
    let millimetres = |name: &str| 1e3 * of(name);
    if of("stopping_time").is_nan() {
        tracing::info!("intrusion {:.4} mm; it has not come to rest", millimetres("depth"));
        return;
    }
    tracing::info!(
        "intrusion {:.4} mm (peak of the filling factor {:.4} mm, gap {:.4} mm) after {:.4e} s; {:.3} from a sine",
        millimetres("depth"),
        millimetres("peak_depth"),
        millimetres("gap_depth"),
        of("stopping_time"),
        of("sine_deviation")
    );
}

/// Where and under which title figures are drawn.
struct Drawer<'a> {
    title: &'a str,
    directory: &'a Path,
}

fn axis(label: &str) -> Axis {
    Axis { label: label.into(), logarithmic: false }
}

fn series(label: &str, points: Vec<(f64, f64)>, mark: Mark) -> Series {
    Series { label: label.into(), points, errors: vec![], mark }
}

impl Drawer<'_> {
    fn draw(&self, name: &str, [x, y]: [Axis; 2], series: Vec<Series>) -> Result<()> {
        Figure { title: self.title.into(), x, y, series }.draw(&self.directory.join(name))
    }

    fn draw_curve(&self, evaluation: &IntrusionEvaluation) -> Result<()> {
        let Some(curve) = &evaluation.curve else { return Ok(()) };
        let fall = curve.normalised.iter().map(|&[t, h]| (t, h)).collect();
        let ideal = (0..=100).map(|k| 0.01 * f64::from(k)).map(|t| (t, sine(t))).collect();
        let axes = [axis("Time since contact / stopping time"), axis("Height of the lowest point / intrusion")];
        self.draw("intrusion.png", axes, vec![series("fall", fall, Mark::Line), series("sine", ideal, Mark::Dashed)])
    }

    fn draw_profile(&self, evaluation: &IntrusionEvaluation) -> Result<()> {
        let (rows, marks) = (&evaluation.profile.rows, &evaluation.marks);
        let dust = rows.iter().map(|row| (1e3 * row.depth, row.dust)).collect();
        let all = rows.iter().map(|row| (1e3 * row.depth, row.all)).collect();
        let found = [marks.peak_depth.zip(marks.peak), marks.gap_depth.zip(marks.gap)];
        let found = found.into_iter().flatten().map(|(depth, phi)| (1e3 * depth, phi)).collect();
        let lines = vec![
            series("dust", dust, Mark::Line),
            series("with the body", all, Mark::Dashed),
            series("peak and gap", found, Mark::Points),
        ];
        self.draw("filling_profile.png", [axis("Depth [mm]"), axis("Filling factor")], lines)
    }

    fn draw_volumes(&self, evaluation: &IntrusionEvaluation) -> Result<()> {
        let volumes = evaluation.volumes.rows.iter().map(|&[phi, volume]| (phi, volume)).collect();
        let volume = Axis { logarithmic: true, ..axis("Volume filled more / volume of the body") };
        self.draw("filling_volumes.png", [axis("Filling factor"), volume], vec![series("", volumes, Mark::Line)])
    }
}
