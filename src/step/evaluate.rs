//! One chunk from pair sums to corrected state: rates of motion, rates of the material effects, the step they allow, and the
//! corrector, while everything is in cache.

use std::cell::Cell;
use std::ops::Range;
use std::time::{Duration, Instant};

use super::integrator::{self, NewRates};
use super::pack::{Packer, read_stress};
use super::time_step::{self, Limit};
use crate::material::{BodyConstants, Core, Local, MaterialEffect, Motion};
use crate::math::{Mat3, Sym};
use crate::motion::Motions;
use crate::pair::{Layout, PairLoop, RowSums, Rows, correction};
use crate::particles::chunk::{CHUNK, Chunk};
use crate::particles::{Columns, ParticleId, Registry};

/// What a thread needs for a chunk, and what it finds out.
pub struct Workspace {
    sums: Vec<RowSums>,
    motion: Vec<Motion>,
    bodies: Vec<u16>,
    acceleration: Vec<f64>,
    new_rates: Vec<Vec<Cell<u64>>>,
    /// Tightest limit since the last [`Workspace::take`].
    limit: Limit,
    /// First particle with a rate that is no number, by id, and what it was.
    bad: Option<(ParticleId, &'static str)>,
    /// Directed pairs inside the support.
    pairs: u64,
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
            bad: None,
            pairs: 0,
            effects: vec![Cell::default(); effects],
        }
    }

    /// Limit, first bad particle and pairs since the last call.
    pub fn take(&mut self) -> (Limit, Option<(ParticleId, &'static str)>, u64) {
        let out = (self.limit, self.bad, self.pairs);
        (self.limit, self.bad, self.pairs) = (Limit::NONE, None, 0);
        out
    }

    /// Seconds that this thread has spent in each effect so far.
    pub fn effect_seconds(&self) -> impl Iterator<Item = f64> {
        self.effects.iter().map(|time| time.get().as_secs_f64())
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
    pub cfl: f64,
}

impl Physics<'_> {
    /// Advances a chunk by `dt` and brings its material up to date.
    pub fn predict(&self, chunk: &Chunk, dt: f64, workspace: &mut Workspace) {
        integrator::predict(chunk, self.registry, self.core, dt);
        self.fill_bodies(chunk, workspace);
        let local = self.local(chunk, workspace, dt);
        self.each_effect(workspace, |effect| effect.admit(&local));
        self.each_effect(workspace, |effect| effect.update(&local));
    }

    /// Calls `initialise` and one first `update` on new particles.
    pub fn initialise(&self, chunk: &Chunk, workspace: &mut Workspace) {
        self.fill_bodies(chunk, workspace);
        let local = self.local(chunk, workspace, 0.0);
        self.each_effect(workspace, |effect| effect.initialise(&local));
        self.each_effect(workspace, |effect| effect.admit(&local));
        self.each_effect(workspace, |effect| effect.update(&local));
    }

    /// Sums the rows of a chunk and corrects its state with the rates found.
    pub fn evaluate(&self, chunk: &Chunk, rows: &Rows, dt: f64, workspace: &mut Workspace) {
        self.fill_bodies(chunk, workspace);
        self.pair_loop.sum(rows, chunk.range.clone(), &mut workspace.sums);
        self.find_motion(chunk.range.clone(), rows, workspace);
        for block in &workspace.new_rates {
            block.iter().for_each(|word| word.set(0));
        }
        let held = self.motions.and_then(|motions| self.constrain(motions, chunk, workspace));
        let local = self.local(chunk, workspace, dt);
        self.each_effect(workspace, |effect| effect.rates(&local));
        let limit = self.step_limit(&local, chunk, workspace, held);
        let bad = self.first_bad(chunk, workspace);
        let new = NewRates { acceleration: &workspace.acceleration, integrated: &workspace.new_rates };
        integrator::correct(chunk, self.registry, self.core, &new, dt);
        let local = self.local(chunk, workspace, dt);
        self.each_effect(workspace, |effect| effect.admit(&local));
        workspace.limit = workspace.limit.tighter(limit);
        workspace.bad = match (workspace.bad, bad) {
            (Some(a), Some(b)) => Some(if a.0 <= b.0 { a } else { b }),
            (a, b) => a.or(b),
        };
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
    fn find_motion(&self, range: Range<usize>, rows: &Rows, workspace: &mut Workspace) {
        let layout = &self.pair_loop.layout;
        let dimension = layout.dimension;
        let stride = layout.stride();
        for (k, i) in range.enumerate() {
            let sums = &workspace.sums[k];
            let record = &rows.records[rows.slots[i] as usize * stride..][..stride];
            let inverse_density = 1.0 / record[layout.density()];
            for a in 0..dimension {
                workspace.acceleration[k * dimension + a] = inverse_density * sums.force[a];
            }
            let raw = gradient(dimension, &sums.gradient);
            let work = contract(&read_stress(layout, record), &raw);
            let heating = inverse_density * (work + 0.5 * sums.dissipation);
            workspace.motion[k] = Motion { velocity_gradient: self.corrected(layout, &raw, sums), heating };
            workspace.pairs += sums.neighbours as u64;
        }
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
        match self.registry.dimension {
            2 => motions.constrain::<2>(chunk, self.core.velocity, bodies, rates),
            _ => motions.constrain::<3>(chunk, self.core.velocity, bodies, rates),
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

    /// A rate that is no number, before it reaches the state.
    fn first_bad(&self, chunk: &Chunk, workspace: &Workspace) -> Option<(ParticleId, &'static str)> {
        let dimension = self.registry.dimension;
        let n = chunk.len();
        // One sum per quantity: it is finite only if every term is (an overflow of the sum is worth a look, too).
        let finite = |words: &[Cell<u64>]| words.iter().map(|w| f64::from_bits(w.get()) * 0.0).sum::<f64>() == 0.0;
        let acceleration_finite = workspace.acceleration[..n * dimension].iter().map(|a| a * 0.0).sum::<f64>() == 0.0;
        let ids = chunk.view(self.core.id);
        let first = |bad: &dyn Fn(usize) -> bool| (0..n).filter(|&k| bad(k)).map(|k| ids.get(k)).min();
        if !acceleration_finite {
            let a =
                |k: usize| !workspace.acceleration[k * dimension..(k + 1) * dimension].iter().all(|a| a.is_finite());
            return first(&a).map(|id| (id, "acceleration"));
        }
        for (slot, &(value, _)) in self.registry.integrated.iter().enumerate() {
            let entry = &self.registry.entries[value];
            let block = &workspace.new_rates[slot][..n * entry.width];
            if !finite(block) {
                let width = entry.width;
                let bad =
                    |k: usize| !block[k * width..(k + 1) * width].iter().all(|w| f64::from_bits(w.get()).is_finite());
                return first(&bad).map(|id| (id, entry.info.name));
            }
        }
        None
    }
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

/// Whether the columns of a rank hold numbers only; for tests and restarts.
pub fn all_finite(columns: &Columns) -> bool {
    let numbers = columns.registry.entries.iter().enumerate().filter(|(_, e)| e.shape != crate::particles::Shape::Id);
    numbers.into_iter().all(|(index, _)| columns.numbers(index).iter().all(|x| x.is_finite()))
}
