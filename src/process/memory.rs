//! A failed allocation ends the job with one line. The program's allocator is otherwise the system's; without it a failed
//! allocation would end in an abort, of which MPI prints the stack.

use std::alloc::{GlobalAlloc, Layout, System};
use std::io::Write;
use std::sync::atomic::{AtomicBool, AtomicI32, AtomicUsize, Ordering};

/// Exit code of a run that failed while running.
const FAILED: libc::c_int = 1;

/// Number of this process among the ranks.
static RANK: AtomicUsize = AtomicUsize::new(0);
/// Descriptor of the open log, beside the terminal; -1 where none is.
static LOG: AtomicI32 = AtomicI32::new(-1);
/// Whether a thread has begun to report.
static REPORTED: AtomicBool = AtomicBool::new(false);

/// The system's allocator, whose failure ends the process.
pub struct Allocator;

// SAFETY: forwards everything to the system's allocator, and returns its result.
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

/// Sets the log in which the error is reported, too: its descriptor, or -1 where none is open.
pub fn report_to(log: i32) {
    LOG.store(log, Ordering::Relaxed);
}

/// Sets the number of this process among the ranks.
pub fn name_rank(rank: usize) {
    RANK.store(rank, Ordering::Relaxed);
}

/// Reports without allocating; the launcher then ends the other ranks, which cannot write a checkpoint.
#[cold]
fn end(bytes: usize) -> ! {
    if REPORTED.swap(true, Ordering::SeqCst) {
        loop {
            // SAFETY: waits for the thread that reports, which ends the process.
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
    // SAFETY: ends the process, without running anything that may allocate.
    unsafe { libc::_exit(FAILED) }
}
