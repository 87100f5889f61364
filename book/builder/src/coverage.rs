//! Examples and pages belong together: every example shows its outcome on a page, every page leads to an
//! example and opens with a picture, and no command on a page names an example, no code type a file, that is
//! not there.

use crate::chapter::Page;
use crate::data::names;
use crate::error::{Fault, Result};
use crate::scan::{Kind, line_at, pieces};
use std::collections::BTreeSet;
use std::path::Path;

/// Directives that show the outcome of an example; a bare name or verdict does not.
const SHOWN: [&str; 7] = ["table", "measured", "figure", "slider", "value", "finding", "findings"];
/// Directives that draw a picture.
const PICTURES: [&str; 3] = ["{{idea:", "{{figure:", "{{slider:"];
/// How a command names an example.
const COMMAND: &str = "--example ";

/// Directories whose files pages name.
const DIRECTORIES: [&str; 5] = ["src/", "tests/", "examples/", "book/", "toolkit/"];

/// Faults of the pages against the programs and files of a repository.
///
/// # Errors
/// When the directory of examples cannot be read.
pub fn faults(pages: &[Page], repository: &Path) -> Result<Vec<Fault>> {
    let examples = &repository.join("examples");
    let programs: Vec<String> = names(examples)?
        .into_iter()
        .filter_map(|n| n.strip_suffix(".rs").map(str::to_owned))
        .collect();
    let summary =
        std::fs::read_to_string(repository.join("book/src/SUMMARY.md")).unwrap_or_default();
    let mut found = Vec::new();
    let mut shown = BTreeSet::new();
    for page in pages {
        let on_page = outcomes(page, &programs);
        let commands = commands(&page.text);
        for &(at, name) in &commands {
            if !programs.iter().any(|p| p == name) {
                let line = line_at(&page.text, at);
                found.push(Fault::new(&page.file, line, "command names an unknown example", name));
            }
        }
        for (at, name) in files(&page.text) {
            if !repository.join(name).exists() {
                let line = line_at(&page.text, at);
                found.push(Fault::new(&page.file, line, "file does not exist", name));
            }
        }
        if on_page.is_empty() && commands.is_empty() {
            found.push(Fault::new(&page.file, 1, "page without an example", page.html.as_str()));
        }
        let opening =
            page.text.lines().find(|line| !line.trim().is_empty() && !line.starts_with("# "));
        if !opening.is_some_and(|line| PICTURES.iter().any(|picture| line.starts_with(picture))) {
            let line = opening.unwrap_or("");
            found.push(Fault::new(&page.file, 1, "page does not open with a picture", line));
        }
        shown.extend(on_page);
        // One page has one title: that of the table of contents.
        let title = page.text.lines().next().unwrap_or("").trim_start_matches("# ");
        let title = title.split(" {#").next().unwrap_or(title);
        let file = page.html.replace(".html", ".md");
        if !summary.is_empty() && !summary.contains(&format!("[{title}]({file})")) {
            found.push(Fault::new(
                &page.file,
                1,
                "not the title that SUMMARY.md gives the page",
                title,
            ));
        }
    }
    let missing = programs.iter().filter(|name| !shown.contains(*name));
    found.extend(missing.map(|name| {
        let file = Path::new("examples").join(name).with_extension("rs");
        Fault::new(&file, 1, "no page shows what this example computes", name)
    }));
    Ok(found)
}

/// Examples whose outcome a page shows.
fn outcomes(page: &Page, programs: &[String]) -> BTreeSet<String> {
    let found = pieces(&page.text).unwrap_or_default();
    let directives = found.iter().filter(|piece| piece.kind == Kind::Directive).filter(|piece| {
        let name = piece.text.split(':').next().unwrap_or("").trim();
        SHOWN.contains(&name)
    });
    let words =
        directives.flat_map(|piece| piece.text.split(|c: char| !c.is_alphanumeric() && c != '_'));
    words.filter(|word| programs.iter().any(|p| p == word)).map(str::to_owned).collect()
}

/// Examples named by the commands of a page, with their place.
fn commands(text: &str) -> Vec<(usize, &str)> {
    text.match_indices(COMMAND)
        .filter_map(|(at, _)| {
            let rest = &text[at + COMMAND.len()..];
            let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
            (end > 0).then_some((at, &rest[..end]))
        })
        .collect()
}

/// Files of the repository that stand between single backticks, with their place.
fn files(text: &str) -> Vec<(usize, &str)> {
    let is_file = |name: &str| {
        DIRECTORIES.iter().any(|d| name.starts_with(d)) && !name.contains(char::is_whitespace)
    };
    let starts = text.match_indices('`').map(|(at, _)| at + 1);
    starts
        .filter_map(|at| Some((at, text[at..].split_once('`')?.0)))
        .filter(|(_, name)| is_file(name))
        .collect()
}
