//! Shape models: one closed surface of triangles. Its volume, centre of mass and moments follow exactly from the triangles (as sums
//! of tetrahedra with the origin); a point is inside where a line from it upwards crosses the surface an odd number of times.
//!
//! That test cannot leak. Seen along z a triangle covers a point of the plane or not, by its edges, and an edge that two triangles
//! share is on the same side of the point for both, as it is computed once, from its ends in one order: what one triangle does not
//! cover at its edge, the other does.

mod columns;
pub mod read;
mod surface;
mod tree;

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use self::columns::Columns;
pub use self::surface::Flaw;
use self::tree::Tree;

pub type Point = [f64; 3];

/// A closed surface around its centre of mass.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(from = "Sent", into = "Sent")]
pub struct Mesh {
    vertices: Vec<Point>,
    /// Corners, counterclockwise seen from outside.
    triangles: Vec<[u32; 3]>,
    pub volume: f64,
    /// Integrals of x_a x_b over the inside: xx yy zz xy xz yz, m^5.
    pub moments: [f64; 6],
    columns: Columns,
    tree: Tree,
}

/// A mesh as it is sent: the numbers alone.
#[derive(Serialize, Deserialize)]
struct Sent {
    vertices: Vec<Point>,
    triangles: Vec<[u32; 3]>,
}

impl From<Mesh> for Sent {
    fn from(Mesh { vertices, triangles, .. }: Mesh) -> Self {
        Self { vertices, triangles }
    }
}

impl From<Sent> for Mesh {
    fn from(Sent { vertices, triangles }: Sent) -> Self {
        Self::of(vertices, triangles)
    }
}

impl PartialEq for Mesh {
    fn eq(&self, other: &Self) -> bool {
        self.vertices == other.vertices && self.triangles == other.triangles
    }
}

impl Mesh {
    /// The surface of these triangles, turned outside out and moved so that its centre of mass is the origin; or what is wrong with it.
    pub fn new(vertices: &[Point], triangles: &[[u32; 3]]) -> Result<Self, Flaw> {
        let (mut vertices, triangles) = surface::closed(vertices, triangles)?;
        // Sums about a point nearby lose no digits.
        let middle = bounds(&vertices).map(|[low, high]| 0.5 * (low + high));
        shift(&mut vertices, &middle);
        let (volume, centre, _) = integrals(&vertices, &triangles);
        if !(volume > 0.0 && volume.is_finite()) {
            return Err(Flaw::Flat);
        }
        shift(&mut vertices, &centre);
        Ok(Self::of(vertices, triangles))
    }

    fn of(vertices: Vec<Point>, triangles: Vec<[u32; 3]>) -> Self {
        let (volume, _, moments) = integrals(&vertices, &triangles);
        let (columns, tree) = (Columns::of(&vertices, &triangles), Tree::of(&vertices, &triangles));
        Self { vertices, triangles, volume, moments, columns, tree }
    }

    /// The same, `factor` times as large.
    pub fn scaled(&self, factor: f64) -> Self {
        Self::of(self.vertices.iter().map(|x| x.map(|x| factor * x)).collect(), self.triangles.clone())
    }

    /// Number of triangles.
    pub fn faces(&self) -> usize {
        self.triangles.len()
    }

    /// Least and largest coordinate along each axis, m.
    pub fn bounds(&self) -> [[f64; 2]; 3] {
        bounds(&self.vertices)
    }

    /// Largest distance of the surface from the centre, m.
    pub fn outer_radius(&self) -> f64 {
        self.vertices.iter().map(|x| dot(x, x)).fold(0.0, f64::max).sqrt()
    }

    pub fn contains(&self, point: Point) -> bool {
        self.columns.crossings_above(&self.vertices, &self.triangles, &point) % 2 == 1
    }

    /// Distance from the surface, m.
    pub fn distance(&self, point: Point) -> f64 {
        self.tree.distance(&self.vertices, &self.triangles, &point)
    }
}

/// What several bodies, and a scene and its source, share.
pub type Shared = Arc<Mesh>;

fn shift(vertices: &mut [Point], by: &Point) {
    vertices.iter_mut().for_each(|x| (0..3).for_each(|k| x[k] -= by[k]));
}

fn bounds(vertices: &[Point]) -> [[f64; 2]; 3] {
    let mut bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    for x in vertices {
        for k in 0..3 {
            bounds[k] = [bounds[k][0].min(x[k]), bounds[k][1].max(x[k])];
        }
    }
    bounds
}

/// Volume, centre of mass and second moments about the origin. Of a tetrahedron with corners 0, a, b, c and 6 V = a . (b x c):
/// the mean of x is (a + b + c) / 4, and that of x_k x_l is (s_k s_l + a_k a_l + b_k b_l + c_k c_l) / 20 with s = a + b + c.
fn integrals(vertices: &[Point], triangles: &[[u32; 3]]) -> (f64, Point, [f64; 6]) {
    const PAIRS: [[usize; 2]; 6] = [[0, 0], [1, 1], [2, 2], [0, 1], [0, 2], [1, 2]];
    let (mut volume, mut first, mut second) = (0.0, [0.0; 3], [0.0; 6]);
    for triangle in triangles {
        let [a, b, c] = triangle.map(|corner| vertices[corner as usize]);
        let v = dot(&a, &cross(&b, &c)) / 6.0;
        let s: Point = std::array::from_fn(|k| a[k] + b[k] + c[k]);
        volume += v;
        (0..3).for_each(|k| first[k] += 0.25 * v * s[k]);
        for (sum, [k, l]) in second.iter_mut().zip(PAIRS) {
            *sum += v / 20.0 * (s[k] * s[l] + a[k] * a[l] + b[k] * b[l] + c[k] * c[l]);
        }
    }
    (volume, first.map(|x| x / volume), second)
}

pub(super) fn dot(a: &Point, b: &Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: &Point, b: &Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn minus(a: &Point, b: &Point) -> Point {
    std::array::from_fn(|k| a[k] - b[k])
}

#[cfg(test)]
pub mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::random::uniform;

    /// A ball of `rings` rings of triangles, stretched along the axes.
    pub fn ball(rings: usize, stretch: Point) -> (Vec<Point>, Vec<[u32; 3]>) {
        let around = 2 * rings;
        let mut vertices = vec![[0.0, 0.0, stretch[2]], [0.0, 0.0, -stretch[2]]];
        for ring in 1..rings {
            let polar = PI * ring as f64 / rings as f64;
            for k in 0..around {
                let angle = 2.0 * PI * k as f64 / around as f64;
                let x = [polar.sin() * angle.cos(), polar.sin() * angle.sin(), polar.cos()];
                vertices.push(std::array::from_fn(|k| stretch[k] * x[k]));
            }
        }
        let at = |ring: usize, k: usize| (2 + (ring - 1) * around + k % around) as u32;
        let mut triangles = Vec::new();
        for k in 0..around {
            triangles.push([0, at(1, k), at(1, k + 1)]);
            triangles.push([1, at(rings - 1, k + 1), at(rings - 1, k)]);
            for ring in 1..rings - 1 {
                triangles.push([at(ring, k), at(ring + 1, k), at(ring + 1, k + 1)]);
                triangles.push([at(ring, k), at(ring + 1, k + 1), at(ring, k + 1)]);
            }
        }
        (vertices, triangles)
    }

    fn cube(at: Point) -> (Vec<Point>, Vec<[u32; 3]>) {
        let corner = |n: usize| std::array::from_fn(|k| at[k] + (n >> k & 1) as f64);
        let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let triangles = faces.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).collect();
        ((0..8).map(corner).collect(), triangles)
    }

    #[test]
    fn a_cube_is_moved_to_its_centre_and_measured() {
        let (vertices, mut triangles) = cube([1e5, -3.0, 7.0]);
        // One face looks inwards.
        triangles[5].swap(0, 1);
        let mesh = Mesh::new(&vertices, &triangles).unwrap();
        assert!((mesh.volume - 1.0).abs() < 1e-12);
        for (k, moment) in mesh.moments.iter().enumerate() {
            let exact = if k < 3 { 1.0 / 12.0 } else { 0.0 };
            assert!((moment - exact).abs() < 1e-12, "{k}: {moment}");
        }
        assert_eq!(mesh.bounds(), [[-0.5, 0.5]; 3]);
        assert_eq!(mesh.scaled(2.0).bounds(), [[-1.0, 1.0]; 3]);
        assert!((mesh.outer_radius() - 0.75f64.sqrt()).abs() < 1e-15);
        assert!((mesh.distance([0.1, 0.2, 0.3]) - 0.2).abs() < 1e-15);
        assert!((mesh.distance([1.5, 1.5, 0.0]) - 2f64.sqrt()).abs() < 1e-15);
    }

    /// On a grid whose lines go through vertices and along edges: no point inside is missed and none outside is taken in.
    #[test]
    fn no_line_slips_between_triangles() {
        let (vertices, triangles) = cube([0.0; 3]);
        let mesh = Mesh::new(&vertices, &triangles).unwrap();
        let mut inside = 0;
        for n in 0..17 * 17 * 17 {
            let point = [n % 17, n / 17 % 17, n / 289].map(|k| (k as f64 - 8.0) / 8.0);
            let most = point.iter().fold(0.0f64, |most, x| most.max(x.abs()));
            let held = mesh.contains(point);
            inside += held as usize;
            assert!(most == 0.5 || held == (most < 0.5), "{point:?}");
        }
        // Of two opposite faces one belongs to the cube, as with any half-open rule.
        assert_eq!(inside, 8 * 8 * 8);
    }

    #[test]
    fn a_ball_of_triangles_is_nearly_one() {
        let stretch = [1.0, 0.8, 0.5];
        let (vertices, triangles) = ball(48, stretch);
        let mesh = Mesh::new(&vertices, &triangles).unwrap();
        let volume = 4.0 / 3.0 * PI * stretch.iter().product::<f64>();
        // A polyhedron within the ellipsoid: its faces are (pi / 48)^2 / 8 of a radius below it, twice.
        assert!(mesh.volume < volume && mesh.volume > volume * (1.0 - 3e-3), "{} {volume}", mesh.volume);
        for k in 0..3 {
            let exact = volume * stretch[k] * stretch[k] / 5.0;
            assert!((mesh.moments[k] / exact - 1.0).abs() < 5e-3, "{k}");
        }
        let draw = |n: u64, k: u64| 2.4 * (uniform(5, n, k) - 0.5);
        for n in 0..20_000 {
            let point: Point = std::array::from_fn(|k| draw(n, k as u64));
            let scaled = (0..3).map(|k| (point[k] / stretch[k]).powi(2)).sum::<f64>().sqrt();
            if !(0.997..=1.0).contains(&scaled) {
                assert_eq!(mesh.contains(point), scaled < 1.0, "{point:?}");
            }
        }
    }

    #[test]
    fn the_nearest_triangle_is_found() {
        let (vertices, triangles) = ball(9, [1.0, 0.7, 1.3]);
        let mesh = Mesh::new(&vertices, &triangles).unwrap();
        for n in 0..500 {
            let point: Point = std::array::from_fn(|k| 3.0 * (uniform(6, n, k as u64) - 0.5));
            let corners = mesh.triangles.iter().map(|triangle| triangle.map(|corner| mesh.vertices[corner as usize]));
            let nearest = corners.map(|corners| tree::square(&point, &corners)).fold(f64::INFINITY, f64::min).sqrt();
            assert_eq!(mesh.distance(point), nearest);
        }
    }

    #[test]
    fn meshes_travel_as_numbers() {
        let (vertices, triangles) = ball(5, [1.0, 2.0, 3.0]);
        let mesh = Mesh::new(&vertices, &triangles).unwrap();
        let text = serde_json::to_string(&mesh).unwrap();
        assert_eq!(serde_json::from_str::<Mesh>(&text).unwrap(), mesh);
    }
}
