//! Elastic shear with a von Mises yield surface.
//!
//! ```text
//! dS/dt = 2 mu (e - tr(e)/3) + Omega S - S Omega     Jutzi et al. 2008, eqs 31-32 with the sign of the spin corrected
//! e = (L + L^T)/2    Omega = (L - L^T)/2
//! S -> S min(1, Y / sqrt(3 J2))    J2 = S:S / 2      Benz & Asphaug 1995, with the first power of Y / sqrt(3 J2)
//! Y = Y_0 max(0, 1 - u / u_melt)                     where `melting` is asked for
//! c_L^2 = c^2 + 4 mu / (3 rho)
//! ```
//! S deviatoric stress, mu shear modulus, Y yield strength, Pa; e strain rate, Omega spin, 1/s; u specific internal
//! energy, J/kg; c, c_L bulk and longitudinal speed of sound, m/s. In 2D this is plane strain: S_zz = -(S_xx + S_yy)
//! counts in J2.
//!
//! In porous bodies S is that of the body, S_s / alpha with S_s of the matrix (Jutzi et al. 2008, eqs 45-53, with f on Hooke's
//! term alone, as stress turns with the body whatever its pores do, and S for that of the body throughout):
//!
//! ```text
//! dS/dt = f / alpha 2 mu (e - tr(e)/3) + Omega S - S Omega - S alpha' / alpha    c_L^2 = c^2 + 4 mu / (3 alpha rho)
//! ```
//! f of `porosity`, within 0 and 1; alpha' the rate of distention alpha. Y does not depend on alpha.
//!
//! S is the stress of the undamaged matter: damage is a view of it (see `fracture`) and is never written back.
//! Columns: owns `deviatoric_stress`; stiffens the core column `sound_speed`.
//! Time step: none of its own; the Courant condition uses the longitudinal speed.

use serde::{Deserialize, Serialize};

use super::porosity::{PoreColumns, distention_rate};
use super::setup::{Table, all_positive};
use super::{Core, Local, MaterialEffect, MaterialTable, PerBody, Setup, eos};
use crate::error::Result;
use crate::math::{Deviator, Sym};
use crate::particles::{Column, ColumnInfo, Integrated, Life, Registry};
use crate::units::{Pressure, SpecificEnergy};

/// Name of the column that this effect owns.
pub const DEVIATORIC_STRESS: &str = "deviatoric_stress";

/// A stress this little beyond the yield surface was put there by rounding and stays, so that a second return changes
/// no bit.
const ROUNDING: f64 = 1e-14;
/// Largest volume of a particle in the pair sums over the one it starts with; it bounds the speed of shear waves in
/// spray.
const LARGEST_VOLUME: f64 = 2.0;

/// `[material.X.strength]`
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StrengthTable {
    #[serde(rename = "yield")]
    pub yield_law: YieldLaw,
    pub shear_modulus: Pressure,
    /// Largest sqrt(3 J2) that cold matter bears.
    pub yield_strength: Pressure,
    pub melting: Option<MeltingTable>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum YieldLaw {
    VonMises,
}

/// `[material.X.strength.melting]`: heat weakens.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MeltingTable {
    /// u_melt, at which no strength is left.
    pub energy: SpecificEnergy,
}

impl Table for StrengthTable {
    fn validate(&self, place: &str, _material: &MaterialTable) -> Result<()> {
        let YieldLaw::VonMises = self.yield_law;
        all_positive(place, &[("shear_modulus", self.shear_modulus.0), ("yield_strength", self.yield_strength.0)])?;
        match self.melting {
            Some(melting) => all_positive(&format!("{place}.melting"), &[("energy", melting.energy.0)]),
            None => Ok(()),
        }
    }
}

#[derive(Debug, Clone, Copy)]
struct Solid {
    shear_modulus: f64,
    yield_strength: f64,
    /// 1 / u_melt, kg/J; zero where heat does not weaken.
    softening: f64,
    /// Density of the matrix below which shear waves get no faster, kg/m^3.
    lowest_density: f64,
    porous: bool,
}

impl Solid {
    fn new(table: &StrengthTable, matrix_density: f64, porous: bool) -> Self {
        Self {
            shear_modulus: table.shear_modulus.0,
            yield_strength: table.yield_strength.0,
            softening: table.melting.map_or(0.0, |melting| 1.0 / melting.energy.0),
            lowest_density: matrix_density / LARGEST_VOLUME,
            porous,
        }
    }

    /// Y at internal energy `u`, Pa.
    #[inline]
    fn yield_strength(&self, u: f64) -> f64 {
        self.yield_strength * (1.0 - self.softening * u).clamp(0.0, 1.0)
    }

    /// The stress brought back radially to the yield surface; `None` where it lies within.
    #[inline]
    fn returned(&self, stress: &Deviator, u: f64) -> Option<Deviator> {
        let bearable = self.yield_strength(u);
        let square = 3.0 * stress.j2();
        (square > bearable * bearable * (1.0 + ROUNDING)).then(|| stress.scaled(bearable / square.sqrt()))
    }
}

/// Deviatoric stress of the bodies that have strength.
pub struct Strength {
    solids: PerBody<Solid>,
    stress: Integrated<Deviator>,
    density: Column<f64>,
    energy: Column<f64>,
    sound_speed: Column<f64>,
    /// Where any body is porous.
    pores: Option<PoreColumns>,
}

impl MaterialEffect for Strength {
    fn declare(setup: &Setup, registry: &mut Registry, core: &Core) -> Option<Self> {
        let solids = PerBody::new(setup, |body, material| {
            let constants = &setup.constants[body];
            let matrix_density = constants.density * constants.distention;
            let new = |table| Solid::new(table, matrix_density, material.porosity.is_some());
            material.strength.as_ref().map(new)
        })?;
        let pores = PoreColumns::find(registry);
        let stress = registry.owner("strength").integrated(ColumnInfo {
            name: DEVIATORIC_STRESS,
            unit: "Pa",
            about: "Deviatoric stress before damage.",
            life: Life::State,
            snapshot: true,
        });
        let energy = registry.find(eos::INTERNAL_ENERGY)?;
        Some(Self { solids, stress, density: core.density.value, energy, sound_speed: core.sound_speed, pores })
    }

    fn name(&self) -> &'static str {
        "strength"
    }

    fn rates(&self, local: &Local) {
        let (stress, rate) = (local.view(self.stress.value), local.new_rate(self.stress));
        for (solid, range) in self.solids.runs(local) {
            if let Some(pores) = self.pores.filter(|_| solid.porous) {
                self.porous_rates(local, solid, range, &pores);
                continue;
            }
            for i in range {
                let gradient = &local.motion[i].velocity_gradient;
                let elastic = Deviator::of(&Sym::symmetric_part(gradient), 2.0 * solid.shear_modulus);
                rate.set(i, elastic.plus(&stress.get(i).turned_by(gradient)));
            }
        }
    }

    fn admit(&self, local: &Local) {
        let (stress, energy) = (local.view(self.stress.value), local.view(self.energy));
        for (solid, range) in self.solids.runs(local) {
            for i in range {
                if let Some(returned) = solid.returned(&stress.get(i), energy.get(i)) {
                    stress.set(i, returned);
                }
            }
        }
    }

    fn update(&self, local: &Local) {
        let (density, sound_speed) = (local.view(self.density), local.view(self.sound_speed));
        for (solid, range) in self.solids.runs(local) {
            let stiffness = 4.0 / 3.0 * solid.shear_modulus;
            if let Some(pores) = self.pores.filter(|_| solid.porous) {
                let (distention, factor) = (local.view(pores.distention), local.view(pores.stress_factor));
                let loading_speed = pores.loading_speed.map(|column| local.view(column));
                for i in range {
                    let matrix_density = distention.get(i) * density.get(i);
                    let shear = stiffness / matrix_density.max(solid.lowest_density);
                    let c = sound_speed.get(i);
                    sound_speed.set(i, (c * c + shear).sqrt());
                    if let Some(loading_speed) = &loading_speed {
                        let (c, share) = (loading_speed.get(i), factor.get(i).clamp(0.0, 1.0));
                        loading_speed.set(i, (c * c + shear * share).sqrt());
                    }
                }
                continue;
            }
            for i in range {
                let c = sound_speed.get(i);
                sound_speed.set(i, (c * c + stiffness / density.get(i).max(solid.lowest_density)).sqrt());
            }
        }
    }
}

impl Strength {
    /// Rates of porous matter.
    fn porous_rates(&self, local: &Local, solid: &Solid, range: std::ops::Range<usize>, pores: &PoreColumns) {
        let (stress, rate) = (local.view(self.stress.value), local.new_rate(self.stress));
        let (distention, stress_factor) = (local.view(pores.distention), local.view(pores.stress_factor));
        for i in range {
            let gradient = &local.motion[i].velocity_gradient;
            let (divergence, factor) = (gradient.trace(), stress_factor.get(i));
            // Pores that gave way do not come back: the matrix follows an expansion alone.
            let share = if divergence < 0.0 { factor.clamp(0.0, 1.0) } else { 1.0 };
            let modulus = 2.0 * solid.shear_modulus * share / distention.get(i);
            let s = stress.get(i);
            let elastic = Deviator::of(&Sym::symmetric_part(gradient), modulus);
            let concentrated = s.scaled(-distention_rate(factor, divergence));
            rate.set(i, elastic.plus(&s.turned_by(gradient)).plus(&concentrated));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::{Rig, basalt, without_fracture};
    use super::*;
    use crate::math::Mat3;

    fn stress_column(rig: &Rig) -> Column<Deviator> {
        rig.column(DEVIATORIC_STRESS)
    }

    /// Uniaxial strain at a constant rate: S_xx = 4/3 mu e until 3/2 |S_xx| = Y, from there S_xx = -2/3 Y.
    #[test]
    fn uniaxial_strain_is_elastic_then_plastic() {
        let mut rig = Rig::new(without_fracture(basalt()));
        let gradient = Mat3::from_diagonal(&crate::math::Vec3::new(-1.0, 0.0, 0.0));
        // The rate of the first step is zero: the gradient is seen once before.
        rig.step(&gradient, 0.0);
        let (mu, bearable) = (22.7e9, 3.5e9);
        let dt = 1e-4;
        for step in 1..=2000 {
            rig.step(&gradient, dt);
            let s = rig.get(stress_column(&rig));
            // Heating by compression softens: Y = Y_0 (1 - u / u_melt).
            let u: f64 = rig.get(rig.column(eos::INTERNAL_ENERGY));
            let elastic = -4.0 / 3.0 * mu * dt * step as f64;
            let expected = elastic.max(-2.0 / 3.0 * bearable * (1.0 - u / 3.4e6));
            assert!(
                (s.xx / expected - 1.0).abs() < 1e-10 && (s.yy / s.xx + 0.5).abs() < 1e-12,
                "{step} {s:?} {expected}"
            );
        }
    }

    /// q after the return for a trial q, both over Y.
    #[test]
    fn yield_table() {
        let table = without_fracture(basalt()).strength.unwrap();
        let solid = Solid::new(&table, 2700.0, false);
        for (trial, after) in [(0.70, 0.700), (0.90, 0.900), (1.00, 1.000), (1.20, 1.000), (1.50, 1.000), (2.00, 1.000)]
        {
            // Simple shear: sqrt(3 J2) = sqrt(3) S_xy.
            let stress = Deviator { xy: trial * 3.5e9 / 3f64.sqrt(), ..Default::default() };
            let returned = solid.returned(&stress, 0.0).unwrap_or(stress);
            let q = (3.0 * returned.j2()).sqrt() / 3.5e9;
            assert!((q - after).abs() < 1e-14, "{trial} {q}");
            assert_eq!(solid.returned(&returned, 0.0), None, "a second return changes nothing");
        }
    }

    #[test]
    fn melt_bears_nothing() {
        let solid = Solid::new(&basalt().strength.unwrap(), 2700.0, false);
        let stress = Deviator { xy: 1e6, ..Default::default() };
        assert_eq!(solid.yield_strength(1.7e6), 1.75e9);
        assert_eq!(solid.yield_strength(-1.0), 3.5e9);
        assert_eq!(solid.returned(&stress, 5e6), Some(Deviator::default()));
    }

    /// A rigid rotation by 45 degrees turns diag(1, -1, 0) into S_xy = 1 and keeps J2. The scheme turns by z = 2 dtheta
    /// per step with a phase error of order z^3, so that the sum stays below z^2 times the angle turned in the stress's
    /// plane.
    #[test]
    fn rotation_turns_stress_and_keeps_j2() {
        let mut rig = Rig::new(without_fracture(basalt()));
        rig.set(stress_column(&rig), Deviator { xx: 1e6, yy: -1e6, ..Default::default() });
        let gradient = Mat3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0);
        let steps = 1000;
        let dt = std::f64::consts::FRAC_PI_4 / steps as f64;
        rig.step(&gradient, 0.0);
        for _ in 0..steps {
            rig.step(&gradient, dt);
        }
        let s = rig.get(stress_column(&rig));
        let bound = 1e6 * (2.0 * dt) * (2.0 * dt) * std::f64::consts::FRAC_PI_2;
        assert!((s.xy - 1e6).abs() < bound && s.xx.abs() < bound, "{s:?}");
        assert!((s.j2() / 1e12 - 1.0).abs() < 2e-6 * bound, "{}", s.j2());
        assert_eq!(rig.get(rig.core.density.value), 2700.0);
    }

    /// c_L = sqrt((K + 4/3 mu) / rho): 4593 m/s in basalt, so that cracks grow at c_g = 0.4 c_L = 1837 m/s (Benz & Asphaug 1995).
    #[test]
    fn sound_is_longitudinal() {
        let mut rig = Rig::new(without_fracture(basalt()));
        rig.step(&Mat3::zeros(), 0.0);
        assert!((0.4 * rig.get(rig.core.sound_speed) - 1837.0).abs() < 0.5);
    }
}
