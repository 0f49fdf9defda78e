//! What a rank will hold in memory, known before anything is allocated: sizes per particle are exact, the numbers of
//! neighbours and ghosts are those of an even medium.

use super::resources;
use super::setup::Plan;
use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::gravity::{Source, Target};
use crate::kernel::SUPPORT;
use crate::math::lanes::LANES;
use crate::outcome;
use crate::pair::Layout;
use crate::particles::{Place, Site};
use crate::scene::Scene;

/// Bytes of a particle while an outcome is found, where all material is loose: the particle, pieces at two thresholds of
/// damage in vectors that grew by doubling, and sources and targets of a tree, in order and sorted.
const LOOSE: usize =
    size_of::<outcome::Particle>() + 4 * size_of::<outcome::Piece>() + 2 * (size_of::<Source>() + size_of::<Target>());

/// Memory of one of equally loaded ranks.
#[derive(Debug, Clone)]
pub struct Footprint {
    /// Particles of all ranks.
    pub particles: u64,
    /// Particles that a rank owns.
    pub owned: f64,
    /// Ghosts of a rank.
    pub ghosts: f64,
    /// Mean neighbours within the list radius.
    pub neighbours: f64,
    /// What, and its bytes on a rank.
    pub parts: [(&'static str, f64); 6],
    /// Numbers that a ghost record sends.
    pub layout: Layout,
}

impl Footprint {
    pub fn new(scene: &Scene, plan: &Plan, ranks: usize) -> Self {
        let dimension = scene.dimension;
        let particles: u64 = plan.constants.iter().map(|body| body.particles).sum();
        let owned = particles as f64 / ranks as f64;
        // In spacings: h = eta (m / rho)^(1/d), and there is one particle per spacing^d.
        let reach = SUPPORT * (1.0 + scene.numerics.skin) * scene.numerics.eta;
        let ghosts = ghosts(particles as f64, ranks, dimension, reach);
        let neighbours = ball(reach, dimension) - 1.0;
        let layout = Layout { dimension, terms: plan.terms };
        // A row ends anywhere in its last group of lanes.
        let row = neighbours + 0.5 * (LANES - 1) as f64;
        let place = size_of::<Place>();
        let (site, slot) = (if dimension == 2 { size_of::<Site<2>>() } else { size_of::<Site<3>>() }, size_of::<u32>());
        // Position, squared radius, whether it is a ghost, and its slot.
        let local = place + 8 * dimension + 8 + 1 + slot;
        // The sites, and the table that sorts them at each build.
        let order = site + (place + site + 2 * slot);
        let parts = [
            ("columns", owned * plan.registry.bytes_per_particle() as f64),
            ("pair records", (owned + ghosts) * 8.0 * layout.stride() as f64),
            ("neighbour list", owned * (4.0 * row + 8.0 + 4.0)),
            ("local set and order", (owned + ghosts) * local as f64 + owned * order as f64),
            ("outcome", scene.impact.map_or(0.0, |_| owned * LOOSE as f64)),
            ("ghost messages", 2.0 * ghosts * 8.0 * layout.words() as f64),
        ];
        Self { particles, owned, ghosts, neighbours, parts, layout }
    }

    /// Bytes of a rank.
    pub fn per_rank(&self) -> f64 {
        self.parts.iter().map(|(_, bytes)| bytes).sum()
    }

    /// Bytes that a rank sends in a step.
    pub fn sent(&self) -> f64 {
        8.0 * self.ghosts * self.layout.words() as f64
    }

    /// Refuses what does not fit: the ranks of a machine share its memory. The same answer on all ranks. Collective.
    pub fn require(&self, comm: &Comm) -> Result<()> {
        let mine = [resources::machine(), resources::available_bytes() as u64];
        let all = comm.all_gather(&mine);
        let fits = |machine: &[u64]| {
            let ranks = all.chunks_exact(2).filter(|other| other[0] == machine[0]).count();
            // A machine that does not say what it has is given the benefit of the doubt.
            (machine[1] == 0 || ranks as f64 * self.per_rank() <= machine[1] as f64, ranks, machine[1])
        };
        match all.chunks_exact(2).map(fits).find(|(fits, ..)| !fits) {
            None => Ok(()),
            Some((_, ranks, available)) => {
                let gigabytes = |bytes: f64| 1e-9 * bytes;
                let need = gigabytes(ranks as f64 * self.per_rank());
                let what = format!(
                    "{} particles need about {need:.1} GB on a machine with {:.1} GB of memory available ({ranks} ranks there)",
                    self.particles,
                    gigabytes(available as f64)
                );
                let allowed = "fewer particles, or more machines; --check shows what takes the memory";
                Err(Error::new(what).allowed(allowed).bad_input())
            }
        }
    }
}

/// Volume of a ball in two or three dimensions.
fn ball(radius: f64, dimension: usize) -> f64 {
    use std::f64::consts::PI;
    if dimension == 2 { PI * radius * radius } else { 4.0 / 3.0 * PI * radius * radius * radius }
}

/// Particles within `reach` (in spacings) of one of `ranks` parts of a cube: it is cut across its longest side until there are
/// as many parts, and the outside of the cube has no ghosts.
fn ghosts(particles: f64, ranks: usize, dimension: usize, reach: f64) -> f64 {
    let side = particles.powf(1.0 / dimension as f64);
    let mut cuts = vec![1.0f64; dimension];
    let mut parts = ranks as f64;
    while parts > 1.0 {
        let longest = (0..dimension).min_by(|&a, &b| cuts[a].total_cmp(&cuts[b])).unwrap_or(0);
        cuts[longest] *= parts.min(2.0);
        parts /= 2.0;
    }
    let own: f64 = cuts.iter().map(|cut| side / cut).product();
    let around: f64 = cuts.iter().map(|cut| side / cut + 2.0 * reach * (1.0 - 1.0 / cut)).product();
    (around - own).min(particles - own)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ghosts_of_halves_and_of_parts_inside() {
        assert_eq!(ghosts(1000.0, 1, 3, 2.0), 0.0);
        // A cube of 10 in halves: one layer of 2 on one of two faces of each.
        assert!((ghosts(1000.0, 2, 3, 2.0) - 2.0 * 100.0).abs() < 1e-9);
        // Four squares of 10: two of four sides have neighbours, and one corner.
        assert!((ghosts(400.0, 4, 2, 2.0) - (12.0 * 12.0 - 100.0)).abs() < 1e-9);
        // Never more than there are.
        assert!(ghosts(1000.0, 1000, 3, 20.0) <= 999.0);
    }

    #[test]
    fn memory_follows_the_effects_of_the_scene() {
        let text = include_str!("../../inputs/impact.toml");
        let footprint = |overrides: &[&str], ranks| {
            let overrides: Vec<String> = overrides.iter().map(|o| o.to_string()).collect();
            let scene = Scene::parse("impact.toml", text, &overrides).unwrap();
            let constants = scene.bodies.iter().map(|body| body.constants(1000, scene.numerics.eta)).collect();
            Footprint::new(&scene, &super::super::setup::plan(&scene, constants), ranks)
        };
        let (solid, fluid) = (footprint(&[], 1), {
            let off = ["material.basalt.fracture=false", "material.basalt.strength=false"];
            footprint(&off, 1)
        });
        // 5 numbers of stress, 5 of its rate, damage and threshold.
        assert_eq!(solid.parts[0].1 - fluid.parts[0].1, 2000.0 * 8.0 * 12.0);
        assert_eq!((solid.ghosts, solid.sent()), (0.0, 0.0));
        let four = footprint(&[], 4);
        assert_eq!((four.particles, four.owned), (2000, 500.0));
        assert_eq!(four.sent(), four.ghosts * 16.0 * 8.0);
        assert!(four.per_rank() > 0.25 * solid.per_rank());
    }
}
