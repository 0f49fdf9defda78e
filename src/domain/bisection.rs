//! Orthogonal recursive bisection over cost: a box is cut across its longest side so that the costs on both sides are in
//! proportion to the numbers of parts they will be cut into, for any number of parts (Berger and Bokhari 1987, IEEE
//! Trans. Comput. C-36, 570).
//! Planes are found by histograms: no rank ever sees another's particles, costs are integers, so that sums are exact, and
//! all boxes of one depth share their collectives.
//!
//! A plane lies on a fine lattice of the box it cuts. Particles on a lattice of their own lie in whole layers that no plane
//! could divide, so a plane orders them by the other coordinates too: it cuts a layer along a line, and a line at a point.

use super::comm::Comm;
use crate::particles::curve::BITS;

/// A histogram has `2^BIN_BITS` bins.
const BIN_BITS: u32 = 6;
const BINS: usize = 1 << BIN_BITS;

/// A plane is good enough when it misses by this share of the cost on its lighter side.
const TOLERANCE: f64 = 1e-3;

/// How the ranks of a job, or one process alone, combine numbers.
pub trait Reduce {
    /// Element-wise maximum over all ranks.
    fn all_max(&self, values: &mut [f64]);
    /// Element-wise sum over all ranks.
    fn all_sum(&self, values: &mut [i64]);
}

impl Reduce for Comm {
    fn all_max(&self, values: &mut [f64]) {
        Comm::all_max(self, values);
    }

    fn all_sum(&self, values: &mut [i64]) {
        Comm::all_sum(self, values);
    }
}

/// One process that holds all particles.
pub struct Alone;

impl Reduce for Alone {
    fn all_max(&self, _: &mut [f64]) {}

    fn all_sum(&self, _: &mut [i64]) {}
}

/// A tree of planes, the same on every rank.
#[derive(Debug, Clone)]
pub struct Bisection<const D: usize> {
    nodes: Vec<Node<D>>,
    parts: usize,
}

#[derive(Debug, Clone)]
struct Node<const D: usize> {
    axis: usize,
    low: [f64; D],
    /// Cells of the fine lattice per metre.
    scale: f64,
    /// Keys below it lie in the first child.
    plane: u64,
    children: [Child; 2],
}

#[derive(Debug, Clone, Copy)]
enum Child {
    Node(u32),
    Part(u32),
}

impl<const D: usize> Node<D> {
    /// Coordinates on the fine lattice, the cut one foremost.
    #[inline]
    fn key(&self, position: &[f64; D]) -> u64 {
        let last = (1u64 << BITS) - 1;
        (0..D).fold(0, |key, k| {
            let k = (self.axis + k) % D;
            // Outside the box the conversion saturates below and the minimum above.
            key << BITS | (((position[k] - self.low[k]) * self.scale) as u64).min(last)
        })
    }

    #[inline]
    fn child(&self, position: &[f64; D]) -> Child {
        self.children[(self.key(position) >= self.plane) as usize]
    }
}

/// A box that is being cut: its node, the parts that it will fall into, and what is known of its plane.
struct Open {
    node: usize,
    first: usize,
    parts: usize,
    /// First key of the interval that holds the plane, and the cost below it.
    start: u64,
    below: i64,
    /// Cost that belongs below the plane.
    target: i64,
    total: i64,
    found: bool,
}

/// This rank's particles while planes are sought.
struct Sought<'a, const D: usize> {
    positions: &'a [[f64; D]],
    costs: &'a [u32],
    /// The open box that each is in; none once its part is known.
    members: &'a [Option<u32>],
}

impl<const D: usize> Bisection<D> {
    /// `positions`: D numbers for each particle of this rank; `costs`: one for each. Collective.
    pub fn new(positions: &[f64], costs: &[u32], parts: usize, reduce: &impl Reduce) -> Self {
        let (positions, rest) = positions.as_chunks::<D>();
        assert!(rest.is_empty() && positions.len() == costs.len() && parts > 0);
        let mut tree = Self { nodes: Vec::new(), parts };
        let mut open = Vec::new();
        if parts > 1 {
            tree.open(&mut open, 0, parts);
        }
        // Number of the open box that holds each particle; none once its part is known.
        let mut members: Vec<Option<u32>> = vec![(parts > 1).then_some(0); positions.len()];
        while !open.is_empty() {
            let particles = Sought { positions, costs, members: &members };
            tree.fit_boxes(&open, &particles, reduce);
            for round in 0.. {
                tree.refine(&mut open, round, &particles, reduce);
                if open.iter().all(|o| o.found) {
                    break;
                }
            }
            let mut next = Vec::new();
            for o in &open {
                tree.nodes[o.node].children = tree.split(&mut next, o.first, o.parts);
            }
            // Nodes of one depth have consecutive numbers.
            let first = next.first().map_or(0, |o: &Open| o.node as u32);
            for (member, position) in members.iter_mut().zip(positions) {
                *member = member.and_then(|m| match tree.nodes[open[m as usize].node].child(position) {
                    Child::Node(node) => Some(node - first),
                    Child::Part(_) => None,
                });
            }
            open = next;
        }
        tree
    }

    pub fn parts(&self) -> usize {
        self.parts
    }

    /// The part that a position belongs to, wherever it is.
    #[inline]
    pub fn owner(&self, position: &[f64; D]) -> usize {
        let mut at = if self.nodes.is_empty() { Child::Part(0) } else { Child::Node(0) };
        loop {
            match at {
                Child::Node(node) => at = self.nodes[node as usize].child(position),
                Child::Part(part) => return part as usize,
            }
        }
    }

    fn open(&mut self, open: &mut Vec<Open>, first: usize, parts: usize) -> Child {
        let node = self.nodes.len();
        self.nodes.push(Node { axis: 0, low: [0.0; D], scale: 0.0, plane: 0, children: [Child::Part(0); 2] });
        open.push(Open { node, first, parts, start: 0, below: 0, target: 0, total: 0, found: false });
        Child::Node(node as u32)
    }

    fn split(&mut self, open: &mut Vec<Open>, first: usize, parts: usize) -> [Child; 2] {
        let left = parts / 2;
        [(first, left), (first + left, parts - left)].map(|(first, parts)| match parts {
            1 => Child::Part(first as u32),
            _ => self.open(open, first, parts),
        })
    }

    /// Gives every open node the tight box of its particles: the longest side is cut.
    fn fit_boxes(&mut self, open: &[Open], particles: &Sought<D>, reduce: &impl Reduce) {
        let mut extremes = vec![f64::NEG_INFINITY; 2 * D * open.len()];
        for (position, member) in particles.positions.iter().zip(particles.members) {
            let Some(member) = member else { continue };
            let mine = &mut extremes[2 * D * *member as usize..][..2 * D];
            for k in 0..D {
                mine[k] = mine[k].max(position[k]);
                mine[D + k] = mine[D + k].max(-position[k]);
            }
        }
        reduce.all_max(&mut extremes);
        for (o, extremes) in open.iter().zip(extremes.chunks_exact(2 * D)) {
            let side = |k: usize| extremes[k] + extremes[D + k];
            let axis = (0..D).rev().max_by(|&a, &b| side(a).total_cmp(&side(b))).unwrap_or(0);
            let node = &mut self.nodes[o.node];
            // A box without particles keeps its empty lattice: everything is on the plane's one side.
            if side(axis) > 0.0 {
                node.axis = axis;
                node.low = std::array::from_fn(|k| -extremes[D + k]);
                node.scale = (1u64 << BITS) as f64 / side(axis);
            }
        }
    }

    /// One histogram per open node over the interval that still holds its plane.
    fn refine(&mut self, open: &mut [Open], round: u32, particles: &Sought<D>, reduce: &impl Reduce) {
        let Sought { positions, costs, members } = particles;
        let shift = (BITS * D as u32).saturating_sub(BIN_BITS * (round + 1));
        let mut histograms = vec![0i64; BINS * open.len()];
        for ((position, cost), member) in positions.iter().zip(*costs).zip(*members) {
            let Some(m) = member.map(|m| m as usize) else { continue };
            let o = &open[m];
            if !o.found {
                let bin = self.nodes[o.node].key(position).checked_sub(o.start).map(|k| k >> shift);
                if let Some(bin) = bin.filter(|&bin| bin < BINS as u64) {
                    histograms[BINS * m + bin as usize] += *cost as i64;
                }
            }
        }
        reduce.all_sum(&mut histograms);
        for (o, histogram) in open.iter_mut().zip(histograms.chunks_exact(BINS)) {
            if !o.found {
                self.nodes[o.node].plane = o.narrow(histogram, round, shift);
            }
        }
    }
}

impl Open {
    /// Narrows the interval to the bin that holds the plane; the nearer edge of that bin is the plane so far.
    fn narrow(&mut self, histogram: &[i64], round: u32, shift: u32) -> u64 {
        if round == 0 {
            self.total = histogram.iter().sum();
            self.target = (self.total as i128 * (self.parts / 2) as i128 / self.parts as i128) as i64;
        }
        let mut bin = 0;
        while bin + 1 < BINS && self.below + histogram[bin] <= self.target {
            self.below += histogram[bin];
            bin += 1;
        }
        self.start += (bin as u64) << shift;
        let short = self.target - self.below;
        let over = (self.below + histogram[bin] - self.target).max(0);
        let allowed = TOLERANCE * self.target.min(self.total - self.target) as f64;
        self.found = shift == 0 || short.min(over) as f64 <= allowed;
        if short <= over { self.start } else { self.start + (1 << shift) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::uniform;

    /// A ball on a cubic lattice, cut along its layers, a denser small ball beside it, and ejecta far around.
    fn impact(sites: i32) -> (Vec<f64>, Vec<u32>) {
        let (mut positions, mut costs) = (Vec::new(), Vec::new());
        for (centre, radius, spacing) in [(0.0, 1.0, 1.0), (1.3, 0.25, 0.5)] {
            let n = (sites as f64 * radius / spacing) as i32;
            for (i, j, k) in (-n..=n).flat_map(|i| (-n..=n).flat_map(move |j| (-n..=n).map(move |k| (i, j, k)))) {
                if i * i + j * j + k * k <= n * n {
                    positions.extend([i, j, k].map(|c| c as f64 * spacing / sites as f64 + centre));
                    costs.push(if centre > 0.0 { 70 } else { 100 });
                }
            }
        }
        for id in 0..positions.len() as u64 / 30 {
            let distance = 2.0 / (1.001 - uniform(3, id, 3));
            positions.extend([0, 1, 2].map(|k| distance * (uniform(3, id, k) - 0.5)));
            costs.push(20);
        }
        (positions, costs)
    }

    fn imbalance(positions: &[f64], costs: &[u32], parts: usize) -> f64 {
        let tree = Bisection::<3>::new(positions, costs, parts, &Alone);
        let mut sums = vec![0u64; parts];
        for (position, cost) in positions.as_chunks::<3>().0.iter().zip(costs) {
            sums[tree.owner(position)] += *cost as u64;
        }
        let mean = sums.iter().sum::<u64>() as f64 / parts as f64;
        *sums.iter().max().unwrap() as f64 / mean - 1.0
    }

    /// The layers of this ball are 1/57 of its width: whole layers would miss by 30 % at 64 parts.
    #[test]
    fn any_number_of_parts_is_balanced() {
        let (positions, costs) = impact(28);
        for parts in [1, 2, 3, 7, 64] {
            let found = imbalance(&positions, &costs, parts);
            assert!(found < 0.05, "{parts} parts: {found}");
        }
    }

    #[test]
    fn a_thousand_parts_are_balanced() {
        let (positions, costs) = impact(48);
        let found = imbalance(&positions, &costs, 1000);
        assert!(found < 0.05, "{found}");
    }

    #[test]
    fn more_parts_than_particles() {
        let tree = Bisection::<2>::new(&[0.0, 0.0, 1.0, 0.0, 1.0, 0.0], &[1, 1, 1], 8, &Alone);
        assert!(tree.owner(&[0.0, 0.0]) != tree.owner(&[1.0, 0.0]));
        for x in [f64::NEG_INFINITY, -5.0, 0.5, 1e300, f64::NAN] {
            assert!(tree.owner(&[x, x]) < 8);
        }
        assert!(Bisection::<3>::new(&[], &[], 5, &Alone).owner(&[1.0; 3]) < 5);
    }

    /// Three unit costs for one part and six for two: the plane lies between the third and the fourth.
    #[test]
    fn costs_stand_like_parts() {
        let positions: Vec<f64> = (0..9).flat_map(|k| [0.0, k as f64]).collect();
        let tree = Bisection::<2>::new(&positions, &[1; 9], 3, &Alone);
        let owners: Vec<_> = positions.as_chunks::<2>().0.iter().map(|p| tree.owner(p)).collect();
        assert_eq!(owners, [0, 0, 0, 1, 1, 1, 2, 2, 2]);
    }
}
