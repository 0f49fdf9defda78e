//! When the gravity of the particles on each other is evaluated, and how it overlaps with the sums over pairs. Integrators are not
//! involved: it is due by the age of its last evaluation, at the first stage of a step.

use std::time::Instant;

use super::Stepper;
use super::phases::Phase;
use super::settings::Moment;
use crate::gravity::Matter;
use crate::gravity::attraction::Evaluation;
use crate::particles::Columns;

/// Pairs are summed while gravity is evaluated where it is kept for this many steps at least: it then counts from the next evaluation
/// on.
const STEPS_TO_OVERLAP: f64 = 8.0;

impl<'c, const D: usize> Stepper<'c, D> {
    /// Begins an evaluation at the first stage of a step, where one is due; returns it if other work may overlap with it.
    /// Collective.
    pub(super) fn begin_gravity(&mut self, moment: &Moment) -> Option<Evaluation<'c>> {
        let own = self.settings.gravity.and_then(|gravity| gravity.own).filter(|_| moment.stage == 0)?;
        let (timing, dt) = (&mut self.state.gravity, moment.since);
        timing.age = timing.age.map(|age| age + dt);
        if !own.is_due(timing, dt) {
            return None;
        }
        self.counters.gravity_evaluations += 1;
        let (start, first, lasts) = (Instant::now(), timing.age.is_none(), own.lasts(timing));
        let view = &self.settings.view;
        let mass_and_softening = |columns: &Columns, i: usize| {
            let body = columns.get(view.core.id, i).body();
            (view.constants[body].particle_mass, view.smoothing_length(columns, i, body))
        };
        let matter = Matter { id: view.core.id, position: view.core.position, mass_and_softening: &mass_and_softening };
        let evaluation = own.evaluation(&self.columns, &matter, first, self.comm);
        self.phases.add(Phase::Gravity, start);
        // A field that counts a step later must not be much older for it; until then the previous field is extrapolated.
        if !first && lasts >= STEPS_TO_OVERLAP * dt {
            return Some(evaluation);
        }
        self.finish_gravity(evaluation);
        None
    }

    pub(super) fn finish_gravity(&mut self, evaluation: Evaluation<'c>) {
        let (start, waited) = (Instant::now(), self.comm.wait_seconds());
        let fields = evaluation.finish();
        if let Some(own) = self.settings.gravity.and_then(|gravity| gravity.own) {
            own.keep(&mut self.columns, &fields, &mut self.state.gravity);
        }
        // Waits for other ranks are not part of this rank's load.
        let waited = self.comm.wait_seconds() - waited;
        self.phases.seconds[Phase::Gravity as usize] -= waited;
        self.phases.seconds[Phase::Wait as usize] += waited;
        self.phases.add(Phase::Gravity, start);
        self.neighbourhood.poll();
    }
}
