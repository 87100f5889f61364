//! The pages as plain Markdown, to be read where no book is built: numbers filled in, formulas with their
//! macros expanded between dollars, pictures and code by links relative to `book/pages`.

use crate::chapter::Page;
use crate::code;
use crate::directive::{self, LONG, Meaning, Sources};
use crate::error::{Fault, Result, read, write};
use crate::formula::{self, Labels};
use crate::layout::Layout;
use crate::letters::Letters;
use crate::markup::tags;
use crate::page::fill;
use crate::scan::{Kind, Piece, pieces};
use crate::{idea, include, sentence, slider};
use std::path::Path;

/// Below the directory of the book.
const DIRECTORY: &str = "pages";

/// Macros that GitHub refuses ("The following macros are not allowed"): they could hide text or redefine others.
const REFUSED: [&str; 24] = [
    "operatorname",
    "DeclareMathOperator",
    "phantom",
    "hphantom",
    "vphantom",
    "mbox",
    "newcommand",
    "renewcommand",
    "providecommand",
    "newenvironment",
    "renewenvironment",
    "def",
    "gdef",
    "edef",
    "xdef",
    "let",
    "require",
    "href",
    "class",
    "style",
    "cssId",
    "unicode",
    "data",
    "mmlToken",
];

/// Everything of the edition: file names with their text, the index first.
///
/// # Errors
/// [`crate::error::Error::File`] when the summary cannot be read.
pub fn edition(
    layout: &Layout,
    pages: &[Page],
    sources: &Sources<'_>,
    labels: &Labels,
) -> Result<Vec<(String, String)>> {
    let summary = read(&layout.book.join("src/SUMMARY.md"))?;
    let index = summary.trim_start_matches("# Summary").trim().replace("\n[", "\n- [");
    let index = if index.starts_with('[') { format!("- {index}") } else { index };
    let head = "<!-- Written by `cargo book`; do not edit. -->\n\n# The book, to be read here\n\n\
        Every page with its numbers, formulas and pictures. `cargo book` builds the same as HTML, \
        `cargo book serve` lets the pages compute with other parameters.";
    let mut files = vec![("README.md".to_owned(), format!("{head}\n\n{index}\n"))];
    let letters = Letters::read(pages);
    for page in pages {
        let name = page.html.replace(".html", ".md");
        let writer = Writer { page, sources, labels, letters: &letters, pages, layout };
        files.push((name, writer.write()));
    }
    Ok(files)
}

/// Writes the edition; files that are no page of it are removed.
///
/// # Errors
/// [`crate::error::Error::File`].
pub fn renew(layout: &Layout, files: &[(String, String)]) -> Result<()> {
    let directory = layout.book.join(DIRECTORY);
    for name in crate::data::names(&directory)? {
        if !files.iter().any(|(known, _)| *known == name) {
            let _ = std::fs::remove_file(directory.join(name));
        }
    }
    files.iter().try_for_each(|(name, text)| write(&directory.join(name), text))
}

/// Files of the edition that are not what `cargo book` writes.
///
/// # Errors
/// [`crate::error::Error::File`].
pub fn stale(layout: &Layout, files: &[(String, String)]) -> Result<Vec<Fault>> {
    let directory = layout.book.join(DIRECTORY);
    let place = |name: &str| Path::new("book").join(DIRECTORY).join(name);
    let mut faults = Vec::new();
    for (name, text) in files {
        let committed = std::fs::read_to_string(directory.join(name)).unwrap_or_default();
        let mut pairs = committed.lines().zip(text.lines());
        let line = pairs.position(|(old, new)| old != new).unwrap_or(committed.lines().count());
        if committed != *text {
            let now = text.lines().nth(line).unwrap_or("");
            faults.push(Fault::new(
                &place(name),
                line + 1,
                "not what `cargo book build` writes",
                now,
            ));
        }
    }
    let unknown = crate::data::names(&directory)?;
    let unknown = unknown.iter().filter(|name| !files.iter().any(|(known, _)| known == *name));
    faults.extend(unknown.map(|name| Fault::new(&place(name), 1, "no page of the book", name)));
    Ok(faults)
}

/// Formulas of the edition with a macro that a repository's own page refuses to render.
pub fn refused(files: &[(String, String)]) -> Vec<Fault> {
    let mut faults = Vec::new();
    for (name, text) in files {
        for (k, line) in text.lines().enumerate() {
            let words = line.split('\\').skip(1);
            let words = words
                .map(|rest| rest.split(|c: char| !c.is_ascii_alphabetic()).next().unwrap_or(""));
            faults.extend(words.filter(|word| line.contains('$') && REFUSED.contains(word)).map(
                |word| {
                    let place = Path::new("book").join(DIRECTORY).join(name);
                    Fault::new(
                        &place,
                        k + 1,
                        "a macro that a repository's page does not render",
                        word,
                    )
                },
            ));
        }
    }
    faults
}

/// One page.
struct Writer<'a> {
    page: &'a Page,
    sources: &'a Sources<'a>,
    labels: &'a Labels,
    letters: &'a Letters,
    pages: &'a [Page],
    layout: &'a Layout,
}

impl Writer<'_> {
    fn write(&self) -> String {
        let source = self.page.html.replace(".html", ".md");
        let mut text =
            format!("<!-- Written by `cargo book` from book/src/{source}; do not edit. -->\n\n");
        let mut opens = true;
        for piece in pieces(&self.page.text).unwrap_or_default() {
            match piece.kind {
                Kind::Prose => text.push_str(piece.text),
                Kind::Code => text.push_str(&self.code(piece.text)),
                Kind::Inline | Kind::Display => text.push_str(&self.formula(&piece)),
                Kind::Directive => {
                    let (written, is_block) = self.directive(piece.text, sentence::begins(&text));
                    text.push_str(&written);
                    if is_block && std::mem::take(&mut opens) {
                        text.push_str(&self.letters());
                    }
                }
            }
        }
        text.trim_end().to_owned() + "\n"
    }

    fn letters(&self) -> String {
        let link = |letter: crate::letters::Letter| {
            format!("[${}$](notation.md#{})", portable(&letter.latex, self.labels), letter.section)
        };
        let list: Vec<String> = self.letters.of(self.page).into_iter().map(link).collect();
        if list.is_empty() { String::new() } else { format!("\n\n*Letters:* {}", list.join(", ")) }
    }

    /// Code with what it includes, without the lines that only a compiler needs.
    fn code(&self, text: &str) -> String {
        if !text.starts_with("```") {
            return text.to_owned();
        }
        let is_rust = text.starts_with("```rust");
        let mut lines = Vec::new();
        for line in
            text.lines().filter(|line| !(is_rust && (line.starts_with("# ") || *line == "#")))
        {
            let body =
                line.trim().strip_prefix("{{#include ").and_then(|rest| rest.strip_suffix("}}"));
            match body.and_then(|body| include::text(body, &self.layout.book.join("src"))) {
                Some(included) => lines.push(included),
                None if line.starts_with("```rust") => lines.push("```rust".to_owned()),
                None => lines.push(line.to_owned()),
            }
        }
        lines.join("\n") + if text.ends_with('\n') { "\n" } else { "" }
    }

    fn formula(&self, piece: &Piece<'_>) -> String {
        let latex = fill(piece.text, self.sources).unwrap_or_default();
        let latex = latex.replace("\n>", "\n");
        let only = latex.trim().strip_prefix(r"\eqref{").and_then(|rest| rest.strip_suffix('}'));
        if let Some(label) = only.and_then(|label| self.labels.get(label)) {
            return format!(
                "[({})]({})",
                label.number,
                self.pages[label.page].html.replace(".html", ".md")
            );
        }
        let latex = portable(&latex, self.labels);
        if piece.kind == Kind::Display { format!("$${latex}$$") } else { format!("${latex}$") }
    }

    /// What a directive stands for, and whether that is a paragraph.
    fn directive(&self, text: &str, begins: bool) -> (String, bool) {
        let parts: Vec<&str> = text.splitn(3, ':').map(str::trim).collect();
        match parts.as_slice() {
            ["figure", name, caption] => {
                let full = self.sources.data.figure(name).map_or("", |(full, _)| full);
                (self.picture(&[(String::new(), self.figure(full))], "", caption, full), true)
            }
            ["slider", parameter, rest] => {
                let (list, caption) = rest.split_once(':').unwrap_or((rest, ""));
                let frames = slider::frames(list, self.sources.data).unwrap_or_default();
                let frames: Vec<_> =
                    frames.into_iter().map(|(label, name)| (label, self.figure(&name))).collect();
                (self.picture(&frames, parameter, caption.trim(), ""), true)
            }
            ["idea", name, caption] => {
                let frames = idea::frames(self.sources.ideas, name).unwrap_or_default();
                let parameter = frames
                    .first()
                    .map_or(String::new(), |f| idea::parameter(self.sources.ideas, &f.1));
                let frames: Vec<_> = frames
                    .into_iter()
                    .map(|(label, file)| (label, format!("../ideas/{file}")))
                    .collect();
                (self.picture(&frames, &parameter, caption, ""), true)
            }
            _ => match directive::resolve(text, self.sources) {
                Ok(Meaning::Number(number)) => (number.html(), false),
                Ok(Meaning::Words(words)) => {
                    let words = if begins { sentence::capitalised(&words) } else { words };
                    (inline(&words), false)
                }
                Ok(Meaning::Name(name)) if code::program(self.sources.examples, &name).is_ok() => {
                    (format!("[`{name}`](../../examples/{name}.rs)"), false)
                }
                Ok(Meaning::Name(name)) => (format!("`{name}`"), false),
                Ok(Meaning::Block(html)) => (table(&html), true),
                Ok(Meaning::Markdown(block)) => (block.replace("```rust,ignore", "```rust"), true),
                Err(what) => (what, false),
            },
        }
    }

    /// The file of a figure, seen from the pages.
    fn figure(&self, full: &str) -> String {
        let large = self.layout.large().join("figures").join(format!("{full}.svg"));
        let below = if large.exists() { "generated/large" } else { "generated" };
        format!("../{below}/figures/{full}.svg")
    }

    /// The frame that a book shows first, links to the others, the caption, and the numbers behind a chart.
    fn picture(
        &self,
        frames: &[(String, String)],
        parameter: &str,
        caption: &str,
        data: &str,
    ) -> String {
        let shown = frames.len().saturating_sub(1) / 2;
        let Some((label, file)) = frames.get(shown) else { return String::new() };
        // The caption stands below the picture, so the alternative text does not repeat it.
        let mut text = format!("![Picture]({file})\n\n*{}*", caption.replace(['[', ']'], ""));
        if frames.len() > 1 {
            let others = frames.iter().filter(|frame| frame.0 != *label);
            let others: Vec<String> =
                others.map(|(label, file)| format!("[{label}]({file})")).collect();
            text.push_str(&format!(" ({parameter}: {label}; also {})", others.join(", ")));
        }
        if self.sources.data.series.contains_key(data) {
            text.push_str(&format!(" ([data]({}))", file.replace(".svg", ".csv")));
        }
        text
    }
}

/// Words of a page: of the tags only indices, powers and emphasis stay.
fn inline(html: &str) -> String {
    let mut text = String::new();
    let mut at = 0;
    for tag in tags(html) {
        text.push_str(&escaped(&html[at..tag.start]));
        match tag.name.trim_start_matches('/') {
            "sub" | "sup" | "b" => text.push_str(&html[tag.start..tag.end]),
            "strong" => text.push_str("**"),
            _ => {}
        }
        at = tag.end;
    }
    text + &escaped(&html[at..])
}

/// Stars and underscores as such, but for code.
fn escaped(text: &str) -> String {
    let parts = text.split('`').enumerate();
    let written = parts.map(|(k, part)| {
        if k % 2 == 0 { part.replace('*', r"\*").replace('_', r"\_") } else { part.into() }
    });
    written.collect::<Vec<_>>().join("`")
}

/// A table as Markdown; one without a head gets that of findings.
fn table(html: &str) -> String {
    if html.is_empty() {
        return String::new();
    }
    let (body, key) = html.split_once("</table>").unwrap_or((html, ""));
    let cells = |row: &str| -> Vec<String> {
        let cells = row.split(['\n']).collect::<String>();
        let ends = cells.replace("</th>", "</td>").replace("<th>", "<td>");
        let cells = ends.split("<td").skip(1).filter_map(|cell| {
            let inner = cell.split_once('>')?.1.split("</td>").next()?;
            Some(inline(inner).replace('|', r"\|"))
        });
        cells.collect()
    };
    let mut rows: Vec<Vec<String>> =
        body.split("<tr>").skip(1).map(cells).filter(|row| !row.is_empty()).collect();
    if !html.contains("<th>") {
        rows.insert(0, ["outcome", "finding", "comparison"].map(str::to_owned).to_vec());
    }
    let of = rows.len() - 1;
    let is_long = html.contains("<th>") && of > LONG;
    if is_long {
        // From the first row to the last, evenly.
        let kept = (0..LONG).map(|k| 1 + (2 * k * (of - 1) + LONG - 1) / (2 * (LONG - 1)));
        rows = std::iter::once(0).chain(kept).map(|k| rows[k].clone()).collect();
    }
    let line = |row: &Vec<String>| format!("| {} |", row.join(" | "));
    let mut lines: Vec<String> = rows.iter().map(line).collect();
    if let Some(head) = rows.first() {
        lines.insert(1, format!("|{}", " --- |".repeat(head.len())));
    }
    let mut text = lines.join("\n");
    if is_long {
        text += &format!("\n\n{LONG} of {of} rows; the program prints all.");
    }
    match inline(key).trim() {
        "" => text,
        key if is_long => text + " " + key,
        key => text + "\n\n" + key,
    }
}

/// LaTeX without macros of this book, and without what Markdown would take for its own: escaped
/// punctuation, bars, angles and stars.
fn portable(latex: &str, labels: &Labels) -> String {
    let latex = latex.split_whitespace().collect::<Vec<_>>().join(" ");
    let expanded = allowed(&numbered(&expand(&latex), labels));
    let mut text = String::new();
    let mut rest = expanded.trim();
    while let Some(first) = rest.chars().next() {
        let escaped = [
            (r"\,", r"\thinspace"),
            (r"\;", r"\thickspace"),
            (r"\:", r"\medspace"),
            (r"\!", r"\negthinspace"),
            (r"\{", r"\lbrace"),
            (r"\}", r"\rbrace"),
            (r"\|", r"\Vert"),
            (r"\\", r"\cr"),
            ("<", r"\lt"),
            (">", r"\gt"),
            ("|", r"\vert"),
            ("*", r"\ast"),
        ];
        if let Some((mark, command)) = escaped.iter().find(|(mark, _)| rest.starts_with(mark)) {
            text.push_str(command);
            rest = &rest[mark.len()..];
            if rest.starts_with(|c: char| c.is_ascii_alphabetic()) {
                text.push(' ');
            }
        } else {
            text.push(first);
            rest = &rest[first.len_utf8()..];
        }
    }
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Macros replaced by what they mean.
fn expand(latex: &str) -> String {
    let mut text = latex.to_owned();
    for (name, meaning) in formula::MACROS {
        let command = format!("\\{name}");
        let mut at = 0;
        while let Some(found) = text[at..].find(&command).map(|k| at + k) {
            let behind = found + command.len();
            if text[behind..].starts_with(|c: char| c.is_ascii_alphabetic()) {
                at = behind;
                continue;
            }
            let end = if meaning.contains("#1") {
                argument(&text, behind)
            } else {
                Some((String::new(), behind))
            };
            let Some((inner, end)) = end else { break };
            text.replace_range(found..end, &meaning.replace("#1", &inner));
            at = found;
        }
    }
    text
}

/// The argument at this place, without its braces, and where it ends.
fn argument(text: &str, at: usize) -> Option<(String, usize)> {
    let start = at + text[at..].find(|c: char| !c.is_whitespace())?;
    if !text[start..].starts_with('{') {
        let first = text[start..].chars().next()?;
        let name = text[start + first.len_utf8()..]
            .find(|c: char| !c.is_ascii_alphabetic() || first != '\\');
        let end = start + first.len_utf8() + name.unwrap_or(text.len() - start - first.len_utf8());
        return Some((text[start..end].to_owned(), end));
    }
    let mut depth = 0;
    for (k, c) in text[start..].char_indices() {
        depth += i32::from(c == '{') - i32::from(c == '}');
        if depth == 0 {
            return Some((text[start + 1..start + k].to_owned(), start + k + 1));
        }
    }
    None
}

/// Names of operators by other means, and nothing for space.
fn allowed(latex: &str) -> String {
    let mut text = latex.to_owned();
    for (name, open) in [(r"\operatorname", r"\mathop{\mathrm{"), (r"\phantom", "")] {
        while let Some(found) = text.find(name) {
            let Some((inner, end)) = argument(&text, found + name.len()) else { break };
            let inner = if open.is_empty() { String::new() } else { format!("{open}{inner}}}}}") };
            text.replace_range(found..end, &inner);
        }
    }
    text
}

/// References as numbers; an equation by its number in place of its label.
fn numbered(latex: &str, labels: &Labels) -> String {
    let mut text = latex.replace(r"\begin{equation}", "").replace(r"\end{equation}", "");
    for (name, label) in labels {
        let (at, reference) = (format!("\\label{{{name}}}"), format!("\\eqref{{{name}}}"));
        let tag = if text.contains(r"\tag{") {
            String::new()
        } else {
            format!("\\tag{{{}}}", label.number)
        };
        text =
            text.replace(&at, &tag).replace(&reference, &format!("\\text{{({})}}", label.number));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formula::Label;

    #[test]
    fn long_tables_have_eight_rows_from_the_first_to_the_last() {
        let html = |rows: usize| {
            let body: String = (1..=rows).map(|k| format!("<tr><td>{k}</td></tr>")).collect();
            format!("<table><thead><tr><th>n</th></tr></thead><tbody>{body}</tbody></table>")
        };
        let of = |rows| table(&html(rows)).lines().map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(of(8).len(), 10);
        let long = of(22);
        let shown = long[2..10].iter().map(|row| row.trim_matches(['|', ' ']));
        assert_eq!(shown.collect::<Vec<_>>(), ["1", "4", "7", "10", "13", "16", "19", "22"]);
        assert_eq!(long[11], "8 of 22 rows; the program prints all.");
        assert_eq!(of(9)[2..10].join(""), "| 1 || 2 || 3 || 4 || 6 || 7 || 8 || 9 |");
        assert_eq!(table(""), "");
    }

    #[test]
    fn formulas_need_no_macro_and_survive_markdown() {
        let labels = [("bound".to_owned(), Label { page: 0, number: "5.2".to_owned() })].into();
        let of = |latex: &str| portable(latex, &labels);
        assert_eq!(
            of(r"\abs{\uN'}_\nu < \R"),
            r"\left\vert u_{\mathrm N}'\right\vert_\nu \lt \mathbb{R}"
        );
        assert_eq!(
            of(r"\int \norm{v} \dd x"),
            r"\int \left\Vert v\right\Vert \thinspace\mathrm{d} x"
        );
        assert_eq!(
            of(r"\abs{\abs{a} b}\Rho"),
            r"\left\vert\left\vert a\right\vert b\right\vert\Rho"
        );
        assert_eq!(
            of(r"\abs E + \abs \theta"),
            r"\left\vert E\right\vert + \left\vert\theta\right\vert"
        );
        assert_eq!(
            of(r"\operatorname{div} u &\phantom{{}\le{}} a"),
            r"\mathop{\mathrm{div}} u & a"
        );
        let page = |formula: &str| {
            refused(&[("a.md".to_owned(), format!("text $\\{formula}{{a}}$\n"))]).len()
        };
        assert_eq!(["phantom", "mathrm", "mbox"].map(page), [1, 0, 1]);
        assert_eq!(of(r"\{a\} * b \\ c"), r"\lbrace a\rbrace \ast b \cr c");
        assert_eq!(of("\\begin{equation}\n a \\label{bound}\n\\end{equation}"), r"a \tag{5.2}");
        assert_eq!(of(r"b \le \eqref{bound}"), r"b \le \text{(5.2)}");
    }
}
