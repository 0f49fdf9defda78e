//! The top of the tree, which all ranks know: down to cells that one rank each builds, with all of their bodies.

use super::cells::{Cell, DEEPEST};
use crate::domain::comm::Comm;

/// Branches aimed at per rank: enough for their surfaces to follow those of the ranks' domains.
const BRANCHES_PER_RANK: u64 = 32;

/// The entries of a cell, from a list sorted by key.
pub fn within<T>(cell: Cell, keyed: &[(u64, T)]) -> &[(u64, T)] {
    let begin = keyed.partition_point(|(key, _)| *key < cell.first_key());
    let end = keyed.partition_point(|(key, _)| *key < cell.end_key());
    &keyed[begin..end]
}

/// The ends of the top, along the curve: cells with bodies that are not split, being leaves, or are small enough for one rank.
pub async fn find_ends<T>(comm: &Comm, keyed: &[(u64, T)], leaf: i64) -> Vec<Cell> {
    let total = comm.all_sum_later(vec![keyed.len() as i64]).await;
    let enough = leaf.max(total[0] / (BRANCHES_PER_RANK * comm.size() as u64) as i64);
    let (mut frontier, mut ends) = (vec![Cell::ROOT], Vec::new());
    while !frontier.is_empty() {
        let counts = frontier.iter().map(|&cell| within(cell, keyed).len() as i64).collect();
        let counts = comm.all_sum_later(counts).await;
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

/// Each branch goes to the rank that holds most of it, the lowest of several, so that little has to be sent.
pub async fn find_owners<T>(comm: &Comm, ends: &[Cell], keyed: &[(u64, T)]) -> Vec<usize> {
    let size = comm.size() as f64;
    let claim = |&end: &Cell| within(end, keyed).len() as f64 * size + (size - 1.0 - comm.rank() as f64);
    let claims = comm.all_max_later(ends.iter().map(claim).collect()).await;
    claims.iter().map(|claim| comm.size() - 1 - (claim % size) as usize).collect()
}

/// Messages to be sent, one per rank, in the order in which ranks were first addressed.
#[derive(Default)]
pub struct Parcels(pub Vec<(usize, Vec<u64>)>);

impl Parcels {
    pub fn to(&mut self, rank: usize) -> &mut Vec<u64> {
        let index = self.0.iter().rposition(|(to, _)| *to == rank).unwrap_or_else(|| {
            self.0.push((rank, Vec::new()));
            self.0.len() - 1
        });
        &mut self.0[index].1
    }
}
