//! Density that returns to mass over volume where continuity has let it drift away (an effect of the scene's numerics).
//!
//! ```text
//! d rho / dt = -rho div v + rho C (c / h) e     e = ln S / S_0 beyond +-ln(1 + b), else 0     C = 1/4
//! ```
//! S of [`sums`](super::sums), inside matter alone: spray and rigid bodies keep their density. S_0 is S at the start: how lattices meet is no
//! drift, and a coarse pile on a floor of its own lattice is lifted otherwise. b is what both may differ by; c is the speed of sound, so that
//! matter without pressure, whose density does nothing, is left as it is. S is measured in every eighth step, and its rate acts until the
//! next. Momentum and energy are kept exactly, as pairs exchange what they exchange at any density.

use super::sums::{Neighbours, Sums};
use crate::material::ParticleView;
use crate::pair::{Layout, Rows};
use crate::particles::{Chunk, Column, ColumnInfo, Integrated, Life, Rates, Registry};

/// Steps from one measurement to the next.
const EVERY: u64 = 8;
/// Share of the drift that returns while sound crosses h: half of it between two measurements at the Courant number of 0.25.
const SHARE: f64 = 0.25;

/// Whether density is measured in this step.
pub fn is_due(step: u64) -> bool {
    step.is_multiple_of(EVERY)
}

#[derive(Debug, Clone, Copy)]
pub struct DensityRelaxation {
    /// d ln rho / dt, 1/s.
    rate: Column<f64>,
    /// ln S_0.
    at_start: Column<f64>,
    /// ln(1 + b).
    free: f64,
    eta: f64,
}

impl DensityRelaxation {
    /// `beyond`: b; `eta`: h over (m / rho)^(1/d).
    pub fn declare(registry: &mut Registry, beyond: f64, eta: f64) -> Self {
        let about = "Rate at which density returns to mass over volume, over density.";
        let info = ColumnInfo { name: "density_relaxation", unit: "1/s", about, life: Life::Kept, snapshot: false };
        let owner = registry.owner("density_relaxation");
        let rate = owner.column(info);
        let about = "Logarithm of mass over volume over density at the start.";
        let at_start = owner.column(ColumnInfo { name: "packing_at_start", unit: "", about, ..info });
        Self { rate, at_start, free: libm::log1p(beyond), eta }
    }

    /// Measures the rate of a chunk's particles, whose records are in `rows`; `is_first`: before the first step.
    pub fn measure<const D: usize>(
        &self,
        chunk: &Chunk,
        rows: &Rows,
        layout: &Layout,
        view: &ParticleView,
        is_first: bool,
    ) {
        let (rate, at_start, ids) = (chunk.view(self.rate), chunk.view(self.at_start), chunk.view(view.core.id));
        let neighbours = Neighbours::<D>::new(rows, layout, self.eta);
        for (k, i) in chunk.range.clone().enumerate() {
            let body = ids.get(k).body();
            let sums = neighbours.sums(i);
            let h = view.smoothing_length(chunk, k, body);
            if is_first {
                at_start.set(k, if sums.is_inside() { sums.off() } else { 0.0 });
            }
            let excess = if view.is_rigid(body) { 0.0 } else { self.excess(&sums, at_start.get(k)) };
            rate.set(k, SHARE * excess * chunk.view(view.core.sound_speed).get(k) / h);
        }
    }

    /// e.
    fn excess(&self, sums: &Sums, at_start: f64) -> f64 {
        let off = if sums.is_inside() { sums.off() - at_start } else { 0.0 };
        off - off.clamp(-self.free, self.free)
    }

    /// Adds to the rates of density.
    pub fn add(&self, chunk: &Chunk, density: Integrated<f64>, rates: &Rates) {
        let (rho, rate, sum) = (chunk.view(density.value), chunk.view(self.rate), rates.view(density));
        for k in 0..chunk.len() {
            sum.set(k, sum.get(k) + rho.get(k) * rate.get(k));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_beyond_returns() {
        let mut registry = Registry::new(3);
        let relaxation = DensityRelaxation::declare(&mut registry, 0.05, 1.2);
        let with = |packing: f64, shift: f64| relaxation.excess(&Sums { packing, cover: 2.0, shift }, 0.0);
        let excess = |packing: f64| with(packing, 0.0);
        assert_eq!((excess(1.049), excess(1.0 / 1.049)), (0.0, 0.0));
        assert!((excess(2.1) - libm::log(2.0)).abs() < 1e-14 && (excess(1.0 / 2.1) + libm::log(2.0)).abs() < 1e-14);
        // A tenth of the neighbours is missing on one side; what is nearer to a surface is not judged.
        assert_eq!((with(0.9, 0.2), with(0.5, 0.3)), (0.0, 0.0));
        assert!(with(1.2, 0.2) > 0.1);
        let since = |packing: f64| relaxation.excess(&Sums { packing, cover: 2.0, shift: 0.0 }, libm::log(1.2));
        assert!(since(1.2) == 0.0 && (since(1.2 * 2.1) - libm::log(2.0)).abs() < 1e-14);
    }
}
