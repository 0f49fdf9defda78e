//! One error type: what went wrong, where, and what is allowed. It travels between ranks, so that all return it together.

use serde::{Deserialize, Serialize};

/// An error for the person at the terminal.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Error {
    /// What is wrong, with the value found.
    pub what: String,
    /// File, key, particle or rank where it was found; empty when nothing narrower than the run can be named.
    pub place: String,
    /// What is allowed instead; empty when there is nothing to choose from.
    pub allowed: String,
    /// Whether what was asked for is at fault, not the run on its way: the exit code tells them apart.
    pub bad_input: bool,
}

pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    pub fn new(what: impl Into<String>) -> Self {
        Self { what: what.into(), place: String::new(), allowed: String::new(), bad_input: false }
    }

    pub fn at(mut self, place: impl Into<String>) -> Self {
        self.place = place.into();
        self
    }

    pub fn allowed(mut self, allowed: impl Into<String>) -> Self {
        self.allowed = allowed.into();
        self
    }

    pub fn bad_input(mut self) -> Self {
        self.bad_input = true;
        self
    }
}

impl std::fmt::Display for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if !self.place.is_empty() {
            write!(f, "{}: ", self.place)?;
        }
        write!(f, "{}", self.what)?;
        if !self.allowed.is_empty() {
            write!(f, " (allowed: {})", self.allowed)?;
        }
        Ok(())
    }
}

impl std::error::Error for Error {}

impl From<std::io::Error> for Error {
    fn from(e: std::io::Error) -> Self {
        Error::new(e.to_string())
    }
}
