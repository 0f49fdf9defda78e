//! The only module that names MPI. Ranks communicate through a few operations; all irregular messages go through one sparse
//! exchange. Minima, maxima and integer sums are the only reductions: no order of arrival can change them.

use crate::math::ExactSum;
use std::cell::{Cell, RefCell};
use std::ffi::{CStr, CString};
use std::io::Write;
use std::sync::atomic::{AtomicBool, Ordering};
use std::task::{Context, Poll};
use std::time::Instant;

use bytemuck::Pod;
use mpi::ffi;
use mpi::raw::AsRaw;
use mpi::traits::*;

mod overlap;
mod requests;

pub use overlap::Overlapped;
pub use requests::now;
use requests::{PIECE, Reduction, Request, Round};

/// Tags of persistent exchanges; MPI grants at least 32767.
const FIRST_EXCHANGE_TAG: i32 = 1000;
const EXCHANGE_TAGS: i32 = 10_000;

/// Round trips that measure the network.
const TRIP_TAG: i32 = 99;
const LONG_MESSAGE: usize = 1 << 20;

/// Characters of a hint's key or value, with a NUL, in any MPI.
const LONGEST_HINT: usize = 1025;

/// What messages between two ranks take.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Network {
    /// s for a short one.
    pub latency: f64,
    /// bytes/s of long ones.
    pub bandwidth: f64,
}

/// All ranks of the job, or one of them alone.
pub struct Comm {
    universe: Option<mpi::environment::Universe>,
    raw: ffi::MPI_Comm,
    rank: usize,
    size: usize,
    round: Cell<i32>,
    /// Exchanges made so far: each gets a tag of its own.
    exchanges: Cell<i32>,
    waited: Cell<f64>,
    waited_cpu: Cell<f64>,
    sent: Cell<u64>,
    /// Whether waits return at once, as [`Overlapped`] continues the work later.
    overlaps: Cell<bool>,
    /// This rank's contribution to a reduction; kept, as steps do not allocate.
    mine: RefCell<Vec<u64>>,
    /// Hints for files; null where there are none.
    file_hints: Cell<ffi::MPI_Info>,
}

static ABORT_ON_PANIC: AtomicBool = AtomicBool::new(false);

impl Comm {
    /// Initialises MPI and makes a panic on any thread of any rank end the whole job.
    pub fn start() -> Self {
        let (universe, _level) =
            mpi::initialize_with_threading(mpi::Threading::Funneled).expect("MPI is initialised once");
        let world = universe.world();
        let (rank, size) = (world.rank() as usize, world.size() as usize);
        let raw = world.as_raw();
        if size > 1 && !ABORT_ON_PANIC.swap(true, Ordering::SeqCst) {
            let default = std::panic::take_hook();
            std::panic::set_hook(Box::new(move |info| {
                default(info);
                // If stderr is closed, the job must end all the same.
                let _ = writeln!(std::io::stderr(), "rank {rank} panicked: the job ends");
                // SAFETY: MPI is initialised; MPI_Abort may be called from any state and does not return.
                unsafe { ffi::MPI_Abort(ffi::RSMPI_COMM_WORLD, 101) };
            }));
        }
        Self::over(raw, rank, size, Some(universe))
    }

    /// This rank alone, for work without the others.
    pub fn alone(&self) -> Self {
        // SAFETY: a constant of the MPI library.
        Self::over(unsafe { ffi::RSMPI_COMM_SELF }, 0, 1, None)
    }

    fn over(raw: ffi::MPI_Comm, rank: usize, size: usize, universe: Option<mpi::environment::Universe>) -> Self {
        Self {
            universe,
            raw,
            rank,
            size,
            round: Cell::new(0),
            exchanges: Cell::new(0),
            waited: Cell::new(0.0),
            waited_cpu: Cell::new(0.0),
            sent: Cell::new(0),
            overlaps: Cell::new(false),
            mine: RefCell::new(Vec::new()),
            // SAFETY: a constant of the MPI library.
            file_hints: Cell::new(unsafe { ffi::RSMPI_INFO_NULL }),
        }
    }

    pub fn rank(&self) -> usize {
        self.rank
    }

    pub fn size(&self) -> usize {
        self.size
    }

    /// This rank's share of things that are numbered below `count`: together the ranks have all of them, in the order of ranks.
    pub fn share(&self, count: u64) -> std::ops::Range<u64> {
        let part = |rank: usize| (count as u128 * rank as u128 / self.size() as u128) as u64;
        part(self.rank())..part(self.rank() + 1)
    }

    pub fn is_root(&self) -> bool {
        self.rank == 0
    }

    /// The handle of the communicator for libraries written in C.
    pub fn raw(&self) -> ffi::MPI_Comm {
        self.raw
    }

    /// Hints for files that are opened from now on, as (key, value), in place of those given before. Keys of up to 35
    /// characters, values of up to 255, none empty and none with a NUL: what every MPI takes.
    pub fn set_file_hints<'h>(&self, hints: impl IntoIterator<Item = (&'h str, &'h str)>) {
        self.free_file_hints();
        let mut hints = hints.into_iter().peekable();
        if hints.peek().is_none() {
            return;
        }
        let text = |text: &str| CString::new(text).expect("hints hold no NUL");
        // SAFETY: MPI is initialised, and copies both texts.
        unsafe {
            let mut info = ffi::RSMPI_INFO_NULL;
            ffi::MPI_Info_create(&mut info);
            for (key, value) in hints {
                ffi::MPI_Info_set(info, text(key).as_ptr(), text(value).as_ptr());
            }
            self.file_hints.set(info);
        }
    }

    fn free_file_hints(&self) {
        // SAFETY: the object was made by `set_file_hints`, and is forgotten here.
        unsafe {
            if self.file_hints.get() != ffi::RSMPI_INFO_NULL {
                ffi::MPI_Info_free(self.file_hints.as_ptr());
                self.file_hints.set(ffi::RSMPI_INFO_NULL);
            }
        }
    }

    /// The handle of the hints for libraries written in C; `None` where none are set.
    pub fn raw_file_hints(&self) -> Option<ffi::MPI_Info> {
        let info = self.file_hints.get();
        // SAFETY: a constant of the MPI library.
        (info != unsafe { ffi::RSMPI_INFO_NULL }).then_some(info)
    }

    /// The hints with which MPI has opened a file, as (key, value): those it was given and knows, and its own.
    ///
    /// # Safety
    /// `file` must point to the open `MPI_File` of a library written in C.
    pub unsafe fn hints_of_file(&self, file: *const std::ffi::c_void) -> Vec<(String, String)> {
        // SAFETY: `file` is as promised; the buffers are as long as the sizes given to MPI, with room for a last NUL.
        unsafe {
            let mut info = ffi::RSMPI_INFO_NULL;
            ffi::MPI_File_get_info(*file.cast::<ffi::MPI_File>(), &mut info);
            let mut count = 0;
            ffi::MPI_Info_get_nkeys(info, &mut count);
            let mut hints = Vec::new();
            for number in 0..count {
                let (mut key, mut value, mut found) = ([0; LONGEST_HINT], [0; LONGEST_HINT], 0);
                ffi::MPI_Info_get_nthkey(info, number, key.as_mut_ptr());
                ffi::MPI_Info_get(info, key.as_ptr(), LONGEST_HINT as i32 - 1, value.as_mut_ptr(), &mut found);
                let text = |from: &[std::ffi::c_char]| CStr::from_ptr(from.as_ptr()).to_string_lossy().into_owned();
                hints.push((text(&key), text(&value)));
            }
            ffi::MPI_Info_free(&mut info);
            hints
        }
    }

    /// Ends the job on all ranks at once.
    pub fn abort(&self, code: i32) -> ! {
        // SAFETY: ends the process.
        unsafe { ffi::MPI_Abort(self.raw, code) };
        std::process::exit(code)
    }

    /// Seconds this rank has spent waiting for others so far.
    pub fn wait_seconds(&self) -> f64 {
        self.waited.get()
    }

    /// Processor time of those waits, s: they spin where there are cores enough, and yield where there are not.
    pub fn wait_cpu_seconds(&self) -> f64 {
        self.waited_cpu.get()
    }

    /// Bytes this rank has sent point to point so far.
    pub fn bytes_sent(&self) -> u64 {
        self.sent.get()
    }

    fn waiting<T>(&self, f: impl FnOnce() -> T) -> T {
        let (start, cpu) = (Instant::now(), thread_cpu_seconds());
        let out = f();
        self.waited.set(self.waited.get() + start.elapsed().as_secs_f64());
        self.waited_cpu.set(self.waited_cpu.get() + thread_cpu_seconds() - cpu);
        out
    }

    pub fn barrier(&self) {
        // SAFETY: the communicator is valid for the life of `self`.
        self.waiting(|| unsafe { ffi::MPI_Barrier(self.raw) });
    }

    /// Element-wise minimum over ranks, in place. NaN does not survive: replace it by what it should mean first.
    pub fn all_min(&self, values: &mut [f64]) {
        // SAFETY: constants of the MPI library.
        self.all_reduce(values, unsafe { ffi::RSMPI_DOUBLE }, unsafe { ffi::RSMPI_MIN });
    }

    /// Element-wise maximum over ranks, in place.
    pub fn all_max(&self, values: &mut [f64]) {
        // SAFETY: constants of the MPI library.
        self.all_reduce(values, unsafe { ffi::RSMPI_DOUBLE }, unsafe { ffi::RSMPI_MAX });
    }

    /// Every sum added up over all ranks, exactly, and its value: no order of ranks can change a bit. Collective.
    pub fn sum_exactly(&self, sums: &mut [ExactSum]) -> Vec<f64> {
        let mut limbs: Vec<i64> = sums.iter_mut().flat_map(|sum| sum.limbs_mut().to_vec()).collect();
        self.all_sum(&mut limbs);
        for (sum, limbs) in sums.iter_mut().zip(limbs.chunks_exact(ExactSum::WORDS)) {
            *sum = ExactSum::from_limbs(limbs);
        }
        sums.iter().map(ExactSum::value).collect()
    }

    /// Element-wise sum over ranks, in place: exact, so independent of order.
    pub fn all_sum(&self, values: &mut [i64]) {
        // SAFETY: constants of the MPI library.
        self.all_reduce(values, unsafe { ffi::RSMPI_INT64_T }, unsafe { ffi::RSMPI_SUM });
    }

    fn all_reduce<T: Pod>(&self, values: &mut [T], kind: ffi::MPI_Datatype, op: ffi::MPI_Op) {
        if self.size == 1 || values.is_empty() {
            return;
        }
        let mut mine = self.mine.borrow_mut();
        mine.clear();
        mine.extend_from_slice(bytemuck::cast_slice(values));
        // SAFETY: both buffers hold `values.len()` elements of the type named.
        self.waiting(|| unsafe {
            ffi::MPI_Allreduce(
                mine.as_ptr().cast(),
                values.as_mut_ptr().cast(),
                values.len() as i32,
                kind,
                op,
                self.raw,
            )
        });
    }

    /// Seconds for a short message, and bytes per second of long ones, between the first rank and the last, which where
    /// there are several machines are on different ones: the best of many round trips. None on one rank. Collective.
    pub fn network(&self) -> Option<Network> {
        if self.size == 1 {
            return None;
        }
        let mut message = vec![0u8; LONG_MESSAGE];
        let mut trip = |bytes: usize, times: usize| {
            let trips = (0..times).map(|_| self.round_trip(&mut message[..bytes]));
            [0.5 * trips.fold(f64::INFINITY, f64::min)]
        };
        let (mut short, mut long) = (trip(8, 500), trip(LONG_MESSAGE, 20));
        self.all_min(&mut short);
        self.all_min(&mut long);
        let bandwidth = LONG_MESSAGE as f64 / (long[0] - short[0]).max(1e-9);
        Some(Network { latency: short[0], bandwidth })
    }

    /// Seconds of a message from the first rank to the last and back; infinite on others.
    fn round_trip(&self, message: &mut [u8]) -> f64 {
        let (last, bytes) = (self.size as i32 - 1, message.len() as i32);
        // SAFETY: a constant of the MPI library.
        let kind = unsafe { ffi::RSMPI_UINT8_T };
        let start = Instant::now();
        let buffer = message.as_mut_ptr().cast();
        // SAFETY: the buffer holds as many bytes as are named.
        let send = |to: i32| unsafe { ffi::MPI_Send(buffer, bytes, kind, to, TRIP_TAG, self.raw) };
        // SAFETY: the buffer holds as many bytes as are named; the status is filled by MPI.
        let receive = |from: i32| unsafe {
            ffi::MPI_Recv(buffer, bytes, kind, from, TRIP_TAG, self.raw, &mut std::mem::zeroed());
        };
        if self.rank == 0 {
            send(last);
            receive(last);
            start.elapsed().as_secs_f64()
        } else {
            if self.rank == last as usize {
                receive(0);
                send(0);
            }
            f64::INFINITY
        }
    }

    /// The values of all ranks, in rank order; every rank gives equally many.
    pub fn all_gather<T: Pod>(&self, mine: &[T]) -> Vec<T> {
        let mut all = vec![T::zeroed(); mine.len() * self.size];
        let bytes = std::mem::size_of_val(mine) as i32;
        // SAFETY: `all` has room for `size` contributions of `bytes` bytes.
        self.waiting(|| unsafe {
            let byte = ffi::RSMPI_UINT8_T;
            ffi::MPI_Allgather(mine.as_ptr().cast(), bytes, byte, all.as_mut_ptr().cast(), bytes, byte, self.raw)
        });
        all
    }

    /// Rank 0's bytes, on every rank.
    pub fn broadcast(&self, bytes: &mut Vec<u8>) {
        let mut length = [bytes.len() as f64];
        if !self.is_root() {
            length[0] = 0.0;
        }
        self.all_max(&mut length);
        bytes.resize(length[0] as usize, 0);
        for piece in bytes.chunks_mut(PIECE) {
            // SAFETY: the piece holds as many bytes as are named.
            self.waiting(|| unsafe {
                ffi::MPI_Bcast(piece.as_mut_ptr().cast(), piece.len() as i32, ffi::RSMPI_UINT8_T, 0, self.raw)
            });
        }
    }

    /// Sends each message to its rank and returns what came for this one as (source, words), in rank order. No rank needs
    /// to know who will send to it, and the cost follows the messages, not the number of ranks squared (Hoefler, Siebert
    /// and Lumsdaine 2010: synchronous sends closed by a non-blocking barrier). Messages to oneself are allowed.
    pub fn sparse_exchange(&self, messages: Vec<(usize, Vec<u64>)>) -> Vec<(usize, Vec<u64>)> {
        requests::now(self.sparse_exchange_later(messages))
    }

    /// [`Comm::sparse_exchange`] as a part of work that overlaps.
    pub async fn sparse_exchange_later(&self, messages: Vec<(usize, Vec<u64>)>) -> Vec<(usize, Vec<u64>)> {
        let mut received: Vec<(usize, Vec<u64>)> = Vec::new();
        let mut outgoing = Vec::new();
        for (to, words) in messages {
            if to == self.rank {
                received.push((to, words));
            } else {
                outgoing.push((to, words));
            }
        }
        if self.size > 1 {
            // Two rounds in flight cannot be mixed up: a rank enters the next only after the barrier of this one.
            self.round.set((self.round.get() + 1) % 2);
            let mut round = Round::start(self.raw, &self.sent, outgoing, 100 + self.round.get());
            self.complete(|| round.go_on(&mut received)).await;
        }
        received.sort_by_key(|(from, _)| *from);
        received
    }

    /// Element-wise minimum over ranks, as a part of work that overlaps.
    pub async fn all_min_later(&self, values: Vec<f64>) -> Vec<f64> {
        // SAFETY: constants of the MPI library.
        self.all_reduce_later(values, unsafe { ffi::RSMPI_DOUBLE }, unsafe { ffi::RSMPI_MIN }).await
    }

    /// Element-wise maximum over ranks, as a part of work that overlaps.
    pub async fn all_max_later(&self, values: Vec<f64>) -> Vec<f64> {
        // SAFETY: constants of the MPI library.
        self.all_reduce_later(values, unsafe { ffi::RSMPI_DOUBLE }, unsafe { ffi::RSMPI_MAX }).await
    }

    /// Element-wise sum over ranks, as a part of work that overlaps.
    pub async fn all_sum_later(&self, values: Vec<i64>) -> Vec<i64> {
        // SAFETY: constants of the MPI library.
        self.all_reduce_later(values, unsafe { ffi::RSMPI_INT64_T }, unsafe { ffi::RSMPI_SUM }).await
    }

    async fn all_reduce_later<T: Pod>(&self, mine: Vec<T>, kind: ffi::MPI_Datatype, op: ffi::MPI_Op) -> Vec<T> {
        if self.size == 1 || mine.is_empty() {
            return mine;
        }
        let mut reduction = Reduction { all: vec![T::zeroed(); mine.len()], mine, request: Request::none() };
        let Reduction { mine, all, request } = &mut reduction;
        // SAFETY: both buffers hold as many elements of the type named, and stay where they are until the request, which goes
        // before them, is done.
        unsafe {
            let (from, to, count) = (mine.as_ptr().cast(), all.as_mut_ptr().cast(), mine.len() as i32);
            ffi::MPI_Iallreduce(from, to, count, kind, op, self.raw, &mut request.0);
        }
        self.complete(|| reduction.request.is_done()).await;
        std::mem::take(&mut reduction.all)
    }

    /// Returns once `is_done`: after waiting, or, where work overlaps, at its first continuation after that.
    async fn complete(&self, mut is_done: impl FnMut() -> bool) {
        let poll = |_: &mut Context| {
            if self.overlaps.get() {
                return if is_done() { Poll::Ready(()) } else { Poll::Pending };
            }
            self.waiting(|| while !is_done() {});
            Poll::Ready(())
        };
        std::future::poll_fn(poll).await;
    }

    /// Releases MPI; called last, after every file is closed.
    pub fn finish(mut self) {
        self.free_file_hints();
        self.universe.take();
    }
}

/// Processor time of the calling thread, s.
fn thread_cpu_seconds() -> f64 {
    // SAFETY: fills the structure it is given.
    let time = unsafe {
        let mut time: libc::timespec = std::mem::zeroed();
        libc::clock_gettime(libc::CLOCK_THREAD_CPUTIME_ID, &mut time);
        time
    };
    time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64
}

/// A fixed pattern of messages, sent again and again: persistent requests over two buffers that it owns.
pub struct Exchange {
    outgoing: Vec<f64>,
    incoming: Vec<f64>,
    requests: Vec<ffi::MPI_Request>,
    running: bool,
}

impl Exchange {
    /// `sends` and `receives`: (rank, numbers), in the order in which they lie in the buffers. Both sides must agree on the
    /// numbers; a message between two ranks may be empty and is then not sent. All ranks make their exchanges in the same
    /// order, so that those of one number find each other even if several are on their way at once.
    pub fn new(comm: &Comm, sends: &[(usize, usize)], receives: &[(usize, usize)]) -> Self {
        let total = |list: &[(usize, usize)]| list.iter().map(|(_, n)| n).sum::<usize>();
        let (mut outgoing, mut incoming) = (vec![0.0; total(sends)], vec![0.0; total(receives)]);
        let mut requests = Vec::new();
        let piece = PIECE / 8;
        let tag = FIRST_EXCHANGE_TAG + comm.exchanges.get();
        comm.exchanges.set((comm.exchanges.get() + 1) % EXCHANGE_TAGS);
        // SAFETY: the buffers are never resized while the requests live, and both live in `Self`.
        unsafe {
            let double = ffi::RSMPI_DOUBLE;
            let mut rest = incoming.as_mut_slice();
            for &(from, n) in receives {
                let (mine, after) = rest.split_at_mut(n);
                rest = after;
                for part in mine.chunks_mut(piece) {
                    let mut request = std::mem::zeroed();
                    ffi::MPI_Recv_init(
                        part.as_mut_ptr().cast(),
                        part.len() as i32,
                        double,
                        from as i32,
                        tag,
                        comm.raw,
                        &mut request,
                    );
                    requests.push(request);
                }
            }
            let mut rest = outgoing.as_mut_slice();
            for &(to, n) in sends {
                let (mine, after) = rest.split_at_mut(n);
                rest = after;
                for part in mine.chunks_mut(piece) {
                    let mut request = std::mem::zeroed();
                    ffi::MPI_Send_init(
                        part.as_ptr().cast(),
                        part.len() as i32,
                        double,
                        to as i32,
                        tag,
                        comm.raw,
                        &mut request,
                    );
                    requests.push(request);
                }
            }
        }
        Self { outgoing, incoming, requests, running: false }
    }

    /// Where messages are written before [`Exchange::start`].
    pub fn outgoing(&mut self) -> &mut [f64] {
        assert!(!self.running, "messages are on their way");
        &mut self.outgoing
    }

    /// The messages received, once [`Exchange::wait`] has returned.
    pub fn incoming(&self) -> &[f64] {
        assert!(!self.running, "messages are on their way");
        &self.incoming
    }

    pub fn start(&mut self, comm: &Comm) {
        self.running = true;
        comm.sent.set(comm.sent.get() + 8 * self.outgoing.len() as u64);
        if !self.requests.is_empty() {
            // SAFETY: the requests are inactive, as `running` was false.
            unsafe { ffi::MPI_Startall(self.requests.len() as i32, self.requests.as_mut_ptr()) };
        }
    }

    /// Lets MPI move messages: large ones only move while it is called.
    pub fn poll(&mut self) {
        if self.running && !self.requests.is_empty() {
            let mut flag = 0;
            // SAFETY: persistent requests stay valid when complete.
            unsafe {
                ffi::MPI_Testall(
                    self.requests.len() as i32,
                    self.requests.as_mut_ptr(),
                    &mut flag,
                    ffi::RSMPI_STATUSES_IGNORE,
                )
            };
            self.running = flag == 0;
        }
    }

    pub fn wait(&mut self, comm: &Comm) {
        if self.running && !self.requests.is_empty() {
            // SAFETY: as above.
            comm.waiting(|| unsafe {
                ffi::MPI_Waitall(self.requests.len() as i32, self.requests.as_mut_ptr(), ffi::RSMPI_STATUSES_IGNORE)
            });
        }
        self.running = false;
    }

    /// Bytes of both buffers.
    pub fn bytes(&self) -> usize {
        8 * (self.outgoing.len() + self.incoming.len())
    }
}

impl Drop for Exchange {
    fn drop(&mut self) {
        let mut finalized = 0;
        // SAFETY: may be called at any time; requests do not outlive MPI.
        unsafe { ffi::MPI_Finalized(&mut finalized) };
        if finalized != 0 {
            return;
        }
        for request in &mut self.requests {
            // SAFETY: each request is freed once; an active one is freed by MPI when it completes.
            unsafe { ffi::MPI_Request_free(request) };
        }
    }
}
