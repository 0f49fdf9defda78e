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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::declare_core;
    use crate::math::Vec3;
    use crate::particles::Registry;

    /// A row of particles, each with its neighbours on both sides, of which every tenth is fast.
    fn row(count: usize) -> (Columns, TwoRates) {
        let mut registry = Registry::new(2);
        declare_core(&mut registry);
        let columns = RateColumns::declare(&mut registry);
        let settings = RateSettings { bodies: vec![true], steps: None, columns };
        let mut particles = Columns::new(registry);
        particles.resize(count);
        let mut rates = TwoRates::new(&particles, &settings);
        let padding = count as u32;
        let mut entries = Vec::new();
        for i in 0..padding {
            let beside = [i.wrapping_sub(1), i + 1];
            let mut eight = [padding; 8];
            eight.iter_mut().zip(beside.iter().filter(|&&j| j < padding)).for_each(|(to, &j)| *to = j);
            entries.extend(eight);
        }
        let offsets: Vec<usize> = (0..=count).map(|i| 8 * i).collect();
        let slots: Vec<u32> = (0..padding).collect();
        let mut marks: Vec<f64> = (0..count).map(|i| f64::from(i % 10 == 0)).collect();
        marks.push(0.0);
        rates.group(&particles, &Rows { records: &[], offsets: &offsets, entries: &entries, slots: &slots }, &marks);
        (particles, rates)
    }

    #[test]
    fn groups_hold_what_is_fast_and_what_is_beside_it() {
        let (_, rates) = row(600);
        assert!(rates.fast.members.iter().copied().eq((0..600).step_by(10)));
        assert!(rates.edge.members.iter().copied().eq((0..599).filter(|i| matches!(i % 10, 1 | 9))));
        // A fast one has all of its neighbours, one of the edge the fast one alone.
        let rows = rates.fast.lists.rows(&[]);
        assert_eq!(rows.entries[8..11], [9, 11, 600]);
        let rows = rates.edge.lists.rows(&[]);
        assert_eq!((rows.slots[1], &rows.entries[8..10]), (9, &[10, 600][..]));
        let pieces = rates.slow_pieces(600).expect("some are fast");
        assert_eq!(pieces[..2], [1..10, 11..20]);
        assert!(pieces.contains(&(251..256)) && pieces.contains(&(256..260)), "chunks are cut, not joined");
        assert_eq!(pieces.iter().map(|piece| piece.len()).sum::<usize>(), 540);
        assert_eq!(row(0).1.slow_pieces(0), None);
    }

    /// The weights of a step: what the corrector gives, dt/2 at both ends, and these make those of the small steps.
    #[test]
    fn weights_make_up_for_those_of_the_large_step() {
        let (mut particles, mut rates) = row(20);
        let one = Received { motion: Vec3::new(1.0, 0.0, 0.0), heat: 0.0 };
        rates.edge.members.clone().iter().for_each(|&i| rates.columns.set_received(&mut particles, i as usize, one));
        let (dt, small) = (1.0, 0.25);
        rates.begin(&particles, dt, small);
        for k in 0..rates.ahead.len() {
            let columns = rates.columns.clone();
            columns.set_received(&mut rates.ahead, k, one);
        }
        (0..3).for_each(|_| rates.receive(small));
        rates.hand_over(&mut particles, small);
        let so_far = rates.columns.received(&particles, 1).motion.x;
        // The whole of an even push is that of the corrector.
        assert_eq!(so_far + 0.5 * (rates.small - dt), 0.0);
        assert_eq!(rates.columns.received(&particles, 5), Received::default());
    }
}
