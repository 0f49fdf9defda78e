//! Rigid bodies: how they turn, hit each other and what deforms, and rest; that all of it is conserved, and that scenes without them
//! have nothing of it.

use std::f64::consts::{PI, TAU};

use sph_mpi::math::Vec3;
use sph_mpi::motion::rigid::RigidBody;
use sph_mpi::scene::Scene;
use sph_mpi::simulation::setup;

use crate::common::{ByHand, ranks};
use crate::errors::assert_scene_refused;

/// One box in free flight; its edges make it asymmetric, or two of them alike.
fn flying_box(edges: [u32; 3], spin: [f64; 3]) -> String {
    let [x, y, z] = edges;
    format!(
        "[[body]]\nname = \"top\"\nshape = {{ box = {{ size = [\"{x} m\", \"{y} m\", \"{z} m\"] }} }}\nmaterial = \"basalt\"\n\
         spacing = \"1 m\"\nlattice = \"cubic\"\nvelocity = [\"3 m/s\", \"-1 m/s\", \"2 m/s\"]\nspin = {spin:?}\nrigid = true\n[run]\nuntil = 1\n"
    )
}

fn energy_of_turning(body: &RigidBody) -> f64 {
    0.5 * body.motion.angular_momentum.dot(&body.spin())
}

/// A hundred turns of an asymmetric body about an axis near its middle one, where it tumbles: sums over its particles and its own motion
/// keep momentum, angular momentum and energy. Turns of second order would lose a thousandth of the energy here.
#[test]
fn a_free_body_turns_and_keeps_what_it_has() {
    ranks(1, "rigid::a_free_body_turns_and_keeps_what_it_has", |comm| {
        let mut top = ByHand::<3>::new(&flying_box([6, 4, 2], [0.1, 2.0, 0.1]), comm, |_| {});
        let (first, start) = (top.stepper.totals(), top.stepper.state.rigid[0].clone());
        assert!(
            (0.5 * first.momentum.norm_squared() / first.mass + energy_of_turning(&start) - first.kinetic).abs()
                < 1e-9 * first.kinetic
        );
        top.run(100.0 * TAU / 2.0, |_| {});
        let (last, end) = (top.stepper.totals(), &top.stepper.state.rigid[0]);
        let turned = energy_of_turning(end) / energy_of_turning(&start) - 1.0;
        let kinetic = last.kinetic / first.kinetic - 1.0;
        println!("{} steps; energy of turning changed by {turned:.1e}, all of it by {kinetic:.1e}", top.steps());
        assert!(turned.abs() < 1e-6 && kinetic.abs() < 1e-6, "{turned:e} {kinetic:e}");
        assert!((last.momentum - first.momentum).norm() < 1e-12 * first.momentum_scale);
        assert!(
            (last.angular_momentum - first.angular_momentum).norm()
                < 1e-11 * last.angular_scale.max(first.angular_scale)
        );
        let norm: f64 = end.motion.orientation.0.iter().map(|q| q * q).sum();
        assert!((norm - 1.0).abs() < 1e-14, "{norm}");
        // The body is as it was: no rotation pulls its particles apart.
        let centre = end.motion.centre;
        let farthest = top.particles().map(|i| (top.position(i) - centre).norm()).fold(0.0, f64::max);
        assert!((farthest / start.reach - 1.0).abs() < 1e-13, "{farthest} {}", start.reach);
        assert!(top.particles().all(|i| top.get::<f64>("density", i) == top.scene.bodies[0].density));
    });
}

/// The axis of a symmetric top goes round its angular momentum once in 2 pi J_1 / |L|, as Euler's equations say; with an integrator of
/// several stages, too, and its steps then are as short as the error of its turning asks for.
#[test]
fn a_symmetric_top_precesses() {
    ranks(1, "rigid::a_symmetric_top_precesses", |comm| {
        for integrator in ["\"predictor_corrector\"", "{ cash_karp = { tolerance = 1e-8 } }"] {
            let scene = format!("{}[numerics]\nintegrator = {integrator}\n", flying_box([4, 4, 2], [0.5, 0.0, 2.0]));
            let mut top = ByHand::<3>::new(&scene, comm, |_| {});
            let start = top.stepper.state.rigid[0].clone();
            let period = TAU / (start.motion.angular_momentum.norm() * start.mobility[0][0]);
            let axis = |body: &RigidBody| body.motion.orientation.matrix() * Vec3::z();
            let mut halfway = 0.0f64;
            top.run(50.0 * period, |top| {
                halfway = halfway.max((axis(&top.stepper.state.rigid[0]) - axis(&start)).norm());
            });
            let off = (axis(&top.stepper.state.rigid[0]) - axis(&start)).norm();
            println!(
                "{integrator}: {off:.1e} rad after 50 periods of {period} s, {} steps; {halfway:.2} rad between",
                top.steps()
            );
            assert!(off < 1e-5 && halfway > 0.25, "{off:e} {halfway}");
        }
    });
}

/// Two rigid balls, one of them faster, beside its path by `offset`.
fn two_balls(offset: f64, viscosity: bool) -> String {
    let ball = |name: &str, x: f64, y: f64, v: f64, density: f64| {
        format!(
            "[[body]]\nname = \"{name}\"\nshape = {{ sphere = {{ radius = \"1 m\" }} }}\nmaterial = \"basalt\"\ndensity = {density}\n\
             spacing = \"25 cm\"\nlattice = \"cubic\"\nposition = [{x}, {y}, 0]\nvelocity = [{v}, 0, 0]\nrigid = true\n"
        )
    };
    let (a, b) = (ball("a", -1.6, 0.0, 1.0, 2700.0), ball("b", 1.6, offset, -2.0, 5400.0));
    format!("{a}{b}[numerics]\nviscosity = {viscosity}\n[run]\nuntil = 1\n")
}

/// Without viscosity two rigid bodies part with the energy that they met with: their contact is a spring. With it they lose some.
#[test]
fn rigid_bodies_bounce_off_each_other() {
    ranks(1, "rigid::rigid_bodies_bounce_off_each_other", |comm| {
        for (offset, viscosity) in [(0.0, false), (0.7, false), (0.0, true)] {
            let mut balls = ByHand::<3>::new(&two_balls(offset, viscosity), comm, |_| {});
            let (first, mut least) = (balls.stepper.totals(), f64::INFINITY);
            balls.run(2.0, |balls| least = least.min(balls.stepper.totals().kinetic));
            let last = balls.stepper.totals();
            let (kept, in_touch) = (last.kinetic / first.kinetic, least / first.kinetic);
            let (p, l) = (last.momentum - first.momentum, last.angular_momentum - first.angular_momentum);
            let [a, b] = [0, 1].map(|k| balls.stepper.state.rigid[k].motion.velocity.x);
            println!("offset {offset} m: energy {kept:.6} (least {in_touch:.3}), velocities {a:.4} {b:.4} m/s");
            assert!(p.norm() < 1e-12 * first.momentum_scale, "{p}");
            assert!(l.norm() < 1e-12 * first.angular_scale, "{l}");
            assert!(a < b && in_touch < 0.95, "they met and part: {a} {b}");
            if viscosity {
                assert!((0.05..0.9).contains(&kept), "{kept}");
            } else {
                assert!((kept - 1.0).abs() < 2e-3, "{kept}");
            }
            if offset == 0.0 && !viscosity {
                // Elastic, masses 1 and 2: (1, -2) becomes (-3, 0).
                assert!((a + 3.0).abs() < 0.02 && b.abs() < 0.02, "{a} {b}");
            }
            // Nothing is near any more: both have their own density again, for the next time they meet.
            (0..60).for_each(|_| balls.step(0.01));
            let strained = balls.particles().map(|i| {
                let density = balls.scene.bodies[balls.body(i)].density;
                (balls.get::<f64>("density", i) / density - 1.0).abs()
            });
            assert!(strained.fold(0.0, f64::max) < 1e-12);
        }
    });
}

/// A rigid ball comes to rest in a hollow of a rigid floor, which bears its weight.
#[test]
fn a_rigid_body_rests_on_a_floor() {
    const SCENE: &str = r#"
        [gravity]
        uniform = [0, 0, "-9.81 m/s^2"]
        [[body]]
        name = "ball"
        shape = { sphere = { radius = "1 m" } }
        material = "basalt"
        spacing = "25 cm"
        lattice = "cubic"
        position = ["12.5 cm", "12.5 cm", "1.3 m"]
        rigid = { sound_speed = "40 m/s" }
        [[body]]
        name = "floor"
        shape = { box = { size = ["3 m", "3 m", "75 cm"] } }
        material = "basalt"
        spacing = "25 cm"
        lattice = "cubic"
        position = [0, 0, "-37.5 cm"]
        motion = "fixed"
        rigid = { sound_speed = "40 m/s" }
        [run]
        until = 1
    "#;
    ranks(1, "rigid::a_rigid_body_rests_on_a_floor", |comm| {
        let mut ball = ByHand::<3>::new(SCENE, comm, |_| {});
        let first = ball.stepper.totals();
        let weight = 9.81 * ball.stepper.state.rigid[0].mass;
        ball.run(16.0, |_| {});
        let [upper, floor] = [0, 1].map(|k| ball.stepper.state.rigid[k].clone());
        let (speed, centre) = (upper.motion.velocity.norm(), upper.motion.centre);
        let borne = -floor.load.force.z - 9.81 * floor.mass;
        println!("{speed:.1e} m/s at {:.3} m; the floor bears {:.4} of the weight", centre.z, borne / weight);
        assert!(speed < 5e-3 && (centre.xy().add_scalar(-0.125)).norm() < 1e-2, "{speed} {centre}");
        assert!((0.9..1.2).contains(&centre.z), "{centre}");
        assert_eq!((floor.motion.velocity, floor.motion.work), (Vec3::zeros(), 0.0));
        // What holds the floor has taken up all the momentum of gravity.
        let last = ball.stepper.totals();
        let off = last.momentum_balance(ball.time) - first.momentum_balance(0.0);
        assert!(off.norm() < 1e-9 * weight * ball.time, "{off}");
        assert!((borne / weight - 1.0).abs() < 0.02, "{}", borne / weight);
    });
}

/// A block of rubber in free space, hit by a ball of `density` beside its middle.
fn ball_and_block(ball: &str) -> String {
    format!(
        r#"
[[body]]
name = "block"
shape = {{ box = {{ size = ["12 mm", "12 mm", "6 mm"] }} }}
material = "rubber"
spacing = "1 mm"

[[body]]
name = "ball"
shape = {{ sphere = {{ radius = "3 mm" }} }}
material = "steel"
spacing = "1 mm"
position = ["3 mm", "1 mm", "8.5 mm"]
velocity = ["2 m/s", 0, "-10 m/s"]
{ball}

[material.rubber]
eos = {{ tillotson = {{ rho_0 = 1000, a = 0.5, b = 0.5, A = "20 MPa", B = "20 MPa", E_0 = "1 MJ/kg", E_iv = "1 MJ/kg", E_cv = "4 MJ/kg", alpha = 5, beta = 5 }} }}
[material.rubber.strength]
shear_modulus = "20 MPa"
yield_strength = "1 GPa"
[material.steel]
eos = {{ murnaghan = {{ rho_0 = 7800, K_0 = "160 GPa", n = 4 }} }}

[run]
until = "1 ms"

[output]
picture = false
history_every = 1
"#
    )
}

/// Momentum is kept to rounding, angular momentum and energy to the error of the steps, whatever the rigid body does to what deforms.
/// A ball whose particles were heavy instead of rigid would be crossed by waves that need steps a hundred times as short.
#[test]
fn what_a_rigid_body_hits_gets_what_it_loses() {
    ranks(1, "rigid::what_a_rigid_body_hits_gets_what_it_loses", |comm| {
        let mut scene = ByHand::<3>::new(&ball_and_block("rigid = true"), comm, |_| {});
        let (first, before) = (scene.stepper.totals(), scene.stepper.state.rigid[0].clone());
        let step = scene.dt;
        scene.run(1e-3, |_| {});
        let (last, ball) = (scene.stepper.totals(), &scene.stepper.state.rigid[0]);
        let (p, l) = (last.momentum - first.momentum, last.angular_momentum - first.angular_momentum);
        let energy = (last.balance() - first.balance()) / first.kinetic;
        println!(
            "{} steps: momentum {:.1e}, angular momentum {:.1e}, energy {energy:.1e}; the ball {} m/s, {} /s",
            scene.steps(),
            p.norm() / first.momentum_scale,
            l.norm() / first.angular_scale,
            ball.motion.velocity,
            ball.spin()
        );
        assert!(p.norm() < 1e-12 * first.momentum_scale, "{p}");
        assert!(l.norm() < 1e-3 * first.angular_scale, "{l}");
        assert!(energy.abs() < 2e-2, "{energy}");
        assert!(ball.motion.velocity.z > before.motion.velocity.z + 1.0 && ball.spin().norm() > 1.0, "it was hit");
        // Steel has a speed of sound of 4.5 km/s, the block of 216 m/s.
        let rubber = 0.25 * 1.2e-3 / 216.0;
        assert!(step > 0.3 * rubber, "{step:e} s at the start, {rubber:e} s by the sound of rubber");
    });
}

/// What holds or drives a rigid body does work and gives momentum: both are counted, so that the rest is conserved.
#[test]
fn what_guides_a_rigid_body_is_counted() {
    ranks(1, "rigid::what_guides_a_rigid_body_is_counted", |comm| {
        for (motion, works) in [
            ("{ velocity = [0, 0, \"-10 m/s\"] }", true),
            ("{ damping = \"0.2 ms\" }", true),
            ("{ along = [\"z\"] }", false),
        ] {
            let ball = format!("rigid = {{ rotation = true }}\nmotion = {motion}");
            let ball = if motion.contains("velocity") {
                ball_and_block(&ball).replace("velocity = [\"2 m/s\", 0, \"-10 m/s\"]\n", "")
            } else {
                ball_and_block(&ball)
            };
            let mut scene = ByHand::<3>::new(&ball, comm, |_| {});
            let first = scene.stepper.totals();
            scene.run(5e-4, |_| {});
            let last = scene.stepper.totals();
            let scale = first.kinetic.max(last.kinetic);
            let energy = (last.balance() - first.balance()) / scale;
            let momentum = (last.momentum_balance(scene.time) - first.momentum_balance(0.0)).norm();
            println!(
                "{motion}: work {:.3} J of {scale:.3} J, energy {energy:.1e}, momentum {:.1e}",
                last.work,
                momentum / last.momentum_scale
            );
            assert!(momentum < 1e-12 * last.momentum_scale, "{momentum:e}");
            assert!(energy.abs() < 2e-2, "{energy}");
            assert!(last.impulse.norm() > 1e-3 * last.momentum_scale, "{}", last.impulse);
            assert_eq!(last.work.abs() > 0.05 * scale, works, "{}", last.work);
        }
    });
}

/// The mean step does not know what the rigid ball is made of; as matter that deforms it would.
#[test]
fn a_rigid_body_does_not_bring_its_sound() {
    ranks(1, "rigid::a_rigid_body_does_not_bring_its_sound", |comm| {
        let first_step = |ball: &str| {
            let mut scene = ByHand::<3>::new(&ball_and_block(ball), comm, |_| {});
            scene.step(f64::INFINITY);
            scene.dt
        };
        let [rigid, fast, elastic] = ["rigid = true", "rigid = { sound_speed = \"100 km/s\" }", ""].map(first_step);
        println!("steps: rigid {rigid:e} s, with a fast contact {fast:e} s, elastic {elastic:e} s");
        // It touches nothing yet: the speed of its contact limits nothing, either.
        assert_eq!(rigid, fast);
        assert!(rigid > 10.0 * elastic, "{rigid:e} {elastic:e}");
    });
}

/// Peak force, N, and how long the force is above half of it, s, of a rigid ball of `mass` kg, 1 cm in radius, that meets an elastic layer
/// at 5 m/s: Hertz's force with the factor for a layer of finite thickness on a rigid base (Dimitriadis et al. 2002, Biophys. J. 82, 2798).
fn hertz(mass: f64, thickness: f64) -> [f64; 2] {
    let (radius, young, nu): (f64, f64, f64) = (1e-2, 45e6, 0.125);
    let a = -(1.2876 - 1.4678 * nu + 1.3442 * nu * nu) / (1.0 - nu);
    let force = |depth: f64| {
        let chi = 2.0 * a / PI * (radius * depth).sqrt() / thickness;
        4.0 / 3.0 * young / (1.0 - nu * nu) * radius.sqrt() * depth.powf(1.5) * (1.0 - chi + chi * chi)
    };
    let (mut depth, mut speed, dt, mut pulse) = (0.0, 5.0, 1e-7, Vec::new());
    while depth >= 0.0 {
        let middle: f64 = depth + 0.5 * dt * speed;
        speed -= dt * force(middle.max(0.0)) / mass;
        depth = middle + 0.5 * dt * speed;
        pulse.push((dt, force(middle.max(0.0))));
    }
    of_pulse(&pulse)
}

/// Peak, and width at half of it, of widths and heights.
fn of_pulse(pulse: &[(f64, f64)]) -> [f64; 2] {
    let peak = pulse.iter().map(|(_, height)| *height).fold(0.0, f64::max);
    [peak, pulse.iter().filter(|(_, height)| *height > 0.5 * peak).map(|(width, _)| width).sum()]
}

/// A ball that bounces on a block as Hertz's contact says, with the speed that it came with. On a half space the force would be 9 per cent
/// smaller, and last 11 per cent longer: the radius of the contact is a quarter of the block's depth, and 3.4 spacings.
#[test]
fn a_rigid_ball_bounces_as_hertz_says() {
    const SCENE: &str = include_str!("../inputs/rigid_bead.toml");
    ranks(1, "rigid::a_rigid_ball_bounces_as_hertz_says", |comm| {
        let mut scene = ByHand::<3>::new(SCENE, comm, |_| {});
        let (first, mut pulse, mut before) = (scene.stepper.totals(), Vec::new(), 0.0);
        scene.run(1.3e-3, |scene| {
            pulse.push((scene.time - before, scene.stepper.state.rigid[0].load.force.z));
            before = scene.time;
        });
        let last = scene.stepper.totals();
        let ball = &scene.stepper.state.rigid[0];
        let ([force, time], restitution) = (of_pulse(&pulse), ball.motion.velocity.z / 5.0);
        let [expected, half_space] = [15e-3, 1.0].map(|thickness| hertz(ball.mass, thickness));
        println!(
            "{} steps: force {force:.1} N, half of it for {time:.3e} s; Hertz {expected:?}, on a half space {half_space:?}; \
             restitution {restitution:.3}",
            scene.steps()
        );
        assert!((force / expected[0] - 1.0).abs() < 0.03, "{force} {expected:?}");
        assert!((time / expected[1] - 1.0).abs() < 0.03, "{time:e} {expected:?}");
        assert!(restitution > 0.95 && restitution < 1.0, "{restitution}");
        let off = last.momentum_balance(scene.time) - first.momentum_balance(0.0);
        assert!(off.norm() < 1e-12 * first.momentum_scale, "{off}");
    });
}

/// A bead that lies within the block's reach at the start, coarse, in steps of twice the length: contact is stiff there at once. With the pressure of
/// a contact that is carried to the new place by its rate it left 1.42 times as fast as it came.
#[test]
fn a_bounce_from_within_reach_gains_nothing() {
    const SCENE: &str = include_str!("../inputs/rigid_bead.toml");
    ranks(1, "rigid::a_bounce_from_within_reach_gains_nothing", |comm| {
        let changes = ["bead.spacing=\"2 mm\"", "block.spacing=\"2 mm\"", "numerics.cfl=0.5", "numerics.eta=1.875"];
        let mut scene = ByHand::<3>::with(SCENE, &changes, comm, |_, _, _| {});
        let (first, mut most) = (scene.stepper.totals(), 0.0f64);
        scene.run(1.3e-3, |scene| most = most.max(scene.stepper.totals().kinetic));
        let restitution = scene.stepper.state.rigid[0].motion.velocity.z / 5.0;
        println!("restitution {restitution:.3}, kinetic energy at most {:.3} of the first", most / first.kinetic);
        assert!(restitution > 0.9 && restitution < 1.0 && most < 1.01 * first.kinetic, "{restitution} {most:e}");
    });
}

/// A body of which every rank has a part, and the same motion of it on every rank.
#[test]
fn a_body_may_be_split_over_all_ranks() {
    ranks(3, "rigid::a_body_may_be_split_over_all_ranks", |comm| {
        let mut top = ByHand::<3>::new(&flying_box([12, 6, 4], [0.1, 2.0, 0.1]), comm, |_| {});
        for _ in 0..50 {
            top.step(f64::INFINITY);
        }
        assert!(!top.stepper.columns.is_empty(), "rank {} has nothing of it", comm.rank());
        let mine = top.stepper.state.rigid[0].motion;
        let bits = mine.orientation.0.map(f64::to_bits);
        let all = comm.all_gather(&bits);
        assert!(all.chunks(4).all(|other| other == bits), "one body, one orientation");
    });
}

/// Without a rigid body there is nothing of it: no column, no state, no term. With one its particles know no neighbours among themselves.
#[test]
fn scenes_without_rigid_bodies_have_nothing_of_it() {
    let plan = |ball: &str| {
        let scene = Scene::parse("scene.toml", &ball_and_block(ball), &[]).expect("a scene");
        let constants = scene.bodies.iter().map(|body| body.constants(10, scene.numerics.eta)).collect();
        setup::plan(&scene, constants).expect("a plan")
    };
    let [without, off, with] =
        ["density = 1500", "density = 1500\nrigid = false", "density = 1500\nrigid = true"].map(plan);
    let bytes = |plan: &setup::Plan| plan.registry.bytes_per_particle();
    assert_eq!([bytes(&off), bytes(&with)], [bytes(&without), bytes(&without) + 32]);
    for plan in [&without, &off] {
        assert!(
            plan.registry.find::<Vec3>("rigid_place").is_none() && plan.rigid.is_none() && plan.view.rigid.is_empty()
        );
        assert!(!plan.terms.contrast());
    }
    assert!(with.terms.contrast() && with.terms.angular_momentum());
    ranks(1, "rigid::scenes_without_rigid_bodies_have_nothing_of_it", |comm| {
        let top = ByHand::<3>::new(&flying_box([6, 4, 2], [0.1, 2.0, 0.1]), comm, |_| {});
        assert_eq!((top.stepper.counters.pairs, top.stepper.neighbourhood.list.entries.len()), (0, 0));
        let none = serde_json::to_string(&sph_mpi::step::StepState::default()).expect("a state");
        assert!(!none.contains("rigid"), "{none}");
    });
}

#[test]
fn what_makes_no_sense_is_refused() {
    let rigid = |more: &str| ball_and_block(&format!("rigid = true\n{more}"));
    let with = |table: &str| format!("{}\n{table}\n", rigid(""));
    for (scene, says) in [
        (rigid("damage = 1"), &["ball", "damage", "does not break"][..]),
        (rigid("flow = { mode = { shape = \"radial\", speed = 1 } }"), &["flow", "does not deform"]),
        (ball_and_block("rigid = { rotation = false }\nspin = [1, 0, 0]"), &["spin", "does not turn"]),
        (ball_and_block("rigid = { sound_speed = -1 }"), &["sound_speed", "-1"]),
        (ball_and_block("rigid = { speed = 1 }"), &["speed", "sound_speed"]),
        (ball_and_block("rigid = 3"), &["rigid", "true, false or a table"]),
        (with("[numerics]\ncorrected_gradient = false"), &["corrected_gradient", "ball", "contrast"]),
        (with("[numerics]\ndensity_contrast = false"), &["density_contrast", "ball"]),
        (with("[[layer]]\nbody = \"ball\"\nmotion = \"fixed\""), &["layer", "motion of its own"]),
        (
            flying_box([2, 2, 2], [0.0; 3]).replace("\"3 m/s\", \"-1 m/s\", \"2 m/s\"", "0, 0, 0"),
            &["sound_speed", "missing"],
        ),
        (
            flying_box([2, 2, 2], [0.0; 3])
                + "[domain]\nperiodic = { x = [\"-1 m\", \"1 m\"] }\n[numerics]\neta = 0.8\nskin = 0\n",
            &["period"],
        ),
    ] {
        assert_scene_refused(&scene, says);
    }
}
