//! Smoothing length that follows density:
//!
//!   h = h_0 (rho_0 / rho)^(1/d), kept within [smallest, largest] h_0.
//!
//! h_0 and rho_0 are those of the body at the start (Benz 1990, in The Numerical Modelling of Nonlinear Stellar Pulsations,
//! eq. 2.20, in closed form). Columns: smoothing_length (m) and its value at the last list build, on which lists and ghosts
//! are based. No time-step limit of its own: density changes by a limited share per step already.

use super::setup::Bounds;
use super::{Core, Local, MaterialEffect, Setup};
use crate::error::Result;
use crate::particles::{Column, ColumnInfo, Integrated, Life, Registry};

/// Names of the columns.
pub const SMOOTHING_LENGTH: &str = "smoothing_length";
pub const AT_BUILD: &str = "build_smoothing_length";

pub struct SmoothingLength {
    bounds: Bounds,
    planar: bool,
    value: Column<f64>,
    density: Integrated<f64>,
}

impl MaterialEffect for SmoothingLength {
    fn declare(setup: &Setup, registry: &mut Registry, core: &Core) -> Result<Option<Self>> {
        let Some(bounds) = setup.smoothing_length else { return Ok(None) };
        let info = |name, about, life| ColumnInfo { name, unit: "m", about, life, snapshot: false };
        registry.owner("smoothing_length");
        let about = "Smoothing length; the radius of the kernel's support is twice as large.";
        let value = registry.column(info(SMOOTHING_LENGTH, about, Life::State));
        registry.column::<f64>(info(AT_BUILD, "Smoothing length at the last list build.", Life::Kept));
        Ok(Some(Self { bounds, planar: setup.dimension == 2, value, density: core.density }))
    }

    fn name(&self) -> &'static str {
        "smoothing_length"
    }

    fn initialise(&self, local: &Local) {
        self.update(local);
    }

    fn update(&self, local: &Local) {
        let (h, density) = (local.view(self.value), local.view(self.density.value));
        for k in 0..local.len() {
            let body = &local.constants[local.bodies[k] as usize];
            let ratio = body.density / density.get(k);
            let stretch = if self.planar { ratio.sqrt() } else { libm::cbrt(ratio) };
            h.set(k, body.smoothing_length * stretch.clamp(self.bounds.smallest, self.bounds.largest));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::gas;
    use super::super::{BodyConstants, Records, declare_core};
    use super::*;
    use crate::particles::chunk::Chunks;
    use crate::particles::{Columns, Rates};

    /// h over h_0 where density is `ratio` times that at the start.
    fn stretch(dimension: usize, ratio: f64) -> f64 {
        let (density, smoothing_length) = (2700.0, 1.2);
        let constants =
            [BodyConstants { particle_mass: 1.0, smoothing_length, particles: 1, density, distention: 1.0 }];
        let setup = Setup {
            dimension,
            materials: &[gas()],
            body_material: &[0],
            constants: &constants,
            initial_damage: &[0.0],
            records: Records::default(),
            smoothing_length: Some(Bounds { smallest: 0.25, largest: 5.0 }),
        };
        let mut registry = Registry::new(dimension);
        let core = declare_core(&mut registry);
        let effect = SmoothingLength::declare(&setup, &mut registry, &core).expect("nothing is missing");
        let effect = effect.expect("bounds request it");
        let rates = Rates::new(&registry);
        let mut columns = Columns::new(registry);
        columns.resize(1);
        columns.set(core.density.value, 0, ratio * density);
        let chunks = Chunks::new(&mut columns, Vec::new());
        // SAFETY: the only chunk.
        let chunk = unsafe { chunks.chunk(0..1) };
        effect.update(&Local { chunk: &chunk, bodies: &[0], constants: &constants, flow: &[], rates: &rates, dt: 0.0 });
        columns.get(effect.value, 0) / smoothing_length
    }

    /// Mass in a ball, or a disc, of radius h stays the same; bounds hold.
    #[test]
    fn smoothing_lengths_keep_the_number_of_neighbours() {
        for (dimension, ratio, expected) in
            [(3, 8.0, 0.5), (2, 4.0, 0.5), (3, 1.0 / 64.0, 4.0), (2, 1.0 / 16.0, 4.0), (3, 1e3, 0.25), (2, 1e-3, 5.0)]
        {
            let found = stretch(dimension, ratio);
            assert!((found / expected - 1.0).abs() < 1e-12, "{dimension}D, {ratio}: {found}");
        }
    }
}
