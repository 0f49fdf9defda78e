//! The threads of one rank. Passes run over chunks of owned particles; each thread has one workspace that lives as long as
//! the run, so that a step allocates nothing. Chunks write only to their own particles: their distribution over threads does not
//! change the result.

use std::sync::Mutex;

use rayon::prelude::*;

use crate::error::{Error, Result};

/// Makes the pool of this process: `threads` threads, the calling one among them. Once per process, before any work.
pub fn start_threads(threads: usize) -> Result<()> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).use_current_thread().build_global();
    pool.map_err(|e| Error::new(format!("cannot start {threads} threads: {e}")))
}

/// A workspace for each thread of the pool.
pub struct Workers<W> {
    workspaces: Vec<Mutex<W>>,
}

impl<W: Send> Workers<W> {
    pub fn new(workspace: impl Fn() -> W) -> Self {
        Self { workspaces: (0..rayon::current_num_threads()).map(|_| Mutex::new(workspace())).collect() }
    }

    pub fn threads(&self) -> usize {
        self.workspaces.len()
    }

    /// `work(item, workspace)` for every item, in any order.
    pub fn each(&self, items: &[u32], work: impl Fn(usize, &mut W) + Sync) {
        if self.threads() == 1 {
            let mut workspace = self.workspaces[0].lock().unwrap();
            items.iter().for_each(|&item| work(item as usize, &mut workspace));
        } else {
            items.par_iter().with_max_len(1).for_each(|&item| {
                let thread = rayon::current_thread_index().unwrap_or(0);
                work(item as usize, &mut self.workspaces[thread].lock().unwrap());
            });
        }
    }

    /// Visits every workspace, in thread order, after a pass.
    pub fn collect(&self, mut visit: impl FnMut(&mut W)) {
        for workspace in &self.workspaces {
            visit(&mut workspace.lock().unwrap());
        }
    }
}

/// The cores this process may really run on: launchers pin ranks, and a pool larger than that only waits.
fn affinity() -> libc::cpu_set_t {
    // SAFETY: `sched_getaffinity` fills the set it is given; where it fails the set stays empty.
    unsafe {
        let mut set: libc::cpu_set_t = std::mem::zeroed();
        libc::sched_getaffinity(0, std::mem::size_of::<libc::cpu_set_t>(), &mut set);
        set
    }
}

/// Number of cores this process may run on.
pub fn usable_cores() -> usize {
    // SAFETY: counts the bits of a set.
    let count = unsafe { libc::CPU_COUNT(&affinity()) } as usize;
    if count > 0 { count } else { std::thread::available_parallelism().map_or(1, |n| n.get()) }
}

/// A number that ranks of one host share if they may use the same cores.
pub fn affinity_key() -> u64 {
    let host = std::fs::read("/proc/sys/kernel/hostname").unwrap_or_default();
    let set = affinity();
    // SAFETY: reads of whether a core below the set's size is in it.
    let cores: Vec<u8> =
        (0..libc::CPU_SETSIZE as usize).map(|core| unsafe { libc::CPU_ISSET(core, &set) } as u8).collect();
    let hash = blake3::hash(&[host, cores].concat());
    u64::from_le_bytes(std::array::from_fn(|k| hash.as_bytes()[k]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicU64, Ordering};

    #[test]
    fn every_item_is_worked_on_once() {
        let workers = Workers::new(|| 0u64);
        let items: Vec<u32> = (0..1000).collect();
        let sum = AtomicU64::new(0);
        workers.each(&items, |item, count| {
            *count += 1;
            sum.fetch_add(item as u64, Ordering::Relaxed);
        });
        let mut visits = 0;
        workers.collect(|count| visits += *count);
        assert_eq!((visits, sum.into_inner()), (1000, 499_500));
    }
}
