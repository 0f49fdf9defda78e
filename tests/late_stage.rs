//! The late stage: what the switch to soft matter does, by hand; an impact from shock to reaccumulation; what is refused.

use std::f64::consts::PI;

use sph_mpi::gravity::G;
use sph_mpi::scene::Scene;

use crate::common::{ByHand, Launch, ranks, summary};

/// A planet under its own weight, and its soft late stage: a tenth of basalt's 26.7 GPa.
const PLANET: &str = r#"
[[body]]
name = "planet"
shape = { sphere = { radius = "500 km" } }
material = "basalt"
particles = 8000
start = "hydrostatic"

[gravity]
self = { interval = 0.002 }

[late_stage]
at = "10 s"
bulk_modulus = "2.67 GPa"

[numerics]
corrected_gradient = true

[run]
until = "400 s"
"#;

/// P = P_c (1 - x^2) with P_c = 2/3 pi G rho^2 R^2 and x = r / R: mean 2/5 P_c, elastic energy 8/35 V P_c^2 / (2 A). At the same
/// strain pressure and energy fall to a tenth, and CFL steps of matter without shear grow by sqrt(10).
#[test]
fn the_jump_of_a_planet_by_hand() {
    ranks(1, "late_stage::the_jump_of_a_planet_by_hand", |comm| {
        let mut planet = ByHand::<3>::new(PLANET, comm, |_| {});
        (0..3).for_each(|_| planet.step(f64::INFINITY));
        let late = planet.scene.late().expect("a late stage");
        let (before, dt) = (planet.stepper.totals(), planet.dt);
        let switch = planet.stepper.soften(&late).expect("an evaluation");
        let next = planet.stepper.state.next;
        let middle = 2.0 / 3.0 * PI * G * (2700.0f64 * 5e5).powi(2);
        let stored = 8.0 / 35.0 * 4.0 / 3.0 * PI * 5e5f64.powi(3) * middle * middle / (2.0 * 26.7e9);
        println!(
            "pressure {:.4} and {:.4} of 2/5 P_c, elastic energy {:.4} and {:.4} of that by hand, steps {:.4} of sqrt(10) times as long",
            switch.before.mean_pressure / (0.4 * middle),
            switch.after.mean_pressure / (0.04 * middle),
            switch.before.elastic_energy / stored,
            switch.after.elastic_energy / (0.1 * stored),
            next / dt / 10f64.sqrt()
        );
        // B of Tillotson's law, as large as A, makes pressure stiffer by the strain, 1 % in the middle, and sound faster by as much;
        // the softened kernel makes gravity weaker by about (h / R)^2, 0.4 %.
        for (found, expected) in [
            (switch.before.mean_pressure, 0.4 * middle),
            (switch.after.mean_pressure, 0.04 * middle),
            (switch.before.elastic_energy, stored),
            (switch.after.elastic_energy, 0.1 * stored),
            (switch.energy_jump, -0.9 * stored),
        ] {
            assert!((found / expected - 1.0).abs() < 0.02, "{found:e} {expected:e}");
        }
        assert!((next / dt / 10f64.sqrt() - 1.0).abs() < 0.02, "{} {dt}", next);
        // The sums say the same: nothing but internal energy changes, by what is told.
        let after = planet.stepper.totals();
        let kept = (after.balance() - before.balance() - switch.energy_jump).abs();
        assert!(kept < 1e-12 * before.potential.expect("gravity").abs(), "{kept}");
        assert_eq!((after.kinetic, after.momentum), (before.kinetic, before.momentum));
        // It now falls into itself by a few per cent; energy stays, the jump taken out.
        planet.dt = next;
        planet.run(400.0, |_| {});
        let end = planet.stepper.totals();
        let (drift, moved) = (
            (end.balance() - after.balance()).abs(),
            end.potential.expect("gravity") - after.potential.expect("gravity"),
        );
        println!(
            "over the next 400 s potential energy falls by {:.2e} J, energy drifts by {:.1e} of that",
            -moved,
            drift / moved.abs()
        );
        assert!(moved < 0.0 && drift < 0.01 * moved.abs(), "{drift} {moved}");
    });
}

/// Broken rock is shattered, and most of it falls together again.
const IMPACT: &str = r#"
title = "From shock to reaccumulation, small"

[[body]]
name = "target"
shape = { sphere = { radius = "10 km" } }
material = "basalt"
particles = 700
damage = 1.0

[[body]]
name = "projectile"
shape = { sphere = { radius = "3 km" } }
material = "basalt"
spacing = "1.8 km"
damage = 1.0

[impact]
speed = "1 km/s"
angle = "45 deg"

[material.basalt.strength]
collins = true

[gravity]
self = { interval = 0.003 }

[late_stage]
at = "settled"
sound_speed = "100 m/s"

[numerics]
corrected_gradient = true

[run]
until = "1500 s"

[output]
picture = false
"#;

/// The same remnant as with stiff matter all the way, for a fraction of the steps.
#[test]
fn soft_matter_reaccumulates_as_stiff_matter_does() {
    let run = |more: &[&str]| {
        let dir = tempfile::tempdir().expect("a temporary directory");
        Launch::in_directory(1, dir.path(), IMPACT, more).limit(200).run().expect_code(0);
        summary(&dir.path().join("run"))
    };
    let (soft, stiff) = (run(&[]), run(&["--set", "late_stage=false"]));
    let number =
        |summary: &serde_json::Value, key: &str| summary.pointer(key).and_then(|x| x.as_f64()).expect("a number");
    let remnant = |summary| number(summary, "/outcome/largest_remnant_fraction");
    let factor = number(&stiff, "/steps") / number(&soft, "/steps");
    println!(
        "largest remnant {:.4}, with stiff matter {:.4}; {} steps instead of {}, {factor:.1} times fewer; {:.1} s instead of {:.1} s; \
         jump {:.1e} of the initial energy, drift {:.1e}",
        remnant(&soft),
        remnant(&stiff),
        soft["steps"],
        stiff["steps"],
        number(&soft, "/core_seconds"),
        number(&stiff, "/core_seconds"),
        number(&soft, "/late_stage/energy_jump_of_initial"),
        number(&soft, "/energy_drift")
    );
    assert!(stiff.get("late_stage").is_none());
    // Over five orientations of the lattice it keeps 1.2 to 1.9 % more; 0.3 % is one particle.
    assert!((remnant(&soft) / remnant(&stiff) - 1.0).abs() < 0.03 && remnant(&soft) > 0.2, "{soft} {stiff}");
    assert!(factor > 8.0, "{factor}");
    assert!(number(&soft, "/late_stage/time_step_factor") > 20.0, "{}", soft["late_stage"]);
    // The jump is not in the drift.
    assert!(number(&soft, "/energy_drift") < 2e-4, "{}", soft["energy_drift"]);
}

#[test]
fn what_makes_no_sense_is_refused() {
    let error = |changes: &[&str]| {
        let changes: Vec<String> = changes.iter().map(|change| change.to_string()).collect();
        Scene::parse("scene.toml", IMPACT, &changes).err().map_or("no error".into(), |error| error.to_string())
    };
    for (changes, said) in [
        (&["late_stage.at=2000 s"][..], "before the late stage begins"),
        (&["late_stage.at=-1 s"], "not positive"),
        (&["late_stage.at=settld"], "settled"),
        (&["late_stage={ at = \"10 s\" }"], "how soft"),
        (&["late_stage={ sound_speed = \"100 m/s\" }"], "`at` is missing"),
        (&["late_stage={ at = \"settled\", sound_speed = \"100 m/s\", bulk_modulus = \"1e7 Pa\" }"], "one of them"),
        (&["late_stage.sound_speed=5 km/s"], "would not become softer"),
        (&["late_stage.sound_speed=2 m/s"], "press soft matter together by"),
        (&["late_stage.sound_sped=5 m/s"], "did you mean `sound_speed`"),
        (&["gravity=false", "run.until=settled"], "[gravity] self = true"),
        (&["projectile.material=ideal_gas", "projectile.density=1000", "projectile.internal_energy=1"], "is a gas"),
    ] {
        let found = error(changes);
        assert!(found.contains(said), "{changes:?}: {found}");
    }
    assert_eq!(error(&["run.until=settled"]), "no error");
    let planet = PLANET.replace("\"10 s\"", "\"settled\"");
    let found = Scene::parse("scene.toml", &planet, &[]).expect_err("an error").to_string();
    assert!(found.contains("late_stage.at") && found.contains("no [impact]"), "{found}");
}
