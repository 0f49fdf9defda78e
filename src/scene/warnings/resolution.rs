//! What an impact asks of the spacing and dust of the kernel, and what to change where they cannot give it.

use crate::kernel::SUPPORT;
use crate::math::Vec3;
use crate::scene::geometry::shape::BodyShape;
use crate::scene::tables::body::validated::Body;
use crate::scene::tables::impacts::impact::AngleAt;
use crate::scene::tables::numerics::neighbours;
use crate::scene::validated::Scene;
use crate::warning::Warning;

/// Neighbours of dust in 2D and 3D up to which it is noisy. In 2D profiles were unstable with 13 of them and noisy with 30 (Geretshauser
/// et al. 2010, Sect. 4.2: h / l_c = 2 and 3); in 3D as many across.
const FEW_NEIGHBOURS: [f64; 2] = [32.0, 125.0];

/// How many times the speed of sound. Discs of dust that met at ten times went through each other, with a gain of energy; with beta = 2
/// they did not.
const PASSING: f64 = 2.0;
/// beta up to which particles of so fast dust pass through others: with 0.2 aggregates 11 spacings across went through each other at
/// 50 m/s, and with 2 they bounced.
const ENOUGH: f64 = 1.0;

/// Particles of a projectile in 2D and 3D below which it is told: with fewer all of it is surface.
const FEW_PARTICLES: [f64; 2] = [8.0, 20.0];

/// Least thickness of a layer that holds what lies in it, in supports: the outermost tenth of a kernel weighs a thousandth.
const THIN: f64 = 0.9;

impl Scene {
    /// Warnings about what the spacing cannot resolve: a projectile smaller than the target's, paths that overlap by less than that; and
    /// about dust with few neighbours.
    pub fn unresolved(&self) -> Vec<Warning> {
        let small = self.impact.as_ref().and_then(|impact| {
            let target = self.at_impact().unwrap_or(impact.target);
            small_projectile(&self.bodies[target], &self.bodies[impact.projectile])
        });
        let of_impact = small.into_iter().chain(self.coarse_projectile()).chain(self.graze());
        of_impact.chain(self.few_neighbours()).chain(self.passing_through()).chain(self.thin_layer()).collect()
    }

    /// A projectile of so few particles that all of it is surface.
    fn coarse_projectile(&self) -> Option<Warning> {
        let body = &self.bodies[self.impact.as_ref()?.projectile];
        let (found, few) = (body.expected_particles(), FEW_PARTICLES[self.dimension - 2]);
        (found < few).then(|| {
            let text = format!(
                "`{}` is of some {found:.0} particles: its mass, momentum and energy are right, the shock that it makes and what becomes of it are \
                 those of a lump (change: particles = 100 of it, or impact.refine = true with it)",
                body.name
            );
            Warning::new("coarse_projectile", text)
        })
    }

    /// A layer along a body's outer faces that matter beside it reaches through: it does not hold what it should.
    fn thin_layer(&self) -> Option<Warning> {
        self.layers.iter().find_map(|layer| {
            let (outer, body) = (layer.outer.as_ref()?, &self.bodies[layer.region.body?]);
            let spacing = libm::pow(body.lattice.cell_volume(), 1.0 / body.dimension as f64);
            let support = SUPPORT * self.numerics.eta * spacing;
            (outer.thickness < THIN * support).then(|| {
                let text = format!(
                    "the outer layer of `{}` is {:.4} m thick, and its particles reach {support:.4} m: what lies inside may leak through it \
                     (change: layer.outer of {support:.4} m and more, or a spacing of at most {:.4} m)",
                    body.name,
                    outer.thickness,
                    body.lattice.spacing * outer.thickness / support
                );
                Warning::new("thin_layer", text)
            })
        })
    }

    /// Dust that meets another body faster than [`PASSING`] times its speed of sound, with little quadratic viscosity.
    fn passing_through(&self) -> Option<Warning> {
        let met = |body: &Body| {
            let others =
                self.bodies.iter().map(|other| (Vec3::from(other.velocity) - Vec3::from(body.velocity)).norm());
            others.fold(0.0, f64::max)
        };
        self.bodies.iter().find_map(|body| {
            let material = &self.materials[body.material];
            let sound = material.dust()?.unloaded(body.density).1;
            let (speed, beta) = (met(body), material.viscosity_coefficients().map_or(0.0, |[_, beta]| beta));
            (speed > PASSING * sound && beta < ENOUGH).then(|| {
                let text = format!(
                    "`{}` meets other matter at {speed:.3} m/s, {:.1} times its speed of sound: its particles may pass through others \
                     with a quadratic viscosity of {beta} (change: viscosity.beta = 2 of its material)",
                    body.name,
                    speed / sound
                );
                Warning::new("passing_through", text)
            })
        })
    }

    fn few_neighbours(&self) -> Option<Warning> {
        let (eta, few) = (self.numerics.eta, FEW_NEIGHBOURS[self.dimension - 2]);
        let found = neighbours(eta, self.dimension);
        let body = self.bodies.iter().find(|body| self.materials[body.material].is_dust())?;
        (found <= few).then(|| {
            let text = format!(
                "particles of `{}` have {found:.0} neighbours at the start: dust with up to {few} is noisy, with half of them its filling \
                 factor is not to be trusted (change: numerics.eta, {eta} now)",
                body.name
            );
            Warning::new("few_neighbours", text)
        })
    }

    /// The projectile's cross-section and the target's overlap by (R_t + R_p) - b as they pass on straight lines, b the distance of
    /// the centres: below a spacing the lattice decides what is hit.
    fn graze(&self) -> Option<Warning> {
        let impact = self.impact.as_ref()?;
        let (target, projectile) = (&self.bodies[impact.target], &self.bodies[impact.projectile]);
        let (&BodyShape::Sphere { radius: r_t }, &BodyShape::Sphere { radius: r_p }) =
            (&target.shape, &projectile.shape)
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

    /// h / l_c = 3 of the paper, 31 neighbours, is told, 5.6 is not, and a gas with as few never.
    #[test]
    fn dust_wants_neighbours() {
        let kinds = |text: &str, eta: &str| {
            let scene = Scene::parse("scene.toml", text, &[format!("numerics.eta={eta}")]).expect("a scene");
            scene.unresolved().into_iter().map(|warning| warning.kind.to_string()).collect::<Vec<_>>()
        };
        let dust = include_str!("../../../inputs/dust_compaction_2d.toml");
        assert_eq!(kinds(dust, "1.61"), ["few_neighbours"]);
        assert!(kinds(dust, "3").is_empty() && kinds(include_str!("../../../inputs/blast_gas.toml"), "0.9").is_empty());
    }

    #[test]
    fn a_layer_is_as_thick_as_kernels_reach() {
        let kinds = |spacing: &str| {
            let set = ["dust", "bead"].map(|body| format!("{body}.spacing={spacing}"));
            let text = include_str!("../../../inputs/dust_compaction_2d.toml");
            let scene = Scene::parse("dust.toml", text, &set).expect("a scene");
            scene.unresolved().into_iter().map(|warning| warning.kind.to_string()).collect::<Vec<_>>()
        };
        assert!(kinds("25 um").is_empty());
        assert_eq!(kinds("50 um"), ["thin_layer"]);
    }

    #[test]
    fn fast_dust_wants_beta() {
        let kinds = |more: &[&str]| {
            let overrides: Vec<String> = more.iter().map(|change| change.to_string()).collect();
            let text = include_str!("../../../inputs/dust_compaction_2d.toml");
            let scene = Scene::parse("dust.toml", text, &overrides).expect("a scene");
            scene.unresolved().into_iter().map(|warning| warning.kind.to_string()).collect::<Vec<_>>()
        };
        let fast = "bead.velocity=[0, \"-20 m/s\"]";
        assert_eq!(kinds(&[fast]), ["passing_through"]);
        assert_eq!(kinds(&[fast, "material.silica_dust.viscosity.beta=0.2"]), ["passing_through"]);
        assert!(kinds(&[]).is_empty() && kinds(&[fast, "material.silica_dust.viscosity.beta=2"]).is_empty());
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
