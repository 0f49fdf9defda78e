//! The field of bodies of many ranks, at all of them: which rank builds which branch of the tree, which parts of it are sent, and
//! how results return to the owners.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};
use rayon::prelude::*;

use super::bodies::Bodies;
use super::cells::{Cell, Root, key_within};
use super::expansions::row;
use super::octree::{Body, LEAF, Node, Octree};
use super::opening::{Openers, Opening, distance2};
use super::top::{Parcels, find_ends, find_owners, within};
use super::walk;
use crate::domain::comm::{Comm, now};
use crate::gravity::G;

/// Words of a body in a message.
const BODY_WORDS: usize = std::mem::size_of::<Body>() / 8;
/// Words of a body of a tree in a message: position, mass, softening.
const TREE_BODY_WORDS: usize = 5;
/// Words of a result in a message.
const FIELD_WORDS: usize = std::mem::size_of::<Field>() / 8;

/// The gravitational field at a body.
#[derive(Debug, Clone, Copy, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Field {
    /// m/s^2.
    pub acceleration: [f64; 3],
    /// J/kg.
    pub potential: f64,
}

/// The field of all bodies of all ranks at each of this rank's, itself left out; all in SI units. Collective.
pub fn solve(comm: &Comm, bodies: &[Body], opening: &Opening) -> Vec<Field> {
    now(solve_later(comm, bodies, opening))
}

/// [`solve`] as a part of work that overlaps.
pub async fn solve_later(comm: &Comm, bodies: &[Body], opening: &Opening) -> Vec<Field> {
    let root = Root::around(comm, bodies.iter().map(|body| &body.position)).await;
    let keyed = in_order(&root, bodies);
    let ends = find_ends(comm, &keyed, LEAF as i64).await;
    let owners = find_owners(comm, &ends, &keyed).await;

    let mut parcels = Parcels::default();
    let mut sent: Vec<(usize, Vec<u32>)> = Vec::new();
    for (&end, &owner) in ends.iter().zip(&owners) {
        let parcel = parcels.to(owner);
        let numbers = match sent.iter_mut().find(|(to, _)| *to == owner) {
            Some((_, numbers)) => numbers,
            None => {
                sent.push((owner, Vec::new()));
                &mut sent.last_mut().expect("just pushed").1
            }
        };
        for &(_, number) in within(end, &keyed) {
            parcel.extend_from_slice(bytemuck::cast_slice(std::slice::from_ref(&scaled(
                &root,
                &bodies[number as usize],
            ))));
            numbers.push(number);
        }
    }
    let received = comm.sparse_exchange_later(parcels.0).await;
    let arrived = Arrived::new(&received);
    let tree = Forest { comm, opening, ends: &ends, owners: &owners }.tree(&arrived.sorted).await;
    let sums = walk::fields(&tree.octree, opening, &|node| tree.own[node]);
    drop(tree);

    // Back to where they came from, in the order in which they came.
    let mut replies: Vec<(usize, Vec<u64>)> =
        received.iter().map(|(from, words)| (*from, vec![0; words.len() / BODY_WORDS * FIELD_WORDS])).collect();
    for (&(message, place), sums) in arrived.origins.iter().zip(&sums) {
        let field = si(&root, sums);
        let words = &mut replies[message as usize].1[place as usize * FIELD_WORDS..][..FIELD_WORDS];
        words.copy_from_slice(bytemuck::cast_slice(std::slice::from_ref(&field)));
    }
    let mut fields = vec![Field::default(); bodies.len()];
    for (owner, words) in comm.sparse_exchange_later(replies).await {
        let numbers = sent.iter().find(|(to, _)| *to == owner).map_or(&[][..], |(_, numbers)| numbers);
        for (&number, words) in numbers.iter().zip(words.chunks_exact(FIELD_WORDS)) {
            fields[number as usize] = bytemuck::pod_read_unaligned(bytemuck::cast_slice(words));
        }
    }
    fields
}

/// Keys and indices of bodies in canonical order: along the curve, by id within a deepest cell.
fn in_order(root: &Root, bodies: &[Body]) -> Vec<(u64, u32)> {
    let mut keyed: Vec<(u64, u32)> =
        bodies.iter().zip(0..).map(|(body, number)| (root.key(&body.position), number)).collect();
    keyed.sort_unstable_by_key(|&(key, number)| (key, bodies[number as usize].id));
    keyed
}

/// A body in units of the tree: sides of the root cube, kg, and accelerations over G.
fn scaled(root: &Root, body: &Body) -> Body {
    let side = root.side();
    Body {
        position: root.within(&body.position),
        softening: body.softening / side,
        acceleration: body.acceleration * side * side / G,
        ..*body
    }
}

fn si(root: &Root, sums: &[f64; 4]) -> Field {
    let (potential, acceleration) = (G / root.side(), G / (root.side() * root.side()));
    Field {
        acceleration: [sums[0] * acceleration, sums[1] * acceleration, sums[2] * acceleration],
        potential: -sums[3] * potential,
    }
}

/// The bodies of this rank's branches in canonical order, and where each came from: message, and place in it.
struct Arrived {
    sorted: Vec<(u64, Body)>,
    origins: Vec<(u32, u32)>,
}

impl Arrived {
    fn new(received: &[(usize, Vec<u64>)]) -> Self {
        let messages = received.iter().zip(0u32..);
        let mut all: Vec<(u64, Body, (u32, u32))> = messages
            .flat_map(|((_, words), message)| {
                words.chunks_exact(BODY_WORDS).zip(0u32..).map(move |(words, place)| {
                    let body: Body = bytemuck::pod_read_unaligned(bytemuck::cast_slice(words));
                    (key_within(&body.position), body, (message, place))
                })
            })
            .collect();
        if received.len() > 1 {
            // Messages are in order already.
            all.sort_by_key(|(key, body, _)| (*key, body.id));
        }
        Self {
            sorted: all.iter().map(|(key, body, _)| (*key, *body)).collect(),
            origins: all.iter().map(|(_, _, origin)| *origin).collect(),
        }
    }
}

/// The branches of all ranks.
struct Forest<'a> {
    comm: &'a Comm,
    opening: &'a Opening,
    ends: &'a [Cell],
    owners: &'a [usize],
}

/// A tree as far as this rank's branches need it.
#[derive(Default)]
struct Shared {
    octree: Octree,
    /// Whether a node holds bodies of this rank's branches.
    own: Vec<bool>,
    /// Nodes above the branches, with the numbers of these.
    top: Vec<(usize, Range<usize>)>,
}

/// The first node of a branch with its row, and which sources its cells may open.
struct Head {
    node: Node,
    row: Vec<f64>,
    openers: Openers,
}

impl Forest<'_> {
    async fn tree(&self, sorted: &[(u64, Body)]) -> Shared {
        let (order, me) = (self.opening.order, self.comm.rank());
        let grow =
            |(&end, &owner): (&Cell, &usize)| (owner == me).then(|| Octree::branch(order, end, within(end, sorted)));
        let mut branches: Vec<Option<Octree>> = self.ends.par_iter().zip(self.owners).map(grow).collect();
        let heads = self.share_heads(&branches).await;
        self.receive_parts(&mut branches, &heads).await;
        self.assembled(&branches, &heads)
    }

    fn assembled(&self, branches: &[Option<Octree>], heads: &[Head]) -> Shared {
        let mut shared = Shared { octree: Octree::new(self.opening.order), ..Shared::default() };
        if !self.ends.is_empty() {
            let mut next = 0;
            self.assemble(Cell::ROOT, &mut next, branches, heads, &mut shared);
        }
        shared
    }

    /// The heads of all branches, on all ranks: one rank has each and the others add zeros to its bits.
    async fn share_heads(&self, branches: &[Option<Octree>]) -> Vec<Head> {
        let order = self.opening.order;
        let mut words: Vec<i64> = Vec::new();
        let width = Node::WORDS + row(order) + Openers::WORDS;
        for branch in branches {
            match branch {
                Some(branch) => {
                    words.extend_from_slice(bytemuck::cast_slice(&branch.nodes[..1]));
                    words.extend_from_slice(bytemuck::cast_slice(branch.row(0)));
                    words.extend_from_slice(bytemuck::cast_slice(&[Openers::of(branch)]));
                }
                None => words.resize(words.len() + width, 0),
            }
        }
        let words = self.comm.all_sum_later(words).await;
        let head = |words: &[i64]| Head {
            node: bytemuck::pod_read_unaligned(bytemuck::cast_slice(&words[..Node::WORDS])),
            row: bytemuck::cast_slice(&words[Node::WORDS..Node::WORDS + row(order)]).to_vec(),
            openers: bytemuck::pod_read_unaligned(bytemuck::cast_slice(&words[Node::WORDS + row(order)..])),
        };
        words.chunks_exact(width).map(head).collect()
    }

    /// Sends each rank the parts of this rank's branches that cells of its own can open, and puts those that come into
    /// `branches`.
    async fn receive_parts(&self, branches: &mut [Option<Octree>], heads: &[Head]) {
        let me = self.comm.rank();
        if self.comm.size() == 1 {
            return;
        }
        let closed: Vec<Option<Octree>> = heads.iter().map(|_| None).collect();
        let above = self.assembled(&closed, heads);
        let mut messages = Vec::new();
        for rank in (0..self.comm.size()).filter(|&rank| rank != me) {
            let theirs: Vec<usize> = (0..heads.len()).filter(|&k| self.owners[k] == rank).collect();
            // Cells above branches open others of their level, too.
            let holds = |(_, ends): &&(usize, Range<usize>)| self.owners[ends.clone()].contains(&rank);
            let tops: Vec<&Node> = above.top.iter().filter(holds).map(|(top, _)| &above.octree.nodes[*top]).collect();
            let is_far = |node: &Node| {
                let sees_as_one = |top: &&Node| {
                    let r2 = distance2(&top.centre, &node.centre);
                    top.level < node.level || self.opening.is_far(r2, &top.side, &node.side)
                };
                node.side.mass == 0.0
                    || theirs.iter().all(|&k| heads[k].openers.see_as_one(self.ends[k], node, self.opening))
                        && tops.iter().all(sees_as_one)
            };
            let mut words: Vec<u64> = Vec::new();
            for (index, branch) in branches.iter().enumerate() {
                let Some(branch) = branch else { continue };
                if !is_far(&branch.nodes[0]) {
                    let mut part = Octree::new(self.opening.order);
                    branch.copy_part(0, &is_far, &mut part);
                    write_part(index, &part, &mut words);
                }
            }
            if !words.is_empty() {
                messages.push((rank, words));
            }
        }
        for (_, words) in self.comm.sparse_exchange_later(messages).await {
            let mut rest = words.as_slice();
            while let [index, nodes, bodies, after @ ..] = rest {
                let (part, after) = read_part(self.opening.order, *nodes as usize, *bodies as usize, after);
                branches[*index as usize] = Some(part);
                rest = after;
            }
        }
    }

    /// Appends the cell with all ends in it, of which `next` is the first.
    fn assemble(&self, cell: Cell, next: &mut usize, branches: &[Option<Octree>], heads: &[Head], shared: &mut Shared) {
        if self.ends[*next] == cell {
            match &branches[*next] {
                Some(branch) => shared.octree.graft(branch),
                None => shared.octree.push_closed(heads[*next].node, &heads[*next].row),
            }
            shared.own.resize(shared.octree.nodes.len(), self.owners[*next] == self.comm.rank());
            *next += 1;
            return;
        }
        let (node, first) = (shared.octree.begin(cell), *next);
        shared.own.push(false);
        for child in (0..8).map(|octant| cell.child(octant)) {
            if self.ends.get(*next).is_some_and(|end| end.first_key() < child.end_key()) {
                self.assemble(child, next, branches, heads, shared);
            }
        }
        shared.octree.finish(node, cell);
        shared.octree.nodes[node].kind = Node::TOP;
        shared.top.push((node, first..*next));
        shared.own[node] = shared.octree.children(node).any(|child| shared.own[child]);
    }
}

fn write_part(index: usize, part: &Octree, words: &mut Vec<u64>) {
    words.extend([index as u64, part.nodes.len() as u64, part.bodies.count() as u64]);
    words.extend_from_slice(bytemuck::cast_slice(&part.nodes));
    words.extend_from_slice(bytemuck::cast_slice(&part.rows));
    let Bodies { position: [x, y, z], mass, softening, .. } = &part.bodies;
    for numbers in [x, y, z, mass, softening] {
        words.extend_from_slice(bytemuck::cast_slice(numbers));
    }
}

/// The part at the beginning of `words`, and what follows it.
fn read_part(order: usize, nodes: usize, bodies: usize, words: &[u64]) -> (Octree, &[u64]) {
    let (its_nodes, rest) = words.split_at(nodes * Node::WORDS);
    let (rows, rest) = rest.split_at(nodes * row(order));
    let (numbers, rest) = rest.split_at(bodies * TREE_BODY_WORDS);
    let mut part = Octree::new(order);
    part.nodes.extend_from_slice(bytemuck::cast_slice(its_nodes));
    part.rows.extend_from_slice(bytemuck::cast_slice(rows));
    let numbers: &[f64] = bytemuck::cast_slice(numbers);
    for i in 0..bodies {
        let [x, y, z, mass, softening] = std::array::from_fn(|k| numbers[k * bodies + i]);
        part.bodies.push(&[x, y, z], mass, softening);
    }
    (part, rest)
}
