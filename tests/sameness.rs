//! The same bits on any number of ranks and threads, with any vector width, and through a checkpoint at any moment.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use serde_json::Value;

use crate::common::{IMPACT, Launch, summary};

/// Where the runs of one comparison lie; emptied first.
fn directory(name: &str) -> PathBuf {
    let dir = Path::new(env!("CARGO_TARGET_TMPDIR")).join("sameness").join(name);
    let _ = fs::remove_dir_all(&dir);
    fs::create_dir_all(&dir).expect("a directory for runs");
    dir
}

/// How a run is made.
#[derive(Clone, Copy)]
struct Way {
    scene: &'static str,
    ranks: usize,
    threads: usize,
    /// Vector width, where it is not left to the program.
    simd: Option<&'static str>,
}

impl Way {
    /// The impact.
    fn new(ranks: usize, threads: usize) -> Self {
        Self { scene: IMPACT, ranks, threads, simd: None }
    }

    fn launch(self, dir: &Path, more: &[&str]) -> Launch {
        let threads = self.threads.to_string();
        let launch = Launch::in_directory(self.ranks, dir, self.scene, &[&["--threads", &threads], more].concat());
        match self.simd {
            Some(width) => launch.env("SPH_MPI_SIMD", width),
            None => launch,
        }
    }

    /// Runs the scene to its end in `dir` and returns its summary.
    fn run(self, dir: &Path) -> Value {
        self.launch(dir, &[]).run().expect_code(0);
        summary(&dir.join("run"))
    }
}

/// Runs a scene in several ways, one after another: each but the last stops at the step named beside it.
fn run_legs(dir: &Path, legs: &[(u64, Way)]) -> Value {
    for (leg, (stop, way)) in legs.iter().enumerate() {
        let launch = way.launch(dir, if leg == 0 { &[] } else { &["--resume"] });
        if leg + 1 == legs.len() {
            launch.run().expect_code(0);
        } else {
            launch.env("SPH_MPI_FAULT", format!("stop:0:{stop}")).run().expect_code(75);
        }
    }
    summary(&dir.join("run"))
}

/// A run that others are compared with: one rank, one thread.
pub type Reference = (PathBuf, Value);

fn run_reference(name: &str, way: Way) -> Reference {
    let dir = directory(name);
    let summary = way.run(&dir);
    (dir, summary)
}

/// Of the impact.
fn reference() -> &'static Reference {
    static REFERENCE: OnceLock<Reference> = OnceLock::new();
    REFERENCE.get_or_init(|| run_reference("reference", Way::new(1, 1)))
}

/// A comparison of runs in which nothing happened would prove nothing.
fn assert_eventful(name: &str, summary: &Value, ranks: usize) {
    let at_least = |pointer: &str, least: f64| {
        let value = summary.pointer(pointer).and_then(Value::as_f64);
        assert!(
            value.is_some_and(|v| v >= least),
            "{name}: {pointer} of summary.json is {value:?}, not at least {least}"
        );
    };
    at_least("/steps", 100.0);
    at_least("/list_builds", 4.0);
    at_least("/outcome/damaged_fraction", 0.01);
    if ranks > 1 {
        at_least("/migrated_particles", 1.0);
        at_least("/rebisections", 1.0);
    }
}

/// Equal to the reference by the hash, which covers the state of every particle, and byte for byte in the history and the last
/// checkpoint.
fn assert_same(name: &str, dir: &Path, found: &Value, (reference_dir, expected): &Reference) {
    for key in ["particles", "steps", "pair_interactions", "state_hash"] {
        assert!(!expected[key].is_null(), "{key} is in summary.json");
        assert_eq!(found[key], expected[key], "{key} of {name}");
    }
    assert_eq!(found["outcome"], expected["outcome"], "outcome of {name}");
    let history = |dir: &Path| fs::read(dir.join("run/history.csv")).expect("a history");
    assert!(history(dir) == history(reference_dir), "history.csv of {name}");
    let Some(python) = std::env::var_os("SPH_MPI_PYTHON") else {
        println!("{name}: columns are not compared: SPH_MPI_PYTHON names no Python with h5py");
        return;
    };
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("columns.py");
    let checkpoint = |dir: &Path| dir.join("run/checkpoint.h5");
    let mut compare = Command::new(python);
    let output =
        compare.arg(script).args([checkpoint(reference_dir), checkpoint(dir)]).output().expect("Python starts");
    let (said, error) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{name}: {error}");
    let words: Vec<&str> = said.split_whitespace().collect();
    assert_eq!(words[0], expected["particles"].to_string(), "all particles were compared");
    // Id, position, velocity, density, energy and their rates at the least.
    assert!(words[2].parse::<usize>().expect("a number") >= 8, "{said}");
}

#[track_caller]
fn compare(name: &str, way: Way) {
    let dir = directory(name);
    let found = way.run(&dir);
    assert_same(name, &dir, &found, reference());
    assert_eventful(name, &found, way.ranks);
}

#[test]
fn ranks_and_threads() {
    assert_eventful("reference", &reference().1, 1);
    for ranks in 1..=4 {
        for threads in 1..=2 {
            if (ranks, threads) != (1, 1) {
                compare(&format!("{ranks}_ranks_{threads}_threads"), Way::new(ranks, threads));
            }
        }
    }
}

#[test]
fn vector_widths() {
    let here = [
        ("portable", true),
        ("avx2", is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma")),
        ("avx512", is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512dq")),
    ];
    for (width, available) in here {
        if available {
            compare(width, Way { simd: Some(width), ..Way::new(2, 1) });
        } else {
            println!("skipped: this processor has no {width}");
        }
    }
}

/// The fault `stop:RANK:STEP` sends the rank SIGUSR1 as it begins that step: the real path of a stop, at a known moment.
#[test]
fn checkpoint_and_resume_on_other_ranks() {
    let steps = reference().1["steps"].as_u64().expect("steps in summary.json");
    // Before the first list is worn out, amid the impact, near the end; and a run that stops twice.
    let legs: [&[(u64, Way)]; 4] = [
        &[(3, Way::new(1, 1)), (0, Way::new(3, 1))],
        &[(steps / 3, Way::new(2, 1)), (0, Way::new(1, 2))],
        &[(steps - 2, Way::new(4, 1)), (0, Way::new(2, 1))],
        &[(steps / 4, Way::new(3, 1)), (steps / 2 + 1, Way::new(2, 2)), (0, Way::new(4, 1))],
    ];
    for (i, legs) in legs.iter().enumerate() {
        let name = format!("resume_{i}");
        let dir = directory(&name);
        let found = run_legs(&dir, legs);
        assert_same(&name, &dir, &found, reference());
    }
}

/// A scene on other ranks and threads, and through a checkpoint. Where the run on one rank lies, and its summary.
pub fn compare_scene(name: &str, scene: &'static str) -> Reference {
    let way = |ranks, threads| Way { scene, ..Way::new(ranks, threads) };
    let reference = run_reference(&format!("{name}_reference"), way(1, 1));
    let steps = reference.1["steps"].as_u64().expect("steps in summary.json");
    assert!(steps >= 50 && reference.1["list_builds"].as_u64().is_some_and(|n| n >= 3), "{name}: {}", reference.1);
    for (i, legs) in
        [&[(0, way(2, 2))][..], &[(0, way(3, 1))], &[(steps / 2, way(4, 1)), (0, way(1, 2))]].iter().enumerate()
    {
        let name = format!("{name}_{i}");
        let dir = directory(&name);
        let found = run_legs(&dir, legs);
        assert_same(&name, &dir, &found, &reference);
    }
    reference
}

/// Strong rock that breaks, under artificial stress, in the plane.
pub const DISCS: &str = r#"
title = "Two discs"
dimension = 2

[[body]]
name = "target"
shape = { sphere = { radius = "1 km" } }
material = "basalt"
particles = 900

[[body]]
name = "projectile"
shape = { sphere = { radius = "300 m" } }
material = "basalt"

[impact]
speed = "5 km/s"
angle = "30 deg"

[material.basalt.strength]
[material.basalt.fracture]

[numerics]
corrected_gradient = true
artificial_stress = true

[run]
until = "1 s"

[output]
picture = false
"#;

#[test]
fn impact_in_two_dimensions() {
    compare_scene("plane", DISCS);
}

/// Broken rock with friction, hit by intact rock that breaks.
#[test]
fn impact_with_friction() {
    let (_, summary) = compare_scene(
        "friction",
        r#"
title = "Two balls with friction"

[[body]]
name = "target"
shape = { sphere = { radius = "1 km" } }
material = "basalt"
particles = 1200
damage = 1.0

[[body]]
name = "projectile"
shape = { sphere = { radius = "400 m" } }
material = "granite"
rubble = { radius = ["100 m", "200 m"], voids = 0.65 }

[impact]
speed = "3 km/s"
angle = "45 deg"

[material.basalt.strength]
collins = true
[material.basalt.strength.melting]
[material.granite.strength]
collins = { cohesion = "90 MPa", internal_friction = 2.0, friction = 0.6, damaged_cohesion = "1 MPa" }
[material.granite.fracture]

[numerics]
corrected_gradient = true

[run]
until = "1 s"

[output]
picture = false
"#,
    );
    // The target is broken, though it has no column that says so: nothing but pieces of the projectile holds together.
    let fragment = summary["outcome"]["largest_fragment_fraction"].as_f64().expect("a number");
    assert!(fragment < 0.05, "{fragment}");
}

/// Pores that crush and break what is around them: P-alpha with elastic pores on one side, epsilon-alpha on the other.
#[test]
fn impact_of_porous_bodies() {
    let (dir, _) = compare_scene(
        "pores",
        r#"
title = "Two porous balls"

[[body]]
name = "target"
shape = { sphere = { radius = "1 km" } }
material = "basalt"
particles = 1200

[[body]]
name = "projectile"
shape = { sphere = { radius = "400 m" } }
material = "ice"
distention = 1.5

[impact]
speed = "3 km/s"
angle = "45 deg"

[material.basalt.strength]
[material.basalt.fracture]
[material.basalt.porosity.p_alpha]
quadratic = true
elastic = { c_e = "2 km/s", c_0 = "3145 m/s" }

[material.ice.strength]
[material.ice.fracture]
[material.ice.porosity]
epsilon_alpha = { kappa = 0.98, P_e = "1 MPa", alpha_X = 1.1 }

[numerics]
corrected_gradient = true
smoothing_length = { follows = "density" }

[run]
until = "1.5 s"

[output]
picture = false
"#,
    );
    // Both crush, and not wholly: pores whose state were lost at a restart would show.
    let file = hdf5::File::open(dir.join("run/checkpoint.h5")).expect("a checkpoint");
    let column = |name: &str| file.dataset(&format!("columns/{name}")).expect("a column");
    let ids = column("id").read_raw::<u64>().expect("ids");
    let distention = column("distention").read_raw::<f64>().expect("numbers");
    for (body, initial) in [(0, 3.0), (1, 1.5)] {
        let of_body = || ids.iter().zip(&distention).filter(move |(id, _)| **id >> 48 == body).map(|(_, alpha)| *alpha);
        let between = of_body().filter(|alpha| (1.001..0.999 * initial).contains(alpha)).count();
        println!("body {body}: {between} of {} particles are partly crushed", of_body().count());
        assert!(between > 20, "body {body}: {between}");
    }
}

/// Everything at once: gravity, friction, pores that crush, fracture, h that follows density; and the late stage, whose first step a
/// restart may fall on.
#[test]
fn impact_with_gravity_pores_friction_and_a_late_stage() {
    const SCENE: &str = r#"
title = "All at once"

[[body]]
name = "target"
shape = { sphere = { radius = "10 km" } }
material = "basalt"
particles = 900
distention = 1.3

[[body]]
name = "projectile"
shape = { sphere = { radius = "4 km" } }
material = "granite"

[impact]
speed = "1 km/s"
angle = "45 deg"

[material.basalt.strength]
collins = true
[material.basalt.fracture]
[material.basalt.porosity.p_alpha]
quadratic = true
elastic = { c_e = "2 km/s", c_0 = "3145 m/s" }

[material.granite.strength]
collins = true
[material.granite.fracture]

[gravity]
self = { accuracy = 0.02, interval = 0.003 }

[late_stage]
at = "10 s"
sound_speed = "100 m/s"

[numerics]
corrected_gradient = true
smoothing_length = { follows = "density" }

[run]
until = "200 s"

[output]
picture = false
"#;
    let reference = compare_scene("late", SCENE);
    let summary = &reference.1;
    let at = |pointer: &str| {
        summary.pointer(pointer).and_then(Value::as_f64).unwrap_or_else(|| panic!("{pointer}: {summary}"))
    };
    let (switch, steps) = (at("/late_stage/step") as u64, at("/steps") as u64);
    println!("{switch} steps, then {} soft ones; {summary}", steps - switch);
    assert!(at("/outcome/damaged_fraction") > 0.05);
    assert!(switch > 50 && steps > switch + 50);
    let way = |ranks, threads| Way { scene: SCENE, ..Way::new(ranks, threads) };
    for (i, stop) in [switch - 1, switch, switch + 1].into_iter().enumerate() {
        let name = format!("late_resumed_{i}");
        let dir = directory(&name);
        let found = run_legs(&dir, &[(stop, way(2, 1)), (0, way(1, 1))]);
        assert_same(&name, &dir, &found, &reference);
        assert_eq!(found["late_stage"], summary["late_stage"], "{name}");
        assert_eq!(found["energy_drift"], summary["energy_drift"], "{name}");
    }
}

/// Gas that expands: smoothing lengths grow several times over.
#[test]
fn gas_that_expands() {
    compare_scene(
        "gas",
        r#"
title = "A ball of gas"

[[body]]
name = "ball"
shape = { sphere = { radius = "1 m" } }
material = "ideal_gas"
particles = 1200
density = "1 kg/m^3"
pressure = "1e5 Pa"

[numerics]
smoothing_length = { follows = "density", smallest = 0.5, largest = 4.0 }

[run]
until = "6 ms"

[output]
picture = false
"#,
    );
}

/// A search, stopped at the same step of its first and of its second impact, finds what it finds undisturbed.
#[test]
fn threshold_search_resumed_inside_impacts() {
    const SEARCH: &str = r#"
title = "A coarse search"

[[body]]
name = "target"
shape = { sphere = { radius = "50 km" } }
material = "basalt"
particles = 300

[[body]]
name = "projectile"
shape = { sphere = { radius = "12 km" } }
material = "basalt"

[impact]
speed = "5 km/s"
angle = "45 deg"

[material.basalt.strength]
[material.basalt.fracture]

[threshold]
vary = "projectile.radius"
tolerance = 0.5
repeats = 0

[run]
until = "settled"

[output]
picture = false
"#;
    let way = |ranks, threads| Way { scene: SEARCH, ..Way::new(ranks, threads) };
    let (_, expected) = run_reference("search_reference", way(2, 1));
    let found = run_legs(&directory("search"), &[(60, way(2, 1)), (60, way(1, 2)), (0, way(3, 1))]);
    // What it cost may differ.
    let result = |summary: &Value| {
        let mut threshold = summary["threshold"].clone();
        let impacts = threshold["impacts"].as_array_mut().expect("impacts in summary.json");
        assert!(impacts.len() >= 2, "one impact is no search");
        impacts.iter_mut().for_each(|impact| drop(impact.as_object_mut().expect("a table").remove("core_seconds")));
        threshold
    };
    assert_eq!(result(&found), result(&expected));
    for key in ["state_hash", "steps", "pair_interactions"] {
        assert_eq!(found[key], expected[key], "{key}");
    }
    assert!(expected["threshold"]["q_star_d"].is_number(), "{}", expected["threshold"]);
}
