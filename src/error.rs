//! One error type: what went wrong, where, and what is allowed. It travels between ranks, so that all return it together.

use std::borrow::Cow;

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
    /// Whether the input is at fault, not the run itself: their exit codes differ.
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

/// Characters of each part of an error that are printed: what is wrong may quote a file that is no scene.
const LONGEST: usize = 2000;

/// One line, whatever it quotes.
impl std::fmt::Display for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let line = |text: &str| {
            let cut =
                text.char_indices().nth(LONGEST).map_or(text.to_string(), |(end, _)| format!("{} ...", &text[..end]));
            plain(&cut).replace('\n', "\\n")
        };
        if !self.place.is_empty() {
            write!(f, "{}: ", line(&self.place))?;
        }
        write!(f, "{}", line(&self.what))?;
        if !self.allowed.is_empty() {
            write!(f, " (allowed: {})", line(&self.allowed))?;
        }
        Ok(())
    }
}

/// Text as a terminal may get it: names and values of a scene come from anywhere, and characters that would move the cursor,
/// retitle the window or reverse lines are escaped, `\u{1b}`. Ends of lines stay.
pub fn plain(text: &str) -> Cow<'_, str> {
    let acts = |c: char| {
        let turns =
            matches!(c, '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{feff}');
        (c.is_control() || turns) && c != '\n'
    };
    if !text.contains(acts) {
        return Cow::Borrowed(text);
    }
    let spelt = |c: char| if acts(c) { c.escape_default().to_string() } else { c.to_string() };
    Cow::Owned(text.chars().map(spelt).collect())
}

impl std::error::Error for Error {}

impl From<std::io::Error> for Error {
    fn from(e: std::io::Error) -> Self {
        Error::new(e.to_string())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_that_a_terminal_acts_on_is_printed() {
        let error = Error::new("unknown key `\u{1b}[2J`").at("a\u{7}.toml:1").allowed("x\n\u{202e}y\u{9b}31m");
        assert_eq!(error.to_string(), r"a\u{7}.toml:1: unknown key `\u{1b}[2J` (allowed: x\n\u{202e}y\u{9b}31m)");
        assert_eq!(plain("Körper µ\nsecond line"), "Körper µ\nsecond line");
        assert!(Error::new("x".repeat(1 << 20)).to_string().len() < 2 * LONGEST);
    }
}
