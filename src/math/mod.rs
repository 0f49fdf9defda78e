//! Small vectors and tensors, vectors of eight lanes, sums that do not depend on order, straight lines.

pub mod exact_sum;
pub mod lanes;
pub mod line;
pub mod tensor;

pub use exact_sum::ExactSum;
pub use line::Line;
pub use tensor::{Deviator, Mat3, Sym, Vec3};
