//! Bodies of blocks: `rubble`, a pile of spheres, and `joints`, rock that is parted into blocks.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::Result;
use crate::scene::document::source::Document;
use crate::scene::geometry::joints::Joints;
use crate::scene::geometry::rubble::{Packing, Rubble};
use crate::scene::geometry::shape::BodyShape;
use crate::units::{Length, Number};

const VOIDS: &str = "a share from 0 to below 1";
const BLOCKS: [u64; 2] = [2, 100_000];

/// A pile of spheres (in 2D discs) that do not overlap, most of which touch another. Where the material has fracture, blocks are broken
/// within a spacing of their surface and do not stick together.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RubbleTable {
    /// Smallest and largest radius of a block: `["20 m", "200 m"]`.
    radius: [Length; 2],
    /// Largest share of the shape's volume that is left empty between blocks.
    #[schemars(extend("x-allowed" = VOIDS))]
    voids: Number,
    /// Another seed gives another pile.
    #[serde(default = "first_seed")]
    seed: u64,
}

/// Fracture before the start: random blocks (Voronoi cells), broken within a spacing of a face between two.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JointsTable {
    /// Number of blocks.
    #[schemars(range(min = BLOCKS[0], max = BLOCKS[1]))]
    blocks: u64,
    /// Another seed gives other blocks.
    #[serde(default = "first_seed")]
    seed: u64,
}

fn first_seed() -> u64 {
    1
}

impl RubbleTable {
    pub fn validate(&self, document: &Document, path: &str, shape: &BodyShape, dimension: usize) -> Result<Rubble> {
        if !shape.has_depth(dimension) {
            let error = document.error(path, "blocks find no room in a shape from which something is taken away");
            return Err(error.allowed("shapes without a part with `minus`"));
        }
        let [smallest, largest] = self.radius.map(|radius| radius.0);
        if !(0.0 < smallest && smallest <= largest) {
            let what = format!("radii of blocks from {} to {}", self.radius[0], self.radius[1]);
            return Err(document
                .error(&format!("{path}.radius"), what)
                .allowed("two lengths above zero, the smaller first"));
        }
        let voids = &format!("{path}.voids");
        if !(0.0..1.0).contains(&self.voids.0) {
            let what = format!("voids are {}", self.voids);
            return Err(document.error(voids, what).allowed(VOIDS));
        }
        let packing = Packing { smallest, largest, voids: self.voids.0, seed: self.seed };
        Rubble::pack(shape, dimension, packing).map_err(|full| {
            let left = 1.0 - full.volume / shape.volume(dimension);
            let what =
                format!("voids of {} are not reached: {left:.3} are left beside {} blocks", self.voids, full.count());
            document.error(voids, what).allowed(format!("{:.2} or more, or smaller blocks", left + 0.005))
        })
    }
}

impl JointsTable {
    pub fn validate(&self, document: &Document, path: &str, shape: &BodyShape, dimension: usize) -> Result<Joints> {
        let [fewest, most] = BLOCKS;
        if !(fewest..=most).contains(&self.blocks) {
            let what = format!("{} blocks", self.blocks);
            return Err(document.error(&format!("{path}.blocks"), what).allowed(format!("{fewest} to {most}")));
        }
        Ok(Joints::new(shape, dimension, self.blocks as usize, self.seed))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::document::source::SourceText;

    #[test]
    fn what_cannot_be_piled_is_refused() {
        let source = SourceText::new("s.toml", "", &[]);
        let document = Document::parse(&source).expect("an empty scene");
        let said = |radius: [f64; 2], voids| {
            let table = RubbleTable { radius: radius.map(Length::new), voids: Number::new(voids), seed: 1 };
            let shape = BodyShape::Sphere { radius: 1.0 };
            table.validate(&document, "body.0.rubble", &shape, 3).unwrap_err().to_string()
        };
        assert!(said([0.2, 0.1], 0.5).contains("body.0.rubble.radius"));
        assert!(said([0.1, 0.2], 1.5).contains("voids are 1.5"));
        let full = said([0.2, 0.3], 0.1);
        assert!(full.contains("voids of 0.1 are not reached") && full.contains("or more, or smaller blocks"), "{full}");
    }
}
