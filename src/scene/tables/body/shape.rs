//! `shape` of a body.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::Result;
use crate::scene::document::source::Document;
use crate::scene::geometry::shape::BodyShape;
use crate::scene::values::checks::POSITIVE;
use crate::scene::values::components::Components;
use crate::units::Length;

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
