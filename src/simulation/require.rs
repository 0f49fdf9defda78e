//! Errors of a scene that can be found before any particle exists, beyond those of reading it. Runs and `--check` both pass
//! here first, so that they report the same.

use crate::comparison::Comparison;
use crate::comparison::modes;
use crate::error::{Error, Result};
use crate::scene::{Body, Flow, InitialState, Pressed, Scene};

/// Refuses a scene that no run can begin with.
pub fn require(scene: &Scene) -> Result<()> {
    for (number, body) in scene.bodies.iter().enumerate() {
        let at =
            |key: &str, e: Error| Error { allowed: e.allowed, ..scene.error(&format!("body.{number}.{key}"), e.what) };
        if let Some(Flow::Mode { shape, .. }) = body.flow {
            vibrates(scene, body)
                .and_then(|()| modes::ModeShape::new(scene, body, shape))
                .map_err(|e| at("flow.mode", e))?;
        }
        if body.start == InitialState::Hydrostatic {
            let uniform = scene.gravity.uniform.unwrap_or_default();
            let law = scene.materials[body.material].eos.law();
            Pressed::new(body, &law, uniform).map_err(|e| at("start", e))?;
        }
    }
    Comparison::new(scene).map(drop)
}

/// Matter without shear has no free vibration.
fn vibrates(scene: &Scene, body: &Body) -> Result<()> {
    if scene.materials[body.material].has_strength() {
        return Ok(());
    }
    let name = &scene.material_names[body.material];
    Err(Error::new(format!("material `{name}` has no strength, and a body of it no mode of vibration"))
        .allowed(format!("a table [material.{name}.strength], or another flow")))
}

#[cfg(test)]
mod tests {
    use super::*;

    const BALL: &str = "[[body]]\nname = \"b\"\nshape = { sphere = { radius = 1 } }\nmaterial = \"basalt\"\nparticles = 100\n\
        [run]\nuntil = 1\n";

    fn checked(text: &str, overrides: &[&str]) -> String {
        let overrides: Vec<String> = overrides.iter().map(|text| text.to_string()).collect();
        let scene = Scene::parse("s.toml", text, &overrides).unwrap_or_else(|e| panic!("{e}"));
        require(&scene).map_or_else(|e| format!("{} {e}", e.bad_input), |()| String::new())
    }

    #[test]
    fn what_no_run_can_begin_with() {
        assert_eq!(checked(BALL, &[]), "");
        let vibrates =
            BALL.replace("particles = 100", "particles = 100\nflow = { mode = { shape = \"radial\", speed = 1 } }");
        assert_eq!(checked(&format!("{vibrates}[material.basalt.strength]\n"), &[]), "");
        let text = checked(&vibrates, &[]);
        assert!(text.starts_with("true s.toml:6: body b, flow.mode: material `basalt` has no strength"), "{text}");
        let bends = "b.flow={ mode = { shape = \"bending\", speed = 1 } }";
        let text = checked(&format!("{BALL}[material.basalt.strength]\n"), &[bends]);
        assert!(text.starts_with("true --set b.flow") && text.contains("no such mode"), "{text}");
        let text = checked(BALL, &["b.start=hydrostatic", "gravity.self=true", "b.radius=1e9"]);
        assert!(text.starts_with("true --set b.start=hydrostatic: no density"), "{text}");
        let text = checked(&format!("{BALL}[compare]\nwith = \"rotation\"\n"), &[]);
        assert!(text.starts_with("true s.toml:9: compare.with: ") && text.contains("a body with a spin"), "{text}");
    }
}
