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

#[test]
fn a_missing_table_is_one_clear_error() {
    let dir = tempfile::tempdir().expect("a directory");
    let scene = by_table(Path::new("none.csv"));
    let output = Launch::in_directory(2, dir.path(), &scene, &[]).run().expect_code(2);
    assert!(output.stderr.contains("material.rock.eos.table.file: cannot read"), "{}", output.stderr);
    assert_eq!(output.stderr.matches("cannot read").count(), 1, "{}", output.stderr);
}
