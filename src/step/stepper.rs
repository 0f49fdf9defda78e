//! The particles of a rank and the step that advances them: the stages of the integrator, each with its lists, its records, its
//! pairs and its reduction.

use std::ops::Range;
use std::sync::Arc;
use std::time::Instant;

use super::buffers::Buffers;
use super::diagnostics::{self, Totals};
use super::failure::Failure;
use super::integrator::Verdict;
use super::neighbourhood::{Load, Neighbourhood};
use super::passes::Passes;
use super::phases::{Phase, Phases};
use super::rates::TwoRates;
use super::reduction::{self, Reduced};
use super::settings::{Counters, Moment, StepSettings, StepState};
use super::time_step::{Limit, NamedLimit};
use super::workers::Workers;
use super::workspace::{Findings, Workspace};
use crate::domain::comm::Comm;
use crate::material::Core;
use crate::material::eos::INTERNAL_ENERGY;
use crate::motion::rigid::RigidBody;
use crate::pair::Rows;
use crate::particles::chunk::Chunks;
use crate::particles::{Chunk, Column, Columns, ParticleId};

/// Chunks between two polls of pending messages.
const CHUNKS_PER_POLL: usize = 8;
/// A step that fails is tried again with this share of its length, where the integrator may refuse steps.
const SHORTER: f64 = 0.2;
/// Share of its first length below which a step is abandoned.
const SHORTEST: f64 = 1e-9;

/// A step that was made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stepped {
    /// How long it was, s: less than requested where it was refused first.
    pub taken: f64,
    /// Largest next step, s.
    pub dt: f64,
    /// Largest of the ranks' signals: zero means nothing.
    pub signal: u32,
}

pub struct Stepper<'c, const D: usize> {
    pub comm: &'c Comm,
    pub columns: Columns,
    pub settings: StepSettings,
    pub state: StepState,
    pub workers: Workers<Workspace>,
    pub neighbourhood: Neighbourhood<D>,
    pub phases: Phases,
    pub counters: Counters,
    /// Tightest limit of this rank's particles at the last evaluation.
    pub limit: Limit,
    pub(super) internal_energy: Option<Column<f64>>,
    pub(super) buffers: Buffers,
    /// Where some bodies take smaller steps than the rest.
    pub(super) rates: Option<Box<TwoRates>>,
    pub(super) pointers: Vec<(*mut u64, usize)>,
    /// Findings of this rank in the last evaluation.
    pub(super) found: Findings,
}

impl<'c, const D: usize> Stepper<'c, D> {
    /// Takes particles, distributed in any way; [`Stepper::start`] or [`Stepper::resume`] must follow.
    pub fn new(comm: &'c Comm, columns: Columns, settings: StepSettings) -> Self {
        let rigid = settings.rigid.as_ref().map_or(0, |rigid| rigid.bodies.len());
        let workers = Workers::new(|| Workspace::new(&columns.registry, settings.effects.len(), rigid));
        let internal_energy = columns.registry.find(INTERNAL_ENERGY);
        let neighbourhood = Neighbourhood::new(&columns.registry, &settings);
        let rates = settings.two_rates.as_ref().map(|two| Box::new(TwoRates::new(&columns, two)));
        Self {
            comm,
            columns,
            settings,
            state: StepState::default(),
            workers,
            neighbourhood,
            phases: Phases::default(),
            counters: Counters::default(),
            limit: Limit::NONE,
            internal_energy,
            buffers: Buffers::default(),
            rates,
            pointers: Vec::new(),
            found: Findings::nothing(),
        }
    }

    /// New particles: initialises their effects, distributes them and evaluates once, for the first step.
    pub fn start(&mut self) -> Result<(), Failure> {
        // Smoothing lengths, on which lists are based, may be set by an effect.
        self.find_chunks();
        self.weigh_rigid();
        self.chunk_pass(|passes, chunk, workspace| passes.initialise(chunk, workspace));
        for preset in std::mem::take(&mut self.settings.presets) {
            let first = preset.first * self.columns.width(preset.column);
            self.columns.words_mut(preset.column)[first..first + preset.words.len()].copy_from_slice(&preset.words);
        }
        let found = self.collect();
        reduction::before_evaluation(&found, 0.0, 0, self.comm)?;
        self.rebuild(true);
        self.adopt_groups();
        self.evaluate_anew()
    }

    /// Resumes from particles of a checkpoint and their state: lists are based on the positions of their last build, as in the
    /// uninterrupted run.
    pub fn resume(&mut self, state: StepState) {
        self.state = state;
        self.rebuild(false);
    }

    /// Advances all particles by `dt` seconds to the time `end`, or by less where the integrator refuses that. `signal`: the
    /// request of this rank, reduced over all ranks. Where it fails, particles are left in the middle of the step on every rank,
    /// and the run can only continue from a checkpoint.
    pub fn step(&mut self, dt: f64, end: f64, signal: u32) -> Result<Stepped, Failure> {
        self.rebuild_released();
        self.state.rigid.iter_mut().for_each(RigidBody::begin);
        let stages = self.settings.integrator.stages();
        // Evaluations at the beginning of a step are valid, however long the step will be.
        let at_start = stages.iter().take_while(|&&share| share == 0.0).count();
        self.make_stages(0..at_start, dt, signal)?;
        self.make_small_steps(dt)?;
        let mut tried = dt;
        loop {
            let verdict = match self.make_stages(at_start..stages.len(), tried, signal) {
                Ok(reduced) => {
                    let reduced = reduced.expect("an integrator has stages beyond the beginning of a step");
                    match self.settings.integrator.judge(&reduced.error, reduced.speed, tried) {
                        Verdict::Accept { most } => {
                            let time = if tried == dt { end } else { self.state.time + tried };
                            return self.accept(tried, time, &reduced, most);
                        }
                        refused => refused,
                    }
                }
                Err(_) if self.settings.integrator.may_refuse() && SHORTER * tried > SHORTEST * dt => {
                    Verdict::Refuse { next: SHORTER * tried }
                }
                Err(failure) => return Err(failure),
            };
            if let Verdict::Refuse { next } = verdict {
                if next.is_nan() || next <= SHORTEST * dt {
                    let what = format!("no step is short enough for the tolerated error: {next:e} s");
                    return Err(Failure { step: self.coming(), particle: None, what });
                }
                self.counters.refused += 1;
                self.chunk_pass(|passes, chunk, _| passes.settings.integrator.set_back(chunk));
                self.state.rigid.iter_mut().for_each(RigidBody::set_back);
                tried = next;
            }
        }
    }

    /// Makes some stages of a step of `dt` seconds; returns the global values after the last of them. Collective.
    fn make_stages(&mut self, which: Range<usize>, dt: f64, signal: u32) -> Result<Option<Reduced>, Failure> {
        let stages = self.settings.integrator.stages();
        let mut reduced = None;
        for stage in which {
            let (share, last) = (stages[stage], stage + 1 == stages.len());
            let (time, since) = (self.state.time + share * dt, self.since(stage, dt));
            let moment = Moment { time, dt, since, gravity_age: 0.0, step: self.coming(), stage, last };
            self.move_to(&moment, share)?;
            reduced = Some(self.evaluate(&moment, signal)?);
        }
        Ok(reduced)
    }

    /// Accepts a step of `taken` seconds, which ends at `time`. Collective.
    fn accept(&mut self, taken: f64, time: f64, reduced: &Reduced, most: f64) -> Result<Stepped, Failure> {
        if self.settings.integrator.may_refuse() {
            self.chunk_pass(|passes, chunk, workspace| passes.commit(chunk, taken, workspace));
            reduction::before_evaluation(&self.collect(), 0.0, self.coming(), self.comm)?;
        }
        let next = self.next_step(reduced, most)?;
        let before = std::mem::take(&mut self.state);
        self.state = StepState { step: before.step + 1, time, next, last: taken, ..before };
        self.regroup();
        Ok(Stepped { taken, dt: next, signal: reduced.signal })
    }

    /// Number of the step that is being made.
    pub(super) fn coming(&self) -> u64 {
        self.state.step + 1
    }

    /// Seconds from the last evaluation at a first stage to stage `stage` of a step of `dt` seconds.
    fn since(&self, stage: usize, dt: f64) -> f64 {
        let stages = self.settings.integrator.stages();
        match stage {
            0 => (1.0 - stages[0]) * self.state.last + stages[0] * dt,
            later => (stages[later] - stages[0]) * dt,
        }
    }

    /// Moves particles to the moment of a stage, and builds their lists anew where these do not hold any more. Collective.
    fn move_to(&mut self, moment: &Moment, share: f64) -> Result<(), Failure> {
        let start = Instant::now();
        if share > 0.0 {
            let Self { state, settings, .. } = self;
            state.rigid.iter_mut().for_each(|body| settings.integrator.advance_rigid(body, moment.stage, moment.dt));
        }
        self.chunk_pass(|passes, chunk, workspace| passes.advance(chunk, moment, share, workspace));
        self.move_fast(moment);
        self.phases.add(Phase::Predict, start);
        let start = Instant::now();
        self.state.list_age += 1;
        let used = self.neighbourhood.skin_used(&self.columns, &self.settings, self.comm);
        self.phases.add(Phase::Watch, start);
        let found = self.collect();
        let start = Instant::now();
        let used = reduction::before_evaluation(&found, used, self.coming(), self.comm);
        self.phases.add(Phase::Reduce, start);
        if used? > 1.0 {
            self.rebuild(true);
        }
        Ok(())
    }

    /// Evaluates particles where they are, for the next step. Collective.
    pub(super) fn evaluate_anew(&mut self) -> Result<(), Failure> {
        let time = self.state.time;
        let moment =
            Moment { time, dt: 0.0, since: 0.0, gravity_age: 0.0, step: self.state.step, stage: 0, last: true };
        // What fails here belongs to the step before: a run that goes back must not come here again.
        let of_last_step = |failure: Failure, step: u64| Failure { step, ..failure };
        let step = self.state.step;
        let reduced = self.evaluate(&moment, 0).map_err(|failure| of_last_step(failure, step))?;
        self.state.next = self.next_step(&reduced, f64::INFINITY).map_err(|failure| of_last_step(failure, step))?;
        Ok(())
    }

    /// The next step, s: no longer than any particle allows, nor than `most`. Collective.
    fn next_step(&mut self, reduced: &Reduced, most: f64) -> Result<f64, Failure> {
        let mut dt = reduced.limit.min(most).min(self.longest_by_fast());
        if dt == f64::INFINITY {
            dt = self.longest_rigid_step();
        }
        if most < reduced.limit {
            let limit = Limit { dt, reason: Limit::ERROR, id: ParticleId(0), position: [0.0; 3] };
            self.limit = self.limit.tighter(limit);
        }
        // Otherwise no particle moves by as much as the limit of approaching matter allows.
        if reduced.speed * dt > self.settings.cfl * reduced.smallest {
            dt = dt.min(self.closing(reduced.speed));
        }
        if dt > 0.0 && dt.is_finite() {
            return Ok(dt);
        }
        let what = format!("no finite time step: {dt} s");
        Err(Failure { step: self.coming(), particle: None, what })
    }

    /// Conserved quantities; collective.
    pub fn totals(&mut self) -> Totals {
        let start = Instant::now();
        let age = self.state.gravity.age.unwrap_or(0.0);
        let mut totals = diagnostics::totals(&self.columns, &self.settings, age, self.comm);
        for body in &self.state.rigid {
            totals.work += body.motion.work;
            totals.impulse += body.motion.impulse;
        }
        self.phases.add(Phase::Diagnostics, start);
        totals
    }

    /// The tightest limit of all ranks, with its reason; collective, for the log.
    pub fn tightest_limit(&self) -> NamedLimit {
        let l = &self.limit;
        let mine = [l.dt, l.reason as f64, f64::from_bits(l.id.0), l.position[0], l.position[1], l.position[2]];
        let all = self.comm.all_gather(&mine);
        let limits = all.chunks_exact(6).map(|w| Limit {
            dt: w[0],
            reason: w[1] as usize,
            id: ParticleId(w[2].to_bits()),
            position: [w[3], w[4], w[5]],
        });
        let limit = limits.fold(Limit::NONE, Limit::tighter);
        NamedLimit { limit, reason: self.reason_name(limit.reason) }
    }

    /// Largest load of a rank over the mean load, over the run; collective.
    pub fn imbalance(&self) -> f64 {
        let load = Load { phases: &self.phases, steps: self.coming(), small_steps: self.small_steps_made() };
        self.neighbourhood.imbalance(&load, self.comm)
    }

    pub fn reason_name(&self, reason: usize) -> &'static str {
        match reason {
            Limit::CFL => "CFL",
            Limit::ACCELERATION => "acceleration",
            Limit::MOTION => "damping",
            Limit::CLOSING => "closing",
            Limit::ERROR => "error",
            effect => self.settings.effects[effect - Limit::EFFECTS].name(),
        }
    }

    pub(super) fn chunk_pass(&mut self, work: impl Fn(&Passes, &Chunk, &mut Workspace) + Sync) {
        let (registry, count) = (Arc::clone(&self.columns.registry), self.columns.len());
        let owners = self.neighbourhood.owners();
        let passes = Passes { settings: &self.settings, registry: &registry, rigid: &self.state.rigid, owners };
        let chunks = Chunks::new(&mut self.columns, std::mem::take(&mut self.pointers));
        let buffers = &self.buffers;
        self.workers.each(&buffers.all, |chunk, workspace| {
            // SAFETY: each chunk is worked on once per pass, and chunks do not overlap.
            let chunk = unsafe { chunks.chunk(buffers.range(chunk, count)) };
            work(&passes, &chunk, workspace);
        });
        self.pointers = chunks.into_pointers();
    }

    /// The findings of all threads since the last call.
    pub(super) fn collect(&self) -> Findings {
        let mut found = Findings::nothing();
        self.workers.collect(|workspace| found.merge(workspace.take()));
        found
    }

    /// One stage: pack, exchange, pair sums, rates, which the integrator takes; overlapped with it, where it is due, gravity for
    /// later steps; and the reduction. Collective.
    fn evaluate(&mut self, moment: &Moment, signal: u32) -> Result<Reduced, Failure> {
        let start = Instant::now();
        self.pack(moment.since);
        self.pack_fast(moment);
        self.phases.add(Phase::Pack, start);
        let layout = *self.settings.pair_loop.layout();
        let stride = layout.stride();
        let records: &[f64] = bytemuck::cast_slice(&self.buffers.records);
        self.neighbourhood.send(records, stride, self.comm);
        let mut gravity = self.begin_gravity(moment);
        let age = self.state.gravity.age.unwrap_or(0.0) + if moment.stage == 0 { 0.0 } else { moment.since };
        let moment = &Moment { gravity_age: age, ..*moment };
        let interior = std::mem::take(&mut self.buffers.interior);
        for group in interior.chunks(CHUNKS_PER_POLL * self.workers.threads()) {
            let start = Instant::now();
            self.evaluate_chunks(group, moment);
            self.neighbourhood.poll();
            self.phases.add(Phase::Pairs, start);
            if let Some(evaluation) = &mut gravity {
                let start = Instant::now();
                evaluation.go_on();
                self.phases.add(Phase::Gravity, start);
            }
        }
        self.buffers.interior = interior;
        let start = Instant::now();
        self.neighbourhood.wait(self.comm);
        self.phases.add(Phase::Wait, start);
        let start = Instant::now();
        self.neighbourhood.receive(bytemuck::cast_slice_mut(&mut self.buffers.records), stride);
        let boundary = std::mem::take(&mut self.buffers.boundary);
        self.evaluate_chunks(&boundary, moment);
        self.buffers.boundary = boundary;
        self.found = self.collect();
        self.limit = self.found.limit;
        self.counters.pairs += self.found.pairs;
        self.counters.updates += self.columns.len() as u64;
        let small = self.evaluate_fast(moment);
        self.phases.add(Phase::Pairs, start);
        if let Some(evaluation) = gravity {
            self.finish_gravity(evaluation);
        }
        let start = Instant::now();
        let controlled = self.settings.integrator.controlled();
        let reduced = reduction::after_evaluation::<D>(&self.found, controlled, signal, self.coming(), self.comm);
        self.phases.add(Phase::Reduce, start);
        let mut reduced = reduced?;
        self.note_small(small);
        if self.settings.rigid.is_some() {
            self.take_rigid(moment, &mut reduced);
        }
        Ok(reduced)
    }

    fn evaluate_chunks(&mut self, items: &[u32], moment: &Moment) {
        let (registry, count) = (Arc::clone(&self.columns.registry), self.columns.len());
        let owners = self.neighbourhood.owners();
        let passes = Passes { settings: &self.settings, registry: &registry, rigid: &self.state.rigid, owners };
        let rows = Rows {
            records: bytemuck::cast_slice(&self.buffers.records),
            offsets: &self.neighbourhood.list.offsets,
            entries: &self.neighbourhood.list.entries,
            slots: &self.neighbourhood.local().slot_of_owned,
        };
        let chunks = Chunks::new(&mut self.columns, std::mem::take(&mut self.pointers));
        let buffers = &self.buffers;
        self.workers.each(items, |chunk, workspace| {
            // SAFETY: each chunk is worked on once per pass, and chunks do not overlap.
            let chunk = unsafe { chunks.chunk(buffers.range(chunk, count)) };
            passes.evaluate(&chunk, &rows, moment, workspace);
        });
        self.pointers = chunks.into_pointers();
    }

    /// The longest step in which nothing flies into each other unseen, s. Collective.
    fn closing(&mut self, fastest: f64) -> f64 {
        let start = Instant::now();
        let found = self.neighbourhood.closing(&self.columns, &self.settings, fastest, self.comm);
        if let Some(particle) = found.particle {
            let Core { id, position, .. } = self.settings.view.core;
            let (id, position) = (self.columns.get(id, particle), self.columns.get(position, particle).into());
            self.limit = self.limit.tighter(Limit { dt: found.dt, reason: Limit::CLOSING, id, position });
        }
        self.phases.add(Phase::Watch, start);
        found.dt
    }
}
