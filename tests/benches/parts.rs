//! What the parts of a step cost, one by one: pair pass, material update, packing, list building, exchange of ghost records.
//! The program's own stepper is timed, phase by phase, on a block of basalt in motion; one rank, one thread.
//!
//! `cargo bench --bench parts`. Compare figures of one run only: processors and days differ.

use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};

use sph_mpi::domain::Exchange;
use sph_mpi::domain::comm::Comm;
use sph_mpi::scene::Scene;
use sph_mpi::simulation::setup;
use sph_mpi::step::Stepper;
use sph_mpi::step::phases::Phase;
use sph_mpi::step::workers::start_threads;

/// A ball of rock that falls into itself, slowly enough to be the same problem from the first sample to the last.
const BALL: &str = r#"
[[body]]
name = "ball"
shape = { sphere = { radius = "1 km" } }
material = "basalt"
particles = 40_000
flow = { radial = "-1 m/s" }

[material.basalt.strength]
[material.basalt.fracture]

[numerics]
corrected_gradient = true

[run]
until = "1 s"
"#;

fn stepper(comm: &Comm) -> Stepper<'_, 3> {
    let scene = Scene::parse("ball.toml", BALL, &[]).expect("a valid scene");
    let counts = setup::count_particles(&scene, comm).expect("particles");
    let plan = setup::plan(&scene, counts).expect("a plan");
    let (columns, settings) = plan.populate(&scene, comm).expect("no modes");
    let mut stepper = Stepper::new(comm, columns, settings);
    stepper.start().expect("a first step");
    stepper
}

/// Times one phase over as many calls as asked for.
fn phase<const D: usize>(
    stepper: &mut Stepper<'_, D>,
    phase: Phase,
    calls: u64,
    act: impl Fn(&mut Stepper<'_, D>),
) -> Duration {
    let before = stepper.phases.seconds[phase as usize];
    (0..calls).for_each(|_| act(stepper));
    Duration::from_secs_f64(stepper.phases.seconds[phase as usize] - before)
}

fn parts(criterion: &mut Criterion) {
    start_threads(1).expect("nothing has used the pool yet");
    let comm = Comm::start();
    let mut ball = stepper(&comm);
    let dt = 1e-9;
    let step = |ball: &mut Stepper<'_, 3>| {
        ball.step(dt, 0.0, 0).expect("a step");
    };
    let particles = ball.columns.len() as u64;

    let mut group = criterion.benchmark_group("step");
    group.sample_size(20).measurement_time(Duration::from_secs(4)).throughput(Throughput::Elements(particles));
    for (name, timed) in [("pair_pass", Phase::Pairs), ("material_update", Phase::Predict), ("pack", Phase::Pack)] {
        group.bench_function(name, |bencher| bencher.iter_custom(|calls| phase(&mut ball, timed, calls, step)));
    }
    let rebuild = |ball: &mut Stepper<'_, 3>| ball.resume(ball.state.clone());
    group.bench_function("list_building", |bencher| {
        bencher.iter_custom(|calls| phase(&mut ball, Phase::Lists, calls, rebuild));
    });
    group.bench_function("order_and_ghosts", |bencher| {
        bencher.iter_custom(|calls| phase(&mut ball, Phase::Migration, calls, rebuild));
    });
    group.finish();

    // To oneself: what copying and MPI's calls cost, without a network.
    let mut group = criterion.benchmark_group("exchange");
    for words in [1usize, 2048, 131_072] {
        let mut exchange = Exchange::new(&comm, &[(0, words)], &[(0, words)]);
        group.throughput(Throughput::Bytes(8 * words as u64));
        group.bench_function(BenchmarkId::from_parameter(8 * words), |bencher| {
            bencher.iter(|| {
                exchange.start(&comm);
                exchange.wait(&comm);
            });
        });
    }
    group.finish();
    drop(ball);
    comm.finish();
}

criterion_group!(benches, parts);
criterion_main!(benches);
