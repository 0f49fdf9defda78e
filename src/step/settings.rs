//! All settings of a step by the scene, held once, and the state of a run that is not a column of particles.

use serde::{Deserialize, Serialize};

use super::contact::Contact;
use super::integrator::Integrator;
use super::pack::Packer;
use super::packing::DensityRelaxation;
use super::rates::RateSettings;
use super::skin::Skin;
use super::switch::ViscositySwitch;
use crate::gravity::{Attraction, Timing};
use crate::material::{MaterialEffect, ParticleView};
use crate::motion::Motions;
use crate::motion::rigid::{RigidBody, RigidMatter};
use crate::pair::PairLoop;
use crate::particles::{Column, Periods};

/// All settings of a step by the scene.
pub struct StepSettings {
    pub view: ParticleView,
    pub effects: Vec<Box<dyn MaterialEffect>>,
    pub integrator: Box<dyn Integrator>,
    pub packer: Packer,
    pub pair_loop: PairLoop,
    /// Where a scene prescribes how particles move.
    pub motions: Option<Motions>,
    /// Where bodies are rigid.
    pub rigid: Option<RigidMatter>,
    /// Where some of them do not adhere.
    pub contact: Option<Contact>,
    pub gravity: Option<Attraction>,
    /// Where some bodies take smaller steps than the rest.
    pub two_rates: Option<RateSettings>,
    /// The divergence of velocity at the last evaluation, where viscosity depends on it.
    pub divergence: Option<Column<f64>>,
    /// Where a switch decides each particle's share of viscosity.
    pub switch: Option<ViscositySwitch>,
    /// Where density returns to mass over volume.
    pub relaxation: Option<DensityRelaxation>,
    pub periods: Periods,
    /// Courant number.
    pub cfl: f64,
    /// Margin of the neighbour lists.
    pub skin: Skin,
    /// Values with which some particles start whatever effects initialise: those of a file.
    pub presets: Vec<Preset>,
}

/// Values of a column of some particles at the start.
pub struct Preset {
    /// Index of the column.
    pub column: usize,
    /// The first particle.
    pub first: usize,
    pub words: Vec<u64>,
}

impl StepSettings {
    /// Whether the scene prescribes how anything moves.
    pub fn prescribes_motion(&self) -> bool {
        self.motions.is_some() || self.rigid.as_ref().is_some_and(RigidMatter::are_guided)
    }
}

/// The state that later steps depend on beside the columns, the same on every rank. Checkpoint, state hash and summary take it as
/// it is serialised here: a new field is in all of them.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct StepState {
    /// Steps so far.
    pub step: u64,
    /// The one clock: s since the start.
    pub time: f64,
    /// The next step, s.
    pub next: f64,
    /// The last step, s; 0 before the first.
    pub last: f64,
    /// Evaluations with the present lists.
    pub list_age: u64,
    /// When the particles' own gravity was evaluated.
    pub gravity: Timing,
    /// The rigid bodies, where there are any.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub rigid: Vec<RigidBody>,
    /// The longest small step that fast particles allow, s, where there are two rates.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub small: Option<f64>,
}

/// The moment of an evaluation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moment {
    /// s since the start.
    pub time: f64,
    /// The step that it is made for, s.
    pub dt: f64,
    /// Seconds since the first stage of the step before was evaluated, or that of this step, where this is a later one.
    pub since: f64,
    /// Seconds since the particles' own gravity was evaluated.
    pub gravity_age: f64,
    /// Number of the step, from 1 on; 0 before the first.
    pub step: u64,
    /// Number of the stage.
    pub stage: usize,
    /// Whether it is the last stage of its step.
    pub last: bool,
}

/// Counts so far: for the summary, not for later steps.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
pub struct Counters {
    pub list_builds: u64,
    pub rebisections: u64,
    /// Steps that were refused and tried again shorter.
    pub refused: u64,
    /// Small steps of bodies that take these, the last of each large one among them.
    #[serde(default)]
    pub small_steps: u64,
    pub gravity_evaluations: u64,
    /// Particles that left this rank.
    pub migrated: u64,
    /// Directed pairs inside the support, of this rank.
    pub pairs: u64,
    /// Force evaluations of owned particles, of this rank.
    pub updates: u64,
}
