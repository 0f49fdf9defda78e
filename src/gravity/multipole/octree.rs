//! The tree: nodes in preorder, each followed by its subtree, with a row of moments for each node and the bodies of the leaves.
//! Lengths in sides of the root cube, from its corner.

use bytemuck::{Pod, Zeroable};

use super::bodies::Bodies;
use super::cells::{Cell, DEEPEST};
use super::expansions::{add_body, add_moved, row};
use super::indices::{MOST, count};

/// Cells with more bodies than this are split.
pub const LEAF: usize = 16;

/// Half the diagonal of a unit cube, rounded up.
const HALF_DIAGONAL: f64 = 0.866_025_5;

/// A body that attracts and is attracted.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Body {
    /// Different for every body of the job: fixes the order of sums.
    pub id: u64,
    pub position: [f64; 3],
    /// kg; a body without mass is attracted all the same.
    pub mass: f64,
    /// Smoothing length h; softening ends at 2h.
    pub softening: f64,
    /// Its approximate acceleration, against which errors are measured.
    pub acceleration: f64,
}

/// Bounds that determine whether a cell is far enough from another to act as an expansion.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Side {
    /// kg.
    pub mass: f64,
    /// No body is farther from the centre of mass.
    pub radius: f64,
    /// Largest softening of its bodies.
    pub softening: f64,
    /// Least acceleration of its bodies, over G.
    pub acceleration: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Node {
    /// Centre of mass.
    pub centre: [f64; 3],
    pub side: Side,
    /// First body of the cell, where this rank holds them.
    pub first: u64,
    /// Bodies of the cell, where this rank holds them.
    pub count: u32,
    /// Nodes of the subtree, this one included.
    pub extent: u32,
    pub level: u32,
    pub kind: u32,
}

impl Node {
    /// All of the subtree is on this rank.
    pub const OPEN: u32 = 0;
    /// Its subtree stays on another rank, as no body here opens it.
    pub const CLOSED: u32 = 1;
    /// A cell of the top above branches of several ranks.
    pub const TOP: u32 = 2;

    pub const WORDS: usize = std::mem::size_of::<Self>() / 8;

    pub fn is_leaf(&self) -> bool {
        self.extent == 1
    }

    pub fn bodies(&self) -> std::ops::Range<usize> {
        self.first as usize..self.first as usize + self.count as usize
    }
}

/// Nodes in preorder, their rows, and the bodies of their leaves: a whole tree or a part of one.
#[derive(Debug, Clone, Default)]
pub struct Octree {
    pub order: usize,
    pub nodes: Vec<Node>,
    /// Centre, mass and moments of each node, see [`row`].
    pub rows: Vec<f64>,
    pub bodies: Bodies,
}

impl Octree {
    pub fn new(order: usize) -> Self {
        Self { order, ..Self::default() }
    }

    pub fn row(&self, node: usize) -> &[f64] {
        &self.rows[node * row(self.order)..(node + 1) * row(self.order)]
    }

    /// The subtree of a cell from its bodies in order of (key, id).
    pub fn branch(order: usize, cell: Cell, sorted: &[(u64, Body)]) -> Self {
        let mut tree = Self::new(order);
        for (_, body) in sorted {
            tree.bodies.push(&body.position, body.mass, body.softening);
        }
        tree.grow(cell, sorted, 0);
        tree
    }

    fn grow(&mut self, cell: Cell, sorted: &[(u64, Body)], first: usize) {
        let node = self.begin(cell);
        if sorted.len() <= LEAF || cell.level == DEEPEST {
            self.finish_leaf(node, sorted);
        } else {
            let mut begin = 0;
            for octant in 0..8 {
                let child = cell.child(octant);
                let end = begin + sorted[begin..].partition_point(|(key, _)| *key < child.end_key());
                if end > begin {
                    self.grow(child, &sorted[begin..end], first + begin);
                }
                begin = end;
            }
            self.finish(node, cell);
        }
        (self.nodes[node].first, self.nodes[node].count) = (first as u64, sorted.len() as u32);
    }

    /// Appends a node that [`Octree::finish`] completes once its children are there.
    pub fn begin(&mut self, cell: Cell) -> usize {
        self.nodes.push(Node { level: cell.level, ..Node::zeroed() });
        self.rows.resize(self.nodes.len() * row(self.order), 0.0);
        self.nodes.len() - 1
    }

    fn finish_leaf(&mut self, node: usize, sorted: &[(u64, Body)]) {
        let bodies = || sorted.iter().map(|(_, body)| body);
        let (mass, centre) = centre_of_mass(bodies().map(|body| (body.mass, body.position)));
        let mut side = Side { mass, radius: 0.0, softening: 0.0, acceleration: f64::INFINITY };
        let mut moments = [0.0; MOST];
        for body in bodies() {
            let e: [f64; 3] = std::array::from_fn(|k| centre[k] - body.position[k]);
            side.radius = side.radius.max(length(&e));
            side.softening = side.softening.max(body.softening);
            side.acceleration = side.acceleration.min(body.acceleration);
            add_body(self.order, body.mass, &e, &mut moments);
        }
        let Node { level, .. } = self.nodes[node];
        self.nodes[node] = Node { centre, side, level, extent: 1, ..Node::zeroed() };
        self.write_row(node, &moments);
    }

    /// Completes a node from its children, summed in their order.
    pub fn finish(&mut self, node: usize, cell: Cell) {
        let children = || Children { tree: self, at: node + 1, end: self.nodes.len() };
        let parts = children().map(|child| (self.nodes[child].side.mass, self.nodes[child].centre));
        let (mass, centre) = centre_of_mass(parts);
        let mut side = Side { mass, radius: 0.0, softening: 0.0, acceleration: f64::INFINITY };
        let mut moments = [0.0; MOST];
        for child in children() {
            let Node { centre: its, side: theirs, .. } = self.nodes[child];
            let shift: [f64; 3] = std::array::from_fn(|k| centre[k] - its[k]);
            side.radius = side.radius.max(theirs.radius + length(&shift));
            side.softening = side.softening.max(theirs.softening);
            side.acceleration = side.acceleration.min(theirs.acceleration);
            add_moved(self.order, &self.moments(child), &shift, &mut moments);
        }
        // Nothing is farther than the farthest corner of the cell.
        let width = 1.0 / (1u64 << cell.level) as f64;
        let middle = cell.middle();
        let off: [f64; 3] = std::array::from_fn(|k| centre[k] - middle[k]);
        side.radius = side.radius.min(HALF_DIAGONAL * width + length(&off));
        let extent = (self.nodes.len() - node) as u32;
        self.nodes[node] = Node { centre, side, extent, level: cell.level, ..Node::zeroed() };
        self.write_row(node, &moments);
    }

    fn moments(&self, node: usize) -> [f64; MOST] {
        let row = self.row(node);
        let mut moments = [0.0; MOST];
        moments[0] = row[3];
        let known = count(self.order);
        moments[4..known].copy_from_slice(&row[4..known]);
        moments
    }

    fn write_row(&mut self, node: usize, moments: &[f64; MOST]) {
        let Node { centre, side, .. } = self.nodes[node];
        let (width, known) = (row(self.order), count(self.order));
        let row = &mut self.rows[node * width..(node + 1) * width];
        row[..3].copy_from_slice(&centre);
        row[3] = side.mass;
        row[4..known].copy_from_slice(&moments[4..known]);
    }

    pub fn children(&self, node: usize) -> Children<'_> {
        Children { tree: self, at: node + 1, end: node + self.nodes[node].extent as usize }
    }

    /// Appends a node without its subtree.
    pub fn push_closed(&mut self, node: Node, row: &[f64]) {
        self.nodes.push(Node { kind: Node::CLOSED, extent: 1, first: 0, count: 0, ..node });
        self.rows.extend_from_slice(row);
    }

    /// Appends a subtree whose leaves count their bodies from zero.
    pub fn graft(&mut self, part: &Octree) {
        let base = self.bodies.count() as u64;
        self.nodes.extend(part.nodes.iter().map(|node| Node { first: node.first + base, ..*node }));
        self.rows.extend_from_slice(&part.rows);
        self.bodies.extend(&part.bodies, 0..part.bodies.count());
    }

    /// Copies the subtree at `at`; nodes for which `is_far` holds, which no cell opens, are copied without their own subtrees.
    pub fn copy_part(&self, at: usize, is_far: &impl Fn(&Node) -> bool, part: &mut Octree) {
        let node = self.nodes[at];
        if is_far(&node) {
            return part.push_closed(node, self.row(at));
        }
        let index = part.nodes.len();
        part.nodes.push(node);
        part.rows.extend_from_slice(self.row(at));
        if node.is_leaf() {
            part.nodes[index].first = part.bodies.count() as u64;
            part.bodies.extend(&self.bodies, node.bodies());
            return;
        }
        for child in self.children(at) {
            self.copy_part(child, is_far, part);
        }
        part.nodes[index].extent = (part.nodes.len() - index) as u32;
    }
}

/// The children of a node.
#[derive(Clone)]
pub struct Children<'a> {
    tree: &'a Octree,
    at: usize,
    end: usize,
}

impl Iterator for Children<'_> {
    type Item = usize;

    fn next(&mut self) -> Option<usize> {
        (self.at < self.end).then(|| {
            let child = self.at;
            self.at += self.tree.nodes[child].extent as usize;
            child
        })
    }
}

/// The mass of some parts in their order, and its centre; where none has any, their mean place.
fn centre_of_mass(parts: impl Iterator<Item = (f64, [f64; 3])> + Clone) -> (f64, [f64; 3]) {
    let mass: f64 = parts.clone().map(|(mass, _)| mass).sum();
    let centre = |weight: &dyn Fn(f64) -> f64| {
        let total: f64 = parts.clone().map(|(mass, _)| weight(mass)).sum();
        std::array::from_fn(|k| parts.clone().map(|(mass, place)| weight(mass) * place[k]).sum::<f64>() / total)
    };
    (mass, if mass == 0.0 { centre(&|_| 1.0) } else { centre(&|mass| mass) })
}

fn length(x: &[f64; 3]) -> f64 {
    ((x[0] * x[0] + x[1] * x[1]) + x[2] * x[2]).sqrt()
}
