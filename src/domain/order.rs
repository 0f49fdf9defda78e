//! Sorting of what is nearly in order: between two list builds few particles change their cells.

/// Sorts by `key`, in time proportional to the number of items and to that of the misplaced ones times its logarithm.
///
/// Items are kept where they stand while keys rise, and put aside where they fall; an item that stood so far ahead that all
/// after it would be put aside gives way instead. What was put aside is sorted and merged with the rest.
pub fn sort_nearly_sorted<T: Copy, K: Ord>(items: &mut [T], key: impl Fn(&T) -> K) {
    let mut aside: Vec<T> = Vec::new();
    let mut kept = 0;
    // Items put aside one after the other.
    let mut run = 0;
    for next in 0..items.len() {
        let item = items[next];
        let k = key(&item);
        if kept > 0 && k < key(&items[kept - 1]) {
            // At most one more than have been put aside in a row may give way: each item pays for what it moves.
            let stay = kept.saturating_sub(run + 1);
            if stay > 0 && k < key(&items[stay - 1]) {
                aside.push(item);
                run += 1;
                continue;
            }
            let ahead = items[stay..kept].len() - items[stay..kept].partition_point(|other| key(other) <= k);
            aside.extend_from_slice(&items[kept - ahead..kept]);
            kept -= ahead;
        }
        items[kept] = item;
        kept += 1;
        run = 0;
    }
    aside.sort_unstable_by_key(&key);
    // From the end: the place of the largest one is free, or holds it.
    let mut to = items.len();
    while let Some(item) = aside.last() {
        to -= 1;
        if kept > 0 && key(&items[kept - 1]) > key(item) {
            kept -= 1;
            items[to] = items[kept];
        } else {
            items[to] = *item;
            aside.pop();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::uniform;

    fn sorts(mut items: Vec<u64>) {
        let mut expected = items.clone();
        expected.sort_unstable();
        sort_nearly_sorted(&mut items, |x| *x);
        assert_eq!(items, expected);
    }

    #[test]
    fn any_order_is_sorted() {
        for n in 0..200 {
            sorts((0..n).map(|k| (1000.0 * uniform(1, n, k)) as u64).collect());
            sorts((0..n).rev().collect());
            // One in ten elsewhere, some of them in a row.
            let moved = |k: u64| uniform(2, n, k / 3) < 0.1;
            sorts((0..n).map(|k| if moved(k) { (uniform(3, n, k) * n as f64) as u64 } else { k }).collect());
        }
    }

    /// Items that stand far ahead do not make all after them look misplaced.
    #[test]
    fn few_misplaced_items_are_few_moves() {
        let keys = std::cell::Cell::new(0);
        let mut items: Vec<u64> = (0..10_000).collect();
        for k in 0..5 {
            items[100 + k] = 9_000 + k as u64;
            items[7_000 + 10 * k] = 50;
        }
        sort_nearly_sorted(&mut items, |x| {
            keys.set(keys.get() + 1);
            *x
        });
        assert!(items.is_sorted());
        assert!(keys.get() < 50_000, "{}", keys.get());
    }
}
