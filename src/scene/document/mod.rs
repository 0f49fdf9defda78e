//! The text of a scene: where it comes from, what the command line sets over it, where in it a key stands, and messages about keys.

pub mod input;
pub mod keys;
pub mod source;
