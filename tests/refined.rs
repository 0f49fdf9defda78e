//! Impacts whose target is finer where it is hit: seams, energy, what layers, probes and outcomes mean by the target, and the
//! same bits on any ranks.

use sph_mpi::kernel::{CubicSpline, Shape};
use sph_mpi::simulation::results::probes;

use crate::common::{ByHand, Launch, ranks, summary};

/// A small ball onto one of a hundred times its size; about 5000 particles.
const REFINED: &str = r#"
title = "A pebble onto a boulder that is fine where it is hit"

[[body]]
name = "target"
shape = { sphere = { radius = "10 m" } }
material = "basalt"
spacing = "2.4 m"

[[body]]
name = "projectile"
shape = { sphere = { radius = "60 cm" } }
material = "basalt"
least_particles = 40

[impact]
speed = "1 km/s"
angle = "30 deg"
refine = { radius = "1.6 m" }

[material.basalt.strength]
[material.basalt.fracture]

[[probe]]
name = "whole"
body = "target"

[numerics]
corrected_gradient = true

[run]
until = "1.5 ms"
"#;

/// Where parts of different spacing meet, the number density is that of the lattice on the whole. Within
/// a smoothing length of a seam single particles differ by more: two lattices meet there as chance has it.
#[test]
fn seams_are_filled() {
    ranks(1, "refined::seams_are_filled", |comm| {
        let hand = ByHand::<3>::with(REFINED, &[], comm, |_, _, _| {});
        let constants = &hand.stepper.settings.view.constants;
        let volume = |i: usize| constants[hand.body(i)].particle_mass / constants[hand.body(i)].density;
        let cut = hand.scene.bodies[2].cut.expect("a part");
        let point = sph_mpi::math::Vec3::from(cut.point);
        let seams: Vec<f64> =
            hand.scene.bodies.iter().filter_map(|body| body.cut).map(|cut| cut.inner).filter(|r| *r > 0.0).collect();
        assert!(seams.len() >= 2, "{seams:?}");
        let mut found = Vec::new();
        for seam in seams {
            let (mut sum, mut whole, mut number, mut worst) = (0.0, 0.0, 0, 0.0f64);
            for i in hand.particles().filter(|&i| hand.body(i) != 1) {
                let (x, h) = (hand.position(i), constants[hand.body(i)].smoothing_length);
                // Deep inside, so that no surface cuts the kernel.
                if ((x - point).norm() - seam).abs() > h || x.norm() + 3.0 * h > 10.0 {
                    continue;
                }
                let share = |j: usize| {
                    let h_ij = 0.5 * (h + constants[hand.body(j)].smoothing_length);
                    let w = CubicSpline::value((hand.position(j) - x).norm() / h_ij);
                    volume(j) * w * CubicSpline::normalisation::<3>() / (h_ij * h_ij * h_ij)
                };
                let filled: f64 = hand.particles().map(share).sum();
                (sum, whole, number) = (sum + volume(i) * filled, whole + volume(i), number + 1);
                worst = worst.max((filled - 1.0).abs());
            }
            let mean = sum / whole;
            println!("seam at {seam} m: {number} particles, mean {mean}, worst {worst}");
            found.push((number, mean, worst));
        }
        // 1.04, 1.13, 0.99 from the outermost seam: fine particles see heavy ones beside them by chance.
        let filled =
            |(number, mean, worst): &(i32, f64, f64)| *number > 20 && (mean - 1.0).abs() < 0.16 && *worst < 0.6;
        assert!(found.iter().all(filled), "{found:?}");
    });
}

/// Energy is conserved, the same state comes out of one rank and two, and the target is all of its parts: its mass, and what a
/// probe of it sees.
#[test]
fn a_small_projectile_on_a_refined_target() {
    let hashes = [1, 2].map(|n| {
        let dir = tempfile::tempdir().expect("a temporary directory");
        Launch::in_directory(n, dir.path(), REFINED, &[]).run().expect_code(0);
        let run = dir.path().join("run");
        let said = summary(&run);
        let number = |key: &str| said[key].as_f64().unwrap_or_else(|| panic!("{key}: {said}"));
        println!("{} particles, drift {:e}, {:e}", said["particles"], number("energy_drift"), number("momentum_drift"));
        assert!(number("energy_drift").abs() < 2e-3 && number("momentum_drift").abs() < 1e-10);
        said["state_hash"].clone()
    });
    assert_eq!(hashes[0], hashes[1]);
}

/// Before contact the target is one fragment across its seams, as heavy as the exact shape; `--check` lists its parts.
#[test]
fn a_refined_target_is_whole() {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let said = Launch::in_directory(1, dir.path(), REFINED, &["--check"]).run().expect_code(0);
    for part in ["target within 1.6 m", "target within 3.2 m"] {
        assert!(said.stdout.contains(part), "{}", said.stdout);
    }
    Launch::in_directory(1, dir.path(), REFINED, &["--set", "run.until=20 us"]).run().expect_code(0);
    let outcome = summary(&dir.path().join("run"))["outcome"].clone();
    let figure = |name: &str| outcome[name].as_f64().unwrap_or_else(|| panic!("{name}: {outcome}"));
    let exact = 2700.0 * 4.0 / 3.0 * std::f64::consts::PI * 1e3;
    assert!((figure("target_mass") / exact - 1.0).abs() < 1e-14);
    assert!((figure("largest_fragment_fraction") - 1.0).abs() < 1e-12 && figure("fragments") == 2.0, "{outcome}");
}

/// Layers and probes of the target hold all of its parts.
#[test]
fn layers_and_probes_hold_all_parts() {
    ranks(1, "refined::layers_and_probes_hold_all_parts", |comm| {
        let layer = "[[layer]]\nbody = \"target\"\nx = [\"9 m\", \"20 m\"]\nmotion = \"fixed\"\n[numerics]";
        let text = REFINED.replace("[numerics]", layer);
        let hand = ByHand::<3>::with(&text, &["impact.angle=0"], comm, |_, _, _| {});
        let layers = hand.numbers("layer");
        let expected = |i: usize| (hand.body(i) != 1 && hand.position(i).x >= 9.0) as u8 as f64;
        assert!(hand.particles().all(|i| layers[i] == expected(i)));
        assert!(hand.particles().filter(|&i| hand.body(i) >= 2 && layers[i] == 1.0).count() > 50);
        let [pressure, density] = probes::row(&hand.scene, &hand.stepper, comm)[..] else { panic!("two figures") };
        let (mut volumes, mut pressures, mut mass) = (0.0, 0.0, 0.0);
        for i in hand.particles().filter(|&i| hand.body(i) != 1) {
            let m = hand.stepper.settings.view.constants[hand.body(i)].particle_mass;
            let volume = m / hand.numbers("density")[i];
            (volumes, pressures, mass) =
                (volumes + volume, pressures + volume * hand.get::<f64>("pressure", i), mass + m);
        }
        assert!((mass / hand.scene.bodies[0].whole_mass() - 1.0).abs() < 1e-12);
        assert!((density / (mass / volumes) - 1.0).abs() < 1e-12);
        assert!((pressure - pressures / volumes).abs() <= 1e-9 * pressure.abs());
    });
}
