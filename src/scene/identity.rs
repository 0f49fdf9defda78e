//! Whether a checkpoint belongs to a scene. When a run is to end, what it writes, and how it is called may change at a restart;
//! any other key that differs is named.

use std::fmt;

use toml::{Table, Value};

use super::validated::Scene;

/// Keys of `[run]` that may change at a restart.
const OF_RUN: [&str; 4] = ["until", "steps", "max_time", "checkpoint_every"];
/// Longer values are cut in messages, to this many characters.
const LONGEST_VALUE: usize = 40;
/// So many keys are named at most.
const MOST_KEYS: usize = 4;

/// A key whose values differ.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    /// Dotted, with numbers for items of lists.
    pub key: String,
    pub before: Option<Value>,
    pub now: Option<Value>,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let said = |value: &Option<Value>| match value.as_ref().map(Value::to_string) {
            None => "absent".to_string(),
            Some(text) if text.chars().count() > LONGEST_VALUE => {
                text.chars().take(LONGEST_VALUE).chain("...".chars()).collect()
            }
            Some(text) => text,
        };
        write!(f, "`{}` was {} and now is {}", self.key, said(&self.before), said(&self.now))
    }
}

impl Scene {
    /// What this scene says other than the one that is understood as `before`, in what a restart may not change; none where it
    /// says the same.
    pub fn differs_from(&self, before: &str) -> Option<String> {
        let [before, now] = [before, &self.to_toml()].map(|text| fixed(text.parse().unwrap_or_default()));
        let names = body_names(&now);
        let found = differences(&before, &now);
        let mut told: Vec<String> = found.iter().take(MOST_KEYS).map(|one| as_set(one, &names).to_string()).collect();
        if found.len() > MOST_KEYS {
            told.push(format!("{} more", found.len() - MOST_KEYS));
        }
        (!told.is_empty()).then(|| told.join(", "))
    }
}

/// What a restart may not change. A search may ask for more, or less, of the impacts that it has.
fn fixed(mut scene: Table) -> Table {
    ["title", "output", "threshold"].into_iter().for_each(|key| drop(scene.remove(key)));
    if let Some(run) = scene.get_mut("run").and_then(Value::as_table_mut) {
        OF_RUN.into_iter().for_each(|key| drop(run.remove(key)));
    }
    scene
}

/// Every key whose values differ.
pub fn differences(before: &Table, now: &Table) -> Vec<Difference> {
    let mut found = Vec::new();
    tables("", before, now, &mut found);
    found
}

fn tables(key: &str, before: &Table, now: &Table, found: &mut Vec<Difference>) {
    let below = |name: &str| if key.is_empty() { name.to_string() } else { format!("{key}.{name}") };
    for (name, value) in before {
        match now.get(name) {
            Some(other) => values(&below(name), value, other, found),
            None => found.push(Difference { key: below(name), before: Some(value.clone()), now: None }),
        }
    }
    let added = now.iter().filter(|(name, _)| !before.contains_key(*name));
    found.extend(added.map(|(name, value)| Difference { key: below(name), before: None, now: Some(value.clone()) }));
}

fn values(key: &str, before: &Value, now: &Value, found: &mut Vec<Difference>) {
    match (before, now) {
        (Value::Table(before), Value::Table(now)) => tables(key, before, now, found),
        (Value::Array(before), Value::Array(now)) if before.len() == now.len() => {
            for (k, (before, now)) in before.iter().zip(now).enumerate() {
                values(&format!("{key}.{k}"), before, now, found);
            }
        }
        (before, now) if before == now => {}
        (before, now) => {
            found.push(Difference { key: key.into(), before: Some(before.clone()), now: Some(now.clone()) })
        }
    }
}

fn body_names(scene: &Table) -> Vec<String> {
    let bodies = scene.get("body").and_then(Value::as_array);
    let name = |body: &Value| Some(body.get("name")?.as_str()?.to_string());
    bodies.into_iter().flatten().map(|body| name(body).unwrap_or_default()).collect()
}

/// With the key as `--set` takes it: a body by its name, the keys of its shape directly.
fn as_set(difference: &Difference, names: &[String]) -> Difference {
    let mut steps: Vec<&str> = difference.key.split('.').collect();
    let name = steps.get(1).and_then(|number| names.get(number.parse::<usize>().ok()?));
    if let Some(name) = name.filter(|_| steps[0] == "body") {
        steps.splice(..2, [name.as_str()]);
        if steps.len() > 3 && steps[1] == "shape" {
            steps.drain(1..3);
        }
    }
    Difference { key: steps.join("."), ..difference.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(before: &str, now: &str) -> Vec<String> {
        differences(&before.parse().unwrap(), &now.parse().unwrap()).iter().map(Difference::to_string).collect()
    }

    #[test]
    fn differences_are_named() {
        assert!(told("a = 1\n[b]\nc = [1, 2]", "a = 1\n[b]\nc = [1, 2]").is_empty());
        assert_eq!(told("[b]\nc = [1, 2]", "[b]\nc = [1, 3]"), ["`b.c.1` was 2 and now is 3"]);
        assert_eq!(
            told("a = 1\nb = 2", "c = 3"),
            ["`a` was 1 and now is absent", "`b` was 2 and now is absent", "`c` was absent and now is 3"]
        );
        let long = told("a = 1", &format!("a = \"{}\"", "x".repeat(100)));
        assert!(long[0].ends_with("xxx...") && long[0].len() < 80, "{long:?}");
    }

    const SCENE: &str = "title = \"one\"\n[[body]]\nname = \"target\"\nshape = { sphere = { radius = \"1 km\" } }\n\
        material = \"basalt\"\nparticles = 300\n[[body]]\nname = \"projectile\"\n\
        shape = { sphere = { radius = \"200 m\" } }\nmaterial = \"basalt\"\n[impact]\nspeed = \"3 km/s\"\n\
        [threshold]\nvary = \"projectile.radius\"\n[run]\nuntil = \"2 s\"\n";

    #[test]
    fn a_restart_may_change_the_end_and_what_is_written() {
        let scene = |set: &[&str]| {
            let set: Vec<String> = set.iter().map(|text| text.to_string()).collect();
            Scene::parse("a.toml", SCENE, &set).unwrap_or_else(|e| panic!("{e}"))
        };
        let before = scene(&[]).to_toml();
        for change in [
            "title=two",
            "run.until=40 s",
            "run.until=settled",
            "run.max_time=7 s",
            "run.steps=7",
            "run.checkpoint_every=1 s",
            "output.every=0.1 s",
            "output.precision=f32",
            "output.history_every=3",
            "output.mpi_io_hints.cb_nodes=4",
            "threshold.tolerance=0.2",
        ] {
            assert_eq!(scene(&[change]).differs_from(&before), None, "{change}");
            assert_ne!(scene(&[change]).to_toml(), before, "{change}");
        }
        for (change, says) in [
            ("projectile.radius=250 m", "`projectile.radius` was "),
            ("target.particles=301", "`target.particles` was 300 and now is 301"),
            ("impact.speed=4 km/s", "`impact.speed` was "),
            ("numerics.eta=1.3", "`numerics.eta` was 1.2 and now is 1.3"),
            ("record.peak_pressure=true", "`record.peak_pressure` was "),
        ] {
            let told = scene(&[change]).differs_from(&before).unwrap_or_default();
            assert!(told.contains(says), "{change}: {told}");
        }
        let many =
            ["numerics.eta=1.3", "numerics.cfl=0.1", "numerics.skin=0.2", "impact.speed=4 km/s", "impact.angle=9 deg"];
        assert!(scene(&many).differs_from(&before).is_some_and(|told| told.ends_with(", 1 more")));
    }
}
