//! Hard cases of few particles: too near, too far, too few, too fast, too thin. Where the cure is in the code, a comment says
//! what the figure was when it was taken out.

use sph_mpi::domain::comm::Comm;
use sph_mpi::exact::shock::Medium;
use sph_mpi::material::eos::EosTable;
use sph_mpi::math::Vec3;
use sph_mpi::random::uniform;
use sph_mpi::scene::Scene;
use sph_mpi::step::pack::Packer;

use crate::common::{ByHand, assert_as_measured, ranks};

/// A ball, and particles to be put wherever a test needs them.
const BALL: &str = r#"
title = "A ball of rock"
[[body]]
name = "ball"
shape = { sphere = { radius = "1 m" } }
material = "basalt"
spacing = "25 cm"
[[body]]
name = "spray"
shape = { sphere = { radius = "50 cm" } }
position = ["10 m", 0, 0]
material = "basalt"
spacing = "25 cm"
[material.basalt.strength]
[numerics]
corrected_gradient = true
artificial_stress = true
[run]
until = 1
"#;

/// The step of the ball at rest, s.
fn calm(comm: &Comm) -> f64 {
    ByHand::<3>::new(BALL, comm, |_| {}).dt
}

/// The particle nearest to a point.
fn at<const D: usize>(hand: &ByHand<D>, point: Vec3) -> usize {
    let far = |i: &usize| (hand.position(*i) - point).norm();
    hand.particles().min_by(|i, j| far(i).total_cmp(&far(j))).expect("a particle")
}

/// Two particles at 1e-12 h that meet with 1 km/s pass through each other. Without 0.01 h^2 in the viscosity one step was the
/// last: accelerations of 1e56 m/s^2.
#[test]
fn nearly_coincident_particles() {
    ranks(1, "hard_neighbours::nearly_coincident_particles", |comm| {
        let calm = calm(comm);
        for kernel in ["cubic_spline", "wendland_c2"] {
            let pinned = if kernel == "cubic_spline" { [0.0, -0.001779, 0.001405] } else { [0.0, -0.1561, 0.001389] };
            let cases = [(0.0, true), (1e3, true), (1e3, false)];
            for ((speed, artificial_stress), measured) in cases.into_iter().zip(pinned) {
                let change =
                    [format!("numerics.kernel={kernel}"), format!("numerics.artificial_stress={artificial_stress}")];
                let mut hand = ByHand::<3>::with(BALL, &change.each_ref().map(String::as_str), comm, |_, _, _| {});
                let [least, energy, momentum] = meet(&mut hand, speed);
                println!(
                    "{kernel}, {speed} m/s, artificial stress {artificial_stress}: step {:.3} of the ball's, \
                     energy {energy:.1e}, momentum {momentum:.1e}",
                    least / calm
                );
                assert!(least > 0.5 * calm && momentum < 1e-13);
                // The pair crosses its core within a few steps, a coarse integration. The artificial stress between particles
                // this close, f^4 = 350 with Wendland's kernel, is too stiff for these steps: 0.2 to 16 %.
                assert!(energy.abs() < if artificial_stress { 0.2 } else { 0.02 }, "{energy}");
                assert_as_measured(&format!("{kernel}, {speed} m/s, energy"), energy, measured);
            }
        }
    });
}

/// Puts a particle of the ball onto another and lets them meet; shortest step, s, and drifts of energy and momentum.
fn meet(hand: &mut ByHand<3>, speed: f64) -> [f64; 3] {
    let one = at(hand, Vec3::zeros());
    let here = hand.position(one);
    let near = |i: &usize| *i != one && (hand.position(*i) - here).norm() < 0.26;
    let other = hand.particles().find(near).expect("a neighbour");
    let away = Vec3::new(1.0, 1.0, 1.0).normalize();
    hand.set("position", other, here + 1e-12 * 0.267 * away);
    hand.set("velocity", one, 0.5 * speed * away);
    hand.set("velocity", other, -0.5 * speed * away);
    hand.evaluate();
    let before = hand.stepper.totals();
    let mut least = hand.dt;
    for _ in 0..300 {
        hand.step(f64::INFINITY);
        least = least.min(hand.dt);
    }
    let after = hand.stepper.totals();
    let momentum = (after.momentum - before.momentum).norm() / after.momentum_scale.max(1.0);
    [least, (after.energy() - before.energy()) / before.energy().max(1.0), momentum]
}

/// One particle; two; three on a line; four in a plane; three neighbours in as many directions, far from all others.
const GROUPS: [&[[f64; 3]]; 5] = [
    &[[0.0; 3]],
    &[[0.0; 3], [1.0, 0.3, -0.2]],
    &[[-1.0, 0.2, 0.1], [0.0; 3], [1.0, -0.2, -0.1]],
    &[[0.0; 3], [1.0, 0.1, 0.3], [-0.3, 1.0, 0.1], [0.7, 1.1, 0.4]],
    &[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
];

/// Puts the groups far from everything, with velocities drawn at random, and every other particle of the spray alone.
fn scatter<const D: usize>(hand: &mut ByHand<D>, groups: &[&[[f64; 3]]]) {
    let mut spray = hand.particles().filter(|&i| hand.body(i) == 1).collect::<Vec<_>>().into_iter();
    for (group, places) in groups.iter().enumerate() {
        for place in *places {
            let i = spray.next().expect("enough particles");
            hand.set("position", i, Vec3::new(10.0, 5.0 * group as f64, 0.0) + 0.25 * Vec3::from(*place));
            let n = hand.id(i);
            hand.set("velocity", i, Vec3::from_fn(|k, _| 1e3 * (uniform(3, n, k as u64) - 0.5)));
        }
    }
    for (k, i) in spray.enumerate() {
        hand.set("position", i, Vec3::new(-50.0 - 5.0 * k as f64, 0.0, 0.0));
    }
}

/// Rates of density of ball and spray, in the order of ids, and the step.
fn rates<const D: usize>(text: &str, corrected: bool, groups: &[&[[f64; 3]]], comm: &Comm) -> ([Vec<f64>; 2], f64) {
    let change = format!("numerics.corrected_gradient={corrected}");
    let mut hand = ByHand::<D>::with(text, &[&change], comm, |_, _, _| {});
    let stir = |n: u64| Vec3::from_fn(|k, _| 10.0 * (uniform(5, n, k as u64) - 0.5));
    hand.particles().for_each(|i| hand.set("velocity", i, stir(hand.id(i))));
    scatter(&mut hand, groups);
    hand.evaluate();
    let of = |body: usize| {
        let mut own: Vec<usize> = hand.particles().filter(|&i| hand.body(i) == body).collect();
        own.sort_by_key(|&i| hand.id(i));
        own.into_iter().map(|i| hand.numbers("density_rate")[i] / 2700.0).collect::<Vec<f64>>()
    };
    ([of(0), of(1)], hand.dt)
}

/// Where neighbours are too few to tell a gradient, the uncorrected one stands. Without the guard, three particles on a line
/// that part with 1 km/s made strain rates of -5e4/s instead of -34/s, four in a plane -1152/s instead of -25/s; an impact
/// fell to steps of 1e-4 of those before, and its energy drifted by 6 %.
#[test]
fn degenerate_neighbourhoods() {
    ranks(1, "hard_neighbours::degenerate_neighbourhoods", |comm| {
        let flat = BALL.replacen("[[body]]", "dimension = 2\n[[body]]", 1).replace("[\"10 m\", 0, 0]", "[\"10 m\", 0]");
        let check = |([ball, spray], dt): ([Vec<f64>; 2], f64),
                     ([plain_ball, plain_spray], plain_dt): ([Vec<f64>; 2], f64)| {
            assert_eq!(spray, plain_spray, "the spray is not corrected");
            assert!(ball.iter().zip(&plain_ball).filter(|(a, b)| a != b).count() > ball.len() / 2, "the ball is");
            assert!(
                spray.iter().all(|rate| rate.abs() < 1e3 / 0.25)
                    && spray.iter().filter(|rate| **rate != 0.0).count() >= 5
            );
            assert!((dt / plain_dt - 1.0).abs() < 0.01, "{dt} {plain_dt}");
        };
        check(rates::<3>(BALL, true, &GROUPS, comm), rates::<3>(BALL, false, &GROUPS, comm));
        let lines = &GROUPS[..3];
        check(rates::<2>(&flat, true, lines, comm), rates::<2>(&flat, false, lines, comm));
    });
}

/// Particles that have left everything behind, 28 km/s hot in sound, send no signal to anyone. If they counted, steps would be
/// 0.165 of the ball's.
#[test]
fn hot_spray_does_not_hold_up_the_rest() {
    ranks(1, "hard_neighbours::hot_spray_does_not_hold_up_the_rest", |comm| {
        let mut hand = ByHand::<3>::new(BALL, comm, |_| {});
        let calm = hand.dt;
        scatter(&mut hand, &[]);
        for i in hand.particles().filter(|&i| hand.body(i) == 1).collect::<Vec<_>>() {
            hand.set("internal_energy", i, 1e9);
            hand.set("density", i, 1e-3);
            hand.set("velocity", i, Vec3::new(-1e4, 0.0, 0.0));
        }
        hand.evaluate();
        let fastest = hand.numbers("sound_speed").iter().copied().fold(0.0, f64::max);
        assert!(fastest > 2e4 && hand.dt > 0.99 * calm, "{fastest} m/s, {} of the step", hand.dt / calm);
        for _ in 0..50 {
            hand.step(f64::INFINITY);
        }
        assert!(hand.dt > 0.99 * calm);
        let away =
            hand.particles().filter(|&i| hand.body(i) == 1).all(|i| hand.velocity(i) == Vec3::new(-1e4, 0.0, 0.0));
        assert!(away, "spray flies straight on");
    });
}

/// A particle shot through the ball, and one of ten times its density. Steps are those of the Courant condition, they never let
/// a volume change by more than 0.4, and they come back when the disturbance has spread.
#[test]
fn one_particle_does_not_stop_the_run() {
    ranks(1, "hard_neighbours::one_particle_does_not_stop_the_run", |comm| {
        let calm = calm(comm);
        for (speed, density) in [(5e4, 2700.0), (5e5, 2700.0), (0.0, 2.7e4)] {
            let mut hand = ByHand::<3>::new(BALL, comm, |_| {});
            let one = at(&hand, Vec3::zeros());
            hand.set("velocity", one, Vec3::new(speed, 0.1 * speed, 0.2 * speed));
            hand.set("density", one, density);
            hand.evaluate();
            let expected = courant(&hand);
            // Pairs see speeds of sound and h to 5e-7.
            assert!((hand.dt / expected - 1.0).abs() < 1e-6, "{} {expected}", hand.dt);
            let (mut least, mut strain) = (f64::INFINITY, 0.0f64);
            while hand.time < 100.0 * calm {
                let rate = hand.numbers("density_rate").iter().zip(hand.numbers("density")).map(|(r, d)| (r / d).abs());
                strain = strain.max(hand.dt * rate.fold(0.0, f64::max));
                least = least.min(hand.dt);
                hand.step(f64::INFINITY);
            }
            println!(
                "{speed:.0} m/s, {density} kg/m^3: {} steps, shortest {:.1e}, last {:.2} of the ball's, strain {strain:.3}",
                hand.steps(),
                least / calm,
                hand.dt / calm
            );
            assert!(least > 1e-3 * calm && hand.dt > 0.3 * calm && strain <= 0.4);
        }
    });
}

/// Smallest C h / (c + 0.6 (alpha c + beta |mu|)) of all particles, pair by pair.
fn courant(hand: &ByHand<3>) -> f64 {
    let h = |i: usize| hand.stepper.settings.view.constants[hand.body(i)].smoothing_length;
    let approach = |i: usize, j: usize| {
        let (x, v) = (hand.position(i) - hand.position(j), hand.velocity(i) - hand.velocity(j));
        let mean = 2.0 / (1.0 / h(i) + 1.0 / h(j));
        let near = x.norm() < 2.0 * h(i).max(h(j));
        if near { (-mean * x.dot(&v) / (x.norm_squared() + 0.01 * mean * mean)).max(0.0) } else { 0.0 }
    };
    let limit = |i: usize| {
        let c = hand.numbers("sound_speed")[i];
        let mu = hand.particles().filter(|&j| j != i).map(|j| approach(i, j)).fold(0.0, f64::max);
        0.25 * h(i) / (c + 0.6 * (1.5 * c + 3.0 * mu))
    };
    hand.particles().map(limit).fold(f64::INFINITY, f64::min)
}

/// In matter without sound nothing but the change of volume limits a step: 0.4 / |tr L|. In impacts of 5 to 60 km/s this
/// limit never decides, and without it they take the same steps; but here there would be none.
#[test]
fn cold_gas_takes_the_steps_of_its_expansion() {
    const GAS: &str = r#"
title = "Cold gas expands"
[[body]]
name = "gas"
shape = { sphere = { radius = 1 } }
material = "ideal_gas"
density = 1
spacing = 0.25
flow = { stretch = [1, 2, 3] }
[numerics]
corrected_gradient = true
[run]
until = 1
"#;
    ranks(1, "hard_neighbours::cold_gas_takes_the_steps_of_its_expansion", |comm| {
        let mut hand = ByHand::<3>::new(GAS, comm, |_| {});
        assert!((hand.dt / (0.4 / 6.0) - 1.0).abs() < 1e-12, "{}", hand.dt);
        assert_eq!(hand.stepper.tightest_limit().reason, "density");
        hand.run(1.0, |_| {});
    });
}

const SPRAY: &str = r#"
title = "Compressed rock beside spray"
[domain]
periodic = { y = ["0 cm", "6.928 cm"], z = ["0 cm", "6.532 cm"] }
[[body]]
name = "rock"
shape = { box = { size = ["12 cm", "6.928 cm", "6.532 cm"] } }
position = ["-6 cm", "3.464 cm", "3.266 cm"]
material = "basalt"
spacing = "1 cm"
density = "3481 kg/m^3"
[[body]]
name = "spray"
shape = { box = { size = ["3 cm", "6.928 cm", "6.532 cm"] } }
position = ["1.5 cm", "3.464 cm", "3.266 cm"]
material = "basalt"
spacing = "1 cm"
[[layer]]
x = ["-12 cm", "-9 cm"]
motion = "fixed"
[numerics]
smoothing_length = SMOOTHING
[run]
until = 1
"#;

/// Particles at a thousandth of their density touch rock at 10 GPa. Volumes capped at twice that of the spacing, nothing gets
/// faster than the rock's own release; with m / rho as their volume, one step throws them out.
#[test]
fn rock_beside_spray() {
    ranks(1, "hard_neighbours::rock_beside_spray", |comm| {
        for smoothing in ["\"constant\"", "{ follows = \"density\", largest = 1.2 }"] {
            let fastest = |capped: bool, steps: u64| {
                let text = SPRAY.replace("SMOOTHING", smoothing);
                let mut hand = ByHand::<3>::with(&text, &[], comm, |columns, settings, _| {
                    if !capped {
                        // The cap is 2 (h / eta)^3.
                        let (layout, eta) = (settings.pair_loop.layout(), 0.01);
                        settings.packer = Packer::new(&columns.registry, &settings.view, layout, 0.0, eta);
                    }
                });
                let law = hand.scene.materials[0].eos.law();
                let rock = Medium { law, density: 3481.0, internal_energy: 0.0 };
                assert!((rock.state().stress / 1e10 - 1.0).abs() < 0.01, "10 GPa");
                for i in hand.particles().filter(|&i| hand.body(i) == 1).collect::<Vec<_>>() {
                    hand.set("density", i, 2.7);
                }
                hand.evaluate();
                let before = hand.stepper.totals();
                let mut fastest = 0.0f64;
                while hand.time < 20e-6 && hand.steps() < steps {
                    hand.step(20e-6 - hand.time);
                    fastest = hand.particles().map(|i| hand.velocity(i).norm()).fold(fastest, f64::max);
                }
                let after = hand.stepper.totals();
                let drift = (after.balance() - before.balance()) / after.kinetic;
                let release = rock.release(&rock.state()).expect("a release").velocity;
                println!(
                    "{smoothing}, capped {capped}: {:.2} of {release:.0} m/s, energy {drift:.1e}",
                    fastest / release
                );
                (fastest / release, drift)
            };
            let (fast, drift) = fastest(true, 1000);
            assert!((0.5..1.5).contains(&fast) && drift.abs() < 1e-3);
            assert!(fastest(false, 100).0 > 10.0, "the defect is gone");
        }
    });
}

/// Tillotson's law of every material of the library, expanded to 0.002 to 0.998 of its density at energies up to four times
/// that of vapour. Without the fading of tension materials pulled with 0.25 to 1 A and c^2 was negative in 38 to 61 % of
/// these states; with B mu^2 nylon pushed with 2.3 A and water with 5.1 A; with B = 1.06 A anorthosite did with 0.05 A.
#[test]
fn cold_expanded_matter() {
    let library: toml::Table = toml::from_str(include_str!("../src/material/library.toml")).expect("the library");
    let solids = library.iter().filter(|(_, table)| table.get("eos").is_some_and(|eos| eos.get("tillotson").is_some()));
    let mut seen = 0;
    for (name, _) in solids {
        let body = format!(
            "[[body]]\nname = \"b\"\nshape = {{ sphere = {{ radius = 1 }} }}\nmaterial = \"{name}\"\nspacing = 0.5\n"
        );
        let scene = Scene::parse("scene.toml", &(body + "[run]\nuntil = 1\n"), &[]).expect("a scene");
        let EosTable::Tillotson(table) = scene.materials[0].eos else { panic!("{name}") };
        let (law, modulus, rho_0) = (scene.materials[0].eos.law(), table.modulus_a.0, table.rho_0.0);
        let (mut pull, mut push, mut slowest) = (0.0f64, f64::MIN, f64::INFINITY);
        for eta in (1..500).map(|k| 0.002 * k as f64) {
            for j in 0..60 {
                let u = if j == 0 { 0.0 } else { 100.0 * libm::pow(4.0 * table.e_cv.0 / 100.0, j as f64 / 59.0) };
                let (p, c) = law.pressure(eta * rho_0, u);
                assert!(p.is_finite() && c.is_finite(), "{name} {eta} {u}");
                pull = pull.max(-p / modulus);
                slowest = slowest.min(c * c * rho_0 / modulus);
                push = if j == 0 { push.max(p / modulus) } else { push };
            }
        }
        println!("{name}: pulls with {pull:.4} A, pushes cold with {push:.1e} A, c^2 from {slowest:.3} A / rho_0");
        // A (1 - eta) (eta - 0.85) / 0.1 is largest at eta = 0.925.
        assert!(pull < 0.05625 * (1.0 + 1e-12) && push <= 0.0 && slowest >= 0.25 * (1.0 - 1e-12), "{name}");
        seen += 1;
    }
    assert!(seen >= 12);
}

/// A liquid pulled through all these states. With c^2 as it comes, the speed of sound is NaN after the
/// first step.
#[test]
fn a_liquid_that_is_pulled_apart() {
    const LIQUID: &str = r#"
title = "A liquid is pulled apart"
[[body]]
name = "drop"
shape = { sphere = { radius = "1 m" } }
material = "basalt"
spacing = "25 cm"
flow = { stretch = [3000, 5000, 8000] }
[run]
until = 1
"#;
    ranks(1, "hard_neighbours::a_liquid_that_is_pulled_apart", |comm| {
        let mut hand = ByHand::<3>::new(LIQUID, comm, |_| {});
        hand.run(2e-4, |_| {});
        let thickest = hand.numbers("density").iter().copied().fold(0.0, f64::max);
        let slowest = hand.numbers("sound_speed").iter().copied().fold(f64::INFINITY, f64::min);
        let floor = 0.5 * (26.7e9f64 / 2700.0).sqrt();
        println!("{} steps, density up to {thickest:.0} kg/m^3, sound from {slowest:.1} m/s", hand.steps());
        assert!(thickest < 0.85 * 2700.0 && slowest >= floor * (1.0 - 1e-12));
    });
}

/// Matter in wild motion uses its lists up every other step, and none of them ever lacks a pair. Where lists were built only after
/// twice the skin was used, hundreds of pairs went unseen.
#[test]
fn no_list_lacks_a_pair() {
    ranks(1, "hard_neighbours::no_list_lacks_a_pair", |comm| {
        for (skin, builds) in [("0", 40), ("0.05", 15), ("0.2", 4), ("auto", 4)] {
            let mut hand =
                ByHand::<3>::with(BALL, &[&format!("numerics.skin={skin}")], comm, |columns, settings, _| {
                    for i in 0..columns.len() {
                        let draw = |k| uniform(5, i as u64, k) - 0.5;
                        let velocity = Vec3::new(draw(0), draw(1), draw(2)) * 4e3;
                        columns.set(settings.view.core.velocity, i, velocity);
                    }
                });
            let before = hand.stepper.counters.list_builds;
            for step in 0..40 {
                let seen = hand.stepper.counters.pairs;
                hand.step(f64::INFINITY);
                assert_eq!(hand.stepper.counters.pairs - seen, pairs(&hand), "skin {skin}, step {step}");
            }
            let built = hand.stepper.counters.list_builds - before;
            println!("skin {skin}: {built} lists in 40 steps");
            assert!(built >= builds, "skin {skin}: {built} lists");
        }
    });
}

/// Where little of a body moves fast, skins of its own let lists last longer than one skin for all, and hold less; none lacks a pair.
#[test]
fn fast_matter_alone_has_wide_skins() {
    ranks(1, "hard_neighbours::fast_matter_alone_has_wide_skins", |comm| {
        let of = |skin: &str| {
            let changes = ["ball.spacing=7 cm", &format!("numerics.skin={skin}")];
            let mut hand = ByHand::<3>::with(BALL, &changes, comm, |columns, settings, _| {
                let core = settings.view.core;
                let top = (0..columns.len()).map(|i| columns.get(core.position, i).z).fold(0.0, f64::max);
                for i in 0..columns.len() {
                    if columns.get(core.position, i).z > 0.9 * top {
                        let draw = |k| uniform(5, i as u64, k) - 0.5;
                        columns.set(core.velocity, i, Vec3::new(draw(0), draw(1), draw(2)) * 4e3);
                    }
                }
            });
            let (before, mut entries) = (hand.stepper.counters.list_builds, 0.0);
            for step in 0..20 {
                let seen = hand.stepper.counters.pairs;
                hand.step(f64::INFINITY);
                assert_eq!(hand.stepper.counters.pairs - seen, pairs(&hand), "skin {skin}, step {step}");
                entries += hand.stepper.neighbourhood.list_size().entries / 20.0;
            }
            let built = hand.stepper.counters.list_builds - before;
            println!("skin {skin}: {built} lists in 20 steps, {entries:.0} entries");
            (built, entries)
        };
        let (one, own) = (of("0.1"), of("auto"));
        assert!(3 * own.0 <= 2 * one.0 && own.1 < one.1, "{own:?} {one:?}");
    });
}

/// Directed pairs inside the larger support, by looking at all.
fn pairs(hand: &ByHand<3>) -> u64 {
    let support = |i: usize| 2.0 * hand.stepper.settings.view.constants[hand.body(i)].smoothing_length;
    let sites: Vec<([f64; 3], f64)> = hand.particles().map(|i| (hand.position(i).into(), support(i))).collect();
    let mut found = 0;
    for (a, own) in &sites {
        for (b, other) in &sites {
            let [x, y, z] = [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
            let reach = if other > own { other } else { own };
            found += u64::from(x * x + y * y + z * z < reach * reach);
        }
    }
    found - sites.len() as u64
}
