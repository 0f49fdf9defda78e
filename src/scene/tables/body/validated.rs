//! A body as the rest of the program knows it: where its particles are, and what they start with.

use std::ops::Range;

use serde::{Deserialize, Serialize};

use super::blast::Blast;
use super::filling::{COUNTED, is_filled};
use super::flow::Flow;
use super::given::Given;
use super::rigid::Rigid;
use super::table::InitialState;
use crate::material::BodyConstants;
use crate::motion::PrescribedMotion;
use crate::random::uniform;
use crate::scene::geometry::cut::Cut;
use crate::scene::geometry::joints::Joints;
use crate::scene::geometry::lattice::Lattice;
use crate::scene::geometry::rubble::Rubble;
use crate::scene::geometry::shape::BodyShape;

/// A validated body, SI units.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Body {
    pub name: String,
    pub shape: BodyShape,
    pub dimension: usize,
    /// Index into the scene's materials.
    pub material: usize,
    pub lattice: Lattice,
    /// Random shifts of particles from its sites.
    pub disorder: Option<Disorder>,
    /// Where the shape's centre is, m.
    pub centre: [f64; 3],
    /// Velocity of the centre, m/s.
    pub velocity: [f64; 3],
    /// Angular velocity about the centre, rad/s; along z in 2D.
    pub spin: [f64; 3],
    /// Damage at the start, 0 to 1.
    pub damage: f64,
    /// Specific internal energy at the start, J/kg.
    pub internal_energy: f64,
    /// Density at the start, kg/m^3.
    pub density: f64,
    /// Distention at the start, 1 without pores.
    pub distention: f64,
    pub motion: PrescribedMotion,
    pub rigid: Option<Rigid>,
    pub flow: Option<Flow>,
    pub blast: Option<Blast>,
    pub rubble: Option<Rubble>,
    pub joints: Option<Joints>,
    pub start: InitialState,
    /// What of the shape it is, where an impact refines its target.
    pub cut: Option<Cut>,
    /// What of the particles of a file it is, where it comes from one.
    pub given: Option<Given>,
}

/// Random shifts of particles from the sites of their lattice.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Disorder {
    /// Largest along each axis, in spacings.
    pub shift: f64,
    pub seed: u64,
}

impl Disorder {
    /// That of a site, m.
    fn of(&self, site: u64, spacing: f64, dimension: usize) -> [f64; 3] {
        let draw = |axis: usize| (2.0 * uniform(self.seed, site, axis as u64) - 1.0) * self.shift * spacing;
        std::array::from_fn(|axis| if axis < dimension { draw(axis) } else { 0.0 })
    }
}

impl Body {
    /// Exact volume of its matter, m^3 (in 2D m^2, per metre of depth).
    pub fn volume(&self) -> f64 {
        if let Some(given) = &self.given {
            return self.mass_of(given) / self.density;
        }
        self.cut.map_or_else(|| self.whole_volume(), |cut| cut.volume)
    }

    /// Exact volume of the matter of the body that it is or is a part of, m^3 (in 2D m^2).
    fn whole_volume(&self) -> f64 {
        if let Some(given) = &self.given {
            return given.whole_volume;
        }
        self.rubble.as_ref().map_or_else(|| self.shape.volume(self.dimension), |rubble| rubble.volume)
    }

    /// Exact mass of its matter, kg (per metre of depth in 2D).
    pub fn mass(&self) -> f64 {
        self.given.as_ref().map_or_else(|| self.density * self.volume(), |given| self.mass_of(given))
    }

    fn mass_of(&self, given: &Given) -> f64 {
        given.particles as f64 * given.particle_mass
    }

    /// Exact mass of the body that it is or is a part of, kg (per metre of depth in 2D).
    pub fn whole_mass(&self) -> f64 {
        self.given.as_ref().map_or_else(|| self.density * self.whole_volume(), |given| given.whole_mass)
    }

    /// Number of the scene's body that this one, with this number, is or is a part of.
    pub fn whole(&self, number: usize) -> usize {
        let of_file = self.given.as_ref().map(|given| given.body);
        self.cut.map(|cut| cut.body).or(of_file).unwrap_or(number)
    }

    pub fn contains(&self, point: [f64; 3]) -> bool {
        self.holds(std::array::from_fn(|k| point[k] - self.centre[k]))
    }

    /// Velocity at the start of a particle at `point`, m/s, but for a mode of vibration.
    pub fn velocity_at(&self, point: [f64; 3]) -> [f64; 3] {
        let r: [f64; 3] = std::array::from_fn(|k| point[k] - self.centre[k]);
        let [wx, wy, wz] = self.spin;
        let turning = [wy * r[2] - wz * r[1], wz * r[0] - wx * r[2], wx * r[1] - wy * r[0]];
        let flow = self.flow.and_then(|flow| flow.velocity(r)).unwrap_or_default();
        std::array::from_fn(|k| self.velocity[k] + turning[k] + flow[k])
    }

    /// Pressure of its flow at `point` beside its own, over density, m^2/s^2.
    pub fn flow_pressure(&self, point: [f64; 3]) -> f64 {
        self.flow.map_or(0.0, |flow| flow.pressure(std::array::from_fn(|k| point[k] - self.centre[k])))
    }

    /// Damage at the start of a particle at `point`: whole where a joint or the surface of a block is less than a spacing away.
    pub fn damage_at(&self, point: [f64; 3]) -> f64 {
        let local = std::array::from_fn(|k| point[k] - self.centre[k]);
        let joint = self.joints.as_ref().map_or(f64::INFINITY, |joints| joints.depth(local));
        let surface = self.rubble.as_ref().and_then(|rubble| rubble.depth(local)).unwrap_or(f64::INFINITY);
        if joint.min(surface) < self.lattice.spacing { 1.0 } else { self.damage }
    }

    fn holds(&self, local: [f64; 3]) -> bool {
        is_filled(local, &self.shape, self.rubble.as_ref(), self.dimension)
            && self.cut.is_none_or(|cut| cut.holds(local))
    }

    /// Lattice sites are numbered below this; those inside the shape are its particles. Particles of a file have none.
    pub fn lattice_sites(&self) -> u64 {
        if self.given.is_some() { 0 } else { self.lattice.sites() }
    }

    /// The site of the lattice that a particle has started from, m; none where it comes from a file.
    pub fn site(&self, site: u64) -> Option<[f64; 3]> {
        let place = |local: [f64; 3]| std::array::from_fn(|k| self.centre[k] + local[k]);
        self.given.is_none().then(|| place(self.lattice.position(site)))
    }

    /// The sites of `range` that lie inside, with their positions: the same bits whoever asks.
    pub fn sites(&self, range: Range<u64>) -> impl Iterator<Item = (u64, [f64; 3])> + '_ {
        range.filter_map(|site| {
            let local = self.lattice.position(site);
            self.holds(local).then(|| (site, self.placed(site, local)))
        })
    }

    /// Where the particle of a site starts, before its own weight compresses the body, m; of particles of a file, the centre.
    pub fn start_of(&self, site: u64) -> [f64; 3] {
        if self.given.is_some() {
            return self.centre;
        }
        self.placed(site, self.lattice.position(site))
    }

    fn placed(&self, site: u64, local: [f64; 3]) -> [f64; 3] {
        let disorder = |disorder: Disorder| disorder.of(site, self.lattice.spacing, self.dimension);
        let shift = self.disorder.map_or([0.0; 3], disorder);
        std::array::from_fn(|k| self.centre[k] + (local[k] + shift[k]))
    }

    /// Particles among the sites of `range`.
    pub fn count(&self, range: Range<u64>) -> u64 {
        range.filter(|site| self.holds(self.lattice.position(*site))).count() as u64
    }

    /// Whether it has no particles at all; those of many sites are not counted.
    pub fn has_no_site(&self) -> bool {
        let sites = self.lattice_sites();
        self.given.is_none() && sites <= COUNTED && self.count(0..sites) == 0
    }

    /// Particles as expected from the volume; the true number differs at the surface.
    pub fn expected_particles(&self) -> f64 {
        self.given.as_ref().map_or_else(|| self.volume() / self.lattice.cell_volume(), |given| given.particles as f64)
    }

    /// What all particles share, once their number is known; `eta` is h over (m / rho)^(1/d).
    pub fn constants(&self, particles: u64, eta: f64) -> BodyConstants {
        let particle_mass =
            self.given.as_ref().map_or_else(|| self.mass() / particles as f64, |given| given.particle_mass);
        let smoothing_length = eta * root(particle_mass / self.density, self.dimension);
        BodyConstants { particle_mass, smoothing_length, particles, density: self.density, distention: self.distention }
    }

    /// Smoothing length as expected from the lattice, before particles are counted, m.
    pub fn expected_smoothing_length(&self, eta: f64) -> f64 {
        eta * root(self.lattice.cell_volume(), self.dimension)
    }
}

/// The d-th root.
fn root(volume: f64, dimension: usize) -> f64 {
    if dimension == 2 { volume.sqrt() } else { libm::cbrt(volume) }
}

#[cfg(test)]
mod tests {
    use crate::scene::Scene;

    const BALL: &str = "[[body]]\nname = \"ball\"\nshape = { sphere = { radius = 1 } }\nmaterial = \"basalt\"\nspacing = 0.2\n[run]\nuntil = 1\n";

    fn places(changes: &[&str]) -> Vec<(u64, [f64; 3])> {
        let changes: Vec<String> = changes.iter().map(|change| change.to_string()).collect();
        let scene = Scene::parse("s.toml", BALL, &changes).unwrap_or_else(|e| panic!("{e}"));
        let body = &scene.bodies[0];
        body.sites(0..body.lattice_sites()).collect()
    }

    #[test]
    fn disorder_shifts_particles_at_random() {
        let (even, uneven) = (places(&[]), places(&["ball.disorder.shift=0.3"]));
        let (mut most, mut sum) = (0.0f64, 0.0);
        for ((site, x), (other, y)) in even.iter().zip(&uneven) {
            assert_eq!(site, other);
            for k in 0..3 {
                most = most.max((y[k] - x[k]).abs());
                sum += y[k] - x[k];
            }
        }
        assert!((0.05..=0.06).contains(&most) && sum.abs() / (3.0 * even.len() as f64) < 0.003, "{most} {sum}");
        assert_eq!((even.len(), &uneven), (uneven.len(), &places(&["ball.disorder={ shift = 0.3, seed = 0 }"])));
        assert_ne!(uneven, places(&["ball.disorder={ shift = 0.3, seed = 1 }"]));
        let wrong = Scene::parse("s.toml", BALL, &["ball.disorder.shift=0.6".to_string()]).expect_err("too far");
        assert!(
            wrong.to_string().contains("body.0.disorder.shift") || wrong.to_string().contains("disorder.shift=0.6"),
            "{wrong}"
        );
    }
}
