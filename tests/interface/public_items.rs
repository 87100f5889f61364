//! What the library `signorini` makes public: each room with its functions, types, fields and methods stands in
//! `tests/data/public_items.txt`, so that a review sees what comes and goes.
//!
//! Read from the sources: `pub` is what can be reached from outside, since `unreachable_pub` warns of all others.

use std::path::{Path, PathBuf};

/// The list. `SIGNORINI_WRITE_API=1` writes it anew.
const LIST: &str = "tests/data/public_items.txt";

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Files below `src`, sorted.
fn sources() -> Vec<PathBuf> {
    let (mut left, mut found) = (vec![root().join("src")], Vec::new());
    while let Some(path) = left.pop() {
        if path.is_dir() {
            left.extend(path.read_dir().unwrap().map(|entry| entry.unwrap().path()));
        } else if path.extension().is_some_and(|end| end == "rs") {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// The letters of a name at the start of a text.
fn name(text: &str) -> String {
    text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
}

/// The type that an `impl`, a `struct` or an `enum` at the outermost level is about.
fn owner(line: &str) -> Option<String> {
    if let Some(rest) = line.strip_prefix("impl") {
        let rest = if rest.starts_with('<') { rest.split_once("> ")?.1 } else { rest.trim_start() };
        return Some(name(rest.rsplit(" for ").next()?));
    }
    let rest = line.strip_prefix("pub ")?;
    ["struct ", "enum "].iter().find_map(|kind| rest.strip_prefix(kind)).map(name)
}

/// `Type.field`, `Type::function`, `function`, `Type` of a file.
fn items(text: &str) -> Vec<String> {
    let text = text.split("#[cfg(test)]\nmod ").next().unwrap_or("");
    let (mut found, mut of) = (Vec::new(), None);
    for line in text.lines() {
        if let Some(name) = owner(line) {
            of = Some(name);
        } else if line.starts_with('}') {
            of = None;
        }
        let Some(rest) = line.trim_start().strip_prefix("pub ") else { continue };
        let is_inside = line.starts_with(' ');
        let kinds = ["const fn ", "fn ", "struct ", "enum ", "const ", "type ", "trait "];
        let kind = kinds.iter().find(|kind| rest.starts_with(**kind));
        let of = of.as_deref().unwrap_or("");
        match (kind, is_inside) {
            (Some(kind), true) => found.push(format!("{of}::{}", name(&rest[kind.len()..]))),
            (Some(kind), false) => found.push(name(&rest[kind.len()..])),
            (None, true) if rest.contains(": ") => found.push(format!("{of}.{}", name(rest))),
            (None, _) => {}
        }
    }
    found
}

#[test]
fn the_list_of_public_items_is_up_to_date() {
    let mut now: Vec<String> = Vec::new();
    for file in sources() {
        let below = file.strip_prefix(root().join("src")).unwrap().with_extension("");
        let room = below.components().next().unwrap().as_os_str().to_str().unwrap().to_owned();
        let text = std::fs::read_to_string(&file).unwrap();
        now.extend(items(&text).into_iter().map(|item| format!("{room} {item}")));
    }
    now.sort();
    assert!(now.len() > 300 && now.contains(&"contact ContactSolution.energy".to_owned()));
    if std::env::var_os("SIGNORINI_WRITE_API").is_some() {
        std::fs::write(root().join(LIST), now.join("\n") + "\n").unwrap();
    }
    let kept = std::fs::read_to_string(root().join(LIST)).unwrap_or_default();
    let gone: Vec<&str> = kept.lines().filter(|line| !now.iter().any(|l| l == line)).collect();
    let new: Vec<&String> = now.iter().filter(|line| !kept.lines().any(|k| k == *line)).collect();
    assert!(
        gone.is_empty() && new.is_empty(),
        "gone: {gone:#?}\nnew: {new:#?}\nif meant: SIGNORINI_WRITE_API=1 cargo test --release --test interface public_items"
    );
}
