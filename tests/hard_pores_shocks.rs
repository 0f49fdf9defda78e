//! Hard cases of porous matter through which shocks run, in strips of the plane; the others are in `hard_pores`.

use std::collections::HashMap;

use sph_mpi::domain::comm::Comm;
use sph_mpi::exact::State;
use sph_mpi::exact::compaction::PorousMedium;
use sph_mpi::exact::shock::Medium;
use sph_mpi::material::MaterialTable;
use sph_mpi::step::diagnostics::Totals;

use crate::common::{ByHand, ranks};
use crate::hard_pores::{PUMICE, SPONGE, all_finite, material};

/// Spacing of the strips, m.
const SPACING: f64 = 0.01;
/// Bodies that meet start out of each other's reach, as the smoothing length is 0.013 m: a step into the first contact at full
/// speed costs energy.
const APART: f64 = 0.03;

/// Space that closes on itself after eight close-packed rows, with sums that are right to 0.1 per cent.
fn strip(title: &str, bodies: &[String], more: &str) -> String {
    let height = 8.0 * SPACING * 0.75f64.sqrt();
    format!(
        "title = \"{title}\"\ndimension = 2\n[domain]\nperiodic = {{ y = [0, {height}] }}\n{}\n\
         [numerics]\nkernel = \"wendland_c2\"\neta = 1.4\ncorrected_gradient = true\n[run]\nuntil = 1\n{more}",
        bodies.concat()
    )
}

/// A body of the strip, m and m/s.
fn plate(name: &str, material: &str, [low, high]: [f64; 2], velocity: f64) -> String {
    let height = 8.0 * SPACING * 0.75f64.sqrt();
    format!(
        "[[body]]\nname = \"{name}\"\nmaterial = \"{material}\"\nspacing = {SPACING}\nvelocity = [{velocity}, 0]\n\
         shape = {{ box = {{ size = [{}, {height}] }} }}\nposition = [{}, {}]\n",
        high - low,
        0.5 * (low + high),
        0.5 * height
    )
}

/// Mean of a column over the particles of a body between two places, m.
fn mean<const D: usize>(hand: &ByHand<D>, column: &str, body: usize, [low, high]: [f64; 2]) -> f64 {
    let within = |&i: &usize| hand.body(i) == body && (low..high).contains(&hand.position(i).x);
    let chosen: Vec<usize> = hand.particles().filter(within).collect();
    assert!(chosen.len() >= 16, "{} particles of body {body} between {low} and {high}", chosen.len());
    chosen.iter().map(|&i| hand.numbers(column)[i]).sum::<f64>() / chosen.len() as f64
}

/// Where the particles of a body begin and end along x, m.
fn ends<const D: usize>(hand: &ByHand<D>, body: usize) -> [f64; 2] {
    let x = hand.particles().filter(|&i| hand.body(i) == body).map(|i| hand.position(i).x);
    x.fold([f64::MAX, f64::MIN], |[low, high], x| [low.min(x), high.max(x)])
}

/// Energy gained or lost by now, over the kinetic energy of the start.
fn drift<const D: usize>(hand: &mut ByHand<D>, before: &Totals) -> f64 {
    (hand.stepper.totals().energy() - before.energy()) / before.kinetic
}

/// Cold matter of a material without pores.
fn medium(material: &MaterialTable) -> Medium {
    Medium { law: material.eos.law(), density: material.reference_density().expect("a solid"), internal_energy: 0.0 }
}

/// The velocity of the contact when basalt at `speed` meets porous matter at rest, m/s.
fn contact(basalt: &Medium, porous: &PorousMedium, speed: f64) -> f64 {
    let (mut low, mut high) = (1e-3 * speed, (1.0 - 1e-3) * speed);
    while high - low > 1e-9 * speed {
        let u = 0.5 * (low + high);
        let pushed = porous.piston(u).expect("a compaction wave").front.behind.stress;
        if basalt.shock(speed - u).expect("a shock").behind.stress > pushed { low = u } else { high = u }
    }
    high
}

/// alpha_0 = 4.64, hit by basalt at 3 km/s: the matrix gets so hot that it ends thinner than without load. With distention by its
/// rate (Jutzi et al. 2008, eqs 24-25) instead of the crush curve itself, the pressure behind the shock was 1.5 times as high as it
/// should be, the density 0.53, and alpha 3.3. With viscosity that uses the speed of further compression instead of sound, P
/// is 1.26 times and the density 1.07 times as high as it should be.
#[test]
fn pumice_hit_at_three_kilometres_per_second() {
    ranks(1, "hard_pores_shocks::pumice_hit_at_three_kilometres_per_second", |comm| {
        let bodies =
            [plate("flyer", "basalt", [-1.0 - APART, -APART], 3e3), plate("pumice", "pumice", [0.0, 1.0], 0.0)];
        let mut hand = ByHand::<2>::new(&strip("Pumice is hit", &bodies, PUMICE), comm, |_| {});
        let before = hand.stepper.totals();
        let porous = PorousMedium::of(material(&hand, "pumice"), 4.64).expect("porous matter");
        let u = contact(&medium(material(&hand, "flyer")), &porous, 3e3);
        let wave = porous.piston(u).expect("a compaction wave").front;
        let time = 0.7 / wave.speed;
        hand.run(time + APART / 3e3, |_| {});
        let crushed = (wave.speed - u) * time;
        let place = [u * time + 0.2 * crushed, u * time + 0.7 * crushed];
        let names = ["pressure", "density", "internal_energy", "distention"];
        let [p, density, energy, alpha] = names.map(|name| mean(&hand, name, 1, place));
        let drift = drift(&mut hand, &before);
        let exact = wave.behind;
        let [p, density, energy] = [p / exact.stress, density / exact.density, energy / exact.internal_energy];
        println!(
            "P {p:.4}, density {density:.4}, energy {energy:.4} of {exact:?}, alpha {alpha}, drift {drift:.1e}, {} steps",
            hand.steps()
        );
        assert!(all_finite(&hand) && drift.abs() < 1e-3 && alpha == 1.0 && exact.density < 2327.0);
        // Sums over a lattice that is squeezed 3.2 times put the density 3 per cent too high whatever the spacing, and a pressure
        // that goes with its power of 3.6 thereby 11; the energy does not depend on that.
        assert!((energy - 1.0).abs() < 0.01 && (density - 1.0).abs() < 0.04 && (p - 1.0).abs() < 0.13);
    });
}

/// Pores that all go at nearly one pressure: in a step the pressure of unchanged pores would pass P_s by hundreds of P_s - P_e.
/// With distention by its rate the energy behind the shock was 6.5 times and its pressure 9.9 times as high as it should be,
/// and pores were left. The limit of the step by the change of distention makes no difference here: the Courant condition
/// allows changes of 0.005 only.
#[test]
fn pressure_crosses_the_crush_curve_in_one_step() {
    ranks(1, "hard_pores_shocks::pressure_crosses_the_crush_curve_in_one_step", |comm| {
        let speed = 458.0;
        let more = format!(
            "[[layer]]\nx = [-1, 0]\nmotion = {{ velocity = [{speed}, 0] }}\n[[layer]]\nx = [1.5, 2]\nmotion = \"fixed\"\n\
             [material.aluminium.porosity.p_alpha.quadratic]\nP_e = 80e6\nP_s = 81e6\n"
        );
        let bodies = [plate("column", "aluminium", [-0.1, 1.6], 0.0)];
        let mut hand = ByHand::<2>::new(&strip("A steep crush curve", &bodies, &more), comm, |_| {});
        let before = hand.stepper.totals();
        let porous = PorousMedium::of(material(&hand, "column"), 1.275).expect("porous matter");
        let wave = porous.piston(speed).expect("a compaction wave").front;
        let time = 1.3 / wave.speed;
        // What one step would make of P if no pore gave way, over P_s - P_e.
        let mut leap = 0.0f64;
        let mut last: HashMap<u64, f64> = HashMap::new();
        hand.run(time, |hand| {
            for i in hand.particles() {
                let (density, alpha) = (hand.numbers("density")[i], hand.numbers("distention")[i]);
                let before = last.insert(hand.id(i), density).unwrap_or(density);
                if alpha < 1.275 && alpha > 1.0 {
                    leap = leap.max((density / before - 1.0) * 75.2e9 / alpha / 1e6);
                }
            }
        });
        let between =
            [speed * time + 0.3 * (wave.speed - speed) * time, speed * time + 0.8 * (wave.speed - speed) * time];
        let [u, p, alpha] = ["internal_energy", "pressure", "distention"].map(|name| mean(&hand, name, 0, between));
        let totals = hand.stepper.totals();
        let drift = (totals.balance() - before.balance()) / totals.kinetic;
        let (u, p) = (u / wave.behind.internal_energy, p / wave.behind.stress);
        println!(
            "{leap:.0} times P_s - P_e; energy {u:.4}, P {p:.4}, alpha {alpha}, drift {drift:.1e}, {} steps",
            hand.steps()
        );
        assert!(leap > 100.0 && alpha == 1.0 && drift.abs() < 1e-3);
        // What sums over a squeezed lattice allow.
        assert!((u - 1.0).abs() < 0.01 && (p - 1.0).abs() < 0.015);
    });
}

/// Two porous plates run into each other, are crushed and fly apart as solids. Were distention that of the pressure now, pores
/// would open again: nothing was left crushed, and surfaces flew off at more than 800 m/s.
#[test]
fn crushed_matter_expands_into_vacuum() {
    ranks(1, "hard_pores_shocks::crushed_matter_expands_into_vacuum", |comm| {
        let bodies =
            [plate("left", "sponge", [-0.3 - APART, -APART], 1.5e3), plate("right", "sponge", [0.0, 0.3], -1.5e3)];
        let mut hand = ByHand::<2>::new(&strip("Crushed and let go", &bodies, SPONGE), comm, |_| {});
        let before = hand.stepper.totals();
        let porous = PorousMedium::of(material(&hand, "left"), 3.0).expect("porous matter");
        let shock = porous.piston(1.5e3).expect("a compaction wave").front;
        let State { density, internal_energy, .. } = shock.behind;
        let matrix = Medium { law: porous.matter.eos, density, internal_energy };
        let release = matrix.release(&shock.behind).expect("a release");
        let surface = release.velocity - 1.5e3;
        let (mut least, mut reopened) = (f64::MAX, 0.0f64);
        let mut last: HashMap<u64, f64> = hand.particles().map(|i| (hand.id(i), 3.0)).collect();
        hand.run(4e-4, |hand| {
            least = hand.numbers("density").iter().copied().fold(least, f64::min);
            for i in hand.particles() {
                let now = hand.numbers("distention")[i];
                reopened = reopened.max(now - last.insert(hand.id(i), now).expect("a known particle"));
            }
        });
        let drift = drift(&mut hand, &before);
        let crushed = hand.numbers("distention").iter().filter(|a| **a == 1.0).count() as f64 / last.len() as f64;
        let mut right: Vec<usize> = hand.particles().collect();
        right.sort_by(|&a, &b| hand.position(b).x.total_cmp(&hand.position(a).x));
        let layers: Vec<f64> =
            right.chunks(8).map(|l| l.iter().map(|&i| hand.velocity(i).x).sum::<f64>() / l.len() as f64).collect();
        println!(
            "{:.0?} m/s of {surface:.0}, density from {least:.0} kg/m^3, {crushed:.3} crushed, drift {drift:.1e}",
            &layers[..4]
        );
        assert!(all_finite(&hand) && drift.abs() < 1e-3 && least > 0.0);
        // What the shock reached whole is a solid now; the outer layers were let go before.
        assert!(reopened == 0.0 && crushed > 0.8);
        // Of the speed gained in the release; the density behind the shock is off by per cent, see above.
        assert!(layers[..4].iter().all(|v| (v - surface).abs() < 0.02 * release.velocity), "{layers:.0?}");
    });
}

/// What a shock through basalt, porous matter of a fifth of its density and basalt again leaves.
struct Sandwich {
    /// Mean pressure on the near and on the far side of the first contact behind the first shock, over that of the shock.
    first: [f64; 2],
    /// The same of both contacts when waves have run to and fro, Pa.
    last: [[f64; 2]; 2],
    /// How far a particle lies beyond one of the other side, in smoothing lengths; below zero while they keep apart.
    deepest: f64,
    drift: f64,
}

fn sandwich(changes: &[&str], comm: &Comm) -> Sandwich {
    let bodies = [
        plate("flyer", "basalt", [-1.0 - APART, -APART], 1e3),
        plate("sponge", "sponge", [0.0, 0.6], 0.0) + "distention = 5\n",
        plate("target", "basalt", [0.6, 1.2], 0.0),
    ];
    let text = strip("Porous beside solid", &bodies, SPONGE);
    let mut hand = ByHand::<2>::with(&text, changes, comm, |_, _, _| {});
    let before = hand.stepper.totals();
    let porous = PorousMedium::of(material(&hand, "sponge"), 5.0).expect("porous matter");
    let u = contact(&medium(material(&hand, "flyer")), &porous, 1e3);
    let wave = porous.piston(u).expect("a compaction wave").front;
    let h = hand.stepper.settings.view.constants[0].smoothing_length;
    let mut deepest = f64::MIN;
    let mut reach = |hand: &mut ByHand<2>, time: f64| {
        hand.run(time, |hand| {
            for pair in [[0, 1], [1, 2]] {
                deepest = deepest.max((ends(hand, pair[0])[1] - ends(hand, pair[1])[0]) / h);
            }
        });
    };
    // Beyond the row that stands at the contact, which is hot from the first touch.
    let across = |hand: &ByHand<2>, [a, b]: [usize; 2]| {
        let place = 0.5 * (ends(hand, a)[1] + ends(hand, b)[0]);
        let near = [place - 7.0 * h, place - h];
        [mean(hand, "pressure", a, near), mean(hand, "pressure", b, [place + h, place + 7.0 * h])]
    };
    let meet = APART / 1e3;
    reach(&mut hand, meet + 0.45 / wave.speed);
    let first = across(&hand, [0, 1]).map(|p| p / wave.behind.stress);
    reach(&mut hand, meet + 0.6 / wave.speed + 1.4e-4);
    let last = [[0, 1], [1, 2]].map(|pair| across(&hand, pair));
    assert!(all_finite(&hand));
    Sandwich { first, last, deepest, drift: drift(&mut hand, &before) }
}

/// Pressure goes on across the contacts and matter keeps to its side; without viscosity it runs through the other.
#[test]
fn porous_next_to_solid() {
    ranks(1, "hard_pores_shocks::porous_next_to_solid", |comm| {
        let Sandwich { first, last, deepest, drift } = sandwich(&[], comm);
        println!("P {first:.3?}, {last:.3?}, deepest {deepest:.2} h, drift {drift:.1e}");
        assert!(deepest < 1.0 && drift.abs() < 1e-3);
        assert!(last.iter().all(|[near, far]| (near / far - 1.0).abs() < 0.05), "pressure jumps: {last:?}");
        // Crushed rows ring behind the front by a fifth of the pressure, and there are two dozen of them.
        assert!((first[0] - 1.0).abs() < 0.05 && (first[1] - 1.0).abs() < 0.15, "{first:?}");
        let Sandwich { deepest, .. } = sandwich(&["numerics.viscosity=false"], comm);
        println!("without viscosity: deepest {deepest:.1} h");
        assert!(deepest > 5.0, "the defect is gone");
    });
}
