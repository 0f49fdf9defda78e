//! The reduction points of a stage: all that is global meets here, in one minimum over ranks before the evaluation (do the lists
//! hold?) and one after it. Minima do not depend on order, so that every rank continues with the same bits.

use super::failure::Failure;
use super::integrator::{QUANTITIES, StepError};
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

/// Numbers beside the errors: limit, failure, signal, smallest smoothing length, and six extremes of velocities.
const ALWAYS: usize = 10;

/// Reduces the findings of all ranks in a stage of step `step`; a failure where one of them met a non-finite number. `controlled`: how many
/// quantities have an error. Collective.
pub fn after_evaluation<const D: usize>(
    found: &Findings,
    controlled: usize,
    signal: u32,
    step: u64,
    comm: &Comm,
) -> Result<Reduced, Failure> {
    let failed = found.non_finite.is_some() as u32 as f64;
    let VelocityRange { forward, backward, smallest } = found.velocities;
    let StepError { errors, sizes } = &found.error;
    let mut least = [0.0; ALWAYS + 2 * QUANTITIES];
    least[..4].copy_from_slice(&[found.limit.dt, -failed, -(signal as f64), smallest]);
    let largest = forward.iter().chain(&backward).chain(&errors[..controlled]).chain(&sizes[..controlled]);
    least[4..].iter_mut().zip(largest).for_each(|(value, x)| *value = -x);
    comm.all_min(&mut least[..ALWAYS + 2 * controlled]);
    let [limit, failed, signal, smallest, rest @ ..] = least;
    if failed < 0.0 {
        return Err(Failure::of_ranks(found.non_finite.as_ref(), step, comm));
    }
    let largest = rest.map(|x| -x);
    let mut error = StepError::default();
    let (errors, sizes) = largest[6..][..2 * controlled].split_at(controlled);
    error.errors[..controlled].copy_from_slice(errors);
    error.sizes[..controlled].copy_from_slice(sizes);
    Ok(Reduced {
        limit,
        signal: -signal as u32,
        error,
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
