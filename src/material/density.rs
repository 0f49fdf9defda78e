//! Continuity: d rho / dt = -rho div v = -rho tr L (Jutzi et al. 2008, eq. 26).
//!
//! rho bulk density, kg/m^3; L velocity gradient, 1/s.
//! Columns: acts on the core column `density`, owns none.
//! Time step: |tr L| dt <= 0.4, so that a prediction from the rate of the step before cannot take the density near zero
//! and a shock front is not crossed within one step.

use super::{Core, Local, MaterialEffect, Setup, StepLimit};
use crate::error::Result;
use crate::particles::{Integrated, Registry};

/// Largest change of volume within one step.
const LARGEST_STRAIN: f64 = 0.4;
/// Density below which a particle is not followed, as a fraction of the one its body starts with. Spray as thin as this
/// moves freely, and formulas with 1 / rho stay finite.
const LOWEST_FRACTION: f64 = 1e-6;

/// Density of every particle; always present.
pub struct Continuity {
    density: Integrated<f64>,
}

impl MaterialEffect for Continuity {
    fn declare(_setup: &Setup, _registry: &mut Registry, core: &Core) -> Result<Option<Self>> {
        Ok(Some(Self { density: core.density }))
    }

    fn name(&self) -> &'static str {
        "density"
    }

    fn initialise(&self, local: &Local) {
        let density = local.view(self.density.value);
        for (body, range) in local.runs() {
            // Densities set by the scene stay.
            for i in range.filter(|&i| density.get(i) == 0.0) {
                density.set(i, local.constants[body].density);
            }
        }
    }

    fn rates(&self, local: &Local) {
        let density = local.view(self.density.value);
        let rate = local.rate(self.density);
        for (i, flow) in local.flow.iter().enumerate() {
            rate.set(i, -density.get(i) * flow.velocity_gradient.trace());
        }
    }

    fn admit(&self, local: &Local) {
        let density = local.view(self.density.value);
        for (body, range) in local.runs() {
            let lowest = LOWEST_FRACTION * local.constants[body].density;
            for i in range {
                if density.get(i) < lowest {
                    density.set(i, lowest);
                }
            }
        }
    }

    fn step_limit(&self, local: &Local) -> Option<StepLimit> {
        let mut fastest = (0.0, 0);
        for (i, flow) in local.flow.iter().enumerate() {
            let divergence = flow.velocity_gradient.trace().abs();
            if divergence > fastest.0 {
                fastest = (divergence, i);
            }
        }
        (fastest.0 > 0.0).then(|| StepLimit { dt: LARGEST_STRAIN / fastest.0, particle: fastest.1 })
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::{Rig, gas};
    use crate::math::Mat3;

    /// With constant tr L the density is rho_0 exp(-tr L t); halving the step divides the error by four.
    #[test]
    fn density_follows_a_uniform_expansion() {
        let error = |steps: usize| {
            let mut rig = Rig::new(gas());
            let start = rig.get(rig.core.density.value);
            // The rate of the first step is zero: the gradient is seen once before.
            rig.step(&Mat3::from_diagonal_element(0.1), 0.0);
            for _ in 0..steps {
                rig.step(&Mat3::from_diagonal_element(0.1), 1.0 / steps as f64);
            }
            rig.get(rig.core.density.value) / (start * libm::exp(-0.3)) - 1.0
        };
        let ratio = error(50) / error(100);
        assert!((ratio - 4.0).abs() < 0.2, "{ratio}");
    }

    #[test]
    fn step_limit_bounds_the_change_of_volume() {
        let mut rig = Rig::new(gas());
        let limit = rig.step(&Mat3::from_diagonal_element(-2.0), 0.0).unwrap();
        assert_eq!(limit.dt, 0.4 / 6.0);
        assert!(rig.step(&Mat3::zeros(), 0.0).is_none());
    }

    #[test]
    fn density_stays_positive() {
        let mut rig = Rig::new(gas());
        rig.set(rig.core.density.value, -1.0);
        rig.step(&Mat3::zeros(), 0.0);
        assert!(rig.get(rig.core.density.value) > 0.0);
    }
}
