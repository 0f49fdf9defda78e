//! Shapes of bodies, around the body's centre. In 2D a sphere is a disc and a box a rectangle, per metre of depth.

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};

use super::lattice::BoundingBox;

/// A shape; lengths in m.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum BodyShape {
    /// A disc in 2D.
    Sphere { radius: f64 },
    /// Full edge lengths; the third is 0 in 2D.
    Box { size: [f64; 3] },
    /// Axis along z, centre at half height; 3D only.
    Cylinder { radius: f64, height: f64 },
    /// A cone cut off at the top, axis along z (along y in 2D, where it is a trapezium), centre at half height; radii of foot
    /// and top.
    Heap { radius: f64, top: f64, height: f64 },
    /// Flat face up, its middle the centre; material below (z < 0, in 2D y < 0), beyond `inner` from the centre: shells of
    /// different spacing may lie around each other.
    HalfSphere { radius: f64, inner: f64 },
}

impl BodyShape {
    /// Volume, m^3 (area in 2D, m^2).
    pub fn volume(&self, dimension: usize) -> f64 {
        let ball = |r: f64| if dimension == 2 { PI * r * r } else { 4.0 / 3.0 * PI * r * r * r };
        match *self {
            BodyShape::Sphere { radius } => ball(radius),
            BodyShape::HalfSphere { radius, inner } => 0.5 * (ball(radius) - ball(inner)),
            BodyShape::Box { size } => size[..dimension].iter().product(),
            BodyShape::Cylinder { radius, height } => PI * radius * radius * height,
            BodyShape::Heap { radius, top, height } if dimension == 2 => (radius + top) * height,
            BodyShape::Heap { radius, top, height } => PI / 3.0 * (radius * radius + radius * top + top * top) * height,
        }
    }

    /// Whether a point relative to the centre lies inside or on the surface.
    pub fn contains(&self, point: [f64; 3], dimension: usize) -> bool {
        let [x, y, z] = point;
        match *self {
            BodyShape::Sphere { radius } => x * x + y * y + z * z <= radius * radius,
            BodyShape::HalfSphere { radius, inner } => {
                let square = x * x + y * y + z * z;
                // What lies on the inner surface belongs to what is inside it.
                point[dimension - 1] <= 0.0 && square <= radius * radius && (inner == 0.0 || square > inner * inner)
            }
            BodyShape::Box { size } => (0..dimension).all(|a| 2.0 * point[a].abs() <= size[a]),
            BodyShape::Cylinder { radius, height } => x * x + y * y <= radius * radius && 2.0 * z.abs() <= height,
            BodyShape::Heap { height, .. } => {
                2.0 * point[dimension - 1].abs() <= height && self.flank_distance(point, dimension) >= 0.0
            }
        }
    }

    /// The smallest box around the shape.
    pub fn bounds(&self, dimension: usize) -> BoundingBox {
        let (mut middle, mut half) = ([0.0; 3], [0.0; 3]);
        match *self {
            BodyShape::Sphere { radius } => half[..dimension].fill(radius),
            BodyShape::HalfSphere { radius, .. } => {
                half[..dimension].fill(radius);
                half[dimension - 1] = 0.5 * radius;
                middle[dimension - 1] = -0.5 * radius;
            }
            BodyShape::Box { size } => half = size.map(|s| 0.5 * s),
            BodyShape::Cylinder { radius, height } => half = [radius, radius, 0.5 * height],
            BodyShape::Heap { radius, height, .. } => {
                half[..dimension].fill(radius);
                half[dimension - 1] = 0.5 * height;
            }
        }
        BoundingBox { middle, half, dimension }
    }

    /// Largest distance of a point of the shape from its centre, m.
    pub fn outer_radius(&self) -> f64 {
        match *self {
            BodyShape::Sphere { radius } | BodyShape::HalfSphere { radius, .. } => radius,
            BodyShape::Box { size } => 0.5 * (size[0] * size[0] + size[1] * size[1] + size[2] * size[2]).sqrt(),
            BodyShape::Cylinder { radius, height } | BodyShape::Heap { radius, height, .. } => {
                (radius * radius + 0.25 * height * height).sqrt()
            }
        }
    }

    /// Whether the shape ends in a plane above, as ground does: an impact then comes down on it.
    pub fn has_upper_face(&self) -> bool {
        !matches!(self, BodyShape::Sphere { .. })
    }

    /// Distance of a point inside from the outer faces, m: all of a sphere's, and all of the others' but the upper one. These
    /// are where a body that stands for a part of something larger is cut off. A box has faces across the axes of `across`
    /// only; infinite where there are none.
    pub fn outer_distance(&self, point: [f64; 3], across: [bool; 3], dimension: usize) -> f64 {
        let [x, y, z] = point;
        match *self {
            BodyShape::Sphere { radius } | BodyShape::HalfSphere { radius, .. } => {
                radius - (x * x + y * y + z * z).sqrt()
            }
            BodyShape::Cylinder { radius, height } => (radius - (x * x + y * y).sqrt()).min(0.5 * height + z),
            // Flanks are its upper face.
            BodyShape::Heap { height, .. } => 0.5 * height + point[dimension - 1],
            BodyShape::Box { size } => {
                (0..dimension).filter(|&axis| across[axis]).fold(f64::INFINITY, |least, axis| {
                    let height = if axis == dimension - 1 { point[axis] } else { -point[axis].abs() };
                    least.min(0.5 * size[axis] + height)
                })
            }
        }
    }

    /// Distance of a point from the flanks of a heap, m, below zero outside; infinite for other shapes.
    fn flank_distance(&self, point: [f64; 3], dimension: usize) -> f64 {
        let BodyShape::Heap { radius, top, height } = *self else { return f64::INFINITY };
        let (from_axis, up) = match dimension {
            2 => (point[0].abs(), point[1]),
            _ => ((point[0] * point[0] + point[1] * point[1]).sqrt(), point[2]),
        };
        let narrowing = (radius - top) / height;
        (radius - narrowing * (up + 0.5 * height) - from_axis) / (1.0 + narrowing * narrowing).sqrt()
    }

    /// Distance of a point inside from the surface, m.
    pub fn depth(&self, point: [f64; 3], dimension: usize) -> f64 {
        let [x, y, z] = point;
        let from_centre = (x * x + y * y + z * z).sqrt();
        match *self {
            BodyShape::Sphere { radius } => radius - from_centre,
            BodyShape::HalfSphere { radius, inner } => {
                let hollow = if inner > 0.0 { from_centre - inner } else { f64::INFINITY };
                (radius - from_centre).min(-point[dimension - 1]).min(hollow)
            }
            BodyShape::Cylinder { radius, height } => (radius - (x * x + y * y).sqrt()).min(0.5 * height - z.abs()),
            BodyShape::Heap { height, .. } => {
                self.flank_distance(point, dimension).min(0.5 * height - point[dimension - 1].abs())
            }
            BodyShape::Box { size } => {
                (0..dimension).map(|axis| 0.5 * size[axis] - point[axis].abs()).fold(f64::INFINITY, f64::min)
            }
        }
    }

    /// The largest distance from the outer faces that there is within the shape, m.
    pub fn largest_outer_distance(&self, across: [bool; 3], dimension: usize) -> f64 {
        let innermost = match *self {
            BodyShape::Sphere { .. } => [0.0; 3],
            BodyShape::HalfSphere { inner, .. } => std::array::from_fn(|k| if k == 0 { inner } else { 0.0 }),
            BodyShape::Cylinder { height, .. } => [0.0, 0.0, 0.5 * height],
            BodyShape::Heap { height, .. } => {
                std::array::from_fn(|k| if k == dimension - 1 { 0.5 * height } else { 0.0 })
            }
            BodyShape::Box { size } => std::array::from_fn(|k| if k == dimension - 1 { 0.5 * size[k] } else { 0.0 }),
        };
        self.outer_distance(innermost, across, dimension)
    }

    /// Whether two shapes at `a` and `b` share some volume. Exact for two spheres and two boxes; otherwise a grid of points
    /// through the part that their bounding boxes share is tested.
    pub fn overlaps(&self, a: [f64; 3], other: &BodyShape, b: [f64; 3], dimension: usize) -> bool {
        let offset: [f64; 3] = std::array::from_fn(|k| b[k] - a[k]);
        if let (BodyShape::Sphere { radius: r }, BodyShape::Sphere { radius: s }) = (self, other) {
            let square: f64 = offset.iter().map(|x| x * x).sum();
            return square.sqrt() < (r + s) * (1.0 - TOUCHING);
        }
        let (mine, theirs) = (self.bounds(dimension), other.bounds(dimension));
        let (mut low, mut high) = ([0.0; 3], [0.0; 3]);
        for k in 0..dimension {
            low[k] = (mine.middle[k] - mine.half[k]).max(offset[k] + theirs.middle[k] - theirs.half[k]);
            high[k] = (mine.middle[k] + mine.half[k]).min(offset[k] + theirs.middle[k] + theirs.half[k]);
            if high[k] - low[k] <= TOUCHING * (mine.half[k] + theirs.half[k]) {
                return false;
            }
        }
        grid(low, high, dimension).any(|point| {
            let seen_from_other = std::array::from_fn(|k| point[k] - offset[k]);
            self.contains(point, dimension) && other.contains(seen_from_other, dimension)
        })
    }
}

/// Bodies whose surfaces touch to this relative precision do not overlap.
const TOUCHING: f64 = 1e-9;

/// Points of a regular grid through a box, the middle of each cell.
fn grid(low: [f64; 3], high: [f64; 3], dimension: usize) -> impl Iterator<Item = [f64; 3]> {
    const POINTS: usize = 48;
    let layers = if dimension == 3 { POINTS } else { 1 };
    (0..POINTS * POINTS * layers).map(move |n| {
        let index = [n % POINTS, n / POINTS % POINTS, n / (POINTS * POINTS)];
        std::array::from_fn(|k| low[k] + (high[k] - low[k]) * (index[k] as f64 + 0.5) / POINTS as f64)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHAPES: [BodyShape; 6] = [
        BodyShape::Heap { radius: 1.9, top: 0.4, height: 1.1 },
        BodyShape::Sphere { radius: 1.3 },
        BodyShape::Box { size: [1.0, 2.0, 3.0] },
        BodyShape::Cylinder { radius: 0.8, height: 2.5 },
        BodyShape::HalfSphere { radius: 1.7, inner: 0.0 },
        BodyShape::HalfSphere { radius: 1.7, inner: 0.9 },
    ];

    /// The exact volume against the share of grid points of the bounding box, whose error is below surface x cell.
    #[test]
    fn volumes_agree_with_points_inside() {
        for shape in SHAPES {
            let b = shape.bounds(3);
            let low = std::array::from_fn(|k| b.middle[k] - b.half[k]);
            let high = std::array::from_fn(|k| b.middle[k] + b.half[k]);
            let inside = grid(low, high, 3).filter(|p| shape.contains(*p, 3)).count() as f64 / 48f64.powi(3);
            let share = shape.volume(3) / (8.0 * b.half.iter().product::<f64>());
            assert!((inside - share).abs() < 6.0 / 48.0 / 4.0, "{shape:?}: {inside} {share}");
        }
        assert_eq!(BodyShape::Box { size: [2.0, 3.0, 0.0] }.volume(2), 6.0);
        assert_eq!(BodyShape::Heap { radius: 3.0, top: 1.0, height: 2.0 }.volume(2), 8.0);
        assert_eq!(BodyShape::HalfSphere { radius: 2.0, inner: 0.0 }.volume(2), 2.0 * PI);
    }

    #[test]
    fn half_spheres_lie_below_their_centre() {
        let half = BodyShape::HalfSphere { radius: 1.0, inner: 0.0 };
        assert!(half.contains([0.0, 0.5, -0.5], 3) && !half.contains([0.0, 0.0, 0.1], 3));
        assert!(half.contains([0.5, -0.5, 0.0], 2) && !half.contains([0.0, 0.1, 0.0], 2));
    }

    #[test]
    fn a_heap_narrows_upwards() {
        let heap = BodyShape::Heap { radius: 3.0, top: 0.0, height: 3.0 };
        for (dimension, [foot, inside, flank, above]) in [
            (2, [[2.9, -1.5, 0.0], [0.5, 0.0, 0.0], [1.6, 0.0, 0.0], [0.0, 1.6, 0.0]]),
            (3, [[0.0, 2.9, -1.5], [0.5, 0.0, 0.0], [0.0, 1.6, 0.0], [0.0, 0.0, 1.6]]),
        ] {
            assert!(heap.contains(foot, dimension) && heap.contains(inside, dimension));
            assert!(!heap.contains(flank, dimension) && !heap.contains(above, dimension));
            assert!((heap.depth(inside, dimension) - 0.5f64.sqrt()).abs() < 1e-15);
        }
    }

    #[test]
    fn outer_faces_are_all_but_the_upper_one() {
        let open = [true; 3];
        let near = |shape: BodyShape, point: [f64; 3]| shape.outer_distance(point, open, 3);
        assert_eq!(near(BodyShape::HalfSphere { radius: 2.0, inner: 0.0 }, [0.0, 0.0, -0.5]), 1.5);
        assert_eq!(near(BodyShape::Cylinder { radius: 2.0, height: 6.0 }, [0.0, 1.5, 2.9]), 0.5);
        assert_eq!(near(BodyShape::Cylinder { radius: 2.0, height: 6.0 }, [0.0, 0.5, -2.0]), 1.0);
        let brick = BodyShape::Box { size: [4.0, 6.0, 8.0] };
        assert_eq!([near(brick, [-1.5, 0.0, 3.9]), near(brick, [0.0, 0.0, -3.0])], [0.5, 1.0]);
        assert_eq!(brick.outer_distance([-1.5, 0.0, 3.9], [false, true, true], 3), 3.0);
        assert_eq!(brick.outer_distance([0.0; 3], [false; 3], 3), f64::INFINITY);
        assert_eq!(brick.largest_outer_distance(open, 3), 2.0);
        assert_eq!(BodyShape::Cylinder { radius: 2.0, height: 1.0 }.largest_outer_distance(open, 3), 1.0);
        // In 2D y points up.
        assert_eq!(BodyShape::Box { size: [4.0, 6.0, 0.0] }.outer_distance([0.0, 2.5, 0.0], open, 2), 2.0);
    }

    #[test]
    fn overlap_of_unlike_shapes() {
        let sphere = BodyShape::Sphere { radius: 1.0 };
        let brick = BodyShape::Box { size: [2.0, 2.0, 2.0] };
        assert!(sphere.overlaps([0.0; 3], &brick, [1.9, 0.0, 0.0], 3));
        assert!(!sphere.overlaps([0.0; 3], &brick, [2.0, 0.0, 0.0], 3), "touching is allowed");
        // Bounding boxes overlap at the corner, the shapes do not: sqrt(3) x 0.9 > 1.
        assert!(!sphere.overlaps([0.0; 3], &brick, [1.9, 1.9, 1.9], 3));
        assert!(sphere.overlaps([0.0; 3], &sphere, [1.9, 0.0, 0.0], 3));
        assert!(!sphere.overlaps([0.0; 3], &sphere, [2.0, 0.0, 0.0], 3));
        let bowl = BodyShape::HalfSphere { radius: 5.0, inner: 0.0 };
        assert!(!bowl.overlaps([0.0; 3], &sphere, [0.0, 0.0, 1.0], 3));
        assert!(bowl.overlaps([0.0; 3], &sphere, [0.0, 0.0, 0.5], 3));
        let shell = BodyShape::HalfSphere { radius: 8.0, inner: 5.0 };
        assert!(!shell.overlaps([0.0; 3], &bowl, [0.0; 3], 3) && shell.overlaps([0.0; 3], &bowl, [0.2, 0.0, 0.0], 3));
    }
}
