//! Materials: what a scene says of one, filled up from the library. The equation of state always comes from the library
//! unless the scene has its own; any other table is there only if the scene names it, at every depth, and then the keys
//! that the scene leaves out come from the library.

use std::collections::BTreeSet;

use toml::{Table, Value};

use crate::error::Result;
use crate::scene::document::keys::unknown;
use crate::scene::document::source::{Document, rivals};

const LIBRARY: &str = include_str!("../../material/library.toml");

/// Replaces the tree's `[material]` by the complete tables of every material that a body is made of.
pub fn complete(document: &mut Document) -> Result<()> {
    let library: Table = LIBRARY.parse().expect("the library is valid TOML: a test reads it");
    let viscosity = document.tree.get("numerics").and_then(|n| n.get("viscosity")) != Some(&Value::Boolean(false));
    let own = match document.tree.get("material") {
        None => Table::new(),
        Some(Value::Table(own)) => own.clone(),
        Some(_) => return Err(document.error("material", "`material` is not a table").allowed("[material.basalt]")),
    };
    let bodies = document.tree.get("body").and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
    let used: Vec<(String, &str)> = bodies.iter().enumerate().flat_map(|(number, body)| named(number, body)).collect();
    let different: BTreeSet<&str> = used.iter().map(|(_, name)| *name).collect();
    if let Some(name) = own.keys().find(|name| !different.contains(name.as_str())) {
        let known: Vec<String> = different.into_iter().map(str::to_string).collect();
        return Err(unknown(document, &format!("material.{name}"), "material: no body is made of", name, &known));
    }
    let mut all = Table::new();
    for (place, name) in &used {
        if !all.contains_key(*name) {
            let complete = material(document, &library, name, own.get(*name), place, viscosity)?;
            all.insert(name.to_string(), Value::Table(complete));
        }
    }
    document.tree.insert("material".into(), Value::Table(all));
    Ok(())
}

/// Where a body names materials, and which: its own, and those of what comes from a file.
fn named(number: usize, body: &Value) -> Vec<(String, &str)> {
    let own = body.get("material").and_then(Value::as_str).map(|name| (format!("body.{number}.material"), name));
    let others = body.get("from").and_then(|from| from.get("materials")?.as_table()).into_iter().flatten();
    let others =
        others.filter_map(|(origin, name)| Some((format!("body.{number}.from.materials.{origin}"), name.as_str()?)));
    own.into_iter().chain(others).collect()
}

/// The complete tables of one material; `place` is where a body names it.
fn material(
    document: &Document,
    library: &Table,
    name: &str,
    own: Option<&Value>,
    place: &str,
    viscosity: bool,
) -> Result<Table> {
    let mut own = match own {
        None => Table::new(),
        Some(Value::Table(own)) => own.clone(),
        Some(_) => return Err(document.error(&format!("material.{name}"), "not a table")),
    };
    let based = own.remove("base");
    let (base, place) = match &based {
        None => (name, place.to_string()),
        Some(base) => (base.as_str().unwrap_or(""), format!("material.{name}.base")),
    };
    let stored = library.get(base).and_then(Value::as_table).filter(|_| base != EVERY);
    if stored.is_none() && (based.is_some() || !own.contains_key("eos")) {
        let known: Vec<String> = library.keys().filter(|k| *k != EVERY).cloned().collect();
        return Err(unknown(document, &place, "material", base, &known));
    }
    let mut complete = Table::new();
    let defaults = |key: &str| {
        [stored.and_then(|s| s.get(key)), library[EVERY].get(key)].into_iter().flatten().filter_map(Value::as_table)
    };
    let eos = own.remove("eos").or_else(|| stored?.get("eos").map(without_sources));
    if let Some(mut eos) = eos {
        fill_same_law(&mut eos, stored.and_then(|s| s.get("eos")));
        complete.insert("eos".into(), eos);
    }
    if viscosity {
        own.entry("viscosity").or_insert(Value::Boolean(true));
    } else {
        own.remove("viscosity");
    }
    for (key, value) in own {
        match value {
            Value::Boolean(false) => continue,
            Value::Boolean(true) => complete.insert(key.clone(), Value::Table(Table::new())),
            other => complete.insert(key.clone(), other),
        };
        if let Some(table) = complete[key.as_str()].as_table_mut() {
            defaults(&key).for_each(|from| fill(table, from));
        }
    }
    Ok(complete)
}

/// Key of the library's defaults for all materials.
const EVERY: &str = "every";

/// Fills up a law's parameters from the library where the scene's law is the library's.
fn fill_same_law(eos: &mut Value, stored: Option<&Value>) {
    for (law, parameters) in eos.as_table_mut().into_iter().flatten() {
        let stored = stored.and_then(|s| s.get(law)).and_then(Value::as_table);
        if let (Some(parameters), Some(stored)) = (parameters.as_table_mut(), stored) {
            // A law needs its tables, but for those that the scene takes from it.
            let is_taken = |key: &str| parameters.get(key) == Some(&Value::Boolean(false));
            let tables: Vec<_> = stored.iter().filter(|(key, value)| value.is_table() && !is_taken(key)).collect();
            fill(parameters, stored);
            for (key, value) in tables {
                parameters.entry(key.as_str()).or_insert_with(|| without_sources(value));
            }
        }
    }
}

/// Adds the keys that `table` leaves out, but for those that a key of its own stands in place of, and for what it sets to
/// `false`; a table within is filled only where it is named.
fn fill(table: &mut Table, from: &Table) {
    for (key, value) in from.iter().filter(|(key, _)| *key != SOURCE) {
        let Value::Table(inner_from) = value else {
            // Where there are other words for the same, `false` leaves it to these; elsewhere a number cannot be absent.
            if rivals(key).next().is_some() && table.get(key) == Some(&Value::Boolean(false)) {
                table.remove(key);
            } else if rivals(key).all(|rival| !table.contains_key(rival)) {
                table.entry(key.as_str()).or_insert_with(|| value.clone());
            }
            continue;
        };
        match table.get_mut(key) {
            Some(Value::Boolean(false)) => {
                table.remove(key);
            }
            Some(inner @ Value::Boolean(true)) => *inner = without_sources(value),
            Some(Value::Table(inner)) => fill(inner, inner_from),
            _ => {}
        }
    }
}

/// Key under which the library says where numbers come from.
const SOURCE: &str = "source";

fn without_sources(value: &Value) -> Value {
    let Value::Table(table) = value else { return value.clone() };
    let kept = table.iter().filter(|(key, _)| *key != SOURCE);
    Value::Table(kept.map(|(key, value)| (key.clone(), without_sources(value))).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::MaterialTable;
    use crate::scene::document::source::SourceText;

    fn completed(text: &str) -> Result<Table> {
        let source = SourceText::new("s.toml", text, &[]);
        let mut document = Document::parse(&source)?;
        complete(&mut document)?;
        Ok(document.tree["material"].as_table().unwrap().clone())
    }

    const BODY: &str = "[[body]]\nmaterial = \"basalt\"\n";

    /// Every table of numbers names its source, and every material is complete enough for its equation of state.
    #[test]
    fn the_library_is_sound() {
        let library: Table = LIBRARY.parse().unwrap();
        fn sourced(path: &str, table: &Table) {
            let numbers = table.iter().any(|(_, v)| !v.is_table());
            assert!(
                !numbers || table.get(SOURCE).is_some_and(|s| !s.as_str().unwrap().is_empty()),
                "{path} has no source"
            );
            for (key, inner) in table.iter().filter_map(|(k, v)| Some((k, v.as_table()?))) {
                sourced(&format!("{path}.{key}"), inner);
            }
        }
        sourced("library", &library);
        for name in library.keys().filter(|name| *name != EVERY) {
            let stored = library[name].as_table().unwrap();
            let mut text = format!("[[body]]\nmaterial = \"{name}\"\n[material.{name}]\n");
            for table in stored.keys().filter(|k| !["eos", "porosity"].contains(&k.as_str())) {
                text += &format!("{table} = true\n");
            }
            let porosity = stored.get("porosity").and_then(Value::as_table);
            let laws = porosity.into_iter().flatten().filter(|(_, law)| law.is_table());
            let porous = laws.map(|(law, _)| format!("{text}porosity = {{ {law} = true }}\n"));
            for text in porous.chain([text.clone()]) {
                let table: MaterialTable =
                    completed(&text).unwrap()[name].clone().try_into().unwrap_or_else(|e| panic!("{name}: {e}"));
                table.validate(name).unwrap();
            }
        }
    }

    #[test]
    fn tables_are_there_only_if_named() {
        let plain = completed(BODY).unwrap();
        assert!(plain["basalt"].get("strength").is_none() && plain["basalt"].get("fracture").is_none());
        assert_eq!(plain["basalt"]["viscosity"]["alpha"].as_float(), Some(1.5));
        assert!(plain["basalt"]["eos"]["tillotson"].get("source").is_none());
        let strong = completed(&format!("{BODY}[material.basalt.strength]\nshear_modulus = 1e9\n")).unwrap();
        assert_eq!(strong["basalt"]["strength"]["shear_modulus"].as_float(), Some(1e9));
        assert_eq!(strong["basalt"]["strength"]["yield_strength"].as_str(), Some("3.5 GPa"));
        assert!(strong["basalt"]["strength"].get("melting").is_none());
        let melting = completed(&format!("{BODY}[material.basalt.strength.melting]\n")).unwrap();
        assert_eq!(melting["basalt"]["strength"]["melting"]["energy"].as_str(), Some("3.4e6 J/kg"));
        let inviscid = completed(&format!("{BODY}[numerics]\nviscosity = false\n")).unwrap();
        assert!(inviscid["basalt"].get("viscosity").is_none());
    }

    #[test]
    fn materials_inherit_and_override() {
        let text = "[[body]]\nmaterial = \"weak\"\n[material.weak]\nbase = \"basalt\"\neos = { tillotson = { rho_0 = 2000 } }\n\
            [material.weak.fracture]\nweibull_m = 8\n";
        let weak = &completed(text).unwrap()["weak"];
        assert_eq!(weak["eos"]["tillotson"]["rho_0"].as_integer(), Some(2000));
        assert_eq!(weak["eos"]["tillotson"]["a"].as_float(), Some(0.5));
        assert_eq!(weak["fracture"]["weibull_k"].as_str(), Some("4.0e29 cm^-3"));
        assert_eq!(weak["fracture"]["model"].as_str(), Some("grady_kipp"));
        let gas = completed(&format!("{BODY}[material.basalt]\neos = {{ ideal_gas = {{ gamma = 1.4 }} }}\n")).unwrap();
        assert!(gas["basalt"]["eos"].get("tillotson").is_none());
    }

    /// A key that says the same in another way takes the place of the library's.
    #[test]
    fn choices_replace_those_of_the_library() {
        let law = |keys: &str| {
            let text = format!("{BODY}[material.basalt.porosity]\nepsilon_alpha = {{ {keys} }}\n");
            completed(&text).unwrap()["basalt"]["porosity"]["epsilon_alpha"].as_table().unwrap().clone()
        };
        assert!(law("kappa = 0.8").contains_key("P_e"));
        let own = law("elastic_strain = 0.01");
        assert!(!own.contains_key("P_e") && own["kappa"].as_float() == Some(1.0), "{own}");
        assert!(!law("P_e = false").contains_key("P_e"));
        // What is set over a scene replaces the library's choice, too, whatever the scene says.
        let text =
            format!("{BODY}[material.basalt.strength.collins]\n[material.basalt.porosity.epsilon_alpha]\nP_e = 5\n");
        let set = [
            "material.basalt.porosity.epsilon_alpha.elastic_strain=0",
            "material.basalt.strength.drucker_prager.friction=0.4",
        ];
        let source = SourceText::new("s.toml", text, &set.map(String::from));
        let mut document = Document::parse(&source).unwrap();
        complete(&mut document).unwrap();
        let basalt = &document.tree["material"]["basalt"];
        assert!(basalt["strength"].get("collins").is_none() && basalt["strength"].get("drucker_prager").is_some());
        assert!(basalt["porosity"]["epsilon_alpha"].get("P_e").is_none());
    }

    /// `false` takes a table away that a law has in the library, and says nothing of a number that nothing else stands for.
    #[test]
    fn tables_of_a_law_may_be_taken_away() {
        let dust = |keys: &str| {
            let text = format!("[[body]]\nmaterial = \"silica_dust\"\n[material.silica_dust]\n{keys}\n");
            completed(&text).unwrap()["silica_dust"].as_table().unwrap().clone()
        };
        let law = |keys: &str| {
            dust(&format!("eos = {{ sirono = {{ {keys} }} }}"))["eos"]["sirono"].as_table().unwrap().clone()
        };
        assert!(law("").contains_key("tension") && law("").contains_key("compression"));
        let loose = law("tension = false");
        assert!(!loose.contains_key("tension") && loose.contains_key("compression"));
        assert_eq!(law("gamma = false")["gamma"].as_bool(), Some(false));
        assert_eq!(dust("viscosity = { speed = false }")["viscosity"]["speed"].as_bool(), Some(false));
    }

    #[test]
    fn unknown_materials_are_named() {
        let text = completed("[[body]]\nmaterial = \"basal\"\n").unwrap_err().to_string();
        assert!(text.contains("unknown material `basal`, did you mean `basalt`?"), "{text}");
        let text = completed(&format!("{BODY}[material.bassalt.strength]\n")).unwrap_err().to_string();
        assert!(text.contains("s.toml:3") && text.contains("`bassalt`, did you mean `basalt`?"), "{text}");
        let text = completed("[[body]]\nmaterial = \"every\"\n").unwrap_err().to_string();
        assert!(text.contains("unknown material `every`"), "{text}");
    }
}
