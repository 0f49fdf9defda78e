//! Triangles as files have them -> one closed surface, all of whose triangles look outwards.

use std::collections::{BTreeMap, HashMap};
use std::fmt;

use super::Point;

/// What keeps triangles from being one closed surface.
#[derive(Debug, Clone, PartialEq)]
pub enum Flaw {
    /// No triangles, or a corner that does not exist.
    NoTriangles,
    /// Edges of one triangle alone, and where the first of them is.
    Open { edges: usize, near: Point },
    /// Edges of three triangles or more.
    Branched { edges: usize, near: Point },
    /// It has one side only.
    OneSided { near: Point },
    /// It is in several pieces.
    Pieces(usize),
    /// It encloses nothing.
    Flat,
    /// A coordinate is not finite.
    NotFinite,
}

impl fmt::Display for Flaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let near = |[x, y, z]: &Point| format!("near ({x}, {y}, {z}) of the file");
        match self {
            Flaw::NoTriangles => write!(f, "there are no triangles"),
            Flaw::Open { edges, near: at } => {
                write!(f, "the surface is not closed: {edges} edges have a triangle on one side only, {}", near(at))
            }
            Flaw::Branched { edges, near: at } => write!(f, "{edges} edges have more than two triangles, {}", near(at)),
            Flaw::OneSided { near: at } => write!(f, "the surface has no inside, {}", near(at)),
            Flaw::Pieces(count) => write!(f, "the surface is in {count} pieces"),
            Flaw::Flat => write!(f, "the surface encloses no volume"),
            Flaw::NotFinite => write!(f, "a coordinate is not finite"),
        }
    }
}

type Surface = (Vec<Point>, Vec<[u32; 3]>);

/// Vertices at one place are one; triangles without area are left out, as those of poles and seams are.
pub fn closed(vertices: &[Point], triangles: &[[u32; 3]]) -> Result<Surface, Flaw> {
    if vertices.iter().flatten().any(|x| !x.is_finite()) {
        return Err(Flaw::NotFinite);
    }
    let (vertices, triangles) = joined(vertices, triangles)?;
    let edges = edges(&triangles);
    let middle = |edge: &[u32; 2]| -> Point {
        let [a, b] = edge.map(|end| vertices[end as usize]);
        std::array::from_fn(|k| 0.5 * (a[k] + b[k]))
    };
    let unlike = |wrong: fn(usize) -> bool| {
        let mut found = edges.iter().filter(|(_, sides)| wrong(sides.len()));
        found.next().map(|(edge, _)| (1 + found.count(), middle(edge)))
    };
    if let Some((edges, near)) = unlike(|sides| sides > 2) {
        return Err(Flaw::Branched { edges, near });
    }
    if let Some((edges, near)) = unlike(|sides| sides < 2) {
        return Err(Flaw::Open { edges, near });
    }
    let mut triangles = triangles;
    turn_alike(&mut triangles, &edges)
        .map_err(|edge| edge.map_or_else(Flaw::Pieces, |edge| Flaw::OneSided { near: middle(&edge) }))?;
    if super::integrals(&vertices, &triangles).0 < 0.0 {
        triangles.iter_mut().for_each(|triangle| triangle.swap(1, 2));
    }
    Ok((vertices, triangles))
}

fn joined(vertices: &[Point], triangles: &[[u32; 3]]) -> Result<Surface, Flaw> {
    let mut numbers = HashMap::new();
    let mut joined = Vec::new();
    let mut number = |corner: u32| {
        // Adding zero makes -0 and 0 one.
        let x = vertices.get(corner as usize)?.map(|x| x + 0.0);
        let next = joined.len() as u32;
        let number = *numbers.entry(x.map(f64::to_bits)).or_insert(next);
        if number == next {
            joined.push(x);
        }
        Some(number)
    };
    let mut kept = Vec::new();
    for triangle in triangles {
        let mut corners = [0; 3];
        for (to, corner) in corners.iter_mut().zip(triangle) {
            *to = number(*corner).ok_or(Flaw::NoTriangles)?;
        }
        let [a, b, c] = corners;
        if a != b && b != c && c != a {
            kept.push(corners);
        }
    }
    if kept.is_empty() { Err(Flaw::NoTriangles) } else { Ok((joined, kept)) }
}

/// The triangles at each edge, and whether they run along it from its lower end to its higher one.
type Edges = BTreeMap<[u32; 2], Vec<(usize, bool)>>;

fn edges(triangles: &[[u32; 3]]) -> Edges {
    let mut edges = Edges::new();
    for (n, triangle) in triangles.iter().enumerate() {
        for (a, b) in sides(triangle) {
            edges.entry([a.min(b), a.max(b)]).or_default().push((n, a < b));
        }
    }
    edges
}

fn sides(&[a, b, c]: &[u32; 3]) -> [(u32, u32); 3] {
    [(a, b), (b, c), (c, a)]
}

/// Turns triangles so that neighbours run along their common edge in opposite directions; an edge where they cannot, or the number
/// of pieces where there is more than one, is the error.
fn turn_alike(triangles: &mut [[u32; 3]], edges: &Edges) -> Result<(), Result<[u32; 2], usize>> {
    let mut turned: Vec<Option<bool>> = vec![None; triangles.len()];
    let mut pieces = 0;
    for first in 0..triangles.len() {
        if turned[first].is_some() {
            continue;
        }
        pieces += 1;
        turned[first] = Some(false);
        let mut waiting = vec![first];
        while let Some(n) = waiting.pop() {
            let own = turned[n].expect("those that wait are known");
            for (a, b) in sides(&triangles[n]) {
                let edge = [a.min(b), a.max(b)];
                let forward = (a < b) != own;
                for &(other, along) in edges[&edge].iter().filter(|(other, _)| *other != n) {
                    let wanted = along == forward;
                    match turned[other] {
                        None => {
                            turned[other] = Some(wanted);
                            waiting.push(other);
                        }
                        Some(is) if is != wanted => return Err(Ok(edge)),
                        Some(_) => {}
                    }
                }
            }
        }
    }
    if pieces > 1 {
        return Err(Err(pieces));
    }
    let wrong = triangles.iter_mut().zip(turned).filter(|(_, turned)| *turned == Some(true));
    wrong.for_each(|(triangle, _)| triangle.swap(1, 2));
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::tests::ball;
    use super::*;

    #[test]
    fn what_is_no_closed_surface_is_told() {
        let (vertices, triangles) = ball(6, [1.0; 3]);
        let flaw = |vertices: &[Point], triangles: &[[u32; 3]]| closed(vertices, triangles).unwrap_err();
        assert_eq!(flaw(&vertices, &[]), Flaw::NoTriangles);
        assert_eq!(flaw(&vertices, &[[0, 1, 9999]]), Flaw::NoTriangles);
        match flaw(&vertices, &triangles[1..]) {
            Flaw::Open { edges: 3, near } => assert!(near[2] > 0.5, "{near:?}"),
            other => panic!("{other}"),
        }
        let twice = [&triangles[..], &triangles[..1]].concat();
        assert!(matches!(flaw(&vertices, &twice), Flaw::Branched { edges: 3, .. }));
        let apart: Vec<Point> = vertices.iter().map(|[x, y, z]| [x + 5.0, *y, *z]).collect();
        let others: Vec<[u32; 3]> = triangles.iter().map(|t| t.map(|k| k + vertices.len() as u32)).collect();
        assert_eq!(flaw(&[vertices.clone(), apart].concat(), &[triangles.clone(), others].concat()), Flaw::Pieces(2));
        let mut wrong = vertices.clone();
        wrong[3][1] = f64::NAN;
        assert_eq!(flaw(&wrong, &triangles), Flaw::NotFinite);
        assert!(flaw(&vertices, &triangles[1..]).to_string().contains("3 edges"));
    }

    /// Each triangle with corners of its own, as in STL, some turned the wrong way: the same surface.
    #[test]
    fn corners_are_joined_and_triangles_turned() {
        let (vertices, triangles) = ball(6, [1.0; 3]);
        let apart: Vec<Point> = triangles.iter().flatten().map(|corner| vertices[*corner as usize]).collect();
        let mut own: Vec<[u32; 3]> = (0..triangles.len() as u32).map(|n| [3 * n, 3 * n + 1, 3 * n + 2]).collect();
        own.iter_mut().step_by(3).for_each(|triangle| triangle.swap(0, 1));
        let (joined, turned) = closed(&apart, &own).unwrap();
        assert_eq!((joined.len(), turned.len()), (vertices.len(), triangles.len()));
        let [found, exact] =
            [(&joined, &turned), (&vertices, &triangles)].map(|(v, t)| super::super::integrals(v, t).0);
        assert!((found - exact).abs() < 1e-14 && found > 0.0, "{found} {exact}");
    }
}
