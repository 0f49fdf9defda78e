pub mod domain;
pub mod error;
pub mod material;
pub mod math;
pub mod particles;
pub mod random;
pub mod units;
