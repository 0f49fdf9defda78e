//! Memory that is not to be had ends the job with one line. The program's allocator is the system's but for that; a failed
//! allocation would otherwise end in an abort, of which MPI prints the stack.

use std::alloc::{GlobalAlloc, Layout, System};
use std::io::Write;
use std::sync::atomic::{AtomicBool, AtomicI32, AtomicUsize, Ordering};

/// Exit code of a run that failed on its way.
const FAILED: libc::c_int = 1;

/// Number of this process among the ranks.
static RANK: AtomicUsize = AtomicUsize::new(0);
/// Descriptor of the open log, beside the terminal; -1 where none is.
static LOG: AtomicI32 = AtomicI32::new(-1);
/// Whether a thread has begun to tell.
static TOLD: AtomicBool = AtomicBool::new(false);

/// The system's allocator, whose failure ends the process.
pub struct Allocator;

// SAFETY: hands everything on to the system's allocator, and returns what that returns.
unsafe impl GlobalAlloc for Allocator {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: as promised by the caller.
        given(unsafe { System.alloc(layout) }, layout.size())
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: as promised by the caller.
        given(unsafe { System.alloc_zeroed(layout) }, layout.size())
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: as promised by the caller.
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // SAFETY: as promised by the caller.
        given(unsafe { System.realloc(pointer, layout, size) }, size)
    }
}

#[inline]
fn given(pointer: *mut u8, bytes: usize) -> *mut u8 {
    if pointer.is_null() {
        end(bytes);
    }
    pointer
}

/// The log in which the end is told, too: its descriptor, or -1 where none is open.
pub fn tell_in(log: i32) {
    LOG.store(log, Ordering::Relaxed);
}

/// As others should call this process.
pub fn name_rank(rank: usize) {
    RANK.store(rank, Ordering::Relaxed);
}

/// Tells without allocating; the launcher then ends the other ranks, which cannot be asked for a checkpoint.
#[cold]
fn end(bytes: usize) -> ! {
    if TOLD.swap(true, Ordering::SeqCst) {
        loop {
            // SAFETY: waits for the thread that tells, which ends the process.
            unsafe { libc::pause() };
        }
    }
    let mut line = [0u8; 256];
    let mut rest = &mut line[..];
    let rank = RANK.load(Ordering::Relaxed);
    let gigabytes = 1e-9 * bytes as f64;
    let _ = writeln!(
        rest,
        "error: rank {rank}: no memory for {gigabytes:.3} GB more (allowed: fewer particles, or more machines; --check \
         shows what takes the memory; --resume goes on from the last checkpoint)"
    );
    let left = rest.len();
    let length = line.len() - left;
    for file in [libc::STDERR_FILENO, LOG.load(Ordering::Relaxed)] {
        // SAFETY: writes from the line, to a file that is open or none.
        unsafe { libc::write(file, line.as_ptr().cast(), length) };
    }
    // SAFETY: ends the process, without running anything that may want memory.
    unsafe { libc::_exit(FAILED) }
}
