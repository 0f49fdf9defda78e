//! A ball of rock that carries its own weight from the start.
//!
//! The ball keeps the mass that its shape has at its density without load. Shells are named by the mass m inside them; with
//! the pressure that each bears and the density that the equation of state gives it,
//!
//! ```text
//! P(m) = int_m^M G m' / (4 pi r^4) dm'       r^3(m) = int_0^m 3 / (4 pi rho) dm'       rho, u = isentrope(P)
//! ```
//!
//! is solved by iteration, from the ball without load on. Lattice sites move along their radius to where their shell is, so that
//! particles keep one mass.

use std::f64::consts::PI;

use super::isentrope::{Isentrope, too_hot, too_much};
use crate::error::{Error, Result};
use crate::gravity::G;
use crate::material::eos::Eos;
use crate::scene::tables::body::validated::Body;

const SHELLS: usize = 2000;
const MOST_ITERATIONS: usize = 200;
/// Change of a radius, relative, at which the iteration has converged.
const CONVERGED: f64 = 1e-12;

/// Where shells are, how dense they are and what energy that took, at equal steps of the radius without load.
#[derive(Debug, Clone, PartialEq)]
pub struct BallProfile {
    /// Radius of the ball without load, m.
    radius: f64,
    /// Radius of the shell over that without load; `SHELLS + 1` numbers.
    ratio: Vec<f64>,
    /// kg/m^3.
    density: Vec<f64>,
    /// J/kg.
    energy: Vec<f64>,
}

impl BallProfile {
    /// The profile of a ball, whose law has a density without load.
    pub fn new(body: &Body, law: &Eos) -> Result<Self> {
        let radius = body.shape.outer_radius();
        let at = |shell: usize| radius * shell as f64 / SHELLS as f64;
        let ball = |r: f64| 4.0 / 3.0 * PI * r * r * r;
        let mass: Vec<f64> = (0..=SHELLS).map(|shell| body.density * ball(at(shell))).collect();
        let mut r: Vec<f64> = (0..=SHELLS).map(at).collect();
        let isentrope = Isentrope::new(law, body.internal_energy).ok_or_else(|| too_hot(body))?;
        let mut density = vec![body.density; SHELLS + 1];
        let mut energy = vec![body.internal_energy; SHELLS + 1];
        let mut pressure = vec![0.0; SHELLS + 1];
        for _ in 0..MOST_ITERATIONS {
            // G m / (4 pi r^4) dm, by the trapezoid in r0: dm = 4 pi rho r0^2 dr0; nothing at the centre.
            let step = radius / SHELLS as f64;
            let weight = |k: usize| match k {
                0 => 0.0,
                k => G * mass[k] * body.density * (at(k) / r[k]).powi(2) / (r[k] * r[k]),
            };
            for k in (0..SHELLS).rev() {
                pressure[k] = pressure[k + 1] + 0.5 * step * (weight(k) + weight(k + 1));
            }
            for ((rho, u), p) in density.iter_mut().zip(&mut energy).zip(&pressure) {
                (*rho, *u) = isentrope.at(*p).ok_or_else(|| too_much(*p))?;
            }
            let (mut cube, mut change) = (0.0, 0.0f64);
            for k in 1..=SHELLS {
                let volume = (mass[k] - mass[k - 1]) / (0.5 * (density[k] + density[k - 1]));
                cube += 3.0 / (4.0 * PI) * volume;
                let new = libm::cbrt(cube);
                change = change.max((new / r[k] - 1.0).abs());
                r[k] = new;
            }
            if change < CONVERGED {
                let mut ratio: Vec<f64> = (0..=SHELLS).map(|k| r[k] / at(k)).collect();
                ratio[0] = ratio[1];
                return Ok(Self { radius, ratio, density, energy });
            }
        }
        Err(Error::new("the body finds no rest under its own weight").allowed("a smaller or stiffer body"))
    }

    /// For what lies at distance `r` from the centre without load (m): the distance that it gets over that, its density, kg/m^3,
    /// and its internal energy, J/kg.
    pub fn at(&self, r: f64) -> (f64, f64, f64) {
        let place = (r / self.radius * SHELLS as f64).min(SHELLS as f64);
        let below = (place as usize).min(SHELLS - 1);
        let part = place - below as f64;
        let between = |values: &[f64]| values[below] + part * (values[below + 1] - values[below]);
        (between(&self.ratio), between(&self.density), between(&self.energy))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    fn profile(radius: &str) -> (BallProfile, Scene) {
        let text = format!(
            "[[body]]\nname = \"ball\"\nshape = {{ sphere = {{ radius = \"{radius}\" }} }}\nmaterial = \"basalt\"\n\
             particles = 1000\nstart = \"hydrostatic\"\n[gravity]\nself = true\n[run]\nuntil = 1\n"
        );
        let scene = Scene::parse("s.toml", &text, &[]).unwrap();
        (BallProfile::new(&scene.bodies[0], &scene.materials[0].eos.law()).unwrap(), scene)
    }

    /// A small ball hardly gives way: P = 2/3 pi G rho^2 (R^2 - r^2).
    #[test]
    fn pressure_of_a_small_ball() {
        let (profile, scene) = profile("100 km");
        let law = scene.materials[0].eos.law();
        for r in [0.0, 2e4, 5e4, 9e4] {
            let (ratio, density, energy) = profile.at(r);
            let expected = 2.0 / 3.0 * PI * G * 2700.0f64.powi(2) * (1e10 - r * r);
            let found = law.pressure(density, energy).0;
            assert!((found / expected - 1.0).abs() < 2e-3, "{r}: {found} {expected}");
            assert!(ratio < 1.0 && ratio > 0.999);
        }
        assert!((profile.at(1e5).1 - 2700.0).abs() < 1e-6);
    }

    /// In a large one matter is pressed together, and each shell carries what lies above: mass and balance hold at any place.
    #[test]
    fn balance_of_a_large_ball() {
        let (profile, scene) = profile("3000 km");
        let law = scene.materials[0].eos.law();
        let p = |r0: f64| law.pressure(profile.at(r0).1, profile.at(r0).2).0;
        for r0 in [5e5, 1.5e6, 2.5e6] {
            let step = 6e3;
            let r = |r0: f64| r0 * profile.at(r0).0;
            let slope = (p(r0 + step) - p(r0 - step)) / (r(r0 + step) - r(r0 - step));
            let mass = 2700.0 * 4.0 / 3.0 * PI * r0.powi(3);
            let expected = -G * mass * profile.at(r0).1 / r(r0).powi(2);
            assert!((slope / expected - 1.0).abs() < 1e-3, "{r0}: {slope} {expected}");
            let shell = 4.0 * PI * r(r0).powi(2) * (r(r0 + step) - r(r0 - step)) * profile.at(r0).1;
            let its_mass = 2700.0 * 4.0 * PI * r0 * r0 * 2.0 * step;
            assert!((shell / its_mass - 1.0).abs() < 1e-3);
        }
        assert!(profile.at(0.0).1 > 1.1 * 2700.0);
    }

    #[test]
    fn what_does_not_rest_is_refused() {
        let said = |changes: &[&str]| {
            let text = "[[body]]\nname = \"ball\"\nshape = { sphere = { radius = \"10 km\" } }\nmaterial = \"basalt\"\nparticles = 1000\n\
                        start = \"hydrostatic\"\n[gravity]\nself = true\n[run]\nuntil = 1\n";
            let changes: Vec<String> = changes.iter().map(|change| change.to_string()).collect();
            Scene::parse("s.toml", text, &changes).map(|_| ()).map_err(|e| e.to_string())
        };
        assert_eq!(said(&[]), Ok(()));
        for (change, expected) in [
            ("gravity=false", "no matter attracts any here"),
            ("ball.shape={ box = { size = [1e4, 1e4, 1e4] } }", "the body is no ball"),
            ("ball.rubble={ radius = [1e3, 3e3], voids = 0.6 }", "the voids of a pile carry nothing"),
            ("material.basalt.porosity={ p_alpha = true }", "pores would crush first"),
        ] {
            let error = said(&[change]).unwrap_err();
            assert!(error.contains(expected) && error.contains("start"), "{change}: {error}");
        }
    }
}
