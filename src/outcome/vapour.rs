//! Which matter is vapour, and so has no cohesion: a gas; and vapour by its equation of state. That is matter
//! hotter than the energy of complete vaporisation E_cv, at any density; and matter hotter than that of incipient vaporisation E_iv
//! that is less dense than its solid, rho alpha < rho_0: there Tillotson's formula treats it as a mixture of liquid and gas, which
//! bubbles disrupt. Compressed, such matter is condensed.
//!
//! rho density, kg/m^3; alpha distention; rho_0 reference density of the matrix, kg/m^3.

use crate::material::porosity::DISTENTION;
use crate::material::{Core, MaterialTable, eos};
use crate::particles::{Column, Columns, Registry};

/// When the matter of a body is vapour.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Law {
    Never,
    Always,
    /// E_iv and E_cv, J/kg; rho_0, kg/m^3.
    Beyond([f64; 2], f64),
}

impl Law {
    fn of(material: &MaterialTable) -> Self {
        let law = material.eos.law();
        match (law.reference_density(), law.vaporisation()) {
            (None, _) => Law::Always,
            (Some(rho_0), Some(energies)) => Law::Beyond(energies, rho_0),
            (Some(_), None) => Law::Never,
        }
    }

    fn holds(&self, u: f64, matrix_density: f64) -> bool {
        match self {
            Law::Never => false,
            Law::Always => true,
            Law::Beyond([e_iv, e_cv], rho_0) => u >= *e_cv || (u > *e_iv && matrix_density < *rho_0),
        }
    }
}

/// Detects vapour by the columns of a scene.
pub struct Vapour {
    laws: Vec<Law>,
    energy: Option<Column<f64>>,
    density: Column<f64>,
    distention: Option<Column<f64>>,
}

impl Vapour {
    /// `materials`: one per body.
    pub fn new<'a>(registry: &Registry, core: &Core, materials: impl Iterator<Item = &'a MaterialTable>) -> Self {
        Self {
            laws: materials.map(Law::of).collect(),
            energy: registry.find(eos::INTERNAL_ENERGY),
            density: core.density.value,
            distention: registry.find(DISTENTION),
        }
    }

    /// Damage of particle `i` of `body` for linking fragments: 1 where it is vapour.
    pub fn damage(&self, columns: &Columns, i: usize, body: usize, damage: f64) -> f64 {
        let u = self.energy.map_or(0.0, |column| columns.get(column, i));
        // Bodies without pores have a distention of one.
        let distention = self.distention.map_or(1.0, |column| columns.get(column, i)).max(1.0);
        let is_vapour = self.laws[body].holds(u, columns.get(self.density, i) * distention);
        if is_vapour { 1.0 } else { damage }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vapour_is_hot_and_thin_or_hotter_still() {
        let law = Law::Beyond([2e6, 8e6], 7800.0);
        assert!(!law.holds(1.9e6, 1.0) && !law.holds(7e6, 7900.0));
        assert!(law.holds(2.1e6, 7700.0) && law.holds(8e6, 9e4));
        assert!(Law::Always.holds(0.0, 1.0) && !Law::Never.holds(1e12, 1e-3));
    }
}
