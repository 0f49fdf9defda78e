//! The walk: every cell of this rank meets every other cell once, in pairs of one level, until both are far enough or leaves.
//!
//! A pair that is not far is split: both cells where they have one level, the one that is no leaf otherwise. So the cells that
//! a cell meets follow from the tree alone, and A meets B where B meets A. Far cells are summed into its local expansion,
//! which its children inherit; the cells that remain for a leaf are summed body by body. All in the order of the tree.

use rayon::prelude::*;

use super::bodies::{self, Bodies, Place};
use super::expansions::{Local, at_place, moved, row};
use super::indices::MOST;
use super::loops;
use super::octree::{Node, Octree};
use super::opening::{Opening, distance2};

/// Bodies of a task of one thread.
const TASK: u32 = 1024;

/// A cell with all that it has met so far.
struct Task {
    sink: usize,
    met: Vec<u32>,
    local: Local,
}

/// sum -m x / r^3 (three numbers) and sum m / r at every body of the rank's branches, in the order of the tree; in units of the
/// tree.
pub fn fields(tree: &Octree, opening: &Opening, is_own: &impl Fn(usize) -> bool) -> Vec<[f64; 4]> {
    if tree.nodes.is_empty() {
        return Vec::new();
    }
    let mut top = Walker::new(tree, opening);
    let mut tasks = Vec::new();
    top.met.push(0);
    top.find_tasks(0, 0, &[0.0; MOST], &mut tasks, is_own);
    let work = |walker: &mut Walker, task: &Task| {
        walker.met.clear();
        walker.met.extend_from_slice(&task.met);
        walker.out.clear();
        walker.descend(task.sink, 0, &task.local);
        std::mem::take(&mut walker.out)
    };
    let parts = tasks.par_iter().with_max_len(1).map_init(|| Walker::new(tree, opening), work);
    parts.flatten_iter().collect()
}

struct Walker<'a> {
    tree: &'a Octree,
    opening: &'a Opening,
    /// Cells met and not far, of each cell on the way down.
    met: Vec<u32>,
    far: Vec<usize>,
    near: Bodies,
    distant: Bodies,
    out: Vec<[f64; 4]>,
}

impl<'a> Walker<'a> {
    fn new(tree: &'a Octree, opening: &'a Opening) -> Self {
        let (near, distant) = (Bodies::default(), Bodies::default());
        Self { tree, opening, met: Vec::new(), far: Vec::new(), near, distant, out: Vec::new() }
    }

    /// Goes down to cells that are large enough for a task.
    fn find_tasks(
        &mut self,
        sink: usize,
        from: usize,
        local: &Local,
        tasks: &mut Vec<Task>,
        is_own: &impl Fn(usize) -> bool,
    ) {
        let node = &self.tree.nodes[sink];
        if !is_own(sink) {
            return;
        }
        if node.kind == Node::OPEN && (node.count <= TASK || node.is_leaf()) {
            return tasks.push(Task { sink, met: self.met[from..].to_vec(), local: *local });
        }
        let (local, after) = self.meet(sink, from, local);
        for child in self.tree.children(sink) {
            let local = self.inherited(sink, child, &local);
            self.find_tasks(child, after, &local, tasks, is_own);
        }
        self.met.truncate(after);
    }

    /// Sums at all bodies of a cell, which is to meet those from `from` on.
    fn descend(&mut self, sink: usize, from: usize, local: &Local) {
        let (local, after) = self.meet(sink, from, local);
        if self.tree.nodes[sink].is_leaf() {
            self.sum_bodies(sink, &local);
        } else {
            for child in self.tree.children(sink) {
                let local = self.inherited(sink, child, &local);
                self.descend(child, after, &local);
            }
        }
        self.met.truncate(after);
    }

    fn inherited(&self, sink: usize, child: usize, local: &Local) -> Local {
        let (old, new) = (self.tree.nodes[sink].centre, self.tree.nodes[child].centre);
        moved(self.opening.order, local, &std::array::from_fn(|k| new[k] - old[k]))
    }

    /// Sorts those that the sink meets, adds the far ones to its expansion, and leaves those its children will meet behind the
    /// place that it returns.
    fn meet(&mut self, sink: usize, from: usize, local: &Local) -> (Local, usize) {
        self.far.clear();
        self.near.clear();
        self.distant.clear();
        let after = self.met.len();
        for at in from..after {
            self.sort(sink, self.met[at] as usize);
        }
        let mut local = *local;
        loops::add_far(self.tree, sink, &self.far, &mut local);
        (local, after)
    }

    fn sort(&mut self, sink: usize, source: usize) {
        let (a, b) = (&self.tree.nodes[sink], &self.tree.nodes[source]);
        if b.side.mass == 0.0 {
            return;
        }
        let r2 = distance2(&a.centre, &b.centre);
        if self.opening.is_far(r2, &a.side, &b.side) {
            self.far.push(source * row(self.opening.order));
            return;
        }
        let (leaf, source_leaf) = (a.is_leaf() && a.kind == Node::OPEN, b.is_leaf() && b.kind == Node::OPEN);
        match (leaf, source_leaf) {
            (true, true) => {
                let reach = a.side.radius + b.side.radius + 2.0 * a.side.softening.max(b.side.softening);
                let near = r2 <= reach * reach;
                let list = if near { &mut self.near } else { &mut self.distant };
                list.extend(&self.tree.bodies, b.bodies());
            }
            (true, false) => {
                assert!(b.kind != Node::CLOSED, "a cell opens one that its rank did not request");
                let tree = self.tree;
                tree.children(source).for_each(|child| self.sort(sink, child));
            }
            (false, false) if b.level <= a.level => {
                assert!(b.kind != Node::CLOSED, "a cell opens one that its rank did not request");
                self.met.extend(self.tree.children(source).map(|child| child as u32));
            }
            (false, _) => self.met.push(source as u32),
        }
    }

    fn sum_bodies(&mut self, sink: usize, local: &Local) {
        let tree = self.tree;
        let node = &tree.nodes[sink];
        self.near.pad();
        self.distant.pad();
        for i in node.bodies() {
            let position = [0, 1, 2].map(|k| tree.bodies.position[k][i]);
            let place = Place { position, softening: tree.bodies.softening[i] };
            let mut sums = loops::sum_bodies(&self.near, &self.distant, &place);
            let t = std::array::from_fn(|k| position[k] - node.centre[k]);
            let far = at_place(self.opening.order, local, &t);
            (0..4).for_each(|k| sums[k] += far[k]);
            sums[3] -= tree.bodies.mass[i] * bodies::own(place.softening);
            self.out.push(sums);
        }
    }
}
