//! Highly porous dust: the law of Sirono as modified by Geretshauser et al. 2010.

use std::collections::BTreeSet;

use sph_mpi::material::MaterialTable;
use sph_mpi::material::eos::sirono::Sirono;
use sph_mpi::scene::Scene;
use sph_mpi::simulation::setup::plan;

use crate::common::reference;

fn silica() -> Sirono {
    let text = "[eos.sirono]\nrho_s = 2000\nrho_i = 300\nK_0 = \"4.5 kPa\"\ngamma = 4\n\
        tension = { T_0 = 630.9573444801932, slope = 1.48 }\n\
        compression.powder = { p_m = 260, phi_1 = 0.12, phi_2 = 0.58, Delta = 0.58 }\n";
    let material: MaterialTable = toml::from_str(text).expect("a material");
    material.validate("material.silica").expect("a sound material");
    material.dust().expect("dust")
}

fn near(found: f64, expected: f64) -> bool {
    (found - expected).abs() <= 1e-9 * expected.abs()
}

/// Strengths, modulus and speed of sound, to 1e-9 of an independent program (1e-13 was found).
#[test]
fn curves_over_the_filling_factor() {
    let law = silica();
    for row in reference("sirono_curves.csv") {
        let [phi, sigma, t, y, k, c] = row[..] else { panic!("six columns") };
        let rho = 2000.0 * phi;
        assert!(near(law.compressive_strength(phi), sigma) && near(law.tensile_strength(phi), t), "{phi}");
        assert!(near(law.shear_strength(phi), y) && near(law.bulk_modulus(rho), k), "{phi}");
        assert!(near(law.unloaded(rho).1, c), "{phi}");
    }
}

/// Compression, tension and compression again: pressure and reference density, to 1e-9.
#[test]
fn a_path_of_loads() {
    let law = silica();
    let mut reference_density = 300.0;
    for row in reference("sirono_path.csv") {
        let [phi, p, rho, branch] = row[..] else { panic!("four columns") };
        let before = reference_density;
        let loaded = law.load(2000.0 * phi, before);
        reference_density = loaded.reference;
        assert!(near(loaded.pressure, p) && near(loaded.reference, rho), "{phi}: {loaded:?}, not {p} {rho}");
        assert_eq!(branch == 0.0, loaded.reference == before, "{phi}");
    }
}

/// A hard bead falls into dust of two kinds: contact viscosity, both variants of plasticity, a fixed layer, gravity.
const BEAD: &str = r#"
title = "A bead in dust, to be compared"
dimension = 2
[[body]]
name = "dust"
shape = { half_disc = { radius = "3.3 mm" } }
material = "silica_dust"
spacing = "150 um"
[[body]]
name = "bead"
shape = { disc = { radius = "0.55 mm" } }
position = [0, "0.7 mm"]
velocity = ["0.1 m/s", "-0.65 m/s"]
material = "glass"
spacing = "150 um"
[[body]]
name = "lump"
shape = { disc = { radius = "0.5 mm" } }
position = ["1.8 mm", "0.65 mm"]
velocity = [0, "-1 m/s"]
material = "lump"
density = "600 kg/m^3"
spacing = "150 um"
[[layer]]
body = "dust"
outer = "600 um"
motion = "fixed"
[material.glass]
eos.murnaghan.K_0 = "1 MPa"
strength.shear_modulus = "0.66 MPa"
[material.lump]
eos.sirono = { rho_s = 2000, rho_i = 300, K_0 = "4.5 kPa", gamma = 3.5, plasticity = "after_unloading", shear_as_printed = true, tension = { T_0 = 631, slope = 1.48 }, compression.powder = { p_m = 1300, phi_1 = 0.12, phi_2 = 0.58, Delta = 0.58 } }
viscosity = { alpha = 0.1, beta = 0 }
[gravity]
uniform = [0, "-9.81 m/s^2"]
[numerics]
eta = 2
corrected_gradient = true
contact_viscosity = true
[run]
until = "1.5 ms"
[output]
picture = false
"#;

/// What a scene of dust cannot mean: what is said, and what is allowed instead.
#[test]
fn what_makes_no_sense_of_dust_is_refused() {
    for (setting, what, allowed) in [
        ("aggregate.distention=2", "`silica_dust` is dust", "filling_factor"),
        ("aggregate.filling_factor=0", "filling_factor is 0", "above 0, 1 at most"),
        ("aggregate.filling_factor=1.1", "filling_factor is 1.1", "above 0, 1 at most"),
        ("plate.filling_factor=0.3", "`glass` is no dust", "a material with eos.sirono"),
        ("plate.density=2e6", "density is 2000000 kg/m^3", "1e-3 to 1e6 kg/m^3 of a rigid body"),
        ("material.silica_dust.eos.sirono.gamma=1", "gamma is 1", "above 1, 24 at most"),
        (
            "material.silica_dust.eos.sirono.plasticity=3",
            "one of its words or tables",
            "those that `sph-mpi --keys material.silica_dust.eos.sirono` lists",
        ),
        ("aggregate.shape=sphere", "one of its words or tables", "those that `sph-mpi --keys body.shape` lists"),
    ] {
        let scene = include_str!("../inputs/dust_bouncing.toml");
        let error = Scene::parse("scene.toml", scene, &[setting.into()]).expect_err(setting).to_string();
        assert!(error.contains(what) && error.contains(&format!("(allowed: {allowed}")), "{error}");
    }
}

#[test]
fn a_bead_in_dust_is_the_same_on_any_ranks() {
    let (dir, _) = crate::sameness::compare_scene("dust", BEAD);
    let history = std::fs::read_to_string(dir.join("run/history.csv")).expect("a history");
    let mut lines = history.lines().filter(|line| !line.starts_with('#'));
    let column = lines.next().expect("names").split(',').position(|name| name.starts_with("dust_compacted_volume"));
    let last = lines.next_back().expect("a last line").split(',').nth(column.expect("a column"));
    let compacted: f64 = last.and_then(|cell| cell.parse().ok()).expect("a number");
    assert!(compacted > 1e-8, "{compacted}");
}

/// The same with a rigid bead, and by an integrator that refuses steps.
#[test]
fn a_rigid_bead_in_dust_is_the_same_on_any_ranks() {
    let rigid = BEAD
        .replace("[material.glass]\neos.murnaghan.K_0 = \"1 MPa\"\nstrength.shear_modulus = \"0.66 MPa\"\n", "")
        .replace("material = \"glass\"\n", "material = \"glass\"\nrigid = true\n");
    crate::sameness::compare_scene("dust_rigid", rigid.clone().leak());
    let refusing = "[numerics]\nintegrator = { cash_karp = { tolerance = 1e-3 } }\n";
    let (_, summary) = crate::sameness::compare_scene("dust_cash_karp", rigid.replace("[numerics]\n", refusing).leak());
    assert!(summary["refused_steps"].as_u64().is_some_and(|n| n > 0), "{summary:#}");
}

/// Cold matter without an energy; contact viscosity and the later variant are held only where asked for.
#[test]
fn dust_holds_what_it_needs() {
    let names = |changes: &[[&str; 2]]| {
        let text = changes.iter().fold(BEAD.to_string(), |text, [from, to]| text.replace(from, to));
        let scene = Scene::parse("scene.toml", &text, &[]).expect("a scene");
        let constants = scene.bodies.iter().map(|body| body.constants(100, scene.numerics.eta)).collect();
        let plan = plan(&scene, constants).expect("a plan");
        plan.registry.entries.iter().map(|entry| entry.name.clone()).collect::<BTreeSet<String>>()
    };
    let all = names(&[]);
    assert!(["internal_energy", "damage", "distention"].iter().all(|name| !all.contains(*name)), "{all:?}");
    let without = |changes: &[[&str; 2]]| all.difference(&names(changes)).cloned().collect::<Vec<_>>();
    let no_contact = ["contact_viscosity = true", "contact_viscosity = false"];
    assert_eq!(without(&[no_contact]), ["contact_alpha"]);
    assert_eq!(without(&[["plasticity = \"after_unloading\", ", ""]]), ["yield_density"]);
    let start = BEAD.find("[material.lump]").expect("dust");
    let end = BEAD.find("[gravity]").expect("gravity");
    let glass = |name: &'static str| [name, "material = \"glass\""];
    let hard = [
        no_contact,
        [&BEAD[start..end], ""],
        glass("material = \"lump\"\ndensity = \"600 kg/m^3\""),
        glass("material = \"silica_dust\""),
    ];
    assert_eq!(without(&hard), ["contact_alpha", "filling_factor", "reference_density", "yield_density"]);
}
