//! Rigid bodies: their rotations ([`turning`]), the motion of one ([`body`]), and their particles ([`matter`]).

pub mod body;
pub mod matter;
pub mod turning;

pub use body::{Guidance, Load, RigidBody, RigidMotion, RigidRates};
pub use matter::{LoadSums, MovedColumns, RigidMatter, RigidStart};
