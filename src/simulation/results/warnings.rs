//! Warnings of a run: about the numbers of its scene before it starts, and about energy, angular momentum and density at
//! its end. Every kind of warning is made here.

use super::report::Report;
use super::{intrusion, restitution};
use crate::math::Vec3;
use crate::outcome::Outcome;
use crate::output::Summary;
use crate::scene::{Body, Scene};
use crate::simulation::scales::has_balance;
use crate::step::packing::{FACTOR, Packing};
use crate::warning::Warning;

/// Largest drift of energy over the initial kinetic energy, and over the remaining one.
const ENERGY: f64 = 1e-3;
const ENERGY_OVER_LEFT: f64 = 1e-2;
/// Largest gain of matter that has no internal energy, over the initial kinetic energy.
const GAIN: f64 = 1e-2;
/// Largest sum of internal energy below zero, over the initial kinetic energy.
const BELOW_ZERO: f64 = 1e-3;
/// Largest drift of angular momentum over sum m |x| |v|.
const ANGULAR_MOMENTUM: f64 = 1e-2;
/// The least change of it that counts, over R sqrt(2 E M), the angular momentum of all matter on circles of the scene's size with
/// the scale E of energy. In matter at rest sum m |x| |v| is noise, and so is the drift (6e-6 of this in balls at rest).
const TURNING: f64 = 1e-4;
/// Share of a body's particles whose density may be off, and the least number of particles inside for a judgement. In good runs,
/// shocks and spray included, 98 % lie within 0.88 and 1.14; of rubble whose voids are a spacing wide 5 % below 0.67.
const OFF: f64 = 0.1;
const LEAST_INSIDE: u64 = 20;
/// Least particles of a remnant in 2D and 3D: about two thirds of so many lie at its surface.
const FEW: [u64; 2] = [25, 100];
/// Least radius of a crater, in smoothing lengths of the ground.
const LEAST_CRATER: f64 = 4.0;
/// Bodies whose masses differ by a smaller share are alike.
const ALIKE: f64 = 0.01;

/// Warnings before a run.
pub fn of_scene(scene: &Scene) -> Vec<Warning> {
    let units = scene.warnings().into_iter().map(|text| Warning::new("units", text));
    units.chain(scene.far_from_equilibrium()).chain(scene.unresolved()).collect()
}

/// Warnings after a run; `summary`: its figures.
pub fn of_run<const D: usize>(report: &Report<D>, summary: &Summary) -> Vec<Warning> {
    let outcome = report.state.outcome.as_ref();
    let scale = report.state.conservation.energy_scale();
    [
        energy(summary),
        cold_gain(report),
        below_zero(report.totals.internal, scale),
        angular_momentum(summary, report.state.conservation.turn / circling(report.scene, report.totals.mass, scale)),
        density(report.scene, &report.density.bodies),
        report.state.intrusion.as_ref().and_then(|fall| intrusion::warning(fall, report.scene)),
        report.state.bounce.as_ref().and_then(|bounce| restitution::warning(bounce, report.scene)),
        crammed(report.state.most_filling),
        outcome.and_then(|outcome| few_particles(outcome, D)),
        outcome.and_then(|outcome| other_remnant(outcome, report.scene)),
        outcome.and_then(changing_remnant),
        report.state.crater.as_ref().and_then(|crater| small_crater(crater.radius, report.scene)),
    ]
    .into_iter()
    .flatten()
    .collect()
}

fn energy(summary: &Summary) -> Option<Warning> {
    let (all, left) = (summary.energy_drift, summary.energy_drift_over_left);
    // Cold matter does not account for its energy.
    if all.is_nan() || (all <= ENERGY && (left.is_nan() || left <= ENERGY_OVER_LEFT)) {
        return None;
    }
    let left = if left.is_nan() { String::new() } else { format!(", {left:.1e} of the kinetic energy that is left") };
    Some(Warning::new(
        "energy",
        format!(
            "total energy has drifted by {all:.1e} of the initial kinetic energy{left}: what moved slowly at the end may owe it to that \
             (change: spacings of the bodies more alike, more particles, numerics.cfl; history.csv shows when it grew)"
        ),
    ))
}

/// Cold matter does not account for heat, but it cannot have more energy than it started with, either.
fn cold_gain<const D: usize>(report: &Report<D>) -> Option<Warning> {
    let conservation = &report.state.conservation;
    let share = conservation.gain / conservation.energy_scale;
    (!has_balance(report.scene) && conservation.energy_scale > 0.0 && share > GAIN).then(|| {
        let text = format!(
            "kinetic and potential energy have grown by {share:.1e} of the initial kinetic energy, which nothing but steps that are too long \
             gives cold matter (change: a smaller numerics.cfl)"
        );
        Warning::new("energy", text)
    })
}

fn below_zero(internal: f64, scale: f64) -> Option<Warning> {
    (internal < -BELOW_ZERO * scale).then(|| {
        let text = format!(
            "the sum of internal energies is {internal:.2e} J, below zero by {:.1e} of the initial kinetic energy: motion has been \
             taken out of heat that was not there (change: numerics.angular_momentum, numerics.cfl, more particles)",
            -internal / scale
        );
        Warning::new("internal_energy", text)
    })
}

/// R sqrt(2 E M), kg m^2/s, with R the reach of the scene's bodies from the origin.
fn circling(scene: &Scene, mass: f64, energy: f64) -> f64 {
    let reach = |body: &Body| Vec3::from(body.centre).norm() + body.shape.outer_radius();
    scene.bodies.iter().map(reach).fold(0.0, f64::max) * (2.0 * energy * mass).sqrt()
}

/// `turn`: the largest change over that of [`circling`].
fn angular_momentum(summary: &Summary, turn: f64) -> Option<Warning> {
    let drift = summary.angular_momentum_drift;
    (drift > ANGULAR_MOMENTUM && turn > TURNING).then(|| {
        let text = format!(
            "angular momentum has drifted by {drift:.1e} of sum m |x| |v|: bodies turn by themselves (change: \
             numerics.angular_momentum = true)"
        );
        Warning::new("angular_momentum", text)
    })
}

/// The warning for the body in which most particles are off.
fn density(scene: &Scene, packing: &[Packing]) -> Option<Warning> {
    let share = |p: &Packing| p.off() as f64 / p.judged() as f64;
    let known = packing.iter().enumerate().filter(|(_, p)| p.judged() >= LEAST_INSIDE && share(p) > OFF);
    let (body, worst) = known.max_by(|a, b| share(a.1).total_cmp(&share(b.1)))?;
    let text = format!(
        "in `{}` density is not mass over volume: of {} particles inside matter {} lie more densely than their density by a factor of \
         {FACTOR}, {} less dense; {} beside it are pressed together by nothing (change: numerics.corrected_gradient, \
         numerics.density_contrast, spacings more alike)",
        scene.bodies[body].name, worst.inside, worst.crowded, worst.sparse, worst.alone
    );
    Some(Warning::new("density", text))
}

/// Dust without pores: its law ends at that of its monomers.
fn crammed(most_filling: f64) -> Option<Warning> {
    (most_filling > 1.0).then(|| {
        let text = format!(
            "dust has been compressed to a filling factor of {most_filling:.2}: matter denser than its monomers is outside of its law, which \
             does not stiffen there (change: a slower impact, or viscosity.beta = 2 of its material)"
        );
        Warning::new("filling", text)
    })
}

fn few_particles(outcome: &Outcome, dimension: usize) -> Option<Warning> {
    let (found, least) = (outcome.largest_remnant_particles, FEW[dimension - 2]);
    // Records of earlier versions lack this number.
    (found > 0 && found < least).then(|| {
        let text = format!(
            "the largest remnant, {:.3} of the target, is of {found} particles, fewer than {least}: its mass is the spacing's as much as \
             the impact's (change: more particles of the target)",
            outcome.largest_remnant_fraction
        );
        Warning::new("few_particles", text)
    })
}

/// Where there are just two bodies the largest remnant may be the projectile.
fn other_remnant(outcome: &Outcome, scene: &Scene) -> Option<Warning> {
    let impact = scene.impact.as_ref()?;
    let origin = |body: usize| outcome.bodies.iter().find(|origin| origin.body == body);
    let (target, projectile) = (origin(impact.target)?, origin(impact.projectile)?);
    let mass = |body: usize| scene.bodies[body].whole_mass();
    // Of two alike, either may be the larger.
    if (mass(impact.projectile) / mass(impact.target) - 1.0).abs() < ALIKE {
        return None;
    }
    let own = target.in_largest_remnant * mass(impact.target);
    (own < projectile.in_largest_remnant * mass(impact.projectile)).then(|| {
        let (target, name) = (target.remnant, &scene.bodies[impact.projectile].name);
        let text = format!(
            "the largest remnant is mostly of `{name}`, and {target:.3} of the target's own matter lies together (see `remnants` in \
             summary.json; change: the larger body as impact.target)"
        );
        Warning::new("remnant", text)
    })
}

/// Where a run has waited as long as runs wait for their remnants.
fn changing_remnant(outcome: &Outcome) -> Option<Warning> {
    let trend = outcome.trend.filter(|trend| !trend.lasts())?;
    let text = format!(
        "the largest remnant is still changing: by {:+.3} of all mass until twice the time since contact, {:.3} either way (change: \
         gravity.self, which holds slow matter back, or a later time as run.until)",
        trend.change, trend.uncertainty
    );
    Some(Warning::new("changing", text))
}

/// A crater that the ground beneath cannot resolve.
fn small_crater(radius: f64, scene: &Scene) -> Option<Warning> {
    let ground = &scene.bodies[scene.at_impact()?];
    let h = ground.expected_smoothing_length(scene.numerics.eta);
    (radius > 0.0 && radius < LEAST_CRATER * h).then(|| {
        let text = format!(
            "the crater has a radius of {radius:.4} m, {:.1} smoothing lengths of the ground: neither its size nor what it throws out is resolved \
             (change: a spacing of `{}` of at most {:.4} m, impact.refine)",
            radius / h,
            ground.name,
            ground.lattice.spacing * radius / (LEAST_CRATER * h)
        );
        Warning::new("small_crater", text)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outcome::lasting::Trend;

    fn kind(warning: Option<Warning>) -> String {
        warning.map_or(String::new(), |warning| warning.kind)
    }

    #[test]
    fn drifts_are_told_beyond_their_bounds() {
        let drift = |energy_drift, energy_drift_over_left, angular_momentum_drift| Summary {
            energy_drift,
            energy_drift_over_left,
            angular_momentum_drift,
            ..Default::default()
        };
        assert_eq!(kind(energy(&drift(9e-4, 9e-3, 0.0))), "");
        assert_eq!(kind(energy(&drift(1.1e-3, f64::NAN, 0.0))), "energy");
        let text = energy(&drift(5e-4, 0.2, 0.0)).expect("a warning").text;
        assert!(
            text.contains("5.0e-4 of the initial") && text.contains("2.0e-1 of the kinetic energy that is left"),
            "{text}"
        );
        let turning = |drift_of_l, turn| kind(angular_momentum(&drift(0.0, 0.0, drift_of_l), turn));
        assert_eq!(turning(9e-3, 1.0) + &turning(f64::NAN, 1.0) + &turning(0.9, 9e-5), "");
        assert_eq!(turning(1.1e-2, 1.1e-4), "angular_momentum");
        assert_eq!(kind(below_zero(-0.9, 1e3)) + &kind(below_zero(1e3, 1.0)), "");
        assert_eq!(kind(below_zero(-1.1, 1e3)), "internal_energy");
        let changing = |uncertainty| {
            changing_remnant(&Outcome { trend: Some(Trend { change: -0.03, uncertainty }), ..Outcome::default() })
        };
        assert_eq!(kind(crammed(0.0)) + &kind(crammed(0.99)) + &kind(crammed(1.01)), "filling");
        assert_eq!(kind(changing(0.039)), "");
        assert!(changing(0.041).is_some_and(|warning| warning.text.contains("by -0.030 of all mass")));
    }

    #[test]
    fn craters_smaller_than_kernels_are_told() {
        let scene = Scene::parse("di.toml", include_str!("../../../inputs/deep_impact.toml"), &[]).expect("a scene");
        let h = scene.bodies[scene.at_impact().expect("ground")].expected_smoothing_length(scene.numerics.eta);
        assert_eq!(kind(small_crater(4.1 * h, &scene)) + &kind(small_crater(0.0, &scene)), "");
        let text = small_crater(2.0 * h, &scene).expect("a warning").text;
        assert!(text.contains("2.0 smoothing lengths"), "{text}");
    }

    #[test]
    fn the_body_whose_density_is_off_is_named() {
        let scene = Scene::parse("qd.toml", include_str!("../../../inputs/qd_star.toml"), &[]).expect("a scene");
        let of = |inside, crowded, sparse, alone| Packing { inside, crowded, sparse, alone };
        assert_eq!(density(&scene, &[of(1000, 50, 50, 0), of(9, 9, 0, 10)]), None);
        let text = density(&scene, &[of(1000, 60, 60, 0), of(100, 0, 30, 40)]).expect("a warning").text;
        assert!(text.starts_with("in `projectile`") && text.contains("100 particles inside matter 0 lie"), "{text}");
        assert!(text.contains("30 less dense; 40 beside it"), "{text}");
    }
}
