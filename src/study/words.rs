//! A word of each point's summary, such as the outcome of a collision: its table is that of the points, and over a grid of two
//! things that are varied it has a map.

use serde::{Deserialize, Serialize};

use super::points::{Point, Study};
use super::record::Record;
use super::settings::{Axis, Change, Combine};
use crate::output::figures::map::{Side, WordMap};

/// A map as study.json keeps it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Words {
    /// What is varied, the first from left to right, the second from the bottom up.
    pub keys: [String; 2],
    pub values: [Vec<String>; 2],
    /// Row by row of the second one.
    pub cells: Vec<Vec<Option<String>>>,
}

impl Words {
    /// The map of a study that asks for a word and combines the values of two things, each at one resolution.
    pub fn of(study: &Study, records: &[Option<Record>]) -> Option<Self> {
        let (word, settings) = (study.settings.word.as_ref()?, &study.settings);
        let [x, y] = &settings.axes[..] else { return None };
        if settings.combine != Combine::Grid || settings.resolution.values.len() != 1 {
            return None;
        }
        let of = |a: usize, b: usize| {
            let wanted: Vec<String> = x.values[a].iter().chain(&y.values[b]).map(Change::text).collect();
            let is_it = |point: &&Point| wanted.iter().all(|change| point.overrides.contains(change));
            let point = study.points.iter().find(is_it)?;
            records[point.number - 1].as_ref()?.word(word).map(str::to_string)
        };
        let row = |b: usize| (0..x.values.len()).map(|a| of(a, b)).collect();
        let cells = (0..y.values.len()).map(row).collect();
        Some(Self { keys: [x, y].map(name), values: [x, y].map(values), cells })
    }

    pub fn figure(&self, title: &str) -> WordMap {
        let [x, y] = [0, 1].map(|side| Side { label: self.keys[side].clone(), values: self.values[side].clone() });
        WordMap { title: title.into(), x, y, cells: self.cells.clone() }
    }
}

/// What an axis is called: the table's name, or the last part of the key.
fn name(axis: &Axis) -> String {
    match axis.name.as_str() {
        "" => axis.values[0].iter().filter_map(|change| change.key.rsplit('.').next()).collect::<Vec<_>>().join(", "),
        name => name.replace('_', " "),
    }
}

fn values(axis: &Axis) -> Vec<String> {
    let text = |value: &toml::Value| value.as_str().map_or_else(|| value.to_string(), str::to_string);
    let of = |changes: &Vec<Change>| changes.first().map_or(String::new(), |change| text(&change.value));
    match axis.labels.is_empty() {
        true => axis.values.iter().map(of).collect(),
        false => axis.labels.clone(),
    }
}
