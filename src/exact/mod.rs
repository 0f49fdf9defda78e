//! Exact solutions that scenes are compared with: pure functions of physical parameters in SI units, or in any consistent ones
//! where no material law enters. One file, one kind of solution; it opens with the equations and their source.
//!
//! A solution lives along one coordinate: x of a plane wave, r of a blast or of a vibrating body.

pub mod compaction;
pub mod grady_kipp;
pub mod noh;
pub mod piston;
pub mod riemann;
pub mod sedov;
pub mod shear_layer;
pub mod shock;
pub mod vibration;
pub mod waves;

use crate::error::{Error, Result};

/// State of a solution at a place along its coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct State {
    /// kg/m^3.
    pub density: f64,
    /// Along the coordinate, m/s.
    pub velocity: f64,
    /// Along the coordinate, positive in compression, Pa; the pressure of a fluid.
    pub stress: f64,
    /// Specific, J/kg.
    pub internal_energy: f64,
    /// Zero where the solution has no pores.
    pub distention: f64,
}

/// Fails unless all parameters, named for the message, are finite and above zero.
fn all_positive(parameters: &[(&str, f64)]) -> Result<()> {
    all_above(0.0, parameters)
}

/// Fails unless all parameters, named for the message, are finite and above `bound`.
fn all_above(bound: f64, parameters: &[(&str, f64)]) -> Result<()> {
    match parameters.iter().find(|(_, value)| !(*value > bound && value.is_finite())) {
        Some((name, value)) => {
            Err(Error::new(format!("{name} is {value:e}")).allowed(format!("finite numbers above {bound}")))
        }
        None => Ok(()),
    }
}

/// The surface of a sphere of radius 1 in `dimension` dimensions: 2 (both sides of a plane), 2 pi, 4 pi. Fails for other
/// dimensions.
fn unit_surface(dimension: usize) -> Result<f64> {
    use std::f64::consts::PI;
    match dimension {
        1 => Ok(2.0),
        2 => Ok(2.0 * PI),
        3 => Ok(4.0 * PI),
        _ => Err(Error::new(format!("the dimension is {dimension}")).allowed("1, 2, 3")),
    }
}

/// The place between `low` and `high` where `f` changes sign, by bisection down to neighbouring numbers; fails where `f` has
/// the same sign at both ends or is NaN there. An end where `f` is zero is the answer.
fn root(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> Result<f64> {
    let (at_low, at_high) = (f(low), f(high));
    if at_low == 0.0 || at_high == 0.0 {
        return Ok(if at_low == 0.0 { low } else { high });
    }
    let bracketed = at_low * at_high.signum() < 0.0;
    if !bracketed {
        return Err(Error::new(format!("no solution between {low:e} and {high:e}")));
    }
    loop {
        let middle = low + 0.5 * (high - low);
        if middle <= low || middle >= high {
            return Ok(middle);
        }
        if f(middle) * at_low.signum() > 0.0 { low = middle } else { high = middle }
    }
}

/// A bound above `start` at which `reached`, by doubling; fails where there is none.
fn doubled_until(start: f64, reached: impl Fn(f64) -> bool) -> Result<f64> {
    let mut bound = start;
    while !reached(bound) {
        bound *= 2.0;
        if !bound.is_normal() {
            return Err(Error::new(format!("no solution above {start:e}")));
        }
    }
    Ok(bound)
}

/// One step of the classical Runge-Kutta method for dy/dx = `slope`(x, y), from `y` at `x` to x + `step`.
fn runge_kutta<const N: usize>(
    x: f64,
    y: &[f64; N],
    step: f64,
    slope: impl Fn(f64, &[f64; N]) -> [f64; N],
) -> [f64; N] {
    let ahead = |by: f64, k: &[f64; N]| std::array::from_fn(|i| y[i] + by * k[i]);
    let half = 0.5 * step;
    let k1 = slope(x, y);
    let k2 = slope(x + half, &ahead(half, &k1));
    let k3 = slope(x + half, &ahead(half, &k2));
    let k4 = slope(x + step, &ahead(step, &k3));
    std::array::from_fn(|i| y[i] + step / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_bracketed() {
        assert!((root(0.0, 2.0, |x| x * x - 2.0).unwrap() - 2f64.sqrt()).abs() <= f64::EPSILON);
        assert!((root(0.0, 1.0, |x| 1e-200 - x).unwrap() / 1e-200 - 1.0).abs() < 1e-15);
        assert_eq!(root(0.0, 1.0, |x| x).unwrap(), 0.0);
        assert!(root(0.0, 1.0, |_| f64::NAN).is_err() && root(0.0, 1.0, |x| x + 1.0).is_err());
        assert_eq!(doubled_until(1.0, |x| x > 5.0).unwrap(), 8.0);
        assert!(doubled_until(1.0, |_| false).is_err() && doubled_until(0.0, |_| false).is_err());
    }
}
