//! Words of a terminal as words of a page: Greek letters by their sign, `x^2` raised, `u_N` lowered, `1e-6`
//! as a power.

use crate::markup::escape;
use crate::number::Written;

const LETTERS: [(&str, &str); 9] = [
    ("alpha", "α"),
    ("gamma", "γ"),
    ("lambda", "λ"),
    ("nu", "ν"),
    ("phi", "φ"),
    ("pi", "π"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("theta", "θ"),
];

/// The text as HTML.
pub fn html(text: &str) -> String {
    let text = greek(text);
    let mut html = String::new();
    let mut at = 0;
    let mut before = ' ';
    while let Some(c) = text[at..].chars().next() {
        let rest = &text[at..];
        let (piece, length) = raised(rest, &text[..at])
            .or_else(|| minus(rest, before))
            .or_else(|| power(rest, before))
            .unwrap_or_else(|| (escape(&rest[..c.len_utf8()]), c.len_utf8()));
        html.push_str(&piece);
        at += length;
        before = text[..at].chars().next_back().unwrap_or(' ');
    }
    html
}

/// Greek letters and comparisons; a letter counts where its name is a whole word.
fn greek(text: &str) -> String {
    let mut result = String::new();
    let mut rest = text;
    while let Some(start) = rest.find(char::is_alphabetic) {
        let length =
            rest[start..].find(|c: char| !c.is_alphanumeric()).unwrap_or(rest.len() - start);
        let word = &rest[start..start + length];
        result.push_str(&rest[..start]);
        result.push_str(
            LETTERS.iter().find(|(name, _)| *name == word).map_or(word, |(_, letter)| letter),
        );
        rest = &rest[start + length..];
    }
    (result + rest).replace("<=", "≤").replace(">=", "≥").replace("->", "→").replace("sqrt(", "√(")
}

/// An exponent or an index at the start of `text`, as HTML, and its length. A symbol is one letter: the names
/// of pages and examples keep their underscores.
fn raised(text: &str, before: &str) -> Option<(String, usize)> {
    let last = before.chars().next_back().unwrap_or(' ');
    let is_symbol = before.chars().rev().take_while(|c| c.is_alphanumeric()).count() == 1;
    let tag = match text.chars().next()? {
        '^' if !last.is_whitespace() => "sup",
        '_' if (last.is_alphabetic() && is_symbol) || matches!(last, '|' | ')') => "sub",
        _ => return None,
    };
    let rest = &text[1..];
    let (inner, length) = match closing(rest) {
        Some(end) => (&rest[1..end], end + 1),
        None => (&rest[..word_end(rest)], word_end(rest)),
    };
    (!inner.is_empty())
        .then(|| (format!("<{tag}>{}</{tag}>", html(inner).replace('-', "\u{2212}")), 1 + length))
}

/// The bracket that closes the one `text` begins with.
fn closing(text: &str) -> Option<usize> {
    let (open, close) = match text.chars().next()? {
        '(' => ('(', ')'),
        '{' => ('{', '}'),
        _ => return None,
    };
    let mut depth = 0;
    for (at, c) in text.char_indices() {
        depth += i32::from(c == open) - i32::from(c == close);
        if depth == 0 {
            return Some(at);
        }
    }
    None
}

/// Letters and digits, with a sign in front, a star behind, a point between two of them and a slash between two digits.
fn word_end(text: &str) -> usize {
    let sign = usize::from(text.starts_with('-'));
    let is_inner = |c: char| c.is_alphanumeric() && !"¹²³".contains(c);
    let next = |at: usize| text[at..].chars().nth(1);
    // `H^1/2` is one exponent, `u^h/at` is not.
    let is_fraction = |at: usize| {
        text[..at].ends_with(|c: char| c.is_ascii_digit())
            && next(at).is_some_and(|c| c.is_ascii_digit())
    };
    let joins = |at: usize, c: char| match c {
        '.' => next(at).is_some_and(char::is_alphanumeric),
        '/' => is_fraction(at),
        _ => false,
    };
    let end = text
        .char_indices()
        .skip(sign)
        .find(|&(at, c)| !(is_inner(c) || joins(at, c)))
        .map_or(text.len(), |(at, _)| at);
    // A number with a power of ten.
    let ten = text[..end]
        .strip_suffix('e')
        .filter(|mantissa| mantissa.ends_with(|c: char| c.is_ascii_digit()));
    let digits = text[end..].strip_prefix('-').filter(|_| ten.is_some());
    let length =
        digits.map_or(0, |rest| rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len()));
    match (end > sign, length) {
        (true, 0) => end,
        (true, length) => end + 1 + length,
        _ => 0,
    }
}

/// A minus sign in front of a number, as HTML, and its length.
fn minus(text: &str, before: char) -> Option<(String, usize)> {
    let is_sign = text.strip_prefix('-')?.starts_with(|c: char| c.is_ascii_digit());
    (is_sign && matches!(before, ' ' | '(')).then(|| ("\u{2212}".to_owned(), 1))
}

/// A number with a power of ten at the start of `text`, as HTML, and its length.
fn power(text: &str, before: char) -> Option<(String, usize)> {
    if before.is_alphanumeric() || before == '.' || !text.starts_with(|c: char| c.is_ascii_digit())
    {
        return None;
    }
    let mantissa = text.find(|c: char| !c.is_ascii_digit() && c != '.')?;
    let exponent = text[mantissa..].strip_prefix('e')?;
    let sign = usize::from(exponent.starts_with(['-', '+']));
    let digits =
        exponent[sign..].find(|c: char| !c.is_ascii_digit()).unwrap_or(exponent.len() - sign);
    let length = mantissa + 1 + sign + digits;
    (digits > 0).then(|| (Written::from_text(&text[..length]).html(), length))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_exponents_indices_and_powers_are_set() {
        for (text, expected) in [
            ("gamma/ln(1/theta) <= pi^h, number", "γ/ln(1/θ) ≤ π<sup>h</sup>, number"),
            ("h^(1+nu) |u|_(1+nu)", "h<sup>1+ν</sup> |u|<sub>1+ν</sub>"),
            ("theta^-0.25, H^{1/2}", "θ<sup>\u{2212}0.25</sup>, H<sup>1/2</sup>"),
            ("theta = 1e-6 (C)", "θ = 10<sup>\u{2212}6</sup> (C)"),
            ("h^0.20 on", "h<sup>0.20</sup> on"),
            (
                "theta^-5.0e-4, h^1e-3; x^2e",
                "θ<sup>\u{2212}5.0\u{202f}·\u{202f}10<sup>\u{2212}4</sup></sup>, \
                 h<sup>10<sup>\u{2212}3</sup></sup>; x<sup>2e</sup>",
            ),
            ("h^(2(tau-1)(2-tau)) all", "h<sup>2(τ\u{2212}1)(2\u{2212}τ)</sup> all"),
            ("u_N = 3.5e-7.", "u<sub>N</sub> = 3.5\u{202f}·\u{202f}10<sup>\u{2212}7</sup>."),
            ("a < b, 1 element, e-6, x1e-3", "a &lt; b, 1 element, e-6, x1e-3"),
            ("J = -1.5, (2nu-1), sqrt(2), a-1", "J = \u{2212}1.5, (2ν-1), √(2), a-1"),
            ("^ a _ b", "^ a _ b"),
            ("gamma_theta on the page lemma_5_2_a", "γ<sub>θ</sub> on the page lemma_5_2_a"),
        ] {
            assert_eq!(html(text), expected, "{text}");
        }
    }
}
