//! One compiled loop per combination of dimension, terms, kernel and instruction set; chosen once per run.

use std::ops::Range;

use super::record::{Layout, Terms, Viscosity};
use super::rows::{Constants, Form, RowSums, Rows, sum_rows};
use crate::kernel::{CubicSpline, Kernel, Shape, WendlandC2};
use crate::math::lanes::{Avx2, Avx512, Portable, Width, width};

type Loop = unsafe fn(&Rows, &Constants, Range<usize>, &mut [RowSums]);

/// The pair loop of a run.
#[derive(Clone, Copy)]
pub struct PairLoop {
    pub layout: Layout,
    pub constants: Constants,
    run: Loop,
}

impl PairLoop {
    pub fn new(dimension: usize, terms: Terms, kernel: Kernel, constants: Constants) -> Self {
        Self::with_width(dimension, terms, kernel, constants, width())
    }

    /// For tests that compare instruction sets; the processor must have `width`.
    pub fn with_width(dimension: usize, terms: Terms, kernel: Kernel, constants: Constants, width: Width) -> Self {
        Self { layout: Layout { dimension, terms }, constants, run: choose(dimension, terms, kernel, width) }
    }

    /// Sums of the owned particles `range`; `out[k]` receives particle `range.start + k`.
    pub fn sum(&self, rows: &Rows, range: Range<usize>, out: &mut [RowSums]) {
        assert!(range.len() <= out.len() && rows.records.len().is_multiple_of(self.layout.stride()));
        // SAFETY: the loop was chosen for this processor; lists hold slots of the records they were built for.
        unsafe { (self.run)(rows, &self.constants, range, out) }
    }
}

/// The constants of one combination.
#[derive(Clone, Copy)]
struct Compiled<
    const D: usize,
    const TENSOR: bool,
    const TENSILE: bool,
    const CORRECTED: bool,
    const BALANCED: bool,
    const CONTRAST: bool,
    const VISC: u8,
    K,
>(std::marker::PhantomData<K>);

impl<
    const D: usize,
    const TENSOR: bool,
    const TENSILE: bool,
    const CORRECTED: bool,
    const BALANCED: bool,
    const CONTRAST: bool,
    const VISC: u8,
    K: Shape,
> Form for Compiled<D, TENSOR, TENSILE, CORRECTED, BALANCED, CONTRAST, VISC, K>
{
    const D: usize = D;
    const TERMS: Terms = Terms {
        tensor: TENSOR,
        viscosity: match VISC {
            0 => Viscosity::Off,
            1 => Viscosity::SameBeta,
            _ => Viscosity::OwnBeta,
        },
        artificial_stress: TENSILE,
        correction: CORRECTED,
        no_torque: BALANCED,
        contrast: CONTRAST,
    };
    type Kernel = K;
}

unsafe fn portable<F: Form, const D: usize>(r: &Rows, c: &Constants, w: Range<usize>, out: &mut [RowSums]) {
    // SAFETY: the portable lanes need no instruction set.
    unsafe { sum_rows::<Portable, F, D>(r, c, w, out) }
}

#[target_feature(enable = "avx2,fma")]
unsafe fn avx2<F: Form, const D: usize>(r: &Rows, c: &Constants, w: Range<usize>, out: &mut [RowSums]) {
    // SAFETY: `choose` asks the processor first.
    unsafe { sum_rows::<Avx2, F, D>(r, c, w, out) }
}

#[target_feature(enable = "avx512f,avx512vl,avx2,fma,popcnt")]
unsafe fn avx512<F: Form, const D: usize>(r: &Rows, c: &Constants, w: Range<usize>, out: &mut [RowSums]) {
    // SAFETY: `choose` asks the processor first.
    unsafe { sum_rows::<Avx512, F, D>(r, c, w, out) }
}

fn choose(dimension: usize, terms: Terms, kernel: Kernel, width: Width) -> Loop {
    match (dimension, kernel) {
        (2, Kernel::CubicSpline) => with_terms::<2, CubicSpline>(terms, width),
        (2, Kernel::WendlandC2) => with_terms::<2, WendlandC2>(terms, width),
        (3, Kernel::CubicSpline) => with_terms::<3, CubicSpline>(terms, width),
        (3, Kernel::WendlandC2) => with_terms::<3, WendlandC2>(terms, width),
        _ => unreachable!("scenes have two or three dimensions"),
    }
}

/// The combinations that there are: artificial stress and forces without torque are of tensors, and what counts neighbours or
/// turns forces wants the corrected gradient.
fn with_terms<const D: usize, K: Shape>(t: Terms, width: Width) -> Loop {
    match (t.tensor, t.correction, t.artificial_stress, t.no_torque, t.contrast) {
        (false, false, ..) => viscous::<D, false, false, false, false, false, K>(t, width),
        (false, true, _, _, false) => viscous::<D, false, false, true, false, false, K>(t, width),
        (false, true, _, _, true) => viscous::<D, false, false, true, false, true, K>(t, width),
        (true, false, false, ..) => viscous::<D, true, false, false, false, false, K>(t, width),
        (true, false, true, ..) => viscous::<D, true, true, false, false, false, K>(t, width),
        (true, true, false, false, false) => viscous::<D, true, false, true, false, false, K>(t, width),
        (true, true, false, false, true) => viscous::<D, true, false, true, false, true, K>(t, width),
        (true, true, false, true, false) => viscous::<D, true, false, true, true, false, K>(t, width),
        (true, true, false, true, true) => viscous::<D, true, false, true, true, true, K>(t, width),
        (true, true, true, false, false) => viscous::<D, true, true, true, false, false, K>(t, width),
        (true, true, true, false, true) => viscous::<D, true, true, true, false, true, K>(t, width),
        (true, true, true, true, false) => viscous::<D, true, true, true, true, false, K>(t, width),
        (true, true, true, true, true) => viscous::<D, true, true, true, true, true, K>(t, width),
    }
}

fn viscous<const D: usize, const T: bool, const A: bool, const C: bool, const B: bool, const X: bool, K: Shape>(
    terms: Terms,
    width: Width,
) -> Loop {
    match terms.viscosity {
        Viscosity::Off => with_lanes::<Compiled<D, T, A, C, B, X, 0, K>, D>(width),
        Viscosity::SameBeta => with_lanes::<Compiled<D, T, A, C, B, X, 1, K>, D>(width),
        Viscosity::OwnBeta => with_lanes::<Compiled<D, T, A, C, B, X, 2, K>, D>(width),
    }
}

fn with_lanes<F: Form, const D: usize>(width: Width) -> Loop {
    match width {
        Width::Portable => portable::<F, D>,
        Width::Avx2 => avx2::<F, D>,
        Width::Avx512 => avx512::<F, D>,
    }
}
