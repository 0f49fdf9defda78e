//! Matter that should rest under its own weight.
//!
//! ```text
//! speed          sqrt(sum m v^2 / sum m) / v_ff      now, over particles without prescribed motion
//! speed_largest  the largest of it, once nothing damps motion any more and `after` has passed
//! pressure       mean by volume in one of ten stretches of depth, less the exact one: the worst, over the exact one at the bottom
//! pressure_rms   root mean square of the errors of single particles
//! ```
//! v_ff is the speed of free fall, sqrt(G M / R) of a ball under its own gravity (M all mass, R the largest body's radius) and
//! sqrt(g H) under uniform gravity (H the height of the tallest body). The exact pressure is 2/3 pi G rho^2 (R^2 - r^2) in a ball, and
//! rho g s in ground without sides; there it is that on planes along the face, P - S_nn, which must bear the weight whatever the
//! others are. Piles have none that is known, and only speeds.

use super::pictures::Pictures;
use crate::domain::comm::Comm;
use crate::error::Result;
use crate::gravity::G;
use crate::material::strength::DEVIATORIC_STRESS;
use crate::math::{Deviator, ExactSum, Vec3};
use crate::motion::{Motions, PrescribedMotion};
use crate::output::figures::curves::{Axis, Figure, Mark, Series};
use crate::output::on_root;
use crate::output::summary::Figures;
use crate::scene::{Body, BodyShape, InitialState, Scene};
use crate::step::Stepper;

/// Stretches of depth.
const STRETCHES: usize = 10;

/// The equilibrium that matter should keep.
pub struct Rest {
    /// v_ff, m/s.
    pub fall: f64,
    /// Motion counts from this time on, s.
    settled: f64,
    field: Option<Field>,
}

/// Pressures that are known.
enum Field {
    /// Centre, radius, m, and pressure at the centre, Pa.
    Ball { centre: Vec3, radius: f64, most: f64 },
    /// Axis across the face, its height, thickness, m, and pressure at the bottom, Pa.
    Ground { up: usize, face: f64, thickness: f64, most: f64 },
}

impl Rest {
    /// `None` for a scene without gravity. `after`: when motion begins to count, s.
    pub fn new(scene: &Scene, after: f64) -> Option<Self> {
        let up = scene.dimension - 1;
        let free = || scene.bodies.iter().filter(|body| !matches!(body.motion, PrescribedMotion::Prescribed(_)));
        let fall = match (scene.gravity.own, scene.gravity.uniform) {
            (Some(_), _) => {
                let radius = free().map(|body| body.shape.outer_radius()).fold(0.0, f64::max);
                (G * free().map(Body::mass).sum::<f64>() / radius).sqrt()
            }
            (None, Some(uniform)) => {
                let height = free().map(|body| 2.0 * body.shape.bounds(body.dimension).half[up]).fold(0.0, f64::max);
                (Vec3::from(uniform).norm() * height).sqrt()
            }
            (None, None) => return None,
        };
        let motions = scene.bodies.iter().map(|body| body.motion).chain(scene.layers.iter().map(|layer| layer.motion));
        let ends = motions.filter_map(|motion| match motion {
            PrescribedMotion::Damped { until, .. } => Some(until.unwrap_or(f64::INFINITY)),
            _ => None,
        });
        let field = match &scene.bodies[..] {
            [body] if body.start == InitialState::Hydrostatic => Some(Field::of(body, scene)),
            _ => None,
        };
        Some(Self { fall, settled: ends.fold(after, f64::max), field })
    }
}

impl Field {
    /// The pressure in a body that starts under its weight.
    fn of(body: &Body, scene: &Scene) -> Self {
        let up = body.dimension - 1;
        if let BodyShape::Box { size } = body.shape {
            let g = -scene.gravity.uniform.unwrap_or_default()[up];
            let face = body.centre[up] + 0.5 * size[up];
            return Self::Ground { up, face, thickness: size[up], most: body.density * g * size[up] };
        }
        let radius = body.shape.outer_radius();
        let most = 2.0 / 3.0 * std::f64::consts::PI * G * (body.density * radius).powi(2);
        Self::Ball { centre: Vec3::from(body.centre), radius, most }
    }

    /// Depth as a share of all, and the exact pressure there over the largest.
    fn at(&self, x: &Vec3) -> (f64, f64) {
        match self {
            Self::Ball { centre, radius, .. } => {
                let share = (x - centre).norm_squared().sqrt() / radius;
                (1.0 - share, 1.0 - share * share)
            }
            Self::Ground { up, face, thickness, .. } => {
                let share = (face - x[*up]) / thickness;
                (share, share)
            }
        }
    }

    fn most(&self) -> f64 {
        match self {
            Self::Ball { most, .. } | Self::Ground { most, .. } => *most,
        }
    }

    /// The stress that bears the weight, from a particle's pressure and deviator, Pa.
    fn borne(&self, pressure: f64, s: &Deviator) -> f64 {
        match self {
            Self::Ball { .. } => pressure,
            Self::Ground { up, .. } => pressure - [s.xx, s.yy, -s.xx - s.yy][*up],
        }
    }
}

/// Speed of the mean square over that of free fall. Collective.
pub fn speed<const D: usize>(rest: &Rest, stepper: &Stepper<D>, comm: &Comm) -> f64 {
    let (columns, settings) = (&stepper.columns, &stepper.settings);
    let mut sums = [ExactSum::new(), ExactSum::new()];
    for i in 0..columns.len() {
        let body = columns.get(settings.view.core.id, i).body();
        let holds = |motions: &Motions| motions.holds(columns, i, body);
        if settings.motions.as_ref().is_some_and(holds)
            || settings.rigid.as_ref().is_some_and(|rigid| rigid.holds(body))
        {
            continue;
        }
        let mass = settings.view.constants[body].particle_mass;
        sums[0].add(mass * columns.get(settings.view.core.velocity, i).norm_squared());
        sums[1].add(mass);
    }
    let sums = comm.sum_exactly(&mut sums);
    (sums[0] / sums[1]).sqrt() / rest.fall
}

/// The errors, and a figure; `samples`: time, s, and [`speed`]. Collective; all ranks give the same samples.
pub fn compare<const D: usize>(
    rest: &Rest,
    stepper: &Stepper<D>,
    samples: &[[f64; 2]],
    pictures: Option<Pictures>,
    comm: &Comm,
) -> Result<Figures> {
    let largest = samples.iter().filter(|[t, _]| *t > rest.settled).map(|[_, v]| *v).fold(f64::NAN, f64::max);
    let mut errors = vec![("speed".to_string(), speed(rest, stepper, comm)), ("speed_largest".to_string(), largest)];
    errors.extend(rest.field.iter().flat_map(|field| pressures(field, stepper, comm)));
    if let Some(pictures) = pictures {
        let draw = || draw(rest, samples, pictures);
        on_root(comm, draw)?;
    }
    Ok(Figures(errors))
}

fn pressures<const D: usize>(field: &Field, stepper: &Stepper<D>, comm: &Comm) -> Vec<(String, f64)> {
    let (columns, settings) = (&stepper.columns, &stepper.settings);
    let deviator = columns.registry.find::<Deviator>(DEVIATORIC_STRESS);
    // Per stretch: V, V (P - P exact); then over all particles: (P - P exact)^2, number.
    let mut sums = vec![ExactSum::new(); 2 * STRETCHES + 2];
    for i in 0..columns.len() {
        let (depth, exact) = field.at(&columns.get(settings.view.core.position, i));
        let s = deviator.map_or(Deviator::default(), |column| columns.get(column, i));
        let off = field.borne(columns.get(settings.view.core.pressure, i), &s) / field.most() - exact;
        let body = columns.get(settings.view.core.id, i).body();
        let volume = settings.view.constants[body].particle_mass / columns.get(settings.view.core.density.value, i);
        let stretch = ((STRETCHES as f64 * depth).max(0.0) as usize).min(STRETCHES - 1);
        sums[2 * stretch].add(volume);
        sums[2 * stretch + 1].add(volume * off);
        sums[2 * STRETCHES].add(off * off);
        sums[2 * STRETCHES + 1].add(1.0);
    }
    let sums = comm.sum_exactly(&mut sums);
    let means =
        sums[..2 * STRETCHES].chunks_exact(2).filter(|sums| sums[0] > 0.0).map(|sums| (sums[1] / sums[0]).abs());
    let rms = (sums[2 * STRETCHES] / sums[2 * STRETCHES + 1]).sqrt();
    vec![("pressure".to_string(), means.fold(0.0, f64::max)), ("pressure_rms".to_string(), rms)]
}

fn draw(rest: &Rest, samples: &[[f64; 2]], pictures: Pictures) -> Result<()> {
    let axis = |label: &str, logarithmic| Axis { label: label.into(), logarithmic };
    let points = samples.iter().filter(|[t, v]| *t > 0.0 && *v > 0.0).map(|&[t, v]| (t, v)).collect();
    let series =
        Series { label: format!("v_ff = {:.3e} m/s", rest.fall), points, errors: Vec::new(), mark: Mark::Line };
    let figure = Figure {
        title: pictures.title.to_string(),
        x: axis("time (s)", false),
        y: axis("speed of the mean square over that of free fall", true),
        series: vec![series],
    };
    figure.draw(&pictures.directory.join("compare_speed.png"))
}
