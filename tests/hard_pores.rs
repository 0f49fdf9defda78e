//! Hard cases of porous matter, as those of solids in `hard_cases`: each with the figure that shows its defect. The cures are in
//! the code: a comment says what the figure was when they were taken out. Those with shocks are in `hard_pores_shocks`.

use std::collections::HashMap;
use std::f64::consts::PI;

use sph_mpi::domain::comm::Comm;
use sph_mpi::material::MaterialTable;
use sph_mpi::material::porosity::law::{Compaction, Porous};
use sph_mpi::math::{Deviator, Vec3};
use sph_mpi::particles::ColumnShape;

use crate::common::{ByHand, IMPACT, ranks};

/// Pumice of Jutzi et al. 2008, table 2; its matrix is basalt but for its density.
pub const PUMICE: &str = r#"
[material.pumice]
base = "basalt"
[material.pumice.eos.tillotson]
rho_0 = 2327
[material.pumice.porosity]
distention = 4.64
[material.pumice.porosity.p_alpha.two_slope]
P_e = "1 MPa"
P_t = "68 MPa"
P_s = "213 MPa"
alpha_t = 1.9
n_1 = 12
n_2 = 3
"#;

/// Basalt of Jutzi et al. 2008, section 5.3, beside basalt without pores.
pub const SPONGE: &str = r#"
[material.sponge]
base = "basalt"
[material.sponge.porosity.p_alpha.quadratic]
"#;

pub fn material<'a, const D: usize>(hand: &'a ByHand<D>, name: &str) -> &'a MaterialTable {
    let body = hand.scene.bodies.iter().find(|body| body.name == name).expect("a body of this name");
    &hand.scene.materials[body.material]
}

pub fn all_finite<const D: usize>(hand: &ByHand<D>) -> bool {
    let entries = hand.stepper.columns.registry.entries.iter().enumerate();
    let mut numbers = entries.filter(|(_, entry)| entry.shape != ColumnShape::Id);
    numbers.all(|(index, _)| hand.stepper.columns.numbers(index).iter().all(|x| x.is_finite()))
}

/// A sponge that is denser than without load, so that pressure stays above P_e, and that flies through its periods.
const RINGING: &str = r#"
title = "Sound in a porous body that flies by"
dimension = 2
[domain]
periodic = { x = [0, 0.4], y = [0, 0.0692820323] }
[[body]]
name = "sponge"
shape = { box = { size = [0.4, 0.0692820323] } }
position = [0.2, 0.03464101615]
velocity = ["1 km/s", "300 m/s"]
density = "1100 kg/m^3"
material = "sponge"
spacing = 0.01
flow = { wave = { along = "x", moves = "x", wavelength = 0.4, speed = "5 m/s" } }
[material.sponge.viscosity]
alpha = 0.1
beta = 0.2
[numerics]
corrected_gradient = true
[run]
until = 1
"#;

/// Sound runs to and fro in matter that it has crushed at first: each particle stays where its largest pressure has put it. Were
/// loading told from dP/dt > 0 alone, pores would collapse in every cycle, until pressure is gone: alpha ended 0.018 below the
/// curve.
#[test]
fn loading_again_in_a_flying_body() {
    ranks(1, "hard_pores::loading_again_in_a_flying_body", |comm| {
        let mut hand = ByHand::<2>::new(&(RINGING.to_string() + SPONGE), comm, |_| {});
        let porous = Porous::of(material(&hand, "sponge"), 3.0).expect("porous matter");
        let Compaction::Pressure { curve, .. } = &porous.compaction else { unreachable!("P-alpha") };
        let at = |hand: &ByHand<2>, name: &str| -> HashMap<u64, f64> {
            hand.particles().map(|i| (hand.id(i), hand.numbers(name)[i])).collect()
        };
        let (start, mut most) = (at(&hand, "distention"), at(&hand, "pressure"));
        let watched = hand.id(0);
        let mut trace = vec![0.0; 2];
        let mut loads = 0;
        hand.run(1.5e-3, |hand| {
            for i in hand.particles() {
                let (id, p) = (hand.id(i), hand.numbers("pressure")[i]);
                let most = most.get_mut(&id).expect("a known particle");
                *most = most.max(p);
                if id == watched {
                    // Rises again, where pores would collapse under a first load.
                    let n = trace.len();
                    loads += u64::from(trace[n - 1] < trace[n - 2] && p > trace[n - 1] && p > curve.elastic_limit());
                    trace.push(p);
                }
            }
        });
        let end = at(&hand, "distention");
        let off: Vec<f64> = end.keys().map(|id| end[id] - curve.at(most[id]).0).collect();
        let worst = off.iter().copied().fold(0.0, |worst, x| if f64::abs(x) > f64::abs(worst) { x } else { worst });
        let crushed = end.keys().map(|id| start[id] - end[id]).fold(0.0, f64::max);
        println!("{} steps, {loads} loads, crushed by {crushed:.4}, off the curve by {worst:.1e}", hand.steps());
        // Roots of the curve are found to the noise of the equation of state.
        assert!(all_finite(&hand) && loads >= 10 && crushed > 0.01 && worst.abs() < 1e-10);
    });
}

/// alpha_0 = 1 is the solid, bit for bit. Were D_c = 1 - (alpha - 1) / (alpha_0 - 1) taken as it is written, the run would end in
/// its first evaluation: compaction_damage is NaN.
#[test]
fn zero_porosity_is_the_solid() {
    ranks(1, "hard_pores::zero_porosity_is_the_solid", |comm| {
        let porous = format!("{IMPACT}[material.basalt.porosity]\ndistention = 1\np_alpha = {{ quadratic = true }}\n");
        let mut pair = [IMPACT, &porous].map(|text| ByHand::<3>::new(text, comm, |_| {}));
        assert!(pair.iter().all(|hand| hand.numbers("damage").iter().all(|d| *d == 0.0)), "nothing is broken at first");
        pair.iter_mut().for_each(|hand| hand.run(0.25, |_| {}));
        let [solid, porous] = &pair;
        assert_eq!(solid.steps(), porous.steps());
        let words = |hand: &ByHand<3>, name: &str| -> Vec<u64> {
            let column = hand.stepper.columns.registry.entries.iter().position(|e| e.name == name).expect("a column");
            hand.stepper.columns.numbers(column).iter().map(|x| x.to_bits()).collect()
        };
        let shared = solid.stepper.columns.registry.entries.iter().filter(|entry| entry.shape != ColumnShape::Id);
        let names: Vec<&str> = shared.map(|entry| entry.name.as_str()).collect();
        names.iter().for_each(|name| assert!(words(solid, name) == words(porous, name), "{name} differs"));
        let broken = solid.numbers("damage").iter().sum::<f64>() / solid.particles().len() as f64;
        println!("{} columns, {} steps, mean damage {broken:.3}", names.len(), solid.steps());
        assert!(names.len() > 15 && broken > 0.02);
        assert!(porous.numbers("distention").iter().all(|alpha| *alpha == 1.0));
    });
}

const RESTING: &str = r#"
title = "A porous body at rest under load"
dimension = 2
[domain]
periodic = { x = [0, 0.2], y = [0, 0.1732050808] }
[[body]]
name = "sponge"
shape = { box = { size = [0.2, 0.1732050808] } }
position = [0.1, 0.0866025404]
material = "sponge"
spacing = 0.01
internal_energy = "5e4 J/kg"
[material.sponge.strength]
[numerics]
corrected_gradient = true
[run]
until = 1
"#;

/// On the crush curve, at rest: f has to come from the state. Divided by the rate of density, the first evaluation fails: effect
/// `strength` makes a rate of deviatoric_stress that is not finite.
#[test]
fn no_rate_of_density() {
    ranks(1, "hard_pores::no_rate_of_density", |comm| {
        let given = Deviator { xx: 3e6, yy: -1e6, xy: 2e6, ..Default::default() };
        let mut hand = ByHand::<2>::new(&(RESTING.to_string() + SPONGE), comm, |columns| {
            let stress = columns.registry.find::<Deviator>("deviatoric_stress").expect("strength");
            (0..columns.len()).for_each(|i| columns.set(stress, i, given));
        });
        let factor = hand.numbers("stress_factor")[0];
        let alpha = hand.numbers("distention")[0];
        // Sound crosses the box ten times.
        hand.run(5e-4, |_| {});
        let off = |i: usize| {
            let s: Deviator = hand.get("deviatoric_stress", i);
            (s.xx - given.xx).abs().max((s.yy - given.yy).abs()).max((s.xy - given.xy).abs())
        };
        let worst = hand.particles().map(off).fold(0.0, f64::max) / 3e6;
        let fastest = hand.particles().map(|i| hand.velocity(i).norm()).fold(0.0, f64::max);
        println!(
            "f {factor:.4}, alpha {alpha:.4}, stress off by {worst:.1e}, {fastest:.1e} m/s, {} steps",
            hand.steps()
        );
        assert!(all_finite(&hand) && (0.0..0.5).contains(&factor) && (1.1..2.999).contains(&alpha), "pores give way");
        // Roundings of forces that cancel, over a thousand steps.
        assert!(worst < 1e-12 && fastest < 1e-12);
    });
}

/// Sound in pumice that breaks, at a speed, m/s: the particles' distention and damage, and the largest pressure.
fn ring(speed: f64, comm: &Comm) -> (Vec<f64>, Vec<f64>, f64) {
    let text = format!(
        "title = \"Sound in pumice\"\ndimension = 2\n[domain]\nperiodic = {{ x = [0, 0.4], y = [0, 0.0692820323] }}\n[[body]]\n\
         name = \"pumice\"\nshape = {{ box = {{ size = [0.4, 0.0692820323] }} }}\nposition = [0.2, 0.03464101615]\n\
         material = \"pumice\"\nspacing = 0.01\n\
         flow = {{ wave = {{ along = \"x\", moves = \"x\", wavelength = 0.4, speed = {speed} }} }}\n\
         [material.pumice.strength]\n[material.pumice.fracture]\n[numerics]\ncorrected_gradient = true\n[run]\nuntil = 1\n"
    );
    let mut hand = ByHand::<2>::new(&(text + PUMICE), comm, |_| {});
    let mut most = 0.0f64;
    hand.run(2e-4, |hand| most = hand.numbers("pressure").iter().copied().fold(most, f64::max));
    (hand.numbers("distention").to_vec(), hand.numbers("damage").to_vec(), most)
}

/// Below P_e distention stays alpha_0 to the last bit and nothing breaks. With the curve's own value at P_e it was 4.4e-15 lower
/// from the first moment, and damage 1.4e-42. Where the first pores go damage is small: D^(1/3) was 0.037 instead of 4.5e-4 with
/// delta = 0 in eq. 57, at which it starts at an infinite rate.
#[test]
fn distention_at_its_first_value() {
    ranks(1, "hard_pores::distention_at_its_first_value", |comm| {
        let (alpha, damage, most) = ring(0.3, comm);
        assert!(most > 3e5 && most < 1e6, "{most}");
        assert!(alpha.iter().all(|alpha| *alpha == 4.64) && damage.iter().all(|damage| *damage == 0.0));
        let (alpha, damage, most) = ring(1.0, comm);
        let least = alpha.iter().copied().fold(f64::MAX, f64::min);
        let crushed = (4.64 - least) / 3.64;
        let root = damage.iter().copied().fold(0.0, f64::max).cbrt();
        println!("up to {most:.3e} Pa: D_c {crushed:.2e}, D^(1/3) {root:.2e}");
        // 1 / (3 delta^(2/3) 0.788) = 9.1
        assert!(crushed > 1e-6 && crushed < 1e-3 && (root / crushed / 9.1 - 1.0).abs() < 0.02);
    });
}

const DISC: &str = r#"
title = "A porous disc under stress turns"
dimension = 2
[[body]]
name = "disc"
shape = { disc = { radius = "1 m" } }
material = "sponge"
spacing = "12 cm"
spin = "2000 rad/s"
[material.sponge.strength]
shear_modulus = "1 MPa"
[numerics]
corrected_gradient = true
viscosity = false
[run]
until = 1
"#;

/// A whole turn at alpha = 3: stress turns with the body. A free body would let go of a uniform stress while sound crosses it
/// once, so that its particles are led; their spin comes from the sums over neighbours. The shear modulus is so small that strains
/// of the prediction, of the third order of the step, count for nothing. With spin terms over alpha, as public codes have them,
/// S_xx ended at -0.50 of what it was.
#[test]
fn stress_turns_with_a_whole_body() {
    ranks(1, "hard_pores::stress_turns_with_a_whole_body", |comm| {
        let mut hand = ByHand::<2>::new(&(DISC.to_string() + SPONGE), comm, |_| {});
        let (spin, steps) = (2e3, 1000);
        let given = Deviator { xx: 1e5, yy: -1e5, ..Default::default() };
        let first: HashMap<u64, Vec3> = hand.particles().map(|i| (hand.id(i), hand.position(i))).collect();
        let lead = |hand: &mut ByHand<2>, angle: f64| {
            for i in hand.particles() {
                let x = first[&hand.id(i)];
                let (sin, cos) = angle.sin_cos();
                let x = Vec3::new(cos * x.x - sin * x.y, sin * x.x + cos * x.y, 0.0);
                hand.set("position", i, x);
                hand.set("velocity", i, spin * Vec3::new(-x.y, x.x, 0.0));
                hand.set("acceleration", i, -spin * spin * x);
                hand.set("jerk", i, Vec3::zeros());
            }
        };
        lead(&mut hand, 0.0);
        hand.evaluate();
        hand.particles().for_each(|i| hand.set("deviatoric_stress", i, given));
        let dt = 2.0 * PI / spin / f64::from(steps);
        let mut eighth = Deviator::default();
        for step in 1..=steps {
            hand.stepper.step(dt, hand.time, 0).expect("a step");
            lead(&mut hand, 2.0 * PI * f64::from(step) / f64::from(steps));
            if step == steps / 8 {
                eighth = hand.get("deviatoric_stress", 0);
            }
        }
        let off = |i: usize| {
            let s: Deviator = hand.get("deviatoric_stress", i);
            (s.xx - given.xx).abs().max((s.yy - given.yy).abs()).max(s.xy.abs()) / 1e5
        };
        let worst = hand.particles().map(off).fold(0.0, f64::max);
        println!("S_xy after an eighth {:.4}, off by {worst:.1e} after a turn", eighth.xy / 1e5);
        // The phase of the scheme: (4 pi / 1000)^2 times the angle of the stress, 4 pi, over 4.
        assert!((eighth.xy / 1e5 - 1.0).abs() < 0.01 && worst < 0.01);
        assert!(hand.numbers("distention").iter().all(|alpha| *alpha == 3.0));
    });
}
