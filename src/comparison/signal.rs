//! A vibration against its exact period: the velocity field is projected onto the shape of the mode,
//!
//! ```text
//! q = sum m v . phi / sum m phi . phi        (particles of the vibrating body)
//! q(t) = exp(-d t) (A cos w t + B sin w t)   fitted by least squares
//! ```
//! Errors: `frequency` w over the exact one, less one; `damping` d / w, the amplitude lost per radian. Where nothing pulls back, in a
//! fluid that moves across, q = q_0 exp(-d t), and all of it is an error: `viscosity` d / (k^2 c h), the kinematic viscosity over c h.

use std::f64::consts::PI;

use super::pictures::Pictures;
use super::solution::Vibration;
use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::math::{ExactSum, Line, Vec3};
use crate::output::figures::curves::{Axis, Figure, Mark, Series};
use crate::output::on_root;
use crate::output::summary::Figures;
use crate::step::Stepper;

/// q now, m/s. Collective.
pub fn amplitude<const D: usize>(vibration: &Vibration, stepper: &Stepper<D>, comm: &Comm) -> f64 {
    let (columns, settings) = (&stepper.columns, &stepper.settings);
    let mut sums = [ExactSum::new(), ExactSum::new()];
    let mass = settings.view.constants[vibration.body].particle_mass;
    for i in (0..columns.len()).filter(|&i| columns.get(settings.view.core.id, i).body() == vibration.body) {
        let shape = Vec3::from((vibration.shape)(columns.get(settings.view.core.position, i).into()));
        sums[0].add(mass * columns.get(settings.view.core.velocity, i).dot(&shape));
        sums[1].add(mass * shape.norm_squared());
    }
    let sums = comm.sum_exactly(&mut sums);
    sums[0] / sums[1]
}

/// A fitted vibration.
#[derive(Debug, Clone, Copy)]
struct Fit {
    frequency: f64,
    decay: f64,
    /// Amplitudes of cosine and sine, m/s.
    parts: [f64; 2],
    residual: f64,
}

impl Fit {
    /// The best parts for a frequency and a decay.
    fn linear(samples: &[[f64; 2]], frequency: f64, decay: f64) -> Self {
        let (mut cc, mut cs, mut ss, mut qc, mut qs, mut qq) = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
        for &[t, q] in samples {
            let fade = libm::exp(-decay * t);
            let (c, s) = (fade * libm::cos(frequency * t), fade * libm::sin(frequency * t));
            (cc, cs, ss) = (cc + c * c, cs + c * s, ss + s * s);
            (qc, qs, qq) = (qc + q * c, qs + q * s, qq + q * q);
        }
        let det = cc * ss - cs * cs;
        let parts = [(qc * ss - qs * cs) / det, (qs * cc - qc * cs) / det];
        let residual = qq - parts[0] * qc - parts[1] * qs;
        Self { frequency, decay, parts, residual: if residual.is_finite() { residual } else { f64::INFINITY } }
    }

    /// The best of all within 40 % of `expected`, rad/s: grids around the best so far, ever finer.
    fn best(samples: &[[f64; 2]], expected: f64) -> Self {
        let mut best = Self::linear(samples, expected, 0.0);
        let (mut wide, mut deep) = (0.4 * expected, 0.2 * expected);
        for _ in 0..40 {
            let centre = best;
            for w in -20..=20 {
                for d in -4..=4 {
                    let (w, d) = (0.05 * w as f64 * wide, 0.25 * d as f64 * deep);
                    let trial = Self::linear(samples, centre.frequency + w, centre.decay + d);
                    if trial.residual < best.residual {
                        best = trial;
                    }
                }
            }
            (wide, deep) = (0.5 * wide, 0.5 * deep);
        }
        best
    }

    fn at(&self, t: f64) -> f64 {
        let (s, c) = (libm::sin(self.frequency * t), libm::cos(self.frequency * t));
        libm::exp(-self.decay * t) * (self.parts[0] * c + self.parts[1] * s)
    }
}

/// The errors, and a figure. Collective; all ranks give the same samples.
pub fn compare(
    vibration: &Vibration,
    samples: &[[f64; 2]],
    pictures: Option<Pictures>,
    comm: &Comm,
) -> Result<Figures> {
    if vibration.frequency == 0.0 {
        return fading(vibration, samples);
    }
    let span = samples.last().map_or(0.0, |last| last[0]);
    if samples.len() < 8 || span * vibration.frequency < 0.5 * PI {
        return Err(Error::new(format!("{} samples over {span:e} s show no vibration", samples.len()))
            .allowed("a run of a quarter of a period or more, output.history_every small enough for 8 samples"));
    }
    let fit = Fit::best(samples, vibration.frequency);
    if let Some(pictures) = pictures {
        let draw = || draw(vibration, &fit, samples, pictures);
        on_root(comm, draw)?;
    }
    let errors = [
        ("frequency", fit.frequency / vibration.frequency - 1.0),
        ("damping", fit.decay / fit.frequency),
        ("amplitude", fit.parts[0] / vibration.speed - 1.0),
    ];
    Ok(Figures(errors.map(|(name, value)| (name.to_string(), value)).to_vec()))
}

/// What is left of a flow that nothing pulls back.
fn fading(vibration: &Vibration, samples: &[[f64; 2]]) -> Result<Figures> {
    let counts = samples.iter().filter(|[_, q]| *q > 0.0);
    let counts: Vec<(f64, f64)> = counts.map(|&[t, q]| (t, libm::log(q))).collect();
    let Some(line) = Line::through(&counts).filter(|_| counts.len() >= 8) else {
        return Err(Error::new(format!("{} samples show no decay", counts.len()))
            .allowed("a shorter run, or output.history_every small enough for 8 samples before the flow ends"));
    };
    let left = samples.last().map_or(f64::NAN, |last| last[1] / vibration.speed);
    let errors = [("viscosity", -line.slope / vibration.decay), ("amplitude", left - 1.0)];
    Ok(Figures(errors.map(|(name, value)| (name.to_string(), value)).to_vec()))
}

fn draw(vibration: &Vibration, fit: &Fit, samples: &[[f64; 2]], pictures: Pictures) -> Result<()> {
    let span = samples.last().map_or(0.0, |last| last[0]);
    let times = (0..=1000).map(|k| 1e-3 * k as f64 * span);
    let series = |label: &str, points, mark| Series { label: label.into(), points, errors: Vec::new(), mark };
    let exact = times.clone().map(|t| (t, vibration.speed * libm::cos(vibration.frequency * t))).collect();
    let axis = |label: &str| Axis { label: label.into(), logarithmic: false };
    let figure = Figure {
        title: pictures.title.to_string(),
        x: axis("time (s)"),
        y: axis("amplitude of the mode's velocity (m/s)"),
        series: vec![
            series("measured", samples.iter().map(|&[t, q]| (t, q)).collect(), Mark::Points),
            series("exact", exact, Mark::Line),
            series("fit", times.map(|t| (t, fit.at(t))).collect(), Mark::Dashed),
        ],
    };
    figure.draw(&pictures.directory.join("compare_signal.png"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fading_flow_is_found() {
        let shape = Box::new(|_: [f64; 3]| [0.0; 3]);
        let vibration = Vibration { body: 0, shape, frequency: 0.0, decay: 4.0, speed: 0.5 };
        let samples: Vec<[f64; 2]> = (0..20).map(|k| 0.1 * k as f64).map(|t| [t, 0.5 * libm::exp(-0.2 * t)]).collect();
        let Figures(found) = fading(&vibration, &samples).expect("a decay");
        assert!((found[0].1 - 0.05).abs() < 1e-12 && (found[1].1 - libm::exp(-0.38) + 1.0).abs() < 1e-12, "{found:?}");
        assert!(fading(&vibration, &samples[..7]).is_err());
    }

    #[test]
    fn a_fading_vibration_is_found() {
        let (w, d) = (4.0 * 1.13, 0.17);
        let q = |t: f64| libm::exp(-d * t) * (0.7 * libm::cos(w * t) + 0.2 * libm::sin(w * t));
        let samples: Vec<[f64; 2]> = (0..60).map(|k| 0.07 * k as f64).map(|t| [t, q(t)]).collect();
        let fit = Fit::best(&samples, 4.0);
        assert!((fit.frequency / w - 1.0).abs() < 1e-6 && (fit.decay / d - 1.0).abs() < 1e-5, "{fit:?}");
        assert!((fit.at(1.234) - q(1.234)).abs() < 1e-6);
    }
}
