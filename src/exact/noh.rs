//! Implosion of a cold ideal gas that falls everywhere at the same speed towards a plane, an axis or a point. Noh 1987, J.
//! Comput. Phys. 72, 78.
//!
//! ```text
//! shock at r = (gamma - 1) u t / 2
//! within:   rho = rho_0 [(gamma + 1) / (gamma - 1)]^d    P = (gamma - 1) rho u^2 / 2    at rest
//! outside:  rho = rho_0 (1 + u t / r)^(d - 1)            P = 0                          velocity -u
//! ```
//! r distance, d dimension, rho_0 density at the start, u inward speed, gamma ratio of heats.

use super::{State, all_above, all_positive, unit_surface};
use crate::error::Result;

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Noh {
    dimension: usize,
    gamma: f64,
    density: f64,
    speed: f64,
}

impl Noh {
    /// `density` at the start, kg/m^3; `speed` inward, m/s. Fails for other dimensions than 1, 2, 3.
    pub fn new(dimension: usize, gamma: f64, density: f64, speed: f64) -> Result<Self> {
        unit_surface(dimension)?;
        all_above(1.0, &[("gamma", gamma)])?;
        all_positive(&[("the density", density), ("the speed", speed)])?;
        Ok(Self { dimension, gamma, density, speed })
    }

    /// Distance of the shock at the time `t`, m.
    pub fn shock_radius(&self, t: f64) -> f64 {
        0.5 * (self.gamma - 1.0) * self.speed * t
    }

    /// State at the distance `r`, m, and the time `t`, s.
    pub fn at(&self, r: f64, t: f64) -> State {
        if r < self.shock_radius(t) {
            let ratio = (self.gamma + 1.0) / (self.gamma - 1.0);
            let density = self.density * ratio.powi(self.dimension as i32);
            let internal_energy = 0.5 * self.speed * self.speed;
            return State {
                density,
                stress: (self.gamma - 1.0) * density * internal_energy,
                internal_energy,
                ..State::default()
            };
        }
        let gathered = if t > 0.0 { 1.0 + self.speed * t / r } else { 1.0 };
        let density = self.density * gathered.powi(self.dimension as i32 - 1);
        State { density, velocity: -self.speed, ..State::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Noh 1987: 64, 64/3, the shock at t/3, (1 + t/r)^2 outside.
    #[test]
    fn spherical_implosion_of_a_monatomic_gas() {
        let noh = Noh::new(3, 5.0 / 3.0, 1.0, 1.0).unwrap();
        let (inside, outside) = (noh.at(0.1, 0.6), noh.at(0.3, 0.6));
        assert!((inside.density - 64.0).abs() < 1e-12 && (inside.stress - 64.0 / 3.0).abs() < 1e-12);
        assert!((noh.shock_radius(0.6) - 0.2).abs() < 1e-15);
        assert!((outside.density - 9.0).abs() < 1e-12 && outside.velocity == -1.0 && outside.stress == 0.0);
        assert_eq!(noh.at(0.0, 0.0), State { density: 1.0, velocity: -1.0, ..State::default() });
    }

    /// Mass, momentum and energy through the front, in every dimension.
    #[test]
    fn front_obeys_the_jump_conditions() {
        for dimension in 1..=3 {
            for gamma in [1.2, 1.4, 3.0] {
                let noh = Noh::new(dimension, gamma, 2.5, 300.0).unwrap();
                let t = 0.7;
                let front = noh.shock_radius(t);
                let speed = front / t;
                let (behind, ahead) = (noh.at(front * (1.0 - 1e-12), t), noh.at(front * (1.0 + 1e-12), t));
                let flow = ahead.density * (speed - ahead.velocity);
                let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-10, "{dimension} {gamma}: {a} {b}");
                near(behind.density * speed, flow);
                near(behind.stress, flow * 300.0);
                near(behind.internal_energy, 0.5 * 300.0 * 300.0);
                near(behind.stress, (gamma - 1.0) * behind.density * behind.internal_energy);
            }
        }
        assert!(Noh::new(4, 1.4, 1.0, 1.0).is_err() && Noh::new(2, 1.4, 1.0, -1.0).is_err());
    }
}
