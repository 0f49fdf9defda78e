//! Decides when neighbour lists must be built again: when two particles that were not neighbours at the last build may have come
//! within their supports. What counts is how far particles have moved *relative to each other* since then, with displacements
//! d = x - x_build, list radii L (support and skin at the build) and supports s = 2h (now).
//!
//! At each level l of the lattice, over the 3^D cells around any cell near particles:
//!
//! ```text
//! | max d - min d |  <=  min( min over particles of level l of (L - s),   R - max over particles of finer levels of s )
//! R = the smallest L of the particles of level l there, or the cells' side where there are none
//! ```
//! and half of that in the latter case, see [`closing`](super::closing).
//!
//! Why this is enough. Two particles, the wider of whose levels is c, that were not listed were at least max(L_i, L_j) apart.
//! If their cells of level c lie at most two apart, some block of 3^D cells holds both, and the line above bounds how much
//! nearer they have come. If not, at least two sides of level c were between them; look at the next level, where one side
//! is as wide: either a block there holds both, and R is its side, or at least two of its sides were between them, and so on.
//! Beyond `ABOVE` levels over the widest occupied one, it is enough that no particle has moved by more than half a side.
//!
//! Along periodic axes a period is a whole number of cells at every level that particles live in, and blocks wrap
//! around. Wider levels would not fit, so nothing above the widest occupied one is watched: two sides of it are between
//! particles that no block holds, and it is enough that none has moved by more than half a side.
//!
//! Extremes are exact and blocks belong to the global lattice, so any number of ranks gives the same answer, as long as every
//! rank knows the whole content of all cells up to two away from its own: that is what ranks exchange in each step.

use rayon::prelude::*;

use super::comm::{Comm, Exchange};
use super::ghosts::{Extent, Territory};
use super::velocities::{Velocities, relative};
use crate::particles::cells::{CellTable, MAX_LEVEL};
use crate::particles::curve::{self, Block};
use crate::particles::{Lattice, Place, Site};

/// Levels watched above the widest occupied one.
const ABOVE: u32 = 2;

/// Cells a thread takes at a time.
pub(super) const CELLS: usize = 256;

/// Ranks, each with the number of cells that it sends or is sent.
type Peers = Vec<(usize, usize)>;

/// Numbers of a cell that another rank must know.
const fn words(dimension: usize) -> usize {
    2 * dimension + 2
}

/// Extremes over a cell's particles since the last build: maxima only, so that cells merge element by element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Summary<const D: usize> {
    forward: [f64; D],
    /// Maxima of the opposite displacement.
    backward: [f64; D],
    /// -(L - s) over particles of the cell's own level.
    lack: f64,
    /// Support of particles of finer levels.
    finer: f64,
}

impl<const D: usize> Summary<D> {
    const NOTHING: Self = Self {
        forward: [f64::NEG_INFINITY; D],
        backward: [f64::NEG_INFINITY; D],
        lack: f64::NEG_INFINITY,
        finer: f64::NEG_INFINITY,
    };

    #[inline(always)]
    fn merge(&mut self, other: &Self) {
        for k in 0..D {
            self.forward[k] = self.forward[k].max(other.forward[k]);
            self.backward[k] = self.backward[k].max(other.backward[k]);
        }
        self.lack = self.lack.max(other.lack);
        self.finer = self.finer.max(other.finer);
    }

    /// Relative displacement over what is allowed; `reach` is R above.
    fn used(&self, reach: f64) -> f64 {
        let apart = relative(&self.forward, &self.backward);
        // Where no particle of the block's own level is, half of it: particles that approach then always have half of the distance
        // left.
        let alone = self.lack == f64::NEG_INFINITY;
        let allowed = if alone { 0.5 * (reach - self.finer) } else { (-self.lack).min(reach - self.finer) };
        if allowed > 0.0 { apart / allowed } else { f64::INFINITY }
    }

    /// The largest displacement that may have happened.
    fn farthest(&self) -> f64 {
        (0..D).fold(0.0, |sum, k| sum + self.forward[k].max(self.backward[k]).powi(2)).sqrt()
    }

    fn write(&self, to: &mut [f64]) {
        to[..D].copy_from_slice(&self.forward);
        to[D..2 * D].copy_from_slice(&self.backward);
        to[2 * D..].copy_from_slice(&[self.lack, self.finer]);
    }

    fn read(from: &[f64]) -> Self {
        Self {
            forward: std::array::from_fn(|k| from[k]),
            backward: std::array::from_fn(|k| from[D + k]),
            lack: from[2 * D],
            finer: from[2 * D + 1],
        }
    }
}

/// A cell of some level with particles of this rank.
#[derive(Debug, Clone)]
pub(super) struct Cell {
    pub(super) code: u64,
    /// Owned particles of exactly this level.
    pub(super) particles: std::ops::Range<u32>,
    /// Its cells of the level below.
    pub(super) children: std::ops::Range<u32>,
}

/// Where particles are now.
pub struct Displacements<'a, S> {
    /// D numbers per owned particle, m.
    pub position: &'a [f64],
    pub build_position: &'a [f64],
    /// The support 2h of owned particle `i`, m.
    pub support: S,
}

pub struct Watch<const D: usize> {
    /// Own cells, level after level.
    pub(super) cells: Vec<Cell>,
    /// Where each level begins in `cells`, and where the last one ends.
    pub(super) levels: Vec<usize>,
    /// Side of the cells of each level, and of those in which the widest particles live, m.
    pub(super) sides: Vec<f64>,
    pub(super) widest_side: f64,
    pub(super) lattice: Lattice,
    /// Own cells, then cells known from other ranks only.
    pub(super) summaries: Vec<Summary<D>>,
    /// Whether summaries are those of the present positions.
    surveyed: bool,
    /// Largest support in each own cell.
    supports: Vec<f64>,
    /// List radii of owned particles, m.
    radii: Vec<f64>,
    pub(super) blocks: Blocks,
    exchange: Exchange,
    /// (rank, cells) that are sent, and that are received.
    pub(super) peers: [Peers; 2],
    pub(super) send_cells: Vec<u32>,
    pub(super) receive_cells: Vec<u32>,
    pub(super) velocities: Option<Velocities<D>>,
    /// No particle may move farther, m.
    farthest: f64,
}

/// The blocks of 3^D cells to look at: block b merges `cells[offsets[b]..offsets[b + 1]]`.
#[derive(Debug, Default)]
pub(super) struct Blocks {
    offsets: Vec<u32>,
    cells: Vec<u32>,
    /// Where in its block each of `cells` lies, see [`Block::layers`].
    layers: Vec<u8>,
    /// R of each block.
    pub(super) reach: Vec<f64>,
    /// The first block of each level.
    first: Vec<usize>,
}

impl<const D: usize> Watch<D> {
    /// `owned`: in canonical order. Collective.
    pub fn build(lattice: &Lattice, owned: &[Site<D>], territories: &[Territory<D>], comm: &Comm) -> Self {
        let radii = owned.iter().map(|site| site.radius).collect();
        Self::build_placed(lattice, radii, owned.iter().map(|site| lattice.place(site)), territories, comm)
    }

    /// Like [`Watch::build`], from list radii and places alone. Collective.
    pub fn build_placed(
        lattice: &Lattice,
        radii: Vec<f64>,
        places: impl Iterator<Item = Place>,
        territories: &[Territory<D>],
        comm: &Comm,
    ) -> Self {
        let extents: Vec<Extent<D>> = territories.iter().map(Territory::whole).collect();
        let widest = widest_level(lattice, &extents);
        let above = if lattice.is_periodic() { 0 } else { ABOVE };
        let (cells, levels) = own_cells::<D>(places, radii.len(), (widest + above).min(MAX_LEVEL));
        let mut reach: Vec<f64> = Vec::with_capacity(cells.len());
        for (level, cells) in by_level(&cells, &levels) {
            let smallest = |c: &Cell| {
                let own = &radii[c.particles.start as usize..c.particles.end as usize];
                own.iter().copied().fold(lattice.side(level), f64::min)
            };
            reach.extend(cells.iter().map(smallest));
        }
        let (mut send_cells, mut sends, mut messages) = (Vec::new(), Vec::new(), Vec::new());
        for (rank, extent) in
            extents.iter().enumerate().filter(|(rank, extent)| *rank != comm.rank() && !extent.is_empty())
        {
            let start = send_cells.len();
            send_cells.extend(cells_near(lattice, &cells, &levels, extent));
            let sent = &send_cells[start..];
            if !sent.is_empty() {
                let level_of = |cell: u32| levels.partition_point(|&start| start <= cell as usize) as u64 - 1;
                let describe = |&c: &u32| [level_of(c), cells[c as usize].code, reach[c as usize].to_bits()];
                messages.push((rank, sent.iter().flat_map(describe).collect()));
                sends.push((rank, sent.len()));
            }
        }
        let received = comm.sparse_exchange(messages);
        let reported = received.iter().map(|(_, message)| message.len() / 3).sum();
        let mut known = Known::new(&cells, &levels, reach, reported);
        let (mut receive_cells, mut receives) = (Vec::new(), Vec::new());
        for (rank, message) in received {
            let described = message.chunks_exact(3);
            receives.push((rank, described.len()));
            receive_cells.extend(described.map(|w| known.add(w[0] as usize, w[1], f64::from_bits(w[2]))));
        }
        let numbers =
            |list: &[(usize, usize)]| list.iter().map(|&(rank, cells)| (rank, cells * words(D))).collect::<Vec<_>>();
        Self {
            sides: (0..levels.len() as u32 - 1).map(|level| lattice.side(level)).collect(),
            widest_side: lattice.side(widest),
            lattice: *lattice,
            summaries: vec![Summary::NOTHING; known.reach.len()],
            surveyed: false,
            supports: vec![0.0; cells.len()],
            radii,
            blocks: known.blocks::<D>(lattice, &cells, &levels),
            exchange: Exchange::new(comm, &numbers(&sends), &numbers(&receives)),
            peers: [sends, receives],
            velocities: None,
            farthest: farthest(lattice, widest, (levels.len() - 2) as u32, D),
            cells,
            levels,
            send_cells,
            receive_cells,
        }
    }

    /// How much of the skin is used up, as far as this rank sees: lists hold while the maximum over ranks is at most 1.
    /// Collective.
    pub fn skin_used<S: Fn(usize) -> f64 + Sync>(&mut self, motion: &Displacements<'_, S>, comm: &Comm) -> f64 {
        self.surveyed = false;
        self.survey(motion, comm);
        let farthest = self.summaries[self.top()].iter().map(Summary::farthest).fold(0.0, f64::max);
        let (blocks, summaries) = (&self.blocks, &self.summaries);
        let each = (0..blocks.reach.len()).into_par_iter().with_min_len(CELLS);
        each.map(|b| blocks.used(b, summaries)).reduce(|| 0.0, f64::max).max(farthest / self.farthest)
    }

    /// How far matter around each owned particle has moved against each other, m, between the last build and the last call of
    /// [`Watch::skin_used`]: the most in any block of its level that holds it.
    pub fn moves_around(&self) -> Vec<f64> {
        let (blocks, summaries) = (&self.blocks, &self.summaries);
        let each = (0..blocks.reach.len()).into_par_iter().with_min_len(CELLS);
        let moved: Vec<f64> = each.map(|block| blocks.moved(block, summaries).0).collect();
        let mut most = vec![0.0f64; self.cells.len()];
        for (block, moved) in moved.into_iter().enumerate() {
            for &cell in blocks.cells_of(block) {
                if let Some(most) = most.get_mut(cell as usize) {
                    *most = most.max(moved);
                }
            }
        }
        let mut around = vec![0.0; self.radii.len()];
        for (cell, most) in self.cells.iter().zip(most) {
            around[cell.particles.start as usize..cell.particles.end as usize].fill(most);
        }
        around
    }

    /// Brings the summaries of all cells to the present positions. Collective.
    pub(super) fn survey<S: Fn(usize) -> f64 + Sync>(&mut self, motion: &Displacements<'_, S>, comm: &Comm) {
        if std::mem::replace(&mut self.surveyed, true) {
            return;
        }
        for level in 0..self.levels.len() - 1 {
            self.summarise(level, motion);
        }
        let outgoing = self.exchange.outgoing().chunks_exact_mut(words(D));
        for (&cell, to) in self.send_cells.iter().zip(outgoing) {
            self.summaries[cell as usize].write(to);
        }
        self.exchange.start(comm);
        self.summaries[self.cells.len()..].fill(Summary::NOTHING);
        self.exchange.wait(comm);
        for (&cell, from) in self.receive_cells.iter().zip(self.exchange.incoming().chunks_exact(words(D))) {
            self.summaries[cell as usize].merge(&Summary::read(from));
        }
    }

    /// Own cells of the widest level watched.
    fn top(&self) -> std::ops::Range<usize> {
        self.levels[self.levels.len() - 2]..self.cells.len()
    }

    /// The largest displacements of own particles, and of their opposites.
    pub(super) fn farthest_moves(&self) -> ([f64; D], [f64; D]) {
        // Own cells may know of other ranks' particles, too, which does not matter.
        let mut all = Summary::NOTHING;
        self.summaries[self.top()].iter().for_each(|summary| all.merge(summary));
        (all.forward, all.backward)
    }

    /// Owned particles of all levels in the cells of a block.
    pub(super) fn particles_of(&self, block: usize) -> Vec<usize> {
        let mut cells: Vec<u32> = self.blocks.cells_of(block).to_vec();
        let mut particles = Vec::new();
        while let Some(cell) = cells.pop() {
            let Some(cell) = self.cells.get(cell as usize) else { continue };
            particles.extend(cell.particles.start as usize..cell.particles.end as usize);
            cells.extend(cell.children.clone());
        }
        particles
    }

    /// Releases the memory before another watch is made.
    pub fn forget(&mut self) {
        (self.cells, self.summaries, self.supports, self.radii) = Default::default();
        self.blocks = Blocks::default();
        self.velocities = None;
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        std::mem::size_of::<Cell>() * self.cells.len()
            + std::mem::size_of::<Summary<D>>() * self.summaries.len()
            + 8 * (self.supports.len() + self.radii.len() + self.blocks.reach.len())
            + self.blocks.layers.len()
            + 4 * (self.blocks.offsets.len()
                + self.blocks.cells.len()
                + self.send_cells.len()
                + self.receive_cells.len())
            + self.exchange.bytes()
            + self.velocities.as_ref().map_or(0, Velocities::bytes)
    }

    /// Own cells of one level, from their particles and the level below.
    fn summarise<S: Fn(usize) -> f64 + Sync>(&mut self, level: usize, motion: &Displacements<'_, S>) {
        let (start, end) = (self.levels[level], self.levels[level + 1]);
        let (finer, summaries) = self.summaries.split_at_mut(start);
        let (finer_supports, supports) = self.supports.split_at_mut(start);
        let radii = &self.radii;
        let mine = summaries[..end - start].par_iter_mut().zip(supports.par_iter_mut());
        mine.zip(&self.cells[start..end]).with_min_len(CELLS).for_each(|((summary, support), cell)| {
            *summary = Summary::NOTHING;
            for child in cell.children.start as usize..cell.children.end as usize {
                summary.merge(&Summary { lack: f64::NEG_INFINITY, finer: finer_supports[child], ..finer[child] });
            }
            *support = summary.finer;
            for i in cell.particles.start as usize..cell.particles.end as usize {
                let s = (motion.support)(i);
                *support = support.max(s);
                summary.lack = summary.lack.max(s - radii[i]);
                for k in 0..D {
                    let d = motion.position[D * i + k] - motion.build_position[D * i + k];
                    summary.forward[k] = summary.forward[k].max(d);
                    summary.backward[k] = summary.backward[k].max(-d);
                }
            }
        });
    }
}

impl Blocks {
    /// The share of the skin used up in one block.
    fn used<const D: usize>(&self, block: usize, summaries: &[Summary<D>]) -> f64 {
        self.merged(block, summaries).used(self.reach[block])
    }

    /// How far particles of one block have moved against each other, m, and the largest support of those of finer levels.
    pub(super) fn moved<const D: usize>(&self, block: usize, summaries: &[Summary<D>]) -> (f64, f64) {
        let merged = self.merged(block, summaries);
        (relative(&merged.forward, &merged.backward), merged.finer)
    }

    fn merged<const D: usize>(&self, block: usize, summaries: &[Summary<D>]) -> Summary<D> {
        let mut merged = Summary::NOTHING;
        self.cells_of(block).iter().for_each(|&cell| merged.merge(&summaries[cell as usize]));
        merged
    }

    pub(super) fn cells_of(&self, block: usize) -> &[u32] {
        &self.cells[self.offsets[block] as usize..self.offsets[block + 1] as usize]
    }

    /// Where the cells of a block lie in it.
    pub(super) fn layers_of(&self, block: usize) -> &[u8] {
        &self.layers[self.offsets[block] as usize..self.offsets[block + 1] as usize]
    }

    pub(super) fn level(&self, block: usize) -> usize {
        self.first.partition_point(|&first| first <= block) - 1
    }
}

/// The widest level that any rank's particles live in: levels grow with the radius.
fn widest_level<const D: usize>(lattice: &Lattice, extents: &[Extent<D>]) -> u32 {
    lattice.level(extents.iter().map(|e| e.radius).fold(0.0, f64::max))
}

/// How far particles may move where blocks do not reach, m. Nowhere at all if the widest level does not fit into the
/// periods: smoothing lengths that have grown so much are rare, and lists are then built in every step.
fn farthest(lattice: &Lattice, widest: u32, top: u32, dimension: usize) -> f64 {
    let fits =
        if dimension == 2 { lattice.period::<2>(widest).is_some() } else { lattice.period::<3>(widest).is_some() };
    // Half a side: two particles that no block holds are then still a side apart, see `closing`.
    if fits { 0.5 * lattice.side(top) } else { 0.0 }
}

/// A cell and those that touch it.
fn around<const D: usize>(lattice: &Lattice, level: u32, code: u64) -> Block {
    let side = Lattice::cells(level);
    match lattice.period(level) {
        Some(period) if lattice.is_periodic() => Block::around_periodic::<D>(code, side, period),
        _ => Block::around::<D>(code, side),
    }
}

fn by_level<'a>(cells: &'a [Cell], levels: &'a [usize]) -> impl Iterator<Item = (u32, &'a [Cell])> {
    (0u32..).zip(levels.windows(2)).map(|(level, range)| (level, &cells[range[0]..range[1]]))
}

/// Cells of levels 0 to `top` with owned particles, `count` of them, of that or a finer level; along the curve within a level.
fn own_cells<const D: usize>(places: impl Iterator<Item = Place>, count: usize, top: u32) -> (Vec<Cell>, Vec<usize>) {
    let (mut cells, mut levels) = (Vec::<Cell>::new(), vec![0]);
    let mut particles = places.zip(0u32..).peekable();
    for level in 0..=top {
        let start = cells.len();
        let finer = if level == 0 { start..start } else { levels[level as usize - 1]..start };
        let mut children = finer.peekable();
        loop {
            let own = particles.peek().filter(|(place, _)| place.level == level).map(|(place, _)| place.cell);
            let child = children.peek().map(|&c| cells[c].code >> D);
            let Some(code) = own.into_iter().chain(child).min() else { break };
            let first = particles.peek().map_or(count as u32, |p| p.1);
            while particles.next_if(|(place, _)| place.level == level && place.cell == code).is_some() {}
            let last = particles.peek().map_or(count as u32, |p| p.1);
            let first_child = children.peek().map_or(start, |&c| c) as u32;
            while children.next_if(|&c| cells[c].code >> D == code).is_some() {}
            let last_child = children.peek().map_or(start, |&c| c) as u32;
            cells.push(Cell { code, particles: first..last, children: first_child..last_child });
        }
        levels.push(cells.len());
    }
    (cells, levels)
}

/// Own cells at most two away from the cells that a rank's box covers.
fn cells_near<const D: usize>(lattice: &Lattice, cells: &[Cell], levels: &[usize], extent: &Extent<D>) -> Vec<u32> {
    let (low, high) = (lattice.coordinates(&extent.low), lattice.coordinates(&extent.high));
    let mut near = Vec::new();
    for (level, range) in (0u32..).zip(levels.windows(2)) {
        let period = lattice.period::<D>(level).unwrap_or([0; D]);
        let touches = |cell: &Cell| {
            let c = curve::decode::<D>(cell.code);
            (0..D).all(|k| {
                let within = |c: u32| c + 2 >= low[k] >> level && c <= (high[k] >> level) + 2;
                within(c[k]) || (period[k] > 0 && (within(c[k] + period[k]) || within(c[k] - period[k])))
            })
        };
        near.extend((range[0]..range[1]).filter(|&c| touches(&cells[c])).map(|c| c as u32));
    }
    near
}

/// Cells of this rank and those that other ranks have reported.
struct Known {
    /// Numbers of cells by code, for each level.
    tables: Vec<CellTable>,
    /// Smallest list radius of the cell's own level, or its side; of all ranks.
    reach: Vec<f64>,
}

impl Known {
    /// `reported`: how many cells other ranks will report.
    fn new(cells: &[Cell], levels: &[usize], reach: Vec<f64>, reported: usize) -> Self {
        let mut tables = Vec::new();
        for range in levels.windows(2) {
            let mut table = CellTable::default();
            table.reset(range[1] - range[0] + reported);
            (range[0]..range[1]).for_each(|c| table.insert(cells[c].code, c as u32, c as u32 + 1));
            tables.push(table);
        }
        Self { tables, reach }
    }

    /// The number of a cell that another rank has reported.
    fn add(&mut self, level: usize, code: u64, reach: f64) -> u32 {
        if let Some((cell, _)) = self.tables[level].get(code) {
            let mine = &mut self.reach[cell as usize];
            *mine = mine.min(reach);
            return cell;
        }
        let cell = self.reach.len() as u32;
        self.tables[level].insert(code, cell, cell + 1);
        self.reach.push(reach);
        cell
    }

    /// The blocks around all cells that touch own ones, empty cells included.
    fn blocks<const D: usize>(&self, lattice: &Lattice, cells: &[Cell], levels: &[usize]) -> Blocks {
        let mut blocks = Blocks { offsets: vec![0], ..Blocks::default() };
        let mut others = Vec::new();
        for (level, own) in by_level(cells, levels) {
            blocks.first.push(blocks.reach.len());
            let numbers = levels[level as usize] as u32..levels[level as usize + 1] as u32;
            others.clear();
            for cell in own {
                self.add_block::<D>(&mut blocks, level, &around::<D>(lattice, level, cell.code), |code, number| {
                    if !number.is_some_and(|number| numbers.contains(&number)) {
                        others.push(code);
                    }
                });
            }
            others.sort_unstable();
            others.dedup();
            for &centre in &others {
                self.add_block::<D>(&mut blocks, level, &around::<D>(lattice, level, centre), |_, _| {});
            }
        }
        blocks
    }

    /// Adds a block; `visit` sees the code of each of its cells, and the number of those that are known.
    fn add_block<const D: usize>(
        &self,
        blocks: &mut Blocks,
        level: u32,
        around: &Block,
        mut visit: impl FnMut(u64, Option<u32>),
    ) {
        let mut reach = f64::INFINITY;
        for (place, &code) in around.codes().iter().enumerate() {
            let number = self.tables[level as usize].get(code).map(|range| range.0);
            if let Some(number) = number {
                blocks.cells.push(number);
                blocks.layers.push(around.layers::<D>(place));
                reach = reach.min(self.reach[number as usize]);
            }
            visit(code, number);
        }
        blocks.reach.push(reach);
        blocks.offsets.push(blocks.cells.len() as u32);
    }
}
