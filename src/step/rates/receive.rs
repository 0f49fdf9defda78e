//! What particles receive from some of their neighbours.

use super::columns::RateColumns;
use crate::math::Vec3;
use crate::pair::Rows;
use crate::particles::Chunk;
use crate::step::derivatives::power;
use crate::step::settings::StepSettings;
use crate::step::workspace::Workspace;

/// Writes acceleration and heating of a chunk's particles by the neighbours in their rows.
pub fn receive(settings: &StepSettings, chunk: &Chunk, rows: &Rows, columns: &RateColumns, workspace: &mut Workspace) {
    let layout = settings.pair_loop.layout();
    let stride = layout.stride();
    settings.pair_loop.sum(rows, chunk.range.clone(), &mut workspace.sums);
    let (acceleration, heating) = columns.targets();
    let (ids, acceleration) = (chunk.view(settings.view.core.id), chunk.view(acceleration));
    let heating = heating.map(|column| chunk.view(column));
    for (k, i) in chunk.range.clone().enumerate() {
        let sums = &workspace.sums[k];
        let record = &rows.records[rows.slots[i] as usize * stride..][..stride];
        let inverse_density = record[layout.volume()] / settings.view.constants[ids.get(k).body()].particle_mass;
        acceleration.set(k, Vec3::from(sums.force) * inverse_density);
        if let Some(heating) = &heating {
            heating.set(k, inverse_density * power(layout, record, sums));
        }
    }
}
