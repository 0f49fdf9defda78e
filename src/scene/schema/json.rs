//! JSON Schemas as editors of TOML read them: draft 7, every definition where it is used, no null, aliases as alternatives.

use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde_json::{Map, Value, json};

/// Key under which a type says by which other name one of its alternatives goes.
pub const ALIAS: &str = "x-alias";
/// Key of an alternative that is another one under its alias.
pub const ALIAS_OF: &str = "x-alias-of";

/// The schema of a type.
pub fn of<T: JsonSchema>(title: &str) -> Value {
    let settings = SchemaSettings::draft07().with(|settings| settings.inline_subschemas = true);
    let mut schema = settings.into_generator().into_root_schema_for::<T>().to_value();
    clean(&mut schema);
    schema["title"] = title.into();
    schema
}

/// Takes out what TOML does not have and what says nothing, and writes aliases out.
fn clean(schema: &mut Value) {
    match schema {
        Value::Array(items) => items.iter_mut().for_each(clean),
        Value::Object(object) => {
            object.values_mut().for_each(clean);
            if let Some(Value::Array(alternatives)) = object.get_mut("oneOf") {
                let others: Vec<Value> = alternatives.iter().filter_map(under_alias).collect();
                alternatives.extend(others);
            }
            without_null(object);
            if object.get("format").is_some_and(|format| format.as_str().is_some_and(is_width)) {
                object.remove("format");
            }
            if object.get("default") == Some(&Value::Null) {
                object.remove("default");
            }
            if let Some(Value::String(text)) = object.get_mut("description") {
                *text = text.split_whitespace().collect::<Vec<_>>().join(" ");
            }
        }
        _ => {}
    }
}

/// Whether a format only names the bits of a number.
fn is_width(format: &str) -> bool {
    ["uint", "int", "double", "float"].iter().any(|kind| format.starts_with(kind))
}

/// TOML has no null: what may be left out is not required, and that says it.
fn without_null(object: &mut Map<String, Value>) {
    let null = json!({ "type": "null" });
    if let Some(Value::Array(types)) = object.get_mut("type") {
        types.retain(|kind| kind != "null");
        if let [single] = &types[..] {
            let single = single.clone();
            object.insert("type".into(), single);
        }
    }
    if let Some(Value::Array(values)) = object.get_mut("enum") {
        values.retain(|value| !value.is_null());
    }
    let Some(Value::Array(alternatives)) = object.get_mut("anyOf") else { return };
    alternatives.retain(|alternative| *alternative != null);
    if let [Value::Object(single)] = &alternatives[..] {
        let single = single.clone();
        object.remove("anyOf");
        for (key, value) in single {
            object.entry(key).or_insert(value);
        }
    }
}

/// The same alternative under its other name.
fn under_alias(alternative: &Value) -> Option<Value> {
    let alias = alternative.get(ALIAS)?.as_str()?;
    let mut other = alternative.clone();
    let object = other.as_object_mut()?;
    object.remove(ALIAS);
    let name = match object.get("const").cloned() {
        Some(name) => {
            object.insert("const".into(), alias.into());
            name
        }
        None => {
            let properties = object.get_mut("properties")?.as_object_mut()?;
            let name = properties.keys().next()?.clone();
            let keys = properties.remove(&name)?;
            properties.insert(alias.into(), keys);
            object.insert("required".into(), json!([alias]));
            name.into()
        }
    };
    object.insert(ALIAS_OF.into(), name);
    Some(other)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Length;

    #[derive(JsonSchema)]
    #[serde(rename_all = "snake_case")]
    #[expect(dead_code, reason = "only described")]
    enum Form {
        /// Round.
        #[schemars(extend("x-alias" = "disc"))]
        Ball(Option<Length>),
    }

    #[derive(JsonSchema)]
    #[expect(dead_code, reason = "only described")]
    struct Formless {
        form: Option<Form>,
    }

    #[test]
    fn an_alternative_has_its_alias_once_where_it_may_be_left_out() {
        let schema = of::<Formless>("Perhaps a form");
        assert_eq!(schema["properties"]["form"]["oneOf"].as_array().unwrap().len(), 2, "{schema:#}");
    }

    #[test]
    fn aliases_are_alternatives_and_null_is_none() {
        let schema = of::<Form>("A form");
        let alternatives = schema["oneOf"].as_array().unwrap();
        let [ball, disc] = &alternatives[..] else { panic!("{schema:#}") };
        assert_eq!((&ball["required"], &disc["required"]), (&json!(["ball"]), &json!(["disc"])));
        assert_eq!((&disc[ALIAS_OF], &disc["properties"]["disc"]["x-unit"]), (&json!("ball"), &json!("m")));
        assert!(!schema.to_string().contains("null"), "{schema:#}");
    }
}
