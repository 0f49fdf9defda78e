//! The walk: down the tree for one target, adding whole cells where they are far and single bodies where they are near.

use rayon::prelude::*;

use super::Target;
use super::moments::Field;
use super::tree::Tree;
use crate::math::Vec3;

/// x^2 + y^2 + z^2, rounded the same way wherever distances decide about opening.
#[inline]
pub(super) fn squared(x: f64, y: f64, z: f64) -> f64 {
    (x * x + y * y) + z * z
}

impl Tree {
    /// The field at one of the targets that the tree was built for. Sums run in the order of the tree, which is the same on
    /// every rank that holds the target.
    pub fn field<F: Field>(&self, target: &Target) -> F {
        let mut field = F::default();
        let mut at = 0;
        while let Some(node) = self.nodes.get(at) {
            let x = target.position - node.centre();
            let r2 = squared(x.x, x.y, x.z);
            if node.is_far(r2, target.softening) {
                field.add_cell(&node.moments(), &x, r2);
                at += node.extent();
                continue;
            }
            for source in &self.sources[node.sources()] {
                if source.id != target.id {
                    let x = target.position - Vec3::from(source.position);
                    field.add_body(source.mass, source.softening.max(target.softening), &x);
                }
            }
            at += 1;
        }
        field
    }

    /// The field at many targets, by all threads of the rank.
    pub fn fields<F: Field>(&self, targets: &[Target]) -> Vec<F> {
        targets.par_iter().with_min_len(64).map(|target| self.field(target)).collect()
    }
}
