//! Plane shocks of matter with any equation of state, impacts of two half-spaces, release to a free surface. Melosh 1989,
//! chapter 3; Zel'dovich & Raizer 1967, chapters I and XI.
//!
//! ```text
//! mass, momentum, energy through a front:   u = U dV / V_0    s - s_0 = u^2 / dV    E - E_0 = s_0 dV + u^2 / 2
//! impact:    both sides share the velocity of the contact and the stress on it
//! release:   dE = P / rho^2 drho    du = -(c / rho) drho    c^2 = dP/drho at constant entropy, down to P = 0
//! ```
//! V = 1 / rho specific volume, dV = V_0 - V; u velocity gained, U speed of the front, both against the matter ahead; s
//! stress, the pressure P of a fluid; E specific internal energy.
//!
//! c follows from the pressure alone, as the law's own speed of sound has a floor. Where the law reduces or removes tension, matter
//! that reaches P = 0 stays there, so that the release is over.

use super::{State, all_positive, root, runge_kutta};
use crate::error::Result;
use crate::material::eos::Eos;

/// Uniform matter at rest.
#[derive(Debug, Clone, PartialEq)]
pub struct Medium {
    pub law: Eos,
    /// kg/m^3.
    pub density: f64,
    /// Specific, J/kg.
    pub internal_energy: f64,
}

/// A front and the state behind it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Front {
    pub behind: State,
    /// m/s, in the frame of the velocities of the states.
    pub speed: f64,
}

/// The front that adds `gain`, m/s, at least 0, to the velocity of the matter ahead; `stress` is that of matter with a given
/// density and internal energy behind the front. The speed of a front with no gain is NaN.
pub(super) fn jump(ahead: &State, gain: f64, stress: impl Fn(f64, f64) -> f64) -> Result<Front> {
    let volume = 1.0 / ahead.density;
    let behind = |shrunk: f64| {
        let density = 1.0 / (volume - shrunk);
        let internal_energy = ahead.internal_energy + ahead.stress * shrunk + 0.5 * gain * gain;
        let stress = stress(density, internal_energy);
        State { density, velocity: ahead.velocity + gain, stress, internal_energy, distention: 0.0 }
    };
    // At the upper end matter is 1e9 times as dense as ahead: no law allows that at a lower stress than the jump requires.
    let shrunk =
        root(0.0, volume * (1.0 - 1e-9), |shrunk| (behind(shrunk).stress - ahead.stress) * shrunk - gain * gain)?;
    Ok(Front { behind: behind(shrunk), speed: ahead.velocity + volume * gain / shrunk })
}

/// Matter that has expanded to zero pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Release {
    /// kg/m^3; zero where the matter expands without limit.
    pub density: f64,
    /// Specific, J/kg.
    pub internal_energy: f64,
    /// Velocity of the free surface, m/s.
    pub velocity: f64,
}

impl Medium {
    /// The state at rest.
    pub fn state(&self) -> State {
        let (density, internal_energy) = (self.density, self.internal_energy);
        let stress = self.law.pressure(density, internal_energy).0;
        State { density, stress, internal_energy, ..State::default() }
    }

    /// The shock that gives the matter the velocity `particle_speed`, m/s.
    pub fn shock(&self, particle_speed: f64) -> Result<Front> {
        all_positive(&[("the density", self.density), ("the particle speed", particle_speed)])?;
        jump(&self.state(), particle_speed, |density, energy| self.law.pressure(density, energy).0)
    }

    /// Along an isentrope, by x = ln rho: dE/dx = P / rho and du/dx = -c.
    fn expansion(&self, x: f64, energy: f64) -> [f64; 2] {
        let pressure = |x: f64, energy: f64| self.law.pressure(libm::exp(x), energy).0;
        let rho = libm::exp(x);
        let by_x = pressure(x, energy) / rho;
        // P along the isentrope to both sides: errors of order d^2 from curvature and 1e-16 / d from rounding.
        let d = 1e-5;
        let rise = pressure(x + d, energy + by_x * d) - pressure(x - d, energy - by_x * d);
        [by_x, -(rise / (2.0 * d * rho)).max(0.0).sqrt()]
    }

    /// The state to which the shocked state `behind` expands when the shock reaches a free surface.
    pub fn release(&self, behind: &State) -> Result<Release> {
        /// Longest step in ln rho, and what one step may add to the relative error.
        const LONGEST: f64 = 0.02;
        const TOLERANCE: f64 = 1e-10;
        /// Expansion from which on the pressure is a power of the density.
        const GAS: f64 = 1e-6;
        let slope = |x: f64, y: &[f64; 2]| self.expansion(x, y[0]);
        let pressure = |x: f64, y: &[f64; 2]| self.law.pressure(libm::exp(x), y[0]).0;
        all_positive(&[("the density", behind.density), ("the pressure before release", behind.stress)])?;
        let (mut x, mut y) = (libm::log(behind.density), [behind.internal_energy, behind.velocity]);
        let (last, scale) = (x + libm::log(GAS), [y[0], y[1].abs() + slope(x, &y)[1].abs()]);
        let mut step = -LONGEST;
        while x > last {
            // One step against two of half the length. The speed of sound jumps between the branches of a law: there the step
            // shrinks until the jump no longer counts.
            let whole = runge_kutta(x, &y, step, slope);
            let halves = runge_kutta(x + 0.5 * step, &runge_kutta(x, &y, 0.5 * step, slope), 0.5 * step, slope);
            let wrong = (0..2).any(|k| (whole[k] - halves[k]).abs() > TOLERANCE * scale[k]);
            if wrong && step < -TOLERANCE {
                step *= 0.5;
                continue;
            }
            let pushes = pressure(x + step, &whole) > 0.0;
            if !pushes {
                let after = |part: f64| runge_kutta(x, &y, part * step, slope);
                let part = root(0.0, 1.0, |part| {
                    let p = pressure(x + part * step, &after(part));
                    if p > 0.0 { p } else { -1.0 }
                })?;
                let [internal_energy, velocity] = after(part);
                return Ok(Release { density: libm::exp(x + part * step), internal_energy, velocity });
            }
            (x, y) = (x + step, halves);
            step = (2.0 * step).max(-LONGEST);
        }
        // From here on P goes with rho^gamma: what is still to come are the integrals of P / rho^2 and c / rho down to nothing.
        let [per_mass, sound] = slope(x, &y).map(f64::abs);
        let gamma = sound * sound / per_mass;
        let internal_energy = (y[0] - per_mass / (gamma - 1.0)).max(0.0);
        Ok(Release { density: 0.0, internal_energy, velocity: y[1] + 2.0 * sound / (gamma - 1.0) })
    }
}

/// Two half-spaces that have met at x = 0, t = 0: the target, at rest, lies at x > 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Impact {
    projectile: State,
    target: State,
    /// Velocity of the contact, m/s.
    pub velocity: f64,
    /// Runs into the projectile, with a speed that may have either sign.
    pub projectile_shock: Front,
    /// Runs into the target.
    pub target_shock: Front,
}

impl Impact {
    /// `speed` of the projectile, m/s. Fails unless both start at about the same pressure.
    pub fn new(projectile: &Medium, target: &Medium, speed: f64) -> Result<Self> {
        all_positive(&[
            ("the density of the projectile", projectile.density),
            ("the density of the target", target.density),
            ("the impact speed", speed),
        ])?;
        let shocked =
            |medium: &Medium, gain: f64| jump(&medium.state(), gain, |rho, energy| medium.law.pressure(rho, energy).0);
        let stress = |medium: &Medium, gain: f64| shocked(medium, gain).map_or(f64::NAN, |front| front.behind.stress);
        let velocity = root(0.0, speed, |u| stress(target, u) - stress(projectile, speed - u))?;
        // Seen from the projectile, the target comes from the other side.
        let mirrored = shocked(projectile, speed - velocity)?;
        let projectile_shock = Front { behind: State { velocity, ..mirrored.behind }, speed: speed - mirrored.speed };
        Ok(Self {
            projectile: State { velocity: speed, ..projectile.state() },
            target: target.state(),
            velocity,
            projectile_shock,
            target_shock: shocked(target, velocity)?,
        })
    }

    /// State at `x`, m, and the time `t` since the contact, s.
    pub fn at(&self, x: f64, t: f64) -> State {
        if x < self.projectile_shock.speed * t {
            self.projectile
        } else if x < self.velocity * t {
            self.projectile_shock.behind
        } else if x < self.target_shock.speed * t {
            self.target_shock.behind
        } else {
            self.target
        }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::material::eos::EosTable;

    pub fn medium(eos: &str, density: f64) -> Medium {
        let table: std::collections::BTreeMap<String, EosTable> = toml::from_str(&format!("eos = {eos}")).unwrap();
        Medium { law: table["eos"].law(), density, internal_energy: 0.0 }
    }

    fn solid(rho_0: f64, [a, b, modulus_a, modulus_b, e_0, e_iv, e_cv, alpha]: [f64; 8]) -> Medium {
        let eos = format!(
            "{{ tillotson = {{ rho_0 = {rho_0}, a = {a}, b = {b}, A = {modulus_a}, B = {modulus_b}, E_0 = {e_0}, E_iv = {e_iv}, \
             E_cv = {e_cv}, alpha = {alpha}, beta = 5 }} }}"
        );
        medium(&eos, rho_0)
    }

    // Benz & Asphaug 1999; Melosh 1989, appendix II.
    pub fn basalt() -> Medium {
        solid(2700.0, [0.5, 1.5, 26.7e9, 26.7e9, 487e6, 4.72e6, 18.2e6, 5.0])
    }

    pub fn aluminium() -> Medium {
        solid(2700.0, [0.5, 1.63, 75.2e9, 65e9, 5e6, 3e6, 13.9e6, 5.0])
    }

    fn ice() -> Medium {
        solid(917.0, [0.3, 0.1, 9.47e9, 9.47e9, 10e6, 0.773e6, 3.04e6, 10.0])
    }

    fn nylon() -> Medium {
        solid(1185.0, [0.6, 2.0, 10.1e9, 33.8e9, 7e6, 2e6, 2.4e6, 10.0])
    }

    pub fn near(a: f64, b: f64, tolerance: f64) {
        assert!((a / b - 1.0).abs() < tolerance, "{a} {b}");
    }

    /// Mass, momentum and energy through a front, in its own frame.
    pub fn obeys_the_jump_conditions(ahead: &State, front: &Front) {
        let behind = &front.behind;
        let flow = ahead.density * (front.speed - ahead.velocity);
        near(behind.density * (front.speed - behind.velocity), flow, 1e-9);
        near(behind.stress - ahead.stress, flow * (behind.velocity - ahead.velocity), 1e-9);
        let energy = |s: &State| s.internal_energy + 0.5 * s.velocity * s.velocity;
        let work = behind.stress * behind.velocity - ahead.stress * ahead.velocity;
        near(flow * (energy(behind) - energy(ahead)), work, 1e-9);
    }

    /// The jump conditions solved independently, to the digits given.
    #[test]
    fn tabulated_impacts() {
        let like = Impact::new(&aluminium(), &aluminium(), 1000.0).unwrap();
        near(like.velocity, 500.0, 1e-12);
        near(like.target_shock.behind.stress, 8.122e9, 1e-4);
        near(like.target_shock.speed, 6016.0, 1e-4);
        let rock = Impact::new(&basalt(), &basalt(), 5000.0).unwrap().target_shock;
        near(rock.behind.stress, 48.13e9, 1e-4);
        near(rock.speed, 7131.0, 1e-4);
        near(rock.behind.density, 4157.7, 1e-5);
        let mixed = Impact::new(&aluminium(), &ice(), 10e3).unwrap();
        near(mixed.velocity, 7133.0, 1e-4);
        near(mixed.target_shock.behind.stress, 72.5e9, 1e-3);
        let nylon = Impact::new(&nylon(), &basalt(), 3200.0).unwrap();
        near(nylon.velocity, 1220.67, 1e-5);
        near(nylon.target_shock.behind.stress, 16.5907e9, 1e-5);
    }

    /// Whatever meets what: both fronts are shocks of their matter, and the contact is in balance.
    #[test]
    fn impacts_obey_the_jump_conditions() {
        let gas = Medium { internal_energy: 2e5, ..medium("{ ideal_gas = { gamma = 1.4 } }", 1.2) };
        let dense = Medium { density: 12.0, internal_energy: 2e4, ..gas.clone() };
        let warm = Medium { density: 2691.0, internal_energy: 7e3, ..basalt() };
        for (projectile, target, speed) in [
            (basalt(), ice(), 700.0),
            (nylon(), aluminium(), 9000.0),
            (dense.clone(), gas.clone(), 350.0),
            (gas, dense, 2000.0),
            (warm.clone(), warm, 40.0),
        ] {
            let impact = Impact::new(&projectile, &target, speed).unwrap();
            let (near_side, far_side) = (impact.projectile_shock, impact.target_shock);
            near(near_side.behind.stress, far_side.behind.stress, 1e-9);
            obeys_the_jump_conditions(&target.state(), &far_side);
            obeys_the_jump_conditions(&State { velocity: speed, ..projectile.state() }, &near_side);
            for (medium, state) in [(&projectile, near_side.behind), (&target, far_side.behind)] {
                near(medium.law.pressure(state.density, state.internal_energy).0, state.stress, 1e-12);
            }
            let t = 2e-3;
            assert_eq!(impact.at(near_side.speed * t - 1e-6, t).velocity, speed);
            assert_eq!(impact.at(impact.velocity * t - 1e-6, t), near_side.behind);
            assert_eq!(impact.at(impact.velocity * t + 1e-6, t), far_side.behind);
            assert_eq!(impact.at(far_side.speed * t + 1e-6, t), target.state());
        }
        assert!(Impact::new(&basalt(), &ice(), 0.0).is_err());
    }

    /// A strong shock in a cold gas: (gamma + 1) / (gamma - 1) times the density, U = (gamma + 1) / 2 u. The free surface then
    /// runs at u + 2 c / (gamma - 1) and nothing is left behind.
    #[test]
    fn gas_has_closed_forms() {
        let gas = medium("{ ideal_gas = { gamma = 1.4 } }", 1.2);
        let front = gas.shock(500.0).unwrap();
        near(front.behind.density, 7.2, 1e-12);
        near(front.speed, 600.0, 1e-12);
        let release = gas.release(&front.behind).unwrap();
        let c = (1.4 * front.behind.stress / front.behind.density).sqrt();
        near(release.velocity, 500.0 + 5.0 * c, 1e-10);
        assert!(release.density == 0.0 && release.internal_energy < 1e-8 * front.behind.internal_energy);
        assert!(gas.release(&gas.state()).is_err());
    }

    /// An independent integration of the isentrope, to the digits given: speed of the free surface, residual energy, density.
    #[test]
    fn tabulated_releases() {
        for (medium, u, velocity, energy, density) in [
            (aluminium(), 500.0, 1000.9, 9.215e3, 2698.1),
            (aluminium(), 2000.0, 4050.8, 3.329e5, 2634.9),
            (aluminium(), 5000.0, 10433.2, 2.7094e6, 2329.0),
            (basalt(), 1000.0, 2018.5, 8.254e4, 2654.9),
            (basalt(), 2500.0, 5242.2, 6.220e5, 2360.8),
            (basalt(), 4000.0, 8769.1, 1.3947e6, 1941.5),
            (ice(), 1000.0, 1994.6, 8.408e4, 914.0),
            (ice(), 3000.0, 5986.7, 1.4520e6, 863.3),
        ] {
            let release = medium.release(&medium.shock(u).unwrap().behind).unwrap();
            near(release.velocity, velocity, 5e-5);
            near(release.internal_energy, energy, 2e-4);
            near(release.density, density, 5e-5);
        }
    }

    /// The work done on the way out, summed over volumes with the trapezoidal rule, is what the matter loses; and vapour too
    /// comes to an end.
    #[test]
    fn release_turns_internal_energy_into_motion() {
        let start = nylon().shock(1500.0).unwrap().behind;
        let end = nylon().release(&start).unwrap();
        let (law, mut energy, mut velocity) = (nylon().law, start.internal_energy, start.velocity);
        let steps = 100_000;
        let (first, last) = (1.0 / start.density, 1.0 / end.density);
        let dv = (last - first) / f64::from(steps);
        let pressure = |v: f64, energy: f64| law.pressure(1.0 / v, energy).0;
        for i in 0..steps {
            let v = first + f64::from(i) * dv;
            let before = pressure(v, energy);
            let guess = pressure(v + dv, energy - before * dv);
            energy -= 0.5 * (before + guess) * dv;
            velocity += ((before - pressure(v + dv, energy)) * dv).sqrt();
        }
        near(end.internal_energy, energy, 1e-6);
        near(end.velocity, velocity, 1e-6);
        // Mixed with liquid at the end, and as vapour throughout.
        for (speed, expands_without_limit) in [(15e3, false), (50e3, true)] {
            let release = basalt().release(&basalt().shock(speed).unwrap().behind).unwrap();
            assert!(release.velocity > 2.0 * speed && release.velocity < 4.0 * speed, "{release:?}");
            assert_eq!(release.density == 0.0, expands_without_limit);
        }
    }
}
