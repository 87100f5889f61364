//! The list of labels: every statement of the paper with its example, test, page and room, in `labels.toml`.
//!
//! Tables are made from it ([`crate::tables`]). Every name in the list must exist; every example must have a
//! label.

use crate::code;
use crate::data::names;
use crate::error::{Error, Fault, Result, read};
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
    /// In place of a verdict where no example prints one.
    pub note: String,
    /// What of the statement has a proof; with `seen` and `open` it makes a row of one table, see [`Label::is_judged`].
    pub proved: String,
    /// What is computed and has no proof.
    pub seen: String,
    /// What is neither proved nor computed.
    pub open: String,
    /// The line of the list.
    line: usize,
}

impl Label {
    /// True if the list says what is proved, seen or open.
    pub fn is_judged(&self) -> bool {
        ![&self.proved, &self.seen, &self.open].into_iter().all(String::is_empty)
    }
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
        let words =
            || value.as_str().map(str::to_owned).ok_or_else(|| format!("{key} is not a text"));
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
            "proved" => label.proved = words()?,
            "seen" => label.seen = words()?,
            "open" => label.open = words()?,
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
        if !label.page.is_empty()
            && !repository.join(format!("book/src/{}.md", label.page)).exists()
        {
            fault("unknown page", &label.page);
        }
        if !label.room.is_empty() && !repository.join(&label.room).is_file() {
            fault("unknown file", &label.room);
        }
        if label.is_judged() && label.page.is_empty() {
            fault("proved, seen or open without a page", &label.label);
        }
        if !label.seen.is_empty() && label.example.is_empty() && label.test.is_empty() {
            fault("seen without example and test", &label.label);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::write;

    const ENTRY: &str = "[[label]]\nlabel = \"Lemma 1\"\ngroup = \"tools\"\nwords = \"so\"\nexample = \"ex\"\n\
        test = \"lemma::holds\"\npage = \"lemma\"\nroom = \"src/a.rs\"\n";

    fn repository() -> tempfile::TempDir {
        let directory = tempfile::tempdir().unwrap();
        let put = |path: &str, text: &str| write(&directory.path().join(path), text).unwrap();
        put(LIST, ENTRY);
        put("examples/ex.rs", "");
        put("tests/lemma.rs", "#[test]\nfn holds() {}\n");
        put("book/src/lemma.md", "");
        put("src/a.rs", "");
        directory
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
        assert!(faults(&list(directory.path()).unwrap(), directory.path()).unwrap().is_empty());
        for more in ["proved = \"yes\"", "seen = \"so\""] {
            let entry = format!(
                "[[label]]\nlabel = \"a\"\ngroup = \"g\"\nwords = \"w\"\nnote = \"n\"\n{more}\n"
            );
            write(&directory.path().join(LIST), ENTRY.to_owned() + &entry).unwrap();
            assert!(
                !faults(&list(directory.path()).unwrap(), directory.path()).unwrap().is_empty(),
                "{more}"
            );
        }
        for text in [
            "[[label]]\nlabel = 3\n",
            "[[label]]\nwhat = \"x\"\n",
            "[[label",
            "[[label]]\nlabel = \"a\"\n",
        ] {
            write(&directory.path().join(LIST), text).unwrap();
            assert!(list(directory.path()).is_err(), "{text}");
        }
    }
}
