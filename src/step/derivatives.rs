//! From the state of a chunk and the records of its neighbours to rates: accelerations, rates of every integrated column, and the
//! step that they allow. Nothing of the state changes here.

use super::failure;
use super::pack::read_stress;
use super::settings::{Moment, StepSettings};
use super::time_step::{self, Limit};
use super::workspace::Workspace;
use crate::material::{Local, LocalFlow};
use crate::math::{Mat3, Sym};
use crate::motion::rigid::RigidBody;
use crate::motion::{DampingLimit, Moving};
use crate::pair::record::half;
use crate::pair::{Layout, RowSums, Rows, angular_momentum, correction};
use crate::particles::{Chunk, Registry};

/// Rows of a chunk that are summed between two requests for columns.
const ROWS_PER_FETCH: usize = 32;

/// An evaluation of one chunk.
pub struct Derivatives<'a> {
    pub settings: &'a StepSettings,
    pub registry: &'a Registry,
    pub chunk: &'a Chunk<'a>,
    pub moment: &'a Moment,
    pub rigid: &'a [RigidBody],
    /// The scene's body of each slot, where rigid bodies are touched.
    pub owners: &'a [u16],
}

impl Derivatives<'_> {
    /// Evaluates the rates of the chunk, whose records are in `rows`; false where one of them is not finite, which is then noted.
    pub fn evaluate(&self, rows: &Rows, workspace: &mut Workspace) -> bool {
        let (chunk, settings) = (self.chunk, self.settings);
        // While pairs are summed, the columns that their sums will change are prefetched.
        let mut sums = workspace.sums.chunks_mut(ROWS_PER_FETCH);
        for start in chunk.range.clone().step_by(ROWS_PER_FETCH) {
            let rows_now = start..(start + ROWS_PER_FETCH).min(chunk.range.end);
            let sums = sums.next().expect("sums for each row of a chunk");
            chunk.fetch(start - chunk.range.start..rows_now.end - chunk.range.start);
            settings.pair_loop.sum(rows, rows_now, sums);
        }
        self.find_flow(rows, workspace);
        workspace.rates.clear();
        self.push_apart(rows, workspace);
        if let Some(gravity) = &settings.gravity {
            gravity.add(chunk, self.moment.gravity_age, self.registry.dimension, &workspace.rates);
        }
        let damping = self.constrain(workspace);
        self.take_forces(workspace);
        let local = local(settings, chunk, workspace, 0.0);
        workspace.each_effect(&settings.effects, |effect| effect.rates(&local));
        if let Some(relaxation) = &settings.relaxation {
            relaxation.add(chunk, settings.view.core.density, &workspace.rates);
        }
        let limit = self.step_limit(&local, workspace, damping);
        if !workspace.rates.are_finite(chunk.len(), self.registry.dimension) {
            let found = failure::first_non_finite_rate(settings, self.registry, &local);
            workspace.found.non_finite = failure::NonFinite::first(workspace.found.non_finite.take(), found);
            return false;
        }
        workspace.found.limit = workspace.found.limit.tighter(limit);
        true
    }

    /// Acceleration, velocity gradient and heating of each row.
    fn find_flow(&self, rows: &Rows, workspace: &mut Workspace) {
        let layout = &self.settings.pair_loop.layout();
        let dimension = layout.dimension;
        let stride = layout.stride();
        for (k, i) in self.chunk.range.clone().enumerate() {
            let (sums, body) = (&workspace.sums[k], workspace.bodies[k] as usize);
            let record = &rows.records[rows.slots[i] as usize * stride..][..stride];
            let inverse_density = record[layout.volume()] / self.settings.view.constants[body].particle_mass;
            for a in 0..dimension {
                workspace.rates.acceleration[k * dimension + a].set(inverse_density * sums.force[a]);
            }
            let raw = gradient(dimension, &sums.gradient);
            let heating = inverse_density * power(layout, record, sums);
            let velocity_gradient = match (sums.neighbours, self.settings.view.is_rigid(body)) {
                (0, false) => Mat3::from_diagonal_element(self.unloading(k, body)),
                (_, false) => corrected(layout, &raw, sums),
                (0, true) => Mat3::from_diagonal_element(self.release(k, body)),
                // Density then follows sum_j w_i V_j W_ij of other rigid bodies, whatever way they have come and gone.
                (_, true) => raw,
            };
            workspace.flow[k] = LocalFlow { velocity_gradient, heating };
            workspace.found.pairs += sums.neighbours as u64;
        }
    }

    /// The expansion, 1/s along each axis, by which a particle that has lost all neighbours releases its pressure, of either sign:
    /// at its speed of sound over h, in ten steps or more, so that it limits no step. Without it the pressure of its last contact
    /// would stay for good. Its energy stays, as it does no work on others.
    fn unloading(&self, k: usize, body: usize) -> f64 {
        let (view, dt) = (&self.settings.view, self.moment.dt);
        let at = |column| self.chunk.view(column).get(k);
        let (pressure, c) = (at(view.core.pressure), at(view.core.sound_speed));
        if !(c > 0.0 && dt > 0.0) {
            return 0.0;
        }
        let h = view.smoothing_length(self.chunk, k, body);
        let rate = pressure / (at(view.core.density.value) * c * h);
        rate.clamp(-0.1 / dt, 0.1 / dt) / self.registry.dimension as f64
    }

    /// The expansion, 1/s along each axis, by which a rigid body's particle that nothing touches returns to its own density, within the
    /// time of sound through h, and some steps: what rounding and steps of finite length have left must not add up over many contacts. At
    /// a rate that a short step does not change, as an error must shrink with the step.
    fn release(&self, k: usize, body: usize) -> f64 {
        let (view, dt) = (&self.settings.view, self.moment.dt);
        let constants = &view.constants[body];
        let strain = self.chunk.view(view.core.density.value).get(k) / constants.density - 1.0;
        let c = self.settings.rigid.as_ref().map_or(0.0, |rigid| rigid.sound_speed(body));
        if dt > 0.0 {
            strain * (c / constants.smoothing_length).min(0.5 / dt) / self.registry.dimension as f64
        } else {
            0.0
        }
    }

    /// Hands the forces on particles of rigid bodies to these.
    fn take_forces(&self, workspace: &mut Workspace) {
        let Some(rigid) = &self.settings.rigid else { return };
        let Workspace { bodies, rates, loads, .. } = workspace;
        match self.registry.dimension {
            2 => rigid.take_forces::<2>(self.chunk, bodies, self.rigid, rates, loads),
            _ => rigid.take_forces::<3>(self.chunk, bodies, self.rigid, rates, loads),
        }
    }

    /// Applies the motion that the scene prescribes.
    fn constrain(&self, workspace: &Workspace) -> Option<DampingLimit> {
        let motions = self.settings.motions.as_ref()?;
        let velocity = self.settings.view.core.velocity;
        let moving = Moving { chunk: self.chunk, velocity, bodies: &workspace.bodies, now: self.moment.time };
        match self.registry.dimension {
            2 => motions.constrain::<2>(&moving, &workspace.rates),
            _ => motions.constrain::<3>(&moving, &workspace.rates),
        }
    }

    fn step_limit(&self, local: &Local, workspace: &Workspace, damping: Option<DampingLimit>) -> Limit {
        let StepSettings { view, cfl: courant, effects, .. } = self.settings;
        let (chunk, core, dimension) = (self.chunk, &view.core, self.registry.dimension);
        let sound_speed = chunk.view(core.sound_speed);
        let ids = chunk.view(core.id);
        let contact = self.settings.contact.as_ref();
        let mut best = damping.map_or((f64::INFINITY, 0, Limit::CFL), |held| (held.dt, held.particle, Limit::MOTION));
        for k in 0..chunk.len() {
            let body = workspace.bodies[k] as usize;
            let h = view.smoothing_length(chunk, k, body);
            let a = &workspace.rates.acceleration[k * dimension..(k + 1) * dimension];
            let a2: f64 = a.iter().map(|a| a.get() * a.get()).sum();
            let sums = &workspace.sums[k];
            // A particle without neighbours exchanges no signals, however hot it is.
            let alone = sums.neighbours == 0;
            let sound = sound_speed.get(k);
            let swing = contact
                .filter(|_| !view.is_rigid(body))
                .map_or(0.0, |contact| contact.speed(chunk, k, sums, h / sound));
            let sound = sound * swing.max(1.0);
            let cfl = time_step::cfl(*courant, h, sound, view.viscosity(chunk, k, body), sums.approach);
            let cfl = if alone { f64::INFINITY } else { cfl };
            let acceleration = time_step::acceleration(*courant, h, a2);
            for (dt, reason) in [(cfl, Limit::CFL), (acceleration, Limit::ACCELERATION)] {
                // Of equal ones that of the first particle counts, in whatever order they lie.
                let earlier = || dt == best.0 && (reason, ids.get(k)) < (best.2, ids.get(best.1));
                if dt < best.0 || earlier() {
                    best = (dt, k, reason);
                }
            }
        }
        let mut reason = Limit::EFFECTS;
        workspace.each_effect(effects, |effect| {
            if let Some(limit) = effect.step_limit(local).filter(|limit| limit.dt < best.0) {
                best = (limit.dt, limit.particle, reason);
            }
            reason += 1;
        });
        let position = chunk.view(core.position).get(best.1);
        Limit { dt: best.0, reason: best.2, id: chunk.view(core.id).get(best.1), position: position.into() }
    }
}

/// What the pairs of a row do to a particle of this record beyond moving it, W/m^3.
#[inline]
pub fn power(layout: &Layout, record: &[f64], sums: &RowSums) -> f64 {
    let mut work = contract(&read_stress(layout, record), &gradient(layout.dimension, &sums.gradient));
    if layout.terms.angular_momentum() {
        let axial = |k: usize| half(record, layout.axial() + k);
        work += match layout.dimension {
            2 => angular_momentum::heating::<2>(&[axial(0)], &sums.gradient),
            _ => angular_momentum::heating::<3>(&[axial(0), axial(1), axial(2)], &sums.gradient),
        };
    }
    work + 0.5 * sums.dissipation
}

/// A chunk in the form that effects take.
pub fn local<'a>(settings: &'a StepSettings, chunk: &'a Chunk<'a>, workspace: &'a Workspace, dt: f64) -> Local<'a> {
    Local {
        chunk,
        bodies: &workspace.bodies,
        constants: &settings.view.constants,
        flow: &workspace.flow[..chunk.len()],
        rates: &workspace.rates,
        dt,
    }
}

fn corrected(layout: &Layout, raw: &Mat3, sums: &RowSums) -> Mat3 {
    if !layout.terms.corrects() {
        return *raw;
    }
    let m = moment(layout, sums);
    if layout.dimension == 2 { correction::corrected::<2>(raw, &m) } else { correction::corrected::<3>(raw, &m) }
}

/// Whether the neighbours of a row tell a gradient that is exact for linear flow.
pub fn is_corrected(layout: &Layout, sums: &RowSums) -> bool {
    let m = moment(layout, sums);
    let inverse = if layout.dimension == 2 { correction::inverse::<2>(&m) } else { correction::inverse::<3>(&m) };
    layout.terms.corrects() && sums.neighbours > 0 && inverse.is_some()
}

/// M_i.
fn moment(layout: &Layout, sums: &RowSums) -> Sym {
    let m = &sums.moment;
    if layout.dimension == 2 {
        Sym { xx: m[0], yy: m[1], xy: m[2], ..Sym::ZERO }
    } else {
        Sym { xx: m[0], yy: m[1], zz: m[2], xy: m[3], xz: m[4], yz: m[5] }
    }
}

fn gradient(dimension: usize, sums: &[f64; 9]) -> Mat3 {
    if dimension == 2 {
        Mat3::new(sums[0], sums[1], 0.0, sums[2], sums[3], 0.0, 0.0, 0.0, 0.0)
    } else {
        Mat3::from_row_slice(sums)
    }
}

/// sigma : L, W/m^3.
fn contract(s: &Sym, l: &Mat3) -> f64 {
    s.xx * l[(0, 0)]
        + s.yy * l[(1, 1)]
        + s.zz * l[(2, 2)]
        + s.xy * (l[(0, 1)] + l[(1, 0)])
        + s.xz * (l[(0, 2)] + l[(2, 0)])
        + s.yz * (l[(1, 2)] + l[(2, 1)])
}
