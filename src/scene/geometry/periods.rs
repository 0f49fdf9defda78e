//! Boxes that fill a period of space.

use crate::particles::Periods;

/// Share of a period by which a body may seem to miss its ends.
pub const TOUCHING: f64 = 1e-9;

/// Along which axes a box of this size (m) fills the period.
pub fn fills(periods: &Periods, size: [f64; 3]) -> [bool; 3] {
    std::array::from_fn(|k| periods.closed(k) && (size[k] - periods.length[k]).abs() <= TOUCHING * periods.length[k])
}
