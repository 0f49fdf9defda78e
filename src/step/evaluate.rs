//! One chunk from pair sums to corrected state: rates of motion, rates of the material effects, the step they allow, and the
//! corrector, while everything is in cache.

use std::cell::Cell;
use std::ops::Range;
use std::time::{Duration, Instant};

use super::failure::{Bad, all_finite, finite};
use super::integrator::{self, NewRates};
use super::pack::{Packer, read_stress};
use super::time_step::{self, Limit};
use crate::gravity::Attraction;
use crate::material::{BodyConstants, Core, Late, Local, MaterialEffect, Motion};
use crate::math::{Mat3, Sym};
use crate::motion::Motions;
use crate::pair::record::half;
use crate::pair::{Layout, PairLoop, RowSums, Rows, correction, torque};
use crate::particles::chunk::{CHUNK, Chunk};
use crate::particles::columns::Entry;
use crate::particles::{Life, Registry, Shape};

/// Rows of a chunk that are summed between two requests for columns.
const ROWS_PER_FETCH: usize = 32;

/// What a thread needs for a chunk, and what it finds out.
pub struct Workspace {
    sums: Vec<RowSums>,
    motion: Vec<Motion>,
    bodies: Vec<u16>,
    acceleration: Vec<f64>,
    new_rates: Vec<Vec<Cell<u64>>>,
    /// Tightest limit since the last [`Workspace::take`].
    limit: Limit,
    /// Columns that are looked through after prediction, see [`is_watched`].
    watched: Vec<usize>,
    /// First particle with a number that is none, by id, since then.
    bad: Option<Bad>,
    /// Directed pairs inside the support.
    pairs: u64,
    /// Velocities since the last [`Workspace::take`].
    flight: Flight,
    /// Time spent in each effect so far.
    effects: Vec<Cell<Duration>>,
}

impl Workspace {
    pub fn new(registry: &Registry, effects: usize) -> Self {
        let block = |&(value, _): &(usize, usize)| vec![Cell::new(0); CHUNK * registry.entries[value].width];
        let motion = Motion { velocity_gradient: Mat3::zeros(), heating: 0.0 };
        Self {
            sums: vec![RowSums::default(); CHUNK],
            motion: vec![motion; CHUNK],
            bodies: vec![0; CHUNK],
            acceleration: vec![0.0; CHUNK * registry.dimension],
            new_rates: registry.integrated.iter().map(block).collect(),
            limit: Limit::NONE,
            watched: (0..registry.entries.len()).filter(|&index| is_watched(&registry.entries[index])).collect(),
            bad: None,
            pairs: 0,
            flight: Flight::NOTHING,
            effects: vec![Cell::default(); effects],
        }
    }

    /// Limit, first bad particle, pairs and velocities since the last call.
    pub fn take(&mut self) -> (Limit, Option<Bad>, u64, Flight) {
        let limit = std::mem::replace(&mut self.limit, Limit::NONE);
        let flight = std::mem::replace(&mut self.flight, Flight::NOTHING);
        (limit, self.bad.take(), std::mem::take(&mut self.pairs), flight)
    }

    /// The first bad particle of the passes since the last call.
    pub fn take_bad(&mut self) -> Option<Bad> {
        self.bad.take()
    }

    /// Seconds that this thread has spent in each effect so far.
    pub fn effect_seconds(&self) -> impl Iterator<Item = f64> {
        self.effects.iter().map(|time| time.get().as_secs_f64())
    }
}

/// Extremes of the velocities of many particles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flight {
    /// m/s
    pub forward: [f64; 3],
    /// Of the velocity's opposite.
    pub backward: [f64; 3],
    /// Smallest smoothing length, m.
    pub thin: f64,
}

impl Flight {
    pub const NOTHING: Self =
        Self { forward: [f64::NEG_INFINITY; 3], backward: [f64::NEG_INFINITY; 3], thin: f64::INFINITY };

    pub fn merge(&mut self, other: &Self) {
        for k in 0..3 {
            self.forward[k] = self.forward[k].max(other.forward[k]);
            self.backward[k] = self.backward[k].max(other.backward[k]);
        }
        self.thin = self.thin.min(other.thin);
    }
}

/// What all chunks of a pass share.
pub struct Physics<'a> {
    pub registry: &'a Registry,
    pub core: &'a Core,
    pub constants: &'a [BodyConstants],
    pub effects: &'a [Box<dyn MaterialEffect>],
    pub packer: &'a Packer,
    pub pair_loop: &'a PairLoop,
    pub motions: Option<&'a Motions>,
    pub gravity: Option<&'a Attraction>,
    /// Seconds since own gravity was evaluated.
    pub gravity_age: f64,
    pub cfl: f64,
    /// Time at the end of the step, s since the start.
    pub now: f64,
}

impl Physics<'_> {
    /// Advances a chunk by `dt` and brings its material up to date.
    pub fn predict(&self, chunk: &Chunk, dt: f64, workspace: &mut Workspace) {
        integrator::predict(chunk, self.registry, self.core, dt);
        self.fill_bodies(chunk, workspace);
        let local = self.local(chunk, workspace, dt);
        self.each_effect(workspace, |effect| effect.admit(&local));
        self.each_effect(workspace, |effect| effect.update(&local));
        self.note_bad_columns(chunk, workspace);
    }

    /// Calls `initialise` and one first `update` on new particles.
    pub fn initialise(&self, chunk: &Chunk, workspace: &mut Workspace) {
        self.fill_bodies(chunk, workspace);
        let local = self.local(chunk, workspace, 0.0);
        self.each_effect(workspace, |effect| effect.initialise(&local));
        self.each_effect(workspace, |effect| effect.admit(&local));
        self.each_effect(workspace, |effect| effect.update(&local));
        self.note_bad_columns(chunk, workspace);
    }

    /// Brings particles over to the soft matter of the late stage.
    pub fn carry_over(&self, chunk: &Chunk, late: &Late, workspace: &mut Workspace) {
        self.fill_bodies(chunk, workspace);
        let local = self.local(chunk, workspace, 0.0);
        self.each_effect(workspace, |effect| effect.carry_over(&local, late));
        self.each_effect(workspace, |effect| effect.admit(&local));
        self.each_effect(workspace, |effect| effect.update(&local));
        self.note_bad_columns(chunk, workspace);
    }

    /// Sums the rows of a chunk and corrects its state with the rates found, unless one of them is no number.
    pub fn evaluate(&self, chunk: &Chunk, rows: &Rows, dt: f64, workspace: &mut Workspace) {
        self.fill_bodies(chunk, workspace);
        // While pairs are summed, the columns that their sums will change come from memory.
        let mut sums = workspace.sums.chunks_mut(ROWS_PER_FETCH);
        for start in chunk.range.clone().step_by(ROWS_PER_FETCH) {
            let rows_now = start..(start + ROWS_PER_FETCH).min(chunk.range.end);
            let sums = sums.next().expect("sums for each row of a chunk");
            chunk.fetch(start - chunk.range.start..rows_now.end - chunk.range.start);
            self.pair_loop.sum(rows, rows_now, sums);
        }
        self.find_motion(chunk, rows, dt, workspace);
        for block in &workspace.new_rates {
            block.iter().for_each(|word| word.set(0));
        }
        if let Some(gravity) = self.gravity {
            gravity.add(chunk, self.gravity_age, self.registry.dimension, &mut workspace.acceleration);
        }
        let held = self.motions.and_then(|motions| self.constrain(motions, chunk, workspace));
        let local = self.local(chunk, workspace, dt);
        self.each_effect(workspace, |effect| effect.rates(&local));
        let limit = self.step_limit(&local, chunk, workspace, held);
        if !self.rates_are_finite(chunk, workspace) {
            let bad = self.first_bad_rate(chunk, &local, workspace);
            workspace.bad = Bad::first(workspace.bad.take(), bad);
            return;
        }
        let new = NewRates { acceleration: &workspace.acceleration, integrated: &workspace.new_rates };
        integrator::correct(chunk, self.registry, self.core, &new, dt);
        let local = self.local(chunk, workspace, dt);
        self.each_effect(workspace, |effect| effect.admit(&local));
        workspace.limit = workspace.limit.tighter(limit);
        self.note_flight(chunk, workspace);
    }

    fn note_flight(&self, chunk: &Chunk, workspace: &mut Workspace) {
        let velocity = chunk.view(self.core.velocity);
        let mut flight = Flight::NOTHING;
        for k in 0..chunk.len() {
            let v: [f64; 3] = velocity.get(k).into();
            let thin = self.packer.chunk_smoothing_length(chunk, k, workspace.bodies[k] as usize);
            flight.merge(&Flight { forward: v, backward: v.map(|v| -v), thin });
        }
        workspace.flight.merge(&flight);
    }

    /// Calls every effect in its turn and notes the time that it took.
    fn each_effect(&self, workspace: &Workspace, mut act: impl FnMut(&dyn MaterialEffect)) {
        let mut start = Instant::now();
        for (effect, time) in self.effects.iter().zip(&workspace.effects) {
            act(effect.as_ref());
            let end = Instant::now();
            time.set(time.get() + (end - start));
            start = end;
        }
    }

    fn fill_bodies(&self, chunk: &Chunk, workspace: &mut Workspace) {
        let ids = chunk.view(self.core.id);
        workspace.bodies.clear();
        workspace.bodies.extend((0..chunk.len()).map(|k| ids.get(k).body() as u16));
    }

    fn local<'a>(&'a self, chunk: &'a Chunk<'a>, workspace: &'a Workspace, dt: f64) -> Local<'a> {
        Local {
            chunk,
            bodies: &workspace.bodies,
            constants: self.constants,
            motion: &workspace.motion[..chunk.len()],
            new_rates: &workspace.new_rates,
            dt,
        }
    }

    /// Acceleration, velocity gradient and heating of each row.
    fn find_motion(&self, chunk: &Chunk, rows: &Rows, dt: f64, workspace: &mut Workspace) {
        let layout = &self.pair_loop.layout;
        let dimension = layout.dimension;
        let stride = layout.stride();
        for (k, i) in chunk.range.clone().enumerate() {
            let sums = &workspace.sums[k];
            let record = &rows.records[rows.slots[i] as usize * stride..][..stride];
            let inverse_density = record[layout.volume()] / self.constants[workspace.bodies[k] as usize].particle_mass;
            for a in 0..dimension {
                workspace.acceleration[k * dimension + a] = inverse_density * sums.force[a];
            }
            let raw = gradient(dimension, &sums.gradient);
            let mut work = contract(&read_stress(layout, record), &raw);
            if let Some(moments) = &self.packer.moments {
                let axial = |k: usize| half(record, layout.axial() + k);
                work += match dimension {
                    2 => torque::heating::<2>(&[axial(0)], &sums.gradient),
                    _ => torque::heating::<3>(&[axial(0), axial(1), axial(2)], &sums.gradient),
                };
                moments.keep(chunk, (k, dimension), &sums.moment, dt);
            }
            let heating = inverse_density * (work + 0.5 * sums.dissipation);
            let velocity_gradient = match sums.neighbours {
                0 => Mat3::from_diagonal_element(self.unloading(chunk, k, workspace.bodies[k] as usize, dt)),
                _ => self.corrected(layout, &raw, sums),
            };
            workspace.motion[k] = Motion { velocity_gradient, heating };
            workspace.pairs += sums.neighbours as u64;
        }
    }

    /// The expansion, 1/s along each axis, by which a particle that has lost all neighbours lets go of its pressure, of either sign: at its
    /// speed of sound over h, in ten steps or more, so that it limits no step. Without it the pressure of its last contact would
    /// stay for good. Its energy stays, as nothing takes up work.
    fn unloading(&self, chunk: &Chunk, k: usize, body: usize, dt: f64) -> f64 {
        let at = |column| chunk.view(column).get(k);
        let (pressure, c) = (at(self.core.pressure), at(self.core.sound_speed));
        if !(c > 0.0 && dt > 0.0) {
            return 0.0;
        }
        let h = self.packer.chunk_smoothing_length(chunk, k, body);
        let rate = pressure / (at(self.core.density.value) * c * h);
        rate.clamp(-0.1 / dt, 0.1 / dt) / self.registry.dimension as f64
    }

    fn corrected(&self, layout: &Layout, raw: &Mat3, sums: &RowSums) -> Mat3 {
        if !layout.terms.correction {
            return *raw;
        }
        let m = &sums.moment;
        if layout.dimension == 2 {
            correction::corrected::<2>(raw, &Sym { xx: m[0], yy: m[1], xy: m[2], ..Sym::ZERO })
        } else {
            correction::corrected::<3>(raw, &Sym { xx: m[0], yy: m[1], zz: m[2], xy: m[3], xz: m[4], yz: m[5] })
        }
    }

    /// Motion as the scene prescribes it.
    fn constrain(&self, motions: &Motions, chunk: &Chunk, workspace: &mut Workspace) -> Option<(f64, usize)> {
        let Workspace { acceleration, new_rates, bodies, .. } = workspace;
        let rates = (&mut acceleration[..], &new_rates[..]);
        let moving = (self.core.velocity, self.now);
        match self.registry.dimension {
            2 => motions.constrain::<2>(chunk, moving, bodies, rates),
            _ => motions.constrain::<3>(chunk, moving, bodies, rates),
        }
    }

    fn step_limit(&self, local: &Local, chunk: &Chunk, workspace: &Workspace, held: Option<(f64, usize)>) -> Limit {
        let dimension = self.registry.dimension;
        let sound_speed = chunk.view(self.core.sound_speed);
        let mut best = held.map_or((f64::INFINITY, 0, Limit::CFL), |(dt, k)| (dt, k, Limit::MOTION));
        for k in 0..chunk.len() {
            let body = workspace.bodies[k] as usize;
            let h = self.packer.chunk_smoothing_length(chunk, k, body);
            let a = &workspace.acceleration[k * dimension..(k + 1) * dimension];
            let a2: f64 = a.iter().map(|a| a * a).sum();
            let alpha_beta = self.packer.viscosity(body);
            let sums = &workspace.sums[k];
            // A particle alone sends no signal to anyone, however hot it is.
            let alone = sums.neighbours == 0;
            let cfl = time_step::cfl(self.cfl, h, sound_speed.get(k), alpha_beta, sums.approach);
            let cfl = if alone { f64::INFINITY } else { cfl };
            let acceleration = time_step::acceleration(self.cfl, h, a2);
            if cfl < best.0 {
                best = (cfl, k, Limit::CFL);
            }
            if acceleration < best.0 {
                best = (acceleration, k, Limit::ACCELERATION);
            }
        }
        let mut reason = Limit::EFFECTS;
        self.each_effect(workspace, |effect| {
            if let Some(limit) = effect.step_limit(local).filter(|limit| limit.dt < best.0) {
                best = (limit.dt, limit.particle, reason);
            }
            reason += 1;
        });
        let position = chunk.view(self.core.position).get(best.1);
        Limit { dt: best.0, reason: best.2, id: chunk.view(self.core.id).get(best.1), position: position.into() }
    }

    fn rates_are_finite(&self, chunk: &Chunk, workspace: &Workspace) -> bool {
        let n = chunk.len();
        let width = |slot: usize| self.registry.entries[self.registry.integrated[slot].0].width;
        let mut blocks = workspace.new_rates.iter().enumerate();
        all_finite(&workspace.acceleration[..n * self.registry.dimension])
            && blocks.all(|(slot, block)| finite(&block[..n * width(slot)]))
    }

    /// The first particle with a rate that is no number, and which of the causes in their order: the forces of its neighbours,
    /// their motion, or the effect without which its rates would be numbers.
    fn first_bad_rate(&self, chunk: &Chunk, local: &Local, workspace: &Workspace) -> Option<Bad> {
        let (n, dimension) = (chunk.len(), self.registry.dimension);
        let mut found = None;
        let mut note = |k: usize, what: &dyn Fn() -> String| {
            let id = chunk.view(self.core.id).get(k);
            if found.as_ref().is_none_or(|bad: &Bad| id < bad.id) {
                found = Some(Bad { id, what: what() });
            }
        };
        for k in 0..n {
            let motion = &workspace.motion[k];
            if !all_finite(&workspace.acceleration[k * dimension..(k + 1) * dimension]) {
                note(k, &|| "the forces of its neighbours add up to an acceleration that is no number".into());
            } else if !(all_finite(motion.velocity_gradient.as_slice()) && motion.heating.is_finite()) {
                note(k, &|| "the motion of its neighbours gives a velocity gradient that is no number".into());
            }
        }
        // Effects fill the rates once more, one after another.
        workspace.new_rates.iter().flatten().for_each(|word| word.set(0));
        for effect in self.effects {
            effect.rates(local);
            for (block, &(value, _)) in workspace.new_rates.iter().zip(&self.registry.integrated) {
                let entry = &self.registry.entries[value];
                for k in (0..n).filter(|&k| !finite(&block[k * entry.width..(k + 1) * entry.width])) {
                    note(k, &|| format!("effect `{}` makes a rate of {} that is no number", effect.name(), entry.name));
                }
            }
        }
        found
    }

    /// Looks through the numbers that the effects have made of a chunk.
    fn note_bad_columns(&self, chunk: &Chunk, workspace: &mut Workspace) {
        if workspace.watched.iter().all(|&index| finite(chunk.words(index))) {
            return;
        }
        let ids = chunk.view(self.core.id);
        for &index in &workspace.watched {
            let entry = &self.registry.entries[index];
            let words = chunk.words(index);
            let bad = (0..chunk.len()).filter(|&k| !finite(&words[k * entry.width..(k + 1) * entry.width]));
            let what =
                || format!("its {} is no number after the effects have acted (owner: {})", entry.name, entry.owner);
            let bad = bad.map(|k| ids.get(k)).min().map(|id| Bad { id, what: what() });
            workspace.bad = Bad::first(workspace.bad.take(), bad);
        }
    }
}

/// Numbers that snapshots show, and those that follow from the state. The others are rates, which are looked at when they are
/// made, and values at the last list build.
fn is_watched(entry: &Entry) -> bool {
    entry.shape != Shape::Id && (entry.info.snapshot || entry.info.life == Life::Scratch)
}

fn gradient(dimension: usize, sums: &[f64; 9]) -> Mat3 {
    if dimension == 2 {
        Mat3::new(sums[0], sums[1], 0.0, sums[2], sums[3], 0.0, 0.0, 0.0, 0.0)
    } else {
        Mat3::from_row_slice(sums)
    }
}

/// sigma : L, W/m^3.
fn contract(s: &Sym, l: &Mat3) -> f64 {
    s.xx * l[(0, 0)]
        + s.yy * l[(1, 1)]
        + s.zz * l[(2, 2)]
        + s.xy * (l[(0, 1)] + l[(1, 0)])
        + s.xz * (l[(0, 2)] + l[(2, 0)])
        + s.yz * (l[(1, 2)] + l[(2, 1)])
}

/// Chunks of `count` owned particles.
pub fn chunk_range(chunk: usize, count: usize) -> Range<usize> {
    chunk * CHUNK..((chunk + 1) * CHUNK).min(count)
}
