//! Neighbour lists: for every owned particle the slots of all others nearer than the larger of the two list radii, in an
//! order that depends on the particles alone. A row is padded with the dummy slot to whole groups of eight lanes.

use std::ops::Range;

use rayon::prelude::*;

use super::cells::CellIndex;
use super::filter::{Candidates, Centre};
use super::stream;
use crate::math::lanes::{Width, width};
use crate::particles::large_pages::prefer_large_pages;
use crate::particles::{Local, ParticleId, Place};

/// Entries of a row come in groups of this many.
pub const LANES: usize = 8;

/// Rows a thread makes at a time: their entries stay in its cache until they are copied.
const BLOCK: usize = 512;

/// Bytes beyond which a list is not expected to stay in the caches from one step to the next.
const CACHES: usize = 16 << 20;

/// Rows of neighbours, by owned particle.
#[derive(Debug)]
pub struct NeighbourList<const D: usize> {
    /// Where each row begins in `entries`, and where the last one ends.
    pub offsets: Vec<usize>,
    /// Slots, by level, cell around and id; the dummy slot fills the last group.
    pub entries: Vec<u32>,
    /// Owned particles without a ghost in their row, ascending.
    pub interior: Vec<u32>,
    /// Owned particles with a ghost in their row, ascending.
    pub boundary: Vec<u32>,
    /// Directed pairs, padding not counted.
    pub pairs: u64,
    index: CellIndex,
    /// First row of every cell with owned particles.
    cells: Vec<u32>,
    blocks: Vec<Block<D>>,
    /// Whether each body is rigid: its particles are no neighbours of each other. Empty where none is.
    rigid: Vec<bool>,
}

/// What rows are made from.
struct Search<'a, const D: usize> {
    local: &'a Local<D>,
    index: &'a CellIndex,
    width: Width,
    rigid: &'a [bool],
}

/// The rows of a few cells, while they are made.
#[derive(Debug)]
struct Block<const D: usize> {
    candidates: Candidates<D>,
    entries: Vec<u32>,
    rows: Vec<Row>,
}

#[derive(Debug)]
struct Row {
    end: usize,
    neighbours: u32,
    boundary: bool,
}

impl<const D: usize> Default for NeighbourList<D> {
    fn default() -> Self {
        Self {
            offsets: vec![0],
            entries: Vec::new(),
            interior: Vec::new(),
            boundary: Vec::new(),
            pairs: 0,
            index: CellIndex::default(),
            cells: Vec::new(),
            blocks: Vec::new(),
            rigid: Vec::new(),
        }
    }
}

impl<const D: usize> NeighbourList<D> {
    /// A list for a scene with rigid bodies, where there are any.
    pub fn new(rigid: &[bool]) -> Self {
        Self { rigid: rigid.to_vec(), ..Self::default() }
    }

    /// The neighbours of owned particle `i`, padding included.
    #[inline]
    pub fn row(&self, i: usize) -> &[u32] {
        &self.entries[self.offsets[i]..self.offsets[i + 1]]
    }

    /// Makes the rows of all owned particles of `local`.
    pub fn build(&mut self, local: &Local<D>) {
        self.build_with(local, width());
    }

    /// Releases the memory; the next [`NeighbourList::build`] starts from nothing.
    pub fn forget(&mut self) {
        *self = Self::new(&std::mem::take(&mut self.rigid));
    }

    /// Bytes held, spare capacity included.
    pub fn bytes(&self) -> usize {
        let numbers =
            self.entries.capacity() + self.interior.capacity() + self.boundary.capacity() + self.cells.capacity();
        8 * self.offsets.capacity() + 4 * numbers
    }

    fn build_with(&mut self, local: &Local<D>, width: Width) {
        self.clear();
        self.index.build::<D>(&local.places);
        self.find_cells(local);
        let blocks = 4 * rayon::current_num_threads();
        self.blocks.resize_with(blocks, Block::default);
        let mut next = 0;
        while next + 1 < self.cells.len() {
            let mut ends = Vec::with_capacity(blocks);
            for _ in 0..blocks {
                let first = ends.last().map_or(next, |&(_, end)| end);
                ends.push((first, self.end_of_block(first)));
            }
            let cells = &self.cells;
            let search = Search { local, index: &self.index, width, rigid: &self.rigid };
            self.blocks.par_iter_mut().zip(&ends).for_each(|(block, &(first, end))| {
                block.clear();
                for rows in cells[first..end.max(first) + 1].windows(2) {
                    block.add_cell(&search, rows[0] as usize..rows[1] as usize);
                }
            });
            next = ends[blocks - 1].1;
            self.collect(local.owned());
        }
    }

    fn clear(&mut self) {
        self.offsets.clear();
        self.offsets.push(0);
        self.entries.clear();
        self.interior.clear();
        self.boundary.clear();
        self.pairs = 0;
    }

    fn find_cells(&mut self, local: &Local<D>) {
        let cell = |i: usize| {
            let Place { level, cell, .. } = local.places[local.slot_of_owned[i] as usize];
            (level, cell)
        };
        self.cells.clear();
        self.cells.extend((0..local.owned()).filter(|&i| i == 0 || cell(i - 1) != cell(i)).map(|i| i as u32));
        self.cells.push(local.owned() as u32);
    }

    /// The cells from `first` on that make up a block.
    fn end_of_block(&self, first: usize) -> usize {
        let last = self.cells.len() - 1;
        let rows = self.cells[first] as usize + BLOCK;
        (first + self.cells[first..].partition_point(|&row| (row as usize) < rows)).min(last)
    }

    /// Appends the blocks, in order. Lists are large: they grow to what all rows will need, not by doubling.
    fn collect(&mut self, owned: usize) {
        let added: usize = self.blocks.iter().map(|b| b.entries.len()).sum();
        let start = self.entries.len();
        let rows = self.offsets.len() - 1 + self.blocks.iter().map(|b| b.rows.len()).sum::<usize>();
        if start + added > self.entries.capacity() {
            let expected = (start + added) as f64 * owned as f64 / rows as f64 * 1.05;
            self.entries.reserve_exact((expected as usize).max(start + added) - start);
            prefer_large_pages(&self.entries);
        }
        let streamed = size_of::<u32>() * self.entries.capacity() > CACHES;
        let mut rest = &mut self.entries.spare_capacity_mut()[..added];
        let mut parts = Vec::with_capacity(self.blocks.len());
        let mut base = start;
        for block in &self.blocks {
            let (part, after) = rest.split_at_mut(block.entries.len());
            rest = after;
            parts.push((part, block));
            for row in &block.rows {
                let i = self.offsets.len() as u32 - 1;
                self.offsets.push(base + row.end);
                self.pairs += row.neighbours as u64;
                if row.boundary { self.boundary.push(i) } else { self.interior.push(i) }
            }
            base += block.entries.len();
        }
        parts.into_par_iter().for_each(|(part, block)| {
            // Lists that fit into the caches are better left there.
            if streamed {
                stream::copy(&block.entries, part);
            } else {
                part.iter_mut().zip(&block.entries).for_each(|(to, entry)| {
                    to.write(*entry);
                });
            }
        });
        // SAFETY: the parts, which are all written, make up the `added` entries behind `start`.
        unsafe { self.entries.set_len(start + added) };
    }
}

impl<const D: usize> Default for Block<D> {
    fn default() -> Self {
        Self { candidates: Candidates::default(), entries: Vec::new(), rows: Vec::new() }
    }
}

impl<const D: usize> Block<D> {
    fn clear(&mut self) {
        self.entries.clear();
        self.rows.clear();
    }

    /// Adds the rows of one cell: its candidates are the same for all of them.
    fn add_cell(&mut self, search: &Search<D>, rows: Range<usize>) {
        let &Search { local, index, width, rigid } = search;
        let Place { level, cell, .. } = local.places[local.slot_of_owned[rows.start] as usize];
        self.candidates.clear();
        index.ranges_around::<D>(level, cell, |slots| self.candidates.push(local, slots));
        let position = |slot: u32| std::array::from_fn(|d| local.position[d][slot as usize]);
        self.candidates.close(width, position(local.slot_of_owned[rows.start]));
        for &slot in &local.slot_of_owned[rows] {
            let start = self.entries.len();
            let centre = Centre { slot, position: position(slot), radius_squared: local.radius_squared[slot as usize] };
            self.candidates.filter(width, &centre, &mut self.entries);
            let body = |slot: u32| ParticleId(local.places[slot as usize].id).body();
            if rigid.get(body(slot)).is_some_and(|rigid| *rigid) {
                let others = drop_body(&mut self.entries[start..], body(slot), body);
                self.entries.truncate(start + others);
            }
            let row = &self.entries[start..];
            let neighbours = row.len();
            let boundary = self.candidates.ghosts && row.iter().any(|&j| local.is_ghost[j as usize]);
            self.entries.resize(start + neighbours.next_multiple_of(LANES), local.count as u32);
            self.rows.push(Row { end: self.entries.len(), neighbours: neighbours as u32, boundary });
        }
    }
}

/// Moves the entries of other bodies to the front, in their order, and returns how many these are.
fn drop_body(entries: &mut [u32], body: usize, body_of: impl Fn(u32) -> usize) -> usize {
    let mut kept = 0;
    for k in 0..entries.len() {
        if body_of(entries[k]) != body {
            entries[kept] = entries[k];
            kept += 1;
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::particles::{Lattice, Site};
    use crate::random::uniform;

    /// A cloud with list radii over three levels, pairs at the same place, and outliers beyond the lattice.
    fn cloud<const D: usize>(n: u64) -> (Lattice, Vec<Site<D>>) {
        let spread = 0.35 * (n as f64).powf(1.0 / D as f64);
        let mut sites: Vec<Site<D>> = (0..n)
            .map(|id| {
                let position = std::array::from_fn(|d| (uniform(1, id, d as u64) - 0.5) * spread);
                let radius = 0.5 * 4.0f64.powf(uniform(1, id, 7).powi(3)) + if id % 97 == 0 { 1.0 } else { 0.0 };
                Site { id: (id * 7919) % n, position, radius }
            })
            .collect();
        for k in (0..n as usize / 2).step_by(50) {
            sites[k + 1].position = sites[k].position;
        }
        for k in 0..8 {
            sites[k].position[0] = 1e7 + 0.2 * k as f64;
        }
        (Lattice::new(0.5), sites)
    }

    fn local<const D: usize>(lattice: &Lattice, owned: &[Site<D>], incoming: &[Site<D>]) -> Local<D> {
        let mut owned = owned.to_vec();
        owned.sort_by_key(|s| lattice.place(s));
        let mut local = Local::default();
        local.build(lattice, &owned, incoming);
        local
    }

    /// Rows as ids, padding checked and dropped, by id of the owner.
    fn rows<const D: usize>(list: &NeighbourList<D>, local: &Local<D>) -> Vec<(u64, Vec<u64>)> {
        let mut rows: Vec<_> = (0..local.owned())
            .map(|i| {
                let row = list.row(i);
                let real: Vec<u64> =
                    row.iter().filter(|&&j| j < local.count as u32).map(|&j| local.places[j as usize].id).collect();
                assert_eq!(row.len(), real.len().next_multiple_of(LANES));
                assert!(row[real.len()..].iter().all(|&j| j == local.count as u32), "padding is at the end");
                (local.places[local.slot_of_owned[i] as usize].id, real)
            })
            .collect();
        rows.sort();
        rows
    }

    fn near<const D: usize>(a: &Site<D>, b: &Site<D>) -> bool {
        let r_squared = (0..D).map(|d| (a.position[d] - b.position[d]).powi(2)).fold(0.0, |s, x| s + x);
        r_squared < a.radius.max(b.radius).powi(2)
    }

    fn against_brute_force<const D: usize>(n: u64) {
        let (lattice, sites) = cloud::<D>(n);
        let local = local(&lattice, &sites, &[]);
        assert!(local.places.last().unwrap().level >= 2, "the cloud spans three levels");
        let mut list = NeighbourList::default();
        list.build(&local);
        let mut pairs = 0;
        for (id, mut row) in rows(&list, &local) {
            let me = sites.iter().find(|s| s.id == id).unwrap();
            let mut expected: Vec<u64> = sites.iter().filter(|s| s.id != id && near(me, s)).map(|s| s.id).collect();
            pairs += row.len() as u64;
            expected.sort();
            row.sort();
            assert_eq!(row, expected, "particle {id}");
        }
        assert_eq!(list.pairs, pairs);
        assert!(pairs > 10 * n && list.boundary.is_empty() && list.interior.len() == n as usize);
    }

    #[test]
    fn rows_hold_every_neighbour_3d() {
        against_brute_force::<3>(3000);
    }

    #[test]
    fn rows_hold_every_neighbour_2d() {
        against_brute_force::<2>(2000);
    }

    #[test]
    fn all_widths_make_the_same_list() {
        let (lattice, sites) = cloud::<3>(5000);
        let local = local(&lattice, &sites, &[]);
        let build = |width| {
            let mut list = NeighbourList::default();
            list.build_with(&local, width);
            (list.offsets, list.entries)
        };
        let portable = build(Width::Portable);
        for (width, available) in
            [(Width::Avx2, is_x86_feature_detected!("avx2")), (Width::Avx512, is_x86_feature_detected!("avx512f"))]
        {
            if available {
                assert!(build(width) == portable, "{width:?}");
            } else {
                println!("skipped: this processor has no {width:?}");
            }
        }
    }

    /// Rows and their order are the same whichever part of the cloud is owned and whatever else is a ghost.
    fn rows_do_not_depend_on_parts<const D: usize>(n: u64) {
        let (lattice, sites) = cloud::<D>(n);
        let mut list = NeighbourList::default();
        let whole = local(&lattice, &sites, &[]);
        list.build(&whole);
        let expected = rows(&list, &whole);
        let mut found = Vec::new();
        for part in 0..5 {
            let owned: Vec<_> =
                sites.iter().filter(|s| (0..5).find(|&p| is_part(s, p, n)) == Some(part)).copied().collect();
            let ghosts: Vec<_> = sites
                .iter()
                .filter(|s| !owned.iter().any(|o| o.id == s.id))
                .filter(|s| s.id % 3 == part % 3 || owned.iter().any(|o| near(o, s)))
                .copied()
                .collect();
            let local = local(&lattice, &owned, &ghosts);
            list.build(&local);
            for &i in &list.interior {
                assert!(!list.row(i as usize).iter().any(|&j| j < local.count as u32 && local.is_ghost[j as usize]));
            }
            for &i in &list.boundary {
                assert!(list.row(i as usize).iter().any(|&j| j < local.count as u32 && local.is_ghost[j as usize]));
            }
            assert_eq!(list.interior.len() + list.boundary.len(), owned.len());
            found.extend(rows(&list, &local));
        }
        found.sort();
        assert!(found == expected);
    }

    /// Slabs along x, and one scattered part.
    fn is_part<const D: usize>(site: &Site<D>, part: u64, n: u64) -> bool {
        match part {
            0 => site.id % 11 == 0,
            4 => true,
            _ => site.position[0] < (part as f64 - 2.0) * 0.06 * (n as f64).powf(1.0 / D as f64),
        }
    }

    #[test]
    fn rows_do_not_depend_on_parts_3d() {
        rows_do_not_depend_on_parts::<3>(3000);
    }

    #[test]
    fn rows_do_not_depend_on_parts_2d() {
        rows_do_not_depend_on_parts::<2>(2000);
    }

    #[test]
    fn an_empty_rank_has_an_empty_list() {
        let (lattice, sites) = cloud::<3>(100);
        let mut list = NeighbourList::default();
        list.build(&local(&lattice, &[], &sites));
        assert_eq!((list.offsets.as_slice(), list.entries.len(), list.pairs), ([0].as_slice(), 0, 0));
    }
}
