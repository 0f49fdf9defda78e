//! How far density is from mass over volume, of all particles inside matter. Matter with too little around it to be inside cannot be
//! dense: at twice its initial density it has kept a density that is no longer true.

use super::sums::{LEAST_COVER, Neighbours};
use crate::step::Stepper;

/// S beyond this or below its inverse is off.
pub const FACTOR: f64 = 1.5;
/// No surface is as dense as that.
const COMPRESSED: f64 = 2.0;

/// Counts of one body's particles, on all ranks.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Packing {
    /// Particles inside matter.
    pub inside: u64,
    /// Those of them that are packed more densely than their density, by [`FACTOR`].
    pub crowded: u64,
    /// Those that are packed less densely.
    pub sparse: u64,
    /// Particles with less than half of the matter around them, twice as dense as initially.
    pub alone: u64,
}

impl Packing {
    /// Particles whose density is off.
    pub fn off(&self) -> u64 {
        self.crowded + self.sparse + self.alone
    }

    /// Particles that can be judged.
    pub fn judged(&self) -> u64 {
        self.inside + self.alone
    }
}

/// Density against mass over volume, of matter that deforms.
#[derive(Debug, Clone, PartialEq)]
pub struct DensityCheck {
    /// One for each body; all are zero where no step has been taken since lists were released.
    pub bodies: Vec<Packing>,
    /// What 99 of 100 particles inside matter do not exceed: of density and mass over volume the larger over the smaller, less 1, what a
    /// surface nearby accounts for apart; NaN where there are none.
    pub drift: f64,
}

impl DensityCheck {
    /// Before the first check.
    pub fn unknown() -> Self {
        Self { bodies: Vec::new(), drift: f64::NAN }
    }

    /// Whether any particle could be judged.
    pub fn is_known(&self) -> bool {
        self.bodies.iter().any(|body| body.judged() > 0)
    }
}

/// Classes of |ln S|, each [`WIDTH`] times as far as the one before.
const CLASSES: usize = 240;
const FIRST: f64 = 1e-4;
/// 10^(1/48), 5 per cent.
const WIDTH: f64 = 1.0491413;
const QUANTILE: f64 = 0.99;

/// The class of ln S.
fn class(off: f64) -> usize {
    let number = libm::log(libm::fabs(off) / FIRST) / libm::log(WIDTH);
    if number > 0.0 { (number.ceil() as usize).min(CLASSES - 1) } else { 0 }
}

/// The upper end of the class that the quantile falls into, as a density off by a factor, less 1.
fn quantile(counts: &[i64]) -> f64 {
    let all: i64 = counts.iter().sum();
    let mut below = 0;
    let found = counts.iter().position(|count| {
        below += count;
        all > 0 && below as f64 >= QUANTILE * all as f64
    });
    found.map_or(f64::NAN, |class| libm::expm1(FIRST * libm::pow(WIDTH, class as f64)))
}

impl<const D: usize> Stepper<'_, D> {
    /// Collective.
    pub fn check_density(&self) -> DensityCheck {
        let bodies = self.settings.view.constants.len();
        let mut counts = vec![0i64; CLASSES + 4 * bodies];
        if let Some(rows) = self.rows() {
            let neighbours = Neighbours::<D>::new(&rows, self.settings.pair_loop.layout(), self.settings.packer.eta());
            for i in 0..self.columns.len() {
                let body = self.columns.get(self.settings.view.core.id, i).body();
                if self.settings.view.is_rigid(body) {
                    continue;
                }
                let sums = neighbours.sums(i);
                let density = self.columns.get(self.settings.view.core.density.value, i);
                let is_dense = density > COMPRESSED * self.settings.view.constants[body].density;
                let inside = sums.is_inside();
                if inside {
                    counts[class(sums.off())] += 1;
                }
                let [crowded, sparse] = [sums.packing > FACTOR, sums.packing < 1.0 / FACTOR].map(|off| inside && off);
                let alone = is_dense && sums.cover > 0.0 && sums.cover < LEAST_COVER;
                let is = [inside, crowded, sparse, alone];
                counts[CLASSES + 4 * body..].iter_mut().zip(is).for_each(|(count, is)| *count += is as i64);
            }
        }
        self.comm.all_sum(&mut counts);
        let of = |c: [u64; 4]| Packing { inside: c[0], crowded: c[1], sparse: c[2], alone: c[3] };
        let (classes, of_bodies) = counts.split_at(CLASSES);
        let bodies = of_bodies.as_chunks::<4>().0.iter().map(|counts| of(counts.map(|n| n as u64)));
        DensityCheck { bodies: bodies.collect(), drift: quantile(classes) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_quantile_is_found_within_five_per_cent() {
        let mut counts = vec![0; CLASSES];
        assert!(quantile(&counts).is_nan());
        // One in fifty is off by a fifth, to either side.
        let off = |factor: f64| class(libm::log(factor));
        (0..980).for_each(|_| counts[off(1.003)] += 1);
        (0..20).for_each(|k| counts[off(if k % 2 == 0 { 1.2 } else { 1.0 / 1.2 })] += 1);
        assert!((quantile(&counts) / 0.2 - 1.0).abs() < 0.06, "{}", quantile(&counts));
        (0..2000).for_each(|_| counts[off(1.003)] += 1);
        assert!((quantile(&counts) / 0.003 - 1.0).abs() < 0.06, "{}", quantile(&counts));
        assert_eq!((off(1.0), off(0.0), off(1e9)), (0, CLASSES - 1, CLASSES - 1));
    }
}
