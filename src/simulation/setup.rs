//! From a scene to particles that can be stepped: effects, columns, terms of the pair loop, initial conditions. Every rank
//! makes an equal share of each body's lattice sites; no rank ever holds them all.

use super::handover;
use super::rigid;
use super::scales::free_fall_time_of;
use crate::comparison::modes;
use crate::domain::comm::Comm;
use crate::error::{Error, Result};
use crate::gravity::{self, Attraction, OwnGravity};
use crate::kernel::{CubicSpline, Shape};
use crate::material::eos::{EosTable, INTERNAL_ENERGY};
use crate::material::{self, BodyConstants, Core, MaterialEffect, ParticleView, Setup};
use crate::math::{ExactSum, Vec3};
use crate::motion::rigid::{MovedColumns, RigidMatter};
use crate::motion::{Motions, PrescribedMotion};
use crate::pair::record::{PressureGradient, StressTerm, TensorGradient, ViscousTerm};
use crate::pair::rows::Constants;
use crate::pair::{PairLoop, Terms};
use crate::pair::{artificial_stress, contrast};
use crate::particles::{Column, Columns, ParticleId, Registry};
use crate::scene::{
    Blast, Body, Flow, InitialState, IntegratorRule, Pressed, Scene, SkinRule, SmoothingLengthRule, Until,
};
use crate::step::StepSettings;
use crate::step::contact::Contact;
use crate::step::integrator::{CashKarp, Integrator, PredictorCorrector, RungeKutta};
use crate::step::pack::{Moments, Packer};
use crate::step::packing::DensityRelaxation;
use crate::step::rates::{RateColumns, RateSettings};
use crate::step::skin::{Limits, Skin};
use crate::step::slopes::Slopes;
use crate::step::switch::ViscositySwitch;

/// Effects, columns and settings of a scene, before any particle exists.
pub struct Plan {
    pub registry: Registry,
    pub view: ParticleView,
    pub effects: Vec<Box<dyn MaterialEffect>>,
    pub integrator: Box<dyn Integrator>,
    pub terms: Terms,
    pub constants: Vec<BodyConstants>,
    pub motions: Option<Motions>,
    pub rigid: Option<RigidMatter>,
    pub contact: Option<Contact>,
    pub gravity: Option<Attraction>,
    pub two_rates: Option<RateSettings>,
    pub skin: Skin,
    pub divergence: Option<Column<f64>>,
    pub switch: Option<ViscositySwitch>,
    pub relaxation: Option<DensityRelaxation>,
}

/// Number of particles from which on a body's volume gives their number as well as a count.
const MANY: f64 = 1e7;

/// Numbers of particles by volume, without counting lattice sites, where there are many; `None` where they are few. Rows that end
/// at a surface make a difference of less than a spacing over the body's size.
pub fn expected_particles(scene: &Scene) -> Option<Vec<BodyConstants>> {
    let expected = |body: &Body| body.expected_particles().round().max(1.0);
    if scene.bodies.iter().map(expected).sum::<f64>() < MANY {
        return None;
    }
    let constants = scene.bodies.iter().map(|body| body.constants(expected(body) as u64, scene.numerics.eta));
    Some(constants.collect())
}

/// Counts the particles of each body, each rank its share of the lattice sites. Collective.
pub fn count_particles(scene: &Scene, comm: &Comm) -> Result<Vec<BodyConstants>> {
    let mine = scene.bodies.iter().map(|body| match &body.given {
        Some(given) => {
            if comm.is_root() {
                given.particles as i64
            } else {
                0
            }
        }
        None => body.count(comm.share(body.lattice_sites())) as i64,
    });
    let mut counts: Vec<i64> = mine.collect();
    comm.all_sum(&mut counts);
    let constants = scene.bodies.iter().zip(&counts).map(|(body, &count)| {
        if count == 0 {
            let what = format!("body `{}` has no particles: no lattice site lies inside its shape", body.name);
            let error = Error::new(what).at(scene.path()).allowed("a smaller spacing, or more particles");
            return Err(error.bad_input());
        }
        Ok(body.constants(count as u64, scene.numerics.eta))
    });
    constants.collect()
}

/// Declares an effect from outside the program, see [`plan_with`].
pub type Declare<'a> = &'a dyn Fn(&Setup, &mut Registry, &Core) -> Result<Option<Box<dyn MaterialEffect>>>;

/// Declares columns and effects for bodies with these constants.
///
/// # Errors
/// Where an effect needs a column or effect that is missing.
pub fn plan(scene: &Scene, constants: Vec<BodyConstants>) -> Result<Plan> {
    plan_with(scene, constants, &[])
}

/// [`plan`] with further effects, which act after those of the program in their order.
///
/// # Errors
/// Where an effect needs a column or effect that is missing.
pub fn plan_with(scene: &Scene, constants: Vec<BodyConstants>, more: &[Declare]) -> Result<Plan> {
    let mut registry = Registry::new(scene.dimension);
    let matter = rigid::matter(scene);
    let smoothing_length = match scene.numerics.smoothing_length {
        SmoothingLengthRule::Constant => None,
        SmoothingLengthRule::FollowsDensity { smallest, largest } => {
            Some(material::setup::Bounds { smallest, largest })
        }
    };
    let setup = Setup {
        dimension: scene.dimension,
        materials: &matter.materials,
        body_material: &matter.of_body,
        constants: &constants,
        initial_damage: &matter.damage,
        records: scene.record,
        smoothing_length,
    };
    let here = |e: Error| e.at(scene.path()).bad_input();
    let (core, mut effects) = material::effects(&setup, &mut registry).map_err(here)?;
    for declare in more {
        effects.extend(declare(&setup, &mut registry, &core).map_err(here)?);
    }
    check_heat(scene, &registry)?;
    if scene.numerics.contact_viscosity {
        material::viscosity::declare_contact(&mut registry);
    }
    let switch = scene.numerics.viscosity_switch.map(|floor| ViscositySwitch::declare(&mut registry, floor));
    let by_loading = matter.materials.iter().any(material::MaterialTable::has_loading_speed);
    let divergence = (switch.is_some() || by_loading).then(|| material::viscosity::declare_divergence(&mut registry));
    let (beyond, eta) = (scene.numerics.density_relaxation, scene.numerics.eta);
    let relaxation = beyond.map(|beyond| DensityRelaxation::declare(&mut registry, beyond, eta));
    let mut view = ParticleView::new(&setup, &registry, core);
    (view.rigid, view.standing) = (matter.rigid, matter.standing);
    let masses: Vec<f64> = constants.iter().map(|body| body.particle_mass).collect();
    let motions = Motions::declare(
        scene
            .bodies
            .iter()
            .map(|body| if body.rigid.is_some() { PrescribedMotion::Free } else { body.motion })
            .collect(),
        scene.layers.iter().map(|layer| layer.motion).collect(),
        masses.clone(),
        &mut registry,
    );
    let moved = MovedColumns { id: core.id, position: core.position, velocity: core.velocity };
    let rigid = RigidMatter::declare(rigid::starts(scene), masses, scene.periods, &mut registry, moved);
    let gravity = scene.gravity.any().then(|| Attraction {
        uniform: Vec3::from(scene.gravity.uniform.unwrap_or_default()),
        rounds: falls_round(scene).then(|| (gravity::declare_rounds(&mut registry), Vec3::from(scene.periods.length))),
        own: scene.gravity.own.map(|own| {
            let densest = constants.iter().map(|body| body.density).fold(0.0, f64::max);
            OwnGravity::declare(&mut registry, own.accuracy, own.interval * free_fall_time_of(densest))
        }),
    });
    let terms = terms(scene, &view);
    if terms.angular_momentum() {
        Moments::declare(&mut registry);
    }
    if scene.numerics.reconstruction {
        Slopes::declare(&mut registry);
    }
    let contact = view.standing.contains(&contrast::LOOSE).then(|| Contact::declare(&mut registry));
    let skin = skin(scene, &mut registry);
    let integrator = integrator(scene, &mut registry, &view)?;
    let two_rates = scene.two_rates.as_ref().map(|rates| RateSettings {
        bodies: rates.fast.clone(),
        steps: rates.steps,
        columns: RateColumns::declare(&mut registry),
    });
    Ok(Plan {
        registry,
        view,
        effects,
        integrator,
        terms,
        constants,
        motions,
        rigid,
        contact,
        gravity,
        two_rates,
        skin,
        divergence,
        switch,
        relaxation,
    })
}

/// Refuses what a scene says about heat where every law of its matter is cold: it would be lost, or never found.
fn check_heat(scene: &Scene, registry: &Registry) -> Result<()> {
    let is_cold = registry.find::<f64>(INTERNAL_ENERGY).is_none();
    let settles = scene.run.until == Until::Settled || scene.late_stage.is_some_and(|late| late.at == Until::Settled);
    if is_cold && settles {
        let error =
            scene.error("run.until", "an impact settles by its internal energy, which cold matter does not have");
        return Err(error.allowed("a time, or an equation of state with an internal energy"));
    }
    let heated = scene.bodies.iter().find(|body| body.internal_energy != 0.0 || body.blast.is_some());
    match heated.filter(|_| is_cold) {
        Some(body) => {
            Err(Error::new(format!("body `{}` starts with heat, but pressure depends on density alone", body.name))
                .at(scene.path())
                .allowed("an equation of state with an internal energy, or no heat")
                .bad_input())
        }
        None => Ok(()),
    }
}

/// How steps are made; it is declared last, as it has to know all that is integrated.
fn integrator(scene: &Scene, registry: &mut Registry, view: &ParticleView) -> Result<Box<dyn Integrator>> {
    registry.owner("integrator");
    Ok(match &scene.numerics.integrator {
        IntegratorRule::PredictorCorrector => Box::new(PredictorCorrector::declare(registry, &view.core)),
        IntegratorRule::RungeKutta { tolerance } => Box::new(RungeKutta::declare(registry, &view.core, *tolerance)),
        IntegratorRule::CashKarp { tolerance, tolerances } => {
            let of = |name: &str| *tolerances.get(name).unwrap_or(tolerance);
            let integrator = CashKarp::declare(registry, view, of);
            let known = integrator.controlled_names();
            if let Some(name) = tolerances.keys().find(|name| !known.contains(&name.as_str())) {
                let path = format!("numerics.integrator.cash_karp.tolerances.{name}");
                let error = scene.error(&path, format!("this scene has no error of `{name}`"));
                return Err(error.allowed(known.join(", ")));
            }
            Box::new(integrator)
        }
    })
}

/// The terms of the pair loop.
fn terms(scene: &Scene, view: &ParticleView) -> Terms {
    let numerics = &scene.numerics;
    let artificial = numerics.artificial_stress.is_some();
    let (corrected, contrast) = (numerics.corrected_gradient, numerics.density_contrast);
    // Pressure alone acts along the line between two particles.
    let angular_momentum = numerics.angular_momentum;
    // The strength of a material that only rigid bodies have does not count.
    let deforms = |material: usize| {
        let mut bodies = scene.bodies.iter().filter(|body| body.material == material).peekable();
        bodies.peek().is_none() || bodies.any(|body| body.rigid.is_none())
    };
    let tensor = artificial || scene.materials.iter().enumerate().any(|(k, m)| m.has_strength() && deforms(k));
    let betas: Vec<f64> = (0..scene.bodies.len()).map(|body| view.material_viscosity(body).beta).collect();
    Terms {
        stress: match (tensor, corrected) {
            (false, false) => StressTerm::Pressure { gradient: PressureGradient::Plain },
            (false, true) => StressTerm::Pressure { gradient: PressureGradient::Corrected { contrast } },
            (true, false) => StressTerm::Tensor { artificial, gradient: TensorGradient::Plain },
            (true, true) => {
                StressTerm::Tensor { artificial, gradient: TensorGradient::Corrected { contrast, angular_momentum } }
            }
        },
        viscosity: match (numerics.viscosity, betas.windows(2).all(|pair| pair[0] == pair[1])) {
            (false, _) => ViscousTerm::Off,
            _ if numerics.reconstruction => ViscousTerm::Reconstructed,
            (true, true) => ViscousTerm::SameBeta,
            (true, false) => ViscousTerm::OwnBeta,
        },
    }
}

/// The margin of neighbour lists.
fn skin(scene: &Scene, registry: &mut Registry) -> Skin {
    match scene.numerics.skin {
        SkinRule::Fixed(skin) => Skin::Fixed(skin),
        SkinRule::Auto => Skin::own(skin_limits(scene), registry),
    }
}

/// What bounds skins that particles have of their own.
pub fn skin_limits(scene: &Scene) -> Limits {
    let (rule, periodic, dimension) = (scene.numerics.skin, scene.periods.any(), scene.dimension);
    Limits { first: rule.first(), of_cells: rule.of_cells(), widest: rule.widest(periodic), dimension }
}

/// Whether uniform gravity acts along a period.
fn falls_round(scene: &Scene) -> bool {
    let uniform = scene.gravity.uniform.unwrap_or_default();
    (0..scene.dimension).any(|axis| scene.periods.closed(axis) && uniform[axis] != 0.0)
}

impl Plan {
    /// New particles of this rank's share of every body, and the settings of their steps.
    pub fn populate(self, scene: &Scene, comm: &Comm) -> Result<(Columns, StepSettings)> {
        let core = self.view.core;
        let mut columns = Columns::new(self.registry.clone());
        let internal_energy = self.registry.find::<f64>(INTERNAL_ENERGY);
        let damage = self.registry.find::<f64>(material::damage::DAMAGE);
        for (number, body) in scene.bodies.iter().enumerate() {
            let mode = match body.flow {
                Some(Flow::Mode { shape, speed }) => Some((modes::ModeShape::new(scene, body, shape)?, speed)),
                _ => None,
            };
            let pressed = match body.start {
                InitialState::Hydrostatic => {
                    let uniform = scene.gravity.uniform.unwrap_or_default();
                    let pressed = Pressed::new(body, &scene.materials[body.material].eos.law(), uniform);
                    Some(pressed.map_err(|e| e.at(format!("{}: body {}", scene.path(), body.name)).bad_input())?)
                }
                InitialState::Unloaded => None,
            };
            let sites = comm.share(body.lattice_sites());
            let count = body.count(sites.clone()) as usize;
            let first = columns.len();
            columns.resize(first + count);
            for (i, (site, position)) in (first..).zip(body.sites(sites)) {
                columns.set(core.id, i, ParticleId::new(number, site));
                columns.set(core.position, i, Vec3::from(position));
                let held = scene.layers.iter().position(|layer| layer.holds(body.whole(number), position));
                let held = held.filter(|_| body.rigid.is_none());
                let motion = held.map_or(body.motion, |layer| scene.layers[layer].motion);
                let mut velocity = body.velocity_at(position);
                if let Some((mode, speed)) = &mode {
                    let swing = mode.velocity(std::array::from_fn(|k| position[k] - body.centre[k]));
                    (0..3).for_each(|k| velocity[k] += speed * swing[k]);
                }
                columns.set(core.velocity, i, Vec3::from(motion.start(velocity)));
                if let Some(layer) = self.motions.as_ref().and_then(|motions| motions.layer) {
                    columns.set(layer, i, held.map_or(0.0, |layer| (layer + 1) as f64));
                }
                columns.set(core.density.value, i, body.density);
                let breaks = scene.materials[body.material].has_fracture() && body.rigid.is_none();
                if let Some(damage) = damage.filter(|_| breaks) {
                    columns.set(damage, i, body.damage_at(position));
                }
                let mut energy = body.internal_energy;
                if let EosTable::IdealGas(gas) = &scene.materials[body.material].eos {
                    energy += body.flow_pressure(position) / (gas.gamma.0 - 1.0);
                }
                if let Some(pressed) = &pressed {
                    let (place, density, pressed_in) = pressed.at(position);
                    columns.set(core.position, i, Vec3::from(place));
                    columns.set(core.density.value, i, density);
                    energy = pressed_in;
                }
                if let Some(u) = internal_energy {
                    columns.set(u, i, energy);
                }
            }
            if let (Some(blast), Some(u)) = (body.blast, internal_energy) {
                let heated = Heated { body, blast: &blast, particle_mass: self.constants[number].particle_mass };
                heated.heat(&mut columns, first, core.position, u, comm);
            }
        }
        let layer = self.motions.as_ref().and_then(|motions| motions.layer);
        let presets = handover::take(scene, &core, layer, &mut columns, comm)?;
        Ok((columns, StepSettings { presets, ..self.settings(scene) }))
    }

    /// The settings of steps for particles from a checkpoint.
    pub fn settings(self, scene: &Scene) -> StepSettings {
        let numerics = &scene.numerics;
        // The coarsest lattice counts, as measured by its smoothing length.
        let in_spacings =
            |(body, constants): (&Body, &BodyConstants)| constants.smoothing_length / body.lattice.spacing;
        let h = scene.bodies.iter().zip(&self.constants).map(in_spacings).fold(f64::INFINITY, f64::min);
        let constants = Constants {
            beta: self.view.material_viscosity(0).beta,
            artificial_reference: artificial_stress::reference(numerics.kernel, h),
        };
        let pair_loop = PairLoop::new(scene.dimension, self.terms, numerics.kernel, constants);
        let epsilon = numerics.artificial_stress.map_or(0.0, |artificial| artificial.factor);
        StepSettings {
            packer: Packer::new(&self.registry, &self.view, pair_loop.layout(), epsilon, numerics.eta),
            view: self.view,
            effects: self.effects,
            integrator: self.integrator,
            motions: self.motions,
            rigid: self.rigid,
            contact: self.contact,
            gravity: self.gravity,
            periods: scene.periods,
            two_rates: self.two_rates,
            divergence: self.divergence,
            switch: self.switch,
            relaxation: self.relaxation,
            pair_loop,
            cfl: numerics.cfl,
            skin: self.skin,
            presets: Vec::new(),
        }
    }
}

/// A body that a blast heats.
struct Heated<'a> {
    body: &'a Body,
    blast: &'a Blast,
    /// kg.
    particle_mass: f64,
}

impl Heated<'_> {
    /// Adds the energy of the blast to the particles from `first` on, those of the body; the sum over all ranks is exact to
    /// rounding. Collective.
    fn heat(&self, columns: &mut Columns, first: usize, position: Column<Vec3>, energy: Column<f64>, comm: &Comm) {
        let h = self.blast.smoothing_length();
        let shares: Vec<f64> = (first..columns.len())
            .map(|i| {
                let r = columns.get(position, i) - Vec3::from(self.body.centre);
                CubicSpline::value(r.norm() / h)
            })
            .collect();
        let mut sum = ExactSum::new();
        shares.iter().for_each(|share| sum.add(*share));
        let total = comm.sum_exactly(std::slice::from_mut(&mut sum))[0];
        for (i, share) in (first..).zip(shares) {
            let added = self.blast.energy / self.particle_mass * (share / total);
            columns.set(energy, i, columns.get(energy, i) + added);
        }
    }
}
