//! Rigid bodies in a step: what acts on them is summed after an evaluation, the integrator advances them, and their particles follow.

use std::time::Instant;

use super::Stepper;
use super::phases::Phase;
use super::reduction::Reduced;
use super::settings::Moment;
use super::time_step::{Limit, acceleration};
use crate::motion::rigid::LoadSums;
use crate::particles::ParticleId;

impl<const D: usize> Stepper<'_, D> {
    /// Finds the rigid bodies of new particles, and gives these the velocities of their bodies. Collective.
    pub(super) fn weigh_rigid(&mut self) {
        if let Some(rigid) = &self.settings.rigid {
            self.state.rigid = rigid.weigh(&mut self.columns, self.comm);
            self.chunk_pass(|passes, chunk, workspace| passes.place(chunk, workspace));
        }
    }

    /// Takes the forces of an evaluation to rigid bodies, as the integrator does with rates, and their particles to where the bodies then
    /// are; their limits of the step and their errors join those of particles. The same on every rank. Collective.
    pub(super) fn take_rigid(&mut self, moment: &Moment, reduced: &mut Reduced) {
        let Some(rigid) = &self.settings.rigid else { return };
        let start = Instant::now();
        let mut sums = vec![LoadSums::default(); rigid.bodies.len()];
        self.workers.collect(|workspace| {
            for (sum, mine) in sums.as_flattened_mut().iter_mut().zip(workspace.loads.as_flattened_mut()) {
                sum.merge(mine);
                *mine = Default::default();
            }
        });
        let loads = rigid.loads(&mut sums, self.comm);
        let view = &self.settings.view;
        for ((body, load), at_start) in self.state.rigid.iter_mut().zip(loads).zip(&rigid.bodies) {
            let rates = body.rates_by(&load, &at_start.guidance, moment.time);
            body.load = load;
            let h = view.constants[body.body].smoothing_length;
            let limits = [
                (acceleration(self.settings.cfl, h, body.fastest(&rates).powi(2)), Limit::ACCELERATION),
                (at_start.guidance.longest_step(moment.time), Limit::MOTION),
            ];
            for (dt, reason) in limits {
                let (id, position) = (ParticleId::new(body.body, 0), body.motion.centre.into());
                self.limit = self.limit.tighter(Limit { dt, reason, id, position });
                reduced.limit = reduced.limit.min(dt);
            }
            let error = self.settings.integrator.take_rigid(body, &rates, moment.stage, moment.dt);
            reduced.error.merge(&error);
        }
        self.phases.add(Phase::Reduce, start);
        let start = Instant::now();
        self.chunk_pass(|passes, chunk, workspace| passes.place(chunk, workspace));
        self.phases.add(Phase::Predict, start);
    }

    /// A step where nothing limits it: rigid bodies in free flight, and nothing else. The time in which the speed of their contact takes
    /// through a smoothing length.
    pub(super) fn longest_rigid_step(&self) -> f64 {
        let h = |body: usize| self.settings.view.constants[body].smoothing_length;
        let bodies = self.settings.rigid.iter().flat_map(|rigid| &rigid.bodies);
        bodies.map(|start| h(start.body) / start.sound_speed).fold(f64::INFINITY, f64::min)
    }
}
