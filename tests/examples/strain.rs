//! Equivalent strain, how far matter has been sheared in all: d eps / dt = sqrt(2/3 e':e'), e' deviatoric strain rate, 1/s.
//! Columns: owns `strain`. Time step: none.

use sph_mpi::error::Result;
use sph_mpi::material::{Core, Local, MaterialEffect, PerBody, Setup};
use sph_mpi::math::{Deviator, Sym};
use sph_mpi::particles::{ColumnInfo, Integrated, Life, Registry};

/// Strain of the bodies whose material has strength.
pub struct Strain {
    bodies: PerBody<()>,
    strain: Integrated<f64>,
}

impl MaterialEffect for Strain {
    fn declare(setup: &Setup, registry: &mut Registry, _core: &Core) -> Result<Option<Self>> {
        let Some(bodies) = PerBody::new(setup, |_, material| material.has_strength().then_some(())) else {
            return Ok(None);
        };
        let strain = registry.owner("strain").integrated(ColumnInfo {
            name: "strain",
            unit: "",
            about: "Equivalent strain so far.",
            life: Life::State,
            snapshot: true,
        });
        Ok(Some(Self { bodies, strain }))
    }

    fn name(&self) -> &'static str {
        "strain"
    }

    fn rates(&self, local: &Local) {
        let rate = local.rate(self.strain);
        for (_, range) in self.bodies.runs(local) {
            for i in range {
                let e = Deviator::of(&Sym::symmetric_part(&local.flow[i].velocity_gradient), 1.0);
                rate.set(i, (4.0 / 3.0 * e.j2()).sqrt());
            }
        }
    }
}

mod tests {
    use super::*;
    use crate::common::ranks;
    use sph_mpi::scene::Scene;
    use sph_mpi::simulation::setup::{Declare, count_particles, plan_with};
    use sph_mpi::step::Stepper;

    /// A ball that is stretched along x at 10 1/s and not held: e' = 10 diag(2/3, -1/3, -1/3).
    const BALL: &str = "[[body]]\nname = \"ball\"\nshape = { sphere = { radius = \"1 km\" } }\nmaterial = \"basalt\"\n\
        particles = 500\nflow = { stretch = [\"10 1/s\", 0, 0] }\nSTRENGTH\n[run]\nuntil = 1\n";

    fn stepper<'c>(text: &str, comm: &'c sph_mpi::domain::comm::Comm) -> Stepper<'c, 3> {
        let scene = Scene::parse("ball.toml", text, &[]).expect("a scene");
        let declare: Declare = &|setup, registry, core| {
            Ok(Strain::declare(setup, registry, core)?.map(|effect| Box::new(effect) as Box<dyn MaterialEffect>))
        };
        let counts = count_particles(&scene, comm).expect("particles");
        let plan = plan_with(&scene, counts, &[declare]).expect("a plan");
        let (columns, settings) = plan.populate(&scene, comm).expect("particles");
        let mut stepper = Stepper::new(comm, columns, settings);
        stepper.start().expect("an evaluation");
        stepper
    }

    #[test]
    fn strain_is_that_of_the_flow() {
        ranks(1, "examples::strain::tests::strain_is_that_of_the_flow", |comm| {
            let strong = BALL.replace("STRENGTH", "[material.basalt.strength]");
            let mut ball = stepper(&strong, comm);
            // Before waves come from the surface, in the middle of the ball.
            while ball.state.time < 0.02 {
                let (dt, time) = (ball.state.next.min(0.02 - ball.state.time), ball.state.time);
                ball.step(dt, time + dt, 0).expect("a step");
            }
            let strain = ball.columns.registry.find::<f64>("strain").expect("the effect's column");
            let middle = (0..ball.columns.len())
                .filter(|&i| ball.columns.get(ball.settings.view.core.position, i).norm() < 300.0)
                .map(|i| ball.columns.get(strain, i));
            // No wave has come so far in: x = x_0 (1 + 10 t), so that e_xx = 10 / (1 + 10 t).
            let exact = 2.0 / 3.0 * libm::log(1.2);
            for eps in middle {
                assert!((eps / exact - 1.0).abs() < 2e-3, "{eps} of {exact}");
            }
            // Matter without strength has no such column.
            let weak = stepper(&BALL.replace("STRENGTH", ""), comm);
            assert!(weak.columns.registry.find::<f64>("strain").is_none());
        });
    }
}
