//! One letter, one meaning on a page. A sentence that says what a letter is counts as a definition: "let $X$
//! be ..", "with $X = ..$", "where $X$ is the ..", ", $X$ the ..", "a number $X$". Refused are
//!
//! - a letter with two definitions on a page that differ (a value such as $c = 1/4$ is none);
//! - a letter that is defined in words, or has a range, and is the variable of an integral too;
//! - a letter of the notation page whose definition on another page has no word in common with that of the
//!   notation page, unless the last table of that page lists the other meaning;
//! - a page under two meanings of one row of that table, or under a letter that its formulas do not use;
//! - Euler's number as the letter of errors: $e$ with an exponent that is no number.

use crate::chapter::Page;
use crate::error::Fault;
use crate::letters::{NOTATION, tokens};
use crate::local::{is_letter, without_values};
use crate::scan::{Kind, Piece, line_at, pieces};
use crate::several::{row_faults, rows};
use crate::symbol::{formulas, symbol};
use std::collections::{BTreeMap, BTreeSet};

/// What an apposition before a letter may say: "a number $c$".
const NOUNS: [&str; 34] = [
    "number",
    "constant",
    "angle",
    "point",
    "function",
    "set",
    "power",
    "frequency",
    "exponent",
    "distance",
    "length",
    "radius",
    "height",
    "width",
    "zone",
    "segment",
    "triangle",
    "interval",
    "order",
    "factor",
    "mean",
    "load",
    "gap",
    "operator",
    "field",
    "norm",
    "space",
    "matrix",
    "edge",
    "corner",
    "quotient",
    "index",
    "direction",
    "rotation",
];
/// Commands that a plain value may hold.
const VALUES: [&str; 10] =
    ["\\frac", "\\tfrac", "\\dfrac", "\\sqrt", "\\pi", "\\infty", "\\cdot", "\\ln", "\\exp", "\\pm"];
/// Letters that are points or distances in every integral.
const POINTS: [&str; 4] = ["x", "y", "z", "r"];

/// What a sentence says of a letter.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Definition {
    symbol: String,
    start: usize,
    meaning: String,
    in_words: bool,
}

/// All faults of letters with two meanings.
pub fn faults(pages: &[Page]) -> Vec<Fault> {
    let Some(notation) = pages.iter().find(|page| page.html == NOTATION) else { return Vec::new() };
    let known = known(notation);
    let rows = rows(notation);
    let mut faults = row_faults(notation, &rows, pages);
    for page in pages.iter().filter(|page| page.html != NOTATION) {
        let definitions = definitions(page);
        faults.extend(twice(page, &definitions));
        faults.extend(bound(page, &definitions));
        faults.extend(euler(page));
        let is_listed = |symbol: &str| {
            rows.iter().any(|row| row.symbol == symbol && row.meanings.iter().any(|m| m.contains(&page.html)))
        };
        let other = definitions
            .iter()
            .filter(|d| d.in_words && !is_listed(&d.symbol))
            .filter(|d| known.get(&d.symbol).is_some_and(|words| words.is_disjoint(&stems(&d.meaning))));
        faults.extend(other.map(|d| {
            let what = "another meaning than on the notation page, whose last table does not say so";
            Fault::new(&page.file, line_at(&page.text, d.start), what, format!("{}: {}", d.symbol, d.meaning))
        }));
    }
    faults
}

/// Letters of the first tables of the notation page, each with the words of its row.
fn known(notation: &Page) -> BTreeMap<String, BTreeSet<String>> {
    let first = notation.text.split("## Understood").next().unwrap_or("");
    let mut known: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for (cell, rest) in first.lines().filter_map(|line| line.strip_prefix("| ")?.split_once(" | ")) {
        for formula in cell.split('$').skip(1).step_by(2) {
            if let Some((symbol, _)) = symbol(&tokens(formula)) {
                known.entry(symbol).or_default().extend(stems(rest));
            }
        }
    }
    known
}

/// Definitions that differ.
fn twice(page: &Page, definitions: &[Definition]) -> Vec<Fault> {
    let mut faults = Vec::new();
    for (k, one) in definitions.iter().enumerate() {
        let before = definitions[..k].iter().find(|d| d.symbol == one.symbol && d.meaning != one.meaning);
        if let Some(first) = before {
            let text = format!("{}: {} / {}", one.symbol, first.meaning, one.meaning);
            let what = format!("a second meaning, the first is in line {}", line_at(&page.text, first.start));
            faults.push(Fault::new(&page.file, line_at(&page.text, one.start), what, text));
        }
    }
    faults
}

/// Letters that are defined in words or have a range, and are bound by an integral too.
fn bound(page: &Page, definitions: &[Definition]) -> Vec<Fault> {
    let all = formulas(page);
    let mut bound: BTreeMap<&str, usize> = BTreeMap::new();
    for (start, formula) in all.iter().filter(|(_, formula)| formula.iter().any(|token| is_integral(token))) {
        for pair in formula.windows(2).filter(|pair| matches!(pair[0].as_str(), "d" | "\\dd")) {
            if is_letter(&pair[1]) && !POINTS.contains(&pair[1].as_str()) {
                bound.entry(&pair[1]).or_insert(*start);
            }
        }
    }
    let mut faults = Vec::new();
    for (letter, start) in bound {
        let said = definitions.iter().find(|d| d.symbol == letter && d.in_words);
        let is_limit = |token: &String| matches!(token.as_str(), "<" | "\\le");
        let range = all.iter().find(|(_, formula)| {
            formula.windows(4).any(|four| is_limit(&four[1]) && four[2] == letter && is_limit(&four[3]))
                && !formula.iter().any(|token| is_integral(token))
        });
        if let Some(other) = said.map(|d| d.start).or(range.map(|(start, _)| *start)) {
            let what = format!(
                "an integral runs over a letter with a meaning of its own, line {}",
                line_at(&page.text, other)
            );
            faults.push(Fault::new(&page.file, line_at(&page.text, start), what, letter));
        }
    }
    faults
}

/// Euler's number in italics.
fn euler(page: &Page) -> Vec<Fault> {
    let is_euler = |all: &[String], k: usize| {
        let before = k.checked_sub(1).map_or("", |k| all[k].as_str());
        let is_power = all[k] == "e" && !matches!(before, "_" | "\\mathrm") && all[k + 1] == "^";
        let exponent = all[k + 2..].iter().find(|token| !matches!(token.as_str(), "{" | "-"));
        let is_number = |token: &String| token.starts_with(|c: char| c.is_ascii_digit() || c == '*');
        is_power
            && (all[k + 2..].iter().take(2).any(|token| token == "-") || !exponent.is_some_and(is_number))
    };
    let all = formulas(page);
    let has_euler = |all: &[String]| (0..all.len().saturating_sub(2)).any(|k| is_euler(all, k));
    let found = all.iter().filter(|(_, formula)| has_euler(formula));
    found
        .map(|(start, _)| {
            Fault::new(&page.file, line_at(&page.text, *start), "Euler's number is \\mathrm e", "e")
        })
        .collect()
}

fn is_integral(token: &str) -> bool {
    matches!(token, "\\int" | "\\iint")
}

/// The definitions of a page in order.
fn definitions(page: &Page) -> Vec<Definition> {
    let found = pieces(&page.text).unwrap_or_default();
    let prose = |at: Option<usize>| {
        let piece = at.and_then(|at| found.get(at)).filter(|piece| piece.kind == Kind::Prose);
        piece.map_or(String::new(), |piece: &Piece<'_>| plain(piece.text))
    };
    let inline = found.iter().enumerate().filter(|(_, piece)| piece.kind == Kind::Inline);
    inline
        .filter_map(|(k, piece)| {
            let all = tokens(&without_values(piece.text));
            let (symbol, end) = symbol(&all)?;
            let (meaning, in_words) = match all.get(end).map(String::as_str) {
                None => (in_words(&prose(k.checked_sub(1)), &prose(Some(k + 1)))?, true),
                Some("=") => (by_formula(&prose(k.checked_sub(1)), &all[end..])?, false),
                Some(_) => return None,
            };
            Some(Definition { symbol, start: piece.start, meaning, in_words })
        })
        .collect()
}

/// One space between words, no marks of quotations; a blank at an end stays.
fn plain(text: &str) -> String {
    let mut words = text.replace('>', " ").split_whitespace().collect::<Vec<_>>().join(" ");
    if text.starts_with(char::is_whitespace) {
        words.insert(0, ' ');
    }
    words.to_lowercase()
}

/// "with $X = ..$", where the right side is no plain value.
fn by_formula(before: &str, right: &[String]) -> Option<String> {
    let last = before.split_whitespace().last()?;
    let is_value = right[1..].iter().all(|token| {
        let is_command = token.starts_with('\\') && token[1..].starts_with(char::is_alphabetic);
        if is_command { VALUES.contains(&token.as_str()) } else { !token.contains(char::is_alphabetic) }
    });
    (["let", "where", "put", "set", "with", "write"].contains(&last) && !is_value).then(|| right.concat())
}

/// What prose around a letter says of it.
fn in_words(before: &str, behind: &str) -> Option<String> {
    let clause = || behind.split(['.', ',', ';', ':', '(']).next().unwrap_or("").trim().to_owned();
    let is_article = |rest: &str| ["a ", "an ", "the "].iter().any(|article| rest.starts_with(article));
    let last = before.split_whitespace().last().unwrap_or("");
    if last == "let" && behind.strip_prefix(" be ").is_some_and(is_article) {
        return Some(clause()["be ".len()..].to_owned());
    }
    let opens = before.ends_with([',', '(']) || ["where", "with", "and"].contains(&last);
    if opens
        && let Some(rest) = behind.strip_prefix(" is ").or(behind.strip_prefix(' ')).filter(|r| is_article(r))
    {
        return Some(rest.split(['.', ',', ';', ':', '(']).next().unwrap_or("").trim().to_owned());
    }
    let has_article = before.split_whitespace().rev().take(3).any(|word| matches!(word, "a" | "an" | "any"));
    (has_article && NOUNS.contains(&last)).then(|| last.to_owned())
}

/// Beginnings of the longer words.
fn stems(text: &str) -> BTreeSet<String> {
    let words = text.split(|c: char| !c.is_alphabetic()).filter(|word| word.len() > 3);
    words.map(|word| word.to_lowercase().chars().take(5).collect()).collect()
}

#[cfg(test)]
#[path = "meanings_tests.rs"]
mod tests;
