//! The search of a disruption threshold: impacts of one scene with projectiles of different sizes, until the size that leaves half
//! of the target is known.

pub mod bracket;
pub mod fit;
pub mod record;
pub mod search;
