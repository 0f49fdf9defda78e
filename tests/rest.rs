//! Bodies at rest stay at rest: a ball of broken rock, a pile of sand, a rubble pile, a slope; and what should not rest does not.
//! `scripts/validate rest` does them finer. Moduli are such that sound is 25 times as fast as free fall: with those of rock nothing
//! would have the time to fall.

use sph_mpi::comparison::{Comparison, Noted};
use sph_mpi::domain::comm::Comm;
use sph_mpi::math::{Deviator, Vec3};
use sph_mpi::random::uniform;
use sph_mpi::scene::{Scene, Until};

use crate::common::{ByHand, ranks};

const BALL: &str = include_str!("../inputs/rest_sphere.toml");
const RUBBLE: &str = include_str!("../inputs/rest_rubble.toml");
const PILE: &str = include_str!("../inputs/rest_pile.toml");
const SLOPE: &str = include_str!("../inputs/slope.toml");

/// Rms speed over that of free fall that counts as rest.
const STILL: f64 = 1e-3;
/// Error of the pressure in a stretch of depth, over that at the bottom.
const PRESSURE: f64 = 0.02;

/// Runs a scene to its end; its errors by name.
fn run<const D: usize>(text: &str, changes: &[&str], comm: &Comm) -> impl Fn(&str) -> f64 + use<D> {
    let mut hand = ByHand::<D>::with(text, changes, comm, |_, _, _| {});
    let comparison = Comparison::new(&hand.scene).expect("a comparison").expect("something to compare with");
    let Until::Time(end) = hand.scene.run.until else { panic!("a scene with an end") };
    let mut samples = Vec::new();
    hand.run(end, |hand| {
        if hand.steps() % 10 == 0 {
            samples.extend(comparison.sample(&hand.stepper, hand.time, comm));
        }
    });
    let noted = Noted { time: end, angular_momentum: 0.0, samples: &samples };
    let found = comparison.finish(&hand.stepper, &noted, None, comm).expect("figures");
    println!("{changes:?}, {} steps: {:?}", hand.steps(), found.0);
    move |name: &str| found.0.iter().find(|(known, _)| known == name).map_or(f64::NAN, |(_, value)| *value)
}

/// For two free-fall times a ball hardly moves, and its pressure is that of its weight once small swings have faded: softened gravity is weaker
/// by (h / R)^2, 1 per cent with 8000 particles. Without the start under its own weight it swings.
#[test]
fn a_ball_of_broken_rock_keeps_still() {
    ranks(1, "rest::a_ball_of_broken_rock_keeps_still", |comm| {
        let coarse = "ball.particles=1000";
        let ball = run::<3>(BALL, &[coarse], comm);
        assert!(ball("speed_largest") < STILL, "{}", ball("speed_largest"));
        let fine = run::<3>(BALL, &["run.until=600", "ball.particles=8000"], comm);
        assert!(fine("pressure") < PRESSURE, "{}", fine("pressure"));
        let swinging = run::<3>(BALL, &[coarse, "ball.start=unloaded", "run.until=300"], comm);
        assert!(swinging("speed_largest") > 3.0 * STILL, "{}", swinging("speed_largest"));
    });
}

/// The hard case of a pile at rest. Its slope does not creep: shear of broken matter is borne by friction, as much as pressure allows.
/// Were damage to weaken it as it weakens tension, the pile would run like water; with too little friction its flanks slide; and
/// without damping at the start it takes longer to settle.
#[test]
fn a_pile_of_sand_does_not_creep() {
    ranks(1, "rest::a_pile_of_sand_does_not_creep", |comm| {
        let coarse = ["sand.spacing=0.01", "floor.spacing=0.01"];
        let with = |change: &str| run::<2>(PILE, &[coarse[0], coarse[1], change], comm);
        let pile = run::<2>(PILE, &coarse, comm);
        assert!(pile("speed_largest") < 0.01 * STILL, "{}", pile("speed_largest"));
        let water = with("material.sand.strength.drucker_prager=false");
        assert!(water("speed") > 30.0 * STILL, "{}", water("speed"));
        let slippery = with("material.sand.strength.drucker_prager.friction=0.3");
        assert!(slippery("speed") > STILL, "{}", slippery("speed"));
        let undamped = with("sand.motion=false");
        assert!(undamped("speed_largest") > 10.0 * STILL, "{}", undamped("speed_largest"));
    });
}

/// Blocks that have fallen together stay where they are. Forces along the stress of their surfaces exert a torque; left alone, it makes
/// the pile turn, faster and faster.
#[test]
fn a_rubble_pile_keeps_still() {
    ranks(1, "rest::a_rubble_pile_keeps_still", |comm| {
        let coarse = "pile.particles=1000";
        let pile = run::<3>(RUBBLE, &[coarse], comm);
        assert!(pile("speed_largest") < STILL, "{}", pile("speed_largest"));
        let turning = run::<3>(RUBBLE, &[coarse, "numerics.angular_momentum=false"], comm);
        assert!(turning("speed_largest") > 3.0 * STILL, "{}", turning("speed_largest"));
    });
}

/// A loose ball under any stress: no torque is left of all forces, to the rounding (5e-7) with which the antisymmetric stress
/// stands, where the neighbourhoods of the last evaluation are
/// those of this one. Without the antisymmetric stress a thousandth
/// of all single torques is left, as much as random stresses leave that nothing correlates.
#[test]
fn forces_conserve_angular_momentum() {
    ranks(1, "rest::forces_conserve_angular_momentum", |comm| {
        fn torque<const D: usize>(change: &str, comm: &Comm) -> f64 {
            let text = format!(
                "dimension = {D}\n[[body]]\nname = \"ball\"\nshape = {{ sphere = {{ radius = 1 }} }}\nmaterial = \"basalt\"\n\
                 particles = 400\n[material.basalt.strength]\n[numerics]\ncorrected_gradient = true\nviscosity = false\n\
                 [run]\nuntil = 1\n"
            );
            let mut ball = ByHand::<D>::with(&text, &[change], comm, |_, _, _| {});
            let draw = |i: usize, k: u64| uniform(7, i as u64, k) - 0.5;
            for i in ball.particles() {
                let s = Deviator { xx: draw(i, 0), yy: draw(i, 1), xy: draw(i, 2), xz: draw(i, 3), yz: draw(i, 4) };
                let stress = if D == 2 { Deviator { xz: 0.0, yz: 0.0, ..s } } else { s };
                ball.set("deviatoric_stress", i, stress.scaled(1e6));
                let shaken = Vec3::from_fn(|k, _| if k < D { 0.02 * draw(i, 5 + k as u64) } else { 0.0 });
                ball.set("position", i, ball.position(i) + shaken);
            }
            ball.evaluate();
            ball.evaluate();
            let (mut sum, mut size) = (Vec3::zeros(), 0.0);
            for i in ball.particles() {
                let one = ball.position(i).cross(&ball.acceleration(i));
                sum += one;
                size += one.norm();
            }
            println!("{D}D, {change}: {:.1e}", sum.norm() / size);
            sum.norm() / size
        }
        for torque in [torque::<2>, torque::<3>] {
            assert!(torque("numerics.angular_momentum=false", comm) > 1e-4);
            assert!(torque("numerics.angular_momentum=true", comm) < 1e-8);
        }
    });
}

/// A slope holds two degrees below atan(friction), and slides two above it. In plane strain nothing stretches along the slope, so that
/// plastic flow is pure shear, the deviator has no other component left, and all normal stresses are the pressure: sqrt(J2) is the
/// shear stress, and tan(angle) the friction.
#[test]
fn a_slope_slides_at_its_angle() {
    ranks(1, "rest::a_slope_slides_at_its_angle", |comm| {
        let critical = 0.5f64.atan().to_degrees();
        let tilted = |angle: f64, more: &str| {
            let (sine, cosine) = angle.to_radians().sin_cos();
            let gravity = format!("gravity.uniform=[{}, {}]", 9.81 * sine, -9.81 * cosine);
            run::<2>(SLOPE, &["sand.spacing=0.01", &gravity, more], comm)
        };
        let holds = tilted(critical - 2.0, "run.until=0.5");
        assert!(holds("speed") < STILL && holds("pressure") < PRESSURE, "{} {}", holds("speed"), holds("pressure"));
        let (early, late) = (tilted(critical + 2.0, "run.until=0.25"), tilted(critical + 2.0, "run.until=0.5"));
        assert!(
            early("speed") > 20.0 * STILL && late("speed") > 1.5 * early("speed"),
            "{} {}",
            early("speed"),
            late("speed")
        );
    });
}

/// Matter that falls along a period comes round again and again; nothing of its energy or momentum is lost from the count.
const FALLING: &str = r#"
title = "A ball that falls round"

[[body]]
name = "ball"
shape = { sphere = { radius = "10 m" } }
position = ["5 m", 0, 0]
velocity = ["-40 m/s", "3 m/s", 0]
material = "jelly"
particles = 300

[material.jelly]
eos = { simplified_tillotson = { rho_0 = 1000, c = 0.1, A = "1 kPa" } }

[domain]
periodic = { x = ["-45 m", "35 m"] }

[gravity]
uniform = ["9 m/s^2", 0, "-1 m/s^2"]

[run]
until = "12 s"
"#;

#[test]
fn gravity_along_a_period_is_accounted_for() {
    ranks(1, "rest::gravity_along_a_period_is_accounted_for", |comm| {
        let mut ball = ByHand::<3>::new(FALLING, comm, |_| {});
        let first = ball.stepper.totals();
        while ball.time < 12.0 {
            let dt = ball.dt.min(0.01);
            ball.dt = ball.stepper.step(dt, ball.time + dt, 0).expect("a step").dt;
            ball.time += dt;
        }
        let (t, last) = (ball.time, ball.stepper.totals());
        // 5 - 40 t + 4.5 t^2: more than a period down, and then up to three above the first.
        let rounds: Vec<f64> = ball.particles().map(|i| ball.get::<Vec3>("rounds", i).x).collect();
        assert!(rounds.iter().all(|n| (1.0..=3.0).contains(n)), "{rounds:?}");
        let drift = (last.balance() - first.balance()).abs() / first.kinetic;
        assert!(drift < 1e-11, "energy drifts by {drift}");
        let drift = (last.momentum_balance(t) - first.momentum_balance(0.0)).norm() / last.momentum_scale;
        assert!(drift < 1e-12, "momentum drifts by {drift}");
    });
}

/// A slope that slides round its period, damped at first: the same on any ranks and through a checkpoint.
#[test]
fn slope_on_any_ranks() {
    crate::sameness::compare_scene(
        "slope",
        r#"
title = "A slope that slides"
dimension = 2

[gravity]
uniform = ["9 m/s^2", "-9 m/s^2"]

[domain]
periodic = { x = ["0 cm", "10 cm"] }

[[body]]
name = "sand"
shape = { box = { size = ["10 cm", "15 cm"] } }
position = ["5 cm", "5 cm"]
material = "sand"
spacing = "5 mm"
damage = 1.0
start = "hydrostatic"
motion = { damping = ["10 ms", "50 ms"] }

[[layer]]
y = ["-2.5 cm", "0 cm"]
motion = "fixed"

[material.sand]
eos = { simplified_tillotson = { rho_0 = "1500 kg/m^3", c = 0.1, A = "5e4 Pa" } }
[material.sand.strength]
shear_modulus = "2e4 Pa"
yield_strength = "1 MPa"
[material.sand.strength.drucker_prager]
cohesion = "0 Pa"
friction = 0.3

[numerics]
corrected_gradient = true
angular_momentum = true

[run]
until = "0.35 s"

[output]
picture = false
"#,
    );
}

#[test]
fn what_cannot_rest_is_refused() {
    let said = |text: &str, change: &str| {
        let found = Scene::parse("scene.toml", text, &[change.to_string()]).err();
        found.map_or("no error".into(), |error| error.to_string())
    };
    for (text, change, expected) in [
        (SLOPE, "gravity.uniform=[1, 9.81]", "nothing holds the body's sides, or nothing pulls it down"),
        (SLOPE, "sand.size=[0.05, 0.1]", "nothing holds the body's sides"),
        (SLOPE, "compare.after=-1", "after -1 s"),
        (PILE, "sand.start=hydrostatic", "no matter attracts any here"),
        (PILE, "sand.motion={ damping = [1, 2, 3] }", "3 times"),
        (PILE, "sand.motion={ damping = [1, 0] }", "until 0 s"),
        (PILE, "sand.top=0.4", "top is"),
    ] {
        let found = said(text, change);
        assert!(found.contains(expected), "{change}: {found}");
    }
}
