//! `[fragments]`: what has become of a body, or of two that have collided.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::named;
use crate::error::Result;
use crate::scene::document::source::Document;
use crate::scene::tables::body::validated::Body;
use crate::scene::values::checks::{POSITIVE, Range, positive, within};
use crate::units::{Length, Number};

/// What has become of a body, or of two that have collided, at the end of the run: masses of its pieces with a power law; of two
/// bodies also whether they stick, bounce or break.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FragmentsTable {
    /// Names of one body or of two; only their particles count.
    #[schemars(length(min = 1, max = 2))]
    bodies: Vec<String>,
    /// Particles nearer than this belong to one piece.
    #[schemars(extend("x-allowed" = POSITIVE))]
    #[schemars(extend("x-default" = "the kernel's support, 2 h"))]
    link: Option<Length>,
    /// Particles that a piece must have for the power law.
    #[serde(default = "ten")]
    #[schemars(range(min = 1))]
    least_particles: u64,
    /// Share of its matter that a body must keep in one piece, or the collision counts as fragmentation.
    #[serde(default = "most")]
    #[schemars(range(min = 0.5, max = 1))]
    intact: Number,
}

const INTACT: Range = [0.5, 1.0];

fn ten() -> u64 {
    10
}

fn most() -> Number {
    Number::new(0.9)
}

/// What has become of a body, or of two that have collided.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct FragmentsSettings {
    /// Numbers of the two; the same twice where there is one.
    pub bodies: [usize; 2],
    /// m; the kernel's support without it.
    pub link: Option<f64>,
    pub least_particles: u64,
    pub intact: f64,
}

impl FragmentsTable {
    pub fn validate(&self, document: &Document, bodies: &[Body]) -> Result<FragmentsSettings> {
        let find = |name: &String| named::body(document, "fragments.bodies", name, bodies);
        let found = self.bodies.iter().map(find).collect::<Result<Vec<_>>>()?;
        let bodies = match found[..] {
            [one] => [one, one],
            [first, second] if first != second => [first, second],
            _ => {
                let what = format!("{} bodies, or one twice", found.len());
                return Err(document.error("fragments.bodies", what).allowed("the names of one body or of two"));
            }
        };
        if self.least_particles == 0 {
            let what = "a piece has particles";
            return Err(document.error("fragments.least_particles", what).allowed("1 and more"));
        }
        let link = self.link.map(|link| positive(document, "fragments.link", link)).transpose()?;
        let intact = within(document, "fragments.intact", self.intact, INTACT)?;
        Ok(FragmentsSettings { bodies, link, least_particles: self.least_particles, intact })
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::Scene;

    const BALLS: &str = "[[body]]\nname = \"a\"\nshape = { sphere = { radius = 1 } }\nmaterial = \"basalt\"\nspacing = 0.5\n\
        [[body]]\nname = \"b\"\nshape = { sphere = { radius = 1 } }\nposition = [3, 0, 0]\nmaterial = \"basalt\"\nspacing = 0.5\n\
        [run]\nuntil = 1\n[fragments]\nbodies = [\"a\", \"b\"]\n";

    fn parse(change: &str) -> crate::error::Result<Scene> {
        Scene::parse("s.toml", BALLS, &[change.to_string()])
    }

    #[test]
    fn one_body_or_two() {
        let found = |change| parse(change).unwrap_or_else(|e| panic!("{e}")).fragments.expect("fragments");
        let two = found("title=x");
        assert_eq!((two.bodies, two.link, two.least_particles, two.intact), ([0, 1], None, 10, 0.9));
        assert_eq!(found("fragments.bodies=[\"b\"]").bodies, [1, 1]);
        assert_eq!(found("fragments.link=20 cm").link, Some(0.2));
        for (change, expected) in [
            ("fragments.bodies=[]", "0 bodies, or one twice (allowed: the names of one body or of two)"),
            ("fragments.bodies=[\"a\", \"a\"]", "2 bodies, or one twice"),
            ("fragments.bodies=[\"c\"]", "unknown body `c`"),
            ("fragments.link=-1", "is not positive (allowed: more than 0)"),
            ("fragments.least_particles=0", "a piece has particles (allowed: 1 and more)"),
            ("fragments.intact=0.4", "0.4 is out of range (allowed: 0.5 to 1)"),
        ] {
            let text = parse(change).expect_err(change).to_string();
            assert!(text.contains(expected) && !text.contains('\n'), "{change}: {text}");
        }
    }
}
