//! What rigid bodies that do not adhere do to a chunk, and it to them: see [`contact`](super::contact).

use super::contact::{push, touch};
use super::derivatives::Derivatives;
use super::workspace::Workspace;
use crate::pair::Rows;

impl Derivatives<'_> {
    /// Pushes what touches rigid bodies away from them, and these by as much.
    pub fn push_apart(&self, rows: &Rows, workspace: &mut Workspace) {
        let (Some(contact), Some(rigid)) = (&self.settings.contact, &self.settings.rigid) else { return };
        let (view, moment) = (&self.settings.view, self.moment);
        let layout = self.settings.pair_loop.layout();
        let [density, sound_speed] = [view.core.density.value, view.core.sound_speed].map(|c| self.chunk.view(c));
        let position = self.chunk.view(view.core.position);
        let Workspace { sums, bodies, rates, flow, loads, touches, .. } = workspace;
        for (k, i) in self.chunk.range.clone().enumerate() {
            let (sums, body) = (&sums[k], bodies[k] as usize);
            if view.is_rigid(body) {
                continue;
            }
            let least = contact.least(self.chunk, k, sums.fill, moment.stage == 0, moment.step == 0);
            let push = push(sums.fill, least);
            if push == 0.0 {
                continue;
            }
            let pressure = push * density.get(k) * sound_speed.get(k) * sound_speed.get(k);
            let volume = rows.records[rows.slots[i] as usize * layout.stride() + layout.volume()];
            let mass = view.constants[body].particle_mass;
            flow[k].heating += pressure * volume / mass * sums.filling;
            touch(layout, self.settings.pair_loop.kernel, rows, i, self.owners, touches);
            for touch in touches.drain(..) {
                let force = -(pressure * volume) * touch.gradient;
                let accelerations = &rates.acceleration[k * layout.dimension..(k + 1) * layout.dimension];
                accelerations.iter().zip(&force).for_each(|(a, force)| a.set(a.get() + force / mass));
                // What is not finite is found with all other rates.
                if force.iter().sum::<f64>().is_finite() {
                    rigid.push(touch.body as usize, self.rigid, position.get(k), -force, loads);
                }
            }
        }
    }
}
