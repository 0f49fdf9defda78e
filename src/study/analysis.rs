//! The results of a study: points with their errors and costs, orders and limits of settings, costs of errors. This
//! is study.json.

use serde::{Deserialize, Serialize};

use super::limit::{Limit, limit};
use super::measure::{Against, Measure, Sample};
use super::order::{Order, order};
use super::pareto::{ErrorCost, Step, beyond, first_within, front, price};
use super::points::Study;
use super::record::Record;
use super::settings::Change;
use super::thresholds;
use super::words::Words;
use crate::scene::answer::understood;
use crate::warning::{self, Warning};

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Analysis {
    pub title: String,
    pub version: String,
    /// File of the study.
    pub study: String,
    pub scene: BaseScene,
    pub measure: Measure,
    /// The body whose spacing counts.
    pub spacing_of: Option<String>,
    pub points: Vec<Found>,
    pub settings: Vec<Setting>,
    pub targets: Vec<Target>,
    /// The map of a word, where one is asked for and two things are varied.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub words: Option<Words>,
    /// Thresholds, where points are searches.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub thresholds: Vec<thresholds::Row>,
}

/// The scene that was studied.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BaseScene {
    pub path: String,
    /// `[study.set]`, as after `--set`: a part of the problem, which `--accuracy` does not change.
    pub set: Vec<String>,
    /// Identity of the first point, hashed and in full: a scene is the same if it gives this with that point's settings.
    pub identity: String,
    pub understood: String,
}

/// A point and its result.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Found {
    pub number: usize,
    pub setting: usize,
    /// As after `--set`.
    pub overrides: Vec<String>,
    pub identity: String,
    /// m
    pub spacing: f64,
    /// Why it has no result; empty where it has one.
    pub failed: String,
    pub figure: Option<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub word: Option<String>,
    pub error: Option<f64>,
    pub particles: Option<f64>,
    pub steps: Option<f64>,
    pub pair_interactions: Option<f64>,
    pub core_seconds: Option<f64>,
    pub wall_seconds: Option<f64>,
    /// Whether no other point is both better and cheaper, by either cost.
    pub on_front_of_core_seconds: bool,
    pub on_front_of_pairs: bool,
    pub state_hash: String,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub warnings: Vec<Warning>,
}

/// A setting over all its resolutions.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Setting {
    pub name: String,
    pub order: Option<Order>,
    /// Limit of the figure at zero spacing.
    pub limit: Option<Limit>,
}

/// The cost of an error.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Target {
    pub error: f64,
    pub by_core_seconds: Cheapest,
    pub by_pairs: Cheapest,
}

/// The cheapest ways to an error by one of the costs.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Cheapest {
    /// Setting and price, where a setting reaches the error within the study.
    pub setting: Option<usize>,
    pub price: Option<ErrorCost>,
    /// The cheapest run that has it.
    pub point: Option<usize>,
    /// Setting and price by extrapolation, where none reaches it and one is in its asymptotic range.
    pub guess: Option<(usize, ErrorCost)>,
}

/// The measures of cost.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cost {
    CoreSeconds,
    /// Does not depend on the machine.
    Pairs,
}

impl Cost {
    pub const fn name(self) -> &'static str {
        match self {
            Cost::CoreSeconds => "core-seconds",
            Cost::Pairs => "pair interactions",
        }
    }
}

impl Found {
    pub fn cost(&self, cost: Cost) -> Option<f64> {
        match cost {
            Cost::CoreSeconds => self.core_seconds,
            Cost::Pairs => self.pair_interactions,
        }
    }

    pub fn on_front(&self, cost: Cost) -> bool {
        match cost {
            Cost::CoreSeconds => self.on_front_of_core_seconds,
            Cost::Pairs => self.on_front_of_pairs,
        }
    }
}

impl Analysis {
    /// Warnings of all points, each kind once.
    pub fn warnings(&self) -> Vec<Warning> {
        warning::merged("point", self.points.iter().map(|point| (point.number, point.warnings.as_slice())))
    }

    pub fn new(study: &Study, records: &[Option<Record>]) -> Self {
        let measure = &study.settings.measure;
        let figure = |k: usize, name: &str| records[k].as_ref().and_then(|record| record.figure(name));
        let word = |k: usize| records[k].as_ref()?.word(study.settings.word.as_ref()?).map(str::to_string);
        let samples: Vec<Option<Sample>> = (0..study.points.len())
            .map(|k| {
                let (spacing, pairs) = (study.points[k].spacing, figure(k, "pair_interactions"));
                Some(Sample { figure: figure(k, &measure.figure)?, spacing, pair_interactions: pairs? })
            })
            .collect();
        let errors = measure.errors(&samples);
        let points = study.points.iter().enumerate().map(|(k, point)| Found {
            number: point.number,
            setting: point.setting,
            overrides: point.overrides.clone(),
            identity: point.identity.clone(),
            spacing: point.spacing,
            failed: records[k].as_ref().map_or("not run".into(), |record| record.failed.clone()),
            figure: figure(k, &measure.figure),
            word: word(k),
            error: errors[k],
            particles: figure(k, "particles"),
            steps: figure(k, "steps"),
            pair_interactions: figure(k, "pair_interactions"),
            core_seconds: figure(k, "core_seconds"),
            wall_seconds: figure(k, "wall_seconds"),
            on_front_of_core_seconds: false,
            on_front_of_pairs: false,
            state_hash: records[k].as_ref().map_or(String::new(), |record| record.state_hash.clone()),
            warnings: records[k].as_ref().map_or(Vec::new(), |record| record.warnings.clone()),
        });
        let first = &study.points[0];
        let mut found = Self {
            title: study.settings.title.clone(),
            version: env!("CARGO_PKG_VERSION").to_string(),
            study: study.path.clone(),
            scene: BaseScene {
                path: study.scene_path.clone(),
                set: study.settings.set.iter().map(Change::text).collect(),
                identity: first.identity.clone(),
                understood: understood(&first.scene.to_toml()).to_string(),
            },
            measure: measure.clone(),
            spacing_of: study.spacing_of.clone(),
            points: points.collect(),
            settings: Vec::new(),
            targets: Vec::new(),
            words: Words::of(study, records),
            thresholds: thresholds::rows(study, records),
        };
        found.mark_fronts();
        found.settings = study.names.iter().enumerate().map(|(k, name)| found.setting(k, name)).collect();
        found.targets = study.settings.targets.iter().map(|error| found.target(*error)).collect();
        found
    }

    fn mark_fronts(&mut self) {
        for cost in [Cost::CoreSeconds, Cost::Pairs] {
            let points: Vec<_> = self.points.iter().map(|point| point.cost(cost).zip(point.error)).collect();
            for k in front(&points) {
                match cost {
                    Cost::CoreSeconds => self.points[k].on_front_of_core_seconds = true,
                    Cost::Pairs => self.points[k].on_front_of_pairs = true,
                }
            }
        }
    }

    /// Points of a setting, from coarse to fine.
    pub fn of_setting(&self, setting: usize) -> impl Iterator<Item = &Found> {
        self.points.iter().filter(move |point| point.setting == setting)
    }

    fn setting(&self, number: usize, name: &str) -> Setting {
        let errors: Vec<_> = self.of_setting(number).filter_map(|point| Some((point.spacing, point.error?))).collect();
        let figures: Vec<_> =
            self.of_setting(number).filter_map(|point| Some((point.spacing, point.figure?))).collect();
        let (mut order, limit) = (order(&errors), limit(&figures));
        // A straight line in logarithms ends at zero; where errors do not, its slope is not an order.
        let floor = limit.as_ref().filter(|limit| self.measure.against == Against::Exact && limit.order.is_some());
        if let (Some(order), Some(floor)) = (&mut order, floor.filter(|f| f.value.abs() > 2.0 * f.uncertainty))
            && order.doubt.is_empty()
        {
            order.doubt = format!("errors settle at {:.1e}, not at zero", floor.value.abs());
        }
        Setting { name: name.into(), order, limit }
    }

    /// Points of a setting that have an error, and their steps along its curve.
    pub fn curve(&self, setting: usize, cost: Cost) -> (Vec<&Found>, Vec<Step>) {
        let step = |point: &Found| Some(Step { spacing: point.spacing, error: point.error?, cost: point.cost(cost)? });
        self.of_setting(setting).filter_map(|point| Some((point, step(point)?))).unzip()
    }

    fn target(&self, error: f64) -> Target {
        let by = |cost: Cost| {
            let priced = (0..self.settings.len()).filter_map(|k| Some((k, price(&self.curve(k, cost).1, error)?)));
            let cheapest = priced.min_by(|a, b| a.1.cost.total_cmp(&b.1.cost));
            Cheapest {
                setting: cheapest.map(|(setting, _)| setting),
                price: cheapest.map(|(_, price)| price),
                point: self.cheapest_point(error, cost).map(|point| point.number),
                guess: if cheapest.is_none() { self.guess(error, cost) } else { None },
            }
        };
        Target { error, by_core_seconds: by(Cost::CoreSeconds), by_pairs: by(Cost::Pairs) }
    }

    /// The cheapest run within an error whose finer ones are within it too.
    pub fn cheapest_point(&self, error: f64, cost: Cost) -> Option<&Found> {
        let within = |k: usize| {
            let (points, steps) = self.curve(k, cost);
            let first = first_within(&steps, error)?;
            // A finer run may have been cheaper, on another number of cores.
            (first..steps.len())
                .min_by(|&a, &b| steps[a].cost.total_cmp(&steps[b].cost))
                .map(|best| (points[best], steps[best]))
        };
        let each = (0..self.settings.len()).filter_map(within);
        each.min_by(|a, b| a.1.cost.total_cmp(&b.1.cost)).map(|(point, _)| point)
    }

    fn guess(&self, error: f64, cost: Cost) -> Option<(usize, ErrorCost)> {
        let one = |(k, setting): (usize, &Setting)| {
            let order = setting.order.as_ref().filter(|order| order.doubt.is_empty())?;
            Some((k, beyond(&self.curve(k, cost).1, error, order.order)?))
        };
        let each = self.settings.iter().enumerate().filter_map(one);
        each.min_by(|a, b| a.1.cost.total_cmp(&b.1.cost))
    }

    /// The smallest error that any setting ends with.
    pub fn smallest_error(&self) -> Option<&Found> {
        let there = self.points.iter().filter(|point| point.error.is_some());
        there.min_by(|a, b| a.error.unwrap_or(f64::INFINITY).total_cmp(&b.error.unwrap_or(f64::INFINITY)))
    }
}
