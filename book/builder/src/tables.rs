//! What is made from lists, between two lines of a file: the tables of the lemma cards from `labels.toml`; the
//! chapters in `src/book.rs` (documentation tests) from `SUMMARY.md`.

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
/// The page with the lemma cards.
const CARDS: &str = "book/src/every_label.md";
/// The group of statements that have rows of their own on that page, in its tables by section, and no card.
const BY_SECTION: &str = "by section";
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
    for (group, members) in groups(labels).into_iter().filter(|(group, _)| *group != BY_SECTION) {
        let marks = (format!("<!-- labels: {group} -->"), "<!-- end of labels -->");
        found.push(Region { file: CARDS, marks, lines: cards_table(&members), source: LIST });
    }
    if labels.iter().any(Label::is_judged) {
        let marks = ("<!-- labels -->".to_owned(), "<!-- end of labels -->");
        found.push(Region { file: CERTAINTY, marks, lines: certainty_table(labels), source: LIST });
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

fn cards_table(labels: &[&Label]) -> String {
    let mut text = "| label | statement | assumptions | example | test | verdict |\n".to_owned();
    text.push_str("| --- | --- | --- | --- | --- | --- |\n");
    for label in labels {
        let directive = |name: &str, key: &str| {
            if key.is_empty() { "none".to_owned() } else { format!("{{{{{name}: {key}}}}}") }
        };
        let verdict = if label.note.is_empty() {
            directive("verdict", &label.example)
        } else {
            label.note.clone()
        };
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
    let files =
        summary.split("](").skip(1).filter_map(|rest| rest.split_once(')').map(|(file, _)| file));
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
        test = \"lemma::it_holds\"\npage = \"lemma\"\nroom = \"src/a.rs\"\n\
        [[label]]\nlabel = \"Remark\"\ngroup = \"rest\"\nwords = \"more\"\nnote = \"none\"\n\
        [[label]]\nlabel = \"Lemma 2\"\ngroup = \"tools\"\nwords = \"so too\"\nnote = \"none\"\npage = \"two\"\n\
        proved = \"yes\"\nopen = \"the constant\"\n\
        [[label]]\nlabel = \"(5.1)\"\ngroup = \"by section\"\nwords = \"has its row\"\nnote = \"none\"\n";

    fn repository() -> tempfile::TempDir {
        let directory = tempfile::tempdir().unwrap();
        let put = |path: &str, text: &str| write(&directory.path().join(path), text).unwrap();
        put(LIST, LABELS);
        put("examples/ex.rs", "");
        put(SUMMARY, "# Summary\n\n[How](how.md)\n\n- [(3.2): so](lemma.md)\n");
        put(CERTAINTY, "<!-- labels -->\n<!-- end of labels -->\n");
        put(
            CHAPTERS,
            "chapters! {\n    // chapters\n    old: \"old.md\",\n    // end of chapters\n}\n",
        );
        let cards = "<!-- labels: tools -->\n<!-- end of labels -->\n<!-- labels: rest -->\n";
        put(CARDS, &format!("{cards}<!-- end of labels -->\n"));
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
        assert_eq!(stale_files(), [CARDS, CARDS, CERTAINTY, CHAPTERS]);
        renew(&labels, directory.path()).unwrap();
        assert!(stale_files().is_empty());
        let text = |file: &str| read(&directory.path().join(file)).unwrap();
        assert!(text(CARDS).contains("{{verdict: ex}} |\n| Lemma 2 |"), "{}", text(CARDS));
        assert!(!text(CARDS).contains("(5.1)"), "{}", text(CARDS));
        let row = "| --- |\n| [Lemma 2](two.md) | yes |  | the constant |\n<!-- end";
        assert!(text(CERTAINTY).contains(row), "{}", text(CERTAINTY));
        let lines = "    // chapters\n    readme: \"../../README.md\",\n    how: \"how.md\",\n    lemma: \"lemma.md\",\n    // end";
        assert!(text(CHAPTERS).contains(lines), "{}", text(CHAPTERS));
        // Another order: the list is old again.
        write(&directory.path().join(SUMMARY), "[So](lemma.md)\n[How](how.md)\n").unwrap();
        assert_eq!(stale_files(), [CHAPTERS]);
    }
}
