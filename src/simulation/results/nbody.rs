//! Writes the outcome of an impact for an N-body program.

use crate::outcome::nbody::{Choice, spheres};
use crate::outcome::rebound::{archive, table};
use crate::output::summary::Figures;
use crate::simulation::run::Run;
use crate::simulation::scales::free_fall_time;

/// First step of an N-body integrator over the free-fall time of the target.
const STEP: f64 = 1e-3;

impl<const D: usize> Run<'_, D> {
    /// Makes `nbody.csv` and `nbody.bin` where the scene requests them; returns the numbers of bodies and of pieces left out.
    /// Collective.
    pub(in crate::simulation) fn nbody(&mut self) -> Option<Figures> {
        let settings = self.scene.nbody?;
        self.stepper.release_buffers();
        let particles = self.particles();
        let choice = Choice { smallest: settings.smallest, most: settings.most };
        let (bodies, left_out) = spheres(self.comm, &particles, &choice);
        let step = STEP * free_fall_time(self.scene);
        let binary = archive(self.stepper.state.time, step, &bodies);
        self.products.tables.extend([("nbody.csv", table(&bodies).into_bytes()), ("nbody.bin", binary)]);
        let mut number = [bodies.len() as i64];
        self.comm.all_sum(&mut number);
        let [x, y, z] = left_out.momentum;
        let named = |name: &str, value: f64| (name.to_string(), value);
        tracing::info!(
            "{} bodies for an N-body program; {} pieces of {:.3e} kg in all are left out",
            number[0],
            left_out.pieces,
            left_out.mass
        );
        Some(Figures(vec![
            named("bodies", number[0] as f64),
            named("left_out", left_out.pieces),
            named("left_out_mass", left_out.mass),
            named("left_out_momentum_x", x),
            named("left_out_momentum_y", y),
            named("left_out_momentum_z", z),
        ]))
    }
}
