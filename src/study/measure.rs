//! The error of a run: a figure of its summary and its reference.

use serde::{Deserialize, Serialize};

/// The error that a study measures.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Measure {
    /// Dotted key of summary.json.
    pub figure: String,
    pub against: Against,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Against {
    /// The exact solution: the figure is the error.
    Exact,
    /// A value from elsewhere, SI, and how uncertain it is.
    Value { value: f64, uncertainty: f64 },
    /// The figure of the run with the smallest spacing; among several, with the most pair interactions.
    Finest,
    /// No reference: the figure itself is the result.
    Nothing,
}

/// The values of a finished run on which its error depends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    pub figure: f64,
    /// m
    pub spacing: f64,
    pub pair_interactions: f64,
}

impl Measure {
    /// Relative error of each run; `None` for one that failed, and for the reference.
    pub fn errors(&self, runs: &[Option<Sample>]) -> Vec<Option<f64>> {
        let finest = self.finest(runs);
        let error = |(k, run): (usize, &Option<Sample>)| {
            let figure = (*run)?.figure;
            let error = match self.against {
                Against::Exact => figure.abs(),
                Against::Value { value, .. } => (figure / value - 1.0).abs(),
                Against::Nothing => return None,
                Against::Finest if finest == Some(k) => return None,
                Against::Finest => (figure / runs[finest?]?.figure - 1.0).abs(),
            };
            error.is_finite().then_some(error)
        };
        runs.iter().enumerate().map(error).collect()
    }

    /// The run that is the reference of the others, where one is.
    pub fn finest(&self, runs: &[Option<Sample>]) -> Option<usize> {
        let there = runs.iter().enumerate().filter_map(|(k, run)| Some((k, (*run)?)));
        let order = |a: &Sample, b: &Sample| {
            b.spacing.total_cmp(&a.spacing).then(a.pair_interactions.total_cmp(&b.pair_interactions))
        };
        match self.against {
            Against::Finest => there.max_by(|(_, a), (_, b)| order(a, b)).map(|(k, _)| k),
            _ => None,
        }
    }

    /// The relative error below which the reference is too uncertain.
    pub fn floor(&self) -> f64 {
        match self.against {
            Against::Value { value, uncertainty } => uncertainty / value.abs(),
            _ => 0.0,
        }
    }

    /// The measure in words.
    pub fn describe(&self) -> String {
        match self.against {
            Against::Exact => format!("{} against the exact solution", self.figure),
            Against::Value { value, uncertainty: 0.0 } => format!("{} against {value}", self.figure),
            Against::Value { value, uncertainty } => format!("{} against {value} ± {uncertainty}", self.figure),
            Against::Finest => format!("{} against the finest run", self.figure),
            Against::Nothing => self.figure.clone(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(figure: f64, spacing: f64, pairs: f64) -> Option<Sample> {
        Some(Sample { figure, spacing, pair_interactions: pairs })
    }

    #[test]
    fn errors_are_relative_to_what_is_asked() {
        let runs = [sample(-0.02, 2.0, 10.0), None, sample(0.01, 1.0, 40.0), sample(0.0125, 1.0, 20.0)];
        let errors = |against| Measure { figure: "errors.x".into(), against }.errors(&runs);
        assert_eq!(errors(Against::Exact), [Some(0.02), None, Some(0.01), Some(0.0125)]);
        assert_eq!(errors(Against::Value { value: 0.01, uncertainty: 0.0 }), [Some(3.0), None, Some(0.0), Some(0.25)]);
        // Of two at the smallest spacing, the one that took more pairs is the reference.
        assert_eq!(errors(Against::Finest), [Some(3.0), None, None, Some(0.25)]);
    }
}
