//! Pores below the resolution: distention (Jutzi, Benz & Michel 2008, Icarus 198, 242).
//!
//! ```text
//! alpha = rho_s / rho >= 1        P = P_s(alpha rho, u) / alpha                                      eqs 1-3
//! D_c = 1 - (alpha - 1) / (alpha_0 - 1)                                                              eq. 54
//! D^(1/3) grows by that of [(D_c + delta)^(1/3) - delta^(1/3)] / [(1 + delta)^(1/3) - delta^(1/3)]   eqs 57-59, delta = 0.01
//! ```
//! rho density of the body, rho_s that of the matrix, kg/m^3; alpha distention, alpha_0 that at the start; P pressure of the body,
//! P_s equation of state of the matrix, Pa; u specific internal energy, of both, J/kg; D damage.
//!
//! alpha follows from density and energy (see `law`) by pressure (P-alpha), by pressure without heat (rho-alpha) or by strain
//! (epsilon-alpha). alpha grows along the elastic branch only, and changes in `update` alone, from its value
//! when the last step was accepted: an integrator that tries a state sets it back before it tries another.
//!
//! Columns: owns `distention`, `unloaded_distention` where pores are elastic, `stress_factor` (f of eq. 53, which `strength`
//! reads), `loading_speed` where viscosity uses it (longitudinal, of further compression; `strength` stiffens it), and, where a
//! porous material can break, `compaction_damage` (growth of D^(1/3) in this step, which `fracture` adds to its own). Sets the core
//! columns `pressure` and `sound_speed` of porous bodies.
//! Time step: alpha changes by at most 0.2 (alpha_0 - 1), so that a collapse is resolved by several steps. With distention
//! solved for, and the Courant condition beside it, no case was found where the shock's energy depends on this limit.

pub mod crush_curve;
pub mod elastic;
pub mod law;
pub mod strain_law;
#[cfg(test)]
pub mod testing;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::setup::Table;
use super::{Core, Diagnostic, Late, Local, MaterialEffect, MaterialTable, PerBody, Setup, StepLimit, eos};
use crate::error::{Error, Result};
use crate::particles::{Column, ColumnInfo, Columns, Life, Registry};
use crate::units::Number;
use crush_curve::{CrushCurve, CurveTable, MeasuredTable, QuadraticTable, TwoSlopeTable};
use elastic::{Elastic, ElasticTable};
use law::{Compaction, Porous};
use strain_law::{StrainLaw, StrainTable};

/// Names of columns that other effects and outcomes read.
pub const DISTENTION: &str = "distention";
pub const LOADING_SPEED: &str = "loading_speed";
pub const STRESS_FACTOR: &str = "stress_factor";
pub const COMPACTION_DAMAGE: &str = "compaction_damage";

/// Largest change of alpha in a step, over alpha_0 - 1.
const LARGEST_CHANGE: f64 = 0.2;

/// Pores below the resolution: the distention, and one of the three laws.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PorosityTable {
    /// Distention of bodies that have none of their own: density of the matrix over that of the body.
    pub distention: Number,
    /// Distention follows pressure.
    pub p_alpha: Option<PressureTable>,
    /// Distention follows density: the same curves, entered with the pressure of cold matter.
    pub rho_alpha: Option<PressureTable>,
    /// Distention follows strain.
    pub epsilon_alpha: Option<StrainTable>,
}

/// One crush curve, and for P-alpha an elastic branch below it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PressureTable {
    /// A quadratic curve; one of three.
    pub quadratic: Option<QuadraticTable>,
    /// A curve of two powers; one of three.
    pub two_slope: Option<TwoSlopeTable>,
    /// A measured curve; one of three.
    pub measured: Option<MeasuredTable>,
    /// Pores below P_e give way and come back, in P-alpha; they are rigid without it.
    pub elastic: Option<ElasticTable>,
}

impl PressureTable {
    fn curve(&self) -> Option<CurveTable<'_>> {
        let curves = [
            self.quadratic.as_ref().map(CurveTable::Quadratic),
            self.two_slope.as_ref().map(CurveTable::TwoSlope),
            self.measured.as_ref().map(CurveTable::Measured),
        ];
        let mut given = curves.into_iter().flatten();
        given.next().filter(|_| given.next().is_none())
    }

    fn validate(&self, place: &str, distention: f64) -> Result<()> {
        let curve = self.curve().ok_or_else(|| {
            Error::new("there is not one crush curve").at(place).allowed("one of quadratic, two_slope, measured")
        })?;
        curve.validate(place, distention)?;
        self.elastic.as_ref().map_or(Ok(()), |elastic| elastic.validate(&format!("{place}.elastic")))
    }
}

impl Table for PorosityTable {
    fn validate(&self, place: &str, material: &MaterialTable) -> Result<()> {
        let distention = self.distention.0;
        if !(distention >= 1.0 && distention.is_finite()) {
            return Err(Error::new(format!("distention is {distention}"))
                .at(format!("{place}.distention"))
                .allowed("1 (no pores) and above"));
        }
        if material.eos.law().bulk_modulus().is_none() {
            return Err(Error::new("porosity needs a solid, and the equation of state is that of a gas").at(place));
        }
        match (&self.p_alpha, &self.rho_alpha, &self.epsilon_alpha) {
            (Some(table), None, None) => table.validate(&format!("{place}.p_alpha"), distention),
            (None, Some(table), None) if table.elastic.is_some() => {
                let error = Error::new("an elastic branch follows pressure, which rho_alpha does not");
                Err(error.at(format!("{place}.rho_alpha.elastic")).allowed("p_alpha with an elastic branch"))
            }
            (None, Some(table), None) => table.validate(&format!("{place}.rho_alpha"), distention),
            (None, None, Some(table)) => table.validate(&format!("{place}.epsilon_alpha"), distention),
            _ => Err(Error::new("there is not one law of compaction")
                .at(place)
                .allowed("one of p_alpha, rho_alpha, epsilon_alpha")),
        }
    }
}

impl Porous {
    /// The matter of a body with the distention `initial`; `None` where the material has no pores or is no solid.
    pub fn of(material: &MaterialTable, initial: f64) -> Option<Self> {
        let table = material.porosity.as_ref()?;
        let eos = material.eos.law();
        let (density, modulus) = (eos.reference_density()?, eos.bulk_modulus()?);
        let scale = if table.distention.0 > 1.0 { (initial - 1.0) / (table.distention.0 - 1.0) } else { 0.0 };
        let compaction = if let Some(strain) = &table.epsilon_alpha {
            let elastic = strain.elastic_strain.map_or_else(
                || elastic_strain(&eos, density / initial, initial, strain.p_e.map_or(0.0, |p_e| p_e.0)),
                |strain| strain.0,
            );
            Compaction::Strain(StrainLaw::new(strain, initial, density / initial, elastic))
        } else {
            let pressures = table.p_alpha.as_ref().or(table.rho_alpha.as_ref())?;
            let curve = pressures.curve()?;
            let branch = pressures.elastic.as_ref();
            let branch = branch.and_then(|elastic| Elastic::new(elastic, initial, curve.elastic_limit(), density));
            let curve = CrushCurve::new(&curve, scale, branch.map_or(initial, |(_, alpha_e)| alpha_e));
            match table.p_alpha {
                Some(_) => Compaction::Pressure { curve, elastic: branch.map(|(elastic, _)| elastic) },
                None => Compaction::ColdPressure(curve),
            }
        };
        Some(Self { compaction, eos, sound2_at_rest: modulus / density, initial })
    }

    /// D^(1/3) caused by crushing down to a distention (eq. 57).
    pub fn damage_root(&self, unloaded: f64) -> f64 {
        /// Keeps the growth finite at alpha_0.
        const DELTA: f64 = 0.01;
        if self.initial <= 1.0 {
            return 0.0;
        }
        let crushed = (1.0 - (unloaded - 1.0) / (self.initial - 1.0)).clamp(0.0, 1.0);
        let least = libm::cbrt(DELTA);
        (libm::cbrt(crushed + DELTA) - least) / (libm::cbrt(1.0 + DELTA) - least)
    }
}

/// The strain ln(rho / rho_0) at which a cold body has a pressure.
fn elastic_strain(eos: &eos::Eos, density: f64, alpha: f64, pressure: f64) -> f64 {
    let (mut low, mut high) = (density, 2.0 * density);
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return libm::log(middle / density);
        }
        if eos.slopes(alpha * middle, 0.0).p / alpha < pressure { low = middle } else { high = middle }
    }
}

/// Columns that the effects of shear and fracture read of porous bodies.
#[derive(Debug, Clone, Copy)]
pub struct PoreColumns {
    pub distention: Column<f64>,
    pub stress_factor: Column<f64>,
    /// Where viscosity uses it.
    pub loading_speed: Option<Column<f64>>,
}

impl PoreColumns {
    pub fn find(registry: &Registry) -> Option<Self> {
        Some(Self {
            distention: registry.find(DISTENTION)?,
            stress_factor: registry.find(STRESS_FACTOR)?,
            loading_speed: registry.find(LOADING_SPEED),
        })
    }
}

/// Distention of the bodies that have pores.
pub struct Porosity {
    bodies: PerBody<Porous>,
    distention: Column<f64>,
    /// Where pores are elastic.
    unloaded: Option<Column<f64>>,
    stress_factor: Column<f64>,
    /// Where viscosity uses it.
    loading_speed: Option<Column<f64>>,
    /// Where a porous material can break.
    damage: Option<Column<f64>>,
    density: Column<f64>,
    /// None where all equations of state are cold.
    energy: Option<Column<f64>>,
    pressure: Column<f64>,
    sound_speed: Column<f64>,
}

impl MaterialEffect for Porosity {
    fn declare(setup: &Setup, registry: &mut Registry, core: &Core) -> Result<Option<Self>> {
        let porous = |body: usize, material: &MaterialTable| Porous::of(material, setup.constants[body].distention);
        let Some(bodies) = PerBody::new(setup, porous) else { return Ok(None) };
        let any = |holds: fn(&MaterialTable) -> bool| setup.body_material.iter().any(|&m| holds(&setup.materials[m]));
        let elastic = any(|material| {
            material.porosity.as_ref().is_some_and(|table| table.p_alpha.as_ref().is_some_and(|t| t.elastic.is_some()))
        });
        let breaks = any(|material| material.porosity.is_some() && material.has_fracture());
        let info = |name, about, life, snapshot| ColumnInfo { name, unit: "", about, life, snapshot };
        let energy = registry.find(eos::INTERNAL_ENERGY);
        registry.owner("porosity");
        let distention =
            registry.column(info(DISTENTION, "Density of the matrix over that of the body.", Life::State, true));
        let unloaded = elastic.then(|| {
            let about = "Distention after release of the load.";
            registry.column(info("unloaded_distention", about, Life::State, false))
        });
        let about = "Volumetric strain rate of the matrix over that of the body.";
        let stress_factor = registry.column(info(STRESS_FACTOR, about, Life::Scratch, false));
        let loading_speed = any(MaterialTable::has_loading_speed).then(|| {
            registry.column(ColumnInfo {
                name: LOADING_SPEED,
                unit: "m/s",
                about: "Longitudinal wave speed of further compression.",
                life: Life::Scratch,
                snapshot: false,
            })
        });
        let damage = breaks.then(|| {
            let about = "Growth of the cube root of damage by compaction in this step.";
            registry.column(info(COMPACTION_DAMAGE, about, Life::Scratch, false))
        });
        let (density, pressure, sound_speed) = (core.density.value, core.pressure, core.sound_speed);
        Ok(Some(Self {
            bodies,
            distention,
            unloaded,
            stress_factor,
            loading_speed,
            damage,
            density,
            energy,
            pressure,
            sound_speed,
        }))
    }

    fn name(&self) -> &'static str {
        "porosity"
    }

    fn initialise(&self, local: &Local) {
        let distention = local.view(self.distention);
        let unloaded = self.unloaded.map(|column| local.view(column));
        for (body, range) in local.runs() {
            for i in range {
                distention.set(i, local.constants[body].distention);
                if let Some(unloaded) = &unloaded {
                    unloaded.set(i, local.constants[body].distention);
                }
            }
        }
    }

    fn soften(&mut self, late: &Late) {
        for (body, porous) in self.bodies.iter_mut() {
            let softening = &late.0[body];
            porous.compaction = Compaction::Kept;
            (porous.eos, porous.sound2_at_rest) = (softening.law(), softening.sound2());
        }
    }

    fn carry_over(&self, local: &Local, _late: &Late) {
        let Some(unloaded) = self.unloaded.map(|column| local.view(column)) else { return };
        let distention = local.view(self.distention);
        (0..local.len()).for_each(|i| unloaded.set(i, distention.get(i)));
    }

    fn update(&self, local: &Local) {
        let (density, energy) = (local.view(self.density), local.optional(self.energy));
        let (pressure, sound_speed) = (local.view(self.pressure), local.view(self.sound_speed));
        let (distention, stress_factor) = (local.view(self.distention), local.view(self.stress_factor));
        let loading_speed = self.loading_speed.map(|column| local.view(column));
        let pores_left = self.unloaded.map_or(distention, |column| local.view(column));
        let damage = self.damage.map(|column| local.view(column));
        for (porous, range) in self.bodies.runs(local) {
            for i in range {
                let before = pores_left.get(i);
                let state = porous.state(density.get(i), energy.get(i), before);
                distention.set(i, state.distention);
                pores_left.set(i, if self.unloaded.is_some() { state.unloaded } else { state.distention });
                pressure.set(i, state.pressure);
                sound_speed.set(i, state.sound_speed);
                stress_factor.set(i, state.stress_factor);
                if let Some(loading_speed) = &loading_speed {
                    loading_speed.set(i, state.loading_speed);
                }
                if let Some(damage) = &damage {
                    let crushed = state.unloaded < before;
                    let growth = || porous.damage_root(state.unloaded) - porous.damage_root(before);
                    damage.set(i, if crushed { growth() } else { 0.0 });
                }
            }
        }
    }

    fn step_limit(&self, local: &Local) -> Option<StepLimit> {
        let (distention, stress_factor) = (local.view(self.distention), local.view(self.stress_factor));
        // Changes of alpha over alpha_0 - 1, 1/s.
        let mut fastest = (0.0, 0);
        for (porous, range) in self.bodies.runs(local) {
            if porous.initial <= 1.0 {
                continue;
            }
            for i in range {
                let divergence = local.flow[i].velocity_gradient.trace();
                let rate =
                    distention_rate(stress_factor.get(i), divergence) * distention.get(i) / (porous.initial - 1.0);
                if -rate > fastest.0 {
                    fastest = (-rate, i);
                }
            }
        }
        (fastest.0 > 0.0).then(|| StepLimit { dt: LARGEST_CHANGE / fastest.0, particle: fastest.1 })
    }

    fn diagnostics(&self) -> Vec<Diagnostic> {
        vec![Diagnostic { name: "compacted_volume", unit: "m^3" }]
    }

    /// m (1 / rho_0 - alpha / (alpha_0 rho_0)).
    fn diagnose(&self, columns: &Columns, i: usize, body: usize, mass: f64, add: &mut dyn FnMut(usize, f64)) {
        if let Some(porous) = self.bodies.of(body) {
            let matrix_density = porous.eos.reference_density().unwrap_or(f64::INFINITY);
            add(0, mass / matrix_density * (porous.initial - columns.get(self.distention, i)));
        }
    }
}

/// d ln(alpha) / dt of matter with the factor f under compression; zero in expansion.
#[inline]
pub fn distention_rate(stress_factor: f64, divergence: f64) -> f64 {
    if divergence < 0.0 { (1.0 - stress_factor) * divergence } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::super::Records;
    use super::super::damage::DAMAGE;
    use super::super::strength::DEVIATORIC_STRESS;
    use super::super::testing::{Rig, basalt};
    use super::testing::material;
    use super::*;
    use crate::math::{Deviator, Mat3, Vec3};

    /// Basalt with strength, flaws and pores.
    fn porous_basalt(alpha_0: f64) -> MaterialTable {
        let porosity = "p_alpha = { quadratic = { P_e = 1e6, P_s = 2e8 } }";
        let table: PorosityTable = toml::from_str(&format!("distention = {alpha_0}\n{porosity}")).unwrap();
        MaterialTable { porosity: Some(table), ..basalt() }
    }

    fn unbreakable(alpha_0: f64) -> MaterialTable {
        MaterialTable { fracture: None, ..porous_basalt(alpha_0) }
    }

    fn compression(along_x: f64, along_y: f64) -> Mat3 {
        Mat3::from_diagonal(&Vec3::new(-along_x, -along_y, -along_y))
    }

    /// A rigid rotation by 45 degrees at alpha = 3: diag(1, -1, 0) becomes S_xy = 1. Spin terms over alpha, as public codes have
    /// them, would give 0.50.
    #[test]
    fn stress_turns_with_the_body_whatever_its_pores() {
        let mut rig = Rig::new(unbreakable(3.0));
        let column = rig.column::<Deviator>(DEVIATORIC_STRESS);
        rig.set(column, Deviator { xx: 1e6, yy: -1e6, ..Default::default() });
        let gradient = Mat3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0);
        let dt = std::f64::consts::FRAC_PI_4 / 1000.0;
        rig.step(&gradient, 0.0);
        (0..1000).for_each(|_| {
            rig.step(&gradient, dt);
        });
        let s = rig.get(column);
        assert!((s.xy - 1e6).abs() < 10.0 && s.xx.abs() < 10.0, "{s:?}");
        assert_eq!(rig.get(rig.column::<f64>(DISTENTION)), 3.0);
    }

    /// From alpha = 3 to 1 at a matrix density that stays (epsilon-alpha, kappa = 1: f = 0) alpha S stays: S grows threefold,
    /// the matrix is not sheared. The scheme is of second order: 1e-4 for 2000 steps.
    #[test]
    fn stress_concentrates_as_pores_close() {
        let table = toml::from_str("distention = 3\nepsilon_alpha = { kappa = 1, elastic_strain = 0 }").unwrap();
        let mut rig = Rig::new(MaterialTable { porosity: Some(table), ..unbreakable(3.0) });
        let column = rig.column::<Deviator>(DEVIATORIC_STRESS);
        let alpha = rig.column::<f64>(DISTENTION);
        rig.set(column, Deviator { xx: 1e6, yy: -1e6, ..Default::default() });
        let steps = 2000;
        // div v = -1 for ln 3 seconds.
        let (gradient, dt) = (Mat3::from_diagonal_element(-1.0 / 3.0), libm::log(3.0) / f64::from(steps));
        rig.step(&gradient, 0.0);
        (0..steps).for_each(|_| {
            rig.step(&gradient, dt);
        });
        let (s, alpha) = (rig.get(column), rig.get(alpha));
        assert!((alpha - 1.0).abs() < 1e-3 && (s.xx / 1e6 - 3.0 / alpha).abs() < 3e-3, "{alpha} {s:?}");
    }

    /// Uniaxial compression below P_e: moduli over alpha, the same longitudinal speed of sound as the solid.
    #[test]
    fn elastic_moduli_are_those_of_the_matrix_over_alpha() {
        let mut rig = Rig::new(unbreakable(3.0));
        let column = rig.column::<Deviator>(DEVIATORIC_STRESS);
        rig.step(&compression(1.0, 0.0), 0.0);
        rig.step(&compression(1.0, 0.0), 5e-5);
        let s = rig.get(column);
        assert!((s.xx / (-4.0 / 3.0 * 22.7e9 / 3.0 * 5e-5) - 1.0).abs() < 1e-12, "{s:?}");
        assert!((rig.get(rig.core.pressure) / (26.7e9 / 3.0 * 5e-5) - 1.0).abs() < 1e-3);
        assert!((rig.get(rig.core.sound_speed) - 4593.3).abs() < 2.0);
    }

    /// All pores crushed: D = 1 from compression alone; half of them: as in figure 4.
    #[test]
    fn crushing_breaks() {
        let mut rig = Rig::new(porous_basalt(3.0));
        let (damage, alpha) = (rig.column::<f64>(DAMAGE), rig.column::<f64>(DISTENTION));
        let gradient = Mat3::from_diagonal_element(-1.0);
        rig.step(&gradient, 0.0);
        let mut last = 0.0;
        let root = |x: f64| {
            let least = libm::cbrt(0.01);
            (libm::cbrt(x + 0.01) - least) / (libm::cbrt(1.01) - least)
        };
        for _ in 0..2000 {
            rig.step(&gradient, 2e-4);
            let now = rig.get(damage);
            let expected = root(1.0 - (rig.get(alpha) - 1.0) / 2.0);
            assert!(now >= last && (libm::cbrt(now) - expected).abs() < 1e-9, "{now} {expected}");
            last = now;
        }
        assert!(rig.get(alpha) == 1.0 && (last - 1.0).abs() < 1e-9, "{} {last}", rig.get(alpha));
    }

    /// Growth just below alpha_0 is finite: d D^(1/3) / d D_c = 1 / (3 0.01^(2/3) 0.788) = 9.1.
    #[test]
    fn damage_grows_at_a_finite_rate_at_alpha_0() {
        let porous = Porous::of(&porous_basalt(3.0), 3.0).unwrap();
        assert_eq!(porous.damage_root(3.0), 0.0);
        let slope = porous.damage_root(3.0 - 2.0e-9) / 1e-9;
        assert!((slope - 9.1).abs() < 0.02, "{slope}");
        assert_eq!(porous.damage_root(1.0), 1.0);
    }

    /// No pores at the start: the same numbers as the solid, and no damage.
    #[test]
    fn zero_porosity_is_the_solid() {
        let mut pair = [Rig::new(basalt()), Rig::new(porous_basalt(1.0))];
        for step in 0..400 {
            let turn = 0.3 * f64::from(step % 7);
            let sign = if step / 80 % 2 == 0 { 1.0 } else { -1.0 };
            let gradient = Mat3::new(-sign, turn, 0.0, -turn, 0.5 * sign, 0.1, 0.0, 0.2, -sign);
            let limits = pair.each_mut().map(|rig| rig.step(&gradient, 1e-4));
            assert_eq!(limits[0], limits[1]);
            let [solid, porous] = &pair;
            for (name, values) in
                solid.columns.registry.entries.iter().map(|e| (e.name.as_str(), e)).filter(|(name, _)| *name != "id")
            {
                let other = porous.columns.registry.entries.iter().position(|e| e.name == name).unwrap();
                let own = solid.columns.registry.entries.iter().position(|e| e.name == values.name).unwrap();
                assert_eq!(solid.columns.numbers(own), porous.columns.numbers(other), "{name}");
            }
        }
        let mut pressed = Rig::new(porous_basalt(1.0));
        (0..200).for_each(|_| {
            pressed.step(&Mat3::from_diagonal_element(-0.5), 1e-4);
        });
        assert_eq!(pressed.get(pressed.column::<f64>(DAMAGE)), 0.0);
    }

    /// A body of its own distention, beside a solid one of the same material without pores.
    #[test]
    fn each_body_has_its_own_pores() {
        let mut rig = Rig::with_materials(vec![porous_basalt(3.0), basalt(), porous_basalt(1.5)]);
        let alpha = rig.column::<f64>(DISTENTION);
        rig.step(&compression(0.1, 0.1), 0.0);
        rig.step(&compression(0.1, 0.1), 1e-6);
        assert_eq!([0, 1, 2].map(|body| rig.get_of(body, alpha)), [3.0, 1.0, 1.5]);
        assert_eq!([0, 1, 2].map(|body| (rig.get_of(body, rig.core.density.value)).round()), [900.0, 2700.0, 1800.0]);
    }

    /// The limit requires five steps or more for a whole collapse.
    #[test]
    fn steps_follow_the_collapse() {
        let mut rig = Rig::new(unbreakable(3.0));
        let gradient = Mat3::from_diagonal_element(-10.0);
        rig.step(&gradient, 0.0);
        rig.step(&gradient, 1e-3);
        let limit = rig.step(&gradient, 1e-3).unwrap();
        // alpha' is about alpha div v: 0.2 (alpha_0 - 1) / (alpha |div v|).
        let alpha = rig.get(rig.column::<f64>(DISTENTION));
        assert!(limit.dt < 1.3 * 0.4 / (30.0 * alpha) && alpha > 2.5, "{limit:?} {alpha}");
    }

    #[test]
    fn tables_are_checked() {
        let place = "material.x.porosity";
        let checked = |porosity: &str| {
            let material = material(&testing::simple_eos(2.0), porosity);
            material.porosity.as_ref().unwrap().validate(place, &material).map_err(|e| e.to_string())
        };
        let quadratic = "{ quadratic = { P_e = 8e7, P_s = 7e8 } }";
        assert_eq!(checked(&format!("distention = 3\np_alpha = {quadratic}")), Ok(()));
        assert!(
            checked(&format!("distention = 0.9\np_alpha = {quadratic}")).unwrap_err().contains("distention is 0.9")
        );
        assert!(checked("distention = 3").unwrap_err().contains("one of p_alpha, rho_alpha, epsilon_alpha"));
        let both = format!("distention = 3\np_alpha = {quadratic}\nrho_alpha = {quadratic}");
        assert!(checked(&both).is_err());
        assert!(checked("distention = 3\np_alpha = {}").unwrap_err().contains("quadratic, two_slope, measured"));
        let elastic =
            "distention = 3\nrho_alpha = { quadratic = { P_e = 8e7, P_s = 7e8 }, elastic = { c_e = 4e3, c_0 = 5e3 } }";
        assert!(checked(elastic).unwrap_err().contains("p_alpha with an elastic branch"));
        let gas = MaterialTable { porosity: porous_basalt(2.0).porosity, ..super::super::testing::gas() };
        assert!(gas.validate("material.gas").is_err());
    }

    #[test]
    fn a_scene_without_pores_has_no_column_of_them() {
        let rig = Rig::new(basalt());
        assert!(rig.effects.iter().all(|effect| effect.name() != "porosity"));
        assert!(rig.columns.registry.find::<f64>(DISTENTION).is_none());
        let rigid = Rig::new(unbreakable(3.0));
        assert!(rigid.columns.registry.find::<f64>("unloaded_distention").is_none());
        assert!(rigid.columns.registry.find::<f64>(COMPACTION_DAMAGE).is_none());
        let broken = Rig::with_records(vec![porous_basalt(2.0)], Records::default(), 0.5);
        assert!(broken.columns.registry.find::<f64>(COMPACTION_DAMAGE).is_some());
    }
}
