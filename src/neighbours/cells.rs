//! Where the particles of a cell lie among the slots. Slots are sorted by level and along the curve, so the particles of one
//! level inside any cell of that level or a wider one are contiguous.

use crate::particles::cells::{CellTable, MAX_LEVEL};
use crate::particles::curve::Block;
use crate::particles::{Lattice, Place};

/// Ranges of slots by (level of the particles, level of the cell, cell).
#[derive(Debug, Default)]
pub struct CellIndex {
    /// Levels that hold particles, ascending.
    levels: Vec<u32>,
    /// For each of them, a table for each of them at or above it.
    tables: Vec<Vec<CellTable>>,
    runs: Vec<(u64, u32, u32)>,
}

impl CellIndex {
    /// `places`: of all slots, in order.
    pub fn build<const D: usize>(&mut self, places: &[Place]) {
        self.levels.clear();
        self.levels.extend((0..=MAX_LEVEL).filter(|l| places.binary_search_by_key(l, |p| p.level).is_ok()));
        self.tables.resize_with(self.levels.len(), Vec::new);
        let mut start = 0;
        for (nth, &level) in self.levels.iter().enumerate() {
            let end = start + places[start..].partition_point(|p| p.level == level);
            let (tables, runs) = (&mut self.tables[nth], &mut self.runs);
            tables.resize_with(self.levels.len() - nth, CellTable::default);
            runs.clear();
            let mut first = start;
            for cell in places[start..end].chunk_by(|a, b| a.cell == b.cell) {
                runs.push((cell[0].cell, first as u32, (first + cell.len()) as u32));
                first += cell.len();
            }
            let mut below = level;
            for (table, &above) in tables.iter_mut().zip(&self.levels[nth..]) {
                coarsen(runs, D as u32 * (above - below));
                below = above;
                table.reset(runs.len());
                for &(cell, start, end) in runs.iter() {
                    table.insert(cell, start, end);
                }
            }
            start = end;
        }
    }

    /// Calls `visit` with the ranges of slots that can hold neighbours of the particles in `cell` of `level`, in canonical
    /// order: by level of the neighbour, then by cell around, at the wider one of the two levels. Two particles within
    /// the larger of their list radii lie in cells of that level that touch.
    pub fn ranges_around<const D: usize>(&self, level: u32, cell: u64, mut visit: impl FnMut(std::ops::Range<usize>)) {
        // Ranges that follow each other are one.
        let mut open = 0..0;
        for (nth, &other) in self.levels.iter().enumerate() {
            let wider = level.max(other);
            let table = self.levels[nth..].binary_search(&wider).expect("the levels of all local particles are here");
            let centre = cell >> (D as u32 * (wider - level));
            for &code in Block::around::<D>(centre, Lattice::cells(wider)).codes() {
                if let Some((start, end)) = self.tables[nth][table].get(code) {
                    if open.end == start as usize {
                        open.end = end as usize;
                    } else {
                        visit(std::mem::replace(&mut open, start as usize..end as usize));
                    }
                }
            }
        }
        visit(open);
    }
}

/// Drops `bits` of each cell's code and joins the ranges that then share one.
fn coarsen(runs: &mut Vec<(u64, u32, u32)>, bits: u32) {
    runs.iter_mut().for_each(|run| run.0 >>= bits);
    runs.dedup_by(|next, run| {
        let same = next.0 == run.0;
        if same {
            run.2 = next.2;
        }
        same
    });
}
