//! Tillotson (1962): P_c as Jutzi et al. 2008, eq. 62; P_e and the mixture as Melosh 1989, appendix II.
//!
//! ```text
//! eta = rho / rho_0    mu = eta - 1    nu = 1 / eta - 1    omega = 1 + u / (E_0 eta^2)
//! eta >= 1 or u <= E_iv:   P_c = (a + b / omega) rho u + A mu + B mu^2
//! eta < 1 and u >= E_cv:   P_e = a rho u + [b rho u / omega + A mu exp(-beta nu)] exp(-alpha nu^2)
//! between:                 P = [(u - E_iv) P_e + (E_cv - u) P_c] / (E_cv - E_iv)
//! c^2 = dP/drho + P / rho^2 dP/du
//! ```
//! P pressure, A and B moduli, Pa; rho density, rho_0 reference density, kg/m^3; u specific internal energy, E_0 a
//! constant, E_iv and E_cv energies of incipient and complete vaporisation, J/kg; a, b, alpha, beta pure numbers.
//!
//! The published form fails in expansion, where it was never fitted; three guards, each outside the range of the fit:
//! - For mu < 0, B mu^2 is dropped where B > 2 A (nylon, water), and B counts as A where it lies between: with B > A cold
//!   matter below eta = 1 - A/B would explode.
//! - Tension fades (see [`fading`](super::slopes)): the tension of the formula grows down to eta = 0.5 (to A/4); that of a solid does not.
//! - c^2 >= A / (4 rho_0), as c^2 < 0 in half of the expanded states.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::super::setup::{all_positive, none_negative};
use super::slopes::{Slopes, bounded_sound, fading};
use crate::error::{Error, Result};
use crate::units::{Density, Number, Pressure, SpecificEnergy};

/// Smallest rho / rho_0 that enters the formulas, so that none of them overflows.
const LOWEST_ETA: f64 = 1e-8;

/// Tillotson's equation of state, with the letters of the literature.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TillotsonTable {
    /// Density without load.
    pub rho_0: Density,
    /// a: share of the heat in the pressure, at any density.
    pub a: Number,
    /// b: further share of the heat, which fades with energy.
    pub b: Number,
    /// A: bulk modulus.
    #[serde(rename = "A")]
    pub modulus_a: Pressure,
    /// B: term of second order in the compression.
    #[serde(rename = "B")]
    pub modulus_b: Pressure,
    /// E_0: energy by which b fades.
    #[serde(rename = "E_0")]
    pub e_0: SpecificEnergy,
    /// E_iv: energy of incipient vaporisation.
    #[serde(rename = "E_iv")]
    pub e_iv: SpecificEnergy,
    /// E_cv: energy of complete vaporisation.
    #[serde(rename = "E_cv")]
    pub e_cv: SpecificEnergy,
    /// alpha: decay of the thermal pressure in expansion.
    pub alpha: Number,
    /// beta: decay of the cold pressure in expansion.
    pub beta: Number,
}

impl TillotsonTable {
    pub(super) fn validate(&self, place: &str) -> Result<()> {
        all_positive(
            place,
            &[
                ("rho_0", self.rho_0.0),
                ("a", self.a.0),
                ("A", self.modulus_a.0),
                ("E_0", self.e_0.0),
                ("E_iv", self.e_iv.0),
                ("E_cv", self.e_cv.0),
            ],
        )?;
        none_negative(
            place,
            &[("b", self.b.0), ("B", self.modulus_b.0), ("alpha", self.alpha.0), ("beta", self.beta.0)],
        )?;
        if self.e_cv.0 > self.e_iv.0 {
            return Ok(());
        }
        Err(Error::new(format!("E_cv is {:e} J/kg, not above E_iv = {:e} J/kg", self.e_cv.0, self.e_iv.0))
            .at(format!("{place}.E_cv")))
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tillotson {
    rho_0: f64,
    inverse_rho_0: f64,
    a: f64,
    b: f64,
    modulus_a: f64,
    /// B in compression and in expansion.
    modulus_b: [f64; 2],
    e_0: f64,
    e_iv: f64,
    e_cv: f64,
    alpha: f64,
    beta: f64,
}

impl Tillotson {
    pub fn new(table: &TillotsonTable) -> Self {
        let (rho_0, modulus_a, modulus_b) = (table.rho_0.0, table.modulus_a.0, table.modulus_b.0);
        Self {
            rho_0,
            inverse_rho_0: 1.0 / rho_0,
            a: table.a.0,
            b: table.b.0,
            modulus_a,
            modulus_b: [modulus_b, if modulus_b > 2.0 * modulus_a { 0.0 } else { modulus_b.min(modulus_a) }],
            e_0: table.e_0.0,
            e_iv: table.e_iv.0,
            e_cv: table.e_cv.0,
            alpha: table.alpha.0,
            beta: table.beta.0,
        }
    }

    pub fn reference_density(&self) -> f64 {
        self.rho_0
    }

    /// K = rho dP/drho at rho_0 and u = 0, Pa.
    pub fn bulk_modulus(&self) -> f64 {
        self.modulus_a
    }

    /// E_iv and E_cv, J/kg.
    pub fn vaporisation(&self) -> [f64; 2] {
        [self.e_iv, self.e_cv]
    }

    /// Pressure, Pa, and speed of sound, m/s. An energy below zero counts as zero.
    #[inline]
    pub fn pressure(&self, rho: f64, u: f64) -> (f64, f64) {
        let state = self.slopes(rho, u);
        (state.p, bounded_sound(state.sound2(self.bounded(rho)), self.modulus_a * self.inverse_rho_0))
    }

    /// Pressure and its derivatives, of an energy of at least zero.
    #[inline]
    pub fn slopes(&self, rho: f64, u: f64) -> Slopes {
        self.state(self.bounded(rho), if u < 0.0 { 0.0 } else { u })
    }

    /// Comparisons, as f64::max would turn a NaN into a number and hide it.
    #[inline]
    fn bounded(&self, rho: f64) -> f64 {
        let lowest = LOWEST_ETA * self.rho_0;
        if rho < lowest { lowest } else { rho }
    }

    #[inline]
    fn state(&self, rho: f64, u: f64) -> Slopes {
        let eta = rho * self.inverse_rho_0;
        if eta >= 1.0 {
            return self.condensed(rho, u, self.modulus_b[0]);
        }
        let state = if u <= self.e_iv {
            self.condensed(rho, u, self.modulus_b[1])
        } else if u >= self.e_cv {
            self.vapour(rho, u)
        } else {
            self.mixture(rho, u)
        };
        fading(state, eta, self.inverse_rho_0)
    }

    /// P_c.
    #[inline]
    fn condensed(&self, rho: f64, u: f64, modulus_b: f64) -> Slopes {
        let eta = rho * self.inverse_rho_0;
        let mu = eta - 1.0;
        let scale = self.e_0 * eta * eta;
        let inverse_omega = scale / (scale + u);
        let gamma = self.a + self.b * inverse_omega;
        Slopes {
            p: gamma * rho * u + (self.modulus_a + modulus_b * mu) * mu,
            by_rho: (gamma + 2.0 * self.b * inverse_omega * (1.0 - inverse_omega)) * u
                + (self.modulus_a + 2.0 * modulus_b * mu) * self.inverse_rho_0,
            by_u: (self.a + self.b * inverse_omega * inverse_omega) * rho,
        }
    }

    /// P_e.
    fn vapour(&self, rho: f64, u: f64) -> Slopes {
        let eta = rho * self.inverse_rho_0;
        let mu = eta - 1.0;
        let nu = 1.0 / eta - 1.0;
        let scale = self.e_0 * eta * eta;
        let inverse_omega = scale / (scale + u);
        let decay = libm::exp(-self.alpha * nu * nu);
        let cold = self.modulus_a * libm::exp(-self.beta * nu);
        let bracket = self.b * rho * u * inverse_omega + cold * mu;
        // d nu / d rho = -1 / (eta^2 rho_0)
        let nu_by_rho = -self.inverse_rho_0 / (eta * eta);
        let bracket_by_rho = self.b * u * inverse_omega * (3.0 - 2.0 * inverse_omega)
            + cold * (self.inverse_rho_0 - self.beta * mu * nu_by_rho);
        Slopes {
            p: self.a * rho * u + bracket * decay,
            by_rho: self.a * u + (bracket_by_rho - 2.0 * self.alpha * nu * nu_by_rho * bracket) * decay,
            by_u: (self.a + self.b * inverse_omega * inverse_omega * decay) * rho,
        }
    }

    /// Between incipient and complete vaporisation.
    fn mixture(&self, rho: f64, u: f64) -> Slopes {
        let (cold, hot) = (self.condensed(rho, u, self.modulus_b[1]), self.vapour(rho, u));
        let by_fraction = 1.0 / (self.e_cv - self.e_iv);
        let fraction = (u - self.e_iv) * by_fraction;
        let mix = |c: f64, h: f64| c + fraction * (h - c);
        Slopes {
            p: mix(cold.p, hot.p),
            by_rho: mix(cold.by_rho, hot.by_rho),
            by_u: mix(cold.by_u, hot.by_u) + (hot.p - cold.p) * by_fraction,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::testing::{basalt, nylon};
    use super::super::Eos;
    use super::super::slopes::{TENSION_FADES, TENSION_GONE};
    use super::*;

    fn law(material: super::super::super::MaterialTable) -> Tillotson {
        match material.eos.law() {
            Eos::Tillotson(law) => law,
            other => panic!("{other:?}"),
        }
    }

    /// Points in all branches: compressed cold and hot, expanded cold with full, fading and no tension, mixture,
    /// vapour.
    const POINTS: [(f64, f64); 12] = [
        (1.3, 0.0),
        (1.5, 5e6),
        (1.1, 4e7),
        (0.98, 0.0),
        (0.98, 3e6),
        (0.91, 1e4),
        (0.8, 4e6),
        (0.97, 8e6),
        (0.6, 1.5e7),
        (0.9, 3e7),
        (0.5, 2.5e7),
        (0.01, 4e7),
    ];

    /// Central differences with a relative step s have an error of order s^2; 1e-4 of the natural scale is far above it
    /// and far below what a wrong term would make.
    #[test]
    fn derivatives_agree_with_differences() {
        for law in [law(basalt()), law(nylon())] {
            for (eta, u) in POINTS {
                let rho = eta * law.rho_0;
                let state = law.state(rho, u);
                let (dr, du) = (1e-5 * rho, 1e-5 * (u + 1e3));
                let by_rho = (law.state(rho + dr, u).p - law.state(rho - dr, u).p) / (2.0 * dr);
                let by_u = (law.state(rho, u + du).p - law.state(rho, u - du).p) / (2.0 * du);
                assert!(
                    (state.by_rho - by_rho).abs() < 1e-4 * law.modulus_a / law.rho_0,
                    "{eta} {u}: {state:?} {by_rho}"
                );
                assert!((state.by_u - by_u).abs() < 1e-4 * rho, "{eta} {u}: {state:?} {by_u}");
            }
        }
    }

    #[test]
    fn pressure_is_continuous_between_branches() {
        for law in [law(basalt()), law(nylon())] {
            let near = |rho: f64, u: f64, drho: f64, du: f64| {
                let (below, above) = (law.state(rho - drho, u - du), law.state(rho + drho, u + du));
                assert!((below.p - above.p).abs() < 1e-8 * law.modulus_a, "{rho} {u}: {below:?} {above:?}");
            };
            for eta in [0.2, 0.7, 0.9, 0.96, 0.999] {
                near(eta * law.rho_0, law.e_iv, 0.0, 1e-10 * law.e_iv);
                near(eta * law.rho_0, law.e_cv, 0.0, 1e-10 * law.e_cv);
            }
            for u in [0.0, 1e5, 1e7, 3e7] {
                for eta in [1.0, TENSION_FADES, TENSION_GONE] {
                    near(eta * law.rho_0, u, 1e-10 * law.rho_0, 0.0);
                }
            }
        }
    }

    /// Plane impact of basalt on basalt at 5 km/s, from the jump conditions solved independently: 48.13 GPa at 4157.7 kg/m^3, u = u_p^2 / 2.
    #[test]
    fn basalt_lies_on_its_hugoniot() {
        let (p, c) = law(basalt()).pressure(4157.7, 0.5 * 2500.0 * 2500.0);
        assert!((p / 48.13e9 - 1.0).abs() < 2e-4, "{p:e}");
        // Sound behind the front is faster than the front seen from there: U_s - u_p = 7131 - 2500 m/s.
        assert!(c > 4631.0);
    }

    #[test]
    fn sound_speed_at_rest_is_that_of_the_bulk_modulus() {
        let (p, c) = law(basalt()).pressure(2700.0, 0.0);
        assert_eq!(p, 0.0);
        assert!((c - (26.7e9f64 / 2700.0).sqrt()).abs() < 1e-9);
    }

    /// Cold nylon below eta = 0.70 must not push. The tension A (1 - eta) (eta - 0.85) / 0.1, which
    /// B > 0 only weakens, is largest at eta = 0.925: 0.05625 A.
    #[test]
    fn cold_expanded_matter_never_pushes_and_never_pulls_far() {
        let rounding = 1.0 + 1e-12;
        for law in [law(basalt()), law(nylon())] {
            for step in 1..1000 {
                let eta = step as f64 * 1e-3;
                let (p, _) = law.pressure(eta * law.rho_0, 0.0);
                assert!(p <= 0.0 && p >= -0.05625 * rounding * law.modulus_a, "{eta} {p:e}");
                assert!(p == 0.0 || eta > TENSION_GONE);
            }
            // Small tension is that of the law.
            let (p, _) = law.pressure(0.96 * law.rho_0, 0.0);
            let mu = 0.96 - 1.0;
            assert!((p / (law.modulus_a * mu + law.modulus_b[1] * mu * mu) - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn every_state_is_finite_with_a_bounded_sound_speed() {
        for law in [law(basalt()), law(nylon())] {
            for eta in [0.0, 1e-300, 1e-9, 1e-4, 0.02, 0.3, 0.5, 0.8, 0.9, 0.99, 1.0, 1.5, 4.0] {
                for u in [-1e6, 0.0, 1e-300, 1.0, 1e6, 4e6, 1e7, 7e7, 1e10] {
                    let (p, c) = law.pressure(eta * law.rho_0, u);
                    assert!(
                        p.is_finite() && c.is_finite() && c * c >= 0.999 * 0.25 * law.modulus_a / law.rho_0,
                        "{eta} {u}: {p} {c}"
                    );
                }
            }
            assert!(law.pressure(f64::NAN, 0.0).0.is_nan() && law.pressure(law.rho_0, f64::NAN).0.is_nan());
        }
    }

    /// Nylon in each branch, from the formulas written out; its B does not act in expansion.
    #[test]
    fn branches_by_hand() {
        let law = law(nylon());
        let omega = |eta: f64, u: f64| 1.0 + u / (7e6 * eta * eta);
        let near = |eta: f64, u: f64, expected: f64| {
            let (p, _) = law.pressure(1185.0 * eta, u);
            assert!((p / expected - 1.0).abs() < 1e-12, "{eta} {u}: {p:e} {expected:e}");
        };
        let condensed = |eta: f64, u: f64| {
            let (mu, b) = (eta - 1.0, if eta > 1.0 { 33.8e9 } else { 0.0 });
            (0.6 + 2.0 / omega(eta, u)) * 1185.0 * eta * u + 10.1e9 * mu + b * mu * mu
        };
        let vapour = |eta: f64, u: f64| {
            let (rho, mu, nu) = (1185.0 * eta, eta - 1.0, 1.0 / eta - 1.0);
            let cold = 10.1e9 * mu * f64::exp(-5.0 * nu);
            0.6 * rho * u + (2.0 * rho * u / omega(eta, u) + cold) * f64::exp(-10.0 * nu * nu)
        };
        near(1.3, 2e7, condensed(1.3, 2e7));
        near(0.98, 1e6, condensed(0.98, 1e6));
        for (eta, u) in [(0.9, 3e6), (0.8, 2.5e6), (0.5, 2.4e6), (0.05, 4e7)] {
            near(eta, u, vapour(eta, u));
        }
        // A quarter of the way from incipient to complete vaporisation.
        near(0.97, 2.1e6, 0.75 * condensed(0.97, 2.1e6) + 0.25 * vapour(0.97, 2.1e6));
    }
}
