//! Numbers that are allowed and still unlikely: those without a unit that no matter has, as numbers in cgs typed as SI are.
//!
//! ```text
//! solids            20 kg/m^3 <= rho <= 3e4 kg/m^3      1 m/s <= c_L <= 14 km/s      lightest foams, osmium; dust, boron carbide
//! moduli, strength  <= 1e12 Pa, <= 2e10 Pa                                           diamond: 4.4e11 Pa
//! energies          <= 3e9 J/kg                                                      Tillotson's E_0 of basalt: 4.9e8 J/kg
//! speeds, lengths   < 1e5 m/s, <= 1e9 m                                              orbits of the solar system; Jupiter: 7e7 m
//! ```
//! c_L longitudinal speed of sound at the start. What is written with its unit is meant as it stands.

use toml::{Table, Value};

use crate::scene::document::source::Document;
use crate::scene::tables::body::validated::Body;
use crate::scene::validated::Scene;

/// kg/m^3
const DENSITIES: [f64; 2] = [20.0, 3e4];
/// m/s
const SOUND: [f64; 2] = [1.0, 1.4e4];
/// Pa
const STIFFEST: f64 = 1e12;
const STRONGEST: f64 = 2e10;
/// J/kg
const MOST_ENERGY: f64 = 3e9;
/// m/s
const FASTEST: f64 = 1e5;
/// m
const LARGEST: f64 = 1e9;

/// Units that numbers are understood in, and those of cgs that may have been meant.
const CGS: [(&str, &str); 5] =
    [("kg/m^3", "g/cm^3"), ("Pa", "dyn/cm^2"), ("J/kg", "erg/g"), ("m/s", "cm/s"), ("m", "cm")];

/// A number that stands in the scene without a unit, and the unit that it gets.
struct Bare {
    path: String,
    value: f64,
    unit: String,
}

impl Scene {
    /// What is unlikely about the scene, one line each, with file, line and key.
    pub fn warnings(&self) -> Vec<String> {
        let Ok(document) = Document::parse(&self.source) else { return Vec::new() };
        let Ok(understood) = self.understood.parse::<Table>() else { return Vec::new() };
        let mut bare = Vec::new();
        collect("", &Value::Table(document.tree.clone()), &Value::Table(understood), &mut bare);
        let single = bare.iter().filter_map(|number| {
            let (what, value) = (self.oddity(number)?, in_short(number.value));
            let unit = &number.unit;
            let cgs = CGS.iter().find(|(si, _)| si == unit).map_or(unit.as_str(), |(_, cgs)| cgs);
            let place = document.place(&number.path);
            Some(format!("{place}: {value} without a unit is {value} {unit}, {what}; in cgs it is \"{value} {cgs}\""))
        });
        let single: Vec<String> = single.collect();
        let sound = self.bodies.iter().enumerate().filter_map(|(number, body)| {
            let first = self.bodies[..number].iter().all(|other| other.material != body.material);
            self.odd_sound(body, &bare)
                .filter(|_| first)
                .map(|(path, what)| format!("{}: {what}", document.place(path)))
        });
        single.into_iter().chain(sound).collect()
    }

    /// What is said of a number that no matter has.
    fn oddity(&self, number: &Bare) -> Option<&'static str> {
        let (value, mut path) = (number.value.abs(), number.path.split('.'));
        let (table, name) = (path.next()?, path.next().unwrap_or_default());
        let material = match table {
            "material" => self.material_names.iter().position(|own| own == name),
            "body" => name.parse().ok().and_then(|k: usize| self.bodies.get(k)).map(|body| body.material),
            _ => None,
        };
        let solid = material.is_some_and(|k| self.materials[k].reference_density().is_some());
        let bears = number.path.contains(".strength.") && !number.path.ends_with(".shear_modulus");
        match number.unit.as_str() {
            "m/s" if value >= FASTEST => Some("faster than anything that orbits the sun"),
            "m" if value > LARGEST => Some("larger than any planet"),
            "kg/m^3" if solid && value < DENSITIES[0] => Some("lighter than any solid"),
            "kg/m^3" if solid && value > DENSITIES[1] => Some("denser than any solid"),
            "Pa" if solid && bears && value > STRONGEST => Some("stronger than any matter"),
            "Pa" if solid && value > STIFFEST => Some("stiffer than any matter"),
            "J/kg" if solid && value > MOST_ENERGY => Some("more than vaporises any matter"),
            _ => None,
        }
    }

    /// The key without a unit that gives the body a speed of sound that no solid has.
    fn odd_sound<'b>(&self, body: &Body, bare: &'b [Bare]) -> Option<(&'b str, String)> {
        let (material, name) = (&self.materials[body.material], &self.material_names[body.material]);
        let density = body.density * body.distention;
        material.reference_density()?;
        let (_, bulk) = material.eos.law().pressure(density, body.internal_energy);
        let shear = material.strength.as_ref().map_or(0.0, |table| table.shear_modulus.0);
        let sound = (bulk * bulk + 4.0 / 3.0 * shear / density).sqrt();
        if (SOUND[0]..=SOUND[1]).contains(&sound) {
            return None;
        }
        let eos = format!("material.{name}.eos.");
        let stiffness = |number: &&Bare| {
            number.path.starts_with(&eos) && number.unit == "Pa"
                || number.path == format!("material.{name}.strength.shear_modulus")
        };
        let weight = |number: &&Bare| number.path.starts_with(&eos) && number.unit == "kg/m^3";
        let culprit = bare.iter().find(stiffness).or_else(|| bare.iter().find(weight))?;
        let what =
            format!("sound in `{name}` comes to {sound:.2e} m/s, as in no solid: are its numbers without unit SI?");
        Some((&culprit.path, what))
    }
}

/// Numbers of the scene that are quantities where it is printed as understood.
fn collect(path: &str, written: &Value, understood: &Value, found: &mut Vec<Bare>) {
    let below = |key: &str| if path.is_empty() { key.to_string() } else { format!("{path}.{key}") };
    match (written, understood) {
        (Value::Table(written), Value::Table(understood)) => {
            let both = written.iter().filter_map(|(key, value)| Some((key, value, understood.get(key)?)));
            both.for_each(|(key, value, other)| collect(&below(key), value, other, found));
        }
        (Value::Array(written), Value::Array(understood)) => {
            for (k, (value, other)) in written.iter().zip(understood).enumerate() {
                let place = if value.is_table() { below(&k.to_string()) } else { path.to_string() };
                collect(&place, value, other, found);
            }
        }
        (Value::Integer(_) | Value::Float(_), Value::String(text)) => {
            let quantity = text.split_once(' ').and_then(|(value, unit)| Some((value.parse().ok()?, unit)));
            found.extend(quantity.map(|(value, unit)| Bare { path: path.into(), value, unit: unit.into() }));
        }
        _ => {}
    }
}

fn in_short(value: f64) -> String {
    if value == 0.0 || (1e-3..1e5).contains(&value.abs()) { format!("{value}") } else { format!("{value:e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MINE: &str = "eos = { tillotson = { rho_0 = 2.7, a = 0.5, b = 1.5, A = 2.67e11, B = 2.67e11, E_0 = 4.87e12, \
        E_iv = 4.72e10, E_cv = 1.82e11, alpha = 5, beta = 5 } }\n\
        strength = { shear_modulus = 2.27e11, yield_strength = 3.5e10 }\n";

    fn warnings(material: &str, overrides: &[&str]) -> Vec<String> {
        let text = format!(
            "[[body]]\nname = \"target\"\nshape = {{ sphere = {{ radius = 5e5 }} }}\nmaterial = \"mine\"\nparticles = 1000\n\
             [[body]]\nname = \"projectile\"\nshape = {{ sphere = {{ radius = 5e4 }} }}\nmaterial = \"mine\"\n\
             [impact]\nspeed = 5e5\n[material.mine]\nbase = \"basalt\"\n{material}"
        );
        let overrides: Vec<String> = overrides.iter().map(|text| text.to_string()).collect();
        Scene::parse("s.toml", &text, &overrides).unwrap_or_else(|e| panic!("{e}")).warnings()
    }

    #[test]
    fn numbers_in_cgs_are_told_with_their_keys() {
        let found = warnings(MINE, &[]);
        for (k, says) in [
            "s.toml:11: impact.speed: 5e5 without a unit is 5e5 m/s, faster than anything that orbits the sun; in cgs it is \"5e5 cm/s\"",
            "s.toml:14: material.mine.eos.tillotson.rho_0: 2.7 without a unit is 2.7 kg/m^3, lighter than any solid",
            "s.toml:14: material.mine.eos.tillotson.E_0: 4.87",
            "s.toml:14: material.mine.eos.tillotson.E_iv: 4.72",
            "s.toml:14: material.mine.eos.tillotson.E_cv: 1.82",
            "s.toml:15: material.mine.strength.yield_strength: 3.5",
            "s.toml:14: material.mine.eos.tillotson.A: sound in `mine` comes to 4.59e5 m/s",
        ]
        .iter()
        .enumerate()
        {
            assert!(found.get(k).is_some_and(|line| line.starts_with(says)), "{says}\n{found:#?}");
        }
        assert_eq!(found.len(), 7, "{found:#?}");
    }

    /// Moduli alone in cgs show in the speed of sound; what has a unit, and what is SI, is not spoken of.
    #[test]
    fn likely_numbers_are_not_warned_about() {
        let si = ["impact.speed=5e3"];
        assert_eq!(warnings("", &si), [""; 0]);
        assert_eq!(
            warnings(
                "eos = { tillotson = { rho_0 = 2700, A = 2.67e10 } }\nstrength = { shear_modulus = 2.27e10 }\n",
                &si
            ),
            [""; 0]
        );
        let units = ["impact.speed=500 km/s", "target.density=\"2.7 kg/m^3\""];
        assert_eq!(warnings("", &units), [""; 0]);
        let moduli = warnings("eos = { tillotson = { A = 2.67e11 } }\nstrength = { shear_modulus = 2.27e11 }\n", &si);
        assert!(
            moduli.len() == 1 && moduli[0].contains("tillotson.A: sound in `mine` comes to 1.45e4 m/s"),
            "{moduli:?}"
        );
        let giga = warnings("eos = { tillotson = { A = 26.7 } }\n", &si);
        assert!(giga.len() == 1 && giga[0].contains("as in no solid"), "{giga:?}");
        let dense = warnings("", &[si[0], "target.density=2.7"]);
        assert!(dense[0].starts_with("--set target.density=2.7: 2.7 without a unit"), "{dense:?}");
    }
}
