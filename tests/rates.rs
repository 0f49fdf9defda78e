//! Two rates in one run: what bodies of both give each other, its order, the same bits on any ranks, and what it saves.

use std::sync::LazyLock;

use sph_mpi::domain::comm::Comm;
use sph_mpi::math::Vec3;

use crate::common::{ByHand, ranks};
use crate::sameness::compare_scene;

/// A ball of steel hits a block of rubber: sound is some 30 times faster in it.
const BALL: &str = r#"
title = "A ball of steel on rubber"

[[body]]
name = "bed"
shape = { box = { size = ["14 mm", "14 mm", "6 mm"] } }
position = [0, 0, "-3 mm"]
material = "rubber"
spacing = "1 mm"

[[body]]
name = "ball"
shape = { sphere = { radius = "2.5 mm" } }
position = ["0.3 mm", "-0.2 mm", "3.2 mm"]
velocity = ["2 m/s", 0, "-10 m/s"]
material = "steel"
spacing = "1 mm"

[material.rubber]
eos = { murnaghan = { rho_0 = "1000 kg/m^3", K_0 = "20 MPa", n = 4 } }
[material.rubber.strength]
shear_modulus = "5 MPa"
yield_strength = "1 MPa"

[material.steel]
eos = { murnaghan = { rho_0 = "7800 kg/m^3", K_0 = "160 GPa", n = 4 } }
[material.steel.strength]
shear_modulus = "80 GPa"
yield_strength = "1 GPa"

[two_rates]
fast = ["ball"]

[run]
until = "0.3 ms"

[output]
picture = false
history_every = 1
"#;

/// s, of [`BALL`].
const END: f64 = 0.3e-3;
const ONE_RATE: &str = "two_rates=false";

/// Two halves of a bar of rock that vibrates along its length. Forces without torque follow the neighbourhood to second order only.
const BAR: &str = r#"
dimension = 2

[[body]]
name = "left"
shape = { box = { size = ["1 m", "60 cm"] } }
position = ["-50 cm", 0]
material = "basalt"
spacing = "5 cm"
lattice = "cubic"

[[body]]
name = "right"
shape = { box = { size = ["1 m", "60 cm"] } }
position = ["50 cm", 0]
material = "basalt"
spacing = "5 cm"
lattice = "cubic"

[material.basalt.strength]

[numerics]
viscosity = false
cfl = 1
angular_momentum = false

[two_rates]
fast = ["left"]
steps = 4

[run]
until = "1 s"
"#;

/// A part of a period of [`BAR`], s.
const PART: f64 = 2e-4;

/// The bar, stretched at 1 m/s, and its step, after `steps` even ones.
fn bar<'c>(changes: &[&str], steps: u32, comm: &'c Comm) -> ByHand<'c, 2> {
    let mut bar = ByHand::<2>::with(BAR, changes, comm, |columns, settings, _| {
        let core = settings.view.core;
        for i in 0..columns.len() {
            let x = columns.get(core.position, i).x;
            columns.set(core.velocity, i, Vec3::new(libm::sin(0.5 * std::f64::consts::PI * x), 0.0, 0.0));
        }
    });
    for step in 1..=steps {
        let most = PART * f64::from(step) / f64::from(steps) - bar.time;
        bar.step(most);
    }
    assert_eq!(bar.steps(), u64::from(steps), "nothing but the given length limits a step");
    bar
}

/// Velocities in the order of ids, m/s.
fn velocities(run: &ByHand<2>) -> Vec<f64> {
    let mut found: Vec<(u64, [f64; 2])> = run.particles().map(|i| (run.id(i), run.velocity(i).xy().into())).collect();
    found.sort_by_key(|(id, _)| *id);
    found.into_iter().flat_map(|(_, v)| v).collect()
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    let square: f64 = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum();
    (square / a.len() as f64).sqrt()
}

/// Half the step, a quarter of the error, across the interface as elsewhere, and of the energy as of the motion.
#[test]
fn two_rates_are_of_second_order() {
    ranks(1, "rates::two_rates_are_of_second_order", |comm| {
        let exact = velocities(&bar(&[ONE_RATE], 3200, comm));
        let (mut errors, mut drifts) = (Vec::new(), Vec::new());
        for steps in [100, 200, 400] {
            let at_start = bar(&[], 0, comm).stepper.totals();
            let mut run = bar(&[], steps, comm);
            let totals = run.stepper.totals();
            errors.push(distance(&velocities(&run), &exact));
            drifts.push((totals.energy() - at_start.energy()).abs() / at_start.kinetic);
        }
        let orders = |errors: &[f64]| [0, 1].map(|k: usize| (errors[k] / errors[k + 1]).log2());
        println!("errors {errors:?} m/s, orders {:.3?}", orders(&errors));
        println!("drifts {drifts:?}, orders {:.3?}", orders(&drifts));
        assert!(orders(&errors).iter().all(|order| (1.7..2.5).contains(order)), "{errors:?}");
        assert!(orders(&drifts).iter().all(|order| *order > 1.7), "{drifts:?}");
    });
}

/// Particles come and go between both groups, and momentum stays to rounding.
#[test]
fn momentum_is_exact_while_groups_change() {
    ranks(1, "rates::momentum_is_exact_while_groups_change", |comm| {
        let mut run = ByHand::<3>::new(BALL, comm, |_| {});
        let at_start = run.stepper.totals();
        let fast = |run: &ByHand<3>| run.numbers("fast").iter().filter(|fast| **fast == 1.0).count();
        let (mut counts, mut worst) = (vec![fast(&run)], 0.0f64);
        run.run(END, |run| {
            counts.push(fast(run));
            let totals = run.stepper.totals();
            worst = worst.max((totals.momentum - at_start.momentum).norm() / at_start.momentum_scale);
        });
        counts.dedup();
        let (steps, builds) = (run.steps(), run.stepper.counters.list_builds);
        println!("{steps} steps, {builds} lists, fast {counts:?}, momentum {worst:e}");
        assert!(builds >= 3 && counts.len() >= 3, "{builds} lists, fast particles {counts:?}");
        assert!(worst < 1e-12, "{worst:e}");
        // The ball has been stopped by the bed.
        let ball = run.particles().find(|&i| run.body(i) == 1).expect("the ball");
        assert!(run.velocity(ball).z > -9.0, "{}", run.velocity(ball));
    });
}

/// What is held takes what fast particles give it as impulse.
#[test]
fn a_held_bed_takes_impulse() {
    ranks(1, "rates::a_held_bed_takes_impulse", |comm| {
        let mut run = ByHand::<3>::with(BALL, &["bed.motion=fixed"], comm, |_, _, _| {});
        let at_start = run.stepper.totals();
        run.run(END, |_| {});
        let totals = run.stepper.totals();
        let off = (totals.momentum_balance(run.time) - at_start.momentum).norm() / at_start.momentum_scale;
        let given = totals.impulse.norm() / at_start.momentum_scale;
        println!("impulse {given:.3}, off by {off:e}");
        assert!(given > 0.1 && off < 1e-12, "{given} {off:e}");
        assert!(run.particles().filter(|&i| run.body(i) == 0).all(|i| run.velocity(i) == Vec3::zeros()));
    });
}

/// The same fall by one rate and by two, and the evaluations of particles that each takes.
#[test]
fn two_rates_save_evaluations() {
    ranks(1, "rates::two_rates_save_evaluations", |comm| {
        let run = |changes: &[&str]| {
            let mut run = ByHand::<3>::with(BALL, changes, comm, |_, _, _| {});
            run.run(END, |_| {});
            let (mut momentum, mut count) = (Vec3::zeros(), 0.0);
            for i in run.particles().filter(|&i| run.body(i) == 1) {
                momentum += run.velocity(i);
                count += 1.0;
            }
            (momentum / count, run.stepper.counters.updates as f64, run.steps())
        };
        let [(plain, all, steps), (two, fewer, large)] = [&[ONE_RATE][..], &[]].map(run);
        println!("{plain} and {two} m/s, {steps} and {large} steps, {:.2} times fewer evaluations", all / fewer);
        assert!((plain - two).norm() < 0.05, "{plain} {two}");
        assert!(large < steps / 8 && fewer < 0.5 * all, "{large} of {steps} steps, {fewer} of {all} evaluations");
    });
}

/// A scene without two rates has nothing of them.
#[test]
fn one_rate_has_no_trace_of_two() {
    ranks(1, "rates::one_rate_has_no_trace_of_two", |comm| {
        let names = |changes: &[&str]| {
            let run = ByHand::<3>::with(BALL, changes, comm, |_, _, _| {});
            let names: Vec<String> =
                run.stepper.columns.registry.entries.iter().map(|entry| entry.name.clone()).collect();
            (names, serde_json::to_string(&run.stepper.state).expect("a state"))
        };
        let ((plain, state), (two, small)) = (names(&[ONE_RATE]), names(&[]));
        assert!(plain.iter().all(|name| !name.contains("fast")) && !state.contains("small"), "{plain:?} {state}");
        assert!(two.iter().any(|name| name == "fast_acceleration") && small.contains("small"), "{two:?} {small}");
    });
}

/// A ball of nylon, which takes four small steps.
static NYLON: LazyLock<String> =
    LazyLock::new(|| BALL.replace("160 GPa", "1 GPa").replace("80 GPa", "500 MPa").replace("\"0.3 ms\"", "\"0.1 ms\""));

#[test]
fn two_rates_have_the_same_bits_on_any_ranks() {
    let (_, summary) = compare_scene("rates", &NYLON);
    println!("{} steps, momentum {}", summary["steps"], summary["momentum_drift"]);
    assert!(summary["momentum_drift"].as_f64().is_some_and(|drift| drift < 1e-12), "{}", summary["momentum_drift"]);
    assert!(summary["step_state"]["small"].as_f64().is_some_and(|small| small > 0.0), "{}", summary["step_state"]);
}
