//! Tensors of the local (per particle) physics. They are three-dimensional in 2D too: plane strain has an out-of-plane
//! stress, and one formula then serves both dimensions. The pair loop, where the cost is, has its own flat arithmetic.

pub type Vec3 = nalgebra::Vector3<f64>;
pub type Mat3 = nalgebra::Matrix3<f64>;

/// Symmetric tensor, components xx, yy, zz, xy, xz, yz.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Sym {
    pub xx: f64,
    pub yy: f64,
    pub zz: f64,
    pub xy: f64,
    pub xz: f64,
    pub yz: f64,
}

/// Traceless symmetric tensor; zz = -(xx + yy) is not stored.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Deviator {
    pub xx: f64,
    pub yy: f64,
    pub xy: f64,
    pub xz: f64,
    pub yz: f64,
}

impl Sym {
    /// Cofactors: the inverse times the determinant.
    #[inline(always)]
    pub fn cofactors(&self) -> Self {
        Self {
            xx: self.yy * self.zz - self.yz * self.yz,
            yy: self.xx * self.zz - self.xz * self.xz,
            zz: self.xx * self.yy - self.xy * self.xy,
            xy: self.xz * self.yz - self.xy * self.zz,
            xz: self.xy * self.yz - self.xz * self.yy,
            yz: self.xy * self.xz - self.yz * self.xx,
        }
    }

    /// The determinant, where the cofactors are known.
    #[inline(always)]
    pub fn determinant(&self, cofactors: &Self) -> f64 {
        self.xx * cofactors.xx + self.xy * cofactors.xy + self.xz * cofactors.xz
    }

    pub const ZERO: Self = Self { xx: 0.0, yy: 0.0, zz: 0.0, xy: 0.0, xz: 0.0, yz: 0.0 };

    /// Symmetric part of a matrix.
    #[inline]
    pub fn symmetric_part(l: &Mat3) -> Self {
        Self {
            xx: l[(0, 0)],
            yy: l[(1, 1)],
            zz: l[(2, 2)],
            xy: 0.5 * (l[(0, 1)] + l[(1, 0)]),
            xz: 0.5 * (l[(0, 2)] + l[(2, 0)]),
            yz: 0.5 * (l[(1, 2)] + l[(2, 1)]),
        }
    }

    #[inline]
    pub fn trace(&self) -> f64 {
        self.xx + self.yy + self.zz
    }

    #[inline]
    pub fn to_matrix(&self) -> Mat3 {
        Mat3::new(self.xx, self.xy, self.xz, self.xy, self.yy, self.yz, self.xz, self.yz, self.zz)
    }

    /// Principal values and the matrix whose columns are their directions, by cyclic Jacobi rotations: square roots and
    /// divisions only, so the bits do not depend on a mathematical library.
    pub fn principal(&self) -> ([f64; 3], Mat3) {
        let mut a = self.to_matrix();
        let mut axes = Mat3::identity();
        for _sweep in 0..12 {
            let off = a[(0, 1)].abs() + a[(0, 2)].abs() + a[(1, 2)].abs();
            let size = a[(0, 0)].abs() + a[(1, 1)].abs() + a[(2, 2)].abs();
            if off <= 1e-15 * size || off == 0.0 {
                break;
            }
            for (p, q) in [(0, 1), (0, 2), (1, 2)] {
                let apq = a[(p, q)];
                if apq == 0.0 {
                    continue;
                }
                let theta = (a[(q, q)] - a[(p, p)]) / (2.0 * apq);
                let t = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
                let c = 1.0 / (t * t + 1.0).sqrt();
                let s = t * c;
                for k in 0..3 {
                    let (akp, akq) = (a[(k, p)], a[(k, q)]);
                    a[(k, p)] = c * akp - s * akq;
                    a[(k, q)] = s * akp + c * akq;
                }
                for k in 0..3 {
                    let (apk, aqk) = (a[(p, k)], a[(q, k)]);
                    a[(p, k)] = c * apk - s * aqk;
                    a[(q, k)] = s * apk + c * aqk;
                }
                for k in 0..3 {
                    let (vkp, vkq) = (axes[(k, p)], axes[(k, q)]);
                    axes[(k, p)] = c * vkp - s * vkq;
                    axes[(k, q)] = s * vkp + c * vkq;
                }
            }
        }
        ([a[(0, 0)], a[(1, 1)], a[(2, 2)]], axes)
    }

    /// Largest principal value.
    pub fn largest_principal(&self) -> f64 {
        let (values, _) = self.principal();
        values[0].max(values[1]).max(values[2])
    }
}

impl Deviator {
    #[inline]
    pub fn zz(&self) -> f64 {
        -(self.xx + self.yy)
    }

    /// The deviatoric part of a symmetric tensor, times a factor.
    #[inline]
    pub fn of(e: &Sym, factor: f64) -> Self {
        let mean = e.trace() / 3.0;
        Self {
            xx: factor * (e.xx - mean),
            yy: factor * (e.yy - mean),
            xy: factor * e.xy,
            xz: factor * e.xz,
            yz: factor * e.yz,
        }
    }

    /// J2 = S:S / 2, Pa^2.
    #[inline]
    pub fn j2(&self) -> f64 {
        let zz = self.zz();
        0.5 * (self.xx * self.xx + self.yy * self.yy + zz * zz)
            + self.xy * self.xy
            + self.xz * self.xz
            + self.yz * self.yz
    }

    #[inline]
    pub fn scaled(&self, f: f64) -> Self {
        Self { xx: f * self.xx, yy: f * self.yy, xy: f * self.xy, xz: f * self.xz, yz: f * self.yz }
    }

    #[inline]
    pub fn plus(&self, o: &Self) -> Self {
        Self { xx: self.xx + o.xx, yy: self.yy + o.yy, xy: self.xy + o.xy, xz: self.xz + o.xz, yz: self.yz + o.yz }
    }

    /// S scaled plus an isotropic part on the diagonal.
    #[inline]
    pub fn with_mean(&self, factor: f64, mean: f64) -> Sym {
        Sym {
            xx: factor * self.xx + mean,
            yy: factor * self.yy + mean,
            zz: factor * self.zz() + mean,
            xy: factor * self.xy,
            xz: factor * self.xz,
            yz: factor * self.yz,
        }
    }

    /// Omega S - S Omega with the spin Omega = (L - L^T)/2: the stress rotates with the body (Jaumann rate).
    #[inline]
    pub fn turned_by(&self, l: &Mat3) -> Self {
        let (wxy, wxz, wyz) =
            (0.5 * (l[(0, 1)] - l[(1, 0)]), 0.5 * (l[(0, 2)] - l[(2, 0)]), 0.5 * (l[(1, 2)] - l[(2, 1)]));
        let zz = self.zz();
        Self {
            xx: 2.0 * (wxy * self.xy + wxz * self.xz),
            yy: 2.0 * (-wxy * self.xy + wyz * self.yz),
            xy: wxy * (self.yy - self.xx) + wxz * self.yz + wyz * self.xz,
            xz: wxz * (zz - self.xx) + wxy * self.yz - wyz * self.xy,
            yz: wyz * (zz - self.yy) - wxy * self.xz - wxz * self.xy,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix(s: &Deviator) -> Mat3 {
        s.with_mean(1.0, 0.0).to_matrix()
    }

    #[test]
    fn jaumann_terms_equal_the_matrix_products() {
        let l = Mat3::new(0.3, -1.2, 0.7, 2.0, 0.1, -0.4, 0.9, 1.7, -0.6);
        let s = Deviator { xx: 1.0, yy: -3.0, xy: 0.5, xz: 2.5, yz: -1.5 };
        let w = 0.5 * (l - l.transpose());
        let expected = w * matrix(&s) - matrix(&s) * w;
        assert!((matrix(&s.turned_by(&l)) - expected).norm() < 1e-14);
    }

    /// Rotating diag(1, -1, 0) by 45 degrees (counter-clockwise) gives S_xy = +1.
    #[test]
    fn rotation_by_45_degrees_gives_positive_shear() {
        let l = Mat3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0);
        let mut s = Deviator { xx: 1.0, yy: -1.0, ..Default::default() };
        let n = 100_000;
        let dt = std::f64::consts::FRAC_PI_4 / n as f64;
        for _ in 0..n {
            let half = s.plus(&s.turned_by(&l).scaled(0.5 * dt));
            s = s.plus(&half.turned_by(&l).scaled(dt));
        }
        assert!((s.xy - 1.0).abs() < 1e-8 && s.xx.abs() < 1e-8, "{s:?}");
    }

    #[test]
    fn principal_values_rebuild_the_tensor() {
        let s = Sym { xx: 4.0, yy: -1.0, zz: 2.5, xy: 0.3, xz: -2.0, yz: 1.1 };
        let (values, axes) = s.principal();
        let d = Mat3::from_diagonal(&Vec3::new(values[0], values[1], values[2]));
        assert!((axes * d * axes.transpose() - s.to_matrix()).norm() < 1e-12);
    }
}
