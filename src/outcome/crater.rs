//! Effects of an impact on ground: ejecta, the bowl, and how far pores were crushed. Depth and upward speed are measured along
//! the outward normal of the face that was hit.
//!
//! ```text
//! ejected above v    sum of m over particles of all bodies but the projectile with v_up > v, wherever they are
//! ... above the face sum of m over those of them that have risen above the initial face
//! volume             m / rho_0 of these, rho_0 bulk density at the start
//! compacted volume   sum of m (1 / rho_0 - alpha / (alpha_0 rho_0)) over porous bodies
//! momentum           sum of m v_up over all matter above the face with v_up > v, the projectile's included
//! beta               1 + momentum / (m_p U cos(theta)): how much more momentum along the normal the ground takes than was brought
//! ```
//! The first is how Jutzi, Benz & Michel 2008 (Icarus 198, 242) count ejecta (Figs 8, 9, 12); early on it holds matter
//! that is still on its way up through the ground. beta is the momentum enhancement of planetary defence (Holsapple & Housen 2012,
//! Icarus 221, 875); it has converged where it no longer changes with time, and v is then the speed of escape. alpha distention, alpha_0
//! at the start; m_p, U and theta are the projectile's mass, speed and angle from the normal.
//!
//! Sums are exact, the rest are minima and maxima: no order of particles or ranks changes a bit.

use serde::{Deserialize, Serialize};

use super::profiles::{Bowl, Ejecta, Pores};
use super::tally::all_values;
use super::target_particle::TargetParticle;
use crate::domain::comm::Comm;
use crate::material::porosity::DISTENTION;
use crate::material::{BodyConstants, Core};
use crate::math::{ExactSum, Vec3};
use crate::particles::{Columns, ParticleId};

/// Matter below this share of its initial density is spray, not ground.
const THIN: f64 = 0.5;
/// Geometry and thresholds by which craters are measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Question {
    /// Where the projectile hits the face, m.
    pub face: Vec3,
    /// The axis that points out of the ground.
    pub up: usize,
    /// The body at the point of impact: bins are as wide as its particles.
    pub target: usize,
    pub projectile: usize,
    /// Upward speed from which on matter counts as ejected, m/s.
    pub ejection_speed: Option<f64>,
    /// A width that holds the ground, m.
    pub extent: f64,
    /// Momentum of the projectile along the normal, kg m/s.
    pub impulse: f64,
}

/// Where a particle was at the start, m.
pub type Start<'a> = &'a dyn Fn(ParticleId) -> [f64; 3];

/// The crater and the compaction in figures.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Crater {
    /// Where the scene gives the speed above which matter counts as ejected.
    pub ejected: Option<Ejected>,
    /// Depth of the bowl below the initial face, m; zero without one.
    pub depth: f64,
    /// Radius of a circle as large as the bowl, m (in 2D half its width).
    pub radius: f64,
    /// Compaction, where a body has pores.
    pub compaction: Option<Compaction>,
    /// Mass of all bodies but the projectile, kg.
    pub ground_mass: f64,
    /// kg.
    pub projectile_mass: f64,
}

/// Ejecta faster than the speed that the scene names.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Ejected {
    /// kg.
    pub mass: f64,
    /// Volume before the impact, m^3 (m^2 in 2D).
    pub volume: f64,
    /// Mass of the ejecta that have risen above the face, kg.
    pub mass_above_face: f64,
    /// beta.
    pub momentum_enhancement: f64,
}

/// How far pores were crushed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Compaction {
    pub minimum_distention: f64,
    /// Loss of volume by compaction, m^3 (m^2 in 2D).
    pub compacted_volume: f64,
    /// Volume before the impact of matter without pores left, m^3 (m^2 in 2D).
    pub crushed_volume: f64,
}

/// The outcome in figures and the tables for its files.
pub struct CraterEvaluation {
    pub crater: Crater,
    pub ejecta: Ejecta,
    pub bowl: Bowl,
    pub pores: Option<Pores>,
    /// Momentum of the projectile along the normal, kg m/s.
    pub impulse: f64,
}

/// The owned particles of all bodies.
#[derive(Clone, Copy)]
pub struct Matter<'a> {
    pub columns: &'a Columns,
    pub core: &'a Core,
    pub constants: &'a [BodyConstants],
    pub start: Start<'a>,
}

impl Matter<'_> {
    fn seen(&self, question: &Question) -> impl Iterator<Item = TargetParticle> {
        let distention = self.columns.registry.find::<f64>(DISTENTION);
        let aside = |from_face: &Vec3| [from_face.x, if question.up == 2 { from_face.y } else { 0.0 }];
        (0..self.columns.len()).map(move |i| {
            let id = self.columns.get(self.core.id, i);
            let constants = &self.constants[id.body()];
            let from_face = self.columns.get(self.core.position, i) - question.face;
            let velocity = self.columns.get(self.core.velocity, i);
            let at_start = Vec3::from((self.start)(id)) - question.face;
            let [x, y] = aside(&at_start);
            let first = constants.distention;
            TargetParticle {
                of_projectile: id.body() == question.projectile,
                height: from_face[question.up],
                aside: aside(&from_face),
                speed: velocity[question.up],
                energy: 0.5 * constants.particle_mass * velocity.norm_squared(),
                start: [-at_start[question.up], (x * x + y * y).sqrt()],
                mass: constants.particle_mass,
                volume: constants.particle_mass / constants.density,
                relative_density: self.columns.get(self.core.density.value, i) / constants.density,
                distention: distention.filter(|_| first > 1.0).map(|now| [self.columns.get(now, i), first]),
            }
        })
    }

    /// Those of the ground.
    fn ground(&self, question: &Question) -> impl Iterator<Item = TargetParticle> {
        self.seen(question).filter(|particle| !particle.of_projectile)
    }
}

/// beta for the speed that the scene names, where it names one. Collective.
pub fn momentum_enhancement(comm: &Comm, matter: Matter, question: &Question) -> Option<f64> {
    let speed = question.ejection_speed?;
    let mut sum = [ExactSum::new()];
    let escaping = matter.seen(question).filter(|particle| particle.speed > speed && particle.height > 0.0);
    escaping.for_each(|particle| sum[0].add(particle.mass * particle.speed));
    Some(1.0 + all_values(comm, &mut sum)[0] / question.impulse)
}

/// Evaluates the state of all ranks. Collective.
pub fn evaluate(comm: &Comm, matter: Matter, question: &Question) -> CraterEvaluation {
    let Matter { columns, constants, .. } = matter;
    let distention = columns.registry.find::<f64>(DISTENTION);
    let volume = constants[question.target].particle_mass / constants[question.target].density;
    let spacing = if columns.registry.dimension == 3 { libm::cbrt(volume) } else { volume.sqrt() };
    let mass = |body: &BodyConstants| body.particle_mass * body.particles as f64;
    let projectile_mass = mass(&constants[question.projectile]);
    let has_pores = distention.is_some() && constants.iter().any(|body| body.distention > 1.0);

    let ejecta = Ejecta::count(comm, matter.seen(question));
    let fastest = question.ejection_speed.unwrap_or(f64::INFINITY);
    let dense =
        matter.ground(question).filter(|particle| particle.relative_density > THIN && particle.speed <= fastest);
    let bowl = Bowl::measure(comm, dense, spacing, question.extent, columns.registry.dimension);
    let pores = has_pores.then(|| Pores::measure(comm, matter.ground(question), spacing, question.extent));
    let [depth, radius] = bowl.size();
    let crater = Crater {
        ejected: question.ejection_speed.map(|speed| ejected(comm, matter, question, speed)),
        depth,
        radius,
        compaction: has_pores.then(|| compaction(comm, matter.ground(question))),
        ground_mass: constants.iter().map(mass).sum::<f64>() - projectile_mass,
        projectile_mass,
    };
    CraterEvaluation { crater, ejecta, bowl, pores, impulse: question.impulse }
}

fn ejected(comm: &Comm, matter: Matter, question: &Question, speed: f64) -> Ejected {
    let mut sums = [const { ExactSum::new() }; 3];
    for particle in matter.ground(question).filter(|particle| particle.speed > speed) {
        let above = if particle.height > 0.0 { particle.mass } else { 0.0 };
        sums.iter_mut().zip([particle.mass, particle.volume, above]).for_each(|(sum, share)| sum.add(share));
    }
    let [mass, volume, mass_above_face] = all_values(comm, &mut sums);
    let momentum_enhancement = momentum_enhancement(comm, matter, question).expect("the speed is told");
    Ejected { mass, volume, mass_above_face, momentum_enhancement }
}

fn compaction(comm: &Comm, particles: impl Iterator<Item = TargetParticle>) -> Compaction {
    let mut sums = [const { ExactSum::new() }; 2];
    let mut least = [f64::INFINITY];
    for particle in particles {
        let Some([now, first]) = particle.distention else { continue };
        sums[0].add(particle.volume * (1.0 - now / first));
        if particle.is_crushed() {
            sums[1].add(particle.volume);
        }
        least[0] = now.min(least[0]);
    }
    comm.all_min(&mut least);
    let [compacted_volume, crushed_volume] = all_values(comm, &mut sums);
    Compaction { minimum_distention: least[0], compacted_volume, crushed_volume }
}
