//! Bodies from files: what a run has left is where another one begins, on any ranks, and so are particles of other programs.

use std::fs;
use std::path::Path;

use sph_mpi::domain::comm::Comm;
use sph_mpi::math::Vec3;
use sph_mpi::outcome::Particle;
use sph_mpi::outcome::form::form;
use sph_mpi::scene;

use crate::common::{ByHand, Launch, ranks, summary, write_scene};

/// An oblique impact that breaks a ball with pores and lets it turn; both bodies of one rock.
const FIRST: &str = r#"
[[body]]
name = "target"
shape = { sphere = { radius = "1 km" } }
material = "basalt"
particles = 700

[[body]]
name = "projectile"
shape = { sphere = { radius = "200 m" } }
material = "basalt"
least_particles = 30

[impact]
speed = "200 m/s"
angle = "45 deg"

[material.basalt.strength]
[material.basalt.fracture]
[material.basalt.porosity]
distention = 1.3
[material.basalt.porosity.p_alpha.quadratic]
P_e = "10 MPa"
P_s = "500 MPa"

[gravity.self]

[numerics]
corrected_gradient = true

[run]
until = "3 s"

[output]
picture = false
snapshots = 1
"#;

/// The matter of FIRST's last snapshot, as it stands there.
const SECOND: &str = r#"
[[body]]
name = "matter"
from = { file = "run/FILE", frame = "file" }
material = "basalt"

[material.basalt.strength]
[material.basalt.fracture]
[material.basalt.porosity]
distention = 1.3
[material.basalt.porosity.p_alpha.quadratic]
P_e = "10 MPa"
P_s = "500 MPa"

[gravity.self]

[numerics]
corrected_gradient = true

[run]
until = "1 s"

[output]
picture = false
"#;

fn number(summary: &serde_json::Value, path: &str) -> f64 {
    path.split('.').fold(summary, |value, key| &value[key]).as_f64().unwrap_or_else(|| panic!("no {path} in {summary}"))
}

/// Runs SECOND beside the run in `dir`; returns its summary.
fn go_on(dir: &Path, ranks: usize, scene: &str, more: &[&str]) -> serde_json::Value {
    let scene = write_scene(dir, scene);
    let out = dir.join(format!("second_{ranks}"));
    let mut args = vec![scene.display().to_string(), "--out".into(), out.display().to_string()];
    args.extend(more.iter().map(|arg| arg.to_string()));
    Launch::scene(ranks, &args).run().expect_code(0);
    summary(&out)
}

/// Columns of a line of history.csv.
fn last_line(run: &Path) -> Vec<f64> {
    let text = fs::read_to_string(run.join("history.csv")).expect("a history");
    let cells = text.lines().last().expect("a line").split(',');
    cells.map(|cell| cell.parse().unwrap_or(f64::NAN)).collect()
}

/// A run that ends at 3 s and is handed over goes on as it would have done: what differs is that its first step is a new
/// one. The same bits follow from snapshots of any ranks, on any ranks.
#[test]
fn what_a_run_has_left_goes_on() {
    let dir = tempfile::tempdir().expect("a directory");
    let part = ["--set", "run.until=3 s"];
    Launch::in_directory(2, dir.path(), FIRST, &part).run().expect_code(0);
    let second = SECOND.replace("FILE", "snapshot_0001.vtkhdf");
    let found = go_on(dir.path(), 1, &second, &[]);
    let whole = tempfile::tempdir().expect("a directory");
    Launch::in_directory(1, whole.path(), FIRST, &["--set", "run.until=4 s"]).run().expect_code(0);
    let (there, here) = (last_line(&whole.path().join("run")), last_line(&dir.path().join("second_1")));
    // Kinetic and internal energy, momentum along x, angular momentum about z.
    for k in [6, 7, 9, 14] {
        assert!((here[k] / there[k] - 1.0).abs() < 5e-4, "{k}: {} for {}", here[k], there[k]);
    }
    // From a snapshot that one rank has written, on three.
    let other = tempfile::tempdir().expect("a directory");
    Launch::in_directory(1, other.path(), FIRST, &part).run().expect_code(0);
    let again = go_on(other.path(), 3, &second, &["--threads", "2"]);
    assert_eq!(found["state_hash"], again["state_hash"]);
}

/// The largest remnant alone: its mass and its turn are what the first run said, and an impact onto it is one like any other.
#[test]
fn the_largest_remnant_is_hit_again() {
    let dir = tempfile::tempdir().expect("a directory");
    Launch::in_directory(2, dir.path(), FIRST, &[]).run().expect_code(0);
    let first = summary(&dir.path().join("run"));
    let spin = number(&first, "outcome.largest_remnant_spin_z");
    let axes = ["a", "b", "c"].map(|axis| number(&first, &format!("outcome.largest_remnant_semi_axis_{axis}")));
    assert!(spin > 0.0 && axes[0] >= axes[1] && axes[1] >= axes[2] && axes[2] > 700.0, "{spin} {axes:?}");
    let efficiency = number(&first, "outcome.angular_momentum_efficiency");
    assert!((0.005..=1.0).contains(&efficiency), "{efficiency}");
    let porosity = number(&first, "outcome.largest_remnant_porosity");
    assert!((0.15..0.24).contains(&porosity), "{porosity}");

    let again = format!(
        "{}{}",
        SECOND.replace("FILE\", frame = \"file\" }", "snapshot_0001.vtkhdf\", keep = \"largest_remnant\" }").replace(
            "[material.basalt.strength]",
            "[[body]]\nname = \"stone\"\nshape = { sphere = { radius = \"200 m\" } }\nmaterial = \"basalt\"\nleast_particles = 30\n\
             [impact]\nspeed = \"100 m/s\"\n[material.basalt.strength]"
        ),
        ""
    );
    let found = go_on(dir.path(), 2, &again, &[]);
    let target = number(&found, "outcome.target_mass");
    let kept = number(&first, "outcome.largest_remnant_fraction") * number(&first, "outcome.target_mass");
    assert!((target / kept - 1.0).abs() < 1e-12, "{target} of {kept}");
    assert!(number(&found, "momentum_drift") < 1e-12 && number(&found, "outcome.largest_remnant_fraction") > 0.3);
    let line = fs::read_to_string(dir.path().join("second_2/history.csv")).expect("a history");
    let start: Vec<f64> =
        line.lines().nth(1).unwrap().split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect();
    let damaged = line.lines().next().unwrap().split(',').position(|name| name.starts_with("damaged_mass")).unwrap();
    assert!(start[damaged] > 0.05 * target, "the damage of the first impact is there: {} of {target}", start[damaged]);
}

const BALL: &str = r#"
[[body]]
name = "ball"
from = { file = "ball.csv", materials = { iron = "iron" }, frame = "file" }
material = "basalt"
spin = [0, 0, "1e-3 1/s"]
velocity = ["3 m/s", 0, 0]

[material.basalt.strength]
[material.basalt.fracture]

[run]
steps = 5
until = "1 s"

[output]
picture = false
"#;

/// A cubic lattice of rock with some iron in it, as another program would list it.
fn table() -> String {
    let mut text = "# made elsewhere\nx [km],y [km],z [km],vx [km/s],mass [Mg],material,damage\n".to_string();
    for n in 0..512 {
        let [x, y, z] = [n % 8, n / 8 % 8, n / 64].map(|k| 0.1 * k as f64 - 0.35);
        let (mass, material) = if n < 64 { (7.8e6, "iron") } else { (2.7e6, "rock") };
        text += &format!("{x},{y},{z},0.001,{mass},{material},{}\n", if n % 2 == 0 { 1.0 } else { 0.25 });
    }
    text
}

/// Two materials, units in the titles, damage; no density, so that it is the materials'.
#[test]
fn particles_of_another_program_become_a_body() {
    let dir = tempfile::tempdir().expect("a directory");
    fs::write(dir.path().join("ball.csv"), table()).expect("a file");
    let path = write_scene(dir.path(), BALL);
    let read = scene::read(&path, &[]).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(read.bodies.len(), 2);
    assert_eq!(read.bodies[1].whole(1), 0);
    assert!((read.bodies[0].whole_mass() / (64.0 * 7.8e9 + 448.0 * 2.7e9) - 1.0).abs() < 1e-12);
    assert_eq!([0, 1].map(|k| read.bodies[k].expected_particles()), [448.0, 64.0]);
    let found = go_on(dir.path(), 2, BALL, &[]);
    let alone = go_on(dir.path(), 1, BALL, &[]);
    assert_eq!(found["state_hash"], alone["state_hash"]);
    let text = fs::read_to_string(dir.path().join("second_1/history.csv")).expect("a history");
    let column =
        |name: &str| text.lines().next().unwrap().split(',').position(|title| title.starts_with(name)).unwrap();
    let start: Vec<f64> =
        text.lines().nth(1).unwrap().split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect();
    let mass = read.bodies[0].whole_mass();
    // 1 m/s of the file and 3 of the scene.
    assert!((start[column("momentum_x")] / (4.0 * mass) - 1.0).abs() < 1e-3, "{}", start[column("momentum_x")] / mass);
    assert!(start[column("angular_momentum_z")] > 0.0);
    // Half of it broken, half a quarter; iron does not break, and stays as damaged as the file says.
    assert!((start[column("damaged_mass")] / (0.625 * mass) - 1.0).abs() < 1e-9);
}

/// Compressed by a tenth, as the table says, it bursts; without load each particle has the density of its material.
#[test]
fn what_is_unloaded_starts_without_pressure() {
    ranks(1, "handover::what_is_unloaded_starts_without_pressure", |comm| {
        let dir = tempfile::tempdir().expect("a directory");
        let file = dir.path().join("ball.csv");
        let dense = |line: (usize, &str)| match line.0 {
            0 => format!("{}\n", line.1),
            1 => format!("{},density\n", line.1),
            _ => format!("{},{}\n", line.1, if line.1.contains("iron") { 8580.0 } else { 2970.0 }),
        };
        fs::write(&file, table().lines().enumerate().map(dense).collect::<String>()).expect("a file");
        let path = write_scene(dir.path(), BALL);
        let [loaded, unloaded] = ["false", "true"].map(|unload| {
            let change = format!("ball.from.unload={unload}");
            let scene = scene::read(&path, &[change]).unwrap_or_else(|e| panic!("{e}"));
            let run = ByHand::<3>::of(scene, comm, |_, _, _| {});
            let reference = |i| {
                let material = &run.scene.materials[run.scene.bodies[run.body(i)].material];
                material.reference_density().expect("a solid")
            };
            let range = |values: &mut dyn Iterator<Item = f64>| {
                values.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], x| [least.min(x), most.max(x)])
            };
            let density = range(&mut run.particles().map(|i| run.numbers("density")[i] / reference(i)));
            (density, range(&mut run.numbers("pressure").iter().copied()))
        });
        assert!(loaded.0[0] > 1.09 && loaded.1[0] > 2e9, "{loaded:?}");
        assert_eq!(unloaded, ([1.0; 2], [0.0; 2]));
    });
}

#[test]
fn what_a_file_lacks_is_one_clear_error() {
    let dir = tempfile::tempdir().expect("a directory");
    fs::write(dir.path().join("ball.csv"), table()).expect("a file");
    let scene = write_scene(dir.path(), BALL);
    for (change, what) in [
        ("ball.from.file=none.csv", "none.csv: No such file"),
        ("ball.from.file=scene.toml", "does not say what kind of file it is"),
        ("ball.from.keep=largest_remnant", "does not say what the largest remnant is"),
        ("ball.from.keep.body=ice", "no particle of `ice`, but of iron, rock"),
        ("ball.from.materials={}", "nothing says what material here is that of `iron`"),
        ("ball.from.materials.iron=cheese", "cheese"),
        ("ball.from.keep=most", "unknown"),
        ("ball.particles=100", "`particles` is not theirs"),
        ("ball.rigid=true", "`rigid` is not theirs"),
        ("ball.from.columns.position=x", "columns are those of an HDF5 file"),
        ("dimension=2", "has 3 dimensions, the scene 2"),
    ] {
        let read = scene::read(&scene, &[change.to_string()]);
        let message = read.map(|_| ()).expect_err(change).to_string();
        assert!(message.contains(what) && message.contains("ball"), "{change}: {message}");
    }
    let output = Launch::in_directory(2, dir.path(), &BALL.replace("ball.csv", "none.csv"), &[]).run().expect_code(2);
    assert_eq!(output.stderr.matches("none.csv").count(), 1, "{}", output.stderr);
    let scene = write_scene(dir.path(), BALL);
    // As it is understood, from anywhere, and again on other ranks, from what has been sent.
    let read = scene::read(&scene, &[]).unwrap();
    let sent = serde_json::to_string(&read).unwrap();
    let received: scene::Scene = serde_json::from_str(&sent).unwrap();
    assert_eq!(received, read);
    assert_eq!(received.reread(&["run.steps=7".into()]).unwrap().bodies, read.bodies);
    let elsewhere = tempfile::tempdir().expect("a directory");
    let copy = write_scene(elsewhere.path(), &read.to_toml());
    assert_eq!(scene::read(&copy, &[]).unwrap().bodies, read.bodies);
}

/// An ellipsoid of a cubic lattice that turns about an axis of no symmetry.
#[test]
fn a_spinning_ellipsoid_is_found_again() {
    ranks(3, "handover::a_spinning_ellipsoid_is_found_again", |comm: &Comm| {
        let (axes, spin, drift) = ([3.0, 2.0, 1.5], Vec3::new(0.1, -0.2, 0.3), Vec3::new(5.0, 0.0, -7.0));
        let side = 0.1;
        let mut particles = Vec::new();
        for n in (0..64u64.pow(3)).filter(|n| n % 3 == comm.rank() as u64) {
            let k = [n % 64, n / 64 % 64, n / 4096];
            let x = Vec3::from_fn(|a, _| (k[a] as f64 - 31.5) * side);
            if (0..3).map(|a| (x[a] / axes[a]).powi(2)).sum::<f64>() <= 1.0 {
                let (velocity, position) = (drift + spin.cross(&x), x + Vec3::new(100.0, 0.0, 0.0));
                let volume = side * side * side;
                particles.push(Particle {
                    id: n,
                    body: 0,
                    position,
                    velocity,
                    mass: 2.0,
                    volume,
                    spacing: side,
                    damage: 0.0,
                });
            }
        }
        let found = form(comm, &particles, &vec![true; particles.len()]).expect("a body");
        for k in 0..3 {
            assert!((found.spin[k] - spin[k]).abs() < 1e-12, "{found:?}");
            assert!((found.axes[k] / axes[k] - 1.0).abs() < 5e-3, "{found:?}");
        }
        assert!(form(comm, &particles, &vec![false; particles.len()]).is_none());
    });
}
