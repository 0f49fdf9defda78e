//! The geometry of bodies, which no table of a scene needs to know of: shapes, the lattices that fill them, piles of blocks, joints,
//! and the parts that a shape is cut into.

pub mod bounding_box;
pub mod compound;
pub mod cut;
pub mod joints;
pub mod lattice;
pub mod periods;
pub mod rubble;
pub mod shape;
pub mod voxels;
