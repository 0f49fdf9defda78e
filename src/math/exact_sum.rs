//! exact sums
pub struct ExactSum;
