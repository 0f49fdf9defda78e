//! Work that continues while a rank does something else: its waits are those of futures, which are polled by hand.

use std::pin::Pin;
use std::task::{Context, Poll, Waker};

use super::Comm;
use super::requests::now;

/// Work with waits for other ranks that continues bit by bit, while this rank does something else. All ranks have the same work
/// pending, one at a time, and no other reductions or sparse exchanges until it is finished.
pub struct Overlapped<'a, T> {
    comm: &'a Comm,
    work: Pin<Box<dyn Future<Output = T> + 'a>>,
    found: Option<T>,
}

impl<'a, T> Overlapped<'a, T> {
    pub fn new(comm: &'a Comm, work: impl Future<Output = T> + 'a) -> Self {
        Self { comm, work: Box::pin(work), found: None }
    }

    /// Continues as far as messages have arrived.
    pub fn go_on(&mut self) {
        if self.found.is_none() {
            self.comm.overlaps.set(true);
            if let Poll::Ready(found) = self.work.as_mut().poll(&mut Context::from_waker(Waker::noop())) {
                self.found = Some(found);
            }
            self.comm.overlaps.set(false);
        }
    }

    /// Waits for the rest.
    pub fn finish(self) -> T {
        self.found.unwrap_or_else(|| now(self.work))
    }
}
