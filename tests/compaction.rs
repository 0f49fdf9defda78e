//! Compaction of porous matter: the figures of Jutzi, Benz & Michel 2008 from the program's material functions, and compaction
//! waves against the jump conditions. `scripts/validate compaction` does the waves finer and in space.

use std::path::{Path, PathBuf};

use serde_json::Value;
use sph_mpi::exact::State;
use sph_mpi::exact::compaction::PorousMedium;
use sph_mpi::material::MaterialTable;
use sph_mpi::material::porosity::law::Porous;

use crate::common::{Launch, program, reference, summary};

/// Matter of figures 1 to 3, with a law of compaction.
fn porous_medium(alpha_0: f64, c: f64, law: &str) -> PorousMedium {
    let text = format!(
        "eos = {{ simplified_tillotson = {{ rho_0 = 2700, c = {c}, A = 7.5e10 }} }}\n[porosity]\ndistention = {alpha_0}\n{law}"
    );
    let material: MaterialTable = toml::from_str(&text).expect("a material");
    material.validate("material.simple").expect("a sound material");
    PorousMedium::of(&material, alpha_0).expect("a porous material")
}

fn by_pressure(alpha_0: f64, c: f64) -> PorousMedium {
    porous_medium(alpha_0, c, "p_alpha = { quadratic = { P_e = 8e7, P_s = 7e8 } }")
}

fn by_cold_pressure(alpha_0: f64) -> PorousMedium {
    porous_medium(alpha_0, 2.0, "rho_alpha = { quadratic = { P_e = 8e7, P_s = 7e8 } }")
}

/// Constant matrix density from where the Hugoniot with closed pores has P_e:
/// rho_e / rho_0 = [1 + (1 + c/2) alpha_0 P_e / A] / [1 + c/2 alpha_0 P_e / A].
fn by_strain(alpha_0: f64, c: f64) -> PorousMedium {
    let x = alpha_0 * 8e7 / 7.5e10;
    let strain = libm::log((1.0 + (1.0 + 0.5 * c) * x) / (1.0 + 0.5 * c * x));
    porous_medium(alpha_0, c, &format!("epsilon_alpha = {{ kappa = 1, elastic_strain = {strain:e} }}"))
}

/// The weakest shock behind which something holds that holds behind every stronger one; `None` up to 1e8 m/s.
fn weakest(medium: &PorousMedium, holds: impl Fn(&State) -> bool) -> Option<State> {
    let behind = |gain: f64| medium.shock(gain).map(|front| front.behind).ok();
    let (mut low, mut high) = (1e-3, 1e8);
    behind(high).filter(|state| holds(state))?;
    loop {
        let middle = (low * high).sqrt();
        if middle <= low || middle >= high {
            return behind(high);
        }
        if behind(middle).is_some_and(|state| holds(&state)) { high = middle } else { low = middle }
    }
}

/// Figures agree to this; references have nine digits.
const DIGITS: f64 = 1e-6;

#[track_caller]
fn assert_near(found: f64, expected: f64, what: &str) {
    assert!((found / expected - 1.0).abs() < DIGITS, "{what}: {found} and {expected}");
}

/// Figure 1: density and matrix density along the Hugoniot. At alpha_0 = 3 the matrix ends up less dense than without load.
#[test]
fn figure_1() {
    for alpha_0 in [1.275, 3.0] {
        let medium = by_pressure(alpha_0, 2.0);
        let rows = reference(&format!("jutzi08_fig1_alpha0_{alpha_0:?}.csv"));
        assert!(rows.len() > 20);
        for row in rows.iter().filter(|row| row[0] > 0.0) {
            let state = weakest(&medium, |state| state.stress >= row[0]).expect("a shock");
            assert_near(state.distention, row[1], "alpha");
            assert_near(state.density, row[2], "rho");
            assert_near(state.distention * state.density, row[3], "rho_s");
        }
    }
    let thinnest = weakest(&by_pressure(3.0, 2.0), |state| state.stress >= 7e8).expect("a shock");
    assert!((thinnest.density - 2675.49).abs() < 0.01 && thinnest.distention < 1.0 + 1e-12, "{thinnest:?}");
}

/// Pressure at a distention on the Hugoniot; infinite where it is never reached.
fn pressure_at(medium: &PorousMedium, alpha_0: f64, alpha: f64) -> f64 {
    let reached = |state: &State| state.distention < alpha || (state.distention == alpha && alpha < alpha_0);
    weakest(medium, reached).map_or(f64::INFINITY, |state| state.stress)
}

#[track_caller]
fn assert_curve(medium: &PorousMedium, alpha_0: f64, rows: &[Vec<f64>], column: usize) {
    let mut finite = 0;
    for row in rows {
        let pressure = pressure_at(medium, alpha_0, row[0]);
        if row[column].is_finite() {
            assert_near(pressure, row[column], &format!("P at alpha = {}", row[0]));
            finite += 1;
        } else {
            assert!(pressure > 1e15, "alpha = {} is reached at {pressure:e} Pa", row[0]);
        }
    }
    assert!(finite > 10, "{finite}");
}

/// Figure 2: P-alpha, rho-alpha, epsilon-alpha with kappa = 1. Only P-alpha crushes all pores at alpha_0 = 3.
#[test]
fn figure_2() {
    for alpha_0 in [1.275, 3.0] {
        let rows = reference(&format!("jutzi08_fig2_alpha0_{alpha_0:?}.csv"));
        let laws = [by_pressure(alpha_0, 2.0), by_cold_pressure(alpha_0), by_strain(alpha_0, 2.0)];
        laws.iter().zip(1..).for_each(|(medium, column)| assert_curve(medium, alpha_0, &rows, column));
    }
}

/// Figure 3: epsilon-alpha for c = 0.5, 1, 2.
#[test]
fn figure_3() {
    for alpha_0 in [1.275, 3.0] {
        let rows = reference(&format!("jutzi08_fig3_alpha0_{alpha_0:?}.csv"));
        for (c, column) in [(0.5, 1), (1.0, 2), (2.0, 3)] {
            assert_curve(&by_strain(alpha_0, c), alpha_0, &rows, column);
        }
    }
}

/// Least distention at constant matrix density (eq. 19): 1 / P is linear in alpha along the Hugoniot and vanishes there. 0.602 lies
/// below 1: then all pores close, at 4.82e8 Pa.
#[test]
fn least_distentions() {
    for (c, least) in [(2.0, 1.5048), (1.0, 1.0032), (0.5, 0.6019)] {
        let medium = by_strain(3.0, c);
        let [a, b] = [2.9, 2.5].map(|alpha| (alpha, 1.0 / pressure_at(&medium, 3.0, alpha)));
        let vanishes = a.0 - a.1 * (b.0 - a.0) / (b.1 - a.1);
        assert!((vanishes - least).abs() < 5e-5, "c = {c}: {vanishes}");
    }
    assert!((pressure_at(&by_strain(3.0, 0.5), 3.0, 1.0) / 4.819e8 - 1.0).abs() < 1e-4);
    assert!(pressure_at(&by_strain(3.0, 1.0), 3.0, 1.0).is_infinite());
    // And where a strong shock comes close to it.
    let strong = by_strain(3.0, 2.0).shock(1e6).expect("a shock").behind;
    assert!((strong.distention - 1.5048).abs() < 1e-3, "{strong:?}");
}

/// Figure 4: damage by compaction against distention, in closed form.
#[test]
fn figure_4() {
    for alpha_0 in [1.275, 3.0, 4.64] {
        let porous: Porous = by_pressure(alpha_0, 2.0).matter;
        for k in 0..=100 {
            let crushed: f64 = 0.01 * f64::from(k);
            let alpha = 1.0 + (alpha_0 - 1.0) * (1.0 - crushed);
            let least = libm::cbrt(0.01);
            let expected = (libm::cbrt(crushed + 0.01) - least) / (libm::cbrt(1.01) - least);
            assert!((porous.damage_root(alpha) - expected).abs() < 1e-12, "{alpha_0} {crushed}");
        }
    }
}

/// A compaction wave in the plane over some 7 mm, closed along y, and its errors.
fn wave(alpha_0: f64, speed: f64, until: f64, spacing: f64) -> Value {
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("../inputs/compaction_wave.toml");
    let dir = tempfile::tempdir().expect("a temporary directory");
    let out: PathBuf = dir.path().join("out");
    let (height, thick) = (8.0 * spacing * 0.75f64.sqrt(), 10.0 * spacing);
    let settings = [
        "dimension=2".into(),
        format!("domain={{ periodic = {{ y = [0, {height}] }} }}"),
        format!("column.size=[{}, {height}]", 0.02 + thick),
        format!("column.position=[{}, {}]", 0.01 - 0.5 * thick, 0.5 * height),
        format!("column.spacing={spacing}"),
        format!("column.distention={alpha_0}"),
        "layer.0.z=false".into(),
        "layer.1.z=false".into(),
        format!("layer.0.x=[{}, 0]", -thick),
        format!("layer.0.motion={{ velocity = [{speed}, 0] }}"),
        format!("layer.1.x=[{}, 0.02]", 0.02 - thick),
        format!("compare.within=[{}, 0.0185]", speed * until + 1e-4),
        format!("run.until={until}"),
        "output.picture=false".into(),
    ];
    let plain = |path: &Path| path.to_str().expect("a plain path").to_string();
    let mut args = vec![plain(&scene), "--quiet".into(), "--out".into(), plain(&out)];
    settings.into_iter().for_each(|setting| args.extend(["--set".into(), setting]));
    Launch::alone(program(), &args).run().expect_code(0);
    summary(&out)
}

#[track_caller]
fn assert_within(summary: &Value, tolerances: &[(&str, f64)]) {
    for (name, tolerance) in tolerances {
        let error = summary["errors"][name].as_f64().unwrap_or_else(|| panic!("no {name} in {:#}", summary["errors"]));
        assert!(error.abs() <= *tolerance, "{name} is {error}, tolerance {tolerance}\n{:#}", summary["errors"]);
    }
}

/// Behind the compaction shock: what is named within its tolerance; the energy of the run is conserved.
#[track_caller]
fn assert_wave(summary: &Value, tolerances: &[(&str, f64)]) {
    assert_within(summary, tolerances);
    let drift = summary["energy_drift"].as_f64().expect("a number");
    assert!(drift < 1e-3, "{drift}");
}

/// The paper's wave at a spacing of 0.1 mm: all pores close. Densities and pressures behind both fronts are right to what sums over
/// a squeezed lattice allow; fronts start a spacing late, 2 per cent of what they have run; energy has the start of the shock
/// at the piston in it. Tolerances are a fifth to a third above what this spacing gives.
#[test]
fn waves_that_close_all_pores() {
    let paper = wave(1.275, 458.0, 3.5e-6, 1e-4);
    assert_wave(&paper, &[("plateau_1_stress", 0.0055), ("plateau_1_density", 5e-4), ("plateau_1_distention", 1e-12)]);
    assert_wave(&paper, &[("plateau_1_internal_energy", 0.011), ("plateau_2_stress", 0.009)]);
    assert_wave(
        &paper,
        &[("plateau_2_distention", 2e-5), ("front_1_speed", 0.026), ("front_2_speed", 0.02), ("stress_l1", 0.03)],
    );
    let dense = wave(1.1, 300.0, 3e-6, 1e-4);
    assert_wave(&dense, &[("plateau_1_stress", 0.0075), ("plateau_1_density", 5e-4), ("plateau_1_distention", 1e-12)]);
    assert_wave(&dense, &[("plateau_1_internal_energy", 0.0055), ("front_1_speed", 0.025), ("stress_l1", 0.03)]);
}

/// At 100 m/s a third of the pores is left: 1.1446. The wave is weak and wide.
#[test]
fn a_wave_that_leaves_pores() {
    let slow = wave(1.275, 100.0, 4.5e-6, 1e-4);
    assert_wave(
        &slow,
        &[("plateau_1_distention", 0.0025), ("plateau_1_stress", 0.018), ("plateau_1_internal_energy", 0.009)],
    );
    assert_wave(&slow, &[("plateau_2_stress", 0.001), ("front_2_speed", 0.014), ("distention_l1", 0.003)]);
}

/// At 1500 m/s the shock has overtaken its precursor: one front.
#[test]
fn an_overdriven_wave() {
    let fast = wave(1.275, 1500.0, 3e-6, 1e-4);
    assert_wave(&fast, &[("plateau_1_distention", 1e-12), ("plateau_1_stress", 0.014), ("front_1_speed", 0.026)]);
    assert!(fast["errors"].get("front_2_speed").is_none(), "{:#}", fast["errors"]);
}

/// alpha_0 = 3: the layer behind the shock is ten spacings of the start thick, and its middle is not yet flat; the profile is.
#[test]
fn a_wave_at_high_porosity() {
    let light = wave(3.0, 458.0, 4.5e-6, 1e-4);
    assert_wave(
        &light,
        &[("distention_l1", 0.0145), ("stress_l1", 0.029), ("front_1_speed", 0.012), ("plateau_2_stress", 0.0005)],
    );
}
