//! Integrators by themselves: their order on a vibration, the errors that they tolerate, and the same bits on any ranks where steps
//! are refused.

use sph_mpi::domain::comm::Comm;

use crate::common::{ByHand, ranks};
use crate::sameness;

/// A disc of rock that vibrates radially.
const DISC: &str = r#"
dimension = 2

[[body]]
name = "disc"
shape = { disc = { radius = "1 m" } }
material = "basalt"
spacing = "12 cm"
flow = { mode = { shape = "radial", speed = "1 m/s" } }

[material.basalt.strength]

[numerics]
kernel = "wendland_c2"
eta = 1.4
viscosity = false
cfl = 1

[run]
until = "1 s"
"#;

/// Half a period or so, s; steps of the Courant condition are a fiftieth of it.
const END: f64 = 3e-4;

const RUNGE_KUTTA: &str = "numerics.integrator={ runge_kutta = { tolerance = 1 } }";
const PREDICTOR_CORRECTOR: &str = "numerics.integrator=\"predictor_corrector\"";

/// Velocities after `steps` even steps, in the order of ids.
fn velocities(integrator: &str, steps: u32, comm: &Comm) -> Vec<f64> {
    let mut disc = ByHand::<2>::with(DISC, &[integrator], comm, |_, _, _| {});
    for step in 1..=steps {
        let most = END * f64::from(step) / f64::from(steps) - disc.time;
        disc.step(most);
    }
    assert_eq!(disc.steps(), u64::from(steps), "nothing but the given length limits a step");
    let mut found: Vec<(u64, [f64; 2])> =
        disc.particles().map(|i| (disc.id(i), disc.velocity(i).xy().into())).collect();
    found.sort_by_key(|(id, _)| *id);
    found.into_iter().flat_map(|(_, v)| v).collect()
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    let square: f64 = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum();
    (square / a.len() as f64).sqrt()
}

/// Half the step, a quarter of the error: both integrators are of second order, and lead to the same motion.
#[test]
fn both_integrators_are_of_second_order() {
    ranks(1, "integrators::both_integrators_are_of_second_order", |comm| {
        let exact = velocities(RUNGE_KUTTA, 3200, comm);
        for integrator in [RUNGE_KUTTA, PREDICTOR_CORRECTOR] {
            let errors = [100, 200, 400].map(|steps| distance(&velocities(integrator, steps, comm), &exact));
            let orders = [0, 1].map(|k: usize| (errors[k] / errors[k + 1]).log2());
            println!("{integrator}: errors {errors:.3?} m/s, orders {orders:.3?}");
            // The third order of the error makes a few per cent at these steps.
            assert!(orders.iter().all(|order| (1.9..2.1).contains(order)), "{integrator}: {orders:?}");
            assert!(errors[2] < 1e-3, "{integrator}: {errors:?} of 1 m/s");
        }
    });
}

/// The steps follow the tolerance, as its root, and what is refused leaves no trace.
#[test]
fn steps_follow_the_tolerated_error() {
    ranks(1, "integrators::steps_follow_the_tolerated_error", |comm| {
        let exact = velocities(RUNGE_KUTTA, 3200, comm);
        let run = |tolerance: f64| {
            let integrator = format!("numerics.integrator={{ runge_kutta = {{ tolerance = {tolerance} }} }}");
            let mut disc = ByHand::<2>::with(DISC, &[&integrator], comm, |_, _, _| {});
            let first = disc.stepper.totals();
            disc.run(END, |_| {});
            let last = disc.stepper.totals();
            let mut found: Vec<(u64, [f64; 2])> =
                disc.particles().map(|i| (disc.id(i), disc.velocity(i).xy().into())).collect();
            found.sort_by_key(|(id, _)| *id);
            let found: Vec<f64> = found.into_iter().flat_map(|(_, v)| v).collect();
            let drift = (last.balance() - first.balance()).abs() / first.kinetic;
            (disc.steps(), disc.stepper.counters.refused, distance(&found, &exact), drift)
        };
        let [coarse, fine] = [1e-4, 1e-6].map(run);
        println!("steps, refused, error in m/s, drift of energy: {coarse:?} and {fine:?}");
        // The first step is that of the Courant condition, which is too long for these.
        assert!(coarse.1 >= 1 && fine.1 >= 1, "{coarse:?} {fine:?}");
        let ratio = fine.0 as f64 / coarse.0 as f64;
        assert!((7.0..13.0).contains(&ratio), "{ratio} times as many steps for a hundredth of the error of each");
        // Errors add up over the steps: a hundredth of it in ten times as many.
        let gain = coarse.2 / fine.2;
        assert!((40.0..250.0).contains(&gain), "{gain} times less error");
    });
}

/// Pores that are crushed, rock that breaks and yields with friction: state that never goes back, in steps that do.
#[test]
fn refused_steps_have_the_same_bits_on_any_ranks() {
    let (_, summary) = sameness::compare_scene(
        "refused",
        r#"
title = "Two porous balls"

[[body]]
name = "target"
shape = { sphere = { radius = "1 km" } }
material = "basalt"
particles = 800

[[body]]
name = "projectile"
shape = { sphere = { radius = "400 m" } }
material = "basalt"

[impact]
speed = "2 km/s"

[material.basalt.strength.collins]
[material.basalt.fracture]
[material.basalt.porosity]
distention = 1.3
p_alpha = { quadratic = { P_e = "1 MPa", P_s = "1 GPa" } }

[numerics]
integrator = { runge_kutta = { tolerance = 0.005 } }

[record]
peak_pressure = true

[run]
until = "0.6 s"

[output]
picture = false
"#,
    );
    println!("{} steps, {} refused", summary["steps"], summary["refused_steps"]);
    assert!(summary["refused_steps"].as_u64().is_some_and(|refused| refused > 0), "no step was refused");
    let drift = summary["energy_drift"].as_f64().expect("a drift");
    assert!(drift < 1e-2, "{drift}");
}
