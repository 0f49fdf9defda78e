//! The field as a plain sum over bodies: the reference for the multipoles.

use super::{Body, Field};
use crate::gravity::G;

/// The field of all bodies at a target, itself left out by its id; SI units.
pub fn direct(bodies: &[Body], target: &Body) -> Field {
    let mut field = Field::default();
    for body in bodies.iter().filter(|body| body.id != target.id) {
        let x: [f64; 3] = std::array::from_fn(|k| target.position[k] - body.position[k]);
        let (r, h) = (x.iter().map(|x| x * x).sum::<f64>().sqrt(), body.softening.max(target.softening));
        let pull = G * body.mass * spline_force_over_r(r, h);
        field.acceleration.iter_mut().zip(x).for_each(|(a, x)| *a -= pull * x);
        field.potential -= G * body.mass * spline_potential(r, h);
    }
    field
}

/// -phi / (G m) of the softened body, 1/m (Price and Monaghan 2007, appendix A; support 2h).
fn spline_potential(r: f64, h: f64) -> f64 {
    if r >= 2.0 * h {
        return 1.0 / r;
    }
    let q = r / h;
    let q2 = q * q;
    if q < 1.0 {
        (1.4 - q2 * (2.0 / 3.0 - q2 * (0.3 - 0.1 * q))) / h
    } else {
        (1.6 - 1.0 / (15.0 * q) - q2 * (4.0 / 3.0 - q + q2 * (0.3 - q / 30.0))) / h
    }
}

/// phi'(r) / (G m r) of the softened body, 1/m^3 (Price and Monaghan 2007, appendix A).
fn spline_force_over_r(r: f64, h: f64) -> f64 {
    if r >= 2.0 * h {
        return 1.0 / (r * r * r);
    }
    let q = r / h;
    let h3 = h * h * h;
    if q < 1.0 {
        (4.0 / 3.0 - q * q * (1.2 - 0.5 * q)) / h3
    } else {
        (8.0 / 3.0 - 3.0 * q + q * q * (1.2 - q / 6.0) - 1.0 / (15.0 * q * q * q)) / h3
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spline_is_continuous_and_its_slope_is_the_force() {
        let h = 0.7;
        for (near, far) in [(1.0 - 1e-12, 1.0 + 1e-12), (2.0 - 1e-12, 2.0 + 1e-12)] {
            assert!((spline_potential(near * h, h) - spline_potential(far * h, h)).abs() < 1e-11);
            assert!((spline_force_over_r(near * h, h) - spline_force_over_r(far * h, h)).abs() < 1e-10);
        }
        for r in [0.1, 0.4, 0.69, 0.8, 1.1, 1.39, 1.5, 4.0] {
            let e = 1e-5;
            let slope = (spline_potential(r + e, h) - spline_potential(r - e, h)) / (2.0 * e);
            assert!((slope + r * spline_force_over_r(r, h)).abs() < 1e-8, "r = {r}");
        }
        assert!((spline_potential(0.0, h) - 1.4 / h).abs() < 1e-15);
    }
}
