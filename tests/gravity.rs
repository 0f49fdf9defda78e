//! Gravity: uniform, and of the particles themselves.

use std::f64::consts::PI;

use sph_mpi::domain::comm::{Comm, Exchange, Overlapped};
use sph_mpi::gravity::multipole::direct;
use sph_mpi::gravity::{Body, Field, G, Opening, solve, solve_later};
use sph_mpi::math::Vec3;
use sph_mpi::random::uniform;
use sph_mpi::scene::Scene;
use sph_mpi::simulation::scales::free_fall_time_of;

use crate::common::{ByHand, assert_as_measured, ranks, same_on_any_ranks};

/// A ball of rock in flight.
const THROWN: &str = r#"
dimension = DIMENSION

[[body]]
name = "ball"
shape = { sphere = { radius = "10 m" } }
material = "basalt"
particles = 300
velocity = VELOCITY

[gravity]
uniform = GRAVITY

[run]
until = "10 s"
"#;

fn thrown(dimension: usize) -> String {
    let vector = |x: [&str; 3]| format!("[{}]", x[..dimension].join(", "));
    THROWN
        .replace("DIMENSION", &dimension.to_string())
        .replace("VELOCITY", &vector(["\"3 m/s\"", "\"20 m/s\"", "\"-1 m/s\""]))
        .replace("GRAVITY", &vector(["\"0.5 m/s^2\"", "\"-9.81 m/s^2\"", "0"]))
}

/// Every particle flies along a parabola, to rounding; energy and momentum, with what gravity gives, stay.
fn flies_along_a_parabola<const D: usize>(comm: &Comm) {
    let mut ball = ByHand::<D>::new(&thrown(D), comm, |_| {});
    let starts: std::collections::BTreeMap<u64, Vec3> =
        ball.particles().map(|i| (ball.id(i), ball.position(i))).collect();
    let (g, v) = (Vec3::new(0.5, -9.81, 0.0), Vec3::new(3.0, 20.0, if D == 3 { -1.0 } else { 0.0 }));
    let first = ball.stepper.totals();
    // Long steps: nothing but the fall happens.
    for _ in 0..50 {
        let dt = ball.dt.min(0.01);
        ball.dt = ball.stepper.step(dt, ball.time + dt, 0).expect("a step").dt;
        ball.time += dt;
    }
    let t = ball.time;
    for i in ball.particles() {
        let expected = starts[&ball.id(i)] + v * t + 0.5 * t * t * g;
        let off = (ball.position(i) - expected).norm();
        assert!(off < 1e-9, "{off} m after {t} s");
    }
    let last = ball.stepper.totals();
    let drift = (last.balance() - first.balance()).abs() / first.kinetic;
    assert!(drift < 1e-11, "energy drifts by {drift}");
    let drift = (last.momentum_balance(t) - first.momentum_balance(0.0)).norm() / first.momentum_scale;
    assert!(drift < 1e-12, "momentum drifts by {drift}");
    assert!((last.momentum - first.momentum).norm() > 1e-3 * first.momentum_scale, "the ball has fallen");
}

#[test]
fn free_fall() {
    ranks(1, "gravity::free_fall", |comm| {
        flies_along_a_parabola::<2>(comm);
        flies_along_a_parabola::<3>(comm);
    });
}

/// A column of molten rock on a floor that is held, periodic sideways.
const COLUMN: &str = r#"
dimension = 2

[[body]]
name = "column"
shape = { box = { size = ["2500 m", "10 km"] } }
position = ["1250 m", "5 km"]
material = "basalt"
spacing = "250 m"
lattice = "square"
motion = { damping = "1 s" }

[[layer]]
y = ["0 m", "1 km"]
motion = "fixed"

[domain]
periodic = { x = ["0 m", "2500 m"] }

[gravity]
uniform = [0, "-10 m/s^2"]

[numerics]
corrected_gradient = true

[run]
until = "20 s"
"#;

/// Pressure bears the weight of what lies above, and what holds the column takes up its weight.
#[test]
fn hydrostatic_column() {
    ranks(1, "gravity::hydrostatic_column", |comm| {
        let mut column = ByHand::<2>::new(COLUMN, comm, |_| {});
        let first = column.stepper.totals();
        column.run(20.0, |_| {});
        let pressure = column.numbers("pressure");
        let weight = |i: usize| 2700.0 * 10.0 * (1e4 - column.position(i).y);
        // Rows come in pairs: above a floor that gives way by whole rows, one is pressed a little more, the next less.
        let mut worst = 0.0f64;
        for low in (1500..9000).step_by(500) {
            let within = |i: &usize| (low as f64..low as f64 + 500.0).contains(&column.position(*i).y);
            let rows: Vec<usize> = column.particles().filter(within).collect();
            let mean = |value: &dyn Fn(usize) -> f64| rows.iter().map(|&i| value(i)).sum::<f64>() / rows.len() as f64;
            worst = worst.max((mean(&|i| pressure[i]) - mean(&weight)).abs() / (2700.0 * 10.0 * 9000.0));
        }
        println!("pressure within {worst:.4} of that at the bottom");
        assert!(worst < 0.015, "{worst}");
        assert_as_measured("pressure", worst, 0.01111);
        let last = column.stepper.totals();
        let moved = last.potential.expect("gravity") - first.potential.expect("gravity");
        let drift = (last.balance() - first.balance()).abs();
        println!("energy drifts by {:.2e} of what the column lost by settling", drift / moved.abs());
        assert!(moved < 0.0 && drift < 1e-4 * moved.abs(), "{drift} {moved}");
        assert_as_measured("drift of energy", drift / moved.abs(), 7.018e-6);
        let drift = (last.momentum_balance(column.time) - first.momentum_balance(0.0)).norm();
        assert!(drift < 1e-9 * last.weight.norm() * column.time, "{drift}");
    });
}

#[test]
fn what_cannot_be_is_refused() {
    let error = |changes: &[&str]| {
        let changes: Vec<String> = changes.iter().map(|change| change.to_string()).collect();
        Scene::parse("scene.toml", COLUMN, &changes).err().map_or("no error".into(), |error| error.to_string())
    };
    for (change, said) in [
        ("gravity.uniform=[0, 0, \"-10 m/s^2\"]", "3 components in 2 dimensions"),
        ("gravity.uniform=[0, \"-10 m/s\"]", "an acceleration is wanted"),
        ("gravity.unifrom=[0, 1]", "did you mean `uniform`"),
        ("gravity.self=true", "three dimensions"),
        ("gravity.self.acuracy=0.1", "did you mean `accuracy`"),
    ] {
        let found = error(&[change]);
        assert!(found.contains(said), "{change}: {found}");
    }
    let empty = Scene::parse("scene.toml", &COLUMN.replace("uniform", "# uniform"), &[]).expect_err("an error");
    assert!(empty.to_string().contains("nothing attracts"), "{empty}");
}

/// A ball of jittered sites, a dense clump beside it and a few far away.
fn all_bodies(edge: i64) -> Vec<Body> {
    let mut all = Vec::new();
    let mut add = |position: [f64; 3], mass: f64, softening: f64| {
        let id = all.len() as u64;
        all.push(Body { id, position, mass, softening, acceleration: 0.0 });
    };
    let jitter = |n: u64, k: u64| 0.4 * (uniform(3, n, k) - 0.5);
    let half = edge / 2;
    for site in 0..(edge * edge * edge) as u64 {
        let index = |k: u32| (site as i64 / edge.pow(k) % edge - half) as f64;
        let p = [0, 1, 2].map(|k| index(k) + jitter(site, k as u64));
        if p.iter().map(|x| x * x).sum::<f64>() < (half * half) as f64 {
            add(p.map(|x| 1e3 * x), 2.7e12, 1.2e3);
        }
    }
    for n in 0..300 {
        let p = [0, 1, 2].map(|k| 400.0 * uniform(4, n, k) + if k == 0 { 1.5e3 * half as f64 } else { 0.0 });
        add(p, 5e11, 60.0);
    }
    for n in 0..8 {
        add([0, 1, 2].map(|k| 1e5 * (uniform(5, n, k) - 0.5)), 1e12, 1e3);
    }
    all
}

/// A rank's share of them.
fn bodies(comm: &Comm, edge: i64) -> Vec<Body> {
    let all = all_bodies(edge);
    let share = |rank: usize| all.len() * rank / comm.size();
    all[share(comm.rank())..share(comm.rank() + 1)].to_vec()
}

fn size(a: &[f64; 3]) -> f64 {
    Vec3::from(*a).norm()
}

/// Against sums over all bodies, at four accuracies: median, 99 % and largest error of the acceleration, by its length, which
/// between ball and clump is almost nothing.
#[test]
fn errors_against_direct_sums() {
    ranks(1, "gravity::errors_against_direct_sums", |comm| {
        let mut bodies = bodies(comm, 21);
        let every: Vec<usize> = (0..bodies.len()).step_by(7).collect();
        let exact: Vec<Field> = every.iter().map(|&i| direct(&bodies, &bodies[i])).collect();
        let first = solve(comm, &bodies, &Opening { angle: 0.7, accuracy: f64::INFINITY, order: 4 });
        bodies.iter_mut().zip(&first).for_each(|(body, field)| body.acceleration = size(&field.acceleration));
        // Order, accuracy, what the median may be, and median, 99 %, largest and that of the potential as measured.
        let cases = [
            (3, 0.03, 4e-3, [1.497e-3, 7.927e-3, 3.820e-2, 1.479e-3]),
            (4, 0.01, 1e-3, [4.087e-4, 2.177e-3, 3.155e-2, 4.017e-3]),
            (4, 1e-3, 4e-4, [1.918e-4, 6.885e-4, 1.554e-2, 5.480e-3]),
            (5, 1e-4, 1.2e-4, [2.523e-5, 1.080e-4, 4.956e-4, 4.731e-5]),
        ];
        for (order, accuracy, allowed, measured) in cases {
            let fields = solve(comm, &bodies, &Opening { angle: 0.9, accuracy, order });
            let error = |(&i, exact): (&usize, &Field)| {
                let off = std::array::from_fn(|k| fields[i].acceleration[k] - exact.acceleration[k]);
                size(&off) / size(&exact.acceleration)
            };
            let mut errors: Vec<f64> = every.iter().zip(&exact).map(error).collect();
            errors.sort_by(f64::total_cmp);
            let share = |part: f64| errors[((errors.len() - 1) as f64 * part) as usize];
            let (median, most, worst) = (share(0.5), share(0.99), share(1.0));
            let potential = every.iter().zip(&exact).map(|(&i, e)| (fields[i].potential / e.potential - 1.0).abs());
            let potential = potential.fold(0.0, f64::max);
            println!(
                "order {order}, accuracy {accuracy}: {median:.1e}, 99 % {most:.1e}, max {worst:.1e}; potential {potential:.1e}"
            );
            // Where ball and clump pull against each other next to nothing is left, and the error is large beside it.
            assert!(median < allowed && most < 5.0 * allowed && worst < 0.05, "{accuracy}");
            assert!(potential < 0.01, "{potential}");
            for (found, measured) in [median, most, worst, potential].into_iter().zip(measured) {
                assert_as_measured(&format!("accuracy {accuracy}"), found, measured);
            }
            let force = |k: usize| bodies.iter().zip(&fields).map(|(b, f)| b.mass * f.acceleration[k]).sum::<f64>();
            let scale: f64 = bodies.iter().zip(&fields).map(|(b, f)| b.mass * size(&f.acceleration)).sum();
            let drift = Vec3::new(force(0), force(1), force(2)).norm() / scale;
            assert!(drift < 1e-13, "forces add up to {drift} of their sizes");
            let place = |b: &Body| Vec3::from(b.position);
            let torque = |(b, f): (&Body, &Field)| b.mass * place(b).cross(&Vec3::from(f.acceleration));
            let most = |(b, f): (&Body, &Field)| b.mass * place(b).norm() * size(&f.acceleration);
            let torques = bodies.iter().zip(&fields).fold(Vec3::zeros(), |sum, one| sum + torque(one));
            let drift = torques.norm() / bodies.iter().zip(&fields).map(most).sum::<f64>();
            println!("torques add up to {drift:.1e} of their sizes");
            assert!(drift < 1e-12, "torques add up to {drift} of their sizes");
        }
    });
}

/// All ranks' fields in order of id, as text.
fn gathered(comm: &Comm, bodies: &[Body], fields: &[Field]) -> String {
    let mut words: Vec<u64> = Vec::new();
    for (body, field) in bodies.iter().zip(fields) {
        words.push(body.id);
        words.extend(field.acceleration.iter().chain([&field.potential]).map(|x| x.to_bits()));
    }
    let received = comm.sparse_exchange(vec![(0, words)]);
    let mut all: Vec<&[u64]> = received.iter().flat_map(|(_, words)| words.chunks_exact(5)).collect();
    all.sort();
    format!("{} {:?} ", all.len(), blake3::hash(bytemuck::cast_slice(&all.concat())))
}

/// The same bits on any number of ranks, wherever bodies are.
#[test]
fn the_same_field_on_any_ranks() {
    same_on_any_ranks("gravity::the_same_field_on_any_ranks", |comm| {
        let mut bodies = bodies(comm, 15);
        let mut answer = String::new();
        for (accuracy, order) in [(f64::INFINITY, 3), (0.05, 3), (1e-3, 4), (1e-4, 5)] {
            let fields = solve(comm, &bodies, &Opening { angle: 0.8, accuracy, order });
            bodies.iter_mut().zip(&fields).for_each(|(body, field)| body.acceleration = size(&field.acceleration));
            answer += &gathered(comm, &bodies, &fields);
        }
        answer
    });
}

/// Bodies without mass are attracted and attract nobody, whole cells of them included: potentials as sums over the others, to 1e-3,
/// which is what the search for bound mass relies on.
#[test]
fn bodies_without_mass() {
    same_on_any_ranks("gravity::bodies_without_mass", |comm| {
        let has_mass = |body: &Body| body.position[1] <= 0.0 && body.id % 3 != 0;
        let with_mass: Vec<Body> = all_bodies(17).into_iter().filter(has_mass).collect();
        let mut bodies = bodies(comm, 17);
        bodies.iter_mut().filter(|body| !has_mass(body)).for_each(|body| body.mass = 0.0);
        assert!((600..1500).contains(&with_mass.len()), "{}", with_mass.len());
        let fields = solve(comm, &bodies, &Opening { angle: 0.7, accuracy: f64::INFINITY, order: 4 });
        let off = |(body, field): (&Body, &Field)| (field.potential / direct(&with_mass, body).potential - 1.0).abs();
        let worst = bodies.iter().zip(&fields).map(off).fold(0.0, f64::max);
        println!("potentials within {worst:.1e}");
        assert!(worst < 1e-3, "{worst}");
        gathered(comm, &bodies, &fields)
    });
}

/// An evaluation goes on while this rank does something else: where others have not begun it yet, nobody waits for them until it
/// is finished, and the field is that of one done at once. (If going on waited, no rank but the first would ever say that it
/// has gone on, for which the first waits before it begins.)
#[test]
fn evaluations_overlap_with_other_work() {
    ranks(3, "gravity::evaluations_overlap_with_other_work", |comm| {
        let (bodies, opening) = (bodies(comm, 11), Opening { angle: 0.7, accuracy: f64::INFINITY, order: 3 });
        let others: Vec<(usize, usize)> = (1..comm.size()).map(|rank| (rank, 1)).collect();
        let (to, from) = if comm.is_root() { (Vec::new(), others) } else { (vec![(0, 1)], Vec::new()) };
        let mut has_gone_on = Exchange::new(comm, &to, &from);
        let mut evaluation = Overlapped::new(comm, solve_later(comm, &bodies, &opening));
        if !comm.is_root() {
            (0..10).for_each(|_| evaluation.go_on());
        }
        has_gone_on.start(comm);
        has_gone_on.wait(comm);
        evaluation.go_on();
        let (later, at_once) = (evaluation.finish(), solve(comm, &bodies, &opening));
        assert!(!later.is_empty() && later == at_once);
    });
}

/// Few bodies, or none: on one rank, at one place, far apart.
#[test]
fn few_bodies() {
    ranks(3, "gravity::few_bodies", |comm| {
        let opening = Opening { angle: 0.8, accuracy: f64::INFINITY, order: 4 };
        let body =
            |id: u64, x: f64| Body { id, position: [x, 0.0, 0.0], mass: 6e10, softening: 1.0, acceleration: 0.0 };
        assert!(solve(comm, &[], &opening).is_empty());
        let of_first = |bodies: &[Body]| if comm.is_root() { bodies.to_vec() } else { Vec::new() };
        let one = solve(comm, &of_first(&[body(7, 3.0)]), &opening);
        assert!(one.iter().all(|field| field.acceleration == [0.0; 3] && field.potential.abs() < 1e-9), "{one:?}");
        let two = solve(comm, &of_first(&[body(7, 0.0), body(1, 5e8)]), &opening);
        if let [a, b] = &two[..] {
            let expected = G * 6e10 / 25e16;
            assert!((a.acceleration[0] / expected - 1.0).abs() < 1e-12, "{a:?}");
            assert_eq!(a.acceleration[0], -b.acceleration[0]);
        }
        let at_once = solve(comm, &of_first(&[body(7, 2.0), body(1, 2.0)]), &opening);
        assert!(at_once.iter().all(|field| field.acceleration == [0.0; 3] && field.potential < 0.0), "{at_once:?}");
        let none = solve(comm, &of_first(&[Body { mass: 0.0, ..body(7, 2.0) }]), &opening);
        assert!(none.iter().all(|field| *field == Field::default()), "{none:?}");
    });
}

/// A ball of cold gas without viscosity: nothing but gravity acts.
const DUST: &str = r#"
[[body]]
name = "cloud"
shape = { sphere = { radius = "10 km" } }
material = "ideal_gas"
density = "1000 kg/m^3"
internal_energy = "1e-9 J/kg"
particles = 5000

[gravity]
self = { accuracy = 0.005, interval = 0 }

[numerics]
viscosity = false
cfl = 0.05

[run]
until = "1 s"
"#;

/// The field of an even ball, and its fall into its own centre: r = R cos^2 x, t = (2 / pi) t_ff (x + sin(2 x) / 2).
#[test]
fn cold_collapse() {
    ranks(1, "gravity::cold_collapse", |comm| {
        let mut cloud = ByHand::<3>::new(DUST, comm, |_| {});
        let slope = -4.0 / 3.0 * PI * G * 1000.0;
        for i in cloud.particles().filter(|&i| (2e3..8e3).contains(&cloud.position(i).norm())) {
            let (x, a) = (cloud.position(i), cloud.get::<Vec3>("gravity", i));
            assert!((a - slope * x).norm() < 0.05 * (slope * x).norm(), "{x} {a}");
        }
        let spread = |cloud: &ByHand<3>| {
            let squares: f64 = cloud.particles().map(|i| cloud.position(i).norm_squared()).sum();
            (squares / cloud.particles().len() as f64).sqrt()
        };
        let (first, start) = (spread(&cloud), cloud.stepper.totals());
        let potential = -0.6 * G * start.mass * start.mass / 1e4;
        let found = start.potential.expect("gravity");
        assert!((found / potential - 1.0).abs() < 0.02, "{found} {potential}");
        let fall = free_fall_time_of(1000.0);
        for (x, radius) in [(0.5, 0.004450), (0.7, 0.01279), (0.85f64, 0.02869)] {
            let time = 2.0 / PI * fall * (x + 0.5 * (2.0 * x).sin());
            cloud.run(time, |_| {});
            let ratio = spread(&cloud) / first / x.cos().powi(2);
            let totals = cloud.stepper.totals();
            let energy = (totals.balance() - start.balance()) / potential.abs();
            let momentum = totals.momentum.norm() / totals.momentum_scale;
            println!(
                "{:.3} of the free-fall time, {} steps: radius {:.4} of that expected ({:.3} of the first), energy {energy:.1e}, momentum {momentum:.1e}",
                time / fall,
                cloud.steps(),
                ratio,
                x.cos().powi(2)
            );
            // Softening over 2h weakens gravity by about (h / R)^2.
            assert!((ratio - 1.0).abs() < 0.03, "{ratio}");
            assert_as_measured("radius, beside that expected", ratio - 1.0, radius);
            assert!(energy.abs() < 5e-4 && momentum < 1e-12, "{energy} {momentum}");
        }
    });
}

/// Two clouds that fall onto each other and to the ground, gravity evaluated every few steps: the same on any ranks and through
/// a checkpoint.
#[test]
fn clouds_on_any_ranks() {
    let (_, summary) = crate::sameness::compare_scene(
        "clouds",
        r#"
title = "Two clouds"

[[body]]
name = "left"
shape = { sphere = { radius = "10 km" } }
material = "ideal_gas"
density = "1000 kg/m^3"
internal_energy = "5 J/kg"
particles = 900

[[body]]
name = "right"
shape = { sphere = { radius = "7 km" } }
material = "ideal_gas"
density = "1500 kg/m^3"
internal_energy = "5 J/kg"
particles = 500
position = ["18 km", "3 km", "0 km"]
velocity = ["-10 m/s", "0 m/s", "0 m/s"]

[gravity]
uniform = [0, 0, "-1e-3 m/s^2"]
self = { accuracy = 0.02, interval = 0.003 }

[numerics]
smoothing_length = { follows = "density" }

[run]
until = "900 s"

[output]
picture = false
"#,
    );
    println!("{} steps, energy drift {}", summary["steps"], summary["energy_drift"]);
}

/// What is not asked for is not there: how the field changes is kept where it is not evaluated in every step.
#[test]
fn gravity_holds_its_columns_and_sends_no_more() {
    let columns = |changes: &[&str]| {
        let changes: Vec<String> = changes.iter().map(|change| change.to_string()).collect();
        let scene = Scene::parse("scene.toml", DUST, &changes).expect("a scene");
        let constants = scene.bodies.iter().map(|body| body.constants(3000, scene.numerics.eta)).collect();
        let plan = sph_mpi::simulation::setup::plan(&scene, constants).expect("a plan");
        let names: Vec<String> = plan.registry.entries.iter().map(|entry| entry.name.clone()).collect();
        (names, plan.terms)
    };
    let (none, terms) = columns(&["gravity=false"]);
    let (even, same_terms) = columns(&["gravity.self=false", "gravity.uniform=[0, 0, 1]"]);
    assert_eq!((&none, terms), (&even, same_terms));
    let (own, same_terms) = columns(&[]);
    let more: Vec<&str> = own.iter().filter(|name| !none.contains(name)).map(String::as_str).collect();
    assert_eq!((&more[..], terms), (&["gravity", "gravitational_potential"][..], same_terms));
    let (kept, same_terms) = columns(&["gravity.self.interval=0.003"]);
    let more: Vec<&str> = kept.iter().filter(|name| !own.contains(name)).map(String::as_str).collect();
    let rates = ["gravity_rate", "gravity_slope", "gravitational_potential_rate"];
    assert_eq!((&more[..], terms), (&rates[..], same_terms));
}

/// A small planet of molten rock that starts under its own weight.
const PLANET: &str = r#"
[[body]]
name = "planet"
shape = { sphere = { radius = "500 km" } }
material = "basalt"
particles = 8000
start = "hydrostatic"

[gravity]
self = { interval = 0.002 }

[numerics]
corrected_gradient = true

[run]
until = "1 s"
"#;

/// It stays at rest, and its pressure is 2/3 pi G rho^2 (R^2 - r^2), within 2 % of that in the middle.
#[test]
fn hydrostatic_start() {
    ranks(1, "gravity::hydrostatic_start", |comm| {
        let mut planet = ByHand::<3>::new(PLANET, comm, |_| {});
        let middle = 2.0 / 3.0 * PI * G * 2700.0f64.powi(2) * 25e10;
        let start = planet.stepper.totals();
        let off = |planet: &ByHand<3>| {
            let pressure = planet.numbers("pressure");
            let (mut worst, mut all) = (0.0f64, 0.0);
            for shell in 0..9 {
                let within =
                    |i: &usize| (5e4 * shell as f64..5e4 * (shell + 1) as f64).contains(&planet.position(*i).norm());
                let members: Vec<usize> = planet.particles().filter(within).collect();
                let off = |&i: &usize| pressure[i] / middle - (1.0 - planet.position(i).norm_squared() / 25e10);
                let mean = members.iter().map(off).sum::<f64>() / members.len() as f64;
                worst = worst.max(mean.abs());
                all += members.iter().map(|i| off(i).powi(2)).sum::<f64>();
            }
            (worst, (all / planet.particles().len() as f64).sqrt())
        };
        println!(
            "at the start: shells within {:.4}, rms {:.4} of the pressure in the middle",
            off(&planet).0,
            off(&planet).1
        );
        assert!(off(&planet).0 < 0.02, "{:?}", off(&planet));
        assert_as_measured("pressure at the start", off(&planet).0, 0.008742);
        // Sound crosses it in 320 s; it would fall into itself in 1280 s.
        let mut fastest = 0.0f64;
        planet.run(960.0, |planet| {
            let squares: f64 = planet.particles().map(|i| planet.velocity(i).norm_squared()).sum();
            fastest = fastest.max((squares / planet.particles().len() as f64).sqrt());
        });
        let escape = (8.0 / 3.0 * PI * G * 2700.0).sqrt() * 5e5;
        let end = planet.stepper.totals();
        println!(
            "after 3 crossings, {} steps: shells within {:.4}, rms {:.4}; rms speed at most {:.2e} of the speed of escape; energy drift {:.1e} of the potential",
            planet.steps(),
            off(&planet).0,
            off(&planet).1,
            fastest / escape,
            (end.balance() - start.balance()) / start.potential.expect("gravity").abs()
        );
        assert!(off(&planet).0 < 0.02 && fastest < 0.01 * escape, "{:?} {fastest} {escape}", off(&planet));
        assert_as_measured("pressure at the end", off(&planet).0, 0.006042);
        assert_as_measured("largest speed", fastest / escape, 0.002151);
    });
}

#[test]
fn what_cannot_start_at_rest_is_refused() {
    for (change, said) in [
        ("gravity.self=false", "nothing attracts"),
        ("planet.material=ideal_gas", "density"),
        ("planet.shape={ box = { size = [1, 1, 1] } }", "no ball"),
        ("material.basalt.porosity.p_alpha=true", "pores"),
        ("planet.start=hydrostatc", "hydrostatic"),
    ] {
        let error = Scene::parse("scene.toml", PLANET, &[change.to_string()]).err();
        let found = error.map_or("no error".into(), |error| error.to_string());
        assert!(found.contains(said), "{change}: {found}");
    }
}
