//! The house: no import circle among the files of any crate, arrows between the rooms of the two libraries downwards
//! only, no type of an experiment in them, no name exported twice, and nothing that shows an outcome. Read from the sources: `use` declarations and paths that begin with
//! `crate`, `super` or `self`, each followed through re-exports to the file that defines the item. Code
//! behind `#[cfg(test)]` does not count.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Rooms of the two crates from the ground up: a room may use those before it.
const ROOMS: [(&str, &[&str]); 2] = [
    (
        "toolkit/src",
        &[
            "value",
            "error",
            "estimate",
            "numeric",
            "quadrature",
            "order",
            "root",
            "grading",
            "mesh",
            "nearly_one",
            "kernel",
            "gram",
            "energy",
            "closed_forms",
            "piecewise",
            "functions",
            "dual",
            "boundary",
            "plane",
            "fields",
            "function",
            "matrix",
            "constant",
            "trace",
            "poincare",
            "interpolation",
        ],
    ),
    (
        "src",
        &[
            "error", "text", "numeric", "mesh", "fem", "cone", "contact", "strip", "singular", "problems",
            "edge", "rates", "proof",
        ],
    ),
];
/// Crates in which arrows are not ranked: their files lie on no import circle.
const OTHERS: [&str; 2] = ["examples/report/src", "book/builder/src"];
/// Endings of the names of experiments: no public type of a library has one.
const EXPERIMENTS: [&str; 4] = ["Study", "Row", "Case", "Profile"];
/// Words of showing an outcome: none may be imported or named as a path in `src`.
const SHOWING: [&str; 9] = [
    "plotters",
    "clap",
    "indicatif",
    "serde_json",
    "example_report",
    "report",
    "figures",
    "Headline",
    "Verdict",
];

/// A module: its file, the items the file defines, and its re-exports as (name, path).
#[derive(Default)]
struct Module {
    file: PathBuf,
    items: BTreeSet<String>,
    exports: Vec<(String, Vec<String>)>,
    uses: Vec<Vec<String>>,
}

type Modules = BTreeMap<Vec<String>, Module>;

fn words(path: &str) -> Vec<String> {
    path.split("::").map(|s| s.trim().to_owned()).filter(|s| !s.is_empty()).collect()
}

/// The code without comments, literals and what follows `#[cfg(test)]`.
fn code(text: &str) -> String {
    let text = text.split("#[cfg(test)]\nmod ").next().unwrap_or("");
    let mut code = String::new();
    for line in text.lines() {
        let (mut literal, mut last) = (false, ' ');
        let mut kept = String::new();
        for c in line.chars() {
            if c == '"' && last != '\\' && last != '\'' {
                literal = !literal;
            }
            if !literal && c == '/' && last == '/' {
                kept.pop();
                break;
            }
            if !literal {
                kept.push(c);
            }
            last = c;
        }
        code.push_str(&kept);
        code.push('\n');
    }
    code
}

/// Paths of a use tree, `a::{b, c::{d as e}}`, with the name each brings in.
fn tree(prefix: &[String], text: &str, found: &mut Vec<(String, Vec<String>)>) {
    let text = text.trim();
    if let Some(open) = text.find('{') {
        let mut inner: Vec<String> = prefix.to_vec();
        inner.extend(words(text[..open].trim_end_matches("::")));
        let (mut depth, mut start) = (0, open + 1);
        for (k, c) in text.char_indices().skip_while(|(k, _)| *k <= open) {
            match c {
                '{' => depth += 1,
                '}' if depth > 0 => depth -= 1,
                ',' | '}' if depth == 0 => {
                    tree(&inner, &text[start..k], found);
                    start = k + 1;
                }
                _ => {}
            }
        }
    } else if !text.is_empty() {
        let (path, alias) = text.split_once(" as ").map_or((text, None), |(p, a)| (p, Some(a.trim())));
        let mut full: Vec<String> = prefix.to_vec();
        full.extend(words(path).into_iter().filter(|w| w != "self" || prefix.is_empty()));
        let name = alias.map_or_else(|| full.last().cloned().unwrap_or_default(), str::to_owned);
        found.push((name, full));
    }
}

const KINDS: [&str; 9] = ["fn", "struct", "enum", "trait", "const", "type", "static", "union", "mod"];

/// Names defined at the top of a file.
fn items(code: &str) -> BTreeSet<String> {
    let tokens = |line: &str| -> Vec<String> {
        line.split(|c: char| !c.is_alphanumeric() && c != '_').map(str::to_owned).collect()
    };
    let top = code.lines().filter(|line| !line.starts_with([' ', '\t', '}', '#']));
    let defined = top.filter_map(|line| {
        let words = tokens(line);
        let at = words.iter().position(|word| KINDS.contains(&word.as_str()))?;
        // `const fn f`: the name follows the last keyword.
        let at = (at..words.len()).take_while(|&k| KINDS.contains(&words[k].as_str())).last()?;
        let is_file = words[at] == "mod" && line.trim_end().ends_with(';');
        (!is_file).then(|| words.get(at + 1).cloned()).flatten()
    });
    // A registry of scenes declares its enum inside the call of its macro.
    let registered =
        code.lines().filter_map(|line| line.strip_prefix("    pub enum ")?.split([':', ' ']).next());
    let macros = code.lines().filter_map(|line| line.strip_prefix("macro_rules! "));
    let named = macros.map(|m| m.trim_end_matches([' ', '{'])).chain(registered);
    defined.chain(named.map(str::to_owned)).collect()
}

/// Every path in the code outside `use` that begins with crate, super or self.
fn inline_paths(code: &str) -> Vec<Vec<String>> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    let paths = code.split(|c: char| !is_word(c)).map(words);
    let rooted = |p: &Vec<String>| p.len() > 1 && ["crate", "super", "self"].contains(&p[0].as_str());
    paths.filter(rooted).collect()
}

fn read(directory: &Path, path: &[String], modules: &mut Modules) {
    let mut entries: Vec<PathBuf> =
        std::fs::read_dir(directory).unwrap().map(|e| e.unwrap().path()).collect();
    entries.sort();
    for entry in entries {
        let stem = entry.file_stem().unwrap().to_string_lossy().into_owned();
        let mut own = path.to_vec();
        if entry.is_dir() {
            own.push(stem);
            read(&entry, &own, modules);
            continue;
        }
        if stem == "book" || entry.extension().is_none_or(|e| e != "rs") {
            continue;
        }
        if stem != "mod" && stem != "lib" {
            own.push(stem);
        }
        let code = code(&std::fs::read_to_string(&entry).unwrap());
        let mut module = Module { file: entry, items: items(&code), ..Module::default() };
        let mut rest = String::new();
        for statement in code.split_inclusive(';') {
            let at = statement.find("use ").filter(|&at| {
                let before = statement[..at].trim_end();
                before.is_empty()
                    || before.ends_with(['}', ')', ']', '\n', 'b', ';'])
                    || before.ends_with("pub")
            });
            let Some(at) = at.filter(|_| statement.ends_with(';')) else {
                rest.push_str(statement);
                continue;
            };
            rest.push_str(&statement[..at]);
            let before = statement[..at].trim_end();
            let is_export = before.ends_with("pub") || before.ends_with(')') && before.contains("pub(");
            let mut found = Vec::new();
            tree(&[], statement[at + 4..].trim_end_matches(';'), &mut found);
            if is_export {
                module.exports.extend(found);
            } else {
                module.uses.extend(found.into_iter().map(|(_, full)| full));
            }
        }
        module.uses.extend(inline_paths(&rest));
        modules.insert(own, module);
    }
}

/// The module whose file defines what `path` names as seen from `here`.
fn resolve(modules: &Modules, here: &[String], path: &[String], depth: usize) -> Option<Vec<String>> {
    if depth > 8 {
        return None;
    }
    let (mut at, mut rest) = (here.to_vec(), path);
    match path.first()?.as_str() {
        "crate" => {
            at.clear();
            rest = &rest[1..];
        }
        "self" => rest = &rest[1..],
        _ => {}
    }
    while rest.first().is_some_and(|word| word == "super") {
        at.pop();
        rest = &rest[1..];
    }
    let Some(word) = rest.first() else { return Some(at) };
    let child: Vec<String> = at.iter().chain([word]).cloned().collect();
    if modules.contains_key(&child) {
        let mut next = vec!["self".to_owned()];
        next.extend_from_slice(&rest[1..]);
        return resolve(modules, &child, &next, depth);
    }
    let module = modules.get(&at)?;
    if module.items.contains(word) || word == "*" {
        return Some(at);
    }
    for (name, full) in &module.exports {
        if name == word {
            let first = full.first()?;
            let is_rooted = ["crate", "super", "self"].contains(&first.as_str());
            let mut target = if is_rooted { Vec::new() } else { vec!["self".to_owned()] };
            target.extend_from_slice(full);
            return resolve(modules, &at, &target, depth + 1);
        }
    }
    None
}

fn house(source: &str) -> (Modules, BTreeMap<Vec<String>, BTreeSet<Vec<String>>>) {
    let mut modules = Modules::new();
    read(&Path::new(env!("CARGO_MANIFEST_DIR")).join(source), &[], &mut modules);
    let mut edges: BTreeMap<Vec<String>, BTreeSet<Vec<String>>> = BTreeMap::new();
    for (here, module) in &modules {
        for path in &module.uses {
            if let Some(there) = resolve(&modules, here, path, 0).filter(|there| there != here) {
                edges.entry(here.clone()).or_default().insert(there);
            }
        }
    }
    (modules, edges)
}

fn reaches<'a>(
    edges: &'a BTreeMap<Vec<String>, BTreeSet<Vec<String>>>,
    from: &Vec<String>,
) -> BTreeSet<&'a Vec<String>> {
    let mut found = BTreeSet::new();
    let mut open: Vec<&Vec<String>> = edges.get(from).into_iter().flatten().collect();
    while let Some(next) = open.pop() {
        if found.insert(next) {
            open.extend(edges.get(next).into_iter().flatten());
        }
    }
    found
}

#[test]
fn no_import_circle_among_files() {
    for source in ROOMS.iter().map(|room| room.0).chain(OTHERS) {
        let (modules, edges) = house(source);
        assert!(
            modules.len() > 20 && edges.values().map(BTreeSet::len).sum::<usize>() > 40,
            "{source}: little was read"
        );
        let circles: Vec<String> = edges
            .keys()
            .filter(|from| reaches(&edges, from).contains(from))
            .map(|from| {
                let back = edges[from].iter().filter(|to| reaches(&edges, to).contains(from));
                format!(
                    "{} -> {}",
                    from.join("::"),
                    back.map(|to| to.join("::")).collect::<Vec<_>>().join(", ")
                )
            })
            .collect();
        assert!(
            circles.is_empty(),
            "{source}: {} files lie on a circle:\n{}",
            circles.len(),
            circles.join("\n")
        );
    }
}

#[test]
fn arrows_between_rooms_point_downwards() {
    for (source, rooms) in ROOMS {
        let (_, edges) = house(source);
        let rank = |module: &Vec<String>| {
            rooms.iter().position(|room| Some(*room) == module.first().map(String::as_str))
        };
        let mut upwards = Vec::new();
        for (from, to) in edges.iter().flat_map(|(from, to)| to.iter().map(move |to| (from, to))) {
            // The root re-exports what is public, and stands above all rooms.
            let own = rank(from).unwrap_or(rooms.len());
            if !from.is_empty() && own == rooms.len() {
                upwards.push(format!("{} is in no room", from.join("::")));
            }
            if rank(to).is_none_or(|other| other > own) {
                upwards.push(format!("{} -> {}", from.join("::"), to.join("::")));
            }
        }
        assert!(
            upwards.is_empty(),
            "{source}: {} arrows point upwards:\n{}",
            upwards.len(),
            upwards.join("\n")
        );
    }
}

/// Public types that a file defines.
fn public_types(module: &Module) -> Vec<String> {
    let text = code(&std::fs::read_to_string(&module.file).unwrap());
    let defined = text.lines().filter_map(|line| {
        let rest = ["pub struct ", "pub enum ", "pub trait ", "pub type "]
            .iter()
            .find_map(|kind| line.strip_prefix(kind))?;
        rest.split(|c: char| !c.is_alphanumeric() && c != '_').next()
    });
    defined.map(str::to_owned).collect()
}

#[test]
fn no_type_of_an_experiment_stands_in_a_library() {
    let mut found = Vec::new();
    for (source, _) in ROOMS {
        let (modules, _) = house(source);
        for module in modules.values() {
            let named = public_types(module).into_iter();
            let named = named.filter(|name| EXPERIMENTS.iter().any(|ending| name.ends_with(ending)));
            found.extend(named.map(|name| format!("{}: {name}", module.file.display())));
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn no_name_is_exported_twice() {
    // Two files that export a type of one name: a reader of `use` lines cannot tell them apart.
    let mut places: BTreeMap<String, BTreeSet<PathBuf>> = BTreeMap::new();
    for source in ROOMS.iter().map(|room| room.0).chain(["examples/report/src"]) {
        let (modules, _) = house(source);
        let exported: BTreeSet<&String> =
            modules.values().flat_map(|module| module.exports.iter().map(|(name, _)| name)).collect();
        for module in modules.values() {
            for name in public_types(module).into_iter().filter(|name| exported.contains(name)) {
                places.entry(name).or_default().insert(module.file.clone());
            }
        }
    }
    assert!(places.len() > 100, "little was read");
    // Every crate has its error.
    let twice = places
        .iter()
        .filter(|(name, files)| files.len() > 1 && !["Error", "Result"].contains(&name.as_str()));
    let twice: Vec<String> = twice.map(|(name, files)| format!("{name}: {files:?}")).collect();
    assert!(twice.is_empty(), "{}", twice.join("\n"));
}

#[test]
fn the_libraries_show_nothing() {
    let mut found = Vec::new();
    for (source, _) in ROOMS {
        let (modules, _) = house(source);
        for module in modules.values() {
            let named = module.uses.iter().chain(module.exports.iter().map(|(_, path)| path)).flatten();
            let shown: BTreeSet<&String> = named.filter(|word| SHOWING.contains(&word.as_str())).collect();
            if !shown.is_empty() {
                found.push(format!("{}: {shown:?}", module.file.display()));
            }
            let defined = module
                .items
                .iter()
                .filter(|item| ["Table", "Verdict", "Chart", "Headline"].contains(&item.as_str()));
            found.extend(defined.map(|item| format!("{} defines {item}", module.file.display())));
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn the_reader_of_sources_sees_circles_and_arrows() {
    let directory = tempfile_directory();
    let put = |name: &str, text: &str| {
        let path = directory.join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    };
    put("lib.rs", "pub mod a;\npub mod b;\n");
    put("a/mod.rs", "mod one;\nmod two;\npub use one::One;\npub use two::{Two, make as made};\n");
    put("a/one.rs", "use super::Two;\npub struct One(Two);\n");
    put("a/two.rs", "//! use super::One;\npub struct Two;\npub fn make() { crate::b::go(); }\n");
    put("b.rs", "pub fn go() {}\n#[cfg(test)]\nmod tests { use crate::a::One; }\n");
    let mut modules = Modules::new();
    read(&directory, &[], &mut modules);
    let find =
        |here: &str, path: &str| resolve(&modules, &words(here), &words(path), 0).map(|m| m.join("::"));
    assert_eq!(find("b", "crate::a::One").as_deref(), Some("a::one"));
    assert_eq!(find("a::one", "super::Two").as_deref(), Some("a::two"));
    assert_eq!(find("b", "crate::a::made").as_deref(), Some("a::two"));
    assert_eq!(modules[&words("a::two")].uses, [words("crate::b::go")]);
    assert!(modules[&words("b")].uses.is_empty());
    std::fs::remove_dir_all(directory).unwrap();
}

fn tempfile_directory() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("rooms-{}", std::process::id()))
}
