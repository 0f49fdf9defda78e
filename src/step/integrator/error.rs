//! The error of a step, as an integrator with error control finds it over many particles: of each quantity that it controls the largest
//! error, and the size that this is compared with. Maxima do not depend on order.

/// Quantities that may be controlled: velocity, position, and columns.
pub const QUANTITIES: usize = 16;

/// Errors of a step's quantities, in the order of the integrator.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepError {
    /// Largest error of each, SI, or relative where every particle has its own size.
    pub errors: [f64; QUANTITIES],
    /// Largest size of each, SI; zero where the integrator compares with something else.
    pub sizes: [f64; QUANTITIES],
}

impl Default for StepError {
    fn default() -> Self {
        Self { errors: [0.0; QUANTITIES], sizes: [0.0; QUANTITIES] }
    }
}

impl StepError {
    /// The error `off` of one particle.
    #[inline]
    pub fn note(&mut self, quantity: usize, off: f64) {
        self.errors[quantity] = self.errors[quantity].max(off);
    }

    /// The size of the quantity in one particle.
    #[inline]
    pub fn note_size(&mut self, quantity: usize, size: f64) {
        self.sizes[quantity] = self.sizes[quantity].max(size);
    }

    pub fn merge(&mut self, other: &Self) {
        for k in 0..QUANTITIES {
            self.note(k, other.errors[k]);
            self.note_size(k, other.sizes[k]);
        }
    }
}

/// An error over what is tolerated of it; none is, where its size is zero.
pub fn share(off: f64, size: f64, tolerance: f64) -> f64 {
    if off > 0.0 { off / (size * tolerance) } else { 0.0 }
}
