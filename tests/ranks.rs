//! Communication on several ranks, and the harness that starts them.

use crate::common::{Launch, ranks};
use sph_mpi::domain::comm::Exchange;

#[test]
fn reductions_and_broadcast() {
    ranks(3, "ranks::reductions_and_broadcast", |comm| {
        let r = comm.rank() as f64;
        let (mut least, mut most, mut sum) = ([r, -r], [r, -r], [1i64 << 60, comm.rank() as i64]);
        comm.all_min(&mut least);
        comm.all_max(&mut most);
        comm.all_sum(&mut sum);
        assert_eq!((least, most), ([0.0, -2.0], [2.0, 0.0]));
        assert_eq!(sum, [3 << 60, 3]);
        assert_eq!(comm.all_gather(&[comm.rank() as u64, 7]), [0, 7, 1, 7, 2, 7]);
        let mut bytes = if comm.is_root() { b"a scene".to_vec() } else { vec![1; 99] };
        comm.broadcast(&mut bytes);
        assert_eq!(bytes, b"a scene");
    });
}

/// Many rounds without a barrier between them: a message of one round must not arrive in another.
#[test]
fn sparse_exchange_keeps_rounds_apart() {
    ranks(4, "ranks::sparse_exchange_keeps_rounds_apart", |comm| {
        let (me, n) = (comm.rank(), comm.size());
        for round in 0..200 {
            // Rank r writes to r, r + 1, ... r + (round mod n): to some of the ranks, to itself always.
            let to = |r: usize| (0..=round % n).map(move |step| (r + step) % n);
            let words = |from: usize, to: usize| vec![(round * 100 + from * 10 + to) as u64; (from + round) % 5];
            let came = comm.sparse_exchange(to(me).map(|other| (other, words(me, other))).collect());
            let expected: Vec<_> =
                (0..n).filter(|&from| to(from).any(|r| r == me)).map(|from| (from, words(from, me))).collect();
            assert_eq!(came, expected, "round {round}");
        }
    });
}

#[test]
fn exchange_repeats_its_pattern() {
    ranks(3, "ranks::exchange_repeats_its_pattern", |comm| {
        // Round a ring, as many numbers as the sender's rank says: rank 0 sends an empty message.
        let (me, n) = (comm.rank(), comm.size());
        let (next, previous) = ((me + 1) % n, (me + n - 1) % n);
        let mut exchange = Exchange::new(comm, &[(next, 1000 * me)], &[(previous, 1000 * previous)]);
        for round in 0..50 {
            exchange.outgoing().fill((10 * round + me) as f64);
            exchange.start(comm);
            exchange.poll();
            exchange.wait(comm);
            assert_eq!(exchange.incoming(), vec![(10 * round + previous) as f64; 1000 * previous]);
        }
    });
}

#[test]
#[should_panic(expected = "no end within")]
fn harness_ends_a_job_that_hangs() {
    Launch::new(2, "sleep", &["60"]).limit(2).run();
}

#[test]
#[should_panic(expected = "did not run")]
fn harness_notices_a_wrong_name() {
    ranks(2, "ranks::no_such_test", |_| {});
}
