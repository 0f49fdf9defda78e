//! Coefficients of the artificial viscosity, per material. The pair loop holds the formula: for approaching pairs Pi =
//! (-alpha c mu + beta mu^2) / rho, mu = h v.x / (r^2 + 0.01 h^2) (Monaghan & Gingold 1983), with alpha and beta as
//! means over the pair.
//!
//! c is the speed of sound, or, in porous bodies that request it, that of further compression c_l (`porosity`). Where pores collapse
//! this is much lower: weak waves of compaction then keep their width, which with sound c_s would be many times that. Strong shocks
//! need the speed of sound: where matter is compressed within h by more than c_l, waves are no longer those of c_l. So
//!
//! ```text
//! c = c_l + (c_s - c_l) n^2 / (n^2 + c_l^2)     n = 1.5 h max(-div v, 0)
//! ```
//! with div v at the last evaluation.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::MaterialTable;
use super::setup::{Table, none_negative};
use crate::error::{Error, Result};
use crate::particles::{Column, ColumnInfo, Life, Registry};
use crate::units::{Number, Quantity};

/// Name of the column of alpha where matter that touches other matter takes its alpha.
pub const CONTACT_ALPHA: &str = "contact_alpha";

/// Declares alpha of each particle: the largest of its own and those in touch with it (Geretshauser et al. 2010, Sect. 4.4 (3)). In touch
/// is what is in the neighbour list.
pub fn declare_contact(registry: &mut Registry) {
    let about = "alpha of viscosity: the largest of all matter in touch at the last list build.";
    let info = ColumnInfo { name: CONTACT_ALPHA, unit: "", about, life: Life::Kept, snapshot: false };
    registry.owner("viscosity").column::<f64>(info);
}

/// Name of the column of the divergence of velocity.
pub const DIVERGENCE: &str = "divergence";

/// Declares the divergence, for a viscosity that depends on what it was.
pub fn declare_divergence(registry: &mut Registry) -> Column<f64> {
    let about = "Divergence of velocity at the last evaluation.";
    registry.owner("viscosity").column(ColumnInfo {
        name: DIVERGENCE,
        unit: "1/s",
        about,
        life: Life::Kept,
        snapshot: false,
    })
}

/// Name of the column of the share of alpha that a particle has where a switch decides it.
pub const SWITCH: &str = "viscosity_switch";

/// Artificial viscosity between particles.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct ViscosityTable {
    /// Linear in the speed of approach, spreads shocks and damps the noise behind them.
    pub alpha: Number,
    /// Quadratic, keeps particles from passing through each other in strong shocks.
    pub beta: Number,
    /// The speed that `alpha` multiplies.
    pub speed: ViscousSpeed,
}

/// The speed that alpha multiplies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ViscousSpeed {
    /// The speed of sound.
    #[default]
    Sound,
    /// The speed of further compression where pores give way, in waves that are slower than it; that of sound in strong shocks.
    Loading,
}

impl Default for ViscosityTable {
    fn default() -> Self {
        Self { alpha: Quantity(1.5), beta: Quantity(3.0), speed: ViscousSpeed::Sound }
    }
}

impl Table for ViscosityTable {
    fn validate(&self, place: &str, material: &MaterialTable) -> Result<()> {
        if self.speed == ViscousSpeed::Loading && material.porosity.is_none() {
            let error = Error::new("only pores make compression slower than sound").at(format!("{place}.speed"));
            return Err(error.allowed("\"sound\", or a porosity table beside it"));
        }
        none_negative(place, &[("alpha", self.alpha.0), ("beta", self.beta.0)])
    }
}

impl MaterialTable {
    /// alpha and beta; `None` where the scene has no viscosity.
    pub fn viscosity_coefficients(&self) -> Option<[f64; 2]> {
        self.viscosity.map(|table| [table.alpha.0, table.beta.0])
    }

    /// Whether viscosity uses the speed of further compression.
    pub fn has_loading_speed(&self) -> bool {
        self.viscosity.is_some_and(|table| table.speed == ViscousSpeed::Loading)
    }
}

/// n over h |div v|.
const FRONT: f64 = 1.5;

/// The speed that viscosity uses where matter with waves of speed `sound` is further compressed at `loading`, m/s; `inward`: by how much
/// matter approaches within h, m/s.
#[inline]
pub fn speed_in_pores(loading: f64, sound: f64, inward: f64) -> f64 {
    let n = FRONT * inward.max(0.0);
    // Both are zero in matter that is slack.
    let strong = if n > 0.0 { n * n / (n * n + loading * loading) } else { 0.0 };
    loading + (sound - loading) * strong
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weak_waves_have_the_speed_of_loading_and_shocks_that_of_sound() {
        let speed = |inward: f64| speed_in_pores(100.0, 1000.0, inward);
        assert_eq!([speed(0.0), speed(-1e3)], [100.0, 100.0]);
        assert!(speed(1.0) < 101.0 && speed(2000.0) > 999.0);
        assert!((speed(100.0 / FRONT) - 550.0).abs() < 1e-9);
        assert_eq!([speed_in_pores(0.0, 0.0, 0.0), speed_in_pores(0.0, 5.0, 1.0)], [0.0, 5.0]);
    }

    #[test]
    fn defaults_fill_what_a_scene_leaves_out() {
        let coefficients = |text: &str| toml::from_str::<MaterialTable>(text).unwrap().viscosity_coefficients();
        let gas = "eos = { ideal_gas = { gamma = 1.4 } }\n";
        assert_eq!(coefficients(&format!("{gas}viscosity = {{ beta = 2 }}")), Some([1.5, 2.0]));
        assert_eq!(coefficients(gas), None);
        assert!(toml::from_str::<ViscosityTable>("gamma = 2").is_err());
    }
}
