//! `cargo course skeleton NAME`: writes the programs of `tests/NAME.rs` with holes in place of their solutions to
//! `tests/mine_NAME.rs`. Without dependencies, so that the first exercise waits for no compiler.
//! Slides and sheets are written by `cargo book course`.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

const USAGE: &str =
    "usage: cargo course skeleton NAME, NAME one of before, contact, estimate, zone, rates";
/// Before the hint of a hole, and behind a hole.
const HOLE: [&str; 2] = ["    // solution: ", "    // end"];

fn main() -> ExitCode {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let ["skeleton", name] = words.as_slice() else {
        eprintln!("{USAGE}");
        return ExitCode::from(2);
    };
    match skeleton(here, name) {
        Ok(file) => {
            println!("file://{}", file.display());
            println!("fill the holes, then: cargo test --release -p course --test mine_{name}");
            println!("solutions: book/course/tests/{name}.rs");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{error}\n{USAGE}");
            ExitCode::FAILURE
        }
    }
}

/// Writes programs with holes; the file must not be there yet.
fn skeleton(here: &Path, name: &str) -> Result<PathBuf, String> {
    let file = here.join("tests").join(format!("mine_{name}.rs"));
    if file.exists() {
        return Err(format!("{} exists: move it away first", file.display()));
    }
    let source = here.join("tests").join(format!("{name}.rs"));
    let failed = |path: &Path, error: std::io::Error| format!("{}: {error}", path.display());
    let text = std::fs::read_to_string(&source).map_err(|error| failed(&source, error))?;
    std::fs::write(&file, holes(&text)).map_err(|error| failed(&file, error))?;
    Ok(file)
}

/// The programs with a `todo!` that carries the hint in place of each solution.
fn holes(programs: &str) -> String {
    let mut text = "#![allow(unused, clippy::todo, reason = \"holes\")]\n".to_owned();
    let (mut header, mut rest) = ("", programs);
    // Documentation of the file comes before its attributes.
    if let Some(end) = programs.find("\n\n") {
        (header, rest) = programs.split_at(end + 1);
    }
    text.insert_str(0, header);
    let mut is_hole = false;
    for line in rest.lines() {
        if let Some(hint) = line.strip_prefix(HOLE[0]) {
            let _ = writeln!(text, "    todo!({hint:?})");
            is_hole = true;
        } else if line == HOLE[1] {
            is_hole = false;
        } else if !is_hole {
            text.push_str(line);
            text.push('\n');
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILES: [&str; 5] = ["before", "contact", "estimate", "zone", "rates"];

    fn programs(name: &str) -> String {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/{name}.rs"));
        std::fs::read_to_string(file).unwrap()
    }

    /// A hole is the whole body of a function, so that the skeleton compiles whatever is in it.
    #[test]
    fn a_hole_is_the_body_of_a_function() {
        for name in FILES {
            let text = programs(name);
            let lines: Vec<&str> = text.lines().collect();
            let holes = lines.iter().filter(|line| line.starts_with(HOLE[0])).count();
            assert!(holes >= 4, "{name}");
            assert_eq!(holes, lines.iter().filter(|line| **line == HOLE[1]).count(), "{name}");
            for pair in lines.windows(2) {
                assert!(
                    !pair[1].starts_with(HOLE[0]) || pair[0].ends_with('{'),
                    "{name}: {}",
                    pair[0]
                );
                assert!(pair[0] != HOLE[1] || pair[1] == "}", "{name}: {}", pair[1]);
            }
        }
    }

    /// What a notebook leaves open is a hole of the programs here, so that both stay the same exercises.
    #[test]
    fn holes_of_the_notebooks_are_those_of_the_programs() {
        let holes: String = FILES.iter().map(|name| holes(&programs(name))).collect();
        for (name, least) in [("before", 7), ("later", 10)] {
            let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("{name}.ipynb"));
            let notebook = std::fs::read_to_string(file).unwrap();
            let (mut function, mut found) = ("", 0);
            for line in notebook.lines().map(str::trim) {
                let code = line.trim_start_matches('"');
                if let Some(rest) = code.strip_prefix("def ") {
                    function = rest.split('(').next().unwrap_or("");
                }
                if code.contains("raise NotImplementedError(") {
                    found += 1;
                    let start = format!("fn {function}(");
                    let body = holes.split(&start).nth(1).and_then(|rest| rest.split("\n}").next());
                    let is_hole = body.is_some_and(|body| body.contains("todo!("));
                    assert!(is_hole, "{name}: {function}");
                }
            }
            assert!(found >= least, "{name}: {found} holes");
        }
    }

    #[test]
    fn a_skeleton_holds_hints_and_tests_and_no_solution() {
        let text = holes(
            "//! Head.\n\nfn a() -> usize {\n    // solution: add\n    1 + 1\n    // end\n}\n\n#[test]\nfn b() {}\n",
        );
        assert!(text.starts_with("//! Head.\n#![allow"), "{text}");
        assert!(text.contains("fn a() -> usize {\n    todo!(\"add\")\n}\n\n#[test]"), "{text}");
        assert!(!text.contains("1 + 1"));
    }
}
