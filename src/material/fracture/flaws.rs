//! The flaws of a particle (Weibull 1939; Benz & Asphaug 1995; Jutzi et al. 2008, eq. 34).
//!
//! ```text
//! n(<eps) = k eps^m                     flaws per volume that are active below a strain
//! eps_j = (Gamma_j / (k V))^(1/m)       thresholds of a particle's flaws, j = 1, 2, ...
//! ```
//! k Weibull constant, 1/m^3, m its exponent; V volume of the particle at the start, m^3.
//!
//! The original assignment gives flaws to particles one by one until each has one, which needs all particles. Here the
//! flaws of a particle are a Poisson process of its own: Gamma_j is the sum of j exponential draws that depend only on
//! (seed, id), and the process ends at k V eps^m = ln N + 0.577, the mean number of flaws per particle of the original
//! among N; a particle has at least one. Only the weakest flaw is stored, the others are drawn again when needed.

use super::table::FractureTable;
use crate::particles::ParticleId;
use crate::random::uniform_pair;

/// Euler's constant, to the digits of the original assignment's mean.
const EULER: f64 = 0.577;

/// Parameters of the flaws of a body's particles. Logarithms, as k V may be 1e61.
#[derive(Debug, Clone, Copy)]
pub struct Flaws {
    seed: u64,
    m: f64,
    ln_kv: f64,
    /// k V eps^m at which the process ends: the mean number of flaws.
    mean: f64,
    ln_mean: f64,
}

/// Flaws of one particle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FlawCount {
    /// At the strain that was asked for.
    pub active: u32,
    pub all: u32,
}

impl Flaws {
    /// Flaws of particles of `volume`, m^3, of which the body has `particles`.
    pub fn new(table: &FractureTable, volume: f64, particles: u64) -> Self {
        let mean = libm::log(particles as f64) + EULER;
        let ln_kv = libm::log(table.weibull_k.0) + libm::log(volume);
        Self { seed: table.seed, m: table.weibull_m.0, ln_kv, mean, ln_mean: libm::log(mean) }
    }

    /// Strain at which the weakest flaw of a particle begins to grow.
    pub fn weakest(&self, id: ParticleId) -> f64 {
        let gamma = -libm::log(uniform_pair(self.seed, id.0, 0)[0]);
        libm::exp((libm::log(gamma) - self.ln_kv) / self.m)
    }

    /// Flaws of a particle, those that are active at a strain above the weakest threshold among them.
    pub fn count(&self, id: ParticleId, strain: f64) -> FlawCount {
        let ln_intensity = self.ln_kv + self.m * libm::log(strain);
        let intensity = if ln_intensity < self.ln_mean { libm::exp(ln_intensity) } else { self.mean };
        // Gamma_j <= x where the product of the first j draws is at least exp(-x): no logarithm per flaw.
        let (active_product, last_product) = (libm::exp(-intensity), libm::exp(-self.mean));
        let (mut active, mut total, mut product, mut pair) = (0, 0, 1.0, 0);
        'draws: loop {
            for draw in uniform_pair(self.seed, id.0, pair) {
                product *= draw;
                if product < last_product {
                    break 'draws;
                }
                total += 1;
                active += u32::from(product >= active_product);
            }
            pair += 1;
        }
        FlawCount { active: active.max(1), all: total.max(1) }
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::testing::basalt;
    use super::*;
    use crate::units::Quantity;

    /// Flaws of one of `particles` of 1 mm^3, with the constants of Benz & Asphaug 1999.
    fn flaws(particles: u64) -> Flaws {
        Flaws::new(&basalt().fracture.unwrap(), 1e-9, particles)
    }

    fn total(flaws: &Flaws, site: u64) -> u32 {
        flaws.count(ParticleId::new(0, site), 1.0).all
    }

    /// The total is a Poisson number of mean N (ln N + 0.577), plus the flaw given to the fraction exp(-mean) that
    /// draws none: four standard deviations, far inside the 1.3 N by which the original assignment scatters.
    #[test]
    fn number_of_flaws_is_that_of_the_original_assignment() {
        for n in [1000u64, 10_000] {
            let flaws = flaws(n);
            let sum: u64 = (0..n).map(|site| total(&flaws, site) as u64).sum();
            let expected = n as f64 * flaws.mean;
            assert!((sum as f64 - expected).abs() < 4.0 * expected.sqrt() + 2.0, "{n}: {sum} {expected}");
            assert!((sum as f64 - expected).abs() < 1.3 * n as f64);
        }
    }

    /// n(<eps) V = k V eps^m: the number of active flaws at a strain, again a Poisson number.
    #[test]
    fn active_flaws_follow_weibull() {
        let n = 10_000;
        let flaws = flaws(n);
        for intensity in [0.5f64, 2.0, 5.0] {
            let strain = libm::exp((libm::log(intensity) - flaws.ln_kv) / flaws.m);
            let active: u64 = (0..n)
                .map(|site| ParticleId::new(0, site))
                .filter(|&id| flaws.weakest(id) < strain)
                .map(|id| flaws.count(id, strain).active as u64)
                .sum();
            let expected = n as f64 * intensity;
            assert!((active as f64 - expected).abs() < 4.0 * expected.sqrt(), "{intensity}: {active}");
        }
    }

    #[test]
    fn draws_depend_on_seed_and_id_alone() {
        let flaws = flaws(1000);
        let draw = |site: u64| (flaws.weakest(ParticleId::new(0, site)).to_bits(), total(&flaws, site));
        let forward: Vec<_> = (0..1000).map(draw).collect();
        let mut backward: Vec<_> = (0..1000).rev().map(draw).collect();
        backward.reverse();
        assert_eq!(forward, backward);
        let other = Flaws { seed: 4, ..flaws };
        assert!((0..1000).any(|site| total(&other, site) != forward[site as usize].1));
    }

    /// Nakamura et al. 2007: m = 16 and k = 1e61, where k V overflows a float and eps^m underflows one.
    #[test]
    fn huge_weibull_numbers_stay_finite() {
        let table =
            FractureTable { weibull_k: Quantity(1e61), weibull_m: Quantity(16.0), ..basalt().fracture.unwrap() };
        let flaws = Flaws::new(&table, 1e12, 100_000);
        for site in 0..1000 {
            let id = ParticleId::new(0, site);
            let threshold = flaws.weakest(id);
            assert!(threshold > 1e-6 && threshold < 1e-3, "{threshold:e}");
            let mut last = 0;
            for strain in [threshold * 1.0000001, 2.0 * threshold, 1e-2, 1.0, 1e30] {
                let FlawCount { active, all: total } = flaws.count(id, strain);
                assert!(active >= last.max(1) && active <= total);
                last = active;
            }
        }
    }

    #[test]
    fn a_body_of_one_particle_has_a_flaw() {
        let flaws = flaws(1);
        assert!((0..1000).all(|site| total(&flaws, site) >= 1));
        assert!((0..1000).any(|site| total(&flaws, site) == 1));
    }
}
