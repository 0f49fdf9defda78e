//! The reduction points of a stage: all that is global meets here, in one minimum over ranks before the evaluation (do the lists
//! hold?) and one after it. Minima do not depend on order, so that every rank continues with the same bits.

use super::failure::Failure;
use super::integrator::StepError;
use super::workspace::{Findings, VelocityRange};
use crate::domain;
use crate::domain::comm::Comm;

/// Global values after a stage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reduced {
    /// Tightest limit of a step, s.
    pub limit: f64,
    /// Largest of the ranks' signals: zero means nothing.
    pub signal: u32,
    pub error: StepError,
    /// Largest relative velocity of any two particles, m/s.
    pub speed: f64,
    /// Smallest smoothing length, m.
    pub smallest: f64,
}

/// Reduces the findings of all ranks in a stage of step `step`; a failure where one of them met a non-finite number. Collective.
pub fn after_evaluation<const D: usize>(
    found: &Findings,
    signal: u32,
    step: u64,
    comm: &Comm,
) -> Result<Reduced, Failure> {
    let failed = found.non_finite.is_some() as u32 as f64;
    let VelocityRange { forward, backward, smallest } = found.velocities;
    let StepError { velocity, density } = found.error;
    let mut least = [found.limit.dt, -failed, -(signal as f64), smallest, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let largest = forward.into_iter().chain(backward).chain([velocity, density]);
    least[4..].iter_mut().zip(largest).for_each(|(value, x)| *value = -x);
    comm.all_min(&mut least);
    let [limit, failed, signal, smallest, rest @ ..] = least;
    if failed < 0.0 {
        return Err(Failure::of_ranks(found.non_finite.as_ref(), step, comm));
    }
    let largest = rest.map(|x| -x);
    Ok(Reduced {
        limit,
        signal: -signal as u32,
        error: StepError { velocity: largest[6], density: largest[7] },
        speed: domain::relative(&largest[..D], &largest[3..3 + D]),
        smallest,
    })
}

/// The largest share of the skin that is used up on any rank; a failure where one of them met a non-finite number, so that none
/// reaches a neighbour. Collective.
pub fn before_evaluation(found: &Findings, skin_used: f64, step: u64, comm: &Comm) -> Result<f64, Failure> {
    let failed = found.non_finite.is_some();
    let mut values = [if failed { 0.0 } else { skin_used }, failed as u32 as f64];
    comm.all_max(&mut values);
    if values[1] > 0.0 {
        return Err(Failure::of_ranks(found.non_finite.as_ref(), step, comm));
    }
    Ok(values[0])
}
