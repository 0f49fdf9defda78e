//! What the run costs: processor time and memory of this rank.

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

/// A line of /proc/self/status in bytes; zero where it is missing.
fn status_bytes(key: &str) -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|line| line.starts_with(key)).unwrap_or_default();
    line.split_whitespace().nth(1).and_then(|kib| kib.parse::<f64>().ok()).map_or(0.0, |kib| 1024.0 * kib)
}

/// Resident set now, bytes.
pub fn resident_bytes() -> f64 {
    status_bytes("VmRSS:")
}

/// Largest resident set so far, bytes.
pub fn peak_resident_bytes() -> f64 {
    status_bytes("VmHWM:")
}
