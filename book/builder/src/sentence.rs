//! Words of a finding begin with a small letter; at the start of a sentence they get a capital.

/// Whether what follows `text`, Markdown so far, begins a sentence: at the start of a paragraph, of an item
/// of a list or of a page, or behind a full stop, bold or not.
pub fn begins(text: &str) -> bool {
    let trimmed = text.trim_end();
    let gap = &text[trimmed.len()..];
    if trimmed.is_empty() || gap.matches('\n').count() > 1 {
        return true;
    }
    let line = trimmed.rsplit('\n').next().unwrap_or("").trim_start_matches('>').trim();
    if line.is_empty() {
        // The mark of a quotation: what stands before it decides.
        return begins(trimmed.trim_end_matches('>'));
    }
    let is_item = matches!(line, "-" | "*" | "+")
        || line
            .strip_suffix('.')
            .is_some_and(|n| !n.is_empty() && n.chars().all(|c| c.is_ascii_digit()));
    let stop = trimmed.trim_end_matches("**");
    !gap.is_empty() && (is_item || stop.ends_with(['.', '?', '!']))
}

/// The HTML with the first letter of its text as a capital. Symbols are left: letters that stand alone, or
/// carry an exponent, an index or an operation, as in `h* is`, `e/h`, `u<sub>N</sub>`.
pub fn capitalised(html: &str) -> String {
    let mut at = 0;
    while html[at..].starts_with('<') {
        let Some(end) = html[at..].find('>') else { break };
        at += end + 1;
    }
    let word = &html
        [at..at + html[at..].find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(html.len() - at)];
    let behind = html[at + word.len()..].chars().next().unwrap_or(' ');
    let is_word = word.len() > 1 || word == "a";
    if !is_word || !word.starts_with(|c: char| c.is_ascii_lowercase()) || "*/^_=<(".contains(behind)
    {
        return html.to_owned();
    }
    let mut capital = html.to_owned();
    capital[at..=at].make_ascii_uppercase();
    capital
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_get_a_capital_and_symbols_do_not() {
        for (html, expected) in [
            ("<span class=\"finding holds\" title=\"a &lt; b\">no set</span>", None),
            ("no set", Some("No set")),
            (
                "<span title=\"x\"><strong>fails:</strong> it",
                Some("<span title=\"x\"><strong>Fails:</strong> it"),
            ),
            ("a force", Some("A force")),
            ("h* is", None),
            ("e/h does", None),
            ("u<sub>N</sub> is", None),
            ("γ grows", None),
            ("(E1) is", None),
            ("J is", None),
        ] {
            let expected =
                expected.map_or_else(|| html.replace(">no set", ">No set"), str::to_owned);
            assert_eq!(capitalised(html), expected, "{html}");
        }
    }
}
