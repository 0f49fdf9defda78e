//! How long matter that is not in touch yet needs until it is. The Courant condition knows sound, and the approach of pairs inside
//! their supports; what is fast and soft could fly into other matter, or through it, within one of its steps. With the blocks of
//! 3^D cells of [`watch`](super::watch), W the largest relative velocity that a block may hold, C the Courant number:
//!
//! ```text
//! particles of the block's own level:          W dt <= C h              h: the smallest of them
//! finer ones that no block of theirs holds:    W dt <= 2 S - d - s      S: side of the cells one level below, d: how far they have
//!                                                                       come since the lists were built, s: their largest support
//! all that no block holds:                     W dt <= 2 S - d - s      S: side of the widest cells watched; d, s, W: of everything
//! ```
//!
//! as two sides were between particles that no block holds, see there. A pair so comes by C h into its supports at most before its forces are
//! known. A block that holds smooth flow, such as an even expansion, has three times the relative velocity of its cells, and nothing that would
//! meet within their distance: there 0.4 times the largest relative velocity w in a single cell stands for W; W <= 3.5 w tells it.
//!
//! Matter of which nothing moves by C h in a step at all need not be looked at. Extremes are exact, and the same on any ranks.

use rayon::prelude::*;

use super::comm::{Comm, Exchange};
use super::watch::{Blocks, CELLS, Motion, Summary, Watch};

/// Velocities in a cell: maxima only, so that cells merge element by element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Flight<const D: usize> {
    forward: [f64; D],
    /// Of the velocity's opposite.
    backward: [f64; D],
    /// -h of the smallest particle of the cell's own level.
    thin: f64,
}

/// Relative velocity in a block over that in one of its cells, up to which its flow is smooth; and what then counts of the latter.
const SMOOTH: f64 = 3.5;
const WITHIN_CELL: f64 = 0.4;

/// Numbers of a cell that another rank must know.
const fn words(dimension: usize) -> usize {
    2 * dimension + 1
}

impl<const D: usize> Flight<D> {
    const NOTHING: Self =
        Self { forward: [f64::NEG_INFINITY; D], backward: [f64::NEG_INFINITY; D], thin: f64::NEG_INFINITY };

    #[inline(always)]
    fn merge(&mut self, other: &Self) {
        for k in 0..D {
            self.forward[k] = self.forward[k].max(other.forward[k]);
            self.backward[k] = self.backward[k].max(other.backward[k]);
        }
        self.thin = self.thin.max(other.thin);
    }

    fn relative(&self) -> f64 {
        relative(&self.forward, &self.backward)
    }

    fn write(&self, to: &mut [f64]) {
        to[..D].copy_from_slice(&self.forward);
        to[D..2 * D].copy_from_slice(&self.backward);
        to[2 * D] = self.thin;
    }

    fn read(from: &[f64]) -> Self {
        let part = |first: usize| std::array::from_fn(|k| from[first + k]);
        Self { forward: part(0), backward: part(D), thin: from[2 * D] }
    }
}

/// The largest difference of two vectors whose components, and their opposites, are at most these.
pub fn relative(forward: &[f64], backward: &[f64]) -> f64 {
    forward.iter().zip(backward).map(|(f, b)| (f + b).max(0.0).powi(2)).sum::<f64>().sqrt()
}

/// What a watch keeps for it, made when it is first asked.
pub(super) struct Flights<const D: usize> {
    /// Of own cells, then of cells known from other ranks only.
    cells: Vec<Flight<D>>,
    exchange: Exchange,
}

impl<const D: usize> Flights<D> {
    pub(super) fn bytes(&self) -> usize {
        std::mem::size_of::<Flight<D>>() * self.cells.len() + self.exchange.bytes()
    }
}

/// How particles fly.
pub struct Flying<'a> {
    /// D numbers per owned particle, m/s.
    pub velocity: &'a [f64],
    /// The largest relative velocity of any two particles of all ranks, m/s.
    pub relative: f64,
    /// Of an owned particle.
    pub id: &'a dyn Fn(usize) -> u64,
}

/// The longest step for all ranks, and who asks for it on this one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Closing {
    /// s
    pub dt: f64,
    /// The owned particle of the smallest id among those that it may concern.
    pub particle: Option<usize>,
}

impl<const D: usize> Watch<D> {
    /// The longest step in which nothing flies into each other unseen. Collective.
    pub fn closing<S: Fn(usize) -> f64 + Sync>(
        &mut self,
        motion: &Motion<'_, S>,
        flying: &Flying,
        courant: f64,
        comm: &Comm,
    ) -> Closing {
        let &Flying { velocity, relative: all, id } = flying;
        self.survey(motion, comm);
        self.exchange_flights(motion, velocity, comm);
        let flights = &self.flights.as_ref().expect("just made").cells;
        let (blocks, summaries, sides) = (&self.blocks, &self.summaries, &self.sides);
        let limit = |block: usize| limit(blocks, (block, summaries, flights), sides, courant);
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
    fn exchange_flights<S: Fn(usize) -> f64 + Sync>(&mut self, motion: &Motion<'_, S>, velocity: &[f64], comm: &Comm) {
        let [sends, receives] = &self.peers;
        let new = || {
            let numbers = |list: &[(usize, usize)]| {
                list.iter().map(|&(rank, cells)| (rank, cells * words(D))).collect::<Vec<_>>()
            };
            let exchange = Exchange::new(comm, &numbers(sends), &numbers(receives));
            Flights { cells: vec![Flight::NOTHING; self.summaries.len()], exchange }
        };
        let mut flights = self.flights.take().unwrap_or_else(new);
        for level in 0..self.levels.len() - 1 {
            self.summarise_flight(level, &mut flights.cells, motion, velocity);
        }
        let outgoing = flights.exchange.outgoing().chunks_exact_mut(words(D));
        self.send_cells.iter().zip(outgoing).for_each(|(&cell, to)| flights.cells[cell as usize].write(to));
        flights.exchange.start(comm);
        flights.cells[self.cells.len()..].fill(Flight::NOTHING);
        flights.exchange.wait(comm);
        for (&cell, from) in self.receive_cells.iter().zip(flights.exchange.incoming().chunks_exact(words(D))) {
            flights.cells[cell as usize].merge(&Flight::read(from));
        }
        self.flights = Some(flights);
    }

    /// Own cells of one level, from their particles and the level below.
    fn summarise_flight<S: Fn(usize) -> f64 + Sync>(
        &self,
        level: usize,
        flights: &mut [Flight<D>],
        motion: &Motion<'_, S>,
        velocity: &[f64],
    ) {
        let (start, end) = (self.levels[level], self.levels[level + 1]);
        let (finer, flights) = flights.split_at_mut(start);
        let mine = flights[..end - start].par_iter_mut().zip(&self.cells[start..end]);
        mine.with_min_len(CELLS).for_each(|(flight, cell)| {
            *flight = Flight::NOTHING;
            for child in &finer[cell.children.start as usize..cell.children.end as usize] {
                flight.merge(&Flight { thin: f64::NEG_INFINITY, ..*child });
            }
            for i in cell.particles.start as usize..cell.particles.end as usize {
                flight.thin = flight.thin.max(-(motion.support)(i) / crate::kernel::SUPPORT);
                for k in 0..D {
                    let v = velocity[D * i + k];
                    flight.forward[k] = flight.forward[k].max(v);
                    flight.backward[k] = flight.backward[k].max(-v);
                }
            }
        });
    }
}

/// The longest step for the particles of one block, s.
fn limit<const D: usize>(
    blocks: &Blocks,
    (block, summaries, flights): (usize, &[Summary<D>], &[Flight<D>]),
    sides: &[f64],
    courant: f64,
) -> f64 {
    let (mut flight, mut inside) = (Flight::NOTHING, 0.0f64);
    for &cell in blocks.cells_of(block) {
        flight.merge(&flights[cell as usize]);
        inside = inside.max(flights[cell as usize].relative());
    }
    let all = flight.relative();
    let speed = if all <= SMOOTH * inside { WITHIN_CELL * inside } else { all };
    let own = if flight.thin > f64::NEG_INFINITY { -courant * flight.thin } else { f64::INFINITY };
    let (apart, finer) = blocks.moved(block, summaries);
    let gap =
        if finer > f64::NEG_INFINITY { 2.0 * sides[blocks.level(block) - 1] - apart - finer } else { f64::INFINITY };
    if speed > 0.0 { own.min(gap) / speed } else { f64::INFINITY }
}
