//! Keeps the house in order: floors, one file that names MPI, short files, a reason beside every `unsafe`.

mod circles;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Folders and single files of `src/`, lowest floor first. A file imports from lower floors or its own folder only. `error`
/// stands below the other files of the lowest floor, as they report errors, `random` below `math`, whose tests draw numbers, and
/// `cli` below `program`.
const FLOORS: [&[&str]; 15] = [
    &["error", "warning"],
    &["random"],
    &["math", "units"],
    &["kernel", "particles"],
    &["domain", "neighbours"],
    &["material", "pair", "gravity", "motion"],
    &["scene", "exact", "outcome", "output"],
    &["step", "process"],
    &["comparison", "report"],
    &["simulation"],
    &["forecast", "threshold"],
    &["study"],
    &["cli"],
    &["program"],
    &["main", "lib", "kernels"],
];

/// The one file that names MPI. Output hands its raw communicator to HDF5.
const MPI_MODULE: &str = "domain/comm";
const RAW_COMMUNICATOR: [&str; 2] = [MPI_MODULE, "output/"];

const LONGEST_FILE: usize = 600;

#[test]
fn sources_keep_the_rules() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    rust_files(&src, &mut files);
    assert!(files.len() > 5, "{} holds the sources", src.display());
    let mut found = Vec::new();
    for path in files {
        let text = fs::read_to_string(&path).expect("a readable source");
        let name = path.strip_prefix(&src).expect("below src").to_str().expect("a plain name").to_owned();
        found.extend(violations(&name, &text));
    }
    assert!(found.is_empty(), "\n{}\n", found.join("\n"));
}

/// A test file that nobody names is never run.
#[test]
fn every_test_file_is_run() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let main = fs::read_to_string(root.join("tests/main.rs")).expect("tests/main.rs");
    for entry in fs::read_dir(root.join("tests")).expect("tests/").flatten() {
        let name = entry.file_name().into_string().expect("a plain name");
        if let Some(module) = name.strip_suffix(".rs").filter(|module| *module != "main") {
            assert!(main.contains(&format!("mod {module};")), "tests/{name} is not named in tests/main.rs");
        }
    }
}

pub fn rust_files(dir: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(dir).expect("a readable folder").flatten() {
        let path = entry.path();
        if path.is_dir() {
            rust_files(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

/// What is wrong with the source `text` of the file `name` (below `src/`): one line each.
fn violations(name: &str, text: &str) -> Vec<String> {
    let code = code_of(text);
    let mut found = Vec::new();
    let lines = text.lines().count();
    if lines > LONGEST_FILE {
        found.push(format!("src/{name}: {lines} lines, at most {LONGEST_FILE}"));
    }
    check_floors(name, &code, &mut found);
    let covered = covered_by_safety(text, &code);
    for (i, line) in code.lines().enumerate() {
        let mut report = |what: &str| found.push(format!("src/{name}:{}: {what}", i + 1));
        let words: Vec<&str> = line.split(|c: char| !(c.is_alphanumeric() || c == '_')).collect();
        let block = line.contains("unsafe {") || line.contains("unsafe impl") || line.trim_end().ends_with("unsafe");
        if block && words.contains(&"unsafe") && !covered[i] {
            report("`unsafe` without a SAFETY comment");
        }
        if line.contains("todo!") || line.contains("unimplemented!") {
            report("unfinished code");
        }
        if !name.starts_with(MPI_MODULE)
            && words.iter().any(|w| *w == "mpi" || *w == "mpi_sys" || w.starts_with("MPI_"))
        {
            report(&format!("names MPI, which only src/{MPI_MODULE} does"));
        }
        if line.contains("comm.raw()") && !RAW_COMMUNICATOR.iter().any(|allowed| name.starts_with(allowed)) {
            report("takes the raw communicator, which only src/output/ does");
        }
    }
    found
}

/// Which lines a `SAFETY:` comment (or `# Safety` in the docs of an item) speaks for: those of the statement or item below it,
/// and of the statements that follow that one without a closing brace between.
fn covered_by_safety(text: &str, code: &str) -> Vec<bool> {
    let mut comments: Vec<usize> = Vec::new();
    let mut covered = Vec::new();
    for (line, code) in text.lines().zip(code.lines()) {
        let indent = line.len() - line.trim_start().len();
        if !line.trim().is_empty() {
            comments.retain(|&comment| comment <= indent);
        }
        if line.contains("SAFETY:") || line.contains("# Safety") {
            comments.push(indent);
        }
        covered.push(!comments.is_empty());
        if code.trim_start().starts_with(['}', ')']) && !code.trim_end().ends_with('{') {
            comments.retain(|&comment| comment != indent);
        }
    }
    covered
}

fn check_floors(name: &str, code: &str, found: &mut Vec<String>) {
    let own = name.split('/').next().unwrap_or(name).trim_end_matches(".rs");
    let floor = |unit: &str| FLOORS.iter().position(|units| units.contains(&unit));
    let Some(own_floor) = floor(own) else {
        found.push(format!("src/{name}: `{own}` has no floor in tests/structure/main.rs"));
        return;
    };
    for (line, unit) in imports(name, code) {
        let what = match floor(&unit) {
            _ if unit == own => continue,
            Some(below) if below < own_floor => continue,
            Some(above) if above > own_floor => "of a higher floor",
            Some(_) => "of the same floor",
            None => "which has no floor in tests/structure/main.rs",
        };
        found.push(format!("src/{name}:{line}: `{own}` imports from `{unit}`, {what}"));
    }
}

/// Folders and single files of `src/` that the code names, with the line: by `crate::` or by as many `super::` as lead
/// to the root.
fn imports(name: &str, code: &str) -> BTreeSet<(usize, String)> {
    let parts = name.split('/').count();
    let depth = if name.ends_with("/mod.rs") { parts - 1 } else { parts };
    let tests = code.find("#[cfg(test)]").unwrap_or(code.len());
    let mut found = BTreeSet::new();
    for root in path_ends(code, "crate::") {
        let line = code[..root].lines().count();
        found.extend(first_names(&code[root..]).into_iter().map(|unit| (line, unit)));
    }
    for start in path_ends(code, "super::") {
        // Of a chain only the last one: what follows it is a name.
        let before = &code[..start];
        let chain = (0..).take_while(|n| before.ends_with(&"super::".repeat(n + 1))).count();
        // The module of unit tests at the foot of a file lies one deeper.
        if chain >= depth + usize::from(start > tests) && !code[start..].starts_with("super::") {
            let line = before.lines().count();
            found.extend(first_names(&code[start..]).into_iter().map(|unit| (line, unit)));
        }
    }
    found
}

/// Where `word` ends in the code, wherever it is a word of its own.
fn path_ends(code: &str, word: &str) -> Vec<usize> {
    let whole = |at: usize| !code[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_');
    code.match_indices(word).filter(|(at, _)| whole(*at)).map(|(at, _)| at + word.len()).collect()
}

/// First names of a path or of a group of paths: `a` of `a::b`, `a` and `c` of `{a::{b, d}, c}`.
fn first_names(path: &str) -> Vec<String> {
    let name = |s: &str| s.trim_start().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect::<String>();
    let Some(group) = path.strip_prefix('{') else { return vec![name(path)] };
    let mut names = vec![name(group)];
    let mut level = 1;
    for (i, c) in group.char_indices() {
        match c {
            '{' => level += 1,
            '}' => level -= 1,
            ',' if level == 1 => names.push(name(&group[i + 1..])),
            _ => {}
        }
        if level == 0 {
            break;
        }
    }
    names.retain(|n| !n.is_empty());
    names
}

/// The source with comments, strings and characters blanked, lines kept.
pub fn code_of(text: &str) -> String {
    let mut code = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let length = skipped(rest, code.chars().last());
        if length > 0 {
            code.extend(rest[..length].chars().map(|c| if c == '\n' { '\n' } else { ' ' }));
            rest = &rest[length..];
        } else {
            code.push(first);
            rest = &rest[first.len_utf8()..];
        }
    }
    code
}

/// Bytes of the comment, string or character that `text` begins with, 0 if with neither; `before` is what stands before it.
fn skipped(text: &str, before: Option<char>) -> usize {
    let up_to = |end: Option<usize>| end.unwrap_or(text.len());
    if text.starts_with("//") {
        return up_to(text.find('\n'));
    }
    if text.starts_with("/*") {
        return up_to(text.find("*/").map(|end| end + 2));
    }
    let within_word = before.is_some_and(|c| c.is_alphanumeric() || c == '_');
    if let Some(raw) = text.strip_prefix('r').filter(|_| !within_word) {
        let hashes = raw.len() - raw.trim_start_matches('#').len();
        if raw[hashes..].starts_with('"') {
            let close = format!("\"{}", "#".repeat(hashes));
            let begin = 1 + hashes + 1;
            return up_to(text[begin..].find(&close).map(|end| begin + end + close.len()));
        }
    }
    let quoted = |quote: char| {
        let mut escaped = false;
        let close = text.char_indices().skip(1).find(|&(_, c)| {
            let end = c == quote && !escaped;
            escaped = c == '\\' && !escaped;
            end
        });
        up_to(close.map(|(end, _)| end + 1))
    };
    let mut chars = text.chars().skip(1);
    match text.chars().next() {
        Some('"') => quoted('"'),
        // A lifetime is no character: 'a' closes after one, or is escaped.
        Some('\'') if chars.next() == Some('\\') || chars.next() == Some('\'') => quoted('\''),
        _ => 0,
    }
}

/// The checker itself: planted violations are found, what is allowed is not.
mod checker {
    use super::*;

    #[track_caller]
    fn assert_found(name: &str, text: &str, what: &[&str]) {
        let found = violations(name, text);
        assert_eq!(found.len(), what.len(), "{found:?}");
        for (line, part) in found.iter().zip(what) {
            assert!(line.contains(part), "{line:?} does not say {part:?}");
        }
    }

    #[test]
    fn upward_import() {
        assert_found(
            "particles/sort.rs",
            "use crate::math::Vec3;\nuse crate::material::Core;\n",
            &["sort.rs:2: `particles` imports from `material`, of a higher"],
        );
        assert_found("math/a.rs", "fn f() {\n    crate::cli::run();\n}\n", &["math/a.rs:2"]);
    }

    #[test]
    fn import_of_the_same_floor() {
        assert_found("pair/force.rs", "use crate::gravity::Tree;", &["`gravity`, of the same floor"]);
        assert_found("units.rs", "use crate::math::Vec3;", &["`math`, of the same floor"]);
    }

    #[test]
    fn grouped_imports() {
        let text = "use crate::{\n    math::{Vec3, tensor::step},\n    step::Step,\n    error,\n};";
        assert_found("pair/force.rs", text, &["imports from `step`, of a higher"]);
    }

    #[test]
    fn import_by_way_of_super() {
        assert_found("material/eos/gas.rs", "use super::super::super::step::Step;", &["imports from `step`"]);
        assert_found("units.rs", "use super::cli::run;", &["imports from `cli`"]);
        assert_found("material/mod.rs", "use super::pair::Pair;", &["imports from `pair`"]);
        assert_found("material/eos/gas.rs", "use super::super::Core;\nuse super::Eos;", &[]);
        assert_found("units.rs", "#[cfg(test)]\nmod tests {\n    use super::*;\n}", &[]);
    }

    #[test]
    fn file_without_a_floor() {
        assert_found("misc.rs", "", &["`misc` has no floor"]);
        assert_found("step/mod.rs", "use crate::misc::f;", &["`misc`, which has no floor"]);
    }

    #[test]
    fn allowed_imports() {
        let text = "use crate::material::Core;\nuse crate::output::hdf;\npub(crate) fn f() {}\nmod_crate::step::f();";
        assert_found("output/snapshot.rs", text, &[]);
    }

    #[test]
    fn comments_and_strings_are_no_code() {
        let text = "// use crate::cli::x; todo!\n/* unsafe\n mpi */ const A: &str = \"crate::cli \\\" MPI_Init\";\nconst B: &str = r#\"unsafe \" mpi\"#;";
        assert_found("math/a.rs", text, &[]);
        assert_eq!(code_of("a('\"', 'b', '\\'') // c\n<'d>"), "a(   ,    ,     )     \n<'d>");
        assert_found("math/a.rs", "const Q: char = '\"';\nuse crate::cli::x;\nconst R: char = '\"';", &["a.rs:2"]);
    }

    #[test]
    fn unsafe_wants_a_reason() {
        let why = "// SAFETY: in bounds.\n";
        assert_found("math/a.rs", "fn f() {\n    unsafe { g() }\n}", &["a.rs:2: `unsafe`"]);
        assert_found("math/a.rs", "unsafe impl Send for A {}", &["a.rs:1: `unsafe`"]);
        assert_found("math/a.rs", &format!("{why}unsafe {{ g() }}"), &[]);
        // A comment speaks for the item below it, down to its closing brace, and for no other.
        let item = |name| format!("unsafe fn {name}(\n    a: A,\n) -> A {{\n    unsafe {{ g() }}\n}}\n");
        assert_found("math/a.rs", &format!("/// # Safety\n/// AVX2.\n{}", item("f")), &[]);
        assert_found(
            "math/a.rs",
            &format!("/// # Safety\n/// AVX2.\n{}{}", item("f"), item("g")),
            &["a.rs:11: `unsafe`"],
        );
        // Nor does one inside a block speak for what follows the block.
        assert_found("math/a.rs", "{\n    // SAFETY: a\n    f();\n}\nunsafe { g() }", &["a.rs:5: `unsafe`"]);
    }

    #[test]
    fn mpi_in_a_second_place() {
        assert_found("step/mod.rs", "use mpi::traits::*;", &["names MPI"]);
        assert_found("step/mod.rs", "let c: ffi::MPI_Comm;", &["names MPI"]);
        assert_found("domain/comm.rs", "use mpi::traits::*;", &[]);
        assert_found("main.rs", "sph_mpi::cli::run()", &[]);
        assert_found("output/parallel.rs", "h5(comm.raw())", &[]);
        assert_found("step/mod.rs", "h5(comm.raw())", &["raw communicator"]);
    }

    #[test]
    fn length_and_unfinished_code() {
        assert_found("step/mod.rs", &"\n".repeat(LONGEST_FILE + 1), &["601 lines"]);
        assert_found("step/mod.rs", "todo!(); unimplemented!()", &["unfinished"]);
    }
}
