//! What is made from lists, between two lines of a file: the tables of CONTRIBUTING, of `src/with_contact.md`
//! and of the lemma cards from `labels.toml`; the chapters in `src/book.rs` (documentation tests) from
//! `SUMMARY.md`.

use crate::error::{Error, Fault, Result, read, write};
use crate::labels::{LIST, Label};
use std::fmt::Write as _;
use std::path::Path;

/// The chapters of the book in their order.
const SUMMARY: &str = "book/src/SUMMARY.md";
/// The page of what is proved, what is seen, what is open.
const CERTAINTY: &str = "book/src/what_is_proved.md";
/// Most rows that fit on one screen.
const ONE_SCREEN: usize = 24;
/// Every chapter as a documentation test.
const CHAPTERS: &str = "src/book.rs";

/// Lines of a file that are made from a list.
struct Region {
    file: &'static str,
    /// The line before them contains this, the line behind them the other.
    marks: (String, &'static str),
    lines: String,
    /// The list they are made from.
    source: &'static str,
}

/// All of them; the cards have one per group. Files of lists that are not there have none.
fn regions(labels: &[Label], repository: &Path) -> Result<Vec<Region>> {
    let mut found = Vec::new();
    let mut table = |file, group: Option<&str>, lines| {
        let begin = group.map_or("<!-- labels -->".to_owned(), |group| format!("<!-- labels: {group} -->"));
        found.push(Region { file, marks: (begin, "<!-- end of labels -->"), lines, source: LIST });
    };
    let groups = groups(labels);
    if !labels.is_empty() {
        let all: Vec<&Label> = groups.iter().flat_map(|(_, members)| members).copied().collect();
        table("CONTRIBUTING.md", None, readme_table(&all, repository));
        table("src/with_contact.md", None, contents_table(&all));
        for (group, members) in &groups {
            table("book/src/every_label.md", Some(group), cards_table(members));
        }
        if labels.iter().any(Label::is_judged) {
            table(CERTAINTY, None, certainty_table(labels));
        }
    }
    let mut list = |file, begin: &str, end, lines, source| {
        found.push(Region { file, marks: (begin.to_owned(), end), lines, source });
    };
    if repository.join(CHAPTERS).exists() {
        list(CHAPTERS, "// chapters", "// end of chapters", chapters(repository)?, SUMMARY);
    }
    Ok(found)
}

/// Groups in the order in which they first occur, each with all its labels.
fn groups(labels: &[Label]) -> Vec<(&str, Vec<&Label>)> {
    let mut groups: Vec<(&str, Vec<&Label>)> = Vec::new();
    for label in labels {
        match groups.iter_mut().find(|(group, _)| *group == label.group) {
            Some((_, members)) => members.push(label),
            None => groups.push((&label.group, vec![label])),
        }
    }
    groups
}

/// A link, or nothing; the text of a long name may break between its words.
fn link(text: &str, target: &str) -> String {
    if text.is_empty() { String::new() } else { format!("[{text}]({target})") }
}

fn readme_table(labels: &[&Label], repository: &Path) -> String {
    let mut text = "| paper | example | test | page | room |\n| --- | --- | --- | --- | --- |\n".to_owned();
    for label in labels {
        let Label { example, page, room, .. } = label;
        let (file, function) = label.test.split_once("::").unwrap_or((&label.test, ""));
        let colon = if function.is_empty() { "" } else { ": " };
        let _ = writeln!(
            text,
            "| {}: {} | {} | {}{colon}{} | {} | {} |",
            label.label,
            label.words,
            link(example, &format!("examples/{example}.rs")),
            link(file, &test_file(file, repository)),
            function.replace('_', " "),
            link(page, &format!("book/src/{page}.md")),
            link(room.strip_prefix("src/").unwrap_or(room), room),
        );
    }
    text
}

/// The file of a test: the toolkit has tests of its own.
fn test_file(name: &str, repository: &Path) -> String {
    let own = format!("toolkit/tests/{name}.rs");
    if repository.join(&own).exists() { own } else { format!("tests/{name}.rs") }
}

fn contents_table(labels: &[&Label]) -> String {
    let mut text = "| paper | here |\n| --- | --- |\n".to_owned();
    for label in labels.iter().filter(|label| !label.items.is_empty()) {
        let items: Vec<String> = label.items.iter().map(|item| format!("[`{item}`]")).collect();
        let _ = writeln!(text, "| {}: {} | {} |", label.label, label.words, items.join(", "));
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

/// One row for each label that says what is proved, seen or open.
fn certainty_table(labels: &[Label]) -> String {
    let mut text = "| statement | proved | seen | open |\n| --- | --- | --- | --- |\n".to_owned();
    for label in labels.iter().filter(|label| label.is_judged()) {
        let Label { label: name, page, proved, seen, open, .. } = label;
        let _ = writeln!(text, "| [{name}]({page}.md) | {proved} | {seen} | {open} |");
    }
    text
}

/// The README, then the chapters in the order of the summary.
fn chapters(repository: &Path) -> Result<String> {
    let summary = read(&repository.join(SUMMARY))?;
    let files = summary.split("](").skip(1).filter_map(|rest| rest.split_once(')').map(|(file, _)| file));
    let mut text = "    readme: \"../../README.md\",\n".to_owned();
    for name in files.filter_map(|file| file.strip_suffix(".md")) {
        let _ = writeln!(text, "    {name}: \"{name}.md\",");
    }
    Ok(text)
}

/// The bytes between the line that holds the first mark and the line that holds the second.
fn bounds(text: &str, (begin, end): &(String, &str)) -> Option<(usize, usize)> {
    let start = text.find(begin.as_str())?;
    let start = start + text[start..].find('\n')? + 1;
    let stop = start + text[start..].find(end)?;
    Some((start, text[..stop].rfind('\n')? + 1))
}

/// Regions that are not what their list says.
///
/// # Errors
/// [`Error::File`]; [`Error::Data`] for a file without the lines that mark a region.
pub fn stale(labels: &[Label], repository: &Path) -> Result<Vec<Fault>> {
    let mut found = Vec::new();
    let rows = labels.iter().filter(|label| label.is_judged()).count();
    if rows > ONE_SCREEN {
        let what = format!("{rows} rows, at most {ONE_SCREEN} fit on one screen");
        found.push(Fault::new(Path::new(CERTAINTY), 1, "too long", &what));
    }
    each(labels, repository, |region, text, (start, end)| {
        if text[start..end] != *region.lines {
            let line = crate::scan::line_at(text, start);
            let what = "not what its list says (run `cargo book labels`)";
            found.push(Fault::new(Path::new(region.file), line, what, region.source));
        }
        Ok(())
    })?;
    Ok(found)
}

/// Writes all regions into their files.
///
/// # Errors
/// As [`stale`], and when a file cannot be written.
pub fn renew(labels: &[Label], repository: &Path) -> Result<()> {
    each(labels, repository, |region, text, (start, end)| {
        if text[start..end] == *region.lines {
            return Ok(());
        }
        let file = repository.join(region.file);
        write(&file, format!("{}{}{}", &text[..start], region.lines, &text[end..]))
    })
}

fn each(
    labels: &[Label],
    repository: &Path,
    mut visit: impl FnMut(&Region, &str, (usize, usize)) -> Result<()>,
) -> Result<()> {
    for region in regions(labels, repository)? {
        let path = repository.join(region.file);
        let text = read(&path)?;
        let (begin, end) = &region.marks;
        let message = format!("no lines `{begin}` and `{end}`");
        let place = bounds(&text, &region.marks).ok_or(Error::Data { path, message })?;
        visit(&region, &text, place)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::labels::list;

    const LABELS: &str = "[[label]]\nlabel = \"Lemma 1\"\ngroup = \"tools\"\nwords = \"so\"\nexample = \"ex\"\n\
        test = \"lemma::it_holds\"\npage = \"lemma\"\nroom = \"src/a.rs\"\nitems = [\"a::f\"]\n\
        [[label]]\nlabel = \"Remark\"\ngroup = \"rest\"\nwords = \"more\"\nnote = \"none\"\n\
        [[label]]\nlabel = \"Lemma 2\"\ngroup = \"tools\"\nwords = \"so too\"\nnote = \"none\"\npage = \"two\"\n\
        proved = \"yes\"\nopen = \"the constant\"\n";

    fn repository() -> tempfile::TempDir {
        let directory = tempfile::tempdir().unwrap();
        let put = |path: &str, text: &str| write(&directory.path().join(path), text).unwrap();
        put(LIST, LABELS);
        put("examples/ex.rs", "");
        put(SUMMARY, "# Summary\n\n[How](how.md)\n\n- [(3.2): so](lemma.md)\n");
        put("CONTRIBUTING.md", "a\n\n<!-- labels -->\n<!-- end of labels -->\nb\n");
        put("src/with_contact.md", "<!-- labels -->\n<!-- end of labels -->\n");
        put(CERTAINTY, "<!-- labels -->\n<!-- end of labels -->\n");
        put(CHAPTERS, "chapters! {\n    // chapters\n    old: \"old.md\",\n    // end of chapters\n}\n");
        let cards = "<!-- labels: tools -->\n<!-- end of labels -->\n<!-- labels: rest -->\n";
        put("book/src/every_label.md", &format!("{cards}<!-- end of labels -->\n"));
        directory
    }

    #[test]
    fn regions_are_made_from_their_lists_and_old_ones_found() {
        let directory = repository();
        let labels = list(directory.path()).unwrap();
        let stale_files = || {
            let faults = stale(&labels, directory.path()).unwrap();
            faults.into_iter().map(|fault| fault.file.display().to_string()).collect::<Vec<_>>()
        };
        let cards = "book/src/every_label.md";
        assert_eq!(
            stale_files(),
            ["CONTRIBUTING.md", "src/with_contact.md", cards, cards, CERTAINTY, CHAPTERS]
        );
        renew(&labels, directory.path()).unwrap();
        assert!(stale_files().is_empty());
        let text = |file: &str| read(&directory.path().join(file)).unwrap();
        let contents = text("src/with_contact.md");
        assert!(contents.contains("| Lemma 1: so | [`a::f`] |\n<!-- end"), "{contents}");
        let readme = text("CONTRIBUTING.md");
        let row = "| Lemma 1: so | [ex](examples/ex.rs) | [lemma](tests/lemma.rs): it holds | \
                   [lemma](book/src/lemma.md) | [a.rs](src/a.rs) |\n| Lemma 2: so too |  |  | [two](book/src/two.md) |  |\n| Remark";
        assert!(readme.contains(row) && readme.ends_with("b\n"), "{readme}");
        assert!(text(cards).contains("{{verdict: ex}} |\n| Lemma 2 |"), "{}", text(cards));
        let row = "| --- |\n| [Lemma 2](two.md) | yes |  | the constant |\n<!-- end";
        assert!(text(CERTAINTY).contains(row), "{}", text(CERTAINTY));
        let lines = "    // chapters\n    readme: \"../../README.md\",\n    how: \"how.md\",\n    lemma: \"lemma.md\",\n    // end";
        assert!(text(CHAPTERS).contains(lines), "{}", text(CHAPTERS));
        // Another order: the list is old again.
        write(&directory.path().join(SUMMARY), "[So](lemma.md)\n[How](how.md)\n").unwrap();
        assert_eq!(stale_files(), [CHAPTERS]);
    }
}
