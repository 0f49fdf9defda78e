//! SIGTERM and SIGUSR1 ask for a checkpoint at the end of the step and a clean exit; a second one is not waited for. A file
//! that grows beyond what the shell allows is an error like a full disk, not the end of the process.

use std::sync::atomic::{AtomicU32, Ordering};

static ASKED: AtomicU32 = AtomicU32::new(0);

extern "C" fn ask(signal: libc::c_int) {
    ASKED.store(signal as u32, Ordering::Relaxed);
}

/// Installs the handlers.
pub fn listen() {
    for signal in [libc::SIGTERM, libc::SIGUSR1] {
        // SAFETY: the handler only stores to an atomic.
        unsafe { libc::signal(signal, ask as *const () as libc::sighandler_t) };
    }
    // SAFETY: what is ignored runs nothing.
    unsafe { libc::signal(libc::SIGXFSZ, libc::SIG_IGN) };
}

/// The signal that came, or zero.
pub fn asked() -> u32 {
    ASKED.load(Ordering::Relaxed)
}
