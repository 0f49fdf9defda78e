//! Who owns which particles, and what crosses between ranks. Knows columns, no physics.

pub mod comm;
