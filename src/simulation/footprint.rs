//! The memory of a rank, estimated before anything is allocated: sizes per particle are exact, the numbers of
//! neighbours are those of uniform balls, and the numbers of ghosts those of a uniform cube.

use super::setup::Plan;
use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::gravity::multipole::octree::Node;
use crate::gravity::{Body, Field};
use crate::kernel::SUPPORT;
use crate::math::lanes::LANES;
use crate::outcome;
use crate::pair::Layout;
use crate::particles::{Place, Site};
use crate::process::resources;
use crate::scene::Scene;

/// Bytes of a particle while an outcome is found, where all material is loose: the particle, pieces at two thresholds of
/// damage in vectors that grew by doubling, and their gravity.
const LOOSE: usize = size_of::<outcome::Particle>() + 4 * size_of::<outcome::Piece>() + ATTRACTED;

/// Bytes of a particle while its gravity is found: itself in messages and in order, its place in the tree, its share of nodes, and
/// the fields returned.
const ATTRACTED: usize = 8 * size_of::<Body>() + size_of::<Node>() / 4 + 4 * size_of::<Field>();

/// Bytes that libraries take on a rank once files and messages are used, over their memory at the start: about this much
/// with OpenMPI and HDF5, measured in runs of few particles.
const LIBRARIES: f64 = 1e7;

/// Memory of one of equally loaded ranks.
#[derive(Debug, Clone)]
pub struct Footprint {
    pub ranks: usize,
    /// Particles of all ranks.
    pub particles: u64,
    /// Particles that a rank owns.
    pub owned: f64,
    /// Ghosts of a rank.
    pub ghosts: f64,
    /// Ranks that send them.
    pub peers: f64,
    /// Ghosts to a depth of one list radius, over the cells of a list radius they lie in.
    pub ghosts_per_cell: f64,
    /// Mean neighbours within the list radius.
    pub neighbours: f64,
    /// Entries of a particle's row in the list: rows end anywhere in their last group of lanes.
    pub row: f64,
    /// Name of each part, and its bytes on a rank.
    pub parts: [(&'static str, f64); 8],
    /// Numbers that a ghost record sends.
    pub layout: Layout,
}

impl Footprint {
    pub fn new(scene: &Scene, plan: &Plan, ranks: usize) -> Self {
        let dimension = scene.dimension;
        let particles: u64 = plan.constants.iter().map(|body| body.particles).sum();
        let owned = particles as f64 / ranks as f64;
        // In spacings: h = eta (m / rho)^(1/d), and there is one particle per spacing^d.
        let reach = SUPPORT * (1.0 + scene.numerics.skin.first()) * scene.numerics.eta;
        let cuts = cuts(ranks, dimension);
        let ghosts = ghosts(particles as f64, &cuts, reach);
        let total =
            plan.constants.iter().map(|body| body.particles as f64 * neighbours(body.particles, reach, dimension));
        let neighbours = total.sum::<f64>() / particles as f64;
        let layout = Layout { dimension, terms: plan.terms };
        let row = neighbours + 0.5 * (LANES - 1) as f64;
        let place = size_of::<Place>();
        let (site, slot) = (if dimension == 2 { size_of::<Site<2>>() } else { size_of::<Site<3>>() }, size_of::<u32>());
        // Position, squared radius, whether it is a ghost, and its slot.
        let local = place + 8 * dimension + 8 + 1 + slot;
        // Records and lists are released for the outcome, which needs more than that or nothing.
        let records = (owned + ghosts) * 8.0 * layout.stride() as f64;
        let list = owned * (4.0 * row + 8.0 + 4.0);
        let search = (owned + ghosts) * local as f64 + owned * site as f64;
        let pieces = scene.impact.is_some() || scene.fragments.is_some() || scene.deposit.is_some();
        let outcome = if pieces { owned * LOOSE as f64 } else { 0.0 };
        let parts = [
            ("columns", owned * plan.registry.bytes_per_particle() as f64),
            ("pair records", records),
            ("neighbour list", list),
            ("search for neighbours", search),
            ("outcome, beyond these", (outcome - records - list - search).max(0.0)),
            ("gravity", scene.gravity.own.map_or(0.0, |_| owned * ATTRACTED as f64)),
            ("ghost messages", 2.0 * ghosts * 8.0 * layout.words() as f64),
            ("libraries", LIBRARIES),
        ];
        let ghosts_per_cell = reach.powi(dimension as i32);
        Self { ranks, particles, owned, ghosts, peers: peers(&cuts), ghosts_per_cell, neighbours, row, parts, layout }
    }

    /// Bytes of a rank.
    pub fn per_rank(&self) -> f64 {
        self.parts.iter().map(|(_, bytes)| bytes).sum()
    }

    /// Bytes that a rank sends in a step.
    pub fn sent(&self) -> f64 {
        8.0 * self.ghosts * self.layout.words() as f64
    }

    /// An error where a run does not fit: the ranks of a machine share its memory. The same result on all ranks. Collective.
    pub fn require(&self, comm: &Comm) -> Result<()> {
        let mine = [resources::machine(), resources::available_bytes() as u64];
        let all = comm.all_gather(&mine);
        let fits = |machine: &[u64]| {
            let ranks = all.chunks_exact(2).filter(|other| other[0] == machine[0]).count();
            // A machine whose memory is unknown is assumed to have enough.
            (machine[1] == 0 || ranks as f64 * self.per_rank() <= machine[1] as f64, ranks, machine[1])
        };
        match all.chunks_exact(2).map(fits).find(|(fits, ..)| !fits) {
            None => Ok(()),
            Some((_, ranks, available)) => {
                let size = |bytes: f64| match bytes {
                    b if b >= 1e12 => format!("{:.1} TB", 1e-12 * b),
                    b => format!("{:.1} GB", 1e-9 * b),
                };
                let what = format!(
                    "{} particles need about {} on a machine with {} of memory available ({ranks} ranks there)",
                    self.particles,
                    size(ranks as f64 * self.per_rank()),
                    size(available as f64)
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

/// Mean number of particles within `reach` (in spacings) of those of a ball of `particles`: at the surface of radius R a part
/// of the neighbours is missing, to first order 9/16 reach/R of them in the mean, or 4/(3 pi) reach/R in two dimensions.
fn neighbours(particles: u64, reach: f64, dimension: usize) -> f64 {
    let radius = (particles as f64 / ball(1.0, dimension)).powf(1.0 / dimension as f64);
    let missing = if dimension == 2 { 4.0 / (3.0 * std::f64::consts::PI) } else { 9.0 / 16.0 };
    let around = ball(reach, dimension) * (1.0 - missing * reach / radius);
    around.clamp(1.0, particles as f64) - 1.0
}

/// Number of parts into which each side of a cube is cut for so many ranks: repeatedly across the longest side.
fn cuts(ranks: usize, dimension: usize) -> Vec<f64> {
    let mut cuts = vec![1.0f64; dimension];
    let mut parts = ranks as f64;
    while parts > 1.0 {
        let longest = (0..dimension).min_by(|&a, &b| cuts[a].total_cmp(&cuts[b])).unwrap_or(0);
        cuts[longest] *= parts.min(2.0);
        parts /= 2.0;
    }
    cuts
}

/// Particles within `reach` (in spacings) of one part of a cube; the outside of the cube has no ghosts.
fn ghosts(particles: f64, cuts: &[f64], reach: f64) -> f64 {
    let side = particles.powf(1.0 / cuts.len() as f64);
    let own: f64 = cuts.iter().map(|cut| side / cut).product();
    let around: f64 = cuts.iter().map(|cut| side / cut + 2.0 * reach * (1.0 - 1.0 / cut)).product();
    (around - own).min(particles - own)
}

/// Parts that touch one of these parts, in the mean: along each side two neighbours, but for the ends.
fn peers(cuts: &[f64]) -> f64 {
    cuts.iter().map(|cut| 3.0 - 2.0 / cut).product::<f64>() - 1.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ghosts_of_halves_and_of_parts_inside() {
        let ghosts = |particles, ranks, dimension, reach| ghosts(particles, &cuts(ranks, dimension), reach);
        assert_eq!(ghosts(1000.0, 1, 3, 2.0), 0.0);
        // A cube of 10 in halves: one layer of 2 on one of two faces of each.
        assert!((ghosts(1000.0, 2, 3, 2.0) - 2.0 * 100.0).abs() < 1e-9);
        // Four squares of 10: two of four sides have neighbours, and one corner.
        assert!((ghosts(400.0, 4, 2, 2.0) - (12.0 * 12.0 - 100.0)).abs() < 1e-9);
        // Never more than there are.
        assert!(ghosts(1000.0, 1000, 3, 20.0) <= 999.0);
    }

    #[test]
    fn parts_touch_26_others_at_most() {
        let peers = |ranks, dimension| peers(&cuts(ranks, dimension));
        assert_eq!((peers(1, 3), peers(2, 3), peers(4, 3), peers(8, 3)), (0.0, 1.0, 3.0, 7.0));
        assert_eq!(peers(4, 2), 3.0);
        assert!(peers(1 << 30, 3) > 25.9 && peers(1 << 30, 3) < 26.0);
    }

    /// Pairs of sites of a cubic lattice in a ball, counted.
    #[test]
    fn neighbours_are_missing_at_the_surface() {
        for (radius, dimension) in [(9i32, 3), (30, 2)] {
            let depth = if dimension == 3 { radius } else { 0 };
            let cube = |n: i32| (-n..=n).flat_map(move |x| (-n..=n).map(move |y| (x, y)));
            let ball = |n: i32, deep: i32, r2: f64| -> Vec<(i32, i32, i32)> {
                let all = cube(n).flat_map(|(x, y)| (-deep..=deep).map(move |z| (x, y, z)));
                all.filter(|(x, y, z)| f64::from(x * x + y * y + z * z) < r2).collect()
            };
            let reach = 2.64f64;
            let sites = ball(radius, depth, f64::from(radius * radius));
            let near = ball(3, depth.min(3), reach * reach);
            let inside = |x: i32, y: i32, z: i32| x * x + y * y + z * z < radius * radius;
            let counted: usize =
                sites.iter().map(|s| near.iter().filter(|d| inside(s.0 + d.0, s.1 + d.1, s.2 + d.2)).count() - 1).sum();
            let mean = counted as f64 / sites.len() as f64;
            // The lattice itself has 80 neighbours within the reach where a uniform medium has 76, and 20 where it has 21.
            let expected = neighbours(sites.len() as u64, reach, dimension);
            assert!((expected / mean - 1.0).abs() < 0.07, "{expected} {mean}");
            // 16 % are missing in the ball, and 4 % in the disc.
            assert!(mean < 0.97 * (near.len() as f64 - 1.0));
        }
        assert_eq!(neighbours(1, 2.64, 3), 0.0);
    }

    #[test]
    fn memory_follows_the_effects_of_the_scene() {
        let text = include_str!("../../inputs/impact.toml");
        let footprint = |overrides: &[&str], ranks| {
            let overrides: Vec<String> = overrides.iter().map(|o| o.to_string()).collect();
            let scene = Scene::parse("impact.toml", text, &overrides).unwrap();
            let constants = scene.bodies.iter().map(|body| body.constants(1000, scene.numerics.eta)).collect();
            Footprint::new(&scene, &super::super::setup::plan(&scene, constants).expect("a plan"), ranks)
        };
        let (solid, fluid) = (footprint(&[], 1), {
            let off = ["material.basalt.fracture=false", "material.basalt.strength=false"];
            footprint(&off, 1)
        });
        // 5 numbers of stress, 5 of its rate, damage and threshold, 6 of the neighbourhood's second moment and 6 of its rate.
        assert_eq!(solid.parts[0].1 - fluid.parts[0].1, 2000.0 * 8.0 * 24.0);
        assert_eq!((solid.ghosts, solid.sent()), (0.0, 0.0));
        let four = footprint(&[], 4);
        assert_eq!((four.particles, four.owned), (2000, 500.0));
        assert_eq!(four.sent(), four.ghosts * 16.0 * 8.0);
        assert!(four.per_rank() > 0.25 * solid.per_rank());
    }
}
