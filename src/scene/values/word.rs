//! A word in the place of a quantity: `spacing = "target"`, `until = "settled"`.

use std::fmt;
use std::marker::PhantomData;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{IntoDeserializer, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// Reads `word` as none, anything else as a quantity.
pub fn word_or<'de, D: Deserializer<'de>, Q: Deserialize<'de>>(
    deserializer: D,
    word: &'static str,
) -> Result<Option<Q>, D::Error> {
    struct WordOr<Q>(&'static str, PhantomData<Q>);
    impl<'de, Q: Deserialize<'de>> Visitor<'de> for WordOr<Q> {
        type Value = Option<Q>;
        fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
            write!(f, "\"{}\" or a quantity with its unit", self.0)
        }
        fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<Self::Value, E> {
            if text == self.0 {
                return Ok(None);
            }
            Q::deserialize(text.into_deserializer()).map(Some).map_err(|e: E| {
                let message = e.to_string().replacen("(allowed: ", &format!("(allowed: \"{}\", ", self.0), 1);
                E::custom(message)
            })
        }
        fn visit_f64<E: serde::de::Error>(self, value: f64) -> Result<Self::Value, E> {
            Q::deserialize(value.into_deserializer()).map(Some)
        }
        fn visit_i64<E: serde::de::Error>(self, value: i64) -> Result<Self::Value, E> {
            Q::deserialize(value.into_deserializer()).map(Some)
        }
    }
    deserializer.deserialize_any(WordOr(word, PhantomData))
}

/// Writes what [`word_or`] reads.
pub fn serialize<S: Serializer, Q: Serialize>(
    quantity: Option<&Q>,
    word: &'static str,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    match quantity {
        None => serializer.serialize_str(word),
        Some(quantity) => quantity.serialize(serializer),
    }
}

/// What [`word_or`] accepts.
pub fn schema<Q: JsonSchema>(generator: &mut SchemaGenerator, word: &'static str) -> Schema {
    json_schema!({ "anyOf": [{ "const": word }, generator.subschema_for::<Q>()] })
}

/// The schema of a type that reads a word of its own or a quantity.
macro_rules! word_schema {
    ($value:ident, $quantity:ty) => {
        impl schemars::JsonSchema for $value {
            fn schema_name() -> std::borrow::Cow<'static, str> {
                stringify!($value).into()
            }

            fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
                $crate::scene::values::word::schema::<$quantity>(generator, Self::WORD)
            }
        }
    };
}
pub(in crate::scene) use word_schema;
