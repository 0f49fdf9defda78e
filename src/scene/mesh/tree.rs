//! The distance of a point from a surface: a tree of boxes around triangles.

use super::{Point, bounds, dot, minus};

/// Triangles in a leaf at most.
const LEAF: usize = 4;

/// Boxes, each with its two halves or with triangles.
#[derive(Debug, Clone)]
pub struct Tree {
    nodes: Vec<Node>,
    triangles: Vec<u32>,
}

#[derive(Debug, Clone)]
struct Node {
    bounds: [[f64; 2]; 3],
    content: Content,
}

#[derive(Debug, Clone)]
enum Content {
    /// Numbers of the triangles, from and to.
    Leaf(usize, usize),
    Halves([usize; 2]),
}

impl Tree {
    pub fn of(vertices: &[Point], triangles: &[[u32; 3]]) -> Self {
        let mut tree = Self { nodes: Vec::new(), triangles: (0..triangles.len() as u32).collect() };
        let corners = |n: u32| triangles[n as usize].map(|corner| vertices[corner as usize]);
        let mut order = std::mem::take(&mut tree.triangles);
        let count = order.len();
        tree.add(&corners, &mut order, 0, count);
        tree.triangles = order;
        tree
    }

    /// Adds the box around the triangles `from` to `to` of `order`, which it sorts, and returns its number.
    fn add(&mut self, corners: &impl Fn(u32) -> [Point; 3], order: &mut [u32], from: usize, to: usize) -> usize {
        let all: Vec<Point> = order[from..to].iter().flat_map(|n| corners(*n)).collect();
        let bounds = bounds(&all);
        let number = self.nodes.len();
        self.nodes.push(Node { bounds, content: Content::Leaf(from, to) });
        if to - from > LEAF {
            let width = |k: usize| bounds[k][1] - bounds[k][0];
            let axis = (1..3).fold(0, |widest, k| if width(k) > width(widest) { k } else { widest });
            let middle = from + (to - from) / 2;
            let place = |n: &u32| corners(*n).iter().map(|x| x[axis]).sum::<f64>();
            order[from..to].select_nth_unstable_by(middle - from, |a, b| place(a).total_cmp(&place(b)).then(a.cmp(b)));
            let halves = [self.add(corners, order, from, middle), self.add(corners, order, middle, to)];
            self.nodes[number].content = Content::Halves(halves);
        }
        number
    }

    /// Distance from the nearest triangle, m.
    pub fn distance(&self, vertices: &[Point], triangles: &[[u32; 3]], point: &Point) -> f64 {
        let mut least = f64::INFINITY;
        let mut waiting = vec![(self.nodes[0].square(point), 0)];
        while let Some((square, number)) = waiting.pop() {
            if square >= least {
                continue;
            }
            match self.nodes[number].content {
                Content::Leaf(from, to) => {
                    for n in &self.triangles[from..to] {
                        let corners = triangles[*n as usize].map(|corner| vertices[corner as usize]);
                        least = least.min(self::square(point, &corners));
                    }
                }
                Content::Halves(halves) => {
                    let mut halves = halves.map(|half| (self.nodes[half].square(point), half));
                    // The nearer half first.
                    halves.sort_by(|a, b| b.0.total_cmp(&a.0));
                    waiting.extend(halves);
                }
            }
        }
        least.sqrt()
    }
}

impl Node {
    /// Square of the distance from the box.
    fn square(&self, point: &Point) -> f64 {
        let beyond = |k: usize| (self.bounds[k][0] - point[k]).max(point[k] - self.bounds[k][1]).max(0.0);
        (0..3).map(|k| beyond(k) * beyond(k)).sum()
    }
}

/// Square of the distance of a point from a triangle: from its plane where the foot lies within it, or else from the nearest edge.
pub fn square(point: &Point, [a, b, c]: &[Point; 3]) -> f64 {
    let (u, v, w) = (minus(b, a), minus(c, a), minus(point, a));
    let (uu, uv, vv, wu, wv) = (dot(&u, &u), dot(&u, &v), dot(&v, &v), dot(&w, &u), dot(&w, &v));
    let det = uu * vv - uv * uv;
    let (s, t) = ((vv * wu - uv * wv) / det, (uu * wv - uv * wu) / det);
    if s >= 0.0 && t >= 0.0 && s + t <= 1.0 {
        let foot: Point = std::array::from_fn(|k| w[k] - s * u[k] - t * v[k]);
        return dot(&foot, &foot);
    }
    [[a, b], [b, c], [c, a]].iter().map(|[from, to]| from_edge(point, from, to)).fold(f64::INFINITY, f64::min)
}

fn from_edge(point: &Point, from: &Point, to: &Point) -> f64 {
    let (edge, w) = (minus(to, from), minus(point, from));
    let share = (dot(&w, &edge) / dot(&edge, &edge)).clamp(0.0, 1.0);
    let off: Point = std::array::from_fn(|k| w[k] - share * edge[k]);
    dot(&off, &off)
}
