//! Which particles of a file are taken.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::file::{Found, Rows};

/// Which particles of a file become the body.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Keep {
    /// All of them.
    #[default]
    All,
    /// Those of the largest remnant of an impact: the last snapshot of a run says which these are.
    LargestRemnant,
    /// Those that were matter of the body of this name, in a snapshot; or that have this word as their material, in another file.
    Body(String),
}

impl Keep {
    /// Whether a row is taken; `kind`: what the file calls the kind that is meant.
    pub fn takes(&self, rows: &Rows, row: usize, kinds: &[i64]) -> bool {
        match self {
            Keep::All => true,
            Keep::LargestRemnant => rows.in_largest.get(row).copied().unwrap_or(false),
            Keep::Body(_) => kinds.contains(&rows.kind(row)),
        }
    }

    /// What is missing in these rows to choose by.
    pub fn check(&self, rows: &Rows) -> Found<()> {
        match self {
            Keep::LargestRemnant if rows.in_largest.is_empty() => {
                Err("it does not say what the largest remnant is: the last snapshot of an impact does".into())
            }
            _ => Ok(()),
        }
    }
}
