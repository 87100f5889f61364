//! Every public function of the toolkit stands in an example of its documentation, which is compiled
//! and run; and `tests/data/public-api.txt` lists what is public, so that a review sees what goes or changes.
//!
//! Read from the sources: `pub fn` is what can be reached from outside, since `unreachable_pub` warns of all
//! others. A free function counts where an example calls it; a method where an example calls it and names its
//! type, or stands in a file of that type; a constructor where an example calls it by its type.

use std::path::{Path, PathBuf};

/// A public function: file, type, name, and whether it takes `self`.
#[derive(Debug, Clone, PartialEq)]
struct Function {
    file: PathBuf,
    of: Option<String>,
    name: String,
    takes_self: bool,
}

/// The sources.
fn sources() -> Vec<(PathBuf, String)> {
    let mut left = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("src")];
    let mut found = Vec::new();
    while let Some(path) = left.pop() {
        if path.is_dir() {
            left.extend(path.read_dir().unwrap().map(|entry| entry.unwrap().path()));
        } else if let Ok(text) = std::fs::read_to_string(&path) {
            found.push((path, text.split("#[cfg(test)]\nmod ").next().unwrap_or("").to_owned()));
        }
    }
    found.sort();
    found
}

/// The code blocks of the documentation that are compiled.
fn examples(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut open: Option<(bool, String)> = None;
    for line in text.lines().map(str::trim_start) {
        let Some(line) = line.strip_prefix("///").or_else(|| line.strip_prefix("//!")) else {
            open = None;
            continue;
        };
        let line = line.strip_prefix(' ').unwrap_or(line);
        match (line.strip_prefix("```"), &mut open) {
            (Some(kind), None) => open = Some((kind.is_empty() || kind == "rust", String::new())),
            (Some(_), Some((compiled, block))) => {
                if *compiled {
                    found.push(std::mem::take(block));
                }
                open = None;
            }
            (None, Some((_, block))) => {
                block.push_str(line);
                block.push('\n');
            }
            (None, None) => {}
        }
    }
    found
}

/// The type of an `impl` line.
fn implemented(line: &str) -> Option<String> {
    let rest = line.strip_prefix("impl")?;
    let rest = if rest.starts_with('<') { rest.split_once("> ")?.1 } else { rest.trim_start() };
    let name = rest.rsplit(" for ").next()?.trim_start_matches('&');
    Some(name.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect())
}

fn functions(file: &Path, text: &str) -> Vec<Function> {
    let (mut found, mut of) = (Vec::new(), None);
    let lines: Vec<&str> = text.lines().collect();
    for (k, line) in lines.iter().enumerate() {
        if let Some(name) = implemented(line) {
            of = Some(name);
        } else if line.starts_with('}') {
            of = None;
        }
        let Some(rest) = line.trim_start().strip_prefix("pub ") else { continue };
        let Some(rest) = rest.strip_prefix("const ").unwrap_or(rest).strip_prefix("fn ") else {
            continue;
        };
        let name: String = rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
        let signature = lines[k..lines.len().min(k + 3)].join(" ");
        let arguments = signature.split_once(&format!("fn {name}")).unwrap().1;
        let first = arguments.split_once('(').map_or("", |(_, rest)| rest.trim_start());
        let first = first.split([',', ')', ':']).next().unwrap_or("");
        let takes_self =
            first.split_whitespace().any(|word| word.trim_start_matches('&') == "self");
        found.push(Function { file: file.to_owned(), of: of.clone(), name, takes_self });
    }
    found
}

/// Whether the text holds the word, with `before` in front of it.
fn has(text: &str, before: &str, word: &str) -> bool {
    let part = |c: char| c.is_alphanumeric() || c == '_';
    text.match_indices(&format!("{before}{word}")).any(|(at, found)| {
        let starts = !before.is_empty() || !text[..at].ends_with(part);
        starts && !text[at + found.len()..].starts_with(part)
    })
}

/// The functions that stand in no example.
fn missing(sources: &[(PathBuf, String)]) -> Vec<String> {
    let blocks: Vec<(&Path, String)> = sources
        .iter()
        .flat_map(|(file, text)| examples(text).into_iter().map(|block| (file.as_path(), block)))
        .collect();
    let of_type = |file: &Path, name: &str| {
        let text = &sources.iter().find(|source| source.0 == file).unwrap().1;
        text.lines().any(|line| implemented(line).as_deref() == Some(name))
    };
    let shown = |function: &Function| {
        blocks.iter().any(|(file, block)| match &function.of {
            None => has(block, "", &function.name),
            Some(of) if function.takes_self => {
                let called = has(block, ".", &function.name)
                    || has(block, &format!("{of}::"), &function.name);
                called && (has(block, "", of) || of_type(file, of))
            }
            Some(of) => has(block, &format!("{of}::"), &function.name),
        })
    };
    let all = sources.iter().filter(|(file, _)| !file.ends_with("lib.rs"));
    let all: Vec<Function> = all.flat_map(|(file, text)| functions(file, text)).collect();
    assert!(all.len() > 100, "{} public functions", all.len());
    let without = all.iter().filter(|function| !shown(function));
    without
        .map(|f| {
            format!("{}{}", f.of.as_ref().map_or(String::new(), |of| format!("{of}::")), f.name)
        })
        .collect()
}

#[test]
fn every_public_function_of_the_toolkit_stands_in_an_example() {
    let missing = missing(&sources());
    assert!(missing.is_empty(), "{} functions without an example: {missing:#?}", missing.len());
}

/// What is declared public, up to its body, with its type before a method.
fn declarations(text: &str) -> Vec<String> {
    let (mut found, mut of) = (Vec::new(), None);
    let lines: Vec<&str> = text.lines().collect();
    for (k, line) in lines.iter().enumerate() {
        if let Some(name) = implemented(line) {
            of = Some(name);
        } else if line.starts_with('}') {
            of = None;
        }
        let Some(rest) = line.trim_start().strip_prefix("pub ") else { continue };
        if ["mod ", "use "].iter().any(|word| rest.starts_with(word)) {
            continue;
        }
        let (mut whole, mut next) = (line.trim().to_owned(), k);
        let is_function = rest.starts_with("fn ") || rest.starts_with("const fn ");
        while is_function && !whole.ends_with(['{', ';']) && next + 1 < lines.len() {
            next += 1;
            whole = format!("{whole} {}", lines[next].trim());
        }
        let whole =
            whole.trim_end_matches(['{', ';', ',', ' ']).replace("( ", "(").replace(", )", ")");
        found.push(of.as_ref().map_or(whole.clone(), |of| format!("{of}: {whole}")));
    }
    found
}

/// Where the list of public items is kept. `SIGNORINI_WRITE_API=1` writes it anew.
const API: &str = "tests/data/public-api.txt";

#[test]
fn the_list_of_public_items_is_up_to_date() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut lines: Vec<String> = Vec::new();
    for (file, text) in sources() {
        let file = file.strip_prefix(root.join("src")).unwrap().with_extension("");
        let room = file.components().next().unwrap().as_os_str().to_str().unwrap().to_owned();
        lines.extend(declarations(&text).into_iter().map(|whole| format!("{room} | {whole}")));
    }
    lines.sort();
    let now = lines.join("\n") + "\n";
    if std::env::var_os("SIGNORINI_WRITE_API").is_some() {
        std::fs::write(root.join(API), &now).unwrap();
    }
    let kept = std::fs::read_to_string(root.join(API)).unwrap_or_default();
    let gone: Vec<&str> = kept.lines().filter(|line| !lines.iter().any(|l| l == line)).collect();
    let new: Vec<&String> = lines.iter().filter(|line| !kept.lines().any(|k| k == *line)).collect();
    assert!(
        gone.is_empty() && new.is_empty(),
        "gone or changed: {gone:#?}\nnew: {new:#?}\nif meant: SIGNORINI_WRITE_API=1 cargo test -p fractional-sobolev --test interface documented, and a \
         line in CHANGELOG.md"
    );
}
