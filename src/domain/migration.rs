//! Particles whose owner has changed go straight to their new owner, with all their columns.

use super::bisection::Bisection;
use super::comm::Comm;
use crate::math::Vec3;
use crate::particles::{Column, Columns};

/// Sends every particle to the owner of its `position`; returns how many left this rank. Those that stay keep their order,
/// those that come follow by rank. Collective.
pub fn migrate<const D: usize>(
    columns: &mut Columns,
    position: Column<Vec3>,
    bisection: &Bisection<D>,
    comm: &Comm,
) -> usize {
    if bisection.parts() == 1 {
        // Every particle is on its owner.
        return 0;
    }
    let mut stay = Vec::with_capacity(columns.len());
    let mut leave: Vec<(usize, u32)> = Vec::new();
    for (place, i) in columns.numbers(position.index).as_chunks::<D>().0.iter().zip(0..) {
        match bisection.owner(place) {
            owner if owner == comm.rank() => stay.push(i),
            owner => leave.push((owner, i)),
        }
    }
    leave.sort_unstable();
    let messages = leave
        .chunk_by(|a, b| a.0 == b.0)
        .map(|group| {
            let mut message = Vec::with_capacity(group.len() * columns.particle_words());
            group.iter().for_each(|&(_, i)| columns.write_particle(i as usize, &mut message));
            (group[0].0, message)
        })
        .collect();
    if !leave.is_empty() {
        columns.reorder(&stay, &mut Vec::new());
    }
    for (_, message) in comm.sparse_exchange(messages) {
        columns.append(&message);
    }
    leave.len()
}
