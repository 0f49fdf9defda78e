//! The largest remnant as a body: how it turns, and the ellipsoid that has its moments of inertia.
//!
//! With second moments M_ab = sum m x_a x_b about the centre of mass: inertia I = tr M 1 - M, spin omega = I^-1 L, and semi-axes a_k =
//! sqrt(5 lambda_k / m), as of a uniform ellipsoid, with the eigenvalues lambda_k of M and, as particles are cubes of edge s and not
//! points, sum m s^2 / 12.

use serde::{Deserialize, Serialize};

use super::particle::Particle;
use super::tally::all_values;
use crate::domain::comm::Comm;
use crate::math::{ExactSum, Mat3, Vec3};

/// Figures of a body made of particles; 3D only.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Form {
    /// kg.
    pub mass: f64,
    /// About its centre of mass, kg m^2/s.
    pub angular_momentum: [f64; 3],
    /// That of a rigid body with this angular momentum, rad/s.
    pub spin: [f64; 3],
    /// Semi-axes of the ellipsoid with its moments, the longest first, m.
    pub axes: [f64; 3],
    /// Share of its matter's volume that is pores, where there are pores below the resolution.
    pub porosity: Option<f64>,
}

/// The form of the particles that are members; none without any. Collective.
pub fn form(comm: &Comm, particles: &[Particle], members: &[bool]) -> Option<Form> {
    let mine = || particles.iter().zip(members).filter(|(_, member)| **member).map(|(particle, _)| particle);
    let mut first = [const { ExactSum::new() }; 7];
    for p in mine() {
        let (x, v) = (p.position * p.mass, p.velocity * p.mass);
        first.iter_mut().zip([p.mass, x.x, x.y, x.z, v.x, v.y, v.z]).for_each(|(sum, value)| sum.add(value));
    }
    let [mass, x, y, z, u, v, w] = all_values(comm, &mut first);
    if mass <= 0.0 {
        return None;
    }
    let (centre, velocity) = (Vec3::new(x, y, z) / mass, Vec3::new(u, v, w) / mass);
    let mut second = [const { ExactSum::new() }; 10];
    for p in mine() {
        let r = p.position - centre;
        let turn = r.cross(&(p.velocity - velocity)) * p.mass;
        let own = p.spacing * p.spacing / 12.0;
        let moments = [r.x * r.x, r.y * r.y, r.z * r.z, r.x * r.y, r.x * r.z, r.y * r.z, own];
        let values = moments.map(|moment| p.mass * moment).into_iter().chain([turn.x, turn.y, turn.z]);
        second.iter_mut().zip(values).for_each(|(sum, value)| sum.add(value));
    }
    let [xx, yy, zz, xy, xz, yz, own, lx, ly, lz] = all_values(comm, &mut second);
    let moments = Mat3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    let inertia = Mat3::identity() * moments.trace() - moments;
    let spin = inertia.try_inverse().map_or(Vec3::zeros(), |inverse| inverse * Vec3::new(lx, ly, lz));
    let extended = (moments + Mat3::identity() * own).symmetric_eigenvalues();
    let mut axes: [f64; 3] = extended.map(|lambda| (5.0 * lambda.max(0.0) / mass).sqrt()).into();
    axes.sort_by(|a, b| b.total_cmp(a));
    Some(Form { mass, angular_momentum: [lx, ly, lz], spin: spin.into(), axes, porosity: None })
}
