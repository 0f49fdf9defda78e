//! Whole runs with rigid bodies: the same on any ranks and through a checkpoint, and what their files say.

use crate::common::{Launch, summary};
use crate::sameness::compare_scene;

/// Free, guided and held bodies that meet matter and each other in a space that closes on itself, under gravity.
const CROWD: &str = r#"
title = "Rigid bodies of all kinds"

[domain]
periodic = { y = ["-6 mm", "6 mm"] }
[gravity]
uniform = ["1 km/s^2", 0, "-100 km/s^2"]

[[body]]
name = "bed"
shape = { box = { size = ["14 mm", "12 mm", "5 mm"] } }
position = [0, 0, "-2.5 mm"]
material = "rubber"
spacing = "1 mm"
[[body]]
name = "tray"
shape = { box = { size = ["14 mm", "12 mm", "2 mm"] } }
position = [0, 0, "-6 mm"]
material = "steel"
spacing = "1 mm"
motion = "fixed"
rigid = { sound_speed = "200 m/s" }
[[body]]
name = "bead"
shape = { sphere = { radius = "2.5 mm" } }
position = ["-2 mm", 0, "3 mm"]
velocity = [0, "30 m/s", "-20 m/s"]
spin = [0, "20 kHz", "5 kHz"]
material = "steel"
spacing = "0.8 mm"
rigid = { sound_speed = "200 m/s" }
[[body]]
name = "stone"
shape = { box = { size = ["4 mm", "3 mm", "3 mm"] } }
position = ["3.5 mm", "1 mm", "4 mm"]
velocity = ["-20 m/s", 0, "-10 m/s"]
material = "steel"
spacing = "1 mm"
rigid = { sound_speed = "200 m/s" }
[[body]]
name = "piston"
shape = { box = { size = ["6 mm", "12 mm", "2 mm"] } }
position = ["4 mm", 0, "8 mm"]
velocity = [0, 0, "-5 m/s"]
material = "steel"
spacing = "1 mm"
motion = { along = ["z"] }
rigid = { sound_speed = "200 m/s" }

[material.rubber]
eos = { murnaghan = { rho_0 = "1000 kg/m^3", K_0 = "20 MPa", n = 4 } }
[material.rubber.strength]
shear_modulus = "5 MPa"
yield_strength = "100 kPa"
[material.steel]
eos = { murnaghan = { rho_0 = "7800 kg/m^3", K_0 = "160 GPa", n = 4 } }

[run]
until = "0.25 ms"

[output]
picture = false
history_every = 1
"#;

#[test]
fn a_crowd_has_the_same_bits_on_any_ranks() {
    let (dir, summary) = compare_scene("rigid", CROWD);
    println!("{} steps, momentum {}", summary["steps"], summary["momentum_drift"]);
    assert!(summary["momentum_drift"].as_f64().is_some_and(|drift| drift < 1e-12), "{}", summary["momentum_drift"]);
    let bodies = summary["step_state"]["rigid"].as_array().expect("rigid bodies in the state");
    assert_eq!(bodies.len(), 4);
    let history = std::fs::read_to_string(dir.join("run/history.csv")).expect("a history");
    let header = history.lines().next().expect("a header");
    for column in ["bead_position_y [m]", "bead_orientation_w", "piston_force_z [N]", "boundary_impulse_z [kg m/s]"] {
        assert!(header.split(',').any(|name| name == column), "{column} in {header}");
    }
    // What is guided keeps to its path.
    let piston = bodies.iter().find(|body| body["body"] == 4).expect("the piston");
    assert!(
        piston["motion"]["velocity"][0] == 0.0 && piston["motion"]["velocity"][2].as_f64().is_some_and(|v| v != -5.0)
    );
}

/// The same with steps that are refused.
#[test]
fn refused_steps_set_rigid_bodies_back() {
    let controlled = "[numerics]\nintegrator = { runge_kutta = { tolerance = 1e-4 } }\n";
    let scene: &'static str = Box::leak(format!("{CROWD}{controlled}").into_boxed_str());
    let (_, summary) = compare_scene("rigid_refused", scene);
    println!("{} steps, {} refused", summary["steps"], summary["refused_steps"]);
    assert!(summary["refused_steps"].as_u64().is_some_and(|refused| refused > 0), "no step was refused");
    assert!(summary["momentum_drift"].as_f64().is_some_and(|drift| drift < 1e-12), "{}", summary["momentum_drift"]);
}

/// A program of the whole: the example runs, and its history tells of the bead.
#[test]
fn a_plane_scene_runs_to_its_end() {
    const SCENE: &str = r#"
dimension = 2
[[body]]
name = "dust"
shape = { box = { size = ["20 mm", "10 mm"] } }
material = "rubber"
spacing = "1 mm"
[[body]]
name = "bead"
shape = { sphere = { radius = "3 mm" } }
material = "rubber"
density = 3000
spacing = "1 mm"
position = ["2 mm", "9 mm"]
velocity = [0, "-5 m/s"]
spin = ["1 kHz"]
rigid = true
[material.rubber]
eos = { murnaghan = { rho_0 = "1000 kg/m^3", K_0 = "20 MPa", n = 4 } }
[run]
until = "0.5 ms"
[output]
picture = false
"#;
    let dir = tempfile::tempdir().expect("a temporary directory");
    Launch::in_directory(2, dir.path(), SCENE, &[]).run().expect_code(0);
    let summary = summary(&dir.path().join("run"));
    assert!(summary["momentum_drift"].as_f64().is_some_and(|drift| drift < 1e-12), "{}", summary["momentum_drift"]);
    assert!(
        summary["angular_momentum_drift"].as_f64().is_some_and(|drift| drift < 1e-3),
        "{}",
        summary["angular_momentum_drift"]
    );
    let figure = |name: &str| summary["rigid"][name].as_f64().expect("a figure of the bead");
    assert!((figure("bead_mass") / (3000.0 * 9e-6 * std::f64::consts::PI) - 1.0).abs() < 0.05, "{}", summary["rigid"]);
    assert!(figure("bead_velocity_y") > -4.5, "{}", summary["rigid"]);
    let history = std::fs::read_to_string(dir.path().join("run/history.csv")).expect("a history");
    let names: Vec<&str> =
        history.lines().next().expect("a header").split(',').filter(|name| name.starts_with("bead_")).collect();
    let expected = [
        "position_x [m]",
        "position_y [m]",
        "velocity_x [m/s]",
        "velocity_y [m/s]",
        "angular_velocity_z [1/s]",
        "angle [rad]",
        "force_x [N]",
        "force_y [N]",
    ];
    assert_eq!(names, expected.map(|name| format!("bead_{name}")));
}
