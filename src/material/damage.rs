//! The column of damage, and its effect on the acting stress. Fracture makes it grow (see `fracture`); strength with friction
//! reads it before, as broken rock yields at less (see `strength`); the pair sums use the weakened stress.

use crate::math::{Deviator, Sym};
use crate::particles::{Column, ColumnInfo, Life, Registry};

/// Name of the column: 0 intact to 1 broken.
pub const DAMAGE: &str = "damage";

/// Declares the column, or finds it: strength with friction needs it before fracture does.
pub fn damage_column(registry: &mut Registry) -> Column<f64> {
    registry.find(DAMAGE).unwrap_or_else(|| {
        let about = "Damage, 0 intact to 1 broken.";
        let info = ColumnInfo { name: DAMAGE, unit: "", about, life: Life::State, snapshot: true };
        registry.owner("fracture").column(info)
    })
}

/// The stress that acts, where `s` and `pressure` are those of undamaged matter: (1 - D) S - P_D 1, with P_D = (1 - D)
/// P in tension and P in compression (Jutzi et al. 2008, eq. 36, for tension). With `friction` the yield strength of S accounts for
/// damage already (Jutzi 2015, see `strength`). The pair sums and their energy use this stress.
#[inline]
pub fn damaged_stress(s: &Deviator, pressure: f64, damage: f64, friction: bool) -> Sym {
    s.with_mean(if friction { 1.0 } else { 1.0 - damage }, -damaged_pressure(pressure, damage))
}

/// P_D alone: broken matter bears no tension.
#[inline]
pub fn damaged_pressure(pressure: f64, damage: f64) -> f64 {
    if pressure < 0.0 { (1.0 - damage) * pressure } else { pressure }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The stress that damage leaves: all of it at D = 0, compression alone at D = 1.
    #[test]
    fn broken_matter_cannot_pull() {
        let s = Deviator { xx: 3.0, yy: -1.0, xy: 0.5, xz: 0.2, yz: -0.7 };
        assert_eq!(damaged_stress(&s, -5.0, 1.0, false), Sym::ZERO);
        assert_eq!(damaged_stress(&s, 5.0, 1.0, false), Sym { xx: -5.0, yy: -5.0, zz: -5.0, ..Sym::ZERO });
        assert_eq!(damaged_stress(&s, 5.0, 0.0, false), s.with_mean(1.0, -5.0));
        assert_eq!(damaged_stress(&s, -4.0, 0.5, false), s.with_mean(0.5, 2.0));
        // With friction the yield strength has taken from the deviator what damage takes.
        assert_eq!(damaged_stress(&s, 5.0, 1.0, true), s.with_mean(1.0, -5.0));
        assert_eq!(damaged_stress(&s, -4.0, 0.5, true), s.with_mean(1.0, 2.0));
    }
}
