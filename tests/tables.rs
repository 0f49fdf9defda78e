//! Equations of state from tables: an impact into matter of a table against the same by the law that the table was made of.

use std::fs;
use std::path::Path;

use sph_mpi::scene::Scene;

use crate::common::{Launch, summary};

/// Two balls at 5 km/s: rock is pressed to 60 GPa, melts, and some of it turns into vapour.
const BALLS: &str = r#"
[[body]]
name = "target"
shape = { sphere = { radius = "1 km" } }
material = "rock"
particles = 1000

[[body]]
name = "projectile"
shape = { sphere = { radius = "400 m" } }
material = "rock"

[impact]
speed = "5 km/s"

[material.rock]
base = "basalt"
[material.rock.strength]
EOS

[record]
peak_pressure = true
melt_fraction = true
vapour_fraction = true

[run]
until = "0.5 s"
"#;

/// The balls by the library's law of basalt.
fn by_law() -> String {
    BALLS.replace("EOS", "")
}

/// The balls by a table of that law in a file.
fn by_table(file: &Path) -> String {
    let eos = format!(
        "[material.rock.eos.table]\nfile = \"{}\"\nformat = \"columns\"\nE_iv = \"4.72 MJ/kg\"\nE_cv = \"18.2 MJ/kg\"",
        file.display()
    );
    BALLS.replace("EOS", &eos)
}

/// Basalt of the library in a table: forty densities to a decade, energies in steps that grow.
fn write_table(file: &Path) {
    let law = Scene::parse("balls.toml", &by_law(), &[]).expect("a valid scene").materials[0].eos.law();
    let mut text = String::from("density,energy,pressure\n");
    for i in 0..=120 {
        let rho = 27.0 * 10f64.powf(i as f64 / 40.0);
        for j in 0..=120 {
            let u = 1e4 * (10.0 * j as f64 / 120.0).exp_m1();
            text += &format!("{rho:e},{u:e},{:e}\n", law.pressure(rho, u).0);
        }
    }
    fs::write(file, text).expect("a table");
}

#[test]
fn a_table_gives_the_impact_of_its_law() {
    let dir = tempfile::tempdir().expect("a directory");
    let file = dir.path().join("basalt.csv");
    write_table(&file);
    let [law, table] = [by_law(), by_table(&file)].map(|scene| {
        let dir = tempfile::tempdir().expect("a directory");
        Launch::in_directory(1, dir.path(), &scene, &["--set", "output.picture=false"]).run().expect_code(0);
        let history = fs::read_to_string(dir.path().join("run/history.csv")).expect("a history");
        let mut lines = history.lines();
        let names: Vec<&str> = lines.next().expect("a head").split(',').collect();
        let last: Vec<&str> = lines.next_back().expect("a last line").split(',').collect();
        let number = |name: &str| {
            let column = names.iter().position(|n| n.starts_with(name)).unwrap_or_else(|| panic!("no {name}"));
            last[column].parse::<f64>().expect("a number")
        };
        let drift = summary(&dir.path().join("run"))["energy_drift"].as_f64().expect("a drift");
        [number("internal_energy"), number("melted_mass"), number("vaporised_mass"), drift]
    });
    println!("internal energy, melt, vapour, drift: {law:?} by the law, {table:?} by its table");
    // Melt and vapour are counted in particles that cross a threshold.
    for (k, most) in [0.005, 0.02, 0.05].into_iter().enumerate() {
        assert!((table[k] / law[k] - 1.0).abs() < most, "{k}: {law:?} {table:?}");
    }
    assert!(table[1] > 0.0 && table[2] > 0.0 && table[3].abs() < 2.0 * law[3].abs().max(1e-4), "{law:?} {table:?}");
}

#[test]
fn tables_are_the_same_on_any_ranks() {
    let dir = tempfile::tempdir().expect("a directory");
    let file = dir.path().join("basalt.csv");
    write_table(&file);
    crate::sameness::compare_scene("tables", by_table(&file).leak());
}

/// A table with temperatures and phases: snapshots have them, to what lies between the states of the table.
#[test]
fn snapshots_have_temperature_and_phase() {
    let dir = tempfile::tempdir().expect("a directory");
    let field = |x: f64| format!("{x:16.8E}");
    let law = Scene::parse("balls.toml", &by_law(), &[]).expect("a valid scene").materials[0].eos.law();
    let density: Vec<f64> = (0..61).map(|i| 27.0 * 10f64.powf(i as f64 / 20.0)).collect();
    let temperature: Vec<f64> = (0..120).map(|k| 10.0 + 40.0 * k as f64).collect();
    // u = 1000 T, phase 4 below 1500 K and 6 above.
    let states: Vec<[f64; 2]> = temperature.iter().flat_map(|t| density.iter().map(move |rho| [*rho, *t])).collect();
    let head = [density.len() as f64, temperature.len() as f64].into_iter();
    let head: Vec<f64> = head.chain(density.iter().map(|rho| 1e-3 * rho)).chain(temperature.iter().copied()).collect();
    type Of<'a> = &'a dyn Fn(&[f64; 2]) -> f64;
    let write = |name: &str, rest: &[Of]| {
        let numbers = head.iter().copied().chain(rest.iter().flat_map(|of| states.iter().map(of)));
        let fields: Vec<String> = numbers.map(field).collect();
        let lines: String = fields.chunks(5).map(|line| line.concat() + "\n").collect();
        fs::write(dir.path().join(name), "head\n".repeat(6) + &lines).expect("a table");
    };
    let pressure = |[rho, t]: &[f64; 2]| 1e-9 * law.pressure(*rho, 1e3 * t).0;
    write("std.txt", &[&pressure, &|[_, t]| 1e-3 * t, &|_| 0.0]);
    write("ext.txt", &[&|_| 0.0, &|_| 0.0, &|_| 0.0, &|[_, t]| if *t < 1500.0 { 4.0 } else { 6.0 }]);
    let eos = "[material.rock.eos.table]\nfile = \"std.txt\"\nformat = \"sesame\"\nphases = \"ext.txt\"";
    let scene = BALLS.replace("EOS", eos).replace("melt_fraction = true\nvapour_fraction = true\n", "");
    Launch::in_directory(
        2,
        dir.path(),
        &scene,
        &["--set", "output={ picture = false, snapshots = 1 }", "--set", "run.until=0.2 s"],
    )
    .run()
    .expect_code(0);
    let file = hdf5::File::open(dir.path().join("run/snapshot_0001.vtkhdf")).expect("a snapshot");
    let read =
        |name: &str| file.dataset(&format!("VTKHDF/PointData/{name}")).expect(name).read_raw::<f64>().expect(name);
    let (u, t, phase) = (read("internal_energy"), read("temperature"), read("phase"));
    assert!(u.len() > 1000 && u.iter().any(|u| *u > 2e6), "some of it is hot");
    for i in 0..u.len() {
        // Above matter without load, at 298 K.
        let expected = (298.0 + 1e-3 * u[i]).clamp(10.0, 4770.0);
        assert!((t[i] - expected).abs() < 1e-3 * expected, "{} for {expected}", t[i]);
        let liquid = if expected > 1521.0 { 6.0 } else { 4.0 };
        assert!(phase[i] == liquid || (1479.0..1531.0).contains(&expected), "{} at {expected}", phase[i]);
    }
}

#[test]
fn a_missing_table_is_one_clear_error() {
    let dir = tempfile::tempdir().expect("a directory");
    let scene = by_table(Path::new("none.csv"));
    let output = Launch::in_directory(2, dir.path(), &scene, &[]).run().expect_code(2);
    assert!(output.stderr.contains("material.rock.eos.table.file: cannot read"), "{}", output.stderr);
    assert_eq!(output.stderr.matches("cannot read").count(), 1, "{}", output.stderr);
}
