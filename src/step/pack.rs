//! Pair records of owned particles from their columns: volume, damaged stress, artificial stress, viscosity. Neighbours, on this
//! rank or others, read nothing else in the substep.

use std::ops::Range;

use super::slopes::Slopes;
use crate::material::{ParticleView, Viscosity};
use crate::math::lanes::LANES;
use crate::math::{Sym, Vec3};
use crate::pair::artificial_stress::artificial_stress;
use crate::pair::record::{ViscousTerm, set_half};
use crate::pair::{Layout, angular_momentum};
use crate::particles::{Chunk, Column, ColumnInfo, Columns, Life, Registry};

/// Makes records from columns.
#[derive(Debug, Clone)]
pub struct Packer {
    view: ParticleView,
    layout: Layout,
    /// Where angular momentum is conserved.
    pub moments: Option<Moments>,
    /// Where viscosity is reconstructed.
    pub slopes: Option<Slopes>,
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
    ("moment_off_diagonal", "", "Second moment of the neighbourhood: xy, xz, yz; in 2D xy alone."),
    ("moment_diagonal_rate", "1/s", "Rate of the second moment over the last step: xx, yy, zz."),
    ("moment_off_diagonal_rate", "1/s", "Rate of the second moment over the last step: xy, xz, yz; in 2D xy alone."),
];

impl Moments {
    pub fn declare(registry: &mut Registry) {
        for (name, unit, about) in MOMENTS {
            let info = ColumnInfo { name, unit, about, life: Life::Kept, snapshot: false };
            registry.owner("angular_momentum").column::<Vec3>(info);
        }
    }

    fn find(registry: &Registry) -> Option<Self> {
        let column = |k: usize| registry.find(MOMENTS[k].0);
        Some(Self { value: [column(0)?, column(1)?], rate: [column(2)?, column(3)?] })
    }

    /// Keeps the moments of a chunk's particle, as the pair loop gives them after a step of `dt`, s.
    #[inline]
    pub fn keep(&self, chunk: &Chunk, k: usize, dimension: usize, m: &[f64; 6], dt: f64) {
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

    /// M of particle `i` a step of `dt` after the last evaluation, extrapolated.
    fn expected(&self, columns: &Columns, i: usize, dt: f64) -> Sym {
        let [on, off] = [0, 1].map(|part| columns.get(self.value[part], i) + columns.get(self.rate[part], i) * dt);
        Sym { xx: on.x, yy: on.y, zz: on.z, xy: off.x, xz: off.y, yz: off.z }
    }
}

impl Packer {
    /// A packer for records of this layout. `epsilon`: strength of the artificial stress; `eta`: smoothing length over spacing.
    pub fn new(registry: &Registry, view: &ParticleView, layout: &Layout, epsilon: f64, eta: f64) -> Self {
        Self {
            view: view.clone(),
            layout: *layout,
            moments: Moments::find(registry),
            slopes: Slopes::find(registry),
            epsilon,
            most_volume: 2.0 / eta.powi(registry.dimension as i32),
            eta,
        }
    }

    /// Smoothing length over spacing, as the scene has it.
    pub fn eta(&self) -> f64 {
        self.eta
    }

    /// Writes the records of owned particles `range`, a step of `dt` after the last evaluation, to `slots[i] * stride`.
    ///
    /// # Safety
    /// `records` must have room for every slot, and no one else may write to the slots of `range` meanwhile.
    pub unsafe fn pack(&self, columns: &Columns, range: Range<usize>, dt: f64, slots: &[u32], records: *mut f64) {
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
                let axials = if plane { angular_momentum::axials::<2> } else { angular_momentum::axials::<3> };
                for (w, i) in axials(&stresses, &moments).iter().zip(eight) {
                    let (to, first) = (self.layout.axial(), if plane { 2 } else { 0 });
                    (first..3).for_each(|k| set_half(record(i), to + k - first, w[k]));
                }
            }
        }
    }

    /// Writes all but w, and returns the stress that acts on neighbours, Pa.
    fn pack_one(&self, columns: &Columns, i: usize, record: &mut [f64]) -> Sym {
        let (layout, view) = (&self.layout, &self.view);
        let body = columns.get(view.core.id, i).body();
        let constants = &view.constants[body];
        let (x, v) = (columns.get(view.core.position, i), columns.get(view.core.velocity, i));
        for a in 0..layout.dimension {
            record[a] = x[a];
            record[layout.dimension + a] = v[a];
        }
        let h = view.smoothing_length(columns, i, body);
        let density = columns.get(view.core.density.value, i);
        let h_power = if layout.dimension == 2 { h * h } else { h * h * h };
        let volume = (constants.particle_mass / density).min(self.most_volume * h_power);
        record[layout.volume()] = volume;
        let standing = view.standing(body);
        set_half(record, layout.density(), standing * constants.particle_mass / volume);
        set_half(record, layout.h_inverse(), 1.0 / h);
        let Viscosity { alpha, beta } = view.viscosity(columns, i, body);
        if layout.terms.viscosity != ViscousTerm::Off {
            set_half(record, layout.alpha_c(), alpha * view.viscous_speed(columns, i, body) / standing);
        }
        if matches!(layout.terms.viscosity, ViscousTerm::OwnBeta | ViscousTerm::Reconstructed) {
            set_half(record, layout.beta(), beta);
        }
        if let Some(slopes) = &self.slopes {
            write_halves(layout, &slopes.of(columns, i), layout.slope(), record);
        }
        if !layout.terms.tensor() {
            record[layout.stress()] = -view.acting_pressure(columns, i, body);
            return Sym::ZERO;
        }
        let stress = view.acting_stress(columns, i, body);
        write_tensor(layout.dimension, &stress, &mut record[layout.stress()..]);
        if layout.terms.artificial_stress() {
            write_halves(layout, &artificial_stress(&stress, self.epsilon), layout.artificial(), record);
        }
        stress
    }
}

fn spread(t: &Sym, k: usize, to: &mut angular_momentum::Syms) {
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

/// The same in numbers of 32 bits, the first of them number `to`.
fn write_halves(layout: &Layout, s: &Sym, to: usize, record: &mut [f64]) {
    let mut words = [0.0; 6];
    write_tensor(layout.dimension, s, &mut words);
    (0..layout.tensor_words()).for_each(|k| set_half(record, to + k, words[k]));
}

/// Stress of a record as a tensor; in 2D the out-of-plane components, which do no work, are left zero.
pub fn read_stress(layout: &Layout, record: &[f64]) -> Sym {
    let s = &record[layout.stress()..];
    match (layout.terms.tensor(), layout.dimension) {
        (false, _) => Sym { xx: s[0], yy: s[0], zz: s[0], ..Sym::ZERO },
        (true, 2) => Sym { xx: s[0], yy: s[1], xy: s[2], ..Sym::ZERO },
        (true, _) => Sym { xx: s[0], yy: s[1], zz: s[2], xy: s[3], xz: s[4], yz: s[5] },
    }
}
