//! Sand and broken rock: friction in whole scenes. `scripts/validate granular` does the columns finer, and over their shape.

use sph_mpi::domain::comm::Comm;
use sph_mpi::math::{Deviator, Vec3};

use crate::common::{ByHand, Launch, assert_as_measured, assert_known_files, ranks, summary};

const COLUMN: &str = include_str!("../inputs/column_collapse.toml");

/// Ten particles along the half width: a column as high as half as wide.
const COARSE: [&str; 7] = [
    "sand.spacing=0.01",
    "sand.size=[0.2, 0.1]",
    "floor.spacing=0.01",
    "floor.size=[1.2, 0.05]",
    "floor.position=[0, -0.025]",
    "output.snapshots=0",
    "output.picture=false",
];

fn column<'c>(changes: &[&str], comm: &'c Comm) -> ByHand<'c, 2> {
    let all: Vec<&str> = COARSE.iter().chain(changes).copied().collect();
    ByHand::with(COLUMN, &all, comm, |_, _, _| {})
}

fn is_sand(hand: &ByHand<2>, i: usize) -> bool {
    hand.id(i) >> 48 == 0
}

/// Sand that lies farther out than `reach`, m, and the mean square of all speeds, m^2/s^2.
fn spread(hand: &ByHand<2>, reach: f64) -> (f64, f64) {
    let velocity = hand.column::<Vec3>("velocity");
    let sand: Vec<usize> = hand.particles().filter(|&i| is_sand(hand, i)).collect();
    let out = sand.iter().filter(|&&i| hand.position(i).x.abs() > reach).count();
    let squares: f64 = sand.iter().map(|&i| hand.stepper.columns.get(velocity, i).norm_squared()).sum();
    (out as f64 / sand.len() as f64, squares / sand.len() as f64)
}

/// The foot of a column as high as half as wide runs 1.2 half widths (Lube et al. 2005): to within a fifth, 22 cm from the middle. It then
/// lies still, at 2 per cent of the speed of its fall. Without friction a sixth of it has flowed beyond that by then and goes on.
#[test]
fn a_column_of_sand_comes_to_rest() {
    ranks(1, "friction::a_column_of_sand_comes_to_rest", |comm| {
        let mut rough = column(&[], comm);
        rough.run(0.5, |_| {});
        let (beyond, square) = spread(&rough, 0.1 * (1.0 + 1.2 * 1.2));
        let (at_foot, _) = spread(&rough, 0.1 * (1.0 + 1.2 * 0.8));
        println!("{beyond:.3} beyond, {at_foot:.3} at the foot, rms {:.2e} m/s", square.sqrt());
        // Single grains roll on: one layer is not a flank. Of 600 particles some must be where the foot is.
        assert!(beyond < 0.02 && at_foot > 0.005, "{beyond} {at_foot}");
        assert!(square.sqrt() < 0.02 * (9.81f64 * 0.1).sqrt(), "{}", square.sqrt());
        let mut smooth = column(&["material.sand.strength.drucker_prager.friction=0"], comm);
        smooth.run(0.3, |_| {});
        let (beyond, square) = spread(&smooth, 0.1 * (1.0 + 1.2 * 1.2));
        println!("without friction: {beyond:.3} beyond, rms {:.2e} m/s", square.sqrt());
        assert!(beyond > 0.1 && square.sqrt() > 0.1 * (9.81f64 * 0.1).sqrt(), "{beyond} {square}");
    });
}

/// The same heap as the program measures it.
#[test]
fn a_heap_is_measured() {
    let dir = tempfile::tempdir().expect("a directory");
    let asked = format!("{COLUMN}\n[deposit]\nbody = \"sand\"\n");
    let set: Vec<&str> = COARSE.iter().flat_map(|change| ["--set", change]).collect();
    Launch::in_directory(1, dir.path(), &asked, &set).run().expect_code(0);
    let run = dir.path().join("run");
    let heap = &summary(&run)["deposit"];
    let of = |name: &str| heap[name].as_f64().expect("a number");
    // Lube et al. 2005: 1.2 half widths, which finer sand reaches, and as high as half as wide.
    assert_as_measured("run-out", of("run_out_99"), 0.9425);
    assert_as_measured("height", of("height_over_half_width"), 0.8846);
    assert!((of("foot") - 0.1 * (1.0 + of("run_out"))).abs() < 1e-12 && of("speed_over_fall") < 0.02, "{heap:#}");
    let table = std::fs::read_to_string(run.join("deposit.csv")).expect("deposit.csv");
    assert!(table.starts_with("distance_m,height_m\n1e-2,") && table.lines().count() > 10, "{table}");
    assert_known_files(&run);
}

/// Gravity, moduli, strength and energies times four: the same fall in half the time, bit for bit.
#[test]
fn scaled_by_a_power_of_four_all_is_the_same() {
    ranks(1, "friction::scaled_by_a_power_of_four_all_is_the_same", |comm| {
        let cohesive = "material.sand.strength.drucker_prager.cohesion=10";
        let scaled = [
            "gravity.uniform=[0, -39.24]",
            "material.sand.eos.simplified_tillotson.A=36.8e5",
            "material.sand.strength.shear_modulus=16e5",
            "material.sand.strength.yield_strength=4e6",
            "material.sand.strength.drucker_prager.cohesion=40",
        ];
        let (mut plain, mut strong) = (column(&[cohesive], comm), column(&scaled, comm));
        for _ in 0..1500 {
            plain.step(f64::INFINITY);
            strong.step(f64::INFINITY);
        }
        assert!(plain.time > 0.05 && spread(&plain, 0.0).1 > 1e-3, "nothing happened by {} s", plain.time);
        assert_eq!(plain.time, 2.0 * strong.time);
        for i in plain.particles() {
            assert_eq!(plain.id(i), strong.id(i));
            assert_eq!(plain.position(i), strong.position(i));
            let of = |hand: &ByHand<2>, name: &str| hand.stepper.columns.get(hand.column::<Vec3>(name), i);
            assert_eq!(2.0 * of(&plain, "velocity"), of(&strong, "velocity"));
            assert_eq!(4.0 * of(&plain, "acceleration"), of(&strong, "acceleration"));
            let number = |hand: &ByHand<2>, name: &str| hand.stepper.columns.get(hand.column::<f64>(name), i);
            assert_eq!(number(&plain, "density"), number(&strong, "density"));
            assert_eq!(4.0 * number(&plain, "internal_energy"), number(&strong, "internal_energy"));
            let stress = |hand: &ByHand<2>| hand.stepper.columns.get(hand.column::<Deviator>("deviatoric_stress"), i);
            assert_eq!(stress(&plain).scaled(4.0), stress(&strong));
        }
    });
}
