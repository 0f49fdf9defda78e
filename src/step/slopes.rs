//! The velocity gradients that carry values to the middle of pairs (`pair::reconstruction`): those of the last step's first evaluation.

use crate::material::ParticleView;
use crate::math::{Mat3, Sym, Vec3};
use crate::pair::reconstruction::slope;
use crate::particles::{Chunk, Column, ColumnInfo, Columns, Life, Registry};

/// Columns of the six components.
#[derive(Debug, Clone, Copy)]
pub struct Slopes {
    diagonal: Column<Vec3>,
    off_diagonal: Column<Vec3>,
}

const COLUMNS: [(&str, &str); 2] = [
    ("slope_diagonal", "Velocity gradient by which viscosity is reconstructed: xx, yy, zz."),
    ("slope_off_diagonal", "Velocity gradient by which viscosity is reconstructed: xy, xz, yz; in 2D xy alone."),
];

impl Slopes {
    pub fn declare(registry: &mut Registry) {
        for (name, about) in COLUMNS {
            let info = ColumnInfo { name, unit: "1/s", about, life: Life::Kept, snapshot: false };
            registry.owner("reconstruction").column::<Vec3>(info);
        }
    }

    pub fn find(registry: &Registry) -> Option<Self> {
        Some(Self { diagonal: registry.find(COLUMNS[0].0)?, off_diagonal: registry.find(COLUMNS[1].0)? })
    }

    /// Keeps the gradient of a chunk's particle; none where its neighbours say nothing reliable about it.
    #[inline]
    pub fn keep(&self, chunk: &Chunk, k: usize, view: &ParticleView, gradient: Option<&Mat3>) {
        let body = chunk.view(view.core.id).get(k).body();
        let (h, c) = (view.smoothing_length(chunk, k, body), view.viscous_speed(chunk, k, body));
        let s = gradient.map_or(Sym::ZERO, |gradient| slope(gradient, h, c));
        chunk.view(self.diagonal).set(k, Vec3::new(s.xx, s.yy, s.zz));
        chunk.view(self.off_diagonal).set(k, Vec3::new(s.xy, s.xz, s.yz));
    }

    pub fn of(&self, columns: &Columns, i: usize) -> Sym {
        let (on, off) = (columns.get(self.diagonal, i), columns.get(self.off_diagonal, i));
        Sym { xx: on.x, yy: on.y, zz: on.z, xy: off.x, xz: off.y, yz: off.z }
    }
}
