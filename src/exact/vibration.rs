//! Free vibrations of elastic bodies: spheres, discs in plane strain, a clamped plate, a free bar. Love 1944, chapters XII and
//! XVII; Graff 1975, chapters 3 and 8; Landau & Lifshitz 1986, sections 22, 25; Gray, Monaghan & Swift 2001 for the plate.
//!
//! ```text
//! sphere, radial     u_r = j_1(k r)                             x j_0(x) = 4 g j_1(x)      omega = x c_L / R
//! disc, radial       u_r = J_1(k r)                             x J_0(x) = 2 g J_1(x)      omega = x c_L / R
//! sphere, torsional  u_phi = j_2(k r) sin(2 theta)              x j_1(x) = 4 j_2(x)        omega = x c_S / R
//! disc, torsional    u_phi = J_1(k r)                           J_2(x) = 0                 omega = x c_S / R
//! clamped plate      w = cosh y - cos y - q (sinh y - sin y)    cos x cosh x = -1          omega = (x / L)^2 H sqrt(E' / (12 rho))
//! free bar           u_x = cos(k s)                             x = n pi                   omega = x c / L
//! ```
//! x = k R or k L, y = k s, g = (c_S / c_L)^2, q = (cosh x + cos x) / (sinh x + sin x); j and J Bessel functions, theta the angle
//! from the axis, s the distance from the clamped or a free end, L length, H thickness, E' Young's modulus in plane strain. In
//! the torsional mode of the sphere the hemispheres rotate against each other; that of the disc is that of a long cylinder too.

use std::f64::consts::PI;

use super::waves::Elastic;
use super::{all_positive, root};
use crate::error::{Error, Result};

/// A mode of vibration: displacement = amplitude x at(s) x sin(angular_frequency t).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mode {
    /// rad/s.
    pub angular_frequency: f64,
    shape: ModeFunction,
    /// R or L, m.
    size: f64,
    /// k R or k L.
    root: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum ModeFunction {
    Sphere { order: usize },
    Disc,
    Plate,
    Bar,
}

impl Mode {
    fn new(shape: ModeFunction, size: f64, speed: f64, root: f64) -> Result<Self> {
        all_positive(&[("the size", size), ("the speed", speed)])?;
        Ok(Self { angular_frequency: root * speed / size, shape, size, root })
    }

    /// s.
    pub fn period(&self) -> f64 {
        2.0 * PI / self.angular_frequency
    }

    /// Displacement, or velocity, at the distance `s`, m, from the centre, the clamped or a free end; over that at the surface
    /// or a free end.
    pub fn at(&self, s: f64) -> f64 {
        let y = self.root * (s / self.size);
        match self.shape {
            ModeFunction::Sphere { order } => spherical_bessel(order, y) / spherical_bessel(order, self.root),
            ModeFunction::Disc => libm::j1(y) / libm::j1(self.root),
            ModeFunction::Plate => bent(self.root, y) / bent(self.root, self.root),
            ModeFunction::Bar => libm::cos(y),
        }
    }
}

/// `n`-th radial mode of a sphere, n = 1, 2, ...
pub fn sphere_radial(solid: &Elastic, radius: f64, n: usize) -> Result<Mode> {
    let x = nth_root(n, |x| libm::sin(x) - 4.0 * softness(solid) * spherical_bessel(1, x))?;
    Mode::new(ModeFunction::Sphere { order: 1 }, radius, solid.longitudinal_speed(), x)
}

/// `n`-th radial mode of a disc in plane strain, n = 1, 2, ...
pub fn disc_radial(solid: &Elastic, radius: f64, n: usize) -> Result<Mode> {
    let x = nth_root(n, |x| x * libm::j0(x) - 2.0 * softness(solid) * libm::j1(x))?;
    Mode::new(ModeFunction::Disc, radius, solid.longitudinal_speed(), x)
}

/// `n`-th torsional mode of degree 2 of a sphere, n = 1, 2, ...; at(r) is that at 45 degrees from the axis.
pub fn sphere_torsional(solid: &Elastic, radius: f64, n: usize) -> Result<Mode> {
    let x = nth_root(n, |x| x * spherical_bessel(1, x) - 4.0 * spherical_bessel(2, x))?;
    Mode::new(ModeFunction::Sphere { order: 2 }, radius, solid.shear_speed(), x)
}

/// `n`-th torsional mode of a disc, n = 1, 2, ...
pub fn disc_torsional(solid: &Elastic, radius: f64, n: usize) -> Result<Mode> {
    Mode::new(ModeFunction::Disc, radius, solid.shear_speed(), nth_root(n, |x| libm::jn(2, x))?)
}

/// `n`-th mode, n = 1, 2, ..., of a thin plate in plane strain that is clamped at one end. Rotation of its sections and their
/// shear are left out, which lengthen the period by a part in (thickness / length)^2.
pub fn clamped_plate(solid: &Elastic, length: f64, thickness: f64, n: usize) -> Result<Mode> {
    all_positive(&[("the length", length), ("the thickness", thickness)])?;
    let x = nth_root(n, |x| libm::cos(x) + 1.0 / libm::cosh(x))?;
    Mode::new(ModeFunction::Plate, length, x * thickness / length * solid.plate_speed() / 12f64.sqrt(), x)
}

/// `n`-th longitudinal mode, n = 1, 2, ..., of a bar that is free at both ends, with waves of the given `speed`, m/s: that of a
/// bar, a plate or a column.
pub fn free_bar(speed: f64, length: f64, n: usize) -> Result<Mode> {
    at_least_first(n)?;
    Mode::new(ModeFunction::Bar, length, speed, n as f64 * PI)
}

/// g.
fn softness(solid: &Elastic) -> f64 {
    let ratio = solid.shear_speed() / solid.longitudinal_speed();
    ratio * ratio
}

fn at_least_first(n: usize) -> Result<()> {
    if n == 0 { Err(Error::new("the mode is 0").allowed("1, 2, ...")) } else { Ok(()) }
}

/// The `n`-th positive root of an `f` with roots of order 1 apart and without end.
fn nth_root(n: usize, f: impl Fn(f64) -> f64) -> Result<f64> {
    at_least_first(n)?;
    /// Small against the distance of two roots, so that none is missed.
    const STEP: f64 = 0.05;
    let (mut low, mut found) = (1e-6, 0);
    loop {
        let high = low + STEP;
        found += usize::from((f(low) > 0.0) != (f(high) > 0.0));
        if found == n {
            return root(low, high, f);
        }
        low = high;
    }
}

/// j_1 or j_2.
fn spherical_bessel(order: usize, y: f64) -> f64 {
    if y.abs() < 1.0 {
        // The closed forms lose digits: y^l / (2l+1)!! sum over i of (-y^2/2)^i / (i! (2l+3) (2l+5) ... (2l+1+2i)).
        let mut term = if order == 1 { y / 3.0 } else { y * y / 15.0 };
        let mut sum = 0.0;
        for i in 1..10 {
            sum += term;
            term *= -0.5 * y * y / (i * (2 * order + 1 + 2 * i)) as f64;
        }
        return sum;
    }
    let (sin, cos) = (libm::sin(y), libm::cos(y));
    let first = (sin / y - cos) / y;
    if order == 1 { first } else { (3.0 * first - sin) / y }
}

/// Bending of the clamped plate with k L = `x` at k s = `y`, with the growing exponential taken apart: its factor is small.
fn bent(x: f64, y: f64) -> f64 {
    let below = libm::sinh(x) + libm::sin(x);
    let one_less_q = (libm::sin(x) - libm::cos(x) - libm::exp(-x)) / below;
    let q = 1.0 - one_less_q;
    0.5 * (1.0 + q) * libm::exp(-y) + 0.5 * one_less_q * libm::exp(y) - libm::cos(y) + q * libm::sin(y)
}

#[cfg(test)]
mod tests {
    use super::super::waves::tests::{basalt, rubber};
    use super::*;

    fn near(a: f64, b: f64, tolerance: f64) {
        assert!((a / b - 1.0).abs() < tolerance, "{a} {b}");
    }

    /// Roots of Love's equations found independently, to the digits given.
    #[test]
    fn tabulated_modes() {
        let radial = sphere_radial(&basalt(), 1.0, 1).unwrap();
        near(radial.root, 2.3981056, 1e-7);
        near(radial.period(), 5.704e-4, 1e-4);
        let torsional = sphere_torsional(&basalt(), 1.0, 1).unwrap();
        near(torsional.root, 2.5011326, 1e-7);
        near(torsional.period(), 8.664e-4, 1e-4);
        near(sphere_radial(&rubber(), 1.0, 1).unwrap().period(), 1.911, 3e-4);
        near(sphere_torsional(&rubber(), 1.0, 1).unwrap().period(), 5.356, 1e-4);
        near(sphere_radial(&Elastic::new(1.0, 1.0, 1.0).unwrap(), 1.0, 1).unwrap().period(), 1.7785, 1e-4);
        let plate = clamped_plate(&Elastic::new(3.25e6, 7.15e5, 1000.0).unwrap(), 0.2, 0.02, 1).unwrap();
        near(plate.angular_frequency, 24.724369, 1e-7);
        near(plate.period(), 0.2541292, 1e-6);
        // Abramowitz & Stegun 1964, table 9.5.
        near(disc_torsional(&rubber(), 1.0, 1).unwrap().root, 5.13562, 1e-6);
        near(disc_torsional(&rubber(), 1.0, 3).unwrap().root, 11.61984, 1e-6);
        near(free_bar(5000.0, 0.4, 2).unwrap().period(), 0.4 / 5000.0, 1e-14);
    }

    /// First and second derivatives of a mode by central differences, with errors of order (k d)^2.
    fn derivatives(mode: &Mode, s: f64) -> [f64; 2] {
        let d = 1e-4 * mode.size;
        let (before, here, after) = (mode.at(s - d), mode.at(s), mode.at(s + d));
        [(after - before) / (2.0 * d), (after - 2.0 * here + before) / (d * d)]
    }

    /// The equation of motion within and no stress at the surface: u'' + m u' / r - q u / r^2 = -(omega / c)^2 u.
    #[test]
    fn round_bodies_obey_the_equation_of_motion() {
        let radius = 0.3;
        for solid in [basalt(), rubber(), Elastic::new(0.02, 1.0, 2.0).unwrap()] {
            let lambda = solid.bulk_modulus - 2.0 / 3.0 * solid.shear_modulus;
            let stiff = lambda + 2.0 * solid.shear_modulus;
            let (c_l, c_s) = (solid.longitudinal_speed(), solid.shear_speed());
            for n in 1..=4 {
                // Mode, speed, m, q, u' R / u at the surface, and nodes between centre and surface.
                for (mode, speed, m, q, surface, nodes) in [
                    (sphere_radial(&solid, radius, n), c_l, 2.0, 2.0, -2.0 * lambda / stiff, n - 1),
                    (disc_radial(&solid, radius, n), c_l, 1.0, 1.0, -lambda / stiff, n - 1),
                    (sphere_torsional(&solid, radius, n), c_s, 2.0, 6.0, 1.0, n - 1),
                    (disc_torsional(&solid, radius, n), c_s, 1.0, 1.0, 1.0, n),
                ] {
                    let mode = mode.unwrap();
                    let k = mode.angular_frequency / speed;
                    for part in [0.02, 0.1, 0.4, 0.77, 1.0] {
                        let r = part * radius;
                        let [first, second] = derivatives(&mode, r);
                        let residual = second + m * first / r + (k * k - q / (r * r)) * mode.at(r);
                        assert!(residual.abs() < 1e-5 * (second.abs() + k * k + 1.0 / (r * r)), "{mode:?} {part}");
                    }
                    assert_eq!(mode.at(radius), 1.0);
                    assert!((derivatives(&mode, radius)[0] * radius - surface).abs() < 1e-5 * mode.root * mode.root);
                    let at = |i: i32| mode.at(f64::from(i) * 1e-3 * radius);
                    assert_eq!((1..1000).filter(|&i| at(i) * at(i + 1) < 0.0).count(), nodes, "{mode:?}");
                    assert_eq!(at(0), 0.0);
                }
            }
        }
    }

    /// w'''' = k^4 w; w = w' = 0 at the clamped end, w'' = w''' = 0 at the free one. Also far up, where the hyperbolic functions
    /// alone would lose all digits.
    #[test]
    fn plate_bends_by_the_beam_equation() {
        for n in [1, 2, 5, 15] {
            let plate = clamped_plate(&rubber(), 2.0, 0.1, n).unwrap();
            let k = plate.root / 2.0;
            let bend = |s: f64| derivatives(&plate, s)[1] / (k * k);
            for s in [0.3, 1.1, 1.7] {
                let d = 0.02 / k;
                let fourth = (bend(s + d) - 2.0 * bend(s) + bend(s - d)) / (d * d * k * k);
                assert!((fourth - plate.at(s)).abs() < 1e-3, "{n} {s}: {fourth} {}", plate.at(s));
            }
            assert!(plate.at(0.0).abs() < 1e-13 && (derivatives(&plate, 0.0)[0] / k).abs() < 1e-3, "{n}");
            assert!(plate.at(2.0) == 1.0 && bend(2.0).abs() < 1e-3, "{n}");
            let twist = (bend(2.0) - bend(2.0 - 1e-3 / k)) / 1e-3;
            assert!(twist.abs() < 1e-2, "{n} {twist}");
        }
    }

    #[test]
    fn impossible_modes_are_refused() {
        assert!(sphere_radial(&rubber(), 1.0, 0).is_err() && free_bar(1.0, 1.0, 0).is_err());
        assert!(disc_radial(&rubber(), -1.0, 1).is_err() && clamped_plate(&rubber(), 1.0, 0.0, 1).is_err());
    }
}
