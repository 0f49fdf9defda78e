//! Contact of matter that deforms with rigid bodies that do not adhere: these push and never pull, and between them and matter there is
//! neither strain nor stress. With
//!
//! ```text
//! f = sum_j V_j W_ij     over particles j of such bodies: the part of the surroundings of i that they fill, 1/2 on a plane, 0 from 2h on
//! s = (f - f_0) / (1/2 - f_0)     f_0 the least f since the start: 0 but for what lay next to them then and has not left
//! p = 50 rho c^2 s / (1 - s)     with the last 1 - s beyond s = 0.95
//! ```
//! p is a pressure of each such pair, V_i V_j p gW its force, V_i V_j p v_ij . gW its power, as of the pressure of viscosity: a potential of
//! f, which gives back what it takes. The force begins where kernels meet and is stiff, so that it is smooth over the spacings of both
//! lattices: one that begins half a spacing away gives an elastic bounce more energy than it had. The rigid particles count as neighbours
//! in the correction of gradients: matter beside them has no free surface there.
//!
//! f is that of the last evaluation, carried to the next one by its rate, so that force and place belong together to second order.

use crate::pair::RowSums;
use crate::particles::{Chunk, Column, ColumnInfo, Columns, Life, Registry, Values};

#[derive(Debug, Clone, Copy)]
pub struct Contact {
    filled: Column<f64>,
    rate: Column<f64>,
    least: Column<f64>,
}

const COLUMNS: [(&str, &str, &str); 3] = [
    ("contact_fill", "", "Part of the surroundings that rigid bodies fill."),
    ("contact_fill_rate", "1/s", "Rate of that part."),
    ("contact_fill_least", "", "Least part that they have filled."),
];
/// p over rho c^2 where s = 1/2.
const STIFF: f64 = 50.0;
/// 1 - s at least.
const LEAST: f64 = 0.05;

impl Contact {
    pub fn declare(registry: &mut Registry) {
        for (name, unit, about) in COLUMNS {
            let info = ColumnInfo { name, unit, about, life: Life::Kept, snapshot: false };
            registry.owner("rigid_contact").column::<f64>(info);
        }
    }

    pub fn find(registry: &Registry) -> Option<Self> {
        let column = |k: usize| registry.find(COLUMNS[k].0);
        Some(Self { filled: column(0)?, rate: column(1)?, least: column(2)? })
    }

    /// Keeps what the pair loop found around a chunk's particle.
    #[inline]
    pub fn keep(&self, chunk: &Chunk, k: usize, sums: &RowSums, is_first: bool) {
        let least = chunk.view(self.least);
        least.set(k, if is_first { sums.fill } else { least.get(k).min(sums.fill) });
        chunk.view(self.filled).set(k, sums.fill);
        chunk.view(self.rate).set(k, sums.filling);
    }

    /// p over rho c^2 of particle `i`, a step of `dt`, s, after the last evaluation.
    #[inline]
    pub fn push(&self, columns: &Columns, i: usize, dt: f64) -> f64 {
        let filled = columns.get(self.filled, i);
        if filled <= 0.0 {
            return 0.0;
        }
        push(filled + dt * columns.get(self.rate, i), columns.get(self.least, i))
    }

    /// The speed over that of sound that a step must resolve.
    #[inline]
    pub fn speed(&self, particles: &impl Values, k: usize) -> f64 {
        let filled = particles.value(self.filled, k);
        if filled > 0.0 { speed(filled, particles.value(self.least, k)) } else { 0.0 }
    }
}

/// What is left of s to 1, and its rate over f.
fn left(filled: f64, least: f64) -> (f64, f64) {
    let steep = 1.0 / (0.5 - least).max(LEAST);
    ((1.0 - (filled - least) * steep).max(LEAST), steep)
}

fn push(filled: f64, least: f64) -> f64 {
    let (left, _) = left(filled, least);
    if filled > least { STIFF * (1.0 - left) / left } else { 0.0 }
}

/// Half of h times the frequency with which a particle swings against a plane, over c: of the shortest waves, which a step resolves, that is
/// about 1. Beside a plane h |grad f| is 0.8 (2 f)^(2/3) or less.
fn speed(filled: f64, least: f64) -> f64 {
    if filled <= least {
        return 0.0;
    }
    let (left, steep) = left(filled, least);
    0.4 * libm::pow((2.0 * filled).min(1.0), 2.0 / 3.0) * (STIFF * steep).sqrt() / left
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_pushes_what_comes_nearer_than_ever() {
        assert_eq!([push(0.2, 0.2), push(0.1, 0.2), push(0.25, 0.0)], [0.0, 0.0, STIFF]);
        assert!(push(0.26, 0.2) > 0.0 && push(0.499, 0.0) > 18.0 * STIFF && push(0.9, 0.0) == push(0.5, 0.0));
        assert!(push(0.5, 0.5) == 0.0 && push(0.51, 0.5).is_finite());
        // A tenth of rho c^2 shortens no step.
        let resting = 0.001;
        assert!((push(resting, 0.0) - 0.1).abs() < 1e-3 && speed(resting, 0.0) < 0.1 && speed(0.3, 0.0) > 1.0);
        assert_eq!(speed(0.1, 0.2), 0.0);
    }
}
