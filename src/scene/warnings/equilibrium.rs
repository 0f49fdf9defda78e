//! Matter that starts under a load that nothing holds.

use crate::scene::tables::body::table::InitialState;
use crate::scene::tables::body::validated::Body;
use crate::scene::validated::Scene;
use crate::units::{Density, Pressure};
use crate::warning::Warning;

/// Pressure at the start over the bulk modulus, in tension and in compression, from which on a body is told. Rock bears some 1e-3 of its
/// modulus in tension; what starts in compression may be meant.
const TENSION: f64 = 0.01;
const COMPRESSION: f64 = 0.1;
/// Density over that without load below which matter is torn, whatever its law says: by many laws tension fades in matter so thin.
const THIN: f64 = 0.95;

impl Scene {
    /// Bodies whose density and energy at the start are far from what their material has without load.
    pub fn far_from_equilibrium(&self) -> Vec<Warning> {
        self.bodies.iter().filter_map(|body| self.loaded(body)).collect()
    }

    fn loaded(&self, body: &Body) -> Option<Warning> {
        let material = &self.materials[body.material];
        // What comes from a file has densities of its own, dust its own law, and a rigid body none.
        let known = body.given.is_none() && body.rigid.is_none() && !material.is_dust();
        if !known || body.start != InitialState::Unloaded {
            return None;
        }
        let (modulus, reference) = (material.eos.law().bulk_modulus()?, material.reference_density()?);
        let matrix = body.density * body.distention;
        let (pressure, _) = material.eos.law().pressure(matrix, body.internal_energy);
        let share = pressure / modulus;
        let torn = share < -TENSION || (matrix < THIN * reference && share <= 0.0);
        if !torn && share <= COMPRESSION {
            return None;
        }
        let pores = match &material.porosity {
            Some(_) => format!("distention = {:.3}", reference / body.density),
            None => format!(
                "a table [material.NAME.porosity] for matter with pores, a distention of {:.3}",
                reference / body.density
            ),
        };
        let text = format!(
            "`{}` starts at a density of {}, {:.3} of what its material has without load, under a pressure of {}: it {} before anything else \
             happens (change: no `density`, which is then the material's; {pores}; or `internal_energy`)",
            body.name,
            Density::new(body.density),
            matrix / reference,
            Pressure::new(pressure),
            if torn { "is torn" } else { "bursts" }
        );
        Some(Warning::new("equilibrium", text))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(change: &[&str]) -> Vec<Warning> {
        let overrides: Vec<String> = change.iter().map(|change| change.to_string()).collect();
        let text = include_str!("../../../inputs/qd_star.toml");
        Scene::parse("qd.toml", text, &overrides).expect("a scene").far_from_equilibrium()
    }

    /// Basalt at 1000 kg/m^3 is in deep tension; slightly warm or a little denser it is what somebody may have meant.
    #[test]
    fn deep_tension_is_told() {
        assert!(told(&[]).is_empty() && told(&["target.density=2690", "projectile.internal_energy=1e4"]).is_empty());
        let torn = told(&["target.density=1000"]);
        assert!(torn.len() == 1 && torn[0].kind == "equilibrium" && torn[0].text.contains("is torn"), "{torn:?}");
        assert!(torn[0].text.contains("1000 kg/m^3, 0.370 of") && torn[0].text.contains("2.700"), "{torn:?}");
        let hot = told(&["projectile.internal_energy=5e6 J/kg"]);
        assert!(hot.len() == 1 && hot[0].text.contains("`projectile`") && hot[0].text.contains("bursts"), "{hot:?}");
        let gas = Scene::parse("gas.toml", include_str!("../../../inputs/blast_gas.toml"), &[]).expect("a scene");
        assert!(gas.far_from_equilibrium().is_empty());
    }
}
