//! Ground under uniform gravity that carries its own weight from the start: a box without sides.
//!
//! The box keeps the mass that it has without load, and its lower face stays where it is. With s the depth below its upper face
//! and z the height above the lower one, both without load,
//!
//! ```text
//! P = rho_0 g s        rho, u = isentrope(P)        height(z) = int_0^z rho_0 / rho dz'
//! ```
//! g the acceleration across the faces, m/s^2; H the thickness without load, m. In a plane that stays as it is, depths in units of
//! mass do not change, so that the pressure is exact.

use super::isentrope::{Isentrope, too_hot, too_much};
use crate::error::{Error, Result};
use crate::material::eos::Eos;
use crate::scene::geometry::shape::BodyShape;
use crate::scene::tables::body::validated::Body;

const SHEETS: usize = 2000;

/// How high sheets lie and how dense they are, at equal steps of the height without load.
#[derive(Debug, Clone, PartialEq)]
pub struct Slab {
    /// The axis across its faces.
    up: usize,
    /// Lower face, m, and thickness without load, m.
    low: f64,
    thickness: f64,
    /// Height above the lower face, m; `SHEETS + 1` numbers.
    height: Vec<f64>,
    /// kg/m^3.
    density: Vec<f64>,
    /// J/kg.
    energy: Vec<f64>,
}

impl Slab {
    /// The slab of a box under this acceleration, m/s^2; its law has a density without load.
    pub fn new(body: &Body, law: &Eos, uniform: [f64; 3]) -> Result<Self> {
        let up = body.dimension - 1;
        let BodyShape::Box { size } = body.shape else { return Err(Error::new("the body is no box")) };
        let (thickness, low) = (size[up], body.centre[up] - 0.5 * size[up]);
        let step = thickness / SHEETS as f64;
        let isentrope = Isentrope::new(law, body.internal_energy).ok_or_else(|| too_hot(body))?;
        let state = |sheet: usize| {
            let pressure = body.density * -uniform[up] * (thickness - step * sheet as f64);
            isentrope.at(pressure).ok_or_else(|| too_much(pressure))
        };
        let states = (0..=SHEETS).map(state).collect::<Result<Vec<_>>>()?;
        let (density, energy): (Vec<f64>, Vec<f64>) = states.into_iter().unzip();
        let mut height = vec![0.0; SHEETS + 1];
        for k in 1..=SHEETS {
            height[k] = height[k - 1] + 0.5 * step * body.density * (1.0 / density[k] + 1.0 / density[k - 1]);
        }
        Ok(Self { up, low, thickness, height, density, energy })
    }

    /// For what lies at `point` without load, m: the place that it gets, its density, kg/m^3, and its internal energy, J/kg.
    pub fn at(&self, point: [f64; 3]) -> ([f64; 3], f64, f64) {
        let place = ((point[self.up] - self.low) / self.thickness * SHEETS as f64).clamp(0.0, SHEETS as f64);
        let below = (place as usize).min(SHEETS - 1);
        let part = place - below as f64;
        let between = |values: &[f64]| values[below] + part * (values[below + 1] - values[below]);
        let mut moved = point;
        moved[self.up] = self.low + between(&self.height);
        (moved, between(&self.density), between(&self.energy))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    /// Each sheet carries what lies above, and no mass is lost: rho dheight = rho_0 dz.
    #[test]
    fn sheets_carry_what_lies_above() {
        let text = "dimension = 2\n[[body]]\nname = \"ground\"\nshape = { box = { size = [10e3, 50e3] } }\nposition = [5e3, 0]\n\
                    material = \"basalt\"\nspacing = 1e3\nstart = \"hydrostatic\"\n[domain]\nperiodic = { x = [0, 10e3] }\n\
                    [gravity]\nuniform = [2, -10]\n[run]\nuntil = 1\n";
        let scene = Scene::parse("s.toml", text, &[]).unwrap();
        let law = scene.materials[0].eos.law();
        let slab = Slab::new(&scene.bodies[0], &law, [2.0, -10.0, 0.0]).unwrap();
        for y in [-20e3, 0.0, 20e3] {
            let ([x, height, _], density, energy) = slab.at([3e3, y, 0.0]);
            let (p, expected) = (law.pressure(density, energy).0, 2700.0 * 10.0 * (25e3 - y));
            assert!((p / expected - 1.0).abs() < 1e-5 && x == 3e3, "{p} {expected}");
            let rise = slab.at([0.0, y + 50.0, 0.0]).0[1] - slab.at([0.0, y - 50.0, 0.0]).0[1];
            assert!((rise * density / (100.0 * 2700.0) - 1.0).abs() < 1e-5 && height < y);
        }
        assert_eq!(slab.at([0.0, -25e3, 0.0]).0[1], -25e3);
    }
}
