//! New lists, and records for them.

use std::time::Instant;

use super::Stepper;
use super::buffers::Line;
use super::neighbourhood::Load;
use super::phases::Phase;
use crate::pair::Rows;
use crate::particles::chunk::CHUNK;
use crate::particles::large_pages;

impl<const D: usize> Stepper<'_, D> {
    /// Gives the memory of lists and records back, for work that needs its own. The next step makes them anew from the
    /// positions of the last build: nothing changes.
    pub fn release_buffers(&mut self) {
        self.neighbourhood.forget_list();
        self.buffers.records = Vec::new();
        self.buffers.released = true;
    }

    pub(super) fn rebuild_released(&mut self) {
        if self.buffers.released {
            self.rebuild(false);
        }
    }

    /// What the last evaluation read; none where it was given back.
    pub(super) fn rows(&self) -> Option<Rows<'_>> {
        (!self.buffers.released).then(|| self.rows_now())
    }

    fn rows_now(&self) -> Rows<'_> {
        let list = &self.neighbourhood.list;
        Rows {
            records: bytemuck::cast_slice(&self.buffers.records),
            offsets: &list.offsets,
            entries: &list.entries,
            slots: &self.neighbourhood.local().slot_of_owned,
        }
    }

    /// Packs the records of all particles, `since` seconds after the last evaluation.
    pub(super) fn pack(&mut self, since: f64) {
        let records = self.buffers.writer();
        let (columns, packer, buffers) = (&self.columns, &self.settings.packer, &self.buffers);
        let slots = &self.neighbourhood.local().slot_of_owned;
        self.workers.each(&buffers.all, |chunk, _| {
            // SAFETY: there is a record for every local particle, and no two particles share one.
            unsafe { packer.pack(columns, buffers.range(chunk, columns.len()), since, slots, records.start()) };
        });
    }

    pub(super) fn find_chunks(&mut self) {
        self.buffers.pieces = None;
        self.buffers.all.clear();
        self.buffers.all.extend(0..self.columns.len().div_ceil(CHUNK) as u32);
    }

    /// New lists; `fresh` from the present positions, otherwise from those of the last build.
    pub(super) fn rebuild(&mut self, fresh: bool) {
        self.buffers.released = false;
        let start = Instant::now();
        if fresh {
            let age = std::mem::take(&mut self.state.list_age);
            self.neighbourhood.start_afresh(&mut self.columns, &self.settings, age, self.comm);
            let (steps, small_steps) = (self.coming(), self.small_steps_made());
            let load = Load { phases: &self.phases, steps, small_steps };
            let rebisected = self.neighbourhood.balance(&self.columns, &load, self.comm);
            self.counters.list_builds += 1;
            self.counters.rebisections += rebisected as u64;
        }
        self.neighbourhood.distribute(&mut self.columns, &self.settings, self.comm);
        self.counters.migrated += self.neighbourhood.migrated() as u64;
        self.phases.add(Phase::Migration, start);
        let start = Instant::now();
        self.neighbourhood.build_list(&mut self.columns, &self.settings);
        self.phases.add(Phase::Lists, start);
        self.group(fresh);
        self.sort_chunks();
        let layout = *self.settings.pair_loop.layout();
        let lines = layout.stride() / 8;
        let needed = (self.neighbourhood.local().count + 1) * lines;
        if self.buffers.records.capacity() < needed {
            // The old ones are not read again.
            self.buffers.records = large_pages::with_capacity(needed);
        }
        self.buffers.records.resize(needed, Line([0.0; 8]));
        let padding = self.neighbourhood.local().count * layout.stride();
        layout.padding(
            &mut bytemuck::cast_slice_mut::<Line, f64>(&mut self.buffers.records)[padding..padding + layout.stride()],
        );
    }

    /// The chunks (or what of them is slow), with and without ghosts in their rows.
    pub(super) fn sort_chunks(&mut self) {
        self.find_chunks();
        self.leave_out_fast();
        let (count, buffers) = (self.columns.len(), &mut self.buffers);
        buffers.interior.clear();
        buffers.boundary.clear();
        let mut rest = self.neighbourhood.list.boundary.iter().peekable();
        for k in 0..buffers.all.len() {
            let chunk = buffers.all[k];
            let range = buffers.range(chunk as usize, count);
            let mut with_ghosts = false;
            while rest.next_if(|row| (**row as usize) < range.end).is_some() {
                with_ghosts = true;
            }
            if with_ghosts { buffers.boundary.push(chunk) } else { buffers.interior.push(chunk) }
        }
    }
}
