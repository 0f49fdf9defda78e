//! Matter that is pressed together without friction: what work against its pressure leaves in it as internal energy,
//!
//! ```text
//! du/drho = P(rho, u) / rho^2
//! ```
//! from the density at which matter of a given energy bears no pressure on. Matter that was pressed together without this energy would be
//! below the cold curve, and come out of it with less than none.

use crate::error::Error;
use crate::material::eos::Eos;
use crate::scene::tables::body::validated::Body;

/// Ratio of the densities of two entries.
const STEP: f64 = 1.005;
/// Largest density, over the first.
const MOST: f64 = 100.0;

/// (density kg/m^3, energy J/kg, pressure Pa) of ever denser matter.
pub struct Isentrope<'a> {
    law: &'a Eos,
    states: Vec<[f64; 3]>,
}

impl<'a> Isentrope<'a> {
    /// The isentrope from matter of energy `u`, J/kg, without pressure on; none where no density above a tenth of the law's own has that.
    pub fn new(law: &'a Eos, u: f64) -> Option<Self> {
        let rest = law.reference_density()?;
        let pulls = |rho: f64| law.pressure(rho, u).0 <= 0.0;
        let mut low = rest;
        while !pulls(low) {
            low *= 0.9;
            if low < 0.1 * rest {
                return None;
            }
        }
        let mut high = if low < rest { low / 0.9 } else { rest };
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if pulls(middle) { low = middle } else { high = middle }
        }
        let first = high;
        let (mut rho, mut u) = (first, u);
        let mut states = Vec::new();
        while rho < MOST * first {
            states.push([rho, u, law.pressure(rho, u).0]);
            let next = rho * STEP;
            u = follow(law, (rho, u), next);
            rho = next;
        }
        Some(Self { law, states })
    }

    /// Density, kg/m^3, and energy, J/kg, at this pressure, Pa; none beyond the densest matter.
    pub fn at(&self, pressure: f64) -> Option<(f64, f64)> {
        let above = self.states.partition_point(|state| state[2] <= pressure);
        let &[rho, u, _] = self.states.get(above.max(1) - 1).filter(|_| above < self.states.len())?;
        let (mut low, mut high) = (rho, rho * STEP);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let p = self.law.pressure(middle, follow(self.law, (rho, u), middle)).0;
            if p < pressure { low = middle } else { high = middle }
        }
        let density = 0.5 * (low + high);
        Some((density, follow(self.law, (rho, u), density)))
    }
}

/// The energy at density `to`, a step of Runge and Kutta's fourth order away.
fn follow(law: &Eos, (rho, u): (f64, f64), to: f64) -> f64 {
    let h = to - rho;
    let slope = |rho: f64, u: f64| law.pressure(rho, u).0 / (rho * rho);
    let a = slope(rho, u);
    let b = slope(rho + 0.5 * h, u + 0.5 * h * a);
    let c = slope(rho + 0.5 * h, u + 0.5 * h * b);
    let d = slope(to, u + h * c);
    u + h / 6.0 * (a + 2.0 * b + 2.0 * c + d)
}

/// The error where the body has no density without pressure.
pub fn too_hot(body: &Body) -> Error {
    Error::new(format!("matter of {:.3e} J/kg has pressure at any density", body.internal_energy))
        .allowed("a cooler body")
}

/// The error where no density has this pressure, Pa.
pub fn too_much(pressure: f64) -> Error {
    Error::new(format!("no density of the body has a pressure of {pressure:.3e} Pa")).allowed("a smaller body")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    fn law(material: &str) -> Eos {
        let text = format!(
            "[[body]]\nname = \"ball\"\nshape = {{ sphere = {{ radius = 1 }} }}\nmaterial = \"{material}\"\nparticles = 100\n[run]\nuntil = 1\n"
        );
        Scene::parse("s.toml", &text, &[]).unwrap().materials[0].eos.law()
    }

    /// The pressure is the one asked for, and energy grows by the work of a small change of it.
    #[test]
    fn energy_is_the_work_of_compression() {
        for (material, u) in [("basalt", 0.0), ("ice", 0.0), ("iron", 1e5)] {
            let law = law(material);
            let isentrope = Isentrope::new(&law, u).unwrap();
            for pressure in [1e6, 1e9, 1e11, 1e13] {
                let [(a, u_a), (b, u_b)] = [0.999, 1.001].map(|factor| isentrope.at(factor * pressure).unwrap());
                assert!((law.pressure(a, u_a).0 / (0.999 * pressure) - 1.0).abs() < 1e-9);
                let work = pressure * (1.0 / a - 1.0 / b);
                assert!(((u_b - u_a) / work - 1.0).abs() < 1e-4, "{material} {pressure}: {} {work}", u_b - u_a);
            }
            let (rest, at_rest) = isentrope.at(0.0).unwrap();
            assert!(law.pressure(rest, at_rest).0.abs() < 1e-3 && (at_rest - u).abs() < 1e-3);
        }
        assert!(Isentrope::new(&law("basalt"), 0.0).unwrap().at(1e25).is_none());
    }
}
