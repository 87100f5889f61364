//! Pages of the book made ready for mdBook: formulas, numbers, figures and tables replaced by marks that
//! Markdown leaves alone; after mdBook the marks are replaced by what they stand for.

use crate::chapter::Page;
use crate::decimal;
use crate::directive::{self, Meaning, Sources};
use crate::error::Fault;
use crate::formula::{self, Formula, Label, Labels};
use crate::letters::Letters;
use crate::live;
use crate::markup::escape;
use crate::scan::{Kind, Piece, line_at, pieces};
use crate::sentence;
use std::collections::BTreeSet;

/// Marks are numbers between these two characters of Unicode's private use area.
const MARK: (char, char) = ('\u{E000}', '\u{E001}');

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
    /// Numbers and pages of the labelled formulas.
    pub labels: Labels,
}

/// Replaces formulas and directives on all pages by marks.
///
/// # Errors
/// Every fault on every page: formulas, keys, decimals typed by hand.
pub fn mark(pages: &[Page], sources: &Sources<'_>) -> Result<Marked, Vec<Fault>> {
    let mut marker = Marker {
        sources,
        marked: Marked::default(),
        formulas: Vec::new(),
        places: Vec::new(),
        faults: Vec::new(),
        letters: Letters::read(pages),
        opens: true,
        live: BTreeSet::new(),
        panels: BTreeSet::new(),
    };
    for (number, page) in pages.iter().enumerate() {
        let text = marker.page(number, page);
        marker.marked.texts.push(text);
        marker.marked.html.push(page.html.clone());
    }
    marker.finish(pages)
}

/// Pages marked so far.
struct Marker<'a> {
    sources: &'a Sources<'a>,
    marked: Marked,
    formulas: Vec<Formula>,
    /// The snippet of each formula.
    places: Vec<usize>,
    faults: Vec<Fault>,
    letters: Letters,
    /// Whether the opening picture of this page is still to come.
    opens: bool,
    /// Examples that can be computed anew on this page.
    live: BTreeSet<String>,
    /// Those whose panel is still to come.
    panels: BTreeSet<String>,
}

impl Marker<'_> {
    fn page(&mut self, number: usize, page: &Page) -> String {
        self.panels = live::examples(&page.text, self.sources.data);
        self.live = self.panels.clone();
        self.opens = true;
        let found = pieces(&page.text).unwrap_or_else(|error| {
            let rest = page.text[error.start..].lines().next().unwrap_or("");
            self.faults.push(Fault::new(
                &page.file,
                line_at(&page.text, error.start),
                error.what,
                rest,
            ));
            Vec::new()
        });
        let mut text = String::new();
        for piece in found {
            match piece.kind {
                Kind::Code => text.push_str(piece.text),
                Kind::Prose => {
                    self.decimals(page, piece.start, &decimal::without_links(piece.text));
                    text.push_str(piece.text);
                }
                Kind::Inline | Kind::Display => self.formula(number, page, &piece, &mut text),
                Kind::Directive => self.directive(number, page, &piece, &mut text),
            }
        }
        text
    }

    fn formula(&mut self, number: usize, page: &Page, piece: &Piece<'_>, text: &mut String) {
        let line = line_at(&page.text, piece.start);
        let start_of_line = &text[text.rfind('\n').map_or(0, |k| k + 1)..];
        let is_quoted = start_of_line.starts_with('>');
        if start_of_line.starts_with('#') {
            self.faults.push(Fault::new(&page.file, line, "formula in a heading", piece.text));
        }
        self.decimals(page, piece.start, &decimal::without_values(piece.text));
        let latex = if is_quoted { piece.text.replace("\n>", "\n") } else { piece.text.to_owned() };
        let latex = fill(&latex, self.sources).unwrap_or_else(|(what, key)| {
            self.faults.push(Fault::new(&page.file, line, what, key));
            String::new()
        });
        let is_display = piece.kind == Kind::Display;
        self.push_formula(text, Formula { page: number, line, latex, is_display });
    }

    fn push_formula(&mut self, text: &mut String, formula: Formula) {
        self.places.push(self.marked.snippets.len());
        self.formulas.push(formula);
        self.marked.push(text, Snippet::Inline(String::new()));
    }

    /// The letters of a page, each a link to what it means.
    fn letters(&mut self, number: usize, page: &Page, text: &mut String) {
        for (k, letter) in self.letters.of(page).into_iter().enumerate() {
            text.push_str(if k == 0 { "\n\n*Letters:* [" } else { ", [" });
            let latex = letter.latex;
            self.push_formula(text, Formula { page: number, line: 1, latex, is_display: false });
            text.push_str(&format!("](notation.md#{})", letter.section));
        }
    }

    fn directive(&mut self, number: usize, page: &Page, piece: &Piece<'_>, text: &mut String) {
        let example =
            live::example(piece.text, self.sources.data).filter(|e| self.live.contains(e));
        let begins = sentence::begins(text);
        let inline = |html: String| match example {
            Some(_) => live::inline(piece.text, &html, begins),
            None => html,
        };
        match directive::resolve(piece.text, self.sources) {
            // As Markdown, so that the search of mdBook finds them.
            Ok(Meaning::Number(number)) => text.push_str(&guarded(&inline(number.html()))),
            Ok(Meaning::Words(words)) => {
                let words = if begins { sentence::capitalised(&words) } else { words };
                text.push_str(&guarded(&inline(words)));
            }
            Ok(Meaning::Name(name)) => {
                // Long names may break between their words.
                let name = escape(&name).replace("::", "::<wbr>").replace('_', "_<wbr>");
                text.push_str(&guarded(&format!("<code>{name}</code>")));
            }
            Ok(Meaning::Block(html)) => {
                let mut html =
                    if example.is_some() { live::block(piece.text, &html) } else { html };
                if let Some(example) = example.filter(|example| self.panels.remove(example)) {
                    html.push_str(&live::panel(&example, &self.sources.data.options[&example]));
                }
                self.marked.push(text, Snippet::Block(html));
                if std::mem::take(&mut self.opens) {
                    self.letters(number, page, text);
                }
            }
            Ok(Meaning::Markdown(block)) => text.push_str(&block),
            Err(what) => {
                let line = line_at(&page.text, piece.start);
                self.faults.push(Fault::new(&page.file, line, what, piece.text));
            }
        }
    }

    fn decimals(&mut self, page: &Page, start: usize, text: &str) {
        self.faults.extend(decimal::typed_by_hand(text, self.sources.allowed).into_iter().map(
            |found| {
                let line = line_at(&page.text, start + found.start);
                Fault::new(
                    &page.file,
                    line,
                    "decimal typed by hand (use {{value:...}})",
                    found.text,
                )
            },
        ));
    }

    /// All formulas of the book at once.
    fn finish(mut self, pages: &[Page]) -> Result<Marked, Vec<Fault>> {
        match formula::convert(&self.formulas) {
            Ok((mathml, labels)) => {
                for ((&place, formula), mathml) in
                    self.places.iter().zip(&self.formulas).zip(mathml)
                {
                    let class = if formula.is_display { "display" } else { "inline" };
                    let html = format!("<span class=\"{class}-formula\">{mathml}</span>");
                    self.marked.snippets[place] = Snippet::Inline(html);
                }
                self.marked.labels = labels;
            }
            Err(refused) => self.faults.extend(refused.into_iter().map(|refused| {
                let Formula { page, line, .. } = self.formulas[refused.formula];
                Fault::new(&pages[page].file, line, refused.what, refused.text)
            })),
        }
        if self.faults.is_empty() { Ok(self.marked) } else { Err(self.faults) }
    }
}

/// A formula with its values filled in.
pub(crate) fn fill(latex: &str, sources: &Sources<'_>) -> Result<String, (String, String)> {
    let mut filled = String::new();
    let mut rest = latex;
    while let Some(start) = rest.find("{{value:") {
        let Some(length) = rest[start..].find("}}") else { break };
        let directive = &rest[start + 2..start + length];
        match directive::resolve(directive, sources) {
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

/// HTML that Markdown leaves alone within a line.
fn guarded(html: &str) -> String {
    let special = |c: char| matches!(c, '*' | '_' | '`' | '[' | ']' | '\\' | '|' | '~' | '$');
    html.chars()
        .map(|c| if special(c) { format!("&#{};", u32::from(c)) } else { c.to_string() })
        .collect()
}

/// A text that was built, without marks.
pub fn without_marks(text: &str) -> String {
    let mut parts = text.split(MARK.0);
    let first = parts.next().unwrap_or("").to_owned();
    parts
        .fold(first, |kept, part| kept + part.split_once(MARK.1).map_or(part, |(_, behind)| behind))
}

impl Marked {
    fn push(&mut self, text: &mut String, snippet: Snippet) {
        text.push(MARK.0);
        text.push_str(&self.snippets.len().to_string());
        text.push(MARK.1);
        self.snippets.push(snippet);
    }

    /// Puts what the marks stand for into a built page; references to formulas of other pages become links
    /// there.
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
                    let before =
                        before.strip_suffix("<p>").ok_or("a figure or table inside a paragraph")?;
                    rest = behind
                        .strip_prefix("</p>")
                        .ok_or("a figure or table inside a paragraph")?;
                    html.push_str(before);
                    html.push_str(if name == "print.html" {
                        live::without_panel(block)
                    } else {
                        block
                    });
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
        for (label, &Label { page, .. }) in &self.labels {
            let home = &self.html[page];
            if home != name && !(page == 0 && name == "index.html") {
                linked = linked
                    .replace(&format!("href=\"#{label}\""), &format!("href=\"{home}#{label}\""));
            }
        }
        linked
    }
}
