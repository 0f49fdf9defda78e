//! Whether density is still mass over volume. Continuity integrates density without regard to the places of particles; where they
//! pass through each other, or are compressed by spurious forces, the two differ. Inside matter
//!
//! ```text
//! S_i = sum_j V_j W_ij     V = m / rho     is 1 where density is mass over volume,
//! ```
//! of whatever materials and spacings: 2 where particles are twice as dense as their densities. A particle is inside where it has
//! at least half of the surrounding matter that it has in its lattice, evenly distributed:
//!
//! ```text
//! C_i = sum_j v_j W_ij >= 1/2     |sum_j v_j (x_j - x_i) W_ij| <= h C_i / 10     v = (h / eta)^d
//! ```
//! Spray and surfaces, where S is meaningless, thus do not count; but matter with so little around it cannot be dense: at twice its
//! initial density it has kept a density that is no longer true. W is the cubic spline whatever the scene's kernel: any would do.
//! The sums run over the lists and records of the last evaluation.

use super::Stepper;
use crate::kernel::{CubicSpline, SUPPORT, Shape};
use crate::pair::record::half;
use crate::pair::{Layout, Rows};

/// S beyond this or below its inverse is off.
pub const FACTOR: f64 = 1.5;
/// No surface is as dense as that.
const COMPRESSED: f64 = 2.0;
const LEAST_COVER: f64 = 0.5;
const MOST_SHIFT: f64 = 0.1;

/// Counts of one body's particles, on all ranks.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Packing {
    /// Particles inside matter.
    pub inside: u64,
    /// Those of them that are packed more densely than their density, by [`FACTOR`].
    pub crowded: u64,
    /// Those that are packed less densely.
    pub sparse: u64,
    /// Particles with less than half of the matter around them, twice as dense as initially.
    pub alone: u64,
}

impl Packing {
    /// Particles whose density is off.
    pub fn off(&self) -> u64 {
        self.crowded + self.sparse + self.alone
    }

    /// Particles that can be judged.
    pub fn judged(&self) -> u64 {
        self.inside + self.alone
    }
}

/// Sums over a row of neighbours.
#[derive(Debug, Clone, Copy, Default)]
struct Sums {
    /// S.
    packing: f64,
    /// C.
    cover: f64,
    /// Modulus of the first moment of C, over h.
    shift: f64,
}

impl Sums {
    fn is_inside(&self) -> bool {
        self.cover >= LEAST_COVER && self.shift <= MOST_SHIFT * self.cover
    }
}

impl<const D: usize> Stepper<'_, D> {
    /// One for each body; all are zero where no step has been taken since lists were released. Collective.
    pub fn packing(&self) -> Vec<Packing> {
        let mut counts = vec![0i64; 4 * self.settings.view.constants.len()];
        if let Some(rows) = self.rows() {
            let neighbours =
                Neighbours::<D> { rows, layout: *self.settings.pair_loop.layout(), eta: self.settings.packer.eta() };
            for i in 0..self.columns.len() {
                let sums = neighbours.sums(i);
                let body = self.columns.get(self.settings.view.core.id, i).body();
                let density = self.columns.get(self.settings.view.core.density.value, i);
                let is_dense = density > COMPRESSED * self.settings.view.constants[body].density;
                let inside = sums.is_inside();
                let [crowded, sparse] = [sums.packing > FACTOR, sums.packing < 1.0 / FACTOR].map(|off| inside && off);
                let alone = is_dense && sums.cover > 0.0 && sums.cover < LEAST_COVER;
                let is = [inside, crowded, sparse, alone];
                counts[4 * body..].iter_mut().zip(is).for_each(|(count, is)| *count += is as i64);
            }
        }
        self.comm.all_sum(&mut counts);
        let of = |c: [u64; 4]| Packing { inside: c[0], crowded: c[1], sparse: c[2], alone: c[3] };
        counts.as_chunks::<4>().0.iter().map(|counts| of(counts.map(|n| n as u64))).collect()
    }
}

/// Lists and records of the last evaluation.
struct Neighbours<'a, const D: usize> {
    rows: Rows<'a>,
    layout: Layout,
    eta: f64,
}

impl<const D: usize> Neighbours<'_, D> {
    fn record(&self, slot: u32) -> &[f64] {
        &self.rows.records[slot as usize * self.layout.stride()..][..self.layout.words()]
    }

    /// Sums of row `i`; zero where its record has not been made.
    fn sums(&self, i: usize) -> Sums {
        let own = self.record(self.rows.slots[i]);
        let g_i = half(own, self.layout.h_inverse());
        if g_i == 0.0 {
            return Sums::default();
        }
        let lattice_volume = |g: f64| (g * self.eta).powi(-(D as i32));
        let w_0 = CubicSpline::normalisation::<D>() * g_i.powi(D as i32) * CubicSpline::value(0.0);
        let (mut packing, mut cover) = (w_0 * own[self.layout.volume()], w_0 * lattice_volume(g_i));
        let mut shift = [0.0; D];
        for &slot in &self.rows.entries[self.rows.offsets[i]..self.rows.offsets[i + 1]] {
            let other = self.record(slot);
            let g_j = half(other, self.layout.h_inverse());
            let g = 0.5 * (g_i + g_j);
            let x: [f64; D] = std::array::from_fn(|k| other[k] - own[k]);
            let q = g * x.iter().map(|x| x * x).sum::<f64>().sqrt();
            if q >= SUPPORT {
                continue;
            }
            let w = CubicSpline::normalisation::<D>() * g.powi(D as i32) * CubicSpline::value(q);
            let v = w * lattice_volume(g_j);
            packing += w * other[self.layout.volume()];
            cover += v;
            shift.iter_mut().zip(x).for_each(|(sum, x)| *sum += v * x * g);
        }
        Sums { packing, cover, shift: shift.iter().map(|x| x * x).sum::<f64>().sqrt() }
    }
}
