//! The threads of one rank. Passes run over chunks of owned particles; each thread has one workspace that lives as long as
//! the run, so that a step allocates nothing. Chunks write only to their own particles: how they fall on threads leaves no
//! trace in the result.

use std::sync::Mutex;

use rayon::prelude::*;

use crate::error::{Error, Result};

/// Threads with a workspace each.
pub struct Workers<W> {
    pool: Option<rayon::ThreadPool>,
    workspaces: Vec<Mutex<W>>,
}

impl<W: Send> Workers<W> {
    pub fn new(threads: usize, workspace: impl Fn() -> W) -> Result<Self> {
        let pool = if threads > 1 {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
            Some(pool.map_err(|e| Error::new(format!("cannot start {threads} threads: {e}")))?)
        } else {
            None
        };
        Ok(Self { pool, workspaces: (0..threads.max(1)).map(|_| Mutex::new(workspace())).collect() })
    }

    pub fn threads(&self) -> usize {
        self.workspaces.len()
    }

    /// Runs `work` inside the pool, for code that uses rayon itself.
    pub fn install<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        match &self.pool {
            Some(pool) => pool.install(work),
            None => work(),
        }
    }

    /// `work(item, workspace)` for every item, in any order.
    pub fn each(&self, items: &[u32], work: impl Fn(usize, &mut W) + Sync) {
        match &self.pool {
            None => {
                let mut workspace = self.workspaces[0].lock().unwrap();
                items.iter().for_each(|&item| work(item as usize, &mut workspace));
            }
            Some(pool) => pool.install(|| {
                items.par_iter().with_max_len(1).for_each(|&item| {
                    let thread = rayon::current_thread_index().unwrap_or(0);
                    work(item as usize, &mut self.workspaces[thread].lock().unwrap());
                })
            }),
        }
    }

    /// Visits every workspace, in thread order, after a pass.
    pub fn collect(&self, mut visit: impl FnMut(&mut W)) {
        for workspace in &self.workspaces {
            visit(&mut workspace.lock().unwrap());
        }
    }
}

/// Cores this process may really run on: launchers pin ranks, and a pool larger than that only waits for itself.
pub fn usable_cores() -> usize {
    // SAFETY: `sched_getaffinity` fills the set it is given.
    unsafe {
        let mut set: libc::cpu_set_t = std::mem::zeroed();
        if libc::sched_getaffinity(0, std::mem::size_of::<libc::cpu_set_t>(), &mut set) == 0 {
            libc::CPU_COUNT(&set) as usize
        } else {
            std::thread::available_parallelism().map_or(1, |n| n.get())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicU64, Ordering};

    #[test]
    fn every_item_is_worked_on_once() {
        for threads in [1, 3] {
            let workers = Workers::new(threads, || 0u64).unwrap();
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
}
