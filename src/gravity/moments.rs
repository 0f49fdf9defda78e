//! What a cell or a single body contributes at a distance.
//!
//! With x from the centre of mass of a cell to the target, second moments S = sum m d d^T about that centre and
//! Q = 3 S - tr(S) 1:  phi = -G [M / r + x.Q.x / (2 r^5)],  a = -grad phi = G [-M x / r^3 + Q x / r^5 - 5 (x.Q.x) x / (2 r^7)].

use super::{G, Source};
use crate::math::Vec3;

/// Mass, centre and second moments of some sources.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moments {
    /// kg.
    pub mass: f64,
    /// Centre of mass, m.
    pub centre: Vec3,
    /// sum m d d^T about the centre of mass, kg m^2: xx, yy, zz, xy, xz, yz.
    pub second: [f64; 6],
    /// Largest softening among the sources, m.
    pub softening: f64,
}

impl Moments {
    pub fn of_sources(sources: &[Source]) -> Self {
        Self::combine(sources.iter().map(|s| Self {
            mass: s.mass,
            centre: Vec3::from(s.position),
            second: [0.0; 6],
            softening: s.softening,
        }))
    }

    /// Moments of the union, summed in the order given (parallel axes theorem).
    pub fn combine(parts: impl Iterator<Item = Self> + Clone) -> Self {
        let (mut mass, mut weighted, mut softening) = (0.0, Vec3::zeros(), 0.0f64);
        for part in parts.clone() {
            mass += part.mass;
            weighted += part.centre * part.mass;
            softening = softening.max(part.softening);
        }
        let centre = weighted / mass;
        let mut second = [0.0; 6];
        for part in parts {
            let d = part.centre - centre;
            let shifted = [d.x * d.x, d.y * d.y, d.z * d.z, d.x * d.y, d.x * d.z, d.y * d.z];
            for k in 0..6 {
                second[k] += part.second[k] + part.mass * shifted[k];
            }
        }
        Self { mass, centre, second, softening }
    }

    /// Q x, with Q = 3 S - tr(S) 1.
    #[inline]
    fn quadrupole_times(&self, x: &Vec3) -> Vec3 {
        let [xx, yy, zz, xy, xz, yz] = self.second;
        let sx = xx * x.x + xy * x.y + xz * x.z;
        let sy = xy * x.x + yy * x.y + yz * x.z;
        let sz = xz * x.x + yz * x.y + zz * x.z;
        3.0 * Vec3::new(sx, sy, sz) - x * (xx + yy + zz)
    }
}

/// Something that adds up over cells and bodies: potential, acceleration.
pub trait Field: Default + Send {
    /// Adds an expanded cell; `x` leads from its centre of mass to the target, `r2 = x.x`.
    fn add_cell(&mut self, cell: &Moments, x: &Vec3, r2: f64);
    /// Adds one body of mass `mass`, softened with `h`; `x` leads from it to the target.
    fn add_body(&mut self, mass: f64, h: f64, x: &Vec3);
}

/// Specific potential, J/kg.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Potential(pub f64);

impl Field for Potential {
    #[inline]
    fn add_cell(&mut self, cell: &Moments, x: &Vec3, r2: f64) {
        let inverse = 1.0 / r2.sqrt();
        let inverse2 = inverse * inverse;
        let xqx = x.dot(&cell.quadrupole_times(x));
        self.0 -= G * inverse * (cell.mass + 0.5 * xqx * inverse2 * inverse2);
    }

    #[inline]
    fn add_body(&mut self, mass: f64, h: f64, x: &Vec3) {
        self.0 -= G * mass * spline_potential(x.norm_squared().sqrt(), h);
    }
}

/// Acceleration, m/s^2.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Acceleration(pub Vec3);

impl Field for Acceleration {
    #[inline]
    fn add_cell(&mut self, cell: &Moments, x: &Vec3, r2: f64) {
        let inverse2 = 1.0 / r2;
        let inverse3 = inverse2 * inverse2.sqrt();
        let qx = cell.quadrupole_times(x);
        let radial = cell.mass + 2.5 * x.dot(&qx) * inverse2 * inverse2;
        self.0 += (qx * inverse2 - x * radial) * (G * inverse3);
    }

    #[inline]
    fn add_body(&mut self, mass: f64, h: f64, x: &Vec3) {
        self.0 -= x * (G * mass * spline_force_over_r(x.norm_squared().sqrt(), h));
    }
}

/// -phi / (G m) of the softened body, 1/m (Price and Monaghan 2007, appendix A; support 2h).
#[inline]
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
#[inline]
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

    /// Two masses on a line, whose field is known: the error of the expansion falls as r^-5, two orders beyond the quadrupole.
    #[test]
    fn quadrupole_is_right_to_the_next_even_order() {
        let source = |x: f64| Source { id: 0, position: [x, 0.2, -0.1], mass: 3.0, softening: 1e-3 };
        let pair = [source(1.0), source(-1.0)];
        let moments = Moments::of_sources(&pair);
        let error = |distance: f64| {
            let place = Vec3::new(0.6, 0.64, 0.48).normalize() * distance;
            let (mut exact, mut expanded) =
                ((Potential::default(), Acceleration::default()), (Potential::default(), Acceleration::default()));
            for s in &pair {
                let x = place - Vec3::from(s.position);
                exact.0.add_body(s.mass, s.softening, &x);
                exact.1.add_body(s.mass, s.softening, &x);
            }
            let x = place - moments.centre;
            expanded.0.add_cell(&moments, &x, x.norm_squared());
            expanded.1.add_cell(&moments, &x, x.norm_squared());
            ((exact.0.0 - expanded.0.0).abs() / G, (exact.1.0 - expanded.1.0).norm() / G)
        };
        let (near, far) = (error(8.0), error(16.0));
        assert!((25.0..40.0).contains(&(near.0 / far.0)), "{}", near.0 / far.0);
        assert!((50.0..80.0).contains(&(near.1 / far.1)), "{}", near.1 / far.1);
    }

    #[test]
    fn combining_equals_summing_at_once() {
        let s = |id: u64, x: f64| Source { id, position: [x, x * x, 1.0 - x], mass: 1.0 + x, softening: x.abs() + 0.1 };
        let all: Vec<_> = (0..9).map(|i| s(i, i as f64 * 0.3 - 1.0)).collect();
        let whole = Moments::of_sources(&all);
        let joined = Moments::combine([&all[..4], &all[4..]].map(Moments::of_sources).into_iter());
        assert!((whole.centre - joined.centre).norm() < 1e-14);
        assert!(whole.second.iter().zip(joined.second).all(|(a, b)| (a - b).abs() < 1e-13));
        assert_eq!(whole.softening, joined.softening);
    }
}
