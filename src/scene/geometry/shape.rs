//! Shapes of bodies, around the body's centre. In 2D a sphere is a disc and a box a rectangle, per metre of depth.

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};

use super::bounding_box::{BoundingBox, TOUCHING};
use super::compound::{Compound, Solid};
use super::voxels::Voxels;
use crate::scene::mesh::Shared;

/// A shape; lengths in m.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
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
    /// An ellipse in 2D. Half of its axes; the third is 0 in 2D.
    Ellipsoid { axes: [f64; 3] },
    /// A shape model, around its centre of mass.
    Mesh(Shared),
    /// Several shapes.
    Compound(Compound<BodyShape>),
    /// Where particles of a file are.
    Voxels(Voxels),
}

impl BodyShape {
    /// Volume, m^3 (area in 2D, m^2).
    pub fn volume(&self, dimension: usize) -> f64 {
        let ball = |r: f64| if dimension == 2 { PI * r * r } else { 4.0 / 3.0 * PI * r * r * r };
        match *self {
            BodyShape::Ellipsoid { axes } => ball(1.0) * axes[..dimension].iter().product::<f64>(),
            BodyShape::Mesh(ref mesh) => mesh.volume,
            BodyShape::Compound(ref compound) => compound.volume,
            BodyShape::Voxels(ref voxels) => voxels.volume,
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
            BodyShape::Ellipsoid { axes } => scaled(point, &axes, dimension) <= 1.0,
            BodyShape::Mesh(ref mesh) => mesh.contains(point),
            BodyShape::Compound(ref compound) => compound.contains(point, dimension),
            BodyShape::Voxels(ref voxels) => voxels.contains(point),
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
            BodyShape::Ellipsoid { axes } => half = axes,
            BodyShape::Mesh(ref mesh) => (middle, half) = around(&mesh.bounds()),
            BodyShape::Voxels(ref voxels) => (middle, half) = around(&voxels.bounds),
            BodyShape::Compound(ref compound) => return compound.bounds(dimension),
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
            BodyShape::Ellipsoid { axes } => axes.into_iter().fold(0.0, f64::max),
            BodyShape::Mesh(ref mesh) => mesh.outer_radius(),
            BodyShape::Compound(ref compound) => compound.outer_radius(),
            BodyShape::Voxels(ref voxels) => voxels.outer_radius,
            BodyShape::Box { size } => 0.5 * (size[0] * size[0] + size[1] * size[1] + size[2] * size[2]).sqrt(),
            BodyShape::Cylinder { radius, height } | BodyShape::Heap { radius, height, .. } => {
                (radius * radius + 0.25 * height * height).sqrt()
            }
        }
    }

    /// Whether the shape ends in a plane above, as ground does: an impact then comes down on it.
    pub fn has_upper_face(&self) -> bool {
        !self.is_round()
    }

    /// Whether the shape has no face that is called its upper one: an impact then comes along x.
    pub fn is_round(&self) -> bool {
        use BodyShape::{Compound, Ellipsoid, Mesh, Sphere, Voxels};
        matches!(self, Sphere { .. } | Ellipsoid { .. } | Mesh(_) | Compound(_) | Voxels(_))
    }

    /// Whether [`BodyShape::depth`] is known.
    pub fn has_depth(&self, dimension: usize) -> bool {
        match self {
            BodyShape::Compound(compound) => compound.depth([0.0; 3], dimension).is_some(),
            BodyShape::Voxels(_) => false,
            _ => true,
        }
    }

    /// Where the axis from the centre along x leaves the shape last, m; none where it does not pass through it.
    pub fn end_along_x(&self, dimension: usize) -> Option<f64> {
        const STEPS: usize = 4096;
        let bounds = self.bounds(dimension);
        let (low, high) = (bounds.middle[0] - bounds.half[0], bounds.middle[0] + bounds.half[0]);
        let inside = |x: f64| self.contains([x, 0.0, 0.0], dimension);
        let place = |k: usize| low + (high - low) * k as f64 / STEPS as f64;
        let last = (0..=STEPS).rev().map(place).find(|x| inside(*x))?;
        let (mut within, mut beyond) = (last, last + (high - low) / STEPS as f64);
        for _ in 0..60 {
            let middle = 0.5 * (within + beyond);
            *(if inside(middle) { &mut within } else { &mut beyond }) = middle;
        }
        Some(within)
    }

    /// Distance of a point inside from the outer faces, m: all of a sphere's, and all of the others' but the upper one. These
    /// are where a body that stands for a part of something larger is cut off. A box has faces across the axes of `across`
    /// only; infinite where there are none.
    pub fn outer_distance(&self, point: [f64; 3], across: [bool; 3], dimension: usize) -> f64 {
        let [x, y, z] = point;
        match *self {
            BodyShape::Ellipsoid { .. } | BodyShape::Mesh(_) | BodyShape::Compound(_) | BodyShape::Voxels(_) => {
                self.depth(point, dimension)
            }
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

    /// Distance of a point inside from the surface, m; of an ellipsoid and of several shapes one that it is not below. Zero where it is not
    /// known, see [`BodyShape::has_depth`].
    pub fn depth(&self, point: [f64; 3], dimension: usize) -> f64 {
        let [x, y, z] = point;
        let from_centre = (x * x + y * y + z * z).sqrt();
        match *self {
            BodyShape::Ellipsoid { axes } => {
                let narrowest = axes[..dimension].iter().copied().fold(f64::INFINITY, f64::min);
                narrowest * (1.0 - scaled(point, &axes, dimension).sqrt())
            }
            BodyShape::Mesh(ref mesh) => mesh.distance(point),
            BodyShape::Compound(ref compound) => compound.depth(point, dimension).unwrap_or(0.0),
            BodyShape::Voxels(_) => 0.0,
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
            BodyShape::Compound(ref compound) => return compound.outer_radius(),
            BodyShape::Voxels(ref voxels) => return voxels.outer_radius,
            BodyShape::Sphere { .. } | BodyShape::Ellipsoid { .. } | BodyShape::Mesh(_) => [0.0; 3],
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
        let mut theirs = other.bounds(dimension);
        (0..3).for_each(|k| theirs.middle[k] += offset[k]);
        let shared = self.bounds(dimension).common(&theirs);
        shared.into_iter().flat_map(|both| both.grid()).any(|point| {
            let seen_from_other = std::array::from_fn(|k| point[k] - offset[k]);
            self.contains(point, dimension) && other.contains(seen_from_other, dimension)
        })
    }
}

impl Solid for BodyShape {
    fn volume(&self, dimension: usize) -> f64 {
        self.volume(dimension)
    }

    fn contains(&self, point: [f64; 3], dimension: usize) -> bool {
        self.contains(point, dimension)
    }

    fn bounds(&self, dimension: usize) -> BoundingBox {
        self.bounds(dimension)
    }

    fn outer_radius(&self) -> f64 {
        self.outer_radius()
    }

    fn depth(&self, point: [f64; 3], dimension: usize) -> Option<f64> {
        self.has_depth(dimension).then(|| self.depth(point, dimension))
    }
}

/// Middle and half extents of bounds.
fn around(bounds: &[[f64; 2]; 3]) -> ([f64; 3], [f64; 3]) {
    (bounds.map(|[low, high]| 0.5 * (low + high)), bounds.map(|[low, high]| 0.5 * (high - low)))
}

/// Square of the distance from the centre of an ellipsoid over that of its surface there.
fn scaled(point: [f64; 3], axes: &[f64; 3], dimension: usize) -> f64 {
    (0..dimension).map(|k| (point[k] / axes[k]) * (point[k] / axes[k])).sum()
}

#[cfg(test)]
mod tests {
    use super::super::compound::Part;
    use super::super::lattice::{IDENTITY, rotation_about};
    use super::*;

    const SHAPES: [BodyShape; 7] = [
        BodyShape::Ellipsoid { axes: [1.5, 0.7, 1.0] },
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
            let inside = b.grid().filter(|p| shape.contains(*p, 3)).count() as f64 / 48f64.powi(3);
            let share = shape.volume(3) / (8.0 * b.half.iter().product::<f64>());
            assert!((inside - share).abs() < 6.0 / 48.0 / 4.0, "{shape:?}: {inside} {share}");
        }
        assert_eq!(BodyShape::Box { size: [2.0, 3.0, 0.0] }.volume(2), 6.0);
        assert_eq!(BodyShape::Heap { radius: 3.0, top: 1.0, height: 2.0 }.volume(2), 8.0);
        assert_eq!(BodyShape::Ellipsoid { axes: [2.0, 3.0, 0.0] }.volume(2), 6.0 * PI);
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
        let near = |shape: &BodyShape, point: [f64; 3]| shape.outer_distance(point, open, 3);
        assert_eq!(near(&BodyShape::HalfSphere { radius: 2.0, inner: 0.0 }, [0.0, 0.0, -0.5]), 1.5);
        assert_eq!(near(&BodyShape::Cylinder { radius: 2.0, height: 6.0 }, [0.0, 1.5, 2.9]), 0.5);
        assert_eq!(near(&BodyShape::Cylinder { radius: 2.0, height: 6.0 }, [0.0, 0.5, -2.0]), 1.0);
        let brick = BodyShape::Box { size: [4.0, 6.0, 8.0] };
        assert_eq!([near(&brick, [-1.5, 0.0, 3.9]), near(&brick, [0.0, 0.0, -3.0])], [0.5, 1.0]);
        assert_eq!(brick.outer_distance([-1.5, 0.0, 3.9], [false, true, true], 3), 3.0);
        assert_eq!(brick.outer_distance([0.0; 3], [false; 3], 3), f64::INFINITY);
        assert_eq!(brick.largest_outer_distance(open, 3), 2.0);
        assert_eq!(BodyShape::Cylinder { radius: 2.0, height: 1.0 }.largest_outer_distance(open, 3), 1.0);
        // In 2D y points up.
        assert_eq!(BodyShape::Box { size: [4.0, 6.0, 0.0] }.outer_distance([0.0, 2.5, 0.0], open, 2), 2.0);
    }

    /// The depth of an ellipsoid is a lower bound, exact along its shortest axis.
    #[test]
    fn an_ellipsoid_has_room_for_a_ball_of_its_depth() {
        let axes = [1.5, 0.7, 1.0];
        let shape = BodyShape::Ellipsoid { axes };
        assert!((shape.depth([0.0, 0.3, 0.0], 3) - 0.4).abs() < 1e-15);
        for n in 0..2000 {
            let draw = |k: u64| 2.0 * crate::random::uniform(3, n, k) - 1.0;
            let point = std::array::from_fn(|k| axes[k] * draw(k as u64));
            let away: [f64; 3] = std::array::from_fn(|k| draw(3 + k as u64));
            let length = away.iter().map(|x| x * x).sum::<f64>().sqrt();
            if shape.contains(point, 3) {
                let depth = shape.depth(point, 3);
                assert!(shape.contains(std::array::from_fn(|k| point[k] + 0.999 * depth * away[k] / length), 3));
            }
        }
        assert!((shape.end_along_x(3).unwrap() - 1.5).abs() < 1e-12);
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

    fn part(shape: BodyShape, x: f64, minus: bool) -> Part<BodyShape> {
        Part { shape, position: [x, 0.0, 0.0], rotation: IDENTITY, minus }
    }

    const BALL: BodyShape = BodyShape::Sphere { radius: 1.0 };

    #[test]
    fn a_turned_box_is_a_box() {
        let brick = BodyShape::Box { size: [2.0, 1.0, 0.5] };
        let rotation = rotation_about([0.0, 0.0, 1.0], 0.25 * PI);
        let turned = Compound::new(vec![Part { shape: brick, position: [3.0, 0.0, 0.0], rotation, minus: false }], 3);
        assert_eq!(turned.volume, 1.0);
        let along = 0.5f64.sqrt();
        assert!(turned.contains([3.0 + 0.98 * along, 0.98 * along, 0.0], 3));
        assert!(!turned.contains([3.0 + 0.98 * along, -0.98 * along, 0.0], 3));
        assert!((turned.bounds(3).half[0] - 1.5 * along).abs() < 1e-15 && turned.bounds(3).middle == [3.0, 0.0, 0.0]);
        assert!((turned.depth([3.0, 0.0, 0.1], 3).unwrap() - 0.15).abs() < 1e-15);
    }

    /// Two balls that touch, that overlap, and one out of which another is taken: lenses are exact.
    #[test]
    fn volumes_of_unions_and_cuts() {
        let ball = 4.0 / 3.0 * PI;
        let touching = Compound::new(vec![part(BALL, -1.0, false), part(BALL, 1.0, false)], 3);
        assert_eq!(touching.volume, 2.0 * BALL.volume(3));
        let d: f64 = 1.2;
        let lens = PI * (4.0 + d) * (2.0 - d).powi(2) / 12.0;
        for (minus, exact) in [(false, 2.0 * ball - lens), (true, ball - lens)] {
            let both = Compound::new(vec![part(BALL, 0.0, false), part(BALL, d, minus)], 3);
            assert!((both.volume / exact - 1.0).abs() < 3e-5, "{} {exact}", both.volume);
            assert_eq!(both.depth([-0.5, 0.0, 0.0], 3), (!minus).then_some(0.5));
        }
        // In the plane: what two discs share.
        let lens = 2.0 * (0.5 * d).acos() - 0.5 * d * (4.0 - d * d).sqrt();
        let both = Compound::new(vec![part(BALL, 0.0, false), part(BALL, d, false)], 2);
        assert!((both.volume / (2.0 * PI - lens) - 1.0).abs() < 1e-6, "{}", both.volume);
    }

    #[test]
    fn the_last_word_counts() {
        let parts =
            vec![part(BALL, 0.0, false), part(BALL, 1.0, true), part(BodyShape::Sphere { radius: 0.2 }, 1.0, false)];
        let shape = Compound::new(parts, 3);
        for (x, held) in [(-0.5, true), (0.5, false), (1.0, true), (1.3, false)] {
            assert_eq!(shape.contains([x, 0.0, 0.0], 3), held, "{x}");
        }
        assert_eq!(shape.outer_radius(), 1.2);
    }
}
