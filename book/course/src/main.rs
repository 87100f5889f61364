//! `cargo course`: writes the slides and the exercise sheets of the course next to the pages of the book, from
//! `slides.md`, `sessions.toml` and the book's `exercises.toml`. `cargo course skeleton NAME`: writes the programs of
//! `tests/NAME.rs` with holes in place of their solutions to `tests/mine_NAME.rs`.

use book_builder::chapter::Page;
use book_builder::directive::Sources;
use book_builder::error::{Error, Result};
use book_builder::{Layout, decimal, html, page};
use pulldown_cmark::{Options, Parser};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

const USAGE: &str = "usage: cargo course [skeleton NAME]";
/// Before the hint of a hole, and behind a hole.
const HOLE: [&str; 2] = ["    // solution: ", "    // end"];
const STYLE: &str = include_str!("../course.css");

fn main() -> ExitCode {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let done = match words.as_slice() {
        [] => course(here),
        ["skeleton", name] => skeleton(here, name).map(|file| vec![file]),
        _ => {
            eprintln!("{USAGE}");
            return ExitCode::from(2);
        }
    };
    match done {
        Ok(files) => {
            for file in files {
                println!("file://{}", file.display());
            }
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

/// The written files: slides, then two editions of each sheet.
fn course(here: &Path) -> Result<Vec<PathBuf>> {
    let repository = here.join("../..");
    let layout = Layout::of(&repository.canonicalize().unwrap_or(repository));
    let mut pages = vec![one("course.html", read(&here.join("slides.md"))?)];
    let exercises = table(&layout.book.join("exercises.toml"))?;
    let sessions = table(&here.join("sessions.toml"))?;
    for (k, session) in entries(&sessions, "session").iter().enumerate() {
        for with_solutions in [false, true] {
            let name = format!("sheet_{k}{}.html", if with_solutions { "_solutions" } else { "" });
            pages.push(one(&name, sheet(session, &exercises, with_solutions)));
        }
    }
    // All formulas at once, so that references have the numbers of the book.
    let own = pages.len();
    pages.extend(html::chapters(&layout.book, &layout.repository)?);
    let mut data = book_builder::committed(&layout)?;
    data.options.clear();
    let allowed = decimal::allow_list(&read(&layout.book.join("allowed-decimals.txt")).unwrap_or_default());
    let (examples, tests) = (layout.repository.join("examples"), layout.repository.join("tests"));
    let ideas = layout.book.join("ideas");
    let sources =
        Sources { data: &data, examples: &examples, tests: &tests, ideas: &ideas, allowed: &allowed };
    let marked = page::mark(&pages, &sources).map_err(Error::Faults)?;
    let output = layout.book.join("html");
    let mut files = Vec::new();
    for (page, text) in pages[..own].iter().zip(&marked.texts) {
        let file = output.join(&page.html);
        let body = marked.unmark(&page.html, &markdown(text)).map_err(Error::Mdbook)?;
        write(&file, document(&page.html, &body))?;
        files.push(file);
    }
    Ok(files)
}

fn failed(path: &Path, error: &std::io::Error) -> Error {
    Error::Data { path: path.to_owned(), message: error.to_string() }
}

fn read(path: &Path) -> Result<String> {
    std::fs::read_to_string(path).map_err(|e| failed(path, &e))
}

fn write(path: &Path, text: String) -> Result<()> {
    std::fs::write(path, text).map_err(|e| failed(path, &e))
}

fn one(name: &str, text: String) -> Page {
    Page { file: Path::new("book/course").join(name), html: name.to_owned(), text }
}

/// HTML of Markdown; each heading of the second level begins a section, which the slides show as one page.
fn markdown(text: &str) -> String {
    let mut body = String::new();
    // The pages of the book list the letters of a formula that the notation defines.
    let lines: Vec<&str> = text.lines().filter(|line| !line.starts_with("*Letters:*")).collect();
    let text = lines.join("\n");
    let parser = Parser::new_ext(&text, Options::ENABLE_TABLES);
    pulldown_cmark::html::push_html(&mut body, parser);
    body.replace(".md\"", ".html\"").replace(".md#", ".html#").replace("<h2>", "</section><section><h2>")
}

fn document(name: &str, body: &str) -> String {
    let kind = if name.starts_with("sheet") { "sheet" } else { "slides" };
    let title = body.split("<h1>").nth(1).and_then(|rest| rest.split("</h1>").next()).unwrap_or("");
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{title}</title>\
         <style>{STYLE}</style></head>\n<body class=\"{kind}\"><section>{body}</section></body></html>\n"
    )
}

fn table(file: &Path) -> Result<toml::Table> {
    let wrong = |e: toml::de::Error| Error::Data { path: file.to_owned(), message: e.to_string() };
    read(file)?.parse().map_err(wrong)
}

fn entries<'a>(table: &'a toml::Table, key: &str) -> Vec<&'a toml::Value> {
    table.get(key).and_then(toml::Value::as_array).map_or(Vec::new(), |list| list.iter().collect())
}

fn text<'a>(entry: &'a toml::Value, key: &str) -> &'a str {
    entry.get(key).and_then(toml::Value::as_str).unwrap_or("").trim()
}

/// The exercises of a session's pages as Markdown.
fn sheet(session: &toml::Value, exercises: &toml::Table, with_solutions: bool) -> String {
    let edition = if with_solutions { ", with solutions" } else { "" };
    let mut sheet = format!("# {}{edition}\n", text(session, "title"));
    let pages = session.get("pages").and_then(toml::Value::as_array);
    let names = pages.into_iter().flatten().filter_map(toml::Value::as_str);
    for (k, exercise) in names.flat_map(|page| entries(exercises, page)).enumerate() {
        let _ = write!(sheet, "\n**{}.** {}\n", k + 1, text(exercise, "ask"));
        let (program, hint) = (text(exercise, "program"), text(exercise, "hint"));
        if let Some((file, function)) = program.split_once("::") {
            let _ = write!(
                sheet,
                "\n```sh\ncargo course skeleton {file}\ncargo test --release -p course --test mine_{file} {function}\n```\n"
            );
        }
        if !hint.is_empty() {
            let _ = write!(sheet, "\n*Hint.* {hint}\n");
        }
        if with_solutions {
            let _ = write!(sheet, "\n> *Solution.* {}\n", text(exercise, "answer").replace('\n', "\n> "));
        }
    }
    sheet
}

/// Writes programs with holes; the file must not be there yet.
fn skeleton(here: &Path, name: &str) -> Result<PathBuf> {
    let file = here.join("tests").join(format!("mine_{name}.rs"));
    if file.exists() {
        return Err(Error::Mdbook(format!("{} exists: move it away first", file.display())));
    }
    write(&file, holes(&read(&here.join("tests").join(format!("{name}.rs")))?))?;
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
        read(&Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/{name}.rs"))).unwrap()
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
                assert!(!pair[1].starts_with(HOLE[0]) || pair[0].ends_with('{'), "{name}: {}", pair[0]);
                assert!(pair[0] != HOLE[1] || pair[1] == "}", "{name}: {}", pair[1]);
            }
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

    #[test]
    fn every_program_of_an_exercise_has_a_hole_and_a_test() {
        let book = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let exercises = table(&book.join("exercises.toml")).unwrap();
        let all: Vec<&toml::Value> = exercises.keys().flat_map(|page| entries(&exercises, page)).collect();
        let asked: Vec<&str> = all.iter().map(|e| text(e, "program")).filter(|p| !p.is_empty()).collect();
        assert!(4 * asked.len() >= all.len(), "{} of {}", asked.len(), all.len());
        for program in asked {
            let (file, function) = program.split_once("::").unwrap();
            let text = programs(file);
            let body = text.split(&format!("\nfn {function}(")).nth(1).unwrap_or_else(|| panic!("{program}"));
            assert!(body.split("\n}\n").next().unwrap().contains(HOLE[0]), "{program}");
            let checks = text.split("#[test]\nfn ").skip(1).filter(|test| test.starts_with(function)).count();
            assert_eq!(checks, 1, "{program}");
        }
    }
}
