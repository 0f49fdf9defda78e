//! The report of a study: study.json, study.csv, study.md, two figures, and its result in words.

use std::fmt::Write;
use std::path::Path;

use super::analysis::{Analysis, Cheapest, Cost, Found, Setting};
use super::measure::Against;
use super::pareto::{ErrorCost, Known};
use super::thresholds;
use crate::error::{Error, Result};
use crate::output::figures::or_warn;
use crate::output::figures::trade_off::{Curve, TradeOff};
use crate::output::publish::replace_text;
use crate::warning;

/// All files, for one rank; pictures last.
pub fn write(analysis: &Analysis, directory: &Path) -> Result<()> {
    let json = serde_json::to_string_pretty(analysis).map_err(|e| Error::new(e.to_string()))?;
    replace_text(&directory.join("study.json"), &(json + "\n"))?;
    replace_text(&directory.join("study.csv"), &table(analysis))?;
    replace_text(&directory.join("study.md"), &page(analysis))?;
    if has_errors(analysis) {
        for (cost, name) in [(Cost::CoreSeconds, "core_seconds"), (Cost::Pairs, "pairs")] {
            or_warn(figure(analysis, cost).draw(&directory.join(format!("error_{name}.png"))));
        }
    }
    if let Some(words) = &analysis.words {
        or_warn(words.figure(&analysis.title).draw(&directory.join("map.png")));
    }
    if analysis.thresholds.iter().any(|row| row.q_star_d.is_some()) {
        or_warn(thresholds::figure(&analysis.title, &analysis.thresholds).draw(&directory.join("q_star.png")));
    }
    Ok(())
}

fn has_errors(analysis: &Analysis) -> bool {
    analysis.points.iter().any(|point| point.error.is_some())
}

fn converges(setting: &Setting) -> bool {
    setting.order.is_some() || setting.limit.is_some()
}

/// Logs the result, on rank 0.
pub fn print(analysis: &Analysis, directory: &Path, is_root: bool) {
    for setting in analysis.settings.iter().filter(|setting| converges(setting)) {
        tracing::info!("{}: {}", setting.name, convergence(setting));
    }
    for line in prices(analysis) {
        tracing::info!("{line}");
    }
    let failed = analysis.points.iter().filter(|point| !point.failed.is_empty()).count();
    if failed > 0 {
        tracing::info!("{failed} of {} points have no result; study.md says why", analysis.points.len());
    }
    let warnings = analysis.warnings();
    warning::log(&warnings, is_root);
    tracing::info!("written to {}{}", directory.display(), warning::in_short(&warnings));
}

/// One row a point, every number in full.
fn table(analysis: &Analysis) -> String {
    let mut text = String::from(
        "point,setting,spacing,particles,steps,figure,error,core_seconds,pair_interactions,wall_seconds,\
         front_core_seconds,front_pairs,word,settings,failed,warnings\n",
    );
    let number = |value: Option<f64>| value.map_or(String::new(), |x| format!("{x:e}"));
    let whole = |value: Option<f64>| value.map_or(String::new(), |x| format!("{x}"));
    let quoted = |words: &str| format!("\"{}\"", words.replace('"', "\"\""));
    for p in &analysis.points {
        let cells = [
            p.number.to_string(),
            quoted(&analysis.settings[p.setting].name),
            format!("{:e}", p.spacing),
            whole(p.particles),
            whole(p.steps),
            number(p.figure),
            number(p.error),
            number(p.core_seconds),
            whole(p.pair_interactions),
            number(p.wall_seconds),
            (p.on_front_of_core_seconds as u8).to_string(),
            (p.on_front_of_pairs as u8).to_string(),
            quoted(p.word.as_deref().unwrap_or_default()),
            quoted(&p.overrides.join("; ")),
            quoted(&p.failed),
            quoted(&warning::kinds(&p.warnings).join("; ")),
        ];
        text += &(cells.join(",") + "\n");
    }
    text
}

/// study.md: the table for readers, with orders, limits and costs.
fn page(analysis: &Analysis) -> String {
    let mut text = String::new();
    let title = if analysis.title.is_empty() { &analysis.study } else { &analysis.title };
    let of = analysis.spacing_of.as_ref().map_or(String::new(), |body| format!(", of `{body}`"));
    let _ = writeln!(text, "# {title}\n\n`{}`: {}.\n", analysis.scene.path, analysis.measure.describe());
    if !analysis.thresholds.is_empty() {
        let _ = writeln!(text, "{}\n![Q*_D over the radius](q_star.png)\n", thresholds::table(&analysis.thresholds));
    }
    if analysis.words.is_some() {
        let _ = writeln!(text, "![Map of the outcomes](map.png)\n");
    }
    let _ = writeln!(
        text,
        "| point | setting | spacing (m{of}) | particles | steps | figure | error | core-s | pair interactions | Pareto |"
    );
    let _ = writeln!(text, "|---|---|---|---|---|---|---|---|---|---|");
    for point in &analysis.points {
        let _ = writeln!(text, "{}", row(analysis, point));
    }
    if has_errors(analysis) {
        let _ = writeln!(
            text,
            "\nPareto: no other point is both better and cheaper, by core-seconds (s) or by pair interactions (p).\n\n\
             ![Error against core-seconds](error_core_seconds.png)\n\n![Error against pair interactions](error_pairs.png)"
        );
    }
    if analysis.settings.iter().any(converges) {
        let _ = writeln!(text, "\n| setting | order of convergence | at zero spacing |\n|---|---|---|");
    }
    for setting in analysis.settings.iter().filter(|setting| converges(setting)) {
        let _ = writeln!(text, "| {} | {} | {} |", setting.name, order(setting), limit(setting));
    }
    let prices = prices(analysis);
    if !prices.is_empty() {
        let _ = writeln!(text, "\n## What an error costs\n");
    }
    for line in &prices {
        let _ = writeln!(text, "- {line}");
    }
    let floor = analysis.measure.floor();
    if floor > 0.0 {
        let _ =
            writeln!(text, "\nThe value itself is uncertain by {}: errors below that are meaningless.", percent(floor));
    }
    for warning in analysis.warnings() {
        let _ = writeln!(text, "\nWarning ({}): {}", warning.kind, warning.text);
    }
    text
}

fn row(analysis: &Analysis, p: &Found) -> String {
    let name = &analysis.settings[p.setting].name;
    if !p.failed.is_empty() {
        return format!("| {} | {name} | {:.4e} | {} | | | | | | |", p.number, p.spacing, p.failed.replace('|', "\\|"));
    }
    let short = |value: Option<f64>| value.map_or("–".into(), |x| format!("{x:.3e}"));
    let whole = |value: Option<f64>| value.map_or("–".into(), |x| format!("{x}"));
    let front = [(p.on_front_of_core_seconds, "s"), (p.on_front_of_pairs, "p")];
    let front: Vec<&str> = front.iter().filter(|(on, _)| *on).map(|(_, letter)| *letter).collect();
    format!(
        "| {} | {name} | {:.4e} | {} | {} | {} | {} | {} | {} | {} |",
        p.number,
        p.spacing,
        whole(p.particles),
        whole(p.steps),
        p.figure.map(|x| format!("{x:.4e}")).or(p.word.clone()).unwrap_or_else(|| "–".into()),
        p.error.map_or(if analysis.measure.against == Against::Nothing { "–" } else { "reference" }.into(), percent),
        short(p.core_seconds),
        short(p.pair_interactions),
        front.join(" ")
    )
}

fn percent(x: f64) -> String {
    let x = 100.0 * x;
    let digits = if x > 0.0 { (2.0 - libm::log10(x).floor()).clamp(0.0, 8.0) as usize } else { 0 };
    format!("{x:.digits$} %")
}

fn doubted(text: String, doubt: &str) -> String {
    if doubt.is_empty() { text } else { format!("{text} (asymptotic range in doubt: {doubt})") }
}

fn order(setting: &Setting) -> String {
    let Some(found) = &setting.order else { return "–".into() };
    let error = found.standard_error.map_or(String::new(), |error| format!(" ± {error:.2}"));
    doubted(format!("{:.2}{error}", found.order), &found.doubt)
}

fn limit(setting: &Setting) -> String {
    let Some(found) = &setting.limit else { return "–".into() };
    let by = found.order.map_or(String::new(), |order| format!(", order {order:.2}"));
    doubted(format!("{:.4e} ± {:.1e}{by}", found.value, found.uncertainty), &found.doubt)
}

fn convergence(setting: &Setting) -> String {
    format!("order {}; figure at zero spacing {}", order(setting), limit(setting))
}

/// For each target and cost, one sentence.
fn prices(analysis: &Analysis) -> Vec<String> {
    let each = |cost: Cost, target: f64, cheapest: &Cheapest| {
        format!("{} in {}: {}", percent(target), cost.name(), cheapest_words(analysis, cost, cheapest))
    };
    let both = analysis.targets.iter().flat_map(|target| {
        [
            each(Cost::CoreSeconds, target.error, &target.by_core_seconds),
            each(Cost::Pairs, target.error, &target.by_pairs),
        ]
    });
    both.collect()
}

fn cheapest_words(analysis: &Analysis, cost: Cost, cheapest: &Cheapest) -> String {
    let name = |setting: usize| &analysis.settings[setting].name;
    let how = |price: &ErrorCost| match price.known {
        Known::Measured => "by its coarsest run; a coarser one might do",
        Known::Interpolated => "interpolated between its runs",
        Known::Extrapolated => "an extrapolation beyond its finest run",
    };
    let words = |setting: usize, price: &ErrorCost| {
        format!(
            "{} at spacing {:.3e} m, {:.3e} {}, {}",
            name(setting),
            price.spacing,
            price.cost,
            cost.name(),
            how(price)
        )
    };
    if let Some((setting, price)) = cheapest.setting.zip(cheapest.price.as_ref()) {
        let measured = price.known == Known::Measured;
        let point = cheapest.point.filter(|_| !measured).and_then(|number| analysis.points.get(number - 1));
        let run = point.map_or(String::new(), |point| {
            let spent = point.cost(cost).unwrap_or(f64::NAN);
            format!("; the cheapest run that has it is point {} ({}), {spent:.3e}", point.number, name(point.setting))
        });
        return words(setting, price) + &run;
    }
    let smallest = analysis.smallest_error();
    let smallest = smallest.map_or("there are no errors".into(), |point| {
        format!("the smallest error is {} (point {})", percent(point.error.unwrap_or(f64::NAN)), point.number)
    });
    match &cheapest.guess {
        Some((setting, price)) => format!("no setting reaches it, {smallest}; {}", words(*setting, price)),
        None => format!("no setting reaches it, {smallest}"),
    }
}

fn figure(analysis: &Analysis, cost: Cost) -> TradeOff {
    let curves = analysis.settings.iter().enumerate().map(|(k, setting)| {
        let order = setting.order.as_ref().map_or(String::new(), |order| format!(" (order {:.1})", order.order));
        let points = analysis.curve(k, cost).1.iter().map(|step| (step.cost, step.error)).collect();
        Curve { label: setting.name.clone() + &order, points }
    });
    let front = analysis.points.iter().filter(|point| point.on_front(cost));
    let mut front: Vec<(f64, f64)> = front.filter_map(|point| point.cost(cost).zip(point.error)).collect();
    front.sort_by(|a, b| a.0.total_cmp(&b.0));
    TradeOff {
        title: analysis.title.clone(),
        cost: cost.name().into(),
        error: format!("error ({})", analysis.measure.describe()),
        curves: curves.collect(),
        front,
        targets: analysis.targets.iter().map(|target| (percent(target.error), target.error)).collect(),
    }
}
