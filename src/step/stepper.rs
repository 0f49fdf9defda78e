//! The particles of a rank and the step that moves them on.

use std::sync::Arc;
use std::time::Instant;

use super::diagnostics::{self, Sources, Totals};
use super::evaluate::{Flight, Physics, Workspace, chunk_range};
use super::failure::{Bad, Failure};
use super::neighbourhood::Neighbourhood;
use super::pack::Packer;
use super::phases::{Phase, Phases};
use super::time_step::Limit;
use super::workers::Workers;
use crate::domain::closing;
use crate::domain::comm::Comm;
use crate::gravity::attraction::Evaluation;
use crate::gravity::{Attraction, Matter, Timing};
use crate::material::{BodyConstants, Core, MaterialEffect};
use crate::motion::Motions;
use crate::pair::{PairLoop, Rows};
use crate::particles::chunk::{CHUNK, Chunks};
use crate::particles::{Column, Columns, ParticleId, Periods, large_pages};

/// Chunks between two looks at the messages on their way.
const CHUNKS_PER_POLL: usize = 8;
/// Pairs are summed while gravity is evaluated where it is kept for this many steps at least: it then counts a step later.
const STEPS_TO_OVERLAP: f64 = 8.0;

/// Everything a scene decides about a substep.
pub struct StepSettings {
    pub core: Core,
    pub effects: Vec<Box<dyn MaterialEffect>>,
    pub constants: Vec<BodyConstants>,
    pub packer: Packer,
    pub pair_loop: PairLoop,
    /// Where a scene prescribes how particles move.
    pub motions: Option<Motions>,
    pub gravity: Option<Attraction>,
    pub periods: Periods,
    pub cfl: f64,
    /// Skin of the neighbour lists over the support.
    pub skin: f64,
}

/// What happened so far, on all ranks alike but for the pairs.
#[derive(Debug, Clone, Copy, Default, serde::Serialize, serde::Deserialize)]
pub struct Counters {
    pub steps: u64,
    /// Since the start, s.
    #[serde(default)]
    pub time: f64,
    pub list_builds: u64,
    pub rebisections: u64,
    /// Of this rank.
    pub migrated: u64,
    /// Directed pairs inside the support, of this rank.
    pub pairs: u64,
    /// Force evaluations of owned particles, of this rank.
    pub updates: u64,
    /// When the particles' own gravity was evaluated.
    #[serde(default)]
    pub gravity: Timing,
    #[serde(default)]
    pub gravity_evaluations: u64,
}

/// A line of 64 bytes.
#[repr(C, align(64))]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Line([f64; 8]);

/// What ranks tell each other after an evaluation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Agreed {
    /// Largest next step, s.
    pub dt: f64,
    /// Largest of the ranks' signals: zero means nothing.
    pub signal: u32,
}

pub struct Stepper<'c, const D: usize> {
    pub comm: &'c Comm,
    pub columns: Columns,
    pub settings: StepSettings,
    pub workers: Workers<Workspace>,
    pub neighbourhood: Neighbourhood<D>,
    pub phases: Phases,
    pub counters: Counters,
    /// Tightest limit of this rank's particles at the last evaluation.
    pub limit: Limit,
    pub(super) internal_energy: Option<Column<f64>>,
    records: Vec<Line>,
    /// Chunks without and with ghosts in their rows.
    interior: Vec<u32>,
    boundary: Vec<u32>,
    all: Vec<u32>,
    pointers: Vec<(*mut u64, usize)>,
    bad: Option<Bad>,
    /// Velocities of this rank's particles after the last evaluation.
    flight: Flight,
    /// Whether lists and records were given back.
    pub(super) resting: bool,
}

impl<'c, const D: usize> Stepper<'c, D> {
    /// Takes over particles wherever they are; [`Stepper::start`] or [`Stepper::resume`] comes next.
    pub fn new(comm: &'c Comm, columns: Columns, settings: StepSettings) -> Self {
        let workers = Workers::new(|| Workspace::new(&columns.registry, settings.effects.len()));
        let internal_energy = columns.registry.find("internal_energy");
        let neighbourhood = Neighbourhood::new(&columns.registry, &settings);
        Self {
            comm,
            columns,
            settings,
            workers,
            neighbourhood,
            phases: Phases::default(),
            counters: Counters::default(),
            limit: Limit::NONE,
            internal_energy,
            records: Vec::new(),
            interior: Vec::new(),
            boundary: Vec::new(),
            all: Vec::new(),
            pointers: Vec::new(),
            resting: false,
            bad: None,
            flight: Flight::NOTHING,
        }
    }

    /// New particles: initialises their effects, distributes them and evaluates once. Returns the first step.
    pub fn start(&mut self) -> Result<Agreed, Failure> {
        // Smoothing lengths, on which lists stand, may be made by an effect.
        self.find_chunks();
        self.material_pass(|physics, chunk, workspace| physics.initialise(chunk, workspace));
        self.agree_on_particles(0.0)?;
        self.rebuild(true);
        self.evaluate(0.0);
        self.agree(0)
    }

    /// Particles of a checkpoint: lists stand on the positions of their last build, as if nothing had happened.
    pub fn resume(&mut self) {
        self.rebuild(false);
    }

    /// Moves all particles on by `dt`, s. `signal` is this rank's wish to stop, agreed on with all others. Where it fails,
    /// particles are left amid the step on every rank, and only a checkpoint leads on.
    pub fn step(&mut self, dt: f64, signal: u32) -> Result<Agreed, Failure> {
        self.counters.steps += 1;
        self.counters.time += dt;
        if self.resting {
            self.rebuild(false);
        }
        let start = Instant::now();
        self.material_pass(|physics, chunk, workspace| physics.predict(chunk, dt, workspace));
        self.phases.add(Phase::Predict, start);
        let start = Instant::now();
        let used = self.neighbourhood.skin_used(&self.columns, &self.settings, self.comm);
        self.phases.add(Phase::Watch, start);
        if self.agree_on_particles(used)? > 1.0 {
            self.rebuild(true);
        }
        self.evaluate(dt);
        self.agree(signal)
    }

    /// Gives the memory of lists and records back, for work that needs its own. The next step makes them anew from the
    /// positions of the last build: nothing changes.
    pub fn rest(&mut self) {
        self.neighbourhood.forget_list();
        self.records = Vec::new();
        self.resting = true;
    }

    /// What the last evaluation read; none where it was given back.
    pub(super) fn rows(&self) -> Option<Rows<'_>> {
        let list = &self.neighbourhood.list;
        let slots = &self.neighbourhood.local().slot_of_owned;
        let records = bytemuck::cast_slice(&self.records);
        (!self.resting).then_some(Rows { records, offsets: &list.offsets, entries: &list.entries, slots })
    }

    /// Conserved quantities; collective.
    pub fn totals(&mut self) -> Totals {
        let start = Instant::now();
        let sources = Sources {
            columns: &self.columns,
            core: &self.settings.core,
            constants: &self.settings.constants,
            effects: &self.settings.effects,
            motions: self.settings.motions.as_ref(),
            gravity: self.settings.gravity.as_ref(),
            gravity_age: self.counters.gravity.age.unwrap_or(0.0),
            internal_energy: self.internal_energy,
        };
        let totals = diagnostics::totals(&sources, self.comm);
        self.phases.add(Phase::Diagnostics, start);
        totals
    }

    /// The tightest limit of all ranks, with its reason; collective, for the log.
    pub fn tightest_limit(&self) -> (Limit, &'static str) {
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
        (limit, self.reason_name(limit.reason))
    }

    /// Largest load of a rank over the mean load, over the run; collective.
    pub fn imbalance(&self) -> f64 {
        self.neighbourhood.imbalance(&self.phases, &self.counters, self.comm)
    }

    pub fn reason_name(&self, reason: usize) -> &'static str {
        match reason {
            Limit::CFL => "CFL",
            Limit::ACCELERATION => "acceleration",
            Limit::MOTION => "damping",
            Limit::CLOSING => "closing",
            effect => self.settings.effects[effect - Limit::EFFECTS].name(),
        }
    }

    /// Bytes of the pair records held.
    pub fn record_bytes(&self) -> usize {
        std::mem::size_of::<Line>() * self.records.capacity()
    }

    pub(super) fn material_pass(&mut self, work: impl Fn(&Physics, &crate::particles::Chunk, &mut Workspace) + Sync) {
        let (registry, count) = (Arc::clone(&self.columns.registry), self.columns.len());
        let physics = physics(&self.settings, &registry, &self.counters);
        let chunks = Chunks::new(&mut self.columns, std::mem::take(&mut self.pointers));
        self.workers.each(&self.all, |chunk, workspace| {
            // SAFETY: each chunk is worked on once per pass, and chunks do not overlap.
            let chunk = unsafe { chunks.chunk(chunk_range(chunk, count)) };
            work(&physics, &chunk, workspace);
        });
        self.pointers = chunks.into_pointers();
    }

    /// Pack, exchange, pair loop, rates, correction by `dt`; with all of it, where it is due, gravity for the steps to come.
    pub(super) fn evaluate(&mut self, dt: f64) {
        let start = Instant::now();
        self.pack(dt);
        self.phases.add(Phase::Pack, start);
        let layout = self.settings.pair_loop.layout;
        let stride = layout.stride();
        let records: &[f64] = bytemuck::cast_slice(&self.records);
        self.neighbourhood.send(records, stride, self.comm);
        let mut gravity = self.begin_gravity(dt);
        let interior = std::mem::take(&mut self.interior);
        for group in interior.chunks(CHUNKS_PER_POLL * self.workers.threads()) {
            let start = Instant::now();
            self.evaluate_chunks(group, dt);
            self.neighbourhood.poll();
            self.phases.add(Phase::Pairs, start);
            if let Some(evaluation) = &mut gravity {
                let start = Instant::now();
                evaluation.go_on();
                self.phases.add(Phase::Gravity, start);
            }
        }
        self.interior = interior;
        let start = Instant::now();
        self.neighbourhood.wait(self.comm);
        self.phases.add(Phase::Wait, start);
        let start = Instant::now();
        self.neighbourhood.receive(bytemuck::cast_slice_mut(&mut self.records), stride);
        let boundary = std::mem::take(&mut self.boundary);
        self.evaluate_chunks(&boundary, dt);
        self.boundary = boundary;
        let (mut limit, mut bad, mut pairs, mut flight) = (Limit::NONE, None, 0, Flight::NOTHING);
        self.workers.collect(|workspace| {
            let (l, b, p, f) = workspace.take();
            limit = limit.tighter(l);
            bad = Bad::first(bad.take(), b);
            pairs += p;
            flight.merge(&f);
        });
        (self.limit, self.bad, self.flight) = (limit, bad, flight);
        self.counters.pairs += pairs;
        self.counters.updates += self.columns.len() as u64;
        self.phases.add(Phase::Pairs, start);
        if let Some(evaluation) = gravity {
            self.finish_gravity(evaluation);
        }
    }

    /// Begins an evaluation of the particles' own gravity, where it is due; returns it if others may go on meanwhile. Collective.
    fn begin_gravity(&mut self, dt: f64) -> Option<Evaluation<'c>> {
        let own = self.settings.gravity.and_then(|gravity| gravity.own)?;
        let timing = &mut self.counters.gravity;
        timing.age = timing.age.map(|age| age + dt);
        if !own.is_due(timing, dt) {
            return None;
        }
        self.counters.gravity_evaluations += 1;
        let (start, first, lasts) = (Instant::now(), timing.age.is_none(), own.lasts(timing));
        let StepSettings { core, constants, packer, .. } = &self.settings;
        let mass_and_softening = |columns: &Columns, i: usize| {
            let body = columns.get(core.id, i).body();
            (constants[body].particle_mass, packer.smoothing_length(columns, i, body))
        };
        let matter = Matter { id: core.id, position: core.position, mass_and_softening: &mass_and_softening };
        let evaluation = own.evaluation(&self.columns, &matter, first, self.comm);
        self.phases.add(Phase::Gravity, start);
        // What counts a step later must not be much older for it; until then the field before goes on.
        if !first && lasts >= STEPS_TO_OVERLAP * dt {
            return Some(evaluation);
        }
        self.finish_gravity(evaluation);
        None
    }

    fn finish_gravity(&mut self, evaluation: Evaluation<'c>) {
        let (start, waited) = (Instant::now(), self.comm.wait_seconds());
        let fields = evaluation.finish();
        if let Some(own) = self.settings.gravity.and_then(|gravity| gravity.own) {
            own.keep(&mut self.columns, &fields, &mut self.counters.gravity);
        }
        // Waits for other ranks are no load of this one.
        let waited = self.comm.wait_seconds() - waited;
        self.phases.seconds[Phase::Gravity as usize] -= waited;
        self.phases.seconds[Phase::Wait as usize] += waited;
        self.phases.add(Phase::Gravity, start);
        self.neighbourhood.poll();
    }

    fn evaluate_chunks(&mut self, items: &[u32], dt: f64) {
        let (registry, count) = (Arc::clone(&self.columns.registry), self.columns.len());
        let physics = physics(&self.settings, &registry, &self.counters);
        let rows = Rows {
            records: bytemuck::cast_slice(&self.records),
            offsets: &self.neighbourhood.list.offsets,
            entries: &self.neighbourhood.list.entries,
            slots: &self.neighbourhood.local().slot_of_owned,
        };
        let chunks = Chunks::new(&mut self.columns, std::mem::take(&mut self.pointers));
        self.workers.each(items, |chunk, workspace| {
            // SAFETY: each chunk is worked on once per pass, and chunks do not overlap.
            let chunk = unsafe { chunks.chunk(chunk_range(chunk, count)) };
            physics.evaluate(&chunk, &rows, dt, workspace);
        });
        self.pointers = chunks.into_pointers();
    }

    fn pack(&mut self, dt: f64) {
        struct Records(*mut f64);
        // SAFETY: chunks write to the slots of their own particles only, which are all different.
        unsafe impl Sync for Records {}
        impl Records {
            fn start(&self) -> *mut f64 {
                self.0
            }
        }
        let records = Records(bytemuck::cast_slice_mut::<Line, f64>(&mut self.records).as_mut_ptr());
        let (columns, packer) = (&self.columns, &self.settings.packer);
        let slots = &self.neighbourhood.local().slot_of_owned;
        self.workers.each(&self.all, |chunk, _| {
            // SAFETY: `records` has a slot for every local particle, and no two particles share one.
            unsafe { packer.pack(columns, (chunk_range(chunk, columns.len()), dt), slots, records.start()) };
        });
    }

    /// One answer of all ranks after prediction: the largest share of the skin that is used up. Nothing that is no number goes
    /// on to a neighbour. Collective.
    pub(super) fn agree_on_particles(&mut self, used: f64) -> Result<f64, Failure> {
        let mut bad = None;
        self.workers.collect(|workspace| bad = Bad::first(bad.take(), workspace.take_bad()));
        let mut values = [if bad.is_none() { used } else { 0.0 }, bad.is_some() as u32 as f64];
        let start = Instant::now();
        self.comm.all_max(&mut values);
        self.phases.add(Phase::Reduce, start);
        if values[1] > 0.0 {
            return Err(Failure::of_ranks(bad.as_ref(), self.counters.steps, self.comm));
        }
        Ok(values[0])
    }

    /// One answer of all ranks after an evaluation: the next step, a particle gone bad, a wish to stop.
    pub(super) fn agree(&mut self, signal: u32) -> Result<Agreed, Failure> {
        let bad = self.bad.is_some() as u32 as f64;
        let Flight { forward, backward, thin } = self.flight;
        let mut values = [self.limit.dt, -bad, -(signal as f64), thin, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        for (value, v) in values[4..].iter_mut().zip(forward.into_iter().chain(backward)) {
            *value = -v;
        }
        let start = Instant::now();
        self.comm.all_min(&mut values);
        self.phases.add(Phase::Reduce, start);
        let [mut dt, bad, signal, thin, rest @ ..] = values;
        if bad < 0.0 {
            return Err(Failure::of_ranks(self.bad.as_ref(), self.counters.steps, self.comm));
        }
        let velocities = rest.map(|v| -v);
        let fastest = closing::relative(&velocities[..D], &velocities[3..3 + D]);
        // Otherwise nothing moves by as much as the limit of what closes allows.
        if fastest * dt > self.settings.cfl * thin {
            dt = dt.min(self.closing(fastest));
        }
        if !(dt > 0.0 && dt.is_finite()) {
            let what = format!("no finite time step: {dt} s");
            return Err(Failure { step: self.counters.steps, particle: None, what });
        }
        Ok(Agreed { dt, signal: -signal as u32 })
    }

    /// The longest step in which nothing flies into each other unseen, s. Collective.
    fn closing(&mut self, fastest: f64) -> f64 {
        let start = Instant::now();
        let found = self.neighbourhood.closing(&self.columns, &self.settings, fastest, self.comm);
        if let Some(particle) = found.particle {
            let Core { id, position, .. } = self.settings.core;
            let (id, position) = (self.columns.get(id, particle), self.columns.get(position, particle).into());
            self.limit = self.limit.tighter(Limit { dt: found.dt, reason: Limit::CLOSING, id, position });
        }
        self.phases.add(Phase::Watch, start);
        found.dt
    }

    fn find_chunks(&mut self) {
        self.all.clear();
        self.all.extend(0..self.columns.len().div_ceil(CHUNK) as u32);
    }

    /// New lists; `fresh` from the present positions, otherwise from those of the last build.
    pub(super) fn rebuild(&mut self, fresh: bool) {
        self.resting = false;
        let start = Instant::now();
        if fresh {
            self.neighbourhood.start_afresh(&mut self.columns);
            let rebisected = self.neighbourhood.balance(&self.columns, &self.phases, &self.counters, self.comm);
            self.counters.list_builds += 1;
            self.counters.rebisections += rebisected as u64;
        }
        self.neighbourhood.distribute(&mut self.columns, &self.settings, self.comm);
        self.counters.migrated += self.neighbourhood.migrated() as u64;
        self.phases.add(Phase::Migration, start);
        let start = Instant::now();
        self.neighbourhood.build_list();
        self.phases.add(Phase::Lists, start);
        self.find_chunks();
        let count = self.columns.len();
        self.interior.clear();
        self.boundary.clear();
        let mut rest = self.neighbourhood.list.boundary.iter().peekable();
        for &chunk in &self.all {
            let range = chunk_range(chunk as usize, count);
            let mut with_ghosts = false;
            while rest.next_if(|row| (**row as usize) < range.end).is_some() {
                with_ghosts = true;
            }
            if with_ghosts { self.boundary.push(chunk) } else { self.interior.push(chunk) }
        }
        let layout = self.settings.pair_loop.layout;
        let lines = layout.stride() / 8;
        let needed = (self.neighbourhood.local().count + 1) * lines;
        if self.records.capacity() < needed {
            // The old ones are not read again.
            self.records = large_pages::with_capacity(needed);
        }
        self.records.resize(needed, Line([0.0; 8]));
        let padding = self.neighbourhood.local().count * layout.stride();
        layout
            .padding(&mut bytemuck::cast_slice_mut::<Line, f64>(&mut self.records)[padding..padding + layout.stride()]);
    }
}

fn physics<'a>(
    settings: &'a StepSettings,
    registry: &'a crate::particles::Registry,
    counters: &Counters,
) -> Physics<'a> {
    Physics {
        registry,
        core: &settings.core,
        constants: &settings.constants,
        effects: &settings.effects,
        packer: &settings.packer,
        pair_loop: &settings.pair_loop,
        motions: settings.motions.as_ref(),
        gravity: settings.gravity.as_ref(),
        gravity_age: counters.gravity.age.unwrap_or(0.0),
        cfl: settings.cfl,
        now: counters.time,
    }
}
