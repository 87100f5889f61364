//! The letters of a page: symbols of the tables of the notation page that its formulas use, so that a line
//! behind the opening picture can lead to what each means.
//!
//! The first cell of a row holds the symbols; the last cell of the table "One letter, several pages" the pages
//! on which a letter means something else.

use crate::chapter::Page;
use crate::scan::{Kind, pieces};
use std::collections::BTreeSet;

/// The page of letters.
pub const NOTATION: &str = "notation.html";
/// The section of letters with several meanings.
const SEVERAL: &str = "several-pages";
/// Letters that name something else at every turn: normals, indices, loads, any function, any constant.
const NEVER: [&str; 5] = ["n", "f", "u", "C", "l"];
/// Commands whose argument is no formula.
const NAMED: [&str; 8] =
    ["\\label", "\\eqref", "\\tag", "\\text", "\\mathrm", "\\begin", "\\end", "\\operatorname"];

/// A symbol and the section of the notation page that defines it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Letter {
    /// LaTeX.
    pub latex: String,
    /// Anchor of its section.
    pub section: String,
    pattern: Vec<String>,
    /// Pages on which it means something else, `x.html`.
    elsewhere: BTreeSet<String>,
}

/// The table of symbols.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Letters(Vec<Letter>);

impl Letters {
    /// Reads the notation page, if there is one.
    pub fn read(pages: &[Page]) -> Self {
        let Some(page) = pages.iter().find(|page| page.html == NOTATION) else {
            return Self::default();
        };
        let mut letters: Vec<Letter> = Vec::new();
        let mut section = String::new();
        for line in page.text.lines() {
            if let Some(title) = line.strip_prefix("## ") {
                section = anchor(title);
            }
            let Some((first, rest)) = line.strip_prefix("| ").and_then(|row| row.split_once(" | "))
            else {
                continue;
            };
            let symbols = first.split('$').skip(1).step_by(2);
            let symbols: Vec<&str> =
                symbols.map(|symbol| symbol.split('=').next().unwrap_or("").trim()).collect();
            if section.ends_with(SEVERAL) {
                for letter in letters.iter_mut().filter(|letter| symbols.contains(&&*letter.latex))
                {
                    letter.elsewhere.extend(links(rest.rsplit(" | ").next().unwrap_or("")));
                }
            } else {
                let symbols = symbols.into_iter().filter(|symbol| !NEVER.contains(symbol));
                letters.extend(symbols.map(|latex| Letter {
                    latex: latex.to_owned(),
                    section: section.clone(),
                    pattern: pattern(latex),
                    elsewhere: BTreeSet::new(),
                }));
            }
        }
        Self(letters)
    }

    /// Those that the formulas of a page use, in the order of the notation page.
    pub fn of(&self, page: &Page) -> Vec<Letter> {
        if page.html == NOTATION {
            return Vec::new();
        }
        let found = pieces(&page.text).unwrap_or_default();
        let formulas =
            found.iter().filter(|piece| matches!(piece.kind, Kind::Inline | Kind::Display));
        let formulas: Vec<Vec<String>> = formulas.map(|piece| tokens(piece.text)).collect();
        let is_in = |formula: &[String], letter: &Letter| {
            (0..formula.len()).any(|at| begins(&formula[at..], &formula[..at], &letter.pattern))
        };
        let is_used = |letter: &&Letter| {
            !letter.elsewhere.contains(&page.html)
                && formulas.iter().any(|formula| is_in(formula, letter))
        };
        self.0.iter().filter(is_used).cloned().collect()
    }
}

/// The anchor of a heading.
pub fn anchor(title: &str) -> String {
    title
        .to_lowercase()
        .replace(' ', "-")
        .replace(|c: char| !c.is_alphanumeric() && !"-_".contains(c), "")
}

/// Built pages that a cell leads to.
fn links(cell: &str) -> BTreeSet<String> {
    let targets = cell.split("](").skip(1).filter_map(|rest| rest.split_once(".md"));
    targets.map(|(name, _)| format!("{name}.html")).collect()
}

/// Commands and characters; spaces, names and words are left out.
fn tokens(latex: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut rest = latex.trim_start();
    while let Some(first) = rest.chars().next() {
        let command = rest[1..].find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len() - 1);
        let length = if first == '\\' && command > 0 { 1 + command } else { first.len_utf8() };
        let (token, mut behind) = rest.split_at(length);
        if NAMED.contains(&token) && behind.starts_with('{') {
            behind = behind.split_once('}').map_or("", |(_, behind)| behind);
        }
        if !matches!(token, "\\" | ";" | "!") {
            found.push(token.to_owned());
        }
        rest = behind.trim_start();
    }
    found
}

/// What is looked for: the arguments of a symbol, and what stands between the bars of a norm, are any.
fn pattern(latex: &str) -> Vec<String> {
    let all = tokens(latex);
    match all.iter().position(|token| token == "(") {
        // C(q) keeps its argument, a(u, v) and γ_θ(ν) do not.
        Some(1) if all[2..].iter().all(|token| "uv,)".contains(token.as_str())) => {
            all[..2].to_vec()
        }
        Some(open) if open > 1 => all[..open].to_vec(),
        _ => all,
    }
}

/// Whether the rest of a formula begins with the pattern; an index or a power makes another symbol.
fn begins(rest: &[String], before: &[String], pattern: &[String]) -> bool {
    if let Some(bars) =
        pattern.iter().position(|token| token == "v").filter(|_| pattern[0].len() > 1)
    {
        // Any function between the bars of \abs{v}_\nu.
        let close = rest.iter().scan(0, |depth, token| {
            *depth += i32::from(token == "{") - i32::from(token == "}");
            Some((*depth, token == "}"))
        });
        let close = close.enumerate().skip(bars).find(|(_, at)| *at == (0, true)).map(|(k, _)| k);
        return rest.starts_with(&pattern[..bars])
            && close.is_some_and(|close| rest[close..].starts_with(&pattern[bars + 1..]));
    }
    let last = before.last().map_or("", String::as_str);
    let behind = rest.get(pattern.len()).map_or("", String::as_str);
    let is_capital = pattern.len() == 1 && pattern[0].chars().all(char::is_uppercase);
    let is_part = matches!(last, "\\mathsf" | "\\mathcal")
        || pattern.len() == 1
            && (last == "^" || last == "_" && before.ends_with(&["\\Gamma".into(), "_".into()]))
        || behind == "_"
        || is_capital && matches!(behind, "^" | "(" | "'");
    rest.starts_with(pattern) && !is_part
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(text: &str) -> Vec<String> {
        let page = |html: &str, text: &str| Page {
            file: html.into(),
            html: html.into(),
            text: text.into(),
        };
        let notation = "## Norms and zones\n\n| letter | meaning |\n| --- | --- |\n| $\\theta$, $K$, $K^h$ | a |\n\
            | $\\abs{v}_\\nu$ | b |\n| $\\gamma_\\theta(\\nu)$ | c |\n| $\\nu = \\tau - \\frac32$, $h$, $n$ | d |\n\
            | $a(u, v)$, $C(q)$, $T$ | e |\n\n## One letter, several pages\n\n| $T$ | here | time: [x](p.md) |\n";
        let pages = [page(NOTATION, notation), page("p.html", text)];
        let letters = Letters::read(&pages);
        assert!(letters.of(&pages[0]).is_empty());
        let found = letters.of(&pages[1]);
        assert!(found.iter().all(|letter| letter.section == "norms-and-zones"));
        found.into_iter().map(|letter| letter.latex).collect()
    }

    #[test]
    fn symbols_of_formulas_are_found() {
        assert_eq!(found("$\\theta^2$ and $n$, `$K$`, $T$"), ["\\theta"]);
        assert_eq!(found("$K^h \\subset V$"), ["K^h"]);
        assert_eq!(found("$\\abs{\\uN'}_\\nu \\le K$"), ["K", "\\abs{v}_\\nu", "\\nu"]);
        assert_eq!(found("$\\abs{u - \\frac{a}{b}}_{\\nu}$"), ["\\nu"]);
        assert_eq!(found("$\\text{with } h \\label{K}, \\mathrm{h}$"), ["h"]);
        assert_eq!(found("$\\gamma_\\theta h_e$"), ["\\theta", "\\gamma_\\theta(\\nu)"]);
        assert_eq!(found("$$a(w, z) + h^{\\mathsf T} C(q) + C(r)$$"), ["h", "a(u, v)", "C(q)"]);
        assert!(found("no formula").is_empty());
    }
}
