//! Formulas of a page and the letters they begin with.

use crate::chapter::Page;
use crate::letters::tokens;
use crate::local::{behind_index, is_letter, without_values};
use crate::scan::{Kind, pieces};

/// Start and tokens of each formula.
pub(crate) fn formulas(page: &Page) -> Vec<(usize, Vec<String>)> {
    let found = pieces(&page.text).unwrap_or_default();
    let formulas = found.iter().filter(|piece| matches!(piece.kind, Kind::Inline | Kind::Display));
    formulas.map(|piece| (piece.start, tokens(&without_values(piece.text)))).collect()
}

/// The letter that a formula begins with, its index and whether it has arguments, and where it ends.
pub(crate) fn symbol(all: &[String]) -> Option<(String, usize)> {
    let first = usize::from(matches!(all.first()?.as_str(), "\\mathcal" | "\\mathbb"));
    let is_macro = matches!(all[0].as_str(), "\\uN" | "\\sigN");
    if !is_macro && !is_letter(all.get(first)?) {
        return None;
    }
    let mut end = behind_index(all, first + 1);
    if all.get(end).is_some_and(|token| token == "'") {
        end += 1;
    }
    let mut symbol = all[..end].concat().replace(['{', '}'], "");
    if all.get(end).is_some_and(|token| token == "(") {
        let close = all[end..].iter().position(|token| token == ")")?;
        end += close + 1;
        symbol.push_str("()");
    }
    Some((symbol, end))
}
