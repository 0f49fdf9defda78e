//! Integrators by themselves: their order on a vibration, the errors that they tolerate, and the same bits on any ranks where steps
//! are refused.

use sph_mpi::domain::comm::Comm;
use sph_mpi::scene::Scene;
use sph_mpi::simulation::setup;
use sph_mpi::step::integrator::{StepError, Verdict};

use crate::common::{ByHand, Launch, ranks, summary as common_summary};
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

const CASH_KARP: &str = "numerics.integrator={ cash_karp = { tolerance = 1 } }";
/// Moments of neighbourhoods are followed to the second order of the step, and forces without torque with them.
const WITH_TORQUE: &str = "numerics.angular_momentum=false";

/// Velocities after `steps` even steps, in the order of ids.
fn velocities(integrator: &str, steps: u32, comm: &Comm) -> Vec<f64> {
    velocities_with(&[integrator], steps, comm)
}

fn velocities_with(changes: &[&str], steps: u32, comm: &Comm) -> Vec<f64> {
    let mut disc = ByHand::<2>::with(DISC, changes, comm, |_, _, _| {});
    for step in 1..=steps {
        let most = END * f64::from(step) / f64::from(steps) - disc.time;
        disc.step(most);
    }
    assert_eq!(disc.steps(), u64::from(steps), "nothing but the given length limits a step");
    in_order(&disc)
}

/// Velocities in the order of ids.
fn in_order(disc: &ByHand<2>) -> Vec<f64> {
    let mut found: Vec<(u64, [f64; 2])> =
        disc.particles().map(|i| (disc.id(i), disc.velocity(i).xy().into())).collect();
    found.sort_by_key(|(id, _)| *id);
    found.into_iter().flat_map(|(_, v)| v).collect()
}

/// Half the step, a 32nd of the error.
#[test]
fn cash_karp_is_of_fifth_order() {
    ranks(1, "integrators::cash_karp_is_of_fifth_order", |comm| {
        for more in [&[WITH_TORQUE][..], &[]] {
            let run = |steps: u32| velocities_with(&[&[CASH_KARP], more].concat(), steps, comm);
            let exact = run(800);
            let errors = [10, 20, 40, 80].map(|steps| distance(&run(steps), &exact));
            let orders: Vec<f64> = errors.windows(2).map(|pair| (pair[0] / pair[1]).log2()).collect();
            println!("{more:?}: errors {:?} m/s, orders {orders:.3?}", errors.map(|error| format!("{error:.2e}")));
            // Beyond, rounding is seen, or else the second order of the moments, far below what any other integrator reaches.
            let least = if more.is_empty() { [4.0, 1.9] } else { [4.8, 4.8] };
            assert!(orders[0] > least[0] && orders[1] > least[1] && orders[0] < 5.5, "{more:?}: {orders:?}");
            assert!(errors[0] < 1e-4, "{more:?}: {errors:?}, of 1 m/s");
        }
    });
}

/// Twenty periods without viscosity: what a step amplifies, however little, would have grown out of all bounds.
#[test]
fn cash_karp_is_stable_at_a_courant_number_of_one() {
    ranks(1, "integrators::cash_karp_is_stable_at_a_courant_number_of_one", |comm| {
        let drift = |integrator: &str| {
            let mut disc = ByHand::<2>::with(DISC, &[integrator], comm, |_, _, _| {});
            let first = disc.stepper.totals();
            disc.run(40.0 * END, |_| {});
            let last = disc.stepper.totals();
            (last.balance() - first.balance()).abs() / first.kinetic
        };
        let [cash_karp, other] = [CASH_KARP, PREDICTOR_CORRECTOR].map(drift);
        println!("drift of energy: {cash_karp:e}, by the predictor-corrector {other:e}");
        assert!(cash_karp < 1e-3, "{cash_karp:e}");
        assert!(other > 1.0, "{other:e}: not a step that is too long for the predictor-corrector");
    });
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
            let drift = (last.balance() - first.balance()).abs() / first.kinetic;
            (disc.steps(), disc.stepper.counters.refused, distance(&in_order(&disc), &exact), drift)
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

/// Two balls whose pores are crushed and whose rock breaks and yields with friction, by an integrator with these settings.
macro_rules! porous_balls {
    ($numerics:literal) => {
        concat!(
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
"#,
            $numerics,
            r#"
[record]
peak_pressure = true

[run]
until = "0.6 s"

[output]
picture = false
"#
        )
    };
}

/// State that never goes back, in steps that do: other ranks and threads, a checkpoint, and the figures of the predictor-corrector.
#[track_caller]
fn compare_porous_balls(name: &str, scene: &'static str) -> serde_json::Value {
    let (_, summary) = sameness::compare_scene(name, scene);
    println!("{name}: {} steps, {} refused", summary["steps"], summary["refused_steps"]);
    assert!(summary["refused_steps"].as_u64().is_some_and(|refused| refused > 0), "no step was refused");
    let drift = summary["energy_drift"].as_f64().expect("a drift");
    assert!(drift < 1e-2, "{drift}");
    summary
}

#[test]
fn refused_steps_have_the_same_bits_on_any_ranks() {
    compare_porous_balls("refused", porous_balls!("integrator = { runge_kutta = { tolerance = 0.005 } }"));
}

#[test]
fn refused_steps_of_cash_karp_have_the_same_bits_on_any_ranks() {
    let found = compare_porous_balls(
        "refused_cash_karp",
        porous_balls!("cfl = 1\nintegrator = { cash_karp = { tolerance = 1e-3, tolerances = { position = 1e-4 } } }"),
    );
    let dir = tempfile::tempdir().expect("a temporary directory");
    Launch::in_directory(1, dir.path(), porous_balls!(""), &[]).run().expect_code(0);
    let expected = common_summary(&dir.path().join("run"));
    let [found, expected] =
        [&found, &expected].map(|summary| summary["outcome"]["compacted_volume"].as_f64().expect("a volume"));
    println!("compacted: {found:.5e} m^3, by the predictor-corrector {expected:.5e}");
    assert!((found / expected - 1.0).abs() < 1e-3, "{found} and {expected}");
}

/// Gas that is pressed through the edges of a period, faster and faster apart.
const ROUND: &str = r#"
title = "Gas of two pressures drifts round and round"
dimension = 2

[domain]
periodic = { x = [0, "1 m"], y = [0, "50 cm"] }

[[body]]
name = "thin"
shape = { box = { size = ["50 cm", "50 cm"] } }
position = ["25 cm", "25 cm"]
velocity = ["300 m/s", "200 m/s"]
material = "ideal_gas"
spacing = "2 cm"
density = "1 kg/m^3"
pressure = "1e5 Pa"

[[body]]
name = "pressed"
shape = { box = { size = ["50 cm", "50 cm"] } }
position = ["75 cm", "25 cm"]
velocity = ["300 m/s", "200 m/s"]
material = "ideal_gas"
spacing = "2 cm"
density = "1 kg/m^3"
pressure = "4e5 Pa"

[gravity]
uniform = ["1e4 m/s^2", 0]

[numerics]
cfl = 0.5
integrator = { cash_karp = { tolerance = 1e-4 } }

[record]
peak_pressure = true

[run]
until = "4 ms"

[output]
picture = false
"#;

/// What crosses an edge takes its copy with it: later stages of the step would else start a period away, and each build lists anew.
#[test]
fn cash_karp_goes_round_periods() {
    let (_, summary) = sameness::compare_scene("round", ROUND);
    let dir = tempfile::tempdir().expect("a temporary directory");
    Launch::in_directory(1, dir.path(), ROUND, &["--set", PREDICTOR_CORRECTOR]).run().expect_code(0);
    let other = common_summary(&dir.path().join("run"));
    let number = |summary: &serde_json::Value, key: &str| summary[key].as_f64().unwrap_or_else(|| panic!("{key}"));
    let keys = ["steps", "list_builds", "energy_drift", "momentum_drift"];
    println!("{keys:?}: {:?}, {:?}", keys.map(|key| number(&summary, key)), keys.map(|key| number(&other, key)));
    assert!(number(&summary, "list_builds") < 1.5 * number(&other, "list_builds"));
    assert!(number(&summary, "energy_drift") < 2.0 * number(&other, "energy_drift") + 1e-4);
    assert!(number(&summary, "momentum_drift") < 1e-10);
}

/// Each quantity has its own tolerance, and what a scene does not have is named.
#[test]
fn cash_karp_controls_each_quantity() {
    ranks(1, "integrators::cash_karp_controls_each_quantity", |comm| {
        let steps = |tolerances: &str| {
            let integrator =
                format!("numerics.integrator={{ cash_karp = {{ tolerance = 1, tolerances = {{ {tolerances} }} }} }}");
            let mut disc = ByHand::<2>::with(DISC, &[&integrator], comm, |_, _, _| {});
            disc.run(END, |_| {});
            disc.steps()
        };
        let free = steps("");
        for name in ["velocity", "position", "density", "internal_energy", "deviatoric_stress"] {
            let controlled = [1e-9, 1e-11].map(|tolerance| steps(&format!("{name} = {tolerance:e}")));
            println!("{name}: {controlled:?} steps instead of {free}");
            assert!(controlled[1] > free, "{name}: {controlled:?}, {free}");
        }
        let wrong = DISC.replace("cfl = 1", "integrator = { cash_karp = { tolerances = { damage = 1e-3 } } }");
        let scene = Scene::parse("scene.toml", &wrong, &[]).expect("a scene");
        let error =
            setup::plan(&scene, setup::count_particles(&scene, comm).expect("particles")).err().expect("an error");
        let text = error.to_string();
        assert!(text.contains("tolerances.damage") && text.contains("deviatoric_stress"), "{text}");
    });
}

/// The steps follow the tolerance, as its fifth root; what is refused leaves no trace.
#[test]
fn cash_karp_follows_the_tolerated_error() {
    ranks(1, "integrators::cash_karp_follows_the_tolerated_error", |comm| {
        let exact = velocities_with(&[CASH_KARP, WITH_TORQUE], 1600, comm);
        let run = |tolerance: f64| {
            let integrator = format!("numerics.integrator={{ cash_karp = {{ tolerance = {tolerance} }} }}");
            let mut disc = ByHand::<2>::with(DISC, &[&integrator, WITH_TORQUE], comm, |_, _, _| {});
            disc.run(END, |_| {});
            (disc.steps(), disc.stepper.counters.refused, distance(&in_order(&disc), &exact))
        };
        let found = [1e-6, 1e-8, 1e-10].map(run);
        println!("steps, refused, error in m/s: {found:?}");
        for pair in found.windows(2) {
            let (ratio, gain) = (pair[1].0 as f64 / pair[0].0 as f64, pair[0].2 / pair[1].2);
            assert!(pair[1].1 >= 1, "the first step, of the Courant condition, is too long");
            assert!((2.1..3.0).contains(&ratio), "{ratio} times as many steps for a hundredth of the error");
            assert!((50.0..500.0).contains(&gain), "{gain} times less error");
        }
    });
}

/// The quantity that is farthest off decides, each over its own size and tolerance.
#[test]
fn cash_karp_judges_the_worst_quantity() {
    ranks(1, "integrators::cash_karp_judges_the_worst_quantity", |comm| {
        let change = "numerics.integrator={ cash_karp = { tolerance = 1e-3, tolerances = { density = 1e-6 } } }";
        let scene = Scene::parse("scene.toml", DISC, &[change.to_string()]).expect("a scene");
        let plan = setup::plan(&scene, setup::count_particles(&scene, comm).expect("particles")).expect("a plan");
        let names = ["velocity", "position", "density", "internal_energy", "deviatoric_stress"];
        let of = |name: &str| names.iter().position(|other| *other == name).expect("a quantity");
        let judge = |name: &str, off: f64, size: f64| {
            let mut error = StepError::default();
            error.note(of(name), off);
            error.note_size(of(name), size);
            plan.integrator.judge(&error, 10.0, 1.0)
        };
        assert_eq!(plan.integrator.controlled(), names.len());
        assert_eq!(judge("velocity", 0.0, 0.0), Verdict::Accept { most: 5.0 });
        // Just tolerated, of each: a share of the largest relative velocity, of h, of the density, of the largest value.
        let tolerated =
            [("velocity", 1e-2, 0.0), ("position", 1e-3, 0.0), ("density", 1e-6, 0.0), ("deviatoric_stress", 2e3, 2e6)];
        for (name, off, size) in tolerated {
            let Verdict::Accept { most } = judge(name, 0.9999 * off, size) else { panic!("{name} is refused") };
            assert!((0.79..0.81).contains(&most), "{name}: {most}");
            let Verdict::Refuse { next } = judge(name, 32.0 * off, size) else { panic!("{name} is accepted") };
            assert!((next - 0.4).abs() < 1e-12, "{name}: {next}");
        }
        assert_eq!(judge("internal_energy", 1e9, 1.0), Verdict::Refuse { next: 0.2 });
    });
}

/// Of matter at rest nothing is left but rounding errors, which no step makes smaller.
#[test]
fn cash_karp_lets_matter_rest() {
    ranks(1, "integrators::cash_karp_lets_matter_rest", |comm| {
        let still = ["numerics.integrator={ cash_karp = { tolerance = 1e-9 } }", "disc.flow.mode.speed=\"1e-12 m/s\""];
        let mut disc = ByHand::<2>::with(DISC, &still, comm, |_, _, _| {});
        disc.run(END, |_| {});
        println!("{} steps, {} refused", disc.steps(), disc.stepper.counters.refused);
        assert!(disc.stepper.counters.refused == 0 && disc.steps() < 40);
    });
}

/// Nobody pays for the integrator of another scene.
#[test]
fn columns_of_integrators() {
    ranks(1, "integrators::columns_of_integrators", |comm| {
        let columns = |integrator: &str| {
            let disc = ByHand::<2>::with(DISC, &[integrator], comm, |_, _, _| {});
            let entries = &disc.stepper.columns.registry.entries;
            let own = entries.iter().filter(|entry| entry.owner == "integrator");
            own.map(|entry| (entry.name.clone(), entry.width)).collect::<Vec<_>>()
        };
        let words = |columns: &[(String, usize)]| columns.iter().map(|(_, width)| width).sum::<usize>();
        let (own, cash_karp) = (columns(PREDICTOR_CORRECTOR), columns(CASH_KARP));
        // Acceleration and jerk, and rates of density, energy and three components of stress.
        assert_eq!(words(&own), 2 * 2 + 5, "{own:?}");
        assert!(own.iter().all(|(name, _)| !name.ends_with("_at_start") && !name.contains("_rate_")), "{own:?}");
        // Copies of these and of positions and velocities, and five rates: positions need none of their own.
        assert_eq!(words(&cash_karp), (2 + 2 + 5) + 5 * (2 + 5), "{cash_karp:?}");
    });
}
