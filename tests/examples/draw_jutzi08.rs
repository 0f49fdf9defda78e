//! Draws figures 1 to 4 of Jutzi, Benz & Michel 2008 (Icarus 198, 242) from the program's own material functions, with no particle:
//! `cargo run --release --example draw_jutzi08`, into the folder that the environment variable FIGURES names, or into tests/validation.

use std::path::Path;

use sph_mpi::error::{Error, Result};
use sph_mpi::exact::compaction::PorousMedium;
use sph_mpi::material::MaterialTable;
use sph_mpi::output::figures::curves::{Axis, Figure, Mark, Series};

fn main() {
    let folder = std::env::var("FIGURES").unwrap_or_else(|_| "tests/validation".into());
    if let Err(error) = draw(Path::new(&folder)) {
        eprintln!("error: {error}");
        std::process::exit(1);
    }
}

/// The matter of figures 1 to 3: P = c rho E + A mu, rigid pores.
fn porous_medium(alpha_0: f64, c: f64, law: &str) -> Result<PorousMedium> {
    let text = format!(
        "eos = {{ simplified_tillotson = {{ rho_0 = 2700, c = {c}, A = 7.5e10 }} }}\n[porosity]\ndistention = {alpha_0}\n{law}"
    );
    let material: MaterialTable = toml::from_str(&text).map_err(|e| Error::new(e.to_string()))?;
    PorousMedium::of(&material, alpha_0).ok_or_else(|| Error::new("no pores"))
}

const BY_PRESSURE: &str = "p_alpha = { quadratic = { P_e = 8e7, P_s = 7e8 } }";
const BY_DENSITY: &str = "rho_alpha = { quadratic = { P_e = 8e7, P_s = 7e8 } }";

/// Constant matrix density from where the Hugoniot has P_e.
fn by_strain(alpha_0: f64, c: f64) -> String {
    let x = alpha_0 * 8e7 / 7.5e10;
    let strain = libm::log((1.0 + (1.0 + 0.5 * c) * x) / (1.0 + 0.5 * c * x));
    format!("epsilon_alpha = {{ kappa = 1, elastic_strain = {strain:e} }}")
}

/// (P in GPa, alpha, rho) along the Hugoniot of first loading.
fn hugoniot(medium: &PorousMedium, most: f64) -> Result<Vec<[f64; 3]>> {
    let mut points = Vec::new();
    for k in 0..4000 {
        let state = medium.shock(0.5 * libm::pow(1.0025, f64::from(k)))?.behind;
        if state.stress > most {
            break;
        }
        points.push([1e-9 * state.stress, state.distention, state.density]);
    }
    Ok(points)
}

fn line(label: String, points: Vec<(f64, f64)>) -> Series {
    Series { label, points, errors: Vec::new(), mark: Mark::Line }
}

fn figure(title: &str, x: &str, y: &str, series: Vec<Series>) -> Figure {
    let axis = |label: &str| Axis { label: label.into(), logarithmic: false };
    Figure { title: title.into(), x: axis(x), y: axis(y), series }
}

fn draw(folder: &Path) -> Result<()> {
    let (mut densities, mut matrices) = (Vec::new(), Vec::new());
    for alpha_0 in [1.275, 3.0] {
        let points = hugoniot(&porous_medium(alpha_0, 2.0, BY_PRESSURE)?, 1.2e9)?;
        densities.push(line(format!("alpha_0 = {alpha_0}"), points.iter().map(|[p, _, rho]| (*p, *rho)).collect()));
        matrices.push(line(
            format!("alpha_0 = {alpha_0}"),
            points.iter().map(|[p, alpha, rho]| (*p, alpha * rho)).collect(),
        ));
    }
    figure("Figure 1, top: density along the Hugoniot", "P (GPa)", "density (kg/m^3)", densities)
        .draw(&folder.join("jutzi08_fig1_density.png"))?;
    figure("Figure 1, bottom: density of the matrix", "P (GPa)", "matrix density (kg/m^3)", matrices)
        .draw(&folder.join("jutzi08_fig1_matrix.png"))?;
    for alpha_0 in [1.275, 3.0] {
        let curve = |label: String, c: f64, law: &str| -> Result<Series> {
            let points = hugoniot(&porous_medium(alpha_0, c, law)?, 1.2e9)?;
            Ok(line(label, points.iter().map(|[p, alpha, _]| (*p, *alpha)).collect()))
        };
        let strain = by_strain(alpha_0, 2.0);
        let laws = [("P-alpha", BY_PRESSURE), ("rho-alpha", BY_DENSITY), ("epsilon-alpha, kappa = 1", &strain)];
        let series = laws.iter().map(|(label, law)| curve(label.to_string(), 2.0, law)).collect::<Result<_>>()?;
        let name = if alpha_0 > 2.0 { "high" } else { "low" };
        let title = |number: u8| format!("Figure {number}: distention behind shocks, alpha_0 = {alpha_0}");
        figure(&title(2), "P (GPa)", "distention", series).draw(&folder.join(format!("jutzi08_fig2_{name}.png")))?;
        let series = [0.5, 1.0, 2.0].map(|c| curve(format!("epsilon-alpha, c = {c}"), c, &by_strain(alpha_0, c)));
        let series = series.into_iter().collect::<Result<_>>()?;
        figure(&title(3), "P (GPa)", "distention", series).draw(&folder.join(format!("jutzi08_fig3_{name}.png")))?;
    }
    let matter = porous_medium(3.0, 2.0, BY_PRESSURE)?.matter;
    let damage = (0..=400).map(|k| 1.0 - 0.0025 * f64::from(k)).map(|pores| {
        let root = matter.damage_root(1.0 + 2.0 * pores);
        (pores, root * root * root)
    });
    let series = vec![line("D".into(), damage.collect())];
    figure("Figure 4: damage by compaction", "(alpha - 1) / (alpha_0 - 1)", "damage", series)
        .draw(&folder.join("jutzi08_fig4.png"))
}
