//! Access to a particle's smoothing length, damage, viscosity and the stress that acts on its neighbours, whatever effects a scene
//! has. Each is a column in some scenes and a number of the body in others; the caller need not know.

use super::damage::{DAMAGE, damaged_pressure, damaged_stress};
use super::viscosity::{CONTACT_ALPHA, DIVERGENCE, SWITCH, speed_in_pores};
use super::{BodyConstants, Core, MaterialTable, Setup, porosity, smoothing_length, strength};
use crate::math::{Deviator, Sym};
use crate::particles::{Column, Registry, Values};

/// The columns and numbers of particles that the step reads.
#[derive(Debug, Clone)]
pub struct ParticleView {
    pub core: Core,
    pub constants: Vec<BodyConstants>,
    /// Whether each body is rigid; empty where none is.
    pub rigid: Vec<bool>,
    /// Factor of the density of each body's records (see `pair::contrast`); empty where none is rigid.
    pub standing: Vec<f64>,
    bodies: Vec<BodyTraits>,
    /// Smoothing length now and at the last list build, where it varies.
    smoothing_length: Option<[Column<f64>; 2]>,
    damage: Option<Column<f64>>,
    deviatoric_stress: Option<Column<Deviator>>,
    distention: Option<Column<f64>>,
    /// The speed of further compression and the divergence of velocity, for viscosity in bodies that request it.
    loading: Option<[Column<f64>; 2]>,
    /// Where matter takes the alpha of what it touches.
    contact_alpha: Option<Column<f64>>,
    /// Share of alpha, where a switch decides it.
    switch: Option<Column<f64>>,
}

/// Properties of a body by its material.
#[derive(Debug, Clone, Copy, PartialEq)]
struct BodyTraits {
    viscosity: Viscosity,
    /// Whether viscosity uses the speed of further compression.
    by_loading: bool,
    /// Whether damage acts on shear through the yield strength alone.
    friction: bool,
    /// Damage, where there is no fracture.
    fixed_damage: Option<f64>,
}

/// Coefficients of the artificial viscosity; zero without it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Viscosity {
    pub alpha: f64,
    pub beta: f64,
}

impl BodyTraits {
    fn new(material: &MaterialTable, initial_damage: f64) -> Self {
        Self {
            viscosity: Viscosity::of(material),
            by_loading: material.has_loading_speed(),
            friction: material.has_friction(),
            fixed_damage: (!material.has_fracture()).then_some(initial_damage),
        }
    }
}

impl Viscosity {
    pub fn of(material: &MaterialTable) -> Self {
        material.viscosity_coefficients().map_or(Self::default(), |[alpha, beta]| Self { alpha, beta })
    }
}

impl ParticleView {
    /// Finds the columns that the effects of `setup` have declared.
    pub fn new(setup: &Setup, registry: &Registry, core: Core) -> Self {
        let bodies = (0..setup.constants.len()).map(|body| (setup.material(body), setup.initial_damage[body]));
        let varying = [smoothing_length::SMOOTHING_LENGTH, smoothing_length::AT_BUILD].map(|name| registry.find(name));
        Self {
            core,
            constants: setup.constants.to_vec(),
            rigid: Vec::new(),
            standing: Vec::new(),
            bodies: bodies.map(|(material, damage)| BodyTraits::new(material, damage)).collect(),
            smoothing_length: varying[0].zip(varying[1]).map(|(now, at_build)| [now, at_build]),
            damage: registry.find(DAMAGE),
            deviatoric_stress: registry.find(strength::DEVIATORIC_STRESS),
            distention: registry.find(porosity::DISTENTION),
            loading: registry.find(porosity::LOADING_SPEED).zip(registry.find(DIVERGENCE)).map(<[_; 2]>::from),
            contact_alpha: registry.find(CONTACT_ALPHA),
            switch: registry.find(SWITCH),
        }
    }

    /// Whether a body is rigid.
    #[inline]
    pub fn is_rigid(&self, body: usize) -> bool {
        self.rigid.get(body).is_some_and(|rigid| *rigid)
    }

    /// Factor of the density in a body's records.
    #[inline]
    pub fn standing(&self, body: usize) -> f64 {
        self.standing.get(body).copied().unwrap_or(1.0)
    }

    /// Columns of the smoothing length, now and at the last list build, where it varies.
    pub fn varying_smoothing_length(&self) -> Option<[Column<f64>; 2]> {
        self.smoothing_length
    }

    /// h of particle `i` of `body`, m.
    #[inline]
    pub fn smoothing_length(&self, particles: &impl Values, i: usize, body: usize) -> f64 {
        match self.smoothing_length {
            Some([now, _]) => particles.value(now, i),
            None => self.constants[body].smoothing_length,
        }
    }

    /// h of particle `i` of `body` at the last list build, m.
    #[inline]
    pub fn smoothing_length_at_build(&self, particles: &impl Values, i: usize, body: usize) -> f64 {
        match self.smoothing_length {
            Some([_, at_build]) => particles.value(at_build, i),
            None => self.constants[body].smoothing_length,
        }
    }

    /// D of particle `i` of `body`; 0 where nothing breaks.
    #[inline]
    pub fn damage(&self, particles: &impl Values, i: usize, body: usize) -> f64 {
        let grown = || self.damage.map_or(0.0, |column| particles.value(column, i));
        self.bodies[body].fixed_damage.unwrap_or_else(grown)
    }

    /// alpha of `porosity`; 1 without pores.
    pub fn distention(&self, particles: &impl Values, i: usize) -> f64 {
        self.distention.map_or(1.0, |column| particles.value(column, i))
    }

    /// S before damage, Pa; zero without strength.
    #[inline]
    pub fn deviatoric_stress(&self, particles: &impl Values, i: usize) -> Deviator {
        self.deviatoric_stress.map_or(Deviator::default(), |column| particles.value(column, i))
    }

    /// Whether damage acts on shear of a body through its yield strength alone.
    pub fn has_friction(&self, body: usize) -> bool {
        self.bodies[body].friction
    }

    /// Coefficients of a body's material.
    pub fn material_viscosity(&self, body: usize) -> Viscosity {
        self.bodies[body].viscosity
    }

    /// Coefficients of particle `i` of `body`.
    #[inline]
    pub fn viscosity(&self, particles: &impl Values, i: usize, body: usize) -> Viscosity {
        let own = self.bodies[body].viscosity;
        let alpha = self.contact_alpha.map_or(own.alpha, |column| particles.value(column, i));
        let share = self.switch.map_or(1.0, |column| particles.value(column, i));
        Viscosity { alpha: alpha * share, ..own }
    }

    /// The column of alpha where matter takes that of what it touches.
    pub fn contact_alpha(&self) -> Option<Column<f64>> {
        self.contact_alpha
    }

    /// The speed that viscosity uses, m/s.
    #[inline]
    pub fn viscous_speed(&self, particles: &impl Values, i: usize, body: usize) -> f64 {
        let sound = particles.value(self.core.sound_speed, i);
        let Some([speed, divergence]) = self.loading.filter(|_| self.bodies[body].by_loading) else { return sound };
        let inward = -self.smoothing_length(particles, i, body) * particles.value(divergence, i);
        speed_in_pores(particles.value(speed, i), sound, inward)
    }

    /// The pressure that acts on neighbours, Pa.
    #[inline]
    pub fn acting_pressure(&self, particles: &impl Values, i: usize, body: usize) -> f64 {
        damaged_pressure(particles.value(self.core.pressure, i), self.damage(particles, i, body))
    }

    /// The stress that acts on neighbours, Pa: deviator and tension weakened by damage, never written back.
    #[inline]
    pub fn acting_stress(&self, particles: &impl Values, i: usize, body: usize) -> Sym {
        let s = self.deviatoric_stress(particles, i);
        let pressure = particles.value(self.core.pressure, i);
        damaged_stress(&s, pressure, self.damage(particles, i, body), self.bodies[body].friction)
    }
}
