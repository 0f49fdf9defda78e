//! Particles of a rank that are worked on apart from the others: copies of them, one beside the other, and rows of neighbours for them.

use std::ops::Range;

use crate::neighbours::list::LANES;
use crate::pair::Rows;
use crate::particles::Columns;

/// Members that a thread takes at a time: a group is small, and all threads are to have some of it.
const STRETCH: usize = 64;

pub struct Group {
    /// Owned particles, ascending.
    pub members: Vec<u32>,
    /// Copies of them.
    pub columns: Columns,
    pub lists: GroupLists,
}

/// What the members of a group sum over.
pub struct GroupLists {
    /// Slot of each member.
    pub slots: Vec<u32>,
    /// Numbers of the stretches of members.
    pub stretches: Vec<u32>,
    offsets: Vec<usize>,
    entries: Vec<u32>,
}

impl Group {
    /// An empty group of such particles.
    pub fn new(columns: &Columns) -> Self {
        let lists = GroupLists { slots: Vec::new(), stretches: Vec::new(), offsets: vec![0], entries: Vec::new() };
        Self { members: Vec::new(), columns: columns.without_particles(), lists }
    }

    pub fn clear(&mut self) {
        self.members.clear();
        let GroupLists { slots, stretches, offsets, entries } = &mut self.lists;
        slots.clear();
        stretches.clear();
        offsets.truncate(1);
        entries.clear();
    }

    /// Adds a particle with its slot and the slots of its neighbours; `padding` fills the last lanes.
    pub fn add(&mut self, member: u32, slot: u32, row: impl Iterator<Item = u32>, padding: u32) {
        let GroupLists { slots, stretches, offsets, entries } = &mut self.lists;
        if self.members.len().is_multiple_of(STRETCH) {
            stretches.push(stretches.len() as u32);
        }
        self.members.push(member);
        slots.push(slot);
        entries.extend(row);
        entries.resize(entries.len().next_multiple_of(LANES), padding);
        offsets.push(entries.len());
    }

    /// Copies the particles anew.
    pub fn copy(&mut self, columns: &Columns) {
        self.columns.copy_of(columns, &self.members);
    }
}

impl GroupLists {
    pub fn rows<'a>(&'a self, records: &'a [f64]) -> Rows<'a> {
        Rows { records, offsets: &self.offsets, entries: &self.entries, slots: &self.slots }
    }

    /// Entries of all rows.
    pub fn entries(&self) -> usize {
        self.entries.len()
    }

    /// The members of a stretch.
    pub fn range(&self, stretch: usize) -> Range<usize> {
        stretch * STRETCH..((stretch + 1) * STRETCH).min(self.slots.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::declare_core;
    use crate::math::Vec3;
    use crate::particles::{ParticleId, Registry};

    #[test]
    fn members_are_copied_out_and_back() {
        let mut registry = Registry::new(3);
        let core = declare_core(&mut registry);
        let mut columns = Columns::new(registry);
        columns.resize(200);
        for i in 0..200 {
            columns.set(core.id, i, ParticleId(i as u64));
            columns.set(core.position, i, Vec3::new(i as f64, 0.0, -1.0));
        }
        let mut group = Group::new(&columns);
        for i in (0..200).filter(|i| i % 2 == 1) {
            group.add(i, 10 * i, [i, i + 1].into_iter(), 999);
        }
        group.copy(&columns);
        assert_eq!((group.columns.len(), group.lists.stretches.len()), (100, 2));
        assert_eq!(group.lists.range(1), 64..100);
        let rows = group.lists.rows(&[]);
        assert_eq!(rows.entries[rows.offsets[3]..rows.offsets[4]], [7, 8, 999, 999, 999, 999, 999, 999]);
        for k in 0..100 {
            let x = group.columns.get(core.position, k);
            assert_eq!(x.x, (2 * k + 1) as f64);
            group.columns.set(core.position, k, -x);
        }
        group.columns.write_back(&mut columns, &group.members);
        for i in 0..200 {
            let sign = if i % 2 == 1 { -1.0 } else { 1.0 };
            assert_eq!(columns.get(core.position, i), Vec3::new(i as f64, 0.0, -1.0) * sign);
        }
        group.clear();
        group.copy(&columns);
        assert_eq!((group.columns.len(), group.lists.rows(&[]).offsets.len()), (0, 1));
    }
}
