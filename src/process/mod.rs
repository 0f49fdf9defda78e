//! The program as a process among others: its log and signals, the machine's memory and cores, the directory of a run and its
//! lock, faults for tests.

pub mod directory;
pub mod faults;
pub mod lock;
pub mod log;
pub mod memory;
pub mod resources;
pub mod signals;
