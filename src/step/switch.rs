//! The share of alpha that a particle has: all of it where compression steepens, and ever less of it afterwards (after Cullen & Dehnen
//! 2010, MNRAS 408, 669).
//!
//! ```text
//! n = h^2 max(-d(div v)/dt, 0)     share = max(n / (n + X c^2), floor + (share before - floor) / (1 + dt c / (10 h)))     X = 0.02
//! ```
//! n / c^2 is about the Mach number of a shock that passes, and (k h)^2 u / c in a wave of amplitude u: shocks have all, sound and shear the
//! floor. d(div v)/dt is the difference of two evaluations.

use crate::material::ParticleView;
use crate::material::viscosity::SWITCH;
use crate::particles::{Chunk, Column, ColumnInfo, Life, Registry};

/// Steepening over c^2 / h^2 from which on most of alpha is there.
const STEEP: f64 = 0.02;
/// Times in which sound crosses h until what is above the floor has fallen to half.
const FADES: f64 = 10.0;

#[derive(Debug, Clone, Copy)]
pub struct ViscositySwitch {
    share: Column<f64>,
    floor: f64,
}

impl ViscositySwitch {
    /// `floor`: least share of alpha.
    pub fn declare(registry: &mut Registry, floor: f64) -> Self {
        let about = "Share of alpha of viscosity.";
        let info = ColumnInfo { name: SWITCH, unit: "", about, life: Life::Kept, snapshot: true };
        Self { share: registry.owner("viscosity_switch").column(info), floor }
    }

    /// Takes by how much the divergence, 1/s, of a chunk's particle has changed within `dt` seconds; the first one says nothing.
    #[inline]
    pub fn keep(&self, chunk: &Chunk, k: usize, view: &ParticleView, change: f64, dt: f64) {
        let share = chunk.view(self.share);
        let body = chunk.view(view.core.id).get(k).body();
        let (h, c) = (view.smoothing_length(chunk, k, body), view.viscous_speed(chunk, k, body));
        let last = Last { share: share.get(k), steepening: -h * h * change / dt };
        share.set(k, if dt > 0.0 { last.share(self.floor, c, dt / h) } else { 1.0 });
    }
}

struct Last {
    share: f64,
    /// Of compression, times h^2, m^2/s^2.
    steepening: f64,
}

impl Last {
    /// The share after a step whose length over h is `step`, s/m, in matter with waves of speed `c`, m/s.
    fn share(&self, floor: f64, c: f64, step: f64) -> f64 {
        let left = floor + (self.share - floor) / (1.0 + step * c / FADES);
        let n = self.steepening;
        if n > 0.0 { left.max(n / (n + STEEP * c * c)) } else { left }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shock_has_all_and_a_wave_the_floor() {
        let share = |share: f64, steepening: f64, step: f64| Last { share, steepening }.share(0.1, 1.0, step);
        assert!(
            share(0.1, 1.0, 0.2) > 0.98 && (share(0.1, 0.02, 0.2) - 0.5).abs() < 1e-12 && share(0.1, 1e-4, 0.2) == 0.1
        );
        assert_eq!(share(0.1, -1.0, 0.2), 0.1);
        // Half of what is above the floor is gone when sound has crossed ten h.
        assert!((share(1.0, 0.0, 10.0) - 0.55).abs() < 1e-12);
        assert_eq!(Last { share: 0.1, steepening: 1e-30 }.share(0.1, 0.0, 0.2), 1.0);
    }
}
