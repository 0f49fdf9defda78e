//! Distribution of particles over ranks, and communication between these. Knows columns, no physics.

pub mod bisection;
pub mod closing;
pub mod comm;
pub mod decomposition;
pub mod ghosts;
pub mod migration;
mod velocities;
pub mod watch;

pub use bisection::Bisection;
pub use closing::{Closing, Moving};
pub use comm::{Comm, Exchange, Network};
pub use decomposition::{Basis, Decomposition, Handles, Space};
pub use ghosts::{Ghosts, SomeGhosts, Territory};
pub use velocities::relative;
pub use watch::{Displacements, Watch};
