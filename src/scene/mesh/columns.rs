//! Triangles by where they lie seen along z, so that a line along z meets few of them.

use super::{Point, bounds};

/// Triangles in a cell, about.
const IN_A_CELL: f64 = 4.0;
/// Cells along an axis at most.
const MOST: usize = 1024;

/// A grid of cells in the plane of x and y, and the triangles whose boxes touch each.
#[derive(Debug, Clone)]
pub struct Columns {
    low: [f64; 2],
    /// Cells per metre.
    inverse: [f64; 2],
    counts: [usize; 2],
    /// Where the triangles of each cell begin.
    first: Vec<u32>,
    triangles: Vec<u32>,
}

impl Columns {
    pub fn of(vertices: &[Point], triangles: &[[u32; 3]]) -> Self {
        let [x, y, _] = bounds(vertices);
        let along = ((triangles.len() as f64 / IN_A_CELL).sqrt() as usize).clamp(1, MOST);
        let inverse = [x, y].map(|[low, high]| if high > low { along as f64 / (high - low) } else { 0.0 });
        let mut columns =
            Self { low: [x[0], y[0]], inverse, counts: [along; 2], first: Vec::new(), triangles: Vec::new() };
        let mut cells = vec![Vec::new(); along * along];
        for (n, triangle) in triangles.iter().enumerate() {
            let corners = triangle.map(|corner| vertices[corner as usize]);
            let [x, y, _] = bounds(&corners);
            let [from, to] = [0, 1].map(|end| [columns.along(0, x[end]), columns.along(1, y[end])]);
            for row in from[1]..=to[1] {
                (from[0]..=to[0]).for_each(|column| cells[row * along + column].push(n as u32));
            }
        }
        for cell in cells {
            columns.first.push(columns.triangles.len() as u32);
            columns.triangles.extend(cell);
        }
        columns.first.push(columns.triangles.len() as u32);
        columns
    }

    /// The cell of a coordinate: the same for a point and for the end of a box there.
    fn along(&self, axis: usize, x: f64) -> usize {
        (((x - self.low[axis]) * self.inverse[axis]).max(0.0) as usize).min(self.counts[axis] - 1)
    }

    /// How often the line from a point upwards crosses the surface.
    pub fn crossings_above(&self, vertices: &[Point], triangles: &[[u32; 3]], point: &Point) -> usize {
        let cell = self.along(1, point[1]) * self.counts[0] + self.along(0, point[0]);
        let here = &self.triangles[self.first[cell] as usize..self.first[cell + 1] as usize];
        here.iter().filter(|n| is_below(vertices, &triangles[**n as usize], point)).count()
    }
}

/// Whether a point is below a triangle: not beside it, as its edges tell, and not above its plane.
fn is_below(vertices: &[Point], triangle: &[u32; 3], point: &Point) -> bool {
    let [a, b, c] = *triangle;
    let beside = [(a, b), (b, c), (c, a)].iter().filter(|(a, b)| is_left(vertices, *a, *b, point)).count();
    beside == 1 && height(triangle.map(|corner| vertices[corner as usize]), point) > point[2]
}

/// Whether an edge crosses the line from a point along x, seen along z. It is computed from the end of the lower number on, so that
/// it is the same for both triangles.
fn is_left(vertices: &[Point], a: u32, b: u32, point: &Point) -> bool {
    let (from, to) = (vertices[a.min(b) as usize], vertices[a.max(b) as usize]);
    let [x, y, _] = *point;
    (from[1] > y) != (to[1] > y) && x < from[0] + (y - from[1]) * ((to[0] - from[0]) / (to[1] - from[1]))
}

/// Height of a triangle at a point that it covers; within its own heights, however steep it is.
fn height([a, b, c]: [Point; 3], point: &Point) -> f64 {
    let [u, v, w] = [[b, a], [c, a], [*point, a]].map(|[to, from]| [to[0] - from[0], to[1] - from[1]]);
    let area = u[0] * v[1] - u[1] * v[0];
    let (s, t) = ((w[0] * v[1] - w[1] * v[0]) / area, (u[0] * w[1] - u[1] * w[0]) / area);
    let height = a[2] + s * (b[2] - a[2]) + t * (c[2] - a[2]);
    let [low, high] = [f64::min, f64::max].map(|least: fn(f64, f64) -> f64| least(least(a[2], b[2]), c[2]));
    // What is seen from its edge has no area, and any height between its own will do.
    if height.is_nan() { 0.5 * (low + high) } else { height.clamp(low, high) }
}
