//! What the table of a rigid body needs of its body, and what makes no sense beside it.

use super::rigid::{Rigid, RigidTable};
use super::table::{BodyTable, InitialState};
use crate::error::Result;
use crate::material::MaterialTable;
use crate::scene::document::source::Document;
use crate::scene::values::checks::POSITIVE;

/// kg/m^3: far from where its contact would be that of another kind (`pair::contrast`).
const DENSITIES: std::ops::RangeInclusive<f64> = 1e-3..=1e6;

/// The rigid body of the completed table `body`, whose key path is `path`.
pub fn validate(
    rigid: &RigidTable,
    document: &Document,
    path: &str,
    body: &BodyTable,
    material: &MaterialTable,
) -> Result<Rigid> {
    let refused = [
        ("material", material.reference_density().is_none(), "a gas is no rigid body", "a solid"),
        ("flow", body.flow.is_some(), "a rigid body does not deform", "velocity and spin"),
        ("blast", body.blast.is_some(), "a rigid body is not driven apart by heat", "no blast"),
        ("joints", body.joints.is_some(), "a rigid body does not break", "no joints"),
        ("damage", body.damage.is_some_and(|d| d.0 != 0.0), "a rigid body does not break", "no damage"),
        ("start", body.start != InitialState::Unloaded, "a rigid body does not yield to its weight", "\"unloaded\""),
    ];
    if let Some((key, _, what, allowed)) = refused.into_iter().find(|(_, refused, ..)| *refused) {
        return Err(document.error(&format!("{path}.{key}"), what).allowed(allowed));
    }
    let key = format!("{path}.density");
    if let Some(density) = body.density.filter(|density| !DENSITIES.contains(&density.0)) {
        return Err(document
            .error(&key, format!("density is {density}"))
            .allowed("1e-3 to 1e6 kg/m^3 of a rigid body"));
    }
    let key = format!("{path}.rigid.sound_speed");
    let Some(sound_speed) = rigid.sound_speed else {
        let what = "key `sound_speed` is missing: nothing moves or deforms that it could follow from";
        return Err(document.error(&key, what).allowed("a speed well above that of the bodies"));
    };
    if !(sound_speed.0 > 0.0 && sound_speed.0.is_finite()) {
        return Err(document.error(&key, format!("sound_speed is {sound_speed}")).allowed(POSITIVE));
    }
    let rotation = rigid.rotation.unwrap_or(body.motion.is_none());
    if !rotation && body.spin.as_ref().is_some_and(|spin| spin.0.iter().any(|w| w.0 != 0.0)) {
        let what = "the body has a spin, but does not turn";
        return Err(document.error(&format!("{path}.spin"), what).allowed("rigid = { rotation = true }, or no spin"));
    }
    Ok(Rigid { sound_speed: sound_speed.0, rotation, adhesion: rigid.adhesion })
}
