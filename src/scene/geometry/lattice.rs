//! Lattices that fill bodies. A body's sites are numbered 0, 1, ... through a block that covers its shape; any rank can
//! enumerate any part of the block, and a site has the same bits whoever computes it.
//!
//! Hexagonal close packing: rows `d` apart along x, sqrt(3)/2 d between rows, sqrt(2/3) d between layers, layers
//! alternating A B; twelve neighbours at distance d. In 2D it is one layer: the hexagonal lattice with six.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::bounding_box::BoundingBox;
use crate::error::{Error, Result};
use crate::particles::ParticleId;
use crate::random::uniform_pair;

/// Regular arrangements of particles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, Default, JsonSchema)]
pub enum LatticeKind {
    /// Hexagonal close packing; hexagonal in 2D.
    #[default]
    #[serde(rename = "hcp", alias = "hexagonal")]
    #[schemars(extend("x-alias" = "hexagonal"))]
    ClosePacked,
    /// Simple cubic; square in 2D.
    #[serde(rename = "cubic", alias = "square")]
    #[schemars(extend("x-alias" = "square"))]
    Cubic,
}

pub type Rotation = [[f64; 3]; 3];

pub const IDENTITY: Rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl LatticeKind {
    /// Distances between rows along x, along y and between layers, in units of the spacing.
    fn steps(self) -> [f64; 3] {
        match self {
            LatticeKind::ClosePacked => [1.0, 0.75f64.sqrt(), (2.0f64 / 3.0).sqrt()],
            LatticeKind::Cubic => [1.0; 3],
        }
    }

    /// Volume (area in 2D) that belongs to one site.
    pub fn cell_volume(self, spacing: f64, dimension: usize) -> f64 {
        self.steps()[..dimension].iter().map(|step| step * spacing).product()
    }

    /// The spacing at which one site has this volume (area in 2D).
    pub fn spacing_of_cell(self, volume: f64, dimension: usize) -> f64 {
        let relative = volume / self.cell_volume(1.0, dimension);
        if dimension == 2 { relative.sqrt() } else { libm::cbrt(relative) }
    }
}

/// A block of lattice sites around a centre, turned by a rotation. In 2D it has one layer at z = 0.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Lattice {
    pub kind: LatticeKind,
    /// Distance between nearest sites, m.
    pub spacing: f64,
    /// From the lattice's frame to the body's.
    pub rotation: Rotation,
    /// Distances between rows along the lattice's axes, m.
    steps: [f64; 3],
    /// Middle of the block relative to the body's centre, m.
    middle: [f64; 3],
    /// Sites along the lattice's three axes.
    counts: [u64; 3],
    dimension: usize,
}

impl Lattice {
    /// The lattice over a box with the given middle and half extents (body frame, m; the last is 0 in 2D). Along axes with
    /// flat faces rows are moved apart or together by little, so that a whole number of them fills the box.
    pub fn covering(
        kind: LatticeKind,
        spacing: f64,
        rotation: Rotation,
        bounds: BoundingBox,
        faces: Faces,
    ) -> Result<Self> {
        if !(spacing > 0.0 && spacing.is_finite()) {
            return Err(
                Error::new(format!("the spacing comes to {spacing} m")).allowed("sizes within reach of numbers")
            );
        }
        let dimension = bounds.dimension;
        let mut counts = [1; 3];
        let mut steps = kind.steps().map(|step| step * spacing);
        let mut sites = 1.0;
        for axis in 0..dimension {
            // Half extent of the turned box along this axis of the lattice.
            let half: f64 = (0..3).map(|a| rotation[a][axis].abs() * bounds.half[a]).sum();
            // Rounding keeps every site of the infinite lattice that lies inside: the first row left out is a quarter step
            // or more beyond the edge, and rows are shifted by a quarter step at most.
            let mut count = (2.0 * half / steps[axis]).round().max(1.0);
            // Close-packed rows and layers alternate; on the other side of a period they must go on as they would.
            if faces.periodic[axis] && kind == LatticeKind::ClosePacked && axis > 0 {
                count = 2.0 * (half / steps[axis]).round().max(1.0);
            }
            let fitted = 2.0 * half / count;
            let stretch = (fitted / steps[axis] - 1.0).abs();
            if faces.periodic[axis] && stretch > MOST_STRETCH {
                let what = format!("rows {} m apart do not fit into a period of {} m", steps[axis], 2.0 * half);
                return Err(Error::new(what).allowed("a smaller spacing, or a longer period"));
            }
            if rotation == IDENTITY && (faces.flat && stretch <= MOST_STRETCH) {
                steps[axis] = fitted;
            }
            sites *= count;
            counts[axis] = count as u64;
        }
        if sites >= (1u64 << ParticleId::SITE_BITS) as f64 {
            return Err(Error::new(format!("a spacing of {spacing} m needs {sites:.2e} lattice sites"))
                .allowed("at most 2^48 sites per body"));
        }
        Ok(Self { kind, spacing, rotation, steps, middle: bounds.middle, counts, dimension })
    }

    /// Sites of the whole block; site numbers are below this.
    pub fn sites(&self) -> u64 {
        self.counts.iter().product()
    }

    /// Volume (area in 2D) that belongs to one site.
    pub fn cell_volume(&self) -> f64 {
        self.steps[..self.dimension].iter().product()
    }

    /// Position of a site relative to the body's centre, m.
    pub fn position(&self, site: u64) -> [f64; 3] {
        let [nx, ny, nz] = self.counts;
        let (i, j, k) = (site % nx, site / nx % ny, site / (nx * ny));
        let centred = |index: u64, count: u64| index as f64 - 0.5 * (count - 1) as f64;
        let mut at = [centred(i, nx), centred(j, ny), centred(k, nz)];
        if self.kind == LatticeKind::ClosePacked {
            at[0] += 0.5 * ((j + k) % 2) as f64 - 0.25;
            if self.dimension == 3 {
                at[1] += (k % 2) as f64 / 3.0 - 1.0 / 6.0;
            }
        }
        for (x, step) in at.iter_mut().zip(self.steps) {
            *x *= step;
        }
        std::array::from_fn(|a| {
            let row = self.rotation[a];
            self.middle[a] + (row[0] * at[0] + row[1] * at[1] + row[2] * at[2])
        })
    }
}

/// What lattices may be fitted to.
#[derive(Debug, Clone, Copy, Default)]
pub struct Faces {
    /// The bounds are the shape itself: a box.
    pub flat: bool,
    /// Axes along which the shape fills a period.
    pub periodic: [bool; 3],
}

/// Rows are moved apart or together by this share at most.
const MOST_STRETCH: f64 = 0.15;

/// Rotation by `angle` (radians) about `axis` (any length but zero).
pub fn rotation_about(axis: [f64; 3], angle: f64) -> Rotation {
    // By a power of two, which changes no bit of the quotients below, to where squares neither overflow nor vanish.
    let largest = axis.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let (_, exponent) = libm::frexp(largest);
    let axis = axis.map(|x| libm::scalbn(x, -exponent));
    let length = (axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]).sqrt();
    let (s, c) = (libm::sin(0.5 * angle), libm::cos(0.5 * angle));
    rotation_of_quaternion([c, s * axis[0] / length, s * axis[1] / length, s * axis[2] / length])
}

/// A rotation drawn uniformly from all rotations (Shoemake 1992, Graphics Gems III, p. 124); about z in 2D.
pub fn random_rotation(seed: u64, dimension: usize) -> Rotation {
    let [u0, u1] = uniform_pair(seed, 0, 0);
    let [u2, _] = uniform_pair(seed, 0, 1);
    let turn = 2.0 * std::f64::consts::PI;
    if dimension == 2 {
        return rotation_about([0.0, 0.0, 1.0], turn * u0);
    }
    let (r1, r2) = ((1.0 - u0).sqrt(), u0.sqrt());
    let (a, b) = (turn * u1, turn * u2);
    rotation_of_quaternion([r2 * libm::cos(b), r1 * libm::sin(a), r1 * libm::cos(a), r2 * libm::sin(b)])
}

/// The rotation of a unit quaternion w, x, y, z.
fn rotation_of_quaternion([w, x, y, z]: [f64; 4]) -> Rotation {
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn block(kind: LatticeKind, rotation: Rotation, half: [f64; 3], dimension: usize) -> Lattice {
        Lattice::covering(
            kind,
            0.7,
            rotation,
            BoundingBox { middle: [0.1, -0.2, 0.0], half, dimension },
            Faces::default(),
        )
        .unwrap()
    }

    fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
        (0..3).map(|k| (a[k] - b[k]) * (a[k] - b[k])).sum::<f64>().sqrt()
    }

    /// Neighbours at the spacing of the site nearest the middle, and the least distance of any two sites.
    fn shells(lattice: &Lattice) -> (usize, f64) {
        let all: Vec<_> = (0..lattice.sites()).map(|s| lattice.position(s)).collect();
        let middle =
            *all.iter().min_by(|a, b| distance(**a, lattice.middle).total_cmp(&distance(**b, lattice.middle))).unwrap();
        let touching = all.iter().filter(|p| (distance(**p, middle) - lattice.spacing).abs() < 1e-12).count();
        let mut least = f64::INFINITY;
        for (i, a) in all.iter().enumerate() {
            for b in &all[..i] {
                least = least.min(distance(*a, *b));
            }
        }
        (touching, least)
    }

    #[test]
    fn nearest_neighbours() {
        let turned = random_rotation(3, 3);
        let cases = [
            (LatticeKind::ClosePacked, IDENTITY, 3, 12),
            (LatticeKind::ClosePacked, turned, 3, 12),
            (LatticeKind::Cubic, turned, 3, 6),
            (LatticeKind::ClosePacked, random_rotation(3, 2), 2, 6),
            (LatticeKind::Cubic, IDENTITY, 2, 4),
        ];
        for (kind, rotation, dimension, neighbours) in cases {
            let half = if dimension == 3 { [2.5; 3] } else { [4.0, 4.0, 0.0] };
            let (touching, least) = shells(&block(kind, rotation, half, dimension));
            assert_eq!(touching, neighbours, "{kind:?} in {dimension}D");
            assert!((least - 0.7).abs() < 1e-12, "{least}");
        }
    }

    /// A commensurate box of a cubic lattice has exactly its sites, all inside.
    #[test]
    fn cubic_lattice_fills_a_box_exactly() {
        let lattice = block(LatticeKind::Cubic, IDENTITY, [0.35 * 4.0, 0.35 * 5.0, 0.35 * 6.0], 3);
        assert_eq!(lattice.sites(), 4 * 5 * 6);
        let first = lattice.position(0);
        assert!((first[0] - (0.1 - 0.7 * 1.5)).abs() < 1e-15 && (first[1] - (-0.2 - 0.7 * 2.0)).abs() < 1e-15);
    }

    #[test]
    fn two_dimensional_lattices_stay_in_the_plane() {
        let lattice = block(LatticeKind::ClosePacked, random_rotation(9, 2), [3.0, 2.0, 0.0], 2);
        assert!((0..lattice.sites()).all(|s| lattice.position(s)[2] == 0.0));
    }

    /// Rows of a random rotation are orthonormal with determinant one, and their mean over draws vanishes.
    #[test]
    fn rotations_are_proper_and_unbiased() {
        let mut mean = [[0.0; 3]; 3];
        let draws = 4000;
        for seed in 0..draws {
            let r = random_rotation(seed, 3);
            for (a, row) in r.iter().enumerate() {
                for b in 0..3 {
                    let dot: f64 = (0..3).map(|k| row[k] * r[b][k]).sum();
                    assert!((dot - (a == b) as u8 as f64).abs() < 1e-14);
                    mean[a][b] += row[b] / draws as f64;
                }
            }
            let minor = |a: usize, b: usize| r[1][a] * r[2][b] - r[1][b] * r[2][a];
            let determinant = r[0][0] * minor(1, 2) - r[0][1] * minor(0, 2) + r[0][2] * minor(0, 1);
            assert!((determinant - 1.0).abs() < 1e-14);
        }
        // Elements have variance 1/3: five standard errors are 5 sqrt(1/3/4000) = 0.046.
        assert!(mean.iter().flatten().all(|m| m.abs() < 0.046), "{mean:?}");
    }

    #[test]
    fn a_quarter_turn_about_z_takes_x_to_y() {
        let r = rotation_about([0.0, 0.0, 2.0], std::f64::consts::FRAC_PI_2);
        assert!((r[1][0] - 1.0).abs() < 1e-15 && r[0][0].abs() < 1e-15);
    }

    /// Only the direction of an axis counts.
    #[test]
    fn axes_of_any_length_turn_alike() {
        for direction in [[1.0, 0.0, 0.0], [1.0, -2.0, 0.5]] {
            let expected = rotation_about(direction, 1.0);
            for exponent in [-1000, -660, -3, 0, 9, 500, 1000] {
                assert_eq!(rotation_about(direction.map(|x| libm::scalbn(x, exponent)), 1.0), expected, "{exponent}");
            }
        }
        for length in [1e200, 1e-200, 1e-308, f64::MAX] {
            let (found, expected) = (rotation_about([length, 0.0, 0.0], 1.0), rotation_about([1.0, 0.0, 0.0], 1.0));
            let pairs = found.as_flattened().iter().zip(expected.as_flattened());
            assert!(pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) < 1e-15, "{length}: {found:?}");
        }
    }

    #[test]
    fn too_fine_a_lattice_is_refused() {
        let bounds = BoundingBox { middle: [0.0; 3], half: [1e5; 3], dimension: 3 };
        assert!(Lattice::covering(LatticeKind::Cubic, 1.0, IDENTITY, bounds, Faces::default()).is_err());
    }
}
