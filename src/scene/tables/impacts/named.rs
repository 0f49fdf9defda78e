//! Bodies that a table names.

use crate::error::Result;
use crate::scene::document::keys::unknown;
use crate::scene::document::source::Document;
use crate::scene::tables::body::validated::Body;

/// The number of the body of that name; `path` is the key that names it.
pub fn body(document: &Document, path: &str, name: &str, bodies: &[Body]) -> Result<usize> {
    bodies.iter().position(|body| body.name == name).ok_or_else(|| {
        let known: Vec<String> = bodies.iter().map(|body| body.name.clone()).collect();
        unknown(document, path, "body", name, &known)
    })
}
