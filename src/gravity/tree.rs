//! The tree in memory: nodes in preorder, so that a walk needs no stack - a node that is expanded is left behind together
//! with the `extent` nodes of its subtree, one that is opened is followed by its first child.

use bytemuck::{Pod, Zeroable};

use super::cells::{Cell, DEEPEST, Root};
use super::moments::Moments;
use super::{Opening, Source, Target};
use crate::math::Vec3;

/// Cells with more sources than this are split.
pub const LEAF: usize = 16;

/// Half the diagonal of a unit cube, rounded up.
const HALF_DIAGONAL: f64 = 0.866_025_5;

/// `Node::count` of a node whose sources stay on another rank because no target here opens it.
const CLOSED: u32 = u32::MAX;

#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Node {
    centre: [f64; 3],
    mass: f64,
    second: [f64; 6],
    softening: f64,
    /// Distance from the centre of mass beyond which the cell's geometry allows expansion, m.
    reach: f64,
    /// No source is farther from the centre of mass, m.
    radius: f64,
    /// First source in `Tree::sources`, for a leaf.
    first: u64,
    /// Sources of a leaf; 0 for a node with children.
    count: u32,
    /// Nodes of the subtree, this one included.
    extent: u32,
}

impl Node {
    pub const WORDS: usize = std::mem::size_of::<Self>() / 8;

    fn new(moments: &Moments, cell: Cell, lattice: &Lattice) -> Self {
        let side = lattice.root.side_at(cell.level);
        let off_centre = (moments.centre - lattice.root.centre(cell)).norm();
        Self {
            centre: moments.centre.into(),
            mass: moments.mass,
            second: moments.second,
            softening: moments.softening,
            reach: side / lattice.opening.angle() + off_centre,
            radius: HALF_DIAGONAL * side + off_centre,
            first: 0,
            count: 0,
            extent: 1,
        }
    }

    pub fn moments(&self) -> Moments {
        Moments { mass: self.mass, centre: Vec3::from(self.centre), second: self.second, softening: self.softening }
    }

    /// The node without its subtree.
    pub fn closed(self) -> Self {
        Self { first: 0, count: CLOSED, extent: 1, ..self }
    }

    /// Whether a target with softening `h` at squared distance `r2` from the centre of mass feels the cell as a whole.
    #[inline]
    pub fn is_far(&self, r2: f64, h: f64) -> bool {
        let limit = self.reach.max(self.radius + 2.0 * self.softening.max(h));
        r2 > limit * limit
    }

    #[inline]
    pub fn centre(&self) -> Vec3 {
        Vec3::from(self.centre)
    }

    #[inline]
    pub fn extent(&self) -> usize {
        self.extent as usize
    }

    /// The sources of a leaf; empty for a node with children.
    #[inline]
    pub fn sources(&self) -> std::ops::Range<usize> {
        assert!(self.count != CLOSED, "a target opens a cell that its rank did not ask for");
        self.first as usize..self.first as usize + self.count as usize
    }
}

/// What all cells have in common.
#[derive(Debug, Clone, Copy)]
pub struct Lattice {
    pub root: Root,
    pub opening: Opening,
}

/// Nodes in preorder and the sources of their leaves: a whole tree or a part of one.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Tree {
    pub(super) nodes: Vec<Node>,
    pub(super) sources: Vec<Source>,
}

impl Tree {
    /// The subtree of a cell that this rank holds alone, from its sources in order of (key, id).
    pub(super) fn branch(lattice: &Lattice, cell: Cell, sources: &[(u64, Source)]) -> Self {
        let mut tree = Self { nodes: Vec::new(), sources: sources.iter().map(|(_, s)| *s).collect() };
        tree.grow(lattice, cell, sources, 0);
        tree
    }

    fn grow(&mut self, lattice: &Lattice, cell: Cell, sources: &[(u64, Source)], first: usize) {
        if sources.len() <= LEAF || cell.level == DEEPEST {
            let moments = Moments::of_sources(&self.sources[first..first + sources.len()]);
            let leaf = Node { first: first as u64, count: sources.len() as u32, ..Node::new(&moments, cell, lattice) };
            self.nodes.push(leaf);
            return;
        }
        self.parent(lattice, cell, |tree| {
            let mut begin = 0;
            for octant in 0..8 {
                let child = cell.child(octant);
                let end = begin + sources[begin..].partition_point(|(key, _)| *key < child.end_key());
                if end > begin {
                    tree.grow(lattice, child, &sources[begin..end], first + begin);
                }
                begin = end;
            }
        });
    }

    /// A node with the children that `grow` appends, summed in their order.
    pub(super) fn parent(&mut self, lattice: &Lattice, cell: Cell, grow: impl FnOnce(&mut Self)) {
        let index = self.nodes.len();
        self.nodes.push(Node::zeroed());
        grow(self);
        let (mut children, mut child) = ([0; 8], index + 1);
        let mut n = 0;
        while child < self.nodes.len() {
            children[n] = child;
            n += 1;
            child += self.nodes[child].extent();
        }
        let moments = Moments::combine(children[..n].iter().map(|&k| self.nodes[k].moments()));
        let extent = (self.nodes.len() - index) as u32;
        self.nodes[index] = Node { extent, ..Node::new(&moments, cell, lattice) };
    }

    /// Appends a subtree whose leaves count their sources from zero.
    pub(super) fn graft(&mut self, part: &Tree) {
        let base = self.sources.len() as u64;
        self.nodes.extend(part.nodes.iter().map(|n| Node { first: n.first + base, ..*n }));
        self.sources.extend_from_slice(&part.sources);
    }

    /// The part of a branch that targets in a region may open; none if they see the branch as one.
    pub(super) fn part_for(&self, region: &Region) -> Option<Tree> {
        let mut part = Tree::default();
        if region.is_empty() || region.sees_as_one(&self.nodes[0]) {
            return None;
        }
        self.copy_part(0, region, &mut part);
        Some(part)
    }

    /// Copies the subtree at node `at`, which is opened.
    fn copy_part(&self, at: usize, region: &Region, part: &mut Tree) {
        let node = self.nodes[at];
        let index = part.nodes.len();
        part.nodes.push(node);
        if node.count > 0 {
            part.nodes[index].first = part.sources.len() as u64;
            part.sources.extend_from_slice(&self.sources[node.sources()]);
            return;
        }
        let mut child = at + 1;
        while child < at + node.extent() {
            if region.sees_as_one(&self.nodes[child]) {
                part.nodes.push(self.nodes[child].closed());
            } else {
                self.copy_part(child, region, part);
            }
            child += self.nodes[child].extent();
        }
        part.nodes[index].extent = (part.nodes.len() - index) as u32;
    }
}

/// A box around a rank's targets and the largest softening among them.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Region {
    low: [f64; 3],
    high: [f64; 3],
    softening: f64,
}

impl Region {
    pub fn around(targets: &[Target]) -> Self {
        let empty = Self { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3], softening: 0.0 };
        targets.iter().fold(empty, |mut region, target| {
            for k in 0..3 {
                region.low[k] = region.low[k].min(target.position[k]);
                region.high[k] = region.high[k].max(target.position[k]);
            }
            region.softening = region.softening.max(target.softening);
            region
        })
    }

    pub fn is_empty(&self) -> bool {
        self.low[0] > self.high[0]
    }

    /// Whether no target in the region opens the node. The distance is rounded as a walk rounds it, each operation being
    /// monotone, so that the answer is safe to the last bit.
    fn sees_as_one(&self, node: &Node) -> bool {
        let axis = |k: usize| (self.low[k] - node.centre[k]).max(node.centre[k] - self.high[k]).max(0.0);
        node.is_far(super::walk::squared(axis(0), axis(1), axis(2)), self.softening)
    }
}
