//! The switch to the late stage (see `material::late`), between two steps: effects switch to soft matter, the state of particles is
//! converted, and rates are evaluated anew, so that the next step predicts with the new ones alone. All of it follows from the
//! particles alone, and sums are exact: the same bits on any ranks.

use serde::{Deserialize, Serialize};

use super::Stepper;
use super::failure::Failure;
use super::reduction;
use crate::material::Late;
use crate::material::late::{Load, Stiffness};
use crate::math::ExactSum;

/// Pressure and elastic energy of all particles.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Loads {
    /// J.
    pub elastic_energy: f64,
    /// Mean over mass of the acting pressure, Pa.
    pub mean_pressure: f64,
    /// Largest modulus of the acting pressure, Pa.
    pub largest_pressure: f64,
}

/// The effects of the switch.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Switch {
    pub before: Loads,
    pub after: Loads,
    /// Change of internal energy, J: the difference of the elastic energies.
    pub energy_jump: f64,
}

impl<const D: usize> Stepper<'_, D> {
    /// Switches to soft matter; the next step follows from it. Collective.
    pub fn soften(&mut self, late: &Late) -> Result<Switch, Failure> {
        self.rebuild_released();
        let stiff: Vec<Stiffness> = late.0.iter().map(|body| body.before()).collect();
        let soft: Vec<Stiffness> = late.0.iter().map(|body| body.after()).collect();
        let elastic = self.elastic_energies(&stiff);
        let before = self.loads(&elastic);
        self.settings.effects.iter_mut().for_each(|effect| effect.soften(late));
        self.chunk_pass(|passes, chunk, workspace| passes.carry_over(chunk, late, workspace));
        reduction::before_evaluation(&self.collect(), 0.0, self.state.step, self.comm)?;
        let left = self.elastic_energies(&soft);
        let after = self.loads(&left);
        if let Some(u) = self.internal_energy {
            for (i, (before, after)) in elastic.iter().zip(&left).enumerate() {
                self.columns.set(u, i, self.columns.get(u, i) + (after - before));
            }
        }
        self.evaluate_anew()?;
        let energy_jump = after.elastic_energy - before.elastic_energy;
        Ok(Switch { before, after, energy_jump })
    }

    /// The elastic energy of each particle, J/kg.
    fn elastic_energies(&self, bodies: &[Stiffness]) -> Vec<f64> {
        let (columns, view) = (&self.columns, &self.settings.view);
        let energy = |i: usize| {
            let body = columns.get(view.core.id, i).body();
            bodies[body].elastic_energy(&Load {
                density: columns.get(view.core.density.value, i),
                distention: view.distention(columns, i),
                pressure: columns.get(view.core.pressure, i),
                stress: view.deviatoric_stress(columns, i),
                damage: view.damage(columns, i, body),
                friction: view.has_friction(body),
            })
        };
        (0..columns.len()).map(energy).collect()
    }

    /// Collective.
    fn loads(&self, elastic: &[f64]) -> Loads {
        let (columns, view) = (&self.columns, &self.settings.view);
        let mut sums = [const { ExactSum::new() }; 3];
        let mut largest = [0.0];
        for (i, elastic) in elastic.iter().enumerate() {
            let body = columns.get(view.core.id, i).body();
            let m = view.constants[body].particle_mass;
            let acting = view.acting_pressure(columns, i, body);
            sums.iter_mut().zip([m * elastic, m * acting, m]).for_each(|(sum, share)| sum.add(share));
            largest[0] = acting.abs().max(largest[0]);
        }
        let sums = self.comm.sum_exactly(&mut sums);
        self.comm.all_max(&mut largest);
        Loads { elastic_energy: sums[0], mean_pressure: sums[1] / sums[2], largest_pressure: largest[0] }
    }
}
