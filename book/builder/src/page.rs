//! Pages of the book made ready for mdBook: formulas, numbers, figures and tables replaced by marks that Markdown
//! leaves alone; after mdBook the marks are replaced by what they stand for.

use crate::data::Data;
use crate::decimal;
use crate::directive::{self, Meaning};
use crate::error::Fault;
use crate::formula::{self, Formula, Labels};
use crate::scan::{Kind, line_at, pieces};
use std::path::PathBuf;

/// Marks are numbers between these two characters of Unicode's private use area.
const MARK: (char, char) = ('\u{E000}', '\u{E001}');

/// A chapter as written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Page {
    /// File, as a reader of the repository names it.
    pub file: PathBuf,
    /// Name of the built page, `x.html`.
    pub html: String,
    /// Markdown with formulas and directives.
    pub text: String,
}

/// What a mark stands for.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Snippet {
    /// Part of a line.
    Inline(String),
    /// A paragraph of its own.
    Block(String),
}

/// Pages with marks, and what the marks stand for.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Marked {
    /// Markdown of each page.
    pub texts: Vec<String>,
    /// The built page of each page.
    html: Vec<String>,
    snippets: Vec<Snippet>,
    labels: Labels,
}

/// Replaces formulas and directives on all pages by marks.
///
/// # Errors
/// Every fault on every page: formulas, keys, decimals typed by hand.
pub fn mark(pages: &[Page], data: &Data, allowed: &[String]) -> Result<Marked, Vec<Fault>> {
    let mut faults = Vec::new();
    let mut marked = Marked::default();
    let mut formulas = Vec::new();
    let mut places = Vec::new(); // the snippet of each formula
    for (number, page) in pages.iter().enumerate() {
        let mut text = String::new();
        let found = pieces(&page.text).unwrap_or_else(|error| {
            let rest = page.text[error.start..].lines().next().unwrap_or("");
            faults.push(Fault::new(&page.file, line_at(&page.text, error.start), error.what, rest));
            Vec::new()
        });
        for piece in found {
            let line = line_at(&page.text, piece.start);
            let mut fault = |what: &str, text: &str| faults.push(Fault::new(&page.file, line, what, text));
            match piece.kind {
                Kind::Code => text.push_str(piece.text),
                Kind::Prose => {
                    faults.extend(decimals(page, piece.start, &without_links(piece.text), allowed));
                    text.push_str(piece.text);
                }
                Kind::Inline | Kind::Display => {
                    let start = &text[text.rfind('\n').map_or(0, |k| k + 1)..];
                    if start.starts_with('#') {
                        fault("formula in a heading", piece.text);
                    }
                    faults.extend(decimals(page, piece.start, &without_values(piece.text), allowed));
                    let latex = fill(piece.text, data).unwrap_or_else(|(what, key)| {
                        faults.push(Fault::new(&page.file, line, what, key));
                        String::new()
                    });
                    places.push(marked.snippets.len());
                    let is_display = piece.kind == Kind::Display;
                    formulas.push(Formula { page: number, line, latex, is_display });
                    marked.push(&mut text, Snippet::Inline(String::new()));
                }
                Kind::Directive => match directive::resolve(piece.text, data) {
                    Ok(Meaning::Number(number)) => marked.push(&mut text, Snippet::Inline(number.html())),
                    Ok(Meaning::Words(words)) => {
                        marked.push(&mut text, Snippet::Inline(crate::markup::escape(&words)));
                    }
                    Ok(Meaning::Block(html)) => marked.push(&mut text, Snippet::Block(html)),
                    Err(what) => fault(&what, piece.text),
                },
            }
        }
        marked.texts.push(text);
        marked.html.push(page.html.clone());
    }
    match formula::convert(&formulas) {
        Ok((mathml, labels)) => {
            for ((place, formula), mathml) in places.iter().zip(&formulas).zip(mathml) {
                let class = if formula.is_display { "display" } else { "inline" };
                marked.snippets[*place] =
                    Snippet::Inline(format!("<span class=\"{class}-formula\">{mathml}</span>"));
            }
            marked.labels = labels;
        }
        Err(refused) => faults.extend(refused.into_iter().filter(|_| !formulas.is_empty()).map(|r| {
            let Formula { page, line, .. } = formulas[r.formula];
            Fault::new(&pages[page].file, line, r.what, r.text)
        })),
    }
    if faults.is_empty() { Ok(marked) } else { Err(faults) }
}

/// Decimals typed by hand in a piece of a page.
fn decimals(page: &Page, start: usize, text: &str, allowed: &[String]) -> Vec<Fault> {
    decimal::typed_by_hand(text, allowed)
        .into_iter()
        .map(|found| {
            let line = line_at(&page.text, start + found.start);
            Fault::new(&page.file, line, "decimal typed by hand (use {{value:...}})", found.text)
        })
        .collect()
}

/// Prose with link targets and HTML tags blanked out, length unchanged.
fn without_links(text: &str) -> String {
    let blank = blank(text, "](", ")");
    self::blank(&blank, "<", ">")
}

/// A formula with its values blanked out, length unchanged.
fn without_values(latex: &str) -> String {
    blank(latex, "{{value:", "}}")
}

fn blank(text: &str, open: &str, close: &str) -> String {
    let mut result = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find(open) {
        let Some(length) = rest[start + open.len()..].find(close) else { break };
        result.push_str(&rest[..start + open.len()]);
        result.push_str(&" ".repeat(length));
        result.push_str(close);
        rest = &rest[start + open.len() + length + close.len()..];
    }
    result + rest
}

/// A formula with its values filled in.
fn fill(latex: &str, data: &Data) -> Result<String, (String, String)> {
    let mut filled = String::new();
    let mut rest = latex;
    while let Some(start) = rest.find("{{value:") {
        let Some(length) = rest[start..].find("}}") else { break };
        let directive = &rest[start + 2..start + length];
        match directive::resolve(directive, data) {
            Ok(Meaning::Number(number)) => {
                filled.push_str(&rest[..start]);
                filled.push_str(&number.latex());
            }
            Ok(_) => return Err(("not a number in a formula".to_owned(), directive.to_owned())),
            Err(what) => return Err((what, directive.to_owned())),
        }
        rest = &rest[start + length + 2..];
    }
    Ok(filled + rest)
}

impl Marked {
    fn push(&mut self, text: &mut String, snippet: Snippet) {
        text.push(MARK.0);
        text.push_str(&self.snippets.len().to_string());
        text.push(MARK.1);
        self.snippets.push(snippet);
    }

    /// Puts what the marks stand for into a built page; references to formulas of other pages become links there.
    ///
    /// # Errors
    /// In words, a mark that cannot stand where it is.
    pub fn unmark(&self, name: &str, built: &str) -> Result<String, String> {
        let mut html = String::with_capacity(2 * built.len());
        let mut rest = built;
        while let Some(start) = rest.find(MARK.0) {
            let after = &rest[start + MARK.0.len_utf8()..];
            let (number, behind) = after.split_once(MARK.1).ok_or("a mark was torn apart")?;
            let snippet = number.parse().ok().and_then(|k: usize| self.snippets.get(k));
            let before = &rest[..start];
            rest = behind;
            match snippet.ok_or("a mark without meaning")? {
                Snippet::Inline(inline) => {
                    html.push_str(before);
                    html.push_str(&self.linked(inline, name));
                }
                Snippet::Block(block) => {
                    let before = before.strip_suffix("<p>").ok_or("a figure or table inside a paragraph")?;
                    rest = behind.strip_prefix("</p>").ok_or("a figure or table inside a paragraph")?;
                    html.push_str(before);
                    html.push_str(block);
                }
            }
        }
        Ok(html + rest)
    }

    fn linked(&self, mathml: &str, name: &str) -> String {
        // The page for printing holds all pages, the index a copy of the first.
        if !mathml.contains("href=\"#") || name == "print.html" {
            return mathml.to_owned();
        }
        let mut linked = mathml.to_owned();
        for (label, &page) in &self.labels {
            let home = &self.html[page];
            if home != name && !(page == 0 && name == "index.html") {
                linked = linked.replace(&format!("href=\"#{label}\""), &format!("href=\"{home}#{label}\""));
            }
        }
        linked
    }
}

#[cfg(test)]
#[path = "page_tests.rs"]
mod tests;
