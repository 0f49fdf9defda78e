//! Outcomes on 1, 2, 3 and 4 ranks: against exact answers, and bit for bit against each other.
//!
//! A test started plainly runs itself again under mpirun for each number of ranks; every run prints a digest of its results
//! and all digests must agree. Particles are dealt out to ranks by slabs, with some astray, so that fragments and cells are cut.

use crate::common::same_on_any_ranks;
use sph_mpi::domain::comm::Comm;
use sph_mpi::gravity::G;
use sph_mpi::math::Vec3;
use sph_mpi::outcome::deposit::{Deposit, Question as Heap};
use sph_mpi::outcome::{Evaluation, Particle, Question, distributions::distributions, evaluate, fragments, origin};
use sph_mpi::random::uniform;

/// Whether this rank holds something at `x` in [-1, 1]: slabs, with one in twenty astray.
fn is_mine(comm: &Comm, id: u64, x: f64) -> bool {
    let astray = uniform(77, id, 0) < 0.05;
    let place = if astray { uniform(77, id, 1) } else { (0.5 * (x + 1.0)).clamp(0.0, 0.999_999) };
    (place * comm.size() as f64) as usize == comm.rank()
}

/// All ranks' (id, words) on rank 0, as text in order of id.
fn collected(comm: &Comm, records: Vec<(u64, Vec<u64>)>) -> String {
    let words = records.iter().flat_map(|(id, w)| [&[*id, w.len() as u64], w.as_slice()].concat()).collect();
    let mut all: Vec<(u64, Vec<u64>)> = Vec::new();
    for (_, words) in comm.sparse_exchange(vec![(0, words)]) {
        let mut rest = words.as_slice();
        while let [id, n, after @ ..] = rest {
            all.push((*id, after[..*n as usize].to_vec()));
            rest = &after[*n as usize..];
        }
    }
    all.sort();
    format!("{all:?}")
}

const SPACING: f64 = 100.0;

/// Of target and projectile alone.
fn question(dimension: usize, target_mass: f64) -> Question {
    Question { dimension, target_mass, bodies: [0, 1], others: false }
}

/// A particle on the cubic lattice of spacing 100 m, density 2700.
fn particle(id: u64, site: [i64; 3], velocity: Vec3, damage: f64) -> Particle {
    let position = Vec3::from_fn(|k, _| SPACING * site[k] as f64);
    let volume = SPACING * SPACING * SPACING;
    let body = (id >> 48) as usize;
    Particle { id, body, position, velocity, mass: 2700.0 * volume, volume, spacing: SPACING, damage }
}

fn share(comm: &Comm, all: &[Particle], half_width: f64) -> Vec<Particle> {
    all.iter().copied().filter(|p| is_mine(comm, p.id, p.position.x / half_width)).collect()
}

fn digest(comm: &Comm, evaluation: &Evaluation) -> String {
    let tables = distributions(comm, evaluation, 3);
    let words = |p: &sph_mpi::outcome::Piece| {
        let numbers = [p.mass, p.position.x, p.position.y, p.position.z, p.velocity.x, p.velocity.y, p.velocity.z];
        [&[p.count][..], &numbers.map(f64::to_bits)].concat()
    };
    let pieces = collected(comm, evaluation.pieces.iter().map(|p| (p.label, words(p))).collect());
    if !comm.is_root() {
        return String::new();
    }
    let summary = serde_json::to_string(&evaluation.outcome).expect("an outcome is plain data");
    [pieces, summary, tables.fragments, tables.sizes, tables.velocities].join("\n")
}

/// A rod that winds through all slabs several times, a block, and dust between: labels have to travel far.
#[test]
fn fragments_across_ranks() {
    same_on_any_ranks("ranks_outcome::fragments_across_ranks", |comm| {
        let mut all = Vec::new();
        let mut id = 5000;
        let mut put = |site: [i64; 3], damage: f64| {
            id = (id * 7 + 3) % 9973; // ids without relation to place
            all.push(particle(id, site, Vec3::zeros(), damage));
        };
        for row in 0..6 {
            (-40..=40).for_each(|x| put([x, 4 * row, 0], 0.89));
            if row < 5 {
                let turn = if row % 2 == 0 { 40 } else { -40 };
                (1..4).for_each(|y| put([turn, 4 * row + y, 0], 0.0));
            }
        }
        let rod = 6 * 81 + 15;
        (0..27).for_each(|k| put([k / 9 - 20, k / 3 % 3 + 2, k % 3 + 20], 0.1));
        (-40..=40).for_each(|x| put([x, 2, 1], 0.9));
        let mine = share(comm, &all, 40.0 * SPACING);
        let labels = fragments::labels(comm, &mine, fragments::Link::Intact(0.9));
        for (p, label) in mine.iter().zip(&labels) {
            let at = all.iter().position(|q| q.id == p.id).unwrap();
            let smallest = |range: std::ops::Range<usize>| all[range].iter().map(|q| q.id).min();
            let expected = match at {
                at if at < rod => smallest(0..rod),
                at if at < rod + 27 => smallest(rod..rod + 27),
                _ => None,
            };
            assert_eq!(*label, expected, "{at}");
        }
        let question = question(2, 1e12);
        let evaluation = evaluate(comm, &mine, &question);
        assert_eq!(evaluation.outcome.fragments, 2);
        let mass = all[0].mass;
        assert!((evaluation.outcome.largest_fragment_fraction * 1e12 / (rod as f64 * mass) - 1.0).abs() < 1e-14);
        digest(comm, &evaluation)
    });
}

/// Rubble, a chip that leaves, and a second ball: the larger ball is bound although nothing in it is intact.
#[test]
fn rubble_is_bound_and_fast_ejecta_are_not() {
    same_on_any_ranks("ranks_outcome::rubble_is_bound_and_fast_ejecta_are_not", |comm| {
        let ball = |radius: i64| {
            let side = -radius..=radius;
            let sites = side.clone().flat_map(move |x| {
                let side = side.clone();
                side.clone().flat_map(move |y| side.clone().map(move |z| [x, y, z]))
            });
            sites.filter(move |s| s.iter().map(|c| c * c).sum::<i64>() <= radius * radius)
        };
        let is_core = |site: &[i64; 3]| site.iter().map(|c| c * c).sum::<i64>() <= 9;
        let mut all: Vec<Particle> = Vec::new();
        let mut put = |site, velocity, damage| all.push(particle(all.len() as u64, site, velocity, damage));
        // v_esc of the ball: R sqrt(8 pi G rho / 3) = 800 * 1.23e-3 = 0.98 m/s; it expands at a third of that.
        let escape = 800.0 * (8.0 / 3.0 * std::f64::consts::PI * G * 2700.0).sqrt();
        for site in ball(8) {
            let outward = Vec3::from_fn(|k, _| site[k] as f64 / 8.0);
            // The middle, deepest of all, is faster than escape: what is bound must not be asked of it alone.
            let through = Vec3::new(0.0, 0.0, if is_core(&site) { 3.0 * escape } else { 0.0 });
            put(site, outward * (escape / 3.0) + through, 1.0);
        }
        let (in_large, in_core) = (ball(8).count(), ball(8).filter(is_core).count());
        // A second ball of half the size, flying off at ten times the speed of escape.
        for [x, y, z] in ball(4) {
            put([x + 60, y, z], Vec3::new(10.0 * escape, 0.0, 0.0), 1.0);
        }
        let in_small = ball(4).count();
        // An intact chip at the surface that is faster than escape, and one that is slower.
        (0..2).for_each(|k| put([0, 12, k], Vec3::new(0.0, 2.0 * escape, 0.0), 0.0));
        (0..2).for_each(|k| put([0, -12, k], Vec3::new(0.0, -0.5 * escape, 0.0), 0.0));
        let mine = share(comm, &all, 65.0 * SPACING);
        let mass = all[0].mass;
        let target_mass = mass * in_large as f64;
        let evaluation = evaluate(comm, &mine, &question(3, target_mass));
        let outcome = &evaluation.outcome;
        let expected = (in_large + 2 - in_core) as f64 / in_large as f64;
        assert!((outcome.largest_remnant_fraction - expected).abs() < 1e-12, "{outcome:?} {expected}");
        assert!((outcome.second_remnant_fraction - in_small as f64 / in_large as f64).abs() < 1e-12, "{outcome:?}");
        assert!((outcome.unbound_mass / mass - (in_small + 2 + in_core) as f64).abs() < 1e-9);
        // The ball's own motions cancel; of the chips the slow one belongs to it.
        let momentum = outcome.largest_remnant_momentum.map(|p| p / (mass * escape));
        assert!((momentum[1] + 1.0).abs() < 1e-9 && momentum[0].abs() + momentum[2].abs() < 1e-9, "{momentum:?}");
        assert_eq!(outcome.fragments, 2);
        assert!((outcome.largest_fragment_fraction - 2.0 / in_large as f64).abs() < 1e-15);
        digest(comm, &evaluation)
    });
}

/// Two fragments of a solid target that separate slowly are one remnant, and two when they are fast: two-body energy.
#[test]
fn two_halves_obey_two_body_energy() {
    same_on_any_ranks("ranks_outcome::two_halves_obey_two_body_energy", |comm| {
        let mut fractions = Vec::new();
        for factor in [0.98, 1.02] {
            let mut all: Vec<Particle> = Vec::new();
            let (n, gap) = (6i64, 40i64);
            let half_mass = (n * n * n) as f64 * 2700.0 * SPACING * SPACING * SPACING;
            let escape = (2.0 * G * 2.0 * half_mass / (gap as f64 * SPACING)).sqrt();
            for k in 0..2 * n * n * n {
                let (block, site) = (k / (n * n * n), k % (n * n * n));
                let position = [site / (n * n) + gap * block - 23, site / n % n, site % n];
                let speed = factor * escape * (block as f64 - 0.5);
                all.push(particle(k as u64, position, Vec3::new(speed, 0.0, 0.0), 0.0));
            }
            let mine = share(comm, &all, 25.0 * SPACING);
            let question = question(3, 2.0 * half_mass);
            let outcome = evaluate(comm, &mine, &question).outcome;
            assert!((outcome.largest_fragment_fraction - 0.5).abs() < 1e-14);
            fractions.push(outcome.largest_remnant_fraction);
        }
        assert!((fractions[0] - 1.0).abs() < 1e-14 && (fractions[1] - 0.5).abs() < 1e-14, "{fractions:?}");
        format!("{fractions:?}")
    });
}

/// Ranks without particles take part: two particles on one rank, linked or apart.
#[test]
fn few_particles() {
    same_on_any_ranks("ranks_outcome::few_particles", |comm| {
        let question = question(3, 2.0 * 2700.0 * SPACING * SPACING * SPACING);
        let look = |distance, speed| {
            let both = [
                particle(3, [0; 3], Vec3::zeros(), 0.0),
                particle(8, [distance, 0, 0], Vec3::new(speed, 0.0, 0.0), 0.0),
            ];
            let is_last = comm.rank() + 1 == comm.size();
            let evaluation = evaluate(comm, if is_last { &both } else { &[] }, &question);
            (evaluation.outcome.clone(), digest(comm, &evaluation))
        };
        let (linked, apart) = (look(1, 0.0), look(5, 1.0));
        assert_eq!((linked.0.fragments, linked.0.largest_fragment_fraction), (1, 1.0));
        assert_eq!((linked.0.largest_remnant_fraction, linked.0.second_remnant_fraction), (1.0, 0.0));
        assert_eq!((apart.0.fragments, apart.0.largest_fragment_fraction), (0, 0.0));
        assert_eq!((apart.0.largest_remnant_fraction, apart.0.second_remnant_fraction), (0.5, 0.5));
        linked.1 + &apart.1
    });
}

/// Half-damaged rubble that flies apart at about the speed of escape: many fragments, much that is barely bound, all bits
/// of pieces, outcome and tables compared. Mass is conserved, and what is bound is neither nothing nor all.
#[test]
fn expanding_rubble_has_one_outcome() {
    same_on_any_ranks("ranks_outcome::expanding_rubble_has_one_outcome", |comm| {
        let n = 9i64;
        let escape = n as f64 * SPACING * (8.0 / 3.0 * std::f64::consts::PI * G * 2700.0).sqrt();
        let side = -n..=n;
        let sites = side.clone().flat_map(|x| {
            let side = side.clone();
            side.clone().flat_map(move |y| side.clone().map(move |z| [x, y, z]))
        });
        let all: Vec<Particle> = sites
            .filter(|s| s.iter().map(|c| c * c).sum::<i64>() <= n * n)
            .enumerate()
            .map(|(k, site)| {
                let id = k as u64;
                let draw = |number| uniform(3, id, number);
                let out = Vec3::from_fn(|k, _| site[k] as f64 / n as f64);
                let speed = escape * (0.2 + 1.6 * out.norm_squared() * draw(0));
                particle(id, site, out * speed, if draw(1) < 0.12 { 0.7 * draw(2) } else { 1.0 })
            })
            .collect();
        let mine = share(comm, &all, n as f64 * SPACING);
        let target_mass = all[0].mass * all.len() as f64;
        let evaluation = evaluate(comm, &mine, &question(3, target_mass));
        let outcome = &evaluation.outcome;
        assert!((outcome.total_mass / target_mass - 1.0).abs() < 1e-14);
        assert!(outcome.fragments > 20 && outcome.strict.fragments > 20, "{outcome:?}");
        assert!(outcome.largest_remnant_fraction > 0.2 && outcome.largest_remnant_fraction < 0.98, "{outcome:?}");
        digest(comm, &evaluation)
    });
}

/// A rod of which a part is damaged: one fragment by the usual threshold, a shorter one by the strict. Both shares of it, over the
/// target and over everything.
#[test]
fn shares_are_those_of_the_masses_they_are_named_for() {
    same_on_any_ranks("ranks_outcome::shares_are_those_of_the_masses_they_are_named_for", |comm| {
        let rod = |k: i64| particle(k as u64, [k - 6, 0, 0], Vec3::zeros(), if k < 4 { 0.2 } else { 0.7 });
        let dust = |k: i64| particle(20 + k as u64, [0, 10 * k, 0], Vec3::zeros(), 1.0);
        let all: Vec<Particle> = (0..10).map(rod).chain((1..=5).map(dust)).collect();
        let mine = share(comm, &all, 7.0 * SPACING);
        let question = question(2, 12.0 * all[0].mass);
        let evaluation = evaluate(comm, &mine, &question);
        let outcome = &evaluation.outcome;
        let near =
            |found: f64, expected: f64| assert!((found - expected).abs() < 1e-14, "{found} {expected}: {outcome:?}");
        near(outcome.largest_remnant_fraction, 10.0 / 12.0);
        near(outcome.largest_remnant_of_total, 10.0 / 15.0);
        near(outcome.second_remnant_fraction, 1.0 / 12.0);
        near(outcome.largest_fragment_fraction, 10.0 / 12.0);
        near(outcome.unbound_mass / all[0].mass, 5.0);
        near(outcome.strict.largest_remnant_fraction, 4.0 / 12.0);
        near(outcome.strict.largest_fragment_fraction, 4.0 / 12.0);
        assert_eq!((outcome.fragments, outcome.strict.fragments), (1, 1));
        digest(comm, &evaluation)
    });
}

/// A broken moonlet that falls together again, an intact chip of it that leaves, a projectile that has flown on; and beside them a
/// neighbour of thirty times its mass, whole or in rubble. Figures are those without the neighbour; by itself each body is told.
#[test]
fn a_neighbour_is_no_remnant() {
    same_on_any_ranks("ranks_outcome::a_neighbour_is_no_remnant", |comm| {
        let ball = |radius: i64, centre: i64| {
            let sites = (0..(2 * radius + 1).pow(3)).map(move |k| {
                let side = 2 * radius + 1;
                [k / (side * side) - radius, k / side % side - radius, k % side - radius]
            });
            let inside = sites.filter(move |s| s.iter().map(|c| c * c).sum::<i64>() <= radius * radius);
            inside.map(move |[x, y, z]| [x + centre, y, z])
        };
        let mut answers = String::new();
        for neighbour_damage in [0.0, 1.0] {
            let mut all: Vec<Particle> = Vec::new();
            let mut put = |body: u64, sites: &mut dyn Iterator<Item = [i64; 3]>, speed: f64, damage| {
                for site in sites {
                    let id = (body << 48) + all.len() as u64;
                    all.push(particle(id, site, Vec3::new(0.0, speed, 0.0), damage));
                }
            };
            put(0, &mut ball(3, 0), 0.0, 1.0);
            put(0, &mut (0..5).map(|k| [0, 8, k]), 50.0, 0.0);
            put(1, &mut ball(2, 30), 80.0, 1.0);
            put(2, &mut ball(9, -30), 0.0, neighbour_damage);
            let (moonlet, chip) = (ball(3, 0).count() as f64, 5.0);
            let own = moonlet as usize + 5 + ball(2, 30).count();
            let mass = all[0].mass;
            let target_mass = mass * (moonlet + chip);
            let alone = share(comm, &all[..own], 40.0 * SPACING);
            let alone = evaluate(comm, &alone, &question(3, target_mass)).outcome;
            let mine = share(comm, &all, 40.0 * SPACING);
            let asked = Question { others: true, ..question(3, target_mass) };
            let evaluation = evaluate(comm, &mine, &asked);
            let found = &evaluation.outcome;
            let same = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-12, "{a} {b}");
            same(found.largest_remnant_fraction, moonlet / (moonlet + chip));
            same(found.largest_remnant_fraction, alone.largest_remnant_fraction);
            same(found.largest_remnant_of_total, alone.largest_remnant_of_total);
            same(found.second_remnant_fraction, alone.second_remnant_fraction);
            same(found.largest_fragment_fraction, chip / (moonlet + chip));
            same(found.unbound_mass, alone.unbound_mass);
            assert_eq!((found.fragments, found.largest_remnant_particles), (1, moonlet as u64));
            let masses = [target_mass, mass * ball(2, 0).count() as f64, mass * ball(9, 0).count() as f64];
            let told = origin::by_body(comm, &mine, &evaluation, &asked, &masses);
            same(told[0].remnant, moonlet / (moonlet + chip));
            same(told[0].fragment, chip / (moonlet + chip));
            assert_eq!((told[1].in_largest_remnant, told[1].fragment), (0.0, 0.0));
            same(told[1].remnant, 1.0);
            assert_eq!((told[2].body, told[2].in_largest_remnant), (2, 0.0));
            same(told[2].remnant, 1.0);
            assert_eq!(told[2].fragment > 0.99, neighbour_damage == 0.0);
            answers += &(digest(comm, &evaluation) + &format!("{told:?}"));
        }
        answers
    });
}

/// A cone of a slope of one half, eight sites high, and a wedge across a period.
#[test]
fn deposits() {
    same_on_any_ranks("ranks_outcome::deposits", |comm| {
        let sites = |round: bool| {
            let across = if round { -16i64..=16 } else { 0..=2 };
            let plane = (-16i64..=16).flat_map(move |x| across.clone().map(move |y| (x, y)));
            plane.flat_map(move |(x, y)| {
                let out = if round { ((x * x + y * y) as f64).sqrt() } else { x.abs() as f64 };
                (0..).take_while(move |z| *z as f64 + 0.5 <= 8.0 - 0.5 * out).map(move |z| [x, y, z])
            })
        };
        let heap = |round: bool| {
            let speed = Vec3::new(0.0, 3.0, 4.0);
            let all: Vec<Particle> =
                sites(round).enumerate().map(|(id, site)| particle(id as u64, site, speed, 1.0)).collect();
            let question = Heap {
                origin: Vec3::new(0.0, 0.0, -0.5 * SPACING),
                up: Vec3::z(),
                out: [Some(0), round.then_some(1)],
                spacing: SPACING,
            };
            Deposit::measure(comm, &share(comm, &all, 16.0 * SPACING), &question)
        };
        let (cone, wedge) = (heap(true), heap(false));
        assert_eq!((cone.speed, wedge.speed), (5.0, 5.0));
        // Two sites are as high as each other; the highest particle is half a spacing below the top.
        assert_eq!(wedge.profile[1], [3.0 * SPACING, 6.5 * SPACING]);
        assert_eq!((wedge.height, wedge.foot), (7.5 * SPACING, 12.0 * SPACING));
        assert!((wedge.flank - 0.5).abs() < 1e-12 && (cone.flank - 0.5).abs() < 0.05, "{} {}", wedge.flank, cone.flank);
        // Of a cone a hundredth lies beyond the circle where (out / radius)^2 (3 - 2 out / radius) is 0.99.
        assert!((cone.foot_99 / (0.941 * 15.0 * SPACING) - 1.0).abs() < 0.06, "{}", cone.foot_99);
        let bits = |heap: &Deposit| [heap.foot, heap.foot_99, heap.height, heap.flank].map(f64::to_bits);
        format!("{:?} {:?} {}", bits(&cone), bits(&wedge), cone.table())
    });
}
