//! Nothing is exported that nobody enters: every name that a library exports is used by two of its readers, or by
//! Python, or is a type that stands in a public signature. Readers are the examples, their report, the start pages and
//! those of the book (their programs), the course, and for the toolkit the contact library; tests do not count. Read from
//! the sources.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Exports with one reader that is too long to hold them: the room and the name, and who that is.
const ONE_READER: [(&str, &str, &str); 14] = [
    ("mesh", "parse_msh_with", "the twin of read_msh_with for a text"),
    ("mesh", "read_msh", "src/with_contact.md"),
    ("mesh", "read_msh_with", "examples/section_2_own_body.rs"),
    ("mesh", "unit_squares", "examples/guaranteed_error_against_seconds.rs"),
    ("contact", "npy", "examples/section_2_own_body.rs"),
    ("edge", "ContactPair", "examples/theorem_3_1_proof_profile.rs"),
    ("edge", "radial_intervals", "examples/section_1_clamped_end.rs"),
    ("mesh", "parse_msh", "examples/section_2_own_body.rs"),
    ("mesh", "mapped_grid", "book/src/toolkit.md"),
    ("problems", "solution_regularity", "examples/section_2_singular_exponents.rs"),
    ("problems", "DirichletEnd", "examples/section_1_clamped_end.rs"),
    ("proof", "ProofConstants", "examples/theorem_3_1_proof_profile.rs"),
    ("proof", "midpoint_bound", "examples/segment_constants.rs"),
    ("singular", "LARGEST", "examples/section_2_singular_exponents.rs"),
];

/// The reader of the toolkit that counts as a program, as Python does.
const CONTACT: &str = "the contact library";

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap()
}

/// The files below a directory with this extension.
fn files(directory: &str, extension: &str) -> Vec<PathBuf> {
    let (mut left, mut found) = (vec![root().join(directory)], Vec::new());
    while let Some(path) = left.pop() {
        if path.is_dir() {
            left.extend(path.read_dir().unwrap().map(|entry| entry.unwrap().path()));
        } else if path.extension().is_some_and(|e| e == extension) {
            found.push(path);
        }
    }
    found
}

/// The code without comments and without the tests of the file.
fn code(text: &str) -> String {
    let text = text.split("#[cfg(test)]\nmod ").next().unwrap_or("");
    text.lines().filter_map(|line| line.split("//").next()).collect::<Vec<_>>().join("\n")
}

/// The programs of a page.
fn programs(page: &str) -> String {
    let is_program = |block: &&str| block.starts_with('\n') || block.starts_with("rust");
    page.split("```").skip(1).step_by(2).filter(is_program).collect()
}

/// The names in `pub use` of a file, and its own public functions, types and constants.
fn exports(text: &str) -> Vec<String> {
    let text = code(text);
    let listed = text.split("\npub use ").skip(1).filter_map(|rest| rest.split(';').next());
    let listed = listed.flat_map(|path| match path.split_once('{') {
        Some((_, names)) => {
            names.trim_end_matches('}').split(',').map(|n| n.trim().to_owned()).collect()
        }
        None => vec![path.rsplit("::").next().unwrap().trim().to_owned()],
    });
    let own = ["fn ", "struct ", "enum ", "const ", "type "].into_iter().flat_map(|kind| {
        let name = |rest: &str| {
            rest.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap().to_owned()
        };
        text.split(&format!("\npub {kind}")).skip(1).map(name).collect::<Vec<_>>()
    });
    listed
        .chain(own)
        .filter(|name| !name.is_empty() && name != "Error" && name != "Result")
        .collect()
}

fn has(text: &str, word: &str) -> bool {
    let part = |c: char| c.is_alphanumeric() || c == '_';
    text.match_indices(word)
        .any(|(at, _)| !text[..at].ends_with(part) && !text[at + word.len()..].starts_with(part))
}

/// The public signatures and fields of the sources: what follows `pub fn` up to the body, and lines of fields.
fn signatures(directory: &str) -> String {
    let mut found = String::new();
    for text in files(directory, "rs").iter().map(|path| code(&read(path))) {
        for rest in text.split("pub fn ").skip(1).chain(text.split("pub const fn ").skip(1)) {
            found += rest.split(" {\n").next().unwrap_or("");
            found.push('\n');
        }
        let field = |line: &&str| {
            line.starts_with("    pub ")
                && line.contains(": ")
                && !line.contains("fn ")
                && !line.contains('=')
        };
        text.lines().filter(field).for_each(|line| found = format!("{found}{line}\n"));
        // The data of public enums.
        for rest in text.split("\npub enum ").skip(1) {
            found += rest.split("\n}").next().unwrap_or("");
        }
    }
    found
}

/// Exports of the rooms below a directory that nobody enters, with the only reader of each.
fn unread(directory: &str, roots: &[(String, PathBuf)]) -> Vec<(String, String, String)> {
    let mut readers: BTreeMap<String, String> = BTreeMap::new();
    let name = |path: &Path| path.strip_prefix(root()).unwrap().display().to_string();
    for path in files("examples", "rs") {
        let reader = if name(&path).contains("report") { "report".to_owned() } else { name(&path) };
        *readers.entry(reader).or_default() += &code(&read(&path));
    }
    for path in files("book/src", "md") {
        readers.insert(name(&path), programs(&read(&path)));
    }
    for path in files("book/course", "rs") {
        *readers.entry("course".to_owned()).or_default() += &code(&read(&path));
    }
    for page in ["README.md", "src/with_contact.md", "toolkit/README.md"] {
        readers.insert(page.to_owned(), programs(&read(&root().join(page))));
    }
    if directory != "src" {
        let contact = files("src", "rs").iter().map(|path| code(&read(path))).collect();
        readers.insert(CONTACT.to_owned(), contact);
    }
    let python: String = files("python/src", "rs").iter().map(|path| code(&read(path))).collect();
    let signatures = signatures(directory);
    let mut found = Vec::new();
    for (room, path) in roots {
        for export in exports(&format!("\n{}", read(path))) {
            let users: Vec<&str> = readers
                .iter()
                .filter(|(_, text)| has(text, &export))
                .map(|(name, _)| name.as_str())
                .collect();
            let is_type =
                export.starts_with(char::is_uppercase) && export.contains(char::is_lowercase);
            let program = has(&python, &export) || users.contains(&CONTACT);
            if users.len() < 2 && !program && !(is_type && has(&signatures, &export)) {
                found.push((room.clone(), export, users.first().unwrap_or(&"").to_string()));
            }
        }
    }
    found
}

#[test]
fn every_export_has_two_readers_or_stands_in_a_signature() {
    let rooms: Vec<(String, PathBuf)> = read(&root().join("src/lib.rs"))
        .lines()
        .filter_map(|line| line.strip_prefix("pub mod ")?.strip_suffix(';'))
        .map(|room| {
            let folder = root().join(format!("src/{room}/mod.rs"));
            (
                room.to_owned(),
                if folder.exists() { folder } else { root().join(format!("src/{room}.rs")) },
            )
        })
        .collect();
    assert!(rooms.len() > 8, "{rooms:?}");
    let toolkit = [("toolkit".to_owned(), root().join("toolkit/src/lib.rs"))];
    let mut found = unread("src", &rooms);
    found.extend(unread("toolkit/src", &toolkit));
    found.retain(|(room, name, _)| {
        !ONE_READER.iter().any(|listed| (listed.0, listed.1) == (room, name))
    });
    assert!(found.is_empty(), "room, name, only reader: {found:#?}");
}
