//! Processor time and memory of this rank, and the memory of the machine.

use std::path::Path;

/// User and system time of all threads of this process, s.
pub fn cpu_seconds() -> f64 {
    // SAFETY: `getrusage` fills the structure it is given.
    let usage = unsafe {
        let mut usage: libc::rusage = std::mem::zeroed();
        libc::getrusage(libc::RUSAGE_SELF, &mut usage);
        usage
    };
    let seconds = |t: libc::timeval| t.tv_sec as f64 + 1e-6 * t.tv_usec as f64;
    seconds(usage.ru_utime) + seconds(usage.ru_stime)
}

/// A line of a file below /proc in bytes; zero where it is missing.
fn proc_bytes(file: &str, key: &str) -> f64 {
    let text = std::fs::read_to_string(Path::new("/proc").join(file)).unwrap_or_default();
    let line = text.lines().find(|line| line.starts_with(key)).unwrap_or_default();
    line.split_whitespace().nth(1).and_then(|kib| kib.parse::<f64>().ok()).map_or(0.0, |kib| 1024.0 * kib)
}

/// Resident set now, bytes.
pub fn resident_bytes() -> f64 {
    proc_bytes("self/status", "VmRSS:")
}

/// Largest resident set so far, bytes.
pub fn peak_resident_bytes() -> f64 {
    proc_bytes("self/status", "VmHWM:")
}

/// Memory available to programs on this machine, bytes; zero where it is unknown.
pub fn available_bytes() -> f64 {
    proc_bytes("meminfo", "MemAvailable:")
}

/// A number that the ranks of one machine share.
pub fn machine() -> u64 {
    let boot = std::fs::read("/proc/sys/kernel/random/boot_id").unwrap_or_default();
    u64::from_le_bytes(std::array::from_fn(|k| blake3::hash(&boot).as_bytes()[k]))
}

/// Larger arrays are returned to the system at once, bytes: with many particles they would be too large to keep.
#[cfg(target_env = "gnu")]
const LARGE: libc::c_int = 1 << 22;

/// Keeps freed memory for later arrays, but for the largest ones: fresh pages from the system at each
/// list build would cost a tenth of all time.
pub fn hold_memory() {
    #[cfg(target_env = "gnu")]
    // SAFETY: sets parameters of the allocator, before there are threads.
    unsafe {
        libc::mallopt(libc::M_MMAP_THRESHOLD, LARGE);
        libc::mallopt(libc::M_TRIM_THRESHOLD, libc::c_int::MAX);
    }
}

/// Returns free memory to the system, for work that needs arrays of its own.
pub fn give_memory_back() {
    #[cfg(target_env = "gnu")]
    // SAFETY: touches nothing that is in use.
    unsafe {
        libc::malloc_trim(0);
    }
}
