//! `[restitution]`: a body that hits another and bounces.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::named;
use crate::error::Result;
use crate::scene::document::source::Document;
use crate::scene::tables::body::validated::Body;
use crate::scene::tables::gravity::GravitySettings;

/// A body that hits another: how fast their centres of mass part at the end, over how fast they approached at the start.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RestitutionTable {
    /// Name of the body that bounces.
    body: String,
    /// Name of the body that it hits; that may be held.
    against: String,
    /// Whether the run ends before its given end, once both have parted for half as long as they were in contact.
    #[serde(default)]
    ends_run: bool,
}

/// A body that hits another, by their numbers.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct RestitutionSettings {
    pub body: usize,
    pub against: usize,
    pub ends_run: bool,
}

impl RestitutionTable {
    pub fn validate(
        &self,
        document: &Document,
        bodies: &[Body],
        gravity: &GravitySettings,
    ) -> Result<RestitutionSettings> {
        let body = named::body(document, "restitution.body", &self.body, bodies)?;
        let against = named::body(document, "restitution.against", &self.against, bodies)?;
        if body == against {
            let what = "a body does not hit itself";
            return Err(document.error("restitution.against", what).allowed("another body"));
        }
        if gravity.any() {
            let what = "gravity changes the speeds before and after a bounce";
            return Err(document.error("restitution", what).allowed("a scene without gravity"));
        }
        let velocity = |body: usize| bodies[body].motion.start(bodies[body].velocity);
        if velocity(body) == velocity(against) {
            let what = format!("`{}` and `{}` do not approach each other", self.body, self.against);
            return Err(document.error("restitution.body", what).allowed("bodies of different velocities"));
        }
        Ok(RestitutionSettings { body, against, ends_run: self.ends_run })
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::Scene;

    const BALLS: &str = "[[body]]\nname = \"ball\"\nshape = { sphere = { radius = 1 } }\nmaterial = \"basalt\"\nspacing = 0.5\n\
        velocity = [2, 0, 0]\n[[body]]\nname = \"wall\"\nshape = { box = { size = [1, 4, 4] } }\nposition = [3, 0, 0]\n\
        motion = \"fixed\"\nmaterial = \"basalt\"\nspacing = 0.5\n[run]\nuntil = 1\n\
        [restitution]\nbody = \"ball\"\nagainst = \"wall\"\n";

    fn parse(change: &str) -> crate::error::Result<Scene> {
        Scene::parse("s.toml", BALLS, &[change.to_string()])
    }

    #[test]
    fn a_bounce_that_cannot_be_measured_is_refused() {
        let found = parse("title=x").unwrap_or_else(|e| panic!("{e}")).restitution.expect("a bounce");
        assert_eq!((found.body, found.against, found.ends_run), (0, 1, false));
        for (change, expected) in [
            ("restitution.body=bal", "--set restitution.body=bal: unknown body `bal`"),
            ("restitution.against=ball", "a body does not hit itself (allowed: another body)"),
            ("gravity.uniform=[0, 0, -9]", "gravity changes the speeds before and after a bounce"),
            ("ball.velocity=[0, 0, 0]", "`ball` and `wall` do not approach each other"),
        ] {
            let text = parse(change).expect_err(change).to_string();
            assert!(text.contains(expected) && !text.contains('\n'), "{change}: {text}");
        }
    }
}
