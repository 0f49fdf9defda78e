//! Density that returns to mass over volume (`numerics.density_relaxation`).

use sph_mpi::domain::comm::Comm;

use crate::common::{ByHand, ranks};

/// A gas at rest in a periodic box; sound crosses it in a second.
const BOX: &str = r#"
dimension = 2

[domain]
periodic = { x = ["-0.5 m", "0.5 m"], y = ["-0.4330127 m", "0.4330127 m"] }

[[body]]
name = "gas"
shape = { box = { size = ["1 m", "0.8660254 m"] } }
material = "gas"
spacing = "62.5 mm"
density = "1 kg/m^3"
internal_energy = "0.9 J/kg"

[material.gas]
eos = { ideal_gas = { gamma = 1.6666666666666667 } }

[run]
until = "2 s"
"#;
const RETURNS: &str = "numerics.density_relaxation=true";

/// Density over mass over volume, least and largest, after two seconds of a gas that after its first step believes in `factor` times its
/// density; change of its energy over what it was.
fn after(factor: f64, changes: &[&str], comm: &Comm) -> ([f64; 2], f64) {
    let mut run = ByHand::<2>::with(BOX, changes, comm, |_, _, _| {});
    run.step(1e-3);
    for i in run.particles() {
        let density: f64 = run.get("density", i);
        run.set("density", i, factor * density);
    }
    run.evaluate();
    let energy = |run: &mut ByHand<2>| {
        let totals = run.stepper.totals();
        totals.kinetic + totals.internal
    };
    let begin = energy(&mut run);
    run.run(2.0, |_| {});
    let end = energy(&mut run);
    let densities = run.numbers("density");
    let bounds = densities.iter().fold([f64::INFINITY, 0.0], |[low, high], d| [d.min(low), d.max(high)]);
    (bounds, end / begin - 1.0)
}

/// To within the five per cent that both may differ by, and 1 / e of the rest at most; without it a wrong density is kept for good.
#[test]
fn wrong_density_returns_and_energy_stays() {
    ranks(1, "density::wrong_density_returns_and_energy_stays", |comm| {
        for factor in [1.4, 1.0 / 1.4] {
            let ([low, high], drift) = after(factor, &[RETURNS], comm);
            println!("{factor:.3}: {low:.4} to {high:.4}, energy {drift:.1e}");
            assert!(low > 0.93 && high < 1.07 && drift.abs() < 1e-12, "{low} {high} {drift}");
            let ([low, high], _) = after(factor, &[], comm);
            assert!((low / factor - 1.0).abs() < 1e-6 && (high / factor - 1.0).abs() < 1e-6, "{low} {high}");
        }
    });
}

/// Sums miss matter at a surface: there density stays what it is without the effect, to the last bit.
#[test]
fn surfaces_keep_their_density() {
    ranks(1, "density::surfaces_keep_their_density", |comm| {
        let ball = "[[body]]\nname = \"ball\"\nshape = { sphere = { radius = \"1 m\" } }\nmaterial = \"basalt\"\nparticles = 1500\n\
                    [run]\nuntil = \"1 s\"\n";
        let densities = |changes: &[&str]| {
            let mut run = ByHand::<3>::with(ball, changes, comm, |_, _, _| {});
            run.run(4e-4, |_| {});
            assert!(run.steps() > 20, "{} steps", run.steps());
            run.numbers("density").to_vec()
        };
        assert_eq!(densities(&[RETURNS]), densities(&[]));
    });
}

/// A coarse pile at rest, on a floor of another lattice: what sums over particles say of density where lattices meet is no drift. Where it returned
/// at the speed of sound, the pile rose by three per cent of its potential energy, and had minus 2 J inside.
#[test]
fn matter_at_rest_keeps_its_density() {
    const PILE: &str = include_str!("../inputs/rest_pile.toml");
    ranks(1, "density::matter_at_rest_keeps_its_density", |comm| {
        let changes = ["sand.spacing=0.01", "floor.spacing=0.01", RETURNS];
        let mut run = ByHand::<2>::with(PILE, &changes, comm, |_, _, _| {});
        let begin = run.stepper.totals();
        run.run(0.6, |_| {});
        let end = run.stepper.totals();
        let [begin, rest] = [&begin, &end].map(|totals| totals.potential.expect("gravity"));
        println!("potential energy {begin:.3} and {rest:.3} J, internal {:.1e} J", end.internal);
        assert!(
            rest < begin && rest > 0.98 * begin && end.internal.abs() < 1e-2 * begin,
            "{begin} {rest} {}",
            end.internal
        );
    });
}
