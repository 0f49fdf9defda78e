//! How much artificial viscosity takes from flows without shocks.

use std::f64::consts::PI;

use sph_mpi::domain::comm::Comm;

use crate::common::{ByHand, ranks};
use crate::sameness::{DISCS, compare_scene};

/// A fluid in periodic space, c = 1 m/s, in which rows of particles glide past each other: sin(k x) across, at c / 100.
const SHEAR: &str = r#"
dimension = 2

[domain]
periodic = { x = ["-0.5 m", "0.5 m"], y = ["-0.21650635 m", "0.21650635 m"] }

[[body]]
name = "fluid"
shape = { box = { size = ["1 m", "0.4330127 m"] } }
material = "fluid"
spacing = "62.5 mm"
flow = { wave = { along = "x", moves = "y", wavelength = "1 m", speed = "10 mm/s" } }

[material.fluid]
eos = { murnaghan = { rho_0 = "1000 kg/m^3", K_0 = "1000 Pa", n = 1 } }
viscosity = { alpha = 1.5, beta = 3 }

[numerics]
corrected_gradient = true

[run]
until = "10 s"
"#;

/// s, of [`SHEAR`].
const END: f64 = 4.0;
const RECONSTRUCTED: &str = "numerics.reconstruction=true";

/// Viscosity that the wave has felt, over alpha c h, from the decay of its energy, 2 nu k^2.
fn viscosity<const D: usize>(changes: &[&str], spacings: f64, comm: &Comm) -> f64 {
    let mut run = ByHand::<D>::with(SHEAR, changes, comm, |_, _, _| {});
    let begin = run.stepper.totals().kinetic;
    run.run(END, |_| {});
    let h = 1.2 / spacings * if D == 2 { 0.75f64.powf(0.25) } else { 0.5f64.powf(1.0 / 6.0) };
    (begin / run.stepper.totals().kinetic).ln() / (2.0 * (2.0 * PI).powi(2) * END) / (1.5 * h)
}

/// On a lattice a fifteenth to a fiftieth of plain viscosity is left; what is left falls with the square of the spacing.
#[test]
fn shear_is_hardly_damped() {
    ranks(1, "viscosity::shear_is_hardly_damped", |comm| {
        let fine = "fluid.spacing=31.25 mm";
        let plain = viscosity::<2>(&[], 16.0, comm);
        let coarse = viscosity::<2>(&[RECONSTRUCTED], 16.0, comm);
        let finer = viscosity::<2>(&[RECONSTRUCTED, fine], 32.0, comm);
        println!("nu / (alpha c h): {plain:.4} plain, {coarse:.5} and {finer:.5} reconstructed");
        assert!((0.05..0.08).contains(&plain), "{plain}");
        assert!(coarse < plain / 12.0 && finer < plain / 40.0, "{plain} {coarse} {finer}");
    });
}

#[test]
fn all_of_it_has_the_same_bits_on_any_ranks() {
    let terms = "reconstruction = true\nviscosity_switch = true\ndensity_relaxation = true\n";
    let scene = DISCS.replace("corrected_gradient = true\nartificial_stress = true\n", terms);
    assert!(scene.contains(terms));
    let (_, summary) = compare_scene("viscosity", scene.leak());
    let drift = |name: &str| summary[name].as_f64().unwrap_or(f64::NAN);
    assert!(drift("momentum_drift") < 1e-13 && drift("energy_drift") < 3e-3, "{summary:#}");
}
