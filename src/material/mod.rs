//! Material effects: local physics of one particle, one file each. An effect opens with its equations and their source,
//! holds the table by which a scene requests it, declares the columns it owns, and acts on chunks.
//!
//! Sign conventions, stated once: stress is positive in tension, pressure positive in compression, sigma = S - P 1;
//! L[(a, b)] = d v_a / d x_b.

pub mod damage;
pub mod late;
pub mod particle_view;
pub mod setup;
#[cfg(test)]
mod testing;
pub mod viscosity;

use crate::error::Result;
use crate::math::{Mat3, Vec3};
use crate::particles::{Chunk, Column, Columns, Element, Integrated, ParticleId, Rates, Registry, View};
pub use late::Late;
pub use particle_view::{ParticleView, Viscosity};
pub use record::Records;
pub use setup::{PerBody, Setup, Table};

/// From the one list of material effects follow their modules, the fields of [`MaterialTable`] and [`effects`].
macro_rules! material_effects {
    ($($(#[$about:meta])* $module:ident::$effect:ident $({ $(#[$key:meta])* $field:ident: $table:ty })?;)*) => {
        $($(#[$about])* pub mod $module;)*

        /// A material as a scene describes it: one table per effect, absent where the material does without it.
        #[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
        #[serde(deny_unknown_fields)]
        pub struct MaterialTable {
            $($($(#[$key])* pub $field: $table,)?)*
            /// Artificial viscosity between particles; off with `false`.
            pub viscosity: Option<viscosity::ViscosityTable>,
        }

        impl MaterialTable {
            /// Checks every table; `place` names the material in messages, `material.basalt`.
            pub fn validate(&self, place: &str) -> Result<()> {
                $($(self.$field.validate(&format!("{place}.{}", stringify!($field)), self)?;)?)*
                self.viscosity.validate(&format!("{place}.viscosity"), self)
            }
        }

        /// The columns of every scene and the effects that its materials request, in the order in which they act.
        ///
        /// # Errors
        /// Where one needs what the others do not provide.
        pub fn effects(setup: &Setup, registry: &mut Registry) -> Result<(Core, Vec<Box<dyn MaterialEffect>>)> {
            let core = declare_core(registry);
            let mut effects: Vec<Box<dyn MaterialEffect>> = Vec::new();
            $(if let Some(effect) = $module::$effect::declare(setup, registry, &core)? {
                effects.push(Box::new(effect));
            })*
            Ok((core, effects))
        }
    };
}

// Every material effect there is: file and type, and the table that requests it. They act in this order, so an effect
// may use what those above it have brought up to date.
material_effects! {
    /// Density follows the flow.
    density::Continuity;
    /// Pressure from density and internal energy.
    eos::EquationOfState {
        /// Equation of state; keys left out come from the library if the law is the same.
        eos: eos::EosTable
    };
    /// Pressure and reference density of highly porous dust.
    dust::Dust;
    /// Pores below the resolution; sets the pressure of porous bodies.
    porosity::Porosity {
        /// Pores below the resolution.
        porosity: Option<porosity::PorosityTable>
    };
    /// Resistance to shear.
    strength::Strength {
        /// Resistance to shear.
        strength: Option<strength::StrengthTable>
    };
    /// Damage by the growth of flaws.
    fracture::Fracture {
        /// Damage by the growth of flaws; needs strength.
        fracture: Option<fracture::FractureTable>
    };
    /// The largest values that a particle has seen.
    record::Record;
    /// Smoothing length that follows density.
    smoothing_length::SmoothingLength;
}

impl MaterialTable {
    /// Density without load, kg/m^3; a gas has none.
    pub fn reference_density(&self) -> Option<f64> {
        self.eos.law().reference_density()
    }

    /// Longitudinal speed of sound at a density of the matrix, kg/m^3, and internal energy, J/kg; m/s. Rigid pores do not change it.
    pub fn sound_speed(&self, density: f64, energy: f64) -> f64 {
        let (_, bulk) = self.eos.law().pressure(density, energy);
        let shear = self.moduli(density).map_or(0.0, |[_, shear]| shear);
        (bulk * bulk + 4.0 / 3.0 * shear / density).sqrt()
    }

    /// Matter of this viscosity that resists compression alone, by P = c^2 (rho - rho_0) from `density`, kg/m^3, on, c = `sound_speed`,
    /// m/s: that of a contact between rigid bodies. Whatever effects there are, it has no other.
    pub fn of_contact(&self, density: f64, sound_speed: f64) -> Self {
        let number = |x: f64| crate::units::Number::new(x);
        let law = eos::murnaghan::MurnaghanTable {
            rho_0: crate::units::Density::new(density),
            modulus: crate::units::Pressure::new(density * sound_speed * sound_speed),
            n: number(1.0),
        };
        let bare = toml::from_str("eos = { ideal_gas = { gamma = 2 } }").expect("a material of one table");
        let viscosity = self.viscosity.map(|table| viscosity::ViscosityTable { speed: Default::default(), ..table });
        Self { eos: eos::EosTable::Murnaghan(law), viscosity, ..bare }
    }

    /// Whether it bears shear.
    pub fn has_strength(&self) -> bool {
        self.strength.is_some() || self.is_dust()
    }

    pub fn is_dust(&self) -> bool {
        matches!(self.eos, eos::EosTable::Sirono(_))
    }

    /// Bulk and shear modulus without load, Pa, of matter that has this density, kg/m^3, then; a gas has none.
    pub fn moduli(&self, density: f64) -> Option<[f64; 2]> {
        if let Some(law) = self.dust() {
            let bulk = law.bulk_modulus(density);
            return Some([bulk, 0.5 * bulk]);
        }
        let shear = self.strength.as_ref().map_or(0.0, |strength| strength.shear_modulus.0);
        Some([self.eos.law().bulk_modulus()?, shear])
    }

    /// Whether damage acts on shear through the yield strength alone.
    pub fn has_friction(&self) -> bool {
        self.strength.as_ref().is_some_and(strength::StrengthTable::has_friction)
    }

    /// Distention of its bodies that do not set their own, 1 without pores.
    pub fn distention(&self) -> f64 {
        self.porosity.as_ref().map_or(1.0, |table| table.distention.0)
    }

    /// Whether its strength falls with heat.
    pub fn melts(&self) -> bool {
        self.strength.as_ref().is_some_and(|strength| strength.melting.is_some())
    }

    pub fn has_fracture(&self) -> bool {
        self.fracture.is_some()
    }
}

/// Columns that every scene has.
#[derive(Debug, Clone, Copy)]
pub struct Core {
    pub id: Column<ParticleId>,
    pub position: Column<Vec3>,
    pub velocity: Column<Vec3>,
    /// Position at the last list build; lists and ghosts are based on it until the next.
    pub build_position: Column<Vec3>,
    pub density: Integrated<f64>,
    /// Set by the equation of state, read when pair records are packed.
    pub pressure: Column<f64>,
    /// Longitudinal: the equation of state sets the bulk value, strength stiffens it.
    pub sound_speed: Column<f64>,
}

/// Quantities that are the same for all particles of a body.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct BodyConstants {
    /// Mass of one particle, kg (per metre of depth in 2D).
    pub particle_mass: f64,
    /// Smoothing length at the start, m; the kernel's support is 2h.
    pub smoothing_length: f64,
    /// Particles of the body.
    pub particles: u64,
    /// Density at the start, kg/m^3.
    pub density: f64,
    /// Distention at the start, 1 without pores.
    pub distention: f64,
}

/// The flow around one particle, from the sums over its pairs.
#[derive(Debug, Clone, Copy)]
pub struct LocalFlow {
    /// Velocity gradient, corrected where the scene requests it, 1/s.
    pub velocity_gradient: Mat3,
    /// du/dt by stress and viscosity, the counterpart of the momentum sums, J/(kg s).
    pub heating: f64,
}

/// A chunk as effects see it.
pub struct Local<'a> {
    pub chunk: &'a Chunk<'a>,
    /// Body of each particle.
    pub bodies: &'a [u16],
    pub constants: &'a [BodyConstants],
    /// Flow around each particle; empty outside `rates` and `step_limit`.
    pub flow: &'a [LocalFlow],
    /// Rates of the integrated columns; an effect writes those of its own within `rates`.
    pub rates: &'a Rates,
    /// Seconds since the last commit; only within `commit`.
    pub dt: f64,
}

impl Local<'_> {
    pub fn len(&self) -> usize {
        self.bodies.len()
    }

    pub fn is_empty(&self) -> bool {
        self.bodies.is_empty()
    }

    /// The chunk as stretches of particles of one body, so that what depends on the body is looked up once per stretch.
    pub fn runs(&self) -> impl Iterator<Item = (usize, std::ops::Range<usize>)> + '_ {
        let mut start = 0;
        self.bodies.chunk_by(|a, b| a == b).map(move |run| {
            let range = start..start + run.len();
            start = range.end;
            (run[0] as usize, range)
        })
    }

    #[inline]
    pub fn view<T: Element>(&self, column: Column<T>) -> View<'_, T> {
        self.chunk.view(column)
    }

    /// A column that is absent in some scenes.
    #[inline]
    pub fn optional(&self, column: Option<Column<f64>>) -> OrZero<'_> {
        OrZero(column.map(|column| self.view(column)))
    }

    /// Where an effect writes the rate of a column it owns; starts as zero.
    #[inline]
    pub fn rate<T: Element>(&self, column: Integrated<T>) -> View<'_, T> {
        self.rates.view(column)
    }
}

/// A column that may be absent, and then counts as zero.
pub struct OrZero<'a>(Option<View<'a, f64>>);

impl OrZero<'_> {
    #[inline(always)]
    pub fn get(&self, i: usize) -> f64 {
        self.0.as_ref().map_or(0.0, |view| view.get(i))
    }
}

/// The largest step an effect allows, and for which particle of the chunk.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepLimit {
    pub dt: f64,
    /// Index within the chunk.
    pub particle: usize,
}

/// A diagnostic: a sum over particles, written to history.csv and summary.json.
#[derive(Debug, Clone, Copy)]
pub struct Diagnostic {
    pub name: &'static str,
    pub unit: &'static str,
}

/// Local physics. Methods are called once per chunk; each loops over the particles of the bodies that have the effect.
pub trait MaterialEffect: Send + Sync {
    /// Declares the columns of the effect, or `None` where no material of the scene requests it: then nothing of it
    /// exists.
    ///
    /// # Errors
    /// Where a material requests it, and the effects above do not provide what it needs.
    fn declare(setup: &Setup, registry: &mut Registry, core: &Core) -> Result<Option<Self>>
    where
        Self: Sized;

    fn name(&self) -> &'static str;

    /// Sets the initial state of new particles where it is not zero; called once, when they are made.
    fn initialise(&self, _local: &Local) {}

    /// Rates of the integrated columns at the state of the last pair loop.
    fn rates(&self, _local: &Local) {}

    /// Returns a state that the integrator has moved to the nearest admissible one (yield surface, least density). Must be
    /// idempotent.
    fn admit(&self, _local: &Local) {}

    /// Updates what follows from the state: pressure, sound speed, and changes by load since the last commit. An
    /// integrator may try several states before it accepts one; for each it sets the state columns back first.
    fn update(&self, _local: &Local) {}

    /// Commits irreversible changes (damage, peaks), once for each step that is accepted, after `update`, over
    /// `local.dt`.
    fn commit(&self, _local: &Local) {}

    /// The largest time step, evaluated after `rates` with `local.flow` and new rates at hand.
    fn step_limit(&self, _local: &Local) -> Option<StepLimit> {
        None
    }

    /// Switches to the soft matter of the late stage (see `late`).
    fn soften(&mut self, _late: &Late) {}

    /// Converts the state of particles to the late stage; called once, before the next `update`.
    fn carry_over(&self, _local: &Local, _late: &Late) {}

    /// Sums this effect reports, and particle `i`'s share of each.
    fn diagnostics(&self) -> Vec<Diagnostic> {
        Vec::new()
    }
    fn diagnose(&self, _columns: &Columns, _i: usize, _body: usize, _mass: f64, _add: &mut dyn FnMut(usize, f64)) {}
}

/// Declares the columns of every scene.
pub fn declare_core(registry: &mut Registry) -> Core {
    use crate::particles::{ColumnInfo, Life};
    let state = |name, unit, about| ColumnInfo { name, unit, about, life: Life::State, snapshot: true };
    let kept = |name, unit, about, snapshot| ColumnInfo { name, unit, about, life: Life::Kept, snapshot };
    let scratch = |name, unit, about, snapshot| ColumnInfo { name, unit, about, life: Life::Scratch, snapshot };
    registry.owner("core");
    Core {
        id: registry.column(kept(
            "id",
            "",
            "Global number: body in the upper 16 bits, lattice site in the lower 48.",
            true,
        )),
        position: registry.column(state("position", "m", "Position.")),
        velocity: registry.column(state("velocity", "m/s", "Velocity.")),
        build_position: registry.column(kept("build_position", "m", "Position at the last list build.", false)),
        density: registry.integrated(state("density", "kg/m^3", "Bulk density.")),
        pressure: registry.column(scratch(
            "pressure",
            "Pa",
            "Pressure at the last force evaluation, before damage.",
            true,
        )),
        sound_speed: registry.column(scratch("sound_speed", "m/s", "Longitudinal speed of sound.", false)),
    }
}
