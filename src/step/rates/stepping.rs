//! The small steps within a large one, and what becomes of groups when lists change.

use std::sync::Arc;
use std::time::Instant;

use super::columns::Received;
use super::group::GroupLists;
use super::receive::receive;
use super::small_steps::{MOST_STEPS, SmallSteps};
use super::two_rates::TwoRates;
use crate::pair::Rows;
use crate::particles::chunk::Chunks;
use crate::particles::{Chunk, Columns};
use crate::step::failure::Failure;
use crate::step::neighbourhood::ListSize;
use crate::step::passes::Passes;
use crate::step::phases::Phase;
use crate::step::reduction;
use crate::step::settings::Moment;
use crate::step::stepper::Stepper;
use crate::step::workspace::Workspace;

impl<const D: usize> Stepper<'_, D> {
    /// Finds the groups in new lists; `fresh` where other particles may be near fast ones than before. Collective.
    pub(in crate::step) fn group(&mut self, fresh: bool) {
        let Some(rates) = &mut self.rates else { return };
        rates.stale |= fresh;
        let columns = &self.columns;
        let is_fast = |i: usize| columns.get(rates.columns.fast, i);
        let marks = self.neighbourhood.in_slots(is_fast, self.comm);
        let list = &self.neighbourhood.list;
        let slots = &self.neighbourhood.local().slot_of_owned;
        let rows = Rows { records: &[], offsets: &list.offsets, entries: &list.entries, slots };
        rates.group(&self.columns, &rows, &marks);
        let (entries, particles) = (rates.fast.lists.entries() as f64, rates.fast.members.len() as f64);
        let mut moves = vec![0.0; self.columns.len()];
        rates.fast.members.iter().chain(&rates.edge.members).for_each(|&i| moves[i as usize] = 1.0);
        let marks = self.neighbourhood.in_slots(|i| moves[i], self.comm);
        self.neighbourhood.choose(&marks, self.comm);
        self.neighbourhood.note_fast(ListSize { entries, particles });
    }

    /// Small steps in the last large one.
    pub(in crate::step) fn small_steps_made(&self) -> f64 {
        let small = self.rates.as_ref().map_or(0.0, |rates| rates.small);
        if small > 0.0 { (self.state.last / small).max(1.0) } else { 1.0 }
    }

    /// Passes over all particles are from now on over those that are slow.
    pub(in crate::step) fn leave_out_fast(&mut self) {
        let pieces = self.rates.as_ref().and_then(|rates| rates.slow_pieces(self.columns.len()));
        if let Some(pieces) = &pieces {
            self.buffers.all.clear();
            self.buffers.all.extend(0..pieces.len() as u32);
        }
        self.buffers.pieces = pieces;
    }

    /// Particles become fast or slow as the lists at hand have it. Collective.
    pub(in crate::step) fn adopt_groups(&mut self) {
        let Some(rates) = &mut self.rates else { return };
        rates.stale = false;
        rates.columns.adopt(&mut self.columns);
        self.group(false);
        self.sort_chunks();
    }

    /// The same at the end of a step in which lists were built: what the new edge receives at its last evaluation is found again.
    /// Collective.
    pub(in crate::step) fn regroup(&mut self) {
        if !self.rates.as_ref().is_some_and(|rates| rates.stale) {
            return;
        }
        self.adopt_groups();
        let Some(mut rates) = self.rates.take() else { return };
        rates.columns.clear(&mut self.columns);
        self.receive_at_edge(&mut rates);
        for (k, &i) in rates.edge.members.iter().enumerate() {
            rates.columns.set_received(&mut self.columns, i as usize, rates.columns.received(&rates.ahead, k));
        }
        self.rates = Some(rates);
    }

    /// The longest large step that fast particles can follow, s.
    pub(in crate::step) fn longest_by_fast(&self) -> f64 {
        let most = self.rates.as_ref().map_or(1, |rates| rates.steps.unwrap_or(MOST_STEPS));
        self.state.small.map_or(f64::INFINITY, |small| small * f64::from(most))
    }

    /// Makes all small steps of a large one of `dt` seconds but the last. Collective.
    pub(in crate::step) fn make_small_steps(&mut self, dt: f64) -> Result<(), Failure> {
        let Some(mut rates) = self.rates.take() else { return Ok(()) };
        let made = self.small_steps(&mut rates, dt);
        self.rates = Some(rates);
        made
    }

    fn small_steps(&mut self, rates: &mut TwoRates, dt: f64) -> Result<(), Failure> {
        let mut steps = SmallSteps::new(dt, self.state.small.unwrap_or(f64::INFINITY), rates.steps);
        rates.begin(&self.columns, dt, steps.length);
        while steps.left() > 1 {
            let length = steps.length;
            let elapsed = steps.advance();
            let (time, since) = (self.state.time + elapsed, length);
            let moment =
                Moment { time, dt: length, since, gravity_age: 0.0, step: self.coming(), stage: 0, last: true };
            self.predict_small(rates, &moment, elapsed)?;
            self.exchange_small(rates, &moment, elapsed);
            let limit = self.evaluate_small(rates, &moment)?;
            steps.shorten(limit);
            rates.receive(0.5 * (length + steps.length));
        }
        rates.hand_over(&mut self.columns, steps.length);
        Ok(())
    }

    /// Moves fast particles by a small step, and looks where the edge is then. Collective.
    fn predict_small(&mut self, rates: &mut TwoRates, moment: &Moment, elapsed: f64) -> Result<(), Failure> {
        let start = Instant::now();
        let TwoRates { fast, edge, ahead, .. } = rates;
        self.pass_over(&mut fast.columns, &fast.lists, |passes, chunk, workspace| {
            passes.advance(chunk, moment, 1.0, workspace);
        });
        ahead.copy_all(&edge.columns);
        self.pass_over(ahead, &edge.lists, |passes, chunk, workspace| passes.foresee(chunk, elapsed, workspace));
        self.phases.add(Phase::Predict, start);
        let (found, start) = (self.collect(), Instant::now());
        let finite = reduction::before_evaluation(&found, 0.0, self.coming(), self.comm);
        self.phases.add(Phase::Reduce, start);
        finite.map(drop)
    }

    /// Packs records of fast particles and of the edge and brings them to other ranks. Collective.
    fn exchange_small(&mut self, rates: &TwoRates, moment: &Moment, elapsed: f64) {
        let start = Instant::now();
        self.pack_group(&rates.fast.columns, &rates.fast.lists, moment.since);
        self.pack_group(&rates.ahead, &rates.edge.lists, elapsed);
        self.phases.add(Phase::Pack, start);
        let start = Instant::now();
        let stride = self.settings.pair_loop.layout().stride();
        let records = bytemuck::cast_slice_mut(&mut self.buffers.records);
        self.neighbourhood.exchange_chosen(records, stride, self.comm);
        self.phases.add(Phase::Wait, start);
    }

    /// Rates of fast particles, which the integrator takes, and what the edge receives; returns the longest small step. Collective.
    fn evaluate_small(&mut self, rates: &mut TwoRates, moment: &Moment) -> Result<f64, Failure> {
        let start = Instant::now();
        self.evaluate_groups(rates, moment);
        let found = self.collect();
        self.counters.pairs += found.pairs;
        self.counters.updates += rates.fast.members.len() as u64;
        self.counters.small_steps += 1;
        self.phases.add(Phase::Pairs, start);
        let start = Instant::now();
        let reduced = reduction::after_evaluation::<D>(&found, 0, 0, self.coming(), self.comm);
        self.phases.add(Phase::Reduce, start);
        reduced.map(|reduced| reduced.limit)
    }

    /// Moves fast particles by the last small step, and back among the others.
    pub(in crate::step) fn move_fast(&mut self, moment: &Moment) {
        let Some(mut rates) = self.rates.take() else { return };
        let moment = rates.last_of(moment);
        let fast = &mut rates.fast;
        self.pass_over(&mut fast.columns, &fast.lists, |passes, chunk, workspace| {
            passes.advance(chunk, &moment, 1.0, workspace);
        });
        fast.columns.write_back(&mut self.columns, &fast.members);
        self.rates = Some(rates);
    }

    /// Packs the records of fast particles at the end of a large step.
    pub(in crate::step) fn pack_fast(&mut self, moment: &Moment) {
        let Some(rates) = self.rates.take() else { return };
        self.pack_group(&rates.fast.columns, &rates.fast.lists, rates.last_of(moment).since);
        self.rates = Some(rates);
    }

    /// Rates of fast particles at the end of a large step, which the integrator takes; the edge gets what it has received. Returns the
    /// longest small step by the particles of this rank, s.
    pub(in crate::step) fn evaluate_fast(&mut self, moment: &Moment) -> Option<f64> {
        let mut rates = self.rates.take()?;
        let last = rates.last_of(moment);
        self.evaluate_groups(&mut rates, &last);
        self.counters.small_steps += u64::from(moment.dt > 0.0);
        rates.fast.columns.write_back(&mut self.columns, &rates.fast.members);
        self.close(&rates, moment.dt);
        let found = self.collect();
        self.counters.pairs += found.pairs;
        let (slow, small) = (self.found.limit, found.limit.dt);
        self.found.merge(found);
        self.found.limit = slow;
        self.rates = Some(rates);
        Some(small)
    }

    /// The longest small step of all ranks. Collective.
    pub(in crate::step) fn note_small(&mut self, small: Option<f64>) {
        if let Some(small) = small {
            let mut least = [small];
            self.comm.all_min(&mut least);
            self.state.small = least[0].is_finite().then_some(least[0]);
        }
    }

    /// Gives the edge what it has received in a step of `dt` seconds beside what the corrector gave it, and keeps what it receives at the end.
    fn close(&mut self, rates: &TwoRates, dt: f64) {
        let keeper = &rates.columns;
        let over = 0.5 * (rates.small.min(dt) - dt);
        let give = |stepper: &mut Self, i: usize| {
            let so_far = keeper.received(&stepper.columns, i);
            if so_far != Received::default() {
                stepper.give(i, so_far);
                keeper.set_received(&mut stepper.columns, i, Received::default());
            }
        };
        // Who has come or gone with new lists has what it received in its columns.
        if rates.stale {
            (0..self.columns.len()).for_each(|i| give(self, i));
        } else {
            rates.edge.members.iter().for_each(|&i| give(self, i as usize));
        }
        for (k, &i) in rates.edge.members.iter().enumerate() {
            let now = keeper.received(&rates.ahead, k);
            self.give(i as usize, now.times(over));
            keeper.set_received(&mut self.columns, i as usize, now);
        }
    }

    fn give(&mut self, i: usize, received: Received) {
        let core = &self.settings.view.core;
        if let Some(motions) = &self.settings.motions {
            let body = self.columns.get(core.id, i).body();
            motions.push(&mut self.columns, core.velocity, i, body, received.motion);
        } else {
            let v = self.columns.get(core.velocity, i);
            self.columns.set(core.velocity, i, v + received.motion);
        }
        if let Some(energy) = self.internal_energy {
            self.columns.set(energy, i, self.columns.get(energy, i) + received.heat);
        }
    }

    /// Rates of fast particles from the records at hand, which the integrator takes, and what the edge receives.
    fn evaluate_groups(&mut self, rates: &mut TwoRates, moment: &Moment) {
        let lines = std::mem::take(&mut self.buffers.records);
        let records = bytemuck::cast_slice(&lines);
        let fast = &mut rates.fast;
        let rows = fast.lists.rows(records);
        self.pass_over(&mut fast.columns, &fast.lists, |passes, chunk, workspace| {
            passes.evaluate(chunk, &rows, moment, workspace);
        });
        self.buffers.records = lines;
        self.receive_at_edge(rates);
    }

    fn receive_at_edge(&mut self, rates: &mut TwoRates) {
        let lines = std::mem::take(&mut self.buffers.records);
        let TwoRates { edge, ahead, columns, .. } = rates;
        let rows = edge.lists.rows(bytemuck::cast_slice(&lines));
        self.pass_over(ahead, &edge.lists, |passes, chunk, workspace| {
            receive(passes.settings, chunk, &rows, columns, workspace);
        });
        self.buffers.records = lines;
    }

    fn pack_group(&mut self, columns: &Columns, lists: &GroupLists, since: f64) {
        let records = self.buffers.writer();
        let packer = &self.settings.packer;
        self.workers.each(&lists.stretches, |stretch, _| {
            // SAFETY: members of a group are particles of this rank, each with a record of its own.
            unsafe { packer.pack(columns, lists.range(stretch), since, &lists.slots, records.start()) };
        });
    }

    /// Works on the members of a group.
    fn pass_over(
        &mut self,
        columns: &mut Columns,
        lists: &GroupLists,
        work: impl Fn(&Passes, &Chunk, &mut Workspace) + Sync,
    ) {
        let registry = Arc::clone(&columns.registry);
        let owners = self.neighbourhood.owners();
        let passes = Passes { settings: &self.settings, registry: &registry, rigid: &self.state.rigid, owners };
        let chunks = Chunks::new(columns, std::mem::take(&mut self.pointers));
        self.workers.each(&lists.stretches, |stretch, workspace| {
            // SAFETY: each stretch is worked on once per pass, and stretches do not overlap.
            let chunk = unsafe { chunks.chunk(lists.range(stretch)) };
            work(&passes, &chunk, workspace);
        });
        self.pointers = chunks.into_pointers();
    }
}
