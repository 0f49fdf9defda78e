//! One compiled loop per combination of dimension, terms, kernel and instruction set; chosen once per run.

use std::ops::Range;

use sph_mpi_kernels::kernel::{CubicSpline, Kernel, Shape, WendlandC2};
use sph_mpi_kernels::math::lanes::{Avx2, Avx512, Portable, Width, width};
use sph_mpi_kernels::pair::interact::Form;
use sph_mpi_kernels::pair::record::{Layout, PressureGradient, StressTerm, TensorGradient, Terms, ViscousTerm};
use sph_mpi_kernels::pair::rows::{Constants, RowSums, Rows, sum_rows};

type Loop = unsafe fn(&Rows, &Constants, Range<usize>, &mut [RowSums]);

/// The pair loop of a run. Its layout is that of the compiled form, so that records and their reader cannot differ.
#[derive(Clone, Copy)]
pub struct PairLoop {
    pub kernel: Kernel,
    constants: Constants,
    compiled: Compiled,
}

/// A loop and the records that it reads.
#[derive(Clone, Copy)]
struct Compiled {
    run: Loop,
    layout: Layout,
}

impl PairLoop {
    pub fn new(dimension: usize, terms: Terms, kernel: Kernel, constants: Constants) -> Self {
        Self::with_width(dimension, terms, kernel, constants, width())
    }

    /// For tests that compare instruction sets; the processor must have `width`.
    pub fn with_width(dimension: usize, terms: Terms, kernel: Kernel, constants: Constants, width: Width) -> Self {
        Self { kernel, constants, compiled: choose(dimension, terms, kernel, width) }
    }

    /// Layout of the records that it reads.
    pub fn layout(&self) -> &Layout {
        &self.compiled.layout
    }

    /// Sums of the owned particles `range`; `out[k]` receives particle `range.start + k`.
    pub fn sum(&self, rows: &Rows, range: Range<usize>, out: &mut [RowSums]) {
        assert!(range.len() <= out.len() && rows.records.len().is_multiple_of(self.layout().stride()));
        // SAFETY: the loop was chosen for this processor; lists hold slots of the records they were built for.
        unsafe { (self.compiled.run)(rows, &self.constants, range, out) }
    }
}

/// One combination of terms as constants: what `with_terms` and `with_viscosity` choose.
#[derive(Clone, Copy)]
struct Chosen<
    const D: usize,
    const TENSOR: bool,
    const ARTIFICIAL: bool,
    const CORRECTED: bool,
    const ANGULAR_MOMENTUM: bool,
    const CONTRAST: bool,
    const VISCOSITY: u8,
    K,
>(std::marker::PhantomData<K>);

impl<
    const D: usize,
    const TENSOR: bool,
    const ARTIFICIAL: bool,
    const CORRECTED: bool,
    const ANGULAR_MOMENTUM: bool,
    const CONTRAST: bool,
    const VISCOSITY: u8,
    K: Shape,
> Form for Chosen<D, TENSOR, ARTIFICIAL, CORRECTED, ANGULAR_MOMENTUM, CONTRAST, VISCOSITY, K>
{
    const D: usize = D;
    const TERMS: Terms = Terms {
        stress: match (TENSOR, CORRECTED) {
            (false, false) => StressTerm::Pressure { gradient: PressureGradient::Plain },
            (false, true) => StressTerm::Pressure { gradient: PressureGradient::Corrected { contrast: CONTRAST } },
            (true, false) => StressTerm::Tensor { artificial: ARTIFICIAL, gradient: TensorGradient::Plain },
            (true, true) => StressTerm::Tensor {
                artificial: ARTIFICIAL,
                gradient: TensorGradient::Corrected { contrast: CONTRAST, angular_momentum: ANGULAR_MOMENTUM },
            },
        },
        viscosity: match VISCOSITY {
            0 => ViscousTerm::Off,
            1 => ViscousTerm::SameBeta,
            2 => ViscousTerm::OwnBeta,
            _ => ViscousTerm::Reconstructed,
        },
    };
    type Kernel = K;
}

unsafe fn portable<F: Form, const D: usize>(r: &Rows, c: &Constants, w: Range<usize>, out: &mut [RowSums]) {
    // SAFETY: the portable lanes need no instruction set.
    unsafe { sum_rows::<Portable, F, D>(r, c, w, out) }
}

#[target_feature(enable = "avx2,fma")]
unsafe fn avx2<F: Form, const D: usize>(r: &Rows, c: &Constants, w: Range<usize>, out: &mut [RowSums]) {
    // SAFETY: `choose` checks the processor first.
    unsafe { sum_rows::<Avx2, F, D>(r, c, w, out) }
}

#[target_feature(enable = "avx512f,avx512vl,avx2,fma,popcnt")]
unsafe fn avx512<F: Form, const D: usize>(r: &Rows, c: &Constants, w: Range<usize>, out: &mut [RowSums]) {
    // SAFETY: `choose` checks the processor first.
    unsafe { sum_rows::<Avx512, F, D>(r, c, w, out) }
}

fn choose(dimension: usize, terms: Terms, kernel: Kernel, width: Width) -> Compiled {
    match (dimension, kernel) {
        (2, Kernel::CubicSpline) => with_terms::<2, CubicSpline>(terms, width),
        (2, Kernel::WendlandC2) => with_terms::<2, WendlandC2>(terms, width),
        (3, Kernel::CubicSpline) => with_terms::<3, CubicSpline>(terms, width),
        (3, Kernel::WendlandC2) => with_terms::<3, WendlandC2>(terms, width),
        _ => unreachable!("scenes have two or three dimensions"),
    }
}

fn with_terms<const D: usize, K: Shape>(terms: Terms, width: Width) -> Compiled {
    use PressureGradient as Pressed;
    use StressTerm::{Pressure, Tensor};
    use TensorGradient::{Corrected, Plain};
    let viscosity = terms.viscosity;
    match terms.stress {
        Pressure { gradient: Pressed::Plain } => {
            with_viscosity::<D, false, false, false, false, false, K>(viscosity, width)
        }
        Pressure { gradient: Pressed::Corrected { contrast: false } } => {
            with_viscosity::<D, false, false, true, false, false, K>(viscosity, width)
        }
        Pressure { gradient: Pressed::Corrected { contrast: true } } => {
            with_viscosity::<D, false, false, true, false, true, K>(viscosity, width)
        }
        Tensor { artificial: false, gradient: Plain } => {
            with_viscosity::<D, true, false, false, false, false, K>(viscosity, width)
        }
        Tensor { artificial: true, gradient: Plain } => {
            with_viscosity::<D, true, true, false, false, false, K>(viscosity, width)
        }
        Tensor { artificial, gradient: Corrected { contrast, angular_momentum } } => {
            match (artificial, angular_momentum, contrast) {
                (false, false, false) => with_viscosity::<D, true, false, true, false, false, K>(viscosity, width),
                (false, false, true) => with_viscosity::<D, true, false, true, false, true, K>(viscosity, width),
                (false, true, false) => with_viscosity::<D, true, false, true, true, false, K>(viscosity, width),
                (false, true, true) => with_viscosity::<D, true, false, true, true, true, K>(viscosity, width),
                (true, false, false) => with_viscosity::<D, true, true, true, false, false, K>(viscosity, width),
                (true, false, true) => with_viscosity::<D, true, true, true, false, true, K>(viscosity, width),
                (true, true, false) => with_viscosity::<D, true, true, true, true, false, K>(viscosity, width),
                (true, true, true) => with_viscosity::<D, true, true, true, true, true, K>(viscosity, width),
            }
        }
    }
}

fn with_viscosity<
    const D: usize,
    const T: bool,
    const A: bool,
    const C: bool,
    const M: bool,
    const X: bool,
    K: Shape,
>(
    viscosity: ViscousTerm,
    width: Width,
) -> Compiled {
    match viscosity {
        ViscousTerm::Off => with_lanes::<Chosen<D, T, A, C, M, X, 0, K>, D>(width),
        ViscousTerm::SameBeta => with_lanes::<Chosen<D, T, A, C, M, X, 1, K>, D>(width),
        ViscousTerm::OwnBeta => with_lanes::<Chosen<D, T, A, C, M, X, 2, K>, D>(width),
        // Gradients are corrected where they carry velocities.
        ViscousTerm::Reconstructed => with_lanes::<Chosen<D, T, A, true, M, X, 3, K>, D>(width),
    }
}

fn with_lanes<F: Form, const D: usize>(width: Width) -> Compiled {
    let run: Loop = match width {
        Width::Portable => portable::<F, D>,
        Width::Avx2 => avx2::<F, D>,
        Width::Avx512 => avx512::<F, D>,
    };
    Compiled { run, layout: F::LAYOUT }
}
