//! Rotations in space: unit quaternions, and the rotation vectors (axis times angle, rad) by which they change.
//!
//! ```text
//! q' = exp(theta) q          exp(theta): the rotation about theta by |theta|
//! d theta / dt = w - 1/2 theta x w + c theta x (theta x w),    c = (1 - |theta|/2 cot(|theta|/2)) / |theta|^2
//! ```
//! w: angular velocity in space, 1/s. The second line is what turns a method for ordinary numbers into one of the same order for
//! rotations (Munthe-Kaas 1999, Appl. Numer. Math. 29, 115): theta, counted from the beginning of a step, is a vector like any other.

use serde::{Deserialize, Serialize};

use crate::math::{Mat3, Vec3};

/// Angle below which functions of it are summed as series, rad.
const SMALL: f64 = 1e-2;

/// A rotation from the body's frame into space, as a unit quaternion w, x, y, z.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Orientation(pub [f64; 4]);

impl Default for Orientation {
    fn default() -> Self {
        Self([1.0, 0.0, 0.0, 0.0])
    }
}

impl Orientation {
    /// The orientation after a rotation by the vector `by`, rad.
    pub fn turned(&self, by: &Vec3) -> Self {
        let angle = by.norm();
        let half = 0.5 * angle;
        // sin(a/2) / a
        let share = if angle < SMALL {
            0.5 - angle * angle / 48.0 * (1.0 - angle * angle / 80.0)
        } else {
            libm::sin(half) / angle
        };
        let [w, x, y, z] = self.0;
        let (c, s) = (libm::cos(half), by * share);
        let q = [
            c * w - s.x * x - s.y * y - s.z * z,
            c * x + s.x * w + s.y * z - s.z * y,
            c * y - s.x * z + s.y * w + s.z * x,
            c * z + s.x * y - s.y * x + s.z * w,
        ];
        let norm = q.iter().map(|k| k * k).sum::<f64>().sqrt();
        Self(q.map(|k| k / norm))
    }

    /// The matrix that turns vectors of the body's frame into those of space.
    pub fn matrix(&self) -> Mat3 {
        let [w, x, y, z] = self.0;
        Mat3::new(
            1.0 - 2.0 * (y * y + z * z),
            2.0 * (x * y - w * z),
            2.0 * (x * z + w * y),
            2.0 * (x * y + w * z),
            1.0 - 2.0 * (x * x + z * z),
            2.0 * (y * z - w * x),
            2.0 * (x * z - w * y),
            2.0 * (y * z + w * x),
            1.0 - 2.0 * (x * x + y * y),
        )
    }

    /// Angle about z, rad, from -pi to pi: all there is in 2D.
    pub fn angle_about_z(&self) -> f64 {
        let [w, _, _, z] = self.0;
        2.0 * libm::atan2(if w < 0.0 { -z } else { z }, w.abs())
    }
}

/// Rate of the rotation vector `turned`, rad, at the angular velocity `spin`, 1/s.
pub fn turning(turned: &Vec3, spin: &Vec3) -> Vec3 {
    let angle = turned.norm();
    let square = angle * angle;
    let c = match angle < SMALL {
        true => (1.0 + square / 60.0) / 12.0,
        false => (1.0 - 0.5 * angle * libm::cos(0.5 * angle) / libm::sin(0.5 * angle)) / square,
    };
    let across = turned.cross(spin);
    spin - 0.5 * across + c * turned.cross(&across)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quarter_turn_about_z_takes_x_to_y() {
        let quarter = Orientation::default().turned(&Vec3::new(0.0, 0.0, std::f64::consts::FRAC_PI_2));
        let off = quarter.matrix() * Vec3::x() - Vec3::y();
        assert!(off.norm() < 1e-15 && (quarter.angle_about_z() - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
        // A turn comes back, by the other sign of the quaternion.
        let whole =
            (0..4).fold(Orientation::default(), |q, _| q.turned(&Vec3::new(0.0, 0.0, std::f64::consts::FRAC_PI_2)));
        assert!(whole.angle_about_z().abs() < 1e-15 && (whole.matrix() - Mat3::identity()).norm() < 1e-15);
    }

    /// The rate of the rotation vector is what makes exp(theta(t)) turn with the angular velocity.
    #[test]
    fn a_rotation_vector_follows_the_angular_velocity() {
        for scale in [1e-3, 0.5, 2.5] {
            let (theta, spin) = (Vec3::new(0.3, -0.5, 0.8) * scale, Vec3::new(0.7, 0.2, -0.4));
            let step = 1e-5;
            let at = |t: f64| Orientation::default().turned(&(theta + turning(&theta, &spin) * t)).matrix();
            let rate = (at(step) - at(-step)) / (2.0 * step);
            let expected = Mat3::new(0.0, -spin.z, spin.y, spin.z, 0.0, -spin.x, -spin.y, spin.x, 0.0) * at(0.0);
            assert!((rate - expected).norm() < 1e-9, "{scale}: {rate} {expected}");
        }
    }

    #[test]
    fn series_and_functions_meet() {
        let spin = Vec3::new(0.7, 0.2, -0.4);
        let [below, above] = [SMALL * (1.0 - 1e-12), SMALL * (1.0 + 1e-12)].map(|angle| {
            let theta = Vec3::new(0.0, angle, 0.0);
            (turning(&theta, &spin), Orientation::default().turned(&theta))
        });
        assert!((below.0 - above.0).norm() < 1e-12);
        assert!(below.1.0.iter().zip(above.1.0).all(|(a, b)| (a - b).abs() < 1e-13));
    }
}
