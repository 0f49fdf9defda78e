//! Shape models in files: OBJ, STL (text and binary), PLY (text and binary), told apart by their endings.

use std::io::Cursor;
use std::path::Path;

use ply_rs_bw::parser::Parser;
use ply_rs_bw::ply::{DefaultElement, Property};

use super::{Mesh, Point};

/// Endings of the files that are understood.
pub const KINDS: &str = "a file that ends in .obj, .stl or .ply";
/// The largest file, bytes.
const LARGEST: u64 = 1 << 30;

type Triangles = (Vec<Point>, Vec<[u32; 3]>);

/// The surface in a file, in the file's unit; what is wrong where there is none.
pub fn read(path: &Path) -> Result<Mesh, String> {
    let about = std::fs::metadata(path).map_err(|e| format!("cannot read {}: {e}", path.display()))?;
    if !about.is_file() || about.len() > LARGEST {
        return Err(format!("{} is no file of {} MiB at most", path.display(), LARGEST >> 20));
    }
    let bytes = std::fs::read(path).map_err(|e| format!("cannot read {}: {e}", path.display()))?;
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    let (vertices, triangles) = match ending.as_deref() {
        Some("obj") => obj(&bytes),
        Some("stl") => stl(&bytes),
        Some("ply") => ply(&bytes),
        _ => return Err(format!("{} is of no known kind (allowed: {KINDS})", path.display())),
    }
    .map_err(|what| format!("{} is not understood: {what}", path.display()))?;
    Mesh::new(&vertices, &triangles).map_err(|flaw| format!("{}: {flaw}", path.display()))
}

fn obj(bytes: &[u8]) -> Result<Triangles, String> {
    let options =
        tobj::LoadOptions { triangulate: true, ignore_points: true, ignore_lines: true, ..Default::default() };
    // Materials say nothing about the surface.
    let (models, _) =
        tobj::load_obj_buf(&mut Cursor::new(bytes), &options, |_| Ok(Default::default())).map_err(|e| e.to_string())?;
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for model in models {
        let first = vertices.len() as u32;
        vertices.extend(model.mesh.positions.as_chunks::<3>().0);
        triangles
            .extend(model.mesh.indices.as_chunks::<3>().0.iter().map(|corners| corners.map(|corner| first + corner)));
    }
    Ok((vertices, triangles))
}

fn stl(bytes: &[u8]) -> Result<Triangles, String> {
    let mesh = stl_io::read_stl(&mut Cursor::new(bytes)).map_err(|e| e.to_string())?;
    let vertices = mesh.vertices.iter().map(|vertex| vertex.0.map(f64::from)).collect();
    Ok((vertices, mesh.faces.iter().map(|face| face.vertices.map(|corner| corner as u32)).collect()))
}

fn ply(bytes: &[u8]) -> Result<Triangles, String> {
    let file = Parser::<DefaultElement>::new().read_ply(&mut Cursor::new(bytes)).map_err(|e| e.to_string())?;
    let elements = |name: &str| file.payload.get(name).map_or(&[][..], Vec::as_slice);
    let mut vertices = Vec::new();
    for vertex in elements("vertex") {
        let mut x = [0.0; 3];
        for (to, axis) in x.iter_mut().zip(["x", "y", "z"]) {
            *to = vertex.get(axis).and_then(number).ok_or_else(|| format!("a vertex has no {axis}"))?;
        }
        vertices.push(x);
    }
    let mut triangles = Vec::new();
    for face in elements("face") {
        let corners = ["vertex_indices", "vertex_index"].iter().find_map(|name| corners(face.get(*name)?));
        let corners = corners.ok_or("a face has no vertices")?;
        // A polygon as a fan.
        triangles.extend(corners.windows(2).skip(1).map(|pair| [corners[0], pair[0], pair[1]]));
    }
    Ok((vertices, triangles))
}

fn number(property: &Property) -> Option<f64> {
    match *property {
        Property::Float(x) => Some(x.into()),
        Property::Double(x) => Some(x),
        Property::Char(x) => Some(x.into()),
        Property::UChar(x) => Some(x.into()),
        Property::Short(x) => Some(x.into()),
        Property::UShort(x) => Some(x.into()),
        Property::Int(x) => Some(x.into()),
        Property::UInt(x) => Some(x.into()),
        _ => None,
    }
}

fn corners(property: &Property) -> Option<Vec<u32>> {
    fn all<T: Copy>(list: &[T], number: impl Fn(T) -> Option<u32>) -> Option<Vec<u32>> {
        list.iter().map(|x| number(*x)).collect()
    }
    match property {
        Property::ListChar(list) => all(list, |x| x.try_into().ok()),
        Property::ListUChar(list) => all(list, |x| Some(x.into())),
        Property::ListShort(list) => all(list, |x| x.try_into().ok()),
        Property::ListUShort(list) => all(list, |x| Some(x.into())),
        Property::ListInt(list) => all(list, |x| x.try_into().ok()),
        Property::ListUInt(list) => all(list, Some),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::ball;
    use super::*;

    fn written(name: &str, bytes: &[u8]) -> Result<Mesh, String> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        read(&path).map_err(|what| what.replace(&folder.path().display().to_string(), ""))
    }

    fn float(x: f64) -> [u8; 4] {
        (x as f32).to_le_bytes()
    }

    /// One ball in every kind of file: the same surface, but for what 32 bits lose.
    #[test]
    fn every_kind_of_file_gives_the_same_surface() {
        let (vertices, triangles) = ball(7, [1.0, 0.75, 0.5]);
        let exact = Mesh::new(&vertices, &triangles).unwrap();
        let corners = |t: &[u32; 3]| t.map(|corner| vertices[corner as usize]);
        let mut obj = String::from("# a ball\no ball\n");
        vertices.iter().for_each(|[x, y, z]| obj += &format!("v {x} {y} {z}\n"));
        triangles
            .iter()
            .for_each(|t| obj += &format!("f {0}//1 {1}//1 {2}//1\n", t[0] + 1, t[1] + 1, t[2] + 1).replace("//1", ""));
        let mut text = String::from("solid ball\n");
        for t in &triangles {
            text += "facet normal 0 0 0\nouter loop\n";
            corners(t).iter().for_each(|[x, y, z]| text += &format!("vertex {x:e} {y:e} {z:e}\n"));
            text += "endloop\nendfacet\n";
        }
        text += "endsolid ball\n";
        let mut binary = vec![0; 80];
        binary.extend((triangles.len() as u32).to_le_bytes());
        for t in &triangles {
            binary.extend([0; 12]);
            corners(t).iter().flatten().for_each(|x| binary.extend(float(*x)));
            binary.extend([0; 2]);
        }
        let head = |format: &str| {
            format!(
                "ply\nformat {format} 1.0\ncomment a ball\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
                 element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                vertices.len(),
                triangles.len()
            )
        };
        let mut ply_text = head("ascii");
        vertices.iter().for_each(|[x, y, z]| ply_text += &format!("{x} {y} {z}\n"));
        triangles.iter().for_each(|t| ply_text += &format!("3 {} {} {}\n", t[0], t[1], t[2]));
        let mut ply_binary = head("binary_little_endian").into_bytes();
        vertices.iter().flatten().for_each(|x| ply_binary.extend(float(*x)));
        for t in &triangles {
            ply_binary.push(3);
            t.iter().for_each(|corner| ply_binary.extend(corner.to_le_bytes()));
        }
        let files: [(&str, &[u8]); 5] = [
            ("ball.obj", obj.as_bytes()),
            ("text.STL", text.as_bytes()),
            ("binary.stl", &binary),
            ("text.ply", ply_text.as_bytes()),
            ("binary.ply", &ply_binary),
        ];
        for (name, bytes) in files {
            let mesh = written(name, bytes).unwrap_or_else(|what| panic!("{name}: {what}"));
            assert_eq!(mesh.faces(), exact.faces(), "{name}");
            assert!((mesh.volume / exact.volume - 1.0).abs() < 1e-6, "{name}: {} {}", mesh.volume, exact.volume);
        }
        // Text keeps all digits.
        assert!((written("ball.obj", obj.as_bytes()).unwrap().volume - exact.volume).abs() < 1e-14);
    }

    #[test]
    fn what_is_no_shape_model_is_told() {
        for (name, bytes, said) in [
            ("a.txt", &b"v 0 0 0"[..], "of no known kind"),
            ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "3 edges have a triangle on one side only"),
            ("a.obj", b"nothing here\n", "there are no triangles"),
            ("a.ply", b"no header", "is not understood"),
            ("a.stl", b"solid x\nfacet normal 0 0 z\n", "is not understood"),
        ] {
            let what = written(name, bytes).unwrap_err();
            assert!(what.contains(said), "{name}: {what}");
        }
        assert!(read(Path::new("/nowhere/a.obj")).unwrap_err().contains("cannot read"));
    }
}
