//! Pair records of owned particles from their columns: volume, damaged stress, artificial stress, viscosity. This is all
//! that neighbours, here or on other ranks, will read in the substep.

use std::ops::Range;

use crate::material::{BodyConstants, Core, fracture, porosity};
use crate::math::lanes::LANES;
use crate::math::{Deviator, Sym, Vec3};
use crate::pair::artificial_stress::artificial_stress;
use crate::pair::record::{Viscosity, set_half};
use crate::pair::{Layout, Terms, torque};
use crate::particles::{Chunk, Column, ColumnInfo, Columns, Life, Registry};

/// Columns that records are made of, and per-body numbers.
#[derive(Debug, Clone)]
pub struct Packer {
    core: Core,
    layout: Layout,
    /// What viscosity goes by in bodies that ask for it.
    loading_speed: Option<Column<f64>>,
    deviatoric_stress: Option<Column<Deviator>>,
    damage: Option<Column<f64>>,
    smoothing_length: Option<Column<f64>>,
    /// Where forces have no torque.
    pub moments: Option<Moments>,
    constants: Vec<BodyConstants>,
    bodies: Vec<BodyTraits>,
    /// Strength epsilon of the artificial stress.
    epsilon: f64,
    /// Spacing over smoothing length, to the power of the dimension, times two: V_max / h^d.
    most_volume: f64,
    /// Smoothing length over spacing.
    eta: f64,
}

/// Columns of the second moment M of each neighbourhood, at the last evaluation, and of how fast it changed.
#[derive(Debug, Clone, Copy)]
pub struct Moments {
    value: [Column<Vec3>; 2],
    rate: [Column<Vec3>; 2],
}

const MOMENTS: [(&str, &str, &str); 4] = [
    ("moment_diagonal", "", "Second moment of the neighbourhood: xx, yy, zz."),
    ("moment_off_diagonal", "", "The same: xy, xz, yz, in the plane xy and nothing."),
    ("moment_diagonal_rate", "1/s", "Its change over the last step: xx, yy, zz."),
    ("moment_off_diagonal_rate", "1/s", "The same: xy, xz, yz, in the plane xy and nothing."),
];

impl Moments {
    pub fn declare(registry: &mut Registry) {
        for (name, unit, about) in MOMENTS {
            let info = ColumnInfo { name, unit, about, life: Life::State, snapshot: false };
            registry.owner("no_torque").column::<Vec3>(info);
        }
    }

    fn find(registry: &Registry) -> Option<Self> {
        let column = |k: usize| registry.find(MOMENTS[k].0);
        Some(Self { value: [column(0)?, column(1)?], rate: [column(2)?, column(3)?] })
    }

    /// Keeps the moments of a chunk's particle, as the pair loop gives them after a step of `dt`, s.
    #[inline]
    pub fn keep(&self, chunk: &Chunk, (k, dimension): (usize, usize), m: &[f64; 6], dt: f64) {
        let new = match dimension {
            2 => [Vec3::new(m[0], m[1], 0.0), Vec3::new(m[2], 0.0, 0.0)],
            _ => [Vec3::new(m[0], m[1], m[2]), Vec3::new(m[3], m[4], m[5])],
        };
        let [value, rate] = [self.value, self.rate].map(|columns| columns.map(|column| chunk.view(column)));
        // Before the first evaluation there is none.
        let known = dt > 0.0 && value[0].get(k) != Vec3::zeros();
        for part in 0..2 {
            rate[part].set(k, if known { (new[part] - value[part].get(k)) / dt } else { Vec3::zeros() });
            value[part].set(k, new[part]);
        }
    }

    /// M of particle `i` a step of `dt` after the last evaluation, as it changed before.
    fn expected(&self, columns: &Columns, i: usize, dt: f64) -> Sym {
        let [on, off] = [0, 1].map(|part| columns.get(self.value[part], i) + columns.get(self.rate[part], i) * dt);
        Sym { xx: on.x, yy: on.y, zz: on.z, xy: off.x, xz: off.y, yz: off.z }
    }
}

/// What the material of a body says about records.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BodyTraits {
    /// (alpha, beta).
    pub viscosity: (f64, f64),
    /// Whether viscosity goes by the speed of further compression.
    pub by_loading: bool,
    /// Whether damage acts on shear through the yield strength alone.
    pub friction: bool,
    /// Damage, where there is no fracture.
    pub fixed_damage: Option<f64>,
}

/// What a scene says about records.
#[derive(Debug, Clone)]
pub struct PackSettings {
    pub terms: Terms,
    pub constants: Vec<BodyConstants>,
    pub bodies: Vec<BodyTraits>,
    pub artificial_stress_factor: f64,
    /// Smoothing length over spacing.
    pub eta: f64,
}

impl Packer {
    pub fn new(registry: &Registry, core: Core, settings: PackSettings) -> Self {
        let dimension = registry.dimension;
        Self {
            core,
            layout: Layout { dimension, terms: settings.terms },
            loading_speed: registry.find(porosity::LOADING_SPEED),
            deviatoric_stress: registry.find("deviatoric_stress"),
            damage: registry.find("damage"),
            smoothing_length: registry.find("smoothing_length"),
            moments: Moments::find(registry),
            constants: settings.constants,
            bodies: settings.bodies,
            epsilon: settings.artificial_stress_factor,
            most_volume: 2.0 / settings.eta.powi(dimension as i32),
            eta: settings.eta,
        }
    }

    /// Smoothing length over spacing, as the scene has it.
    pub fn eta(&self) -> f64 {
        self.eta
    }

    /// Smoothing length of particle `i` of `body`, m.
    #[inline]
    pub fn smoothing_length(&self, columns: &Columns, i: usize, body: usize) -> f64 {
        match self.smoothing_length {
            Some(column) => columns.get(column, i),
            None => self.constants[body].smoothing_length,
        }
    }

    /// The same for particle `k` of a chunk.
    #[inline]
    pub fn chunk_smoothing_length(&self, chunk: &Chunk, k: usize, body: usize) -> f64 {
        match self.smoothing_length {
            Some(column) => chunk.view(column).get(k),
            None => self.constants[body].smoothing_length,
        }
    }

    /// Damage of particle `i` of `body`; 0 where nothing breaks.
    #[inline]
    pub fn damage(&self, columns: &Columns, i: usize, body: usize) -> f64 {
        let grown = || self.damage.map_or(0.0, |column| columns.get(column, i));
        self.bodies[body].fixed_damage.unwrap_or_else(grown)
    }

    /// Whether damage acts on shear of a body through its yield strength alone.
    pub fn has_friction(&self, body: usize) -> bool {
        self.bodies[body].friction
    }

    /// alpha and beta of a body.
    #[inline]
    pub fn viscosity(&self, body: usize) -> (f64, f64) {
        self.bodies[body].viscosity
    }

    /// Writes the records of owned particles `range`, a step of `dt` after the last evaluation, to `slots[i] * stride`.
    ///
    /// # Safety
    /// `records` must have room for every slot, and no one else may write to the slots of `range` meanwhile.
    pub unsafe fn pack(&self, columns: &Columns, (range, dt): (Range<usize>, f64), slots: &[u32], records: *mut f64) {
        let stride = self.layout.stride();
        // SAFETY: the slot's record lies within `records` and belongs to this particle alone, and no other slice of it lives.
        let record =
            |i: usize| unsafe { std::slice::from_raw_parts_mut(records.add(slots[i] as usize * stride), stride) };
        for start in range.clone().step_by(LANES) {
            let eight = start..range.end.min(start + LANES);
            let (mut stresses, mut moments) = ([[0.0; LANES]; 6], [[0.0; LANES]; 6]);
            for (k, i) in eight.clone().enumerate() {
                let stress = self.pack_one(columns, i, record(i));
                if let Some(known) = &self.moments {
                    spread(&stress, k, &mut stresses);
                    spread(&known.expected(columns, i, dt), k, &mut moments);
                }
            }
            if self.moments.is_some() {
                let plane = self.layout.dimension == 2;
                let axials = if plane { torque::axials::<2> } else { torque::axials::<3> };
                for (w, i) in axials(&stresses, &moments).iter().zip(eight) {
                    let (to, first) = (self.layout.axial(), if plane { 2 } else { 0 });
                    (first..3).for_each(|k| set_half(record(i), to + k - first, w[k]));
                }
            }
        }
    }

    /// Writes all but w, and returns the stress that neighbours see, Pa.
    fn pack_one(&self, columns: &Columns, i: usize, record: &mut [f64]) -> Sym {
        let layout = &self.layout;
        let body = columns.get(self.core.id, i).body();
        let constants = &self.constants[body];
        let (x, v) = (columns.get(self.core.position, i), columns.get(self.core.velocity, i));
        for a in 0..layout.dimension {
            record[a] = x[a];
            record[layout.dimension + a] = v[a];
        }
        let h = self.smoothing_length(columns, i, body);
        let density = columns.get(self.core.density.value, i);
        let h_power = if layout.dimension == 2 { h * h } else { h * h * h };
        let volume = (constants.particle_mass / density).min(self.most_volume * h_power);
        record[layout.volume()] = volume;
        set_half(record, layout.density(), constants.particle_mass / volume);
        set_half(record, layout.h_inverse(), 1.0 / h);
        let (alpha, beta) = self.bodies[body].viscosity;
        if layout.terms.viscosity != Viscosity::Off {
            let speed = self.loading_speed.filter(|_| self.bodies[body].by_loading).unwrap_or(self.core.sound_speed);
            set_half(record, layout.alpha_c(), alpha * columns.get(speed, i));
        }
        if layout.terms.viscosity == Viscosity::OwnBeta {
            set_half(record, layout.beta(), beta);
        }
        let pressure = columns.get(self.core.pressure, i);
        if !layout.terms.tensor {
            record[layout.stress()] = -fracture::damaged_pressure(pressure, self.damage(columns, i, body));
            return Sym::ZERO;
        }
        let stress = self.damaged_stress(columns, (i, body), pressure);
        write_tensor(layout.dimension, &stress, &mut record[layout.stress()..]);
        if layout.terms.artificial_stress {
            let mut words = [0.0; 6];
            write_tensor(layout.dimension, &artificial_stress(&stress, self.epsilon), &mut words);
            (0..layout.tensor_words()).for_each(|k| set_half(record, layout.artificial() + k, words[k]));
        }
        stress
    }

    /// The stress that neighbours see: deviator and tension weakened by damage, never written back.
    fn damaged_stress(&self, columns: &Columns, (i, body): (usize, usize), pressure: f64) -> Sym {
        let s = self.deviatoric_stress.map_or(Deviator::default(), |column| columns.get(column, i));
        fracture::damaged_stress(&s, pressure, self.damage(columns, i, body), self.bodies[body].friction)
    }
}

fn spread(t: &Sym, k: usize, to: &mut torque::Syms) {
    for (to, x) in to.iter_mut().zip([t.xx, t.yy, t.zz, t.xy, t.xz, t.yz]) {
        to[k] = x;
    }
}

/// xx yy zz xy xz yz, or xx yy xy in 2D.
fn write_tensor(dimension: usize, s: &Sym, words: &mut [f64]) {
    if dimension == 2 {
        words[..3].copy_from_slice(&[s.xx, s.yy, s.xy]);
    } else {
        words[..6].copy_from_slice(&[s.xx, s.yy, s.zz, s.xy, s.xz, s.yz]);
    }
}

/// Stress of a record as a tensor; in 2D the out-of-plane components, which do no work, are left zero.
pub fn read_stress(layout: &Layout, record: &[f64]) -> Sym {
    let s = &record[layout.stress()..];
    match (layout.terms.tensor, layout.dimension) {
        (false, _) => Sym { xx: s[0], yy: s[0], zz: s[0], ..Sym::ZERO },
        (true, 2) => Sym { xx: s[0], yy: s[1], xy: s[2], ..Sym::ZERO },
        (true, _) => Sym { xx: s[0], yy: s[1], zz: s[2], xy: s[3], xz: s[4], yz: s[5] },
    }
}
