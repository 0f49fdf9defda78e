//! A wave on a layer between two streams against its exact growth. Of the layer above the centre of the body,
//!
//! ```text
//! A = | sum m v_y exp(i k x) w / sum m w^2 |     w = exp(-k |y - y_0|)     particles with y above the centre
//! ```
//! Error: `growth`, the slope of ln A over that of the solution, less one, from 1.5 times the time of growth on: until then what does not
//! grow of the first wave fades.

use super::solution::Growth;
use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::math::{ExactSum, Line};
use crate::output::summary::Figures;
use crate::step::Stepper;

/// Times the exact rate: when the slope begins to count.
const BEGIN: f64 = 1.5;

/// A now, m/s. Collective.
pub fn amplitude<const D: usize>(growth: &Growth, stepper: &Stepper<D>, comm: &Comm) -> f64 {
    let (columns, core) = (&stepper.columns, &stepper.settings.view.core);
    let mut sums = [ExactSum::new(), ExactSum::new(), ExactSum::new()];
    for i in 0..columns.len() {
        let body = columns.get(core.id, i).body();
        let (x, v) = (columns.get(core.position, i), columns.get(core.velocity, i));
        let (along, up) = (x.x - growth.centre[0], x.y - growth.centre[1]);
        if body != growth.body || up <= 0.0 {
            continue;
        }
        let w = growth.streams.reach(up - growth.streams.height);
        let m = stepper.settings.view.constants[body].particle_mass * w;
        let phase = growth.streams.wavenumber * along;
        sums[0].add(m * v.y * libm::sin(phase));
        sums[1].add(m * v.y * libm::cos(phase));
        sums[2].add(m * w);
    }
    let [sin, cos, all] = comm.sum_exactly(&mut sums)[..] else { return f64::NAN };
    libm::hypot(sin, cos) / all
}

/// The error of the rate.
pub fn compare(growth: &Growth, samples: &[[f64; 2]]) -> Result<Figures> {
    let counts = samples.iter().filter(|[t, a]| *t * growth.rate >= BEGIN && *a > 0.0);
    let counts: Vec<(f64, f64)> = counts.map(|&[t, a]| (t, libm::log(a))).collect();
    let Some(line) = Line::through(&counts).filter(|_| counts.len() >= 8) else {
        let what = format!("{} samples after {:.3e} s show no growth", counts.len(), BEGIN / growth.rate);
        return Err(Error::new(what).allowed("a longer run, or output.history_every small enough for 8 samples"));
    };
    Ok(Figures(vec![("growth".to_string(), line.slope / growth.rate - 1.0)]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Streams;

    #[test]
    fn the_slope_is_found_once_the_rest_has_faded() {
        let streams = Streams { speed: 1.0, height: 0.25, half_width: 0.03, wavenumber: 12.0, swing: 0.01 };
        let growth = Growth { body: 0, centre: [0.0; 3], streams, rate: 2.0 };
        let samples: Vec<[f64; 2]> = (0..40).map(|k| 0.05 * k as f64).map(|t| [t, libm::exp(2.2 * t)]).collect();
        let Figures(found) = compare(&growth, &samples).expect("a growth");
        assert!((found[0].1 - 0.1).abs() < 1e-9, "{found:?}");
        assert!(compare(&growth, &samples[..20]).is_err());
    }
}
