//! Sorts particles with few moves. Between two list builds most particles stay in their cells, so the old order is sorted but
//! for some strays: the particles outside its longest ascending subsequence. The others move in long runs, and all of it
//! happens in place.
//!
//! ```text
//! before   a b X c d e f Y g        runs     a b -> 0,  c d e f -> 2,  g -> 8
//! after    a b c d e f X' Y' g      strays   X -> 6,  Y -> 7
//! ```

/// With more strays than one in so many, particles are gathered one by one.
const FEW: usize = 4;

/// The moves from one order to another.
#[derive(Debug, PartialEq)]
pub enum Reordering {
    /// Runs that keep their order, ascending, and strays as (from, to).
    Moves { runs: Vec<MovedRun>, strays: Vec<(u32, u32)> },
    /// `order[new] = old`.
    Gather(Vec<u32>),
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MovedRun {
    from: u32,
    to: u32,
    len: u32,
}

impl Reordering {
    /// The reordering that sorts `keys`, which are all different.
    pub fn sorting<K: Ord + Copy>(keys: &[K]) -> Self {
        match strays(keys) {
            Some(strays) => Self::moves(keys, strays),
            None => {
                let mut order: Vec<(K, u32)> = keys.iter().copied().zip(0..).collect();
                order.sort_unstable_by_key(|(key, _)| *key);
                Self::Gather(order.into_iter().map(|(_, old)| old).collect())
            }
        }
    }

    /// `strays`: ascending.
    fn moves<K: Ord + Copy>(keys: &[K], mut strays: Vec<u32>) -> Self {
        let n = keys.len() as u32;
        // Runs end where a stray was.
        let mut pieces = Vec::with_capacity(2 * strays.len() + 1);
        let mut start = 0;
        for &stray in strays.iter().chain([&n]) {
            if start < stray {
                pieces.push((start, stray));
            }
            start = stray + 1;
        }
        strays.sort_unstable_by_key(|&i| keys[i as usize]);
        let (mut runs, mut moved) = (Vec::with_capacity(pieces.len() + strays.len()), Vec::with_capacity(strays.len()));
        let (mut rest, mut to) = (strays.into_iter().peekable(), 0);
        for (mut from, end) in pieces {
            // And where one will be.
            while from < end {
                let cut = match rest.peek() {
                    Some(&stray) => {
                        let key = keys[stray as usize];
                        from + keys[from as usize..end as usize].partition_point(|other| *other < key) as u32
                    }
                    None => end,
                };
                if from < cut {
                    runs.push(MovedRun { from, to, len: cut - from });
                    to += cut - from;
                    from = cut;
                }
                if from < end {
                    moved.extend(rest.next().map(|stray| (stray, to)));
                    to += 1;
                }
            }
        }
        moved.extend(rest.zip(to..));
        Self::Moves { runs, strays: moved }
    }

    /// Brings `items` into the new order, `width` for each of those that were sorted.
    pub fn apply<T: Copy>(&self, items: &mut [T], width: usize) {
        match self {
            Self::Moves { runs, strays } => {
                let at = |i: u32| i as usize * width..(i as usize + 1) * width;
                let saved: Vec<T> = strays.iter().flat_map(|&(from, _)| &items[at(from)]).copied().collect();
                let mut shift = |run: &MovedRun| {
                    let [from, to, len] = [run.from, run.to, run.len].map(|n| n as usize * width);
                    items.copy_within(from..from + len, to);
                };
                // Neighbouring runs that move up make room for each other from the last one on; those that move down, from
                // the first one on. A group of one kind never writes to words that another has still to read: targets ascend
                // like sources, and lie beyond them in the one kind and before them in the other.
                for group in runs.chunk_by(|a, b| (a.to > a.from) == (b.to > b.from)) {
                    if group[0].to > group[0].from {
                        group.iter().rev().for_each(&mut shift);
                    } else {
                        group.iter().filter(|run| run.to != run.from).for_each(&mut shift);
                    }
                }
                for (&(_, to), one) in strays.iter().zip(saved.chunks_exact(width)) {
                    items[at(to)].copy_from_slice(one);
                }
            }
            Self::Gather(order) => {
                let mut gathered = super::large_pages::with_capacity(items.len());
                for &old in order {
                    gathered.extend_from_slice(&items[old as usize * width..(old as usize + 1) * width]);
                }
                items.copy_from_slice(&gathered);
            }
        }
    }
}

/// The numbers of all keys outside one of the longest ascending subsequences (Schensted 1961, Canad. J. Math. 13, 179), in
/// ascending order; none if they are too many.
fn strays<K: Ord + Copy>(keys: &[K]) -> Option<Vec<u32>> {
    const NONE: u32 = u32::MAX;
    // The smallest last element of the ascending subsequences of each length, and the predecessor of each element.
    let (mut last, mut before) = (Vec::<u32>::with_capacity(keys.len()), Vec::with_capacity(keys.len()));
    let mut searched = 0;
    for (i, key) in keys.iter().enumerate() {
        let less = |&other: &u32| keys[other as usize] < *key;
        let mut length = last.len();
        if !last.last().is_none_or(less) {
            searched += 1;
            if searched * FEW > keys.len() {
                return None;
            }
            // Strays from the next cells are just before the end.
            let mut step = 1;
            while step < length && !less(&last[length - 1 - step]) {
                step *= 2;
            }
            let start = length.saturating_sub(step + 1);
            length = start + last[start..].partition_point(less);
        }
        before.push(if length == 0 { NONE } else { last[length - 1] });
        if length == last.len() { last.push(i as u32) } else { last[length] = i as u32 }
    }
    let mut strays = Vec::with_capacity(keys.len() - last.len());
    let mut kept = last.last().copied().unwrap_or(NONE);
    for i in (0..keys.len() as u32).rev() {
        if i == kept {
            kept = before[i as usize];
        } else {
            strays.push(i);
        }
    }
    strays.reverse();
    Some(strays)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::uniform;

    /// Sorts the keys and an array of two numbers for each.
    fn sorted(keys: &[u64]) -> (Reordering, Vec<u64>) {
        let reordering = Reordering::sorting(keys);
        let mut pairs: Vec<u64> = keys.iter().flat_map(|&key| [key, !key]).collect();
        reordering.apply(&mut pairs, 2);
        assert!(pairs.chunks_exact(2).all(|pair| pair[1] == !pair[0]));
        (reordering, pairs.into_iter().step_by(2).collect())
    }

    #[test]
    fn whatever_the_order_it_ends_sorted() {
        for n in [0usize, 1, 2, 3, 10, 500] {
            for disorder in [0.0, 0.01, 0.1, 0.3, 1.0] {
                let mut keys: Vec<u64> = (0..n as u64).map(|k| 3 * k).collect();
                for k in 0..n {
                    if uniform(5, k as u64, 0) < disorder {
                        keys.swap(k, (uniform(5, k as u64, 1) * n as f64) as usize);
                    }
                }
                let (_, found) = sorted(&keys);
                keys.sort_unstable();
                assert_eq!(found, keys, "{n} {disorder}");
            }
        }
    }

    #[test]
    fn few_strays_leave_the_others_in_runs() {
        let mut keys: Vec<u64> = (0..100).map(|k| 10 * k).collect();
        // A whole group moves ahead, one falls back, one moves to the front.
        keys[20..23].copy_from_slice(&[801, 802, 803]);
        keys[60] = 305;
        keys[99] = 5;
        let (reordering, found) = sorted(&keys);
        assert!(found.is_sorted());
        let Reordering::Moves { runs, strays } = reordering else { panic!("few strays") };
        assert_eq!((strays.len(), runs.len()), (5, 6));
        assert!(matches!(Reordering::sorting(&[1, 2, 3]), Reordering::Moves { runs, .. } if runs.len() == 1));
        let backwards: Vec<u64> = (0..100).rev().collect();
        assert!(matches!(Reordering::sorting(&backwards), Reordering::Gather(_)));
    }
}
