//! Thresholds that the points of a study have searched: their table, and Q*_D over the target's radius beside published laws.

use std::collections::HashSet;
use std::fmt::Write;

use serde::{Deserialize, Serialize};

use super::points::{Point, Study};
use super::record::Record;
use crate::outcome::scaling::{self, ThresholdFit};
use crate::output::figures::curves::{Axis, Figure, Mark, Series};

/// The result of one search. Specific energies in J/kg.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Row {
    pub point: usize,
    /// The setting without its radius.
    pub family: String,
    /// Radius of the target, m.
    pub radius: f64,
    /// Speed of impact, m/s.
    pub speed: f64,
    /// Density of the target without pores, kg/m^3.
    pub density: f64,
    pub porous: bool,
    pub particles: f64,
    pub q_star_d: Option<f64>,
    pub uncertainty: Option<f64>,
    pub q_star_rd: Option<f64>,
    /// Q*_D over the fit of Benz & Asphaug 1999 for the nearest material and speed.
    pub ratio_to_reference: Option<f64>,
    /// s of M_lr / M_T = 1/2 - s (Q / Q*_D - 1).
    pub slope: Option<f64>,
    pub energy_drift: f64,
    pub core_seconds: f64,
}

/// Rows of the points that have been searched.
pub fn rows(study: &Study, records: &[Option<Record>]) -> Vec<Row> {
    let pairs = study.points.iter().zip(records);
    pairs.filter_map(|(point, record)| row(point, record.as_ref().filter(|record| record.failed.is_empty())?)).collect()
}

fn row(point: &Point, record: &Record) -> Option<Row> {
    point.scene.threshold.as_ref()?;
    let impact = point.scene.impact.as_ref()?;
    let target = &point.scene.bodies[impact.target];
    let material = &point.scene.materials[target.material];
    let found = |name: &str| record.figure(&format!("threshold.{name}"));
    let number = |name: &str| record.figure(name).unwrap_or(f64::NAN);
    Some(Row {
        point: point.number,
        family: point.family.clone(),
        radius: target.shape.outer_radius(),
        speed: impact.speed,
        density: material.reference_density().unwrap_or(target.density),
        porous: material.porosity.is_some(),
        particles: number("particles"),
        q_star_d: found("q_star_d"),
        uncertainty: found("uncertainty"),
        q_star_rd: found("q_star_rd"),
        ratio_to_reference: found("ratio_to_reference"),
        slope: found("slope"),
        energy_drift: number("energy_drift"),
        core_seconds: number("core_seconds"),
    })
}

/// The rows as a Markdown table.
pub fn table(rows: &[Row]) -> String {
    let mut text = String::from(
        "| point | target | radius (m) | speed (m/s) | particles | Q*_D (J/kg) | ± | over Benz & Asphaug 1999 | slope s | Q*_RD (J/kg) | energy drift | core-s |\n\
         |---|---|---|---|---|---|---|---|---|---|---|---|\n",
    );
    let cell = |value: Option<f64>, write: fn(f64) -> String| value.map_or("–".into(), write);
    let energy = |value| cell(value, |q| format!("{q:.3e}"));
    let ratio = |value| cell(value, |x| format!("{x:.2}"));
    for row in rows {
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {:.0e} | {:.0} |",
            row.point,
            row.family,
            row.radius,
            row.speed,
            row.particles,
            energy(row.q_star_d),
            energy(row.uncertainty),
            ratio(row.ratio_to_reference),
            ratio(row.slope),
            energy(row.q_star_rd),
            row.energy_drift,
            row.core_seconds
        );
    }
    text
}

/// Q*_D over the radius: a series of points for each family, lines for the laws of the same materials and speeds.
pub fn figure(title: &str, rows: &[Row]) -> Figure {
    let sizes = rows.iter().map(|row| row.radius);
    let (least, most) = sizes.fold((f64::INFINITY, 0.0f64), |(a, b), radius| (a.min(radius), b.max(radius)));
    let radii = || (0..=120).map(|k| 0.3 * least * libm::pow(most / least * 10.0, k as f64 / 120.0));
    let curve = |label: String, mark: Mark, q_star: &dyn Fn(f64) -> f64| Series {
        label,
        points: radii().map(|radius| (radius, q_star(radius))).collect(),
        errors: Vec::new(),
        mark,
    };
    let mut series: Vec<Series> = Vec::new();
    for (label, fit) in fits(rows) {
        let mark = if label.starts_with("Benz") { Mark::Line } else { Mark::Dashed };
        series.push(curve(label, mark, &|radius| fit.q_star(radius)));
    }
    let rock = rows.iter().filter(|row| is_rock(row)).max_by(|a, b| a.speed.total_cmp(&b.speed));
    if let Some(&Row { speed, density, .. }) = rock {
        let at = format!("Q*_RD, {} km/s", 1e-3 * speed);
        for (name, law) in [("strong rock", scaling::STRONG_ROCK), ("weak aggregates", scaling::WEAK_AGGREGATES)] {
            let label = format!("Stewart & Leinhardt 2009, {name}, {at}");
            series.push(curve(label, Mark::Dashed, &|radius| law.q_star(radius, speed)));
        }
        let at_rho_1 = libm::cbrt(1e-3 * density);
        let label = format!("Leinhardt & Stewart 2012, gravity, {at}");
        series.push(curve(label, Mark::Dashed, &|radius| scaling::gravity_law(at_rho_1 * radius, speed)));
    }
    let mut families: Vec<&str> = rows.iter().map(|row| row.family.as_str()).collect();
    let mut seen = HashSet::new();
    families.retain(|family| seen.insert(*family));
    for family in families {
        let found = || rows.iter().filter(|row| row.family == family && row.q_star_d.is_some());
        series.push(Series {
            label: family.to_string(),
            points: found().map(|row| (row.radius, row.q_star_d.unwrap_or(f64::NAN))).collect(),
            errors: found().map(|row| row.uncertainty.unwrap_or(0.0)).collect(),
            mark: Mark::Points,
        });
    }
    Figure {
        title: title.into(),
        x: Axis { label: "target radius (m)".into(), logarithmic: true },
        y: Axis { label: "Q*_D (J/kg)".into(), logarithmic: true },
        series,
    }
}

fn is_rock(row: &Row) -> bool {
    !scaling::is_ice(row.density)
}

/// Fits of Q*_D for the materials and speeds of the rows.
fn fits(rows: &[Row]) -> Vec<(String, ThresholdFit)> {
    let mut found: Vec<(String, ThresholdFit)> = Vec::new();
    let mut add = |name: &str, fit: ThresholdFit| {
        let label = format!("{name}, {} km/s", 1e-3 * fit.speed);
        if !found.iter().any(|(known, _)| *known == label) {
            found.push((label, fit));
        }
    };
    for row in rows {
        let name = if is_rock(row) { "basalt" } else { "ice" };
        let density = if is_rock(row) { 2700.0 } else { 917.0 };
        add(&format!("Benz & Asphaug 1999, {name}"), scaling::nearest_fit(density, row.speed));
    }
    for row in rows.iter().filter(|row| is_rock(row)) {
        let fast = row.speed * row.speed > 3e3 * 5e3;
        match (row.porous, fast) {
            (false, false) => add("Jutzi et al. 2010", scaling::JUTZI_3_KM_S),
            (false, true) => add("Jutzi et al. 2010", scaling::JUTZI_5_KM_S),
            (true, false) => add("Jutzi et al. 2010, porous", scaling::JUTZI_POROUS_3_KM_S),
            (true, true) => add("Jutzi et al. 2010, porous", scaling::JUTZI_POROUS_5_KM_S),
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(family: &str, radius: f64, density: f64, porous: bool, q_star_d: Option<f64>) -> Row {
        Row {
            point: 1,
            family: family.into(),
            radius,
            speed: 5e3,
            density,
            porous,
            particles: 1e4,
            q_star_d,
            uncertainty: Some(3.0),
            q_star_rd: None,
            ratio_to_reference: Some(1.25),
            slope: Some(0.4),
            energy_drift: 1e-4,
            core_seconds: 12.0,
        }
    }

    #[test]
    fn laws_belong_to_what_was_searched() {
        let rows = [
            row("solid", 1e2, 2700.0, false, Some(360.0)),
            row("solid", 1e4, 2700.0, false, Some(2e4)),
            row("pores", 1e4, 2700.0, true, None),
        ];
        let figure = figure("t", &rows);
        let labels: Vec<&str> = figure.series.iter().map(|series| series.label.as_str()).collect();
        assert_eq!(labels.len(), 8, "{labels:?}");
        assert!(labels[0].starts_with("Benz & Asphaug 1999, basalt, 5"));
        assert_eq!(&labels[6..], ["solid", "pores"]);
        assert_eq!(figure.series[6].points, [(1e2, 360.0), (1e4, 2e4)]);
        assert!(figure.series[7].points.is_empty());
        let ice = fits(&[row("ice", 1e3, 917.0, false, None)]);
        assert_eq!(ice.len(), 1);
        let text = table(&rows);
        assert!(text.lines().count() == 5 && text.contains("| 3.600e2 | 3.000e0 | 1.25 | 0.40 | – |"), "{text}");
    }
}
