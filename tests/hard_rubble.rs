//! Hard cases of matter whose energy falls below zero, as those of solids in `hard_cases`: each with
//! the figure that shows its defect. Where the cure is a key of the scene, both sides are run; where it is in the code, a comment says
//! what the figure was when it was taken out.

use sph_mpi::domain::comm::Comm;
use sph_mpi::math::Deviator;

use crate::common::{ByHand, ranks};
use crate::hard_pores::all_finite;

/// Matter pressed together that holds no heat: all that it gains as it flies apart it takes from an energy below zero.
const SPRING: &str = r#"
title = "Pressed matter without heat lets go"
[[body]]
name = "ball"
shape = { sphere = { radius = "1 m" } }
material = "MATERIAL"
density = DENSITY
spacing = "20 cm"
flow = { stretch = [STRETCH, 0, 0] }
[numerics]
corrected_gradient = true
smoothing_length = { follows = "density" }
cfl = 0.15
[run]
until = 1
"#;

/// What a ball is like that has let go.
#[derive(Debug)]
struct LetGo {
    /// Kinetic energy gained over what the cold ball holds, m e with e = int P(rho, 0) / rho^2.
    kinetic: f64,
    /// Drift of the whole energy, over the same.
    drift: f64,
    /// Lowest specific energy seen, J/kg.
    lowest: f64,
    /// Largest difference of the pressure from that at zero energy where energy is below, over the first pressure.
    pressure: f64,
    /// Largest sqrt(3 J2) over the cold strength seen.
    shear: f64,
}

fn let_go(text: &str, end: f64, comm: &Comm) -> LetGo {
    let mut hand = ByHand::<3>::new(text, comm, |_| {});
    let law = hand.scene.materials[0].eos.law();
    let (rest, first) = (law.reference_density().expect("a solid"), hand.scene.bodies[0].density);
    let cold = |rho: f64| law.pressure(rho, 0.0).0;
    let held: f64 = (0..1000)
        .map(|k| rest + (first - rest) * (k as f64 + 0.5) / 1000.0)
        .map(|rho| cold(rho) / (rho * rho) * (first - rest) / 1000.0)
        .sum();
    let before = hand.stepper.totals();
    let scale = before.mass * held;
    let yields = hand.scene.materials[0].strength.as_ref().map_or(f64::INFINITY, |table| table.yield_strength.0);
    let mut out = LetGo { kinetic: 0.0, drift: 0.0, lowest: 0.0, pressure: 0.0, shear: 0.0 };
    for part in 1..=10 {
        hand.run(end * f64::from(part) / 10.0, |hand| assert!(all_finite(hand)));
        // Pressure is that of the prediction until it is evaluated anew.
        hand.evaluate();
        for i in hand.particles() {
            let (u, rho, p) = (hand.energy(i), hand.numbers("density")[i], hand.numbers("pressure")[i]);
            out.lowest = out.lowest.min(u);
            if u < 0.0 {
                out.pressure = out.pressure.max((p - cold(rho)).abs() / cold(first));
            }
            if yields.is_finite() {
                let s: Deviator = hand.get("deviatoric_stress", i);
                out.shear = out.shear.max((3.0 * s.j2()).sqrt() / yields);
            }
        }
    }
    let after = hand.stepper.totals();
    out.kinetic = (after.kinetic - before.kinetic) / scale;
    out.drift = (after.energy() - before.energy()).abs() / scale;
    println!("{out:?} in {} steps, held {held:.3e} J/kg", hand.steps());
    out
}

/// An energy below zero counts as zero where pressure and strength are made from it, and stays in the sum. Ice that flies apart thins out
/// until E_0 eta^2 is |u|, where Tillotson's 1 / omega has its pole: with the energy as it is, the ball is blown up from there, and the run
/// ends for want of a finite step. Rock that is sheared as it lets go yields at its cold strength: with 1 - u / u_melt as it is, at 1.116
/// times as much. Were energies below zero set to zero instead, the whole energy would grow by 0.80 of what the ice held.
#[test]
fn energy_below_zero() {
    ranks(1, "hard_rubble::energy_below_zero", |comm| {
        let scene = |material: &str, density: &str, stretch: &str| {
            SPRING.replace("MATERIAL", material).replace("DENSITY", density).replace("STRETCH", stretch)
        };
        let ice = let_go(&scene("ice", "1100", "0"), 8e-3, comm);
        assert!(ice.lowest < -1e5 && ice.pressure < 1e-12 && ice.drift < 1e-3, "{ice:?}");
        assert!((0.5..1.0).contains(&ice.kinetic), "{ice:?}");
        let melting = "[material.basalt.strength]\nyield_strength = 1e8\nmelting = { energy = 1e4 }\n";
        let rock = let_go(&(scene("basalt", "2800", "300") + melting), 2e-3, comm);
        assert!(rock.lowest < -1e3 && rock.pressure < 1e-12 && rock.drift < 1e-3, "{rock:?}");
        assert!((0.9..1.0 + 1e-12).contains(&rock.shear), "{rock:?}");
    });
}
