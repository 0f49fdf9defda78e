//! Smoothing length that follows density:
//!
//!   h = h_0 (rho_0 / rho)^(1/d), kept within [smallest, largest] h_0.
//!
//! h_0 and rho_0 are those of the body at the start (Benz 1990, in The Numerical Modelling of Nonlinear Stellar Pulsations,
//! eq. 2.20, in closed form). Columns: smoothing_length (m) and its value at the last list build, on which lists and ghosts
//! stand. No time-step limit of its own: density changes by a limited share per step already.

use super::{Core, Local, MaterialEffect, Setup};
use crate::particles::{Column, ColumnInfo, Integrated, Life, Registry};

/// Bounds in units of the smoothing length at the start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    pub smallest: f64,
    pub largest: f64,
}

pub struct SmoothingLength {
    bounds: Bounds,
    planar: bool,
    value: Column<f64>,
    density: Integrated<f64>,
}

impl MaterialEffect for SmoothingLength {
    fn declare(setup: &Setup, registry: &mut Registry, core: &Core) -> Option<Self> {
        let bounds = setup.smoothing_length?;
        let info = |name, about, snapshot| ColumnInfo { name, unit: "m", about, life: Life::State, snapshot };
        registry.owner("smoothing_length");
        let value = registry.column(info("smoothing_length", "Smoothing length; the support is twice it.", false));
        let _at_build: Column<f64> =
            registry.column(info("build_smoothing_length", "Smoothing length at the last list build.", false));
        Some(Self { bounds, planar: setup.dimension == 2, value, density: core.density })
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
