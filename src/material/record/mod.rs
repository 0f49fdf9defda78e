//! Records: the largest values that a particle has reached, each requested by its key in `[record]`.
//!
//! ```text
//! peak pressure     max P over all steps
//! melt fraction     largest of clamp((u - u_melt) / (E_iv - u_melt), 0, 1); a step at E_iv without melting strength
//! vapour fraction   largest of clamp((u - E_iv) / (E_cv - E_iv), 0, 1)
//! ```
//! P pressure, Pa; u specific internal energy, u_melt energy at which strength is gone (`strength.melting`), E_iv and
//! E_cv energies of incipient and complete vaporisation (Tillotson), J/kg. Matter that turned into vapour counts as
//! melted too.
//!
//! Columns: owns `peak_pressure`, `melt_fraction`, `vapour_fraction`. Time step: none.

mod table;

use super::{Core, Diagnostic, Local, MaterialEffect, MaterialTable, PerBody, Setup, eos};
use crate::error::Result;
use crate::particles::{Column, ColumnInfo, Columns, Life, Registry, View};
pub use table::Records;

/// Energies between which a share rises from 0 to 1, J/kg.
#[derive(Debug, Clone, Copy)]
struct Rise {
    begins: f64,
    complete: f64,
}

impl Rise {
    fn melting(material: &MaterialTable) -> Option<Self> {
        let [e_iv, _] = material.eos.law().vaporisation()?;
        let melting = material.strength.as_ref().and_then(|strength| strength.melting);
        Some(Self { begins: melting.map_or(e_iv, |melting| melting.energy.0.min(e_iv)), complete: e_iv })
    }

    fn vaporisation(material: &MaterialTable) -> Option<Self> {
        let [begins, complete] = material.eos.law().vaporisation()?;
        Some(Self { begins, complete })
    }

    #[inline]
    fn share(&self, u: f64) -> f64 {
        if u >= self.complete {
            1.0
        } else if u > self.begins {
            (u - self.begins) / (self.complete - self.begins)
        } else {
            0.0
        }
    }
}

/// Largest molten or vaporised share so far.
struct Share {
    record: Column<f64>,
    rises: PerBody<Rise>,
    /// Mass that has changed phase.
    diagnostic: Diagnostic,
}

/// Name of the column of the largest pressure.
pub const PEAK_PRESSURE: &str = "peak_pressure";

/// The columns that the scene requests.
pub struct Record {
    /// Where a record depends on it.
    energy: Option<Column<f64>>,
    pressure: Column<f64>,
    peak_pressure: Option<Column<f64>>,
    shares: Vec<Share>,
}

/// Raises a record to `value`.
#[inline]
fn raise(record: &View<f64>, i: usize, value: f64) {
    if value > record.get(i) {
        record.set(i, value);
    }
}

impl MaterialEffect for Record {
    fn declare(setup: &Setup, registry: &mut Registry, core: &Core) -> Result<Option<Self>> {
        let records = setup.records;
        if records == Records::default() {
            return Ok(None);
        }
        let heat = records.melt_fraction || records.vapour_fraction;
        let energy = heat.then(|| registry.need("record", eos::INTERNAL_ENERGY)).transpose()?;
        registry.owner("record");
        let mut column =
            |name, unit, about| registry.column(ColumnInfo { name, unit, about, life: Life::State, snapshot: true });
        let peak_pressure = records.peak_pressure.then(|| column(PEAK_PRESSURE, "Pa", "Largest pressure so far."));
        let mut shares = Vec::new();
        if records.melt_fraction {
            shares.extend(PerBody::new(setup, |_, material| Rise::melting(material)).map(|rises| Share {
                record: column("melt_fraction", "", "Largest molten fraction so far."),
                rises,
                diagnostic: Diagnostic { name: "melted_mass", unit: "kg" },
            }));
        }
        if records.vapour_fraction {
            shares.extend(PerBody::new(setup, |_, material| Rise::vaporisation(material)).map(|rises| Share {
                record: column("vapour_fraction", "", "Largest vaporised fraction so far."),
                rises,
                diagnostic: Diagnostic { name: "vaporised_mass", unit: "kg" },
            }));
        }
        Ok(Some(Self { energy, pressure: core.pressure, peak_pressure, shares }))
    }

    fn name(&self) -> &'static str {
        "record"
    }

    fn commit(&self, local: &Local) {
        if let Some(peak) = self.peak_pressure.map(|column| local.view(column)) {
            let pressure = local.view(self.pressure);
            (0..local.len()).for_each(|i| raise(&peak, i, pressure.get(i)));
        }
        let energy = local.optional(self.energy);
        for share in &self.shares {
            let record = local.view(share.record);
            for (rise, range) in share.rises.runs(local) {
                range.for_each(|i| raise(&record, i, rise.share(energy.get(i))));
            }
        }
    }

    fn diagnostics(&self) -> Vec<Diagnostic> {
        self.shares.iter().map(|share| share.diagnostic).collect()
    }

    fn diagnose(&self, columns: &Columns, i: usize, _body: usize, mass: f64, add: &mut dyn FnMut(usize, f64)) {
        for (k, share) in self.shares.iter().enumerate() {
            add(k, mass * columns.get(share.record, i));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::{Rig, basalt, gas, without_fracture};
    use super::*;
    use crate::math::Mat3;

    const ALL: Records = Records { peak_pressure: true, melt_fraction: true, vapour_fraction: true };

    #[test]
    fn records_keep_the_largest_value() {
        let mut rig = Rig::with_records(vec![without_fracture(basalt())], ALL, 0.0);
        let energy = rig.column(eos::INTERNAL_ENERGY);
        let names = ["peak_pressure", "melt_fraction", "vapour_fraction"];
        let read = |rig: &Rig| names.map(|name| rig.get(rig.column::<f64>(name)));
        // u_melt = 3.4e6, E_iv = 4.72e6, E_cv = 18.2e6 J/kg.
        for (u, melt, vapour) in [(3.4e6, 0.0, 0.0), (4.06e6, 0.5, 0.0), (11.46e6, 1.0, 0.5), (2e7, 1.0, 1.0)] {
            rig.set(energy, u);
            rig.step(&Mat3::zeros(), 0.0);
            let [pressure, melted, vaporised] = read(&rig);
            assert_eq!(pressure, rig.get(rig.core.pressure));
            assert!((melted - melt).abs() < 1e-15 && (vaporised - vapour).abs() < 1e-15, "{u} {melted} {vaporised}");
        }
        let before = read(&rig);
        rig.set(energy, 0.0);
        rig.step(&Mat3::zeros(), 0.0);
        assert_eq!(read(&rig), before);

        let mut sums = [0.0; 2];
        rig.effects.last().unwrap().diagnose(&rig.columns, 0, 0, 2700.0, &mut |k, value| sums[k] += value);
        assert_eq!(sums, [2700.0; 2]);
    }

    #[test]
    fn melting_is_a_step_where_strength_does_not_melt() {
        let material = MaterialTable { strength: None, ..without_fracture(basalt()) };
        let rise = Rise::melting(&material).unwrap();
        assert_eq!([4.71e6, 4.72e6].map(|u| rise.share(u)), [0.0, 1.0]);
    }

    #[test]
    fn nothing_exists_unless_asked_for() {
        assert!(Rig::new(gas()).effects.iter().all(|effect| effect.name() != "record"));
        let pressure_only = Records { peak_pressure: true, ..Records::default() };
        let rig = Rig::with_records(vec![basalt()], pressure_only, 0.0);
        assert!(rig.columns.registry.find::<f64>("peak_pressure").is_some());
        assert!(rig.columns.registry.find::<f64>("melt_fraction").is_none());
        assert!(ALL.validate(&[gas()]).is_err() && ALL.validate(&[gas(), basalt()]).is_ok());
    }
}
