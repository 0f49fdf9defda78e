//! Vectors: a list with one quantity per dimension.

use std::borrow::Cow;
use std::fmt;
use std::marker::PhantomData;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{IntoDeserializer, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::error::Result;
use crate::scene::document::source::Document;
use crate::units::Quantity;

/// A vector with one component per dimension; a single number stands for a vector of one (the spin in 2D).
#[derive(Debug, Clone, PartialEq)]
pub struct Components<Q>(pub Vec<Q>);

impl<const L: i8, const M: i8, const T: i8> Components<Quantity<L, M, T>> {
    /// A vector of `count` zeros.
    pub fn zero(count: usize) -> Self {
        Self(vec![Quantity::new(0.0); count])
    }

    /// The SI numbers, the third 0 in 2D; an error at the key `path` where their number is not the scene's dimension.
    pub fn vector(&self, document: &Document, path: &str, dimension: usize) -> Result<[f64; 3]> {
        let given = self.0.len();
        if given != dimension {
            let what = format!("{given} component{} in {dimension} dimensions", if given == 1 { "" } else { "s" });
            return Err(document.error(path, what).allowed(format!("{dimension} components")));
        }
        let mut vector = [0.0; 3];
        vector.iter_mut().zip(&self.0).for_each(|(v, c)| *v = c.0);
        Ok(vector)
    }
}

impl<Q: Serialize> Serialize for Components<Q> {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        match &self.0[..] {
            [single] => single.serialize(serializer),
            several => several.serialize(serializer),
        }
    }
}

impl<'de, Q: Deserialize<'de>> Deserialize<'de> for Components<Q> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        struct OneOrMany<Q>(PhantomData<Q>);
        impl<'de, Q: Deserialize<'de>> Visitor<'de> for OneOrMany<Q> {
            type Value = Components<Q>;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a list with one component per dimension")
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> std::result::Result<Self::Value, A::Error> {
                let mut components = Vec::new();
                while let Some(component) = list.next_element()? {
                    components.push(component);
                }
                Ok(Components(components))
            }
            fn visit_str<E: serde::de::Error>(self, text: &str) -> std::result::Result<Self::Value, E> {
                Q::deserialize(text.into_deserializer()).map(|q| Components(vec![q]))
            }
            fn visit_f64<E: serde::de::Error>(self, value: f64) -> std::result::Result<Self::Value, E> {
                Q::deserialize(value.into_deserializer()).map(|q| Components(vec![q]))
            }
            fn visit_i64<E: serde::de::Error>(self, value: i64) -> std::result::Result<Self::Value, E> {
                Q::deserialize(value.into_deserializer()).map(|q| Components(vec![q]))
            }
        }
        deserializer.deserialize_any(OneOrMany(PhantomData))
    }
}

impl<Q: JsonSchema> JsonSchema for Components<Q> {
    fn schema_name() -> Cow<'static, str> {
        format!("Components_{}", Q::schema_name()).into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let component = generator.subschema_for::<Q>();
        json_schema!({ "anyOf": [{ "type": "array", "items": component }, component] })
    }
}
