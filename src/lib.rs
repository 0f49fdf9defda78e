pub mod error;
pub mod math;
pub mod particles;
pub mod random;
pub mod domain;
pub mod material;
pub mod neighbours;
