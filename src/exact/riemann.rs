//! Riemann problem of an ideal gas: two half-spaces meet at x = 0, t = 0. Toro 2009, chapter 4; Sod 1978 for its tube.
//!
//! ```text
//! f_L(p) + f_R(p) + u_R - u_L = 0                                                      gives the pressure p between the waves
//! f_K = (p - p_K) sqrt(2 / (rho_K [(gamma + 1) p + (gamma - 1) p_K]))                  shock, p > p_K
//! f_K = 2 c_K / (gamma - 1) [(p / p_K)^((gamma - 1) / (2 gamma)) - 1]                  rarefaction
//! ```
//! rho density, u velocity, p pressure, c speed of sound, gamma ratio of heats. A left wave is a right one in a mirror.

use super::{State, all_above, all_positive, doubled_until, root};
use crate::error::{Error, Result};

/// A uniform ideal gas.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gas {
    /// kg/m^3.
    pub density: f64,
    /// m/s.
    pub velocity: f64,
    /// Pa; may be zero.
    pub pressure: f64,
}

impl Gas {
    fn sound(&self, gamma: f64) -> f64 {
        (gamma * self.pressure / self.density).sqrt()
    }

    fn mirrored(self) -> Self {
        Self { velocity: -self.velocity, ..self }
    }

    /// f_K: velocity that a wave to pressure `p` takes from the gas.
    fn slowed(&self, p: f64, gamma: f64) -> f64 {
        let p_k = self.pressure;
        if p > p_k {
            (p - p_k) * (2.0 / (self.density * ((gamma + 1.0) * p + (gamma - 1.0) * p_k))).sqrt()
        } else if p_k == 0.0 {
            0.0
        } else {
            let exponent = (gamma - 1.0) / (2.0 * gamma);
            2.0 * self.sound(gamma) / (gamma - 1.0) * (libm::pow(p / p_k, exponent) - 1.0)
        }
    }
}

/// The solution: a wave on either side of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Riemann {
    left: Gas,
    right: Gas,
    gamma: f64,
    /// Pressure between the waves, Pa.
    pub pressure: f64,
    /// Velocity between the waves, with which the contact moves, m/s.
    pub velocity: f64,
}

impl Riemann {
    /// Fails where the gases part so fast that a vacuum opens between them.
    pub fn new(left: Gas, right: Gas, gamma: f64) -> Result<Self> {
        all_above(1.0, &[("gamma", gamma)])?;
        all_positive(&[
            ("the density of the left gas", left.density),
            ("the density of the right gas", right.density),
        ])?;
        for gas in [left, right] {
            if !(gas.pressure >= 0.0 && gas.pressure.is_finite() && gas.velocity.is_finite()) {
                return Err(Error::new(format!(
                    "a gas has the pressure {:e} and the velocity {:e}",
                    gas.pressure, gas.velocity
                ))
                .allowed("finite numbers, a pressure of at least 0"));
            }
        }
        let parting = right.velocity - left.velocity;
        let fastest = 2.0 * (left.sound(gamma) + right.sound(gamma)) / (gamma - 1.0);
        if parting >= fastest {
            return Err(Error::new(format!("the gases part at {parting:e} m/s and leave a vacuum between them"))
                .allowed(format!("less than {fastest:e} m/s")));
        }
        let excess = |p: f64| left.slowed(p, gamma) + right.slowed(p, gamma) + parting;
        let scale = left.pressure + right.pressure + left.density.max(right.density) * parting * parting;
        let pressure = root(0.0, doubled_until(scale, |p| excess(p) >= 0.0)?, excess)?;
        let change = right.slowed(pressure, gamma) - left.slowed(pressure, gamma);
        Ok(Self { left, right, gamma, pressure, velocity: 0.5 * (left.velocity + right.velocity + change) })
    }

    /// State at `x`, m, and the time `t`, s.
    pub fn at(&self, x: f64, t: f64) -> State {
        let gas = if t <= 0.0 {
            if x < 0.0 { self.left } else { self.right }
        } else if x / t < self.velocity {
            self.beside(self.left.mirrored(), -self.velocity, -x / t).mirrored()
        } else {
            self.beside(self.right, self.velocity, x / t)
        };
        State {
            density: gas.density,
            velocity: gas.velocity,
            stress: gas.pressure,
            internal_energy: gas.pressure / ((self.gamma - 1.0) * gas.density),
            ..State::default()
        }
    }

    /// The gas right of a contact of velocity `u`, at the speed `s` = x / t.
    fn beside(&self, gas: Gas, u: f64, s: f64) -> Gas {
        let (gamma, p, p_k, c) = (self.gamma, self.pressure, gas.pressure, gas.sound(self.gamma));
        let (above, below) = (gamma + 1.0, gamma - 1.0);
        if p > p_k {
            let density = gas.density * (above * p + below * p_k) / (below * p + above * p_k);
            let shock = gas.velocity + ((above * p + below * p_k) / (2.0 * gas.density)).sqrt();
            return if s > shock { gas } else { Gas { density, velocity: u, pressure: p } };
        }
        let expanded = |sound: f64, velocity: f64| Gas {
            density: gas.density * libm::pow(sound / c, 2.0 / below),
            velocity,
            pressure: p_k * libm::pow(sound / c, 2.0 * gamma / below),
        };
        let behind = c + 0.5 * below * (u - gas.velocity);
        if s >= gas.velocity + c {
            gas
        } else if s <= u + behind {
            Gas { pressure: p, ..expanded(behind, u) }
        } else {
            expanded((2.0 * c - below * (gas.velocity - s)) / above, (below * gas.velocity + 2.0 * (s - c)) / above)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gas(density: f64, velocity: f64, pressure: f64) -> Gas {
        Gas { density, velocity, pressure }
    }

    fn sod(gamma: f64) -> Riemann {
        Riemann::new(gas(1.0, 0.0, 1.0), gas(0.125, 0.0, 0.1), gamma).unwrap()
    }

    fn fluxes(state: &State, speed: f64) -> [f64; 3] {
        let State { density, velocity, stress, internal_energy, .. } = *state;
        let energy = density * (internal_energy + 0.5 * velocity * velocity);
        let relative = velocity - speed;
        [density * relative, density * velocity * relative + stress, energy * relative + stress * velocity]
    }

    /// Toro 2009, Riemann Solvers, section 4.3, for gamma = 1.4; an independent solution for 5/3; six digits.
    #[test]
    fn sod_tubes() {
        for (gamma, p, u, densities, shock, head, tail) in [
            (1.4, 0.303130, 0.927453, [0.426319, 0.265574], 1.752156, -1.183216, -0.070273),
            (5.0 / 3.0, 0.293945, 0.841195, [0.479689, 0.229806], 1.844473, -1.290994, -0.169401),
        ] {
            let tube = sod(gamma);
            let near = |a: f64, b: f64| assert!((a - b).abs() < 6e-7, "gamma {gamma}: {a} {b}");
            near(tube.pressure, p);
            near(tube.velocity, u);
            near(tube.at(2.0 * (tube.velocity - 1e-9), 2.0).density, densities[0]);
            near(tube.at(2.0 * (tube.velocity + 1e-9), 2.0).density, densities[1]);
            // Fronts lie where the state changes.
            assert_eq!(tube.at(shock + 1e-6, 1.0).velocity, 0.0);
            assert_eq!(tube.at(shock - 1e-6, 1.0).velocity, tube.velocity);
            assert_eq!(tube.at(head - 1e-6, 1.0).velocity, 0.0);
            assert!(tube.at(head + 1e-6, 1.0).velocity > 0.0);
            assert_eq!(tube.at(tail + 1e-6, 1.0).velocity, tube.velocity);
            assert!(tube.at(tail - 1e-6, 1.0).velocity < tube.velocity);
        }
    }

    /// A box that holds all waves has gained the inflow through its ends, for two shocks, two rarefactions, one
    /// of each, cold gases that meet and a strong blast. The midpoint rule misses each of the three jumps there can be by at most
    /// half a cell.
    #[test]
    fn waves_conserve_mass_momentum_and_energy() {
        let cases = [
            (gas(1.0, 2.0, 1.0), gas(2.0, -1.0, 0.5)),
            (gas(1.0, -0.5, 1.0), gas(0.7, 0.6, 0.4)),
            (gas(0.125, 0.3, 0.1), gas(1.0, 0.0, 1.0)),
            (gas(1.0, 3.0, 0.0), gas(1.0, 0.0, 0.0)),
            (gas(1.0, 0.0, 1e5), gas(3.0, -0.2, 0.01)),
        ];
        for ((left, right), gamma) in cases.into_iter().flat_map(|case| [1.1, 1.4, 2.2].map(|gamma| (case, gamma))) {
            let tube = Riemann::new(left, right, gamma).unwrap();
            let sounds = left.sound(gamma) + right.sound(gamma);
            let reach = 3.0 * (sounds + left.velocity.abs() + right.velocity.abs() + tube.velocity.abs());
            // The ends of the box move out at the speed `reach`.
            let (inflow, outflow) =
                (fluxes(&tube.at(-1.1 * reach, 1.0), -reach), fluxes(&tube.at(1.1 * reach, 1.0), reach));
            let cells = 40_000;
            let dx = 2.0 * reach / f64::from(cells);
            let states: Vec<State> = (0..cells).map(|i| tube.at(-reach + (f64::from(i) + 0.5) * dx, 1.0)).collect();
            let contents: [fn(&State) -> f64; 3] = [
                |s| s.density,
                |s| s.density * s.velocity,
                |s| s.density * (s.internal_energy + 0.5 * s.velocity * s.velocity),
            ];
            for (k, content) in contents.iter().enumerate() {
                let found = states.iter().map(content).sum::<f64>() * dx;
                let largest = states.iter().map(|s| content(s).abs()).fold(0.0, f64::max);
                let gained = inflow[k] - outflow[k];
                assert!(
                    (found - gained).abs() < 1.5 * dx * largest,
                    "{left:?} {right:?} {gamma} {k}: {found} {gained}"
                );
            }
        }
    }

    /// Across a fan u -/+ 2 c / (gamma - 1) and p / rho^gamma stay.
    #[test]
    fn fans_keep_their_invariants() {
        let tube = sod(1.3);
        let invariants = |s: State| {
            let c = (1.3 * s.stress / s.density).sqrt();
            [s.velocity + 2.0 * c / 0.3, s.stress / libm::pow(s.density, 1.3)]
        };
        let first = invariants(tube.at(-10.0, 1.0));
        for step in 0..100 {
            let now = invariants(tube.at(-1.2 + 0.02 * f64::from(step), 1.0));
            if -1.2 + 0.02 * f64::from(step) < tube.velocity {
                assert!((now[0] / first[0] - 1.0).abs() < 1e-12 && (now[1] / first[1] - 1.0).abs() < 1e-12);
            }
        }
        assert_eq!(tube.at(-1.0, 0.0).density, 1.0);
        assert_eq!(tube.at(1.0, 0.0).density, 0.125);
    }

    #[test]
    fn impossible_gases_are_refused() {
        let still = gas(1.0, 0.0, 1.0);
        let error = Riemann::new(gas(1.0, -7.0, 1.0), gas(1.0, 7.0, 1.0), 1.4).unwrap_err();
        assert!(error.what.contains("vacuum"), "{error}");
        assert!(Riemann::new(still, still, 1.0).is_err());
        assert!(Riemann::new(gas(0.0, 0.0, 1.0), still, 1.4).is_err());
        assert!(Riemann::new(still, gas(1.0, 0.0, -1.0), 1.4).is_err());
    }
}
