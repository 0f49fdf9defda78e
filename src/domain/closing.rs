//! Limits the time step where matter approaches other matter that is not in contact yet. The Courant condition covers sound, and
//! the approach of pairs inside their supports; fast, soft matter could move into other matter, or through it, within one step.
//! With the blocks of 3^D cells of [`watch`](super::watch), W the largest velocity at which matter of a block may approach other
//! matter of it, C the Courant number:
//!
//! ```text
//! particles of the block's own level:          W dt <= C h              h: the smallest of them
//! finer ones that no block of theirs holds:    W dt <= 2 S - d - s      S: side of the cells one level below, d: how far they have
//!                                                                       moved since the lists were built, s: their largest support
//! all that no block holds:                     W dt <= 2 S - d - s      S: side of the widest cells watched; d, s: of all particles,
//!                                                                       W: the largest relative velocity of any two
//! W^2 = sum over axes k of w_k^2,   w_k = max over a <= b of (max v_k in layer a  -  min v_k in layer b)
//! ```
//!
//! Layers are halves of cells, numbered along the axis: of two particles in different layers only the approach counts, of two in one
//! layer their relative velocity. Expanding matter is thus limited by the velocities within half a cell alone. As two sides were
//! between particles that no block holds (see there), a pair overlaps by C h at most before its forces are known; particles that
//! have passed each other since the lists were built are in the wrong order, but they are in the lists.
//!
//! Where no particle moves by C h in a step, nothing need be examined. Extremes are exact, and the same on any number of ranks.

use rayon::prelude::*;

use super::comm::{Comm, Exchange};
use super::velocities::{CellVelocities, Velocities, relative, words};
use super::watch::{Blocks, CELLS, Displacements, Summary, Watch};

/// How particles move.
pub struct Moving<'a> {
    /// D numbers per owned particle, m/s.
    pub velocity: &'a [f64],
    /// The largest relative velocity of any two particles of all ranks, m/s.
    pub relative: f64,
    /// Id of an owned particle.
    pub id: &'a dyn Fn(usize) -> u64,
}

/// The longest step for all ranks, and the particle of this rank that limits it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Closing {
    /// s
    pub dt: f64,
    /// The owned particle of the smallest id among those that it may concern.
    pub particle: Option<usize>,
}

impl<const D: usize> Watch<D> {
    /// The longest step in which no two particles meet undetected. Collective.
    pub fn closing<S: Fn(usize) -> f64 + Sync>(
        &mut self,
        motion: &Displacements<'_, S>,
        moving: &Moving,
        courant: f64,
        comm: &Comm,
    ) -> Closing {
        let &Moving { velocity, relative: all, id } = moving;
        self.survey(motion, comm);
        self.exchange_velocities(motion, velocity, comm);
        let velocities = &self.velocities.as_ref().expect("just made").cells;
        let (blocks, summaries, sides) = (&self.blocks, &self.summaries, &self.sides);
        let cells = AllCells { blocks, summaries, velocities, sides };
        let limit = |block: usize| limit(block, &cells, courant);
        let limits: Vec<f64> = (0..blocks.reach.len()).into_par_iter().with_min_len(CELLS).map(limit).collect();
        let (forward, backward) = self.farthest_moves();
        let mut agreed = vec![limits.iter().copied().fold(f64::INFINITY, f64::min)];
        agreed.extend(forward.iter().chain(&backward).map(|x| -x));
        comm.all_min(&mut agreed);
        let moves: Vec<f64> = agreed[1..].iter().map(|x| -x).collect();
        let apart = relative(&moves[..D], &moves[D..]);
        let beyond = (2.0 * sides[sides.len() - 1] - apart - self.widest_side) / all;
        let dt = agreed[0].min(beyond);
        let near: Vec<usize> = if beyond <= dt {
            (0..velocity.len() / D).collect()
        } else {
            (0..limits.len()).filter(|&block| limits[block] <= dt).flat_map(|block| self.particles_of(block)).collect()
        };
        Closing { dt, particle: near.into_iter().min_by_key(|&i| id(i)) }
    }

    /// Velocities of all cells, other ranks' included. Collective.
    fn exchange_velocities<S: Fn(usize) -> f64 + Sync>(
        &mut self,
        motion: &Displacements<'_, S>,
        velocity: &[f64],
        comm: &Comm,
    ) {
        let [sends, receives] = &self.peers;
        let new = || {
            let numbers = |list: &[(usize, usize)]| {
                list.iter().map(|&(rank, cells)| (rank, cells * words(D))).collect::<Vec<_>>()
            };
            let exchange = Exchange::new(comm, &numbers(sends), &numbers(receives));
            Velocities { cells: vec![CellVelocities::NOTHING; self.summaries.len()], exchange }
        };
        let mut velocities = self.velocities.take().unwrap_or_else(new);
        for level in 0..self.levels.len() - 1 {
            self.summarise_velocities(level, &mut velocities.cells, motion, velocity);
        }
        let outgoing = velocities.exchange.outgoing().chunks_exact_mut(words(D));
        self.send_cells.iter().zip(outgoing).for_each(|(&cell, to)| velocities.cells[cell as usize].write(to));
        velocities.exchange.start(comm);
        velocities.cells[self.cells.len()..].fill(CellVelocities::NOTHING);
        velocities.exchange.wait(comm);
        for (&cell, from) in self.receive_cells.iter().zip(velocities.exchange.incoming().chunks_exact(words(D))) {
            velocities.cells[cell as usize].merge(&CellVelocities::read(from));
        }
        self.velocities = Some(velocities);
    }

    /// Own cells of one level, from their particles and the level below.
    fn summarise_velocities<S: Fn(usize) -> f64 + Sync>(
        &self,
        level: usize,
        velocities: &mut [CellVelocities<D>],
        motion: &Displacements<'_, S>,
        velocity: &[f64],
    ) {
        let (start, end) = (self.levels[level], self.levels[level + 1]);
        let (finer, velocities) = velocities.split_at_mut(start);
        let (cells, lattice) = (&self.cells, &self.lattice);
        let mine = velocities[..end - start].par_iter_mut().zip(&cells[start..end]);
        mine.with_min_len(CELLS).for_each(|(velocities, cell)| {
            *velocities = CellVelocities::NOTHING;
            for child in cell.children.start as usize..cell.children.end as usize {
                velocities.merge_child(&finer[child], cells[child].code);
            }
            for i in cell.particles.start as usize..cell.particles.end as usize {
                velocities.smallest = velocities.smallest.max(-(motion.support)(i) / crate::kernel::SUPPORT);
                let at = std::array::from_fn(|k| motion.build_position[D * i + k]);
                let upper: [bool; D] = lattice.upper_half(&at, level as u32);
                for k in 0..D {
                    let v = velocity[D * i + k];
                    velocities.add(k, upper[k] as usize, v, -v);
                }
            }
        });
    }
}

/// What is known of all cells, other ranks' included.
struct AllCells<'a, const D: usize> {
    blocks: &'a Blocks,
    summaries: &'a [Summary<D>],
    velocities: &'a [CellVelocities<D>],
    /// Side of the cells of each level, m.
    sides: &'a [f64],
}

/// The longest step for the particles of one block, s.
fn limit<const D: usize>(block: usize, cells: &AllCells<D>, courant: f64) -> f64 {
    let &AllCells { blocks, summaries, velocities, sides } = cells;
    let (speed, smallest) =
        approach(blocks.cells_of(block).iter().map(|&c| &velocities[c as usize]), blocks.layers_of(block));
    let own = if smallest > f64::NEG_INFINITY { -courant * smallest } else { f64::INFINITY };
    let (apart, finer) = blocks.moved(block, summaries);
    let gap =
        if finer > f64::NEG_INFINITY { 2.0 * sides[blocks.level(block) - 1] - apart - finer } else { f64::INFINITY };
    if speed > 0.0 { own.min(gap) / speed } else { f64::INFINITY }
}

/// The largest velocity W at which matter in a block of cells may approach other matter in it, and -h of the smallest particle of
/// its level.
fn approach<'a, const D: usize>(velocities: impl Iterator<Item = &'a CellVelocities<D>>, layers: &[u8]) -> (f64, f64) {
    let (mut forward, mut backward) = ([[f64::NEG_INFINITY; 6]; D], [[f64::NEG_INFINITY; 6]; D]);
    let mut smallest = f64::NEG_INFINITY;
    for (velocities, &layers) in velocities.zip(layers) {
        smallest = smallest.max(velocities.smallest);
        for k in 0..D {
            let layer = (layers >> (2 * k) & 3) as usize;
            // Matter of one layer may be on both sides of other matter.
            let around: &[usize] = if layer == 3 { &[0, 2] } else { &[layer] };
            for &layer in around {
                for half in 0..2 {
                    let place = 2 * layer + half;
                    forward[k][place] = forward[k][place].max(velocities.forward[k][half]);
                    backward[k][place] = backward[k][place].max(velocities.backward[k][half]);
                }
            }
        }
    }
    let closing = |k: usize| {
        let (mut behind, mut closing) = (f64::NEG_INFINITY, 0.0f64);
        for (f, b) in forward[k].iter().zip(&backward[k]) {
            behind = behind.max(*f);
            closing = closing.max(behind + b);
        }
        closing
    };
    ((0..D).map(|k| closing(k).powi(2)).sum::<f64>().sqrt(), smallest)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cell in which velocities along x are from `low` to `high` in each half.
    fn cell(halves: [(f64, f64); 2]) -> CellVelocities<2> {
        let mut velocities = CellVelocities::NOTHING;
        for (half, (low, high)) in halves.into_iter().enumerate() {
            velocities.add(0, half, high, -low);
            velocities.add(1, half, 0.0, 0.0);
        }
        velocities
    }

    #[test]
    fn what_parts_does_not_close() {
        let slow = cell([(-3.0, -2.5), (-2.0, -2.0)]);
        let fast = cell([(1.0, 1.0), (5.0, 5.25)]);
        // Layer 0 is behind layer 2 along x; all cells touch each other along y.
        let [first, last] = [0b1100, 0b1110];
        assert_eq!(approach([&slow, &fast].into_iter(), &[first, last]).0, 0.5);
        assert_eq!(approach([&fast, &slow].into_iter(), &[first, last]).0, 8.25);
        // On both sides of each other.
        assert_eq!(approach([&slow, &fast].into_iter(), &[0b1111, 0b1111]).0, 8.25);
        assert_eq!(approach::<2>([].into_iter(), &[]), (0.0, f64::NEG_INFINITY));
    }
}
