//! Elastic constants of the bodies of a scene.

use crate::error::{Error, Result};
use crate::exact::waves::Elastic;
use crate::scene::{Body, Scene};

/// Elastic constants of a body's material; a fluid has no shear modulus.
pub fn elastic(scene: &Scene, body: &Body) -> Result<Elastic> {
    let material = &scene.materials[body.material];
    let [bulk, shear] = material
        .moduli(body.density)
        .ok_or_else(|| Error::new(format!("body `{}` is no solid", body.name)).allowed("a solid"))?;
    Elastic::new(bulk, shear, body.density)
}
