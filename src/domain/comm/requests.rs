//! Pending requests, and futures that wait for them: polled by hand, at once or bit by bit.

use std::cell::Cell;
use std::task::{Context, Poll, Waker};

use mpi::ffi;

/// Bytes of a message at most: lengths are 32-bit numbers in MPI.
pub const PIECE: usize = 1 << 30;

/// Work with waits for other ranks, done at once.
pub fn now<T>(work: impl Future<Output = T>) -> T {
    match std::pin::pin!(work).poll(&mut Context::from_waker(Waker::noop())) {
        Poll::Ready(found) => found,
        Poll::Pending => unreachable!("waits end where nothing overlaps"),
    }
}

/// A request of its own; buffers in use by it must outlive it.
pub struct Request(pub ffi::MPI_Request);

impl Request {
    pub fn none() -> Self {
        // SAFETY: a constant of the MPI library.
        Self(unsafe { ffi::RSMPI_REQUEST_NULL })
    }

    pub fn is_done(&mut self) -> bool {
        let mut flag = 0;
        // SAFETY: the request is valid or null; null ones are done.
        unsafe { ffi::MPI_Test(&mut self.0, &mut flag, &mut std::mem::zeroed()) };
        flag != 0
    }
}

impl Drop for Request {
    fn drop(&mut self) {
        while !self.is_done() {}
    }
}

/// A pending reduction; the request is dropped first.
pub struct Reduction<T> {
    pub request: Request,
    pub mine: Vec<T>,
    pub all: Vec<T>,
}

/// A pending round of the sparse exchange; requests are dropped first.
pub struct Round {
    requests: Vec<Request>,
    barrier: Option<Request>,
    raw: ffi::MPI_Comm,
    tag: i32,
    /// Each message with its length, which is announced first.
    _outgoing: Vec<(Box<u64>, Vec<u64>)>,
}

impl Round {
    pub fn start(raw: ffi::MPI_Comm, sent: &Cell<u64>, messages: Vec<(usize, Vec<u64>)>, tag: i32) -> Self {
        let (mut requests, mut outgoing) = (Vec::new(), Vec::new());
        for (to, words) in messages {
            let header = Box::new(words.len() as u64);
            // SAFETY: a constant of the MPI library.
            let (to, byte, mut request) = (to as i32, unsafe { ffi::RSMPI_UINT8_T }, Request::none());
            // SAFETY: header and words stay where they are until the requests, which go before them, are done.
            unsafe { ffi::MPI_Issend((&raw const *header).cast(), 8, byte, to, tag, raw, &mut request.0) };
            requests.push(request);
            for piece in bytemuck::cast_slice::<u64, u8>(&words).chunks(PIECE) {
                let (from, length, mut request) = (piece.as_ptr().cast(), piece.len() as i32, Request::none());
                // SAFETY: as above.
                unsafe { ffi::MPI_Isend(from, length, byte, to, tag + 2, raw, &mut request.0) };
                requests.push(request);
                sent.set(sent.get() + piece.len() as u64);
            }
            outgoing.push((header, words));
        }
        Self { requests, barrier: None, raw, tag, _outgoing: outgoing }
    }

    /// Takes the messages that have arrived; whether the round is over.
    pub fn go_on(&mut self, received: &mut Vec<(usize, Vec<u64>)>) -> bool {
        while let Some(message) = self.next_message() {
            received.push(message);
        }
        match &mut self.barrier {
            Some(barrier) => barrier.is_done(),
            None => {
                if self.requests.iter_mut().all(Request::is_done) {
                    let barrier = self.barrier.insert(Request::none());
                    // SAFETY: the communicator is valid.
                    unsafe { ffi::MPI_Ibarrier(self.raw, &mut barrier.0) };
                }
                false
            }
        }
    }

    fn next_message(&self) -> Option<(usize, Vec<u64>)> {
        let (raw, tag) = (self.raw, self.tag);
        // SAFETY: a message whose header has come is received whole, into a buffer of the length that it announces.
        unsafe {
            let (mut flag, mut status) = (0, std::mem::zeroed::<ffi::MPI_Status>());
            ffi::MPI_Iprobe(ffi::RSMPI_ANY_SOURCE, tag, raw, &mut flag, &mut status);
            if flag == 0 {
                return None;
            }
            let (from, byte, mut header) = (status.MPI_SOURCE, ffi::RSMPI_UINT8_T, 0u64);
            ffi::MPI_Recv((&raw mut header).cast(), 8, byte, from, tag, raw, &mut status);
            let mut words = vec![0u64; header as usize];
            for piece in bytemuck::cast_slice_mut::<u64, u8>(&mut words).chunks_mut(PIECE) {
                let (to, length) = (piece.as_mut_ptr().cast(), piece.len() as i32);
                ffi::MPI_Recv(to, length, byte, from, tag + 2, raw, &mut status);
            }
            Some((from as usize, words))
        }
    }
}
