//! Gravity that is evaluated rarer than every step: what turns keeps its angular momentum, and all keeps its energy.

use sph_mpi::domain::comm::Comm;

use crate::common::{ByHand, ranks};

/// A drop at 80 per cent of the rate at which it would break up: it starts as a ball, and swings. Forces between its particles act
/// along the lines between them.
const DROP: &str = r#"
[[body]]
name = "drop"
shape = { sphere = { radius = "5 km" } }
material = "fluid"
particles = 200
spin = [0, 0, "7e-4 rad/s"]

[material.fluid]
eos = { simplified_tillotson = { rho_0 = 2700, c = 100, A = "2.7e7 Pa" } }

[gravity]
self = true

[run]
until = "1 s"
"#;

/// What has changed since the start: angular momentum over what there is of it, and energy over the kinetic energy of the start.
fn changes(text: &str, changes: &[&str], end: f64, comm: &Comm) -> [f64; 2] {
    let mut hand = ByHand::<3>::with(text, changes, comm, |_, _, _| {});
    let first = hand.stepper.totals();
    let (mut worst, mut before) = ([0.0f64; 2], 0.0);
    let interval = hand.stepper.settings.gravity.and_then(|gravity| gravity.own).expect("own gravity").interval;
    hand.run(end, |hand| {
        // It is evaluated in the step whose end is nearest to when it is due.
        let age = hand.stepper.state.gravity.age.expect("an evaluation");
        assert!(age + 0.5 * (hand.time - before) < interval, "{age} s, {interval} s");
        before = hand.time;
        if hand.steps() % 7 == 0 {
            let now = hand.stepper.totals();
            let turn = (now.angular_momentum - first.angular_momentum).norm() / first.angular_momentum.norm();
            let energy = (now.balance() - first.balance()).abs() / first.kinetic;
            worst = [worst[0].max(turn), worst[1].max(energy)];
        }
    });
    let counters = &hand.stepper.counters;
    // One and a few more at the start, where intervals grow from one step.
    let wanted = hand.time / interval;
    let evaluations = counters.gravity_evaluations as f64;
    assert!((0.9..1.1).contains(&((evaluations - 6.0) / wanted)), "{evaluations} evaluations, {wanted} wanted");
    println!(
        "{changes:?}: {} steps, {} evaluations; angular momentum {:.1e}, energy {:.1e}",
        hand.steps(),
        counters.gravity_evaluations,
        worst[0],
        worst[1]
    );
    worst
}

/// One turn. A kept acceleration would add 5e-3 of angular momentum, and forces of cells that exert a torque 4e-5.
#[test]
fn a_body_that_turns_keeps_its_spin() {
    ranks(1, "kept_gravity::a_body_that_turns_keeps_its_spin", |comm| {
        let [turn, energy] = changes(DROP, &[], 9000.0, comm);
        assert!(turn < 1e-6 && energy < 1e-4, "{turn:e} {energy:e}");
    });
}

/// The same where an evaluation counts a step later, as it is carried out while pairs are summed: were it taken for one of that time,
/// a step of 2 s would make 1e-2.
#[test]
fn what_counts_a_step_later_is_a_step_old() {
    ranks(1, "kept_gravity::what_counts_a_step_later_is_a_step_old", |comm| {
        let [turn, energy] = changes(DROP, &["gravity.self.interval=0.02"], 9000.0, comm);
        assert!(turn < 1e-4 && energy < 1e-3, "{turn:e} {energy:e}");
    });
}

/// Half an orbit about a drop that turns, too. Kept accelerations would add 6e-3, and as much energy.
#[test]
fn a_moon_keeps_its_orbit() {
    const MOON: &str = r#"
[[body]]
name = "moon"
shape = { sphere = { radius = "1.2 km" } }
material = "fluid"
particles = 4
position = ["11 km", 0, 0]
velocity = [0, "2.95 m/s", 0]
"#;
    ranks(1, "kept_gravity::a_moon_keeps_its_orbit", |comm| {
        let with = ["drop.spin=[0, 0, \"4e-4 rad/s\"]", "gravity.self.accuracy=0.001"];
        let [turn, energy] = changes(&format!("{DROP}{MOON}"), &with, 11e3, comm);
        assert!(turn < 5e-7 && energy < 1e-4, "{turn:e} {energy:e}");
    });
}
