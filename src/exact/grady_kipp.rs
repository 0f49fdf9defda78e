//! Fragmentation at a constant strain rate; Grady & Kipp 1980, Int. J. Rock Mech. Min. Sci. 17, 147; Melosh, Ryan & Asphaug
//! 1992, J. Geophys. Res. 97, 14735.
//!
//! Flaws are k eps^m per volume up to the strain eps. As long as little is broken, the strain r t activates k m r^m t^(m-1) dt
//! of them within dt, and each then breaks a sphere that grows at the speed c_g:
//! ```text
//! D(t) = integral over s from 0 to t of k m r^m s^(m-1) 4/3 pi c_g^3 (t - s)^3 = alpha r^m t^(m+3)
//! alpha = 8 pi c_g^3 k / [(m + 1) (m + 2) (m + 3)]
//! stress = E r t (1 - D)    largest at D = 1 / (m + 4)    none left at D = 1
//! ```
//! D damage, r strain rate, 1/s; E Young's modulus, Pa; k density of flaws, m^-3; c_g speed of cracks, m/s.

use super::{all_above, all_positive};
use crate::error::Result;

/// Pulled uniformly at a constant rate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GradyKipp {
    m: f64,
    crack_speed: f64,
    youngs_modulus: f64,
    strain_rate: f64,
    /// Time at which D = 1, s.
    pub break_time: f64,
}

impl GradyKipp {
    /// `weibull_k`, m^-3, and `weibull_m` of the flaws; `crack_speed`, m/s; `youngs_modulus`, Pa; `strain_rate`, 1/s.
    pub fn new(
        weibull_k: f64,
        weibull_m: f64,
        crack_speed: f64,
        youngs_modulus: f64,
        strain_rate: f64,
    ) -> Result<Self> {
        all_above(0.0, &[("weibull_k", weibull_k), ("weibull_m", weibull_m)])?;
        all_positive(&[
            ("the crack speed", crack_speed),
            ("Young's modulus", youngs_modulus),
            ("the strain rate", strain_rate),
        ])?;
        // Logarithms, as k and r^m reach beyond 1e60.
        let m = weibull_m;
        let spheres = 8.0 * std::f64::consts::PI / ((m + 1.0) * (m + 2.0) * (m + 3.0));
        let rate =
            libm::log(spheres) + 3.0 * libm::log(crack_speed) + libm::log(weibull_k) + m * libm::log(strain_rate);
        Ok(Self { m, crack_speed, youngs_modulus, strain_rate, break_time: libm::exp(-rate / (m + 3.0)) })
    }

    /// D at the time `t`, s, at most 1.
    pub fn damage(&self, t: f64) -> f64 {
        libm::pow((t / self.break_time).clamp(0.0, 1.0), self.m + 3.0)
    }

    /// Tensile stress at the time `t`, s, in Pa.
    pub fn stress(&self, t: f64) -> f64 {
        self.youngs_modulus * self.strain_rate * t * (1.0 - self.damage(t))
    }

    /// When the stress is largest, s.
    pub fn peak_time(&self) -> f64 {
        self.break_time * libm::pow(self.m + 4.0, -1.0 / (self.m + 3.0))
    }

    /// Largest tensile stress, Pa.
    pub fn peak_stress(&self) -> f64 {
        self.stress(self.peak_time())
    }

    /// Size of most of the fragments, m: 6 c_g t / (m + 2), t the time of breaking.
    pub fn fragment_size(&self) -> f64 {
        6.0 * self.crack_speed * self.break_time / (self.m + 2.0)
    }
}

#[cfg(test)]
mod tests {
    use super::super::waves::tests::basalt;
    use super::*;

    fn pulled(k: f64, m: f64, rate: f64) -> GradyKipp {
        GradyKipp::new(k, m, 0.4 * basalt().longitudinal_speed(), basalt().youngs_modulus(3), rate).unwrap()
    }

    /// An independent evaluation: basalt of Benz & Asphaug 1999 and of Nakamura et al. 2007, to three digits.
    #[test]
    fn tabulated_strengths() {
        for (rate, strength, nakamura, break_time) in [
            (1.0, 9.07e6, 10.8e6, 229e-6),
            (10.0, 16.1e6, 15.5e6, 40.8e-6),
            (100.0, 28.7e6, 22.3e6, 7.25e-6),
            (1e3, 51.0e6, 32.1e6, 1.29e-6),
            (1e4, 90.7e6, 46.1e6, 0.229e-6),
        ] {
            let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 5e-3, "{rate}: {a} {b}");
            near(pulled(4.0e35, 9.0, rate).peak_stress(), strength);
            near(pulled(4.0e35, 9.0, rate).break_time, break_time);
            near(pulled(1e61, 16.0, rate).peak_stress(), nakamura);
        }
        assert!((pulled(4.0e35, 9.0, 1.0).fragment_size() / 0.22984 - 1.0).abs() < 1e-4);
    }

    /// The integral over the flaws, by the midpoint rule, and a peak from which the stress falls to both sides.
    #[test]
    fn damage_is_the_volume_of_the_cracks() {
        let (k, m, rate) = (3e30, 7.3, 40.0);
        let solution = pulled(k, m, rate);
        let t = 0.8 * solution.break_time;
        let cells = 10_000;
        let ds = t / f64::from(cells);
        let mut damage = 0.0;
        for i in 0..cells {
            let s = (f64::from(i) + 0.5) * ds;
            let reach = solution.crack_speed * (t - s);
            let activated = k * m * libm::pow(rate, m) * libm::pow(s, m - 1.0) * ds;
            damage += activated * 4.0 / 3.0 * std::f64::consts::PI * reach * reach * reach;
        }
        assert!((solution.damage(t) / damage - 1.0).abs() < 1e-6, "{} {damage}", solution.damage(t));
        let (time, peak) = (solution.peak_time(), solution.peak_stress());
        assert!((solution.damage(time) * (m + 4.0) - 1.0).abs() < 1e-12);
        assert!(solution.stress(0.99 * time) < peak && solution.stress(1.01 * time) < peak);
        assert_eq!(solution.stress(1.5 * solution.break_time), 0.0);
    }
}
