//! What is asked of dust: how deep a body falls into it, how it bounces, and in what pieces it ends; the same on any ranks.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use serde_json::Value;
use sph_mpi::domain::comm::Comm;
use sph_mpi::math::Vec3;
use sph_mpi::outcome::Particle;
use sph_mpi::outcome::populations::{Listed, Question, Word, evaluate};

use crate::common::{Launch, assert_known_files, same_on_any_ranks, summary};

/// A bead falls into a bed of dust, coarsely.
const BEAD: &str = r#"
title = "A bead falls into dust"
dimension = 2

[[body]]
name = "dust"
shape = { half_disc = { radius = "2.4 mm" } }
material = "silica_dust"
spacing = "0.1 mm"

[[body]]
name = "bead"
shape = { disc = { radius = "0.55 mm" } }
position = [0, "0.65 mm"]
velocity = [0, "-0.65 m/s"]
material = "glass"
spacing = "0.1 mm"

[[layer]]
body = "dust"
outer = "0.5 mm"
motion = "fixed"

# A soft glass, whose steps are long.
[material.glass]
eos.murnaghan = { K_0 = "0.3 MPa" }
strength = { shear_modulus = "0.2 MPa", yield_strength = "1 MPa" }

[gravity]
uniform = [0, "-9.81 m/s^2"]

[numerics]
eta = 2
kernel = "cubic_spline"
contact_viscosity = true

[intrusion]
body = "bead"
into = "dust"
ends_run = true

[run]
until = "8 ms"
"#;

fn run(ranks: usize, dir: &Path, scene: &str, more: &[&str]) -> Launch {
    Launch::in_directory(ranks, dir, scene, &[&["--threads", "1"], more].concat()).limit(120)
}

fn figure(summary: &Value, path: &str) -> f64 {
    summary.pointer(path).and_then(Value::as_f64).unwrap_or_else(|| panic!("{path} in {summary:#}"))
}

/// Tables are the same to the bit on one rank, on two, and with a stop in between; and they show a fall.
#[test]
fn a_bead_falls_into_dust() {
    let dirs = [(); 3].map(|()| tempfile::tempdir().expect("a directory"));
    let [alone, shared, stopped] = dirs.each_ref().map(|dir| dir.path());
    run(1, alone, BEAD, &[]).run().expect_code(0);
    run(2, shared, BEAD, &[]).run().expect_code(0);
    run(1, stopped, BEAD, &[]).env("SPH_MPI_FAULT", "stop:0:60").run().expect_code(75);
    run(2, stopped, BEAD, &["--resume"]).run().expect_code(0);
    let found = summary(&alone.join("run"));
    for other in [shared, stopped] {
        assert_eq!(found["intrusion"], summary(&other.join("run"))["intrusion"]);
        for table in ["intrusion.csv", "filling_profile.csv", "filling_volumes.csv", "history.csv"] {
            let read = |dir: &Path| fs::read(dir.join("run").join(table)).unwrap_or_else(|e| panic!("{table}: {e}"));
            assert!(read(alone) == read(other), "{table} in {}", other.display());
        }
    }
    for picture in ["intrusion.png", "filling_profile.png", "filling_volumes.png", "deepest.png"] {
        assert!(alone.join("run").join(picture).exists(), "{picture}");
    }
    assert_known_files(&alone.join("run"));
    let of = |name: &str| figure(&found, &format!("/intrusion/{name}"));
    // Free fall over the gap of 0.1 mm; the run ends with the step in which the bead is deepest.
    assert!((of("contact_speed") - 0.6515).abs() < 0.02, "{found:#}");
    assert!(of("time") == figure(&found, "/time") && of("stopping_time") < of("time"));
    assert!((0.2e-3..1.8e-3).contains(&of("depth")) && of("sine_deviation") < 0.2, "{found:#}");
    // Within the kernel's support of the bead's lowest point. So coarse a profile has no gap.
    assert!((of("peak_depth") - of("depth")).abs() < 0.4e-3 && of("peak_filling_factor") > 0.17, "{found:#}");
    assert!(of("compacted_over_body") > 0.05 && of("filling_factor_of_body_volume") > 0.15, "{found:#}");
    let rows = fs::read_to_string(alone.join("run/history.csv")).expect("a history");
    assert!(rows.starts_with("step") && rows.lines().next().is_some_and(|head| head.contains("intrusion_depth")));
}

/// A bead that does not come to rest is told, and the dust is looked at all the same.
#[test]
fn a_fall_that_is_cut_short_is_told() {
    let dir = tempfile::tempdir().expect("a directory");
    run(1, dir.path(), BEAD, &["--set", "run.steps=20"]).run().expect_code(0);
    let found = summary(&dir.path().join("run"));
    assert!(found["intrusion"]["stopping_time"].is_null() && found["intrusion"]["time"] == found["time"]);
    let kinds: BTreeSet<_> =
        found["warnings"].as_array().into_iter().flatten().map(|w| w["kind"].to_string()).collect();
    assert!(kinds.contains("\"intrusion\""), "{found:#}");
    assert!(dir.path().join("run/filling_profile.csv").exists() && !dir.path().join("run/intrusion.csv").exists());
}

/// Two discs of dust fly into each other.
const DISCS: &str = r#"
title = "Two aggregates"
dimension = 2

[[body]]
name = "left"
shape = { disc = { radius = "0.5 mm" } }
material = "silica_dust"
spacing = "0.05 mm"
velocity = ["0.2 m/s", 0]

[[body]]
name = "right"
shape = { disc = { radius = "0.5 mm" } }
position = ["1.25 mm", 0]
material = "silica_dust"
spacing = "0.05 mm"
velocity = ["-0.2 m/s", 0]

[restitution]
body = "left"
against = "right"

[fragments]
bodies = ["left", "right"]

[numerics]
eta = 2
kernel = "cubic_spline"

[run]
until = "20 ms"
"#;

/// Off a rigid disc the other one bounces; what has parted need not be followed to the end.
#[test]
fn a_bounce_ends_the_run() {
    let more = [
        "right.material=glass",
        "right.rigid=true",
        "numerics.contact_viscosity=true",
        "fragments=false",
        "run.until=8 ms",
    ];
    let found = ["restitution.ends_run=false", "restitution.ends_run=true"].map(|ends| {
        let dir = tempfile::tempdir().expect("a directory");
        let sets: Vec<&str> = more.iter().chain([&ends]).flat_map(|&set| ["--set", set]).collect();
        run(1, dir.path(), DISCS, &sets).run().expect_code(0);
        summary(&dir.path().join("run"))
    });
    let [whole, short] =
        found.each_ref().map(|found| ["/time", "/restitution/coefficient"].map(|of| figure(found, of)));
    println!("coefficients {} and {}, at {} and {} s", whole[1], short[1], whole[0], short[0]);
    assert!(whole[0] == 8e-3 && (1.5e-3..4e-3).contains(&short[0]), "{whole:?} {short:?}");
    assert!(short[1] > 0.02 && (short[1] - whole[1]).abs() < 2e-3, "{whole:?} {short:?}");
}

/// A grazing hit has no coefficient of restitution that means anything.
#[test]
fn a_bounce_that_is_none_is_told() {
    let dir = tempfile::tempdir().expect("a directory");
    let sets = [
        "right.material=glass",
        "right.rigid=true",
        "right.position=[\"1.25 mm\", \"0.9 mm\"]",
        "numerics.contact_viscosity=true",
        "fragments=false",
        "restitution.ends_run=true",
    ];
    run(1, dir.path(), DISCS, &sets.map(|set| ["--set", set]).concat()).run().expect_code(0);
    let found = summary(&dir.path().join("run"));
    assert!(figure(&found, "/restitution/coefficient") < -0.5, "{found:#}");
    let warning = &found["warnings"][0];
    assert!(warning["kind"] == "restitution" && warning.to_string().contains("an oblique hit"), "{found:#}");
}

#[test]
fn two_aggregates_collide() {
    let dirs = [(); 2].map(|()| tempfile::tempdir().expect("a directory"));
    let [alone, shared] = dirs.each_ref().map(|dir| dir.path());
    run(1, alone, DISCS, &[]).run().expect_code(0);
    run(2, shared, DISCS, &[]).run().expect_code(0);
    let found = summary(&alone.join("run"));
    let other = summary(&shared.join("run"));
    for part in ["restitution", "fragments"] {
        assert_eq!(found[part], other[part]);
    }
    for table in ["restitution.csv", "fragment_masses.csv"] {
        let read = |dir: &Path| fs::read(dir.join("run").join(table)).unwrap_or_else(|e| panic!("{table}: {e}"));
        assert!(read(alone) == read(shared), "{table}");
    }
    assert_known_files(&alone.join("run"));
    let of = |name: &str| figure(&found, name);
    assert!((of("/restitution/speed_before") - 0.4).abs() < 1e-12, "{found:#}");
    // Dust loses most of the energy of a bounce.
    assert!((-0.1..0.7).contains(&of("/restitution/coefficient")), "{found:#}");
    let shares = ["largest", "second_largest", "power_law", "rest"].map(|name| of(&format!("/fragments/{name}")));
    assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-12, "{shares:?}");
    let word = found["fragments"]["outcome"].as_str().unwrap_or_default();
    let together = shares[0] > 0.75;
    assert_eq!(word, if together { "sticking" } else { "bouncing" }, "{found:#}");
    assert!(of("/fragments/kept_by_left") > 0.9, "{found:#}");
}

/// One body in pieces of 1, 2, 3, ... particles, another whole beside it.
fn pieces(of: usize) -> Vec<Particle> {
    let particle = |(k, (body, x, y)): (usize, (usize, usize, usize))| Particle {
        id: k as u64,
        body,
        position: Vec3::new(x as f64, 10.0 * y as f64, 0.0),
        velocity: Vec3::zeros(),
        mass: 2.0,
        volume: 1.0,
        spacing: 1.0,
        damage: 0.0,
    };
    let broken = (1..=of).flat_map(|count| (0..count).map(move |k| (0, k, count)));
    let whole = (0..100).map(|k| (1, k, of + 9));
    broken.chain(whole).enumerate().map(particle).collect()
}

#[test]
fn pieces_are_those_that_links_leave() {
    same_on_any_ranks("dust_analysis::pieces_are_those_that_links_leave", |comm: &Comm| {
        let all = pieces(30);
        let mine: Vec<Particle> = all.iter().copied().filter(|p| p.id as usize % comm.size() == comm.rank()).collect();
        let question = Question { bodies: [0, 1], link: 1.5, least_particles: 5, intact: 0.9 };
        let found = evaluate(comm, &mine, &question);
        assert_eq!(found.pieces.len(), 31);
        assert_eq!(found.pieces[0], Listed { mass: 200.0, particles: 100 });
        assert_eq!((found.total, found.resolved), (2.0 * (465.0 + 100.0), 27));
        assert_eq!((found.kept, found.word), ([30.0 / 465.0, 1.0], Some(Word::Fragmentation)));
        // Linked by ten and more all is one piece.
        let one = evaluate(comm, &mine, &Question { link: 100.0, ..question });
        assert_eq!((one.pieces.len(), one.word), (1, Some(Word::Sticking)));
        let whole: Vec<Particle> = mine.iter().copied().filter(|p| p.body == 1).collect();
        let one = evaluate(comm, &whole, &Question { bodies: [1, 1], ..question });
        assert_eq!((one.shares(), one.word, one.law), ([1.0, 0.0, 0.0, 0.0], None, None));
        found.table()
    });
}
