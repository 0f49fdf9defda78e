//! Growth of small waves on a layer between two streams of one incompressible fluid (Rayleigh 1880, Proc. London Math. Soc. 11, 57;
//! Drazin & Reid 2004, Hydrodynamic Stability, Sec. 23). The speed changes evenly from -U to U within a half width b:
//!
//! ```text
//! growth = U / (2 b) sqrt(exp(-4 k b) - (2 k b - 1)^2)      k wavenumber
//! ```
//! Waves with k b above 0.64 are stable; those of 0.40 grow fastest, by 0.20 U / b.

use super::all_positive;
use crate::error::{Error, Result};

/// 1/s; `speed` U, m/s, `half_width` b, m, `wavenumber` k, 1/m. Fails for waves that do not grow.
pub fn growth(speed: f64, half_width: f64, wavenumber: f64) -> Result<f64> {
    all_positive(&[("the speed", speed), ("the half width", half_width), ("the wavenumber", wavenumber)])?;
    let kb = wavenumber * half_width;
    let square = libm::exp(-4.0 * kb) - (2.0 * kb - 1.0) * (2.0 * kb - 1.0);
    if square <= 0.0 {
        let what = format!("waves of k b = {kb:.3} on a layer of this half width b are stable");
        return Err(Error::new(what).allowed("k b below 0.639"));
    }
    Ok(0.5 * speed / half_width * square.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_waves_grow_as_on_a_sheet_and_short_ones_not_at_all() {
        assert!((growth(2.0, 0.5, 0.8).unwrap() / (0.2012 * 2.0 / 0.5) - 1.0).abs() < 1e-3);
        // Kelvin and Helmholtz: k U.
        assert!((growth(3.0, 1e-6, 10.0).unwrap() / 30.0 - 1.0).abs() < 1e-4);
        assert!(growth(1.0, 1.0, 0.638).is_ok() && growth(1.0, 1.0, 0.641).is_err() && growth(1.0, 0.0, 1.0).is_err());
    }
}
