//! How evenly the bisection shares out the particles of an impact, and how many ghosts its parts need: at scale without
//! ranks, and in a run on four.

use sph_mpi::domain::bisection::{Alone, Bisection};
use sph_mpi::domain::ghosts::Extent;
use sph_mpi::kernel::SUPPORT;
use sph_mpi::neighbours::NeighbourList;
use sph_mpi::particles::{Lattice, Local, ParticleId, Site};
use sph_mpi::scene::Scene;

use crate::common::{IMPACT, Launch, summary, write_scene};

/// The bodies of `inputs/impact.toml` with about 200,000 particles, in canonical order.
fn impact() -> Local<3> {
    let text = include_str!("../inputs/impact.toml");
    let scene = Scene::parse("impact.toml", text, &["target.particles=200000".into()]).expect("a valid scene");
    let mut sites = Vec::new();
    for (number, body) in scene.bodies.iter().enumerate() {
        let h = body.expected_smoothing_length(scene.numerics.eta);
        let radius = SUPPORT * (1.0 + scene.numerics.skin.first()) * h;
        let site = |(site, position)| Site { id: ParticleId::new(number, site).0, position, radius };
        sites.extend(body.sites(0..body.lattice_sites()).map(site));
    }
    let smallest = sites.iter().map(|site| site.radius).fold(f64::INFINITY, f64::min);
    let lattice = Lattice::new(smallest);
    sites.sort_by_key(|site| lattice.place(site));
    let mut local = Local::default();
    local.build(&lattice, &sites, &[]);
    local
}

/// Largest cost of a part over the mean, and ghosts over particles.
fn cut(local: &Local<3>, costs: &[u32], parts: usize) -> (f64, f64) {
    let sites: Vec<Site<3>> = (0..local.count)
        .map(|i| Site {
            id: local.places[i].id,
            position: local.position.each_ref().map(|x| x[i]),
            radius: local.radius_squared[i].sqrt(),
        })
        .collect();
    let positions: Vec<f64> = sites.iter().flat_map(|site| site.position).collect();
    let tree = Bisection::<3>::new(&positions, costs, parts, &Alone);
    let mut owned: Vec<Vec<Site<3>>> = vec![Vec::new(); parts];
    let mut sums = vec![0u64; parts];
    for (site, cost) in sites.iter().zip(costs) {
        let owner = tree.owner(&site.position);
        owned[owner].push(*site);
        sums[owner] += *cost as u64;
    }
    let mean = sums.iter().sum::<u64>() as f64 / parts as f64;
    let ghosts: usize = owned
        .iter()
        .map(|part| {
            let extent = Extent::of(part);
            sites.iter().filter(|site| extent.needs(site)).count() - part.len()
        })
        .sum();
    (*sums.iter().max().expect("a part") as f64 / mean, ghosts as f64 / sites.len() as f64)
}

/// By number and by cost: entries of the neighbour list and 30 more for a particle's own update, as in a run.
#[test]
fn a_thousand_parts_of_an_impact_are_balanced() {
    let local = impact();
    assert!(local.count > 195_000, "{} particles", local.count);
    let mut list = NeighbourList::default();
    list.build(&local);
    let entries: Vec<u32> = list.offsets.windows(2).map(|row| (row[1] - row[0]) as u32 + 30).collect();
    let same = vec![1; local.count];
    println!("{} particles\n{:>5} {:>7} {:>10} {:>16}", local.count, "parts", "cost", "imbalance", "ghosts per owned");
    for parts in [7, 64, 1000] {
        for (name, costs) in [("equal", &same), ("entries", &entries)] {
            let (imbalance, ghosts) = cut(&local, costs, parts);
            println!("{parts:>5} {name:>7} {imbalance:>10.4} {ghosts:>16.3}");
            assert!(imbalance < 1.05, "{parts} parts by {name}: {imbalance}");
        }
    }
}

/// The imbalance over a whole run with shocks, fracture and planes that move.
#[test]
fn four_ranks_are_balanced() {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let scene = write_scene(dir.path(), IMPACT);
    let out = dir.path().join("run");
    let args = [scene.as_os_str(), "--out".as_ref(), out.as_os_str()];
    Launch::scene(4, &args).run().expect_code(0);
    let summary = summary(&out);
    let number = |key: &str| summary[key].as_f64().unwrap_or(f64::NAN);
    println!(
        "4 ranks: imbalance {:.3}, {} list builds, {} rebisections, {:.2} ghosts per owned particle",
        number("imbalance"),
        number("list_builds"),
        number("rebisections"),
        number("ghost_fraction")
    );
    assert!(number("list_builds") >= 4.0 && number("rebisections") >= 1.0, "planes were moved in this run");
    assert!((1.0..=1.1).contains(&number("imbalance")), "{}", number("imbalance"));
}
