//! Expansions of 1/r in Cartesian coordinates (Dehnen 2002, J. Comp. Phys. 179, 27; Greengard and Rokhlin 1987), complete up
//! to degree P in the sum of both sides:
//!
//! ```text
//! of sources  B_n = sum m_j e^n / n!            e = centre - x_j, |n| <= P;  B_1 = 0, as the centre is that of mass
//! moved       B'_n = sum_k B_k s^(n-k) / (n-k)!                     s = new centre - old centre
//! at a sink   L_k = sum_n B_n D_(k+n)(R)        D_n = d^n (1/R),  R = sink's centre - source's,  |k| + |n| <= P
//! moved       L'_k = sum_n L_(k+n) s^n / n!
//! at a place  phi = -G sum_k L_k t^k / k!       a_i = G sum_k L_(k+i) t^k / k!       t = x - centre
//! ```
//!
//! With these limits the forces of two cells on each other are equal and opposite: momentum is conserved to rounding. They exert a
//! torque, though, as the energy of the pair, `U = -G sum A_k B_n D_(k+n)` with the sink's `A_k = sum m_i t^k / k!`, depends on the
//! places of the bodies through those of the centres, too: with R the force on the sink as a whole has the terms
//!
//! ```text
//! whole       E_i = sum_(|k|+|n|=P) A_k B_n D_(k+n+i)  =  sum_k A_k X_(k+i),      X_q = sum_n B_n D_(q+n), |q| + |n| = P + 1
//! added       L_i  by  E_i / M        for |i| = 1
//! ```
//!
//! of one degree more, which accelerate all of its mass alike. All forces are then the gradient of U, which does not change when
//! both cells are rotated: angular momentum is conserved to rounding, as in Marcello (2017, Astron. J. 154, 92), and energy except
//! when other pairs of cells are opened.

use super::indices::{ALL, HIGHEST, MOST, POWERS, SUM, count, degree, index, monomials};
use crate::math::lanes::{LANES, Lanes};

/// The body once for each number of a multi-index, as a constant: the contents of arrays may then stay in
/// registers. Conditions are `const`, so that what does not hold costs nothing to compile.
macro_rules! each_index {
    ($number:ident from first $body:block) => {
        each_index!($number in [0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31 32 33 34 35 36 37 38 39 40 41 42 43 44 45 46 47 48 49 50 51 52 53 54 55 56 57 58 59 60 61 62 63 64 65 66 67 68 69 70 71 72 73 74 75 76 77 78 79 80 81 82 83] $body)
    };
    ($number:ident from last $body:block) => {
        each_index!($number in [83 82 81 80 79 78 77 76 75 74 73 72 71 70 69 68 67 66 65 64 63 62 61 60 59 58 57 56 55 54 53 52 51 50 49 48 47 46 45 44 43 42 41 40 39 38 37 36 35 34 33 32 31 30 29 28 27 26 25 24 23 22 21 20 19 18 17 16 15 14 13 12 11 10 9 8 7 6 5 4 3 2 1 0] $body)
    };
    ($number:ident in [$($n:literal)*] $body:block) => {
        $( {
            #[allow(non_upper_case_globals)]
            const $number: usize = $n;
            $body
        } )*
    };
}

/// Numbers of a source's row: centre, mass, then B_n from the second degree on, up to whole vectors of four.
pub const fn row(order: usize) -> usize {
    count(order).next_multiple_of(4)
}

/// Coefficients L_k at a sink.
pub type Local = [f64; MOST];
/// Coefficients X_q at a sink; none below the third degree, as A_1 = 0, and those of the first are in L.
pub type Beyond = [f64; ALL];

/// B_n of one body.
pub fn add_body(order: usize, mass: f64, e: &[f64; 3], moments: &mut [f64]) {
    let powers = monomials(order, e);
    moments.iter_mut().zip(powers).for_each(|(sum, power)| *sum += mass * power);
}

/// Adds the moments of a part, whose centre lies `shift` before the new one.
pub fn add_moved(order: usize, part: &[f64], shift: &[f64; 3], moments: &mut [f64]) {
    let powers = monomials(order, shift);
    for k in 0..count(order) {
        for n in 0..count(order - degree(k)) {
            moments[SUM[k][n] as usize] += part[k] * powers[n];
        }
    }
}

/// The local expansion about a centre that lies `shift` beyond the old one.
pub fn moved(order: usize, local: &Local, shift: &[f64; 3]) -> Local {
    let powers = monomials(order, shift);
    let mut new = [0.0; MOST];
    for k in 0..count(order) {
        for n in 0..count(order - degree(k)) {
            new[k] += local[SUM[k][n] as usize] * powers[n];
        }
    }
    new
}

/// Adds E / M to the expansion at a sink whose row this is. A cell without mass feels no force as a whole.
pub fn add_whole(order: usize, sink: &[f64], beyond: &Beyond, local: &mut Local) {
    if sink[3] == 0.0 {
        return;
    }
    for k in 4..count(order) {
        // A_k from B_k: t is -e.
        let share = if degree(k) % 2 == 0 { sink[k] / sink[3] } else { -sink[k] / sink[3] };
        for axis in 1..4 {
            local[axis] += share * beyond[SUM[k][axis] as usize];
        }
    }
}

/// sum_k L_k t^k / k! and its gradient.
pub fn at_place(order: usize, local: &Local, t: &[f64; 3]) -> [f64; 4] {
    let powers = monomials(order, t);
    let mut sums = [0.0; 4];
    for k in 0..count(order) {
        sums[3] += local[k] * powers[k];
    }
    for k in 0..count(order - 1) {
        for axis in 0..3 {
            sums[axis] += local[SUM[k][1 + axis] as usize] * powers[k];
        }
    }
    sums
}

/// Derivatives of 1/r up to degree P + 1 by recursion over auxiliary ones,
/// `R(m)_(n + e_i) = n_i R(m+1)_(n - e_i) + x_i R(m+1)_n`,  `R(m)_0 = (-1)^m (2m - 1)!! / r^(2m+1)`,  `D_n = R(0)_n`
/// (McMurchie and Davidson 1978, J. Comp. Phys. 26, 218).
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
unsafe fn derivatives<L: Lanes, const P: usize>(x: &[L; 3], inverse: L, out: &mut [L; ALL]) {
    // SAFETY: the caller's.
    unsafe {
        let inverse2 = inverse.mul(inverse);
        let mut first = [inverse; HIGHEST + 2];
        for m in 1..=P + 1 {
            first[m] = first[m - 1].mul(inverse2).mul(L::splat(1.0 - 2.0 * m as f64));
        }
        out[0] = first[P + 1];
        // From the last auxiliary, which has degree 0, to the first, which has all: each is made of the one after it, in place
        // from the highest degree down.
        macro_rules! auxiliary {
            ($($m:literal)*) => { $(
                if const { $m < P + 1 } {
                    each_index!(number from last {
                        if const { is_auxiliary(P, $m, number) } {
                            out[number] = derivative::<L, number>(x, out);
                        }
                    });
                    out[0] = first[$m];
                }
            )* };
        }
        auxiliary!(5 4 3 2 1 0);
    }
}

/// Whether R(m) of this number is needed beside that of degree 0.
const fn is_auxiliary(order: usize, m: usize, number: usize) -> bool {
    m <= order && number > 0 && degree(number) <= order + 1 - m
}

/// The recursion for one multi-index.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
unsafe fn derivative<L: Lanes, const N: usize>(x: &[L; 3], lower: &[L; ALL]) -> L {
    // SAFETY: the caller's.
    unsafe {
        let value = x[const { lowered(N).0 }].mul(lower[const { lowered(N).1 }]);
        match const { lowered(N).2 } {
            0 => value,
            times => lower[const { lowered(N).3 }].fma(L::splat(times as f64), value),
        }
    }
}

/// For a multi-index above zero: an axis along which it may be lowered, its number then, the power that is left there, and the
/// number when it is lowered twice.
const fn lowered(number: usize) -> (usize, usize, usize, usize) {
    let mut p = POWERS[number];
    let axis = if p[0] > 0 {
        0
    } else if p[1] > 0 {
        1
    } else {
        2
    };
    if p[axis] == 0 {
        return (0, 0, 0, 0);
    }
    p[axis] -= 1;
    let (once, left) = (index(p[0], p[1], p[2]), p[axis]);
    if left == 0 {
        return (axis, once, 0, 0);
    }
    p[axis] -= 1;
    (axis, once, left, index(p[0], p[1], p[2]))
}

/// Adds the contributions of eight sources, whose rows begin at `offsets` of `rows`, to L and X of a sink.
///
/// # Safety
/// As for [`Lanes`]; `rows` holds a row behind each offset.
#[inline(always)]
pub unsafe fn add_sources<L: Lanes, const P: usize>(
    centre: &[L; 3],
    rows: *const f64,
    offsets: &[usize; LANES],
    local: &mut [L; ALL],
    beyond: &mut [L; ALL],
) {
    // SAFETY: the caller's.
    unsafe {
        let mut moments = [L::splat(0.0); MOST];
        for quad in 0..row(P) / 4 {
            let four = L::read_quad(rows.add(4 * quad), offsets);
            moments[4 * quad..4 * quad + 4].copy_from_slice(&four);
        }
        let x = [centre[0].sub(moments[0]), centre[1].sub(moments[1]), centre[2].sub(moments[2])];
        let r2 = x[2].fma(x[2], x[1].fma(x[1], x[0].mul(x[0])));
        let mut d = [L::splat(0.0); ALL];
        derivatives::<L, P>(&x, r2.inverse_root(), &mut d);
        let mass = moments[3];
        each_index!(k from first {
            if const { degree(k) <= P } {
                let mut sum = mass.fma(d[k], local[k]);
                let highest = if degree(k) == 1 { P } else { P - degree(k) };
                for n in 4..count(highest) {
                    sum = moments[n].fma(d[SUM[k][n] as usize], sum);
                }
                local[k] = sum;
            }
        });
        each_index!(q from first {
            if const { is_beyond(P, q) } {
                let mut sum = beyond[q];
                if degree(q) == P + 1 {
                    sum = mass.fma(d[q], sum);
                } else {
                    for n in count(P - degree(q))..count(P + 1 - degree(q)) {
                        sum = moments[n].fma(d[SUM[q][n] as usize], sum);
                    }
                }
                beyond[q] = sum;
            }
        });
    }
}

/// Whether X_q is needed for order P: from the third degree on, and not that of P, which goes with B_1.
pub const fn is_beyond(order: usize, q: usize) -> bool {
    degree(q) >= 3 && degree(q) <= order + 1 && degree(q) != order
}
