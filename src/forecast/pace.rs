//! Measures how fast this machine steps a scene: its own effects and pair terms, timed over a few steps on a block of particles,
//! part of them in random motion; messages between two ranks, where there are two; and a small file.

use std::io::Write;
use std::time::Instant;

use super::model::Machine;
use crate::domain::comm::{Comm, Network};
use crate::error::Result;
use crate::material::BodyConstants;
use crate::material::eos::INTERNAL_ENERGY;
use crate::math::Vec3;
use crate::particles::{Columns, ParticleId, Periods};
use crate::process::resources;
use crate::random::uniform;
use crate::scene::Scene;
use crate::simulation::{scales, setup};
use crate::step::StepSettings;
use crate::step::phases::{Phase, Phases};
use crate::step::{Failure, Stepper};

/// Particles of the block: as many as a rank will have, since caches make few particles cheaper, but within these bounds.
const PARTICLES: [f64; 2] = [8e3, 1e5];
/// Updates of particles to be timed, about a second's work, and the fewest steps.
const UPDATES: usize = 1_600_000;
const FEWEST_STEPS: usize = 16;
/// Random speeds over the speed of sound, and one particle in how many has them: enough for shocks, yielding, flaws that open
/// and lists that must be built. Matter that yields and breaks costs four times as much material update as matter at rest, and
/// at any time of an impact about an eighth of it does.
const MOTION: f64 = 0.1;
const MOVING: u64 = 8;
const SEED: u64 = 1;
/// Phases of the step that scale alike: pairs, update, lists, ordering, totals and gravity of the model.
const PARTS: [&[Phase]; 6] = [
    &[Phase::Pairs],
    &[Phase::Predict, Phase::Watch, Phase::Pack],
    &[Phase::Lists],
    &[Phase::Migration],
    &[Phase::Diagnostics],
    &[Phase::Gravity],
];
/// Steps from one evaluation of gravity to the next, while it is timed.
const GRAVITY_EVERY: f64 = 4.5;
/// A network between machines as clusters have it, s and bytes/s, where none is measured or given.
const NETWORK: Network = Network { latency: 2e-6, bandwidth: 5e9 };
/// Bytes written to see how fast files are, and bytes/s where nothing can be written.
const FILE: usize = 16 << 20;
const FILES: f64 = 5e8;

/// The measured times and rates.
#[derive(Debug, Clone)]
pub struct Pace {
    pub machine: Machine,
    /// Steps for which a neighbour list was used.
    pub life: f64,
    /// Particles of the measurement.
    pub particles: usize,
    pub steps: usize,
    /// Where the figures of the network come from, and those of files.
    pub network_by: &'static str,
    pub files_by: &'static str,
}

/// Measures with particles of the scene's largest body, `owned` on each rank of one thread: the mean of all ranks. The network is
/// measured where none is given. Collective.
pub fn measure(
    scene: &Scene,
    constants: &[BodyConstants],
    owned: f64,
    network: Option<Network>,
    comm: &Comm,
) -> Result<Pace> {
    match scene.dimension {
        2 => measure_in::<2>(scene, constants, owned, network, comm),
        _ => measure_in::<3>(scene, constants, owned, network, comm),
    }
}

fn measure_in<const D: usize>(
    scene: &Scene,
    constants: &[BodyConstants],
    owned: f64,
    network: Option<Network>,
    comm: &Comm,
) -> Result<Pace> {
    let plan = setup::plan(scene, constants.to_vec())?;
    let edge = owned.clamp(PARTICLES[0], PARTICLES[1]).powf(1.0 / D as f64) as u64;
    let particles = edge.pow(D as u32) as usize;
    let count = (UPDATES / particles).max(FEWEST_STEPS);
    // Each rank steps a block of its own, all at once: they share memory and caches as in a run, and no rank waits.
    let alone = comm.alone();
    let columns = block(scene, &plan, edge);
    // The block is matter in open space, whatever the boundaries of the scene.
    let settings =
        StepSettings { periods: Periods::OPEN, motions: None, rigid: None, two_rates: None, ..plan.settings(scene) };
    let mut stepper = Stepper::<D>::new(&alone, columns, settings);
    let as_error = |failure: Failure| failure.error(|body| &scene.bodies[body].name);
    let mut times = Times::default();
    stepper.start().map_err(as_error)?;
    let mut dt = stepper.state.next;
    // One-time costs, such as memory that is touched for the first time, do not count.
    times.leave_out(&stepper.phases);
    if let Some(own) = stepper.settings.gravity.as_mut().and_then(|gravity| gravity.own.as_mut()) {
        own.interval = GRAVITY_EVERY * dt;
    }
    for _ in 0..count {
        dt = stepper.step(dt, stepper.state.time + dt, 0).map_err(as_error)?.dt;
        stepper.totals();
        times.note(&stepper.phases);
    }
    let entries = stepper.neighbourhood.list_size().entries;
    let owned = particles as f64;
    let mut sums = times.of_parts().map(|seconds| (1e9 * seconds) as i64);
    comm.all_sum(&mut sums);
    let [pairs, update, lists, ordering, totals, gravity] = sums.map(|sum| 1e-9 * sum as f64 / comm.size() as f64);
    let (network, network_by) = match (network, comm.network()) {
        (Some(given), _) => (given, "as given"),
        (None, Some(measured)) => (measured, "measured between the first rank and the last"),
        (None, None) => {
            (NETWORK, "assumed (under mpirun with two ranks it is measured, or give --latency and --bandwidth)")
        }
    };
    let files = file_speed(comm);
    let machine = Machine {
        pair: pairs / entries,
        update: update / owned,
        list: lists / entries,
        ordering: ordering / owned,
        totals: totals / owned,
        gravity: gravity / owned,
        latency: network.latency,
        bandwidth: network.bandwidth,
        files: files.unwrap_or(FILES),
    };
    Ok(Pace {
        machine,
        life: count as f64 / (stepper.counters.list_builds - 1).max(1) as f64,
        particles,
        steps: count,
        network_by,
        files_by: if files.is_some() { "measured in this folder" } else { "assumed" },
    })
}

/// Time of each part over all steps, s, and the steps that had it: lists are not built in each.
#[derive(Default)]
struct Times {
    seconds: [f64; PARTS.len()],
    steps: [usize; PARTS.len()],
    phases: Phases,
    /// Processor time at the last look, and wall time and processor time of the steps so far.
    cpu: f64,
    wall: f64,
    spent: f64,
}

impl Times {
    fn leave_out(&mut self, phases: &Phases) {
        (self.phases, self.cpu) = (phases.clone(), resources::cpu_seconds());
    }

    fn note(&mut self, phases: &Phases) {
        for (k, part) in PARTS.iter().enumerate() {
            let seconds = |phase: &Phase| phases.seconds[*phase as usize] - self.phases.seconds[*phase as usize];
            let all: f64 = part.iter().map(seconds).sum();
            self.seconds[k] += all;
            self.steps[k] += (all > 0.0) as usize;
        }
        self.wall += phases.total() - self.phases.total();
        self.spent += resources::cpu_seconds() - self.cpu;
        self.leave_out(phases);
    }

    /// s of processor time of each part in a step that has it. Processor time is divided in proportion to
    /// the wall time of the phases, as other processes may have used the core meanwhile.
    fn of_parts(&self) -> [f64; PARTS.len()] {
        let share = (self.spent / self.wall.max(1e-9)).min(1.0);
        std::array::from_fn(|k| share * self.seconds[k] / self.steps[k].max(1) as f64)
    }
}

/// bytes/s of a file that rank 0 writes into the current folder, down to the disk; none where it may not. Collective.
fn file_speed(comm: &Comm) -> Option<f64> {
    let write = || -> std::io::Result<f64> {
        let path = format!(".sph-mpi-check-{}.tmp", std::process::id());
        let start = Instant::now();
        let written = std::fs::File::create(&path).and_then(|mut file| {
            file.write_all(&vec![1u8; FILE])?;
            file.sync_all()
        });
        let seconds = start.elapsed().as_secs_f64();
        std::fs::remove_file(&path)?;
        written.map(|()| FILE as f64 / seconds)
    };
    let mut speed = [if comm.is_root() { write().unwrap_or(0.0) } else { 0.0 }];
    comm.all_max(&mut speed);
    (speed[0] > 0.0).then_some(speed[0])
}

/// The particles of a block with this many along each edge.
fn block(scene: &Scene, plan: &setup::Plan, edge: u64) -> Columns {
    let many = |&body: &usize| (scene.bodies[body].rigid.is_none(), plan.constants[body].particles);
    let number = (0..scene.bodies.len()).max_by_key(many).unwrap_or(0);
    let (body, constants) = (&scene.bodies[number], &plan.constants[number]);
    let spacing = constants.smoothing_length / scene.numerics.eta;
    // Cold gas has no speed of sound: any speed will do.
    let speed = MOTION * Some(scales::sound_speed(scene, number)).filter(|sound| *sound > 0.0).unwrap_or(1.0);
    let last = edge.pow(scene.dimension as u32);
    let core = plan.view.core;
    let mut columns = Columns::new(plan.registry.clone());
    columns.resize(last as usize);
    let internal_energy = plan.registry.find::<f64>(INTERNAL_ENERGY);
    for (i, site) in (0..last).enumerate() {
        let at = |place: u64| spacing * (place % edge) as f64;
        let moves = site < last / MOVING;
        let random = |k: u64| if moves { speed * (2.0 * uniform(SEED, site, k) - 1.0) } else { 0.0 };
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
