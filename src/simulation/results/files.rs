//! Files written during a run: rows of its history, outcomes, snapshots, checkpoints.

use std::time::Instant;

use super::probes;
use super::report;
use crate::error::{Error, Result};
use crate::outcome::vapour::Vapour;
use crate::outcome::{self, Evaluation, Particle, Question};
use crate::output::{Cell, CheckpointMeta, Snapshot, Storage, checkpoint, snapshot};
use crate::process::resources;
use crate::scene::{Body, Precision, Snapshots};
use crate::simulation::due::Due;
use crate::simulation::rigid;
use crate::simulation::run::Run;
use crate::simulation::state::{Saved, Spent};
use crate::step::phases::Phase;

impl<const D: usize> Run<'_, D> {
    pub(in crate::simulation) fn write_history(&mut self) {
        self.limit = self.stepper.tightest_limit();
        let held = self.stepper.settings.prescribes_motion();
        let mut cells = report::history_row(&self.stepper.state, &self.totals, &self.limit, held, D == 2);
        cells.extend(probes::row(self.scene, &self.stepper, self.comm).into_iter().map(Cell::Real));
        cells.extend(self.fall_row().into_iter().map(Cell::Real));
        cells.extend(self.momentum_row().map(Cell::Real));
        cells.extend(self.state.bounce.as_ref().map(|bounce| Cell::Real(bounce.after())));
        cells.extend(rigid::row(&self.stepper.state.rigid, D).into_iter().map(Cell::Real));
        tracing::debug!("{}", self.describe());
        // Rank 0 writes; where it fails, all ranks learn of it with the next step.
        if let Err(error) = self.history.row(&cells) {
            self.failed.get_or_insert(error);
        }
    }

    /// This rank's particles, as outcomes use them.
    pub(in crate::simulation) fn particles(&self) -> Vec<Particle> {
        let (columns, settings) = (&self.stepper.columns, &self.stepper.settings);
        let materials = self.scene.bodies.iter().map(|body| &self.scene.materials[body.material]);
        let vapour = Vapour::new(&columns.registry, &settings.view.core, materials);
        // A rigid body is one piece.
        let broken = |i, body| if settings.view.is_rigid(body) { 0.0 } else { settings.view.damage(columns, i, body) };
        let damage = |i, body| vapour.damage(columns, i, body, broken(i, body));
        let whole: Vec<usize> = self.scene.bodies.iter().enumerate().map(|(n, body)| body.whole(n)).collect();
        outcome::particles(columns, &settings.view.core, &settings.view.constants, &whole, damage)
    }

    pub(in crate::simulation) fn evaluate_outcome(&mut self) -> Evaluation {
        self.check_density();
        let start = Instant::now();
        self.stepper.release_buffers();
        resources::give_memory_back();
        let evaluation = outcome::evaluate(self.comm, &self.particles(), &self.question());
        self.stepper.phases.add(Phase::Outcome, start);
        evaluation
    }

    pub(in crate::simulation) fn question(&self) -> Question {
        let [target, projectile] = self.scene.impact.as_ref().map_or([0, 1], |i| [i.target, i.projectile]);
        let (target_mass, bodies) = (self.scene.bodies[target].whole_mass(), [target, projectile]);
        let others = self.scene.bodies.iter().enumerate().any(|(n, body)| !bodies.contains(&body.whole(n)));
        Question { dimension: D, target_mass, bodies, others }
    }

    /// Checks whether density is mass over volume, unless no particle has moved since the last check. Collective.
    pub(in crate::simulation) fn check_density(&mut self) {
        let now = self.stepper.check_density();
        if now.is_known() {
            self.density = now;
        }
    }

    /// When snapshots are due, where the scene requests them during the run.
    pub(in crate::simulation) fn due(&self) -> Option<Due> {
        match self.scene.output.snapshots {
            Snapshots::Every(every) => Some(Due { every }),
            Snapshots::AtEnd | Snapshots::Never => None,
        }
    }

    /// Writes a snapshot during the run; the last one is written at the end, after more important files. Collective.
    pub(in crate::simulation) fn write_snapshot_if_due(&mut self) -> Result<()> {
        let time = self.stepper.state.time;
        let is_due = |due: Due| due.same(due.next(self.state.snapshot_time, time), time);
        if !self.due().is_some_and(is_due) || self.is_over() {
            return Ok(());
        }
        self.write_snapshot()
    }

    pub(in crate::simulation) fn write_snapshot(&mut self) -> Result<()> {
        let start = Instant::now();
        self.state.snapshots += 1;
        self.state.snapshot_time = Some(self.stepper.state.time);
        let name = snapshot::name(self.state.snapshots);
        let figures = [
            ("energy_drift".to_string(), self.state.conservation.energy_drift()),
            ("momentum_drift".to_string(), self.state.conservation.momentum),
            ("angular_momentum_drift".to_string(), self.state.conservation.angular_momentum),
        ];
        let output = &self.scene.output;
        let scene = self.scene;
        let names = |(number, body): (usize, &Body)| {
            [scene.bodies[body.whole(number)].name.as_str(), scene.material_names[body.material].as_str()]
        };
        let bodies: Vec<[&str; 2]> = scene.bodies.iter().enumerate().map(names).collect();
        let members = self.members.as_ref().filter(|members| members.step == self.stepper.state.step);
        let written = Snapshot {
            columns: &self.stepper.columns,
            view: &self.stepper.settings.view,
            time: self.stepper.state.time,
            step: self.stepper.state.step,
            scene: &self.scene.to_toml(),
            late_stage: self.state.late.is_some(),
            bodies: &bodies,
            derived: &self.temperatures(),
            in_largest: members.map(|members| &members.in_largest[..]),
            figures: &figures,
            storage: Storage {
                single_precision: output.precision == Precision::F32,
                gzip: (output.compression > 0).then_some(output.compression),
            },
        };
        let collective = written.write(&self.options.directory.join(&name), self.comm)?;
        if !collective && self.comm.is_root() {
            tracing::warn!("{name} was not written collectively");
        }
        let series = self.options.directory.join("snapshots.vtkhdf.series");
        snapshot::extend_series(&series, &name, self.stepper.state.time, self.comm)?;
        self.stepper.phases.add(Phase::Output, start);
        Ok(())
    }

    pub(in crate::simulation) fn write_checkpoint(&mut self) -> Result<()> {
        let start = Instant::now();
        let mut state = self.state.clone();
        state.spent = self.spent();
        let saved = Saved { step: &self.stepper.state, counters: &self.stepper.counters, run: &state };
        let meta = CheckpointMeta {
            scene: self.scene.to_toml(),
            json: serde_json::to_string(&saved).map_err(|e| Error::new(e.to_string()))?,
            ..CheckpointMeta::default()
        };
        let id = self.stepper.settings.view.core.id;
        checkpoint::write(&self.options.directory, &self.stepper.columns, id, &meta, self.comm)?;
        self.saved = Instant::now();
        self.stepper.phases.add(Phase::Output, start);
        Ok(())
    }

    /// The cost of the run so far, over all ranks. Collective.
    pub(in crate::simulation) fn spent(&self) -> Spent {
        let before = &self.state.spent;
        let counters = &self.stepper.counters;
        let micro = |seconds: f64| (1e6 * seconds) as i64;
        let mut sums = [
            micro(resources::cpu_seconds() - self.cpu_at_start)
                - micro(self.comm.wait_cpu_seconds() - self.wait_cpu_at_start),
            micro(self.comm.wait_seconds() - self.wait_at_start),
            counters.pairs as i64,
            counters.updates as i64,
            counters.migrated as i64,
        ];
        self.comm.all_sum(&mut sums);
        Spent {
            wall: before.wall + self.started.elapsed().as_secs_f64(),
            cpu: before.cpu + 1e-6 * sums[0] as f64,
            wait: before.wait + 1e-6 * sums[1] as f64,
            pairs: before.pairs + sums[2] as u64,
            updates: before.updates + sums[3] as u64,
            migrated: before.migrated + sums[4] as u64,
        }
    }
}
