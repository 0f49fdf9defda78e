//! What identifies the answer of a run: its scene as it is understood, without what changes no result.

use toml::{Table, Value};

use super::Scene;

/// The scene as it is understood, without what changes no result: identifies what a run answers.
pub fn identity(scene: &Scene) -> String {
    blake3::hash(understood(&scene.to_toml()).to_string().as_bytes()).to_hex().to_string()
}

/// What [`identity`] is made of; `scene` as it is understood.
pub fn understood(scene: &str) -> Table {
    let mut table: Table = scene.parse().unwrap_or_default();
    table.remove("title");
    if let Some(output) = table.get_mut("output").and_then(Value::as_table_mut) {
        // Vibrations are sampled, and impacts found settled, where the history has a row.
        output.retain(|key, _| key == "history_every");
    }
    if let Some(run) = table.get_mut("run").and_then(Value::as_table_mut) {
        run.remove("checkpoint_every");
        // A run that these end has no result.
        if run.get("until").is_some_and(|until| until.as_str() != Some("settled")) {
            run.remove("steps");
            run.remove("max_time");
        }
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCENE: &str = "[[body]]\nname = \"ball\"\nshape = { disc = { radius = 1 } }\nmaterial = \"basalt\"\n\
        particles = 100\n[material.basalt.strength]\n[numerics]\neta = 1.4\n[run]\nuntil = 1\n";

    #[test]
    fn identity_knows_what_changes_an_answer() {
        let scene = |overrides: &[&str]| {
            let overrides: Vec<String> = overrides.iter().map(|text| text.to_string()).collect();
            Scene::parse("a.toml", SCENE, &overrides).map(|scene| identity(&scene)).unwrap_or_else(|e| panic!("{e}"))
        };
        let same = ["title=x", "output.picture=false", "output.snapshots=3", "run.checkpoint_every=5"];
        let disc = "dimension=2";
        assert!(same.iter().all(|change| scene(&[disc, change]) == scene(&[disc])));
        let other = ["run.until=2", "ball.radius=2", "numerics.eta=1.5", "output.history_every=3"];
        assert!(other.iter().all(|change| scene(&[disc, change]) != scene(&[disc])));
    }
}
