//! The letters of a page: which symbols of the notation page its formulas use, so that a line behind the
//! opening picture can lead to what each means.
//!
//! The notation page is read as it stands: a table in each section, its rows begin with symbols and end with
//! the pages that first use them; the last, of several meanings, with those that mean another.

use crate::chapter::Page;
use crate::error::Fault;
use crate::scan::{Kind, pieces};
use std::collections::BTreeSet;

/// The page of letters.
pub const NOTATION: &str = "notation.html";
/// The section of letters with several meanings.
const SEVERAL: &str = "several pages";
/// Letters that name something else at every turn: normals, indices, loads, any function, any constant.
const NEVER: [&str; 5] = ["n", "f", "u", "C", "l"];

/// A symbol and the section of the notation page that defines it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Letter {
    /// LaTeX.
    pub latex: String,
    /// Anchor of its section.
    pub section: String,
    pattern: Vec<String>,
    /// Line of its row.
    line: usize,
    /// Pages on which its row says that its symbols are first used, `x.html`.
    first: BTreeSet<String>,
    /// Pages on which it means something else, `x.html`.
    elsewhere: BTreeSet<String>,
}

/// All symbols of the notation page.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Letters(Vec<Letter>);

impl Letters {
    /// Reads the notation page, if there is one; letters that name something else at every turn are left out.
    pub fn read(pages: &[Page]) -> Self {
        let mut letters = Self::all(pages);
        let is_never =
            |letter: &Letter| matches!(letter.pattern.as_slice(), [one] if NEVER.contains(&one.as_str()));
        letters.0.retain(|letter| !is_never(letter));
        letters
    }

    /// Every symbol of the notation page.
    fn all(pages: &[Page]) -> Self {
        let Some(page) = pages.iter().find(|page| page.html == NOTATION) else { return Self::default() };
        let mut letters = Self::default();
        let mut section = String::new();
        for (k, line) in page.text.lines().enumerate() {
            if let Some(title) = line.strip_prefix("## ") {
                section = title
                    .to_lowercase()
                    .replace(' ', "-")
                    .replace(|c: char| !c.is_alphanumeric() && c != '-', "");
            }
            let Some((first, rest)) = line.strip_prefix("| ").and_then(|row| row.split_once(" | ")) else {
                continue;
            };
            let symbols = formulas(first);
            // The last column; what stands before it is the meaning of the other tables or a page too.
            let pages: BTreeSet<String> = links(rest.rsplit_once(" | ").map_or(rest, |(_, last)| last));
            if section.ends_with(&SEVERAL.replace(' ', "-")) {
                for letter in letters.0.iter_mut().filter(|letter| symbols.contains(&letter.latex)) {
                    letter.elsewhere.extend(pages.iter().cloned());
                }
            } else {
                letters.0.extend(symbols.into_iter().map(|latex| Letter {
                    pattern: pattern(&latex),
                    latex,
                    section: section.clone(),
                    line: k + 1,
                    first: pages.clone(),
                    elsewhere: BTreeSet::new(),
                }));
            }
        }
        letters
    }

    /// Every symbol of the notation page with the first page, in the order of reading, whose formulas use it.
    pub fn first_uses(pages: &[Page]) -> Vec<(Letter, Option<String>)> {
        let mut found: Vec<(Letter, Option<String>)> =
            Self::all(pages).0.into_iter().map(|letter| (letter, None)).collect();
        for page in pages.iter().filter(|page| page.html != NOTATION) {
            let formulas = all_tokens(page);
            for (letter, first) in found.iter_mut().filter(|(_, first)| first.is_none()) {
                *first = letter.is_used(page, &formulas).then(|| page.html.clone());
            }
        }
        found
    }

    /// For each symbol the page of its first use and how that page leads to its meaning, as a table.
    pub fn list(pages: &[Page]) -> String {
        let linked = Self::read(pages);
        let row = |(letter, first): (Letter, Option<String>)| match pages
            .iter()
            .find(|p| Some(&p.html) == first.as_ref())
        {
            Some(page) if linked.of(page).contains(&letter) => {
                format!("| `{}` | {} | link to notation.html#{} |\n", letter.latex, page.html, letter.section)
            }
            Some(page) => format!("| `{}` | {} | in words |\n", letter.latex, page.html),
            None => format!("| `{}` | in no formula | in words and pictures |\n", letter.latex),
        };
        let head = "| symbol | page of first use | meaning |\n| --- | --- | --- |\n".to_owned();
        Self::first_uses(pages).into_iter().map(row).fold(head, |list, row| list + &row)
    }

    /// Rows of the notation page that name other pages than those where their symbols are first used.
    pub fn faults(pages: &[Page]) -> Vec<Fault> {
        let Some(page) = pages.iter().find(|page| page.html == NOTATION) else { return Vec::new() };
        let uses = Self::first_uses(pages);
        let is_wrong = |row: &[(Letter, Option<String>)]| {
            let used: BTreeSet<&String> = row.iter().filter_map(|(_, first)| first.as_ref()).collect();
            !used.is_empty() && used != row[0].0.first.iter().collect()
        };
        let rows = uses.chunk_by(|a, b| a.0.line == b.0.line).filter(|row| is_wrong(row));
        rows.map(|row| {
            let list: Vec<String> = row
                .iter()
                .filter_map(|(letter, first)| Some(format!("{} on {}", letter.latex, first.as_ref()?)))
                .collect();
            Fault::new(&page.file, row[0].0.line, "not the pages of first use", list.join(", "))
        })
        .collect()
    }

    /// Those that the formulas of a page use, in the order of the notation page.
    pub fn of(&self, page: &Page) -> Vec<Letter> {
        if page.html == NOTATION {
            return Vec::new();
        }
        let formulas = all_tokens(page);
        self.0.iter().filter(|letter| letter.is_used(page, &formulas)).cloned().collect()
    }
}

impl Letter {
    /// Whether formulas of a page use it as the notation page means it.
    fn is_used(&self, page: &Page, formulas: &[Vec<String>]) -> bool {
        let is_in = |formula: &Vec<String>| (0..formula.len()).any(|at| begins(formula, at, &self.pattern));
        !self.elsewhere.contains(&page.html) && formulas.iter().any(is_in)
    }
}

/// The tokens of each formula of a page.
fn all_tokens(page: &Page) -> Vec<Vec<String>> {
    let found = pieces(&page.text).unwrap_or_default();
    let formulas = found.iter().filter(|piece| matches!(piece.kind, Kind::Inline | Kind::Display));
    formulas.map(|piece| tokens(piece.text)).collect()
}

/// Formulas of a cell, up to a sign of equality.
fn formulas(cell: &str) -> Vec<String> {
    let parts = cell.split('$').skip(1).step_by(2);
    parts.map(|part| part.split('=').next().unwrap_or("").trim().to_owned()).collect()
}

/// Built pages that a cell leads to.
fn links(cell: &str) -> BTreeSet<String> {
    let targets = cell.split("](").skip(1).filter_map(|rest| rest.split_once(".md"));
    targets.map(|(name, _)| format!("{name}.html")).collect()
}

/// Commands and their names and words in braces, which are no letters.
const NAMED: [&str; 8] =
    ["\\label", "\\eqref", "\\tag", "\\text", "\\mathrm", "\\begin", "\\end", "\\operatorname"];

/// Commands and characters; spaces, names and words are left out.
pub fn tokens(latex: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut rest = latex;
    while let Some(first) = rest.chars().next() {
        let length = if first == '\\' {
            let letters = rest[1..].find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len() - 1);
            // A command of one other character, such as a thin space.
            if letters == 0 { 1 + rest[1..].chars().next().map_or(0, char::len_utf8) } else { 1 + letters }
        } else {
            first.len_utf8()
        };
        let (token, mut behind) = rest.split_at(length);
        if NAMED.contains(&token) && behind.starts_with('{') {
            behind = behind.split_once('}').map_or("", |(_, behind)| behind);
        }
        if !first.is_whitespace() && !matches!(token, "\\," | "\\;" | "\\!" | "\\ ") {
            found.push(token.to_owned());
        }
        rest = behind;
    }
    found
}

/// What is looked for: arguments u and v stand for any, those of γ may be left out.
fn pattern(latex: &str) -> Vec<String> {
    let all = tokens(latex);
    let Some(open) = all.iter().position(|token| token == "(") else { return all };
    let is_any = all[open + 1..].iter().all(|token| matches!(token.as_str(), "u" | "v" | "," | ")"));
    match open {
        1 if is_any => all[..=open].to_vec(),
        1 => all,
        _ => all[..open].to_vec(),
    }
}

/// Whether a formula has the pattern at this token.
fn begins(formula: &[String], at: usize, pattern: &[String]) -> bool {
    if let [one] = pattern {
        // K is not K^h, h not the h of K^h, T not that of a transposed matrix, C not that of Γ_C.
        let before = at.checked_sub(1).map_or("", |k| formula[k].as_str());
        let behind = formula.get(at + 1).map_or("", String::as_str);
        let is_capital = one.chars().all(char::is_uppercase);
        let is_part = matches!(before, "\\mathsf" | "\\mathcal" | "^")
            || before == "_" && at > 1 && formula[at - 2] == "\\Gamma"
            || behind == "_"
            || is_capital && matches!(behind, "^" | "(" | "'");
        return formula[at] == *one && !is_part;
    }
    let mut k = at;
    let mut expected = pattern.iter().peekable();
    while let Some(token) = expected.next() {
        if formula.get(k) != Some(token) {
            return false;
        }
        k += 1;
        if token == "{" && expected.peek().is_some_and(|token| *token == "v") {
            // Any function between the bars.
            expected.next();
            let mut depth = 0;
            while let Some(token) = formula.get(k).filter(|token| depth > 0 || *token != "}") {
                depth += i32::from(token == "{") - i32::from(token == "}");
                k += 1;
            }
        }
    }
    // A longer index is another symbol.
    let is_index = pattern.iter().any(|token| token == "_" || token == "^");
    !(is_index && formula.get(k).is_some_and(|token| token == "_"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn page(html: &str, text: &str) -> Page {
        Page { file: html.into(), html: html.to_owned(), text: text.to_owned() }
    }

    fn found(text: &str) -> Vec<String> {
        let notation = "## Norms and zones\n\n| letter | meaning |\n| --- | --- |\n| $\\theta$, $K$, $K^h$ | a |\n\
            | $\\abs{v}_\\nu$ | b |\n| $\\gamma_\\theta(\\nu)$ | c |\n| $\\nu = \\tau - \\frac32$, $h$, $n$ | d |\n\
            | $a(u, v)$, $C(q)$ | e |\n\n## One letter, several pages\n\n| $\\theta$ | here | an angle: [x](angle.md) |\n";
        let pages = [page(NOTATION, notation), page("p.html", text)];
        Letters::read(&pages).of(&pages[1]).into_iter().map(|letter| letter.latex).collect()
    }

    #[test]
    fn symbols_of_formulas_are_found() {
        assert_eq!(found("$\\theta^2$ and $n$, `$K$`"), ["\\theta"]);
        assert_eq!(found("$K^h \\subset V$"), ["K^h"]);
        assert_eq!(found("$\\abs{\\uN'}_\\nu \\le K$"), ["K", "\\abs{v}_\\nu", "\\nu"]);
        assert_eq!(found("$\\abs{u - \\frac{a}{b}}_{\\nu}$"), ["\\nu"]);
        assert_eq!(found("$\\text{with } h \\label{K}, \\mathrm{h}$"), ["h"]);
        assert_eq!(found("$\\gamma_\\theta h_e$"), ["\\theta", "\\gamma_\\theta(\\nu)"]);
        assert_eq!(found("$$a(w, z) + h^{\\mathsf T} C(q) + C(r)$$"), ["h", "a(u, v)", "C(q)"]);
        assert!(found("no formula").is_empty());
    }

    #[test]
    fn a_letter_with_another_meaning_is_left_out() {
        let notation = "## Norms\n\n| $\\theta$ | b |\n\n## One letter, several pages\n\n| $\\theta$ | here | [x](p.md) |\n";
        let pages = [page(NOTATION, notation), page("p.html", "$\\theta$"), page("q.html", "$\\theta$")];
        let letters = Letters::read(&pages);
        assert!(letters.of(&pages[1]).is_empty());
        assert_eq!(letters.of(&pages[2])[0].section, "norms");
        assert!(letters.of(&pages[0]).is_empty());
    }
    #[test]
    fn rows_name_the_pages_where_their_symbols_are_first_used() {
        let notation = |first: &str| {
            page(
                NOTATION,
                &format!("## Norms\n\n| $\\theta$, $h$, $\\xi_1$ | b | {first} |\n| $n$ | c | [p](p.md) |\n"),
            )
        };
        let (p, q) = (page("p.html", "$n + \\theta$"), page("q.html", "$h$ and $\\theta$"));
        let faults = |first: &str| Letters::faults(&[notation(first), p.clone(), q.clone()]);
        assert!(faults("[p](p.md), [q](q.md)").is_empty());
        for wrong in ["[p](p.md)", "[q](q.md)", "[p](p.md), [q](q.md), [r](r.md)"] {
            let found = faults(wrong);
            assert_eq!((found.len(), found[0].line), (1, 3), "{wrong}");
            assert_eq!(found[0].text, "\\theta on p.html, h on q.html");
        }
    }
}
