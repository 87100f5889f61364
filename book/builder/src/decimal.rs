//! Decimals typed by hand: a number with a fractional part or a power of ten in prose or in a formula must
//! come from a computation (`{{value:...}}`) or be on the allow-list. The paper's own labels (Lemma 5.2,
//! (3.15)) are no numbers.

use regex::Regex;

/// Highest equation number of each section of the paper: (1.1), (2.1)-(2.9), ... (6.1)-(6.2).
const LAST_EQUATION: [(u32, u32); 6] = [(1, 1), (2, 9), (3, 15), (4, 14), (5, 9), (6, 2)];

/// Words after which `S.k` names a statement, a figure or a section.
const LABEL_WORDS: [&str; 15] = [
    "Lemma", "Lemmas", "Theorem", "Theorems", "Figure", "Figures", "Fig.", "Figs.", "Section",
    "Sections", "Sec.", "Secs.", "Remark", "Remarks", "§",
];

/// A decimal found: its offset (bytes) and its text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Decimal<'a> {
    /// Where it starts.
    pub start: usize,
    /// The decimal.
    pub text: &'a str,
}

/// Decimals in a text that are neither labels of the paper nor on the allow-list.
pub fn typed_by_hand<'a>(text: &'a str, allowed: &[String]) -> Vec<Decimal<'a>> {
    // A number that no letter, digit or underscore precedes, with a fraction or a power of ten.
    let number = Regex::new(r"\b[0-9]+(?:(?:\.[0-9]+)+(?:[eE][+-]?[0-9]+)?|[eE][+-]?[0-9]+)");
    let found = number.iter().flat_map(|number| number.find_iter(text));
    let found = found.filter(|n| {
        !is_label(text, n.start(), n.end()) && !allowed.iter().any(|a| a == n.as_str())
    });
    found.map(|n| Decimal { start: n.start(), text: n.as_str() }).collect()
}

/// True for `S.k` in parentheses, in the range of the paper's equations, or after a word such as "Lemma".
fn is_label(text: &str, start: usize, end: usize) -> bool {
    let Some((section, number)) = text[start..end].split_once('.') else { return false };
    let (Ok(section), Ok(number)) = (section.parse::<u32>(), number.parse::<u32>()) else {
        return false;
    };
    let exists =
        LAST_EQUATION.iter().any(|&(s, last)| s == section && (1..=last).contains(&number));
    let before = text[..start].trim_end();
    let in_parentheses = text[..start].ends_with('(') && text[end..].starts_with(')');
    let in_tag = text[..start].ends_with(r"\tag{");
    let named = LABEL_WORDS.iter().any(|word| before.ends_with(word));
    // "Theorems 3.1 and 4.1", "Lemmas 6.1, 6.2"
    let listed =
        before.strip_suffix("and").or_else(|| before.strip_suffix(',')).is_some_and(|list| {
            let list = list.trim_end();
            let first = list.rfind(|c: char| !c.is_ascii_digit() && c != '.').map_or(0, |k| k + 1);
            first < list.len() && is_label(list, first, list.len())
        });
    exists && (in_parentheses || in_tag || named || listed)
}

/// The allow-list: one decimal per line, with its reason after `#`.
pub fn allow_list(text: &str) -> Vec<String> {
    text.lines()
        .map(|line| line.split('#').next().unwrap_or("").trim())
        .filter(|entry| !entry.is_empty())
        .map(str::to_owned)
        .collect()
}

/// Prose with link targets and HTML tags blanked out, length unchanged.
pub fn without_links(text: &str) -> String {
    let blank = blank(text, "](", ")");
    self::blank(&blank, "<", ">")
}

/// A formula with its values blanked out, length unchanged.
pub fn without_values(latex: &str) -> String {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn found(text: &str) -> Vec<&str> {
        typed_by_hand(text, &["0.25".to_owned()]).iter().map(|d| d.text).collect()
    }

    #[test]
    fn decimals_and_powers_are_found() {
        assert_eq!(found("gamma is 0.2916, or 3e-7, not 12"), ["0.2916", "3e-7"]);
        assert_eq!(found(r"\gamma = 1.5\cdot 10^{-3}"), ["1.5"]);
        assert_eq!(found("(1.5) and (0.29)"), ["1.5", "0.29"]);
        assert_eq!(found("ends in 12. Next"), [""; 0]);
    }

    #[test]
    fn labels_and_allowed_decimals_pass() {
        let texts = r"Lemma 5.2 and (3.15)|Theorems 3.1 and 4.1|Fig. 3.2|Lemmas 6.1, 6.2|nu = 0.25|x \tag{5.2}|H1.5|§2.1";
        for text in texts.split('|') {
            assert_eq!(found(text), [""; 0], "{text}");
        }
        assert_eq!(found("Lemma 7.9"), ["7.9"]);
    }
}
