//! SVG text, in user units, and the typesetting of its words: `u_N` with a subscript, `x^0.6` with
//! a superscript, `1e-4` as a power of ten.

use plotters::style::RGBColor;
use std::fmt::Write as _;

/// The colour of the text of the page.
pub(super) const INK: &str = "currentColor";
/// plotters rounds every coordinate to an integer: its surfaces are larger than the picture by this
/// factor.
pub(super) const FINENESS: f64 = 10.0;
/// Stands for [`INK`] where plotters draws.
pub(super) const INK_OF_SHAPES: RGBColor = RGBColor(1, 2, 3);
/// Opened alone a picture has its own light and dark colours.
const STYLE: &str = "<style>svg:root{color:#222;background:#fff}\
    @media(prefers-color-scheme:dark){svg:root{color:#ddd;background:#1b1b1b}}</style>";
/// How far an index is lowered and an exponent raised, in units of its own letters, and how large
/// these are.
const SHIFT: (f64, f64) = (0.3, 0.45);
const SIZE: f64 = 0.75;

/// A picture while it is drawn.
pub(super) struct Canvas(String);

impl Canvas {
    /// An empty picture with letters of that size; `title` is its accessible name.
    pub(super) fn new([width, height]: [f64; 2], title: &str, font_size: f64) -> Self {
        Self(format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{}\" \
             width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\">\n{STYLE}\n\
             <g font-family=\"sans-serif\" font-size=\"{font_size}\" fill=\"{INK}\">\n",
            escape(title)
        ))
    }

    /// The text of the picture.
    pub(super) fn finish(self) -> String {
        self.0 + "</g>\n</svg>\n"
    }

    /// What plotters has drawn on a surface that is [`FINENESS`] times as large.
    pub(super) fn shapes(&mut self, drawn: &str) {
        let inner = drawn.split_once('>').map_or("", |(_, inner)| inner).trim_end();
        let inner = inner.strip_suffix("</svg>").unwrap_or(inner).replace(&css(INK_OF_SHAPES), INK);
        let _ = writeln!(self.0, "<g transform=\"scale({})\">{inner}</g>", FINENESS.recip());
    }

    /// A path; nothing if it is empty.
    pub(super) fn path(&mut self, path: &str, attributes: &str) {
        if !path.is_empty() {
            let _ = writeln!(self.0, "<path d=\"{path}\" {attributes}/>");
        }
    }

    /// Words centred vertically on a point; `anchor` is `start`, `middle` or `end`.
    pub(super) fn text(&mut self, words: &str, at: (f64, f64), anchor: &str, attributes: &str) {
        let (x, y, words) = (tenths(at.0), tenths(at.1), shifted(&powers(&escape(words))));
        let place = format!("x=\"{x}\" y=\"{y}\" dy=\"0.5ex\" text-anchor=\"{anchor}\"");
        let _ = writeln!(self.0, "<text {place}{attributes}>{words}</text>");
    }
}

fn tenths(length: f64) -> f64 {
    (10.0 * length).round() / 10.0
}

/// A colour as plotters writes it.
pub(super) fn css(RGBColor(red, green, blue): RGBColor) -> String {
    format!("#{red:02X}{green:02X}{blue:02X}")
}

/// A text for an attribute or an element.
fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}

/// `1e-4` as a power of ten, to be raised.
fn powers(text: &str) -> String {
    let mut words = Vec::new();
    for word in text.split(' ') {
        let number = word.trim_end_matches([',', ';', ')']);
        let power = number.split_once('e').filter(|_| number.parse::<f64>().is_ok());
        words.push(match power {
            Some(("1", exponent)) => format!("10^{exponent}{}", &word[number.len()..]),
            Some((mantissa, exponent)) => {
                format!("{mantissa}·10^{exponent}{}", &word[number.len()..])
            }
            None => word.to_owned(),
        });
    }
    words.join(" ")
}

/// Lowers what follows a letter and `_`, raises what follows `^`; the rest of the text returns to
/// the line.
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
    let index = format!("{before}<tspan dy=\"{shift}em\" font-size=\"{SIZE}em\">{index}</tspan>");
    if rest.is_empty() {
        return index;
    }
    // A space at the start of an element is dropped by some viewers; one that does not break is
    // not.
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
        c.is_alphanumeric() && !matches!(c, '¹' | '²' | '³')
            || matches!(c, '.' | '/') && next.is_some_and(char::is_alphanumeric)
    };
    let end = text
        .char_indices()
        .find(|&(at, c)| at >= sign && !inner(at, c))
        .map_or(text.len(), |(at, _)| at);
    if end > sign { end } else { 0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices_are_lowered_exponents_raised_and_the_rest_returns() {
        let lowered = "u<tspan dy=\"0.3em\" font-size=\"0.75em\">N</tspan>\
                       <tspan dy=\"-0.2250em\">, shown</tspan>";
        assert_eq!(shifted("u_N, shown"), lowered);
        assert!(shifted("|u|_(3/2)").starts_with("|u|<tspan dy=\"0.3em\""));
        assert_eq!(shifted("x^0.6"), "x<tspan dy=\"-0.45em\" font-size=\"0.75em\">0.6</tspan>");
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
