//! Typesetting of the texts of a figure: `u_N` with a subscript, `x^0.6` with a superscript, `1e-4` as a
//! power of ten.

/// How far an index is lowered and an exponent raised, in units of its own letters, and how large these are.
const SHIFT: (f64, f64) = (0.3, 0.45);
const SIZE: f64 = 0.75;

/// Sets the texts of an SVG; the backend writes each on a line of its own.
pub(super) fn typeset(svg: &str) -> String {
    let set = |line: &str| match line.strip_suffix('\n') {
        Some(text) if !text.starts_with('<') => shifted(&powers(text)) + "\n",
        _ => line.to_owned(),
    };
    svg.split_inclusive('\n').map(set).collect()
}

/// `1e-4` as a power of ten, to be raised.
fn powers(text: &str) -> String {
    let mut words = Vec::new();
    for word in text.split(' ') {
        let number = word.trim_end_matches([',', ';', ')']);
        let power = number.split_once('e').filter(|_| number.parse::<f64>().is_ok());
        words.push(match power {
            Some(("1", exponent)) => format!("10^{exponent}{}", &word[number.len()..]),
            Some((mantissa, exponent)) => format!("{mantissa}·10^{exponent}{}", &word[number.len()..]),
            None => word.to_owned(),
        });
    }
    words.join(" ")
}

/// Lowers what follows a letter and `_`, raises what follows `^`; the rest of the text returns to the line.
fn shifted(text: &str) -> String {
    let marks = |(at, c): &(usize, char)| match c {
        '_' => text[..*at].ends_with(|c: char| c.is_alphabetic() || matches!(c, '|' | ')' | '‖')),
        '^' => *at > 0,
        _ => false,
    };
    let Some((at, mark)) = text.char_indices().find(marks) else { return text.to_owned() };
    let (before, after) = (&text[..at], &text[at + 1..]);
    let (index, rest) = match after.strip_prefix('(').and_then(|inner| inner.split_once(')')) {
        Some(parts) => parts,
        None => after.split_at(index_end(after)),
    };
    if index.is_empty() {
        return format!("{before}{mark}{}", shifted(rest));
    }
    let shift = if mark == '_' { SHIFT.0 } else { -SHIFT.1 };
    let index = index.replace('-', "−");
    let index = format!("{before}<tspan dy=\"{shift}em\" font-size=\"{:.0}%\">{index}</tspan>", 100.0 * SIZE);
    if rest.is_empty() {
        return index;
    }
    // A space at the start of an element is dropped by some viewers; one that does not break is not.
    let rest = match rest.strip_prefix(' ') {
        Some(words) => format!("\u{a0}{}", shifted(words)),
        None => shifted(rest),
    };
    format!("{index}<tspan dy=\"{:.4}em\">{rest}</tspan>", -shift * SIZE)
}

/// Letters and digits, with a sign in front and a point or a slash between two of them.
fn index_end(text: &str) -> usize {
    let sign = text.chars().next().filter(|c| matches!(c, '-' | '−')).map_or(0, char::len_utf8);
    let inner = |at: usize, c: char| {
        let next = text[at + c.len_utf8()..].chars().next();
        c.is_alphanumeric() || matches!(c, '.' | '/') && next.is_some_and(char::is_alphanumeric)
    };
    let end =
        text.char_indices().find(|&(at, c)| at >= sign && !inner(at, c)).map_or(text.len(), |(at, _)| at);
    if end > sign { end } else { 0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lowered(index: &str, rest: &str) -> String {
        format!("<tspan dy=\"0.3em\" font-size=\"75%\">{index}</tspan><tspan dy=\"-0.2250em\">{rest}</tspan>")
    }

    #[test]
    fn indices_are_lowered_exponents_raised_and_the_rest_returns() {
        let svg = "<text a_b=\"1\">\nu_N, shown\n</text>\n";
        assert_eq!(typeset(svg), format!("<text a_b=\"1\">\nu{}\n</text>\n", lowered("N", ", shown")));
        assert!(shifted("|u|_(3/2)").starts_with("|u|<tspan dy=\"0.3em\""));
        assert_eq!(shifted("x^0.6"), "x<tspan dy=\"-0.45em\" font-size=\"75%\">0.6</tspan>");
        assert!(shifted("h^(tau-1), H^1/2.").contains(">tau−1</tspan>"));
        assert!(shifted("|x|^2 over").ends_with(">\u{a0}over</tspan>"));
        assert!(shifted("H^1/2.").contains(">1/2</tspan>"));
        for plain in ["no index", "a ^ b", "_x", "f_", "10⁻³"] {
            assert_eq!(shifted(plain), plain);
        }
    }

    #[test]
    fn powers_of_ten_are_written_as_such() {
        assert_eq!(powers("θ = 1e-4, 2.5e3 e 12 1e x1e3"), "θ = 10^-4, 2.5·10^3 e 12 1e x1e3");
    }
}
