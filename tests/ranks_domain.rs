//! Decomposition on several ranks: lists, watch and ghost messages give the same answers on 1 to 4 ranks, and the watch
//! speaks up before two particles that are not listed come within their supports.

use crate::common::same_on_any_ranks;
use sph_mpi::domain::ghosts::Territory;
use sph_mpi::domain::{Basis, Comm, Decomposition, Displacements, Handles, Space, Watch};
use sph_mpi::math::Vec3;
use sph_mpi::neighbours::NeighbourList;
use sph_mpi::particles::{Column, ColumnInfo, Columns, Lattice, Life, ParticleId, Periods, Registry, Site};
use sph_mpi::random::uniform;

const PARTICLES: u64 = 1500;
const SKIN: f64 = 0.1;
/// No support of a story grows beyond it.
const WIDEST: f64 = 2.6;

/// Where a particle is and how large its support is, at any time: a ball with a few coarse particles, a fine one that flies
/// into it, and single particles that come from afar. At first nothing else moves, so that nothing else asks for new
/// lists before they meet; then the ball expands and supports grow.
fn impact<const D: usize>(id: u64, time: f64) -> ([f64; D], f64) {
    let u = |draw| uniform(5, id, draw) - 0.5;
    let size = 0.5 * (PARTICLES as f64).powf(1.0 / D as f64);
    let late = (time - 7.0).max(0.0);
    let (projectile, bullet) = (id % 10 == 0, id % 97 == 1);
    let position = std::array::from_fn(|d| {
        let start = size * u(d as u64);
        let (start, speed) = match (projectile, bullet, d) {
            (true, _, 0) => (1.3 * size + 0.3 * start, -0.4),
            (true, _, _) => (0.3 * start, 0.0),
            (_, true, 0) => (-1.5 * size - 0.2 * id as f64 / 97.0 * size, 0.9),
            _ => return start + late * (0.02 * start + 0.01 * u(3 + d as u64)),
        };
        start + time * speed
    });
    let growth = 1.0 + 0.005 * late * uniform(5, id, 8);
    (position, growth * if projectile { 0.5 } else { 1.0 + 1.5 * uniform(5, id, 9).powi(4) })
}

/// Two bodies of one support each from afar; nothing else moves.
fn approach<const D: usize>(id: u64, time: f64) -> ([f64; D], f64) {
    let size = 0.4 * (PARTICLES as f64).powf(1.0 / D as f64);
    let mut position = std::array::from_fn(|d| size * (uniform(6, id, d as u64) - 0.5));
    if id % 2 == 0 {
        position[0] += size + 60.0 - 6.5 * time;
    }
    (position, 1.0)
}

/// Position and support of a particle at a time.
type Story<const D: usize> = fn(u64, f64) -> ([f64; D], f64);

struct Cloud<const D: usize> {
    story: Story<D>,
    periods: Periods,
    /// When lists were built last.
    built_at: f64,
    handles: Handles,
    list_radius: Column<f64>,
    columns: Columns,
}

impl<const D: usize> Cloud<D> {
    /// Particles dealt out to ranks like cards.
    fn new(story: Story<D>, periods: Periods, comm: &Comm) -> Self {
        let info = |name| ColumnInfo { name, unit: "m", about: "for tests", life: Life::State, snapshot: false };
        let mut registry = Registry::new(D);
        let handles = Handles {
            id: registry.column(info("id")),
            position: registry.column(info("position")),
            build_position: registry.column(info("build_position")),
        };
        let list_radius = registry.column(info("list_radius"));
        let mut columns = Columns::new(registry);
        let mine = (0..PARTICLES).filter(|id| *id as usize % comm.size() == comm.rank());
        columns.resize(mine.clone().count());
        mine.enumerate().for_each(|(i, id)| columns.set(handles.id, i, ParticleId(id)));
        let mut cloud = Self { story, periods, built_at: 0.0, handles, list_radius, columns };
        for i in 0..cloud.columns.len() {
            let x = story(cloud.id(i), 0.0).0;
            cloud.columns.set(handles.position, i, vector(x));
        }
        cloud.settle(0.0);
        cloud
    }

    fn id(&self, i: usize) -> u64 {
        self.columns.get(self.handles.id, i).0
    }

    /// Between builds no particle comes back into its period.
    fn move_to(&mut self, time: f64) {
        for i in 0..self.columns.len() {
            let [then, now] = [self.built_at, time].map(|time| vector((self.story)(self.id(i), time).0));
            let x = self.columns.get(self.handles.build_position, i) + (now - then);
            self.columns.set(self.handles.position, i, x);
        }
    }

    /// What comes before a build.
    fn settle(&mut self, time: f64) {
        for axis in (0..D).filter(|&axis| self.periods.closed(axis)) {
            for x in self.columns.numbers_mut(self.handles.position.index).as_chunks_mut::<D>().0 {
                x[axis] = self.periods.wrapped(axis, x[axis]);
            }
        }
        self.columns.copy(self.handles.position.index, self.handles.build_position.index);
        self.built_at = time;
        self.stamp(time);
    }

    fn stamp(&mut self, time: f64) {
        for i in 0..self.columns.len() {
            let support = (self.story)(self.id(i), time).1;
            self.columns.set(self.list_radius, i, support * (1.0 + SKIN));
        }
    }
}

fn vector<const D: usize>(x: [f64; D]) -> Vec3 {
    Vec3::from_fn(|d, _| x.get(d).copied().unwrap_or(0.0))
}

/// FNV-1a over words.
fn fold(hash: u64, words: impl IntoIterator<Item = u64>) -> u64 {
    words.into_iter().fold(hash, |h, w| (h ^ w).wrapping_mul(0x0000_0100_0000_01b3).rotate_left(29))
}

/// A number that all rows of all ranks make together; sums of hashes do not depend on who holds the row.
fn hash_of_rows<const D: usize>(list: &NeighbourList<D>, domain: &Decomposition<D>, comm: &Comm) -> u64 {
    let local = &domain.local;
    let id = |slot: u32| if slot as usize == local.count { u64::MAX } else { local.places[slot as usize].id };
    let rows = (0..local.owned()).map(|i| {
        let ids = list.row(i).iter().map(|&j| id(j));
        fold(0xcbf2_9ce4_8422_2325, std::iter::once(id(local.slot_of_owned[i])).chain(ids)) >> 16
    });
    let mut sum = [rows.map(|h| h as i64).sum::<i64>()];
    comm.all_sum(&mut sum);
    sum[0] as u64
}

/// Every ghost's record arrives at the ghost's slot.
fn check_messages<const D: usize>(domain: &mut Decomposition<D>, cloud: &Cloud<D>, comm: &Comm) {
    let (ghosts, local) = (&mut domain.ghosts, &domain.local);
    let words = ghosts.words;
    for (&i, record) in ghosts.send_indices.iter().zip(ghosts.exchange.outgoing().chunks_exact_mut(words)) {
        record.fill(cloud.id(i as usize) as f64);
    }
    ghosts.exchange.start(comm);
    ghosts.exchange.wait(comm);
    assert_eq!(ghosts.exchange.incoming().len(), words * local.ghosts());
    for (&slot, record) in local.slot_of_incoming.iter().zip(ghosts.exchange.incoming().chunks_exact(words)) {
        assert!(record.iter().all(|&x| x == local.places[slot as usize].id as f64));
    }
}

/// No two particles are within their supports without standing in each other's rows.
fn check_complete<const D: usize>(
    list: &NeighbourList<D>,
    domain: &Decomposition<D>,
    (story, time): (Story<D>, f64),
    periods: &Periods,
) {
    // To the nearest image.
    let apart = |axis: usize, x: f64| match periods.closed(axis) {
        true => x - periods.length[axis] * (x / periods.length[axis]).round(),
        false => x,
    };
    let all: Vec<_> = (0..PARTICLES).map(|id| story(id, time)).collect();
    let local = &domain.local;
    let mut listed = vec![u32::MAX; PARTICLES as usize];
    for i in 0..local.owned() {
        let me = local.places[local.slot_of_owned[i] as usize].id as usize;
        for &j in list.row(i).iter().filter(|&&j| (j as usize) < local.count) {
            let other = local.places[j as usize].id as usize;
            assert!(listed[other] != i as u32, "{me} meets {other} twice at {time}");
            listed[other] = i as u32;
        }
        for (other, (x, support)) in all.iter().enumerate() {
            let r_squared: f64 = (0..D).map(|d| apart(d, x[d] - all[me].0[d]).powi(2)).sum();
            let near = r_squared < support.max(all[me].1).powi(2);
            assert!(!near || other == me || listed[other] == i as u32, "{me} and {other} at {time}");
        }
    }
}

/// The story of a run: lists and the watch's answers as one hash, and the number of builds.
fn tell<const D: usize>(story: Story<D>, periods: Periods, comm: &Comm) -> String {
    let mut cloud = Cloud::new(story, periods, comm);
    let column = cloud.list_radius;
    let list_radius = move |columns: &Columns, i: usize| columns.get(column, i);
    let lattice = Lattice::periodic(0.5 * (1.0 + SKIN), WIDEST * (1.0 + SKIN), &periods);
    let basis = Basis { handles: cloud.handles, space: Space { lattice, periods }, words: 3 };
    let mut domain = Decomposition::<D>::new(&mut cloud.columns, basis, &list_radius, comm);
    let mut list = NeighbourList::default();
    list.build(&domain.local);
    let steps = 200;
    let (mut hash, mut builds, mut migrated, mut ghosts) = (hash_of_rows(&list, &domain, comm), 0, 0, 0);
    for step in 1..=steps {
        let time = 0.05 * step as f64;
        cloud.move_to(time);
        let motion = Displacements {
            position: cloud.columns.numbers(cloud.handles.position.index),
            build_position: cloud.columns.numbers(cloud.handles.build_position.index),
            support: |i: usize| story(cloud.id(i), time).1,
        };
        let mut used = [domain.watch.skin_used(&motion, comm)];
        comm.all_max(&mut used);
        hash = fold(hash, [used[0].to_bits()]);
        if used[0] > 1.0 {
            cloud.settle(time);
            if builds % 2 == 0 {
                let costs: Vec<u32> = (0..cloud.columns.len()).map(|i| list.row(i).len() as u32).collect();
                domain.bisect(&cloud.columns, &costs, comm);
            }
            domain.rebuild_from_build_positions(&mut cloud.columns, &list_radius, comm);
            list.build(&domain.local);
            builds += 1;
            migrated += domain.migrated;
            hash = fold(hash, [hash_of_rows(&list, &domain, comm)]);
            check_messages(&mut domain, &cloud, comm);
            ghosts += domain.local.ghosts();
        } else if step % 10 == 5 {
            // What a resumed run does.
            let before = hash_of_rows(&list, &domain, comm);
            domain.rebuild_from_build_positions(&mut cloud.columns, &list_radius, comm);
            list.build(&domain.local);
            assert_eq!(hash_of_rows(&list, &domain, comm), before);
        }
        check_complete(&list, &domain, (story, time), &periods);
    }
    let mut counts = [(migrated.min(1) * ghosts) as i64, cloud.columns.len() as i64, list.pairs as i64];
    comm.all_sum(&mut counts);
    assert!(comm.size() == 1 || counts[0] > 0, "particles migrate and are ghosts");
    assert_eq!(counts[1], PARTICLES as i64);
    assert!((5..3 * steps / 4).contains(&builds), "lists live for some steps: {builds} builds");
    format!("{hash:016x} {builds} builds in {steps} steps, {} pairs", counts[2])
}

#[test]
fn lists_and_watch_are_the_same_3d() {
    same_on_any_ranks("ranks_domain::lists_and_watch_are_the_same_3d", |comm| tell::<3>(impact, Periods::OPEN, comm));
}

#[test]
fn lists_and_watch_are_the_same_2d() {
    same_on_any_ranks("ranks_domain::lists_and_watch_are_the_same_2d", |comm| tell::<2>(impact, Periods::OPEN, comm));
}

#[test]
fn bodies_from_afar_are_seen_in_time() {
    same_on_any_ranks("ranks_domain::bodies_from_afar_are_seen_in_time", |comm| {
        tell::<3>(approach, Periods::OPEN, comm)
    });
}

/// Bodies that leave a period on one side and meet on the other.
#[test]
fn lists_and_watch_are_the_same_where_space_closes() {
    same_on_any_ranks("ranks_domain::lists_and_watch_are_the_same_where_space_closes", |comm| {
        let tube = Periods { low: [-4.0, 0.0, -3.0], length: [12.0, 0.0, 8.0] };
        tell::<3>(impact, tube, comm)
    });
}

/// Two particles, each of support 1, at any distance: when the skin is used up they are still a support apart, and from
/// afar they may come much nearer than a skin.
#[test]
fn a_pair_is_stopped_before_it_meets() {
    same_on_any_ranks("ranks_domain::a_pair_is_stopped_before_it_meets", |comm| {
        let lattice = Lattice::new(1.0 + SKIN);
        let mut most = 0.0f64;
        for (k, start) in (0..90).map(|k| (k, 0.17 * k as f64)) {
            let distance = 1.101 + 0.2 * (k * 37 % 90) as f64;
            let at = [[start, 0.3], [start + distance, 0.3]];
            let mine: Vec<usize> = (0..2).filter(|i| i % comm.size() == comm.rank()).collect();
            let mut owned: Vec<_> =
                mine.iter().map(|&i| Site { id: i as u64, position: at[i], radius: 1.0 + SKIN }).collect();
            owned.sort_by_key(|site| lattice.place(site));
            let mut watch = Watch::build(&lattice, &owned, &Territory::all(&owned, &lattice, comm), comm);
            let build_position: Vec<f64> = owned.iter().flat_map(|site| site.position).collect();
            let mut nearer = 0.0;
            loop {
                let next = nearer + 0.01;
                let mut position = build_position.clone();
                for (site, x) in owned.iter().zip(position.chunks_exact_mut(2)) {
                    x[0] += if site.id == 0 { 0.5 * next } else { -0.5 * next };
                }
                let motion = Displacements { position: &position, build_position: &build_position, support: |_| 1.0 };
                let mut used = [watch.skin_used(&motion, comm)];
                comm.all_max(&mut used);
                if used[0] > 1.0 {
                    break;
                }
                nearer = next;
            }
            assert!(distance - nearer >= 1.0, "{distance} apart, {nearer} nearer");
            most = most.max(nearer);
        }
        assert!(most > 4.0, "particles far from each other may move: {most}");
        format!("{most}")
    });
}

/// Moving together uses nothing of the skin, until particles may have met others far away.
#[test]
fn only_relative_motion_counts() {
    same_on_any_ranks("ranks_domain::only_relative_motion_counts", |comm| {
        let mut cloud = Cloud::<3>::new(impact, Periods::OPEN, comm);
        let column = cloud.list_radius;
        let list_radius = move |columns: &Columns, i: usize| columns.get(column, i);
        let space = Space { lattice: Lattice::new(0.5 * (1.0 + SKIN)), periods: Periods::OPEN };
        let basis = Basis { handles: cloud.handles, space, words: 1 };
        let mut domain = Decomposition::<3>::new(&mut cloud.columns, basis, &list_radius, comm);
        let shift = [0.25, -0.5, 1.0];
        let build_position = cloud.columns.numbers(cloud.handles.build_position.index);
        // A step of the positions' own grid, so that all displacements are equal.
        let rounded: Vec<f64> = build_position.iter().map(|x| (x * 1024.0).round() / 1024.0).collect();
        let position: Vec<f64> = rounded.iter().enumerate().map(|(k, x)| x + shift[k % 3]).collect();
        let radii: Vec<f64> = (0..cloud.columns.len()).map(|i| cloud.columns.get(column, i)).collect();
        let mut used = |growth: f64, position: &[f64]| {
            let support = |i: usize| radii[i] / (1.0 + SKIN) * growth;
            let mut used =
                [domain.watch.skin_used(&Displacements { position, build_position: &rounded, support }, comm)];
            comm.all_max(&mut used);
            used[0]
        };
        let far = used(1.0, &position);
        assert!(far > 0.0 && far < 0.2, "only the bound on absolute displacements: {far}");
        assert_eq!(used(1.0, &rounded), 0.0);
        assert_eq!(used(1.0 + 1.01 * SKIN, &rounded), f64::INFINITY);
        format!("{:016x}", far.to_bits())
    });
}
