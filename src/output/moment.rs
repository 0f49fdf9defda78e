//! Signals during a write, on demand, for tests of the files that remain. Costs one comparison per dataset.

use std::sync::atomic::{AtomicI32, Ordering};

/// Where in a write a signal may be raised.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Moment {
    /// A dataset has been made and its numbers are about to be written.
    Writing,
    /// The file is whole, on disk, and has a temporary name still.
    Written,
}

/// The signals to be raised, one per moment; zero is none.
static SIGNALS: [AtomicI32; 2] = [AtomicI32::new(0), AtomicI32::new(0)];

/// Makes this process raise `signal` when it next reaches that moment.
pub fn arm(moment: Moment, signal: i32) {
    SIGNALS[moment as usize].store(signal, Ordering::Relaxed);
}

pub(super) fn reach(moment: Moment) {
    if SIGNALS[moment as usize].load(Ordering::Relaxed) != 0 {
        // SAFETY: raises a signal in this process.
        unsafe { libc::raise(SIGNALS[moment as usize].swap(0, Ordering::Relaxed)) };
    }
}
