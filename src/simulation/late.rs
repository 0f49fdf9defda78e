//! The late stage of a run: when it begins and the effects of the switch; and the end of reaccumulation.

use super::run::Run;
use super::scales::{first_contact, free_fall_time};
use super::state::LateStart;
use crate::error::Result;
use crate::outcome::lasting::Lasting;
use crate::outcome::reaccumulated::{Reaccumulated, Remnant};
use crate::output::summary::Figures;
use crate::scene::Until;
use crate::step::{Failure, StepState};

impl<const D: usize> Run<'_, D> {
    /// When the late stage begins, s, if that is known and still to come.
    pub(super) fn late_time(&self) -> Option<f64> {
        match self.scene.late_stage.filter(|_| self.state.late.is_none())?.at {
            Until::Time(at) => Some(at),
            Until::Settled => None,
        }
    }

    /// Whether the late stage is to begin now.
    pub(super) fn is_late_now(&self) -> bool {
        let Some(stage) = self.scene.late_stage.filter(|_| self.state.late.is_none()) else { return false };
        match stage.at {
            Until::Time(at) => self.stepper.state.time >= at,
            Until::Settled => self.state.settled.as_ref().is_some_and(|settled| settled.since().is_some()),
        }
    }

    /// Begins the late stage. Collective.
    pub(super) fn go_soft(&mut self) -> std::result::Result<(), Failure> {
        let Some(late) = self.scene.late() else { return Ok(()) };
        let before = self.stepper.state.next;
        let switch = self.stepper.soften(&late)?;
        let StepState { time, step, next, .. } = self.stepper.state;
        let start = LateStart { time, step, switch, dt: [before, next] };
        self.state.conservation.shift_energy(switch.energy_jump);
        self.state.late = Some(start);
        tracing::info!(
            "late stage from t = {time:.4e} s, step {step}: steps {:.1} times as long; mean pressure {:.2e} Pa -> {:.2e} Pa, largest {:.2e} Pa -> {:.2e} Pa; \
             elastic energy {:.3e} J -> {:.3e} J, taken out of the drift",
            start.dt[1] / start.dt[0],
            switch.before.mean_pressure,
            switch.after.mean_pressure,
            switch.before.largest_pressure,
            switch.after.largest_pressure,
            switch.before.elastic_energy,
            switch.after.elastic_energy,
        );
        Ok(())
    }

    /// Evaluates the largest remnant where that is due; takes the outcome once it is known what becomes of it. Collective.
    pub(super) fn watch_remnant(&mut self) -> Result<()> {
        let time = self.stepper.state.time;
        let contact = first_contact(self.scene);
        if !self.state.lasting.get_or_insert_with(|| Lasting::new(contact)).is_due(time) {
            return Ok(());
        }
        let share = self.evaluate_outcome().outcome.largest_remnant_of_total;
        let is_over = self.state.lasting.as_mut().is_some_and(|lasting| lasting.note(time, share));
        tracing::debug!("largest remnant {share:.4} of all mass");
        if is_over { self.take_outcome() } else { Ok(()) }
    }

    /// Evaluates the largest remnant where that is due; takes the outcome once it has stopped changing. Collective.
    pub(super) fn watch_reaccumulation(&mut self) -> Result<()> {
        let time = self.stepper.state.time;
        if self.state.has_outcome() || self.state.reaccumulated.as_ref().is_some_and(|remnants| !remnants.is_due(time))
        {
            return Ok(());
        }
        let evaluation = self.evaluate_outcome();
        let remnant = Remnant::of(&evaluation, self.comm);
        let window = free_fall_time(self.scene);
        let total = evaluation.outcome.total_mass;
        let remnants = self.state.reaccumulated.get_or_insert_with(|| Reaccumulated::new(window, total));
        let is_over = remnants.note(time, remnant);
        tracing::debug!(
            "largest remnant {:.4} of all mass, inner motion {:.2e} of its binding",
            remnant.mass / total,
            remnant.kinetic / remnant.binding
        );
        if is_over {
            tracing::info!("reaccumulated at t = {time:.4e} s, step {}", self.stepper.state.step);
            self.take_outcome()?;
        }
        Ok(())
    }
}

/// The switch in figures; `scale`: the initial kinetic energy, J.
pub fn figures(start: &LateStart, scale: f64) -> Figures {
    let (switch, named) = (&start.switch, |name: &str, value: f64| (name.to_string(), value));
    Figures(vec![
        named("time", start.time),
        named("step", start.step as f64),
        named("time_step_factor", start.dt[1] / start.dt[0]),
        named("energy_jump", switch.energy_jump),
        named("energy_jump_of_initial", switch.energy_jump / scale),
        named("elastic_energy_before", switch.before.elastic_energy),
        named("elastic_energy_after", switch.after.elastic_energy),
        named("mean_pressure_before", switch.before.mean_pressure),
        named("mean_pressure_after", switch.after.mean_pressure),
        named("largest_pressure_before", switch.before.largest_pressure),
        named("largest_pressure_after", switch.after.largest_pressure),
    ])
}
