//! Letters of one page: every letter in its formulas is on the notation page or is introduced on the page,
//! no later than two paragraphs behind its first use. Introduced is a letter that a formula names by itself
//! ("a number $c$"), that stands on the left of a relation ($c = 1$, $0 < c < 1$), or that is bound by a sum,
//! a supremum or an integral.

use crate::chapter::Page;
use crate::error::Fault;
use crate::letters::{NOTATION, tokens};
use crate::scan::{Kind, line_at, pieces};
use std::collections::{BTreeMap, BTreeSet};

/// The section of the notation page whose letters need no word on other pages.
const UNDERSTOOD: &str = "## Understood without a word";
/// Letters of the other alphabet.
const GREEK: [&str; 30] = [
    "alpha",
    "beta",
    "gamma",
    "delta",
    "epsilon",
    "varepsilon",
    "zeta",
    "eta",
    "theta",
    "vartheta",
    "kappa",
    "lambda",
    "mu",
    "nu",
    "xi",
    "rho",
    "varrho",
    "sigma",
    "tau",
    "phi",
    "varphi",
    "chi",
    "psi",
    "omega",
    "Gamma",
    "Theta",
    "Phi",
    "Psi",
    "Omega",
    "ell",
];
/// What stands between a letter and what it is.
const RELATIONS: [&str; 14] = [
    "=", "<", ">", ":", ",", "\\in", "\\le", "\\ge", "\\ne", "\\to", "\\sim", "\\subset", "\\colon",
    "\\mapsto",
];
/// What a letter on the left of a relation may follow.
const BEGINS: [&str; 17] = [
    ",", ";", "&", "=", "<", "\\le", "\\\\", "\\quad", "\\qquad", "\\;", ":", "\\text", "\\begin", "{", "}",
    "\\{", "\\mathrm",
];
/// What binds a letter: the first index of a sum, the variable of an integral, what runs through a set.
const BINDS: [&str; 9] = ["\\sum", "\\prod", "\\sup", "\\inf", "\\max", "\\min", "\\lim", "\\dd", "\\forall"];

/// A formula of a page.
struct Formula {
    start: usize,
    is_inline: bool,
    tokens: Vec<String>,
    latex: String,
}

/// Letters of formulas that are neither on the notation page nor introduced on their own.
pub fn faults(pages: &[Page]) -> Vec<Fault> {
    let Some(notation) = pages.iter().find(|page| page.html == NOTATION) else { return Vec::new() };
    let known: BTreeSet<String> = known(notation);
    let others = pages.iter().filter(|page| page.html != NOTATION);
    others.flat_map(|page| unexplained(page, &known)).collect()
}

/// Letters of the tables of the notation page but the last, and of the list of what is understood.
fn known(notation: &Page) -> BTreeSet<String> {
    let (before, behind) = notation.text.split_once(UNDERSTOOD).unwrap_or((&notation.text, ""));
    let understood = behind.split("\n## ").next().unwrap_or("");
    let symbols = before.lines().filter_map(|line| line.strip_prefix("| ")?.split(" | ").next());
    let text: String = symbols.chain([understood]).collect::<Vec<_>>().join("\n\n");
    let page = Page { text, ..notation.clone() };
    formulas(&page).iter().flat_map(|formula| letters(&formula.tokens)).map(|(_, letter)| letter).collect()
}

fn formulas(page: &Page) -> Vec<Formula> {
    let found = pieces(&page.text).unwrap_or_default();
    let formulas = found.into_iter().filter(|piece| matches!(piece.kind, Kind::Inline | Kind::Display));
    formulas
        .map(|piece| Formula {
            start: piece.start,
            is_inline: piece.kind == Kind::Inline,
            tokens: tokens(&without_values(piece.text)),
            latex: piece.text.split_whitespace().collect::<Vec<_>>().join(" "),
        })
        .collect()
}

/// Directives are numbers.
pub(crate) fn without_values(latex: &str) -> String {
    let mut parts = latex.split("{{value:");
    let first = parts.next().unwrap_or("").to_owned();
    parts.fold(first, |text, part| text + "1" + part.split_once("}}").map_or("", |(_, rest)| rest))
}

/// Whether a token is a letter of either alphabet.
pub(crate) fn is_letter(token: &str) -> bool {
    let is_latin = token.len() == 1 && token.starts_with(|c: char| c.is_ascii_alphabetic());
    is_latin || token.strip_prefix('\\').is_some_and(|name| GREEK.contains(&name))
}

/// Letters and where they stand; an index is part of its letter.
fn letters(tokens: &[String]) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        if is_letter(token) {
            found.push((at, token.clone()));
        }
        at = behind_index(tokens, at + 1);
    }
    found
}

/// Behind an index, if there is one here.
pub(crate) fn behind_index(tokens: &[String], at: usize) -> usize {
    if tokens.get(at).is_none_or(|token| token != "_") {
        return at;
    }
    group_end(tokens, at + 1)
}

/// Behind a group in braces, or behind one token.
fn group_end(tokens: &[String], at: usize) -> usize {
    let mut depth = 0_i32;
    for (k, token) in tokens.iter().enumerate().skip(at) {
        depth += i32::from(token == "{") - i32::from(token == "}");
        if depth <= 0 {
            return k + 1;
        }
    }
    tokens.len()
}

/// The letters of a page that are not known: each with its first use and the formula that introduces it.
fn local(page: &Page, known: &BTreeSet<String>) -> Vec<(String, usize, Option<String>)> {
    let formulas = formulas(page);
    let mut first: BTreeMap<String, usize> = BTreeMap::new();
    for formula in &formulas {
        for (_, letter) in letters(&formula.tokens).into_iter().filter(|(_, letter)| !known.contains(letter))
        {
            first.entry(letter).or_insert(formula.start);
        }
    }
    let introduced = |(letter, start): (String, usize)| {
        let end = window(&page.text, start);
        let near = || formulas.iter().filter(|formula| formula.start < end);
        let by = near().find(|formula| introduces(formula, &letter)).map(|formula| formula.latex.clone());
        (letter, start, by)
    };
    first.into_iter().map(introduced).collect()
}

fn unexplained(page: &Page, known: &BTreeSet<String>) -> Vec<Fault> {
    let open = local(page, known).into_iter().filter(|(.., by)| by.is_none());
    open.map(|(letter, start, _)| {
        Fault::new(&page.file, line_at(&page.text, start), "a letter that is nowhere explained", letter)
    })
    .collect()
}

/// The letters of single pages, each with the formula that introduces it, as a table.
pub fn list(pages: &[Page]) -> String {
    let known = pages.iter().find(|page| page.html == NOTATION).map(known).unwrap_or_default();
    let mut list = "| page | letter | introduced by |\n| --- | --- | --- |\n".to_owned();
    for page in pages.iter().filter(|page| page.html != NOTATION) {
        for (letter, _, by) in local(page, &known) {
            list += &format!("| {} | `{letter}` | `{}` |\n", page.html, by.unwrap_or_default());
        }
    }
    list
}

/// Three paragraphs behind the one that holds this place.
fn window(text: &str, start: usize) -> usize {
    let ends = text[start..].match_indices("\n\n").map(|(at, _)| start + at);
    ends.take(4).last().filter(|_| text[start..].matches("\n\n").count() >= 4).unwrap_or(text.len())
}

fn introduces(formula: &Formula, letter: &str) -> bool {
    let tokens = &formula.tokens;
    letters(tokens).into_iter().filter(|(_, other)| other == letter).any(|(at, _)| {
        let before = at.checked_sub(1).map_or("", |k| tokens[k].as_str());
        let mut behind = behind_index(tokens, at + 1);
        // Arguments, primes and powers between the letter and the relation.
        while let Some(token) = tokens.get(behind) {
            match token.as_str() {
                "'" | "&" | "}" => behind += 1,
                "^" => behind = group_end(tokens, behind + 1),
                "(" => {
                    let close = tokens[behind..].iter().position(|token| token == ")");
                    behind = close.map_or(tokens.len(), |close| behind + close + 1);
                }
                _ => break,
            }
        }
        let next = tokens.get(behind).map_or("", String::as_str);
        let is_first = at == 0 || BEGINS.contains(&before);
        let is_named = formula.is_inline && is_first && next.is_empty();
        let is_bound =
            before == "d" || tokens[..at].iter().rev().take(4).any(|t| BINDS.contains(&t.as_str()));
        is_named || is_first && RELATIONS.contains(&next) || is_bound
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn open(text: &str) -> Vec<String> {
        let notation = "| $h$, $\\uN = u \\cdot n$ | a |\n\n## Understood without a word\n\n$x$ is a point.\n\n## Last\n\n$q$";
        let page = |html: &str, text: &str| Page { file: html.into(), html: html.into(), text: text.into() };
        let pages = [page(NOTATION, notation), page("p.html", text)];
        faults(&pages).into_iter().map(|fault| fault.text).collect()
    }

    #[test]
    fn a_letter_is_known_or_named_or_defined_or_bound() {
        assert!(open("$h x + u n$").is_empty());
        assert_eq!(open("$q + c_1 \\le h$"), ["c", "q"]);
        assert!(open("A number $c$ and $c_2$; $c + h$").is_empty());
        assert!(open("$c h = x$ with\n\n$0 < c < 1$").is_empty());
        assert!(open("$$\\begin{aligned} h &= x, & G(x) &= h \\end{aligned}$$").is_empty());
        assert!(open("$\\sum_{k = 0}^{9} h_k$, $\\int x \\dd s$, $\\sup_{w \\in x} w$").is_empty());
        assert_eq!(open("$h + \\kappa x$\n\na\n\nb\n\nc\n\nd\n\nwith $\\kappa = 1$"), ["\\kappa"]);
    }
}
