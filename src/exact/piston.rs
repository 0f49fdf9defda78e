//! A piston that drives an elastic-plastic solid in uniaxial strain: an elastic precursor and a plastic shock, one elastic
//! front, or one plastic front that has overtaken its precursor. Zel'dovich & Raizer 1967, chapter XI; Melosh 1989, chapter 3.
//!
//! ```text
//! stress = P(rho, E) + 2/3 min(2 mu ln(rho / rho_0), Y)    Y = Y_0 max(0, 1 - E / E_melt)
//! ```
//! P of the equation of state, mu shear modulus, Y yield strength, Pa; rho_0 density before the piston, kg/m^3; E specific
//! internal energy, J/kg. This is what the rate law of `material::strength`, dS/dt = 2 mu (e - tr(e) / 3) up to sqrt(3 J2) =
//! Y, integrates to in uniaxial compression. Y is that at the energy where it acts: the precursor ends at the first elastic
//! state with 2 mu ln(rho / rho_0) = Y(E), and behind the plastic front Y is taken at the energy there. Each front obeys the
//! jump conditions of `shock`.

use super::shock::{Front, Medium, jump};
use super::{State, all_positive, doubled_until, root};
use crate::error::Result;
use crate::material::MaterialTable;

/// An elastic-plastic solid at rest.
#[derive(Debug, Clone, PartialEq)]
pub struct Solid {
    pub medium: Medium,
    /// mu, Pa; zero for a fluid.
    pub shear_modulus: f64,
    /// Y_0, Pa; zero for a fluid.
    pub yield_strength: f64,
    /// E_melt, J/kg, where heat weakens.
    pub melt_energy: Option<f64>,
}

impl Solid {
    /// The material of a scene at its reference density, cold; `None` for a gas.
    pub fn of(material: &MaterialTable) -> Option<Self> {
        let density = material.reference_density()?;
        let strength = material.strength.as_ref();
        Some(Self {
            medium: Medium { law: material.eos.law(), density, internal_energy: 0.0 },
            shear_modulus: strength.map_or(0.0, |table| table.shear_modulus.0),
            yield_strength: strength.map_or(0.0, |table| table.yield_strength.0),
            melt_energy: strength.and_then(|table| table.melting).map(|melting| melting.energy.0),
        })
    }

    /// Y at the internal energy `energy`, Pa.
    fn yield_strength(&self, energy: f64) -> f64 {
        self.yield_strength * self.melt_energy.map_or(1.0, |melt| (1.0 - energy / melt).clamp(0.0, 1.0))
    }

    /// sqrt(3 J2) of matter that has not yielded, Pa.
    fn shear(&self, density: f64) -> f64 {
        2.0 * self.shear_modulus * libm::log(density / self.medium.density)
    }

    fn elastic(&self, gain: f64) -> Result<Front> {
        jump(&self.medium.state(), gain, |density, energy| {
            self.medium.law.pressure(density, energy).0 + 2.0 / 3.0 * self.shear(density)
        })
    }

    fn plastic(&self, ahead: &State, gain: f64) -> Result<Front> {
        jump(ahead, gain, |density, energy| {
            let shear = self.shear(density).min(self.yield_strength(energy));
            self.medium.law.pressure(density, energy).0 + 2.0 / 3.0 * shear
        })
    }

    /// The strongest elastic front, at the Hugoniot elastic limit; `None` for a fluid.
    pub fn elastic_limit(&self) -> Result<Option<Front>> {
        if !(self.shear_modulus > 0.0 && self.yield_strength(self.medium.internal_energy) > 0.0) {
            return Ok(None);
        }
        let excess = |gain: f64| match self.elastic(gain) {
            Ok(Front { behind, .. }) => self.shear(behind.density) - self.yield_strength(behind.internal_energy),
            Err(_) => f64::NAN,
        };
        // In the order of the limit: the strain Y / (2 mu) times the speed of shear waves.
        let scale =
            (self.shear_modulus / self.medium.density).sqrt() * self.yield_strength / (2.0 * self.shear_modulus);
        let gain = root(0.0, doubled_until(scale, |gain| excess(gain) >= 0.0)?, excess)?;
        self.elastic(gain).map(Some)
    }
}

/// A piston that starts to move into a solid at t = 0 from x = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piston {
    pub ahead: State,
    /// Elastic front that runs before the plastic one.
    pub precursor: Option<Front>,
    /// Front behind which the solid moves with the piston.
    pub front: Front,
}

impl Piston {
    /// `speed` of the piston, m/s.
    pub fn new(solid: &Solid, speed: f64) -> Result<Self> {
        all_positive(&[("the density", solid.medium.density), ("the speed of the piston", speed)])?;
        let ahead = solid.medium.state();
        let limit = solid.elastic_limit()?;
        let alone = |front: Front| Self { ahead, precursor: None, front };
        if let Some(limit) = limit {
            if speed <= limit.behind.velocity {
                return solid.elastic(speed).map(alone);
            }
            let front = solid.plastic(&limit.behind, speed - limit.behind.velocity)?;
            if front.speed < limit.speed {
                return Ok(Self { ahead, precursor: Some(limit), front });
            }
        }
        solid.plastic(&ahead, speed).map(alone)
    }

    /// State at `x`, m, and the time `t`, s; the solid begins at x = speed t.
    pub fn at(&self, x: f64, t: f64) -> State {
        match self.precursor {
            _ if x < self.front.speed * t => self.front.behind,
            Some(precursor) if x < precursor.speed * t => precursor.behind,
            _ => self.ahead,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::shock::tests::{aluminium, basalt, near, obeys_the_jump_conditions};
    use super::super::waves::Elastic;
    use super::*;

    fn metal() -> Solid {
        Solid { medium: aluminium(), shear_modulus: 26.5e9, yield_strength: 0.3e9, melt_energy: None }
    }

    fn rock() -> Solid {
        Solid { medium: basalt(), shear_modulus: 22.7e9, yield_strength: 3.5e9, melt_energy: None }
    }

    /// An independent solution, to the digits given: aluminium at 100 and 500 m/s, basalt at 500 and 1000 m/s, without softening.
    #[test]
    fn tabulated_pistons() {
        let slow = Piston::new(&metal(), 100.0).unwrap();
        let limit = slow.precursor.unwrap();
        near(limit.behind.stress, 6.3279e8, 1e-5);
        near(limit.behind.velocity, 36.371, 1e-5);
        near(limit.speed, 6443.7, 1e-5);
        near(slow.front.behind.stress, 1.57315e9, 1e-5);
        near(slow.front.behind.density, 2747.45, 2e-6);
        near(slow.front.behind.internal_energy, 5410.0, 1e-4);
        near(slow.front.speed, 5479.1, 1e-5);
        let fast = Piston::new(&metal(), 500.0).unwrap().front;
        near(fast.behind.stress, 8.2235e9, 1e-5);
        near(fast.speed, 6066.0, 1e-5);
        let rocky = Piston::new(&rock(), 500.0).unwrap();
        let limit = rocky.precursor.unwrap();
        near(limit.behind.stress, 5.049e9, 1e-4);
        near(limit.behind.velocity, 372.5, 1e-4);
        near(limit.speed, 5020.0, 1e-4);
        near(rocky.front.behind.stress, 6.558e9, 1e-4);
        near(rocky.front.speed, 4429.0, 1e-4);
        assert!(Piston::new(&rock(), 1000.0).unwrap().precursor.is_none());
        assert!(Piston::new(&rock(), 300.0).unwrap().precursor.is_none());
    }

    /// With and without softening, elastic, in two waves, overdriven, molten: jump conditions hold and the stress behind is
    /// that of the yield law at the energy behind.
    #[test]
    fn fronts_obey_the_jump_conditions_and_the_yield_law() {
        let soft = Solid { melt_energy: Some(3.4e6), ..rock() };
        let warm = Solid { medium: Medium { internal_energy: 4e5, density: 2650.0, ..basalt() }, ..soft };
        let mut kinds = [0; 3];
        for solid in [metal(), rock(), soft, warm] {
            for speed in [0.1, 30.0, 90.0, 380.0, 620.0, 1100.0, 3000.0, 7000.0] {
                let piston = Piston::new(&solid, speed).unwrap();
                let ahead = piston.precursor.map_or(piston.ahead, |precursor| precursor.behind);
                obeys_the_jump_conditions(&ahead, &piston.front);
                let State { density, internal_energy, stress, velocity, .. } = piston.front.behind;
                near(velocity, speed, 1e-12);
                let elastic = solid.shear(density);
                let bearable = solid.yield_strength(internal_energy);
                let pressure = solid.medium.law.pressure(density, internal_energy).0;
                near(stress, pressure + 2.0 / 3.0 * elastic.min(bearable), 1e-12);
                if let Some(precursor) = piston.precursor {
                    obeys_the_jump_conditions(&piston.ahead, &precursor);
                    near(
                        solid.shear(precursor.behind.density),
                        solid.yield_strength(precursor.behind.internal_energy),
                        1e-9,
                    );
                    assert!(piston.front.speed < precursor.speed && speed > precursor.behind.velocity);
                    assert_eq!(piston.at(0.5 * (precursor.speed + piston.front.speed), 1.0), precursor.behind);
                    assert_eq!(piston.at(1.001 * precursor.speed, 1.0), piston.ahead);
                }
                assert_eq!(piston.at(speed, 1.0), piston.front.behind);
                kinds[if piston.precursor.is_some() { 1 } else { usize::from(elastic > bearable) * 2 }] += 1;
            }
        }
        assert!(kinds.iter().all(|&count| count > 2), "{kinds:?}");
    }

    /// A weak elastic front runs at sqrt((K + 4/3 mu) / rho), and without strength the piston drives a plain shock.
    #[test]
    fn limits_of_strength() {
        let c = ((75.2e9 + 4.0 / 3.0 * 26.5e9) / 2700f64).sqrt();
        near(Piston::new(&metal(), 1e-2).unwrap().front.speed, c, 1e-5);
        let fluid = Solid { yield_strength: 0.0, ..metal() };
        assert_eq!(fluid.elastic_limit().unwrap(), None);
        let (driven, plain) = (Piston::new(&fluid, 500.0).unwrap().front, aluminium().shock(500.0).unwrap());
        assert_eq!(driven, plain);
        assert!(Piston::new(&metal(), -1.0).is_err());
    }

    #[test]
    fn materials_of_scenes_have_exact_solutions() {
        let text = r#"
            eos = { tillotson = { rho_0 = 2700, a = 0.5, b = 1.5, A = "26.7 GPa", B = "26.7 GPa", E_0 = 487e6, E_iv = 4.72e6,
                E_cv = 18.2e6, alpha = 5, beta = 5 } }
            [strength]
            shear_modulus = "22.7 GPa"
            yield_strength = "3.5 GPa"
            melting = { energy = 3.4e6 }
        "#;
        let material = toml::from_str(text).unwrap();
        assert_eq!(Solid::of(&material), Some(Solid { melt_energy: Some(3.4e6), ..rock() }));
        near(Elastic::of(&material).unwrap().longitudinal_speed(), 4593.3, 1e-5);
        let gas = toml::from_str("eos = { ideal_gas = { gamma = 1.4 } }").unwrap();
        assert!(Solid::of(&gas).is_none() && Elastic::of(&gas).is_none());
    }
}
