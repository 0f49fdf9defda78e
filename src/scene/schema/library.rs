//! What a scene may leave to the material library, which the types do not know: a material starts from one of the library, its tables
//! may be `true` or `false`, and keys that are left out come from there. See `reading::library`.

use serde_json::{Map, Value, json};

/// Key of a schema whose value comes from the library where the scene leaves it out.
pub const FROM_LIBRARY: &str = "x-from-library";

/// Opens the materials of a scene's schema for what the library fills in.
pub fn complete(scene: &mut Value) {
    let Some(material) = scene.pointer_mut("/properties/material/additionalProperties") else { return };
    open(material);
    if let Some(keys) = material.get_mut("properties").and_then(Value::as_object_mut) {
        let about = "Material of the library to start from; the one of the same name without it.";
        keys.insert("base".into(), json!({ "type": "string", "description": about }));
    }
    for law in ["p_alpha", "rho_alpha"] {
        let path =
            format!("/properties/porosity/anyOf/1/properties/{law}/anyOf/1/properties/measured/anyOf/1/properties");
        if let Some(keys) = material.pointer_mut(&path).and_then(Value::as_object_mut) {
            let about = "Instead of both: a file with columns of pressure, in Pa, and distention; its path from the scene's folder.";
            keys.insert("file".into(), json!({ "type": "string", "description": about }));
        }
    }
}

/// Keys of a table may be left out, and its tables may be switched.
fn open(schema: &mut Value) {
    let Some(object) = schema.as_object_mut() else { return };
    if let Some(Value::Array(alternatives)) = object.get_mut("oneOf") {
        let tables =
            alternatives.iter_mut().filter_map(|alternative| alternative.get_mut("properties")?.as_object_mut());
        tables.flat_map(|keys| keys.values_mut()).for_each(open);
        return;
    }
    let required = object.remove("required").unwrap_or_default();
    let required: Vec<String> = serde_json::from_value(required).unwrap_or_default();
    let Some(Value::Object(keys)) = object.get_mut("properties") else { return };
    for (name, key) in keys {
        open(key);
        if let Some(key) = key.as_object_mut() {
            switchable(key);
            if required.contains(name) {
                key.insert(FROM_LIBRARY.into(), true.into());
            }
        }
    }
}

/// A key that may be `false`, and `true` where it is a table. What is said about it stays outside.
fn switchable(key: &mut Map<String, Value>) {
    let is_table = key.contains_key("properties") || key.contains_key("oneOf");
    let switch = if is_table { json!({ "type": "boolean" }) } else { json!({ "const": false }) };
    let outside = ["description", "default"];
    let said: Vec<_> = outside.iter().filter_map(|name| key.remove_entry(*name)).collect();
    let value = std::mem::take(key);
    key.insert("anyOf".into(), json!([switch, value]));
    key.extend(said);
}
