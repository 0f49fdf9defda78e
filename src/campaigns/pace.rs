//! How fast this machine steps a scene: its own effects and pair terms, timed over a few steps on a block of particles in
//! random motion.

use crate::domain::comm::Comm;
use crate::error::Result;
use crate::material::BodyConstants;
use crate::math::Vec3;
use crate::particles::{Columns, ParticleId};
use crate::random::uniform;
use crate::scene::Scene;
use crate::simulation::{report, resources, setup};
use crate::step::{Failure, Stepper};

/// Particles along each edge of the block, in two and in three dimensions: about 20,000.
const EDGE: [usize; 2] = [141, 27];
const STEPS: usize = 12;
/// Random speeds over the speed of sound: enough for shocks, yielding, flaws that open, and lists that last for few steps,
/// as in an impact.
const MOTION: f64 = 0.1;
const SEED: u64 = 1;

/// A measured speed.
#[derive(Debug, Clone, Copy)]
pub struct Pace {
    pub updates_per_core_second: f64,
    /// What it was measured with.
    pub particles: usize,
    pub steps: usize,
    pub list_builds: u64,
}

/// Measures with particles of the scene's largest body, one thread per rank. Collective.
pub fn measure(scene: &Scene, constants: &[BodyConstants], comm: &Comm) -> Result<Pace> {
    match scene.dimension {
        2 => measure_in::<2>(scene, constants, comm),
        _ => measure_in::<3>(scene, constants, comm),
    }
}

fn measure_in<const D: usize>(scene: &Scene, constants: &[BodyConstants], comm: &Comm) -> Result<Pace> {
    let plan = setup::plan(scene, constants.to_vec());
    let columns = block(scene, &plan, comm);
    let spent = || resources::cpu_seconds() - comm.wait_cpu_seconds();
    let start = spent();
    let mut stepper = Stepper::<D>::new(comm, columns, plan.settings(scene));
    let told = |failure: Failure| failure.error(|body| &scene.bodies[body].name);
    let mut dt = stepper.start().map_err(told)?.dt;
    for _ in 0..STEPS {
        dt = stepper.step(dt, 0).map_err(told)?.dt;
    }
    let mut sums = [(1e6 * (spent() - start)) as i64, stepper.counters.updates as i64];
    comm.all_sum(&mut sums);
    let updates_per_core_second = sums[1] as f64 / (1e-6 * sums[0].max(1) as f64);
    let particles = EDGE[D - 2].pow(D as u32);
    Ok(Pace { updates_per_core_second, particles, steps: STEPS, list_builds: stepper.counters.list_builds })
}

/// This rank's share of the block.
fn block(scene: &Scene, plan: &setup::Plan, comm: &Comm) -> Columns {
    let number = (0..scene.bodies.len()).max_by_key(|&body| plan.constants[body].particles).unwrap_or(0);
    let (body, constants) = (&scene.bodies[number], &plan.constants[number]);
    let edge = EDGE[scene.dimension - 2] as u64;
    let spacing = constants.smoothing_length / scene.numerics.eta;
    let speed = MOTION * report::sound_speed(scene, number);
    let mine = setup::share(edge.pow(scene.dimension as u32), comm);
    let core = plan.core;
    let mut columns = Columns::new(plan.registry.clone());
    columns.resize(mine.clone().count());
    let internal_energy = plan.registry.find::<f64>("internal_energy");
    for (i, site) in mine.enumerate() {
        let at = |place: u64| spacing * (place % edge) as f64;
        let random = |k: u64| speed * (2.0 * uniform(SEED, site, k) - 1.0);
        columns.set(core.id, i, ParticleId::new(number, site));
        columns.set(core.position, i, Vec3::new(at(site), at(site / edge), at(site / (edge * edge))));
        columns.set(core.velocity, i, Vec3::new(random(0), random(1), random(2)));
        columns.set(core.density.value, i, body.density);
        if let Some(u) = internal_energy {
            columns.set(u, i, body.internal_energy);
        }
    }
    columns
}
