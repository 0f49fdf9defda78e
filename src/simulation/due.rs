//! When snapshots are due, and how steps lead there. A snapshot shows the state at its due time, no step before and none after:
//! the last step before it is shortened. Everything follows from the time, the step and the last snapshot, which checkpoints
//! hold, so that any ranks and any restarts make the same steps.

/// Share of the time between snapshots by which a time may miss a due one: rounding causes less, and no step is that short.
const CLOSE: f64 = 1e-9;

/// The due times of one run: 0, `every`, 2 `every`, ..., s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Due {
    pub every: f64,
}

impl Due {
    /// The first due time after the `last` snapshot that is not over at `time`. Missed snapshots, as in a run resumed with other
    /// due times than it began with, are not made up for.
    pub fn next(self, last: Option<f64>, time: f64) -> f64 {
        let unseen = last.map_or(0.0, |last| (last / self.every + CLOSE).floor() + 1.0);
        unseen.max((time / self.every - CLOSE).ceil()) * self.every
    }

    /// Whether two times are the same for a snapshot.
    pub fn same(self, a: f64, b: f64) -> bool {
        (a - b).abs() <= CLOSE * self.every
    }
}

/// The step that a run makes next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NextStep {
    /// s.
    pub dt: f64,
    /// The time after it, s: where the run has to stop there, the very number.
    pub end: f64,
}

/// The step to make where `most` is allowed and the run has to stop at `goal` on its way, s. Two even steps lead there from less
/// than two steps before, so that none gets tiny.
pub fn lead(most: f64, time: f64, goal: f64) -> NextStep {
    let left = goal - time;
    if left > 0.0 && left <= most {
        NextStep { dt: left, end: goal }
    } else if left > 0.0 && left < 2.0 * most {
        NextStep { dt: 0.5 * left, end: time + 0.5 * left }
    } else {
        NextStep { dt: most, end: time + most }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whatever the steps, snapshots are taken at the due times, all of them and each once, and no step gets tiny.
    #[test]
    fn steps_end_at_due_times_and_never_get_tiny() {
        let due = Due { every: 0.1 };
        for allowed in [0.0123, 0.0999999999, 0.1, 0.100000001, 0.33, 7.0] {
            let (mut time, mut last, mut taken, mut smallest) = (0.0, None, Vec::new(), f64::INFINITY);
            while taken.len() < 2001 {
                if due.same(due.next(last, time), time) {
                    last = Some(time);
                    taken.push(time);
                }
                let next = lead(allowed, time, due.next(last, time));
                smallest = next.dt.min(smallest);
                time = next.end;
            }
            assert!(taken.iter().zip(0..).all(|(t, k)| *t == k as f64 * 0.1), "{allowed}");
            assert!(smallest > 0.49 * allowed.min(0.1), "{smallest} of {allowed}");
        }
    }

    #[test]
    fn what_was_missed_is_not_made_up_for() {
        let due = Due { every: 2.0 };
        assert_eq!(due.next(None, 0.0), 0.0);
        assert_eq!((due.next(Some(0.0), 0.0), due.next(Some(0.0), 1.9), due.next(Some(0.0), 2.0)), (2.0, 2.0, 2.0));
        assert_eq!((due.next(Some(0.0), 7.0), due.next(Some(3.0), 3.0), due.next(None, 7.0)), (8.0, 4.0, 8.0));
        // Rounding of either makes no second snapshot.
        assert_eq!((due.next(Some(6.0 - 1e-12), 6.0), due.next(Some(6.0), 6.0 - 1e-12)), (8.0, 8.0));
    }
}
