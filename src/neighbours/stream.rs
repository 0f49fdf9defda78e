//! Copies that bypass the caches. A list is larger than they are and is read long after it was written: to fetch its lines
//! first, only to overwrite them, would be half of the traffic.

use std::mem::MaybeUninit;

/// Fills `to` with the numbers of `from`, as many; elsewhere than on x86-64 through the caches.
#[cfg(not(target_arch = "x86_64"))]
pub fn copy(from: &[u32], to: &mut [MaybeUninit<u32>]) {
    assert_eq!(from.len(), to.len());
    to.iter_mut().zip(from).for_each(|(to, from)| drop(to.write(*from)));
}

/// Fills `to` with the numbers of `from`, as many.
#[cfg(target_arch = "x86_64")]
pub fn copy(from: &[u32], to: &mut [MaybeUninit<u32>]) {
    use std::arch::x86_64::{_mm_loadu_si128, _mm_sfence, _mm_stream_si128};
    /// Numbers in what is stored at once.
    const QUAD: usize = 4;
    assert_eq!(from.len(), to.len());
    // Streaming requires whole aligned quads; the numbers before and after them are written as usual.
    let head = to.as_ptr().align_offset(QUAD * size_of::<u32>()).min(to.len());
    let end = head + (to.len() - head) / QUAD * QUAD;
    for k in (0..head).chain(end..to.len()) {
        to[k].write(from[k]);
    }
    for (from, to) in from[head..end].chunks_exact(QUAD).zip(to[head..end].chunks_exact_mut(QUAD)) {
        // SAFETY: both hold four numbers, and `to` is aligned; SSE2 is there on every x86-64.
        unsafe { _mm_stream_si128(to.as_mut_ptr().cast(), _mm_loadu_si128(from.as_ptr().cast())) };
    }
    // SAFETY: only orders stores: these before any that announce them to another thread.
    unsafe { _mm_sfence() };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_arrives_whatever_the_alignment() {
        let from: Vec<u32> = (0..41).collect();
        for (start, len) in (0..6).flat_map(|start| [0, 1, 3, 4, 17, 30].map(|len| (start, len))) {
            let mut to = [MaybeUninit::new(u32::MAX); 41];
            copy(&from[start..start + len], &mut to[start..start + len]);
            // SAFETY: all of them were made with a number.
            let to: Vec<u32> = to.iter().map(|x| unsafe { x.assume_init() }).collect();
            let expected = (0..41u32).map(|k| if (start..start + len).contains(&(k as usize)) { k } else { u32::MAX });
            assert!(to.into_iter().eq(expected), "{start} {len}");
        }
    }
}
