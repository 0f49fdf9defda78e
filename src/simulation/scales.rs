//! Times, speeds and energies that characterise a scene.

use crate::gravity::G;
use crate::math::Vec3;
use crate::scene::{Body, Scene};

/// When the bodies of an impact would touch at constant velocities, s; zero where they touch already.
pub fn first_contact(scene: &Scene) -> f64 {
    let Some(impact) = &scene.impact else { return 0.0 };
    let (target, projectile) = (&scene.bodies[impact.target], &scene.bodies[impact.projectile]);
    let x = Vec3::from(projectile.centre) - Vec3::from(target.centre);
    let v = Vec3::from(projectile.velocity) - Vec3::from(target.velocity);
    if let Some(face) = scene.face() {
        let reach = projectile.shape.bounds(projectile.dimension);
        let height = projectile.centre[face.up] + reach.middle[face.up] - reach.half[face.up] - face.middle[face.up];
        return (height / -v[face.up]).max(0.0);
    }
    let reach = target.shape.outer_radius() + projectile.shape.outer_radius();
    // |x + v t| = reach, the earlier root.
    let (a, b, c) = (v.norm_squared(), x.dot(&v), x.norm_squared() - reach * reach);
    let discriminant = b * b - a * c;
    if a > 0.0 && discriminant >= 0.0 { ((-b - discriminant.sqrt()) / a).max(0.0) } else { 0.0 }
}

/// Time that sound takes through the largest body, in the target's material, s.
pub fn crossing(scene: &Scene) -> f64 {
    let largest = scene.bodies.iter().map(|b| b.shape.outer_radius()).fold(0.0, f64::max);
    2.0 * largest / sound_speed(scene, scene.impact.as_ref().map_or(0, |impact| impact.target))
}

/// Longitudinal speed of sound of a body at the start, m/s, where it is hottest; of a rigid body that of its contact.
pub fn sound_speed(scene: &Scene, body: usize) -> f64 {
    let body = &scene.bodies[body];
    match body.rigid {
        Some(rigid) => rigid.sound_speed,
        None => {
            let heat = body.blast.map_or(0.0, |blast| blast.peak(body.dimension) / body.density);
            let material = &scene.materials[body.material];
            material.sound_speed(body.density * body.distention, body.internal_energy + heat)
        }
    }
}

/// Time in which a ball of this density (kg/m^3) at rest and without support falls into its centre, s.
pub fn free_fall_time_of(density: f64) -> f64 {
    (3.0 * std::f64::consts::PI / (32.0 * G * density)).sqrt()
}

fn target(scene: &Scene) -> &Body {
    &scene.bodies[scene.impact.as_ref().map_or(0, |impact| impact.target)]
}

/// Free-fall time of the target, s.
pub fn free_fall_time(scene: &Scene) -> f64 {
    free_fall_time_of(target(scene).density)
}

/// G M^2 / R of the target, J.
pub fn binding(scene: &Scene) -> f64 {
    let target = target(scene);
    G * target.whole_mass() * target.whole_mass() / target.shape.outer_radius()
}

/// Whether energy is accounted for: cold matter does not record what it takes up.
pub fn has_balance(scene: &Scene) -> bool {
    let mut deforming = scene.bodies.iter().filter(|body| body.rigid.is_none()).peekable();
    // What rigid bodies take up by their contact is cold, too, and recorded where others have heat.
    deforming.peek().is_some() && deforming.all(|body| !scene.materials[body.material].eos.law().is_cold())
}
