//! What has become of a body, or of two that have collided: asks for it, makes its figures, table and picture.

use crate::error::Result;
use crate::kernel::SUPPORT;
use crate::outcome::Particle;
use crate::outcome::populations::{self, Populations, Question};
use crate::output::figures::curves::{Axis, Figure, Mark, Series};
use crate::output::summary::{Figures, Fragments};
use crate::scene::Scene;
use crate::simulation::run::Run;

impl<const D: usize> Run<'_, D> {
    /// The pieces as they are now, where the scene asks for them. Collective.
    pub(in crate::simulation) fn populations(&self) -> Option<Populations> {
        let settings = self.scene.fragments?;
        let constants = &self.stepper.settings.view.constants;
        let of = |body: usize| settings.bodies.contains(&self.scene.bodies[body].whole(body));
        let parts = (0..constants.len()).filter(|&body| of(body));
        let support = parts.fold(0.0, |most: f64, body| most.max(SUPPORT * constants[body].smoothing_length));
        let particles: Vec<Particle> =
            self.particles().into_iter().filter(|particle| settings.bodies.contains(&particle.body)).collect();
        let question = Question {
            bodies: settings.bodies,
            link: settings.link.unwrap_or(support),
            least_particles: settings.least_particles,
            intact: settings.intact,
        };
        Some(populations::evaluate(self.comm, &particles, &question))
    }

    /// fragment_masses.png; for one rank.
    pub(in crate::simulation) fn draw_populations(&self, populations: &Populations) -> Result<()> {
        let axis = |label: &str| Axis { label: label.into(), logarithmic: true };
        let series = |label: &str, points, mark| Series { label: label.into(), points, errors: vec![], mark };
        let points: Vec<(f64, f64)> = populations.cumulative().iter().map(|&[mass, share]| (mass, share)).collect();
        let fitted = points.get(..populations.resolved).unwrap_or_default();
        let law = |law: populations::PowerLaw| fitted.iter().map(|&(mass, _)| (mass, law.at(mass))).collect::<Vec<_>>();
        let mut all = vec![series("pieces", points.clone(), Mark::Points)];
        all.extend(populations.law.map(|found| series("power law", law(found), Mark::Dashed)));
        let (x, y) = (axis("Mass / mass of all"), axis("Share of mass in pieces up to this one"));
        let path = self.options.directory.join("fragment_masses.png");
        Figure { title: self.scene.title.clone(), x, y, series: all }.draw(&path)
    }
}

/// `fragments` of summary.json.
pub fn figures(found: &Populations, scene: &Scene) -> Fragments {
    let mut figures = Vec::new();
    let mut named = |name: &str, value: f64| figures.push((name.to_string(), value));
    let [largest, second, power_law, rest] = found.shares();
    named("total_mass", found.total);
    named("largest", largest);
    named("second_largest", second);
    named("power_law", power_law);
    named("rest", rest);
    named("resolved_pieces", found.resolved as f64);
    let of = |value: fn(&populations::PowerLaw) -> f64| found.law.as_ref().map_or(f64::NAN, value);
    named("slope", of(|law| law.slope));
    named("slope_error", of(|law| law.slope_error));
    named("slope_scatter", of(|law| law.scatter.unwrap_or(f64::NAN)));
    named("mu", of(|law| law.largest));
    named("mu_error", of(|law| law.largest_error));
    let bodies = scene.fragments.map(|settings| settings.bodies).unwrap_or_default();
    let number = if bodies[0] == bodies[1] { 1 } else { 2 };
    for (body, kept) in bodies.into_iter().zip(found.kept).take(number) {
        named(&format!("kept_by_{}", scene.bodies[body].name), kept);
    }
    Fragments { outcome: found.word.map(|word| word.to_string()), figures: Figures(figures) }
}

/// On the terminal, rank 0.
pub fn print(found: &Fragments) {
    let of = |name: &str| found.figures.0.iter().find(|(n, _)| n == name).map_or(f64::NAN, |(_, value)| *value);
    let word = found.outcome.as_ref().map_or(String::new(), |word| format!("{word}: "));
    tracing::info!(
        "{word}largest piece {:.3} of all, second {:.3}, power law {:.3} (slope {:.3} +- {:.3}), rest {:.3}",
        of("largest"),
        of("second_largest"),
        of("power_law"),
        of("slope"),
        of("slope_error"),
        of("rest")
    );
}
