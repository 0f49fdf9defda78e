//! The largest remnant as a body: its particles, for the last snapshot, and its figures.

use std::f64::consts::PI;

use crate::material::porosity::DISTENTION;
use crate::math::{ExactSum, Vec3};
use crate::outcome::form::{Form, form};
use crate::outcome::members::members;
use crate::outcome::{Evaluation, Outcome};
use crate::scene::Scene;
use crate::simulation::run::{Members, Run};

impl<const D: usize> Run<'_, D> {
    /// Notes which particles belong to the largest remnant, and what it is like. Collective.
    pub(in crate::simulation) fn find_remnant(&mut self, evaluation: &mut Evaluation) {
        let particles = self.particles();
        let in_largest = members(self.comm, &particles, evaluation);
        if D == 3 {
            let porosity = self.porosity(&in_largest);
            evaluation.outcome.form = form(self.comm, &particles, &in_largest).map(|form| Form { porosity, ..form });
        }
        self.members = Some(Members { step: self.stepper.state.step, in_largest });
    }

    /// Share of the volume of these particles that is pores, where there are any. Collective.
    fn porosity(&self, which: &[bool]) -> Option<f64> {
        let (columns, view) = (&self.stepper.columns, &self.stepper.settings.view);
        let distention = columns.registry.find::<f64>(DISTENTION)?;
        let mut sums = [const { ExactSum::new() }; 2];
        for i in (0..columns.len()).filter(|i| which[*i]) {
            let mass = view.constants[columns.get(view.core.id, i).body()].particle_mass;
            let volume = mass / columns.get(view.core.density.value, i);
            sums[0].add(volume);
            sums[1].add(volume / columns.get(distention, i));
        }
        let sums = self.comm.sum_exactly(&mut sums);
        (sums[0] > 0.0).then(|| 1.0 - sums[1] / sums[0])
    }

    /// Angular momentum of the target about its centre of mass now, kg m^2/s; none where there is no remnant to compare it with.
    /// Collective.
    pub(in crate::simulation) fn turn_of_target(&self) -> Option<[f64; 3]> {
        let impact = self.scene.impact.as_ref().filter(|_| D == 3 && !self.scene.hits_ground())?;
        let particles = self.particles();
        let of_target: Vec<bool> = particles.iter().map(|particle| particle.body == impact.target).collect();
        form(self.comm, &particles, &of_target).map(|form| form.angular_momentum)
    }
}

/// Figures of the largest remnant as a body. `turn`: angular momentum of the target at the start, kg m^2/s.
pub fn figures(outcome: &Outcome, turn: Option<[f64; 3]>, scene: &Scene) -> Vec<(String, f64)> {
    let Some(form) = &outcome.form else { return Vec::new() };
    let named = |name: &str, value: f64| (format!("largest_remnant_{name}"), value);
    let spin = Vec3::from(form.spin);
    let mut figures: Vec<_> = ["spin_x", "spin_y", "spin_z"].iter().zip(form.spin).map(|(n, w)| named(n, w)).collect();
    figures.push(named("period", if spin.norm() > 0.0 { 2.0 * PI / spin.norm() } else { f64::NAN }));
    figures.extend(["semi_axis_a", "semi_axis_b", "semi_axis_c"].iter().zip(form.axes).map(|(n, a)| named(n, a)));
    figures.extend(form.porosity.map(|porosity| named("porosity", porosity)));
    figures.extend(turn.and_then(|turn| efficiency(form, turn, scene)));
    figures
}

/// The share of the projectile's angular momentum about the centre of the target that the remnant has got, along it (Sevecek et al.
/// 2019, A&A 629, A122); none where the impact is head-on.
fn efficiency(form: &Form, turn: [f64; 3], scene: &Scene) -> Option<(String, f64)> {
    let impact = scene.impact.as_ref()?;
    let (target, projectile) = (&scene.bodies[impact.target], &scene.bodies[impact.projectile]);
    let lever = Vec3::from(projectile.centre) - Vec3::from(target.centre);
    let velocity = Vec3::from(projectile.velocity);
    let brought = lever.cross(&velocity) * projectile.whole_mass();
    let head_on = brought.norm() <= 1e-9 * projectile.whole_mass() * lever.norm() * velocity.norm();
    let gained = Vec3::from(form.angular_momentum) - Vec3::from(turn);
    (!head_on).then(|| ("angular_momentum_efficiency".to_string(), gained.dot(&brought) / brought.norm_squared()))
}
