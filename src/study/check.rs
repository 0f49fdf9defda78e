//! The points of a study with their costs, before any of them runs: the text of `--check`, and a plain list.

use std::fmt::Write;

use super::points::Study;
use crate::domain::comm::{Comm, Network};
use crate::error::Result;
use crate::forecast::cost::{self, PredictedCost};
use crate::output::text::{aligned, duration, number, words};
use crate::simulation::results::warnings;
use crate::warning::{self, Warning};

/// Every point's number, spacing and setting; one line each.
pub fn list(study: &Study) -> String {
    let line =
        |point: &super::points::Point| format!("{} {} {}\n", point.number, point.spacing, study.names[point.setting]);
    study.points.iter().map(line).collect()
}

/// Predicts every point on `ranks` ranks of one thread each. The pace of the machine is measured once for each setting, at its
/// finest. Collective.
pub fn check(study: &Study, ranks: usize, network: Option<Network>, comm: &Comm) -> Result<String> {
    let mut rows = vec![words([
        "point",
        "setting",
        "spacing (m)",
        "particles",
        "steps",
        "core-seconds",
        "pair interactions",
        "wall",
    ])];
    let mut sum = [0.0; 3];
    for (setting, name) in study.names.iter().enumerate() {
        let points = || study.points.iter().filter(|point| point.setting == setting);
        let Some(finest) = points().next_back() else { continue };
        let pace = cost::pace(&finest.scene, ranks, network, comm)?;
        for point in points() {
            let price = cost::predict(&point.scene, ranks, &pace, comm)?;
            rows.push(row(&[&point.number.to_string(), name], point.spacing, &price));
            let costs = [price.core_seconds, price.pair_interactions, price.wall_seconds];
            sum.iter_mut().zip(costs).for_each(|(sum, cost)| *sum += cost);
        }
    }
    let mut text = format!("{}\n{} of {}\n", study.settings.title, study.path, study.scene_path);
    let _ = writeln!(text, "{}, {} settings\n", study.settings.measure.describe(), study.names.len());
    text += &aligned(&rows);
    let s = if ranks == 1 { "" } else { "s" };
    let _ = writeln!(
        text,
        "\nall {} points on {ranks} rank{s} of one thread: {:.3e} core-seconds, {:.3e} pair interactions, {}",
        study.points.len(),
        sum[0],
        sum[1],
        duration(sum[2])
    );
    text += "core-seconds are without waits of ranks for each other and without output\n";
    let found: Vec<Vec<Warning>> = study.points.iter().map(|point| warnings::of_scene(&point.scene)).collect();
    let all = warning::merged("point", study.points.iter().map(|p| p.number).zip(found.iter().map(Vec::as_slice)));
    Ok(text + &cost::warned(&all))
}

fn row(names: &[&str], spacing: f64, price: &PredictedCost) -> Vec<String> {
    let mut cells = words([names[0], names[1]]);
    cells.extend([
        number(spacing),
        price.particles.to_string(),
        format!("{:.0}", price.steps),
        format!("{:.3e}", price.core_seconds),
        format!("{:.3e}", price.pair_interactions),
        duration(price.wall_seconds),
    ]);
    cells
}
