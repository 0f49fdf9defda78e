//! Motion that a scene prescribes for whole bodies or for layers of them: walls, pistons, rollers, absorbing layers.
//! It acts on accelerations, after the sums over pairs and before the corrector:
//!
//! ```text
//! fixed, velocity   v = V for ever,                 a = 0
//! along             only the named components move, a_k = 0 for the others
//! damping           a' = a - (v - V) / tau          (V: the velocity at the start; for ever, or until a time)
//! ```
//!
//! A prescribed motion does work on a particle and changes its momentum. Both are integrated like other quantities, so that
//! conservation can be checked with walls, too: dW/dt = m (a' - a).v and dJ/dt = m (a' - a), with a the free acceleration. Energy
//! less W and momentum less J stay constant.

pub mod rigid;

use serde::{Deserialize, Serialize};

use crate::math::Vec3;
use crate::particles::{Chunk, Column, ColumnInfo, Columns, Integrated, Life, Rates, Registry};

/// Largest step over the time constant of a damping layer.
const DAMPING_STEP: f64 = 0.25;

/// How a particle may move.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, Default)]
pub enum PrescribedMotion {
    /// By the forces alone.
    #[default]
    Free,
    /// With this velocity, m/s, whatever the forces.
    Prescribed([f64; 3]),
    /// Along these axes only.
    Along([bool; 3]),
    /// Towards its body's first velocity (m/s), within about this time, s, up to the time `until`, s, where it ends.
    Damped { time: f64, towards: [f64; 3], until: Option<f64> },
}

impl PrescribedMotion {
    /// The velocity that a particle starts with, m/s.
    pub fn start(&self, velocity: [f64; 3]) -> [f64; 3] {
        match self {
            PrescribedMotion::Prescribed(given) => *given,
            PrescribedMotion::Along(free) => std::array::from_fn(|k| if free[k] { velocity[k] } else { 0.0 }),
            PrescribedMotion::Free | PrescribedMotion::Damped { .. } => velocity,
        }
    }

    /// Whether forces alone move it at the time `now`, s.
    #[inline]
    pub fn is_free(&self, now: f64) -> bool {
        match self {
            PrescribedMotion::Free => true,
            PrescribedMotion::Damped { until, .. } => until.is_some_and(|until| now > until),
            PrescribedMotion::Prescribed(_) | PrescribedMotion::Along(_) => false,
        }
    }

    #[inline]
    fn constrained(&self, free: Vec3, velocity: Vec3) -> Vec3 {
        match self {
            PrescribedMotion::Free => free,
            PrescribedMotion::Prescribed(_) => Vec3::zeros(),
            PrescribedMotion::Along(along) => Vec3::from_fn(|k, _| if along[k] { free[k] } else { 0.0 }),
            PrescribedMotion::Damped { time, towards, .. } => free - (velocity - Vec3::from(*towards)) / *time,
        }
    }
}

/// The particles of a chunk whose motion may be prescribed.
#[derive(Clone, Copy)]
pub struct Moving<'a> {
    pub chunk: &'a Chunk<'a>,
    pub velocity: Column<Vec3>,
    /// Body of each particle.
    pub bodies: &'a [u16],
    /// s since the start.
    pub now: f64,
}

/// The largest step that damping allows, s, and for which particle of a chunk.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DampingLimit {
    pub dt: f64,
    pub particle: usize,
}

/// The prescribed motions of a scene, and their work and impulse so far.
#[derive(Debug, Clone)]
pub struct Motions {
    /// Motions of whole bodies.
    pub bodies: Vec<PrescribedMotion>,
    /// Motions of layers; numbered from one on in the column.
    pub layers: Vec<PrescribedMotion>,
    /// Layer of each particle, zero outside; only where there are layers.
    pub layer: Option<Column<f64>>,
    /// Work done on the particle by its prescribed motion, J.
    pub work: Integrated<f64>,
    /// Momentum added by its prescribed motion, kg m/s.
    pub impulse: Integrated<Vec3>,
    masses: Vec<f64>,
}

impl Motions {
    /// Declares the columns, or `None` where everything moves freely: then nothing of this exists. `masses`: mass of a particle
    /// of each body, kg.
    pub fn declare(
        bodies: Vec<PrescribedMotion>,
        layers: Vec<PrescribedMotion>,
        masses: Vec<f64>,
        registry: &mut Registry,
    ) -> Option<Self> {
        if layers.is_empty() && bodies.iter().all(|motion| *motion == PrescribedMotion::Free) {
            return None;
        }
        let state = |name, unit, about| ColumnInfo { name, unit, about, life: Life::State, snapshot: false };
        registry.owner("motion");
        let layer = "Number of the layer that prescribes the particle's motion, zero outside.";
        let work = "Work done on the particle by its prescribed motion.";
        let impulse = "Momentum added to the particle by its prescribed motion.";
        Some(Self {
            layer: (!layers.is_empty())
                .then(|| registry.column(ColumnInfo { life: Life::Kept, snapshot: true, ..state("layer", "", layer) })),
            work: registry.integrated(state("boundary_work", "J", work)),
            impulse: registry.integrated(state("boundary_impulse", "kg m/s", impulse)),
            bodies,
            layers,
            masses,
        })
    }

    /// Whether a velocity is prescribed to particle `i` of a body.
    pub fn holds(&self, columns: &Columns, i: usize, body: usize) -> bool {
        let layer = self.layer.map_or(0, |column| columns.get(column, i) as usize);
        let motion = if layer == 0 { &self.bodies[body] } else { &self.layers[layer - 1] };
        matches!(motion, PrescribedMotion::Prescribed(_))
    }

    /// Changes the velocity of particle `i` by `change`, m/s, as far as its motion follows; the rest is impulse and work of its motion.
    pub fn push(&self, columns: &mut Columns, velocity: Column<Vec3>, i: usize, body: usize, change: Vec3) {
        let layer = self.layer.map_or(0, |column| columns.get(column, i) as usize);
        let motion = if layer == 0 { &self.bodies[body] } else { &self.layers[layer - 1] };
        let followed = match motion {
            PrescribedMotion::Free | PrescribedMotion::Damped { .. } => change,
            PrescribedMotion::Prescribed(_) => Vec3::zeros(),
            PrescribedMotion::Along(along) => Vec3::from_fn(|k, _| if along[k] { change[k] } else { 0.0 }),
        };
        let (v, kept) = (columns.get(velocity, i), self.masses[body] * (followed - change));
        columns.set(velocity, i, v + followed);
        columns.set(self.work.value, i, columns.get(self.work.value, i) + kept.dot(&v));
        columns.set(self.impulse.value, i, columns.get(self.impulse.value, i) + kept);
    }

    fn of(&self, chunk: &Chunk, k: usize, body: usize) -> &PrescribedMotion {
        let layer = self.layer.map_or(0, |column| chunk.view(column).get(k) as usize);
        if layer == 0 { &self.bodies[body] } else { &self.layers[layer - 1] }
    }

    /// Turns the free accelerations of a chunk into those of its motions and writes the rates of work and impulse. Returns the
    /// largest step that damping allows, and for which particle.
    pub fn constrain<const D: usize>(&self, moving: &Moving, rates: &Rates) -> Option<DampingLimit> {
        let &Moving { chunk, velocity, bodies, now } = moving;
        let velocity = chunk.view(velocity);
        let (work, impulse) = (rates.view(self.work), rates.view(self.impulse));
        let mut limit: Option<DampingLimit> = None;
        for (k, a) in rates.acceleration.as_chunks::<D>().0.iter().take(chunk.len()).enumerate() {
            let body = bodies[k] as usize;
            let motion = self.of(chunk, k, body);
            if motion.is_free(now) {
                continue;
            }
            let v = velocity.get(k);
            let free = Vec3::from_fn(|axis, _| if axis < D { a[axis].get() } else { 0.0 });
            let held = motion.constrained(free, v);
            let rate = self.masses[body] * (held - free);
            work.set(k, rate.dot(&v));
            impulse.set(k, rate);
            (0..D).for_each(|axis| a[axis].set(held[axis]));
            if let PrescribedMotion::Damped { time, .. } = motion
                && limit.is_none_or(|least| DAMPING_STEP * time < least.dt)
            {
                limit = Some(DampingLimit { dt: DAMPING_STEP * time, particle: k });
            }
        }
        limit
    }
}
