//! Warnings about a scene, a run, a search or a study, which a user should know before trusting a result. All kinds are in one
//! list, which goes to the terminal and the log, to summary.json, and, by kind, to the last line of the output.

use serde::{Deserialize, Serialize};

/// One warning.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Warning {
    /// One word, for scripts: `energy`, `overlap` ...
    pub kind: String,
    /// One sentence: figures, and the change to make.
    pub text: String,
}

impl Warning {
    pub fn new(kind: &str, text: String) -> Self {
        Self { kind: kind.into(), text }
    }
}

/// One line each, on rank 0.
pub fn log(warnings: &[Warning], is_root: bool) {
    let logged = warnings.iter().filter(|_| is_root);
    logged.for_each(|warning| tracing::warn!("{}: {}", warning.kind, warning.text));
}

/// The end of a last line: empty, or `; 2 warnings: energy, density`.
pub fn in_short(warnings: &[Warning]) -> String {
    let s = if warnings.len() == 1 { "" } else { "s" };
    match warnings {
        [] => String::new(),
        _ => format!("; {} warning{s}: {}", warnings.len(), kinds(warnings).join(", ")),
    }
}

/// Each kind once, in the order of the list.
pub fn kinds(warnings: &[Warning]) -> Vec<&str> {
    let mut kinds: Vec<&str> = Vec::new();
    for warning in warnings {
        if !kinds.contains(&warning.kind.as_str()) {
            kinds.push(&warning.kind);
        }
    }
    kinds
}

/// The warnings of several runs as one list: the first of each kind, with the number of runs that have it. `what` and the number of
/// a run name it: `impact 3`.
pub fn merged<'a>(what: &str, runs: impl Iterator<Item = (usize, &'a [Warning])>) -> Vec<Warning> {
    let runs: Vec<(usize, &[Warning])> = runs.collect();
    let mut all: Vec<Warning> = Vec::new();
    for (number, warnings) in &runs {
        for warning in *warnings {
            if all.iter().any(|known| known.kind == warning.kind) {
                continue;
            }
            let having = runs.iter().filter(|(_, list)| list.iter().any(|other| other.kind == warning.kind)).count();
            let where_to = match having {
                1 => format!("{what} {number}"),
                _ => format!("{having} of {} {what}s, first {what} {number}", runs.len()),
            };
            all.push(Warning::new(&warning.kind, format!("{where_to}: {}", warning.text)));
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_are_texts_in_short_and_merged_by_kind() {
        let [a, b] = ["energy", "density"].map(|kind| Warning::new(kind, format!("{kind} is off")));
        assert_eq!(in_short(&[]), "");
        assert_eq!(in_short(std::slice::from_ref(&a)), "; 1 warning: energy");
        assert_eq!(in_short(&[a.clone(), b.clone(), a.clone()]), "; 3 warnings: energy, density");
        let runs: [&[Warning]; 3] = [&[], &[a.clone(), b], &[a]];
        let all = merged("impact", (1..).zip(runs));
        let texts: Vec<&str> = all.iter().map(|warning| warning.text.as_str()).collect();
        assert_eq!(texts, ["2 of 3 impacts, first impact 2: energy is off", "impact 2: density is off"]);
    }
}
