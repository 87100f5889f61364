//! The list of labels: every statement of the paper with its example, test, page and room, in `labels.toml`.
//!
//! The table of the README, the table of contents of `src/lib.rs` and the lemma cards are made from it, between lines that hold
//! `labels` and `end of labels`. Every name in the list must exist; every example must have a label.

use crate::code;
use crate::data::names;
use crate::error::{Error, Fault, Result, read, write};
use std::fmt::Write as _;
use std::path::Path;

/// The list, below the repository.
pub const LIST: &str = "labels.toml";

/// One statement of the paper.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Label {
    /// "Lemma 5.2, (5.1) to (5.3)".
    pub label: String,
    /// The table of the lemma cards it stands in.
    pub group: String,
    /// The statement in plain words.
    pub words: String,
    /// The statement as the cards print it, with formulas.
    pub statement: String,
    /// Under which assumptions; may be empty.
    pub assumptions: String,
    /// The example that computes it.
    pub example: String,
    /// The test that backs it, `file::function`.
    pub test: String,
    /// The page, without its ending.
    pub page: String,
    /// The file of the library, from the repository.
    pub room: String,
    /// Items of the library, as paths from its root.
    pub items: Vec<String>,
    /// In place of a verdict where no example prints one.
    pub note: String,
    /// The line of the list.
    line: usize,
}

/// Reads the list; an absent one is empty.
///
/// # Errors
/// [`Error::File`], [`Error::Data`] with the place of a fault in the list.
pub fn list(repository: &Path) -> Result<Vec<Label>> {
    let path = repository.join(LIST);
    if !path.exists() {
        return Ok(Vec::new());
    }
    let text = read(&path)?;
    let wrong = |message: String| Error::Data { path: path.clone(), message };
    let table: toml::Table = text.parse().map_err(|e: toml::de::Error| wrong(e.to_string()))?;
    let starts: Vec<usize> = lines_with(&text, "[[label]]").collect();
    let entries = table.get("label").and_then(toml::Value::as_array).cloned().unwrap_or_default();
    let entry = |(k, value): (usize, &toml::Value)| {
        let line = starts.get(k).copied().unwrap_or(1);
        one(value, line).map_err(|what| wrong(format!("line {line}: {what}")))
    };
    entries.iter().enumerate().map(entry).collect()
}

/// Numbers, from 1, of the lines that contain `text`.
fn lines_with<'a>(file: &'a str, text: &'a str) -> impl Iterator<Item = usize> + 'a {
    file.lines().enumerate().filter(move |(_, line)| line.contains(text)).map(|(k, _)| k + 1)
}

fn one(value: &toml::Value, line: usize) -> std::result::Result<Label, String> {
    let mut label = Label { line, ..Label::default() };
    for (key, value) in value.as_table().into_iter().flatten() {
        let words = || value.as_str().map(str::to_owned).ok_or_else(|| format!("{key} is not a text"));
        match key.as_str() {
            "label" => label.label = words()?,
            "group" => label.group = words()?,
            "words" => label.words = words()?,
            "statement" => label.statement = words()?,
            "assumptions" => label.assumptions = words()?,
            "example" => label.example = words()?,
            "test" => label.test = words()?,
            "page" => label.page = words()?,
            "room" => label.room = words()?,
            "note" => label.note = words()?,
            "items" => {
                let list = value.as_array().ok_or("items is not a list")?;
                label.items = list.iter().filter_map(|item| item.as_str().map(str::to_owned)).collect();
            }
            _ => return Err(format!("unknown key {key}")),
        }
    }
    if label.label.is_empty() || label.words.is_empty() || label.group.is_empty() {
        return Err("a label needs `label`, `group` and `words`".to_owned());
    }
    if label.statement.is_empty() {
        label.statement = label.words.clone();
    }
    Ok(label)
}

/// Names in the list that do not exist, and examples that are not in it.
///
/// # Errors
/// When a directory cannot be read.
pub fn faults(labels: &[Label], repository: &Path) -> Result<Vec<Fault>> {
    if labels.is_empty() {
        return Ok(Vec::new());
    }
    let mut found = Vec::new();
    let (examples, tests) = (repository.join("examples"), repository.join("tests"));
    for label in labels {
        let mut fault = |what: &str, name: &str| {
            found.push(Fault::new(Path::new(LIST), label.line, what, name));
        };
        if !label.example.is_empty() && code::program(&examples, &label.example).is_err() {
            fault("unknown example", &label.example);
        }
        let (file, function) = label.test.split_once("::").unwrap_or((&label.test, ""));
        let function = (!function.is_empty()).then_some(function);
        if !label.test.is_empty() && code::test(&tests, file, function).is_err() {
            fault("unknown test", &label.test);
        }
        if !label.page.is_empty() && !repository.join(format!("book/src/{}.md", label.page)).exists() {
            fault("unknown page", &label.page);
        }
        if !label.room.is_empty() && !repository.join(&label.room).is_file() {
            fault("unknown file", &label.room);
        }
        let is_empty = label.example.is_empty() || label.page.is_empty();
        if is_empty && label.note.is_empty() {
            fault("neither example and page nor a note", &label.label);
        }
    }
    for name in names(&examples)? {
        let Some(program) = name.strip_suffix(".rs") else { continue };
        if !labels.iter().any(|label| label.example == program) {
            found.push(Fault::new(Path::new(LIST), 1, "example without a label", program));
        }
    }
    Ok(found)
}

/// A file with a table made from the list, and what that table is.
type Region = (&'static str, String, fn(&[&Label]) -> String);

/// All of them; the cards have one per group.
fn regions(labels: &[Label]) -> Vec<Region> {
    let mut groups: Vec<&str> = labels.iter().map(|label| label.group.as_str()).collect();
    groups.dedup();
    let mut regions: Vec<Region> =
        vec![("README.md", String::new(), readme_table), ("src/lib.rs", String::new(), contents_table)];
    let cards = |group: &&str| {
        ("book/src/lemma_cards.md", (*group).to_owned(), cards_table as fn(&[&Label]) -> String)
    };
    regions.extend(groups.iter().map(cards));
    regions
}

fn readme_table(labels: &[&Label]) -> String {
    let mut text = "| paper | example | test | page | room |\n| --- | --- | --- | --- | --- |\n".to_owned();
    let code = |name: &str| if name.is_empty() { String::new() } else { format!("`{name}`") };
    for label in labels {
        let file = label.test.split("::").next().unwrap_or("");
        let page =
            if label.page.is_empty() { String::new() } else { format!("[{0}](book/src/{0}.md)", label.page) };
        let room = if label.room.is_empty() { String::new() } else { format!("[{0}]({0})", label.room) };
        let _ = writeln!(
            text,
            "| {}: {} | {} | {} | {page} | {room} |",
            label.label,
            label.words,
            code(&label.example),
            code(file),
        );
    }
    text
}

fn contents_table(labels: &[&Label]) -> String {
    let mut text = "//! | paper | here |\n//! | --- | --- |\n".to_owned();
    for label in labels.iter().filter(|label| !label.items.is_empty()) {
        let items: Vec<String> = label.items.iter().map(|item| format!("[`{item}`]")).collect();
        let _ = writeln!(text, "//! | {}: {} | {} |", label.label, label.words, items.join(", "));
    }
    text
}

fn cards_table(labels: &[&Label]) -> String {
    let mut text = "| label | statement | assumptions | example | test | verdict |\n".to_owned();
    text.push_str("| --- | --- | --- | --- | --- | --- |\n");
    for label in labels {
        let directive = |name: &str, key: &str| {
            if key.is_empty() { "none".to_owned() } else { format!("{{{{{name}: {key}}}}}") }
        };
        let verdict =
            if label.note.is_empty() { directive("verdict", &label.example) } else { label.note.clone() };
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {verdict} |",
            label.label,
            label.statement,
            label.assumptions,
            directive("example", &label.example),
            directive("test", &label.test),
        );
    }
    text
}

/// The lines between those that begin and end a region, as byte offsets.
fn bounds(text: &str, group: &str) -> Option<(usize, usize)> {
    let begin =
        if group.is_empty() { "<!-- labels -->".to_owned() } else { format!("<!-- labels: {group} -->") };
    let start = text.find(&begin)?;
    let start = start + text[start..].find('\n')? + 1;
    let end = start + text[start..].find("<!-- end of labels -->")?;
    Some((start, text[..end].rfind('\n')? + 1))
}

/// Tables that are not what the list says.
///
/// # Errors
/// When a file cannot be read.
pub fn stale(labels: &[Label], repository: &Path) -> Result<Vec<Fault>> {
    let mut found = Vec::new();
    each(labels, repository, |file, text, (start, end), table| {
        if text[start..end] != *table {
            let line = crate::scan::line_at(text, start);
            found.push(Fault::new(
                Path::new(file),
                line,
                "table is not that of the list (run `cargo book`)",
                LIST,
            ));
        }
        Ok(())
    })?;
    Ok(found)
}

/// Writes the tables into their files.
///
/// # Errors
/// When a file cannot be read or written, or has no place for its table.
pub fn renew(labels: &[Label], repository: &Path) -> Result<()> {
    each(labels, repository, |file, text, (start, end), table| {
        if text[start..end] == *table {
            return Ok(());
        }
        write(&repository.join(file), format!("{}{table}{}", &text[..start], &text[end..]))
    })
}

fn each(
    labels: &[Label],
    repository: &Path,
    mut visit: impl FnMut(&str, &str, (usize, usize), &String) -> Result<()>,
) -> Result<()> {
    if labels.is_empty() {
        return Ok(());
    }
    for (file, group, table) in regions(labels) {
        let path = repository.join(file);
        let text = read(&path)?;
        let missing = || Error::Data {
            path: path.clone(),
            message: format!(
                "no lines `<!-- labels{}{group} -->` and `<!-- end of labels -->`",
                if group.is_empty() { "" } else { ": " }
            ),
        };
        let place = bounds(&text, &group).ok_or_else(missing)?;
        let mine: Vec<&Label> = labels.iter().filter(|l| group.is_empty() || l.group == group).collect();
        // Comment lines of a source file end the region with their own marker.
        visit(file, &text, place, &table(&mine))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const ENTRY: &str = "[[label]]\nlabel = \"Lemma 1\"\ngroup = \"tools\"\nwords = \"so\"\nexample = \"ex\"\n\
        test = \"lemma::holds\"\npage = \"lemma\"\nroom = \"src/a.rs\"\nitems = [\"a::f\"]\n";

    fn repository() -> tempfile::TempDir {
        let directory = tempfile::tempdir().unwrap();
        let put = |path: &str, text: &str| write(&directory.path().join(path), text).unwrap();
        put(LIST, ENTRY);
        put("examples/ex.rs", "");
        put("tests/lemma.rs", "#[test]\nfn holds() {}\n");
        put("book/src/lemma.md", "");
        put("src/a.rs", "");
        put("README.md", "a\n\n<!-- labels -->\n<!-- end of labels -->\nb\n");
        put("src/lib.rs", "//! <!-- labels -->\n//! <!-- end of labels -->\n");
        put("book/src/lemma_cards.md", "<!-- labels: tools -->\n<!-- end of labels -->\n");
        directory
    }

    #[test]
    fn tables_are_made_from_the_list_and_old_ones_found() {
        let directory = repository();
        let labels = list(directory.path()).unwrap();
        assert!(faults(&labels, directory.path()).unwrap().is_empty());
        assert_eq!(stale(&labels, directory.path()).unwrap().len(), 3);
        renew(&labels, directory.path()).unwrap();
        assert!(stale(&labels, directory.path()).unwrap().is_empty());
        let text = |file: &str| read(&directory.path().join(file)).unwrap();
        assert!(
            text("src/lib.rs").contains("//! | Lemma 1: so | [`a::f`] |\n//! <!-- end"),
            "{}",
            text("src/lib.rs")
        );
        assert!(text("README.md").contains("[src/a.rs](src/a.rs)") && text("README.md").ends_with("b\n"));
        assert!(text("book/src/lemma_cards.md").contains("{{verdict: ex}}"));
    }

    #[test]
    fn names_that_do_not_exist_are_faults() {
        for (from, to) in
            [("\"ex\"", "\"none\""), ("holds", "fails"), ("\"lemma\"", "\"lem\""), ("a.rs", "b.rs")]
        {
            let directory = repository();
            write(&directory.path().join(LIST), ENTRY.replace(from, to)).unwrap();
            let labels = list(directory.path()).unwrap();
            assert!(!faults(&labels, directory.path()).unwrap().is_empty(), "{from} -> {to}");
        }
        let directory = repository();
        for text in
            ["[[label]]\nlabel = 3\n", "[[label]]\nwhat = \"x\"\n", "[[label", "[[label]]\nlabel = \"a\"\n"]
        {
            write(&directory.path().join(LIST), text).unwrap();
            assert!(list(directory.path()).is_err(), "{text}");
        }
    }
}
