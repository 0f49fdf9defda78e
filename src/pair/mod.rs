//! Interactions of pairs of particles. One loop per substep, in gather form: every particle sums over all its neighbours, so
//! that no two threads write to one place, and each term is antisymmetric (forces) or matched (energy) pair by pair:
//!
//!   a_i   = (1/rho_i) sum_j V_j (sigma_i + sigma_j - p_ij 1 + f^4 (R_i + R_j)) . gW
//!   du_i  = (1/rho_i) [ sigma_i : L_i + 1/2 sum_j V_j (p_ij v_ij . gW - f^4 v_ij . (R_i + R_j) . gW) ]
//!   L_i   = sum_j V_j (v_j - v_i) (x) gW          M_i = sum_j V_j (x_j - x_i) (x) gW
//!
//! with x_ij = x_i - x_j, v_ij = v_i - v_j, gW = (grad W(h_i) + grad W(h_j)) / 2, V = min(m/rho, V_max), rho_i = m_i/V_i, and sigma the
//! damaged stress. In a pair of unlike h the smaller counts as two thirds of the larger at least: V_j is made for h_j, and a light particle
//! beside a heavy one would, with a kernel of its own, feel V_j / h_i^d times the right force, and be too stiff for its step.
//!
//! The force of i on j is minus that of j on i term by term, and the energy sums are the exact
//! counterpart of the momentum sums (swap i and j in the double sum), so that sum m (v^2/2 + u) is constant. Where densities
//! differ by orders of magnitude, sigma_i, L_i and M_i may take shares of the pair instead, see [`contrast`].
//!
//! One term, one file: adding one is a file here, its numbers in [`record::Layout`], and a function in [`interact`].

pub mod angular_momentum;
pub mod artificial_stress;
pub mod contrast;
pub mod correction;
pub mod interact;
pub mod reconstruction;
pub mod record;
pub mod rows;
pub mod stress;
pub mod viscosity;

pub use record::{Layout, Terms};
pub use rows::{RowSums, Rows};

use crate::math::lanes::Lanes;

/// Eight pairs (i, j): particle i on all lanes, eight neighbours j.
#[derive(Clone, Copy)]
pub struct Pair<L: Lanes, const D: usize> {
    /// x_i - x_j, m.
    pub x: [L; D],
    /// v_i - v_j, m/s.
    pub v: [L; D],
    /// Distance, m.
    pub r: L,
    /// 1/h of the pair, 1/m.
    pub h_inverse: L,
    /// v_ij . x_ij, m^2/s.
    pub v_dot_x: L,
    /// V_j gW, 1/m.
    pub gradient: [L; D],
    /// The factor of x_ij in `gradient`, 1/m^2; negative.
    pub slope: L,
}
