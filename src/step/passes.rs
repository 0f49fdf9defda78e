//! Operations on one chunk between two reductions: moving it to a stage, evaluating it, accepting or refusing its step.

use super::derivatives::{Derivatives, is_corrected, local};
use super::packing::is_due;
use super::settings::{Moment, StepSettings};
use super::workspace::{VelocityRange, Workspace};
use crate::material::{Late, Local, MaterialEffect};
use crate::motion::rigid::RigidBody;
use crate::pair::Rows;
use crate::particles::{Chunk, Registry};

/// Data that all chunks of a pass share.
#[derive(Clone, Copy)]
pub struct Passes<'a> {
    pub settings: &'a StepSettings,
    pub registry: &'a Registry,
    /// The rigid bodies at the moment of the stage.
    pub rigid: &'a [RigidBody],
    /// The scene's body of each slot, where rigid bodies are touched.
    pub owners: &'a [u16],
}

impl Passes<'_> {
    /// State that new particles start with.
    pub fn initialise(&self, chunk: &Chunk, workspace: &mut Workspace) {
        self.fill_bodies(chunk, workspace);
        self.each_effect(chunk, workspace, 0.0, |effect, local| effect.initialise(local));
        self.settle(chunk, workspace, Some(0.0));
    }

    /// Converts particles to the soft matter of the late stage.
    pub fn carry_over(&self, chunk: &Chunk, late: &Late, workspace: &mut Workspace) {
        self.fill_bodies(chunk, workspace);
        self.each_effect(chunk, workspace, 0.0, |effect, local| effect.carry_over(local, late));
        self.settle(chunk, workspace, Some(0.0));
    }

    /// Moves a chunk to the moment of a stage, `share` of a step of `dt` seconds, and updates its material.
    pub fn advance(&self, chunk: &Chunk, moment: &Moment, share: f64, workspace: &mut Workspace) {
        let integrator = &self.settings.integrator;
        if share > 0.0 {
            integrator.advance(chunk, moment.stage, moment.dt);
        }
        self.fill_bodies(chunk, workspace);
        if let Some(rigid) = self.settings.rigid.as_ref().filter(|_| share > 0.0) {
            rigid.place(chunk, &workspace.bodies, self.rigid);
        }
        self.settle(chunk, workspace, (!integrator.may_refuse()).then_some(moment.dt));
    }

    /// Moves a chunk to `dt` seconds after its last evaluation, to see what it will be like: nothing is committed.
    pub fn foresee(&self, chunk: &Chunk, dt: f64, workspace: &mut Workspace) {
        self.settings.integrator.advance(chunk, 0, dt);
        self.fill_bodies(chunk, workspace);
        self.settle(chunk, workspace, None);
    }

    /// Sets the particles of rigid bodies to where these are.
    pub fn place(&self, chunk: &Chunk, workspace: &mut Workspace) {
        let Some(rigid) = &self.settings.rigid else { return };
        self.fill_bodies(chunk, workspace);
        rigid.place(chunk, &workspace.bodies, self.rigid);
    }

    /// Evaluates a chunk and hands its rates to the integrator, unless one of them is not finite.
    pub fn evaluate(&self, chunk: &Chunk, rows: &Rows, moment: &Moment, workspace: &mut Workspace) {
        self.fill_bodies(chunk, workspace);
        let Self { settings, registry, rigid, owners } = *self;
        if let Some(relaxation) = settings.relaxation.filter(|_| moment.stage == 0 && is_due(moment.step)) {
            let (layout, view) = (settings.pair_loop.layout(), &settings.view);
            match registry.dimension {
                2 => relaxation.measure::<2>(chunk, rows, layout, view, moment.step == 0),
                _ => relaxation.measure::<3>(chunk, rows, layout, view, moment.step == 0),
            }
        }
        let derivatives = Derivatives { settings, registry, chunk, moment, rigid, owners };
        if !derivatives.evaluate(rows, workspace) {
            return;
        }
        if let Some(moments) = self.settings.packer.moments.filter(|_| moment.stage == 0) {
            for (k, sums) in workspace.sums[..chunk.len()].iter().enumerate() {
                moments.keep(chunk, k, self.registry.dimension, &sums.moment, moment.since);
            }
        }
        if let Some(slopes) = self.settings.packer.slopes.filter(|_| moment.stage == 0) {
            let (view, layout) = (&self.settings.view, self.settings.pair_loop.layout());
            for (k, sums) in workspace.sums[..chunk.len()].iter().enumerate() {
                let known = is_corrected(layout, sums) && !view.is_rigid(workspace.bodies[k] as usize);
                slopes.keep(chunk, k, view, known.then_some(&workspace.flow[k].velocity_gradient));
            }
        }
        if let Some(divergence) = self.settings.divergence.filter(|_| moment.stage == 0) {
            let column = chunk.view(divergence);
            for (k, flow) in workspace.flow[..chunk.len()].iter().enumerate() {
                let now = flow.velocity_gradient.trace();
                if let Some(switch) = &self.settings.switch {
                    switch.keep(chunk, k, &self.settings.view, now - column.get(k), moment.since);
                }
                column.set(k, now);
            }
        }
        let error = self.settings.integrator.take(chunk, &workspace.rates, moment.stage, moment.dt);
        workspace.found.error.merge(&error);
        if moment.last {
            self.each_effect(chunk, workspace, 0.0, |effect, local| effect.admit(local));
        }
        self.note_velocities(chunk, workspace);
    }

    /// Commits irreversible changes, at the end of an accepted step.
    pub fn commit(&self, chunk: &Chunk, dt: f64, workspace: &mut Workspace) {
        self.fill_bodies(chunk, workspace);
        self.settle(chunk, workspace, Some(dt));
    }

    /// Updates the material of a chunk, and commits irreversible changes over `commit` seconds, if given.
    fn settle(&self, chunk: &Chunk, workspace: &mut Workspace, commit: Option<f64>) {
        self.each_effect(chunk, workspace, 0.0, |effect, local| effect.admit(local));
        self.each_effect(chunk, workspace, 0.0, |effect, local| effect.update(local));
        if let Some(dt) = commit {
            self.each_effect(chunk, workspace, dt, |effect, local| effect.commit(local));
        }
        let ids = chunk.view(self.settings.view.core.id);
        workspace.watched.look(chunk, &ids, &mut workspace.found.non_finite);
    }

    fn each_effect(&self, chunk: &Chunk, workspace: &Workspace, dt: f64, act: impl Fn(&dyn MaterialEffect, &Local)) {
        let local = local(self.settings, chunk, workspace, dt);
        workspace.each_effect(&self.settings.effects, |effect| act(effect, &local));
    }

    fn note_velocities(&self, chunk: &Chunk, workspace: &mut Workspace) {
        let view = &self.settings.view;
        let velocity = chunk.view(view.core.velocity);
        let mut range = VelocityRange::NOTHING;
        for k in 0..chunk.len() {
            let v: [f64; 3] = velocity.get(k).into();
            let smallest = view.smoothing_length(chunk, k, workspace.bodies[k] as usize);
            range.merge(&VelocityRange { forward: v, backward: v.map(|v| -v), smallest });
        }
        workspace.found.velocities.merge(&range);
    }

    fn fill_bodies(&self, chunk: &Chunk, workspace: &mut Workspace) {
        let ids = chunk.view(self.settings.view.core.id);
        workspace.bodies.clear();
        workspace.bodies.extend((0..chunk.len()).map(|k| ids.get(k).body() as u16));
    }
}
