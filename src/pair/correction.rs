//! Correction of the velocity gradient, L M^-1, exact for linear velocity fields and so free of strain in rigid rotation
//! (Geretshauser et al. 2010, Eqs. 13-15, with x_j - x_i in both). M needs neighbours in all directions: where they are too
//! few or lie in a plane or on a line, the uncorrected gradient is used.

use crate::math::{Mat3, Sym};

/// Largest trace(M^-1) that is used. With neighbours all around, M is about 1; one eigenvalue then may fall to 0.05. It does
/// where neighbours lie in a plane or on a line, and all do in spray, whose few distant neighbours say nothing reliable
/// about a gradient and would only let strain rates of single particles cut the time step.
///
/// In an impact at 5 km/s the trace was 3 inside a body and up to 10 at its faces and edges; above 20 particles had 6 to 23
/// neighbours in the mean, above 100 fewer than 7. Limits from 20 to 1e4 gave the same run; with 5 a fifth of the particles
/// would be uncorrected, all of them at surfaces; without a limit steps fell to 1e-4 of those before.
const MOST_INVERSE: f64 = 20.0;

/// No eigenvalue is below 1/[`MOST_INVERSE`] then, and the determinant not below its power. It must be tested, too: of two
/// neighbours or three, rounding leaves a determinant and cofactors of any sign, about 1e-16.
const fn least_determinant(dimension: i32) -> f64 {
    let mut det = 1.0;
    let mut k = 0;
    while k < dimension {
        det /= MOST_INVERSE;
        k += 1;
    }
    det
}

/// M^-1, or nothing where the neighbourhood is degenerate. In 2D only xx, yy and xy of `m` count.
pub fn inverse<const D: usize>(m: &Sym) -> Option<Sym> {
    if D == 2 {
        let (det, trace) = (m.xx * m.yy - m.xy * m.xy, m.xx + m.yy);
        if !(det >= const { least_determinant(2) } && trace <= MOST_INVERSE * det) {
            return None;
        }
        let f = 1.0 / det;
        return Some(Sym { xx: m.yy * f, yy: m.xx * f, xy: -m.xy * f, ..Sym::ZERO });
    }
    let c = m.cofactors();
    let det = m.determinant(&c);
    if !(det >= const { least_determinant(3) } && c.xx + c.yy + c.zz <= MOST_INVERSE * det) {
        return None;
    }
    let f = 1.0 / det;
    Some(Sym { xx: c.xx * f, yy: c.yy * f, zz: c.zz * f, xy: c.xy * f, xz: c.xz * f, yz: c.yz * f })
}

/// L M^-1, or L where M cannot be inverted.
pub fn corrected<const D: usize>(l: &Mat3, m: &Sym) -> Mat3 {
    match inverse::<D>(m) {
        Some(c) => l * c.to_matrix(),
        None => *l,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn neighbourhood(points: &[[f64; 3]]) -> (Sym, impl Fn(&Mat3) -> Mat3) {
        let points = points.to_vec();
        let mut m = Mat3::zeros();
        for p in &points {
            let x = nalgebra::Vector3::from(*p);
            m += x * x.transpose();
        }
        let sum = move |g: &Mat3| {
            points.iter().map(|p| nalgebra::Vector3::from(*p)).map(|x| (g * x) * x.transpose()).sum::<Mat3>()
        };
        (Sym::symmetric_part(&m), sum)
    }

    #[test]
    fn linear_fields_are_exact_even_one_sided() {
        let points = [[1.0, 0.1, 0.0], [0.2, 0.9, 0.3], [0.4, -0.8, 0.7], [0.5, 0.2, -0.9], [0.9, -0.3, -0.2]];
        let (m, sum) = neighbourhood(&points);
        let g = Mat3::new(0.0, -1.0, 0.4, 1.0, 0.3, 2.0, -0.4, -2.0, 0.1);
        assert!((corrected::<3>(&sum(&g), &m) - g).norm() < 1e-13);
    }

    /// Lines and planes of any direction, whose determinant is rounding noise of either sign.
    #[test]
    fn rounding_does_not_invert_lines_and_planes() {
        let draw = |k: u64, n: u64| crate::random::uniform(4, k, n) - 0.5;
        for k in 0..2000 {
            let axes: [[f64; 3]; 2] = std::array::from_fn(|a| std::array::from_fn(|c| draw(k, (3 * a + c) as u64)));
            let across = if k % 2 == 0 { 0.0 } else { 1.0 };
            let points: Vec<[f64; 3]> = (0..4)
                .map(|p| (draw(k, 10 + p), across * draw(k, 20 + p)))
                .map(|(u, w)| std::array::from_fn(|c| u * axes[0][c] + w * axes[1][c]))
                .collect();
            let (m, _) = neighbourhood(&points);
            assert_eq!(inverse::<3>(&m), None, "{points:?}");
        }
    }

    #[test]
    fn degenerate_neighbourhoods_fall_back() {
        for points in [
            vec![],
            vec![[1.0, 0.0, 0.0]],
            vec![[1.0, 1.0, 0.0], [-2.0, -2.0, 0.0]],
            vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.3, 0.0]],
            vec![[1.0, 0.0, 0.01], [0.0, 1.0, 0.0], [-1.0, 0.3, -0.01]],
            vec![[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]],
        ] {
            let (m, sum) = neighbourhood(&points);
            let g = Mat3::new(0.5, -1.0, 0.4, 1.0, 0.3, 2.0, -0.4, -2.0, 0.1);
            assert_eq!(corrected::<3>(&sum(&g), &m), sum(&g), "{points:?}");
        }
    }
}
