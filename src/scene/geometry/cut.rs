//! Parts of a body by their distance from the point of its surface that an impact meets: a ball around it, and shells around
//! the ball. Their volumes are exact, so that the masses of all parts add up to the body's.

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};

use super::bounding_box::BoundingBox;
use super::shape::BodyShape;

/// What of a body is left between two spheres (in 2D circles) around a point.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Cut {
    /// Number of the body that this is a part of.
    pub body: usize,
    /// From the body's centre, m.
    pub point: [f64; 3],
    /// m; what lies on the inner sphere belongs to what is inside it.
    pub inner: f64,
    /// m; the largest number there is, where nothing lies around it: a scene travels as JSON.
    pub outer: f64,
    /// m^3 (m^2 in 2D).
    pub volume: f64,
}

impl Cut {
    /// Whether a point relative to the body's centre lies between the spheres.
    pub fn holds(&self, local: [f64; 3]) -> bool {
        let square: f64 = (0..3).map(|k| (local[k] - self.point[k]) * (local[k] - self.point[k])).sum();
        square <= self.outer * self.outer && (self.inner == 0.0 || square > self.inner * self.inner)
    }

    /// A box around what is left of `shape`.
    pub fn bounds(&self, shape: &BodyShape, dimension: usize) -> BoundingBox {
        let BoundingBox { mut middle, mut half, .. } = shape.bounds(dimension);
        for k in 0..dimension {
            let low = (middle[k] - half[k]).max(self.point[k] - self.outer);
            let high = (middle[k] + half[k]).min(self.point[k] + self.outer);
            (middle[k], half[k]) = (0.5 * (low + high), 0.5 * (high - low));
        }
        BoundingBox { middle, half, dimension }
    }
}

/// Volume of `shape` (area in 2D) within `radius` of where an impact meets it: any point of a sphere's surface, the middle of
/// another shape's upper face. None for shapes that are not cut.
pub fn volume_within(shape: &BodyShape, radius: f64, dimension: usize) -> Option<f64> {
    let r = radius;
    Some(match *shape {
        BodyShape::Sphere { radius: large } if r >= 2.0 * large => shape.volume(dimension),
        // Two discs, the centre of one on the edge of the other.
        BodyShape::Sphere { radius: large } if dimension == 2 => {
            let x = r / large;
            let sectors = r * r * libm::acos(0.5 * x) + large * large * libm::acos(1.0 - 0.5 * x * x);
            sectors - 0.5 * r * ((2.0 * large - r) * (2.0 * large + r)).sqrt()
        }
        BodyShape::Sphere { radius: large } => PI * r * r * r * (2.0 / 3.0 - 0.25 * r / large),
        BodyShape::HalfSphere { radius: large, inner } if inner == 0.0 => {
            BodyShape::HalfSphere { radius: r.min(large), inner }.volume(dimension)
        }
        BodyShape::Box { size: [width, height, _] } if dimension == 2 => 2.0 * quarter(0.5 * width, height, r),
        BodyShape::Box { size } => within_box(size.map(|edge| 0.5 * edge), r),
        BodyShape::Cylinder { radius: wide, height } => {
            // Down to `straight` the cylinder is narrower than the ball.
            let end = height.min(r);
            let straight = (r * r - wide * wide).max(0.0).sqrt().min(end);
            let ball = |z: f64| z * (r * r - z * z / 3.0);
            PI * (wide * wide * straight + ball(end) - ball(straight))
        }
        _ => return None,
    })
}

/// Area of a quarter of a disc within a rectangle at its corner.
fn quarter(a: f64, b: f64, r: f64) -> f64 {
    if r * r >= a * a + b * b {
        return a * b;
    }
    let (from, to) = ((r * r - b * b).max(0.0).sqrt().min(a), a.min(r));
    let below = |x: f64| 0.5 * (x * (r * r - x * x).max(0.0).sqrt() + r * r * libm::asin((x / r).min(1.0)));
    b * from + below(to) - below(from)
}

/// Volume of a ball around the middle of the upper face of a box with these half edges, by slices; from one edge that the
/// ball's slice meets to the next their areas are smooth.
fn within_box([a, b, c]: [f64; 3], r: f64) -> f64 {
    let bottom = r.min(2.0 * c);
    let depth = |width: f64| (r * r - width * width).max(0.0).sqrt().min(bottom);
    let mut edges = [0.0, depth((a * a + b * b).sqrt()), depth(a), depth(b), bottom];
    edges.sort_by(f64::total_cmp);
    let slice = |z: f64| 4.0 * quarter(a, b, (r * r - z * z).max(0.0).sqrt());
    edges.windows(2).filter(|ends| ends[1] > ends[0]).map(|ends| integral(slice, ends[0], ends[1])).sum()
}

/// By the double exponential rule (Takahasi & Mori 1974, Publ. RIMS 9, 721), to rounding where the function is smooth between
/// the ends, whatever its slopes are there.
fn integral(f: impl Fn(f64) -> f64, low: f64, high: f64) -> f64 {
    const STEPS: i32 = 64;
    const REACH: f64 = 3.2;
    let step = REACH / STEPS as f64;
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
    let term = |k: i32| {
        let t = step * k as f64;
        let s = 0.5 * PI * libm::sinh(t);
        let weight = 0.5 * PI * libm::cosh(t) / (libm::cosh(s) * libm::cosh(s));
        weight * f(middle + half * libm::tanh(s))
    };
    half * step * (-STEPS..=STEPS).map(term).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHAPES: [BodyShape; 5] = [
        BodyShape::Sphere { radius: 1.3 },
        BodyShape::Box { size: [1.0, 2.0, 3.0] },
        BodyShape::Box { size: [3.0, 2.5, 0.4] },
        BodyShape::Cylinder { radius: 0.8, height: 0.9 },
        BodyShape::HalfSphere { radius: 1.7, inner: 0.0 },
    ];

    /// Where an impact meets a shape.
    fn point(shape: &BodyShape, dimension: usize) -> [f64; 3] {
        let bounds = shape.bounds(dimension);
        let mut point = [0.0; 3];
        match shape {
            BodyShape::Sphere { radius } => point[0] = *radius,
            _ => point[dimension - 1] = bounds.middle[dimension - 1] + bounds.half[dimension - 1],
        }
        point
    }

    /// dV/dr is the area of the sphere of radius r within the shape: shares of directions, by a Fibonacci spiral (a circle).
    fn area(shape: &BodyShape, r: f64, dimension: usize) -> f64 {
        const POINTS: usize = 200_000;
        let (middle, turn) = (point(shape, dimension), PI * (3.0 - 5f64.sqrt()));
        let inside = (0..POINTS).filter(|&k| {
            let share = (k as f64 + 0.5) / POINTS as f64;
            let away = if dimension == 2 {
                let angle = 2.0 * PI * share;
                [angle.cos(), angle.sin(), 0.0]
            } else {
                let (z, angle) = (2.0 * share - 1.0, turn * k as f64);
                let wide = (1.0 - z * z).sqrt();
                [wide * angle.cos(), wide * angle.sin(), z]
            };
            shape.contains(std::array::from_fn(|k| middle[k] + r * away[k]), dimension)
        });
        let whole = if dimension == 2 { 2.0 * PI * r } else { 4.0 * PI * r * r };
        whole * inside.count() as f64 / POINTS as f64
    }

    #[test]
    fn volumes_grow_by_the_area_of_the_sphere() {
        for dimension in [2, 3] {
            let round = |shape: &&BodyShape| dimension == 3 || !matches!(shape, BodyShape::Cylinder { .. });
            for shape in SHAPES.iter().filter(round) {
                let within = |r: f64| volume_within(shape, r, dimension).unwrap();
                for r in [0.1, 0.45, 0.7, 0.95, 1.1, 1.5, 1.9, 2.5] {
                    let slope = (within(r + 1e-4) - within(r - 1e-4)) / 2e-4;
                    let expected = area(shape, r, dimension);
                    let full = if dimension == 2 { 2.0 * PI * r } else { 4.0 * PI * r * r };
                    assert!((slope - expected).abs() < 2e-3 * full, "{shape:?} {dimension}D {r}: {slope} {expected}");
                }
            }
        }
    }

    /// The whole shape from some radius on, and a half ball where it fits: to ten digits and more.
    #[test]
    fn volumes_are_exact_where_they_are_known() {
        for shape in &SHAPES {
            let whole = shape.volume(3);
            assert!((volume_within(shape, 9.0, 3).unwrap() / whole - 1.0).abs() < 1e-13, "{shape:?}");
        }
        // Just short of the farthest corner nothing jumps.
        for [a, b, c] in [[1.0, 2.0, 3.0], [3.0, 2.5, 0.4]] {
            let corner = 0.25 * (a * a + b * b) + c * c;
            let near = volume_within(&BodyShape::Box { size: [a, b, c] }, corner.sqrt() * (1.0 - 1e-9), 3).unwrap();
            assert!((near / (a * b * c) - 1.0).abs() < 1e-12, "{near}");
        }
        let half = 2.0 / 3.0 * PI * 0.3f64.powi(3);
        for shape in &SHAPES[1..] {
            assert!((volume_within(shape, 0.3, 3).unwrap() / half - 1.0).abs() < 1e-13, "{shape:?}");
        }
        // A plate of any width: what lies between the upper face and the depth h is pi h (r^2 - h^2 / 3).
        let plate = volume_within(&BodyShape::Box { size: [4.0, 4.0, 0.5] }, 1.2, 3).unwrap();
        assert!((plate / (PI * 0.5 * (1.44 - 0.25 / 3.0)) - 1.0).abs() < 1e-12, "{plate}");
        assert_eq!(volume_within(&BodyShape::Heap { radius: 1.0, top: 0.5, height: 1.0 }, 0.2, 3), None);
    }

    #[test]
    fn parts_share_no_point_and_leave_none_out() {
        let ball = Cut { body: 0, point: [1.0, 0.0, 0.0], inner: 0.0, outer: 0.5, volume: 1.0 };
        let rest = Cut { inner: 0.5, outer: f64::MAX, ..ball };
        for (local, inside) in [([1.0, 0.0, 0.0], true), ([1.0, 0.5, 0.0], true), ([1.0, 0.4, 0.4], false)] {
            assert_eq!([ball.holds(local), rest.holds(local)], [inside, !inside], "{local:?}");
        }
        let bounds = ball.bounds(&BodyShape::Sphere { radius: 1.0 }, 3);
        assert_eq!((bounds.middle, bounds.half), ([0.75, 0.0, 0.0], [0.25, 0.5, 0.5]));
    }
}
