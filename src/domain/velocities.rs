//! Extremes of the velocities in the cells of a watch: from them [`closing`](super::closing) finds how fast matter may approach.

use super::comm::Exchange;

/// Velocities in the halves of a cell along each axis: maxima only, so that cells merge element by element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CellVelocities<const D: usize> {
    pub(super) forward: [[f64; 2]; D],
    /// Maxima of the opposite velocity.
    pub(super) backward: [[f64; 2]; D],
    /// -h of the smallest particle of the cell's own level.
    pub(super) smallest: f64,
}

/// Numbers of a cell that another rank must know.
pub(super) const fn words(dimension: usize) -> usize {
    4 * dimension + 1
}

impl<const D: usize> CellVelocities<D> {
    pub(super) const NOTHING: Self = Self {
        forward: [[f64::NEG_INFINITY; 2]; D],
        backward: [[f64::NEG_INFINITY; 2]; D],
        smallest: f64::NEG_INFINITY,
    };

    pub(super) fn merge(&mut self, other: &Self) {
        for k in 0..D {
            for half in 0..2 {
                self.add(k, half, other.forward[k][half], other.backward[k][half]);
            }
        }
        self.smallest = self.smallest.max(other.smallest);
    }

    /// The velocities of a cell of the level below, whose code ends in `code`.
    pub(super) fn merge_child(&mut self, child: &Self, code: u64) {
        for k in 0..D {
            let half = (code >> (D - 1 - k) & 1) as usize;
            let [forward, backward] = [child.forward[k], child.backward[k]].map(|v| v[0].max(v[1]));
            self.add(k, half, forward, backward);
        }
    }

    #[inline(always)]
    pub(super) fn add(&mut self, k: usize, half: usize, forward: f64, backward: f64) {
        self.forward[k][half] = self.forward[k][half].max(forward);
        self.backward[k][half] = self.backward[k][half].max(backward);
    }

    pub(super) fn write(&self, to: &mut [f64]) {
        to[..2 * D].copy_from_slice(self.forward.as_flattened());
        to[2 * D..4 * D].copy_from_slice(self.backward.as_flattened());
        to[4 * D] = self.smallest;
    }

    pub(super) fn read(from: &[f64]) -> Self {
        let part = |first: usize| std::array::from_fn(|k| [from[first + 2 * k], from[first + 2 * k + 1]]);
        Self { forward: part(0), backward: part(2 * D), smallest: from[4 * D] }
    }
}

/// The largest difference of two vectors whose components, and their opposites, are at most these.
pub fn relative(forward: &[f64], backward: &[f64]) -> f64 {
    forward.iter().zip(backward).map(|(f, b)| (f + b).max(0.0).powi(2)).sum::<f64>().sqrt()
}

/// Velocities of the cells of a watch, made when they are first needed.
pub(super) struct Velocities<const D: usize> {
    /// Own cells, then cells known from other ranks only.
    pub(super) cells: Vec<CellVelocities<D>>,
    pub(super) exchange: Exchange,
}

impl<const D: usize> Velocities<D> {
    pub(super) fn bytes(&self) -> usize {
        std::mem::size_of::<CellVelocities<D>>() * self.cells.len() + self.exchange.bytes()
    }
}
