//! The gravity of bodies on each other by multipoles of cells on cells (Greengard and Rokhlin 1987, J. Comp. Phys. 73, 325; Dehnen
//! 2002, J. Comp. Phys. 179, 27), at a cost in proportion to their number, in an octree that ranks share (Salmon and Warren 1994).
//!
//! Everything that determines the result - root cube, cells, leaves, expansions, which pairs are far, the order of sums -
//! follows from the set of bodies alone, so that fields have the same bits on any number of ranks:
//! - a cell of the global lattice is split where it holds more than [`octree::LEAF`] bodies, counted over all ranks;
//! - cells down to a size that suits the number of ranks form the *top*, which every rank knows; below each of its ends, a
//!   *branch*, all bodies go to one rank, which builds the branch with its bodies in canonical order and finds the sums at them,
//!   whichever rank owns them as particles;
//! - a rank receives of a remote branch the part that cells of its own branches can open, no more.
//!
//! Cells act on each other in pairs with equal and opposite forces, so momentum is conserved to rounding.
//!
//! Pair potential: a point mass spread over the cubic spline kernel, `h_ij = max(h_i, h_j)`, exactly Newtonian from
//! r = 2 h_ij on (Price and Monaghan 2007, MNRAS 374, appendix A). Cells are expanded only where no pair is softened.

pub mod bodies;
pub mod cells;
pub mod direct;
pub mod expansions;
pub mod indices;
pub mod loops;
pub mod octree;
pub mod opening;
pub mod solver;
pub mod top;
pub mod walk;

pub use direct::direct;
pub use octree::Body;
pub use opening::Opening;
pub use solver::{Field, solve, solve_later};
