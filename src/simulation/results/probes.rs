//! Probes: averages over a part of a body, in history.csv. A particle belongs to a probe by its initial position,
//! which follows from its lattice site; so a probe costs nothing but the sums for a row.
//!
//! ```text
//! pressure      sum V_i P_i / sum V_i                V_i = m_i / rho_i
//! density       sum m_i / sum V_i
//! distention    sum m_i alpha_i / sum m_i            where the scene has pores
//! its scatter   sqrt(sum m_i alpha_i^2 / sum m_i - distention^2)
//! ```
//! Sums are exact: no order of particles or ranks changes a bit.

use crate::domain::comm::Comm;
use crate::material::porosity::DISTENTION;
use crate::math::ExactSum;
use crate::scene::Scene;
use crate::step::Stepper;

/// Sums of each probe: V, V P, m, m alpha, m (alpha - 1)^2.
const SUMS: usize = 5;

/// Names and units of the columns of history.csv.
pub fn columns(scene: &Scene, has_pores: bool) -> Vec<(String, String)> {
    let all = [("pressure", "Pa"), ("density", "kg/m^3"), ("distention", ""), ("distention_scatter", "")];
    let kept = if has_pores { &all[..] } else { &all[..2] };
    let of = |name: &str| kept.iter().map(|(what, unit)| (format!("{name}_{what}"), unit.to_string())).collect();
    scene.probes.iter().flat_map(|probe| -> Vec<_> { of(&probe.name) }).collect()
}

/// The numbers below them. Collective where the scene has probes.
pub fn row<const D: usize>(scene: &Scene, stepper: &Stepper<D>, comm: &Comm) -> Vec<f64> {
    if scene.probes.is_empty() {
        return Vec::new();
    }
    let (columns, core) = (&stepper.columns, &stepper.settings.view.core);
    let distention = columns.registry.find::<f64>(DISTENTION);
    let mut sums = vec![ExactSum::new(); SUMS * scene.probes.len()];
    for i in 0..columns.len() {
        let id = columns.get(core.id, i);
        let body = &scene.bodies[id.body()];
        // Particles of a file have started from no place that is known.
        let Some(start) = body.site(id.site()) else { continue };
        let m = stepper.settings.view.constants[id.body()].particle_mass;
        let volume = m / columns.get(core.density.value, i);
        let pores = distention.map_or(0.0, |alpha| columns.get(alpha, i) - 1.0);
        let shares = [volume, volume * columns.get(core.pressure, i), m, m * pores, m * pores * pores];
        for (probe, sums) in scene.probes.iter().zip(sums.chunks_exact_mut(SUMS)) {
            if probe.region.holds(body.whole(id.body()), start) {
                sums.iter_mut().zip(shares).for_each(|(sum, share)| sum.add(share));
            }
        }
    }
    let values = comm.sum_exactly(&mut sums);
    let figures = |sums: &[f64]| {
        let (pores, squares) = (sums[3] / sums[2], sums[4] / sums[2]);
        let all = [sums[1] / sums[0], sums[2] / sums[0], 1.0 + pores, (squares - pores * pores).max(0.0).sqrt()];
        all[..if distention.is_some() { 4 } else { 2 }].to_vec()
    };
    values.chunks_exact(SUMS).flat_map(figures).collect()
}
