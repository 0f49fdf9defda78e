//! Hands what an impact has left on to an N-body program.

use super::late::free_fall_time;
use super::run::Run;
use crate::error::Result;
use crate::outcome::nbody::{Choice, spheres};
use crate::outcome::rebound::{archive, table};
use crate::output::agree;
use crate::output::publish::{replace, replace_text};
use crate::output::summary::Figures;

/// First step of an N-body integrator over the free-fall time of the target.
const STEP: f64 = 1e-3;

impl<const D: usize> Run<'_, D> {
    /// Writes `nbody.csv` and `nbody.bin` where the scene asks for them; what they hold and leave out, in figures. Collective.
    pub(super) fn write_nbody(&mut self) -> Result<Option<Figures>> {
        let Some(asked) = self.scene.nbody else { return Ok(None) };
        self.stepper.rest();
        let particles = self.particles();
        let choice = Choice { smallest: asked.smallest, most: asked.most };
        let (bodies, left_out) = spheres(self.comm, &particles, &choice);
        let step = STEP * free_fall_time(self.scene);
        let path = |name: &str| self.options.directory.join(name);
        let write = || {
            replace_text(&path("nbody.csv"), &table(&bodies))?;
            replace(&path("nbody.bin"), &archive(self.state.time, step, &bodies))
        };
        agree(self.comm, if self.comm.is_root() { write() } else { Ok(()) })?;
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
        Ok(Some(Figures(vec![
            named("bodies", number[0] as f64),
            named("left_out", left_out.pieces),
            named("left_out_mass", left_out.mass),
            named("left_out_momentum_x", x),
            named("left_out_momentum_y", y),
            named("left_out_momentum_z", z),
        ])))
    }
}
