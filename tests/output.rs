//! Files written and read by several ranks: snapshots, checkpoints, the picture of a cut. Each test runs itself again under
//! mpirun.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::common;
use sph_mpi::domain::comm::Comm;
use sph_mpi::error::Result;
use sph_mpi::material::{BodyConstants, Core, MaterialTable, ParticleView, Setup, declare_core};
use sph_mpi::math::{Deviator, Vec3};
use sph_mpi::output::collective::CollectiveFile;
use sph_mpi::output::figures::cut::{self, Picture};
use sph_mpi::output::figures::raster::{Dot, Plane, Window, rasterise, window};
use sph_mpi::output::snapshot::extend_series;
use sph_mpi::output::{Checkpoint, CheckpointMeta, History, Snapshot, Storage, checkpoint, state_hash};
use sph_mpi::particles::{Column, ColumnInfo, Columns, Life, ParticleId, Registry};

const DIRECTORY: &str = "SPH_MPI_TEST_DIRECTORY";
const STAGE: &str = "SPH_MPI_TEST_STAGE";

/// On a rank: runs `body` in the directory and at the stage that [`launch`] named, and says so.
fn on_ranks(body: impl FnOnce(&Comm, &Path, &str)) -> bool {
    common::on_rank(|comm| {
        let directory = PathBuf::from(std::env::var(DIRECTORY).unwrap());
        body(comm, &directory, &std::env::var(STAGE).unwrap());
        String::new()
    })
}

/// Runs test `name` of this file on `ranks` ranks.
fn launch(name: &str, ranks: usize, directory: &Path, stage: &str) {
    let directory = directory.to_str().expect("a plain path");
    common::launch(ranks, &format!("output::{name}"), &[(DIRECTORY, directory), (STAGE, stage)]);
}

const SITES: u64 = 500;
const BODIES: [BodyConstants; 2] = [
    BodyConstants { particle_mass: 2e9, smoothing_length: 120.0, particles: SITES, density: 2700.0, distention: 1.0 },
    BodyConstants { particle_mass: 1e9, smoothing_length: 90.0, particles: SITES, density: 2700.0, distention: 1.0 },
];

struct Scene {
    columns: Columns,
    core: Core,
    damage: Column<f64>,
}

fn registry(dimension: usize) -> (Registry, Core, Column<f64>, Column<Deviator>) {
    let mut registry = Registry::new(dimension);
    let core = declare_core(&mut registry);
    let state = |name, unit, about| ColumnInfo { name, unit, about, life: Life::State, snapshot: true };
    let stress = registry.column(state("deviatoric_stress", "Pa", "Deviatoric stress."));
    let damage = registry.column(state("damage", "", "Damage."));
    (registry, core, damage, stress)
}

/// Two bodies of 500 particles, numbers that follow from the id alone; this rank's share, backwards. With `gap` a rank
/// stays empty.
fn scene(dimension: usize, comm: &Comm, gap: Option<usize>) -> Scene {
    let (registry, core, damage, stress) = registry(dimension);
    let mut columns = Columns::new(registry);
    let workers: Vec<usize> = (0..comm.size()).filter(|rank| Some(*rank) != gap).collect();
    let mine = |k: u64| workers[k as usize * workers.len() / (2 * SITES as usize)] == comm.rank();
    let ids: Vec<u64> = (0..2 * SITES).filter(|k| mine(*k)).rev().collect();
    columns.resize(ids.len());
    for (i, k) in ids.into_iter().enumerate() {
        let (body, site) = ((k / SITES) as usize, k % SITES);
        let draw = |n: u64| sph_mpi::random::uniform(9, k, n);
        columns.set(core.id, i, ParticleId::new(body, site));
        let (x, y, z) = ((site % 10) as f64, (site / 10 % 10) as f64, (site / 100) as f64);
        columns.set(core.position, i, Vec3::new(100.0 * x + 1100.0 * body as f64, 100.0 * y, 100.0 * z));
        columns.set(core.velocity, i, Vec3::new(draw(0), draw(1), draw(2)));
        columns.set(core.density.value, i, 2700.0 + draw(3));
        columns.set(damage, i, x / 10.0);
        columns.set(stress, i, Deviator { xx: draw(4), yy: draw(5), xy: draw(6), xz: draw(7), yz: draw(8) });
    }
    Scene { columns, core, damage }
}

/// Both bodies are of a material of which nothing else is asked.
fn view(scene: &Scene) -> ParticleView {
    let gas: MaterialTable = toml::from_str("eos = { ideal_gas = { gamma = 1.4 } }").expect("a material");
    let setup = Setup {
        dimension: scene.columns.registry.dimension,
        materials: &[gas],
        body_material: &[0, 0],
        constants: &BODIES,
        initial_damage: &[0.0, 0.0],
        records: Default::default(),
        smoothing_length: None,
    };
    ParticleView::new(&setup, &scene.columns.registry, scene.core)
}

fn write_snapshot(path: &Path, dimension: usize, storage: Storage, comm: &Comm) -> bool {
    // On three ranks, the middle one has nothing and must take part all the same.
    let scene = scene(dimension, comm, (comm.size() == 3).then_some(1));
    let figures = [("energy_drift".to_string(), 1e-5)];
    let (columns, view) = (&scene.columns, &view(&scene));
    let text = "title = \"über\"";
    let (late_stage, bodies, in_largest) = (false, &[["ball", "rock"]][..], None);
    let (time, step, figures) = (1.5, 7, &figures[..]);
    let snapshot = Snapshot {
        columns,
        view,
        time,
        step,
        scene: text,
        late_stage,
        bodies,
        derived: &[],
        in_largest,
        figures,
        storage,
    };
    snapshot.write(path, comm).unwrap()
}

/// All numbers of a snapshot's fields, as bits, by particle id.
fn contents(path: &Path) -> Vec<(u64, Vec<u64>)> {
    let file = hdf5::File::open(path).unwrap();
    let fields = file.group("/VTKHDF/PointData").unwrap();
    let ids = fields.dataset("id").unwrap().read_raw::<u64>().unwrap();
    let mut names = fields.member_names().unwrap();
    names.sort();
    let mut rows: Vec<(u64, Vec<u64>)> = ids.into_iter().map(|id| (id, Vec::new())).collect();
    let mut add = |dataset: hdf5::Dataset| {
        let values = dataset.read_raw::<f64>().unwrap();
        let width = values.len() / rows.len();
        rows.iter_mut()
            .zip(values.chunks_exact(width))
            .for_each(|(row, v)| row.1.extend(v.iter().map(|x| x.to_bits())));
    };
    add(file.dataset("/VTKHDF/Points").unwrap());
    names.iter().for_each(|name| add(fields.dataset(name).unwrap()));
    rows.sort();
    rows
}

const PLAIN: Storage = Storage { single_precision: false, gzip: None };
const SMALL: Storage = Storage { single_precision: true, gzip: Some(4) };

#[test]
fn snapshots_hold_the_same_particles_on_any_number_of_ranks() {
    let name = "snapshots_hold_the_same_particles_on_any_number_of_ranks";
    let inside = on_ranks(|comm, directory, _| {
        for (dimension, storage, kind) in [(3, PLAIN, "3d"), (2, PLAIN, "2d"), (3, SMALL, "small")] {
            let path = directory.join(format!("{kind}_{}.vtkhdf", comm.size()));
            assert!(write_snapshot(&path, dimension, storage, comm), "{kind}: a write was not collective");
            let left = path.with_extension("vtkhdf.tmp").exists();
            assert!(!left, "the temporary file is left");
        }
        extend_series(&directory.join("snapshot.vtkhdf.series"), "3d_2.vtkhdf", 1.5, comm).unwrap();
    });
    if inside {
        return;
    }
    let directory = tempfile::tempdir().unwrap();
    [1, 2, 3].into_iter().for_each(|ranks| launch(name, ranks, directory.path(), ""));
    for kind in ["3d", "2d", "small"] {
        let of = |ranks: usize| contents(&directory.path().join(format!("{kind}_{ranks}.vtkhdf")));
        let alone = of(1);
        assert_eq!(alone.len(), 2 * SITES as usize);
        assert!(alone == of(2) && alone == of(3), "{kind}");
    }
    let Ok(python) = std::env::var("SPH_MPI_PYTHON") else {
        println!("skipped: SPH_MPI_PYTHON names no Python with h5py and vtk");
        return;
    };
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/read_snapshot.py");
    for kind in ["3d_2", "2d_2", "small_3"] {
        let file = directory.path().join(format!("{kind}.vtkhdf"));
        let output = Command::new(&python).arg(script).arg(file).output().unwrap();
        assert!(output.status.success(), "{kind}: {}", String::from_utf8_lossy(&output.stderr));
    }
}

fn meta() -> CheckpointMeta {
    CheckpointMeta {
        scene: "abc".into(),
        reals: vec![("time".into(), 0.1.into()), ("dt".into(), f64::NAN.into())],
        integers: vec![("step".into(), u64::MAX)],
        json: "{\"counters\": [1, 2]}".into(),
    }
}

/// Of a scene that says no more than its title.
fn read_newest(directory: &Path, registry: &Registry, comm: &Comm, scene: &str) -> Result<Option<Checkpoint>> {
    let differs = |before: &str| (before != scene).then(|| format!("`title` was {before} and now is {scene}"));
    checkpoint::read_newest(directory, registry, comm, &differs)
}

#[test]
fn a_checkpoint_of_two_ranks_is_read_by_any_number() {
    let name = "a_checkpoint_of_two_ranks_is_read_by_any_number";
    let inside = on_ranks(|comm, directory, stage| {
        let whole = scene(3, comm, None);
        let hash = state_hash(&whole.columns, whole.core.id, b"", comm);
        if stage == "write" {
            checkpoint::write(directory, &whole.columns, whole.core.id, &meta(), comm).unwrap();
            return;
        }
        let read = read_newest(directory, &whole.columns.registry, comm, "abc").unwrap().unwrap();
        assert_eq!(state_hash(&read.columns, whole.core.id, b"", comm), hash);
        let share = 2 * SITES as usize;
        assert_eq!(read.columns.len(), share * (comm.rank() + 1) / comm.size() - share * comm.rank() / comm.size());
        assert_eq!(read.meta, meta());
        assert!(read.refused.is_none() && read.meta.real("dt").unwrap().is_nan());
        assert_eq!((read.meta.real("time"), read.meta.integer("step")), (Some(0.1), Some(u64::MAX)));
        let error = read_newest(directory, &whole.columns.registry, comm, "other").unwrap_err();
        assert!(error.what.contains("another scene: `title` was abc and now is other"), "{error}");
        let none = read_newest(&directory.join("none"), &whole.columns.registry, comm, "abc").unwrap();
        assert!(none.is_none());
    });
    if !inside {
        let directory = tempfile::tempdir().unwrap();
        launch(name, 2, directory.path(), "write");
        [1, 2, 3].into_iter().for_each(|ranks| launch(name, ranks, directory.path(), "read"));
    }
}

#[test]
fn a_damaged_checkpoint_gives_way_to_the_previous_one() {
    let name = "a_damaged_checkpoint_gives_way_to_the_previous_one";
    let inside = on_ranks(|comm, directory, stage| {
        let mut scene = scene(3, comm, None);
        let first = state_hash(&scene.columns, scene.core.id, b"", comm);
        if stage == "write" {
            checkpoint::write(directory, &scene.columns, scene.core.id, &meta(), comm).unwrap();
            for i in 0..scene.columns.len() {
                scene.columns.set(scene.damage, i, 0.75);
            }
            checkpoint::write(directory, &scene.columns, scene.core.id, &meta(), comm).unwrap();
            return;
        }
        let read = read_newest(directory, &scene.columns.registry, comm, if stage == "other" { stage } else { "abc" });
        if stage == "other" {
            // The newest is damaged, the one before of another scene: both are told.
            let error = read.unwrap_err();
            for part in ["checkpoint.h5: cannot open", "checkpoint_previous.h5: the checkpoint belongs"] {
                assert!(error.what.contains(part) && error.bad_input, "{error}");
            }
            return;
        }
        if stage == "no other" {
            let error = read.unwrap_err();
            assert!(error.what.contains("no whole checkpoint is left"), "{error}");
            return;
        }
        let read = read.unwrap().unwrap();
        assert!(read.path.ends_with("checkpoint_previous.h5"));
        assert_eq!(state_hash(&read.columns, scene.core.id, b"", comm), first);
        let refused = read.refused.unwrap().to_string();
        assert!(refused.contains("checkpoint.h5") && refused.contains(stage), "{refused}");
    });
    if inside {
        return;
    }
    let directory = tempfile::tempdir().unwrap();
    launch(name, 2, directory.path(), "write");
    let newest = directory.path().join("checkpoint.h5");
    let whole = std::fs::read(&newest).unwrap();
    let mut flipped = whole.clone();
    // Damage is 0.75 on all particles of the newest file: flip one bit of one of them.
    let run: Vec<u8> = 0.75f64.to_le_bytes().repeat(4);
    let at = flipped.windows(run.len()).position(|bytes| bytes == run).unwrap();
    flipped[at + 8] ^= 1;
    std::fs::write(&newest, &flipped).unwrap();
    launch(name, 2, directory.path(), "the column damage does not match its checksum");
    std::fs::write(&newest, &whole[..whole.len() / 2]).unwrap();
    launch(name, 3, directory.path(), "cannot open");
    launch(name, 2, directory.path(), "other");
    std::fs::write(directory.path().join("checkpoint_previous.h5"), b"no such thing").unwrap();
    launch(name, 2, directory.path(), "no other");
}

#[test]
fn failures_are_errors_on_all_ranks() {
    let name = "failures_are_errors_on_all_ranks";
    let inside = on_ranks(|comm, directory, _| {
        let scene = scene(3, comm, None);
        let nowhere = directory.join("missing");
        let error = checkpoint::write(&nowhere, &scene.columns, scene.core.id, &meta(), comm).unwrap_err();
        assert!(error.place.contains("missing"), "{error}");
        assert!(History::open(&nowhere.join("history.csv"), &[("step", "")], None, comm).is_err());
        let one_fails = if comm.rank() == 1 { Err(sph_mpi::error::Error::new("disk full")) } else { Ok(()) };
        assert_eq!(sph_mpi::output::agree(comm, one_fails).unwrap_err().what, "disk full");
        let file = CollectiveFile::create(&directory.join("a.h5"), comm).unwrap();
        file.write("/numbers", &[comm.rank() as f64; 3], 1, None).unwrap();
        assert!(file.write("/numbers", &[0.0], 1, None).is_err(), "a name that is taken");
        assert!(file.read::<f64>("/absent", 1, 0..1).is_err());
        assert!(file.read::<u64>("/numbers", 1, 0..1).is_err(), "another type");
        assert!(file.read::<f64>("/numbers", 1, 0..7).is_err(), "more rows than there are");
        assert_eq!(file.read::<f64>("/numbers", 1, 2..4).unwrap(), [0.0, 1.0]);
        file.close().unwrap();
    });
    if !inside {
        let directory = tempfile::tempdir().unwrap();
        launch(name, 2, directory.path(), "");
    }
}

#[test]
fn the_picture_does_not_depend_on_ranks() {
    let name = "the_picture_does_not_depend_on_ranks";
    let inside = on_ranks(|comm, directory, _| {
        let scene = scene(3, comm, None);
        let plane = Plane { origin: Vec3::new(0.0, 0.0, 230.0), across: Vec3::x(), up: Vec3::y() };
        let path = directory.join(format!("cut_{}.png", comm.size()));
        let picture = Picture { title: "Two blocks".into(), plane, ejected: None, distention: 1.0 };
        cut::draw(&path, &picture, &scene.columns, &BODIES, comm).unwrap();
    });
    if inside {
        return;
    }
    let directory = tempfile::tempdir().unwrap();
    [1, 2, 3].into_iter().for_each(|ranks| launch(name, ranks, directory.path(), ""));
    let of = |ranks: usize| std::fs::read(directory.path().join(format!("cut_{ranks}.png"))).unwrap();
    assert!(of(1) == of(2) && of(1) == of(3));
}

#[test]
fn every_pixel_of_a_cut_shows_the_nearest_particle() {
    let name = "every_pixel_of_a_cut_shows_the_nearest_particle";
    let inside = on_ranks(|comm, _, _| {
        let dot = |k: u64| {
            let draw = |n: u64| sph_mpi::random::uniform(4, k, n);
            // Dots come in coincident pairs, shared by two ranks: the lower id must win.
            let at = |n: u64| sph_mpi::random::uniform(5, k / 2, n) - 0.5;
            let position = Vec3::new(at(0), at(1), 0.2 * at(2));
            Dot { id: k << 30, position, reach: 0.08, values: [draw(0), draw(1)] }
        };
        let all: Vec<Dot> = (0..600).map(dot).chain([Dot { position: Vec3::new(1e4, 0.0, 0.0), ..dot(600) }]).collect();
        let mine: Vec<Dot> = all.iter().copied().skip(comm.rank()).step_by(comm.size()).collect();
        let plane = Plane { origin: Vec3::zeros(), across: Vec3::x(), up: Vec3::y() };
        let found = window(&plane, &mine, 40, comm);
        assert!(found.half < 0.8, "one far fragment must not shrink the rest: {found:?}");
        let window = Window { centre: [0.0; 2], half: 0.6, side: 40 };
        let raster = rasterise(&plane, window, &mine, comm);
        for pixel in 0..40 * 40 {
            let point = Vec3::new((pixel % 40) as f64 * 0.03 - 0.585, (pixel / 40) as f64 * 0.03 - 0.585, 0.0);
            let near = all.iter().map(|d| ((d.position - point).norm(), d)).filter(|(r, d)| *r < d.reach);
            let best = near.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.id.cmp(&b.1.id)));
            let expected = best.map(|(_, d)| d.values);
            let shown = [raster.panels[0][pixel], raster.panels[1][pixel]];
            assert!(expected.map_or(shown[0].is_nan(), |values| values == shown), "{point}: {shown:?}, {expected:?}");
        }
    });
    if !inside {
        let directory = tempfile::tempdir().unwrap();
        [1, 3].into_iter().for_each(|ranks| launch(name, ranks, directory.path(), ""));
    }
}

/// What is given to MPI is what MPI says of the open file, until other hints are given.
#[test]
fn hints_reach_the_file() {
    let directory = tempfile::tempdir().unwrap();
    let on_ranks = on_ranks(|comm, directory, _| {
        let path = directory.join("hints.h5");
        let hints_of = |file: CollectiveFile| {
            let hints = file.hints().unwrap();
            file.close().unwrap();
            hints
        };
        let given = [("cb_nodes", "1"), ("striping_factor", "8")];
        comm.set_file_hints(given);
        for open in [CollectiveFile::create, CollectiveFile::open] {
            let found = hints_of(open(&path, comm).unwrap());
            for (key, value) in given {
                assert!(found.iter().any(|(k, v)| (k.as_str(), v.as_str()) == (key, value)), "{key} in {found:?}");
            }
        }
        comm.set_file_hints([]);
        let found = hints_of(CollectiveFile::create(&path, comm).unwrap());
        assert!(found.iter().all(|(key, _)| key != "striping_factor"), "{found:?}");
    });
    if !on_ranks {
        launch("hints_reach_the_file", 2, directory.path(), "");
    }
}
