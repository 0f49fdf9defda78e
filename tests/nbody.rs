//! Bodies for an N-body program: REBOUND opens them, on any ranks they are the same, nothing gets lost.

use std::fs;
use std::path::Path;
use std::process::Command;

use sph_mpi::math::Vec3;
use sph_mpi::outcome::Particle;
use sph_mpi::outcome::nbody::{Choice, spheres};
use sph_mpi::random::uniform;
use sph_mpi::scene::Scene;

use crate::common::{Launch, same_on_any_ranks, summary};

/// A ball of rock is broken.
const IMPACT: &str = r#"
title = "Fragments, handed on"

[[body]]
name = "target"
shape = { sphere = { radius = "10 km" } }
material = "basalt"
particles = 900

[[body]]
name = "projectile"
shape = { sphere = { radius = "3 km" } }
material = "basalt"
spacing = "1.8 km"

[impact]
speed = "1 km/s"
angle = "45 deg"

[material.basalt.strength]
[material.basalt.fracture]

[gravity]
self = { accuracy = 0.02, interval = 0.003 }

[late_stage]
at = "20 s"
sound_speed = "100 m/s"

[nbody]
smallest = 1

[numerics]
corrected_gradient = true

[run]
until = "300 s"

[output]
picture = false
"#;

/// The files of a run on so many ranks, and what REBOUND says of them, where there is a Python that has it.
fn files(ranks: usize, changes: &[&str]) -> (Vec<u8>, serde_json::Value) {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let more: Vec<&str> = changes.iter().flat_map(|change| ["--set", change]).collect();
    Launch::in_directory(ranks, dir.path(), IMPACT, &more).run().expect_code(0);
    let run = dir.path().join("run");
    if let Some(python) = std::env::var_os("SPH_MPI_PYTHON") {
        let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("nbody.py");
        let output = Command::new(python).arg(script).arg(&run).output().expect("Python starts");
        let (said, error) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
        assert!(output.status.success(), "{error}");
        println!("{}", said.trim());
    } else {
        println!("nbody.bin is not opened: SPH_MPI_PYTHON names no Python with rebound");
    }
    let read = |name: &str| fs::read(run.join(name)).expect("a file of bodies");
    ([read("nbody.csv"), read("nbody.bin")].concat(), summary(&run)["nbody"].clone())
}

#[test]
fn rebound_opens_what_a_run_hands_on() {
    let (alone, figures) = files(1, &[]);
    let (shared, _) = files(3, &[]);
    assert!(alone == shared, "the files differ between 1 and 3 ranks");
    let number = |figures: &serde_json::Value, key: &str| figures[key].as_f64().expect("a number");
    assert!(number(&figures, "bodies") > 10.0 && number(&figures, "left_out") == 0.0, "{figures}");
    let (_, few) = files(2, &["nbody.smallest=2", "nbody.most=5"]);
    assert_eq!(number(&few, "bodies"), 5.0, "{few}");
    assert_eq!(number(&few, "bodies") + number(&few, "left_out"), number(&figures, "bodies"), "{few}");
    assert!(number(&few, "left_out_mass") > 0.0 && number(&few, "left_out_momentum_x") != 0.0);
}

/// Broken matter of a pile at rest is one body, of spray none; the pile turns and is one still.
#[test]
fn a_pile_is_one_body_and_spray_is_many() {
    same_on_any_ranks("nbody::a_pile_is_one_body_and_spray_is_many", |comm| {
        let mut all = Vec::new();
        for n in 0..1000u64 {
            let site = [0, 1, 2].map(|k| (n / 10u64.pow(k) % 10) as f64 - 4.5 + 0.1 * uniform(3, n, k as u64));
            let (pile, x) = (Vec3::from(site) * 1e3, Vec3::from(site) * 1e3 + Vec3::new(1e5, 0.0, 0.0));
            let mut add = |id: u64, position: Vec3, velocity: Vec3| {
                let (mass, volume) = (2.7e12, 1e9);
                all.push(Particle { id, body: 0, position, velocity, mass, volume, spacing: 1e3, damage: 1.0 });
            };
            // Turning at half the rate at which it would break up, 8.7e-4 /s; flying apart at three times that of escape.
            add(2 * n, pile, Vec3::z().cross(&pile) * 4.3e-4);
            add(2 * n + 1, x, Vec3::from(site) * 1e3 * 3.7e-3);
        }
        let share = |rank: usize| all.len() * rank / comm.size();
        let mine = &all[share(comm.rank())..share(comm.rank() + 1)];
        let (bodies, left_out) = spheres(comm, mine, &Choice { smallest: 1, most: 5000 });
        assert_eq!(left_out.pieces, 0.0);
        if comm.is_root() {
            assert_eq!((bodies.len(), bodies[0].particles, bodies[0].label), (1001, 1000, 0));
            assert!((bodies[0].mass / 2.7e15 - 1.0).abs() < 1e-14 && bodies[1].particles == 1);
            let radius = (1e12 * 0.75 / std::f64::consts::PI).cbrt();
            assert!((bodies[0].radius / radius - 1.0).abs() < 1e-14);
        }
        format!("{bodies:?}")
    });
}

#[test]
fn what_cannot_be_handed_on_is_refused() {
    for (change, said) in [
        ("nbody.smallest=0", "too few"),
        ("nbody.smalest=3", "did you mean `smallest`"),
        ("nbody.most=0", "nbody.most"),
        ("target.shape={ half_sphere = { radius = \"10 km\" } }", "no remnants"),
    ] {
        let error = Scene::parse("scene.toml", IMPACT, &[change.to_string()]).err();
        let found = error.map_or("no error".into(), |error| error.to_string());
        assert!(found.contains(said), "{change}: {found}");
    }
}
