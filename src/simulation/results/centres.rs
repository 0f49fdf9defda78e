//! Centres of mass of bodies, for what follows a body through a run. Sums are exact: no order of particles or ranks changes a bit.

use crate::domain::comm::Comm;
use crate::math::{ExactSum, Vec3};
use crate::outcome::CentreOfMass;
use crate::scene::Scene;
use crate::step::Stepper;

/// Sums of a body: mass, mass times position, momentum.
const SUMS: usize = 7;

/// The centres of mass of these bodies, parts included. Collective.
pub fn of<const D: usize, const N: usize>(
    bodies: [usize; N],
    scene: &Scene,
    stepper: &Stepper<D>,
    comm: &Comm,
) -> [CentreOfMass; N] {
    let (columns, view) = (&stepper.columns, &stepper.settings.view);
    let whole: Vec<usize> = scene.bodies.iter().enumerate().map(|(number, body)| body.whole(number)).collect();
    let mut sums = vec![ExactSum::new(); SUMS * N];
    for i in 0..columns.len() {
        let part = columns.get(view.core.id, i).body();
        let Some(k) = bodies.iter().position(|body| *body == whole[part]) else { continue };
        let m = view.constants[part].particle_mass;
        let (x, p) = (columns.get(view.core.position, i) * m, columns.get(view.core.velocity, i) * m);
        sums[SUMS * k..][..SUMS].iter_mut().zip([m, x.x, x.y, x.z, p.x, p.y, p.z]).for_each(|(sum, s)| sum.add(s));
    }
    let values = comm.sum_exactly(&mut sums);
    std::array::from_fn(|k| {
        let [mass, values] = [&values[SUMS * k..][..1], &values[SUMS * k + 1..][..SUMS - 1]];
        let vector = |from: usize| Vec3::new(values[from], values[from + 1], values[from + 2]) / mass[0];
        CentreOfMass { position: vector(0), velocity: vector(3) }
    })
}
