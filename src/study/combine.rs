//! From values to settings: their combinations and names.

use toml::Value;

use super::settings::{Axis, Change, Combine, Settings};

/// A setting: its name and what it changes.
pub struct Setting {
    pub name: String,
    /// The name without radii of bodies: settings that differ in radii alone lie on one curve over the radius.
    pub family: String,
    pub changes: Vec<Change>,
}

/// All settings, in the order in which they are run.
pub fn combined(settings: &Settings) -> Vec<Setting> {
    let base = || Setting { name: String::new(), family: String::new(), changes: Vec::new() };
    let axis_family = |axis: usize, k: usize| {
        let is_radius = settings.axes[axis].values[k].iter().any(|change| change.key.ends_with(".radius"));
        if is_radius { String::new() } else { name(&settings.axes, axis, k) }
    };
    let mut found = match settings.combine {
        Combine::Grid => settings.axes.iter().enumerate().fold(vec![base()], |settings_so_far, (axis, values)| {
            let with = |setting: &Setting, k: usize| Setting {
                name: join(&setting.name, &name(&settings.axes, axis, k)),
                family: join(&setting.family, &axis_family(axis, k)),
                changes: setting.changes.iter().chain(&values.values[k]).cloned().collect(),
            };
            let each = settings_so_far.iter().flat_map(|setting| (0..values.values.len()).map(move |k| (setting, k)));
            each.map(|(setting, k)| with(setting, k)).collect()
        }),
        Combine::OneAtATime => {
            let each = settings.axes.iter().enumerate();
            let each = each.flat_map(|(axis, values)| (0..values.values.len()).map(move |k| (axis, k)));
            let alone = each.map(|(axis, k)| Setting {
                name: name(&settings.axes, axis, k),
                family: axis_family(axis, k),
                changes: settings.axes[axis].values[k].clone(),
            });
            std::iter::once(base()).chain(alone).collect()
        }
    };
    found.iter_mut().filter(|setting| setting.name.is_empty()).for_each(|setting| setting.name = "as the scene".into());
    found
}

fn join(a: &str, b: &str) -> String {
    if a.is_empty() || b.is_empty() { format!("{a}{b}") } else { format!("{a}, {b}") }
}

/// A value in few words: `wendland_c2`, `eta 1.4`, `no corrected_gradient`; of [study.together.NAME] `labels`, where it has
/// them. A key is named by its last part where no other axis ends alike.
fn name(axes: &[Axis], axis: usize, k: usize) -> String {
    if let Some(label) = axes[axis].labels.get(k) {
        return label.clone();
    }
    let last = |key: &str| key.rsplit('.').next().unwrap_or(key).to_string();
    let keys = |axis: &Axis| axis.values.first().into_iter().flatten().map(|c| last(&c.key)).collect::<Vec<_>>();
    let ambiguous =
        |key: &str| axes.iter().enumerate().any(|(other, values)| other != axis && keys(values).contains(&last(key)));
    let word = |change: &Change| {
        let key = if ambiguous(&change.key) { change.key.clone() } else { last(&change.key) };
        match &change.value {
            Value::Boolean(true) => key,
            Value::Boolean(false) => format!("no {key}"),
            Value::String(text) if text.starts_with(|c: char| c.is_alphabetic()) => text.clone(),
            Value::String(text) => format!("{key} {text}"),
            other => format!("{key} {other}"),
        }
    };
    axes[axis].values[k].iter().map(word).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::measure::{Against, Measure};

    fn settings(combine: Combine) -> Settings {
        let axis = |key: &str, values: &[Value]| Axis {
            name: String::new(),
            labels: Vec::new(),
            values: values
                .iter()
                .map(|value| vec![Change { key: key.into(), value: value.clone(), path: String::new() }])
                .collect(),
        };
        let (yes, no) = (Value::Boolean(true), Value::Boolean(false));
        Settings {
            title: String::new(),
            scene: String::new(),
            measure: Measure { figure: "errors.x".into(), against: Against::Exact },
            targets: Vec::new(),
            word: None,
            combine,
            set: Vec::new(),
            resolution: Axis::default(),
            axes: vec![
                axis("numerics.eta", &[Value::Float(1.2), Value::Float(1.4)]),
                axis("material.gas.viscosity", std::slice::from_ref(&no)),
                axis("numerics.viscosity", &[yes, no]),
            ],
        }
    }

    #[test]
    fn settings_combine_and_have_short_names() {
        let names = |combine| combined(&settings(combine)).into_iter().map(|setting| setting.name).collect::<Vec<_>>();
        let grid = names(Combine::Grid);
        assert_eq!(grid.len(), 4);
        // A key is named by its last part only where no other ends alike.
        assert_eq!(grid[0], "eta 1.2, no material.gas.viscosity, numerics.viscosity");
        assert_eq!(
            names(Combine::OneAtATime),
            [
                "as the scene",
                "eta 1.2",
                "eta 1.4",
                "no material.gas.viscosity",
                "numerics.viscosity",
                "no numerics.viscosity"
            ]
        );
    }
}
