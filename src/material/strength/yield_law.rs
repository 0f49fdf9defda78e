//! Yield strength: how much shear matter bears.
//!
//! ```text
//! von Mises         sqrt(3 J2) <= Y    Y = Y_M m(u)                                       Benz & Asphaug 1995
//! Collins           sqrt(J2)   <= Y    Y = (1 - D) Y_i + D min(Y_d, Y_i)                  Jutzi 2015, eqs 3-6
//!                       Y_i = [Y_0 + mu_i P / (1 + mu_i P / (Y_M - Y_0))] m(u)            Lundborg 1968; Collins et al. 2004
//!                       Y_d = Y_c + mu_d P
//! Drucker-Prager    sqrt(J2)   <= Y    Y = min(Y_0 + mu P, Y_M) m(u)
//! m(u) = max(0, 1 - u / u_melt)                                                           where `melting` is given
//! ```
//! P pressure of the body, D damage, u specific internal energy, J/kg; Y_M largest strength at any pressure, Y_0 and Y_c cohesion
//! of intact and of broken matter, Pa; mu_i, mu_d, mu coefficients of friction. Each law states which invariant it bounds: a
//! number Y bears sqrt(3) times as much if sqrt(J2) is compared. A friction angle phi is mu = sin(phi) in plane shear and
//! 6 sin(phi) / (sqrt(3) (3 - sin(phi))) in triaxial compression.
//!
//! In tension (P < 0) intact matter keeps Y_0, as flaws and not shear limit stress there; friction falls along its line to zero
//! at P = -Y_c / mu_d (broken matter without cohesion bears none). Y of a porous body takes the pressure of the body, not of
//! its matrix, and does not depend on alpha.

use super::super::setup::{all_positive, none_negative};
use super::table::StrengthTable;
use crate::error::{Error, Result};
use crate::math::Deviator;
use crate::units::Pressure;

/// Largest volume of a particle in the pair sums over the one it starts with; it bounds the speed of shear waves in
/// spray.
pub(super) const LARGEST_VOLUME: f64 = 2.0;

/// A stress this little beyond the yield surface was put there by rounding and stays, so that a second return changes
/// no bit.
const ROUNDING: f64 = 1e-14;

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum YieldLaw {
    VonMises,
    Collins { cohesion: f64, internal_friction: f64, friction: f64, damaged_cohesion: f64 },
    DruckerPrager { cohesion: f64, friction: f64 },
}

/// A yield law with what all laws have: the largest strength Y_M, Pa, and 1 / u_melt, kg/J, zero where heat does not weaken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Yield {
    pub law: YieldLaw,
    largest: f64,
    softening: f64,
}

impl StrengthTable {
    /// Checks the parameters of the law.
    pub(super) fn validate_law(&self, place: &str) -> Result<()> {
        let largest = self.yield_strength.0;
        let below = |table: &str, cohesion: Pressure| {
            let what = format!("a cohesion of {cohesion} is not below the largest strength, {}", self.yield_strength);
            let error = Error::new(what).at(format!("{place}.{table}.cohesion"));
            if cohesion.0 < largest { Ok(()) } else { Err(error.allowed("less than yield_strength")) }
        };
        match (&self.collins, &self.drucker_prager) {
            (None, None) => Ok(()),
            (Some(table), None) => {
                let values = [
                    ("cohesion", table.cohesion.0),
                    ("internal_friction", table.internal_friction.0),
                    ("friction", table.friction.0),
                    ("damaged_cohesion", table.damaged_cohesion.0),
                ];
                none_negative(&format!("{place}.collins"), &values)?;
                all_positive(&format!("{place}.collins"), &values[1..2])?;
                below("collins", table.cohesion)
            }
            (None, Some(table)) => {
                let values = [("cohesion", table.cohesion.0), ("friction", table.friction.0)];
                none_negative(&format!("{place}.drucker_prager"), &values)?;
                below("drucker_prager", table.cohesion)
            }
            (Some(_), Some(_)) => {
                Err(Error::new("two laws of yield").at(place).allowed("one of collins, drucker_prager, or neither"))
            }
        }
    }

    /// Whether yield strength depends on pressure. Damage then acts on shear through the yield strength alone.
    pub fn has_friction(&self) -> bool {
        self.collins.is_some() || self.drucker_prager.is_some()
    }
}

impl Yield {
    pub fn new(table: &StrengthTable) -> Self {
        let law = match (&table.collins, &table.drucker_prager) {
            (Some(t), _) => YieldLaw::Collins {
                cohesion: t.cohesion.0,
                internal_friction: t.internal_friction.0,
                friction: t.friction.0,
                damaged_cohesion: t.damaged_cohesion.0,
            },
            (_, Some(t)) => YieldLaw::DruckerPrager { cohesion: t.cohesion.0, friction: t.friction.0 },
            _ => YieldLaw::VonMises,
        };
        let softening = table.melting.map_or(0.0, |melting| 1.0 / melting.energy.0);
        Self { law, largest: table.yield_strength.0, softening }
    }

    /// m(u).
    #[inline]
    fn cold_share(&self, u: f64) -> f64 {
        (1.0 - self.softening * u).clamp(0.0, 1.0)
    }

    /// Y of von Mises' law at the internal energy `u`, Pa.
    #[inline]
    pub fn strength(&self, u: f64) -> f64 {
        self.largest * self.cold_share(u)
    }

    /// Y of the laws with friction at a pressure, Pa, of matter with damage `d`.
    #[inline]
    pub fn strength_under(&self, pressure: f64, d: f64, u: f64) -> f64 {
        let cold = self.cold_share(u);
        match self.law {
            YieldLaw::VonMises => self.largest * cold,
            YieldLaw::Collins { cohesion, internal_friction, friction, damaged_cohesion } => {
                let rise = internal_friction * pressure.max(0.0);
                let intact = (cohesion + rise / (1.0 + rise / (self.largest - cohesion))) * cold;
                let broken = (damaged_cohesion + friction * pressure).clamp(0.0, intact);
                (1.0 - d) * intact + d * broken
            }
            YieldLaw::DruckerPrager { cohesion, friction } => {
                (cohesion + friction * pressure).clamp(0.0, self.largest) * cold
            }
        }
    }
}

/// The stress brought back radially to where `measure` times J2 is the square of `bearable`, Pa; `None` where it lies within.
#[inline]
pub fn returned(stress: &Deviator, measure: f64, bearable: f64) -> Option<Deviator> {
    let square = measure * stress.j2();
    (square > bearable * bearable * (1.0 + ROUNDING)).then(|| stress.scaled(bearable / square.sqrt()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::MaterialTable;

    fn table(law: &str) -> StrengthTable {
        let text = format!(
            "eos = {{ ideal_gas = {{ gamma = 1.4 }} }}\n[strength]\nshear_modulus = 1e10\nyield_strength = 3.5e9\n{law}"
        );
        toml::from_str::<MaterialTable>(&text).expect("a material").strength.expect("strength")
    }

    const ROCK: &str = "collins = { cohesion = 9e7, internal_friction = 2, friction = 0.8, damaged_cohesion = 0 }\nmelting = { energy = 3.4e6 }";

    /// Intact rock, broken rock and what lies between, against the formulas by hand.
    #[test]
    fn rock_under_pressure() {
        let rock = Yield::new(&table(ROCK));
        let near = |found: f64, expected: f64| assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
        near(rock.strength_under(0.0, 0.0, 0.0), 9e7);
        // mu_i P = 2e9: 9e7 + 2e9 / (1 + 2e9 / 3.41e9).
        near(rock.strength_under(1e9, 0.0, 0.0), 9e7 + 2e9 * 3.41e9 / 5.41e9);
        near(rock.strength_under(1e15, 0.0, 0.0) / 3.5e9, 9e7 / 3.5e9 + 2e15 / (1.0 + 2e15 / 3.41e9) / 3.5e9);
        near(rock.strength_under(1e8, 1.0, 0.0), 8e7);
        near(rock.strength_under(1e8, 0.25, 0.0), 0.75 * (9e7 + 2e8 / (1.0 + 2e8 / 3.41e9)) + 0.25 * 8e7);
        // Broken rock is never stronger than intact rock.
        near(rock.strength_under(1e10, 1.0, 0.0), rock.strength_under(1e10, 0.0, 0.0));
        // Heat: half-way to melting intact rock has half of its strength; friction does not change while it is below that.
        near(rock.strength_under(0.0, 0.0, 1.7e6), 4.5e7);
        near(rock.strength_under(1e7, 1.0, 1.7e6), 8e6);
        assert_eq!(rock.strength_under(1e9, 1.0, 4e6), 0.0);
        assert_eq!(rock.strength_under(1e9, 0.3, 4e6), 0.0);
    }

    #[test]
    fn tension_leaves_intact_rock_its_cohesion_and_broken_rock_nothing() {
        let rock = Yield::new(&table(ROCK));
        assert_eq!(rock.strength_under(-1e8, 0.0, 0.0), 9e7);
        assert_eq!(rock.strength_under(-1.0, 1.0, 0.0), 0.0);
        let sticky = Yield::new(&table(
            "collins = { cohesion = 9e7, internal_friction = 2, friction = 0.8, damaged_cohesion = 1e4 }",
        ));
        assert_eq!(sticky.strength_under(0.0, 1.0, 0.0), 1e4);
        assert_eq!(sticky.strength_under(-0.5e4 / 0.8, 1.0, 0.0), 5e3);
        assert_eq!(sticky.strength_under(-2e4, 1.0, 0.0), 0.0);
    }

    #[test]
    fn sand() {
        let sand = Yield::new(&table("drucker_prager = { cohesion = 0, friction = 0.4 }"));
        assert_eq!(sand.strength_under(1e6, 0.0, 0.0), 4e5);
        assert_eq!(sand.strength_under(1e6, 1.0, 0.0), 4e5);
        assert_eq!(sand.strength_under(-1.0, 0.0, 0.0), 0.0);
        assert_eq!(sand.strength_under(1e12, 0.0, 0.0), 3.5e9);
    }

    /// q after the return for a trial q, both over Y.
    #[test]
    fn return_to_the_surface() {
        for (trial, after) in [(0.70, 0.700), (0.90, 0.900), (1.00, 1.000), (1.20, 1.000), (1.50, 1.000), (2.00, 1.000)]
        {
            // Simple shear: sqrt(3 J2) = sqrt(3) S_xy.
            let stress = Deviator { xy: trial * 3.5e9 / 3f64.sqrt(), ..Default::default() };
            let back = returned(&stress, 3.0, 3.5e9).unwrap_or(stress);
            let q = (3.0 * back.j2()).sqrt() / 3.5e9;
            assert!((q - after).abs() < 1e-14, "{trial} {q}");
            assert_eq!(returned(&back, 3.0, 3.5e9), None, "a second return changes nothing");
        }
    }

    #[test]
    fn laws_are_checked() {
        let checked = |law: &str| table(law).validate_law("strength").map_err(|e| e.to_string());
        assert_eq!(checked(ROCK), Ok(()));
        let two = format!("{ROCK}\ndrucker_prager = {{ cohesion = 0, friction = 0.4 }}");
        assert!(checked(&two).unwrap_err().contains("two laws of yield"));
        let strong = ROCK.replace("9e7", "4e9");
        assert!(checked(&strong).unwrap_err().contains("strength.collins.cohesion"));
        assert!(checked(&ROCK.replace("0.8", "-0.8")).unwrap_err().contains("strength.collins.friction"));
    }

    /// Heat weakens sand as it weakens rock, and solids without friction.
    #[test]
    fn melting_weakens_every_law() {
        for law in ["", "drucker_prager = { cohesion = 1e6, friction = 0.4 }"] {
            let matter = Yield::new(&table(&format!("{law}\nmelting = {{ energy = 2e6 }}")));
            for pressure in [0.0, 1e7, 1e12] {
                let cold = matter.strength_under(pressure, 0.0, 0.0);
                assert!(cold > 0.0);
                let share = |u: f64| matter.strength_under(pressure, 0.0, u) / cold;
                assert_eq!([share(0.5e6), share(1e6), share(2e6), share(9e6)], [0.75, 0.5, 0.0, 0.0], "{law}");
            }
        }
    }
}
