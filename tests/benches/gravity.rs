//! What the particles' own gravity costs, and how wrong it is: one evaluation in an even ball of jittered sites at several
//! accuracies, on one core, against sums over all bodies at some of them.
//!
//! `cargo bench --bench gravity -- [SITES ALONG A RADIUS] [REPETITIONS]`, 29 (1e5 bodies) and 5 if not given.

use std::hint::black_box;

use sph_mpi::domain::comm::Comm;
use sph_mpi::gravity::multipole::direct;
use sph_mpi::gravity::{Body, Field, Opening, solve};
use sph_mpi::math::Vec3;
use sph_mpi::random::uniform;
use sph_mpi::step::workers::start_threads;

/// Bodies at which sums over all are made.
const SAMPLE: usize = 500;
/// Order of expansion and accuracy, as scenes have them by `gravity.self.accuracy`.
const CASES: [(usize, f64); 4] = [(3, 0.03), (4, 0.01), (4, 2e-3), (5, 1e-4)];

fn main() {
    let mut numbers = std::env::args().skip(1).filter_map(|argument| argument.parse::<usize>().ok());
    let (radius, repetitions) = (numbers.next().unwrap_or(29) as i64, numbers.next().unwrap_or(5));
    start_threads(1).expect("nothing has used the pool yet");
    let comm = Comm::start();
    let mut bodies = ball(radius);
    let sample: Vec<usize> = (0..bodies.len()).step_by((bodies.len() / SAMPLE).max(1)).collect();
    let exact: Vec<Vec3> = sample.iter().map(|&i| direct(&bodies, &bodies[i]).acceleration.into()).collect();
    let first = solve(&comm, &bodies, &Opening { angle: 0.7, accuracy: f64::INFINITY, order: 4 });
    for (body, field) in bodies.iter_mut().zip(&first) {
        body.acceleration = Vec3::from(field.acceleration).norm();
    }
    println!("{} bodies, softened over a support of 2.4 spacings; best of {repetitions}\n", bodies.len());
    println!("| accuracy | order | median error | 99 %    | largest | forces add up to | us per body, one core |");
    println!("|---------:|------:|-------------:|--------:|--------:|-----------------:|----------------------:|");
    for (order, accuracy) in CASES {
        let (mut seconds, mut fields) = (f64::INFINITY, Vec::new());
        for _ in 0..repetitions {
            let start = thread_seconds();
            fields = black_box(solve(&comm, &bodies, &Opening { angle: 0.9, accuracy, order }));
            seconds = seconds.min(thread_seconds() - start);
        }
        let error = |(&i, exact): (&usize, &Vec3)| (Vec3::from(fields[i].acceleration) - exact).norm() / exact.norm();
        let mut errors: Vec<f64> = sample.iter().zip(&exact).map(error).collect();
        errors.sort_by(f64::total_cmp);
        let share = |part: f64| errors[((errors.len() - 1) as f64 * part) as usize];
        println!(
            "| {accuracy:>8} | {order:>5} | {:>12.1e} | {:>7.1e} | {:>7.1e} | {:>16.1e} | {:>21.2} |",
            share(0.5),
            share(0.99),
            share(1.0),
            total(&fields),
            1e6 * seconds / bodies.len() as f64
        );
    }
    comm.finish();
}

/// Processor time of this thread, s.
fn thread_seconds() -> f64 {
    // SAFETY: `clock_gettime` fills the structure it is given.
    let time = unsafe {
        let mut time: libc::timespec = std::mem::zeroed();
        libc::clock_gettime(libc::CLOCK_THREAD_CPUTIME_ID, &mut time);
        time
    };
    time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64
}

/// Every site of a cubic lattice with a spacing of 1 km within the radius, moved by up to 0.15 of the spacing.
fn ball(radius: i64) -> Vec<Body> {
    let axis = -radius..=radius;
    let sites = axis.clone().flat_map(|x| axis.clone().flat_map(move |y| (-radius..=radius).map(move |z| [x, y, z])));
    let inside = sites.filter(|site| site.iter().map(|x| x * x).sum::<i64>() <= radius * radius);
    let body = |(id, site): (u64, [i64; 3])| Body {
        id,
        position: std::array::from_fn(|k| 1e3 * (site[k] as f64 + 0.3 * (uniform(1, id, k as u64) - 0.5))),
        mass: 2.7e12,
        softening: 1.2e3,
        acceleration: 0.0,
    };
    (0..).zip(inside).map(body).collect()
}

/// The sum of all forces over the sum of their sizes; all bodies have one mass.
fn total(fields: &[Field]) -> f64 {
    let sum: Vec3 = fields.iter().map(|field| Vec3::from(field.acceleration)).sum();
    sum.norm() / fields.iter().map(|field| Vec3::from(field.acceleration).norm()).sum::<f64>()
}
