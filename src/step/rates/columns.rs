//! What two rates add to a particle.

use crate::material::eos::INTERNAL_ENERGY;
use crate::math::Vec3;
use crate::particles::{Column, ColumnInfo, Columns, Life, Registry};

/// Two rates as a scene has them.
#[derive(Debug, Clone)]
pub struct RateSettings {
    /// Whether each body is fast.
    pub bodies: Vec<bool>,
    /// Small steps in a large one; by their limits without it.
    pub steps: Option<u32>,
    pub columns: RateColumns,
}

/// Columns of two rates.
#[derive(Debug, Clone)]
pub struct RateColumns {
    /// 1 where a particle takes small steps, 0 elsewhere.
    pub fast: Column<f64>,
    /// The same by the lists at hand, for the steps to come.
    pub near: Column<f64>,
    /// By fast particles on one that is slow, m/s^2; within a step what these have added to its velocity, m/s.
    acceleration: Column<Vec3>,
    /// The same of internal energy, W/kg and J/kg, where there is any.
    heating: Option<Column<f64>>,
    /// Changes of rates over the last step: a slow particle must not predict by those of a small one.
    slopes: Vec<Column<Vec3>>,
}

/// What fast particles give to a slow one: acceleration, m/s^2, and heating, W/kg, or these times a length of time.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Received {
    pub motion: Vec3,
    pub heat: f64,
}

impl Received {
    pub fn times(self, factor: f64) -> Self {
        Self { motion: self.motion * factor, heat: self.heat * factor }
    }

    pub fn plus(self, other: Self) -> Self {
        Self { motion: self.motion + other.motion, heat: self.heat + other.heat }
    }
}

impl RateColumns {
    /// Declares the columns, after those of effects and integrator.
    pub fn declare(registry: &mut Registry) -> Self {
        let slopes = ["jerk", "moment_diagonal_rate", "moment_off_diagonal_rate"];
        let slopes = slopes.iter().filter_map(|name| registry.find(name)).collect();
        let has_heat = registry.find::<f64>(INTERNAL_ENERGY).is_some();
        let kept = |name, unit, about| ColumnInfo { name, unit, about, life: Life::Kept, snapshot: false };
        registry.owner("two_rates");
        let fast = registry.column(kept("fast", "", "1 where a particle takes small steps."));
        let about = "1 where it will after the present step.";
        let near = registry.column(ColumnInfo { life: Life::Scratch, ..kept("near_fast", "", about) });
        let about = "Acceleration by particles that take small steps, at the last evaluation.";
        let acceleration = registry.column(kept("fast_acceleration", "m/s^2", about));
        let about = "Heating by particles that take small steps, at the last evaluation.";
        let heating = has_heat.then(|| registry.column(kept("fast_heating", "W/kg", about)));
        Self { fast, near, acceleration, heating, slopes }
    }

    pub fn received(&self, columns: &Columns, i: usize) -> Received {
        let heat = self.heating.map_or(0.0, |column| columns.get(column, i));
        Received { motion: columns.get(self.acceleration, i), heat }
    }

    pub fn set_received(&self, columns: &mut Columns, i: usize, received: Received) {
        columns.set(self.acceleration, i, received.motion);
        if let Some(heating) = self.heating {
            columns.set(heating, i, received.heat);
        }
    }

    /// The columns that [`RateColumns::received`] reads.
    pub fn targets(&self) -> (Column<Vec3>, Option<Column<f64>>) {
        (self.acceleration, self.heating)
    }

    /// Particles become what the lists at hand make of them.
    pub fn adopt(&self, columns: &mut Columns) {
        for i in 0..columns.len() {
            let [was, is] = [self.fast, self.near].map(|column| columns.get(column, i) != 0.0);
            if was && !is {
                self.slopes.iter().for_each(|&column| columns.set(column, i, Vec3::zeros()));
            }
            columns.set(self.fast, i, f64::from(is));
        }
    }

    /// Nothing is received yet.
    pub fn clear(&self, columns: &mut Columns) {
        (0..columns.len()).for_each(|i| self.set_received(columns, i, Received::default()));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::declare_core;

    #[test]
    fn who_becomes_slow_forgets_the_slopes_of_small_steps() {
        let mut registry = Registry::new(3);
        declare_core(&mut registry);
        let jerk: Column<Vec3> = registry.column(ColumnInfo {
            name: "jerk",
            unit: "m/s^3",
            about: "Of the integrator.",
            life: Life::Kept,
            snapshot: false,
        });
        let rates = RateColumns::declare(&mut registry);
        let mut columns = Columns::new(registry);
        columns.resize(4);
        let slope = Vec3::new(1.0, 2.0, 3.0);
        for (i, (was, is)) in [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (1.0, 1.0)].into_iter().enumerate() {
            columns.set(rates.fast, i, was);
            columns.set(rates.near, i, is);
            columns.set(jerk, i, slope);
        }
        rates.adopt(&mut columns);
        let found = [0, 1, 2, 3].map(|i| (columns.get(rates.fast, i), columns.get(jerk, i)));
        assert_eq!(found, [(0.0, slope), (1.0, slope), (0.0, Vec3::zeros()), (1.0, slope)]);
        // Cold matter has no heat to receive.
        rates.set_received(&mut columns, 1, Received { motion: slope, heat: 5.0 });
        assert_eq!(rates.received(&columns, 1), Received { motion: slope, heat: 0.0 });
        rates.clear(&mut columns);
        assert_eq!(rates.received(&columns, 1), Received::default());
    }
}
