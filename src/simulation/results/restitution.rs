//! A body that hits another: follows the speed of their centres of mass, makes the coefficient of restitution, its table and its picture.

use std::path::Path;

use super::centres;
use crate::error::Result;
use crate::math::Vec3;
use crate::outcome::restitution::Bounce;
use crate::output::figures::curves::{Axis, Figure, Mark, Series};
use crate::output::summary::Figures;
use crate::scene::{RestitutionSettings, Scene};
use crate::simulation::run::Run;
use crate::step::Stepper;
use crate::warning::Warning;

/// Name and unit of the column of history.csv.
pub const COLUMN: (&str, &str) = ("approach_speed", "m/s");

/// The start of a bounce, where the scene asks for one. Collective.
pub fn begin<const D: usize>(scene: &Scene, stepper: &Stepper<D>) -> Option<Bounce> {
    let settings = scene.restitution?;
    Some(Bounce::new(velocity(&settings, scene, stepper).into(), stepper.state.time))
}

/// Of the body relative to the other, m/s. Collective.
fn velocity<const D: usize>(settings: &RestitutionSettings, scene: &Scene, stepper: &Stepper<D>) -> Vec3 {
    let [body, against] = centres::of([settings.body, settings.against], scene, stepper, stepper.comm);
    body.velocity - against.velocity
}

impl<const D: usize> Run<'_, D> {
    /// Notes the speed, for a row of the history. Collective.
    pub(in crate::simulation) fn follow_bounce(&mut self) {
        let (Some(settings), Some(bounce)) = (self.scene.restitution, &mut self.state.bounce) else { return };
        let velocity = velocity(&settings, self.scene, &self.stepper);
        bounce.update(velocity.into(), self.stepper.state.time);
    }

    /// restitution.png; for one rank.
    pub(in crate::simulation) fn draw_bounce(&self) -> Result<()> {
        let Some(bounce) = &self.state.bounce else { return Ok(()) };
        let axis = |label: &str| Axis { label: label.into(), logarithmic: false };
        let points = bounce.points();
        let series = Series { label: String::new(), points, errors: vec![], mark: Mark::Line };
        let (x, y) = (axis("Time [s]"), axis("Speed of approach [m/s]"));
        let path: &Path = &self.options.directory.join("restitution.png");
        Figure { title: self.scene.title.clone(), x, y, series: vec![series] }.draw(path)
    }
}

/// `restitution` of summary.json.
pub fn figures(bounce: &Bounce) -> Figures {
    let [begin, end] = bounce.contact().unwrap_or([f64::NAN; 2]);
    let figures = [
        ("coefficient", bounce.coefficient()),
        ("energy_loss", bounce.loss()),
        ("speed_before", bounce.before()),
        ("speed_after", -bounce.after()),
        ("contact_begin", begin),
        ("contact_end", end),
    ];
    Figures(figures.map(|(name, value)| (name.to_string(), value)).to_vec())
}

/// The bounce on the terminal, rank 0.
pub fn print(restitution: &Figures) {
    let of = |name: &str| restitution.0.iter().find(|(n, _)| n == name).map_or(f64::NAN, |(_, value)| *value);
    tracing::info!(
        "coefficient of restitution {:.4}: {:.4} of the energy is lost",
        of("coefficient"),
        of("energy_loss")
    );
}

/// Beyond this coefficient of restitution energy has come from nowhere.
const MOST: f64 = 1.01;

/// Bodies that are not done with each other, or part faster than they met.
pub fn warning(bounce: &Bounce, scene: &Scene) -> Option<Warning> {
    let [body, against] = scene.restitution.map(|r| [r.body, r.against].map(|body| &scene.bodies[body].name))?;
    let what = match (bounce.contact(), bounce.is_going_on()) {
        (None, _) => format!("`{body}` has not touched `{against}`"),
        (_, true) => format!(
            "`{body}` and `{against}` still push or pull each other: the coefficient of restitution is of no bounce"
        ),
        _ if bounce.coefficient() > MOST => {
            let what = format!(
                "`{body}` and `{against}` part {:.3} times as fast as they met: steps do not resolve their contact (change: a smaller \
                 numerics.cfl, a start farther apart)",
                bounce.coefficient()
            );
            return Some(Warning::new("restitution", what));
        }
        _ if bounce.coefficient() < 0.0 => {
            let what = format!(
                "`{body}` goes on in the direction in which it has approached `{against}`: an oblique hit, or they stick"
            );
            return Some(Warning::new("restitution", what));
        }
        _ => return None,
    };
    Some(Warning::new("restitution", format!("{what} (change: a later run.until)")))
}
