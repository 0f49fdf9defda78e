//! Every term of a pair, on eight pairs at once: one function per term, each adding to sums of its own. A term that a scene does
//! not request is a constant of the compiled form and leaves no instruction.

use super::record::{Layout, StressTerm, Terms, ViscousTerm};
use super::stress::{PairStress, add_pressure_force};
use super::viscosity::{Inputs, viscous};
use super::{Pair, angular_momentum, artificial_stress, contrast, reconstruction};
use crate::kernel::{SUPPORT, Shape};
use crate::math::lanes::Lanes;

/// The shape of the loop as constants, so that an absent term leaves no instruction.
pub trait Form: Copy {
    const D: usize;
    const TERMS: Terms;
    type Kernel: Shape;
    const LAYOUT: Layout = Layout { dimension: Self::D, terms: Self::TERMS };
}

/// Numbers that are the same for all pairs of a run, on all lanes.
#[derive(Clone, Copy)]
pub struct Fixed<L: Lanes> {
    /// Half of the kernel's normalisation.
    pub norm: L,
    /// 1 / W(spacing) of the artificial stress.
    pub reference: L,
    /// beta of viscosity, where all materials share it.
    pub beta: L,
}

/// Sums of one row on eight lanes; for their meaning see [`RowSums`](super::RowSums).
#[derive(Clone, Copy)]
pub struct Sums<L: Lanes, const D: usize> {
    pub force: [L; D],
    pub gradient: [[L; D]; D],
    pub moment: [L; 6],
    pub dissipation: L,
    pub fill: L,
    pub filling: L,
    pub approach: L,
    pub neighbours: u32,
}

impl<L: Lanes, const D: usize> Sums<L, D> {
    /// # Safety
    /// As for [`Lanes`].
    #[inline(always)]
    pub unsafe fn zero() -> Self {
        unsafe {
            let zero = L::splat(0.0);
            Self {
                force: [zero; D],
                gradient: [[zero; D]; D],
                moment: [zero; 6],
                dissipation: zero,
                fill: zero,
                filling: zero,
                approach: zero,
                neighbours: 0,
            }
        }
    }
}

/// One record on all lanes, or eight records.
pub struct Side<L: Lanes> {
    pub words: [L; 24],
}

impl<L: Lanes> Side<L> {
    #[inline(always)]
    fn at(&self, k: usize) -> L {
        self.words[k]
    }

    /// A number of 32 bits.
    ///
    /// # Safety
    /// As for [`Lanes`].
    #[inline(always)]
    unsafe fn half(&self, k: usize) -> L {
        unsafe { self.words[k / 2].half(k % 2 == 1) }
    }

    /// `N` of them, the first `count` from `from` on.
    ///
    /// # Safety
    /// As for [`Lanes`].
    #[inline(always)]
    unsafe fn halves<const N: usize>(&self, from: usize, count: usize) -> [L; N] {
        unsafe {
            let mut numbers = [L::splat(0.0); N];
            for k in 0..count {
                numbers[k] = self.half(from + k);
            }
            numbers
        }
    }

    #[inline(always)]
    fn stress<F: Form>(&self) -> [L; 6] {
        let from = F::LAYOUT.stress();
        let mut s = [self.words[from]; 6];
        let words = F::LAYOUT.tensor_words();
        s[..words].copy_from_slice(&self.words[from..from + words]);
        s
    }
}

/// Adds every term of eight pairs.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
pub unsafe fn interact<L: Lanes, F: Form, const D: usize>(
    i: &Side<L>,
    j: &Side<L>,
    fixed: &Fixed<L>,
    sums: &mut Sums<L, D>,
) {
    unsafe {
        let mut meeting = meet::<L, F, D>(i, j, sums);
        let resistance = resist::<L, F, D>(&meeting, fixed, sums);
        find_slope::<L, F, D>(&mut meeting, fixed, resistance.r_inverse);
        if F::TERMS.contrast() {
            let around = touch::<L, F, D>(&mut meeting, fixed, sums);
            add_moment(&meeting.pair, &contrast::straining(around, &meeting.pair), sums);
        }
        let pair = &meeting.pair;
        let straining = if F::TERMS.contrast() { contrast::straining(meeting.shares[0], pair) } else { pair.gradient };
        let acting = match F::TERMS.stress {
            StressTerm::Tensor { .. } => add_tensor::<L, F, D>(&meeting, fixed, &resistance, sums),
            StressTerm::Pressure { .. } => add_pressure::<L, F, D>(&meeting, &resistance, sums),
        };
        add_gradient(pair, &straining, sums);
        if F::TERMS.dissipates() {
            sums.dissipation = acting.pressure.mul(pair.v_dot_x).sub(acting.taken).fma(pair.slope, sums.dissipation);
        }
        if F::TERMS.corrects() && !F::TERMS.contrast() {
            add_moment(pair, &straining, sums);
        }
    }
}

/// Geometry shared by the kernels of a pair.
struct Meeting<'a, L: Lanes, const D: usize> {
    i: &'a Side<L>,
    j: &'a Side<L>,
    pair: Pair<L, D>,
    /// 1/h of both, no kernel narrower than two thirds of the other, 1/m.
    h_inverse: [L; 2],
    /// Square of the distance, m^2.
    r2: L,
    /// Lanes inside the larger support.
    inside: L::Mask,
    /// Shares of both in a pair of very different density; zero before [`find_slope`], and without that term.
    shares: [L; 2],
}

/// Contact with rigid bodies that do not adhere (`step::contact`): sums how much of their surroundings they fill, takes their pairs out of
/// strain and stress, and returns the shares of all in the moment.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
unsafe fn touch<L: Lanes, F: Form, const D: usize>(
    meeting: &mut Meeting<L, D>,
    fixed: &Fixed<L>,
    sums: &mut Sums<L, D>,
) -> L {
    unsafe {
        let layout = F::LAYOUT;
        let Meeting { i, j, pair, h_inverse: [g_i, g_j], shares, .. } = meeting;
        let (loose, any) = contrast::loose(i.half(layout.density()), j.half(layout.density()));
        if !any {
            return shares[0];
        }
        let values = value::<L, F, D>(pair.r, *g_i).add(value::<L, F, D>(pair.r, *g_j));
        sums.fill = values.mul(fixed.norm).mul(loose).fma(j.at(layout.volume()), sums.fill);
        sums.filling = loose.mul(pair.slope).fma(pair.v_dot_x, sums.filling);
        let others = L::splat(1.0).sub(loose);
        *shares = [shares[0].mul(others), shares[1].mul(others)];
        shares[0].add(loose)
    }
}

/// Relative positions and velocities of eight pairs; counts those that are inside the larger support.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
unsafe fn meet<'a, L: Lanes, F: Form, const D: usize>(
    i: &'a Side<L>,
    j: &'a Side<L>,
    sums: &mut Sums<L, D>,
) -> Meeting<'a, L, D> {
    unsafe {
        let layout = F::LAYOUT;
        let mut x = [L::splat(0.0); D];
        let mut v = [L::splat(0.0); D];
        for a in 0..D {
            x[a] = i.at(a).sub(j.at(a));
            v[a] = i.at(D + a).sub(j.at(D + a));
        }
        let (mut r2, mut v_dot_x) = (x[0].mul(x[0]), v[0].mul(x[0]));
        for a in 1..D {
            r2 = x[a].fma(x[a], r2);
            v_dot_x = v[a].fma(x[a], v_dot_x);
        }
        // Coincident particles: the slope's numerator is an exact zero at q = 0, and stays finite.
        r2 = r2.max(L::splat(1e-200));
        let r = r2.sqrt();
        let (g_i, g_j) = (i.half(layout.h_inverse()), j.half(layout.h_inverse()));
        let wide = g_i.min(g_j);
        let narrowest = wide.mul(L::splat(1.5));
        let (g_i, g_j) = (g_i.min(narrowest), g_j.min(narrowest));
        let h_inverse = g_i.add(g_j).mul(L::splat(0.5));
        let inside = r.mul(wide).less(L::splat(SUPPORT));
        sums.neighbours += L::count(inside);
        let pair = Pair { x, v, r, h_inverse, v_dot_x, gradient: x, slope: L::splat(0.0) };
        Meeting { i, j, pair, h_inverse: [g_i, g_j], r2, inside, shares: [L::splat(0.0); 2] }
    }
}

/// Viscosity of a pair.
struct Resistance<L: Lanes> {
    r_inverse: L,
    /// p_ij, Pa.
    pressure: L,
}

/// Viscosity, and 1/r, which comes with it from one division.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
unsafe fn resist<L: Lanes, F: Form, const D: usize>(
    meeting: &Meeting<L, D>,
    fixed: &Fixed<L>,
    sums: &mut Sums<L, D>,
) -> Resistance<L> {
    unsafe {
        let layout = F::LAYOUT;
        let Meeting { i, j, pair, .. } = meeting;
        let beta = match F::TERMS.viscosity {
            ViscousTerm::Off => {
                return Resistance { r_inverse: L::splat(1.0).div(pair.r), pressure: L::splat(0.0) };
            }
            ViscousTerm::SameBeta => fixed.beta,
            ViscousTerm::OwnBeta | ViscousTerm::Reconstructed => {
                i.half(layout.beta()).add(j.half(layout.beta())).mul(L::splat(0.5))
            }
        };
        let density = [i.half(layout.density()), j.half(layout.density())];
        let beta = if F::TERMS.contrast() { contrast::beta_of(beta, density[0], density[1]) } else { beta };
        let jump = if F::TERMS.reconstructs() {
            let (from, words) = (layout.slope(), layout.tensor_words());
            reconstruction::jump(pair, [&i.halves(from, words), &j.halves(from, words)])
        } else {
            pair.v_dot_x.min(L::splat(0.0))
        };
        let inputs = Inputs { density, alpha_c: i.half(layout.alpha_c()).add(j.half(layout.alpha_c())), beta, jump };
        let out = viscous(pair, meeting.r2, &inputs);
        sums.approach = sums.approach.max(out.approach.keep(meeting.inside));
        Resistance { r_inverse: out.r_inverse, pressure: out.pressure }
    }
}

/// The mean of both kernels' slopes, times V_j, into the pair, and the shares of a pair of very different density.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
unsafe fn find_slope<L: Lanes, F: Form, const D: usize>(meeting: &mut Meeting<L, D>, fixed: &Fixed<L>, r_inverse: L) {
    unsafe {
        let layout = F::LAYOUT;
        let Meeting { i, j, pair, h_inverse: [g_i, g_j], shares, .. } = meeting;
        let (g_i, g_j) = (*g_i, *g_j);
        let first = slope::<L, F, D>(pair.r, g_i);
        let like = L::count(g_i.min(g_j).less(g_i.max(g_j))) == 0;
        let slopes = first.add(if like { first } else { slope::<L, F, D>(pair.r, g_j) });
        pair.slope = slopes.mul(fixed.norm).mul(j.at(layout.volume())).mul(r_inverse);
        for a in 0..D {
            pair.gradient[a] = pair.slope.mul(pair.x[a]);
        }
        if F::TERMS.contrast() {
            *shares = contrast::shares(i.half(layout.density()), j.half(layout.density()));
        }
    }
}

/// h^-(d+1) times the kernel's slope, from r and 1/h.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
unsafe fn slope<L: Lanes, F: Form, const D: usize>(r: L, g: L) -> L {
    unsafe {
        let g2 = g.mul(g);
        F::Kernel::slope_lanes(r.mul(g)).mul(if D == 2 { g2.mul(g) } else { g2.mul(g2) })
    }
}

/// h^-d times the kernel, from r and 1/h.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
unsafe fn value<L: Lanes, F: Form, const D: usize>(r: L, g: L) -> L {
    unsafe {
        let g2 = g.mul(g);
        F::Kernel::value_lanes(r.mul(g)).mul(if D == 2 { g2 } else { g2.mul(g) })
    }
}

/// Forces along the line between two particles that contribute to heating.
struct Acting<L: Lanes> {
    /// Pressure of the pair that heats: viscous, less a central artificial stress, Pa.
    pressure: L,
    /// Power by which a full artificial stress lowers the energy instead.
    taken: L,
}

/// The force of stress tensors, with artificial stress and the antisymmetric stress that conserves angular momentum.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
unsafe fn add_tensor<L: Lanes, F: Form, const D: usize>(
    meeting: &Meeting<L, D>,
    fixed: &Fixed<L>,
    resistance: &Resistance<L>,
    sums: &mut Sums<L, D>,
) -> Acting<L> {
    unsafe {
        let layout = F::LAYOUT;
        let Meeting { i, j, pair, shares, .. } = meeting;
        let mut acting = Acting { pressure: resistance.pressure, taken: L::splat(0.0) };
        let (mut s_i, mut s_j) = (i.stress::<F>(), j.stress::<F>());
        if F::TERMS.contrast() {
            (s_i, s_j) = (contrast::share_of(shares[0], s_i), contrast::share_of(shares[1], s_j));
        }
        let mut stress = PairStress::<L, D>::sum(&s_i, &s_j);
        if F::TERMS.artificial_stress() {
            let (from, words) = (layout.artificial(), layout.tensor_words());
            let r_ij = PairStress::<L, D>::sum(&i.halves(from, words), &j.halves(from, words));
            if F::TERMS.angular_momentum() {
                let tension =
                    artificial_stress::tension::<L, F::Kernel, D>(pair, resistance.r_inverse, fixed.reference, &r_ij);
                acting.pressure = acting.pressure.sub(tension);
            } else {
                (stress, acting.taken) =
                    artificial_stress::apply::<L, F::Kernel, D>(pair, fixed.reference, &r_ij, stress);
            }
        }
        stress.minus_pressure(acting.pressure).add_force(&pair.gradient, &mut sums.force);
        if F::TERMS.angular_momentum() {
            let (from, words) = (layout.axial(), layout.axial_words());
            let (mut w_i, mut w_j) = (i.halves::<3>(from, words), j.halves::<3>(from, words));
            if F::TERMS.contrast() {
                (w_i, w_j) = (contrast::share_of(shares[0], w_i), contrast::share_of(shares[1], w_j));
            }
            angular_momentum::add_force(&w_i, &w_j, pair, &mut sums.force);
        }
        acting
    }
}

/// The force of pressures alone.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
unsafe fn add_pressure<L: Lanes, F: Form, const D: usize>(
    meeting: &Meeting<L, D>,
    resistance: &Resistance<L>,
    sums: &mut Sums<L, D>,
) -> Acting<L> {
    unsafe {
        let from = F::LAYOUT.stress();
        let Meeting { i, j, pair, shares, .. } = meeting;
        let (mut s_i, mut s_j) = (i.at(from), j.at(from));
        if F::TERMS.contrast() {
            (s_i, s_j) = (s_i.mul(shares[0]), s_j.mul(shares[1]));
        }
        add_pressure_force(s_i.add(s_j), resistance.pressure, pair, &mut sums.force);
        Acting { pressure: resistance.pressure, taken: L::splat(0.0) }
    }
}

/// L_i.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
unsafe fn add_gradient<L: Lanes, const D: usize>(pair: &Pair<L, D>, straining: &[L; D], sums: &mut Sums<L, D>) {
    unsafe {
        for a in 0..D {
            for b in 0..D {
                sums.gradient[a][b] = pair.v[a].fnma(straining[b], sums.gradient[a][b]);
            }
        }
    }
}

/// M_i.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
unsafe fn add_moment<L: Lanes, const D: usize>(pair: &Pair<L, D>, straining: &[L; D], sums: &mut Sums<L, D>) {
    unsafe {
        let (x, m) = (&pair.x, &mut sums.moment);
        for a in 0..D {
            m[a] = x[a].fnma(straining[a], m[a]);
        }
        m[D] = x[0].fnma(straining[1], m[D]);
        if D == 3 {
            m[D + 1] = x[0].fnma(straining[2], m[D + 1]);
            m[D + 2] = x[1].fnma(straining[2], m[D + 2]);
        }
    }
}
