//! Intact fragments: particles nearer than 1.5 times the larger of their spacings are linked where both are damaged less
//! than a threshold; a fragment is a set of particles that are linked, directly or through others. Its label is the smallest id in
//! it.
//!
//! Clumps are wider: broken matter is linked, too, where its relative motion is so slow that a uniform ball which
//! expands at that rate would be held by its own gravity, |dv| / |dx| <= sqrt(8 pi G rho / 3) with rho the density at the start. So a
//! reaccumulated pile is one clump, and spray is none, however dense.
//!
//! Each rank links its particles and a layer of ghosts; labels are then exchanged through the ghosts until none changes.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::ops::Range;

use bytemuck::{Pod, Zeroable};
use rayon::prelude::*;

use super::particle::Particle;
use super::piece::Piece;
use super::tally::{Scale, Tally};
use crate::domain::comm::Comm;
use crate::gravity::G;

/// Link length over the larger spacing.
pub const LINK: f64 = 1.5;

/// When two neighbours are linked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Link {
    /// Both are damaged less than this.
    Intact(f64),
    /// Both are damaged less than this, or they move with each other.
    Slow(f64),
}

/// A particle as linking sees it.
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
#[repr(C)]
struct Point {
    id: u64,
    position: [f64; 3],
    /// m; the link length over [`LINK`].
    spacing: f64,
    velocity: [f64; 3],
    /// Largest |dv| / |dx| that it is linked at, 1/s.
    rate: f64,
}

/// The fragment of each particle; none for a loose one, which is damaged or has no neighbour to be linked to. Collective.
pub fn labels(comm: &Comm, particles: &[Particle], by: Link) -> Vec<Option<u64>> {
    let rate = |p: &Particle| match by {
        Link::Intact(damage) | Link::Slow(damage) if p.damage < damage => Some(f64::INFINITY),
        Link::Intact(_) => None,
        Link::Slow(_) => Some((8.0 / 3.0 * std::f64::consts::PI * G * p.mass / p.volume).sqrt()),
    };
    let intact = |p: &Particle| rate(p).is_some();
    let point = |p: &Particle| Point {
        id: p.id,
        position: p.position.into(),
        spacing: p.spacing,
        velocity: p.velocity.into(),
        rate: rate(p).unwrap_or(0.0),
    };
    let mut points: Vec<Point> = particles.iter().filter(|p| intact(p)).map(point).collect();
    let owned = points.len();
    let mut reach = [LINK * points.iter().fold(0.0, |s: f64, p| s.max(p.spacing))];
    comm.all_max(&mut reach);
    let ghosts = Ghosts::exchange(comm, &mut points, reach[0]);
    let mut sets = link(&points, reach[0]);
    let mut label: Vec<u64> = vec![u64::MAX; points.len()];
    for (i, point) in points.iter().enumerate() {
        let root = sets.root(i);
        label[root] = label[root].min(point.id);
    }
    ghosts.settle(comm, &mut sets, &mut label, owned);

    let mut next = 0..owned;
    let found = particles.iter().map(|p| {
        let i = if intact(p) { next.next() } else { None }?;
        let root = sets.root(i);
        (sets.size[root] > 1).then(|| label[root])
    });
    found.collect()
}

/// Disjoint sets of points.
struct Sets {
    parent: Vec<u32>,
    /// Points of the set, at its root.
    size: Vec<u32>,
}

impl Sets {
    fn root(&mut self, i: usize) -> usize {
        let mut i = i as u32;
        while self.parent[i as usize] != i {
            let above = self.parent[self.parent[i as usize] as usize];
            self.parent[i as usize] = above;
            i = above;
        }
        i as usize
    }

    fn join(&mut self, i: usize, j: usize) {
        let (a, b) = (self.root(i), self.root(j));
        if a != b {
            let (big, small) = if self.size[a] >= self.size[b] { (a, b) } else { (b, a) };
            self.parent[small] = big as u32;
            self.size[big] += self.size[small];
        }
    }
}

/// The cell of a point, and the point.
type Place = ([i64; 3], u32);
/// Cells whose links are held at a time, and those that a thread takes at a time.
const CELLS: usize = 1 << 16;
const CELLS_OF_A_THREAD: usize = 256;

/// Links all points that are near enough, by way of cells of side `reach`.
fn link(points: &[Point], reach: f64) -> Sets {
    let mut sets = Sets { parent: (0..points.len() as u32).collect(), size: vec![1; points.len()] };
    let cell = |p: &Point| p.position.map(|x| (x / reach).floor() as i64);
    let mut order: Vec<Place> = points.iter().enumerate().map(|(i, p)| (cell(p), i as u32)).collect();
    order.par_sort_unstable();
    let mut cells: HashMap<[i64; 3], Range<usize>> = HashMap::new();
    let mut begin = 0;
    for group in order.chunk_by(|a, b| a.0 == b.0) {
        cells.insert(group[0].0, begin..begin + group.len());
        begin += group.len();
    }
    // In the order of cells, as neighbours then are near in memory.
    let here: Vec<&[Place]> = order.chunk_by(|a, b| a.0 == b.0).collect();
    let nearby = |here: &[Place], take: &mut dyn FnMut(u32, u32)| {
        let [x, y, z] = here[0].0;
        // Half of the cells around, and the cell itself: each pair of cells is met once.
        for k in 0..14 {
            let [dx, dy, dz] = [k / 9, k / 3 % 3, k % 3].map(|d| d as i64 - 1);
            let Some(there) = cells.get(&[x + dx, y + dy, z + dz]) else { continue };
            for &(_, i) in here {
                for &(_, j) in &order[there.clone()] {
                    if i != j && are_linked(&points[i as usize], &points[j as usize]) {
                        take(i, j);
                    }
                }
            }
        }
    };
    if rayon::current_num_threads() == 1 {
        here.iter().for_each(|here| nearby(here, &mut |i, j| sets.join(i as usize, j as usize)));
        return sets;
    }
    // Threads find the links of some cells, then one joins them: in whatever order, the sets are the same.
    for some in here.chunks(CELLS) {
        let found = some.par_chunks(CELLS_OF_A_THREAD).map(|cells| {
            let mut links = Vec::new();
            cells.iter().for_each(|here| nearby(here, &mut |i, j| links.push((i, j))));
            links
        });
        let found: Vec<Vec<(u32, u32)>> = found.collect();
        found.iter().flatten().for_each(|&(i, j)| sets.join(i as usize, j as usize));
    }
    sets
}

fn are_linked(a: &Point, b: &Point) -> bool {
    let d: [f64; 3] = std::array::from_fn(|k| a.position[k] - b.position[k]);
    let reach = LINK * a.spacing.max(b.spacing);
    let d2 = (d[0] * d[0] + d[1] * d[1]) + d[2] * d[2];
    let rate = a.rate.min(b.rate);
    d2 < reach * reach && (rate == f64::INFINITY || speed2(a, b) <= rate * rate * d2)
}

/// |dv|^2, m^2/s^2.
fn speed2(a: &Point, b: &Point) -> f64 {
    let v: [f64; 3] = std::array::from_fn(|k| a.velocity[k] - b.velocity[k]);
    (v[0] * v[0] + v[1] * v[1]) + v[2] * v[2]
}

/// Copies of points on other ranks.
struct Ghosts {
    /// (rank, owned points it holds as ghosts, in the order sent).
    sent: Vec<(usize, Vec<u32>)>,
    /// (rank, where its points begin).
    received: Vec<(usize, usize)>,
}

impl Ghosts {
    /// Sends owned points within `reach` of another rank's box there, and appends what comes.
    fn exchange(comm: &Comm, points: &mut Vec<Point>, reach: f64) -> Self {
        let boxes = comm.all_gather(&[around(points)]);
        let mut sent: Vec<(usize, Vec<u32>)> = Vec::new();
        for (rank, ends) in boxes.iter().enumerate().filter(|(rank, _)| *rank != comm.rank()) {
            let near =
                |p: &Point| (0..3).all(|k| p.position[k] >= ends[0][k] - reach && p.position[k] <= ends[1][k] + reach);
            let list: Vec<u32> = (0..points.len()).filter(|&i| near(&points[i])).map(|i| i as u32).collect();
            if !list.is_empty() {
                sent.push((rank, list));
            }
        }
        let message = |list: &[u32]| -> Vec<u64> {
            list.iter().flat_map(|&i| bytemuck::cast::<Point, [u64; 9]>(points[i as usize])).collect()
        };
        let messages = sent.iter().map(|(rank, list)| (*rank, message(list))).collect();
        let mut received = Vec::new();
        for (rank, words) in comm.sparse_exchange(messages) {
            received.push((rank, points.len()));
            points.extend_from_slice(bytemuck::cast_slice(&words));
        }
        Self { sent, received }
    }

    /// Lowers labels to those that neighbouring ranks know, until no label changes anywhere.
    fn settle(&self, comm: &Comm, sets: &mut Sets, label: &mut [u64], owned: usize) {
        let mut sent_before = vec![u64::MAX; owned];
        loop {
            let mut fresh = vec![false; owned];
            for i in 0..owned {
                let now = label[sets.root(i)];
                fresh[i] = now != sent_before[i];
                sent_before[i] = now;
            }
            let news = |list: &[u32]| -> Vec<u64> {
                let fresh = list.iter().enumerate().filter(|(_, i)| fresh[**i as usize]);
                fresh.flat_map(|(k, &i)| [k as u64, sent_before[i as usize]]).collect()
            };
            let messages =
                self.sent.iter().map(|(rank, list)| (*rank, news(list))).filter(|(_, words)| !words.is_empty());
            let mut changed = [0.0];
            for (rank, words) in comm.sparse_exchange(messages.collect()) {
                let begin = self.received.iter().find(|(from, _)| *from == rank).map_or(0, |(_, begin)| *begin);
                for pair in words.chunks_exact(2) {
                    let root = sets.root(begin + pair[0] as usize);
                    if pair[1] < label[root] {
                        label[root] = pair[1];
                        changed[0] = 1.0;
                    }
                }
            }
            comm.all_max(&mut changed);
            if changed[0] == 0.0 {
                return;
            }
        }
    }
}

/// Least and largest corner.
fn around(points: &[Point]) -> [[f64; 3]; 2] {
    points.iter().fold([[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]], |[low, high], p| {
        [std::array::from_fn(|k| low[k].min(p.position[k])), std::array::from_fn(|k| high[k].max(p.position[k]))]
    })
}

/// The pieces of all matter: whole fragments, each on the rank that owns the particle it is named after, and loose
/// particles where they are; in order of label. `bodies`: numbers of the two whose matter is summed apart. Collective.
pub fn pieces(
    comm: &Comm,
    scale: &Scale,
    particles: &[Particle],
    labels: &[Option<u64>],
    bodies: [usize; 2],
) -> Vec<Piece> {
    let mut parts: BTreeMap<u64, (Tally, bool)> = BTreeMap::new();
    let mut pieces = Vec::new();
    for (particle, label) in particles.iter().zip(labels) {
        if let Some(label) = label {
            let (tally, home) = parts.entry(*label).or_default();
            tally.add(scale, particle, bodies);
            *home |= particle.id == *label;
        } else {
            let mut tally = Tally::default();
            tally.add(scale, particle, bodies);
            pieces.push(Piece::new(particle.id, &tally, scale));
        }
    }
    pieces.extend(unite(comm, parts).iter().map(|(label, tally)| Piece::new(*label, tally, scale)));
    pieces.sort_unstable_by_key(|piece| piece.label);
    pieces
}

/// Brings the parts of each fragment together on a rank that its label names, and returns the whole to its owner.
fn unite(comm: &Comm, parts: BTreeMap<u64, (Tally, bool)>) -> Vec<(u64, Tally)> {
    const RECORD: usize = 2 + Tally::WORDS;
    let mut outgoing: BTreeMap<usize, Vec<u64>> = BTreeMap::new();
    for (label, (tally, home)) in &parts {
        let words = outgoing.entry(meeting_place(*label, comm.size())).or_default();
        words.extend([*label, u64::from(*home)]);
        words.extend_from_slice(bytemuck::cast_slice(std::slice::from_ref(tally)));
    }
    let mut whole: BTreeMap<u64, (Tally, usize)> = BTreeMap::new();
    for (rank, words) in comm.sparse_exchange(outgoing.into_iter().collect()) {
        for record in words.chunks_exact(RECORD) {
            let (tally, home) = whole.entry(record[0]).or_default();
            tally.merge(bytemuck::from_bytes(bytemuck::cast_slice(&record[2..])));
            if record[1] == 1 {
                *home = rank;
            }
        }
    }
    let mut homeward: BTreeMap<usize, Vec<u64>> = BTreeMap::new();
    for (label, (tally, home)) in &whole {
        let words = homeward.entry(*home).or_default();
        words.push(*label);
        words.extend_from_slice(bytemuck::cast_slice(std::slice::from_ref(tally)));
    }
    let received = comm.sparse_exchange(homeward.into_iter().collect());
    let records = received.iter().flat_map(|(_, words)| words.chunks_exact(RECORD - 1));
    records.map(|record| (record[0], *bytemuck::from_bytes(bytemuck::cast_slice(&record[1..])))).collect()
}

/// Those of this rank's labels that some rank has among its `chosen`. Collective.
pub fn chosen_of(comm: &Comm, chosen: &BTreeSet<u64>, own: &BTreeSet<u64>) -> BTreeSet<u64> {
    // What is chosen and who asks meet on the rank that a label names.
    let by_place = |labels: &BTreeSet<u64>| {
        let mut places: BTreeMap<usize, Vec<u64>> = BTreeMap::new();
        labels.iter().for_each(|label| places.entry(meeting_place(*label, comm.size())).or_default().push(*label));
        comm.sparse_exchange(places.into_iter().collect())
    };
    let known: BTreeSet<u64> = by_place(chosen).into_iter().flat_map(|(_, labels)| labels).collect();
    let answer = |(rank, labels): (usize, Vec<u64>)| {
        (rank, labels.into_iter().filter(|label| known.contains(label)).collect::<Vec<u64>>())
    };
    let answers = by_place(own).into_iter().map(answer).filter(|(_, labels)| !labels.is_empty()).collect();
    comm.sparse_exchange(answers).into_iter().flat_map(|(_, labels)| labels).collect()
}

/// Spreads labels over ranks (Fibonacci hashing, Knuth 6.4).
fn meeting_place(label: u64, size: usize) -> usize {
    ((label.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32) % size as u64) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(id: u64, position: [f64; 3], spacing: f64) -> Point {
        Point { id, position, spacing, velocity: [0.0; 3], rate: f64::INFINITY }
    }

    /// All pairs, as the definition says.
    fn brute(points: &[Point]) -> Vec<u64> {
        let mut label: Vec<u64> = points.iter().map(|p| p.id).collect();
        while (0..points.len() * points.len()).fold(false, |changed, k| {
            let (i, j) = (k / points.len(), k % points.len());
            let lower = are_linked(&points[i], &points[j]) && label[j] < label[i];
            if lower {
                label[i] = label[j];
            }
            changed | lower
        }) {}
        label
    }

    #[test]
    fn cells_find_the_links_that_all_pairs_find() {
        let draw = |i: u64, k: u64| crate::random::uniform(11, i, k);
        let place = |i| [draw(i, 0) * 9.0 - 4.0, draw(i, 1) * 9.0 - 4.0, draw(i, 2) * 9.0 - 4.0];
        let points: Vec<_> = (0..700).map(|i| point(900 - i, place(i), 0.25 + 0.35 * draw(i, 3))).collect();
        let mut sets = link(&points, LINK * 0.6);
        let expected = brute(&points);
        for (i, label) in expected.iter().enumerate() {
            let root = sets.root(i);
            let mine = (0..points.len()).filter(|&j| sets.root(j) == root).map(|j| points[j].id).min();
            assert_eq!(mine, Some(*label));
        }
        let mut different = expected.clone();
        different.sort_unstable();
        different.dedup();
        assert!(different.len() > 10 && different.len() < 600, "{}", different.len());
    }

    /// Intact neighbours are linked at any speed, broken ones up to the slower one's rate.
    #[test]
    fn broken_neighbours_must_move_together() {
        let at = |x: f64, v: f64, rate: f64| Point { velocity: [0.0, v, 0.0], rate, ..point(0, [x, 0.0, 0.0], 1.0) };
        let hard = f64::INFINITY;
        assert!(are_linked(&at(0.0, 0.0, hard), &at(1.0, 9.0, hard)));
        assert!(
            are_linked(&at(0.0, 0.0, hard), &at(1.0, 0.4, 0.5)) && !are_linked(&at(0.0, 0.0, 0.5), &at(1.0, 0.6, hard))
        );
        assert!(!are_linked(&at(0.0, 0.0, 0.5), &at(1.6, 0.0, 0.5)));
    }

    #[test]
    fn the_larger_spacing_decides() {
        assert!(are_linked(&point(0, [0.0; 3], 1.0), &point(1, [1.4, 0.0, 0.0], 0.1)));
        assert!(!are_linked(&point(0, [0.0; 3], 1.0), &point(1, [1.5, 0.0, 0.0], 1.0)));
    }
}
