//! A piston that crushes porous matter: an elastic precursor up to where pores begin to collapse and a compaction shock behind it;
//! one elastic front; or one front that has overtaken its precursor. Jutzi et al. 2008, section 5.1; Herrmann 1969, J. Appl. Phys.
//! 40, 2490.
//!
//! Behind a front the pressure is that of the porous matter on first loading, P(rho, E) = P_s(alpha rho, E) / alpha with alpha of
//! its law of compaction (`material::porosity`), and each front obeys the jump conditions of `shock`. The precursor ends where the
//! first pore collapses for good. A shock may leave pores: then alpha behind it is on the crush curve.

use super::piston::Piston;
use super::shock::{Front, jump};
use super::{State, all_positive, doubled_until, root};
use crate::error::Result;
use crate::material::MaterialTable;
use crate::material::porosity::law::Porous;

/// Porous matter at rest, without strength.
#[derive(Debug, Clone, PartialEq)]
pub struct PorousMedium {
    pub matter: Porous,
    /// kg/m^3.
    pub density: f64,
}

impl PorousMedium {
    /// The material of a body with the distention `initial`, cold; `None` without pores.
    pub fn of(material: &MaterialTable, initial: f64) -> Option<Self> {
        let matter = Porous::of(material, initial)?;
        Some(Self { density: material.reference_density()? / initial, matter })
    }

    fn at_rest(&self) -> State {
        State { density: self.density, distention: self.matter.initial, ..State::default() }
    }

    /// Distention on first loading.
    fn distention(&self, state: &State) -> f64 {
        self.matter.state(state.density, state.internal_energy, self.matter.initial).distention
    }

    /// The shock from rest that gives the matter the velocity `gain`, m/s, whether or not a precursor would outrun it: the
    /// Hugoniot of first loading.
    pub fn shock(&self, gain: f64) -> Result<Front> {
        self.front(&self.at_rest(), gain)
    }

    fn front(&self, ahead: &State, gain: f64) -> Result<Front> {
        let front =
            jump(ahead, gain, |density, energy| self.matter.state(density, energy, self.matter.initial).pressure)?;
        let distention = self.distention(&front.behind);
        Ok(Front { behind: State { distention, ..front.behind }, ..front })
    }

    /// The strongest front in which no pore collapses; `None` where pores collapse at once.
    pub fn elastic_limit(&self) -> Result<Option<Front>> {
        let gives_way = |gain: f64| match self.front(&self.at_rest(), gain) {
            Ok(Front { behind, .. }) => {
                let state = self.matter.state(behind.density, behind.internal_energy, self.matter.initial);
                if state.unloaded < self.matter.initial { 1.0 } else { -1.0 }
            }
            Err(_) => f64::NAN,
        };
        let least = 1e-6 * self.matter.sound2_at_rest.sqrt();
        if self.matter.initial <= 1.0 || gives_way(least) > 0.0 {
            return Ok(None);
        }
        let gain = root(least, doubled_until(least, |gain| gives_way(gain) > 0.0)?, gives_way)?;
        self.front(&self.at_rest(), gain).map(Some)
    }

    /// The waves that a piston with this speed, m/s, drives into it.
    pub fn piston(&self, speed: f64) -> Result<Piston> {
        all_positive(&[("the density", self.density), ("the speed of the piston", speed)])?;
        let ahead = self.at_rest();
        if let Some(limit) = self.elastic_limit()? {
            if speed <= limit.behind.velocity {
                return Ok(Piston { ahead, precursor: None, front: self.front(&ahead, speed)? });
            }
            let front = self.front(&limit.behind, speed - limit.behind.velocity)?;
            if front.speed < limit.speed {
                return Ok(Piston { ahead, precursor: Some(limit), front });
            }
        }
        Ok(Piston { ahead, precursor: None, front: self.front(&ahead, speed)? })
    }
}

#[cfg(test)]
mod tests {
    use super::super::shock::tests::{near, obeys_the_jump_conditions};
    use super::*;
    use crate::material::porosity::testing;

    fn porous_medium(matter: Porous) -> PorousMedium {
        PorousMedium { density: matter.eos.reference_density().unwrap() / matter.initial, matter }
    }

    /// Porous aluminium at 458 m/s (Jutzi et al. 2008, section 5.1), from an independent solution of the jump conditions.
    #[test]
    fn compaction_wave_in_aluminium() {
        let medium = porous_medium(testing::aluminium(1.275));
        let wave = medium.piston(458.0).unwrap();
        let precursor = wave.precursor.unwrap();
        near(precursor.behind.stress, 8e7, 1e-9);
        near(precursor.speed, 4083.246, 1e-6);
        near(precursor.behind.velocity, 9.251898, 1e-6);
        near(precursor.behind.distention, 1.2738288, 1e-7);
        near(precursor.behind.internal_energy, 42.7988, 1e-5);
        near(wave.front.behind.stress, 1.9597889e9, 1e-7);
        near(wave.front.behind.density, 2747.05701, 1e-8);
        near(wave.front.behind.internal_energy, 109300.334, 1e-7);
        near(wave.front.speed, 1982.8909, 1e-7);
        assert_eq!(wave.front.behind.distention, 1.0);
    }

    /// An independent solution at other speeds: U_s, P and alpha behind.
    #[test]
    fn incomplete_and_complete_compaction() {
        let medium = porous_medium(testing::aluminium(1.275));
        let cases = [
            (100.0, 889.0, 2.495e8, 1.1446),
            (200.0, 1005.7, 4.834e8, 1.0334),
            (300.0, 1330.0, 8.951e8, 1.0),
            (600.0, 2518.0, 3.226e9, 1.0),
        ];
        for (speed, front, pressure, alpha) in cases {
            let wave = medium.piston(speed).unwrap();
            near(wave.front.speed, front, 4e-4);
            near(wave.front.behind.stress, pressure, 3e-4);
            near(wave.front.behind.distention, alpha, 5e-5);
        }
    }

    /// Elastic, two waves, overdriven, in every law: jump conditions hold, and the state behind is one of first loading.
    #[test]
    fn fronts_obey_the_jump_conditions() {
        let mut kinds = [0; 3];
        let matters = [
            testing::aluminium(1.1),
            testing::aluminium(1.275),
            testing::aluminium(3.0),
            testing::simple(1.275, 2.0),
            testing::simple(3.0, 2.0),
            testing::cold(3.0),
            testing::strained(3.0),
            testing::ice(3.0),
        ];
        for medium in matters.map(porous_medium) {
            for speed in [0.02, 5.0, 100.0, 458.0, 1000.0, 5000.0, 9000.0] {
                let wave = medium.piston(speed).unwrap();
                let ahead = wave.precursor.map_or(medium.at_rest(), |precursor| precursor.behind);
                obeys_the_jump_conditions(&ahead, &wave.front);
                near(wave.front.behind.velocity, speed, 1e-12);
                if let Some(precursor) = wave.precursor {
                    obeys_the_jump_conditions(&medium.at_rest(), &precursor);
                    assert!(wave.front.speed < precursor.speed);
                }
                let crushed = wave.front.behind.distention < 0.999 * medium.matter.initial;
                kinds[if wave.precursor.is_some() { 1 } else { 2 * usize::from(crushed) }] += 1;
            }
        }
        assert!(kinds.iter().all(|&count| count > 2), "{kinds:?}");
    }

    /// alpha_0 = 3, c = 2: at P_s the matrix is less dense than without load, and gets thinner as P rises.
    #[test]
    fn compaction_is_anomalous_at_high_porosity() {
        let medium = porous_medium(testing::simple(3.0, 2.0));
        let density = |pressure: f64| {
            let speed =
                root(1.0, 1e4, |speed| medium.front(&medium.at_rest(), speed).unwrap().behind.stress - pressure)
                    .unwrap();
            medium.front(&medium.at_rest(), speed).unwrap().behind.density
        };
        near(density(7e8), 2675.49, 2e-6);
        near(density(1e9), 2665.4, 2e-5);
        near(density(2e9), 2633.3, 2e-5);
    }
}
