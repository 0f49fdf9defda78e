//! No two files of `src/` import each other, be it by way of others: whoever reads one need not have read what stands above it.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use crate::{code_of, rust_files};

/// The sources by their names below `src/`, without comments, strings and unit tests.
struct Sources(BTreeMap<String, String>);

impl Sources {
    fn of_the_program() -> Self {
        let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
        let mut files = Vec::new();
        rust_files(&src, &mut files);
        let read = |path: &Path| {
            let name = path.strip_prefix(&src).expect("below src").to_str().expect("a plain name").to_owned();
            (name, fs::read_to_string(path).expect("a readable source"))
        };
        Self::new(files.iter().map(|path| read(path)))
    }

    fn new(files: impl Iterator<Item = (String, String)>) -> Self {
        let program = |text: &str| {
            let code = code_of(text);
            let tests = code.find("#[cfg(test)]\nmod tests").unwrap_or(code.len());
            code[..tests].to_string()
        };
        // What stands beside unit tests for their sake alone belongs to them.
        let for_tests = |name: &str| name.ends_with("testing.rs") || name.ends_with("tests.rs");
        Self(files.filter(|(name, _)| !for_tests(name)).map(|(name, text)| (name, program(&text))).collect())
    }

    /// The file of a module, `[step, late]`.
    fn file(&self, module: &[String]) -> Option<String> {
        if module.is_empty() {
            return Some("lib.rs".into());
        }
        let path = module.join("/");
        [format!("{path}.rs"), format!("{path}/mod.rs")].into_iter().find(|name| self.0.contains_key(name))
    }

    /// The file that a path from the root leads to, by way of what modules re-export.
    fn resolve(&self, path: &[String]) -> Option<String> {
        let mut module: Vec<String> = Vec::new();
        for (k, name) in path.iter().enumerate() {
            let inner = [&module[..], std::slice::from_ref(name)].concat();
            if self.file(&inner).is_some() {
                module = inner;
                continue;
            }
            let file = self.file(&module)?;
            let handed_on = uses(&module, &self.0[&file]).into_iter().find(|used| used.public && used.name() == *name);
            return match handed_on {
                Some(used) => self.resolve(&[&used.path[..], &path[k + 1..]].concat()),
                None => Some(file),
            };
        }
        self.file(&module)
    }

    /// Every file with those that it imports from.
    fn imports(&self) -> BTreeMap<String, BTreeSet<String>> {
        let of_file = |(name, code): (&String, &String)| {
            let module = module_of(name);
            let all = uses(&module, code).into_iter().filter(|used| !used.public).map(|used| used.path);
            let found = all.chain(paths(&module, code)).filter_map(|path| self.resolve(&path));
            (name.clone(), found.filter(|file| file != name && file != "lib.rs").collect())
        };
        self.0.iter().map(of_file).collect()
    }
}

/// `step/late.rs` is `[step, late]`, `step/mod.rs` is `[step]`.
fn module_of(file: &str) -> Vec<String> {
    let path = file.trim_end_matches(".rs").trim_end_matches("/mod");
    if path == "lib" { Vec::new() } else { path.split('/').map(String::from).collect() }
}

/// A name that a `use` brings into a module, with its path from the root.
struct Used {
    path: Vec<String>,
    public: bool,
}

impl Used {
    fn name(&self) -> &str {
        self.path.last().map_or("", String::as_str)
    }
}

/// What the `use`s of a module's code bring in.
fn uses(module: &[String], code: &str) -> Vec<Used> {
    let mut found = Vec::new();
    for (at, _) in code.match_indices("use ") {
        let line = code[..at].rsplit('\n').next().unwrap_or_default().trim();
        if !(line.is_empty() || line == "pub" || line == "pub(super)" || line == "pub(crate)") {
            continue;
        }
        let tree = code[at + 4..].split(';').next().unwrap_or_default();
        for path in branches(tree) {
            if let Some(path) = from_root(module, &path) {
                found.push(Used { path, public: line.starts_with("pub") });
            }
        }
    }
    found
}

/// Paths of a tree `a::{b, c::{d, e as f}}`.
fn branches(tree: &str) -> Vec<Vec<String>> {
    let tree = tree.trim();
    let Some(open) = tree.find('{') else {
        let path = tree.split(" as ").next().unwrap_or_default();
        return vec![path.split("::").map(|name| name.trim().to_string()).filter(|name| !name.is_empty()).collect()];
    };
    let before: Vec<String> =
        tree[..open].split("::").map(|name| name.trim().to_string()).filter(|name| !name.is_empty()).collect();
    let (mut level, mut start, mut parts) = (0, open + 1, Vec::new());
    for (at, c) in tree.char_indices().skip_while(|(at, _)| *at < open) {
        match c {
            '{' => level += 1,
            '}' => level -= 1,
            _ => {}
        }
        if (c == ',' && level == 1) || (c == '}' && level == 0) {
            parts.push(&tree[start..at]);
            start = at + 1;
        }
        if level == 0 {
            break;
        }
    }
    let inner = parts.into_iter().filter(|part| !part.trim().is_empty()).flat_map(branches);
    inner.map(|path| [&before[..], &path[..]].concat()).collect()
}

/// A path as the module's code says it, from the root; none where it leads out of the program.
fn from_root(module: &[String], path: &[String]) -> Option<Vec<String>> {
    let ups = path.iter().take_while(|name| *name == "super").count();
    let rest: Vec<String> = path[ups..].iter().filter(|name| *name != "self").cloned().collect();
    match path.first()?.as_str() {
        "crate" => Some(path[1..].iter().filter(|name| *name != "self").cloned().collect()),
        "super" => Some([&module[..module.len().checked_sub(ups)?], &rest[..]].concat()),
        "std" | "core" | "self" => None,
        // A module below this one, or another crate, which no file answers to.
        _ => Some([module, &rest[..]].concat()),
    }
}

/// Paths by `crate::` and `super::` outside of `use`.
fn paths(module: &[String], code: &str) -> Vec<Vec<String>> {
    let word = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    let mut found = Vec::new();
    for root in ["crate::", "super::"] {
        for (at, _) in code.match_indices(root) {
            if !code[..at].ends_with(word) {
                let path: String = code[at..].chars().take_while(|c| word(*c)).collect();
                let path: Vec<String> = path.split("::").map(String::from).filter(|name| !name.is_empty()).collect();
                found.extend(from_root(module, &path));
            }
        }
    }
    found
}

/// Every file that is reached from one by imports.
fn reached<'a>(imports: &'a BTreeMap<String, BTreeSet<String>>, from: &'a String) -> BTreeSet<&'a String> {
    let (mut found, mut next) = (BTreeSet::new(), vec![from]);
    while let Some(file) = next.pop() {
        next.extend(imports.get(file).into_iter().flatten().filter(|below| found.insert(*below)));
    }
    found
}

/// Imports among files that import each other, by way of others at the most; empty where there are none.
fn circles(imports: BTreeMap<String, BTreeSet<String>>) -> Vec<String> {
    let edges = imports.iter().flat_map(|(file, all)| all.iter().map(move |below| (file, below)));
    let back = edges.filter(|(file, below)| reached(&imports, below).contains(file));
    back.map(|(file, below)| format!("{file} -> {below}")).collect()
}

#[test]
fn no_files_import_each_other() {
    let found = circles(Sources::of_the_program().imports());
    assert!(found.is_empty(), "circles among these:\n{}\n", found.join("\n"));
}

/// The checker itself: planted circles are found, what is allowed is not.
#[test]
fn planted_circles_are_found() {
    let check = |files: &[(&str, &str)]| {
        let files = files.iter().map(|(name, text)| (name.to_string(), text.to_string()));
        circles(Sources::new(files).imports())
    };
    assert_eq!(check(&[("a.rs", "use crate::b::B;"), ("b.rs", "use crate::c::C;"), ("c.rs", "")]), [""; 0]);
    assert_eq!(
        check(&[("a.rs", "use crate::b::B;"), ("b.rs", "fn f() { crate::a::g() }")]),
        ["a.rs -> b.rs", "b.rs -> a.rs"]
    );
    // By way of a module's face, and of a group.
    let face = ("x/mod.rs", "pub mod one;\npub mod two;\npub use two::Two;");
    let one = ("x/one.rs", "use super::{Two, other::{A, B}};");
    assert_eq!(check(&[face, one, ("x/two.rs", "")]), [""; 0]);
    assert_eq!(
        check(&[face, one, ("x/two.rs", "use super::one::One;")]),
        ["x/one.rs -> x/two.rs", "x/two.rs -> x/one.rs"]
    );
    // What the face defines itself is its own; unit tests may look anywhere.
    let own = ("x/mod.rs", "mod one;\nuse one::One;\npub struct Two;");
    assert_eq!(check(&[own, ("x/one.rs", "use super::Two;")]), ["x/mod.rs -> x/one.rs", "x/one.rs -> x/mod.rs"]);
    let tests = "use crate::b::B;\n#[cfg(test)]\nmod tests {\n    use crate::c::C;\n}";
    assert_eq!(check(&[("a.rs", tests), ("b.rs", ""), ("c.rs", "use crate::a::A;")]), [""; 0]);
}
