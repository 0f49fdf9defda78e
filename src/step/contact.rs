//! Contact of matter that deforms with rigid bodies that do not adhere: these push and never pull, and between them and matter there is
//! neither strain nor stress. With
//!
//! ```text
//! f = sum_j V_j W_ij     over particles j of such bodies: the part of the surroundings of i that they fill, 1/2 on a plane, 0 from 2h on
//! s = (f - f_0) / (1/2 - f_0)     f_0 the least f since the start: 0 but for what lay next to them then and has not left
//! p = 50 rho c^2 s / (1 - s)     with the last 1 - s beyond s = 0.95
//! ```
//! V_i V_j p gW is the force of such a pair, p df/dt its power over V_i: a potential of f, which gives back what it takes. The force begins
//! where kernels meet and is stiff, so that it is smooth over the spacings of both lattices: one that begins half a spacing away gives an
//! elastic bounce more energy than it had. The rigid particles count as neighbours in the correction of gradients: matter beside them has no
//! free surface there.
//!
//! p is that of the f which the pair sums give, so that it follows the place exactly: with an f that is carried to the new place by
//! its rate a swing against the body with w dt = 0.5 gains two per cent of its energy in each step. Therefore it is no pair term: pairs
//! are summed once more where there is a p, which few particles have. As the force of a pair is along it, the body takes it at the place of
//! particle i.

use crate::kernel::Kernel;
use crate::math::Vec3;
use crate::pair::contrast::is_loose;
use crate::pair::record::half;
use crate::pair::{Layout, RowSums, Rows};
use crate::particles::{Chunk, Column, ColumnInfo, Life, Registry};

/// The column of f_0.
#[derive(Debug, Clone, Copy)]
pub struct Contact {
    least: Column<f64>,
}

const LEAST_FILL: ColumnInfo = ColumnInfo {
    name: "contact_fill_least",
    unit: "",
    about: "Least part of the surroundings that rigid bodies have filled.",
    life: Life::Kept,
    snapshot: false,
};
/// p over rho c^2 where s = 1/2.
const STIFF: f64 = 50.0;
/// 1 - s at least.
const LEAST: f64 = 0.05;

/// A rigid body that touches a particle.
#[derive(Debug)]
pub struct Touch {
    /// Number of the scene's body.
    pub body: u16,
    /// Sum of V_j gW over its particles, 1/m.
    pub gradient: Vec3,
}

impl Contact {
    pub fn declare(registry: &mut Registry) -> Self {
        Self { least: registry.owner("rigid_contact").column::<f64>(LEAST_FILL) }
    }

    /// f_0 of a chunk's particle, which an evaluation at the beginning of a step may lower; `is_first`: of new particles.
    pub fn least(&self, chunk: &Chunk, k: usize, fill: f64, keep: bool, is_first: bool) -> f64 {
        let column = chunk.view(self.least);
        let least = if is_first { fill } else { column.get(k).min(fill) };
        if keep {
            column.set(k, least);
        }
        least
    }

    /// The speed over that of sound that a step must resolve, for matter with sound that takes `time`, s, through a smoothing length.
    pub fn speed(&self, chunk: &Chunk, k: usize, sums: &RowSums, time: f64) -> f64 {
        let least = chunk.view(self.least).get(k);
        // What comes so fast that it will be touched within a step or two is as stiff as if it were.
        if sums.fill > 0.0 && sums.fill.max(sums.fill + time * sums.filling) > least {
            speed(sums.fill.max(least), least)
        } else {
            0.0
        }
    }
}

/// Sums over the particles of rigid bodies that do not adhere in row `i`, body by body. `owners`: the scene's body of each slot.
pub fn touch(layout: &Layout, kernel: Kernel, rows: &Rows, i: usize, owners: &[u16], found: &mut Vec<Touch>) {
    let stride = layout.stride();
    let record = |slot: u32| &rows.records[slot as usize * stride..][..stride];
    let place = |record: &[f64]| Vec3::from_fn(|a, _| if a < layout.dimension { record[a] } else { 0.0 });
    let mine = record(rows.slots[i]);
    for &slot in &rows.entries[rows.offsets[i]..rows.offsets[i + 1]] {
        let other = record(slot);
        if !is_loose(half(other, layout.density())) {
            continue;
        }
        let x = place(mine) - place(other);
        let r = x.norm();
        // As in the pair loop: no kernel narrower than two thirds of the other.
        let inverse = [mine, other].map(|record| half(record, layout.h_inverse()));
        let narrowest = 1.5 * inverse[0].min(inverse[1]);
        let slope = |inverse: f64| kernel.slope(r, 1.0 / inverse.min(narrowest), layout.dimension);
        let slope = 0.5 * (slope(inverse[0]) + slope(inverse[1]));
        if slope == 0.0 || r == 0.0 {
            continue;
        }
        let gradient = x * (other[layout.volume()] * slope / r);
        let body = owners[slot as usize];
        match found.iter_mut().find(|touch| touch.body == body) {
            Some(touch) => touch.gradient += gradient,
            None => found.push(Touch { body, gradient }),
        }
    }
}

/// What is left of s to 1, and its rate over f.
fn left(filled: f64, least: f64) -> (f64, f64) {
    let steep = 1.0 / (0.5 - least).max(LEAST);
    ((1.0 - (filled - least) * steep).max(LEAST), steep)
}

/// p over rho c^2.
pub fn push(filled: f64, least: f64) -> f64 {
    let (left, _) = left(filled, least);
    if filled > least { STIFF * (1.0 - left) / left } else { 0.0 }
}

/// Half of h times the frequency with which a particle swings against a plane, over c: of the shortest waves, which a step resolves, that is
/// about 1. Beside a plane h |grad f| is 0.8 (2 f)^(2/3) or less; a quarter more is for planes of few particles, on which discs at rest
/// within their reach gained a third of their energy at a Courant number of 0.5.
fn speed(filled: f64, least: f64) -> f64 {
    let (left, steep) = left(filled, least);
    0.5 * libm::pow((2.0 * filled).min(1.0), 2.0 / 3.0) * (STIFF * steep).sqrt() / left
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
    }
}
