//! Highly porous dust: the law of Sirono as modified by Geretshauser et al. 2010.

use sph_mpi::material::MaterialTable;
use sph_mpi::material::eos::sirono::Sirono;

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
