//! The gravity of bodies on each other by multipoles of cells on cells (Greengard and Rokhlin 1987, J. Comp. Phys. 73, 325; Dehnen
//! 2002, J. Comp. Phys. 179, 27), at a cost in proportion to their number.
//!
//! As in [`super`], all that decides about the result - root cube, cells, leaves, expansions, who sees whom as far, the order of
//! sums - follows from the set of bodies alone. Each branch of the tree belongs to one rank, which finds the sums at all bodies in
//! it, whoever owns these as particles; of remote branches it receives the parts that cells of its own branches can open.
//!
//! Cells act on each other in pairs with equal and opposite forces, so momentum is conserved to rounding.

pub mod bodies;
pub mod expansions;
pub mod indices;
pub mod loops;
pub mod octree;
pub mod opening;
pub mod solver;
pub mod walk;

pub use octree::Body;
pub use opening::Opening;
pub use solver::{Field, solve};
