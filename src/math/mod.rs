//! Small vectors and tensors, vectors of eight lanes, sums that do not depend on order.

pub mod exact_sum;
pub mod lanes;
pub mod tensor;

pub use exact_sum::ExactSum;
pub use tensor::{Deviator, Mat3, Sym, Vec3};
