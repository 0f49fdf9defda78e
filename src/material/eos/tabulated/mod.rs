//! An equation of state by a table, such as those of ANEOS, SESAME or AQUA: pressure over density and energy (`grid`), from text files of
//! three kinds (`formats`).
//!
//! ```text
//! P(rho, u)    c^2 = dP/drho + P / rho^2 dP/du        of the interpolated pressure, so that both belong together
//! ```
//! u is counted from matter without load at rest: at `temperature` and the density `rho_0`, where pressure is that of the air on Earth
//! or, in tables whose matter bears tension, none. Tension fades as for Tillotson's law, and c^2 is a quarter of that at rest at least.

mod curve;
pub mod formats;
pub mod grid;

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::super::setup::all_positive;
use super::slopes::{Slopes, bounded_sound, fading};
use crate::error::{Error, Result};
use crate::units::{Density, Number, SpecificEnergy};
use formats::Format;
use grid::Grid;

/// An equation of state by a table in a file: of ANEOS, SESAME and the like.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TabulatedTable {
    /// Path of the file, from the scene's folder.
    pub file: String,
    /// How it is written.
    pub format: Format,
    /// Path of the file with the phases of the same states: M-ANEOS's extended table (`NEW-SESAME-EXT.TXT`).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phases: Option<String>,
    /// Temperature of matter without load, K. Where the table has none, matter without load has the energy 0.
    #[serde(default = "room")]
    pub temperature: Number,
    /// Density without load; the table's own without it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rho_0: Option<Density>,
    /// Energy of incipient vaporisation, above that of matter without load; for records of melt and vapour.
    #[serde(rename = "E_iv", default, skip_serializing_if = "Option::is_none")]
    pub e_iv: Option<SpecificEnergy>,
    /// Energy of complete vaporisation, above that of matter without load.
    #[serde(rename = "E_cv", default, skip_serializing_if = "Option::is_none")]
    pub e_cv: Option<SpecificEnergy>,
    /// What is in the file, once it has been read.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(skip)]
    pub grid: Option<Arc<Grid>>,
}

fn room() -> Number {
    Number::new(298.0)
}

/// Pressure of the air on Earth, Pa: what is below it is none.
const AIR: f64 = 1e5;

/// The law of a table.
#[derive(Debug, Clone, PartialEq)]
pub struct Tabulated {
    grid: Arc<Grid>,
    rho_0: f64,
    inverse_rho_0: f64,
    /// Energy of matter without load by the table, J/kg.
    u_0: f64,
    /// Square of its speed of sound, m^2/s^2.
    rest2: f64,
    vaporisation: Option<[f64; 2]>,
}

impl TabulatedTable {
    pub(super) fn validate(&self, place: &str) -> Result<()> {
        let given =
            [("rho_0", self.rho_0.map(|x| x.0)), ("E_iv", self.e_iv.map(|x| x.0)), ("E_cv", self.e_cv.map(|x| x.0))];
        for (key, value) in given.into_iter().filter_map(|(key, value)| Some((key, value?))) {
            all_positive(place, &[(key, value)])?;
        }
        all_positive(place, &[("temperature", self.temperature.0)])?;
        let wrong = |what: String, key: &str| Error::new(what).at(format!("{place}.{key}"));
        match (self.e_iv, self.e_cv) {
            (None, None) => {}
            (Some(begins), Some(complete)) if begins.0 < complete.0 => {}
            (Some(_), Some(_)) => return Err(wrong("E_cv is not above E_iv".into(), "E_cv")),
            (None, Some(_)) => return Err(wrong("there is no E_iv".into(), "E_cv").allowed("both or none")),
            (Some(_), None) => return Err(wrong("there is no E_cv".into(), "E_iv").allowed("both or none")),
        }
        let Some(grid) = &self.grid else { return Err(wrong(format!("{} has not been read", self.file), "file")) };
        let [thinnest, densest] = grid.densities();
        if let Some(rho_0) = self.rho_0.filter(|rho_0| !(thinnest..densest).contains(&rho_0.0)) {
            let error = wrong(format!("rho_0 is {rho_0}"), "rho_0");
            return Err(error.allowed(format!("a density of the table, {thinnest} to {densest} kg/m^3")));
        }
        if self.rho_0.or(self.unloaded(grid).map(Density::new)).is_none() {
            let error = wrong("no density of the table is without load at this temperature".into(), "temperature");
            return Err(error.allowed("another, or rho_0"));
        }
        let law = Tabulated::new(self);
        if !(law.rest2 > 0.0 && law.rest2.is_finite()) {
            let what = format!("at {} kg/m^3 pressure does not rise with density", law.rho_0);
            return Err(wrong(what, "rho_0").allowed("a density at which matter resists"));
        }
        Ok(())
    }

    /// The density of matter without load: the largest at which pressure is not above that of the air; none where there is none.
    fn unloaded(&self, grid: &Grid) -> Option<f64> {
        let pressure = |rho: f64| grid.state(rho, self.energy(grid, rho)).p - AIR;
        let [thinnest, densest] = grid.densities();
        // Pressure may fall and rise again far below: the last rise counts.
        let ratio = libm::pow(densest / thinnest, 1.0 / SCANS as f64);
        let (mut above, mut below) = (densest, densest / ratio);
        if pressure(above) <= 0.0 {
            return None;
        }
        while pressure(below) > 0.0 {
            (above, below) = (below, below / ratio);
            if below < thinnest {
                return None;
            }
        }
        for _ in 0..100 {
            let middle = 0.5 * (above + below);
            if pressure(middle) > 0.0 { above = middle } else { below = middle }
        }
        Some(0.5 * (above + below))
    }

    /// Energy at the temperature of matter without load, J/kg.
    fn energy(&self, grid: &Grid, rho: f64) -> f64 {
        grid.energy_at(rho, self.temperature.0).unwrap_or(0.0)
    }
}

/// Densities at which the unloaded one is looked for.
const SCANS: usize = 4000;

impl Tabulated {
    /// The law of a valid table.
    pub fn new(table: &TabulatedTable) -> Self {
        let grid = table.grid.clone().expect("a table whose file has been read");
        let rho_0 = table.rho_0.map(|rho_0| rho_0.0).or(table.unloaded(&grid)).unwrap_or(f64::NAN);
        let u_0 = table.energy(&grid, rho_0);
        let rest2 = grid.state(rho_0, u_0).sound2(rho_0);
        let vaporisation = table.e_iv.zip(table.e_cv).map(|(begins, complete)| [begins.0, complete.0]);
        Self { grid, rho_0, inverse_rho_0: 1.0 / rho_0, u_0, rest2, vaporisation }
    }

    pub fn reference_density(&self) -> f64 {
        self.rho_0
    }

    /// rho c^2 without load, Pa.
    pub fn bulk_modulus(&self) -> f64 {
        self.rho_0 * self.rest2
    }

    /// E_iv and E_cv, J/kg, where they are given.
    pub fn vaporisation(&self) -> Option<[f64; 2]> {
        self.vaporisation
    }

    /// Pressure, Pa, and speed of sound, m/s.
    #[inline]
    pub fn pressure(&self, rho: f64, u: f64) -> (f64, f64) {
        let state = self.slopes(rho, u);
        (state.p, bounded_sound(state.sound2(rho), self.rest2))
    }

    /// Temperature, K; none where the table has none.
    pub fn temperature(&self, rho: f64, u: f64) -> Option<f64> {
        self.grid.temperature(rho, self.u_0 + u)
    }

    /// Number of the phase; none where nobody says it.
    pub fn phase(&self, rho: f64, u: f64) -> Option<f64> {
        self.grid.phase(rho, self.u_0 + u)
    }

    /// Pressure and its derivatives.
    #[inline]
    pub fn slopes(&self, rho: f64, u: f64) -> Slopes {
        fading(self.grid.state(rho, self.u_0 + u), rho * self.inverse_rho_0, self.inverse_rho_0)
    }
}

#[cfg(test)]
mod tests {
    use super::super::tillotson::{Tillotson, TillotsonTable};
    use super::formats::Row;
    use super::*;

    fn basalt() -> Tillotson {
        let table: TillotsonTable = toml::from_str(
            "rho_0 = 2700\na = 0.5\nb = 1.5\nA = 2.67e10\nB = 2.67e10\nE_0 = 4.87e8\nE_iv = 4.72e6\nE_cv = 1.82e7\nalpha = 5\nbeta = 5",
        )
        .unwrap();
        Tillotson::new(&table)
    }

    /// A table of Tillotson's basalt: n densities per decade, energies in steps that grow.
    fn table(n: usize) -> TabulatedTable {
        let densities = (0..=3 * n).map(|k| 27.0 * libm::pow(10.0, k as f64 / n as f64));
        let row = |density: f64| {
            let energy: Vec<f64> = (0..=4 * n).map(|k| 1e4 * libm::expm1(10.0 * k as f64 / (4 * n) as f64)).collect();
            let pressure = energy.iter().map(|u| basalt().pressure(density, *u).0).collect();
            Row { density, energy, pressure, temperature: Vec::new(), phase: Vec::new() }
        };
        let grid = Grid::new(densities.map(row).collect()).unwrap();
        let text = "file = \"basalt.txt\"\nformat = \"columns\"\nE_iv = 4.72e6\nE_cv = 1.82e7";
        TabulatedTable { grid: Some(Arc::new(grid)), ..toml::from_str(text).unwrap() }
    }

    fn law(n: usize) -> Tabulated {
        let table = table(n);
        table.validate("material.basalt.eos.table").unwrap();
        Tabulated::new(&table)
    }

    /// In compressed matter, hot and cold, pressure and sound come nearer to the law's with finer tables.
    #[test]
    fn tables_converge_to_their_law() {
        let off = |n: usize| {
            let (law, exact) = (law(n), basalt());
            let (mut pressure, mut sound) = (0.0f64, 0.0f64);
            for k in 0..40 {
                let rho = 2750.0 + 60.0 * k as f64;
                for u in [0.0, 3e4, 4e5, 2.2e6, 1.3e7, 9e7] {
                    let ((p, c), (exact_p, exact_c)) = (law.pressure(rho, u), exact.pressure(rho, u));
                    pressure = pressure.max((p / exact_p - 1.0).abs());
                    sound = sound.max((c / exact_c - 1.0).abs());
                }
            }
            (pressure, sound)
        };
        let (coarse, fine) = (off(40), off(120));
        println!("pressure and sound off by {coarse:?} with 40 densities per decade, {fine:?} with 120");
        assert!(fine.0 < 0.01 && fine.1 < 0.02 && fine.0 < 0.3 * coarse.0, "{coarse:?} {fine:?}");
    }

    #[test]
    fn matter_without_load_is_found() {
        let law = law(60);
        assert!((law.reference_density() / 2700.0 - 1.0).abs() < 1e-4, "{}", law.reference_density());
        assert!((law.bulk_modulus() / 2.67e10 - 1.0).abs() < 0.03, "{:e}", law.bulk_modulus());
        assert!(law.pressure(law.reference_density(), 0.0).0.abs() <= 1.001 * AIR);
        assert_eq!(law.vaporisation(), Some([4.72e6, 1.82e7]));
    }

    /// Derivatives are those of the pressure, inside the table and beyond it, and nothing breaks anywhere.
    #[test]
    fn derivatives_belong_to_the_pressure() {
        let law = law(40);
        for rho in [1e-6, 3.0, 26.0, 40.0, 900.0, 2701.0, 3333.0, 20_000.0, 40_000.0] {
            for u in [-1e7, 1e3, 5e5, 6e6, 1e8, 1e10] {
                let state = law.grid.state(rho, u);
                let by = |d_rho: f64, d_u: f64| {
                    (law.grid.state(rho + d_rho, u + d_u).p - law.grid.state(rho - d_rho, u - d_u).p) / 2.0
                };
                let (d_rho, d_u) = (1e-6 * rho, 1e-6 * u.abs());
                let (by_rho, by_u) = (by(d_rho, 0.0) / d_rho, by(0.0, d_u) / d_u);
                let size = state.p.abs() / rho + state.by_rho.abs() + 1e-3;
                assert!((state.by_rho - by_rho).abs() < 1e-3 * size, "{rho} {u}: {state:?} {by_rho}");
                assert!(
                    (state.by_u - by_u).abs() < 1e-3 * (state.by_u.abs() + 1e-9 * rho),
                    "{rho} {u}: {state:?} {by_u}"
                );
                let (p, c) = law.pressure(rho, u);
                assert!(p.is_finite() && c.is_finite() && c > 0.0);
            }
        }
        assert!(law.pressure(0.5 * 2700.0, 0.0).0 == 0.0, "tension fades");
    }

    #[test]
    fn bad_tables_are_named() {
        let place = "material.rock.eos.table";
        let wrong = |change: fn(&mut TabulatedTable)| {
            let mut table = table(20);
            change(&mut table);
            table.validate(place).unwrap_err().to_string()
        };
        assert!(wrong(|t| t.grid = None).contains("basalt.txt has not been read"));
        assert!(wrong(|t| t.rho_0 = Some(Density::new(1e6))).contains("27 to 27000"));
        assert!(wrong(|t| t.e_cv = None).starts_with("material.rock.eos.table.E_iv: there is no E_cv"));
        assert!(wrong(|t| t.e_cv = t.e_iv).contains("not above E_iv"));
        assert!(wrong(|t| t.temperature = Number::new(-1.0)).contains("temperature"));
        let row = |density: f64, energy: &[f64]| Row {
            density,
            energy: energy.into(),
            pressure: energy.into(),
            temperature: Vec::new(),
            phase: Vec::new(),
        };
        let refused = |rows: Vec<Row>| Grid::new(rows).unwrap_err();
        assert!(refused(vec![row(1.0, &[0.0, 1.0])]).contains("1 densities"));
        assert!(refused(vec![row(1.0, &[0.0, 1.0]), row(2.0, &[1.0, 1.0]), row(3.0, &[0.0, 1.0])]).contains("at 2"));
        assert!(
            refused(vec![row(1.0, &[0.0, 1.0]), row(3.0, &[0.0, 1.0]), row(2.0, &[0.0, 1.0])]).contains("follows 3")
        );
        assert!(
            refused(vec![row(1.0, &[0.0, f64::NAN]), row(2.0, &[0.0, 1.0]), row(3.0, &[0.0, 1.0])]).contains("at 1")
        );
    }
}
