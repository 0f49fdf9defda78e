//! `shape` of a body.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

use super::orientation::OrientationTable;
use crate::error::Result;
use crate::scene::document::source::Document;
use crate::scene::geometry::compound::{Compound, Part};
use crate::scene::geometry::lattice::IDENTITY;
use crate::scene::geometry::shape::BodyShape;
use crate::scene::values::checks::POSITIVE;
use crate::scene::values::components::Components;
use crate::units::{Length, Volume};

/// A table with one key, the kind of shape.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ShapeTable {
    /// A sphere; in 2D a disc, and `disc` is another name.
    #[serde(alias = "disc")]
    #[schemars(extend("x-alias" = "disc"))]
    Sphere(SphereTable),
    /// A box; in 2D a rectangle.
    Box(BoxTable),
    /// A cylinder along z, in 3D only.
    Cylinder(CylinderTable),
    /// A cone, cut off where it is `top` wide; in 2D a trapezium.
    Heap(HeapTable),
    /// The lower half of a sphere, its flat face up, as wide as the hollow within `inner` leaves it: shells of other spacings may lie
    /// around each other. In 2D `half_disc` is another name.
    #[serde(alias = "half_disc")]
    #[schemars(extend("x-alias" = "half_disc"))]
    HalfSphere(HalfSphereTable),
    /// An ellipsoid; in 2D an ellipse.
    Ellipsoid(EllipsoidTable),
    /// A shape model from a file, a closed surface of triangles; its centre of mass becomes the body's centre. In 3D only.
    Mesh(MeshTable),
    /// Several shapes that make up one: all of them together, less those with `minus = true`, which are taken away from what is before them.
    All(Vec<PartTable>),
}

#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SphereTable {
    /// Radius.
    #[schemars(extend("x-allowed" = POSITIVE))]
    radius: Length,
}

#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BoxTable {
    /// Edges along x, y and (in 3D) z.
    size: Components<Length>,
}

#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CylinderTable {
    /// Radius.
    #[schemars(extend("x-allowed" = POSITIVE))]
    radius: Length,
    /// Height, along z.
    #[schemars(extend("x-allowed" = POSITIVE))]
    height: Length,
}

#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HeapTable {
    /// Radius of the foot.
    #[schemars(extend("x-allowed" = POSITIVE))]
    radius: Length,
    /// Radius of the flat top, 0 for a tip.
    #[serde(default)]
    top: Length,
    /// Height, along z (in 2D along y).
    #[schemars(extend("x-allowed" = POSITIVE))]
    height: Length,
}

#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HalfSphereTable {
    /// Radius.
    #[schemars(extend("x-allowed" = POSITIVE))]
    radius: Length,
    /// Radius of the hollow around the centre.
    #[serde(default)]
    inner: Length,
}

#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EllipsoidTable {
    /// Half of its axes along x, y and (in 3D) z.
    semi_axes: Components<Length>,
}

#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeshTable {
    /// The file: OBJ, STL or PLY by its ending. A path starts at the scene's folder.
    file: String,
    /// How long a unit of the file is; this, `size` or `volume`.
    #[schemars(extend("x-allowed" = POSITIVE))]
    scale: Option<Length>,
    /// The longest extent along an axis of the file.
    #[schemars(extend("x-allowed" = POSITIVE))]
    size: Option<Length>,
    /// The volume inside.
    #[schemars(extend("x-allowed" = POSITIVE))]
    volume: Option<Volume>,
}

impl MeshTable {
    /// The surface in the scene's measures. `path`: of this table.
    fn validate(&self, document: &Document, path: &str, dimension: usize) -> Result<BodyShape> {
        let error = |what: String| document.error(path, what);
        if dimension == 2 {
            return Err(error("a shape model needs three dimensions".into()));
        }
        let mesh = document.mesh(&self.file).ok_or_else(|| error(format!("{} has not been read", self.file)))?;
        let longest = mesh.bounds().iter().map(|[low, high]| high - low).fold(0.0, f64::max);
        let sizes = [
            ("scale", self.scale.map(|length| length.0)),
            ("size", self.size.map(|length| length.0 / longest)),
            ("volume", self.volume.map(|volume| libm::cbrt(volume.0 / mesh.volume))),
        ];
        let given: Vec<(&str, f64)> = sizes.into_iter().filter_map(|(key, factor)| Some((key, factor?))).collect();
        match given[..] {
            [(_, factor)] if factor > 0.0 && factor.is_finite() => Ok(BodyShape::Mesh(mesh.scaled(factor).into())),
            [(key, _)] => {
                Err(document.error(&format!("{path}.{key}"), format!("{key} is not positive")).allowed(POSITIVE))
            }
            _ => Err(error("the size of a shape model must be told in one way".into())
                .allowed("one of scale = \"1 km\" (a unit of the file), size = \"500 m\" (longest extent) and volume")),
        }
    }
}

impl ShapeTable {
    /// `path`: of the body.
    pub fn validate(&self, document: &Document, path: &str, dimension: usize) -> Result<BodyShape> {
        let error = |key: &str, what: String| document.error(&format!("{path}.shape.{key}"), what);
        let positive = |key: &str, value: Length| match value.0 > 0.0 {
            true => Ok(value.0),
            false => {
                let name = key.rsplit('.').next().unwrap_or(key);
                Err(error(key, format!("{name} is {value}")).allowed(POSITIVE))
            }
        };
        match self {
            ShapeTable::Sphere(ball) => Ok(BodyShape::Sphere { radius: positive("sphere.radius", ball.radius)? }),
            ShapeTable::HalfSphere(ball) => {
                let radius = positive("half_sphere.radius", ball.radius)?;
                if !(0.0..radius).contains(&ball.inner.0) {
                    let what = format!("inner is {} in a half sphere of {}", ball.inner, ball.radius);
                    return Err(error("half_sphere.inner", what).allowed("0 to below the radius"));
                }
                Ok(BodyShape::HalfSphere { radius, inner: ball.inner.0 })
            }
            ShapeTable::Cylinder(_) if dimension == 2 => {
                Err(error("cylinder", "a cylinder needs three dimensions".into()).allowed("sphere, box, half_sphere"))
            }
            ShapeTable::Cylinder(cylinder) => Ok(BodyShape::Cylinder {
                radius: positive("cylinder.radius", cylinder.radius)?,
                height: positive("cylinder.height", cylinder.height)?,
            }),
            ShapeTable::Heap(heap) => {
                let radius = positive("heap.radius", heap.radius)?;
                if !(0.0..=radius).contains(&heap.top.0) {
                    let what = format!("top is {} above a foot of {}", heap.top, heap.radius);
                    return Err(error("heap.top", what).allowed("0 to the radius"));
                }
                Ok(BodyShape::Heap { radius, top: heap.top.0, height: positive("heap.height", heap.height)? })
            }
            ShapeTable::Ellipsoid(ellipsoid) => {
                let path = format!("{path}.shape.ellipsoid.semi_axes");
                let axes = ellipsoid.semi_axes.vector(document, &path, dimension)?;
                for axis in &ellipsoid.semi_axes.0 {
                    positive("ellipsoid.semi_axes", *axis)?;
                }
                Ok(BodyShape::Ellipsoid { axes })
            }
            ShapeTable::Mesh(mesh) => mesh.validate(document, &format!("{path}.shape.mesh"), dimension),
            ShapeTable::All(parts) => compound(parts, document, &format!("{path}.shape.all"), dimension),
            ShapeTable::Box(edges) => {
                let size = edges.size.vector(document, &format!("{path}.shape.box.size"), dimension)?;
                for edge in &edges.size.0 {
                    positive("box.size", *edge)?;
                }
                Ok(BodyShape::Box { size })
            }
        }
    }
}

/// One of several shapes that make up a body.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PartTable {
    /// Shape around the part's centre, as that of a body.
    #[schemars(schema_with = "any_shape")]
    shape: ShapeTable,
    /// Where its centre is, from the body's; there without it.
    position: Option<Components<Length>>,
    /// How the part is turned; not at all without it.
    orientation: Option<OrientationTable>,
    /// Whether it is taken away from the parts before it.
    #[serde(default)]
    minus: bool,
}

/// The tables of shapes are listed once, for the body.
fn any_shape(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": "object" })
}

/// The shape of all parts together. `path`: of their list.
fn compound(parts: &[PartTable], document: &Document, path: &str, dimension: usize) -> Result<BodyShape> {
    let read = |(n, part): (usize, &PartTable)| -> Result<Part<BodyShape>> {
        let path = format!("{path}.{n}");
        let position = part.position.as_ref().map(|x| x.vector(document, &format!("{path}.position"), dimension));
        let rotation = part.orientation.as_ref().map(|turned| turned.rotation(document, &path, dimension));
        Ok(Part {
            shape: part.shape.validate(document, &path, dimension)?,
            position: position.transpose()?.unwrap_or_default(),
            rotation: rotation.transpose()?.unwrap_or(IDENTITY),
            minus: part.minus,
        })
    };
    if parts.first().is_none_or(|first| first.minus) {
        let what = "there is nothing to take away from";
        return Err(document.error(path, what).allowed("a list whose first part has no `minus`"));
    }
    let parts = parts.iter().enumerate().map(read).collect::<Result<Vec<_>>>()?;
    Ok(BodyShape::Compound(Compound::new(parts, dimension)))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use crate::scene::mesh::tests::ball;
    use crate::scene::{Scene, read};

    const SCENE: &str = "[[body]]\nname = \"asteroid\"\nshape = SHAPE\nmaterial = \"basalt\"\nspacing = \"0.1 km\"\n\
        [[body]]\nname = \"projectile\"\nshape = { sphere = { radius = \"50 m\" } }\nmaterial = \"basalt\"\nspacing = \"20 m\"\n\
        [impact]\nspeed = \"3 km/s\"\nangle = \"30 deg\"\n[run]\nuntil = \"1 s\"\n";

    fn scene(folder: &Path, shape: &str, overrides: &[&str]) -> crate::error::Result<Scene> {
        let path = folder.join("scene.toml");
        std::fs::write(&path, SCENE.replace("SHAPE", shape)).unwrap();
        read(&path, &overrides.iter().map(|change| change.to_string()).collect::<Vec<_>>())
    }

    /// An ellipsoid as such and as a shape model are the same body, and particles have the volume and the moments of its surface.
    #[test]
    fn a_shape_model_becomes_a_body() {
        let folder = tempfile::tempdir().unwrap();
        let (vertices, triangles) = ball(24, [2.0, 1.5, 1.0]);
        let mut text = String::new();
        vertices.iter().for_each(|[x, y, z]| text += &format!("v {} {y} {z}\n", x + 7.0));
        triangles.iter().for_each(|t| text += &format!("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1));
        std::fs::write(folder.path().join("asteroid.obj"), text).unwrap();
        let read =
            |shape: &str, changes: &[&str]| scene(folder.path(), shape, changes).unwrap_or_else(|e| panic!("{e}"));
        let mesh = read("{ mesh = { file = \"asteroid.obj\", scale = \"0.5 km\" } }", &[]);
        let smooth = read("{ ellipsoid = { semi_axes = [\"1 km\", \"0.75 km\", \"0.5 km\"] } }", &[]);
        let [ours, theirs] = [&mesh, &smooth].map(|scene| scene.bodies[0].volume());
        assert!((ours / theirs - 1.0).abs() < 0.01 && ours < theirs, "{ours} {theirs}");
        for size in ["size=2 km", "volume=2 km^3"] {
            let other = read(
                "{ mesh = { file = \"asteroid.obj\", scale = \"1 m\" } }",
                &[&format!("asteroid.shape.mesh.{size}")],
            );
            let exact = if size.starts_with("volume") { 2e9 } else { ours };
            assert!((other.bodies[0].volume() / exact - 1.0).abs() < 1e-12, "{size}");
        }
        let body = &mesh.bodies[0];
        let sites: Vec<[f64; 3]> = body.sites(0..body.lattice_sites()).map(|(_, x)| x).collect();
        let share = body.volume() / sites.len() as f64;
        assert!((share / body.lattice.cell_volume() - 1.0).abs() < 0.02, "{}", sites.len());
        for (k, exact) in [1000.0f64, 750.0, 500.0].into_iter().enumerate() {
            let moment = share * sites.iter().map(|x| x[k] * x[k]).sum::<f64>();
            assert!((moment / (theirs * exact * exact / 5.0) - 1.0).abs() < 0.04, "{k} {moment}");
            let middle = sites.iter().map(|x| x[k]).sum::<f64>() / sites.len() as f64;
            assert!(middle.abs() < 0.01 * exact, "{k} {middle}");
        }
        // The projectile flies to where the x axis leaves the body, and starts a kernel support away.
        for scene in [&mesh, &smooth] {
            let projectile = &scene.bodies[1];
            let (x, v) = (projectile.centre, projectile.velocity);
            let end = x[0] - v[0] / v[1] * x[1];
            assert!(
                (end - 1000.0).abs() < 1.0 && (v[1] / v[0] - 30f64.to_radians().tan()).abs() < 1e-12,
                "{end} {v:?}"
            );
            assert!((x[1] * 2.0 - 50.0) / scene.bodies[0].expected_smoothing_length(1.2) > 1.9, "{x:?}");
        }
        // The print names the whole path, and other ranks need no file.
        let text = serde_json::to_string(&mesh).unwrap();
        std::fs::write(folder.path().join("printed.toml"), mesh.to_toml()).unwrap();
        let again = crate::scene::read(&folder.path().join("printed.toml"), &[]).unwrap();
        assert_eq!((&again.bodies, again.to_toml()), (&mesh.bodies, mesh.to_toml()));
        std::fs::remove_file(folder.path().join("asteroid.obj")).unwrap();
        let sent: Scene = serde_json::from_str(&text).unwrap();
        assert_eq!(sent, mesh);
        assert_eq!(sent.reread(&["projectile.radius=60 m".into()]).unwrap().bodies[0], mesh.bodies[0]);
        let piled = read(
            "{ ellipsoid = { semi_axes = [\"1 km\", \"0.75 km\", \"0.5 km\"] } }",
            &["asteroid.rubble={ radius = [\"0.1 km\", \"0.3 km\"], voids = 0.7 }"],
        );
        assert!((0.3..0.32).contains(&(piled.bodies[0].volume() / theirs)));
    }

    #[test]
    fn shapes_that_cannot_be_are_told() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("open.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
        let ball = "{ shape = { sphere = { radius = \"1 km\" } } }";
        let hole = "{ shape = { sphere = { radius = \"0.5 km\" } }, minus = true }";
        for (shape, said) in [
            ("{ mesh = { file = \"none.obj\", scale = 1 } }", "mesh.file: cannot read"),
            ("{ mesh = { file = \"open.obj\", scale = 1 } }", "3 edges have a triangle on one side only"),
            ("{ ellipsoid = { semi_axes = [1, 2] } }", "ellipsoid.semi_axes"),
            ("{ ellipsoid = { semi_axes = [1, 2, -3] } }", "semi_axes is -3 m"),
            ("{ all = [] }", "shape.all: there is nothing to take away from"),
            (&format!("{{ all = [{hole}, {ball}] }}"), "nothing to take away from"),
            ("{ all = [{ shape = { sphere = { radius = -1 } } }] }", "shape.all.0.shape.sphere.radius: radius is -1 m"),
            ("{ all = [{ shape = { sphere = { radius = 1 } }, turned = 3 }] }", "unknown key `turned`"),
        ] {
            let text = scene(folder.path(), shape, &[]).expect_err(shape).to_string();
            assert!(text.contains(said), "{text}");
        }
        let hollow = format!("{{ all = [{ball}, {hole}] }}");
        let text =
            scene(folder.path(), &hollow, &["asteroid.rubble={ radius = [\"0.1 km\", \"0.3 km\"], voids = 0.5 }"])
                .unwrap_err();
        assert!(text.to_string().contains("taken away"), "{text}");
        // The volumes of their parts are not known exactly.
        let text = scene(folder.path(), &hollow, &["impact.refine=true"]).unwrap_err().to_string();
        assert!(text.contains("a shape like this is not refined"), "{text}");
        let volume = scene(folder.path(), &hollow, &[]).unwrap().bodies[0].volume();
        let exact = 4.0 / 3.0 * std::f64::consts::PI * 0.875e9;
        assert!((volume / exact - 1.0).abs() < 3e-5, "{volume} {exact}");
    }
}
