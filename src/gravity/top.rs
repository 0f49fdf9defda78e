//! How a tree comes about on many ranks: the top that all know, branches that one rank each builds, and the parts of
//! branches that travel.

use bytemuck::Zeroable;

use super::cells::{Cell, DEEPEST, Root};
use super::tree::{LEAF, Lattice, Node, Region, Tree};
use super::{Opening, Source, Target};
use crate::domain::comm::Comm;

/// Branches wanted per rank: enough for their surfaces to follow those of the ranks' domains.
const BRANCHES_PER_RANK: u64 = 32;

/// Words of a source in a message.
const SOURCE_WORDS: usize = std::mem::size_of::<Source>() / 8;

impl Tree {
    /// Builds the tree of the sources of all ranks, as far as the targets of this rank need it. Collective.
    pub fn build(comm: &Comm, sources: &[Source], targets: &[Target], opening: Opening) -> Tree {
        let root = Root::around(comm, sources.iter().map(|s| &s.position));
        let lattice = Lattice { root, opening };
        let mut keyed = in_order(&root, sources.iter().copied());
        let ends = find_ends(comm, &keyed, LEAF as i64);
        let owners = find_owners(comm, &ends, &keyed);
        keyed = deliver(comm, &root, &ends, &owners, keyed);

        let grow = |(&end, &owner): (&Cell, &usize)| {
            (owner == comm.rank()).then(|| Tree::branch(&lattice, end, within(end, &keyed)))
        };
        let mut branches: Vec<Option<Tree>> = ends.iter().zip(&owners).map(grow).collect();
        let heads = share_heads(comm, &branches);
        receive_parts(comm, &mut branches, targets);

        let mut tree = Tree::default();
        if !ends.is_empty() {
            let mut rest = Ends { ends: &ends, heads: &heads, branches: &branches };
            rest.assemble(&lattice, Cell::ROOT, &mut tree);
        }
        tree
    }
}

/// Sources in canonical order: along the curve, by id within a deepest cell.
fn in_order(root: &Root, sources: impl Iterator<Item = Source>) -> Vec<(u64, Source)> {
    let mut keyed: Vec<_> = sources.map(|s| (root.key(&s.position), s)).collect();
    keyed.sort_unstable_by_key(|(key, s)| (*key, s.id));
    keyed
}

/// What lies in a cell, out of keyed things in order.
pub(super) fn within<T>(cell: Cell, keyed: &[(u64, T)]) -> &[(u64, T)] {
    let begin = keyed.partition_point(|(key, _)| *key < cell.first_key());
    let end = keyed.partition_point(|(key, _)| *key < cell.end_key());
    &keyed[begin..end]
}

/// The ends of the top, along the curve: cells with sources that are not split, being leaves, or are small enough for one rank.
pub(super) fn find_ends<T>(comm: &Comm, keyed: &[(u64, T)], leaf: i64) -> Vec<Cell> {
    let mut total = [keyed.len() as i64];
    comm.all_sum(&mut total);
    let enough = leaf.max(total[0] / (BRANCHES_PER_RANK * comm.size() as u64) as i64);
    let (mut frontier, mut ends) = (vec![Cell::ROOT], Vec::new());
    while !frontier.is_empty() {
        let mut counts: Vec<i64> = frontier.iter().map(|&cell| within(cell, keyed).len() as i64).collect();
        comm.all_sum(&mut counts);
        let mut next = Vec::new();
        for (&cell, &count) in frontier.iter().zip(&counts) {
            if count > enough && cell.level < DEEPEST {
                next.extend((0..8).map(|octant| cell.child(octant)));
            } else if count > 0 {
                ends.push(cell);
            }
        }
        frontier = next;
    }
    ends.sort_unstable_by_key(|cell| cell.first_key());
    ends
}

/// Each branch goes to the rank that holds most of it, the lowest of several, so that little has to travel.
pub(super) fn find_owners<T>(comm: &Comm, ends: &[Cell], keyed: &[(u64, T)]) -> Vec<usize> {
    let size = comm.size() as f64;
    let claim = |&end: &Cell| within(end, keyed).len() as f64 * size + (size - 1.0 - comm.rank() as f64);
    let mut claims: Vec<f64> = ends.iter().map(claim).collect();
    comm.all_max(&mut claims);
    claims.iter().map(|claim| comm.size() - 1 - (claim % size) as usize).collect()
}

/// Sends every source to the owner of its branch; returns those of this rank's branches, in order.
fn deliver(comm: &Comm, root: &Root, ends: &[Cell], owners: &[usize], keyed: Vec<(u64, Source)>) -> Vec<(u64, Source)> {
    if comm.size() == 1 {
        return keyed;
    }
    let mut parcels = Parcels::default();
    for (&end, &owner) in ends.iter().zip(owners) {
        for (_, source) in within(end, &keyed) {
            parcels.to(owner).extend_from_slice(bytemuck::cast_slice(std::slice::from_ref(source)));
        }
    }
    let received = comm.sparse_exchange(parcels.0);
    let sources = received.iter().flat_map(|(_, words)| words.chunks_exact(SOURCE_WORDS));
    in_order(root, sources.map(|words| bytemuck::pod_read_unaligned(bytemuck::cast_slice(words))))
}

/// Messages under way, one per rank, in the order in which ranks were first addressed.
#[derive(Default)]
pub(super) struct Parcels(pub(super) Vec<(usize, Vec<u64>)>);

impl Parcels {
    pub(super) fn to(&mut self, rank: usize) -> &mut Vec<u64> {
        let index = self.0.iter().rposition(|(to, _)| *to == rank).unwrap_or_else(|| {
            self.0.push((rank, Vec::new()));
            self.0.len() - 1
        });
        &mut self.0[index].1
    }
}

/// The first node of every branch, on all ranks: one rank has it and the others add zeros to its bits.
fn share_heads(comm: &Comm, branches: &[Option<Tree>]) -> Vec<Node> {
    let head = |branch: &Option<Tree>| branch.as_ref().map_or(Node::zeroed(), |tree| tree.nodes[0]);
    let mut heads: Vec<Node> = branches.iter().map(head).collect();
    comm.all_sum(bytemuck::cast_slice_mut(&mut heads));
    heads
}

/// Sends each rank the parts of this rank's branches that it can open, and puts those that come into `branches`.
fn receive_parts(comm: &Comm, branches: &mut [Option<Tree>], targets: &[Target]) {
    let regions = comm.all_gather(&[Region::around(targets)]);
    let mut messages = Vec::new();
    for (rank, region) in regions.iter().enumerate().filter(|(rank, _)| *rank != comm.rank()) {
        let mut words: Vec<u64> = Vec::new();
        for (index, branch) in branches.iter().enumerate() {
            if let Some(part) = branch.as_ref().and_then(|branch| branch.part_for(region)) {
                words.extend([index as u64, part.nodes.len() as u64, part.sources.len() as u64]);
                words.extend_from_slice(bytemuck::cast_slice(&part.nodes));
                words.extend_from_slice(bytemuck::cast_slice(&part.sources));
            }
        }
        if !words.is_empty() {
            messages.push((rank, words));
        }
    }
    for (_, words) in comm.sparse_exchange(messages) {
        let mut rest = words.as_slice();
        while let [index, nodes, sources, after @ ..] = rest {
            let (nodes, after) = after.split_at(*nodes as usize * Node::WORDS);
            let (sources, after) = after.split_at(*sources as usize * SOURCE_WORDS);
            let nodes = bytemuck::cast_slice(nodes).to_vec();
            branches[*index as usize] = Some(Tree { nodes, sources: bytemuck::cast_slice(sources).to_vec() });
            rest = after;
        }
    }
}

/// The ends that are not yet part of the tree.
struct Ends<'a> {
    ends: &'a [Cell],
    heads: &'a [Node],
    branches: &'a [Option<Tree>],
}

impl Ends<'_> {
    /// Appends the cell with all ends in it; the next end lies in the cell.
    fn assemble(&mut self, lattice: &Lattice, cell: Cell, tree: &mut Tree) {
        if self.ends[0] == cell {
            match &self.branches[0] {
                Some(branch) => tree.graft(branch),
                None => tree.nodes.push(self.heads[0].closed()),
            }
            (self.ends, self.heads, self.branches) = (&self.ends[1..], &self.heads[1..], &self.branches[1..]);
            return;
        }
        tree.parent(lattice, cell, |tree| {
            for child in (0..8).map(|octant| cell.child(octant)) {
                if self.ends.first().is_some_and(|end| end.first_key() < child.end_key()) {
                    self.assemble(lattice, child, tree);
                }
            }
        });
    }
}
