//! Quantities with units, as scenes and the material library write them: `"50 km"`, `"7e9 dyn/cm^2"`, `"4.0e29 cm^-3"`,
//! or a bare number, which is SI. The dimension is part of the type, so a length given in kilograms is an error that names
//! the unit found and the expected one. Inside the program everything is SI: `.0` is the number.

use std::borrow::Cow;
use std::fmt;
use std::str::FromStr;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserialize, Deserializer, Visitor};
use serde::ser::{Serialize, Serializer};

use crate::error::{Error, Result};

/// A number of SI units of dimension length^L mass^M time^T.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Default)]
pub struct Quantity<const LENGTH: i8, const MASS: i8, const TIME: i8>(pub f64);

pub type Number = Quantity<0, 0, 0>;
/// m
pub type Length = Quantity<1, 0, 0>;
/// m^3
pub type Volume = Quantity<3, 0, 0>;
/// kg
pub type Mass = Quantity<0, 1, 0>;
/// s
pub type Time = Quantity<0, 0, 1>;
/// m/s
pub type Speed = Quantity<1, 0, -1>;
/// m/s^2
pub type Acceleration = Quantity<1, 0, -2>;
/// Pa
pub type Pressure = Quantity<-1, 1, -2>;
/// kg/m^3
pub type Density = Quantity<-3, 1, 0>;
/// J
pub type Energy = Quantity<2, 1, -2>;
/// J/kg
pub type SpecificEnergy = Quantity<2, 0, -2>;
/// 1/s; a rate of rotation may also be given in rad/s or deg/s.
pub type Frequency = Quantity<0, 0, -1>;
/// 1/m^3
pub type NumberDensity = Quantity<-3, 0, 0>;

/// An angle in radians; `"45 deg"`, `"0.5 rad"` or a bare number of radians.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Default)]
pub struct Angle(pub f64);

/// Exponents of length, mass, time and angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Dimension([i8; 4]);

const ANGLE: Dimension = Dimension([0, 0, 0, 1]);

/// The name of a dimension, the unit it is printed in, and examples for a scene.
struct Kind {
    dimension: Dimension,
    name: &'static str,
    unit: &'static str,
    examples: &'static str,
}

const fn kind(dimension: [i8; 4], name: &'static str, unit: &'static str, examples: &'static str) -> Kind {
    Kind { dimension: Dimension(dimension), name, unit, examples }
}

const KINDS: [Kind; 14] = [
    kind([0, 0, 0, 0], "a pure number", "", "a number without unit"),
    kind([0, 0, 0, 1], "an angle", "rad", "\"45 deg\", \"0.5 rad\", or a number of rad"),
    kind([1, 0, 0, 0], "a length", "m", "\"50 km\", \"3 cm\", \"1e-6 m\", or a number of m"),
    kind([3, 0, 0, 0], "a volume", "m^3", "\"2 m^3\", \"5 cm^3\", or a number of m^3"),
    kind([0, 1, 0, 0], "a mass", "kg", "\"2 kg\", \"5 g\", or a number of kg"),
    kind([0, 0, 1, 0], "a time", "s", "\"100 s\", \"2 ms\", \"3 h\", \"1 day\", or a number of s"),
    kind([1, 0, -1, 0], "a speed", "m/s", "\"5 km/s\", \"10 cm/s\", or a number of m/s"),
    kind([1, 0, -2, 0], "an acceleration", "m/s^2", "\"9.81 m/s^2\", or a number of m/s^2"),
    kind([-1, 1, -2, 0], "a pressure", "Pa", "\"3.5 GPa\", \"7e9 dyn/cm^2\", \"2 Mbar\", or a number of Pa"),
    kind([-3, 1, 0, 0], "a density", "kg/m^3", "\"2700 kg/m^3\", \"2.7 g/cm^3\", or a number of kg/m^3"),
    kind([2, 1, -2, 0], "an energy", "J", "\"3 J\", \"1e7 erg\", or a number of J"),
    kind([2, 0, -2, 0], "a specific energy", "J/kg", "\"1e5 J/kg\", \"3e10 erg/g\", or a number of J/kg"),
    kind([0, 0, -1, 0], "a rate", "1/s", "\"2e-4 rad/s\", \"3 1/s\", \"10 Hz\", or a number of 1/s"),
    kind([-3, 0, 0, 0], "a number density", "m^-3", "\"4.0e29 cm^-3\", \"1e35 m^-3\", or a number of m^-3"),
];

/// A unit: its dimension and its size in SI, `factor * 10^decimal`.
struct Unit {
    name: &'static str,
    dimension: [i8; 4],
    decimal: i32,
    factor: f64,
    takes_prefix: bool,
}

const fn unit(name: &'static str, dimension: [i8; 4], decimal: i32, takes_prefix: bool) -> Unit {
    Unit { name, dimension, decimal, factor: 1.0, takes_prefix }
}

const fn irregular(name: &'static str, dimension: [i8; 4], factor: f64) -> Unit {
    Unit { name, dimension, decimal: 0, factor, takes_prefix: false }
}

const UNITS: [Unit; 16] = [
    unit("m", [1, 0, 0, 0], 0, true),
    unit("s", [0, 0, 1, 0], 0, true),
    unit("g", [0, 1, 0, 0], -3, true),
    unit("Pa", [-1, 1, -2, 0], 0, true),
    unit("J", [2, 1, -2, 0], 0, true),
    unit("N", [1, 1, -2, 0], 0, true),
    unit("Hz", [0, 0, -1, 0], 0, true),
    unit("bar", [-1, 1, -2, 0], 5, true),
    unit("dyn", [1, 1, -2, 0], -5, false),
    unit("erg", [2, 1, -2, 0], -7, false),
    unit("rad", [0, 0, 0, 1], 0, false),
    irregular("deg", [0, 0, 0, 1], std::f64::consts::PI / 180.0),
    irregular("min", [0, 0, 1, 0], 60.0),
    irregular("h", [0, 0, 1, 0], 3600.0),
    irregular("day", [0, 0, 1, 0], 86_400.0),
    // The Julian year.
    irregular("yr", [0, 0, 1, 0], 31_557_600.0),
];

const PREFIXES: [(&str, i32); 9] =
    [("n", -9), ("u", -6), ("µ", -6), ("m", -3), ("c", -2), ("k", 3), ("M", 6), ("G", 9), ("T", 12)];

impl Dimension {
    fn kind(self) -> Option<&'static Kind> {
        KINDS.iter().find(|k| k.dimension == self)
    }

    /// The name for messages: "a length", or the unit where the dimension has no name.
    fn name(self) -> String {
        self.kind().map_or_else(|| format!("a quantity in {}", self.unit()), |k| k.name.to_string())
    }

    /// The SI unit in which a quantity of this dimension is printed.
    fn unit(self) -> String {
        if let Some(kind) = self.kind() {
            return kind.unit.to_string();
        }
        let powers = ["m", "kg", "s", "rad"].iter().zip(self.0).filter(|(_, power)| *power != 0);
        powers
            .map(|(name, power)| if power == 1 { name.to_string() } else { format!("{name}^{power}") })
            .collect::<Vec<_>>()
            .join(" ")
    }

    fn examples(self) -> String {
        self.kind().map_or_else(|| format!("\"1 {0}\", or a number of {0}", self.unit()), |k| k.examples.to_string())
    }

    /// Whether a value of dimension `found` is allowed where `self` is expected: a rate of rotation is a rate.
    fn accepts(self, found: Dimension) -> bool {
        self == found || (self.0 == [0, 0, -1, 0] && found.0 == [0, 0, -1, 1])
    }
}

/// The value in SI of a text with a unit, and its dimension; `None` where it is a bare number.
fn parse(text: &str) -> std::result::Result<(f64, Option<Dimension>), String> {
    let text = text.trim();
    let (number, unit_text) = text.split_at(number_length(text));
    let digits = number.replace('_', "");
    if digits.is_empty() {
        return Err("does not begin with a number".into());
    }
    let value: f64 = digits.parse().map_err(|_| format!("`{number}` is not a number"))?;
    if !value.is_finite() {
        return Err("is too large".into());
    }
    if unit_text.trim().is_empty() {
        return Ok((value, None));
    }
    let (dimension, decimal, factor) = parse_unit(unit_text)?;
    // Powers of ten go into the literal, so that "2.7 g/cm^3" has the bits of 2700.0.
    let (mantissa, exponent) = digits.split_once(['e', 'E']).unwrap_or((&digits, "0"));
    let exponent =
        exponent.parse::<i32>().ok().and_then(|e| e.checked_add(decimal)).ok_or("has too large an exponent")?;
    let scaled: f64 = format!("{mantissa}e{exponent}").parse().map_err(|_| format!("`{number}` is not a number"))?;
    let si = scaled * factor;
    if si.is_finite() { Ok((si, Some(dimension))) } else { Err("is too large".into()) }
}

/// Bytes of the number that `text` begins with.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits_from = |mut i: usize| {
        while i < bytes.len() && (bytes[i].is_ascii_digit() || bytes[i] == b'.' || bytes[i] == b'_') {
            i += 1;
        }
        i
    };
    let sign = |i: usize| i < bytes.len() && (bytes[i] == b'+' || bytes[i] == b'-');
    let end = digits_from(sign(0) as usize);
    if end < bytes.len() && (bytes[end] | 32) == b'e' {
        let from = end + 1 + sign(end + 1) as usize;
        let to = digits_from(from);
        if to > from {
            return to;
        }
    }
    end
}

/// Product and quotient of units with integer powers: dimension, power of ten, and remaining factor.
fn parse_unit(text: &str) -> std::result::Result<(Dimension, i32, f64), String> {
    let spaced = text.replace('*', " ").replace('/', " / ");
    let (mut dimension, mut decimal, mut factor) = ([0i8; 4], 0i32, 1.0f64);
    let mut divide = false;
    for token in spaced.split_whitespace() {
        if token == "/" {
            if divide {
                return Err(format!("has an unfinished unit `{}`", text.trim()));
            }
            divide = true;
            continue;
        }
        let (name, power) = token.split_once('^').unwrap_or((token, "1"));
        let power: i8 = power
            .parse()
            .ok()
            .filter(|p: &i8| p.abs() <= 9)
            .ok_or(format!("has a power `{power}` that is not a small integer"))?;
        let power = if std::mem::take(&mut divide) { -power } else { power };
        if name == "1" {
            continue;
        }
        let (unit, prefix) = find_unit(name).ok_or_else(|| unknown_unit(name))?;
        for (sum, exponent) in dimension.iter_mut().zip(unit.dimension) {
            *sum =
                exponent.checked_mul(power).and_then(|e| sum.checked_add(e)).ok_or("has too high a power of a unit")?;
        }
        decimal += (unit.decimal + prefix) * power as i32;
        for _ in 0..power.abs() {
            factor = if power > 0 { factor * unit.factor } else { factor / unit.factor };
        }
    }
    if divide {
        Err(format!("has an unfinished unit `{}`", text.trim()))
    } else {
        Ok((Dimension(dimension), decimal, factor))
    }
}

/// The unit of this name and the power of ten of its prefix.
fn find_unit(name: &str) -> Option<(&'static Unit, i32)> {
    if let Some(unit) = UNITS.iter().find(|u| u.name == name) {
        return Some((unit, 0));
    }
    PREFIXES.iter().find_map(|(prefix, decimal)| {
        let rest = name.strip_prefix(prefix)?;
        UNITS.iter().find(|u| u.takes_prefix && u.name == rest).map(|u| (u, *decimal))
    })
}

fn unknown_unit(name: &str) -> String {
    let names = UNITS.iter().map(|u| u.name).collect::<Vec<_>>().join(", ");
    format!("has an unknown unit `{name}`; units are {names}, with prefixes n u m c k M G T")
}

/// Reads `text` as a quantity of dimension `wanted`.
fn read(text: &str, wanted: Dimension) -> Result<f64> {
    let allowed = || wanted.examples();
    let (value, found) = parse(text)
        .map_err(|why| Error::new(format!("\"{text}\" {why}; {} is wanted", wanted.name())).allowed(allowed()))?;
    match found {
        Some(found) if !wanted.accepts(found) => {
            Err(Error::new(format!("\"{text}\" is {}; {} is wanted", found.name(), wanted.name())).allowed(allowed()))
        }
        _ => within_reach(value, wanted),
    }
}

/// The largest quantity in SI units, so that results computed with it stay finite. No matter comes near.
const LARGEST: f64 = 1e100;
/// Number densities may be larger: k of Weibull's law grows with its other parameter.
const COUNTS: Dimension = Dimension([-3, 0, 0, 0]);

fn within_reach(value: f64, wanted: Dimension) -> Result<f64> {
    if value.abs() <= LARGEST || (wanted == COUNTS && value.is_finite()) {
        return Ok(value);
    }
    let what = format!("{value:e} is too large; {} is wanted", wanted.name());
    Err(Error::new(what).allowed(format!("up to {LARGEST:e} {}", wanted.unit()).trim_end()))
}

/// The value in SI units of a text with any unit.
pub fn si(text: &str) -> Result<f64> {
    parse(text).map(|(value, _)| value).map_err(|why| Error::new(format!("\"{text}\" {why}")))
}

/// Prints `value` so that it reads back to the same bits.
fn write(f: &mut fmt::Formatter<'_>, value: f64, dimension: Dimension) -> fmt::Result {
    let size = value.abs();
    if value == 0.0 || (1e-3..1e7).contains(&size) {
        write!(f, "{value}")?
    } else {
        write!(f, "{value:e}")?
    }
    let unit = dimension.unit();
    if unit.is_empty() { Ok(()) } else { write!(f, " {unit}") }
}

impl<const L: i8, const M: i8, const T: i8> Quantity<L, M, T> {
    const DIMENSION: Dimension = Dimension([L, M, T, 0]);

    /// From a number of SI units.
    pub const fn new(si: f64) -> Self {
        Self(si)
    }
}

impl<const L: i8, const M: i8, const T: i8> fmt::Display for Quantity<L, M, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write(f, self.0, Self::DIMENSION)
    }
}

impl fmt::Display for Angle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write(f, self.0, ANGLE)
    }
}

impl<const L: i8, const M: i8, const T: i8> FromStr for Quantity<L, M, T> {
    type Err = Error;
    fn from_str(text: &str) -> Result<Self> {
        read(text, Self::DIMENSION).map(Self)
    }
}

impl FromStr for Angle {
    type Err = Error;
    fn from_str(text: &str) -> Result<Self> {
        read(text, ANGLE).map(Self)
    }
}

/// Accepts a text with a unit or a bare SI number.
struct QuantityVisitor(Dimension);

impl Visitor<'_> for QuantityVisitor {
    type Value = f64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} (allowed: {})", self.0.name(), self.0.examples())
    }

    fn visit_str<E: serde::de::Error>(self, text: &str) -> std::result::Result<f64, E> {
        read(text, self.0).map_err(E::custom)
    }

    fn visit_f64<E: serde::de::Error>(self, value: f64) -> std::result::Result<f64, E> {
        if !value.is_finite() {
            return Err(E::custom(format!("{value} is not finite; {} is wanted", self.0.name())));
        }
        within_reach(value, self.0).map_err(E::custom)
    }

    fn visit_i64<E: serde::de::Error>(self, value: i64) -> std::result::Result<f64, E> {
        Ok(value as f64)
    }

    fn visit_u64<E: serde::de::Error>(self, value: u64) -> std::result::Result<f64, E> {
        Ok(value as f64)
    }
}

impl<'de, const L: i8, const M: i8, const T: i8> Deserialize<'de> for Quantity<L, M, T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        deserializer.deserialize_any(QuantityVisitor(Self::DIMENSION)).map(Self)
    }
}

impl<'de> Deserialize<'de> for Angle {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        deserializer.deserialize_any(QuantityVisitor(ANGLE)).map(Self)
    }
}

impl<const L: i8, const M: i8, const T: i8> Serialize for Quantity<L, M, T> {
    /// A text with the SI unit; pure numbers as numbers.
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        if Self::DIMENSION == Dimension::default() {
            serializer.serialize_f64(self.0)
        } else {
            serializer.collect_str(self)
        }
    }
}

impl Serialize for Angle {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl Dimension {
    /// What a scene should write, for editors and for the pages of keys. Stricter than reading, where a bare number is SI: a checker asks
    /// for the unit, but of zero.
    fn schema(self) -> Schema {
        let unit = self.unit();
        if unit.is_empty() {
            return json_schema!({ "type": "number" });
        }
        json_schema!({
            "anyOf": [{ "type": "string", "pattern": with_unit() }, { "const": 0 }],
            "x-quantity": self.name(),
            "x-unit": unit,
        })
    }
}

/// A number and its unit, as a regular expression.
fn with_unit() -> String {
    let names = |prefixed: bool| {
        let names = UNITS.iter().filter(|unit| unit.takes_prefix == prefixed).map(|unit| unit.name);
        names.collect::<Vec<_>>().join("|")
    };
    let prefixes = PREFIXES.map(|(prefix, _)| prefix).concat();
    let unit = format!("(?:[{prefixes}]?(?:{})|{}|1)(?:\\^-?[0-9])?", names(true), names(false));
    format!("^ *[+-]?[0-9_.]+(?:[eE][+-]?[0-9]+)? *{unit}(?: *[ */] *{unit})* *$")
}

impl<const L: i8, const M: i8, const T: i8> JsonSchema for Quantity<L, M, T> {
    fn schema_name() -> Cow<'static, str> {
        Self::DIMENSION.name().into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        Self::DIMENSION.schema()
    }
}

impl JsonSchema for Angle {
    fn schema_name() -> Cow<'static, str> {
        ANGLE.name().into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        ANGLE.schema()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cgs_has_the_bits_of_si() {
        assert_eq!("7e9 dyn/cm^2".parse::<Pressure>().unwrap().0, 7e8);
        assert_eq!("2.7 g/cm^3".parse::<Density>().unwrap().0, 2700.0);
        assert_eq!("4.0e29 cm^-3".parse::<NumberDensity>().unwrap().0, 4e35);
        assert_eq!("3e10 erg/g".parse::<SpecificEnergy>().unwrap().0, 3e6);
        assert_eq!("2.67e11 dyn / cm^2".parse::<Pressure>().unwrap().0, 2.67e10);
        assert_eq!("3.5 Mbar".parse::<Pressure>().unwrap().0, 3.5e11);
        assert_eq!("0.1 mm".parse::<Length>().unwrap().0, 1e-4);
        assert_eq!("1_000 kg m^-3".parse::<Density>().unwrap().0, 1000.0);
        assert_eq!("2 N*m/kg".parse::<SpecificEnergy>().unwrap().0, 2.0);
    }

    #[test]
    fn times_and_angles() {
        assert_eq!("2 h".parse::<Time>().unwrap().0, 7200.0);
        assert_eq!("1 day".parse::<Time>().unwrap().0, 86_400.0);
        assert_eq!("3 min".parse::<Time>().unwrap().0, 180.0);
        // 365.25 days of 86400 s.
        assert_eq!("2 yr".parse::<Time>().unwrap().0, 63_115_200.0);
        assert_eq!("1 m/yr".parse::<Speed>().unwrap().0, 1.0 / 31_557_600.0);
        assert_eq!("180 deg".parse::<Angle>().unwrap().0, std::f64::consts::PI);
        assert_eq!("6 1/min".parse::<Frequency>().unwrap().0, 0.1);
        assert_eq!("2 rad/s".parse::<Frequency>().unwrap().0, 2.0);
        assert_eq!("36 km/h".parse::<Speed>().unwrap().0, 10.0);
    }

    #[test]
    fn printed_quantities_read_back_to_the_same_bits() {
        for n in 0..2000 {
            let value = (f64::from(n) * 0.618_033_988_749).fract()
                * 10f64.powi(n % 81 - 40)
                * if n % 2 == 0 { 1.0 } else { -1.0 };
            assert_eq!(
                Pressure::from_str(&Quantity::<-1, 1, -2>(value).to_string()).unwrap().0.to_bits(),
                value.to_bits()
            );
            assert_eq!(Angle::from_str(&Angle(value).to_string()).unwrap().0.to_bits(), value.to_bits());
            let odd = Quantity::<4, -2, 1>(value);
            assert_eq!(odd.to_string().parse::<Quantity<4, -2, 1>>().unwrap().0.to_bits(), value.to_bits());
        }
        assert_eq!(Length::from_str("50 km").unwrap().to_string(), "50000 m");
    }

    #[test]
    fn wrong_units_name_what_was_found_and_what_is_wanted() {
        let text = "50 kg".parse::<Length>().unwrap_err().to_string();
        assert_eq!(
            text,
            "\"50 kg\" is a mass; a length is wanted (allowed: \"50 km\", \"3 cm\", \"1e-6 m\", or a number of m)"
        );
        assert!("5 parsec".parse::<Length>().unwrap_err().to_string().contains("unknown unit `parsec`"));
        let text = "1e98 km".parse::<Length>().unwrap_err().to_string();
        assert_eq!(text, "1e101 is too large; a length is wanted (allowed: up to 1e100 m)");
        assert!("1e120 m^-3".parse::<NumberDensity>().is_ok() && "-1e101".parse::<Number>().is_err());
        assert!("45 deg".parse::<Number>().is_err());
        assert!("5 m".parse::<Angle>().is_err());
        for bad in
            ["", "km", "5 km/", "5 m//s", "1e999 m", "1.2.3 m", "5 m^x", "5 m^99", "--3 m", "nan", "inf m", "5 1e9"]
        {
            assert!(bad.parse::<Length>().is_err(), "{bad}");
        }
    }
}
