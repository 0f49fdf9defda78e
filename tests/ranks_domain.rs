//! Decomposition on several ranks: lists, watch and ghost messages give the same answers on 1 to 4 ranks, and the watch
//! speaks up before two particles that are not listed come within their supports.

use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use sph_mpi::domain::{Comm, Decomposition, Handles, Motion};
use sph_mpi::math::Vec3;
use sph_mpi::neighbours::NeighbourList;
use sph_mpi::particles::{Column, ColumnInfo, Columns, Lattice, Life, ParticleId, Registry};
use sph_mpi::random::uniform;

const RANKS: &str = "SPH_MPI_TEST_RANKS";
const PARTICLES: u64 = 1500;
const SKIN: f64 = 0.1;

/// Runs the test `name` of this executable on `ranks` ranks and returns what rank 0 printed as its result.
fn run(name: &str, ranks: usize) -> String {
    let mut child = Command::new("mpirun")
        .args(["-n", &ranks.to_string()])
        .arg(std::env::current_exe().unwrap())
        .args([name, "--exact", "--nocapture"])
        .env(RANKS, ranks.to_string())
        .env("OMPI_ALLOW_RUN_AS_ROOT", "1")
        .env("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1")
        .env("OMPI_MCA_rmaps_base_oversubscribe", "1")
        .env("OMPI_MCA_hwloc_base_binding_policy", "none")
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("mpirun starts");
    let start = Instant::now();
    while child.try_wait().unwrap().is_none() {
        if start.elapsed() > Duration::from_secs(120) {
            child.kill().unwrap();
            panic!("{name} on {ranks} ranks takes too long");
        }
        std::thread::sleep(Duration::from_millis(20));
    }
    let output = child.wait_with_output().unwrap();
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{ranks} ranks:\n{text}\n{}", String::from_utf8_lossy(&output.stderr));
    let (_, result) = text.split_once("RESULT ").unwrap_or_else(|| panic!("{ranks} ranks give no result:\n{text}"));
    result.lines().next().unwrap().to_string()
}

/// On 1 to 4 ranks `on_ranks` prints the same result.
fn same_on_all_ranks(name: &str, on_ranks: impl Fn(&Comm) -> String) {
    if let Ok(ranks) = std::env::var(RANKS) {
        let comm = Comm::start();
        assert_eq!(comm.size().to_string(), ranks);
        let result = on_ranks(&comm);
        if comm.is_root() {
            println!("RESULT {result}");
        }
        return;
    }
    let alone = run(name, 1);
    println!("{alone}");
    for ranks in 2..=4 {
        assert_eq!(run(name, ranks), alone, "{ranks} ranks");
    }
}

/// Where a particle is and how large its support is, at any time: a ball that expands, in part strongly, a fast small one
/// that hits it, and particles that fly far.
fn state<const D: usize>(id: u64, time: f64) -> ([f64; D], f64) {
    let u = |draw| uniform(5, id, draw) - 0.5;
    let size = 0.5 * (PARTICLES as f64).powf(1.0 / D as f64);
    let fast = id % 10 == 0;
    let scatter: f64 = if id % 37 == 0 { 30.0 } else { 0.02 };
    let position = std::array::from_fn(|d| {
        let start = size * u(d as u64) * if fast { 0.3 } else { 1.0 };
        let (offset, speed) = if fast && d == 0 { (1.5 * size, -0.5) } else { (0.0, 0.02 * start) };
        offset + start + time * (speed + scatter * 0.05 * u(3 + d as u64))
    });
    let growth = 1.0 + 0.01 * time * uniform(5, id, 8);
    (position, growth * if fast { 0.5 } else { 1.0 + 1.5 * uniform(5, id, 9).powi(4) })
}

struct Cloud<const D: usize> {
    handles: Handles,
    list_radius: Column<f64>,
    columns: Columns,
}

impl<const D: usize> Cloud<D> {
    /// Particles dealt out to ranks like cards.
    fn new(comm: &Comm) -> Self {
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
        let mut cloud = Self { handles, list_radius, columns };
        cloud.move_to(0.0);
        cloud.stamp(0.0);
        let position = cloud.columns.words(handles.position.index).to_vec();
        cloud.columns.words_mut(handles.build_position.index).copy_from_slice(&position);
        cloud
    }

    fn id(&self, i: usize) -> u64 {
        self.columns.get(self.handles.id, i).0
    }

    fn move_to(&mut self, time: f64) {
        for i in 0..self.columns.len() {
            let x = state::<D>(self.id(i), time).0;
            let x = Vec3::new(x[0], x[1], if D == 3 { x[2] } else { 0.0 });
            self.columns.set(self.handles.position, i, x);
        }
    }

    fn stamp(&mut self, time: f64) {
        for i in 0..self.columns.len() {
            let support = state::<D>(self.id(i), time).1;
            self.columns.set(self.list_radius, i, support * (1.0 + SKIN));
        }
    }
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
    assert!(comm.size() == 1 || local.ghosts() > 0, "the parts touch");
}

/// No two particles are within their supports without standing in each other's rows.
fn check_complete<const D: usize>(list: &NeighbourList<D>, domain: &Decomposition<D>, time: f64) {
    let all: Vec<_> = (0..PARTICLES).map(|id| state::<D>(id, time)).collect();
    let local = &domain.local;
    let mut listed = vec![u32::MAX; PARTICLES as usize];
    for i in 0..local.owned() {
        let me = local.places[local.slot_of_owned[i] as usize].id as usize;
        for &j in list.row(i).iter().filter(|&&j| (j as usize) < local.count) {
            listed[local.places[j as usize].id as usize] = i as u32;
        }
        for (other, (x, support)) in all.iter().enumerate() {
            let r_squared: f64 = (0..D).map(|d| (x[d] - all[me].0[d]).powi(2)).sum();
            let near = r_squared < support.max(all[me].1).powi(2);
            assert!(!near || other == me || listed[other] == i as u32, "{me} and {other} at {time}");
        }
    }
}

/// The story of a run: lists and the watch's answers as one hash, and the number of builds.
fn story<const D: usize>(comm: &Comm) -> String {
    let mut cloud = Cloud::<D>::new(comm);
    let column = cloud.list_radius;
    let list_radius = move |columns: &Columns, i: usize| columns.get(column, i);
    let support = |id: u64, time: f64| state::<D>(id, time).1;
    let set_up = (cloud.handles, Lattice::new(0.5 * (1.0 + SKIN)), 3);
    let mut domain = Decomposition::<D>::new(&mut cloud.columns, set_up, &list_radius, comm);
    let mut list = NeighbourList::default();
    list.build(&domain.local);
    let (mut hash, mut builds, mut migrated, steps) = (hash_of_rows(&list, &domain, comm), 0, 0, 100);
    for step in 1..=steps {
        let time = 0.08 * step as f64;
        cloud.move_to(time);
        let motion = Motion {
            position: cloud.columns.numbers(cloud.handles.position.index),
            build_position: cloud.columns.numbers(cloud.handles.build_position.index),
            support: |i: usize| support(cloud.id(i), time),
        };
        let mut used = [domain.watch.skin_used(&motion, comm)];
        comm.all_max(&mut used);
        hash = fold(hash, [used[0].to_bits()]);
        if used[0] > 1.0 {
            cloud.stamp(time);
            if builds % 2 == 0 {
                let costs: Vec<u32> = (0..cloud.columns.len()).map(|i| list.row(i).len() as u32).collect();
                domain.bisect(&cloud.columns, &costs, comm);
            }
            domain.rebuild(&mut cloud.columns, &list_radius, comm);
            list.build(&domain.local);
            builds += 1;
            migrated += domain.migrated;
            hash = fold(hash, [hash_of_rows(&list, &domain, comm)]);
            check_messages(&mut domain, &cloud, comm);
        } else if step % 10 == 5 {
            // What a resumed run does.
            let before = hash_of_rows(&list, &domain, comm);
            domain.rebuild_from_build_positions(&mut cloud.columns, &list_radius, comm);
            list.build(&domain.local);
            assert_eq!(hash_of_rows(&list, &domain, comm), before);
        }
        check_complete(&list, &domain, time);
    }
    let mut counts = [migrated as i64, cloud.columns.len() as i64, list.pairs as i64];
    comm.all_sum(&mut counts);
    assert!(comm.size() == 1 || counts[0] > 0, "particles migrate");
    assert_eq!(counts[1], PARTICLES as i64);
    format!("{hash:016x} {builds} builds in {steps} steps, {} pairs", counts[2])
}

#[test]
fn lists_and_watch_are_the_same_3d() {
    same_on_all_ranks("lists_and_watch_are_the_same_3d", story::<3>);
}

#[test]
fn lists_and_watch_are_the_same_2d() {
    same_on_all_ranks("lists_and_watch_are_the_same_2d", story::<2>);
}

/// Moving together uses nothing of the skin, until particles may have met others far away.
#[test]
fn only_relative_motion_counts() {
    same_on_all_ranks("only_relative_motion_counts", |comm| {
        let mut cloud = Cloud::<3>::new(comm);
        let column = cloud.list_radius;
        let list_radius = move |columns: &Columns, i: usize| columns.get(column, i);
        let set_up = (cloud.handles, Lattice::new(0.5 * (1.0 + SKIN)), 1);
        let mut domain = Decomposition::<3>::new(&mut cloud.columns, set_up, &list_radius, comm);
        let shift = [0.25, -0.5, 1.0];
        let build_position = cloud.columns.numbers(cloud.handles.build_position.index);
        // A step of the positions' own grid, so that all displacements are equal.
        let rounded: Vec<f64> = build_position.iter().map(|x| (x * 1024.0).round() / 1024.0).collect();
        let position: Vec<f64> = rounded.iter().enumerate().map(|(k, x)| x + shift[k % 3]).collect();
        let radii: Vec<f64> = (0..cloud.columns.len()).map(|i| cloud.columns.get(column, i)).collect();
        let mut used = |growth: f64, position: &[f64]| {
            let support = |i: usize| radii[i] / (1.0 + SKIN) * growth;
            let mut used = [domain.watch.skin_used(&Motion { position, build_position: &rounded, support }, comm)];
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
