//! The pair record: exactly what a neighbour's loop reads of a particle, in whole cache lines, one record per owned or ghost
//! particle. Which numbers it holds follows from the terms that the scene requests.

/// The terms of the pair loop in a scene. A term that needs another can only be chosen together with it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Terms {
    pub stress: StressTerm,
    pub viscosity: ViscousTerm,
}

/// The stress that acts between particles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StressTerm {
    /// A pressure, where no body has strength.
    Pressure { gradient: PressureGradient },
    /// The full tensor.
    Tensor {
        /// Artificial stress against clumping in tension.
        artificial: bool,
        gradient: TensorGradient,
    },
}

/// The velocity gradient beside a pressure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PressureGradient {
    Plain,
    /// `contrast`: in pairs of very different density the light particle takes most of the strain.
    Corrected {
        contrast: bool,
    },
}

/// The velocity gradient beside a stress tensor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TensorGradient {
    Plain,
    /// `angular_momentum`: an antisymmetric stress cancels the torque of all forces.
    Corrected {
        contrast: bool,
        angular_momentum: bool,
    },
}

/// How viscosity enters the record.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ViscousTerm {
    Off,
    /// One beta for all materials.
    SameBeta,
    /// beta differs: it is in the record.
    OwnBeta,
    /// The same, and acts on what is left of a pair's approach once the flow around is taken off: its gradient is in the record.
    Reconstructed,
}

impl Terms {
    #[inline]
    pub const fn tensor(&self) -> bool {
        matches!(self.stress, StressTerm::Tensor { .. })
    }

    #[inline]
    pub const fn artificial_stress(&self) -> bool {
        matches!(self.stress, StressTerm::Tensor { artificial: true, .. })
    }

    /// Whether the velocity gradient is corrected.
    #[inline]
    pub const fn corrects(&self) -> bool {
        matches!(
            self.stress,
            StressTerm::Pressure { gradient: PressureGradient::Corrected { .. } }
                | StressTerm::Tensor { gradient: TensorGradient::Corrected { .. }, .. }
        )
    }

    /// Whether pairs of very different density share the strain unevenly.
    #[inline]
    pub const fn contrast(&self) -> bool {
        matches!(
            self.stress,
            StressTerm::Pressure { gradient: PressureGradient::Corrected { contrast: true } }
                | StressTerm::Tensor { gradient: TensorGradient::Corrected { contrast: true, .. }, .. }
        )
    }

    /// Whether forces conserve angular momentum.
    #[inline]
    pub const fn angular_momentum(&self) -> bool {
        matches!(
            self.stress,
            StressTerm::Tensor { gradient: TensorGradient::Corrected { angular_momentum: true, .. }, .. }
        )
    }

    /// Whether viscosity acts on reconstructed velocities.
    #[inline]
    pub const fn reconstructs(&self) -> bool {
        matches!(self.viscosity, ViscousTerm::Reconstructed)
    }

    /// Whether a pair heats beyond the work of the stress.
    #[inline]
    pub const fn dissipates(&self) -> bool {
        !matches!(self.viscosity, ViscousTerm::Off) || self.artificial_stress() || self.contrast()
    }
}

/// The position of each number in a record.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Layout {
    pub dimension: usize,
    pub terms: Terms,
}

impl Layout {
    /// m, D numbers.
    pub const POSITION: usize = 0;

    /// m/s, D numbers.
    #[inline]
    pub const fn velocity(&self) -> usize {
        self.dimension
    }

    /// Damaged stress, Pa: xx yy zz xy xz yz in 3D, xx yy xy in 2D; -P alone without strength.
    #[inline]
    pub const fn stress(&self) -> usize {
        2 * self.dimension
    }

    #[inline]
    pub const fn stress_words(&self) -> usize {
        if self.terms.tensor() { self.tensor_words() } else { 1 }
    }

    #[inline]
    pub const fn tensor_words(&self) -> usize {
        self.dimension * (self.dimension + 1) / 2
    }

    /// V, m^3.
    #[inline]
    pub const fn volume(&self) -> usize {
        self.stress() + self.stress_words()
    }

    /// m / V, kg/m^3: the density, but for particles whose volume is capped. From here on numbers are [`half`] words.
    #[inline]
    pub const fn density(&self) -> usize {
        2 * (self.volume() + 1)
    }

    /// 1/h, 1/m.
    #[inline]
    pub const fn h_inverse(&self) -> usize {
        self.density() + 1
    }

    /// alpha c, m/s, where there is viscosity.
    #[inline]
    pub const fn alpha_c(&self) -> usize {
        self.density() + 2
    }

    /// beta, where materials differ in it.
    #[inline]
    pub const fn beta(&self) -> usize {
        self.density() + 3
    }

    /// The gradient that carries velocities to the middle of a pair, 1/s.
    #[inline]
    pub const fn slope(&self) -> usize {
        self.density() + 4
    }

    /// Artificial stress, Pa.
    #[inline]
    pub const fn artificial(&self) -> usize {
        self.density()
            + match self.terms.viscosity {
                ViscousTerm::Off => 2,
                ViscousTerm::SameBeta => 3,
                ViscousTerm::OwnBeta => 4,
                ViscousTerm::Reconstructed => 4 + self.tensor_words(),
            }
    }

    /// Axial vector of the antisymmetric stress, Pa: x y z in 3D, z in 2D.
    #[inline]
    pub const fn axial(&self) -> usize {
        self.artificial() + if self.terms.artificial_stress() { self.tensor_words() } else { 0 }
    }

    #[inline]
    pub const fn axial_words(&self) -> usize {
        match (self.terms.angular_momentum(), self.dimension) {
            (false, _) => 0,
            (true, 2) => 1,
            (true, _) => 3,
        }
    }

    /// Numbers of a record; a ghost record sends just these.
    #[inline]
    pub const fn words(&self) -> usize {
        (self.axial() + self.axial_words()).div_ceil(2)
    }

    /// Numbers from one record to the next: whole lines of 64 bytes.
    #[inline]
    pub const fn stride(&self) -> usize {
        self.words().div_ceil(8) * 8
    }

    /// The record that pads a row: no volume, no density, a tiny support, far away, so that it adds exact zeros.
    pub fn padding(&self, record: &mut [f64]) {
        record.fill(0.0);
        record[..self.dimension].fill(1e30);
        set_half(record, self.h_inverse(), 1e20);
    }
}

/// A number of which only the first 32 bits are in a record, to 5e-7. These enter both sides of a pair alike, so that sums are
/// conserved as exactly as with all bits, and a solid's record takes two lines.
#[inline]
pub fn half(record: &[f64], k: usize) -> f64 {
    f64::from_bits(u64::from(bytemuck::cast_slice::<f64, u32>(record)[k]) << 32)
}

/// Rounds `x` into its place, see [`half`].
#[inline]
pub fn set_half(record: &mut [f64], k: usize, x: f64) {
    bytemuck::cast_slice_mut::<f64, u32>(record)[k] = ((x.to_bits() + (1 << 31)) >> 32) as u32;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_solid_takes_two_lines_and_a_gas_sends_fewer_numbers() {
        let viscosity = ViscousTerm::SameBeta;
        let words = |dimension, stress| Layout { dimension, terms: Terms { stress, viscosity } }.words();
        let tensor = |artificial, angular_momentum| StressTerm::Tensor {
            artificial,
            gradient: TensorGradient::Corrected { contrast: false, angular_momentum },
        };
        let gas = StressTerm::Pressure { gradient: PressureGradient::Corrected { contrast: false } };
        assert_eq!(words(3, tensor(false, false)), 15);
        assert_eq!([2, 3].map(|dimension| words(dimension, gas)), [8, 10]);
        assert_eq!([2, 3].map(|dimension| words(dimension, tensor(false, true))), [10, 16]);
        assert_eq!(words(3, tensor(true, true)), 19);
    }
}
