//! The fast particles of a rank and its edge, between two large steps and within one.

use std::ops::Range;

use super::columns::{RateColumns, RateSettings, Received};
use super::group::Group;
use crate::pair::Rows;
use crate::particles::Columns;
use crate::particles::chunk::{CHUNK, chunk_range};
use crate::step::settings::Moment;

pub struct TwoRates {
    pub columns: RateColumns,
    /// Small steps in a large one, where the scene says how many.
    pub steps: Option<u32>,
    pub fast: Group,
    /// Slow particles with fast neighbours, as they were at the beginning of the step; their rows hold the fast ones alone.
    pub edge: Group,
    /// The edge at the moment of a small step; of its columns what it receives there.
    pub ahead: Columns,
    /// What each of the edge has received so far in the step, beside what the corrector will give it.
    received: Vec<Received>,
    /// Length of the last small step, s.
    pub small: f64,
    /// Whether lists have been built since it was decided which particles are fast.
    pub stale: bool,
}

impl TwoRates {
    pub fn new(columns: &Columns, settings: &RateSettings) -> Self {
        Self {
            columns: settings.columns.clone(),
            steps: settings.steps,
            fast: Group::new(columns),
            edge: Group::new(columns),
            ahead: columns.without_particles(),
            received: Vec::new(),
            small: 0.0,
            stale: false,
        }
    }

    /// Finds both groups. `marks`: of each slot, not zero where the particle is fast; the last is that of padding.
    pub fn group(&mut self, columns: &Columns, rows: &Rows, marks: &[f64]) {
        let padding = marks.len() as u32 - 1;
        let is_fast = |slot: u32| marks[slot as usize] != 0.0;
        self.fast.clear();
        self.edge.clear();
        for (i, ends) in rows.offsets.windows(2).enumerate() {
            let (slot, row) = (rows.slots[i], &rows.entries[ends[0]..ends[1]]);
            if is_fast(slot) {
                self.fast.add(i as u32, slot, row.iter().copied(), padding);
            } else if row.iter().any(|&slot| is_fast(slot)) {
                self.edge.add(i as u32, slot, row.iter().copied().filter(|&slot| is_fast(slot)), padding);
            }
        }
        self.copy(columns);
    }

    fn copy(&mut self, columns: &Columns) {
        self.fast.copy(columns);
        self.edge.copy(columns);
        self.ahead.copy_all(&self.edge.columns);
    }

    /// Begins a step of `dt` with a small one of `small`, s.
    pub fn begin(&mut self, columns: &Columns, dt: f64, small: f64) {
        self.copy(columns);
        let first = |k: usize| self.columns.received(&self.edge.columns, k).times(0.5 * (small - dt));
        self.received.clear();
        self.received.extend((0..self.edge.members.len()).map(first));
    }

    /// Counts what the edge has received at a small step over this time, s.
    pub fn receive(&mut self, over: f64) {
        for (k, received) in self.received.iter_mut().enumerate() {
            *received = received.plus(self.columns.received(&self.ahead, k).times(over));
        }
    }

    /// Ends the small steps but the last, of `small` s: what was received travels with the particles.
    pub fn hand_over(&mut self, columns: &mut Columns, small: f64) {
        self.small = small;
        for (&i, &received) in self.edge.members.iter().zip(&self.received) {
            self.columns.set_received(columns, i as usize, received);
        }
    }

    /// The moment of an evaluation of all particles as the last small step before it has it.
    pub fn last_of(&self, moment: &Moment) -> Moment {
        Moment { dt: self.small.min(moment.dt), since: self.small.min(moment.since), ..*moment }
    }

    /// The slow particles of each chunk in stretches; none where no particle is fast, and chunks are whole.
    pub fn slow_pieces(&self, count: usize) -> Option<Vec<Range<usize>>> {
        if self.fast.members.is_empty() {
            return None;
        }
        let mut fast = self.fast.members.iter().map(|&i| i as usize).peekable();
        let mut pieces = Vec::new();
        for chunk in 0..count.div_ceil(CHUNK) {
            let Range { mut start, end } = chunk_range(chunk, count);
            while let Some(i) = fast.next_if(|&i| i < end) {
                pieces.extend((i > start).then_some(start..i));
                start = i + 1;
            }
            pieces.extend((end > start).then_some(start..end));
        }
        Some(pieces)
    }
}
