//! A plane cut through the particles, as a grid of numbers: every rank rasterises its own particles, and the grids are merged
//! by minima and maxima. No particle leaves its rank, and the picture does not depend on which rank owns which particle.

use crate::domain::comm::Comm;
use crate::math::Vec3;

/// A plane through `origin`, spanned by the orthogonal unit vectors `across` and `up`; a point's coordinates in it are its
/// components along these, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    pub origin: Vec3,
    pub across: Vec3,
    pub up: Vec3,
}

impl Plane {
    /// Coordinates in the plane and the distance from it.
    fn project(&self, x: &Vec3) -> ([f64; 2], f64) {
        let depth = (x - self.origin).dot(&self.across.cross(&self.up));
        ([x.dot(&self.across), x.dot(&self.up)], depth)
    }
}

/// A particle of the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dot {
    pub id: u64,
    pub position: Vec3,
    /// It fills the points of the cut nearer than this, unless another particle is nearer yet, m.
    pub reach: f64,
    /// One value per panel.
    pub values: [f64; 2],
}

/// A square window of `side` by `side` pixels, `half` metres from centre to edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Window {
    pub centre: [f64; 2],
    pub half: f64,
    pub side: usize,
}

/// The cut as numbers, rows from the bottom up; NaN where there is no matter.
#[derive(Debug, Clone, PartialEq)]
pub struct Raster {
    pub window: Window,
    pub panels: [Vec<f64>; 2],
}

/// Share of the cut's particles that may lie beyond each edge of the window: a few fast fragments must not shrink the rest.
const BEYOND: f64 = 0.02;
const BINS: usize = 512;

/// The square window that holds nearly all particles of the cut, found by counting in ever finer bins. Collective.
pub fn window(plane: &Plane, dots: &[Dot], side: usize, comm: &Comm) -> Window {
    let inside: Vec<[f64; 2]> = dots.iter().filter_map(|dot| in_cut(plane, dot)).collect();
    let mut edges = [0, 1].map(|axis| {
        let mut ends = [f64::INFINITY; 2];
        for at in &inside {
            ends = [ends[0].min(at[axis]), ends[1].min(-at[axis])];
        }
        comm.all_min(&mut ends);
        [ends[0], -ends[1]]
    });
    if edges.iter().any(|edge| edge[0] > edge[1]) {
        return Window { centre: [0.0; 2], half: 1.0, side };
    }
    for _round in 0..4 {
        edges = [0, 1].map(|axis| trimmed(edges[axis], inside.iter().map(|at| at[axis]), comm));
    }
    let mut reach = [dots.iter().fold(0.0, |r: f64, dot| r.max(dot.reach))];
    comm.all_max(&mut reach);
    let half = edges.iter().fold(0.0, |h: f64, edge| h.max(0.5 * (edge[1] - edge[0])));
    Window { centre: edges.map(|edge| 0.5 * (edge[0] + edge[1])), half: 1.08 * half + 2.0 * reach[0], side }
}

fn in_cut(plane: &Plane, dot: &Dot) -> Option<[f64; 2]> {
    let (at, depth) = plane.project(&dot.position);
    (depth.abs() < dot.reach).then_some(at)
}

/// An interval without the bins at its ends that hold few of the values.
fn trimmed(edge: [f64; 2], values: impl Iterator<Item = f64>, comm: &Comm) -> [f64; 2] {
    let width = (edge[1] - edge[0]) / BINS as f64;
    // Values outside count at the ends, so that what was trimmed once stays trimmed.
    let mut counts = vec![0i64; BINS];
    for x in values {
        counts[((x - edge[0]) / width).clamp(0.0, (BINS - 1) as f64) as usize] += 1;
    }
    comm.all_sum(&mut counts);
    let allowed = (BEYOND * counts.iter().sum::<i64>() as f64) as i64;
    let spare = |counts: &mut dyn Iterator<Item = &i64>| {
        let mut beyond = 0;
        counts
            .take_while(|&&n| {
                beyond += n;
                beyond <= allowed
            })
            .count()
    };
    let (low, high) = (spare(&mut counts.iter()), spare(&mut counts.iter().rev()));
    if low + high >= BINS || width <= 0.0 || width.is_nan() {
        return edge;
    }
    [edge[0] + low as f64 * width, edge[1] - high as f64 * width]
}

/// Draws the particles: each pixel shows the one nearest to its point in space, the lowest id among equals. Collective.
pub fn rasterise(plane: &Plane, window: Window, dots: &[Dot], comm: &Comm) -> Raster {
    let pixels = window.side * window.side;
    let mut nearest = vec![f64::INFINITY; pixels];
    let mut owner = vec![usize::MAX; pixels];
    for (index, dot) in dots.iter().enumerate() {
        visit(plane, &window, dot, |pixel, distance| {
            let nearer = distance < nearest[pixel] || distance == nearest[pixel] && dot.id < dots[owner[pixel]].id;
            if nearer {
                (nearest[pixel], owner[pixel]) = (distance, index);
            }
        });
    }
    let panels = merge(&nearest, &owner, dots, comm);
    Raster { window, panels }
}

/// Calls back for every pixel within a particle's reach, with the square of its distance.
fn visit(plane: &Plane, window: &Window, dot: &Dot, mut act: impl FnMut(usize, f64)) {
    let (at, depth) = plane.project(&dot.position);
    let room = dot.reach * dot.reach - depth * depth;
    if room <= 0.0 {
        return;
    }
    let pixel = 2.0 * window.half / window.side as f64;
    let low = [0, 1].map(|axis| window.centre[axis] - window.half + 0.5 * pixel);
    let range = |axis: usize| {
        let middle = (at[axis] - low[axis]) / pixel;
        let reach = room.sqrt() / pixel;
        let first = (middle - reach).ceil().max(0.0) as usize;
        let end = ((middle + reach).floor() + 1.0).clamp(0.0, window.side as f64) as usize;
        first..end
    };
    for row in range(1) {
        let dy = low[1] + row as f64 * pixel - at[1];
        for column in range(0) {
            let dx = low[0] + column as f64 * pixel - at[0];
            let plane_square = dx * dx + dy * dy;
            if plane_square <= room {
                act(row * window.side + column, plane_square + depth * depth);
            }
        }
    }
}

/// The values of the nearest particles of all ranks. An id is reduced as two halves, as minima are taken of 64-bit floats.
fn merge(nearest: &[f64], owner: &[usize], dots: &[Dot], comm: &Comm) -> [Vec<f64>; 2] {
    let mut best = nearest.to_vec();
    comm.all_min(&mut best);
    let mut mine: Vec<bool> = (0..best.len()).map(|p| owner[p] != usize::MAX && nearest[p] == best[p]).collect();
    for shift in [32, 0] {
        let half = |p: usize| (dots[owner[p]].id >> shift & 0xffff_ffff) as f64;
        let mut lowest: Vec<f64> =
            mine.iter().enumerate().map(|(p, &m)| if m { half(p) } else { f64::INFINITY }).collect();
        comm.all_min(&mut lowest);
        mine.iter_mut().enumerate().for_each(|(p, m)| *m = *m && half(p) == lowest[p]);
    }
    [0, 1].map(|panel| {
        let value = |(p, &m): (usize, &bool)| if m { dots[owner[p]].values[panel] } else { f64::NEG_INFINITY };
        let mut values: Vec<f64> = mine.iter().enumerate().map(value).collect();
        comm.all_max(&mut values);
        values.iter().map(|v| if v.is_finite() { *v } else { f64::NAN }).collect()
    })
}
