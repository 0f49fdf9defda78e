//! Pages of keys for people, from a JSON Schema: one for each table.

use serde_json::{Map, Value};

use super::json::{ALIAS, ALIAS_OF};
use super::library::FROM_LIBRARY;

/// Columns of a page on the terminal.
const WIDTH: usize = 100;
/// Stands for the name that a scene gives a table.
const NAME: &str = "NAME";
/// Key of a schema that says in words what a default follows from.
const DEFAULT: &str = "x-default";
/// In the place of a default.
const REQUIRED: &str = "required";
const FROM_ELSEWHERE: &str = "the library's";

/// A table and its keys.
#[derive(Debug, Clone, PartialEq)]
pub struct Page {
    /// `body.shape`, `material.NAME`.
    pub path: String,
    /// Whether a scene has a list of such tables.
    pub list: bool,
    pub about: String,
    /// Whether the table has exactly one of its keys.
    pub one_of: bool,
    pub keys: Vec<Key>,
}

#[derive(Debug, Clone, PartialEq)]
pub struct Key {
    pub name: String,
    /// Type and unit.
    pub kind: String,
    pub default: String,
    pub allowed: String,
    pub about: String,
}

/// What a schema accepts, in words; the table in it, if it accepts one.
#[derive(Debug, Clone, Default)]
struct Form<'a> {
    kinds: Vec<String>,
    allowed: Vec<String>,
    /// What is said of single words.
    words: Vec<String>,
    table: Option<Inner<'a>>,
}

#[derive(Debug, Clone, Copy)]
struct Inner<'a> {
    schema: &'a Value,
    list: bool,
    /// Whether tables are told apart by names of the scene's own.
    named: bool,
}

/// The pages of a schema: that of its own keys, whose path is empty, and those of the tables below, each before the tables in it.
pub fn pages(schema: &Value) -> Vec<Page> {
    let mut found = Vec::new();
    let whole = Inner { schema, list: false, named: false };
    collect(String::new(), whole, text(schema, "description"), &mut found);
    found
}

fn collect(path: String, table: Inner, about: String, found: &mut Vec<Page>) {
    let path = if table.named { join(&path, NAME) } else { path };
    let (fields, one_of) = fields(table.schema);
    let at = found.len();
    found.push(Page { path: path.clone(), list: table.list, about, one_of, keys: Vec::new() });
    let mut keys = Vec::new();
    for Field { name, schema, required, mut about } in fields {
        let form = form(schema);
        let default = match schema.get("default") {
            Some(Value::Number(number)) => number.as_f64().map_or(number.to_string(), |number| number.to_string()),
            Some(value) if !value.is_object() && !value.is_array() => value.to_string(),
            _ if schema.get(DEFAULT).is_some() => text(schema, DEFAULT),
            _ if schema.get(FROM_LIBRARY).is_some() => FROM_ELSEWHERE.into(),
            _ if required && !one_of => REQUIRED.into(),
            _ => String::new(),
        };
        form.words.iter().for_each(|word| about = format!("{about} {word}"));
        keys.push(Key {
            name: name.clone(),
            kind: or(&form.kinds),
            default,
            allowed: form.allowed.join("; "),
            about: about.trim().into(),
        });
        if let Some(inner) = form.table {
            let own = text(inner.schema, "description");
            let said = &keys.last().expect("the key just found").about;
            let about = if own.is_empty() { said.clone() } else { own };
            collect(join(&path, name), inner, about, found);
        }
    }
    keys.sort_by_key(|key| key.default != REQUIRED);
    found[at].keys = keys;
}

fn join(path: &str, name: &str) -> String {
    if path.is_empty() { name.into() } else { format!("{path}.{name}") }
}

fn text(schema: &Value, key: &str) -> String {
    schema.get(key).and_then(Value::as_str).unwrap_or_default().into()
}

struct Field<'a> {
    name: &'a String,
    schema: &'a Value,
    required: bool,
    about: String,
}

/// The keys of a table; and whether there is exactly one of them.
fn fields(schema: &Value) -> (Vec<Field<'_>>, bool) {
    if let Some(alternatives) = schema.get("oneOf").and_then(Value::as_array) {
        let own = alternatives.iter().filter(|alternative| alternative.get(ALIAS_OF).is_none());
        // What is said of a kind of table stands outside its only key.
        let mut all = Vec::new();
        for alternative in own {
            let about = text(alternative, "description");
            for mut field in fields(alternative).0 {
                if !about.is_empty() {
                    field.about.clone_from(&about);
                }
                all.push(field);
            }
        }
        return (all, true);
    }
    let required = schema.get("required").and_then(Value::as_array);
    let is_required = |name: &String| required.is_some_and(|names| names.iter().any(|other| other == name));
    let keys = schema.get("properties").and_then(Value::as_object).into_iter().flatten();
    let field =
        |(name, schema)| Field { name, schema, required: is_required(name), about: text(schema, "description") };
    (keys.map(field).collect(), false)
}

fn form(schema: &Value) -> Form<'_> {
    let Some(object) = schema.as_object() else { return Form { kinds: vec!["any value".into()], ..Form::default() } };
    let mut form = accepted(schema, object);
    let number = |key: &str| object.get(key).and_then(Value::as_f64);
    match (number("minimum"), number("maximum")) {
        // Values that are listed say all.
        _ if object.contains_key("enum") => {}
        (Some(low), Some(high)) => form.allowed.push(format!("{low} to {high}")),
        (Some(low), None) if low != 0.0 => form.allowed.push(format!("{low} or more")),
        (None, Some(high)) => form.allowed.push(format!("at most {high}")),
        _ => {}
    }
    form.allowed.extend(object.get("x-allowed").and_then(Value::as_str).map(String::from));
    form
}

fn accepted<'a>(schema: &'a Value, object: &'a Map<String, Value>) -> Form<'a> {
    let single = |kind: &str| Form { kinds: vec![kind.into()], ..Form::default() };
    if let (Some(quantity), Some(unit)) = (object.get("x-quantity"), object.get("x-unit")) {
        let quantity = quantity.as_str().unwrap_or_default();
        let plain = quantity.split_once(' ').map_or(quantity, |(_, noun)| noun);
        return single(&format!("{plain} ({})", unit.as_str().unwrap_or_default()));
    }
    if let Some(value) = object.get("const") {
        return single(&value.to_string());
    }
    if let Some(Value::Array(values)) = object.get("enum") {
        return Form { kinds: values.iter().map(Value::to_string).collect(), ..Form::default() };
    }
    if let Some(Value::Array(alternatives)) = object.get("anyOf") {
        let mut all = alternatives.iter().map(form).fold(Form::default(), merged);
        all.kinds = plain(all.kinds);
        return all;
    }
    if let Some(Value::Array(alternatives)) = object.get("oneOf") {
        return one_of(schema, alternatives);
    }
    match object.get("type").and_then(Value::as_str) {
        Some("string") => single("text"),
        Some("boolean") => Form { kinds: vec!["true".into(), "false".into()], ..Form::default() },
        Some("array") => list(object),
        Some("object") if object.contains_key("properties") => {
            Form { table: Some(Inner { schema, list: false, named: false }), ..single("table") }
        }
        Some("object") => match object.get("additionalProperties") {
            Some(values @ Value::Object(_)) => {
                let inner = form(values);
                let kind = if inner.table.is_some() {
                    "tables by name".into()
                } else {
                    format!("table of {}", or(&inner.kinds))
                };
                Form { table: inner.table.map(|table| Inner { named: true, ..table }), ..single(&kind) }
            }
            _ => single("table"),
        },
        Some(kind) => single(kind),
        None => single("any value"),
    }
}

/// `a`, `b or c`, `a, b or c`
fn or(words: &[String]) -> String {
    match words {
        [others @ .., last] if !others.is_empty() => format!("{} or {last}", others.join(", ")),
        _ => words.concat(),
    }
}

/// Words, of which each may have a meaning, and tables of one key.
fn one_of<'a>(schema: &'a Value, alternatives: &'a [Value]) -> Form<'a> {
    let mut found = Form::default();
    for alternative in alternatives.iter().filter(|alternative| alternative.get(ALIAS_OF).is_none()) {
        if alternative.get("properties").is_some() {
            found.table = Some(Inner { schema, list: false, named: false });
            continue;
        }
        let inner = form(alternative);
        let about = text(alternative, "description");
        let alias = alternative.get(ALIAS).and_then(Value::as_str).map(|alias| format!(" (or \"{alias}\")"));
        if !about.is_empty() {
            found.words.push(format!("{}{}: {about}", or(&inner.kinds), alias.unwrap_or_default()));
        }
        found.kinds.extend(inner.kinds);
    }
    if found.table.is_some() {
        found.kinds.push("table".into());
    }
    found
}

fn list(object: &Map<String, Value>) -> Form<'_> {
    let Some(items) = object.get("items") else { return Form { kinds: vec!["list".into()], ..Form::default() } };
    let inner = form(items);
    let count = object.get("maxItems").filter(|most| object.get("minItems") == Some(most));
    let kind = match (&inner.table, count) {
        (Some(_), _) => "tables".into(),
        (None, Some(count)) => format!("{count} of {}", or(&inner.kinds)),
        (None, None) => format!("list of {}", or(&inner.kinds)),
    };
    Form { kinds: vec![kind], table: inner.table.map(|table| Inner { list: true, ..table }), ..inner }
}

/// Kinds in fewer words: a zero without unit is no kind of its own, neither is what only takes back a value of the library.
fn plain(kinds: Vec<String>) -> Vec<String> {
    let list_of = |kind: &String| format!("list of {kind}");
    let is_listed = |kind: &String| kinds.contains(&list_of(kind));
    let takes_back = kinds.contains(&"false".into()) && !kinds.contains(&"true".into());
    let kept = kinds.iter().filter(|kind| {
        *kind != "0" && !(takes_back && *kind == "false") && !kinds.iter().any(|single| **kind == list_of(single))
    });
    kept.map(|kind| if is_listed(kind) { format!("one {kind}, or a list") } else { kind.clone() }).collect()
}

fn merged<'a>(mut all: Form<'a>, next: Form<'a>) -> Form<'a> {
    all.kinds.extend(next.kinds);
    all.kinds.dedup();
    all.allowed.extend(next.allowed);
    all.words.extend(next.words);
    all.table = all.table.or(next.table);
    all
}

impl Page {
    /// As a scene writes the table: `[[body]]`, `[gravity.self]`.
    pub fn heading(&self) -> String {
        match self.list {
            true => format!("[[{}]]", self.path),
            false => format!("[{}]", self.path),
        }
    }

    /// Whether it is the page of the table of this path, without the names that are the scene's own.
    fn is_called(&self, name: &[&str]) -> bool {
        self.path.split('.').filter(|step| *step != NAME).eq(name.iter().copied())
    }

    /// Whether it is the page of the table of this path, names of the scene's own included.
    fn is_named(&self, name: &[&str]) -> bool {
        let own: Vec<&str> = self.path.split('.').collect();
        own.len() == name.len() && own.iter().zip(name).all(|(own, wanted)| own == wanted || *own == NAME)
    }

    /// For the terminal.
    pub fn text(&self) -> String {
        let mut out = format!("{}\n{}", self.heading(), wrapped(&self.about, 2));
        if self.one_of {
            out += "  One of these keys:\n";
        }
        let width = self.keys.iter().map(|key| key.name.len()).max().unwrap_or(0);
        for key in &self.keys {
            let facts = [key.kind.clone(), key.allowed.clone(), default_words(&key.default)];
            let facts: Vec<String> = facts.into_iter().filter(|fact| !fact.is_empty()).collect();
            let facts = wrapped(&facts.join("; "), width + 4);
            out += &format!("\n  {:width$}  {}{}", key.name, facts.trim_start(), wrapped(&key.about, width + 4));
        }
        out
    }

    /// For a document in Markdown.
    pub fn markdown(&self) -> String {
        let mut out = format!("### `{}`\n\n{}", self.heading(), self.about.replace('|', "\\|"));
        out += if self.one_of { " One of these keys:\n\n" } else { "\n\n" };
        out += "| key | type | default | allowed | |\n|---|---|---|---|---|\n";
        for key in &self.keys {
            let code = |text: &str| if text.is_empty() { String::new() } else { format!("`{text}`") };
            let cells =
                [code(&key.name), key.kind.clone(), key.default.clone(), key.allowed.clone(), key.about.clone()];
            out += &format!("| {} |\n", cells.map(|cell| cell.replace('|', "\\|")).join(" | "));
        }
        out
    }
}

fn default_words(default: &str) -> String {
    match default {
        "" | REQUIRED => default.into(),
        value => format!("default: {value}"),
    }
}

/// The page of a table: `body`, `[[body]]`, `material.porosity` or `material.basalt.porosity`.
pub fn find<'a>(pages: &'a [Page], table: &str) -> Option<&'a Page> {
    let name: Vec<&str> = table.trim_matches(['[', ']']).split('.').collect();
    pages.iter().find(|page| page.is_called(&name)).or_else(|| pages.iter().find(|page| page.is_named(&name)))
}

/// One line or several for each page: its table, and what that is for.
pub fn index(pages: &[&Page]) -> String {
    let name = |page: &Page| if page.path.is_empty() { "outside of tables".into() } else { page.heading() };
    let width = pages.iter().map(|page| name(page).len()).max().unwrap_or(0);
    let line = |page: &&Page| {
        let about = wrapped(first_sentence(&page.about), width + 4);
        format!("  {:width$}  {}\n", name(page), about.trim())
    };
    pages.iter().map(line).collect()
}

/// The first sentence of a text.
fn first_sentence(text: &str) -> &str {
    let end =
        text.match_indices(['.', ':', ';']).find(|(at, _)| text[at + 1..].starts_with(' ') || at + 1 == text.len());
    end.map_or(text, |(at, _)| &text[..at])
}

/// Lines of a text, each indented; nothing for no text.
fn wrapped(text: &str, indent: usize) -> String {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= WIDTH - indent => {
                *line += &format!(" {word}")
            }
            _ => lines.push(word.into()),
        }
    }
    lines.iter().map(|line| format!("{}{line}\n", " ".repeat(indent))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::schema;

    fn key(table: &str, name: &str) -> Key {
        let pages = pages(&schema::of_scene());
        let page = find(&pages, table).unwrap_or_else(|| panic!("no page of {table}"));
        page.keys.iter().find(|key| key.name == name).unwrap_or_else(|| panic!("no {name} in {table}")).clone()
    }

    #[test]
    fn keys_have_type_unit_default_and_range() {
        let facts = |table, name| {
            let Key { kind, default, allowed, .. } = key(table, name);
            [kind, default, allowed]
        };
        assert_eq!(facts("numerics", "cfl"), ["number", "0.25", "0.001 to 2"]);
        assert_eq!(facts("run", "checkpoint_every"), ["time (s)", "\"600 s\"", "more than 0"]);
        assert_eq!(facts("run", "until"), ["\"settled\" or time (s)", "\"settled\" for impacts", ""]);
        assert_eq!(facts("body", "velocity"), ["one speed (m/s), or a list", "", ""]);
        assert_eq!(facts("[[body]]", "name"), ["text", "required", ""]);
        assert_eq!(facts("body.shape.sphere", "radius"), ["length (m)", "required", "more than 0"]);
        assert_eq!(facts("gravity", "self"), ["true, false or table", "false", ""]);
        assert_eq!(facts("layer", "x"), ["2 of length (m)", "", ""]);
        assert_eq!(facts("material.fracture", "weibull_m"), ["number", "the library's", ""]);
        assert_eq!(facts("material.basalt.porosity", "p_alpha"), ["true, false or table", "", ""]);
        assert!(key("compare", "with").about.contains("\"rest\": Matter at rest"));
        assert!(key("body.motion", "damping").about.contains("absorbing"));
        assert_eq!(key("material.porosity.p_alpha.measured", "file").kind, "text");
    }

    /// No page without a text, no key without one, no line too long for a terminal.
    #[test]
    fn everything_is_explained() {
        for page in pages(&schema::of_scene()) {
            assert!(!page.about.is_empty(), "{}", page.path);
            // Axes need no words.
            let mute = |key: &&Key| key.kind.is_empty() || key.about.is_empty() && page.path != "domain.periodic";
            let mute = page.keys.iter().find(mute);
            assert_eq!(mute, None, "{}", page.path);
            assert!(page.text().lines().all(|line| line.chars().count() <= WIDTH), "{}", page.text());
        }
    }
}
