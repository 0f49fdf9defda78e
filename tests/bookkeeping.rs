//! What a run counts and tells, against sums made by hand: tables of what an impact left, pairs, the times of snapshots.

use std::collections::BTreeMap;

use crate::common::{ByHand, Launch, launch, on_rank, ranks, summary};
use sph_mpi::gravity::G;
use sph_mpi::math::Vec3;
use sph_mpi::outcome::distributions::distributions;
use sph_mpi::outcome::reaccumulated::Remnant;
use sph_mpi::outcome::{CentreOfMass, Evaluation, Outcome, Piece, Strict};

/// A piece of this mass, which flies along x, seen from a frame that does so with 10 m/s.
fn piece(label: u64, count: u64, mass: f64, speed: f64) -> Piece {
    let position = Vec3::new(1.0 + label as f64, 2.0, 2.0);
    let velocity = Vec3::new(10.0 + speed, 20.0, 0.0);
    Piece {
        label,
        count,
        mass,
        volume: std::f64::consts::PI / 6.0 * (label as f64).powi(3),
        position,
        velocity,
        of: [mass, 0.0],
    }
}

/// Two fragments and two loose particles of 1000 kg in all; the fragments are the largest remnant.
fn left() -> Evaluation {
    let outcome = Outcome {
        target_mass: 900.0,
        total_mass: 1000.0,
        largest_remnant_particles: 16,
        fragments: 2,
        strict: Strict { fragments: 2, ..Strict::default() },
        ..Outcome::default()
    };
    let pieces =
        vec![piece(3, 12, 600.0, 3.0), piece(2, 4, 200.0, -1.2), piece(8, 1, 100.0, 100.0), piece(9, 1, 100.0, 0.0)];
    let centre = CentreOfMass { position: Vec3::new(1.0, 2.0, 2.0), velocity: Vec3::new(10.0, 20.0, 0.0) };
    Evaluation { outcome, pieces, in_largest: vec![true, true, false, false], labels: Vec::new(), centre, mass: 1000.0 }
}

fn numbers(line: &str) -> Vec<f64> {
    line.split(',').map(|cell| cell.parse().unwrap_or_else(|_| panic!("{line}"))).collect()
}

fn rows(table: &str) -> Vec<Vec<f64>> {
    table.lines().skip(1).map(numbers).collect()
}

/// Bins of a factor of two in mass: every number of the table, and no bin missing.
#[test]
fn sizes_by_hand() {
    ranks(1, "bookkeeping::sizes_by_hand", |comm| {
        let sizes = distributions(comm, &left(), 3).sizes;
        let expected = [
            [500.0, 1.0, 600.0, 0.0, 0.0],
            [250.0, 1.0, 600.0, 0.0, 0.0],
            [125.0, 2.0, 800.0, 0.0, 0.0],
            [62.5, 2.0, 800.0, 2.0, 200.0],
        ];
        assert_eq!(rows(&sizes), expected);
    });
}

/// From 100 m/s down to nothing, in steps of a factor sqrt(2) whose edges are powers of it, as seen from the common centre.
#[test]
fn velocities_by_hand() {
    ranks(1, "bookkeeping::velocities_by_hand", |comm| {
        let velocities = distributions(comm, &left(), 3).velocities;
        let rows = rows(&velocities);
        assert_eq!(rows.len(), 42, "{velocities}");
        for (k, row) in rows.iter().enumerate() {
            let edge = if k == 41 { 0.0 } else { libm::exp2(6.5 - 0.5 * k as f64) };
            assert!((row[0] - edge).abs() <= 1e-12 * edge, "{row:?}");
            let faster = |speed: f64| f64::from(u8::from(speed > edge));
            let loose = if k == 41 { 2.0 } else { 1.0 };
            let (count, mass) = (faster(3.0) + faster(1.2), 600.0 * faster(3.0) + 200.0 * faster(1.2));
            assert_eq!(row[1..], [count, mass, loose, 100.0 * loose], "{row:?}");
        }
    });
}

/// Label, particles, mass, diameter, velocity and distance from the common centre, and whether it is of the largest remnant.
#[test]
fn fragments_by_hand() {
    ranks(1, "bookkeeping::fragments_by_hand", |comm| {
        let listed = rows(&distributions(comm, &left(), 3).fragments);
        let expected =
            [[3.0, 12.0, 600.0, 3.0, 3.0, 0.0, 0.0, 3.0, 1.0], [2.0, 4.0, 200.0, 2.0, -1.2, 0.0, 0.0, 2.0, 1.0]];
        assert_eq!(listed.len(), 2);
        for (found, expected) in listed.iter().flatten().zip(expected.as_flattened()) {
            assert!((found - expected).abs() < 1e-12, "{listed:?}");
        }
    });
}

/// The inner motion of a remnant, wherever it flies as a whole.
#[test]
fn the_motion_of_a_remnant_is_that_within_it() {
    ranks(1, "bookkeeping::the_motion_of_a_remnant_is_that_within_it", |comm| {
        let found = Remnant::of(&left(), comm);
        // 3 and -1.2 m/s about their mean by mass, 1.95 m/s.
        let kinetic = 0.5 * 600.0 * 1.05f64.powi(2) + 0.5 * 200.0 * 3.15f64.powi(2);
        assert!((found.mass - 800.0).abs() < 1e-12 && (found.kinetic / kinetic - 1.0).abs() < 1e-12, "{found:?}");
        let radius = libm::cbrt((27.0 + 8.0) / 8.0);
        assert!((found.binding / (G * 800.0 * 800.0 / radius) - 1.0).abs() < 1e-12);
        // Seen from elsewhere it is the same.
        let mut faster = left();
        faster.pieces.iter_mut().for_each(|piece| piece.velocity.x += 300.0);
        assert!((Remnant::of(&faster, comm).kinetic / kinetic - 1.0).abs() < 1e-9);
    });
}

const BALL: &str = "[[body]]\nname = \"ball\"\nshape = { sphere = { radius = 1 } }\nmaterial = \"basalt\"\nspacing = 0.3\n\
    spin = [0, 0, 1]\n[run]\nuntil = \"1 ms\"\n[output]\nsnapshots = 4\nhistory_every = 3\npicture = false\n";

/// A ball that hardly moves: pairs in each evaluation are those that can be counted, each snapshot has the time that the list of
/// snapshots gives it, and rows of the history follow each other by their steps.
#[test]
fn pairs_times_and_rows_of_a_run() {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let counted = on_rank(|comm| {
        let hand = ByHand::<3>::new(BALL, comm, |_| {});
        let h = hand.stepper.settings.view.constants[0].smoothing_length;
        let near =
            |i: usize| hand.particles().filter(|&j| (hand.position(i) - hand.position(j)).norm() < 2.0 * h).count() - 1;
        let pairs = hand.particles().map(near).sum::<usize>() as f64;
        format!("{}", pairs / hand.particles().len() as f64)
    });
    if counted {
        return;
    }
    let per_particle: f64 = launch(1, "bookkeeping::pairs_times_and_rows_of_a_run", &[]).parse().expect("a number");
    Launch::in_directory(1, dir.path(), BALL, &[]).run().expect_code(0);
    let out = dir.path().join("run");
    let summary = summary(&out);
    let number = |key: &str| summary[key].as_f64().unwrap_or_else(|| panic!("{key}: {}", summary[key]));
    let evaluations = (number("updates_per_core_second") * number("core_seconds") / number("particles")).round();
    assert_eq!(evaluations, number("steps") + 1.0);
    let pairs = evaluations * number("particles") * per_particle;
    assert!((number("pair_interactions") / pairs - 1.0).abs() < 1e-12, "{pairs} {}", summary["pair_interactions"]);

    let text = std::fs::read_to_string(out.join("snapshots.vtkhdf.series")).expect("a list of snapshots");
    let series: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let files = series["files"].as_array().expect("files");
    assert!(files.len() >= 4, "{text}");
    let mut times = Vec::new();
    for file in files {
        let name = file["name"].as_str().expect("a name");
        let snapshot = hdf5::File::open(out.join(name)).unwrap_or_else(|e| panic!("{name}: {e}"));
        let time = snapshot.group("/run").and_then(|run| run.attr("time")).and_then(|time| time.read_scalar::<f64>());
        let time = time.unwrap_or_else(|e| panic!("{name}: {e}"));
        assert_eq!(Some(time), file["time"].as_f64(), "{name}");
        times.push(time);
    }
    assert!(times[0] == 0.0 && times.is_sorted_by(|a, b| a < b), "{times:?}");
    assert_eq!(times.last(), Some(&1e-3));

    let history = std::fs::read_to_string(out.join("history.csv")).expect("a history");
    let header: BTreeMap<&str, usize> = history.lines().next().expect("a header").split(',').zip(0..).collect();
    let rows: Vec<Vec<&str>> = history.lines().skip(1).map(|line| line.split(',').collect()).collect();
    let at = |row: &[&str], name: &str| row[header[name]].parse::<f64>().unwrap_or_else(|_| panic!("{name}: {row:?}"));
    let steps: Vec<f64> = rows.iter().map(|row| at(row, "step")).collect();
    let last = number("steps");
    let expected: Vec<f64> = (0..).map(|k| 3.0 * k as f64).take_while(|step| *step < last).chain([last]).collect();
    assert_eq!(steps, expected);
    // Of the start: a rigid turn, 1/2 I w^2 with I of the particles, nothing inside, all of it angular momentum about z.
    let first = &rows[0];
    let [kinetic, total, turning] =
        ["kinetic_energy [J]", "total_energy [J]", "angular_momentum_z [kg m^2/s]"].map(|name| at(first, name));
    assert!((kinetic / (0.5 * turning) - 1.0).abs() < 1e-12 && (total - kinetic).abs() < 1e-12 * kinetic, "{first:?}");
}
