//! The loops that take the time, on the instruction set of the run and for each order of expansion.

use super::bodies::{Bodies, Place, add_distant, add_near};
use super::expansions::{Beyond, Local, add_sources, add_whole, row};
use super::indices::{ALL, count};
use super::octree::Octree;
use crate::math::lanes::{Avx2, Avx512, LANES, Lanes, Portable, Width, width};

/// A row without mass, far away: fills vectors of lanes.
const PADDING: [f64; row(super::indices::HIGHEST)] = {
    let mut row = [0.0; row(super::indices::HIGHEST)];
    row[0] = 4.0;
    row[1] = 4.0;
    row[2] = 4.0;
    row
};

/// Adds the sources whose rows begin at `far` to the expansion at a sink, a node of the tree.
pub fn add_far(tree: &Octree, sink: usize, far: &[usize], local: &mut Local) {
    let sink = tree.row(sink);
    let mut beyond = [0.0; ALL];
    let into = (&mut *local, &mut beyond);
    // SAFETY: `width` names only what the processor has; each of `far` is the beginning of a row.
    unsafe {
        match (width(), tree.order) {
            (Width::Portable, order) => far_of_order::<Portable>(order, &tree.rows, sink, far, into),
            (Width::Avx2, order) => far_avx2(order, &tree.rows, sink, far, into),
            (Width::Avx512, order) => far_avx512(order, &tree.rows, sink, far, into),
        }
    }
    if !far.is_empty() {
        add_whole(tree.order, sink, &beyond, local);
    }
}

/// L and X at a sink.
type Sums<'a> = (&'a mut Local, &'a mut Beyond);

#[target_feature(enable = "avx2,fma")]
unsafe fn far_avx2(order: usize, rows: &[f64], sink: &[f64], far: &[usize], into: Sums) {
    // SAFETY: the caller's.
    unsafe { far_of_order::<Avx2>(order, rows, sink, far, into) }
}

#[target_feature(enable = "avx512f,avx512vl,avx2,fma")]
unsafe fn far_avx512(order: usize, rows: &[f64], sink: &[f64], far: &[usize], into: Sums) {
    // SAFETY: the caller's.
    unsafe { far_of_order::<Avx512>(order, rows, sink, far, into) }
}

#[inline(always)]
unsafe fn far_of_order<L: Lanes>(order: usize, rows: &[f64], sink: &[f64], far: &[usize], into: Sums) {
    // SAFETY: the caller's.
    unsafe {
        match order {
            3 => far_sources::<L, 3>(rows, sink, far, into),
            4 => far_sources::<L, 4>(rows, sink, far, into),
            _ => far_sources::<L, 5>(rows, sink, far, into),
        }
    }
}

#[inline(always)]
unsafe fn far_sources<L: Lanes, const P: usize>(rows: &[f64], sink: &[f64], far: &[usize], into: Sums) {
    // SAFETY: the caller's; the padding is addressed from the same base, in words.
    unsafe {
        if far.is_empty() {
            return;
        }
        let centre = [L::splat(sink[0]), L::splat(sink[1]), L::splat(sink[2])];
        let (mut sums, mut beyond) = ([L::splat(0.0); ALL], [L::splat(0.0); ALL]);
        let mut eights = far.chunks_exact(LANES);
        for eight in &mut eights {
            let mut offsets = [0; LANES];
            offsets.copy_from_slice(eight);
            add_sources::<L, P>(&centre, rows.as_ptr(), &offsets, &mut sums, &mut beyond);
        }
        let rest = eights.remainder();
        if !rest.is_empty() {
            // The last few beside padding, in a block of their own.
            let mut block = [0.0; LANES * row(super::indices::HIGHEST)];
            let mut offsets = [0; LANES];
            for lane in 0..LANES {
                offsets[lane] = lane * row(P);
                let from = if lane < rest.len() { &rows[rest[lane]..][..row(P)] } else { &PADDING[..row(P)] };
                block[lane * row(P)..(lane + 1) * row(P)].copy_from_slice(from);
            }
            add_sources::<L, P>(&centre, block.as_ptr(), &offsets, &mut sums, &mut beyond);
        }
        fold_onto(&sums[..count(P)], into.0);
        fold_onto(&beyond[..count(P + 1)], into.1);
    }
}

/// Adds the lanes of each sum up.
#[inline(always)]
unsafe fn fold_onto<L: Lanes>(sums: &[L], onto: &mut [f64]) {
    for (eight, onto) in sums.chunks(LANES).zip(onto.chunks_mut(LANES)) {
        // SAFETY: the caller's.
        unsafe {
            let mut all = [L::splat(0.0); LANES];
            all[..eight.len()].copy_from_slice(eight);
            onto.iter_mut().zip(L::fold(all)).for_each(|(onto, sum)| *onto += sum);
        }
    }
}

/// Sums of [`add_near`] and [`add_distant`] at a place.
pub fn sum_bodies(near: &Bodies, distant: &Bodies, place: &Place) -> [f64; 4] {
    // SAFETY: `width` names only what the processor has; bodies are padded.
    unsafe {
        match width() {
            Width::Portable => both::<Portable>(near, distant, place),
            Width::Avx2 => both_avx2(near, distant, place),
            Width::Avx512 => both_avx512(near, distant, place),
        }
    }
}

#[target_feature(enable = "avx2,fma")]
unsafe fn both_avx2(near: &Bodies, distant: &Bodies, place: &Place) -> [f64; 4] {
    // SAFETY: the caller's.
    unsafe { both::<Avx2>(near, distant, place) }
}

#[target_feature(enable = "avx512f,avx512vl,avx2,fma")]
unsafe fn both_avx512(near: &Bodies, distant: &Bodies, place: &Place) -> [f64; 4] {
    // SAFETY: the caller's.
    unsafe { both::<Avx512>(near, distant, place) }
}

#[inline(always)]
unsafe fn both<L: Lanes>(near: &Bodies, distant: &Bodies, place: &Place) -> [f64; 4] {
    // SAFETY: the caller's.
    unsafe {
        let mut sums = [L::splat(0.0); 4];
        add_near(near, place, &mut sums);
        add_distant(distant, place, &mut sums);
        let s = sums;
        let folded = L::fold([s[0], s[1], s[2], s[3], s[0], s[1], s[2], s[3]]);
        [folded[0], folded[1], folded[2], folded[3]]
    }
}
