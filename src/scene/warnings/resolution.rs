//! What an impact asks of the spacing, and what to change where the spacing cannot give it.

use crate::scene::geometry::shape::BodyShape;
use crate::scene::tables::body::validated::Body;
use crate::scene::tables::impacts::impact::AngleAt;
use crate::scene::validated::Scene;
use crate::warning::Warning;

impl Scene {
    /// Warnings about what the target cannot resolve: a projectile smaller than its spacing, paths that overlap by less than that.
    pub fn unresolved(&self) -> Vec<Warning> {
        let Some(impact) = &self.impact else { return Vec::new() };
        let small =
            small_projectile(&self.bodies[self.at_impact().unwrap_or(impact.target)], &self.bodies[impact.projectile]);
        small.into_iter().chain(self.graze()).collect()
    }

    /// The projectile's cross-section and the target's overlap by (R_t + R_p) - b as they pass on straight lines, b the distance of
    /// the centres: below a spacing the lattice decides what is hit.
    fn graze(&self) -> Option<Warning> {
        let impact = self.impact.as_ref()?;
        let (target, projectile) = (&self.bodies[impact.target], &self.bodies[impact.projectile]);
        let (BodyShape::Sphere { radius: r_t }, BodyShape::Sphere { radius: r_p }) = (target.shape, projectile.shape)
        else {
            return None;
        };
        let lever = match impact.angle_at {
            AngleAt::Contact => r_t + r_p,
            AngleAt::Centre => r_t,
        };
        let (overlap, spacing) = (r_t + r_p - libm::sin(impact.angle) * lever, target.lattice.spacing);
        if overlap >= spacing {
            return None;
        }
        let resolved = ((r_t + r_p - spacing) / lever).clamp(0.0, 1.0);
        Some(Warning::new(
            "overlap",
            format!(
                "the paths of `{}` and `{}` overlap by {overlap:.3} m, {:.2} % of the target's spacing of {spacing:.4} m: how the \
                 lattice lies decides what is hit, and the outcome changes with the spacing (change: an angle below {:.1} deg, or a \
                 spacing of the target below {overlap:.3} m)",
                projectile.name,
                target.name,
                100.0 * overlap / spacing,
                libm::asin(resolved).to_degrees(),
            ),
        ))
    }
}

fn small_projectile(target: &Body, projectile: &Body) -> Option<Warning> {
    let diameter = diameter(projectile);
    let spacing = target.lattice.spacing;
    if diameter >= spacing {
        return None;
    }
    let particle = |body: &Body| body.density * body.lattice.cell_volume();
    let finer = libm::pow(spacing / diameter, target.dimension as f64);
    Some(Warning::new(
        "projectile",
        format!(
            "`{}` is {:.3} of the target's spacing across ({diameter:.4} m, {spacing:.4} m), and one particle of the target weighs {:.3e} \
             of its: the target cannot resolve it (change: impact.refine = true, a spacing of `{}` of at most {diameter:.4} m, {:.2e} particles, or a \
             projectile of at least {spacing:.4} m across)",
            projectile.name,
            diameter / spacing,
            particle(target) / particle(projectile),
            target.name,
            target.expected_particles() * finer,
        ),
    ))
}

/// Diameter of the sphere (in 2D disc) that has the volume of a body, m.
fn diameter(body: &Body) -> f64 {
    let volume = body.shape.volume(body.dimension);
    match body.dimension {
        2 => 2.0 * (volume / std::f64::consts::PI).sqrt(),
        _ => 2.0 * libm::cbrt(volume * (0.75 / std::f64::consts::PI)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kinds(change: &[&str]) -> Vec<String> {
        let overrides: Vec<String> = change.iter().map(|change| change.to_string()).collect();
        let text = include_str!("../../../inputs/qd_star.toml");
        let scene = Scene::parse("qd.toml", text, &overrides).expect("a scene");
        scene.unresolved().into_iter().map(|warning| format!("{}: {}", warning.kind, warning.text)).collect()
    }

    /// 50 km and 12 km overlap by 62 km (1 - sin 85 deg) = 236 m, 20000 particles lie 3.33 km apart; 500, 11.4 km, are wider than a
    /// projectile of 5 km.
    #[test]
    fn what_the_spacing_cannot_resolve_is_told() {
        assert!(kinds(&[]).is_empty() && kinds(&["impact.angle=\"60 deg\""]).is_empty());
        let grazing = kinds(&["impact.angle=\"85 deg\""]);
        assert!(grazing.len() == 1 && grazing[0].starts_with("overlap:"), "{grazing:?}");
        assert!(
            grazing[0].contains("overlap by 235.9") && grazing[0].contains("an angle below 71.1 deg"),
            "{grazing:?}"
        );
        // At the surface that its centre's path meets the projectile comes much nearer.
        assert!(kinds(&["impact.angle=\"85 deg\"", "impact.angle_at=\"centre\""]).is_empty());
        let coarse = kinds(&["target.particles=500", "projectile.radius=\"2.5 km\""]);
        assert!(coarse.len() == 1 && coarse[0].starts_with("projectile:"), "{coarse:?}");
        assert!(coarse[0].contains("is 0.439") && coarse[0].contains("of at most 5000.0000 m"), "{coarse:?}");
    }
}
