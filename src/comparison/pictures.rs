//! Pictures of a comparison.

use std::path::Path;

/// Where pictures go, and the title that they get.
#[derive(Debug, Clone, Copy)]
pub struct Pictures<'a> {
    pub title: &'a str,
    pub directory: &'a Path,
}
