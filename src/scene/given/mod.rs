//! Bodies that come as particles from a file: the outcome of another run, or of another program. What a scene has to know of them
//! (mass, centre, shape, groups of equal particles) is gathered when it is read, by one process; the particles themselves stay in the
//! file, and every rank reads a share of its rows when the run starts.
//!
//! All particles of a body have one mass here. What a file brings is therefore sorted into groups of one mass and one origin, and each
//! group becomes a body of the scene, the way the parts of a refined target are.

pub mod choice;
pub mod file;
pub mod gather;
pub mod grid;
mod hdf5_file;
mod read;
mod text;

pub use choice::Keep;
pub use file::{Format, Label, ParticleFile, Rows};
pub use gather::{Gathered, Group, gather};
pub use hdf5_file::{FIELDS, labels};
