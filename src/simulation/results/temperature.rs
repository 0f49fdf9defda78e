//! Temperature and phase of matter whose equation of state is a table that has them: for snapshots, no step knows them.

use crate::material::eos::tabulated::Tabulated;
use crate::material::eos::{Eos, INTERNAL_ENERGY};
use crate::material::porosity::DISTENTION;
use crate::output::snapshot::Derived;
use crate::simulation::run::Run;

/// Answers of the table of a particle.
type Ask = fn(&Tabulated, f64, f64) -> Option<f64>;

impl<const D: usize> Run<'_, D> {
    /// What the tables of the scene say of its particles beside pressure; of others it is zero.
    pub(in crate::simulation) fn temperatures(&self) -> Vec<Derived> {
        let asked: [(&str, &str, &str, Ask); 2] = [
            (
                "temperature",
                "K",
                "Temperature by the table of the equation of state; zero of other matter.",
                Tabulated::temperature,
            ),
            (
                "phase",
                "",
                "Number of the phase by the table of the equation of state; zero of other matter.",
                Tabulated::phase,
            ),
        ];
        let laws: Vec<Option<Tabulated>> = self.scene.bodies.iter().map(|body| self.table_of(body.material)).collect();
        let (columns, core) = (&self.stepper.columns, &self.stepper.settings.view.core);
        let Some(energy) = columns.registry.find::<f64>(INTERNAL_ENERGY) else { return Vec::new() };
        let distention = columns.registry.find::<f64>(DISTENTION);
        let has = |ask: Ask| laws.iter().flatten().any(|law| ask(law, law.reference_density(), 0.0).is_some());
        let of = |ask: Ask, i: usize| {
            let law = laws[columns.get(core.id, i).body()].as_ref()?;
            let pores = distention.map_or(1.0, |distention| columns.get(distention, i));
            ask(law, pores * columns.get(core.density.value, i), columns.get(energy, i))
        };
        let derived = asked.into_iter().filter(|(.., ask)| has(*ask)).map(|(name, unit, about, ask)| Derived {
            name,
            unit,
            about,
            values: (0..columns.len()).map(|i| of(ask, i).unwrap_or(0.0)).collect(),
        });
        derived.collect()
    }

    fn table_of(&self, material: usize) -> Option<Tabulated> {
        match self.scene.materials[material].eos.law() {
            Eos::Tabulated(law) => Some(law),
            _ => None,
        }
    }
}
