//! Two rates in one run. Bodies that are stiff or fine make small steps, the rest a large one at a time; by the
//! predictor-corrector (`predictor_corrector`), whose step of dt is
//!
//! ```text
//! x += dt v + dt^2/2 a    v += dt/2 (a + a')    q += dt/2 (q' of before + q' of after)       a at the old, a' at the new places
//! ```
//!
//! **Groups.** Fast are the bodies that the scene names, and what has a particle of these in its list: soft matter in touch
//! with stiff matter feels its forces and must follow in its time. All others are slow; those of them with a fast neighbour are
//! the *edge*. What is fast is decided between two large steps, after lists were built, from the lists alone, and kept in the
//! column `fast`: in the step in which lists change, every particle still ends as what it began as. The layer of soft matter that
//! is fast is what makes the scheme stable: a chain of springs, a third of it 1e4 times as stiff and 10 times as heavy as the
//! rest, n = 128, blows up without it; with one soft particle in it energy stays within 3 % over 3000 / w (w the frequency of
//! the soft springs) at w dt = 0.4 and within 0.5 % at 0.2, and no better with two.
//!
//! **A large step** of dt is the sum of n small ones of d_m, m = 1 ... n. At the end of each but the last
//!
//! ```text
//! fast    make a whole step of d_m: predicted, evaluated with all of their neighbours, corrected, committed
//! edge    is predicted from the beginning of the large step to that moment, without being moved: fast particles see it there
//! b_j     the acceleration of an edge particle j by its fast neighbours alone, from the same records, is noted
//! ```
//! and in the last one all particles are evaluated where they are at the end, fast ones with d_n, slow ones with dt. The last
//! small step thus costs no more than a step does, and the rows of slow particles are summed once in dt.
//!
//! **Momentum.** A fast particle i has got from its pair with j, with f_m the force at the end of small step m (f_0: of the
//! step before),
//!
//! ```text
//! sum_m d_m/2 (f_(m-1) + f_m)  =  d_1/2 f_0 + sum_(m<n) (d_m + d_(m+1))/2 f_m + d_n/2 f_n
//! ```
//! The corrector gives j minus dt/2 (f_0 + f_n). It gets the difference on top,
//!
//! ```text
//! v_j += sum_(0<m<n) (d_m + d_(m+1))/2 b_m + (d_1 - dt)/2 b_0 + (d_n - dt)/2 b_n
//! ```
//! and u_j the same sums of its heating by fast neighbours. Pairs are antisymmetric in f (`pair`), so that momentum is constant
//! to rounding. b_0 is kept from the last evaluation (`fast_acceleration`, `fast_heating`), of the same records and lists as
//! f_0 in the acceleration of i.
//!
//! **Energy.** At every evaluation the power of a pair on both sides and its heating of both add up to zero, at the predicted
//! velocities. What a fast particle adds up over small steps is that of its own corrected velocities to second order in d. An
//! edge particle is driven by sums of forces while its velocity is followed in one step: sum_m w_m f_m.(v_m - mean v) is left,
//! with v smooth in dt. Where f is smooth in dt, too, this is odd about the middle of the step to first order, and the error of
//! energy is of second order in dt, that of the integrator itself. What of f oscillates within dt cancels in the sums, as it
//! does in the motion of the edge; for it to be small is what the soft layer of fast particles is for. Density, stress and the
//! velocity gradient of slow particles follow from all neighbours, once in dt.
//!
//! **Lengths.** Slow particles limit dt, fast ones d, each by its own limits; both are global. n is the least with
//! dt/n <= d at the beginning of the large step; after each small step the rest is halved where d has become shorter than what
//! they take (not where the scene gives n). All ranks know the same limits, so that they agree. A checkpoint lies between large
//! steps and needs of this only d (`StepState`).
//!
//! **Lists** hold from one large step to the next, as without small ones: they are watched when all particles stand at the end
//! of it. So matter that flies into each other limits the large step even where all of it is fast (`closing`): small steps
//! are gained in matter that moves by less than its skin in a large one.
//!
//! **Ranks.** In each small step the records of ghosts that are fast or of the edge are exchanged, and ranks reduce whether
//! numbers are finite, and d.
//!
//! What else refers to a moment of all particles is left to scenes without two rates: gravity of particles on each other, rigid
//! bodies, the late stage, and integrators that may refuse a step. Pores, fracture, dust, friction and a smoothing length that
//! varies are local and follow each particle's own steps; prescribed motion takes what an edge particle gets as impulse and
//! work.

mod columns;
mod group;
mod receive;
mod small_steps;
mod stepping;
mod two_rates;

pub use columns::{RateColumns, RateSettings, Received};
pub use small_steps::MOST_STEPS;
pub use two_rates::TwoRates;
