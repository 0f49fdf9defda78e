//! Elastic constants of the bodies of a scene.

use crate::error::{Error, Result};
use crate::exact::waves::Elastic;
use crate::scene::{Body, Scene};

/// Elastic constants of a body's material; a fluid has no shear modulus.
pub fn elastic(scene: &Scene, body: &Body) -> Result<Elastic> {
    let material = &scene.materials[body.material];
    let bulk = material
        .eos
        .law()
        .bulk_modulus()
        .ok_or_else(|| Error::new(format!("body `{}` is no solid", body.name)).allowed("a solid"))?;
    let shear = material.strength.as_ref().map_or(0.0, |table| table.shear_modulus.0);
    Elastic::new(bulk, shear, body.density)
}
